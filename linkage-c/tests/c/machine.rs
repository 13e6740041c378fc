//! The system's C compiler.

use std::env;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use linkage_c::{ColumnSweeps, Sources};

/// What no file may be warned of.
pub(crate) const WARNINGS: [&str; 6] = [
    "-Wall",
    "-Wextra",
    "-Wpedantic",
    "-Wconversion",
    "-Wdouble-promotion",
    "-Werror",
];

/// A compiler, by its command.
pub(crate) struct Compiler(String);

impl Compiler {
    /// `CC` or `cc`, if that can be run. Without one tests pass and say so, unless `LINKAGE_CC=required` is in the environment.
    pub(crate) fn find() -> Option<Self> {
        let command = env::var("CC").unwrap_or_else(|_| "cc".to_owned());
        if let Some(found) = Self::named(&command) {
            return Some(found);
        }
        let required = env::var("LINKAGE_CC").is_ok_and(|word| word == "required");
        assert!(!required, "there is no C compiler `{command}`");
        println!("skipped: there is no C compiler `{command}`");
        None
    }

    /// A compiler of this name, if there is one.
    pub(crate) fn named(command: &str) -> Option<Self> {
        let found = Command::new(command).arg("--version").output();
        let found = found.is_ok_and(|output| output.status.success());
        found.then(|| Self(command.to_owned()))
    }

    /// Runs it in a folder; it must succeed.
    pub(crate) fn run(&self, folder: &Path, arguments: &[&str]) {
        let tried = self.attempt(folder, arguments);
        assert!(
            tried.is_ok(),
            "{} in {}:\n{}",
            self.0,
            folder.display(),
            tried.unwrap_err()
        );
    }

    /// Runs it in a folder; its messages if it fails.
    pub(crate) fn attempt(&self, folder: &Path, arguments: &[&str]) -> Result<(), String> {
        let mut command = Command::new(&self.0);
        let output = command.current_dir(folder).args(arguments).output();
        let output = output.expect("the compiler runs");
        match output.status.success() {
            true => Ok(()),
            false => Err(String::from_utf8_lossy(&output.stderr).into_owned()),
        }
    }
}

/// Compilers of C and C++ that are here, by their commands: the system's, and versions that it may have beside them.
pub(crate) fn compilers() -> Vec<(&'static str, Compiler)> {
    let commands = [
        "gcc",
        "clang",
        "clang-14",
        "clang-19",
        "g++",
        "clang++",
        "clang++-14",
        "clang++-19",
    ];
    let here = commands.into_iter();
    here.filter_map(|own| Some((own, Compiler::named(own)?)))
        .collect()
}

/// A new folder for the files of a test.
pub(crate) fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("c").join(name);
    if folder.exists() {
        fs::remove_dir_all(&folder).expect("what an earlier run wrote can be removed");
    }
    fs::create_dir_all(&folder).expect("a folder can be made");
    folder
}

/// Writes both files.
pub(crate) fn write(folder: &Path, sources: &Sources) {
    let file = |end: &str| folder.join(&sources.name).with_extension(end);
    fs::write(file("h"), &sources.header).expect("a header can be written");
    fs::write(file("c"), &sources.source).expect("a source can be written");
}

/// Writes all four files.
pub(crate) fn write_columns(folder: &Path, sweeps: &ColumnSweeps) {
    write(folder, &sweeps.sources);
    for (end, text) in [("h", &sweeps.header), ("c", &sweeps.columns)] {
        let file = folder.join(format!("{}_columns.{end}", sweeps.sources.name));
        fs::write(file, text).expect("a file can be written");
    }
}

/// Runs a compiled program with numbers at its input, under an emulator if there is one; what it writes.
pub(crate) fn run(emulator: Option<&str>, program: &Path, input: &[u8]) -> Vec<u8> {
    let path = program.with_extension("in");
    fs::write(&path, input).expect("numbers can be written");
    let input = fs::File::open(path).expect("they are there");
    let mut command = match emulator {
        Some(emulator) => Command::new(emulator),
        None => Command::new(program),
    };
    command.args(emulator.map(|_| program));
    let output = command.stdin(input).output();
    let output = output.expect("the program runs");
    assert!(output.status.success(), "{}", output.status);
    output.stdout
}
