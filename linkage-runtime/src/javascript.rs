//! The engine in JavaScript: it closes loops and evaluates functions in a browser, as this crate
//! does for generated Rust. It contains centres and windings of angles, groups without a closed
//! form, and closure errors. `linkage-js` prints the programs of a mechanism for it.

/// The parts of the engine; a later one uses those before it.
pub const ENGINE: [&str; 6] = [
    include_str!("javascript/elementary.js"),
    include_str!("javascript/numbers.js"),
    include_str!("javascript/follow.js"),
    include_str!("javascript/revolutions.js"),
    include_str!("javascript/coupled.js"),
    include_str!("javascript/assemble.js"),
];

/// Parts that modules have after the engine, and pages do not. The function `mechanismOf` of the
/// last part makes the public interface of a module from a description.
pub const MODULE: [&str; 2] = [
    include_str!("javascript/range.js"),
    include_str!("javascript/mechanism.js"),
];

/// The part of pages of reports alone, after those: other assemblies of groups without a closed form.
#[cfg(feature = "report")]
pub(crate) const OTHERS: &str = include_str!("javascript/others.js");

/// The programs of a mechanism as JavaScript, for the page of a report: the constant `PROGRAMS` of
/// a mechanism with a function that asks for `picture()`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Programs {
    /// An object with all data of the mechanism for the engine.
    pub description: &'static str,
}
