//! `assemble_from` and `_sweep_sets` with other numbers than `f64`: each lane goes its own way, and digits and derivatives are those of
//! the scalar.

use linkage::{AssemblyError, Dual, Lanes, Scalar};
use linkage_reference::Random;
use num_dual::Dual64;
use simba::simd::AutoF64x4;

linkage::mechanism! {
    /// A crank, a triad with a slider, and a dyad behind it.
    struct Drive {
        unit mm;
        param crank = 27mm;
        param b = 97mm;
        param c = 42mm;
        param q1 = 102mm;
        param rod = 160mm;
        input phi = 30deg;
        unknown x1 = -21deg;
        unknown x2 = -121mm;
        unknown x3 = 153mm;
        unknown theta = 1deg;
        unknown beta = 0deg;
        unknown s = 300mm;
        let e1 = polar(crank, phi) + polar(q1, x1);
        let e3 = e1 + polar(c, theta + 30deg);
        loop e1 + polar(b, theta) = (96mm, -1mm) + polar(x2, 170deg);
        loop e3 = (28mm, 84mm) + polar(x3, theta - 35deg);
        loop e3 + polar(rod, beta) = (s, 30mm);
    }

    impl Drive {
        fn values(phi) -> Values { theta, x2, s }
        fn accuracy(phi) -> Accuracy { theta: sensitivity(theta), x2: sensitivity(x2), s: sensitivity(s) }
    }
}

linkage::mechanism! {
    /// Closed forms alone.
    struct FourBar {
        unit mm;
        param coupler = 120mm;
        input phi = 30deg;
        unknown theta = 40deg;
        unknown psi = 80deg;
        loop polar(50mm, phi) + polar(coupler, theta) = (140mm, 0) + polar(100mm, psi);
    }
    impl FourBar {
        fn psi(phi) -> Psi { psi }
    }
}

/// An input at which the dimensions below are compared.
const PHI: f64 = 0.7;

type Four = Lanes<AutoF64x4>;

macro_rules! list {
    ($v:expr) => {{
        let v = $v;
        [v.theta, v.x2, v.s]
    }};
}

#[track_caller]
fn close(found: f64, expected: f64, tolerance: f64) {
    let off = (found - expected).abs();
    assert!(
        off <= tolerance * expected.abs().max(1.0),
        "{found:e}, not {expected:e}"
    );
}

/// Drives whose dimensions differ by up to 15 %.
fn far(random: &mut Random) -> Drive {
    let mut near = |x: f64| x * random.between(0.85, 1.15);
    let m = Drive::default();
    Drive {
        crank: near(m.crank),
        b: near(m.b),
        c: near(m.c),
        q1: near(m.q1),
        rod: near(m.rod),
    }
}

/// Some of them side by side.
fn lanes(four: &[Drive; 4]) -> Drive<Four> {
    let field = |field: fn(&Drive) -> f64| Four::from_lanes(|lane| field(&four[lane]));
    Drive {
        crank: field(|m| m.crank),
        b: field(|m| m.b),
        c: field(|m| m.c),
        q1: field(|m| m.q1),
        rod: field(|m| m.rod),
    }
}

#[test]
fn each_lane_goes_its_own_way() {
    let mut random = Random::new(201);
    let single = Drive::default().assemble().expect("as written");
    let first = Drive::default()
        .cast::<Four>()
        .assemble()
        .expect("as written");
    let mut reached = 0;
    for _ in 0..20 {
        let four: [Drive; 4] = std::array::from_fn(|_| far(&mut random));
        let each = four.map(|one| one.assemble_from(&single));
        let together = lanes(&four).assemble_from(&first);
        let Ok(together) = together else {
            assert!(
                each.iter().any(Result::is_err),
                "every lane is reached: {four:?}"
            );
            continue;
        };
        let values = list!(together.values(Four::from_f64(PHI)));
        let rows = list!(
            first
                .values_sweep_sets(&[lanes(&four)], &[Four::from_f64(PHI)])
                .get(0)
        );
        for (lane, one) in each.iter().enumerate() {
            let one = one.as_ref().expect("the lanes are all reached");
            let expected = list!(one.values(PHI));
            for k in 0..3 {
                close(values[k].lane(lane), expected[k], 1e-13);
                close(rows[k].lane(lane), expected[k], 1e-13);
            }
        }
        reached += 1;
    }
    assert!(reached > 10, "{reached}");
}

#[test]
fn derivatives_and_single_precision_come_along() {
    let mut random = Random::new(202);
    let single = Drive::default().assemble().expect("as written");
    let dual = Drive::default()
        .cast::<Dual<Dual64>>()
        .assemble()
        .expect("as written");
    let short = Drive::default()
        .cast::<f32>()
        .assemble()
        .expect("as written");
    for _ in 0..20 {
        let other = far(&mut random);
        let expected = other.assemble_from(&single).expect("within reach");
        let mut moving = other.cast::<Dual<Dual64>>();
        moving.q1 = Dual(Dual64::new(other.q1, 1.0));
        let found = moving.assemble_from(&dual).expect("within reach");
        let found = list!(found.values(Dual::from_f64(PHI)));
        let rows = dual.values_sweep_sets(&[moving], &[Dual::from_f64(PHI)]);
        let rows = list!(rows.get(0));
        let accuracy = list!(expected.accuracy(PHI)).map(|by| by[Drive::INDEX_Q1]);
        let values = list!(expected.values(PHI));
        let small = other
            .cast::<f32>()
            .assemble_from(&short)
            .expect("within reach");
        let small = list!(small.values(PHI as f32));
        for k in 0..3 {
            for Dual(number) in [found[k], rows[k]] {
                close(number.re, values[k], 1e-13);
                close(number.eps, accuracy[k], 1e-11);
            }
            close(f64::from(small[k]), values[k], 2e-5);
        }
    }
}

#[test]
fn a_lane_that_is_blocked_blocks_all() {
    let first = FourBar::default()
        .cast::<Four>()
        .assemble()
        .expect("as written");
    let within = FourBar {
        coupler: Four::from_lanes(|lane| 120.0 + 5.0 * lane as f64),
    };
    let beyond = FourBar {
        coupler: Four::from_lanes(|lane| if lane == 2 { 300.0 } else { 125.0 }),
    };
    let found = within.assemble_from(&first).expect("all are within reach");
    let psi = found.psi(Four::from_f64(PHI)).psi;
    for lane in 0..4 {
        let coupler = 120.0 + 5.0 * lane as f64;
        let one = FourBar { coupler }.assemble().expect("within reach");
        close(psi.lane(lane), one.psi(PHI).psi, 1e-14);
    }
    let error = beyond
        .assemble_from(&first)
        .map(|_| ())
        .expect_err("one lane is not");
    assert!(matches!(error, AssemblyError::Blocked { .. }), "{error:?}");
}
