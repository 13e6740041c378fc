//! Generates the tracer point with its derivatives.

use std::error::Error;
use std::{env, fs, path::Path};

use symplex::matrix::Matrix;
use symplex::prelude::*;

/// The names of the inputs of all functions: the angle of the crank and seven dimensions.
const NAMES: [&str; 8] = ["phi", "a", "b", "c", "dx", "dy", "p", "u"];

fn main() -> Result<(), Box<dyn Error>> {
    let context = Context::new();
    let [phi, a, b, c, dx, dy, p, u] = NAMES.map(|name| context.symbol(name));
    let (ax, ay) = (&a * &phi.cos(), &a * &phi.sin());
    let (x, y) = (&dx - &ax, &dy - &ay);
    let square = &x.powi(2) + &y.powi(2);
    let along = (&square + &b.powi(2) - &c.powi(2)) / (&square * 2);
    let across = (&b.powi(2) / &square - &along.powi(2)).sqrt();
    let (bx, by) = (&x * &along - &y * &across, &y * &along + &x * &across);
    let (cos, sin) = (&p * &u.cos() / &b, &p * &u.sin() / &b);
    let point = [&ax + &bx * &cos - &by * &sin, &ay + &bx * &sin + &by * &cos];
    let angle = (&by - &y).atan2(&(&bx - &x));
    let first = [point[0].diff(&phi), point[1].diff(&phi)];
    let second = [first[0].diff(&phi), first[1].diff(&phi)];
    let dimensions = [a, b, c, dx, dy, p, u];
    let effects = point
        .each_ref()
        .map(|q| dimensions.each_ref().map(|d| q.diff(d)));
    let slope = angle.diff(&phi);

    let mut code = String::new();
    let mut add = |name: &str, values: Vec<Ex>| -> Result<(), SymplexError> {
        code += &Matrix::row_vector(values)?.to_rust_fn(name, &NAMES)?;
        Ok(())
    };
    add("point", point.to_vec())?;
    add("motion", [point.clone(), first, second].concat())?;
    add(
        "sensitivities",
        [&point[..], effects.as_flattened()].concat(),
    )?;
    add("rocker", vec![angle, slope])?;
    let folder = env::var("OUT_DIR")?;
    fs::write(Path::new(&folder).join("four_bar.rs"), code)?;
    println!("cargo::rerun-if-changed=build.rs");
    Ok(())
}
