//! The command `linkage`: mechanisms in text files are checked, tabulated and shown, without a Rust
//! toolchain.
//!
//! A file contains the text between the braces of `mechanism! { ... }`, one or several mechanisms,
//! or is a Rust file with calls of that macro. The compiler of the macro reads it, so that the
//! language and all messages are the same. Values come from an interpreter of its programs and are
//! equal to those of the macro's code on the same machine, to the last bit.
//!
//! `docs/command.md` describes the commands. Programs use the library `linkage-engine`, of which
//! the command is a user.

mod command;
mod confusable;
mod failure;
mod look_alike;
mod normal;
mod templates;

pub use command::run;
pub use failure::Failure;
