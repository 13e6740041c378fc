//! Mechanisms of linkage as C99 for controllers: a header and a source that need nothing else.
//!
//! [`sources`] prints the result of [`linkage_compiler::check`]. The C has no allocation, no file,
//! no global state, and no call except of `sqrt` and `fabs`. Sine, cosine and arc tangent are those
//! of generated Rust, in `double` or in `float`. Without fused multiply-adds (`-ffp-contract=off`)
//! its results are those of generated Rust to the last bit.
//!
//! ```
//! use linkage_c::{Real, sources};
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
//! let checked = linkage_compiler::check(text.parse().expect("brackets have partners"));
//! let unit = checked.unit.expect("a mechanism without a mistake");
//! let c = sources("SliderCrank", &unit, Real::Double)?;
//! assert_eq!(c.name, "slider_crank");
//! assert!(c.header.contains("slider_crank_motion_result slider_crank_motion(const slider_crank *m, double phi);"));
//! assert!(c.source.starts_with("/* SliderCrank: see slider_crank.h."));
//! # Ok::<(), linkage_c::Refused>(())
//! ```

mod arithmetic;
mod assemble;
mod c_names;
mod column_header;
mod column_rows;
mod column_sweeps;
mod comment;
mod coupled;
mod evaluator;
mod header;
mod operations;
mod preprocessor;
mod range_check;
mod real;
mod source;
mod states;
mod surface;
mod template;
mod winding;
mod writer;

use linkage_compiler::ir::{CompiledMechanism, Coupled};
use linkage_export::print_all;
pub use linkage_export::{Refused, Renamed};

pub use column_sweeps::{ColumnSweeps, column_sweeps};
pub use real::Real;

/// A mechanism as C.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Sources {
    /// Name of both files, without `.h` and `.c`, and the beginning of all names in them.
    pub name: String,
    /// The text of the header.
    pub header: String,
    /// The text of the source, which includes the header by its name.
    pub source: String,
    /// Names of the declaration that have another form in C, in the order in which the header has
    /// them.
    pub renamed: Vec<Renamed>,
}

/// Prints a mechanism that is called `name` in its declaration.
///
/// Names of C are those of the user, in small letters at the beginning: `favorit_needle` of the
/// function `needle` of `Favorit`. A name that C, C++ or their libraries have gets an underscore at
/// its end; [`Sources::renamed`] lists such names.
///
/// # Errors
///
/// For mechanisms beyond the limits of exported C: the message names the limit.
pub fn sources(name: &str, unit: &CompiledMechanism, real: Real) -> Result<Sources, Refused> {
    exported(name, unit, real).map(|(sources, _)| sources)
}

/// Prints mechanisms that one program may use: each by its name in the declaration, with its unit.
///
/// # Errors
///
/// Those of [`sources`], and for two mechanisms that would have a name of C in common, as
/// `SliderCrank` and `Slider_Crank`.
pub fn all_sources(
    mechanisms: &[(&str, &CompiledMechanism)],
    real: Real,
) -> Result<Vec<Sources>, Refused> {
    print_all("C", mechanisms, |name, unit| exported(name, unit, real))
}

/// The files of a mechanism, and the names that they give to other files.
fn exported(
    name: &str,
    unit: &CompiledMechanism,
    real: Real,
) -> Result<(Sources, Vec<String>), Refused> {
    let mut coupled = unit.coupled.iter();
    let without = |group: &&Coupled| group.inputs.is_empty() || group.start.is_none();
    if let Some(found) = coupled.find(without) {
        let group = &unit.groups[found.group];
        return Err(Refused::new(format!(
            "{name}: {} are solved together without a closed form and depend on no input; exported C has such groups over inputs only, a \
                 limit of ours. Turn a dimension into an input",
            group.unknowns.join(", ")
        )));
    }
    let surface = surface::surface(name, unit, real);
    let names = surface.names();
    let sources = Sources {
        header: header::header(&surface),
        source: source::source(&surface),
        name: surface.declarations.name.clone(),
        renamed: surface.declarations.renamed.clone(),
    };
    Ok((sources, names))
}
