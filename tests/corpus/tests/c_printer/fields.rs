//! What stands in the struct of a unit.

use linkage_compiler::unit::Unit;
use linkage_symbolic::program::Source;

/// A field of the struct: an array.
pub(crate) struct Field {
    /// Name and lengths: `winding[2][1]`
    pub(crate) declared: String,
    /// What its numbers are.
    pub(crate) note: String,
    /// What its numbers are to programs.
    pub(crate) sources: Vec<Source>,
}

/// All that programs load, but for what stages carry. An array of nothing is not C, so there is none.
pub(crate) fn fields(unit: &Unit) -> Vec<Field> {
    let parameters: Vec<&str> = parameters(unit).collect();
    let inputs: Vec<&str> = inputs(unit).collect();
    let angles = unit.angles.iter();
    let angles: Vec<&str> = angles
        .map(|own| &unit.unknowns[own.unknown].name[..])
        .collect();
    let mut fields = vec![
        Field::new(
            "parameter",
            parameters.len(),
            Source::Parameter,
            parameters.join(", "),
        ),
        Field::new(
            "mode",
            unit.modes().len(),
            Source::Mode,
            "the solution of each group with two: +1 or -1".to_owned(),
        ),
        Field::new("centre", angles.len(), Source::Centre, angles.join(", ")),
        windings(unit),
        Field::new(
            "prepared",
            unit.slots(),
            Source::Prepared,
            "what prepare() gives".to_owned(),
        ),
        Field::new("input", inputs.len(), Source::Input, inputs.join(", ")),
    ];
    for (number, group) in unit.coupled.iter().enumerate() {
        fields.push(Field::new(
            &format!("state_{number}"),
            group.size + 1,
            |component| Source::State(number, component),
            "near the solution, then the least determinant that is certified".to_owned(),
        ));
    }
    fields.retain(|field| !field.sources.is_empty());
    fields
}

/// What the user calls a number.
pub(crate) fn called(unit: &Unit, source: Source) -> Option<&str> {
    match source {
        Source::Parameter(index) => parameters(unit).nth(index),
        Source::Input(index) => inputs(unit).nth(index),
        _ => None,
    }
}

fn parameters(unit: &Unit) -> impl Iterator<Item = &str> {
    unit.scalars().map(|own| &own.name[..])
}

/// The inputs, then speeds, accelerations and loads.
fn inputs(unit: &Unit) -> impl Iterator<Item = &str> {
    let inputs = unit.inputs.iter().map(|own| &own.name[..]);
    inputs.chain(unit.arguments.iter().map(|own| &own.name[..]))
}

fn windings(unit: &Unit) -> Field {
    let (angles, inputs) = (unit.angles.len(), unit.inputs.len());
    let of = |angle| (0..inputs).map(move |input| Source::Winding(angle, input));
    Field {
        declared: format!("winding[{angles}][{inputs}]"),
        note: "turns of each of these for a turn of an input".to_owned(),
        sources: (0..angles).flat_map(of).collect(),
    }
}

impl Field {
    fn new(name: &str, length: usize, source: impl Fn(usize) -> Source, note: String) -> Self {
        Self {
            declared: format!("{name}[{length}]"),
            note,
            sources: (0..length).map(source).collect(),
        }
    }
}
