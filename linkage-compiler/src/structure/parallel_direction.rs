//! Recognising an angle that is that of a known direction, or half a turn from it: two pins of one
//! plate on one line.

use std::f64::consts::FRAC_PI_2;

use linkage_symbolic::lookup::Map;
use linkage_symbolic::program::{Binary, Source};
use linkage_symbolic::{
    Ex, SymbolId, V2, Vector, numerically_equal, numerically_equal_within, substitute,
};

use crate::algebra::names::Names;
use crate::algebra::{Atom, Scalar, scalar};

/// A component below this share of a vector is rounding.
const NEGLIGIBLE: f64 = 1e-14;

/// A direction that turns with known angles.
pub(crate) struct Parallel<'m> {
    /// The angle of the direction.
    pub(crate) value: Scalar<'m>,
    /// The length of the vector that turns; the direction is open where it is 0.
    pub(crate) arm: Ex<'m>,
}

/// Returns the angle of a vector of fixed length that turns with known angles and inputs, up to
/// half a turn.
pub(crate) fn parallel_direction<'m>(names: &Names<'m>, vector: V2<'m>) -> Option<Parallel<'m>> {
    let mut arm = vector;
    let mut terms = Vec::new();
    for turn in turns(names, vector) {
        let present = names.graph.symbols_of(&arm.ids());
        if !turn
            .symbols
            .iter()
            .any(|(symbol, _)| present.contains(symbol))
        {
            continue;
        }
        let still: Map<SymbolId, Ex<'m>> = turn.symbols.iter().copied().collect();
        let back = arm.turned(turn.unit.conjugate());
        let Ok(back) = substitute(&back.0, &still).try_into() else {
            continue;
        };
        let back = Vector(back);
        let again = back.turned(turn.unit);
        if (0..2).all(|k| numerically_equal(again[k], arm[k])) {
            arm = back;
            terms.push((turn.atom, turn.factor));
        }
    }
    if !arm.is_fixed() {
        return None;
    }
    terms.sort_by_key(|(atom, _)| *atom);
    let length = arm.length();
    Some(Parallel {
        value: Scalar {
            terms,
            rest: slope(arm, length),
        },
        arm: length,
    })
}

/// The angle of a fixed vector, up to half a turn.
fn slope<'m>(arm: V2<'m>, length: Ex<'m>) -> Ex<'m> {
    let is_small = |x: Ex<'m>| numerically_equal_within(length + x, length, NEGLIGIBLE);
    match arm.0.map(is_small) {
        [_, true] => length.number(0.0),
        [true, _] => length.number(FRAC_PI_2),
        _ => arm[1].binary(Binary::Atan2, arm[0]),
    }
}

/// A known angle with a factor, and its direction.
struct Turn<'m> {
    atom: Atom,
    factor: f64,
    unit: V2<'m>,
    /// Its symbols, with their values where it is 0.
    symbols: Vec<(SymbolId, Ex<'m>)>,
}

/// The unknown angles and inputs that a vector may turn with, forward and backward.
fn turns<'m>(names: &Names<'m>, vector: V2<'m>) -> Vec<Turn<'m>> {
    let present = names.graph.symbols_of(&vector.ids());
    let mut turns = Vec::new();
    for (index, angle) in names.angles.iter().enumerate() {
        if !present.contains(&angle.cos) && !present.contains(&angle.sin) {
            continue;
        }
        let (zero, one) = (names.zero(), names.one());
        for (factor, unit) in [(1.0, angle.unit), (-1.0, angle.unit.conjugate())] {
            turns.push(Turn {
                atom: Atom::Angle(index),
                factor,
                unit,
                symbols: vec![(angle.cos, one), (angle.sin, zero), (angle.value, zero)],
            });
        }
    }
    for index in 0..names.mechanism.inputs.len() {
        let atom = Atom::Input(index);
        let Some(symbol) = names.graph.find_source(Source::Input(index)) else {
            continue;
        };
        for rate in names.input_rates(atom) {
            for factor in [rate, -rate] {
                turns.push(Turn {
                    atom,
                    factor,
                    unit: scalar::unit_of_input(names, index, factor),
                    symbols: vec![(symbol, names.zero())],
                });
            }
        }
    }
    turns
}
