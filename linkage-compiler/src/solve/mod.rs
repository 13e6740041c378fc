//! Every unknown expressed: the closed form of each group.
//!
//! One file for each form of group. A group's unknowns get definitions that are computed by the
//! closed form; their derivatives follow from the group's equations (see
//! [`Solution`](crate::algebra::Solution)).
//!
//! Floors, from below: `closed`, `unknowns`, `contour`, `group_context`, `definitions`; `circles`,
//! `plane`, `space` and `longest`; the closed forms and `coupled`; `formulation`; this file.

mod circles;
mod closed;
mod contour;
mod coupled;
mod definitions;
mod formulation;
mod group_context;
mod longest;
mod parallel_angle;
mod plane;
mod point;
mod prp;
mod quadratic;
mod rpr;
mod rrp;
mod rrr;
mod rssp;
mod rssr;
mod scalar;
mod space;
mod three_slides;
mod trigonometric;
mod unknowns;
use linkage_core::numeric::continuation::Terms;

use crate::algebra::{Algebra, DerivativeRule, Nominal};
use crate::structure::{Form, Structure};

use closed::ClosedForm;
use contour::{Contour, EarlierGroups};

pub(crate) use coupled::prepared::{Prepared, Version};
pub(crate) use formulation::{Formulation, Solved};
use group_context::GroupContext;

/// Gives every unknown its definition.
pub(crate) fn formulate<'m>(
    algebra: &mut Algebra<'m>,
    nominal: &Nominal,
    structure: Structure<'m>,
    in_cells: Terms,
) -> Formulation<'m> {
    let mut formulation = Formulation {
        mobility: structure.mobility,
        ..Default::default()
    };
    let mut earlier = EarlierGroups::default();
    for explicit in &structure.explicit {
        let value = explicit.value;
        earlier.explicit.insert(explicit.symbol, value);
        algebra.graph.define(explicit.symbol, value.id());
        let rule = DerivativeRule::Follow(value);
        algebra.solutions.set_rule(explicit.symbol, rule);
    }
    let (mut modes, mut coupled) = (0, 0);
    for group in structure.groups {
        let first_symbol = algebra.graph.symbol_count();
        let context = GroupContext {
            nominal,
            index: algebra.solutions.groups.len(),
            mode: modes,
            number: coupled,
            dimension: group.loop_dimension(algebra.mechanism),
            earlier: &earlier,
            in_cells,
        };
        let (mut closed, prepared) = solve(algebra, &context, &group.form);
        earlier.contours.extend(Contour::new(algebra, &group.form));
        coupled += usize::from(prepared.is_some());
        if closed.class == 0 && group.finds_point(algebra.mechanism) {
            // A point on a line at a distance from another: the slide has no name, but the group is
            // a dyad.
            closed = ClosedForm {
                kind: "RRP".into(),
                class: 2,
                order: 2,
                ..closed
            };
        }
        if group.factor_has_unit(algebra.mechanism) {
            // Nothing says how large the factor could be.
            closed.margin = algebra.one();
        }
        let made = algebra.graph.symbols_since(first_symbol);
        let defined = unknowns::symbols_of_form(algebra, &group.form);
        let number = formulation.groups.len();
        formulation.group_of.extend(
            defined
                .into_iter()
                .chain(made)
                .map(|symbol| (symbol, number)),
        );
        let mode = closed.two_modes.then_some(modes);
        modes += usize::from(closed.two_modes);
        formulation.groups.push(Solved {
            group,
            closed,
            mode,
            prepared,
        });
    }
    formulation
}

/// Builds the closed form of a group, and the state that is prepared for a coupled group.
fn solve<'m>(
    algebra: &mut Algebra<'m>,
    group: &GroupContext<'_, 'm>,
    form: &Form<'m>,
) -> (ClosedForm<'m>, Option<Prepared<'m>>) {
    let closed = match form {
        Form::TwoRotors {
            first,
            second,
            known,
        } => rrr::rrr(algebra, group, first, second, *known),
        Form::RotorAndSlide {
            rotor,
            slide,
            guide,
            known,
        } => rrp::rrp(algebra, group, rotor, *slide, *guide, *known),
        Form::SlideOnRotor {
            rotor,
            slide,
            guide,
            known,
        } => rpr::rpr(algebra, group, rotor, *slide, *guide, *known),
        Form::TwoSlides {
            slides,
            guides,
            known,
        } => prp::prp(algebra, group, *slides, *guides, *known),
        Form::Trigonometric { angle, a, b, c } => {
            trigonometric::trigonometric(algebra, group, *angle, *a, *b, *c)
        }
        Form::Quadratic { symbol, a, b, c } => {
            quadratic::quadratic(algebra, group, *symbol, *a, *b, *c)
        }
        Form::Linear { symbol, a, b } => scalar::linear(algebra, group, *symbol, *a, *b),
        Form::LinkToRotor {
            angle,
            cosine,
            sine,
            known,
            length,
        } => rssr::rssr(algebra, group, *angle, [*cosine, *sine], *known, *length),
        Form::LinkToSlide {
            slide,
            guide,
            known,
            length,
        } => rssp::rssp(algebra, group, *slide, *guide, *known, *length),
        Form::Point {
            coordinates,
            spheres,
            planes,
        } => point::point(algebra, group, coordinates, spheres, planes),
        Form::ThreeSlides {
            slides,
            guides,
            known,
        } => three_slides::three_slides(algebra, group, *slides, *guides, *known),
        Form::Relation { angle, value } => scalar::relation(algebra, *angle, value),
        Form::Parallel { angle, value, arm } => {
            parallel_angle::parallel_angle(algebra, group, *angle, value, *arm)
        }
        Form::Coupled(coupled) => {
            let (closed, prepared) = coupled::coupled(algebra, group, coupled);
            return (closed, Some(prepared));
        }
    };
    (closed, None)
}
