//! Generates the tracer point with its derivatives.

use std::error::Error;
use std::{env, fs, path::Path};

use arael_sym::{E, atan2, cos, cse, pow, sin, sqrt, sym, symbols};

/// The names of the inputs of all functions: the angle of the crank and seven dimensions.
const NAMES: [&str; 8] = ["phi", "a", "b", "c", "dx", "dy", "p", "u"];

/// The text of a function that returns the values of expressions.
fn function(name: &str, values: &[E]) -> String {
    let inputs = NAMES.map(|name| format!("{name}: f64")).join(", ");
    let (steps, values) = cse(values);
    let steps = steps
        .iter()
        .map(|(name, e)| format!("let {name} = {};\n", e.to_rust("f64")));
    let results: Vec<String> = values.iter().map(|e| e.to_rust("f64")).collect();
    let steps: String = steps.collect();
    format!(
        "pub fn {name}({inputs}) -> [f64; {}] {{\n{steps}[{}]\n}}\n",
        results.len(),
        results.join(", ")
    )
}

fn main() -> Result<(), Box<dyn Error>> {
    let (point, angle) = sym! {
        let (phi, a, b, c, dx, dy, p, u) = symbols!(phi, a, b, c, dx, dy, p, u);
        let ax = a * cos(phi);
        let ay = a * sin(phi);
        let x = dx - ax;
        let y = dy - ay;
        let square = pow(x, 2.0) + pow(y, 2.0);
        let along = (square + pow(b, 2.0) - pow(c, 2.0)) / (2.0 * square);
        let across = sqrt(pow(b, 2.0) / square - pow(along, 2.0));
        let bx = x * along - y * across;
        let by = y * along + x * across;
        let m = p * cos(u) / b;
        let n = p * sin(u) / b;
        ([ax + bx * m - by * n, ay + bx * n + by * m], atan2(by - y, bx - x))
    };
    let first = point.each_ref().map(|q| q.diff("phi"));
    let second = first.each_ref().map(|q| q.diff("phi"));
    let effects = point.each_ref().map(|q| {
        NAMES[1..]
            .iter()
            .map(|name| q.diff(*name))
            .collect::<Vec<_>>()
    });
    let slope = angle.diff("phi");
    let code = [
        function("point", &point),
        function("motion", &[point.clone(), first, second].concat()),
        function(
            "sensitivities",
            &[&point[..], &effects[0], &effects[1]].concat(),
        ),
        function("rocker", &[angle, slope]),
    ];
    let folder = env::var("OUT_DIR")?;
    fs::write(Path::new(&folder).join("four_bar.rs"), code.concat())?;
    println!("cargo::rerun-if-changed=build.rs");
    Ok(())
}
