//! The structure of the sources of all crates: uses of files, methods, comments and names.
//!
//! The tests read text only, so this program needs no crate:
//! `rustc --test --edition 2024 tests/sources/main.rs` builds it, too. `report` prints the current
//! figures, and everything that a folder has to change:
//! `SOURCES_UNDER=linkage-core/src cargo test --test sources report -- --nocapture`.

mod comments;
mod crates;
mod imports;
mod lexer;
#[allow(dead_code, reason = "documents use the other measures")]
#[path = "../documents/measures.rs"]
mod measures;
mod modules;
mod names;
mod objects;
mod reader;
mod resolve;
mod uses;

#[test]
fn report() {
    println!("== Circles of files\n{}", imports::report());
    println!("== Types with methods in many files\n{}", objects::report());
    println!("== Comments\n{}", comments::report());
    println!("== Names\n{}", names::report());
}
