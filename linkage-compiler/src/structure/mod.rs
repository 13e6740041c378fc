//! The structural analysis: which unknowns can be solved together, in which order, and in which form.
//!
//! Loops and unknowns form a bipartite graph. A maximum matching and the strongly connected components of the
//! directed matching graph (Dulmage and Mendelsohn; Tarjan) are the Assur groups, in order. Each group is then brought
//! to one of the [`Form`]s that have a closed solution, by looking at its loops as polynomials in its unknowns.

pub(crate) mod body;
pub(crate) mod body_circle;
pub(crate) mod bound;
pub(crate) mod circle;
pub(crate) mod class;
pub(crate) mod classify;
pub(crate) mod closest_approach;
pub(crate) mod core_unknowns;
pub(crate) mod coupled_core;
pub(crate) mod distance_polynomials;
pub(crate) mod double;
pub(crate) mod eliminate;
pub(crate) mod equations;
pub(crate) mod form;
pub(crate) mod frames;
pub(crate) mod matching;
pub(crate) mod point;
pub(crate) mod product;
pub(crate) mod redundant;
pub(crate) mod report;
pub(crate) mod rewrite;
pub(crate) mod scope;
pub(crate) mod simultaneous;
pub(crate) mod space;
pub(crate) mod unsolved;

use linkage_symbolic::{Ex, SymbolId};

use crate::algebra::{Algebra, Nominal};
use crate::diagnostic::Reporter;
use crate::model::{Dimension, Mechanism, Type};

pub(crate) use bound::Most;
pub(crate) use coupled_core::{Block, Core, Coupled, Private, Product};
pub(crate) use distance_polynomials::Link;
pub(crate) use equations::{Coordinate, Equation};
pub(crate) use form::{Form, Plane, Rotor, Sphere};
pub(crate) use scope::Scope;

/// One Assur group.
#[derive(Clone, Debug)]
pub(crate) struct Group<'m> {
    /// Indices of its loops in the mechanism.
    pub(crate) loops: Vec<usize>,
    /// That of them which is solved; the others were eliminated, or are solved with it.
    pub(crate) written: usize,
    /// Indices of the unknowns that it finds, in the model.
    pub(crate) unknowns: Vec<usize>,
    pub(crate) form: Form<'m>,
}

impl Group<'_> {
    /// True if it finds both components of an unknown point by an angle.
    pub(crate) fn finds_point(&self, mechanism: &Mechanism) -> bool {
        let point = |&k: &usize| mechanism.unknowns[k].ty.components() == Some(2);
        matches!(self.form, Form::Trigonometric { .. }) && self.unknowns.iter().any(point)
    }

    /// The dimension of both sides of the loop that is solved.
    pub(crate) fn loop_dimension(&self, mechanism: &Mechanism) -> Option<Dimension> {
        let equation = &mechanism.loops[self.written];
        let sides = [&equation.left.ty, &equation.right.ty];
        sides.into_iter().find_map(Type::dimension)
    }

    /// The dimension of its links, if its loop is about lengths or squares of lengths.
    pub(crate) fn link_dimension(&self, mechanism: &Mechanism) -> Option<Dimension> {
        let of_loop = self.loop_dimension(mechanism)?;
        Some(match of_loop.half_lengths {
            4 => Dimension::LENGTH,
            _ => of_loop,
        })
    }

    /// The dimension of its first unknown.
    pub(crate) fn unknown_dimension(&self, mechanism: &Mechanism) -> Option<Dimension> {
        let unknown = self.unknowns.first()?;
        mechanism.unknowns[*unknown].ty.dimension()
    }

    /// True for a linear loop whose factor of the unknown is no number.
    pub(crate) fn factor_has_unit(&self, mechanism: &Mechanism) -> bool {
        let halves = |dimension: Option<Dimension>| dimension.map(|d| d.half_lengths);
        let (of_loop, of_unknown) = (
            self.loop_dimension(mechanism),
            self.unknown_dimension(mechanism),
        );
        matches!(self.form, Form::Linear { .. }) && halves(of_loop) != halves(of_unknown)
    }
}

/// An unknown that is an explicit expression of others and was eliminated before its group was solved.
#[derive(Clone, Debug)]
pub(crate) struct Explicit<'m> {
    pub(crate) symbol: SymbolId,
    pub(crate) value: Ex<'m>,
}

/// The groups in an order in which they can be solved.
#[derive(Clone, Debug, Default)]
pub(crate) struct Structure<'m> {
    pub(crate) groups: Vec<Group<'m>>,
    pub(crate) explicit: Vec<Explicit<'m>>,
    /// Inputs + unknowns - equations.
    pub(crate) mobility: usize,
}

/// Finds the groups of what is looked at; what cannot be solved is reported.
pub(crate) fn decompose<'m>(
    algebra: &mut Algebra<'m>,
    nominal: &Nominal,
    scope: &Scope,
    reporter: Reporter,
) -> Structure<'m> {
    let mut analysis = Analysis {
        algebra,
        nominal,
        reporter,
        structure: Structure::default(),
        substitutions: Default::default(),
        whole: Vec::new(),
        steps: 0,
    };
    analysis.structure.mobility = analysis.algebra.mechanism.inputs.len();
    let (equations, coordinates) = equations::equations(&mut analysis, scope);
    analysis.solve(equations, coordinates);
    analysis.structure
}

/// The state of the analysis.
struct Analysis<'a, 'm> {
    algebra: &'a mut Algebra<'m>,
    nominal: &'a Nominal,
    reporter: Reporter<'a>,
    structure: Structure<'m>,
    /// Eliminated symbols and what they stand for.
    substitutions: linkage_symbolic::lookup::Map<SymbolId, Ex<'m>>,
    /// Components of axes that stay unknowns, all six of a body: systems are solved in its turns.
    whole: Vec<SymbolId>,
    /// Reductions so far.
    steps: usize,
}

/// No mechanism needs as many reductions for each of its loops.
const STEPS_PER_LOOP: usize = 10;

impl<'m> Analysis<'_, 'm> {
    /// Splits equations into groups and solves each for its coordinates.
    fn solve(&mut self, equations: Vec<Equation<'m>>, coordinates: Vec<Coordinate>) {
        let incidence: Vec<Vec<usize>> = equations
            .iter()
            .map(|e| equations::incidence(self, e, &coordinates))
            .collect();
        let rows: Vec<usize> = equations.iter().map(|e| e.rows.len()).collect();
        let matching = matching::maximum(&rows, &incidence, coordinates.len());
        let before = self.reporter.errors();
        if !report::report_mobility(self, &equations, &coordinates, &incidence, &matching) {
            if self.reporter.errors() == before {
                // What lacks an equation, or an unknown, has been introduced here: the loop before that has no known form.
                unsolved::report_unsolved(self, &equations, &coordinates);
            }
            return;
        }
        for component in matching::components(&incidence, &matching) {
            let own =
                |k: &usize| component.contains(&matching.equation_of[*k].unwrap_or(usize::MAX));
            let coordinates: Vec<Coordinate> = (0..coordinates.len())
                .filter(own)
                .map(|k| coordinates[k].clone())
                .collect();
            let equations = component.iter().map(|&k| equations[k].clone()).collect();
            self.component(equations, coordinates);
        }
    }

    /// One strongly connected component: recognised, reduced, or reported.
    fn component(&mut self, equations: Vec<Equation<'m>>, coordinates: Vec<Coordinate>) {
        if let [equation] = &equations[..]
            && let Some(form) = classify::classify(self, equation, &coordinates)
        {
            return self.push_group(&equations, &coordinates, form);
        }
        if let Some(form) = point::classify_point(self, &equations, &coordinates) {
            return self.push_group(&equations, &coordinates, form);
        }
        self.steps += 1;
        let allowed = self.steps <= STEPS_PER_LOOP * self.algebra.mechanism.loops.len();
        let reduced = if allowed {
            eliminate::reduce(self, &equations, &coordinates)
        } else {
            None
        };
        if let Some((equations, coordinates)) = reduced {
            return self.solve(equations, coordinates);
        }
        let squared = distance_polynomials::squared(self, &equations, &coordinates);
        match coupled_core::coupled(self, &squared, &coordinates) {
            Some(form) => self.push_group(&equations, &coordinates, form),
            None => unsolved::report_unsolved(self, &squared, &coordinates),
        }
    }

    fn push_group(
        &mut self,
        equations: &[Equation<'m>],
        coordinates: &[Coordinate],
        form: Form<'m>,
    ) {
        let own = coordinates.iter().filter_map(|c| c.unknown);
        let eliminated = equations.iter().flat_map(|e| e.eliminated.iter().copied());
        let loops = equations.iter().flat_map(|e| e.loops.iter().copied());
        let mut loops: Vec<usize> = loops.collect();
        let mechanism = self.algebra.mechanism;
        if loops.iter().any(|&k| !mechanism.is_loop_of_frame(k)) {
            // What the user did not write has no number.
            loops.retain(|&k| !mechanism.is_loop_of_frame(k));
        }
        let sorted = |numbers: Vec<usize>| {
            let mut numbers = numbers;
            numbers.sort_unstable();
            numbers.dedup();
            numbers
        };
        self.structure.groups.push(Group {
            loops: sorted(loops),
            written: equations[0].written,
            unknowns: sorted(own.chain(eliminated).collect()),
            form,
        });
    }
}
