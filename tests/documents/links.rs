//! Lines that fit next to code, and links that lead to files, headings and items.

use std::fs;
use std::path::{Path, PathBuf};

use crate::{has_heading, lines, pages, targets};

/// Lines are shorter. Rows of tables and the output of commands cannot be broken, so they are exempt.
const TOO_LONG: usize = 120;

#[test]
fn lines_are_not_long() {
    for page in pages() {
        let text = fs::read_to_string(&page).expect("a page");
        let mut fence = "";
        for (number, in_code, line) in lines(&text) {
            if line.starts_with("```") {
                fence = line;
            }
            let length = line.chars().count();
            let is_row = line.starts_with('|');
            let is_printed = in_code && fence == "```console";
            assert!(
                is_row || is_printed || length < TOO_LONG,
                "{}:{number}: {length}",
                page.display()
            );
        }
    }
}

/// Links between pages lead to existing files and headings.
#[test]
fn links_lead_somewhere() {
    let mut count = 0;
    for page in pages() {
        let text = fs::read_to_string(&page).expect("a page");
        let targets = targets(&text).into_iter();
        for target in targets.filter(|target| !target.starts_with("http")) {
            let (file, heading) = match target.split_once('#') {
                Some((file, heading)) => (file, Some(heading)),
                None => (target.as_str(), None),
            };
            let to = match file {
                "" => page.clone(),
                file => page.parent().unwrap_or(Path::new("")).join(file),
            };
            assert!(to.exists(), "{}: `{target}`", page.display());
            if let Some(heading) = heading {
                let text = fs::read_to_string(&to).expect("a page");
                assert!(
                    has_heading(&text, heading),
                    "{}: `{target}`",
                    page.display()
                );
            }
            count += 1;
        }
    }
    assert!(count > 80, "{count} links");
}

/// A name in brackets that a page does not define is no link where the repository is read.
#[test]
fn names_of_links_are_defined() {
    let mut count = 0;
    for page in pages() {
        let text = fs::read_to_string(&page).expect("a page");
        let prose = lines(&text).filter(|(_, in_code, _)| !in_code);
        for (number, _, line) in prose {
            let names = line
                .split("][")
                .skip(1)
                .filter_map(|rest| Some(rest.split_once(']')?.0));
            for name in names {
                let defined = text.contains(&format!("\n[{name}]: "));
                assert!(defined, "{}:{number}: `{name}`", page.display());
                count += 1;
            }
        }
    }
    assert!(count > 20, "{count} names");
}

/// Pages that document the crate and its modules: `#![doc = ...]`. Pages that are tested only are `#[doc = ...]`.
fn pages_of_the_crate() -> Vec<PathBuf> {
    let source = fs::read_to_string("src/lib.rs").expect("the crate");
    let pages = source.split("#![doc = include_str!(\"../docs/").skip(1);
    let pages = pages.filter_map(|rest| Some(rest.split_once('"')?.0));
    let pages: Vec<PathBuf> = pages.map(|page| Path::new("docs").join(page)).collect();
    assert!(pages.len() > 20, "{} pages", pages.len());
    pages
}

/// Names that lines `[name]: target` of a page define, outside code.
fn defined(text: &str) -> Vec<String> {
    let prose = lines(text).filter(|(_, in_code, _)| !in_code);
    let names = prose.filter_map(|(_, _, line)| Some(line.strip_prefix('[')?.split_once("]: ")?.0));
    names.map(String::from).collect()
}

/// The documentation of the crate has no files. There a link leads to a module by a name, which is defined in `links.md` too, or in the
/// module itself if that needs a feature.
#[test]
fn links_lead_somewhere_in_the_documentation_of_the_crate() {
    let links = fs::read_to_string("src/links.md").expect("links");
    let items = defined(&links);
    let source = fs::read_to_string("src/lib.rs").expect("the crate");
    let mut used = Vec::new();
    for page in pages_of_the_crate() {
        let text = fs::read_to_string(&page).expect("a page");
        for (number, _, line) in lines(&text).filter(|(_, in_code, _)| !in_code) {
            let targets = line
                .split("](")
                .skip(1)
                .filter_map(|rest| rest.split(')').next());
            for target in targets {
                assert!(
                    !target.contains(".md"),
                    "{}:{number}: `{target}` is no page of the crate",
                    page.display()
                );
            }
        }
        let names = defined(&text);
        for name in &names {
            let by_module = source.contains(&format!("#![doc = \"\\n[{name}]: crate::"));
            assert!(
                by_module || items.contains(name),
                "{}: `{name}` is not in src/links.md",
                page.display()
            );
        }
        let included = format!("include_str!(\"../{}\")", page.display());
        let before = source.split(&included).next().unwrap_or_default();
        let module = before.rsplit('{').next().unwrap_or_default();
        let after_links = module.contains("include_str!(\"links.md\")]");
        assert!(
            names.is_empty() || after_links,
            "{}: src/lib.rs does not put links.md before it",
            page.display()
        );
        used.extend(names);
    }
    for name in items {
        assert!(used.contains(&name), "src/links.md: no page uses `{name}`");
    }
}
