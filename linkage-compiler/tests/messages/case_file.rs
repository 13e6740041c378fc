//! The form of a file of cases.

use std::fmt;

/// The line in front of a case, before its name.
const HEAD: &str = "=== ";
/// The line between the mechanism and its messages.
const BETWEEN: &str = "---";

/// A mechanism and the messages about it.
pub(crate) struct Case {
    pub(crate) name: String,
    /// Lines with their ends.
    pub(crate) mechanism: String,
    /// Messages with a blank line between two of them, and a line end after the last.
    pub(crate) messages: String,
}

/// All cases of a phase.
pub(crate) struct CaseFile {
    /// The lines before the first case.
    introduction: String,
    pub(crate) cases: Vec<Case>,
}

impl CaseFile {
    /// Reads the text of a file.
    ///
    /// # Errors
    ///
    /// If a case has no messages' section, no mechanism, or the name of another.
    pub(crate) fn parsed(text: &str) -> Result<Self, String> {
        let mut file = Self {
            introduction: String::new(),
            cases: Vec::new(),
        };
        let mut is_message = true;
        for line in text.lines() {
            if let Some(name) = line.strip_prefix(HEAD) {
                if !is_message {
                    return Err(format!("a line `{BETWEEN}` is missing before `{name}`"));
                }
                if file.cases.iter().any(|case| case.name == name) {
                    return Err(format!("there are two cases `{name}`"));
                }
                is_message = false;
                file.cases.push(Case {
                    name: name.to_owned(),
                    mechanism: String::new(),
                    messages: String::new(),
                });
                continue;
            }
            let Some(case) = file.cases.last_mut() else {
                push_line(&mut file.introduction, line);
                continue;
            };
            match (is_message, line) {
                (false, BETWEEN) if case.mechanism.is_empty() => {
                    return Err(format!("`{}` has no mechanism", case.name));
                }
                (false, BETWEEN) => is_message = true,
                (false, line) => push_line(&mut case.mechanism, line),
                (true, line) => push_line(&mut case.messages, line),
            }
        }
        if !is_message {
            return Err(format!("a line `{BETWEEN}` is missing at the end"));
        }
        for case in &mut file.cases {
            without_blank_end(&mut case.messages);
        }
        without_blank_end(&mut file.introduction);
        Ok(file)
    }
}

impl fmt::Display for CaseFile {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", self.introduction)?;
        for case in &self.cases {
            write!(f, "\n{HEAD}{}\n{}{BETWEEN}\n", case.name, case.mechanism)?;
            write!(f, "{}", case.messages)?;
        }
        Ok(())
    }
}

fn push_line(text: &mut String, line: &str) {
    text.push_str(line);
    text.push('\n');
}

/// Removes blank lines at the end.
fn without_blank_end(text: &mut String) {
    while text.ends_with("\n\n") || text == "\n" {
        text.pop();
    }
}

#[test]
fn faults_of_a_file_are_reported() {
    let fault = |text| CaseFile::parsed(text).err().unwrap_or_default();
    assert_eq!(fault("=== a\nstruct A {}\n---\n"), "");
    assert_eq!(fault("=== a\n---\n"), "`a` has no mechanism");
    let twice = "=== a\nstruct A {}\n---\n=== a\nstruct A {}\n---\n";
    assert_eq!(fault(twice), "there are two cases `a`");
    let inside = "=== a\nstruct A {}\n=== b\nstruct B {}\n---\n";
    assert_eq!(fault(inside), "a line `---` is missing before `b`");
    assert_eq!(
        fault("=== a\nstruct A {}\n"),
        "a line `---` is missing at the end"
    );
}
