//! The interactive page: one file with its style, its program and the report's data.

use std::string::String;

use super::colour::page_rules;
use super::{Report, ReportError};

const FRAME: &str = include_str!("page/page.html");
const STYLES: [&str; 4] = [
    include_str!("page/style.css"),
    include_str!("page/drawing.css"),
    include_str!("page/sheets.css"),
    include_str!("page/print.css"),
];
/// Joined in this order; the last one starts the page.
const SCRIPTS: [&str; 28] = [
    include_str!("page/dom.js"),
    include_str!("page/numbers.js"),
    include_str!("page/exact.js"),
    include_str!("page/data.js"),
    include_str!("page/position.js"),
    include_str!("page/picture.js"),
    include_str!("page/camera.js"),
    include_str!("page/symbols.js"),
    include_str!("page/parts.js"),
    include_str!("page/cylinders.js"),
    include_str!("page/room.js"),
    include_str!("page/names.js"),
    include_str!("page/points.js"),
    include_str!("page/traces.js"),
    include_str!("page/drawing.js"),
    include_str!("page/gestures.js"),
    include_str!("page/player.js"),
    include_str!("page/keys.js"),
    include_str!("page/curves.js"),
    include_str!("page/panel.js"),
    include_str!("page/choose.js"),
    include_str!("page/plots.js"),
    include_str!("page/tables.js"),
    include_str!("page/values.js"),
    include_str!("page/downloads.js"),
    include_str!("page/theme.js"),
    include_str!("page/print.js"),
    include_str!("page/start.js"),
];

/// Of a page that is written anew while it is open.
const FOLLOW: &str = include_str!("page/follow.js");

impl Report {
    /// An interactive page as one file that needs no network: the moving mechanism, plots, tables.
    ///
    /// # Errors
    ///
    /// As [`check`](Self::check).
    pub fn html(&self) -> Result<String, ReportError> {
        let data = embedded(&self.json()?);
        let follow = match self.version {
            Some(version) => std::format!("{FOLLOW}\nfollow({version});\n"),
            None => String::new(),
        };
        // In a function, so that the names in it do not meet those of the browser.
        let script = SCRIPTS.join("\n") + &follow;
        let script = std::format!("(() => {{\n\"use strict\";\n{script}}})();");
        // The data come last: they may contain anything, even the words that are replaced.
        Ok(FRAME
            .replace("<!-- title -->", &escaped(&self.title))
            .replace(
                "<!-- style -->",
                &enclosed("style", "", &(STYLES.join("\n") + &page_rules())),
            )
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
