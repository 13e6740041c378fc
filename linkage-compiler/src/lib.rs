//! The compiler of `linkage::mechanism!`: from mechanisms to programs.
//!
//! `linkage-language` parses a text, resolves names and checks dimensions. The phases here, each in
//! a separate folder, go on: `structure` finds the Assur groups, `solve` expresses every unknown,
//! `lower` makes programs of expressions, `assembly` runs them to check assembly and range,
//! `outputs` puts the programs of all functions into one [`mod@ir`], which printers print:
//! `linkage-rust` for the macro. `algebra` is shared by the phases; `forces` and `picture` make
//! expressions of the quantities that functions ask for.
//!
//! [`check`] gives a mechanism's programs, or messages with their places; [`check_all`] gives those
//! of all mechanisms of a text, and [`check_names`] what can be known without solving them:
//!
//! ```
//! use linkage_compiler::check;
//! use linkage_symbolic::interpret::run;
//! use linkage_symbolic::program::Source;
//!
//! let text = "
//!     pub struct SliderCrank {
//!         unit mm;
//!         param crank = 30mm;
//!         param rod = 80mm;
//!         input phi = 60deg;
//!         unknown theta = -20deg;
//!         unknown s = 90mm;
//!         loop polar(crank, phi) + polar(rod, theta) = (s, 0);
//!     }
//!     impl SliderCrank {
//!         pub fn motion(phi) -> Motion { s, speed: velocity(s) }
//!     }";
//! let checked = check(text.parse().expect("brackets have partners"));
//! let unit = checked.unit.expect("a mechanism without a mistake");
//!
//! let dimensions: Vec<f64> = unit.scalars().map(|scalar| scalar.nominal).collect();
//! let modes = unit.modes();
//! let phi = std::f64::consts::FRAC_PI_2;
//! let load = |source, prepared: &[f64]| match source {
//!     Source::Parameter(index) => dimensions[index],
//!     Source::Input(_) => phi,
//!     Source::Mode(index) => if modes[index] { 1.0 } else { -1.0 },
//!     Source::Prepared(slot) => prepared[slot],
//!     // Angles that are followed, and coupled groups: there are none here.
//!     _ => f64::NAN,
//! };
//! let prepared = run(&unit.prepare, |source| load(source, &[]));
//! let motion = run(&unit.functions[0].called.program, |source| load(source, &prepared));
//! assert!((motion[0] - (80.0f64.powi(2) - 30.0f64.powi(2)).sqrt()).abs() < 1e-12);
//! assert!((motion[1] + 30.0).abs() < 1e-12);
//!
//! let checked = check(text.replace("rod, theta", "rod, teta").parse().expect("brackets"));
//! assert!(checked.unit.is_none());
//! assert!(checked.messages[0].text.starts_with("unknown name `teta`"));
//! ```

mod algebra;
mod assembly;
mod checks;
mod driver;
mod forces;
pub mod ir;
mod lower;
mod machine;
mod message_format;
mod mobility;
mod observer;
mod oracle;
mod outputs;
mod part_order;
mod picture;
mod pipeline;
mod solve;
mod structure;
pub mod trace;
mod vector;

use linkage_language::{diagnostic, model, syntax};
use proc_macro2::{Ident, Span, TokenStream};
use quote::quote;

pub use diagnostic::characters::{UnreadableCharacter, unreadable_character};
pub use diagnostic::text::{nearest, short_words, shortened};
pub use diagnostic::{EditLocation, Message, SourceEdit, SourceSpan, Suggestion};
pub use driver::{Analysed, Checked, Driver};
#[doc(inline)]
pub use linkage_core::range_check::length_as_written;
pub use oracle::Oracle;

/// Analyses a mechanism, the macro's input without the path of the facade. With several mechanisms
/// it returns the last, which may have the others as parts, with the messages of all; [`check_all`]
/// returns each.
pub fn check(body: TokenStream) -> Checked {
    Driver::analyse(body).last()
}

/// Analyses all mechanisms of a call, in the order in which they are written; the result has at
/// least one.
///
/// ```
/// use linkage_compiler::check_all;
///
/// let text = "
///     struct Crank { unit mm; param radius = 12mm; input phi = 0deg; let tip = polar(radius, phi); }
///     struct Machine {
///         unit mm;
///         input shaft = 0deg;
///         part left: Crank { phi = shaft };
///         part right: Crank { phi = 2 * shaft, radius = 20mm };
///     }
///     impl Machine { fn between(shaft) -> Between { way: left.tip - right.tip } }";
/// let all = check_all(text.parse().expect("brackets have partners"));
/// let machine = all[1].unit.as_ref().expect("a mechanism without a mistake");
/// let names: Vec<&str> = machine.scalars().map(|own| own.name.as_str()).collect();
/// assert_eq!(names, ["left.radius"]);
/// ```
pub fn check_all(body: TokenStream) -> Vec<Checked> {
    Driver::analyse(body).checked()
}

/// Reads all mechanisms of a call and resolves their names, types and dimensions, which solves
/// nothing: the results have models and the messages about them, and no programs.
///
/// [`check_all`] has all messages.
///
/// ```
/// use linkage_compiler::{check_all, check_names};
///
/// // The links do not reach each other.
/// let text = "struct Short { unit mm; input phi = 0deg; unknown psi = 0deg; unknown s = 9mm;
///     loop polar(80mm, phi) + polar(30mm, psi) = (s, 60mm); }";
/// let names = check_names(text.parse().expect("brackets have partners"));
/// assert!(names[0].model.is_some() && names[0].messages.is_empty());
/// assert!(!check_all(text.parse().expect("brackets"))[0].messages.is_empty());
/// ```
pub fn check_names(body: TokenStream) -> Vec<Checked> {
    Driver::names(body).checked()
}

/// Returns mechanisms as a text without joints and links, which are written as the parameters,
/// unknowns, points and loops that they stand for. Comments other than doc comments are not kept.
/// `None` if there are mistakes in joints and links, or in the syntax; [`check_all`] reports
/// them. Loops that cannot be solved are written, too.
///
/// ```
/// use linkage_compiler::loops;
///
/// let text = "
///     struct Crank {
///         unit mm;
///         input phi = 0deg;
///         joint a = (0mm, 0mm), b = (20mm, 0mm);
///         link frame: a;
///         link crank: a, b at phi;
///     }";
/// let text = loops(text.parse().expect("brackets have partners"));
/// assert!(text.expect("it has no mistake").contains("let b = a + polar(crank.length, crank.angle);"));
/// ```
pub fn loops(body: TokenStream) -> Option<String> {
    let mut diagnostics = diagnostic::Diagnostics::default();
    let definitions = model::read(body, &mut diagnostics);
    let is_sound = diagnostics.is_empty();
    is_sound.then(|| definitions.iter().map(syntax::mechanism_text).collect())
}

/// Reads a value that is given apart from a mechanism, as on a command line: that of a parameter of
/// this name, with its tolerance, where lengths are in this unit. The unit has one parameter.
///
/// ```
/// let value = "40mm +- 0.1mm".parse().expect("tokens");
/// let checked = linkage_compiler::check_value("crank", value, "mm");
/// let unit = checked.unit.expect("a value without a mistake");
/// let crank = &unit.parameters[0].scalars[0];
/// assert_eq!((crank.nominal, crank.tolerance), (40.0, 0.1));
/// ```
pub fn check_value(name: &str, value: TokenStream, length: &str) -> Checked {
    let word = |text: &str| syn::parse_str::<Ident>(text).ok();
    let name = word(name).unwrap_or_else(|| Ident::new("value", Span::call_site()));
    let length = word(length).unwrap_or_else(|| Ident::new("m", Span::call_site()));
    check(quote!(struct Value { unit #length; param #name = (#value); }))
}
