//! Derivatives of powers and quotients against differences: of generated Rust, and of its programs on plain numbers.

use linkage::mechanism;
use linkage_corpus::quotients::{Precision, Quotients};
use linkage_corpus::reference::Assembled;

/// The numbers of a result, in order.
trait Numbers {
    fn append(&self, numbers: &mut Vec<f64>);
}

impl Numbers for f64 {
    fn append(&self, numbers: &mut Vec<f64>) {
        numbers.push(*self);
    }
}

impl<N: Numbers, const COUNT: usize> Numbers for [N; COUNT] {
    fn append(&self, numbers: &mut Vec<f64>) {
        self.iter().for_each(|entry| entry.append(numbers));
    }
}

mechanism! {
    pub struct Quotients0 {
        unit mm;
        param a = 1.3;
        param b = 0.8;
        param c = 1.7;
        param crank = 50mm;
        param coupler = 120mm;
        param rocker = 100mm;
        param ground = 140mm;
        input phi = 60deg in 0deg..360deg;
        unknown theta = 40deg;
        unknown psi = 80deg;
        loop polar(crank, phi) + polar(coupler, theta) = (ground, 0) + polar(rocker, psi);

        let sum = a + b * sin(phi) + cos(psi) / 4;
        let cube = sum * sum * sum;
        let inverse = 1 / (sum * sum * sum);
        let nested = a / (b / (c / sum));
        let fraction = a / (1 + b / (1 + c / sum));
        let left = a / b / c / sum - (a - (b - sum));
    }
    impl Quotients0 {
        pub fn motion(phi) -> Motion {
            cube, inverse, nested, fraction, left,
            v0: velocity(cube), v1: velocity(inverse), v2: velocity(nested), v3: velocity(fraction), v4: velocity(left),
            a0: acceleration(cube), a1: acceleration(inverse), a2: acceleration(nested), a3: acceleration(fraction),
            a4: acceleration(left),
            s0: sensitivity(cube), s1: sensitivity(inverse), s2: sensitivity(nested), s3: sensitivity(fraction),
            s4: sensitivity(left),
            m0: sensitivity(velocity(cube)), m1: sensitivity(velocity(inverse)), m2: sensitivity(velocity(nested)),
            m3: sensitivity(velocity(fraction)), m4: sensitivity(velocity(left)),
        }
    }
}

#[test]
fn derivatives_of_generated_rust_are_differences() {
    let all = Quotients::written();
    let results = all.calls(Precision::DOUBLE).into_iter().map(|call| {
        let [a, b, c, crank, coupler, rocker, ground] =
            call.dimensions.try_into().expect("as declared");
        let own = Quotients0 {
            a,
            b,
            c,
            crank,
            coupler,
            rocker,
            ground,
        };
        let motion = own
            .assemble()
            .expect("it closes")
            .motion(call.degrees.to_radians());
        let mut numbers = Vec::new();
        for q in [
            motion.cube,
            motion.inverse,
            motion.nested,
            motion.fraction,
            motion.left,
        ] {
            q.append(&mut numbers);
        }
        for v in [motion.v0, motion.v1, motion.v2, motion.v3, motion.v4] {
            v.append(&mut numbers);
        }
        for a in [motion.a0, motion.a1, motion.a2, motion.a3, motion.a4] {
            a.append(&mut numbers);
        }
        for s in [motion.s0, motion.s1, motion.s2, motion.s3, motion.s4] {
            s.append(&mut numbers);
        }
        for m in [motion.m0, motion.m1, motion.m2, motion.m3, motion.m4] {
            m.append(&mut numbers);
        }
        numbers
    });
    all.check("Rust", Precision::DOUBLE, &results.collect::<Vec<_>>());
}

/// How many random mechanisms.
const RANDOM: u64 = 40;

#[test]
fn derivatives_of_programs_are_differences() {
    for seed in 1..=RANDOM {
        let all = Quotients::random(seed);
        let unit = &all.given.unit;
        let results = all.calls(Precision::DOUBLE).into_iter().map(|call| {
            let assembled = Assembled::new(unit, &call.dimensions).expect("it closes");
            assembled.call(&unit.functions[0], &[call.degrees.to_radians()])
        });
        all.check("programs", Precision::DOUBLE, &results.collect::<Vec<_>>());
    }
}
