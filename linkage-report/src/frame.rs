//! The frame of all pages: one file with style, data and program.

use std::string::String;

use super::spaces::{bare_style, push_tight};
use linkage_formats::characters::escaped;

const FRAME: &str = include_str!("page/frame.html");

/// The contents of a page.
pub(super) struct Framed<'a> {
    pub(super) title: &'a str,
    /// The title of the page of several reports in the folder above, if there is one.
    pub(super) index: Option<&'a str>,
    /// The allowed sources of everything that the page loads.
    pub(super) policy: &'a str,
    pub(super) style: &'a str,
    /// The elements between its head and its data.
    pub(super) body: &'a str,
    /// The id that the program finds the data by, and the data as JSON.
    pub(super) data: (&'a str, &'a str),
    pub(super) script: &'a str,
}

impl Framed<'_> {
    pub(super) fn html(&self) -> String {
        // In a function, so that the names in it do not meet those of the browser.
        let script = std::format!("(() => {{\n\"use strict\";\n{}}})();", bare(self.script));
        let (id, json) = self.data;
        let attributes = std::format!(" type=\"application/json\" id=\"{id}\"");
        let index = self.index.map(|title| {
            let title = escaped(title);
            std::format!("    <a id=\"index\" href=\"../index.html\">&larr; {title}</a>\n")
        });
        // The data come last: they may contain anything, even the words that are replaced.
        FRAME
            .replace("<!-- title -->", &escaped(self.title))
            .replace("<!-- index -->\n", &index.unwrap_or_default())
            .replace("<!-- policy -->", self.policy)
            .replace(
                "<!-- style -->",
                &enclosed("style", "", &bare_style(self.style)),
            )
            .replace("<!-- body -->\n", self.body)
            .replace("<!-- script -->", &enclosed("script", "", &script))
            .replacen(
                "<!-- data -->",
                &enclosed("script", &attributes, &embedded(json)),
                1,
            )
    }
}

/// Without comments, indentation and other spaces, which are for readers of the sources: a third of
/// a script. No text in scripts goes over lines.
pub(super) fn bare(script: &str) -> String {
    let lines = script.lines().map(str::trim_start);
    let mut text = String::new();
    for line in lines.filter(|line| !line.is_empty() && !line.starts_with("//")) {
        push_tight(line, &mut text);
        text.push('\n');
    }
    text
}

fn enclosed(tag: &str, attributes: &str, content: &str) -> String {
    std::format!("<{tag}{attributes}>\n{content}\n</{tag}>")
}

/// JSON that cannot end the element that it stands in.
fn embedded(json: &str) -> String {
    json.replace('<', "\\u003c")
}
