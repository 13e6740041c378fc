//! Masses of robots in space: torques against the change of the potential energy, kinetic energies
//! against velocities by differences.

use linkage_engine::Mechanism;
use linkage_import::Options;

use crate::imported;

type Vector = [f64; 3];

fn minus(a: Vector, b: Vector) -> Vector {
    [0, 1, 2].map(|k| a[k] - b[k])
}

fn dot(a: Vector, b: Vector) -> f64 {
    (0..3).map(|k| a[k] * b[k]).sum()
}

#[test]
fn masses_in_space_have_weight_and_inertia() {
    const GRAVITY: f64 = 9.81;
    const STEP: f64 = 1e-4;
    let text = imported("space_bar.xml", &Options::default()).text;
    let functions = "impl SpaceBar {
        pub fn load(motor_2, omega) -> Load { torque: torque(motor_2), energy: kinetic_energy() }
        pub fn statics(motor_2) -> Statics { torque: torque(motor_2) }
        pub fn centres(motor_2) -> Centres {
            crank: at_motor_2 + turn(crank_centre, (1, 0, 0), motor_2),
            start: at_ball, end: closing_end, turn: bearing,
            rocker: at_bearing + turn(rocker_centre, (0, 0.34, 0.94), bearing),
        }";
    let text = text.replacen("impl SpaceBar {", functions, 1).replacen(
        "-20deg..20deg;",
        "-20deg..20deg at omega;",
        1,
    );
    let mechanism = Mechanism::compile(&text).unwrap_or_else(|error| panic!("{error}\n{text}"));
    let assembly = mechanism
        .assemble(&mechanism.dimensions())
        .expect("it closes");
    let centres = |x: f64| {
        let results = assembly.results("centres", &[x]);
        let points = ["crank", "start", "end", "rocker"];
        (
            points.map(|name| results.vector::<3>(name)),
            results["turn"],
        )
    };
    let potential = |x: f64| {
        let ([crank, start, end, rocker], _) = centres(x);
        let rod = (start[2] + end[2]) / 2.0;
        GRAVITY * (0.2 * crank[2] + 0.4 * rod + 0.3 * rocker[2])
    };
    for x in [-0.2, 0.05, 0.3] {
        let change = (potential(x + STEP) - potential(x - STEP)) / (2.0 * STEP);
        let torque = assembly.results("statics", &[x])["torque"];
        assert!((torque - change).abs() < 1e-7, "{torque} and {change}");
        // The centre of the rod, its direction, and the turns of crank and rocker, at 3 rad/s.
        let omega = 3.0;
        let ([_, start, end, _], _) = centres(x);
        let ((before, turn_before), (after, turn_after)) = (centres(x - STEP), centres(x + STEP));
        let rate = |point: usize| {
            minus(after[point], before[point]).map(|shift| omega * shift / (2.0 * STEP))
        };
        let (first, second) = (rate(1), rate(2));
        let middle = [0, 1, 2].map(|k| (first[k] + second[k]) / 2.0);
        let (across, rod) = (minus(second, first), minus(end, start));
        let spin = dot(across, across) / dot(rod, rod);
        let crank = 1e-4 + 0.2 * (0.015f64.powi(2) + 0.002f64.powi(2));
        let norm = 0.34f64.hypot(0.94);
        let (y, z) = (0.34 / norm, 0.94 / norm);
        let arm = [y * 0.03 - z * 0.02, z * 0.01, -y * 0.01];
        let rocker = 2e-4 * y * y + 3e-4 * z * z + 0.3 * dot(arm, arm);
        let psi = omega * (turn_after - turn_before) / (2.0 * STEP);
        let energy = 0.5
            * (crank * omega * omega
                + 0.4 * dot(middle, middle)
                + 2e-4 * spin
                + rocker * psi * psi);
        let found = assembly.results("load", &[x, omega])["energy"];
        assert!(
            (found - energy).abs() < 1e-7 * energy,
            "{found} and {energy}"
        );
    }
}

#[test]
fn masses_beside_the_line_of_a_rod_are_named() {
    let text = String::from_utf8(crate::file("space_bar.xml")).expect("text");
    let beside = text.replace("pos=\"0.055 0.03 -0.015\"", "pos=\"0.055 0.03 0\"");
    let found = linkage_import::import(beside.as_bytes(), "a.xml", &Options::default());
    let found = found.expect("a mechanism");
    let warning = "the mass of the rod `coupler` is left out: its centre is beside its line";
    assert!(found.warnings.iter().any(|text| text == warning));
    assert!(!found.text.contains("mass 0.4kg"), "{}", found.text);
}
