//! Compiles the parser of `editors/tree-sitter-linkage`, which `tree-sitter generate` wrote.

use std::path::Path;

fn main() {
    let sources = Path::new("../../editors/tree-sitter-linkage/src");
    let mut build = cc::Build::new();
    for file in ["parser.c", "scanner.c"] {
        let path = sources.join(file);
        println!("cargo::rerun-if-changed={}", path.display());
        build.file(path);
    }
    build.include(sources).std("c11").opt_level(0);
    build.compile("tree-sitter-linkage");
}
