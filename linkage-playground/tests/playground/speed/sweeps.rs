//! Times of sweeps.

use std::time::Instant;

use linkage_playground::answer;
use serde_json::{Value, json};

use crate::node::answers;

/// The kernel K1b of the speed tables: a coupler point with both derivatives.
const K1: &str = "
    pub struct K1 {
        unit mm;
        param a = 50mm; param b = 120mm; param c = 100mm;
        param d = (140mm, 0mm); param p = 70mm; param u = 25deg;
        input phi = 30deg in 0deg..360deg;
        unknown theta = 40deg; unknown psi = 80deg;
        let pin = polar(a, phi);
        loop pin + polar(b, theta) = d + polar(c, psi);
        let point = pin + polar(p, theta + u);
    }
    impl K1 { pub fn motion(phi) -> Motion { point, v: velocity(point), a: acceleration(point) } }";

const POSITIONS: usize = 1024;
const SWEEPS: usize = 1000;
const ROUNDS: usize = 9;
/// The largest ratio of the times.
const LIMIT: f64 = 3.0;

/// The shortest times of a sweep in nanoseconds for a position: in a browser's engine, and here.
#[test]
#[ignore = "measures"]
fn speed_of_sweeps() {
    let request = |repeats: usize| json!({ "do": "sweep", "text": K1, "function": "motion", "positions": POSITIONS, "repeats": repeats });
    let pairs = [request(1), request(1 + SWEEPS)];
    let requests: Vec<Value> = pairs.iter().cycle().take(2 * ROUNDS).cloned().collect();
    let Some(answered) = answers(&requests) else {
        return;
    };
    let least = |times: &[f64]| {
        let spent = times.chunks(2).map(|pair| pair[1] - pair[0]);
        spent.fold(f64::INFINITY, f64::min) * 1e6 / (POSITIONS * SWEEPS) as f64
    };
    let there: Vec<f64> = answered.iter().map(|each| each.milliseconds).collect();
    let here = requests.iter().map(|request| {
        let begin = Instant::now();
        let answer = answer(&request.to_string());
        assert!(answer.contains("sum"), "{answer}");
        begin.elapsed().as_secs_f64() * 1e3
    });
    let (there, here) = (least(&there), least(&here.collect::<Vec<f64>>()));
    println!(
        "K1b: {there:.2} ns in node, {here:.2} ns here, {:.2} times",
        there / here
    );
    assert!(there / here <= LIMIT, "at most {LIMIT} times");
}
