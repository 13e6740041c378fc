//! README, `docs/` and what else is read in the repository: lines that fit beside code, links that lead somewhere.

use std::fs;
use std::path::{Path, PathBuf};

/// Lines are shorter. Rows of tables are as long as they are, and so is what a command prints: they cannot be broken.
const TOO_LONG: usize = 120;

fn pages() -> Vec<PathBuf> {
    let alone = [
        "README.md",
        "ARCHITECTURE.md",
        "CONTRIBUTING.md",
        "tests/README.md",
    ];
    let mut pages: Vec<PathBuf> = alone.iter().map(PathBuf::from).collect();
    let packages = fs::read_dir(".").expect("the repository");
    let packages = packages.map(|entry| entry.expect("an entry").path());
    let own = packages.filter(|path| path.join("Cargo.toml").exists());
    pages.extend(own.map(|path| path.join("README.md")));
    for folder in ["docs", "docs/language"] {
        let entries = fs::read_dir(folder).expect("the folder is there");
        let paths = entries.map(|entry| entry.expect("an entry").path());
        pages.extend(paths.filter(|path| path.extension().is_some_and(|own| own == "md")));
    }
    assert!(pages.len() > 35, "{} pages", pages.len());
    pages
}

/// The lines of a page, with their numbers and whether they are code.
fn lines(text: &str) -> impl Iterator<Item = (usize, bool, &str)> {
    let mut in_code = false;
    text.lines().enumerate().map(move |(index, line)| {
        let fence = line.trim_start().starts_with("```");
        in_code ^= fence;
        (index + 1, in_code || fence, line)
    })
}

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

/// What a link to a heading ends with: small letters, and strokes for what is between words.
fn anchor(heading: &str) -> String {
    let letters = heading.trim_start_matches('#').trim().chars();
    let kept = letters.filter(|own| own.is_alphanumeric() || " -_".contains(*own));
    kept.collect::<String>().to_lowercase().replace(' ', "-")
}

fn has_heading(text: &str, wanted: &str) -> bool {
    lines(text)
        .any(|(_, in_code, line)| !in_code && line.starts_with('#') && anchor(line) == wanted)
}

/// Targets of links in the lines of a page, but for code: `](target)` and `[name]: target`.
fn targets(text: &str) -> Vec<String> {
    let prose: Vec<&str> = lines(text)
        .filter(|(_, in_code, _)| !in_code)
        .map(|own| own.2)
        .collect();
    let prose = prose.join("\n");
    let within = prose
        .split("](")
        .skip(1)
        .filter_map(|rest| Some(rest.split_once(')')?.0));
    let defined = prose
        .lines()
        .filter_map(|line| Some(line.strip_prefix('[')?.split_once("]: ")?.1));
    within.chain(defined).map(String::from).collect()
}

/// Links between pages lead to files that are there, and to their headings. The introduction is read as documentation of the crate, and
/// its links are items.
#[test]
fn links_lead_somewhere() {
    let mut count = 0;
    for page in pages() {
        let text = fs::read_to_string(&page).expect("a page");
        let is_item = |target: &String| target.contains("::") || target.contains('@');
        let targets = targets(&text)
            .into_iter()
            .filter(|own| !own.starts_with("http"));
        for target in targets.filter(|own| !is_item(own)) {
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

/// Pages that are documentation of modules of the crate: they stand behind `links.md`, which the introduction does without.
fn pages_of_the_crate() -> Vec<PathBuf> {
    let source = fs::read_to_string("src/lib.rs").expect("the crate");
    let pages = source.split("include_str!(\"../docs/").skip(1);
    let pages = pages.filter_map(|rest| Some(rest.split_once('"')?.0));
    let pages = pages.filter(|page| *page != "introduction.md");
    let pages: Vec<PathBuf> = pages.map(|page| Path::new("docs").join(page)).collect();
    assert!(pages.len() > 20, "{} pages", pages.len());
    pages
}

/// Names that lines `[name]: target` of a page define, but for code.
fn defined(text: &str) -> Vec<String> {
    let prose = lines(text).filter(|(_, in_code, _)| !in_code);
    let names = prose.filter_map(|(_, _, line)| Some(line.strip_prefix('[')?.split_once("]: ")?.0));
    names.map(String::from).collect()
}

/// The documentation of the crate has no files: a link leads to a module there, by a name that `links.md` defines, too, or the
/// module itself, where it stands behind a feature.
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
        let behind_links = before
            .trim_end_matches("#![doc = ")
            .trim_end()
            .ends_with("include_str!(\"links.md\")]");
        assert!(
            names.is_empty() || behind_links,
            "{}: src/lib.rs does not put links.md before it",
            page.display()
        );
        used.extend(names);
    }
    for name in items {
        assert!(used.contains(&name), "src/links.md: no page uses `{name}`");
    }
}
