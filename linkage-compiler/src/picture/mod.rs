//! The picture of a mechanism: the points that its links join, and the guides.
//!
//! Most of it follows from the loops. Sums of vectors are chains of points, a distance is a rod.
//! Two points belong to one link if their distance is the same at several positions of the input.
//! So the form of a loop does not matter, and a link that is drawn never stretches.
//!
//! Files by floor, each of which uses files above it in this table only:
//!
//! | file | content |
//! |---|---|
//! | `point_or_vector` | the names that are points, and those that are steps between points |
//! | `pose` | positions of parts that are placed elsewhere |
//! | `layout` | the parts as they are placed in the drawing |
//! | `statement` | the statement of the program that is drawn |
//! | `marks`, `sketch` | the points and segments that are found |
//! | `expressions`, `weights`, `titles` | facts about expressions, and names of points and links |
//! | `frames` | the coordinates in which names and loops are written |
//! | `parts`, `directions`, `literals`, `terms` | sums of vectors, taken apart into terms |
//! | `chains` | sums of vectors as chains of points |
//! | `listed_links` | links that `picture` or a text with joints and links lists |
//! | `planes`, `arcs`, `bodies`, `loops` | points and segments of loops, arcs, bodies and joints |
//! | `track`, `cells`, `views` | points at several positions and with other dimensions |
//! | `open_loop`, `samples` | the motion without loops, and the points at all positions |
//! | `check` | links that the user added must be rigid |
//! | `raw_link`, `rigid_bodies`, `joining` | links while they are joined |
//! | `ownership`, `links` | parts of a machine, and points that keep their distances |
//! | `candidates`, `guides` | lines and arcs along which points slide, and the links that carry them |
//! | `by_point`, `meeting`, `unique_names` | lists by points, and names that are given once |
//! | `drives`, `declared_gears`, `joints` | links that inputs move, wheels, and joints in points |
//! | `found_picture`, `names` | the picture with names for everything |

mod arcs;
mod bodies;
mod by_point;
mod candidates;
mod cells;
mod chains;
mod check;
mod declared_gears;
mod directions;
mod drives;
mod expressions;
mod found_picture;
mod frames;
mod guides;
mod joining;
mod joints;
mod layout;
mod links;
mod listed_links;
mod literals;
mod loops;
mod marks;
mod meeting;
mod names;
mod open_loop;
mod ownership;
mod parts;
mod planes;
mod point_or_vector;
mod pose;
mod raw_link;
mod rigid_bodies;
mod samples;
mod sketch;
mod statement;
mod terms;
#[cfg(test)]
mod tests;
mod titles;
mod track;
mod unique_names;
mod views;
mod weights;
use linkage_symbolic::lookup::Set;
use linkage_symbolic::{Ex, Vn};

use crate::algebra::{Algebra, Nominal};
use crate::diagnostic::{OriginId, Reporter};
use crate::machine::{AtReference, Reference};
use crate::model::{AskedPicture, Expr, Mechanism, Type};

use guides::Guides;
use layout::Layout;
use links::Links;
use ownership::Ownership;
use samples::Samples;
use sketch::Sketch;

pub(crate) use found_picture::FoundPicture;

/// The picture of a mechanism that closes; without points if no link is found.
pub(crate) fn find<'m>(
    algebra: &mut Algebra<'m>,
    at: AtReference,
    asked: AskedPicture<'m>,
    reporter: &mut Reporter,
) -> FoundPicture<'m> {
    let AtReference {
        reference,
        nominal,
        written,
    } = at;
    let dimension = dimension(algebra.mechanism, asked.links);
    let layout = Layout::new(algebra, dimension);
    let mut sketch = Sketch::default();
    let undrawn = loops::collect(algebra, &layout, &mut sketch);
    listed_links::add_lists(algebra, &layout, &mut sketch, asked.links);
    let mut samples = Samples::new(algebra, &sketch.points, reference, nominal);
    if samples.places() < 2 && !algebra.mechanism.inputs.is_empty() {
        // A refused range has a message already.
        if nominal.ranges == written.ranges {
            warn_of_one_position(algebra.mechanism, asked.origin, reporter);
        }
        return FoundPicture::default();
    }
    check::check_lists(algebra.mechanism, &sketch, &samples, reporter);
    let ownership = Ownership::new(algebra.mechanism, &sketch.points, &samples);
    let mut links = Links::find(algebra.mechanism, dimension, &sketch, &samples, &ownership);
    links.drop_bars_of_arcs(&sketch.arcs, &samples);
    let guides = Guides::find(algebra, &layout, &mut sketch, &mut samples, &links);
    let axes = sketch.axes.iter().map(|(at, _)| samples.same[*at]);
    let needed = axes.chain(guides.ends());
    let needed: Set<usize> = needed.collect();
    links.drop_corners(|point| {
        let mut aliases = samples.aliases(point);
        aliases.any(|alias| sketch.points[alias].wanted)
            || samples.is_fixed(point)
            || needed.contains(&point)
    });
    let mut found = names::named(
        algebra, dimension, &sketch, &samples, &links, &guides, &ownership,
    );
    if found.picture.points.is_empty() {
        reporter.warning_with_help(
            asked.origin,
            "there is nothing to draw: the loops tell of no link; the function of the picture is left out",
            "name the points that links join: `picture([a, b], [b, c, d])`",
        );
    }
    // Who lists links tells of what loops do not.
    if asked.links.is_empty() {
        found.picture.undrawn = undrawn;
    }
    found.picture.reference = at_reference(&found.vectors, reference, nominal);
    check::warn_of_undrawn_loops(&found.picture, asked.origin, reporter);
    check::warn_of_loose_points(&found.picture, asked.origin, reporter);
    found
}

/// Warns of a mechanism that closes at the reference only, where every distance is kept.
fn warn_of_one_position(mechanism: &Mechanism, origin: OriginId, reporter: &mut Reporter) {
    let without_range = mechanism.inputs.iter().find(|input| input.range.is_none());
    reporter.warning_with_help(
        origin,
        "links cannot be told from what stretches: the mechanism closes at none of the other positions looked at; \
         the function of the picture is left out",
        match without_range {
            Some(input) => format!(
                "give the input a range in which the links close: `input {} = ... in LOW..HIGH;`",
                input.name
            ),
            None => "check the ranges of the inputs".to_owned(),
        },
    );
}

/// Returns the components of vectors at the reference inputs.
fn at_reference(vectors: &[Vn], reference: &Reference, nominal: &Nominal) -> Vec<Vec<f64>> {
    let components: Vec<Ex> = vectors.iter().flat_map(|vector| vector.iter()).collect();
    let values = reference.machine.evaluate(&components, &nominal.inputs);
    let tracks = track::divided(&vec![values], vectors);
    tracks.into_iter().flatten().collect()
}

/// Returns 3 if loops, joints or lists lie in space; without loops, if anything does.
fn dimension(mechanism: &Mechanism, lists: &[Vec<Expr>]) -> usize {
    let sides = || {
        mechanism
            .loops
            .iter()
            .flat_map(|equation| [&equation.left, &equation.right])
    };
    let joints = mechanism.joints.iter().map(|joint| &joint.at);
    let lets = || mechanism.lets.iter().map(|item| &item.value);
    let fixed = |count: usize| sides().any(|side| has_vector(side, count));
    let mut places = mechanism
        .placed
        .iter()
        .filter_map(|placed| placed.at.as_ref());
    let in_space = fixed(3)
        || places.any(|at| has_vector(at, 3))
        || joints
            .chain(lists.iter().flatten())
            .any(|expr| has_vector(expr, 3));
    if in_space || !fixed(2) && lets().any(|value| has_vector(value, 3)) {
        3
    } else {
        2
    }
}

/// True if there is a vector of so many components in an expression.
fn has_vector(expr: &Expr, count: usize) -> bool {
    expr.parts().any(|part| match part.ty {
        Type::Vector(components, _) => components == count,
        Type::Frame => count == 3,
        Type::PlaneFrame => count == 2,
        Type::Scalar(_) | Type::Array(_) | Type::Zero(_) | Type::Error => false,
    })
}
