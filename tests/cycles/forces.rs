//! Forces, shaking, accelerations, transmission angles and errors as wishes: slopes against differences, optima against other ways to them.

use super::{N as ROCKER, Rocker, RockerAssembly, design, figure as rocker_figure};
use linkage::Dimensions;
use linkage::design::{
    Curve, CycleDesign, DesignError, Figure, Highest, Lowest, Motion, Peak, Pieces, RootMeanSquare,
    Stroke,
};
use linkage::mechanism;
use std::f64::consts::TAU;

mechanism! {
    /// A slider-crank with a counterweight on its crank.
    #[derive(Clone, Copy)]
    struct Pump {
        unit mm;
        param crank = 40mm;
        param rod = 140mm;
        param offset = 6mm;
        param counter = 0.4kg;
        input phi = 30deg in 0deg..360deg at omega;
        unknown theta = -10deg;
        unknown x = 170mm;
        let p = polar(crank, phi);
        let q = p + polar(rod, theta);
        loop q = (x, offset);

        body wheel = pin main on frame at (0, 0), turns phi, mass 2kg at p / 3, inertia 3000kg*mm^2,
            mass counter at polar(-60mm, phi);
        body link = pin big on wheel at p, turns theta, mass 1.2kg at p + polar(rod / 3, theta), inertia 4000kg*mm^2;
        body piston = slide wall on frame at q along (1, 0), mass 1.5kg at q;
        pin small = link on piston at q;
        force (-400N, 0N) on piston at q;
    }
    impl Pump {
        fn bearing(phi, omega) -> Bearing {
            f: reaction(main), v: velocity(reaction(main)), a: acceleration(reaction(main)), e: sensitivity(reaction(main)),
        }
        fn shaking(phi, omega) -> ShakingForce {
            f: shaking_force(), v: velocity(shaking_force()), a: acceleration(shaking_force()), e: sensitivity(shaking_force()),
        }
        fn piston(phi) -> Piston {
            x, v: velocity(x), a: acceleration(x), j: jerk(x), s: velocity(jerk(x)),
            e: sensitivity(x), ea: sensitivity(acceleration(x)),
        }
    }
}

const N: usize = Pump::PARAMETERS.len();
/// In rad/s.
const SPEED: f64 = 40.0;

type Line = Curve<'static, PumpAssembly, N>;

/// The size of the force on the main bearing.
fn bearing() -> Line {
    let jet = |pump: &PumpAssembly, phi| {
        let force = pump.bearing(phi, SPEED);
        [force.f, force.v, force.a].map(|f| [f.x, f.y])
    };
    Curve::length(jet, |pump, phi| {
        pump.bearing(phi, SPEED).e.map(|f| [f.x, f.y])
    })
}

/// The size of the force on the foundation.
fn shaking() -> Line {
    let jet = |pump: &PumpAssembly, phi| {
        let force = pump.shaking(phi, SPEED);
        [force.f, force.v, force.a].map(|f| [f.x, f.y])
    };
    Curve::length(jet, |pump, phi| {
        pump.shaking(phi, SPEED).e.map(|f| [f.x, f.y])
    })
}

/// The acceleration of the piston, by the crank's angle.
fn acceleration() -> Line {
    let jet = |pump: &PumpAssembly, phi| {
        let piston = pump.piston(phi);
        [piston.a, piston.j, piston.s]
    };
    Curve::new(jet, |pump, phi| pump.piston(phi).ea)
}

fn piston() -> Line {
    let jet = |pump: &PumpAssembly, phi| {
        let piston = pump.piston(phi);
        [piston.x, piston.v, piston.a]
    };
    Curve::new(jet, |pump, phi| pump.piston(phi).e)
}

/// The angle between coupler and rocker.
fn transmission() -> Curve<'static, RockerAssembly, ROCKER> {
    let jet = |rocker: &RockerAssembly, phi| {
        let angle = rocker.transmission(phi);
        [angle.mu, angle.v, angle.a]
    };
    Curve::new(jet, |rocker, phi| rocker.transmission(phi).e)
}

fn figure(figure: &impl Figure<PumpAssembly, N>, pump: &Pump) -> (f64, [f64; N]) {
    let assembly = pump.assemble().expect("assembles");
    let motion = Motion {
        assembly: &assembly,
        range: (0.0, TAU),
        closed: true,
        positions: 121,
    };
    let Some(Pieces::Largest(pieces)) = figure.pieces(&motion) else {
        panic!("a largest value");
    };
    let best = pieces
        .into_iter()
        .max_by(|a, b| a.value.total_cmp(&b.value));
    let best = best.expect("a piece");
    (best.value, best.parameters)
}

#[test]
fn slopes_are_those_of_differences() {
    let agree = |what: &dyn Fn(&Pump) -> (f64, [f64; N]), title: &str| {
        const STEP: f64 = 1e-4;
        let nominal = Pump::default().values();
        let (value, slopes) = what(&Pump::default());
        for (k, slope) in slopes.into_iter().enumerate() {
            let [up, down] = [STEP, -STEP].map(|step| {
                let mut values = nominal;
                values[k] += step;
                what(&Pump::from_values(&values)).0
            });
            let difference = (up - down) / (2.0 * STEP);
            let size = slopes
                .iter()
                .fold(value * 1e-3, |most: f64, s| most.max(s.abs()));
            assert!(
                (slope - difference).abs() < 1e-6 * size,
                "{title} by {k}: {slope} {difference}"
            );
        }
    };
    agree(&|pump| figure(&Peak(bearing()), pump), "bearing");
    agree(
        &|pump| figure(&RootMeanSquare(bearing()), pump),
        "mean of the bearing",
    );
    agree(&|pump| figure(&Peak(shaking()), pump), "shaking");
    agree(&|pump| figure(&Peak(acceleration()), pump), "acceleration");
    let (lowest, slopes) = rocker_figure(&Lowest(transmission()), &Rocker::default());
    for (k, slope) in slopes.into_iter().enumerate() {
        let [up, down] = [1e-4, -1e-4]
            .map(|step| rocker_figure(&Lowest(transmission()), &super::changed(k, step)).0);
        assert!(
            (slope - (up - down) / 2e-4).abs() < 1e-8,
            "{lowest} by {k}: {slope}"
        );
    }
}

fn pump() -> CycleDesign<'static, Pump, PumpAssembly, N> {
    let design = CycleDesign::new(
        Pump {
            offset: 0.0,
            ..Pump::default()
        },
        Pump::assemble,
        Pump::assemble_from,
        Pump::circuits,
    );
    design.expect("assembles")
}

/// The least of a figure over counterweights, by a fine grid around the least of a coarse one.
fn least_over_counterweights(what: &impl Figure<PumpAssembly, N>) -> f64 {
    let at = |counter: f64| {
        let pump = Pump {
            counter,
            offset: 0.0,
            ..Pump::default()
        };
        figure(what, &pump).0
    };
    let (mut best, mut width) = (1.5, 1.5);
    for _ in 0..4 {
        let places = (-10..=10).map(|i| (best + width * f64::from(i) / 10.0).clamp(0.0, 3.0));
        best = places
            .min_by(|a, b| at(*a).total_cmp(&at(*b)))
            .expect("some");
        width /= 5.0;
    }
    at(best)
}

#[test]
fn counterweights_are_those_of_a_grid() -> Result<(), DesignError> {
    let vary = || pump().vary("counter", 0.0, 3.0);
    let bearing_found = vary().want(Peak(bearing()).least()).run()?;
    let least = least_over_counterweights(&Peak(bearing()));
    assert!(
        (bearing_found.goal / least - 1.0).abs() < 1e-4,
        "{} {least}",
        bearing_found.goal
    );
    let shaking_found = vary().want(Peak(shaking()).least()).run()?;
    let least = least_over_counterweights(&Peak(shaking()));
    assert!(
        (shaking_found.goal / least - 1.0).abs() < 1e-4,
        "{} {least}",
        shaking_found.goal
    );
    let before = figure(
        &Peak(shaking()),
        &Pump {
            offset: 0.0,
            ..Pump::default()
        },
    )
    .0;
    assert!(
        shaking_found.goal < 0.9 * before,
        "{} {before}",
        shaking_found.goal
    );
    // Each is a limit for the other.
    let between = 0.5 * (shaking_found.goal + figure(&Peak(shaking()), &bearing_found.mechanism).0);
    let both = vary()
        .want(Peak(bearing()).least())
        .want(Peak(shaking()).at_most(between))
        .run()?;
    assert!(both.goal > bearing_found.goal);
    assert!((figure(&Peak(shaking()), &both.mechanism).0 - between).abs() < 1e-6 * between);
    Ok(())
}

/// Without offset the peak is at the outer dead centre, `r (1 + r / l)`: the rod is as long as may be, the crank as short as the stroke allows.
#[test]
fn the_least_peak_of_an_acceleration() -> Result<(), DesignError> {
    let found = pump()
        .vary("crank", 35.0, 45.0)
        .vary("rod", 120.0, 160.0)
        .want(Peak(acceleration()).least())
        .want(Stroke(piston()).at_least(80.0))
        .run()?;
    assert!(
        found.converged && (found.goal - 40.0 * (1.0 + 40.0 / 160.0)).abs() < 1e-6,
        "{found}"
    );
    Ok(())
}

/// Where crank and frame are in a line, the angle follows from a triangle.
#[test]
fn the_best_transmission_angle() -> Result<(), DesignError> {
    let least = |rocker: &Rocker| {
        let (b, c) = (rocker.coupler, rocker.rocker);
        let at = |d: f64| ((b * b + c * c - d * d) / (2.0 * b * c)).acos();
        [
            at(rocker.frame - rocker.crank),
            at(rocker.frame + rocker.crank),
        ]
    };
    let most = 125_f64.to_radians();
    let found = design()
        .want(Lowest(transmission()).greatest())
        .want(Highest(transmission()).at_most(most))
        .want(Stroke(super::tip()).at_least(72.0))
        .run()?;
    let [lowest, highest] = least(&found.mechanism);
    assert!((found.goal - lowest).abs() < 1e-9 && highest <= most + 1e-6);
    let mut best = 0.0_f64;
    let mut held = 0;
    for i in 0..=12 {
        for j in 0..=12 {
            for k in 0..=12 {
                let part = |low: f64, high: f64, i: i32| low + (high - low) * f64::from(i) / 12.0;
                let rocker = Rocker {
                    crank: part(45.0, 55.0, i),
                    coupler: part(108.0, 132.0, j),
                    rocker: part(90.0, 110.0, k),
                    ..Rocker::default()
                };
                let [low, high] = least(&rocker);
                if high <= most && rocker_figure(&Stroke(super::tip()), &rocker).0 >= 72.0 {
                    held += 1;
                    best = best.max(low);
                }
            }
        }
    }
    assert!(
        held > 10 && found.goal >= best,
        "{held} {best} {}",
        found.goal
    );
    assert!(found.goal < best + 0.05, "{best} {}", found.goal);
    Ok(())
}
