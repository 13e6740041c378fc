//! Scripts and styles of pages without the spaces that are for readers of the sources.

use std::string::String;

/// Appends a line of a script without spaces that separate nothing, and without a comment at its
/// end. Texts and regular expressions end on their line and stay as they are.
pub(super) fn push_tight(line: &str, script: &mut String) {
    let begin = script.len();
    let mut rest = line;
    while let Some(first) = rest.chars().next() {
        let before = script[begin..].chars().next_back();
        let whole = match first {
            '"' | '\'' => text_length(rest, first),
            '`' => template_length(rest),
            '/' if rest.starts_with("//") => break,
            '/' if expects_value(&script[begin..]) => expression_length(rest),
            _ => first.len_utf8(),
        };
        let (item, after) = rest.split_at(whole);
        let next = after.chars().next();
        if item != " " || separates(before, next) {
            script.push_str(item);
        }
        rest = after;
    }
    script.truncate(begin + script[begin..].trim_end().len());
}

/// Returns true if a space between two characters keeps words or operators apart.
fn separates(before: Option<char>, after: Option<char>) -> bool {
    let (Some(before), Some(after)) = (before, after) else {
        return false;
    };
    let is_word = |c: char| c.is_alphanumeric() || "_$\\".contains(c) || !c.is_ascii();
    (is_word(before) && is_word(after)) || (before == after && "+-/ ".contains(before))
}

/// The length of a text between quotes, these included.
fn text_length(line: &str, quote: char) -> usize {
    let mut escaped = false;
    for (at, c) in line.char_indices().skip(1) {
        match c {
            _ if escaped => escaped = false,
            '\\' => escaped = true,
            _ if c == quote => return at + c.len_utf8(),
            _ => {}
        }
    }
    line.len()
}

/// The length of a template, with the expressions in it.
fn template_length(line: &str) -> usize {
    let mut at = 1;
    while let Some(c) = line[at..].chars().next() {
        at += match c {
            '`' => return at + 1,
            '\\' => 1 + line[at + 1..].chars().next().map_or(0, char::len_utf8),
            '$' if line[at..].starts_with("${") => 2 + braced_length(&line[at + 2..]),
            _ => c.len_utf8(),
        };
    }
    line.len()
}

/// The length of an expression up to its closing brace, which is included.
fn braced_length(line: &str) -> usize {
    let mut depth = 0;
    let mut at = 0;
    while let Some(c) = line[at..].chars().next() {
        at += match c {
            '"' | '\'' => text_length(&line[at..], c),
            '`' => template_length(&line[at..]),
            _ => c.len_utf8(),
        };
        match c {
            '{' => depth += 1,
            '}' if depth == 0 => return at,
            '}' => depth -= 1,
            _ => {}
        }
    }
    line.len()
}

/// The length of a regular expression without its flags.
fn expression_length(line: &str) -> usize {
    let (mut escaped, mut in_class) = (false, false);
    for (at, c) in line.char_indices().skip(1) {
        match c {
            _ if escaped => escaped = false,
            '\\' => escaped = true,
            '[' => in_class = true,
            ']' => in_class = false,
            '/' if !in_class => return at + 1,
            _ => {}
        }
    }
    line.len()
}

/// Returns true where a slash begins a regular expression, and is no division.
fn expects_value(script: &str) -> bool {
    let written = script.trim_end();
    let keyword = |word: &str| {
        let before = written.strip_suffix(word).map(str::as_bytes);
        before.is_some_and(|before| before.last().is_none_or(|c| !c.is_ascii_alphanumeric()))
    };
    let after_sign = written
        .chars()
        .next_back()
        .is_none_or(|c| "(,=:[!&|?{;+-*%~^<>".contains(c));
    after_sign || ["return", "typeof", "case"].into_iter().any(keyword)
}

/// A style without comments and indentation.
pub(super) fn bare_style(style: &str) -> String {
    let mut text = String::new();
    let mut rest = style;
    while let Some((before, after)) = rest.split_once("/*") {
        text.push_str(before);
        rest = after.split_once("*/").map_or("", |(_, after)| after);
    }
    text.push_str(rest);
    let lines = text.lines().map(str::trim).filter(|line| !line.is_empty());
    lines.flat_map(|line| [line, "\n"]).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn spaces_that_separate_nothing_are_left_out() {
        for (line, expected) in [
            ("const a = b / 2; // half", "const a=b/2;"),
            ("return a - -b + +c - b;", "return a- -b+ +c-b;"),
            ("x = k - --b / 2;", "x=k- --b/2;"),
            (r#"f("a  b", 'c "d', e);"#, r#"f("a  b",'c "d',e);"#),
            (r#"f("a \" b" + c);"#, r#"f("a \" b"+c);"#),
            (
                "g(`a ${ b ? `c  ${d}` : \"}  `\" } e` + f);",
                "g(`a ${ b ? `c  ${d}` : \"}  `\" } e`+f);",
            ),
            ("h(/a  [/ ]+ b/g, c / d / e);", "h(/a  [/ ]+ b/g,c/d/e);"),
            ("return /a b/.test(c) && d;", "return/a b/.test(c)&&d;"),
            (
                "for (const [a, b] of c) { d(a in b); }",
                "for(const[a,b]of c){d(a in b);}",
            ),
            (
                "const \u{e4} = async () => ({ ...a });",
                "const \u{e4}=async()=>({...a});",
            ),
            ("url = \"http://a\"; // b", "url=\"http://a\";"),
        ] {
            let mut script = String::new();
            push_tight(line, &mut script);
            assert_eq!(script, expected);
        }
    }

    #[test]
    fn styles_lose_comments() {
        let style =
            "/* Of\n two lines. */\n\n  a { b: c; } /* d */\n\n  e::before { content: \"\"; }\n";
        assert_eq!(
            bare_style(style),
            "a { b: c; }\ne::before { content: \"\"; }\n"
        );
    }
}
