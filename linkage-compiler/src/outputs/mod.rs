//! What functions ask for, and the unit that computes it: quantities as expressions, directions of sensitivities, programs.

mod choice;
mod columns;
mod dependencies;
mod doc_text;
mod effort;
mod fields;
mod isolated;
mod needs;
mod part_graph;
mod quantity;
mod signature;
#[cfg(test)]
mod tests;
mod turning;

use std::collections::{BTreeMap, BTreeSet};

use linkage_symbolic::inline::Inliner;
use linkage_symbolic::program::{Instruction, Source};
use linkage_symbolic::schedule::{Slots, schedule, schedule_whole};
use linkage_symbolic::{Ex, Graph, NodeId, Vn};

use crate::algebra::{Algebra, Bound, Nominal};
use crate::assembly::Reference;
use crate::diagnostic::Reporter;
use crate::forces::Forces;
use crate::ir::{CompiledMechanism, Function, Surveyed};
use crate::lower::{
    self, Found, GroupNodes, find_turning, group_nodes, groups, plain, valued_angles,
};
use crate::model::EvaluatorDef;
use crate::observer::PhaseObserver;
use crate::solve::Formulation;
use crate::structure::Scope;

use isolated::Alone;
use part_graph::Apart;
use quantity::Way;

/// A formulated mechanism, in which functions are asked for.
pub(crate) struct State<'a, 'm> {
    pub(crate) algebra: &'a mut Algebra<'m>,
    pub(crate) forces: &'a mut Forces<'m>,
    pub(crate) formulation: &'a Formulation<'m>,
    /// What `picture()` shows, once it has been found: points, then unit vectors.
    pub(crate) drawn: Vec<Vn<'m>>,
}

/// The mechanism at its reference position.
#[derive(Clone, Copy)]
pub(crate) struct AtReference<'a> {
    pub(crate) reference: &'a Reference,
    pub(crate) nominal: &'a Nominal,
    /// What the loops are solved with: estimates as they are given.
    pub(crate) written: &'a Nominal,
}

/// The functions that ask for nothing of bodies; `None` stands for the others.
pub(crate) struct OfMotion(Vec<Option<Alone>>);

/// Makes them before anything is known of bodies: those change nothing in them. What does not fit is reported.
pub(crate) fn of_motion<'m>(
    algebra: &mut Algebra<'m>,
    formulation: &Formulation<'m>,
    at: AtReference,
    reporter: &mut Reporter,
) -> OfMotion {
    let mechanism = algebra.mechanism;
    let functions = &mechanism.evaluators;
    let scopes = functions
        .iter()
        .map(|definition| dependencies::scope(mechanism, formulation, definition));
    let scopes: Vec<Option<Scope>> = scopes.collect();
    // Functions of the same parts share what is solved.
    let distinct: BTreeSet<&Scope> = scopes.iter().flatten().collect();
    let graphs = vec![Graph::new(); distinct.len()];
    let apart = distinct.into_iter().zip(&graphs).map(|(scope, graph)| {
        let apart = Apart::new(algebra, formulation, at, scope, graph, reporter);
        (scope, apart)
    });
    let mut apart: BTreeMap<&Scope, Option<Apart>> = apart.collect();
    let inliner = solved(algebra, formulation);
    let state = &mut State {
        algebra,
        forces: &mut Forces::default(),
        formulation,
        drawn: Vec::new(),
    };
    let all = functions.iter().zip(&scopes).map(|(definition, scope)| {
        if definition.asks_of_bodies() {
            return None;
        }
        let apart = scope
            .as_ref()
            .and_then(|scope| apart.get_mut(scope)?.as_mut());
        Some(match apart {
            Some(apart) => apart.function(at, definition, reporter),
            None => Alone::new(state, at, &inliner, definition, reporter),
        })
    });
    OfMotion(all.collect())
}

/// Lowers all functions of the mechanism. An argument list that does not fit its quantities is reported, and a picture that
/// cannot be drawn.
pub(crate) fn unit<'m>(
    mut state: State<'_, 'm>,
    at: AtReference,
    of_motion: OfMotion,
    reporter: &mut Reporter,
    watch: &mut dyn PhaseObserver,
) -> CompiledMechanism {
    // All graphs begin with the solved groups, so that what functions have in common is put together alike in each of them.
    let mut inliner = solved(state.algebra, state.formulation);
    let functions = state.algebra.mechanism.evaluators.iter();
    let all = functions.zip(of_motion.0).map(|(definition, made)| {
        made.unwrap_or_else(|| Alone::new(&mut state, at, &inliner, definition, reporter))
    });
    let all: Vec<Alone> = all.collect();
    let State {
        algebra,
        formulation,
        ..
    } = state;
    let gaps = formulation.groups.iter().map(|group| group.closed.gap);
    let gaps = plain(&mut inliner, &gaps.collect::<Vec<_>>());
    let survey = plain(&mut inliner, &survey(algebra, formulation));
    let closing = &at.reference.machine.closing;
    let nodes = group_nodes(
        algebra,
        formulation,
        at.nominal,
        &mut inliner,
        |prepared| match closing.coupled[prepared.number].followed {
            true => Found::Followed,
            false => Found::Listed,
        },
    );

    let of_groups = nodes.iter().flat_map(GroupNodes::all);
    let own: Vec<NodeId> = gaps
        .iter()
        .chain(&survey)
        .copied()
        .chain(of_groups)
        .collect();
    let mut angles = valued_angles(&inliner.target, &own);
    angles.extend(all.iter().flat_map(Alone::valued_angles));
    angles.sort_unstable();
    angles.dedup();
    let angles = formulation.in_order(algebra, angles);
    let units = angles.iter().map(|&angle| algebra.names.angles[angle].unit);
    let units: Vec<Ex> = units.flat_map(|unit| unit.components()).collect();
    let units = plain(&mut inliner, &units);

    let mut slots = Slots::default();
    let graph = &inliner.target;
    let picture = all.iter().find_map(|own| own.picture.clone());
    let functions = all.into_iter().enumerate();
    let functions = functions.map(|(index, own)| own.function(algebra, index, &mut slots, watch));
    let functions: Vec<Function> = functions.collect();
    let mut coupled = groups(algebra, formulation, at.nominal, &nodes, |nodes| {
        schedule(graph, nodes, &mut slots)
    });
    find_turning(&mut coupled, &nodes, graph, &angles);
    for (group, start) in coupled.iter_mut().zip(&at.reference.machine.starts) {
        group.start.clone_from(start);
    }
    let valued = valued_angles(graph, &survey);
    let last = angles.iter().rposition(|angle| valued.contains(angle));
    let [gaps, survey, directions] =
        [&gaps, &survey, &units].map(|nodes| schedule(graph, nodes, &mut slots));
    // New formulas: behind all others, whose sums would be ordered in another way.
    let (continuous, bearings) = turning::continuous(algebra, at.nominal, &angles);
    let bearings = plain(&mut inliner, &bearings);
    let mut unit = CompiledMechanism {
        functions,
        coupled,
        gaps,
        survey,
        surveyed: surveyed(algebra, formulation),
        surveying: last.map_or(0, |last| last + 1),
        directions,
        prepare: slots.prepare(),
        angles: continuous,
        bearings: schedule_whole(&inliner.target, &bearings),
        picture,
        ..signature::signature(algebra, formulation, at)
    };
    lower::missed(algebra, formulation, &mut inliner, &mut unit);
    renumber(&mut unit, &angles);
    lower::polish(&mut unit, watch);
    unit
}

/// A plain graph that begins with the solved groups.
fn solved(algebra: &Algebra, formulation: &Formulation) -> Inliner {
    let mut inliner = Inliner::default();
    let closed = formulation.groups.iter().flat_map(|group| {
        let all = group.group.unknowns.iter();
        let all = all.flat_map(|&unknown| algebra.names.numbers_of(unknown));
        all.chain([group.closed.gap]).collect::<Vec<_>>()
    });
    plain(&mut inliner, &closed.collect::<Vec<_>>());
    inliner
}

/// See [`CompiledMechanism::survey`].
fn survey<'m>(algebra: &Algebra<'m>, formulation: &Formulation<'m>) -> Vec<Ex<'m>> {
    let margins = formulation.groups.iter().map(|group| group.closed.margin);
    let least = margins.fold(algebra.one(), |least, margin| least.min(margin));
    // The curves of coupled groups are followed; nobody asks for their slack.
    let slacks = formulation.groups.iter().map(|group| match group.prepared {
        Some(_) => algebra.one(),
        None => group.closed.slack,
    });
    let found = found(algebra, formulation);
    let places = found.flat_map(|unknown| algebra.names.numbers_of(unknown));
    let first = std::iter::once(least).chain(slacks);
    first.chain(places).collect()
}

/// The unknowns that a group finds.
fn found(algebra: &Algebra, formulation: &Formulation) -> impl Iterator<Item = usize> {
    let unknowns = 0..algebra.names.bound.len();
    unknowns.filter(|&k| formulation.last_group_with(k).is_some())
}

/// See [`CompiledMechanism::surveyed`].
fn surveyed(algebra: &Algebra, formulation: &Formulation) -> Vec<Surveyed> {
    let surveyed = |unknown: usize| Surveyed {
        unknown,
        angle: matches!(algebra.names.bound[unknown], Bound::Angle(_)),
        numbers: algebra.names.numbers_of(unknown).len(),
    };
    found(algebra, formulation).map(surveyed).collect()
}

/// The results of one function as expressions of the undigested graph.
pub(crate) fn requested<'m>(state: &mut State<'_, 'm>, definition: &EvaluatorDef) -> Vec<Ex<'m>> {
    quantity::request(state, definition, Way::default()).scalars
}

/// Centres and windings count the continuous angles only.
fn renumber(unit: &mut CompiledMechanism, angles: &[usize]) {
    let number = |angle: usize| angles.iter().position(|&a| a == angle).unwrap_or(angle);
    for program in unit.programs_mut() {
        for instruction in &mut program.instructions {
            if let Instruction::Load(Source::Centre(angle) | Source::Winding(angle, _)) =
                instruction
            {
                *angle = number(*angle);
            }
        }
    }
}
