//! Design problems of whole cycles: derivatives of all figures against differences, optima against other ways to them, messages.

mod divided;
mod drives;
mod dwells;
mod errors;
mod fit;
mod forces;
mod judged;
mod messages;
mod optima;
mod relations;
mod starts;
mod verified;

use linkage::Dimensions;
use linkage::design::{
    Candidate, Chosen, Curve, CycleDesign, CycleObjective, ErrorOf, Figure, Motion, Piece, Pieces,
};
use linkage::mechanism;
use linkage::summary;
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
        let mu = psi - theta;
    }
    impl Rocker {
        fn tip(phi) -> Tip { tip, v: velocity(tip), a: acceleration(tip), j: jerk(tip) }
        fn slopes(phi) -> Slopes {
            e: sensitivity(tip), ev: sensitivity(velocity(tip)), ea: sensitivity(acceleration(tip)),
        }
        fn point(phi) -> Point { point, v: velocity(point), a: acceleration(point), e: sensitivity(point) }
        fn margin(phi) -> Margin { m: margin(), v: velocity(margin()), a: acceleration(margin()), e: sensitivity(margin()) }
        fn transmission(phi) -> Transmission { mu, v: velocity(mu), a: acceleration(mu), e: sensitivity(mu) }
        fn second(phi) -> Second { h: sensitivity(sensitivity(tip)) }
        fn spread(phi) -> Spread {
            e: sensitivity(point), ev: sensitivity(velocity(point)), ea: sensitivity(acceleration(point)),
            h: sensitivity(sensitivity(point)),
        }
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

/// Some dimensions lie on one side of their nominal values.
fn one_sided() -> Tolerances<N> {
    let limits = tolerances().limits(Rocker::INDEX_CRANK, 0.0, 0.03);
    let limits = limits.and_then(|all| all.limits(Rocker::INDEX_COUPLER, -0.05, -0.01));
    limits.expect("the lower ones come first")
}

fn errors(worst_case: bool) -> ErrorOf<'static, RockerAssembly, N> {
    errors_within(&tolerances(), worst_case)
}

fn errors_within(
    tolerances: &Tolerances<N>,
    worst_case: bool,
) -> ErrorOf<'static, RockerAssembly, N> {
    let inputs = (0..12).map(|i| 0.5 * f64::from(i));
    if worst_case {
        ErrorOf::worst_case(effects, second, tolerances, inputs)
    } else {
        ErrorOf::root_sum_square(effects, second, tolerances, inputs)
    }
}

fn effects(rocker: &RockerAssembly, phi: f64) -> [f64; N] {
    rocker.slopes(phi).e
}

fn second(rocker: &RockerAssembly, phi: f64) -> [[f64; N]; N] {
    rocker.second(phi).h
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

/// What a wish asks of a rocker with these dimensions, and variables of its own behind them.
fn asked(wish: &dyn CycleObjective<Rocker, RockerAssembly, N>, place: &[f64]) -> Vec<Piece<N>> {
    let mechanism = Rocker::from_values(&std::array::from_fn(|k| place[k]));
    let assembly = mechanism.assemble().expect("assembles");
    let motion = Motion {
        assembly: &assembly,
        range: (0.0, TAU),
        closed: true,
        positions: 121,
    };
    let assemble = |other: &Rocker| other.assemble().ok();
    let candidate = Candidate::new(&mechanism, motion, &assemble);
    let chosen = Chosen {
        auxiliary: &place[N..],
        added: &[],
    };
    let asked = wish
        .evaluate(&candidate, chosen)
        .expect("runs through the interval");
    let pieces = asked.conditions.into_iter().chain([asked.goal]);
    pieces.flatten().collect()
}

/// Compares all derivatives of what a wish asks at a place with differences.
fn slopes_of_pieces_agree(wish: &dyn CycleObjective<Rocker, RockerAssembly, N>, place: &[f64]) {
    let pieces = asked(wish, place);
    for k in 0..place.len() {
        const STEP: f64 = 1e-5;
        let [up, down] = [STEP, -STEP].map(|step| {
            let mut other = place.to_vec();
            other[k] += step;
            asked(wish, &other)
        });
        for ((piece, up), down) in pieces.iter().zip(&up).zip(&down) {
            let slope = if k < N {
                piece.parameters[k]
            } else {
                piece.auxiliary[k - N]
            };
            let difference = (up.value - down.value) / (2.0 * STEP);
            assert!(
                (slope - difference).abs() < 1e-6 * (1.0 + slope.abs()),
                "{k} {:?}: {slope} and {difference}",
                piece.key
            );
        }
    }
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

fn course(rocker: &Rocker) -> summary::Curve<4, impl Fn(f64) -> [f64; 4]> {
    let assembly = rocker.assemble().expect("assembles");
    let jet = move |phi| {
        let tip = assembly.tip(phi);
        [tip.tip, tip.v, tip.a, tip.j]
    };
    summary::Curve::new((0.0, TAU), 361, jet).expect("a turn")
}
