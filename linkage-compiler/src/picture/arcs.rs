//! Curved slots that the program declares.

use crate::algebra::Algebra;
use crate::picture::layout::Layout;
use crate::picture::marks::Arc;
use crate::picture::sketch::Sketch;
use crate::picture::statement::Statement;
use crate::picture::{chains, layout};

/// Adds the points of all arcs. In space they have none: the plane of an arc is not known there.
pub(super) fn look_at_arcs<'m>(
    algebra: &mut Algebra<'m>,
    layout: &Layout<'m>,
    sketch: &mut Sketch<'m>,
) {
    let mechanism = algebra.mechanism;
    for arc in mechanism.arcs.iter().filter(|_| layout.dimension == 2) {
        let ends = [&arc.slider, &arc.centre];
        let statement = Statement::default();
        let ends = ends.map(|end| chains::point_of(algebra, layout, sketch, statement, end));
        if let [Some(slider), Some(centre)] = ends {
            sketch.arcs.push(Arc {
                name: arc.name.clone(),
                slider,
                centre,
                direction: layout::vector(algebra, layout.dimension, &arc.direction),
            });
        }
    }
}
