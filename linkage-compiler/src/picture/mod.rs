//! What a mechanism looks like: which points its links join, and where something slides.
//!
//! The loops tell most of it. Sums of vectors are chains of points, a distance is a rod; whether two points belong to one
//! link is then a matter of numbers: at several positions of the input their distance must be the same. So it does not
//! matter how a loop is written, and a link that is drawn never stretches.
//!
//! | file | what |
//! |---|---|
//! | `roles` | is a named vector a point, or a step from one to another? |
//! | `chains` | sums of vectors as chains of points |
//! | `marks` | points and steps of a sketch |
//! | `starts` | points that chains begin with |
//! | `frames` | parts that stand elsewhere |
//! | `terms` | sums of vectors, term by term |
//! | `literals`, `parts` | literals and turned sums, taken apart |
//! | `titles` | what points and links are called in the program |
//! | `loops`, `bodies` | what loops, bodies and joints are made of |
//! | `planes` | lines and planes that are scalar products |
//! | `seen` | the points at several positions and with other dimensions |
//! | `free` | the points where nothing closes the loops |
//! | `cells` | which points may coincide |
//! | `links` | points that keep their distances |
//! | `joining` | links that are one |
//! | `by_point` | what meets in a point |
//! | `welded` | which of them are written as one link |
//! | `guides` | lines along which points slide, and what carries them |
//! | `drives` | what inputs move, and wheels |
//! | `joints` | what meets in points, and how it moves against each other |
//! | `owners` | which part of a machine everything belongs to |
//! | `names` | names for points and links that the program does not name |
//! | `check` | links that the user added must be rigid |

pub(crate) mod bodies;
pub(crate) mod by_point;
pub(crate) mod cells;
pub(crate) mod chains;
pub(crate) mod check;
pub(crate) mod drives;
pub(crate) mod frames;
pub(crate) mod guides;
pub(crate) mod joining;
pub(crate) mod joints;
pub(crate) mod links;
pub(crate) mod literals;
pub(crate) mod loops;
pub(crate) mod marks;
pub(crate) mod names;
pub(crate) mod open_loop;
pub(crate) mod ownership;
pub(crate) mod parts;
pub(crate) mod planes;
pub(crate) mod point_or_vector;
pub(crate) mod rigid_bodies;
pub(crate) mod samples;
pub(crate) mod starts;
pub(crate) mod terms;
#[cfg(test)]
mod tests;
pub(crate) mod titles;
pub(crate) mod views;

use linkage_symbolic::Vn;
use linkage_symbolic::lookup::Set;

use crate::algebra::{Algebra, Nominal};
use crate::diagnostic::Reporter;
use crate::ir::Picture;
use crate::machine::Reference;
use crate::model::{AskedPicture, Expr, Type};

use chains::Sketch;
use guides::Guides;
use links::Links;
use ownership::Owners;
use samples::Seen;

/// What is drawn, and the vectors that say where it is: points first, then directions.
#[derive(Clone, Debug, Default)]
pub(crate) struct Found<'m> {
    pub(crate) picture: Picture,
    pub(crate) vectors: Vec<Vn<'m>>,
}

/// The picture of a mechanism that closes.
pub(crate) fn find<'m>(
    algebra: &mut Algebra<'m>,
    reference: &Reference,
    nominal: &Nominal,
    asked: AskedPicture<'m>,
    reporter: &mut Reporter,
) -> Found<'m> {
    let dimension = dimension(algebra, asked.links);
    let mut sketch = Sketch::new(algebra, dimension);
    loops::collect(&mut sketch);
    loops::add_lists(&mut sketch, asked.links);
    let mut seen = Seen::new(sketch.algebra, &sketch.points, reference, nominal);
    if seen.places() < 2 && !sketch.algebra.mechanism.inputs.is_empty() {
        reporter.error_with_help(
            asked.origin,
            "links cannot be told from what stretches: the mechanism closes at none of the other positions looked at",
            "check the ranges of the inputs",
        );
        return Found::default();
    }
    check::check_lists(&sketch, &seen, reporter);
    let owners = Owners::new(&sketch, &seen);
    let mut links = Links::find(&sketch, &seen, &owners);
    let guides = Guides::find(&mut sketch, &mut seen, &links);
    let axes = sketch.axes.iter().map(|(at, _)| seen.same[*at]);
    let needed = axes.chain(guides.ends());
    let needed: Set<usize> = needed.collect();
    links.drop_corners(|point| {
        let mut own = seen.aliases(point);
        own.any(|own| sketch.points[own].wanted) || seen.is_fixed(point) || needed.contains(&point)
    });
    if links.all.is_empty() && guides.all.is_empty() {
        reporter.error_with_help(
            asked.origin,
            "there is nothing to draw: the loops tell of no link",
            "name the points that links join: `picture([a, b], [b, c, d])`",
        );
    }
    let mut found = names::named(&sketch, &seen, &links, &guides, &owners);
    // Who lists links tells of what loops do not.
    if asked.links.is_empty() {
        found.picture.undrawn = sketch.undrawn;
    }
    check::warn_of_undrawn_loops(&found.picture, asked.origin, reporter);
    check::warn_of_loose_points(&found.picture, asked.origin, reporter);
    found
}

/// 3 if loops, joints or lists lie in space; without loops, if anything does.
fn dimension(algebra: &Algebra, lists: &[Vec<Expr>]) -> usize {
    let mechanism = algebra.mechanism;
    let sides = || {
        mechanism
            .loops
            .iter()
            .flat_map(|own| [&own.left, &own.right])
    };
    let joints = mechanism.joints.iter().map(|own| &own.at);
    let lets = || mechanism.lets.iter().map(|own| &own.value);
    let fixed = |count: usize| sides().any(|side| has_vector(side, count));
    let mut places = mechanism.placed.iter().filter_map(|own| own.at.as_ref());
    let in_space = fixed(3)
        || places.any(|at| has_vector(at, 3))
        || joints
            .chain(lists.iter().flatten())
            .any(|own| has_vector(own, 3));
    match in_space || !fixed(2) && lets().any(|own| has_vector(own, 3)) {
        true => 3,
        false => 2,
    }
}

/// Whether there is a vector of so many components in an expression.
fn has_vector(expr: &Expr, count: usize) -> bool {
    expr.parts().any(|part| match part.ty {
        Type::Vector(components, _) => components == count,
        Type::Frame => count == 3,
        Type::PlaneFrame => count == 2,
        Type::Scalar(_) | Type::Array(_) | Type::Zero(_) | Type::Error => false,
    })
}
