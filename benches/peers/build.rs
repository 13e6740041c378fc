//! Compiles the C kernels for the instruction set that the Rust code is compiled for, and their sweeps for
//! every set that may be chosen when the benchmark runs; and the mechanisms of the benchmarks as `linkage-c` prints them.

use std::path::{Path, PathBuf};
use std::{env, fs};

use linkage_c::{Real, sources};
use proc_macro2::{TokenStream, TokenTree};

fn main() {
    for file in [
        "folded.c",
        "kernels.c",
        "own_sine.h",
        "sine.h",
        "space.c",
        "sweeps.c",
    ] {
        println!("cargo:rerun-if-changed={file}");
    }
    println!("cargo:rustc-check-cfg=cfg(vector_sweeps)");
    let setting = |name: &str| env::var(name).unwrap_or_default();
    let features = setting("CARGO_CFG_TARGET_FEATURE");
    let fused = features.split(',').any(|feature| feature == "fma");
    let mut build = single(fused);
    build.file("kernels.c").file("space.c");
    build.compile("linkage_peers_kernels");
    for own_sine in [false, true] {
        let mut build = optimised();
        build.file("folded.c");
        // Whatever this machine has.
        build.flag_if_supported("-march=native");
        build.flag_if_supported("-ffp-contract=fast");
        if own_sine {
            build.define("OWN_SINE", None);
        }
        build.compile(&format!("linkage_peers_folded_{own_sine}"));
    }
    // Generated code chooses its instructions when it runs, so the exported code gets those of the machine.
    let mut build = single(fused);
    let real = match fused || machine_is_fused(&setting("HOST"), &setting("TARGET")) {
        true => {
            build.flag_if_supported("-march=native");
            build.flag_if_supported("-ffp-contract=fast");
            Real::Fused
        }
        false => Real::Double,
    };
    // As the page on C says of GCC and x86-64.
    for flag in [
        "-fschedule-insns",
        "-fsched-pressure",
        "-fno-tree-slp-vectorize",
    ] {
        build.flag_if_supported(flag);
    }
    let folder = setting("OUT_DIR");
    build.files(exported(Path::new(&folder), real, ""));
    build.compile("linkage_peers_exported");
    // Sweeps with two flags that everybody has.
    let mut build = cc::Build::new();
    build.opt_level(3).flag_if_supported("-march=native");
    build.files(exported(Path::new(&folder), Real::Double, "Rows"));
    build.compile("linkage_peers_exported_rows");

    let compiler = optimised().get_compiler();
    if setting("CARGO_CFG_TARGET_ARCH") != "x86_64" || compiler.is_like_msvc() {
        return;
    }
    println!("cargo:rustc-cfg=vector_sweeps");
    for (level, width) in [("v3", 256), ("v4", 512)] {
        let mut build = optimised();
        build
            .file("sweeps.c")
            .define("SUFFIX", Some(format!("_{level}").as_str()));
        build.flag(format!("-march=x86-64-{level}"));
        build.flag_if_supported(format!("-mprefer-vector-width={width}"));
        build.flag("-ffp-contract=fast").flag("-fno-trapping-math");
        build.compile(&format!("linkage_peers_sweeps_{level}"));
    }
}

/// Returns true if the code runs on the machine that builds it, which has fused multiply-adds.
fn machine_is_fused(host: &str, target: &str) -> bool {
    #[cfg(target_arch = "x86_64")]
    let has_instruction = std::arch::is_x86_feature_detected!("fma");
    #[cfg(not(target_arch = "x86_64"))]
    let has_instruction = cfg!(target_arch = "aarch64");
    host == target && has_instruction
}

/// For the instruction set of the Rust code.
fn single(fused: bool) -> cc::Build {
    let mut build = optimised();
    if fused {
        build.flag_if_supported("-march=x86-64-v3");
        build.flag_if_supported("-ffp-contract=fast");
    } else {
        build.flag_if_supported("-ffp-contract=off");
    }
    build
}

fn optimised() -> cc::Build {
    let mut build = cc::Build::new();
    // No call of the C library's `sqrt` to set `errno`.
    build.opt_level(3).flag_if_supported("-fno-math-errno");
    build
}

/// Files in Rust with mechanisms.
const MECHANISMS: [&str; 2] = ["src/mechanisms.rs", "src/space.rs"];

/// Numbers in `src/exported.rs` for what is assembled.
const MOST: usize = 256;

/// Writes all mechanisms as C, their names with `end` behind them; the sources.
fn exported(folder: &Path, real: Real, end: &str) -> Vec<PathBuf> {
    let mut files = Vec::new();
    for path in MECHANISMS {
        println!("cargo:rerun-if-changed={path}");
        let text = fs::read_to_string(path).expect("the file is there");
        for body in bodies(text.parse().expect("Rust")) {
            let mut words = body.clone().into_iter().map(|token| token.to_string());
            words.find(|word| word == "struct");
            let name = words.next().expect("a mechanism has a name");
            let checked = linkage_compiler::check(body);
            let unit = checked.unit.expect("a mechanism without a mistake");
            let own = sources(&format!("{name}{end}"), &unit, real).expect("it can be exported");
            assert!(
                unit.scalars().count() + 1 + unit.slots() <= MOST,
                "{name} is large"
            );
            let file = folder.join(&own.name);
            fs::write(file.with_extension("h"), own.header).expect("a header can be written");
            fs::write(file.with_extension("c"), own.source).expect("a source can be written");
            files.push(file.with_extension("c"));
        }
    }
    files
}

/// What stands in the braces of `mechanism!`.
fn bodies(tokens: TokenStream) -> Vec<TokenStream> {
    let tokens: Vec<TokenTree> = tokens.into_iter().collect();
    let mut bodies = Vec::new();
    for three in tokens.windows(3) {
        if let [
            TokenTree::Ident(word),
            TokenTree::Punct(_),
            TokenTree::Group(group),
        ] = three
            && word == "mechanism"
        {
            bodies.push(group.stream());
        }
    }
    bodies
}
