//! Links that hang on nothing but their slots, in forces: torques are those of the energy, and
//! reactions are in equilibrium.

use linkage_engine::{Assembly, Mechanism};

/// The weight of 2 kg in newtons.
const WEIGHT: f64 = 2.0 * 9.81;

/// Lengths are millimetres, so torques are newton millimetres.
const SMALL: f64 = 1e-8;

/// A plate with two slots on fixed pins, its angle is the input.
const ON_FIXED_PINS: &str = "
pub struct Plate {
    unit mm;
    input phi = 30deg in 5deg..80deg;
    gravity = (0, -9.81m/s^2);
    joint p = (0mm, 0mm), q = (60mm, 0mm);
    joint m = (45mm, 25.980762113533mm), e = (88.301270189222mm, 50.980762113533mm);
    joint f = (25mm, 60.621778264911mm);
    link frame: p, q;
    link plate: m, e, f at phi mass 2kg at f;
    slider u: p on plate along m, e;
    slider v: q on plate along m, f;
}
impl Plate {
    fn forces(phi) -> Forces {
        t: torque(phi), e: d(potential_energy(), phi), u: reaction(u), v: reaction(v), m, f, q,
    }
}";

/// A plate that keeps its angle to the crank on which it slides.
const ON_A_BLOCK: &str = "
pub struct Plate {
    unit mm;
    input phi = 30deg in 20deg..60deg;
    gravity = (0, -9.81m/s^2);
    joint o = (0mm, 0mm), q = (60mm, 40mm);
    joint p = (25.980762113533mm, 15mm), m = (30.321966555206mm, -9.620193825305mm);
    joint e = (19.903075895191mm, 49.468271355427mm), f = (71.385868252963mm, 59.036604653484mm);
    link frame: o, q;
    link crank: o, p at phi;
    link plate: m, e, f mass 2kg at f;
    slider u: p on plate along m, e, block crank;
    slider v: q on plate along m, f;
}
impl Plate {
    fn forces(phi) -> Forces {
        t: torque(phi), e: d(potential_energy(), phi), u: reaction(u), v: reaction(v), m, f, q,
        moment: moment(u),
    }
}";

/// Calls `check` with an assembly and inputs over its range.
fn over_the_range(text: &str, check: impl Fn(&Assembly, f64)) {
    let mechanism = Mechanism::compile(text).unwrap_or_else(|error| panic!("{error}"));
    let assembly = mechanism
        .assemble(&mechanism.dimensions())
        .expect("it closes");
    let (low, high) = mechanism.inputs()[0].range.expect("a range");
    for step in 0..=20 {
        check(&assembly, low + (high - low) * f64::from(step) / 20.0);
    }
}

#[test]
fn torques_are_those_of_the_energy() {
    for text in [ON_FIXED_PINS, ON_A_BLOCK] {
        over_the_range(text, |assembly, phi| {
            let results = assembly.results("forces", &[phi]);
            let [torque, energy] = ["t", "e"].map(|name| results[name]);
            assert!(torque.abs() > 1.0, "{torque}");
            assert!(
                (torque - energy).abs() < SMALL * energy.abs().max(1.0),
                "{torque} {energy}"
            );
        });
    }
}

#[test]
fn reactions_hold_the_weight() {
    for text in [ON_FIXED_PINS, ON_A_BLOCK] {
        over_the_range(text, |assembly, phi| {
            let results = assembly.results("forces", &[phi]);
            let vector = |name: &str| results.vector::<2>(name);
            let [u, v] = ["u", "v"].map(vector);
            let sum = [u[0] + v[0], u[1] + v[1] - WEIGHT];
            assert!(sum.iter().all(|x| x.abs() < SMALL), "{phi}: {sum:?}");
        });
    }
}

/// The moment of the block is about the origin of the link with the slot.
#[test]
fn a_block_holds_the_moment() {
    over_the_range(ON_A_BLOCK, |assembly, phi| {
        let results = assembly.results("forces", &[phi]);
        let vector = |name: &str| results.vector::<2>(name);
        let [m, f, q, v] = ["m", "f", "q", "v"].map(vector);
        let of_pin = (q[0] - m[0]) * v[1] - (q[1] - m[1]) * v[0];
        let sum = results["moment"] + of_pin - WEIGHT * (f[0] - m[0]);
        assert!(sum.abs() < 1e-6, "{phi}: {sum}");
    });
}
