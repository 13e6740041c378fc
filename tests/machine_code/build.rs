//! Says so to the examples that the tests include.

fn main() {
    println!("cargo::rustc-cfg=machine_code");
    println!("cargo::rerun-if-changed=build.rs");
}
