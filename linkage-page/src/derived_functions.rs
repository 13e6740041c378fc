//! Functions that the page of a mechanism needs and its text does not have: those for the drawing
//! and for all unknowns.

use linkage_compiler::{Driver, check_all};
use linkage_engine::{Mechanism, Source};
use proc_macro2::TokenStream;

/// Selections of more inputs than these are not tried, only all inputs together.
const MOST_INPUTS: usize = 5;

/// The functions that a mechanism lacks for its page.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Missing {
    /// It has functions, and one with a picture among them.
    Nothing,
    /// It has functions, but none with a picture.
    Drawing,
    /// It has no functions.
    All,
}

impl Missing {
    /// The functions that this mechanism lacks.
    #[must_use]
    pub fn in_mechanism(mechanism: &Mechanism) -> Self {
        let headings = mechanism.headings();
        if headings.is_empty() {
            Self::All
        } else if headings.iter().all(|heading| heading.picture.is_none()) {
            Self::Drawing
        } else {
            Self::Nothing
        }
    }
}

/// Returns the tokens of a call with a further function for each of its mechanisms that lacks a
/// [drawing](Missing::Drawing), so that all of it is compiled once. `None` if no drawing is missing,
/// or a name has a mistake. The compiler may still refuse the function: it must depend on all inputs.
#[must_use]
pub fn with_drawings(tokens: &TokenStream) -> Option<TokenStream> {
    let mut further = String::new();
    for (_, model) in Driver::resolve(tokens.clone()) {
        let model = model?;
        let mechanism = &model.mechanism;
        let functions = mechanism.evaluators.iter();
        let functions = functions.map(|function| &function.name[..]);
        let inputs = mechanism.inputs.iter();
        let inputs: Vec<&str> = inputs.map(|input| &input.name[..]).collect();
        let mut evaluators = mechanism.evaluators.iter();
        let has_drawing = evaluators.any(|function| function.asked_picture().is_some());
        if functions.len() > 0 && !inputs.is_empty() && !has_drawing {
            further.push_str(&drawing(&mechanism.name, &inputs, functions));
        }
    }
    let further: TokenStream = further.parse().ok()?;
    let tokens = tokens.clone().into_iter();
    (!further.is_empty()).then(|| tokens.chain(further).collect())
}

/// The function for a missing drawing, next to other functions.
fn drawing<'a>(
    mechanism: &str,
    inputs: &[&str],
    functions: impl Iterator<Item = &'a str> + Clone,
) -> String {
    let [name, result, fields] = PICTURE;
    let name = free(functions, name);
    let inputs = inputs.join(", ");
    format!("impl {mechanism} {{ fn {name}({inputs}) -> {result} {{ {fields} }} }}\n")
}

/// The function for a drawing: its name, its result, and the fields of that.
const PICTURE: [&str; 3] = ["picture", "WholePicture", "shape: picture()"];

/// Returns a mechanism of a text with the functions that are missing, as far as the compiler
/// accepts them; `None` if it accepts none.
#[must_use]
pub fn with_functions(
    source: &Source,
    mechanism: &Mechanism,
    missing: Missing,
) -> Option<Mechanism> {
    let inputs: Vec<&str> = mechanism.inputs().iter().map(|input| input.name).collect();
    let motion = ("motion", "AllUnknowns", unknowns(mechanism));
    let [name, result, fields] = PICTURE;
    let picture = (name, result, fields.to_owned());
    let fields = match missing {
        Missing::Nothing => Vec::new(),
        Missing::Drawing => vec![picture],
        Missing::All => vec![motion, picture],
    };
    let fields = fields.into_iter().filter(|(.., fields)| !fields.is_empty());
    let found = fields.filter_map(|(name, result, fields)| {
        let functions = mechanism.compiled().functions.iter();
        let name = free(functions.map(|function| &function.name[..]), name);
        let functions = selections(&inputs).into_iter().map(|inputs| {
            let inputs = inputs.join(", ");
            format!("fn {name}({inputs}) -> {result} {{ {fields} }}\n")
        });
        // A function takes exactly the inputs that its results depend on.
        functions.into_iter().find_map(|function| {
            let with = with_further_functions(source, mechanism.name(), &function)?;
            Some((function, with))
        })
    });
    let (functions, mut compiled): (Vec<String>, Vec<Mechanism>) = found.unzip();
    match compiled.len() {
        0 | 1 => compiled.pop(),
        _ => with_further_functions(source, mechanism.name(), &functions.concat()),
    }
}

/// Returns a name that no function has: with low lines at its end if needed.
pub(crate) fn free<'a>(functions: impl Iterator<Item = &'a str> + Clone, name: &str) -> String {
    let mut name = name.to_owned();
    while functions.clone().any(|function| function == name) {
        name.push('_');
    }
    name
}

/// All unknowns as fields of a result.
fn unknowns(mechanism: &Mechanism) -> String {
    let unknowns = mechanism.compiled().unknowns.iter();
    let fields = unknowns.map(|unknown| match unknown.name.contains('.') {
        // An unknown of a part, `hook.theta`.
        true => format!("{}: {}", unknown.name.replace('.', "_"), unknown.name),
        false => unknown.name.clone(),
    });
    fields.collect::<Vec<_>>().join(", ")
}

/// Selections of inputs with the first one, which runs: the largest first.
#[must_use]
pub fn selections<'a>(inputs: &[&'a str]) -> Vec<Vec<&'a str>> {
    let [first, others @ ..] = inputs else {
        return Vec::new();
    };
    if inputs.len() > MOST_INPUTS {
        return vec![inputs.to_vec()];
    }
    let mut all: Vec<Vec<&str>> = vec![vec![first]];
    for other in others {
        let with = |selection: &Vec<&'a str>| [&selection[..], &[other]].concat();
        all.extend(all.iter().map(with).collect::<Vec<_>>());
    }
    all.sort_by_key(|selection| inputs.len() - selection.len());
    all
}

/// The mechanism of this name with further functions, if the compiler accepts them in any
/// range.
#[must_use]
pub fn with_further_functions(source: &Source, name: &str, functions: &str) -> Option<Mechanism> {
    let further: TokenStream = format!("impl {name} {{ {functions} }}").parse().ok()?;
    let mut all = source.calls().iter().flat_map(|call| {
        let tokens = call.tokens.clone().into_iter().chain(further.clone());
        check_all(tokens.collect())
    });
    let found = all.find(|checked| checked.name.as_deref() == Some(name))?;
    Mechanism::new(&found.in_any_range()).filter(|mechanism| !mechanism.headings().is_empty())
}
