//! Both sides of the dead point: values on one, NaN on the other, and no change of mode.

use crate::cases::tried;
use crate::gap::{GAP_ROUNDINGS, gap_uncertainty};
use crate::solve::determinant_at;
use crate::{Big, Form, Plan, ROUNDOFF, Random, System, Variant, approach, default_mode};

/// The determinant of a position is as uncertain as its angles, which are rounded.
const SIGN_ROUNDOFFS: f64 = 32.0;
/// A position that can be assembled may be refused only where changes of so many roundoffs of the
/// data would make it one that cannot.
const REFUSED_ROUNDINGS: f64 = 2.0;

/// What was seen near the dead points of a system. Distances are multiples of what one roundoff in
/// every datum does to the distance from the dead point.
#[derive(Clone, Copy, Debug, Default)]
pub struct Edge {
    /// Positions that can be assembled.
    pub closed: usize,
    /// How many of them are NaN, and the largest distance of one.
    pub refused: (usize, f64),
    /// Positions that cannot be assembled.
    pub open: usize,
    /// How many of them have a value, and the largest distance of one.
    pub forgiven: (usize, f64),
    /// The most negative determinant for the mode, in roundoffs.
    pub against_mode: f64,
}

impl Edge {
    /// Prints what was seen; panics if a position is NaN although it can be assembled or has a value
    /// although it cannot, by more than rounding, or if one has changed its mode.
    pub fn check(&self, name: &str) {
        println!(
            "{name}, both sides of the dead point\n\
             {:>8} can be assembled: {} are NaN, up to {:.1} roundings from the dead point\n\
             {:>8} cannot:           {} have a value, up to {:.1} roundings\n\
             largest determinant of the other mode: {:.2} roundoffs\n",
            self.closed,
            self.refused.0,
            self.refused.1,
            self.open,
            self.forgiven.0,
            self.forgiven.1,
            self.against_mode
        );
        assert!(self.closed > 0 && self.open > self.forgiven.0);
        assert!(self.refused.1 < REFUSED_ROUNDINGS, "{name}");
        assert!(self.forgiven.1 < GAP_ROUNDINGS, "{name}");
        assert!(self.against_mode < SIGN_ROUNDOFFS, "{name}");
    }
}

/// Looks at both sides of the dead points of random geometries, from neighbouring numbers to
/// relative distances of 1e-9, in both modes.
pub fn edge(system: &System, forms: &[Form], plan: &Plan, geometries: usize, seed: u64) -> Edge {
    let mut random = Random::new(seed);
    let mut seen = Edge::default();
    let mode = default_mode(system);
    let input = system.reference_input();
    for _ in 0..tried(geometries) {
        let geometry = (plan.geometry)(&mut random, 4.0);
        for &(changed, factor) in plan.dead_points {
            let Some(last) = approach(system, &geometry, input, changed, factor, 0.0) else {
                continue;
            };
            let outwards = (geometry[changed] * (factor - 1.0)).signum();
            for distance in distances() {
                let mut moved = last.clone();
                moved[changed] += outwards * distance * last[changed].abs() * f64::EPSILON;
                look(system, forms, &moved, mode, &mut seen);
            }
        }
    }
    seen
}

/// Distances from the last number that can be assembled, in units of its last place.
fn distances() -> impl Iterator<Item = f64> {
    let near = (-12..=12).map(f64::from);
    let far = (4..22).flat_map(|power| [-2f64.powi(power), 2f64.powi(power)]);
    near.chain(far)
}

fn look(system: &System, forms: &[Form], geometry: &[f64], mode: f64, seen: &mut Edge) {
    let input = system.reference_input();
    let data: Vec<f64> = geometry.iter().copied().chain([input]).collect();
    let exact: Vec<Big> = data.iter().map(|&x| Big::from(x)).collect();
    let gap = system.gap_at(&exact);
    let distance = gap.abs().to_f64() / gap_uncertainty(system, &exact, &gap);
    let closed = !gap.is_negative();
    let fitting = forms.iter().filter(|form| (form.fits)(geometry));
    for (index, form) in fitting.enumerate() {
        for (fused, flipped) in [(false, false), (false, true), (true, false), (true, true)] {
            let assembled = (form.assemble)(geometry, Variant { fused, flipped });
            let values = assembled.map_or(Vec::new(), |evaluate| evaluate(input).values);
            let finite = !values.is_empty() && values.iter().all(|x| x.is_finite());
            // The sign takes most of the time; the forms share the root that it comes from.
            if finite && index == 0 {
                let mode = if flipped { -mode } else { mode };
                let determinant = determinant_at(system, &exact, &values).to_f64();
                seen.against_mode = seen.against_mode.max(-determinant * mode / ROUNDOFF);
            }
            let (all, wrong) = if closed {
                (&mut seen.closed, &mut seen.refused)
            } else {
                (&mut seen.open, &mut seen.forgiven)
            };
            *all += 1;
            if finite != closed {
                *wrong = (wrong.0 + 1, wrong.1.max(distance));
            }
        }
    }
}
