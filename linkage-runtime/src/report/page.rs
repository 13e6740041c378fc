//! The interactive page: one file with its style, its program and the report's data.

use std::string::String;

use super::{Report, ReportError};

const FRAME: &str = include_str!("page/page.html");
const STYLE: &str = include_str!("page/style.css");
/// Joined in this order.
const SCRIPTS: [&str; 1] = [include_str!("page/start.js")];

impl Report {
    /// An interactive page as one file that needs no network: the moving mechanism, plots, tables.
    ///
    /// # Errors
    ///
    /// As [`check`](Self::check).
    pub fn html(&self) -> Result<String, ReportError> {
        let data = embedded(&self.json()?);
        let script = SCRIPTS.join("\n");
        // The data come last: they may contain anything, even the words that are replaced.
        Ok(FRAME
            .replace("<!-- title -->", &escaped(&self.title))
            .replace("<!-- style -->", &enclosed("style", "", STYLE))
            .replace("<!-- script -->", &enclosed("script", "", &script))
            .replacen(
                "<!-- report -->",
                &enclosed("script", " type=\"application/json\" id=\"report\"", &data),
                1,
            ))
    }
}

fn enclosed(tag: &str, attributes: &str, content: &str) -> String {
    std::format!("<{tag}{attributes}>\n{content}\n</{tag}>")
}

/// JSON that cannot end the element that it stands in.
fn embedded(json: &str) -> String {
    json.replace('<', "\\u003c")
}

/// Text that is no markup.
pub(super) fn escaped(text: &str) -> String {
    text.replace('&', "&amp;")
        .replace('<', "&lt;")
        .replace('>', "&gt;")
        .replace('"', "&quot;")
}
