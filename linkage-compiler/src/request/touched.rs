//! Which groups a function of a mechanism with parts touches.

use crate::formulate::Formulation;
use crate::model::{EvaluatorDef, Expr, ExprKind, Mechanism, Name};

/// The groups with which the graph of a function begins, by their numbers: all of them, but not those of parts that nothing in the function is
/// made of. So a part costs what it does in its own mechanism: what others share with it would order its sums in another way.
pub(super) fn groups(
    mechanism: &Mechanism,
    formulation: &Formulation,
    function: &EvaluatorDef,
) -> Vec<usize> {
    let all = 0..formulation.groups.len();
    let values = || function.quantities.iter().map(|own| &own.value);
    let is_of_all = |part: &Expr| {
        matches!(
            part.kind,
            ExprKind::Margin | ExprKind::Picture(_) | ExprKind::Mechanics(_)
        )
    };
    if mechanism.parts.is_empty() || values().flat_map(Expr::parts).any(is_of_all) {
        return all.collect();
    }
    let mut touched = Touched {
        mechanism,
        formulation,
        lets: vec![false; mechanism.lets.len()],
        groups: vec![false; formulation.groups.len()],
        open: values().collect(),
    };
    touched.follow();
    let parts: Vec<bool> = mechanism
        .parts
        .iter()
        .enumerate()
        .map(|(part, _)| {
            let mut own = all.clone().filter(|&group| touched.groups[group]);
            own.any(|group| touched.part_of(group) == Some(part))
        })
        .collect();
    all.filter(|&group| touched.part_of(group).is_none_or(|part| parts[part]))
        .collect()
}

struct Touched<'m, 'g> {
    mechanism: &'m Mechanism,
    formulation: &'g Formulation<'m>,
    lets: Vec<bool>,
    groups: Vec<bool>,
    open: Vec<&'m Expr>,
}

impl Touched<'_, '_> {
    fn follow(&mut self) {
        while let Some(value) = self.open.pop() {
            for name in value.parts().filter_map(Expr::as_name) {
                match name {
                    Name::Let(own) if !std::mem::replace(&mut self.lets[own], true) => {
                        self.open.push(&self.mechanism.lets[own].value);
                    }
                    Name::Unknown(unknown) => self.find(unknown),
                    Name::Let(_)
                    | Name::Const(_)
                    | Name::Parameter(_)
                    | Name::Input(_)
                    | Name::Argument(_)
                    | Name::Pi => {}
                }
            }
        }
    }

    /// The group that finds an unknown is made of all that its loops are.
    fn find(&mut self, unknown: usize) {
        let mut groups = self.formulation.groups.iter().enumerate();
        let found = groups.find(|(_, own)| own.group.unknowns.contains(&unknown));
        let Some((number, own)) = found else {
            return;
        };
        if !std::mem::replace(&mut self.groups[number], true) {
            let loops = own
                .group
                .loops
                .iter()
                .map(|&own| &self.mechanism.loops[own]);
            self.open
                .extend(loops.flat_map(|own| [&own.left, &own.right]));
        }
    }

    /// The part that all unknowns of a group belong to.
    fn part_of(&self, group: usize) -> Option<usize> {
        let unknowns = &self.formulation.groups[group].group.unknowns;
        let parts = &self.mechanism.parts;
        let of = |unknown: usize| {
            let mut parts = parts.iter();
            parts.position(|part| part.unknowns.contains(&unknown))
        };
        let first = of(*unknowns.first()?)?;
        let mut others = unknowns.iter();
        others
            .all(|&unknown| of(unknown) == Some(first))
            .then_some(first)
    }
}
