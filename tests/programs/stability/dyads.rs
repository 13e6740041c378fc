//! The three dyads with a square root, random geometries of them, and ways to solve them.

use super::textbook;
use super::{ROD_AND_GUIDE, TURNING_GUIDE, TWO_LINKS};
use core::f64::consts::FRAC_PI_2;
use linkage_reference::{Random, System};

include!("../../../mechanisms/stability.rs");

/// A way to compute the outputs of a dyad from its data; NaN where it sees no assembly.
pub(crate) type Method = fn(&[f64]) -> Vec<f64>;

/// A dyad, random geometries of it and ways to solve it.
pub(crate) struct Dyad {
    pub(crate) title: &'static str,
    pub(crate) system: &'static System,
    /// A random geometry in the assembly mode of the mechanism as written.
    pub(crate) geometry: fn(&mut Random) -> Vec<f64>,
    /// The datum to change until the dead point is near, and the factor by which it may change.
    pub(crate) towards_dead_point: (usize, f64),
    /// The generated code first.
    pub(crate) methods: &'static [(&'static str, Method)],
    /// The methods that lose digits or find no assembly where there is one.
    pub(crate) failing: &'static [&'static str],
}

const GENERATED: &str = "linkage";
const EXPANDED: &str = "expanded discriminant";
const TANGENT: &str = "half-angle tangent";
const ARC: &str = "arc cosine";

const ALL: &[&str] = &[EXPANDED, TANGENT, ARC];

pub(crate) const DYADS: [Dyad; 6] = [
    two_links(
        "RRR, links of like lengths",
        |random| links(random, 1.0),
        &[],
    ),
    two_links(
        "RRR, needle: one link 1e5 times shorter",
        |random| links(random, 1e-5),
        ALL,
    ),
    rod_and_guide(
        "RRP, rod and slide of like lengths",
        |random| rod(random, 1.0),
        &[],
    ),
    rod_and_guide(
        "RRP, needle: rod 1e5 times shorter than the slide",
        |random| rod(random, 1e-5),
        ALL,
    ),
    turning_guide(
        "RPR, offset square to the line",
        |random| guide(random, 1.0, FRAC_PI_2),
        &[],
    ),
    turning_guide(
        "RPR, needle: offset of 1e5 reaches along the line",
        |random| guide(random, 1e5, 1e-5),
        &[EXPANDED],
    ),
];

const fn two_links(
    title: &'static str,
    geometry: fn(&mut Random) -> Vec<f64>,
    failing: &'static [&'static str],
) -> Dyad {
    Dyad {
        title,
        system: &TWO_LINKS,
        geometry,
        failing,
        towards_dead_point: (0, 40.0),
        methods: &[
            (GENERATED, |data| {
                let &[left, right, x, y] = data else {
                    return Vec::new();
                };
                let found = TwoLinks { left, right, x }
                    .assemblies_at(y)
                    .unwrap_or_default();
                let Some(linkage) = found.first() else {
                    return vec![f64::NAN; 4];
                };
                let place = linkage.place(y);
                vec![place.theta, place.psi, place.pin.x, place.pin.y]
            }),
            (EXPANDED, textbook::expanded_links),
            (TANGENT, textbook::tangent_links),
            (ARC, textbook::arc_links),
        ],
    }
}

const fn rod_and_guide(
    title: &'static str,
    geometry: fn(&mut Random) -> Vec<f64>,
    failing: &'static [&'static str],
) -> Dyad {
    Dyad {
        title,
        system: &ROD_AND_GUIDE,
        geometry,
        failing,
        towards_dead_point: (0, 1e-3),
        methods: &[
            (GENERATED, |data| {
                let &[rod, gamma, x, y] = data else {
                    return Vec::new();
                };
                let found = RodAndGuide { rod, gamma, x }
                    .assemblies_at(y)
                    .unwrap_or_default();
                let Some(linkage) = found.first() else {
                    return vec![f64::NAN; 2];
                };
                let place = linkage.place(y);
                vec![place.theta, place.s]
            }),
            (EXPANDED, textbook::expanded_rod),
            (TANGENT, textbook::tangent_rod),
            (ARC, textbook::arc_rod),
        ],
    }
}

const fn turning_guide(
    title: &'static str,
    geometry: fn(&mut Random) -> Vec<f64>,
    failing: &'static [&'static str],
) -> Dyad {
    Dyad {
        title,
        system: &TURNING_GUIDE,
        geometry,
        failing,
        towards_dead_point: (0, 1e6),
        methods: &[
            (GENERATED, |data| {
                let &[offset, beta, x, y] = data else {
                    return Vec::new();
                };
                let found = TurningGuide { offset, beta, x }
                    .assemblies_at(y)
                    .unwrap_or_default();
                let Some(linkage) = found.first() else {
                    return vec![f64::NAN; 4];
                };
                let place = linkage.place(y);
                vec![place.psi, place.s, place.corner.x, place.corner.y]
            }),
            (EXPANDED, textbook::expanded_guide),
            (TANGENT, textbook::tangent_guide),
            (ARC, textbook::arc_guide),
        ],
    }
}

fn links(random: &mut Random, ratio: f64) -> Vec<f64> {
    let [left, right] = [1.0, ratio].map(|factor| factor * random.length(4.0).abs());
    let theta = random.angle();
    let psi = theta + random.between(0.05, 3.1);
    let x = left * theta.cos() - right * psi.cos();
    let y = left * theta.sin() - right * psi.sin();
    vec![left, right, x, y]
}

fn rod(random: &mut Random, ratio: f64) -> Vec<f64> {
    let [rod, s] = [ratio, 1.0].map(|factor| factor * random.length(4.0).abs());
    let gamma = random.angle();
    let theta = gamma + random.between(-1.5, 1.5);
    let x = s * gamma.cos() - rod * theta.cos();
    let y = s * gamma.sin() - rod * theta.sin();
    vec![rod, gamma, x, y]
}

fn guide(random: &mut Random, ratio: f64, beta: f64) -> Vec<f64> {
    let offset = ratio * random.length(4.0).abs();
    let beta = beta * random.between(0.5, 1.5);
    let psi = random.angle();
    let s = random.length(4.0).abs() - offset * beta.cos();
    let x = s * psi.cos() + offset * (psi + beta).cos();
    let y = s * psi.sin() + offset * (psi + beta).sin();
    vec![offset, beta, x, y]
}
