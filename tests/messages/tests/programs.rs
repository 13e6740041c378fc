//! Programs that must compile and run, each for itself: they are in `src/bin`.

use std::process::Command;

/// Runs the programs, and knows their names.
macro_rules! programs {
    ($($name:ident)*) => {
        $(#[test]
        fn $name() {
            let status = Command::new(env!(concat!("CARGO_BIN_EXE_", stringify!($name)))).status();
            assert!(status.expect("it starts").success());
        })*

        const NAMES: &[&str] = &[$(stringify!($name)),*];
    };
}

programs! {
    also_meant
    attributes
    coupled_groups
    degenerate
    documented_items
    frames
    hostile_names
    inside_a_function
    inside_macro_rules
    language
    long_function
    names_of_functions
    no_implicit_prelude
    one_letter_names
    visibilities
}

#[test]
fn none_is_forgotten() {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/src/bin");
    for file in std::fs::read_dir(folder).expect("the folder can be read") {
        let path = file.expect("it can be read").path();
        let name = path.file_stem().and_then(|name| name.to_str());
        assert!(
            NAMES.contains(&name.expect("a name")),
            "{} is not run",
            path.display()
        );
    }
}
