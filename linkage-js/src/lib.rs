//! Mechanisms of linkage as JavaScript: what computes in pages.
//!
//! [`module`] prints what [`linkage_compiler::check`] makes of a mechanism as a module of its own, with types for TypeScript; nothing else is
//! needed to run it. Sums, products, quotients, roots, sines and angles of vectors are those of generated Rust without fused
//! multiply-adds, to the last bit; tangents and arcs of single numbers are the browser's. Groups without a closed form are followed by
//! certified steps of Newton's method from the declared assembly; where that ends, there is no number.
//!
//! ```
//! let text = "
//!     pub struct SliderCrank {
//!         unit mm;
//!         param crank = 30mm;
//!         param rod = 80mm;
//!         input phi = 60deg in 0deg..360deg;
//!         unknown theta = -20deg;
//!         unknown s = 90mm;
//!         loop polar(crank, phi) + polar(rod, theta) = (s, 0);
//!     }
//!     impl SliderCrank {
//!         pub fn motion(phi) -> Motion { s, speed: velocity(s) }
//!     }";
//! let checked = linkage_compiler::check(text.parse().expect("brackets have partners"));
//! let unit = checked.unit.expect("a mechanism without a mistake");
//! let module = linkage_js::module("SliderCrank", &unit);
//! assert!(module.script.contains("export { mechanism as SliderCrank, AssemblyError };"));
//! assert!(module.types.contains("motion(phi: number): { s: number; speed: number };"));
//! ```

mod description;
mod instruction;
mod object;
#[cfg(feature = "module")]
mod types;

use linkage_compiler::unit::Unit;
#[cfg(feature = "module")]
use linkage_runtime::javascript::{ENGINE, MODULE};

/// A mechanism as JavaScript.
#[cfg(feature = "module")]
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Module {
    /// The text of a module, which exports the mechanism and the error that assembling throws.
    pub script: String,
    /// Its types, the text of a `.d.ts` file.
    pub types: String,
}

/// Prints a mechanism that is called `name` in its declaration.
///
/// The module exports the mechanism by this name, and `AssemblyError`, which its `assemble` throws.
#[cfg(feature = "module")]
pub fn module(name: &str, unit: &Unit) -> Module {
    let engine = [&ENGINE[..], &MODULE].concat().join("\n");
    let description = description(name, unit);
    // In a function: no name of the engine, or of the browser, meets that of the mechanism.
    let script = format!(
        "// {name}. Written by linkage; not to be changed by hand.\n\nconst own = (() => {{\n{engine}\n\
         return {{ mechanism: mechanismOf({description}), AssemblyError }};\n}})();\n\
         const {{ mechanism, AssemblyError }} = own;\nexport {{ mechanism as {name}, AssemblyError }};\n"
    );
    Module {
        script,
        types: types::types(name, unit),
    }
}

/// What the engine of `linkage-runtime` knows of a mechanism: an object of JavaScript, its programs among it. Pages of reports have it beside the engine.
pub fn description(name: &str, unit: &Unit) -> String {
    description::description(name, unit)
}
