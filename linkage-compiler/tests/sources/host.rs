//! Builds of packages: the macro of a user's crate and the program share none, tests and macros of this workspace share all.

use std::collections::{BTreeMap, BTreeSet};
use std::process::Command;
use std::{env, fs};

const ROOT: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/..");

/// Packages that are for macros only, by the beginnings of their names.
const MACRO_ONLY: [&str; 6] = [
    "proc-macro2 ",
    "quote ",
    "syn ",
    "unicode-ident ",
    "linkage-compiler ",
    "linkage-symbolic ",
];

/// Packages that are for programs only.
const PROGRAM_ONLY: [&str; 5] = ["approx ", "nalgebra ", "num-", "simba ", "linkage-runtime "];

/// The builds in a user's crate: a build is a package with its version and its features.
struct Builds {
    of_the_macro: BTreeSet<String>,
    of_the_program: BTreeSet<String>,
}

/// Returns the output of `cargo tree` with the given options.
fn tree(options: &[&str]) -> String {
    let output = Command::new(env!("CARGO"))
        .current_dir(ROOT)
        .args(["tree", "--offline"])
        .args(options)
        .output()
        .expect("cargo runs");
    let messages = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{messages}");
    String::from_utf8(output.stdout).expect("a text")
}

/// Returns the builds of a crate that uses the facade with the given options of Cargo.
fn builds(options: &[&str]) -> Builds {
    let facade = ["--package", "linkage-mechanism", "--edges", "normal"];
    let printed = ["--no-dedupe", "--prefix", "depth", "--format", " {p} [{f}]"];
    let tree = tree(&[&facade, &printed[..], options].concat());
    let mut builds = Builds {
        of_the_macro: BTreeSet::new(),
        of_the_program: BTreeSet::new(),
    };
    // The depth of the macro whose dependencies follow.
    let mut macro_depth = None;
    for line in tree.lines() {
        let (depth, package) = line.split_once(' ').expect("a depth and a package");
        let depth: usize = depth.parse().expect("a number");
        if macro_depth.is_some_and(|above| depth <= above) {
            macro_depth = None;
        }
        if macro_depth.is_none() && package.contains("(proc-macro)") {
            macro_depth = Some(depth);
        }
        let side = match macro_depth {
            Some(_) => &mut builds.of_the_macro,
            None => &mut builds.of_the_program,
        };
        side.insert(package.to_owned());
    }
    builds
}

/// Returns the names of the facade's features.
fn features() -> Vec<String> {
    let manifest = fs::read_to_string(format!("{ROOT}/Cargo.toml")).expect("a manifest");
    let (_, after) = manifest.split_once("\n[features]\n").expect("features");
    let table = after.split("\n[").next().unwrap_or_default();
    let names = table.lines().filter_map(|line| line.split_once(" = "));
    names.map(|(name, _)| name.to_owned()).collect()
}

fn check(options: &[&str]) {
    let Builds {
        of_the_macro,
        of_the_program,
    } = builds(options);
    let both: Vec<_> = of_the_macro.intersection(&of_the_program).collect();
    assert!(both.is_empty(), "{options:?}: one build for both: {both:?}");
    let begins = |build: &str, names: &[&str]| names.iter().any(|name| build.starts_with(name));
    for build in &of_the_macro {
        assert!(!begins(build, &PROGRAM_ONLY), "{options:?}: {build}");
    }
    for build in &of_the_program {
        assert!(!begins(build, &MACRO_ONLY), "{options:?}: {build}");
    }
    let core =
        |side: &BTreeSet<String>| side.iter().any(|build| build.starts_with("linkage-core "));
    assert!(core(&of_the_macro) && core(&of_the_program), "{options:?}");
}

/// With one build for both, Cargo gives it the debug information of the program if it builds the program, and none if it
/// checks it. All that depends on it was then built twice, compiler and macro among it.
#[test]
fn macro_and_program_share_no_build() {
    check(&[]);
    check(&["--all-features"]);
    for feature in features() {
        check(&["--features", &feature]);
        check(&["--no-default-features", "--features", &feature]);
    }
}

/// Packages of which macros and tests of the workspace have a build each. Nothing of linkage is compiled for both with them.
const BUILT_TWICE: [&str; 1] = ["serde_json"];

/// `tests/command/Cargo.toml` gives packages the features that others want: without that, the compiler and all that depends on it are
/// built twice in each run of all tests.
#[test]
fn macros_and_tests_of_the_workspace_share_all_builds() {
    let edges = ["--workspace", "--edges", "normal,build,dev"];
    let tree = tree(&[&edges[..], &["--prefix", "none", "--format", "{p} [{f}]"]].concat());
    let builds = tree.lines().map(|line| line.trim_end_matches(" (*)"));
    let builds: BTreeSet<&str> = builds.filter(|line| !line.is_empty()).collect();
    let mut features: BTreeMap<(&str, &str), Vec<&str>> = BTreeMap::new();
    for build in builds {
        let (package, with) = build.split_once(" [").expect("its features");
        let mut words = package.split(' ');
        let named = (words.next().unwrap_or(""), words.next().unwrap_or(""));
        features.entry(named).or_default().push(with);
    }
    assert!(features.keys().any(|(name, _)| *name == "linkage-compiler"));
    features.retain(|(name, _), with| with.len() > 1 && !BUILT_TWICE.contains(name));
    assert!(features.is_empty(), "built twice: {features:#?}");
}
