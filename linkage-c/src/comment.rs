//! Comments of C.

/// Columns of text, the signs of the comment with it.
const WIDTH: usize = 140;

/// A text as a comment, broken into lines; ends with a line's end. Its own lines stay apart, empty
/// ones at its ends are left out.
pub(crate) fn comment(indent: &str, text: &str) -> String {
    // Neither ends the comment early nor begins another one, nor stands for a backslash in old C.
    let text = text.replace("*/", "* /").replace("/*", "/ *");
    let text = text.replace("?/", "? /");
    let mut lines: Vec<String> = Vec::new();
    for paragraph in text.trim().lines() {
        let mut line = String::new();
        for word in paragraph.split_whitespace() {
            let full = indent.len() + 3 + line.len() + 1 + word.len() + 3 > WIDTH;
            if full && !line.is_empty() {
                lines.push(std::mem::take(&mut line));
            }
            if !line.is_empty() {
                line.push(' ');
            }
            line += word;
        }
        lines.push(line);
    }
    let mut comment = format!("{indent}/* ");
    for (index, line) in lines.iter().enumerate() {
        match (index, line.is_empty()) {
            (0, _) => {}
            // No blanks at a line's end.
            (_, true) => comment.push('\n'),
            (_, false) => comment += &format!("\n{indent}   "),
        }
        comment += line;
    }
    comment + " */\n"
}
