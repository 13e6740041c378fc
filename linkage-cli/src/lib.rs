//! The command `linkage`: mechanisms in text files are checked, tabulated and shown, without a Rust
//! toolchain.
//!
//! A file contains the text between the braces of `mechanism! { ... }`, one or several mechanisms,
//! or is a Rust file with calls of that macro. The compiler of the macro reads it, so that the
//! language and all messages are the same. Values come from an interpreter of its programs and are
//! equal to those of the macro's code on the same machine, to the last bit.
//!
//! `docs/command.md` describes the commands. As a library:
//!
//! ```
//! use linkage_cli::{Mechanism, Source};
//!
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
//! let source = Source::new("slider.mech", text).expect("brackets have partners");
//! let checked = linkage_compiler::check(source.calls()[0].tokens.clone());
//! let mechanism = Mechanism::new(&checked).expect("a mechanism without a mistake");
//! let assembly = mechanism.assemble(&mechanism.dimensions()).expect("it closes");
//! let motion = assembly.call(0, &[0.0]);
//! assert!((motion[0] - 110.0).abs() < 1e-12 && motion[1].abs() < 1e-12);
//! ```

mod command;
mod confusable;
mod engine;
mod failure;
mod look_alike;
mod mechanism;
mod messages;
mod normal;
mod source;

pub use command::run;
pub use engine::Assembly;
pub use failure::Failure;
pub use mechanism::Mechanism;
pub use messages::rendered;
pub use source::{MechanismCall, Source};
