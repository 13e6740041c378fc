//! The playground as a folder: the module for WebAssembly, the living page, and the front end.

use std::env;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use linkage_report::{PageView, page_view};
use serde_json::json;

const TARGET: &str = "wasm32-unknown-unknown";
/// Sweeps compute two positions at once.
const FLAGS: &str = "-C target-feature=+simd128";

/// The files of the playground.
#[derive(Clone, Debug)]
pub struct Playground {
    /// The module for WebAssembly.
    pub module: PathBuf,
    /// The page, in a folder with its licences.
    pub page: PathBuf,
}

/// Builds `target/playground`.
///
/// # Errors
///
/// If a program is missing or fails: the message.
pub fn playground() -> Result<Playground, String> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let target = env::var_os("CARGO_TARGET_DIR").map_or_else(|| root.join("target"), PathBuf::from);
    let web = root.join("linkage-playground/web");
    let module = module(&root, &target)?;
    packages(&web)?;
    let parts = target.join("playground-parts.json");
    let written = fs::write(&parts, page_parts());
    written.map_err(|error| format!("cannot write `{}`: {error}", parts.display()))?;
    let folder = target.join("playground");
    let mut bundle = Command::new("node");
    bundle
        .arg(web.join("build.mjs"))
        .args([&parts, &module, &folder]);
    run(&mut bundle, "node", "install node 20 or later")?;
    let page = folder.join("index.html");
    Ok(Playground { module, page })
}

/// Compiles the module, and returns its path.
fn module(root: &Path, target: &Path) -> Result<PathBuf, String> {
    let cargo = env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let mut compile = Command::new(cargo);
    compile
        .current_dir(root)
        .args(["build", "--package", "linkage-playground"])
        .args(["--profile", "wasm", "--target", TARGET])
        .env("RUSTFLAGS", FLAGS)
        .env_remove("CARGO_ENCODED_RUSTFLAGS");
    let advice = format!("`rustup target add {TARGET}` installs the target");
    run(&mut compile, "cargo", &advice)?;
    Ok(target.join(TARGET).join("wasm/linkage_playground.wasm"))
}

/// Installs the packages of the lock file, unless they are there.
fn packages(web: &Path) -> Result<(), String> {
    let installed = fs::read(web.join("node_modules/.package-lock.json")).is_ok();
    if installed {
        return Ok(());
    }
    let mut install = Command::new("npm");
    install
        .current_dir(web)
        .args(["ci", "--no-audit", "--no-fund", "--loglevel=error"])
        .stdout(Stdio::null());
    run(
        &mut install,
        "npm",
        "install node 20 or later with npm, and look at the network",
    )
}

/// Runs a program to its end.
fn run(command: &mut Command, name: &str, advice: &str) -> Result<(), String> {
    match command.status() {
        Ok(status) if status.success() => Ok(()),
        Ok(status) => Err(format!("`{name}` failed: {status}\nhelp: {advice}")),
        Err(error) => Err(format!("cannot run `{name}`: {error}\nhelp: {advice}")),
    }
}

/// The parts of the living page for the front end.
fn page_parts() -> String {
    let PageView {
        style,
        body,
        script,
    } = page_view(&linkage_js::interpreter());
    json!({ "style": style, "body": body, "script": script }).to_string()
}
