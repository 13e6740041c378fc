//! The formulas of a mechanism with parts that a function needs.

use crate::model::{EvaluatorDef, Expr, ExprKind, Leaf, Mechanism, Name};
use crate::solve::Formulation;
use crate::structure::Scope;

/// Returns the formulas that a function of a mechanism with parts needs, with all formulas of each
/// part that it touches; `None` if they are those of the whole mechanism.
pub(super) fn scope(
    mechanism: &Mechanism,
    formulation: &Formulation,
    function: &EvaluatorDef,
) -> Option<Scope> {
    if mechanism.parts.is_empty() || function.asks_of_bodies() {
        return None;
    }
    let values = || function.quantities.iter().map(|quantity| &quantity.value);
    let mut touched = Touched {
        mechanism,
        formulation,
        scope: Scope::nothing(mechanism),
        leaves: vec![false; mechanism.leaves.len()],
        open: values().collect(),
    };
    touched.follow();
    let asks_margin = || {
        let mut parts = values().flat_map(Expr::parts);
        parts.any(|part| matches!(part.kind, ExprKind::Margin))
    };
    // The margin alone is that of all groups.
    let moves = touched.scope.unknowns.contains(&true);
    (moves || !asks_margin()).then_some(touched.scope)
}

struct Touched<'m, 'g> {
    mechanism: &'m Mechanism,
    formulation: &'g Formulation<'m>,
    scope: Scope,
    leaves: Vec<bool>,
    open: Vec<&'m Expr>,
}

/// Returns true if an item is new, and marks it as seen.
fn first(seen: &mut bool) -> bool {
    !std::mem::replace(seen, true)
}

impl Touched<'_, '_> {
    fn follow(&mut self) {
        while let Some(value) = self.open.pop() {
            for name in value.parts().filter_map(Expr::as_name) {
                match name {
                    Name::Let(index) => self.touch_let(index),
                    Name::Unknown(unknown) => self.touch_unknown(unknown),
                    Name::Const(_)
                    | Name::Parameter(_)
                    | Name::Input(_)
                    | Name::Argument(_)
                    | Name::Pi => {}
                }
            }
        }
    }

    fn touch_let(&mut self, index: usize) {
        if first(&mut self.scope.lets[index]) {
            self.open.push(&self.mechanism.lets[index].value);
            self.touch_leaf(|leaf| leaf.lets.contains(&index));
        }
    }

    /// An unknown is made of all that the loops of its groups are.
    fn touch_unknown(&mut self, unknown: usize) {
        if !first(&mut self.scope.unknowns[unknown]) {
            return;
        }
        self.touch_leaf(|leaf| leaf.unknowns.contains(&unknown));
        let groups = self.formulation.groups.iter().map(|solved| &solved.group);
        for group in groups.filter(|candidate| candidate.unknowns.contains(&unknown)) {
            group.loops.iter().for_each(|&index| self.touch_loop(index));
            group
                .unknowns
                .iter()
                .for_each(|&index| self.touch_unknown(index));
        }
        // The loops that define the axes of an unknown frame are in no group.
        let origin = self.mechanism.unknowns[unknown].origin;
        let loops = self.mechanism.loops.iter().enumerate();
        for (index, _) in loops.filter(|(_, equation)| equation.origin == origin) {
            self.touch_loop(index);
        }
    }

    fn touch_loop(&mut self, index: usize) {
        if first(&mut self.scope.loops[index]) {
            let item = &self.mechanism.loops[index];
            self.open.extend([&item.left, &item.right]);
            self.touch_leaf(|leaf| leaf.loops.contains(&index));
        }
    }

    /// Touches all formulas of a part: it is as in its own mechanism, which contains all of them.
    fn touch_leaf(&mut self, is_in: impl Fn(&Leaf) -> bool) {
        let Some(number) = self.mechanism.leaves.iter().position(is_in) else {
            return;
        };
        if first(&mut self.leaves[number]) {
            let leaf = self.mechanism.leaves[number].clone();
            leaf.lets.for_each(|index| self.touch_let(index));
            leaf.loops.for_each(|index| self.touch_loop(index));
            leaf.unknowns.for_each(|index| self.touch_unknown(index));
        }
    }
}
