//! The playground: compiler, engine and report of linkage for a browser.
//!
//! A request is an object of JSON with a text, its answer another one. [`answer`] does the work on
//! every machine, so that tests compare a browser with the command. In a browser, `abi` passes both
//! through the memory of the module. The front end is in `web`; `cargo xtask playground` builds
//! all of it. `docs/playground.md` describes its use.

#[cfg(target_family = "wasm")]
mod abi;
mod analysis;
mod benchmark;
mod bits;
mod document;
mod examples;
mod exports;
mod page;
mod positions;
mod tasks;

pub use tasks::answer;
