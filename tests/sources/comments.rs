//! Prose of comments: nouns as subjects, no words that the style avoids, lines that are not long.

use std::collections::BTreeMap;
use std::fmt::Write;
use std::sync::OnceLock;

use crate::crates::{CRATES, Source, is_reported, known, sources};
use crate::measures::{all_words, occurring};

mod tests;

const CLAUSE: &str = "what";
const CLAUSES_PER_THOUSAND: f64 = 2.0;

/// Words that begin no comment: a comment begins with a verb or with the name of a thing.
const FIRST_WORDS: [&str; 12] = [
    "what", "where", "how", "whether", "who", "which", "of", "if", "as", "by", "so", "from",
];
const FIRST_WORDS_PER_HUNDRED: f64 = 4.0;

const AVOIDED: [&str; 9] = [
    "aboard",
    "anew",
    "at hand",
    "but for",
    "in words",
    "of ours",
    "told",
    "whoever",
    "without a word",
];

const COLUMNS: usize = 120;
/// Longer lines are reported, and no fault.
const COLUMNS_OF_NEW_COMMENTS: usize = 100;

/// The greatest figures of each crate until all comments are rewritten.
const KNOWN: [(&str, Most); 24] = [
    ("linkage-analysis", most(0.0, 0.0, 0, 0)),
    ("linkage-c", most(0.0, 0.0, 0, 0)),
    ("linkage-cli", most(1.5, 2.7, 3, 0)),
    ("linkage-compiler", most(0.5, 0.5, 0, 11)),
    ("linkage-core", most(0.5, 0.5, 0, 0)),
    ("linkage-design", most(0.0, 0.0, 0, 0)),
    ("linkage-dynamics", most(0.0, 0.0, 0, 0)),
    ("linkage-editor", most(0.0, 0.0, 0, 0)),
    ("linkage-formats", most(0.0, 0.0, 0, 0)),
    ("linkage-engine", most(0.0, 0.0, 0, 0)),
    ("linkage-export", most(0.0, 0.0, 0, 0)),
    ("linkage-import", most(0.0, 0.0, 0, 0)),
    ("linkage-js", most(0.0, 0.0, 0, 0)),
    ("linkage-language", most(0.5, 0.5, 0, 11)),
    ("linkage-macros", most(0.0, 0.0, 0, 0)),
    ("linkage-page", most(0.0, 0.0, 0, 0)),
    ("linkage-playground", most(0.0, 0.0, 0, 0)),
    ("linkage-report", most(0.0, 0.0, 0, 0)),
    ("linkage-rust", most(0.5, 0.5, 0, 11)),
    ("linkage-runtime", most(0.0, 0.0, 0, 0)),
    ("linkage-st", most(0.0, 0.0, 0, 0)),
    ("linkage-symbolic", most(0.0, 0.0, 0, 0)),
    ("linkage-synthesis", most(0.0, 0.0, 0, 0)),
    ("src", most(0.0, 0.0, 0, 0)),
];

#[derive(Clone, Copy)]
struct Most {
    clauses: f64,
    first_words: f64,
    avoided: usize,
    long_lines: usize,
}

const fn most(clauses: f64, first_words: f64, avoided: usize, long_lines: usize) -> Most {
    Most {
        clauses,
        first_words,
        avoided,
        long_lines,
    }
}

/// A comment of documentation: its lines together, without slashes.
struct DocComment {
    line: usize,
    text: String,
}

fn doc_comments(source: &Source) -> Vec<DocComment> {
    let mut found: Vec<DocComment> = Vec::new();
    let mut before = (0, "");
    for comment in &source.lexed.comments {
        let sign = ["///", "//!", "/**", "/*!"]
            .into_iter()
            .find(|sign| comment.text.starts_with(sign));
        // A row of slashes, and an empty block.
        let is_other = ["////", "/***", "/**/"]
            .iter()
            .any(|sign| comment.text.starts_with(sign));
        let (Some(sign), false) = (sign, is_other) else {
            continue;
        };
        let text = comment.text[sign.len()..].trim_end_matches("*/");
        match found.last_mut() {
            Some(last) if before == (comment.line - 1, sign) && sign.starts_with("//") => {
                last.text.push('\n');
                last.text.push_str(text);
            }
            _ => found.push(DocComment {
                line: comment.line,
                text: text.to_owned(),
            }),
        }
        before = (comment.line, sign);
    }
    found
}

/// Counts over files, and the places of all faults.
#[derive(Default)]
struct Figures {
    words: usize,
    clauses: usize,
    comments: usize,
    first_words: usize,
    avoided: usize,
    long_lines: usize,
    longer_than_new: usize,
    /// Line and fault.
    places: Vec<(usize, String)>,
}

impl Figures {
    fn of(source: &Source) -> Self {
        let mut figures = Self::default();
        for comment in doc_comments(source) {
            figures.add(&comment);
        }
        for comment in &source.lexed.comments {
            for (index, line) in comment.text.lines().enumerate() {
                let before = if index == 0 { comment.column } else { 0 };
                let columns = before + line.chars().count();
                if columns > COLUMNS_OF_NEW_COMMENTS {
                    figures.longer_than_new += 1;
                    figures.long_lines += usize::from(columns > COLUMNS);
                    let place = (comment.line + index, format!("{columns} columns"));
                    figures.places.push(place);
                }
            }
        }
        figures.places.sort();
        figures
    }

    fn add(&mut self, comment: &DocComment) {
        let words = all_words(&comment.text);
        let clauses = words.iter().filter(|word| *word == CLAUSE).count();
        let mut faults = Vec::new();
        if clauses > 0 {
            faults.push(format!("`{CLAUSE}` {clauses} times"));
        }
        self.words += words.len();
        self.clauses += clauses;
        self.comments += usize::from(!words.is_empty());
        if words
            .first()
            .is_some_and(|word| FIRST_WORDS.contains(&&word[..]))
        {
            self.first_words += 1;
            faults.push("first word".to_owned());
        }
        let avoided = occurring(&comment.text, &AVOIDED);
        self.avoided += avoided.len();
        faults.extend(avoided.iter().map(|word| format!("`{word}`")));
        if !faults.is_empty() {
            let start: String = words.join(" ").chars().take(60).collect();
            let fault = format!("{}: {start}", faults.join(", "));
            self.places.push((comment.line, fault));
        }
    }

    fn sum<'a>(all: impl Iterator<Item = &'a Self>) -> Self {
        let mut sum = Self::default();
        for figures in all {
            sum.words += figures.words;
            sum.clauses += figures.clauses;
            sum.comments += figures.comments;
            sum.first_words += figures.first_words;
            sum.avoided += figures.avoided;
            sum.long_lines += figures.long_lines;
            sum.longer_than_new += figures.longer_than_new;
        }
        sum
    }

    fn clauses_per_thousand(&self) -> f64 {
        1000.0 * self.clauses as f64 / self.words.max(1) as f64
    }

    fn first_words_per_hundred(&self) -> f64 {
        100.0 * self.first_words as f64 / self.comments.max(1) as f64
    }

    /// The number of faults, for the order of files in a report.
    fn faults(&self) -> usize {
        self.clauses + self.first_words + self.avoided + self.long_lines
    }

    fn exceeds(&self, most: Most) -> bool {
        self.clauses_per_thousand() > most.clauses
            || self.first_words_per_hundred() > most.first_words
            || self.avoided > most.avoided
            || self.long_lines > most.long_lines
    }

    fn described(&self) -> String {
        format!(
            "`{CLAUSE}` {:.2} times in 1000 words ({} in {}), first words {:.2} % ({} of {} comments), \
             {} avoided words, {} lines over {COLUMNS} columns, {} over {COLUMNS_OF_NEW_COMMENTS}",
            self.clauses_per_thousand(),
            self.clauses,
            self.words,
            self.first_words_per_hundred(),
            self.first_words,
            self.comments,
            self.avoided,
            self.long_lines,
            self.longer_than_new,
        )
    }
}

/// All sources with their figures.
fn all() -> &'static [(&'static Source<'static>, Figures)] {
    static ALL: OnceLock<Vec<(&Source, Figures)>> = OnceLock::new();
    ALL.get_or_init(|| {
        let all = sources().iter();
        all.map(|source| (source, Figures::of(source))).collect()
    })
}

fn of_crate(all: &[(&Source, Figures)], home: usize) -> Figures {
    let files = all.iter().filter(|(source, _)| source.home == home);
    Figures::sum(files.map(|(_, figures)| figures))
}

/// The files with most faults, at most a number of them.
fn worst(all: &[(&Source, Figures)], is_wanted: impl Fn(&Source) -> bool, count: usize) -> String {
    let mut files: Vec<_> = all
        .iter()
        .filter(|(source, figures)| is_wanted(source) && figures.faults() > 0)
        .collect();
    files.sort_by_key(|(_, figures)| std::cmp::Reverse(figures.faults()));
    let mut text = String::new();
    for (source, figures) in files.into_iter().take(count) {
        let _ = writeln!(
            text,
            "  {}: `{CLAUSE}` {}, first words {} of {}, avoided {}, long lines {}",
            source.path,
            figures.clauses,
            figures.first_words,
            figures.comments,
            figures.avoided,
            figures.long_lines
        );
    }
    text
}

#[test]
fn comments_are_in_plain_english() {
    let all = all();
    let mut failures = String::new();
    for (home, name) in CRATES.iter().enumerate() {
        let figures = of_crate(all, home);
        let target = most(CLAUSES_PER_THOUSAND, FIRST_WORDS_PER_HUNDRED, 0, 0);
        let known = known(&KNOWN, name);
        let most = most(
            known.clauses.max(target.clauses),
            known.first_words.max(target.first_words),
            known.avoided,
            known.long_lines,
        );
        if figures.exceeds(most) {
            let _ = writeln!(
                failures,
                "{name}: {}\n at most {}, {} %, {}, {}; the worst files:\n{}",
                figures.described(),
                most.clauses,
                most.first_words,
                most.avoided,
                most.long_lines,
                worst(all, |source| source.home == home, 20)
            );
        }
    }
    assert!(failures.is_empty(), "\n{failures}");
}

pub(crate) fn report() -> String {
    let all = all();
    let mut text = String::new();
    for (home, name) in CRATES.iter().enumerate() {
        let _ = writeln!(text, "{name}: {}", of_crate(all, home).described());
    }
    let whole = Figures::sum(all.iter().map(|(_, figures)| figures));
    let _ = writeln!(text, "all: {}", whole.described());
    if !crate::crates::is_restricted() {
        text += &worst(all, |_| true, 40);
        return text;
    }
    let reported: Vec<_> = all
        .iter()
        .filter(|(source, _)| is_reported(source.path))
        .collect();
    let figures = Figures::sum(reported.iter().map(|(_, figures)| figures));
    let _ = writeln!(text, "here: {}", figures.described());
    let mut by_path: BTreeMap<&str, &Figures> = BTreeMap::new();
    for (source, figures) in reported {
        by_path.insert(source.path, figures);
    }
    for (path, figures) in by_path {
        for (line, fault) in &figures.places {
            let _ = writeln!(text, "  {path}:{line} {fault}");
        }
    }
    text
}
