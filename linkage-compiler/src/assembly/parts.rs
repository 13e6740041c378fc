//! Parts: the position of each, as if it were alone, at the reference of the surrounding mechanism.
//!
//! The estimates of a part belong to its own reference. The part alone has been closed there. It is
//! followed from there to the values of its inputs here, and the position reached gives the
//! estimates of its unknowns here: the assembly is that of the part alone, and so are the turns of
//! its angles.

use std::rc::Rc;

use linkage_symbolic::lookup::Map;

use crate::algebra::{Algebra, Bound, Nominal, Translate, Value, nominal, scalar, translate};
use crate::model::{Dimension, Expr, ExprKind, Mechanism, Name};
use crate::solve::Formulation;

use super::assembler::Assembly;
use super::closed_part::{AssembledPart, InnerPart};

/// Returns the parts of a mechanism with the expressions of their inputs; `closed` is the assembly
/// of each part alone.
pub(crate) fn inner_parts<'m>(
    algebra: &mut Algebra<'m>,
    nominal: &Nominal,
    closed: &[Rc<AssembledPart>],
) -> Vec<InnerPart<'m>> {
    let mechanism = algebra.mechanism;
    let parts = mechanism.parts.iter().zip(closed);
    let parts = parts.map(|(part, closed)| {
        let ratio = mechanism.unit.in_units_of(closed.unit);
        let inputs = part.inputs.iter();
        let inputs = inputs.map(|&input| match algebra.translate(&named(mechanism, input)) {
            Value::Vector(vector) => vector.iter().next().unwrap_or(algebra.zero()),
            scalar => scalar::number(&algebra.names, &scalar),
        });
        let inputs = inputs.collect();
        let mut numbers = Vec::new();
        for name in &part.parameters {
            match *name {
                Name::Parameter(index) => {
                    let parameter = &mechanism.parameters[index];
                    let first = parameter.first_scalar.0;
                    let count = parameter.tolerances.len();
                    numbers.extend_from_slice(&nominal.parameters[first..first + count]);
                }
                Name::Let(index) => {
                    let expression = &mechanism.lets[index].value;
                    let scale = translate::internal_per_unit(algebra.mechanism, &expression.ty);
                    let found = nominal::evaluated(
                        &mut algebra.names,
                        &named(mechanism, index),
                        &nominal.parameters,
                        &[],
                    );
                    numbers.extend(found.into_iter().map(|number| number / scale));
                }
                // Parameters are nothing else.
                Name::Const(_)
                | Name::Input(_)
                | Name::Unknown(_)
                | Name::Argument(_)
                | Name::Pi => {}
            }
        }
        let scaled = numbers.iter().zip(&closed.parameters);
        InnerPart {
            closed: closed.clone(),
            first_unknown: part.unknowns.start,
            inputs,
            needs: unknowns_below(mechanism, &part.inputs),
            parameters: scaled
                .map(|(x, dimension)| x * power(ratio, *dimension))
                .collect(),
            ratio,
        }
    });
    parts.collect()
}

/// A derived quantity as an expression.
fn named(mechanism: &Mechanism, index: usize) -> Expr {
    let item = &mechanism.lets[index].value;
    Expr {
        kind: ExprKind::Name(Name::Let(index)),
        ty: item.ty.clone(),
        origin: item.origin,
    }
}

/// Returns the factor by which a number of a dimension grows if the length unit is smaller by this
/// ratio.
fn power(ratio: f64, dimension: Dimension) -> f64 {
    match ratio {
        1.0 => 1.0,
        _ => ratio.powf(f64::from(dimension.half_lengths) / 2.0),
    }
}

/// Finds the positions of parts whose inputs are known: all unknowns in these inputs are `closed`,
/// or one of the part's own unknowns is among those that are closed next.
pub(super) fn settle_parts<'m>(
    assembly: &mut Assembly<'_, 'm>,
    formulation: &Formulation<'m>,
    closed: usize,
) {
    let (before, rest) = formulation.groups.split_at(closed);
    let is_closed = |unknown: usize| {
        before
            .iter()
            .any(|solved| solved.group.unknowns.contains(&unknown))
    };
    let next = rest.first();
    let parts = std::mem::take(&mut assembly.parts);
    for part in parts {
        let open: Vec<usize> = part
            .needs
            .iter()
            .copied()
            .filter(|&unknown| !is_closed(unknown))
            .collect();
        match open.is_empty() || next.is_some_and(|next| part.is_in(next)) {
            true => settle(assembly, &part, &open),
            false => assembly.parts.push(part),
        }
    }
}

/// Replaces the estimates of a part's unknowns by its position; the open unknowns are taken at
/// their own estimates.
fn settle<'m>(assembly: &mut Assembly<'_, 'm>, part: &InnerPart<'m>, open: &[usize]) {
    let mut given = Map::new();
    for &unknown in open {
        let estimate = &assembly.nominal.estimates[unknown];
        match &assembly.algebra.names.bound[unknown] {
            Bound::Angle(angle) => {
                let angle = &assembly.algebra.names.angles[*angle];
                let (sin, cos) = estimate[0].sin_cos();
                given.insert(angle.cos, cos);
                given.insert(angle.sin, sin);
                given.insert(angle.value, estimate[0]);
            }
            Bound::Lengths(symbols) => {
                for ((symbol, _), x) in symbols.iter().zip(estimate) {
                    given.insert(*symbol, *x);
                }
            }
        }
    }
    let inputs = assembly
        .machine
        .evaluate_open(&part.inputs, &assembly.nominal.inputs, &given);
    let closed = &part.closed;
    let inputs = inputs.iter().zip(&closed.inputs);
    let inputs: Vec<f64> = inputs
        .map(|(x, dimension)| x * power(part.ratio, *dimension))
        .collect();
    let found = closed.led_to(part.parameters.clone(), &inputs);
    let alone = found.into_iter().zip(&closed.nominal.estimates);
    for (index, ((found, reference), dimension)) in alone.zip(&closed.dimensions).enumerate() {
        // Inputs that the part cannot reach are reported when its loops are closed.
        let known = match found.iter().all(|x| x.is_finite()) {
            true => &found,
            false => reference,
        };
        let scale = power(part.ratio, *dimension);
        let known = known.iter().map(|x| x / scale).collect();
        assembly.nominal.estimates[part.first_unknown + index] = known;
    }
    assembly.centre(Some(part));
}

/// The unknowns that derived quantities are made of, directly or through others.
fn unknowns_below(mechanism: &Mechanism, lets: &[usize]) -> Vec<usize> {
    let mut open: Vec<usize> = lets.to_vec();
    let mut seen: Vec<usize> = Vec::new();
    let mut found = Vec::new();
    while let Some(index) = open.pop() {
        for name in mechanism.lets[index]
            .value
            .parts()
            .filter_map(Expr::as_name)
        {
            match name {
                Name::Let(other) if !seen.contains(&other) => {
                    seen.push(other);
                    open.push(other);
                }
                Name::Unknown(unknown) if !found.contains(&unknown) => found.push(unknown),
                _ => {}
            }
        }
    }
    found
}
