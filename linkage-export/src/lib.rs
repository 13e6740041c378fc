//! Mechanisms of linkage for printers of target languages.
//!
//! A printer implements [`Target`] for its names and declarations of variables, and
//! [`Language`](linkage_symbolic::program::Language) for its expressions. [`Declarations`] contains
//! the chosen names, types, positions of arguments, tables, units and comments of a mechanism. All
//! files of the printer read them, so that a header and a source agree.
//!
//! ```
//! use linkage_compiler::ir::Shape;
//! use linkage_export::{Declarations, FunctionItem, Scope, Target};
//!
//! struct Shouting;
//!
//! impl Target for Shouting {
//!     const LANGUAGE: &'static str = "Shouting";
//!     const FUNCTION_ITEMS: &'static [FunctionItem] = &[FunctionItem {
//!         ending: "",
//!         kind: "the function",
//!     }];
//!     fn mechanism_name(&self, title: &str) -> String {
//!         title.to_owned()
//!     }
//!     fn item_name(&self, _mechanism: &str, item: &str) -> String {
//!         item.to_owned()
//!     }
//!     fn spelled(&self, name: &str, _scope: Scope) -> String {
//!         name.to_uppercase()
//!     }
//!     fn is_reserved(&self, name: &str, _scope: Scope) -> bool {
//!         name == "PHI"
//!     }
//!     fn declared(&self, name: &str, _shape: &Shape, _items: &[String]) -> String {
//!         format!("NUMBER {name}")
//!     }
//! }
//!
//! let text = "
//!     pub struct Crank { unit mm; param radius = 12mm; input phi = 0deg; }
//!     impl Crank { pub fn height(phi) -> Height { height: radius * sin(phi) } }";
//! let checked = linkage_compiler::check(text.parse().expect("brackets have partners"));
//! let unit = checked.unit.expect("a mechanism without a mistake");
//! let declarations = Declarations::new("Crank", &unit, &Shouting);
//! let height = &declarations.functions[0];
//! assert_eq!(height.items, ["HEIGHT"]);
//! assert_eq!(height.arguments[0].declaration, "NUMBER PHI_");
//! assert_eq!(height.fields[0].declaration, "NUMBER HEIGHT");
//! assert_eq!(declarations.dimensions[0].member.note, "mm");
//! ```

mod angles;
mod assembly;
mod builder;
mod coupled;
mod declarations;
mod helpers;
mod names;
mod notes;
mod print_all;
mod refusals;
mod renamed;
mod scalars;
mod target;

pub use angles::{AngleTables, FollowedInput};
pub use assembly::DeclaredAssembly;
pub use coupled::{CoupledDeclaration, PreparedStates};
pub use declarations::{
    ArgumentDeclaration, Declarations, FunctionDeclaration, InputDeclaration, MemberDeclaration,
    ParameterDeclaration,
};
pub use helpers::{HelperLibrary, Helpers};
pub use notes::operations;
pub use print_all::{Refused, print_all};
pub use refusals::{Refusal, RefusalCause, group_text, refusals};
pub use renamed::Renamed;
pub use scalars::{CompoundType, scalar_paths};
pub use target::{FunctionItem, Scope, Target};
