//! The diagram of bars.

use std::format;
use std::string::String;

use super::text::word;
use crate::cyclogram::{Cyclogram, Member, Motion};
use linkage_formats::colour::Colour;
use linkage_formats::svg::{Element, Svg};
use linkage_formats::ticks::Scale;

const WIDTH: f64 = 960.0;
const TOP: f64 = 18.0;
const RIGHT: f64 = 28.0;
/// Height of the stroke in a row.
const STROKE: f64 = 44.0;
/// Height of a row: the stroke, and the angles below it.
const ROW: f64 = STROKE + 34.0;
/// Average width of a character of 12 pixels, rather too wide: fonts differ.
const CHARACTER: f64 = 7.2;
/// Angles at the line, `123.45`, need so much room.
const ANGLE: f64 = 46.0;

/// Positions in the diagram.
struct Places {
    left: f64,
    scale: Scale,
    bottom: f64,
}

impl Places {
    fn x(&self, angle: f64) -> f64 {
        self.left + self.scale.part(angle.to_degrees()) * (WIDTH - RIGHT - self.left)
    }
}

/// Returns the diagram as SVG, with the number of the colour of each member.
pub fn drawn(cyclogram: &Cyclogram, hues: &[usize]) -> String {
    let organs = cyclogram.members();
    let (low, high) = cyclogram.range();
    let names = organs.iter().map(|organ| organ.name().chars().count());
    let places = Places {
        left: (28.0 + CHARACTER * names.max().unwrap_or(0) as f64).max(64.0),
        scale: Scale::degrees(low.to_degrees(), high.to_degrees(), 12),
        bottom: TOP + ROW * organs.len() as f64,
    };
    let names: String = organs
        .iter()
        .map(|organ| format!(", {}", organ.name()))
        .collect();
    let mut svg = Svg::new(
        WIDTH,
        places.bottom + 46.0,
        "",
        &format!("Cyclogram{names}"),
    );
    grid(&mut svg, &places, cyclogram.range());
    for (index, (organ, &hue)) in organs.iter().zip(hues).enumerate() {
        let group = Element::new("g")
            .class("organ")
            .set("data-name", organ.name());
        svg.group(group, |svg| {
            row(svg, &places, organ, hue, TOP + ROW * index as f64);
        });
    }
    svg.finish()
}

fn grid(svg: &mut Svg, places: &Places, range: (f64, f64)) {
    let [left, right] = [places.left, WIDTH - RIGHT];
    for &tick in &places.scale.ticks {
        let x = places.x(tick.to_radians());
        svg.add(Element::line([x, TOP - 6.0], [x, places.bottom]).stroke(Colour::Grid, 1.0));
        svg.add(
            Element::line([x, places.bottom], [x, places.bottom + 5.0]).stroke(Colour::Frame, 1.0),
        );
        let words = Element::text([x, places.bottom + 19.0], 12.0).anchor("middle");
        svg.words(
            words.class("tick").fill(Colour::Ink),
            &places.scale.label(tick),
        );
    }
    // With the angles of its ends, so that a page knows where an angle is.
    let axis = Element::line([left, places.bottom], [right, places.bottom]).class("shaft");
    let axis = axis.set("data-from", range.0).set("data-to", range.1);
    svg.add(axis.stroke(Colour::Frame, 1.0));
    let title = Element::text([0.5 * (left + right), places.bottom + 39.0], 13.0);
    svg.words(
        title.anchor("middle").class("axis").fill(Colour::Ink),
        "shaft [deg]",
    );
}

fn row(svg: &mut Svg, places: &Places, organ: &Member, hue: usize, top: f64) {
    let name = Element::text([places.left - 12.0, top + 0.5 * STROKE + 4.0], 13.0);
    svg.words(
        name.anchor("end").class("name").fill(Colour::Ink),
        organ.name(),
    );
    let [lowest, highest] = organ.limits();
    let height = |value: f64| top + STROKE * (highest - value) / (highest - lowest);
    for (event, (motion, interval)) in organ.intervals().enumerate() {
        let next = (event + 1) % organ.events().len();
        let ends = [event, next].map(|event| height(organ.events()[event].value));
        for (span, levels) in pieces(organ, interval.from, interval.range, ends) {
            stretch(
                svg,
                [span.map(|angle| places.x(angle)), levels],
                motion,
                hue,
                top,
            );
        }
    }
    let mut free = f64::NEG_INFINITY;
    for event in organ.events() {
        let (x, y) = (places.x(event.at), height(event.value));
        let line = Element::line([x, y], [x, top + STROKE + 7.0]);
        svg.add(
            line.stroke(Colour::Frame, 0.8)
                .set("stroke-dasharray", "2.5 3"),
        );
        svg.add(Element::circle([x, y], 2.2).fill(Colour::line_of(hue)));
        // Angles that have no room stand in the tables.
        if x - free >= ANGLE {
            let words = Element::text([x, top + STROKE + 19.0], 11.0).anchor("middle");
            let angle = format!("{:.2}", event.at.to_degrees());
            svg.words(words.class("angle").fill(Colour::Muted), &angle);
            free = x;
        }
    }
}

/// An interval as it is drawn, angles with levels: in two pieces if it goes across the seam.
fn pieces(
    organ: &Member,
    from: f64,
    range: f64,
    [a, b]: [f64; 2],
) -> impl Iterator<Item = ([f64; 2], [f64; 2])> {
    let (low, high) = organ.range();
    let to = from + range;
    let over = to > high;
    let seam = a + (b - a) * (high - from) / range;
    let first = if over {
        ([from, high], [a, seam])
    } else {
        ([from, to], [a, b])
    };
    let second = ([low, to - (high - low)], [seam, b]);
    [Some(first), over.then_some(second)].into_iter().flatten()
}

/// Draws one piece of an interval: its bar if it is a dwell, its line, and its motion.
fn stretch(
    svg: &mut Svg,
    [[left, right], levels]: [[f64; 2]; 2],
    motion: Motion,
    hue: usize,
    top: f64,
) {
    let dwell = motion.is_dwell();
    if dwell {
        let bar = Element::new("rect").class("dwell");
        let bar = bar
            .number("x", left)
            .number("y", top)
            .number("width", right - left);
        svg.add(bar.number("height", STROKE).fill(Colour::Link(hue)));
    }
    let line = Element::polyline([[left, levels[0]], [right, levels[1]]]);
    svg.add(line.stroke(Colour::line_of(hue), if dwell { 2.6 } else { 1.8 }));
    let word = word(motion);
    if dwell && right - left > CHARACTER * word.len() as f64 + 8.0 {
        // On the side of the line where there is room.
        let low = 0.5 * (levels[0] + levels[1]) > top + 0.5 * STROKE;
        let y = if low { top + 15.0 } else { top + STROKE - 8.0 };
        let words = Element::text([0.5 * (left + right), y], 12.0).anchor("middle");
        svg.words(words.class("motion").fill(Colour::Ink), word);
    }
}
