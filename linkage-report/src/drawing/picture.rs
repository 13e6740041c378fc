//! The picture of a mechanism at one position.

use super::options::Drawing;
use super::sheet::Sheet;
use super::{arc_slots, arrows, caption, fixed, legend, marks, names, parts, rows, signs, wheels};
use linkage_formats::svg::{Element, Svg};

/// The drawing at a row; plates have the corners that they have at the row `form`.
pub(super) fn picture_at(drawing: &Drawing<'_>, row: usize, form: usize) -> Svg {
    let sheet = Sheet::new(drawing);
    let [width, height] = sheet.size;
    let mut svg = Svg::new(width, height, "mm", &drawing.report.title);
    if drawing.ghosts > 0 {
        svg.group(
            Element::new("g").class("ghosts").number("opacity", 0.45),
            |svg| {
                for ghost in rows::even_rows(drawing, drawing.ghosts) {
                    parts::ghost(drawing, svg, &sheet, ghost);
                }
            },
        );
    }
    fixed::axes(drawing, &mut svg, &sheet, row);
    wheels::wheels(drawing, &mut svg, &sheet, row);
    arc_slots::on_frame(drawing, &mut svg, &sheet, row);
    parts::links(drawing, &mut svg, &sheet, row, form);
    // In front of plates, which would hide them.
    fixed::pivots(drawing, &mut svg, &sheet, row);
    for guide in drawing.shown.picture.guides {
        fixed::frame_guide(drawing, &mut svg, &sheet, guide, row);
    }
    signs::cylinders(drawing, &mut svg, &sheet, row);
    parts::sliders(drawing, &mut svg, &sheet, row);
    for &point in &drawing.traces {
        fixed::path(drawing, &mut svg, &sheet, point, drawing.point_hue(point));
    }
    marks::even_points(drawing, &mut svg, &sheet);
    if drawing.seconds.is_none() {
        marks::ellipses(drawing, &mut svg, &sheet, row);
    }
    signs::joint_signs(drawing, &mut svg, &sheet, row);
    parts::points(drawing, &mut svg, &sheet, row);
    if drawing.seconds.is_none() {
        of_one_position(drawing, &mut svg, &sheet, row);
    }
    caption::caption(drawing, &mut svg, &sheet, row);
    legend::legend(drawing, &mut svg, &sheet);
    svg
}

/// Draws the words and arrows of this position, which would jump if the drawing moved.
fn of_one_position(drawing: &Drawing<'_>, svg: &mut Svg, sheet: &Sheet<'_>, row: usize) {
    arrows::drives(drawing, svg, sheet, row);
    marks::dimension_lines(drawing, svg, sheet, row);
    arrows::vectors(drawing, svg, sheet, row);
    if drawing.names {
        names::point_names(drawing, svg, sheet, row);
    }
}
