//! The file that tells an open page its newest version, and the mistakes that keep the report from
//! being written again.

use std::format;
use std::fs;
use std::path::{Path, PathBuf};
use std::string::String;

use linkage_formats::ReportError;
use linkage_formats::output_file;

/// The name of the file. A script is all that a page may load that was opened as a file.
const FILE: &str = "version.js";

/// The call in the file, up to the number.
const CALL: &str = "linkageVersion(";

/// Script of a page that follows the versions of its report.
const FOLLOW: &str = include_str!("page/follow.js");

/// Returns the script of a page of this version, which looks for newer ones.
pub(super) fn follow_script(version: Option<u64>) -> String {
    match version {
        Some(version) => format!("{FOLLOW}\nfollow({version});\n"),
        None => String::new(),
    }
}

/// Returns the path of the file in a folder, and its text for a version without mistakes.
pub(super) fn version_file(folder: &Path, version: u64) -> (PathBuf, String) {
    (folder.join(FILE), called(version, ""))
}

/// Shows mistakes on the open page of a folder, in place of those that it shows; an empty text
/// removes them. Returns false if the folder has no page that follows its
/// [versions](crate::Report::version).
///
/// # Errors
///
/// If the file of the version cannot be written.
pub fn show_mistakes(folder: impl AsRef<Path>, mistakes: &str) -> Result<bool, ReportError> {
    let path = folder.as_ref().join(FILE);
    let Some(version) = fs::read_to_string(&path)
        .ok()
        .and_then(|text| number(&text))
    else {
        return Ok(false);
    };
    output_file::file(&path, called(version, mistakes))?;
    Ok(true)
}

/// The call that the script of the page takes.
fn called(version: u64, mistakes: &str) -> String {
    let mistakes = match mistakes {
        "" => String::new(),
        text => format!(", {}", serde_json::Value::from(text)),
    };
    format!("{CALL}{version}{mistakes});\n")
}

fn number(text: &str) -> Option<u64> {
    let digits = text.strip_prefix(CALL)?;
    let end = digits.find(|c: char| !c.is_ascii_digit())?;
    digits[..end].parse().ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_version_is_read_back() {
        for mistakes in ["", "error: 7 \"quoted\"\n  --> a.mech:1:1"] {
            assert_eq!(number(&called(12, mistakes)), Some(12));
        }
        assert_eq!(number("linkageVersion(many);"), None);
    }
}
