//! Gears as pitch circles, and belts.

use std::format;
use std::string::String;
use std::vec::Vec;

use super::geometry::moved;
use super::options::Drawing;
use super::pitch_circles::PitchCircles;
use super::sheet::Sheet;
use linkage_core::format::rounded;
use linkage_formats::colour::Colour;
use linkage_formats::svg::{Element, Svg};

/// Distance from the contact of wheels to the middle of their ratio, which is in the larger one, or
/// outside if one is within the other.
const ASIDE: f64 = 8.5;

pub(super) fn wheels(drawing: &Drawing<'_>, svg: &mut Svg, sheet: &Sheet<'_>, row: usize) {
    let picture = drawing.shown.picture;
    for gear in picture.gears.iter().filter(|_| picture.dimension == 2) {
        let centres = gear.centres.map(|centre| sheet.point(centre, row));
        let ([Some(a), Some(b)], Some(wheels)) = (centres, PitchCircles::new(&drawing.shown, gear))
        else {
            continue;
        };
        let radii = wheels.radii.map(|radius| radius * sheet.factor);
        svg.group(Element::new("g").class("gear"), |svg| {
            for (centre, radius) in [a, b].into_iter().zip(radii) {
                let wheel = Element::circle(centre, radius).class("wheel");
                let wheel = wheel.fill(Colour::Gap).number("fill-opacity", 0.5);
                // The sign of a pitch circle.
                svg.add(
                    wheel
                        .stroke(Colour::Muted, 0.35)
                        .set("stroke-dasharray", "4 1 0.8 1"),
                );
            }
            if wheels.belt {
                belt(svg, [a, b], radii);
            }
        });
    }
    for (at, words) in ratios(drawing, sheet, row) {
        let text = Element::text(at, 3.0).anchor("middle").class("ratio");
        let text = text.stroke(Colour::Paper, 0.9).set("paint-order", "stroke");
        svg.words(text.fill(Colour::Muted), &words);
    }
}

/// The ratios of gears, each where its wheels touch.
pub(super) fn ratios(
    drawing: &Drawing<'_>,
    sheet: &Sheet<'_>,
    row: usize,
) -> Vec<([f64; 2], String)> {
    let picture = drawing.shown.picture;
    let gears = picture.gears.iter().filter(|_| picture.dimension == 2);
    let ratios = gears.filter_map(|gear| {
        let [a, b] = gear.centres.map(|centre| sheet.point(centre, row));
        let (a, b) = (a?, b?);
        let wheels = PitchCircles::new(&drawing.shown, gear)?;
        let radii = wheels.radii.map(|radius| radius * sheet.factor);
        let apart = (b[0] - a[0]).hypot(b[1] - a[1]);
        let way = [0, 1].map(|k| (b[k] - a[k]) / apart);
        let larger = (radii[1] - radii[0]).signum();
        let along = match (wheels.belt, wheels.ratio > 0.0) {
            // Between the wheels of a belt there is room.
            (true, _) => radii[0] + 0.5 * (apart - radii[0] - radii[1]),
            (false, false) => radii[0] + ASIDE * larger,
            // Outside of both wheels, one of which is within the other.
            (false, true) => -larger * (radii[0] + ASIDE),
        };
        let at = moved(a, way, along, -1.0);
        Some((at, format!("1 : {}", rounded(wheels.ratio))))
    });
    ratios.collect()
}

/// The two outer tangents of circles.
fn belt(svg: &mut Svg, [a, b]: [[f64; 2]; 2], radii: [f64; 2]) {
    let apart = (b[0] - a[0]).hypot(b[1] - a[1]);
    let way = [0, 1].map(|k| (b[k] - a[k]) / apart);
    let lean = (radii[0] - radii[1]) / apart;
    let across = (1.0 - lean * lean).max(0.0).sqrt();
    for side in [1.0, -1.0] {
        let touch =
            |at: [f64; 2], radius: f64| moved(at, way, radius * lean, side * radius * across);
        let line = Element::line(touch(a, radii[0]), touch(b, radii[1])).class("belt");
        svg.add(line.stroke(Colour::Muted, 0.5));
    }
}
