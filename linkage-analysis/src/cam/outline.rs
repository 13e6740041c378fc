//! The profile as a polyline.

use alloc::vec::Vec;
use core::f64::consts::TAU;

use super::contact::Contact;
use super::error::CamError;
use linkage_core::Scalar;

/// Parts of the turn to begin with: a profile has no waves within them that all places which are
/// looked at would miss.
const PARTS: usize = 72;

/// Halvings of a part, at most: then its ends are some hundred roundoffs apart.
const DEPTH: usize = 40;

/// The part of the chord error that checked places may use: between them the error is a little
/// larger.
const TAKEN: f64 = 0.95;

/// A closed line.
#[derive(Clone, Debug, PartialEq)]
pub struct Outline {
    /// Its points, clockwise; from the last one it goes back to the first.
    pub points: Vec<[f64; 2]>,
    /// The pitch curve's points, at the same angles.
    pub pitch: Vec<[f64; 2]>,
    /// The angles of the cam at which it touches these points.
    pub angles: Vec<f64>,
}

/// Checks that a chord error is positive.
pub(super) fn check_chord_error(chord_error: f64) -> Result<(), CamError> {
    if chord_error > 0.0 && chord_error.is_finite() {
        return Ok(());
    }
    let expected = "positive and finite";
    Err(CamError::Invalid {
        what: "chord error",
        value: chord_error,
        expected,
    })
}

/// The profile as a line whose chords stray from it by no more than `chord_error`.
pub(super) fn profile(contact: impl Fn(f64) -> Contact, chord_error: f64) -> Outline {
    let mut outline = Outline {
        points: Vec::new(),
        pitch: Vec::new(),
        angles: Vec::new(),
    };
    // A stack of parts, the next one on top, each with how often it may be halved.
    let part = TAU / PARTS as f64;
    let mut open: Vec<([f64; 2], usize)> = (0..PARTS)
        .rev()
        .map(|k| ([k as f64 * part, (k + 1) as f64 * part], DEPTH))
        .collect();
    while let Some(([low, high], depth)) = open.pop() {
        let [from, to] = [low, high].map(|angle| contact(angle).profile);
        let strays = [0.25, 0.5, 0.75].iter().any(|share| {
            let between = contact(low + share * (high - low)).profile;
            distance(between, from, to) > TAKEN * chord_error
        });
        if strays && depth > 0 {
            let middle = 0.5 * (low + high);
            open.push(([middle, high], depth - 1));
            open.push(([low, middle], depth - 1));
            continue;
        }
        outline.points.push(from);
        outline.pitch.push(contact(low).pitch);
        outline.angles.push(low);
    }
    outline
}

/// The distance of a point from the line between two others.
fn distance(point: [f64; 2], from: [f64; 2], to: [f64; 2]) -> f64 {
    let chord = [to[0] - from[0], to[1] - from[1]];
    let way = [point[0] - from[0], point[1] - from[1]];
    let length = Scalar::hypot(chord[0], chord[1]);
    if length > 0.0 {
        (chord[0] * way[1] - chord[1] * way[0]).abs() / length
    } else {
        Scalar::hypot(way[0], way[1])
    }
}
