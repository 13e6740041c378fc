//! The package compiled for another processor, and functions in the compiled library.

use crate::instruction::{Decode, Kind};
use object::read::archive::ArchiveFile;
use object::{
    File, Object, ObjectSection, ObjectSymbol, RelocationTarget, SectionIndex, SymbolKind,
};
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::process::Command;

// Functions in a compiled library.

/// A jump to a place in the function.
pub(crate) const INSIDE: &str = "itself";

/// What the code of a function is.
#[derive(Debug, Default)]
pub(crate) struct Function {
    pub(crate) instructions: usize,
    /// With the constants among them.
    pub(crate) bytes: usize,
    /// Square roots.
    pub(crate) roots: usize,
    pub(crate) divisions: usize,
    pub(crate) returns: usize,
    /// Offsets of jumps on a condition or to computed addresses.
    pub(crate) branches: Vec<u64>,
    /// Offsets of instructions in double precision.
    pub(crate) doubles: Vec<u64>,
    /// Names of what is called, as the linker knows them.
    pub(crate) calls: BTreeSet<String>,
}

/// The functions of the package.
pub(crate) struct Library {
    archive: Vec<u8>,
    decode: Decode,
}

impl Library {
    pub(crate) fn read(path: &Path, decode: Decode) -> Self {
        let archive = std::fs::read(path).expect("the library can be read");
        Self { archive, decode }
    }

    /// The function whose mangled name contains this one.
    ///
    /// # Panics
    ///
    /// If there is not exactly one.
    pub(crate) fn function(&self, name: &str) -> Function {
        let archive = ArchiveFile::parse(&*self.archive).expect("an archive");
        let members = archive
            .members()
            .map(|member| member.expect("a member of the archive"));
        let mut found = members
            .filter_map(|member| {
                let data = member.data(&*self.archive).expect("a member's bytes");
                // Next to machine code there are the compiler's own data.
                self.find(&File::parse(data).ok()?, name)
            })
            .collect::<Vec<_>>();
        assert_eq!(found.len(), 1, "functions named {name}");
        found.remove(0)
    }

    fn find(&self, file: &File, name: &str) -> Option<Function> {
        // The length stands before a name, and thus where it begins.
        let part = format!("{}{name}", name.len());
        let symbol = file.symbols().find(|symbol| {
            symbol.kind() == SymbolKind::Text
                && symbol.name().is_ok_and(|whole| whole.contains(&part))
        })?;
        // The lowest bit says that it is Thumb.
        let start = symbol.address() & !1;
        let end = start + symbol.size();
        let section = symbol.section_index()?;
        let calls = Relocations::of(file, section);
        let code = file.section_by_index(section).ok()?.data().ok()?;

        let mut function = Function {
            bytes: symbol.size() as usize,
            ..Function::default()
        };
        let mut place = start;
        while place < end {
            if let Some(next) = constants(file, section, place, end) {
                place = next;
                continue;
            }
            let (kind, length) = (self.decode)(&code[place as usize..]);
            function.instructions += 1;
            match kind {
                Kind::Branch => function.branches.push(place - start),
                Kind::Double => function.doubles.push(place - start),
                Kind::Return => function.returns += 1,
                Kind::Root => function.roots += 1,
                Kind::Division => function.divisions += 1,
                Kind::Call => {
                    function.calls.insert(calls.at(place));
                }
                Kind::Other => {}
            }
            place += length as u64;
        }
        Some(function)
    }
}

/// Where constants among the instructions end that begin here.
fn constants(file: &File, section: SectionIndex, place: u64, end: u64) -> Option<u64> {
    // Symbols of no size say what follows: `$d` data, others code.
    let marks = || {
        file.symbols().filter(move |symbol| {
            symbol.section_index() == Some(section)
                && symbol.name().is_ok_and(|name| name.starts_with('$'))
        })
    };
    let last = marks()
        .filter(|mark| mark.address() <= place)
        .max_by_key(|mark| mark.address())?;
    let next = marks()
        .map(|mark| mark.address())
        .filter(|&at| at > place)
        .min();
    let is_data = last.name().is_ok_and(|name| name.starts_with("$d"));
    is_data.then(|| next.unwrap_or(end))
}

/// What the linker fills in.
struct Relocations(Vec<(u64, String)>);

impl Relocations {
    fn of(file: &File, section: SectionIndex) -> Self {
        let section = file.section_by_index(section).expect("a section of code");
        let all = section.relocations().filter_map(|(place, relocation)| {
            let RelocationTarget::Symbol(index) = relocation.target() else {
                return None;
            };
            let symbol = file.symbol_by_index(index).ok()?;
            Some((place, symbol.name().ok()?.to_owned()))
        });
        Self(all.collect())
    }

    fn at(&self, place: u64) -> String {
        let found = self.0.iter().find(|(at, _)| *at == place);
        found.map_or_else(|| INSIDE.to_owned(), |(_, name)| name.clone())
    }
}

/// The library for a target, or nothing if its standard library is not installed.
///
/// # Panics
///
/// If `LINKAGE_TARGETS` has its name: then it must be.
pub(crate) fn library(target: &str) -> Option<PathBuf> {
    if !is_installed(target) {
        let required = std::env::var("LINKAGE_TARGETS").unwrap_or_default();
        let required = required.split_whitespace().any(|name| name == target);
        assert!(
            !required,
            "{target} is not installed: rustup target add {target}"
        );
        println!("{target} is not installed: skipped (rustup target add {target})");
        return None;
    }
    // Where this test was built: what runs on this machine, the macro among it, is there already.
    let directory = Path::new(env!("CARGO_TARGET_TMPDIR")).parent()?;
    let built = Command::new(env!("CARGO"))
        .args([
            "build",
            "--quiet",
            "--lib",
            "--package",
            "linkage-controllers",
        ])
        .args(["--target", target, "--target-dir"])
        .arg(directory)
        .current_dir(env!("CARGO_MANIFEST_DIR"))
        // Flags for this machine are none for others.
        .env_remove("RUSTFLAGS")
        .env_remove("CARGO_ENCODED_RUSTFLAGS")
        .status()
        .expect("cargo runs");
    assert!(built.success(), "the package compiles for {target}");
    Some(
        directory
            .join(target)
            .join("debug/liblinkage_controllers.rlib"),
    )
}

fn is_installed(target: &str) -> bool {
    let rustc = std::env::var_os("RUSTC").unwrap_or("rustc".into());
    let output = Command::new(rustc)
        .args(["--print", "target-libdir", "--target", target])
        .output()
        .expect("rustc runs");
    let path = String::from_utf8_lossy(&output.stdout);
    output.status.success() && Path::new(path.trim()).is_dir()
}
