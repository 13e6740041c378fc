//! The point where methods differ: needle triangles, dead points, change points.

use crate::errors::{Errors, larger};
use crate::methods::Parts;
use crate::panels::{Kernels, points};
use crate::{Outcome, Panel};
use linkage_peers::mechanisms::{K1, dimensions1};
use linkage_peers::reference::{self, Exact};
use linkage_peers::{ROUNDOFF, Random};

/// A mechanism, and positions at which it is hard.
struct Set {
    name: &'static str,
    mechanism: K1,
    positions: Vec<f64>,
}

/// Positions of each set.
const COUNT: usize = 256;

/// Exponents of the distance to a dead point or change point, in radians. Nearer than that, single precision has no positions.
const DECADES: [f64; 2] = [-6.5, -1.0];

/// A number of `f32`, so that it gets the same.
fn plain(x: f64) -> f64 {
    f64::from(x as f32)
}

/// From the crank pin to the rocker's pivot.
fn base(mechanism: &K1, phi: f64) -> f64 {
    let (sin, cos) = phi.sin_cos();
    let [x, y] = [mechanism.crank * cos, mechanism.crank * sin];
    f64::hypot(mechanism.pivot_d.x - x, mechanism.pivot_d.y - y)
}

/// A rocker of ten micrometres: the triangle is a needle wherever it can be assembled.
fn needle(random: &mut Random) -> Set {
    const ROCKER: f64 = 0.01;
    /// Where the mechanism is assembled: elsewhere it cannot be.
    const MIDDLE: f64 = std::f64::consts::FRAC_PI_6;
    let published = K1::default();
    let coupler = plain(base(&published, MIDDLE));
    // How fast the base grows with the crank's angle.
    let rate = published.crank * published.pivot_d.x * MIDDLE.sin() / coupler;
    let reach = 0.9 * ROCKER / rate;
    let place = |_| MIDDLE + reach * random.between(-1.0, 1.0);
    Set {
        name: "needle",
        positions: (0..COUNT).map(place).collect(),
        mechanism: K1 {
            coupler,
            rocker: ROCKER,
            ..published
        },
    }
}

/// Links that are too short for a full turn: they are stretched at the dead point.
fn dead_point(random: &mut Random) -> Set {
    let mechanism = K1 {
        crank: 90.0,
        ..K1::default()
    };
    let K1 {
        crank,
        coupler,
        rocker,
        pivot_d,
        ..
    } = mechanism;
    let (base, distance) = (coupler + rocker, pivot_d.x);
    let dead =
        ((crank * crank + distance * distance - base * base) / (2.0 * crank * distance)).acos();
    let place = |_| dead - 10f64.powf(random.between(DECADES[0], DECADES[1]));
    Set {
        name: "dead point",
        positions: (0..COUNT).map(place).collect(),
        mechanism,
    }
}

/// A parallelogram: with the crank along the base all links lie on one line.
fn change_point(random: &mut Random) -> Set {
    let published = K1::default();
    let place = |index| {
        let distance = 10f64.powf(random.between(DECADES[0], DECADES[1]));
        if index % 2 == 0 { distance } else { -distance }
    };
    Set {
        name: "change point",
        positions: (0..COUNT).map(place).collect(),
        mechanism: K1 {
            rocker: published.crank,
            coupler: published.pivot_d.x,
            ..published
        },
    }
}

/// What a roundoff in each dimension and in the input does to the point, and a roundoff of the point itself.
fn uncertainty(exact: &reference::Reference<7>, dimensions: &[f64; 7], phi: f64) -> f64 {
    let value = |numbers: &[Exact]| f64::hypot(numbers[0].value(), numbers[1].value());
    let motion = exact.motion(phi);
    let by_dimensions = exact.accuracy(phi);
    let moved = by_dimensions[2..]
        .chunks_exact(2)
        .zip(dimensions)
        .map(|(change, dimension)| value(change) * dimension.abs())
        .sum::<f64>();
    ROUNDOFF * (value(&motion[..2]) + value(&motion[2..4]) * phi.abs() + moved)
}

/// The errors of all methods at the positions of a set, in units of what roundoffs of the data do.
fn errors(set: &Set) -> Vec<Vec<f64>> {
    let dimensions = dimensions1(&set.mechanism);
    let exact = reference::k1(dimensions);
    let kernels = Kernels::new(&set.mechanism);
    let known: Vec<_> = set
        .positions
        .iter()
        .map(|&phi| (exact.point(phi), uncertainty(&exact, &dimensions, phi)))
        .collect();
    let error = |result: &[Parts; 2], (exact, unit): &([Exact; 2], f64)| {
        let parts = exact.iter().zip(result);
        let error = parts.fold(0.0, |error, (exact, &[high, low])| {
            larger(error, exact.distance(high, low))
        });
        error / unit
    };
    let methods = points(&kernels, &set.positions);
    methods
        .iter()
        .map(|method| {
            let results = method.results.iter().zip(&known);
            results
                .map(|(result, known)| error(result, known))
                .collect()
        })
        .collect()
}

/// The largest errors of all methods; the times are those of `easy`, which has the same methods.
pub(crate) fn panel(easy: &Panel) -> Panel {
    let mut random = Random::new(21);
    let mut sets = [needle, dead_point, change_point].map(|set| set(&mut random));
    for set in &mut sets {
        set.positions.iter_mut().for_each(|phi| *phi = plain(*phi));
        // In order, as a simulation steps through them.
        set.positions.sort_by(f64::total_cmp);
    }
    let by_set = sets.each_ref().map(errors);
    let outcomes = easy.outcomes.iter().enumerate().map(|(method, outcome)| {
        let of_method = by_set.each_ref().map(|errors| &errors[method]);
        Outcome {
            name: outcome.name,
            family: outcome.family,
            times: outcome.times.clone(),
            errors: Errors::of_sets(&of_method.map(Vec::as_slice)),
        }
    });
    Panel {
        title: "Needles, dead points, change points",
        unit: "what roundoffs of the data do",
        parts: sets.iter().map(|set| set.name).collect(),
        outcomes: outcomes.collect(),
    }
}
