//! Measures of a text: words in a sentence, frequency of a word, words of a list. Code does not count.

/// The lines of a page, with their numbers and whether they are code.
pub(crate) fn lines(text: &str) -> impl Iterator<Item = (usize, bool, &str)> {
    let mut in_code = false;
    text.lines().enumerate().map(move |(index, line)| {
        let fence = line.trim_start().starts_with("```");
        in_code ^= fence;
        (index + 1, in_code || fence, line)
    })
}

/// The text of a document outside code: paragraphs with items of lists, headings and rows of tables.
struct Prose {
    /// Paragraphs and items of lists.
    paragraphs: Vec<String>,
    /// Headings and rows of tables.
    rows: Vec<String>,
}

/// An item of a list without its sign.
fn item(line: &str) -> Option<&str> {
    let number = line.trim_start_matches(|digit: char| digit.is_ascii_digit());
    let numbered = (number.len() < line.len()).then(|| number.strip_prefix(". "));
    let starred = line.strip_prefix("* ");
    numbered.flatten().or(line.strip_prefix("- ")).or(starred)
}

fn prose(text: &str) -> Prose {
    let mut prose = Prose {
        paragraphs: Vec::new(),
        rows: Vec::new(),
    };
    let mut goes_on = false;
    for (_, in_code, line) in lines(text) {
        let line = line.trim();
        let is_definition = line.starts_with('[') && line.contains("]: ");
        if in_code || line.is_empty() || is_definition {
            goes_on = false;
        } else if line.starts_with(['|', '#']) {
            goes_on = false;
            prose.rows.push(line.replace(['|', '#'], " "));
        } else if let (true, None, Some(paragraph)) =
            (goes_on, item(line), prose.paragraphs.last_mut())
        {
            paragraph.push(' ');
            paragraph.push_str(line);
        } else {
            prose.paragraphs.push(item(line).unwrap_or(line).to_owned());
            goes_on = true;
        }
    }
    for text in prose.paragraphs.iter_mut().chain(&mut prose.rows) {
        *text = without_marks(text);
    }
    prose
}

/// A text in which code in back-ticks is one word, and links are their text.
fn without_marks(text: &str) -> String {
    let mut kept = String::new();
    for (index, part) in text.split('`').enumerate() {
        kept.push_str(if index % 2 == 0 { part } else { "code" });
    }
    for (open, close) in [("](", ')'), ("][", ']')] {
        while let Some(start) = kept.find(open) {
            let length = kept[start..]
                .chars()
                .skip(1)
                .position(|letter| letter == close);
            let end = length.map_or(kept.len(), |length| {
                let mut letters = kept[start..].char_indices().skip(length + 2);
                letters
                    .next()
                    .map_or(kept.len(), |(after, _)| start + after)
            });
            kept.replace_range(start..end, "");
        }
    }
    kept.replace(['[', ']', '!'], "")
}

/// Words of a text in small letters.
fn words(text: &str) -> Vec<String> {
    let words = text.split(|letter: char| !letter.is_alphanumeric() && letter != '\'');
    let words = words.filter(|word| !word.is_empty());
    words.map(str::to_lowercase).collect()
}

/// The numbers of words of all sentences in paragraphs and lists.
fn sentences(text: &str) -> Vec<usize> {
    let mut found = Vec::new();
    for paragraph in prose(text).paragraphs {
        let mut count = 0;
        for word in paragraph.split_whitespace() {
            count += usize::from(word.contains(char::is_alphanumeric));
            let bare = word.trim_end_matches([')', '"', '*', '_']);
            if bare.ends_with(['.', '?']) {
                found.push(count);
                count = 0;
            }
        }
        found.push(count);
    }
    found.retain(|count| *count > 0);
    found
}

/// The number of words that nine sentences out of ten do not exceed; 0 without a sentence.
pub(crate) fn long_sentence(text: &str) -> usize {
    let mut counts = sentences(text);
    counts.sort_unstable();
    let rank = (counts.len() * 9).div_ceil(10);
    rank.checked_sub(1).map_or(0, |index| counts[index])
}

/// All words outside code, in small letters.
pub(crate) fn all_words(text: &str) -> Vec<String> {
    let prose = prose(text);
    let parts = prose.paragraphs.iter().chain(&prose.rows);
    parts.flat_map(|part| words(part)).collect()
}

/// How often a word occurs in a thousand words.
pub(crate) fn per_thousand(text: &str, wanted: &str) -> f64 {
    let words = all_words(text);
    let count = words.iter().filter(|word| *word == wanted).count();
    1000.0 * count as f64 / words.len().max(1) as f64
}

/// The words of a list that occur; some are several words, which may be in two lines.
pub(crate) fn occurring<'a>(text: &str, list: &[&'a str]) -> Vec<&'a str> {
    let text = format!(" {} ", all_words(text).join(" "));
    let occurs = |own: &&&str| text.contains(&format!(" {own} "));
    list.iter().filter(occurs).copied().collect()
}
