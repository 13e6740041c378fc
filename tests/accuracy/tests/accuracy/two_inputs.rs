//! Two degrees of freedom: all partial derivatives by both inputs and by parameters.

use linkage_reference::{Big, Components, Output, Plane, Random, Reference, System, Unknown, data};

/// A five-bar: one crank turns, the other one slides along the frame.
const FIVE_BAR: System = System {
    name: "five-bar",
    data: data! {
        length "crank" 30.0, "rod_1" 90.0, "rod_2" 85.0;
        degrees "phi" 70.0;
        length "shift" 95.0;
    },
    parameters: 3,
    unknowns: &[Unknown::angle("alpha", 30.0), Unknown::angle("beta", 105.0)],
    residual: |p| {
        let frame = Plane {
            x: p.value("shift").clone(),
            y: Big::zero(),
        };
        let closure =
            p.polar("crank", "phi") + p.polar("rod_1", "alpha") - frame - p.polar("rod_2", "beta");
        vec![closure.x, closure.y]
    },
    further: |p| {
        let point = p.polar("crank", "phi") + p.polar("rod_1", "alpha");
        Output::lengths([point.x, point.y])
    },
    margin: Some(|_| linkage_reference::Big::one()),
    ..System::PLAIN
};

linkage_interpreted::interpreted! {
    struct FiveBar {
        unit mm;
        param crank = 30mm;
        param rod_1 = 90mm;
        param rod_2 = 85mm;
        input phi = 70deg in 0deg..360deg;
        input shift = 95mm in 80mm..110mm;
        unknown alpha = 30deg;
        unknown beta = 105deg;
        let point = polar(crank, phi) + polar(rod_1, alpha);
        loop point = (shift, 0) + polar(rod_2, beta);
    }

    impl FiveBar {
        fn values(phi, shift) -> Values { alpha, beta, point }
        fn first(phi, shift) -> First {
            alpha: velocity(alpha), beta: velocity(beta), point: velocity(point),
        }
        fn second(phi, shift) -> Second {
            alpha: acceleration(alpha), beta: acceleration(beta), point: acceleration(point),
        }
        fn single(phi, shift) -> Single {
            by_shift: d(point, shift),
            twice: d(point, shift, shift),
            both: d(point, shift, phi),
            with_rod: d(point, rod_2, shift),
        }
        fn accuracy(phi, shift) -> Accuracy {
            point: sensitivity(point),
            rate: sensitivity(d(point, shift), [rod_1, crank]),
        }
    }
}

/// The largest error in units of the joint uncertainty.
fn largest(reference: &mut Reference, by: &[usize], computed: &[f64], first: usize) -> f64 {
    let unit = reference.joint_uncertainty(by);
    let exact = reference.derivative(by);
    let error = |(k, &x): (usize, &f64)| {
        let k = first + k;
        ((&exact[k] - &Big::from(x)).abs() / &unit[k]).to_f64()
    };
    computed
        .iter()
        .enumerate()
        .map(error)
        .fold(0.0, |m, e| if e > m || e.is_nan() { e } else { m })
}

#[test]
fn all_partial_derivatives() {
    let mut random = Random::new(71);
    let mut worst = 0.0f64;
    for _ in 0..40 {
        let default = FIVE_BAR.default_geometry();
        let geometry: Vec<f64> = default[..3]
            .iter()
            .map(|x| x * random.between(0.9, 1.1))
            .collect();
        let (phi, shift) = (random.between(-3.0, 6.0), random.between(80.0, 110.0));
        let mechanism = FiveBar {
            crank: geometry[0],
            rod_1: geometry[1],
            rod_2: geometry[2],
        };
        let linkage = mechanism.assemble().expect("closes");
        let values = linkage.values(phi, shift);
        let data = [geometry.as_slice(), &[phi, shift]].concat();
        let start = [values.alpha, values.beta];
        let mut reference = Reference::new(&FIVE_BAR, &data, &start).expect("a solution nearby");
        let mut compare = |by: &[usize], computed: &[f64], first| {
            worst = worst.max(largest(&mut reference, by, computed, first));
        };
        let inputs = [3, 4];
        let (first, second) = (linkage.first(phi, shift), linkage.second(phi, shift));
        for (i, x) in inputs.into_iter().enumerate() {
            let angles = [first.alpha[i], first.beta[i]];
            compare(
                &[x],
                &[&angles[..], &first.point[i].components()].concat(),
                0,
            );
            for (j, y) in inputs.into_iter().enumerate() {
                let angles = [second.alpha[i][j], second.beta[i][j]];
                compare(
                    &[x, y],
                    &[&angles[..], &second.point[i][j].components()].concat(),
                    0,
                );
            }
        }
        let single = linkage.single(phi, shift);
        compare(&[4], &single.by_shift.components(), 2);
        compare(&[4, 4], &single.twice.components(), 2);
        compare(&[4, 3], &single.both.components(), 2);
        compare(&[2, 4], &single.with_rod.components(), 2);
        let accuracy = linkage.accuracy(phi, shift);
        for (p, e) in accuracy.point.iter().enumerate() {
            compare(&[p], &e.components(), 2);
        }
        for (p, e) in [1, 0].into_iter().zip(&accuracy.rate) {
            compare(&[4, p], &e.components(), 2);
        }
    }
    println!("largest error: {worst:.3} times the inherent uncertainty");
    assert!(worst < 10.0);
}
