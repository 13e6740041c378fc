//! The compiler behind `linkage::mechanism!`: tokens in, tokens out.
//!
//! The phases, each in a folder of its own: `syntax` parses, `model` resolves names and checks dimensions, `structure`
//! finds the Assur groups, `formulate` expresses every unknown, `lower` makes programs of expressions, `close` runs them to check
//! assembly and range, `request` puts the programs of all functions into one [`mod@unit`], `emit` prints that. `algebra` is what the
//! middle phases share; `forces` and `picture` make expressions of what functions ask for.
//!
//! [`compile`] is the macro. Without Rust at the end, [`check`] gives a mechanism's programs, or messages with their places; a text with several
//! mechanisms is divided by [`mechanisms`]:
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
mod close;
mod diagnostic;
mod emit;
mod file;
mod forces;
mod formulate;
mod lower;
mod model;
mod oracle;
mod picture;
mod request;
mod structure;
mod syntax;
pub mod trace;
pub mod unit;
mod vector;
mod watch;

use linkage_symbolic::Graph;
use proc_macro2::{Group, TokenStream, TokenTree};
use quote::quote;

use algebra::{Algebra, Nominal};
use diagnostic::{Diagnostics, Origins, Reporter};
use forces::Forces;
use model::Mechanism;
use request::{AtReference, State};
use syntax::{Attribute, MechanismDef};
use unit::Unit;
use watch::Watch;

pub use diagnostic::{Message, SourceSpan};
pub use file::mechanisms;
pub use oracle::Oracle;

/// Compiles the macro's input: the path of the facade in brackets, then the mechanism. Mistakes become `compile_error!`s
/// beside a skeleton of the generated items. A mechanism that is drawn gets its programs as a text, too, which `printed` makes of its name and its unit:
/// reports compute with it.
pub fn compile(input: TokenStream, printed: impl Fn(&str, &Unit) -> String) -> TokenStream {
    let (krate, body) = split_crate_path(input);
    Analysed::new(body, &mut ()).emitted(&krate, &printed)
}

/// Analyses a mechanism, the macro's input without the path of the facade.
pub fn check(body: TokenStream) -> Checked {
    Analysed::new(body, &mut ()).checked()
}

/// What [`check`] says of a mechanism.
#[derive(Clone, Debug)]
pub struct Checked {
    /// Its name, if it has one.
    pub name: Option<String>,
    /// Its programs, if there is no mistake.
    pub unit: Option<Unit>,
    /// The mistakes, in the order in which phases found them.
    pub messages: Vec<Message>,
    /// What is no mistake, but hardly meant, unless the mechanism allows it.
    pub warnings: Vec<Message>,
}

/// What the phases before emission made of a mechanism, as far as mistakes let them.
#[derive(Default)]
struct Analysed {
    definition: Option<MechanismDef>,
    mechanism: Option<Mechanism>,
    unit: Option<Unit>,
    diagnostics: Diagnostics,
}

impl Analysed {
    fn new(body: TokenStream, watch: &mut dyn Watch) -> Self {
        let mut own = Self::default();
        let diagnostics = &mut own.diagnostics;
        own.definition = syntax::parse(body, diagnostics);
        let mut origins = Origins::default();
        let definition = own.definition.as_ref();
        own.mechanism = definition.and_then(|own| model::resolve(own, &mut origins, diagnostics));
        let mechanism = own.mechanism.as_ref();
        own.unit = mechanism.map(|own| analyse(own, &origins, diagnostics, watch));
        own
    }

    fn emitted(&self, krate: &TokenStream, printed: &emit::Printer) -> TokenStream {
        let errors = self.diagnostics.to_tokens();
        match (&self.definition, &self.unit) {
            (None, _) => errors,
            (Some(definition), Some(unit)) if self.diagnostics.is_empty() => {
                let items = emit::emit(krate, definition, unit, printed);
                let warnings = self.diagnostics.warnings_to_tokens(&definition.allows());
                quote!(#items #warnings)
            }
            (Some(definition), _) => {
                let skeleton = emit::skeleton(krate, definition, self.mechanism.as_ref());
                quote!(#errors #skeleton)
            }
        }
    }

    fn checked(self) -> Checked {
        let (messages, mut warnings) = self.diagnostics.into_messages();
        let definition = self.definition.as_ref();
        if definition.is_some_and(|own| own.attributes.iter().any(Attribute::allows_warnings)) {
            warnings.clear();
        }
        Checked {
            name: definition.map(MechanismDef::title),
            unit: self.unit.filter(|_| messages.is_empty()),
            messages,
            warnings,
        }
    }
}

/// The middle phases of a resolved mechanism: structure, formulation, checks and lowering. Their order stands here alone.
fn analyse(
    mechanism: &Mechanism,
    origins: &Origins,
    diagnostics: &mut Diagnostics,
    watch: &mut dyn Watch,
) -> Unit {
    let graph = Graph::new();
    let mut algebra = Algebra::new(mechanism, &graph);
    let mut nominal = Nominal::of(&mut algebra);
    let mut reporter = Reporter {
        origins,
        diagnostics,
    };
    let before = reporter.errors();
    close::check_directions(mechanism, &nominal, &mut reporter);
    if reporter.errors() > before {
        // What is computed with them would be reported as not finite.
        return Unit::default();
    }
    nominal.check(mechanism, &mut reporter);
    if reporter.errors() == before {
        close::check_values(mechanism, &nominal, &mut reporter);
    }
    close::warn_of_unused(mechanism, &nominal, &mut reporter);
    let structure = structure::decompose(&mut algebra, &nominal, reporter.reborrow());
    watch.structure(&algebra, &structure);
    if reporter.errors() > before {
        return Unit::default();
    }
    let formulation = formulate::formulate(&mut algebra, structure);
    watch.formulated(&mut algebra, &formulation, &nominal);
    let closing = lower::closing(&mut algebra, &formulation, &nominal);
    let mut reference = close::assemble_reference(
        &algebra,
        &formulation,
        closing,
        &nominal,
        reporter.reborrow(),
    );
    nominal.complete(&reference.found);
    let mut forces = Forces::new(&mut algebra);
    if reference.closed {
        forces::check(
            &mut algebra,
            &mut forces,
            &reference,
            &nominal,
            &mut reporter,
        );
    }
    let state = State {
        algebra: &mut algebra,
        forces: &mut forces,
        formulation: &formulation,
        drawn: Vec::new(),
    };
    let at = AtReference {
        reference: &reference,
        nominal: &nominal,
    };
    let unit = request::unit(state, at, &mut reporter, watch);
    if reference.closed {
        close::check_ranges(
            &mut algebra,
            &formulation,
            &nominal,
            &mut reference,
            &unit.angles,
            &mut reporter,
        );
    }
    unit
}

/// The bracketed path that the facade's wrapper puts in front, and the rest.
fn split_crate_path(input: TokenStream) -> (TokenStream, TokenStream) {
    let mut tokens = input.into_iter();
    match tokens.next() {
        Some(TokenTree::Group(path)) => (Group::stream(&path), tokens.collect()),
        first => (quote!(::linkage), first.into_iter().chain(tokens).collect()),
    }
}
