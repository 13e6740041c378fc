//! Pictures of the documents, drawn from the samples on their pages.
//!
//! `UPDATE=1 cargo test -p linkage-cli --test pictures` writes them.

mod cookbook;
mod language;
mod rows;
mod sample;

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use sample::Page;

/// A picture of a page.
pub(crate) struct Picture {
    /// Its path below the folder of the page.
    path: &'static str,
    svg: String,
}

/// A page with its pictures. `folder` has no other files.
struct Illustrated {
    page: Page,
    folder: &'static str,
    draw: fn(&Page) -> Vec<Picture>,
}

/// A reader on a slow connection loads some of them with each page.
const LARGEST: usize = 20_000;
/// An alternative text with fewer letters does not describe a picture.
const SHORTEST_DESCRIPTION: usize = 30;

fn illustrated() -> [Illustrated; 4] {
    let illustrated = |page, folder, draw| Illustrated {
        page: Page::read(page),
        folder,
        draw,
    };
    [
        illustrated("language/pictures.md", "pictures", language::pictures),
        illustrated("language/forces.md", "forces", language::forces),
        illustrated("language/loops.md", "loops", language::loops),
        illustrated("cookbook.md", "cookbook", cookbook::pictures),
    ]
}

fn files(folder: &Path) -> BTreeSet<PathBuf> {
    let entries = fs::read_dir(folder).into_iter().flatten();
    let paths = entries.map(|entry| entry.expect("an entry").path());
    paths.collect()
}

/// Faults of a page, after its pictures are written if `update`.
fn faults(illustrated: &Illustrated, update: bool) -> Vec<String> {
    let Illustrated { page, folder, draw } = illustrated;
    let parent = page.path.parent().expect("a folder");
    let mut faults = Vec::new();
    let mut drawn = BTreeSet::new();
    for Picture { path, svg } in draw(page) {
        let path = parent.join(path);
        if update {
            fs::create_dir_all(path.parent().expect("a folder")).expect("a folder");
            fs::write(&path, &svg).expect("the documents can be written");
        }
        if fs::read_to_string(&path).ok().as_ref() != Some(&svg) {
            faults.push(format!("{}: the sample gives another", path.display()));
        }
        if svg.len() > LARGEST {
            faults.push(format!("{}: {} bytes", path.display(), svg.len()));
        }
        drawn.insert(path);
    }
    for path in files(&parent.join(folder)).difference(&drawn) {
        faults.push(format!("{}: no sample gives it", path.display()));
    }
    let images = page.images();
    for (description, target) in &images {
        if description.chars().count() < SHORTEST_DESCRIPTION {
            faults.push(format!("{target}: `{description}` does not describe it"));
        }
    }
    let shown: BTreeSet<PathBuf> = images.iter().map(|(_, own)| parent.join(own)).collect();
    for path in drawn.difference(&shown) {
        faults.push(format!("{}: the page does not show it", path.display()));
    }
    faults
}

#[test]
fn pictures_are_those_of_the_samples() {
    let update = std::env::var_os("UPDATE").is_some();
    let pages = illustrated();
    let faults: Vec<String> = pages.iter().flat_map(|own| faults(own, update)).collect();
    assert!(
        faults.is_empty(),
        "\n{}\n`UPDATE=1 cargo test -p linkage-cli --test pictures` writes the pictures",
        faults.join("\n")
    );
}
