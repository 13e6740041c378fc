//! rust-analyzer as a program of tests: it is asked as an editor asks it.
//!
//! Programs are described to it crate by crate, with the macro that the tests are built with: it
//! builds nothing.

mod client;

pub use client::{Analyzer, Location};
use serde_json::{Value, json};
use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::SystemTime;

/// Returns true if tests should run: rust-analyzer and the sources of the standard library are
/// there.
///
/// # Panics
///
/// If they are required by `LINKAGE_RUST_ANALYZER=required` and not there.
pub fn is_there() -> bool {
    let found = sysroot_sources().is_some_and(|path| path.is_dir())
        && std::process::Command::new("rust-analyzer")
            .arg("--version")
            .output()
            .is_ok_and(|output| output.status.success());
    let required = std::env::var("LINKAGE_RUST_ANALYZER").is_ok_and(|value| value == "required");
    assert!(
        found || !required,
        "rustup component add rust-analyzer rust-src"
    );
    found
}

// A program for rust-analyzer: its crates, described without Cargo.

/// A crate of modules that use the macro.
pub struct Project {
    folder: PathBuf,
}

/// Crates that generated code names, with the features of a build by default.
const CRATES: [(&str, &str, &[usize]); 5] = [
    ("linkage_core", "linkage-core/src/lib.rs", &[]),
    ("linkage_runtime", "linkage-runtime/src/lib.rs", &[0]),
    ("linkage_analysis", "linkage-analysis/src/lib.rs", &[0, 1]),
    ("linkage_macros", "linkage-macros/src/lib.rs", &[]),
    ("linkage", "src/lib.rs", &[0, 1, 2, 3]),
];

impl Project {
    /// Writes the modules, each a name and a text, and the description of the program.
    ///
    /// # Panics
    ///
    /// If the folder cannot be written, or there is no built macro next to the test.
    pub fn new(modules: &[(&str, &str)]) -> Self {
        let folder = std::env::temp_dir().join(format!("linkage-analyzer-{}", std::process::id()));
        std::fs::create_dir_all(&folder).expect("a folder for temporary files");
        let mut root = String::new();
        for (module, text) in modules {
            std::fs::write(folder.join(format!("{module}.rs")), text).expect("a file");
            root.push_str(&format!("pub mod {module};\n"));
        }
        std::fs::write(folder.join("lib.rs"), root).expect("a file");
        let description = description(&folder).to_string();
        std::fs::write(folder.join("rust-project.json"), description).expect("a file");
        Self { folder }
    }

    /// Returns the folder.
    pub fn folder(&self) -> &Path {
        &self.folder
    }

    /// Returns the path of a module.
    pub fn file(&self, module: &str) -> PathBuf {
        self.folder.join(format!("{module}.rs"))
    }
}

impl Drop for Project {
    fn drop(&mut self) {
        // What is left is in the folder for temporary files.
        let _ = std::fs::remove_dir_all(&self.folder);
    }
}

fn description(folder: &Path) -> Value {
    let repository = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let dependency = |index: usize| json!({ "crate": index, "name": CRATES[index].0 });
    let dependencies =
        |indices: &[usize]| -> Vec<Value> { indices.iter().copied().map(dependency).collect() };
    let mut crates: Vec<Value> = CRATES
        .iter()
        .map(|(name, root, uses)| {
            let mut one = json!({
                "display_name": name,
                "root_module": repository.join(root),
                "edition": "2024",
                "deps": dependencies(uses),
                "cfg": ["feature=\"std\"", "feature=\"alloc\"", "feature=\"tolerance\""],
                "is_workspace_member": false,
            });
            if *name == "linkage_macros" {
                one["is_proc_macro"] = true.into();
                one["proc_macro_dylib_path"] = json!(built_macro());
            }
            one
        })
        .collect();
    crates.push(json!({
        "display_name": "program",
        "root_module": folder.join("lib.rs"),
        "edition": "2024",
        "deps": dependencies(&[CRATES.len() - 1]),
        "is_workspace_member": true,
    }));
    json!({
        "sysroot": sysroot(),
        "sysroot_src": sysroot_sources(),
        "crates": crates,
    })
}

/// The library of the macro that is built with the test, the newest if there are several.
fn built_macro() -> PathBuf {
    let test = std::env::current_exe().expect("the path of the test");
    let folder = test.parent().expect("it is in a folder");
    let prefix = format!("{}linkage_macros-", std::env::consts::DLL_PREFIX);
    let libraries = std::fs::read_dir(folder)
        .expect("a folder")
        .flatten()
        .filter(|entry| {
            let name = entry.file_name().to_string_lossy().into_owned();
            name.starts_with(&prefix) && name.ends_with(std::env::consts::DLL_SUFFIX)
        });
    let built = |entry: &std::fs::DirEntry| {
        let changed = entry.metadata().and_then(|data| data.modified());
        changed.unwrap_or(SystemTime::UNIX_EPOCH)
    };
    let newest = libraries.max_by_key(built);
    newest.expect("a macro is built with the test").path()
}

fn sysroot() -> Option<PathBuf> {
    let output = Command::new("rustc")
        .args(["--print", "sysroot"])
        .output()
        .ok()?;
    let path = String::from_utf8(output.stdout).ok()?;
    Some(PathBuf::from(path.trim()))
}

/// Returns the folder where the sources of the standard library are if they are installed.
fn sysroot_sources() -> Option<PathBuf> {
    Some(sysroot()?.join("lib/rustlib/src/rust/library"))
}
