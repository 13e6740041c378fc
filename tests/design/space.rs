//! Poses of a body in space: a point and two directions at each position.

use super::evenly;
use linkage::Dimensions;
use linkage::design::{Design, Targets, Timing};
use linkage::mechanism;

mechanism! {
    /// A coupler between two ball joints, held upright by the pin of its crank.
    struct Carrier {
        unit mm;
        param crank = 30mm;
        param rod = 130mm;
        param rocker = 70mm;
        param pivot = (110mm, 30mm, -50mm);
        param tool = (90mm, 15mm, -25mm);
        input phi = 0deg in 0deg..360deg;
        const x = (1, 0, 0);
        let p2 = turn((0mm, crank, 0mm), x, phi);
        unknown psi = 100deg;
        let p3 = pivot + turn((rocker, 0mm, 0mm), (0.2, 0.3, 0.9), psi);
        loop distance(p2, p3) = rod;
        unknown upward = (0, 0.7, 0.7);
        loop norm(upward) = 1;
        loop dot(upward, p3 - p2) = 0mm;
        loop dot(upward, x) = 0;
        let coupler = frame(p2, p3 - p2, upward);
        let along = coupler.x;
        let tip = point_in(coupler, tool);
    }
    impl Carrier {
        fn pose(phi) -> CarrierPose {
            tip, along, upward,
            v: velocity(tip), by_tip: sensitivity(tip), by_along: sensitivity(along), by_upward: sensitivity(upward),
        }
    }
}

/// Poses of a carrier that differs in all dimensions lead back to it, turned as it was.
#[test]
fn poses_are_found_again() {
    let nominal = Carrier::default();
    let shares = [1.05, 0.97, 1.04, 0.98, 1.06, 1.03, 0.96, 1.05, 0.95];
    let values = nominal.values();
    let known = Carrier::from_values(&std::array::from_fn(|k| shares[k] * values[k]));
    let assembly = known.assemble().expect("it assembles");
    let inputs = evenly(0.2, 0.6, 10);
    let poses = inputs.iter().map(|&phi| {
        let CarrierPose {
            tip, along, upward, ..
        } = assembly.pose(phi);
        let numbers = [tip, along, upward].map(<[f64; 3]>::from);
        std::array::from_fn::<f64, 9, _>(|k| numbers[k / 3][k % 3])
    });
    let wish = Targets::of_all(["tip", "along", "upward"], poses)
        .weights([1.0, 1.0, 1.0, 50.0, 50.0, 50.0, 50.0, 50.0, 50.0])
        .at_inputs(inputs)
        .computed_by(CarrierAssembly::pose_sweep_sets_into);
    let design = Design::new(
        nominal,
        Carrier::assemble,
        Carrier::assemblies,
        Carrier::circuits,
    );
    let design = Carrier::PARAMETERS.iter().fold(
        design.expect("it assembles").want(wish).starts(8),
        |design, own| design.vary_by(own.name, 0.1),
    );
    let found = design.run().expect("it can be found");
    let best = found.best();
    assert!(best.sum < 1e-18, "{:e}", best.sum);
    for (value, known) in best.mechanism.values().iter().zip(known.values()) {
        assert!((value - known).abs() < 1e-8, "{value} and {known}");
    }
    assert_eq!((found.residuals, found.variables), (90, 9));
}

/// Points of a way in space, one after the other at any inputs, lead back to the carrier and to their inputs.
#[test]
fn a_path_in_space_is_found_again() {
    let nominal = Carrier::default();
    let known = Carrier {
        rod: 133.0,
        rocker: 68.0,
        crank: 31.0,
        ..nominal
    };
    let assembly = known.assemble().expect("it assembles");
    let inputs = evenly(0.3, 0.55, 9);
    let points = inputs
        .iter()
        .map(|&phi| <[f64; 3]>::from(assembly.pose(phi).tip));
    let wish = Targets::new("tip", points)
        .timing(Timing::InOrder)
        .computed_by(CarrierAssembly::pose_sweep_sets_into);
    let design = Design::new(
        nominal,
        Carrier::assemble,
        Carrier::assemblies,
        Carrier::circuits,
    );
    let design = ["rod", "rocker", "crank"].into_iter().fold(
        design.expect("it assembles").want(wish).starts(64),
        |design, name| design.vary_by(name, 0.1),
    );
    let found = design.run().expect("it can be found");
    let best = found.best();
    assert!(best.sum < 1e-16, "{found}");
    for (value, known) in best.mechanism.values().iter().zip(known.values()) {
        assert!((value - known).abs() < 1e-6, "{value} and {known}");
    }
    for (input, known) in best.inputs[0].iter().zip(&inputs) {
        assert!((input - known).abs() < 1e-6, "{input} and {known}");
    }
    assert_eq!((found.residuals, found.variables), (27, 12));
}
