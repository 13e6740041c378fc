//! The facts of a unit besides its programs: its inputs, and the results of the analysis of the
//! groups.

use std::collections::BTreeSet;

use linkage_core::range_check::Slack;
use linkage_symbolic::Ex;
use linkage_symbolic::program::Source;

use crate::algebra::derivatives::dependence;
use crate::algebra::{Algebra, constant_ratio};
use crate::ir::{Argument, CompiledMechanism, Group, Input, Parameter, Role, Scalar, Unknown};
use crate::machine::{AtReference, Reference, followed_range};
use crate::message_format::joint_names;
use crate::model::{Mechanism, Shape};
use crate::solve::{Formulation, Prepared, Solved};
use crate::structure::SolutionBound;

/// A unit without programs.
pub(super) fn signature<'m>(
    algebra: &Algebra<'m>,
    formulation: &Formulation<'m>,
    at: AtReference,
) -> CompiledMechanism {
    let AtReference {
        reference, nominal, ..
    } = at;
    let mechanism = algebra.mechanism;
    let link_lengths = mechanism.link_lengths();
    let parameters = mechanism.parameters.iter().enumerate();
    let parameters = parameters.map(|(index, parameter)| {
        let shape = Shape::from_type(&parameter.ty);
        let first = parameter.first_scalar.0;
        let scalars = (first..first + shape.width()).map(|index| {
            let scalar = &mechanism.scalar_parameters[index];
            Scalar {
                name: scalar.name.clone(),
                unit: scalar.dimension.unit(mechanism.unit),
                nominal: nominal.parameters[index],
                tolerance: nominal.tolerances[index],
            }
        });
        Parameter {
            name: parameter.name.clone(),
            documentation: parameter.documentation.clone(),
            scalars: scalars.collect(),
            shape,
            is_link_length: link_lengths.contains(&index),
        }
    });
    let inputs = mechanism.inputs.iter().enumerate();
    let inputs = inputs.map(|(index, input)| Input {
        name: input.name.clone(),
        unit: input.dimension.unit(mechanism.unit),
        angle: input.dimension.half_lengths == 0,
        reference: nominal.inputs[index],
        range: at.written.ranges[index],
        followed: followed_range(algebra, nominal, index),
        rates: constant_ratio::candidate_rates(&algebra.names, index),
    });
    let arguments = mechanism.arguments.iter().enumerate();
    let arguments = arguments.map(|(index, argument)| Argument {
        name: argument.name.clone(),
        unit: argument.dimension.unit(mechanism.unit),
        role: role(mechanism, index),
        reference: nominal.arguments[index].filter(|value| value.is_finite()),
    });
    let unknowns = mechanism.unknowns.iter().map(|unknown| {
        let dimension = unknown.ty.dimension();
        Unknown {
            name: unknown.name.clone(),
            unit: dimension.map_or_else(String::new, |dimension| dimension.unit(mechanism.unit)),
            is_number: dimension.is_some_and(|dimension| dimension.half_lengths == 0),
        }
    });
    let group_parameters = own_parameters(algebra, formulation);
    let groups = formulation.groups.iter().zip(group_parameters);
    CompiledMechanism {
        documentation: mechanism.documentation.clone(),
        length: mechanism.unit.name(),
        parameters: parameters.collect(),
        inputs: inputs.collect(),
        arguments: arguments.collect(),
        unknowns: unknowns.collect(),
        groups: groups
            .map(|(solved, parameters)| group(algebra, solved, parameters, reference))
            .collect(),
        mobility: formulation.mobility,
        longest: reference.longest,
        ..CompiledMechanism::default()
    }
}

fn role(mechanism: &Mechanism, argument: usize) -> Role {
    let mut inputs = mechanism.inputs.iter().enumerate();
    let found = inputs.find_map(|(index, input)| match () {
        () if input.speed == Some(argument) => Some(Role::Speed(index)),
        () if input.acceleration == Some(argument) => Some(Role::Acceleration(index)),
        () => None,
    });
    found.unwrap_or(Role::Load)
}

/// See [`Group::parameters`].
fn own_parameters(algebra: &Algebra, formulation: &Formulation) -> Vec<Vec<usize>> {
    let (mut known, mut seen) = (BTreeSet::new(), BTreeSet::new());
    let groups = formulation.groups.iter().map(|solved| {
        let unknowns = solved.group.unknowns.iter();
        let mut needs: Vec<Ex> = unknowns
            .flat_map(|&unknown| algebra.names.numbers_of(unknown))
            .collect();
        needs.push(solved.closed.gap);
        if let Some(prepared) = &solved.prepared {
            let coefficients = prepared.system.coefficients.iter();
            needs.extend(coefficients.flat_map(|x| x.components()));
        }
        // The dependencies of earlier groups have been visited.
        let symbols = dependence::add_symbols_below(algebra.graph, &needs, &mut seen).into_iter();
        let mut parameters: Vec<usize> = symbols
            .filter_map(|symbol| match algebra.graph.symbol(symbol).source {
                Some(Source::Parameter(index)) => Some(index),
                _ => None,
            })
            .filter(|&index| known.insert(index))
            .collect();
        parameters.sort_unstable();
        parameters
    });
    groups.collect()
}

/// Returns the method that solves a group: a group whose assemblies cannot be listed has another
/// one than its form gives.
fn method(algebra: &Algebra, solved: &Solved, reference: &Reference) -> String {
    let coupled = &reference.machine.closure.coupled;
    let followed = |prepared: &&Prepared| coupled[prepared.number].followed;
    let Some(prepared) = solved.prepared.as_ref().filter(followed) else {
        return solved.closed.method.to_owned();
    };
    let how = prepared.method();
    let solutions = SolutionBound::of_group(&algebra.names, &solved.group);
    format!("followed from the estimates; {solutions} not listed; {how}")
}

fn group(
    algebra: &Algebra,
    solved: &Solved,
    parameters: Vec<usize>,
    reference: &Reference,
) -> Group {
    let mechanism = algebra.mechanism;
    let unknown = |&k: &usize| mechanism.unknowns[k].name.clone();
    let modes = &reference.machine.modes;
    Group {
        class: solved.closed.class,
        order: solved.closed.order,
        kind: solved.closed.kind.to_string(),
        loops: solved.group.loops.iter().map(|k| k + 1).collect(),
        joints: joint_names(mechanism, &solved.group.loops),
        unknowns: solved.group.unknowns.iter().map(unknown).collect(),
        mode: solved.mode,
        coupled: solved.prepared.is_some(),
        plus: solved.mode.is_none_or(|mode| modes[mode] > 0.0),
        method: method(algebra, solved, reference),
        gap_unit: solved.gap_dimension(mechanism).unit(mechanism.unit),
        slack: slack(solved),
        parameters,
    }
}

/// Returns the kind of slack of a group.
fn slack(solved: &Solved) -> Slack {
    let closed = &solved.closed;
    match solved.prepared {
        Some(_) => Slack::Prepared,
        None if !closed.two_modes => Slack::Signed,
        None if closed.slack_scale.constant_value() == Some(1.0) => Slack::Number,
        None => Slack::Relative,
    }
}
