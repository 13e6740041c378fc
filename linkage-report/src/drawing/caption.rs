//! Title, scale bar, and which position it is.

use std::format;
use std::string::String;
use std::vec::Vec;

use super::options::Drawing;
use super::sheet::Sheet;
use super::vector::head;
use crate::positioned_picture::told_of_missing;
use linkage_core::format::rounded;
use linkage_formats::colour::Colour;
use linkage_formats::svg::{Element, Svg};

/// Length of the signs of axes; one that is seen shorter than this share has no head.
pub(super) const SIGN: f64 = 7.0;
const SEEN: f64 = 0.4;

/// Height of the words below the drawing.
pub(super) const FOOT: f64 = 11.0;
/// Height of the title, and of a line of notes below it.
const TITLE: f64 = 10.5;
const NOTE: f64 = 4.5;

/// The scale bar is about this long on paper.
const LENGTH: f64 = 30.0;

/// Returns the height of title and notes.
pub(super) fn title_end(drawing: &Drawing<'_>) -> f64 {
    TITLE + NOTE * notes(drawing).len() as f64
}

/// Returns the notes about the mechanism below the title.
fn notes(drawing: &Drawing<'_>) -> Vec<String> {
    let rows = 0..drawing.report.positions.len();
    let missing = rows.filter(|row| !drawing.shown.is_assembled(*row)).count();
    let missing = (missing > 0).then(|| {
        format!(
            "It cannot be assembled at {missing} of {} positions.",
            drawing.report.positions.len()
        )
    });
    let undrawn = told_of_missing(drawing.shown.picture);
    missing.into_iter().chain(undrawn).collect()
}

pub(super) fn caption(drawing: &Drawing<'_>, svg: &mut Svg, sheet: &Sheet<'_>, row: usize) {
    let [width, height] = sheet.size;
    let title = Element::text([6.0, 9.0], 4.4).set("font-weight", 600);
    svg.words(title.fill(Colour::Ink), &drawing.report.title);
    for (line, words) in notes(drawing).iter().enumerate() {
        let note = Element::text([6.0, 14.0 + NOTE * line as f64], 3.2).class("note");
        svg.words(note.fill(Colour::Muted), words);
    }
    if let Some(axes) = sheet.axes() {
        axis_sign(svg, sign_at(width), axes);
    }
    scale_bar(drawing, svg, sheet, [6.0, height - 6.0]);
    let at = [width - 6.0, height - 6.0];
    let words = Element::text(at, 3.2).anchor("end").class("caption");
    svg.words(words.fill(Colour::Muted), &described(drawing, sheet, row));
}

fn described(drawing: &Drawing<'_>, sheet: &Sheet<'_>, row: usize) -> String {
    let input = &drawing.report.input;
    let input_text = |row: usize| {
        let at = drawing.report.positions[row];
        rounded(match input.unit {
            "rad" => at.to_degrees(),
            _ => at,
        })
    };
    let unit = match input.unit {
        "rad" => "deg",
        unit => unit,
    };
    let enlarged = drawing.enlarged.map_or_else(String::new, |times| {
        format!(", tolerances enlarged {} times", rounded(times))
    });
    let at = match drawing.seconds {
        Some(_) => format!(
            "from {} to {}",
            input_text(0),
            input_text(drawing.report.positions.len() - 1)
        ),
        None => format!("= {}", input_text(row)),
    };
    let position = format!("{} {at} {unit}{enlarged}", input.name);
    if sheet.axes().is_some() {
        // A foreshortened picture has no scale.
        return position;
    }
    let scale = match sheet.scale {
        scale if scale < 1.0 => format!("1:{}", rounded(1.0 / scale)),
        scale => format!("{}:1", rounded(scale)),
    };
    format!("{position}, scale {scale}")
}

/// A round length of the mechanism with its number.
fn scale_bar(drawing: &Drawing<'_>, svg: &mut Svg, sheet: &Sheet<'_>, [left, bottom]: [f64; 2]) {
    let wanted = LENGTH / sheet.factor;
    let power = 10f64.powf(wanted.log10().floor());
    let round = [5.0, 2.0, 1.0].map(|digit| digit * power);
    let length = round
        .into_iter()
        .find(|length| *length <= wanted)
        .unwrap_or(power);
    let right = left + length * sheet.factor;
    svg.group(Element::new("g").class("scale"), |svg| {
        svg.add(Element::line([left, bottom], [right, bottom]).stroke(Colour::Ink, 0.4));
        for end in [left, right] {
            let tick = Element::line([end, bottom - 1.2], [end, bottom + 1.2]);
            svg.add(tick.stroke(Colour::Ink, 0.4));
        }
        let words = Element::text([0.5 * (left + right), bottom - 1.6], 3.2).anchor("middle");
        let length = format!("{} {}", rounded(length), drawing.shown.unit);
        svg.words(words.fill(Colour::Ink), &length);
        if sheet.axes().is_some() {
            let at = [right + 3.0, bottom + 1.1];
            let words = Element::text(at, 2.9).fill(Colour::Muted);
            svg.words(words, "across the line of sight");
        }
    });
}

/// The middle of the sign of the axes.
pub(super) fn sign_at(width: f64) -> [f64; 2] {
    [width - 16.0, 16.0]
}

/// Draws the directions of the axes of space.
fn axis_sign(svg: &mut Svg, at: [f64; 2], axes: [[f64; 2]; 3]) {
    svg.group(Element::new("g").class("axes"), |svg| {
        for (name, [x, y]) in ["x", "y", "z"].into_iter().zip(axes) {
            let end = |length: f64| [at[0] + length * x, at[1] + length * y];
            svg.add(Element::line(at, end(SIGN)).stroke(Colour::Muted, 0.4));
            if x.hypot(y) > SEEN {
                head(svg, at, end(SIGN), Colour::Muted);
            }
            let [left, below] = end(SIGN + 2.4);
            let words = Element::text([left, below + 1.0], 2.9).anchor("middle");
            svg.words(words.fill(Colour::Muted), name);
        }
    });
}
