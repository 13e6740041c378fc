//! The size of the folder.

use std::fs;
use std::path::Path;

use miniz_oxide::deflate::compress_to_vec;

use crate::built::built;

/// Bytes of all files, each compressed as servers send it.
const LARGEST: usize = 3_000_000;

fn compressed(file: &Path) -> usize {
    let bytes = fs::read(file).unwrap_or_else(|error| panic!("{}: {error}", file.display()));
    compress_to_vec(&bytes, 9).len()
}

#[test]
fn the_folder_is_small() {
    let Some(built) = built() else {
        return;
    };
    let folder = built.page.parent().expect("a folder");
    let files = fs::read_dir(folder).expect("the folder");
    let sizes = files.map(|file| compressed(&file.expect("a file").path()));
    let size: usize = sizes.sum();
    println!("{:.2} MB compressed", size as f64 / 1e6);
    assert!(
        (LARGEST / 2..=LARGEST).contains(&size),
        "{size} bytes, at most {LARGEST}"
    );
}
