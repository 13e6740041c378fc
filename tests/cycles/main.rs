//! Design problems of whole cycles: derivatives of all figures against differences, optima against other ways to them, messages.

mod derivatives;
mod length;
mod messages;
mod optima;
mod relations;
mod seeds;
mod starts;
mod whole;

use linkage::Dimensions;
use linkage::design::{Curve, CycleDesign, ErrorOf, Figure, Motion, Pieces};
use linkage::mechanism;
use linkage::summary::Course;
use linkage::tolerance::Tolerances;
use std::f64::consts::TAU;

mechanism! {
    #[derive(Clone, Copy)]
    struct Rocker {
        unit mm;
        param frame   = 140mm +- 20um;
        param crank   = 50mm  +- 12um;
        param coupler = 120mm +- 20um;
        param rocker  = 100mm +- 20um;
        param arm     = 70mm  +- 15um;
        input phi = 30deg in 0deg..360deg;
        unknown theta = 40deg;
        unknown psi   = 80deg;
        loop polar(crank, phi) + polar(coupler, theta) = (frame, 0) + polar(rocker, psi);
        let tip = arm * psi;
        let point = polar(crank, phi) + polar(arm, theta);
    }
    impl Rocker {
        fn tip(phi) -> Tip { tip, v: velocity(tip), a: acceleration(tip), j: jerk(tip) }
        fn slopes(phi) -> Slopes { e: sensitivity(tip), ev: sensitivity(velocity(tip)) }
        fn point(phi) -> Point { point, v: velocity(point), a: acceleration(point), e: sensitivity(point) }
        fn margin(phi) -> Margin { m: margin(), v: velocity(margin()), a: acceleration(margin()), e: sensitivity(margin()) }
        fn second(phi) -> Second { h: sensitivity(sensitivity(tip)) }
    }
}

const N: usize = Rocker::PARAMETERS.len();
type Line = Curve<'static, RockerAssembly, N>;

fn tip() -> Line {
    let jet = |rocker: &RockerAssembly, phi| {
        let tip = rocker.tip(phi);
        [tip.tip, tip.v, tip.a]
    };
    Curve::new(jet, |rocker, phi| rocker.slopes(phi).e)
}

fn speed() -> Line {
    let jet = |rocker: &RockerAssembly, phi| {
        let tip = rocker.tip(phi);
        [tip.v, tip.a, tip.j]
    };
    Curve::new(jet, |rocker, phi| rocker.slopes(phi).ev)
}

fn distance() -> Line {
    let jet = |rocker: &RockerAssembly, phi| {
        let point = rocker.point(phi);
        [point.point, point.v, point.a].map(|v| [v.x, v.y])
    };
    Curve::length(jet, |rocker, phi| rocker.point(phi).e.map(|v| [v.x, v.y]))
}

fn margin() -> Line {
    let jet = |rocker: &RockerAssembly, phi| {
        let margin = rocker.margin(phi);
        [margin.m, margin.v, margin.a]
    };
    Curve::new(jet, |rocker, phi| rocker.margin(phi).e)
}

fn tolerances() -> Tolerances<N> {
    Tolerances::complete(Rocker::PARAMETERS).expect("all have one")
}

fn errors(worst_case: bool) -> ErrorOf<'static, RockerAssembly, N> {
    let second = |rocker: &RockerAssembly, phi| rocker.second(phi).h;
    let inputs = (0..12).map(|i| 0.5 * f64::from(i));
    if worst_case {
        ErrorOf::worst_case(tip(), second, &tolerances(), inputs)
    } else {
        ErrorOf::root_sum_square(tip(), second, &tolerances(), inputs)
    }
}

/// The figure, and its slopes by all parameters.
fn figure(figure: &impl Figure<RockerAssembly, N>, rocker: &Rocker) -> (f64, [f64; N]) {
    let assembly = rocker.assemble().expect("assembles");
    let motion = Motion {
        assembly: &assembly,
        range: (0.0, TAU),
        closed: true,
        positions: 121,
    };
    let (pieces, sign) = match figure.pieces(&motion).expect("runs through the turn") {
        Pieces::Largest(pieces) => (pieces, 1.0),
        Pieces::Smallest(pieces) => (pieces, -1.0),
    };
    let key = |value: f64| sign * value;
    let best = pieces
        .into_iter()
        .max_by(|a, b| key(a.value).total_cmp(&key(b.value)))
        .expect("a piece");
    (best.value, best.parameters)
}

/// A rocker whose parameter `k` differs.
fn changed(k: usize, change: f64) -> Rocker {
    let mut values = Rocker::default().values();
    values[k] += change;
    Rocker::from_values(&values)
}

fn design() -> CycleDesign<'static, Rocker, RockerAssembly, N> {
    let design = CycleDesign::new(
        Rocker::default(),
        Rocker::assemble,
        Rocker::assemble_from,
        Rocker::circuits,
    );
    let design = design
        .expect("assembles")
        .vary_by("crank", 0.1)
        .vary_by("coupler", 0.1);
    design.vary_by("rocker", 0.1)
}

fn course(rocker: &Rocker) -> Course<4, impl Fn(f64) -> [f64; 4]> {
    let assembly = rocker.assemble().expect("assembles");
    let jet = move |phi| {
        let tip = assembly.tip(phi);
        [tip.tip, tip.v, tip.a, tip.j]
    };
    Course::of((0.0, TAU), 361, jet).expect("a turn")
}
