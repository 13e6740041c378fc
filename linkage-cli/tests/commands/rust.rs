//! `linkage rust`: the module that `tests/printed` compiles is that of the command. `UPDATE=1` writes it anew.

use std::env;
use std::fs;
use std::path::Path;

use crate::{folder, printed, refused};

#[test]
fn the_module_that_is_checked_in_is_printed() {
    let folder = folder("rust");
    printed(&folder, &["new", "slider.mech"]);
    let text = printed(&folder, &["rust", "slider.mech"]);
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let checked_in = root.join("tests/printed/src/slider_crank.rs");
    if env::var_os("UPDATE").is_some() {
        fs::write(&checked_in, &text).expect("it can be written");
    }
    let expected = fs::read_to_string(checked_in).expect("it is there");
    // Thousands of lines: the first that differs says enough.
    let differs = text.lines().zip(expected.lines()).find(|(a, b)| a != b);
    assert_eq!(differs, None);
    assert_eq!(text.len(), expected.len());
}

#[test]
fn features_choose_items_and_mistakes_print_nothing() {
    let folder = folder("rust_features");
    printed(&folder, &["new", "slider.mech"]);
    let with = |features: &str| printed(&folder, &["rust", "slider.mech", "--features", features]);
    let (few, all) = (with("none"), with("alloc,report"));
    let has = |text: &str| {
        [
            "fn stroke(",
            "stroke_sweep,",
            "stroke_sweep_parallel_into]",
            "for StrokeColumns",
        ]
        .map(|item| text.contains(item) || text.contains(&item.replace("for ", "::")))
    };
    assert_eq!(has(&few), [true, false, false, false]);
    assert_eq!(has(&all)[..3], [true; 3]);
    assert!(!all.contains("if_alloc") && !all.contains("if_report"));
    assert_eq!(all.matches("clippy::pedantic").count(), 1);
    let said = refused(
        &folder,
        &["rust", "slider.mech", "--features", "reports"],
        2,
    );
    assert!(said.contains("invalid value 'reports'"), "{said}");

    let text = fs::read_to_string(folder.join("slider.mech")).expect("the mechanism");
    fs::write(folder.join("wrong.mech"), text.replace("40mm", "40kg")).expect("a file");
    let said = refused(&folder, &["rust", "wrong.mech", "-o", "wrong.rs"], 1);
    assert!(said.starts_with("error: "), "{said}");
    assert!(!folder.join("wrong.rs").exists());
    let said = refused(&folder, &["rust", "slider.mech", "-o", "slider.mech"], 1);
    assert!(said.contains("slider.mech"), "{said}");
}
