//! Functions of some parts of a mechanism, made as if the other parts did not exist.
//!
//! Node numbers order sums, and nodes that parts share (the shaft, a number) would order them in
//! another way than in a part's own mechanism: the function would cost more or less by an
//! operation, and round otherwise. Therefore the formulas that a function touches are solved once
//! more, in a separate graph.

use linkage_symbolic::Graph;
use linkage_symbolic::inline::Inliner;
use linkage_symbolic::program::Source;

use crate::algebra::{Algebra, Angle};
use crate::diagnostic::{Diagnostics, Reporter};
use crate::forces::Forces;
use crate::lower::{FunctionExpressions, solved_groups};
use crate::machine::AtReference;
use crate::model::EvaluatorDef;
use crate::solve::{Formulation, Solved, formulate};
use crate::structure::{Scope, decompose};

use super::isolated::express;
use super::state::State;

/// Some parts of a mechanism, solved.
pub(super) struct PartGraph<'m> {
    algebra: Algebra<'m>,
    formulation: Formulation<'m>,
    inliner: Inliner,
    numbers: Numbers,
}

/// The numbers of modes, coupled groups and angles in the whole mechanism.
struct Numbers {
    modes: Vec<usize>,
    coupled: Vec<usize>,
    angles: Vec<usize>,
}

impl<'m> PartGraph<'m> {
    /// Solves the formulas of the scope, in an empty graph. Returns `None` if the groups are not
    /// those of the whole mechanism, whose modes choose the assembly.
    pub(super) fn new<'w: 'm>(
        algebra: &Algebra<'w>,
        formulation: &Formulation<'w>,
        at: AtReference,
        scope: &Scope,
        graph: &'m Graph,
        reporter: &Reporter,
    ) -> Option<Self> {
        let mut part_algebra = Algebra::new(algebra.mechanism, graph);
        // All diagnostics have been reported for the whole mechanism.
        let mut diagnostics = Diagnostics::default();
        let silent = Reporter::new(reporter.origins(), &mut diagnostics);
        let structure = decompose(&mut part_algebra.names, at.written, scope, silent);
        if !diagnostics.is_empty() {
            return None;
        }
        let solution = formulate(
            &mut part_algebra,
            at.written,
            structure,
            formulation.in_cells(),
        );
        let numbers = Numbers::find(
            [&algebra.names.angles, &part_algebra.names.angles],
            formulation,
            &solution,
        )?;
        Some(Self {
            inliner: solved_groups(&part_algebra, &solution),
            algebra: part_algebra,
            formulation: solution,
            numbers,
        })
    }

    /// A function of nothing else.
    pub(super) fn function(
        &mut self,
        at: AtReference,
        definition: &'m EvaluatorDef,
        reporter: &mut Reporter,
    ) -> FunctionExpressions {
        let state = &mut State {
            algebra: &mut self.algebra,
            forces: &mut Forces::default(),
            formulation: &self.formulation,
            drawn: Vec::new(),
        };
        let expressed = express(state, at, &self.inliner, definition, reporter);
        expressed
            .graph
            .move_sources(|source| self.numbers.whole_source(source));
        expressed
    }
}

impl Numbers {
    fn find(
        [angles, own_angles]: [&[Angle]; 2],
        formulation: &Formulation,
        part_formulation: &Formulation,
    ) -> Option<Self> {
        let mut numbers = Self {
            modes: Vec::new(),
            coupled: Vec::new(),
            angles: Vec::new(),
        };
        let mut groups = formulation.groups.iter();
        for group in &part_formulation.groups {
            // Both have the same order, and groups between belong to other parts.
            let same = groups.clone().position(|other| are_same(group, other))?;
            let other = groups.nth(same)?;
            numbers.modes.extend(other.mode);
            let prepared = other.prepared.as_ref();
            numbers
                .coupled
                .extend(prepared.map(|prepared| prepared.number));
        }
        let mut taken = vec![false; angles.len()];
        for angle in own_angles {
            let all = angles.iter().zip(&taken);
            let same = |other: &Angle| {
                let [part_angle, other] =
                    [angle, other].map(|angle| (angle.unknown, angle.summands()));
                part_angle == other
            };
            let mut all = all.map(|(other, taken)| !taken && same(other));
            let found = all.position(|is_same| is_same)?;
            taken[found] = true;
            numbers.angles.push(found);
        }
        Some(numbers)
    }

    fn whole_source(&self, source: Source) -> Source {
        match source {
            Source::Mode(mode) => Source::Mode(self.modes[mode]),
            Source::Centre(angle) => Source::Centre(self.angles[angle]),
            Source::Winding(angle, input) => Source::Winding(self.angles[angle], input),
            Source::State(group, component) => Source::State(self.coupled[group], component),
            Source::Parameter(_)
            | Source::Input(_)
            | Source::Prepared(_)
            | Source::Carried(_)
            | Source::Limit => source,
        }
    }
}

/// Returns true if two groups find the same unknowns in the same way.
fn are_same(a: &Solved, b: &Solved) -> bool {
    let [a, b] = [a, b].map(|solved| {
        let (group, closed) = (&solved.group, &solved.closed);
        let found = (&group.unknowns, &group.loops, group.written);
        let way = (&closed.kind, closed.method, solved.mode.is_some());
        (found, way, solved.prepared.is_some())
    });
    a == b
}
