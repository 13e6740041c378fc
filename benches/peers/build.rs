//! Compiles the C kernels for the instruction set that the Rust code is compiled for, and their sweeps for
//! every set that may be chosen when the benchmark runs.

fn main() {
    for file in ["kernels.c", "space.c", "sine.h", "sweeps.c"] {
        println!("cargo:rerun-if-changed={file}");
    }
    println!("cargo:rustc-check-cfg=cfg(vector_sweeps)");
    let setting = |name: &str| std::env::var(name).unwrap_or_default();
    let features = setting("CARGO_CFG_TARGET_FEATURE");
    let mut build = optimised();
    build.file("kernels.c").file("space.c");
    if features.split(',').any(|feature| feature == "fma") {
        build.flag_if_supported("-march=x86-64-v3");
        build.flag_if_supported("-ffp-contract=fast");
    } else {
        build.flag_if_supported("-ffp-contract=off");
    }
    build.compile("linkage_peers_kernels");

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

fn optimised() -> cc::Build {
    let mut build = cc::Build::new();
    // No call of the C library's `sqrt` to set `errno`.
    build.opt_level(3).flag_if_supported("-fno-math-errno");
    build
}
