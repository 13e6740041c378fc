//! Mechanisms of linkage as JavaScript for pages.
//!
//! [`module`] prints the result of [`linkage_compiler::check`] as a module, with types for
//! TypeScript. Nothing else is needed to run it. Sums, products, quotients, roots, sines and angles
//! of vectors are those of generated Rust without fused multiply-adds, to the last bit; tangents
//! and arcs of single numbers are the browser's. Groups without a closed form are followed by
//! certified steps of Newton's method from the declared assembly; where that ends, there is no
//! number.
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

#[cfg(feature = "description")]
mod description;
#[cfg(feature = "engine")]
#[doc(hidden)]
pub mod engine;
#[cfg(feature = "description")]
mod instruction;
#[cfg(feature = "description")]
mod js_names;
#[cfg(feature = "module")]
mod module;
#[cfg(feature = "description")]
mod object;
#[cfg(feature = "description")]
mod program_data;
#[cfg(feature = "module")]
mod types;

#[cfg(feature = "description")]
use linkage_compiler::ir::CompiledMechanism;
#[cfg(feature = "description")]
use linkage_export::Declarations;

#[cfg(feature = "description")]
use js_names::JavaScript;
#[cfg(feature = "module")]
pub use module::{Clash, Module, module, modules};
#[cfg(feature = "description")]
use object::Notation;

/// Returns the description of a mechanism for the engine: an object of
/// JavaScript with its programs. Pages of reports have it next to the engine.
#[cfg(feature = "description")]
pub fn description(name: &str, unit: &CompiledMechanism) -> String {
    description::description(
        &Declarations::new(name, unit, &JavaScript),
        Notation::Script,
    )
}

/// Returns the [`description`] as JSON, for pages whose content policy allows no new code. Their
/// script has the [`interpreter`], whose function `revived` makes the object from it.
#[cfg(feature = "description")]
pub fn description_data(name: &str, unit: &CompiledMechanism) -> String {
    description::description(&Declarations::new(name, unit, &JavaScript), Notation::Json)
}

/// Returns the part of the engine that runs programs of [`description_data`], as text.
#[cfg(feature = "description")]
pub fn interpreter() -> String {
    program_data::interpreter()
}
