//! Lines of a formatted text: their breaks, their indents and the columns of marks and comments.

use linkage_language::syntax::{ItemWord, Word};

use super::spacing::Gap;
use crate::lexer::{Kind, Token};

/// The number of blanks of an indent.
const INDENT: usize = 4;

/// The column of comments after items, unless an item is longer.
const COMMENTS: usize = 48;

/// A line that has been written.
#[derive(Default)]
struct Line {
    indent: usize,
    code: String,
    /// The comment after it.
    comment: Option<String>,
    /// True after a blank line.
    is_after_blank: bool,
    /// The word of the item, and the byte of the `=` after its name.
    equals: Option<(ItemWord, usize)>,
    /// True if the user wrote more than one blank before that `=`.
    is_padded: bool,
}

/// A bracket without its partner so far.
struct Open {
    /// The indent of its line.
    indent: usize,
    /// True for the braces after `struct NAME` and `impl NAME`.
    is_block: bool,
    /// True for those after `struct NAME`.
    is_struct: bool,
}

/// Writes tokens one after the other.
pub(super) struct Writer<'t> {
    text: &'t str,
    tokens: &'t [&'t Token],
    lines: Vec<Line>,
    open: Vec<Open>,
    /// The last of `struct` and `impl`.
    is_struct: bool,
    /// True at the beginning of an item.
    at_item: bool,
}

impl<'t> Writer<'t> {
    pub(super) fn new(text: &'t str, tokens: &'t [&'t Token]) -> Self {
        Self {
            text,
            tokens,
            lines: Vec::new(),
            open: Vec::new(),
            is_struct: false,
            at_item: true,
        }
    }

    /// Writes the token of this index.
    pub(super) fn write(&mut self, index: usize) {
        let token = self.tokens[index];
        let word = token.text(self.text);
        let breaks = self.breaks_before(index);
        let is_after_code = index > 0 && breaks == 0;
        if token.kind == Kind::Comment && is_after_code && self.ends_line(index) {
            let line = self.lines.last_mut();
            line.expect("code before it").comment = Some(spaced(word));
            return;
        }
        let closed = match token.kind {
            Kind::Close => self.open.pop(),
            _ => None,
        };
        if !is_after_code {
            let indent = match (&closed, self.open.last()) {
                (Some(closed), _) => closed.indent,
                (None, None) => 0,
                (None, Some(open)) if self.at_item || !open.is_block => open.indent + INDENT,
                (None, Some(open)) => open.indent + 2 * INDENT,
            };
            self.lines.push(Line {
                indent,
                is_after_blank: breaks > 1,
                ..Line::default()
            });
        } else if (Gap {
            text: self.text,
            tokens: self.tokens,
            index,
        })
        .has_blank()
        {
            self.line().code.push(' ');
        }
        self.note_equals(index);
        let written = if token.is_trivia() {
            spaced(word)
        } else {
            word.to_owned()
        };
        self.line().code += &written;
        self.note(token, word);
    }

    fn line(&mut self) -> &mut Line {
        if self.lines.is_empty() {
            self.lines.push(Line::default());
        }
        self.lines.last_mut().expect("a line")
    }

    /// Keeps track of brackets and items after a token.
    fn note(&mut self, token: &Token, word: &str) {
        match word {
            "struct" => self.is_struct = true,
            "impl" => self.is_struct = false,
            _ => {}
        }
        if token.kind == Kind::Open {
            let is_block = self.open.is_empty() && word == "{";
            self.open.push(Open {
                indent: self.lines.last().map_or(0, |line| line.indent),
                is_block,
                is_struct: is_block && self.is_struct,
            });
        }
        let at_block = self.open.last().is_none_or(|open| open.is_block);
        let ends = matches!(word, ";" | "}" | "{") || token.is_trivia();
        if at_block && ends && (self.at_item || !token.is_trivia()) {
            self.at_item = true;
        } else if !token.is_trivia() {
            self.at_item = false;
        }
    }

    /// Returns the number of line breaks before a token: 0 on the same line, 2 after a blank line.
    fn breaks_before(&self, index: usize) -> usize {
        let token = self.tokens[index];
        let Some(before) = index.checked_sub(1).map(|before| self.tokens[before]) else {
            return 1;
        };
        let between = &self.text[before.range.end..token.range.start];
        let written = between.matches('\n').count();
        let (left, right) = (before.text(self.text), token.text(self.text));
        let block = self.open.last().filter(|open| open.is_block);
        let is_comment = token.kind == Kind::Comment;
        if left == "{" && right == "}" {
            return 0;
        }
        let begins = left == "{" && block.is_some();
        let ends = right == "}" && block.is_some();
        let is_item_over = match block {
            Some(open) if open.is_struct => left == ";",
            Some(_) | None => self.at_item && left == "}",
        };
        let is_forced = begins
            || ends
            || is_item_over
            || left.starts_with("//")
            || before.kind == Kind::Documentation
            || token.kind == Kind::Documentation;
        let most = if begins || ends { 1 } else { 2 };
        match written {
            0 if is_comment && !left.starts_with("//") => 0,
            0 => usize::from(is_forced),
            _ => written.min(most),
        }
    }

    /// Returns true for a comment at the end of its line.
    fn ends_line(&self, index: usize) -> bool {
        let comment = self.tokens[index];
        let rest = &self.text[comment.range.end..];
        let next = rest.trim_start_matches([' ', '\t', '\r']);
        comment.text(self.text).starts_with("//") || next.is_empty() || next.starts_with('\n')
    }

    /// Remembers the `=` after the name of an item, whose column is that of its neighbours.
    fn note_equals(&mut self, index: usize) {
        if self.tokens[index].text(self.text) != "=" || index < 2 {
            return;
        }
        let [word, name] = [index - 2, index - 1].map(|index| self.tokens[index]);
        let Some(word) = ItemWord::from_word(word.text(self.text)) else {
            return;
        };
        let blanks = self.tokens[index].range.start - name.range.end;
        let written = format!("{} {} ", word.word(), name.text(self.text));
        let line = self.line();
        if line.code == written {
            line.equals = Some((word, line.code.len()));
            line.is_padded = blanks > 1;
        }
    }

    /// Aligns marks and comments. Returns the text.
    pub(super) fn finished(mut self) -> String {
        align_equals(&mut self.lines);
        let mut text = String::new();
        let mut start = 0;
        while start < self.lines.len() {
            let rest = &self.lines[start + 1..];
            let length = 1 + rest.iter().take_while(|line| !line.is_after_blank).count();
            write_lines(&mut text, &self.lines[start..start + length]);
            start += length;
        }
        text
    }
}

/// Writes lines without a blank line between them, with their comments in one column.
fn write_lines(text: &mut String, lines: &[Line]) {
    let width = |line: &Line| line.indent + line.code.chars().count();
    let commented = lines.iter().filter(|line| line.comment.is_some());
    let column = commented
        .map(|line| width(line) + 1)
        .fold(COMMENTS, usize::max);
    if lines[0].is_after_blank && !text.is_empty() {
        text.push('\n');
    }
    for line in lines {
        let indent = if line.code.is_empty() { 0 } else { line.indent };
        *text += &" ".repeat(indent);
        *text += &line.code;
        if let Some(comment) = &line.comment {
            *text += &" ".repeat(column - width(line));
            *text += comment;
        }
        text.push('\n');
    }
}

/// Aligns the `=` of neighbours that begin with the same word, if the user has aligned one of them.
fn align_equals(lines: &mut [Line]) {
    let mut start = 0;
    while start < lines.len() {
        let Some((word, _)) = lines[start].equals else {
            start += 1;
            continue;
        };
        let rest = lines[start + 1..].iter();
        let alike = rest.take_while(|line| {
            !line.is_after_blank && line.equals.is_some_and(|(other, _)| other == word)
        });
        let run = start..start + 1 + alike.count();
        let columns = lines[run.clone()].iter();
        let column = columns
            .filter_map(|line| Some(line.equals?.1))
            .max()
            .unwrap_or(0);
        let is_padded = lines[run.clone()].iter().any(|line| line.is_padded);
        for line in lines[run.clone()].iter_mut().filter(|_| is_padded) {
            if let Some((_, at)) = line.equals {
                line.code.insert_str(at, &" ".repeat(column - at));
            }
        }
        start = run.end;
    }
}

/// Returns a comment with a blank after its marks.
fn spaced(comment: &str) -> String {
    let marks = comment.len() - comment.trim_start_matches(['/', '!']).len();
    let (marks, rest) = comment.split_at(marks);
    let is_line = marks.starts_with("//") && !rest.is_empty();
    match is_line && !rest.starts_with(char::is_whitespace) {
        true => format!("{marks} {}", rest.trim_end()),
        false => comment.trim_end().to_owned(),
    }
}
