//! A page that leads to several reports.

use std::borrow::ToOwned;
use std::format;
use std::fs;
use std::path::{Path, PathBuf};
use std::string::String;
use std::vec::Vec;

use super::builder::Report;
use super::frame::bare;
use super::positioned_picture;
use super::version::{follow_script, version_file};
use linkage_formats::characters::{control, escaped};
use linkage_formats::error::{ReportError, failed};
use linkage_formats::output_file;

const FRAME: &str = include_str!("page/index.html");

/// A page with a picture of each report and a link to it.
///
/// ```no_run
/// # fn two() -> Result<(), linkage_report::ReportError> {
/// # let input = linkage_runtime::Input { name: "phi", unit: "rad", reference: 0.0, range: None };
/// # let report = linkage_report::Report::new("Press", &input, &[]);
/// use linkage_report::Index;
///
/// report.write("machine/press")?;
/// Index::new("Machine").report("press", &report).write("machine")?;
/// # Ok(())
/// # }
/// ```
#[derive(Clone, Debug)]
pub struct Index {
    title: String,
    entries: Vec<Entry>,
    version: Option<u64>,
}

#[derive(Clone, Debug)]
struct Entry {
    folder: String,
    title: String,
    about: String,
    drawn: bool,
}

impl Index {
    /// A page with this title.
    #[must_use]
    pub fn new(title: impl Into<String>) -> Self {
        Self {
            title: title.into(),
            entries: Vec::new(),
            version: None,
        }
    }

    /// Sets the version of a page that is written repeatedly, as [`Report::version`] does.
    #[must_use]
    pub fn version(mut self, version: u64) -> Self {
        self.version = Some(version);
        self
    }

    /// A report that is written to a folder beside the page.
    #[must_use]
    pub fn report(mut self, folder: impl Into<String>, report: &Report) -> Self {
        self.entries.push(Entry {
            folder: folder.into(),
            title: report.title.clone(),
            about: report.about.clone(),
            drawn: positioned_picture::is_drawable(report),
        });
        self
    }

    /// Writes `index.html` into a folder, which is made if it is not there, and returns its path.
    ///
    /// # Errors
    ///
    /// If the file cannot be written, or the title has control characters.
    pub fn write(&self, folder: impl AsRef<Path>) -> Result<PathBuf, ReportError> {
        if let Some(mistake) = control("the title", &self.title) {
            return Err(mistake.into());
        }
        let folder = folder.as_ref();
        fs::create_dir_all(folder).map_err(failed(folder))?;
        let page = output_file::file(&folder.join("index.html"), self.html())?;
        if let Some(version) = self.version {
            let (path, text) = version_file(folder, version);
            output_file::file(&path, text)?;
        }
        Ok(page)
    }

    /// The page.
    #[must_use]
    pub fn html(&self) -> String {
        let entries: Vec<String> = self.entries.iter().map(Entry::html).collect();
        FRAME
            .replace("<!-- title -->", &escaped(&self.title))
            .replace("<!-- script -->", &script(self.version))
            .replacen("<!-- entries -->", &entries.join("\n"), 1)
    }
}

impl Entry {
    fn html(&self) -> String {
        let folder = address(&self.folder);
        let [title, about] = [&self.title, &self.about].map(|text| escaped(text));
        let picture = match self.drawn {
            true => format!("<img src=\"{folder}/drawing.svg\" alt=\"\">"),
            false => "<div class=\"none\"></div>".to_owned(),
        };
        format!("<a href=\"{folder}/index.html\">{picture}<h2>{title}</h2><p>{about}</p></a>")
    }
}

/// The script of a page that follows its versions.
fn script(version: Option<u64>) -> String {
    match version {
        Some(_) => format!("<script>\n{}</script>\n", bare(&follow_script(version))),
        None => String::new(),
    }
}

/// A folder as part of an address.
fn address(folder: &str) -> String {
    let plain = |byte: u8| byte.is_ascii_alphanumeric() || b"-._~/".contains(&byte);
    let byte = |byte: u8| match plain(byte) {
        true => String::from(char::from(byte)),
        false => format!("%{byte:02X}"),
    };
    folder.bytes().map(byte).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn folders_become_addresses() {
        assert_eq!(address("press #2/50%"), "press%20%232/50%25");
    }

    #[test]
    fn titles_are_no_markup() {
        let input = linkage_runtime::Input {
            name: "phi",
            unit: "rad",
            reference: 0.0,
            range: None,
        };
        let report = Report::new("<b>A & B</b>", &input, &[]).about("\"quoted\"");
        let html = Index::new("All <of> them").report("a", &report).html();
        assert!(html.contains("<h2>&lt;b&gt;A &amp; B&lt;/b&gt;</h2><p>&quot;quoted&quot;</p>"));
        assert!(html.contains("<title>All &lt;of&gt; them</title>") && !html.contains("<img"));
    }
}
