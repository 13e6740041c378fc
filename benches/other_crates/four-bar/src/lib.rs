//! The four-bar of the crate four-bar.

use four_bar::{
    FourBar, NormFourBar,
    mech::{CurveGen, Stat, fb::UnNorm},
};

/// The mechanism with dimensions `a, b, c, dx, dy, p, u`; its frame must be along x.
pub fn mechanism([a, b, c, dx, _, p, u]: [f64; 7]) -> FourBar {
    let norm = NormFourBar {
        l1: dx,
        l3: b,
        l4: c,
        l5: p,
        g: u,
        stat: Stat::C1B1,
    };
    FourBar::new(UnNorm::from_driver(a), norm)
}

/// The tracer point.
pub fn point(mechanism: &FourBar, phi: f64) -> Option<[f64; 2]> {
    mechanism.pos(phi).map(|[.., tracer]| tracer)
}

/// The angle of the rocker, from both of its pins.
pub fn rocker(mechanism: &FourBar, phi: f64) -> Option<f64> {
    let [_, pivot, _, pin, _] = mechanism.pos(phi)?;
    Some((pin[1] - pivot[1]).atan2(pin[0] - pivot[0]))
}
