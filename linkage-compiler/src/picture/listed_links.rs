//! Links that are listed by their points: those that `picture` lists, and those of a text with joints
//! and links. Such a text also has straight slots and wheels.

use crate::algebra::Algebra;
use crate::model::{Expr, PairedWheel};
use crate::picture::layout::Layout;
use crate::picture::marks::{Asked, NamedLink, Slot, WheelPair};
use crate::picture::sketch::Sketch;
use crate::picture::statement::Statement;
use crate::picture::{chains, layout, sketch, titles};

/// Adds the links that `picture` lists.
pub(super) fn add_lists<'m>(
    algebra: &mut Algebra<'m>,
    layout: &Layout<'m>,
    sketch: &mut Sketch<'m>,
    lists: &'m [Vec<Expr>],
) {
    for list in lists {
        let points = points(algebra, layout, sketch, list);
        let origin = list[0].origin;
        sketch.asked.push(Asked { points, origin });
    }
}

/// Adds the links, straight slots and wheels that the text has.
pub(super) fn add_links<'m>(
    algebra: &mut Algebra<'m>,
    layout: &Layout<'m>,
    sketch: &mut Sketch<'m>,
) {
    let elements = &algebra.mechanism.link_elements;
    for link in &elements.links {
        let points = points(algebra, layout, sketch, &link.joints);
        let name = link.name.clone();
        sketch.named_links.push(NamedLink { name, points });
    }
    for slot in &elements.slots {
        let [slider, start] =
            [&slot.slider, &slot.start].map(|end| point(algebra, layout, sketch, end));
        sketch.slots.push(Slot {
            name: slot.name.clone(),
            slider,
            start,
            direction: layout::vector(algebra, layout.dimension, &slot.direction),
        });
    }
    // In space, wheels may lie in any plane.
    for pair in elements.pairs.iter().filter(|_| layout.dimension == 2) {
        let [first, second] = &pair.wheels;
        let centres = [first, second].map(|wheel| point(algebra, layout, sketch, &wheel.centre));
        let mut direction = |wheel: &PairedWheel| {
            let direction = wheel.direction.as_ref();
            direction.map(|vector| layout::vector(algebra, layout.dimension, vector))
        };
        let directions = [first, second].map(&mut direction);
        sketch.wheels.push(WheelPair {
            centres,
            directions,
            touch: pair.touch,
        });
    }
}

fn points<'m>(
    algebra: &mut Algebra<'m>,
    layout: &Layout<'m>,
    sketch: &mut Sketch<'m>,
    list: &'m [Expr],
) -> Vec<usize> {
    let points = list.iter();
    points
        .map(|expr| point(algebra, layout, sketch, expr))
        .collect()
}

/// Returns the number of a point that has the name of its expression.
fn point<'m>(
    algebra: &mut Algebra<'m>,
    layout: &Layout<'m>,
    sketch: &mut Sketch<'m>,
    expr: &'m Expr,
) -> usize {
    let at = layout::vector(algebra, layout.dimension, expr);
    let found = chains::point_of(algebra, layout, sketch, Statement::default(), expr);
    let point = sketch::point(algebra, layout, &mut sketch.points, &[], at);
    titles::name(algebra.mechanism, &mut sketch.points[point], 0, expr);
    sketch.points[point].wanted = true;
    found.unwrap_or(point)
}
