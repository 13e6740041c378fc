//! Title, scale bar, and which position it is.

use std::format;
use std::string::String;
use std::vec::Vec;

use super::Drawing;
use super::arrows::head;
use super::sheet::Sheet;
use crate::format::rounded;
use crate::report::colour::Colour;
use crate::report::shown::told_of_missing;
use crate::report::svg::{Element, Svg};

/// Length of the signs of axes; one that is seen shorter than this share has no head.
pub(super) const SIGN: f64 = 7.0;
const SEEN: f64 = 0.4;

/// What the words below the drawing take of the sheet.
pub(super) const FOOT: f64 = 11.0;
/// Where the title ends, and lines of notes below it.
const TITLE: f64 = 10.5;
const NOTE: f64 = 4.5;

/// The scale bar is about this long on paper.
const LENGTH: f64 = 30.0;

impl Drawing<'_> {
    /// Where title and notes end.
    pub(super) fn head(&self) -> f64 {
        TITLE + NOTE * self.notes().len() as f64
    }

    /// What is to be said of the mechanism below the title.
    fn notes(&self) -> Vec<String> {
        let rows = 0..self.report.positions.len();
        let missing = rows.filter(|row| !self.shown.is_assembled(*row)).count();
        let missing = (missing > 0).then(|| {
            format!(
                "It cannot be assembled at {missing} of {} positions.",
                self.report.positions.len()
            )
        });
        let undrawn = told_of_missing(self.shown.picture);
        missing.into_iter().chain(undrawn).collect()
    }

    pub(super) fn caption(&self, svg: &mut Svg, sheet: &Sheet<'_>, row: usize) {
        let [width, height] = sheet.size;
        let title = Element::text([6.0, 9.0], 4.4).set("font-weight", 600);
        svg.words(title.fill(Colour::Ink), &self.report.title);
        for (line, words) in self.notes().iter().enumerate() {
            let note = Element::text([6.0, 14.0 + NOTE * line as f64], 3.2).class("note");
            svg.words(note.fill(Colour::Muted), words);
        }
        if let Some(axes) = sheet.axes() {
            axis_sign(svg, sign_at(width), axes);
        }
        self.scale_bar(svg, sheet, [6.0, height - 6.0]);
        let at = [width - 6.0, height - 6.0];
        let words = Element::text(at, 3.2).anchor("end").class("caption");
        svg.words(words.fill(Colour::Muted), &self.described(sheet, row));
    }

    fn described(&self, sheet: &Sheet<'_>, row: usize) -> String {
        let input = &self.report.input;
        let told = |row: usize| {
            let at = self.report.positions[row];
            rounded(match input.unit {
                "rad" => at.to_degrees(),
                _ => at,
            })
        };
        let unit = match input.unit {
            "rad" => "deg",
            unit => unit,
        };
        let enlarged = self.enlarged.map_or_else(String::new, |times| {
            format!(", tolerances enlarged {} times", rounded(times))
        });
        let at = match self.seconds {
            Some(_) => format!(
                "from {} to {}",
                told(0),
                told(self.report.positions.len() - 1)
            ),
            None => format!("= {}", told(row)),
        };
        let position = format!("{} {at} {unit}{enlarged}", input.name);
        if sheet.axes().is_some() {
            // What is foreshortened has no scale.
            return position;
        }
        let scale = match sheet.scale {
            scale if scale < 1.0 => format!("1:{}", rounded(1.0 / scale)),
            scale => format!("{}:1", rounded(scale)),
        };
        format!("{position}, scale {scale}")
    }

    /// A round length of the mechanism with its number.
    fn scale_bar(&self, svg: &mut Svg, sheet: &Sheet<'_>, [left, bottom]: [f64; 2]) {
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
            let length = format!("{} {}", rounded(length), self.shown.unit);
            svg.words(words.fill(Colour::Ink), &length);
            if sheet.axes().is_some() {
                let at = [right + 3.0, bottom + 1.1];
                let words = Element::text(at, 2.9).fill(Colour::Muted);
                svg.words(words, "across the line of sight");
            }
        });
    }
}

/// The middle of the sign of the axes.
pub(super) fn sign_at(width: f64) -> [f64; 2] {
    [width - 16.0, 16.0]
}

/// Where the axes of space point.
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
