//! What closes loops and evaluates functions in a browser, as this crate does it for generated Rust: centres and windings of angles, groups without a
//! closed form, misses. `linkage-js` prints the programs of a mechanism for it.

/// The parts of the engine; a later one uses those before it.
pub const ENGINE: [&str; 6] = [
    include_str!("javascript/elementary.js"),
    include_str!("javascript/numbers.js"),
    include_str!("javascript/follow.js"),
    include_str!("javascript/turns.js"),
    include_str!("javascript/coupled.js"),
    include_str!("javascript/assemble.js"),
];

/// What modules have after the engine, and pages do not. The function `mechanismOf` of the last part makes of a description what other people's
/// programs use.
pub const MODULE: [&str; 2] = [
    include_str!("javascript/range.js"),
    include_str!("javascript/mechanism.js"),
];

/// Of the page of a report alone, behind those: other assemblies of groups without a closed form.
#[cfg(feature = "report")]
pub(crate) const OTHERS: &str = include_str!("javascript/others.js");

/// The programs of a mechanism as JavaScript, for the page of a report: the constant `PROGRAMS` of a mechanism with a function that asks for
/// `picture()`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Programs {
    /// An object: what the engine knows of the mechanism.
    pub description: &'static str,
}
