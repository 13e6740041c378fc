//! Mechanisms of linkage as structured text of IEC 61131-3, for programmable controllers.
//!
//! [`structured_text`] prints the result of [`linkage_compiler::check`]: types, a function block
//! that closes the loops, and one for each function of the user. There is no loop, and no call
//! except of `ABS`, `SQRT` and `SEL`. Where the controller computes with numbers of IEEE 754, the
//! results are those of generated Rust without fused multiply-adds, to the last bit. Zeros have no
//! sign in arc tangents.
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
//! let printed = linkage_st::structured_text("SliderCrank", &unit)?;
//! assert!(printed.text.contains("crank : LREAL := LREAL#30.0; (* mm *)"));
//! assert!(printed.text.contains("FUNCTION_BLOCK SliderCrank_motion"));
//! # Ok::<(), linkage_st::Refused>(())
//! ```

mod assemble;
mod blocks;
mod names;
mod program;

use std::sync::OnceLock;

use linkage_compiler::ir::CompiledMechanism;
use linkage_core::certificate;
use linkage_export::{
    Declarations, DeclaredAssembly, HelperLibrary, Helpers, Target, group_text, print_all,
};
pub use linkage_export::{Refused, Renamed};

use assemble::assemble;
use blocks::{Writer, comment};
use names::Text;

/// A mechanism as structured text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct StructuredText {
    /// The name of its type and of its file, and the beginning of all names in it.
    pub name: String,
    /// Types, functions and function blocks.
    pub text: String,
    /// Names of the declaration that have another form.
    pub renamed: Vec<Renamed>,
}

/// Prints a mechanism that is called `title` in its declaration.
///
/// # Errors
///
/// For mechanisms with coupled groups, and for angles whose turns cannot be counted.
pub fn structured_text(title: &str, unit: &CompiledMechanism) -> Result<StructuredText, Refused> {
    printed(title, unit).map(|(printed, _)| printed)
}

/// Prints mechanisms of one project: each by its name in the declaration, with its unit.
///
/// # Errors
///
/// Those of [`structured_text`], and for two mechanisms that would have a name in common, where
/// large and small letters are the same.
pub fn all_structured_text(
    mechanisms: &[(&str, &CompiledMechanism)],
) -> Result<Vec<StructuredText>, Refused> {
    print_all(Text::LANGUAGE, mechanisms, printed)
}

/// The text of a mechanism, and the names that it gives to a project, in small letters.
fn printed(
    title: &str,
    unit: &CompiledMechanism,
) -> Result<(StructuredText, Vec<String>), Refused> {
    if let Some(coupled) = unit.coupled.first() {
        let group = group_text(coupled.group, &unit.groups[coupled.group]);
        let message = format!(
            "{title}: {group} has no closed form, and structured text has closed forms only. Export C by `linkage c`"
        );
        return Err(Refused::new(message));
    }
    let assembly = DeclaredAssembly::new(unit).map_err(|angle| {
        let angle = &unit.unknowns[unit.angles[angle].unknown].name;
        let message = format!("{title}: the turns of {angle} cannot be counted over the range");
        Refused::new(message)
    })?;
    let declarations = Declarations::new(title, unit, &Text);
    let mut writer = Writer {
        declarations: &declarations,
        assembly: &assembly,
        helpers: Helpers::new(library(), ""),
    };
    let mut blocks = writer.types() + &assemble(&mut writer);
    for function in &declarations.functions {
        blocks += &writer.function(function);
    }
    let helpers = writer.helpers.texts().collect::<Vec<_>>().join("\n");
    let slack = certificate::ROUNDINGS * f64::EPSILON;
    let helpers = helpers
        .replace("own_", &declarations.private)
        .replace("LREAL#EIGHT_ROUNDOFFS", &program::literal(slack));
    let length = declarations.length;
    let length = length.map_or_else(String::new, |unit| format!(", lengths {unit}"));
    let about = format!(
        "{title}: its loops are closed by formulas. Written by linkage; not to be changed by hand.\n{}\n\
         Angles are radians{length}. A result that does not exist is NaN, the only number that is not equal to itself.",
        declarations.documentation
    );
    let items = declarations.functions.iter().flat_map(|item| &item.items);
    let names = declarations.items.iter().chain([&declarations.name]);
    let names = names.chain(items).map(|name| name.to_ascii_lowercase());
    let names = names.collect();
    let text = StructuredText {
        text: comment(&about) + "\n" + &helpers + "\n" + &blocks,
        name: declarations.name,
        renamed: declarations.renamed,
    };
    Ok((text, names))
}

/// The functions that programs call.
fn library() -> &'static HelperLibrary {
    static LIBRARY: OnceLock<HelperLibrary> = OnceLock::new();
    LIBRARY.get_or_init(|| HelperLibrary::new(include_str!("helpers.st"), "(* ", " *)"))
}
