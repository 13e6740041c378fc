//! The symbols of a group's unknowns.

use linkage_symbolic::{Ex, SymbolId, V2};

use crate::algebra::Algebra;
use crate::structure::{Core, Coupled, Form, Private, Rotor};

/// The symbol of an unknown, as it enters the group's equations.
pub(super) fn unknown<'m>(algebra: &Algebra<'m>, symbol: SymbolId) -> Ex<'m> {
    let graph = algebra.graph;
    graph.ex(graph.symbol_node(symbol))
}

/// The unit vector `(cos, sense sin)` of a rotor's angle.
pub(super) fn unit_of<'m>(algebra: &Algebra<'m>, rotor: &Rotor<'m>) -> V2<'m> {
    let unit = algebra.names.angles[rotor.angle].unit;
    if rotor.sense < 0.0 {
        unit.conjugate()
    } else {
        unit
    }
}

/// The unknown symbols that a closed form defines.
pub(super) fn symbols_of_form(algebra: &Algebra, form: &Form) -> Vec<SymbolId> {
    let of_angle = |angle: usize| algebra.names.angles[angle].symbols().to_vec();
    match form {
        Form::TwoRotors { first, second, .. } => {
            [of_angle(first.angle), of_angle(second.angle)].concat()
        }
        Form::RotorAndSlide { rotor, slide, .. } | Form::SlideOnRotor { rotor, slide, .. } => {
            [of_angle(rotor.angle), vec![*slide]].concat()
        }
        Form::TwoSlides { slides, .. } => slides.to_vec(),
        Form::ThreeSlides { slides, .. } => slides.to_vec(),
        Form::Trigonometric { angle, .. }
        | Form::LinkToRotor { angle, .. }
        | Form::Relation { angle, .. }
        | Form::Parallel { angle, .. } => of_angle(*angle),
        Form::Quadratic { symbol, .. } | Form::Linear { symbol, .. } => vec![*symbol],
        Form::LinkToSlide { slide, .. } => vec![*slide],
        Form::Point { coordinates, .. } => coordinates.iter().map(|(symbol, _)| *symbol).collect(),
        Form::Coupled(coupled) => symbols_of_coupled(coupled, of_angle),
    }
}

/// The symbols of the private unknowns of loops and of the core, with those of each angle from
/// `of_angle`.
pub(super) fn symbols_of_coupled(
    coupled: &Coupled,
    of_angle: impl Fn(usize) -> Vec<SymbolId>,
) -> Vec<SymbolId> {
    let private = coupled.blocks.iter().filter_map(|b| b.private.as_ref());
    let private = private.flat_map(|private| match private {
        Private::Rotor(rotor) => of_angle(rotor.angle),
        Private::Slide { slide, .. } => vec![*slide],
    });
    let core = coupled.core.iter().flat_map(|core| match *core {
        Core::Angle(angle) => of_angle(angle),
        Core::Length { symbol, .. } => vec![symbol],
    });
    private.chain(core).collect()
}
