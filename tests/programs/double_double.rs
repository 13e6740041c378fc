//! More digits: a crank-rocker in double-double numbers, about 31 digits.
//!
//! Generated code works with every type that implements [`Scalar`]. The module `number` adapts the
//! double-doubles of the crate `xprec`; it is all that a program needs, and the mechanism stays as
//! it is. Uses: a reference for the rounding errors of `f64`, differences by tiny steps, positions
//! so near to a dead point that `f64` has no digits left.
//!
//! What is a double stays a double. Literals and the default dimensions are rounded to `f64` when
//! the program is compiled: the default coupler below is not 120.1 mm, but the double next to it.
//! More digits of a dimension come in where the user sets it, as the second part shows. So a number
//! that needs them must be a parameter: one that is written in a loop or a `let`, such as the 25 in
//! `theta + 25deg`, and the constant `PI` are doubles.

#[path = "double_double/number.rs"]
pub(crate) mod number;

use crate::check::Check;
use linkage::{Scalar, Vector2};
use number::DoubleDouble;
use std::error::Error;
use std::str::FromStr;

include!("../../mechanisms/double_double.rs");

/// A name and the digits of x, y of the point, its velocity and its acceleration, and psi.
///
/// The loop equations were solved by Newton's method in 160 digits, and the derivatives are central
/// differences of the solution, also in 160 digits.
type Known = [(&'static str, &'static str); 7];

/// At the double next to 0.7 rad, with the dimensions as doubles.
const OF_DOUBLES: Known = [
    ("x, mm", "68.98654409720281560662737176176154589154"),
    ("y, mm", "71.87715098573392503388394989250392518535"),
    ("dx/dphi, mm", "-18.25655834218578812799567065034677793659"),
    ("dy/dphi, mm", "24.33858879045959809315454969568204215359"),
    (
        "d2x/dphi2, mm",
        "-53.53852160330613856763261681757194611977",
    ),
    (
        "d2y/dphi2, mm",
        "-8.735838414280260836135412671449812274114",
    ),
    ("psi, rad", "0.9989573714775750557335203774480656362599"),
];

/// At 0.7 rad, with a coupler of 120.1 mm and a lift of 30 degrees.
const OF_DECIMALS: Known = [
    ("x, mm", "68.98654409720282016151007039898779384713"),
    ("y, mm", "71.87715098573392164696003639089877868152"),
    ("dx/dphi, mm", "-18.25655834218579391522218783555120018842"),
    ("dy/dphi, mm", "24.33858879045959906400056160894901900445"),
    (
        "d2x/dphi2, mm",
        "-53.53852160330613102774561182894316510746",
    ),
    (
        "d2y/dphi2, mm",
        "-8.735838414280260913999015174022252973695",
    ),
    ("psi, rad", "0.9989573714775749502657751503864522733576"),
];

fn numbers<T: Scalar>(motion: &Motion<T>) -> [T; 7] {
    let [tracer, v, a] = [motion.tracer, motion.v, motion.a];
    [tracer.x, tracer.y, v.x, v.y, a.x, a.y, motion.psi]
}

#[test]
fn known_answers_are_met() -> Result<(), Box<dyn Error>> {
    let mut check = Check::default();
    let mechanism = CrankRocker::default();

    println!("The same doubles, computed in f64 and in double-double:");
    let double = mechanism.assemble()?.motion(0.7);
    let wide = mechanism.cast::<DoubleDouble>().assemble()?;
    let more = wide.motion(DoubleDouble::from_f64(0.7));
    println!(
        "       {:<14} {:>20}   {:>35}   {:>9}",
        "", "f64", "double-double", "f64 error"
    );
    let mut errors = Vec::new();
    for ((&(name, _), few), many) in OF_DOUBLES.iter().zip(numbers(&double)).zip(numbers(&more)) {
        let error = (DoubleDouble::from_f64(few) - many).lane(0);
        println!("       {name:<14} {few:>20.15}   {many:>35}   {error:>9.1e}");
        errors.push((error, 0.0));
    }
    check.all_near("f64 against double-double", errors, 1e-12);
    compare(&mut check, &more, &OF_DOUBLES)?;

    println!("Decimal dimensions to all digits:");
    let exact = CrankRocker {
        coupler: "120.1".parse()?,
        lift: DoubleDouble::PI / DoubleDouble::from_f64(6.0),
        ..mechanism.cast()
    };
    let decimal = exact.assemble()?.motion("0.7".parse()?);
    compare(&mut check, &decimal, &OF_DECIMALS)?;
    let moved: Vector2<f64> =
        (decimal.tracer.zip_map(&more.tracer, |a, b| a - b)).map(|d| d.lane(0));
    println!(
        "       the point has moved by {:.1e}, {:.1e} mm",
        moved.x, moved.y
    );

    println!(
        "The rocker's velocity as a difference over 1e-14 rad, where f64 has two digits left:"
    );
    let phi = DoubleDouble::from_f64(0.7);
    let step = DoubleDouble::from_f64(5e-15);
    let [before, after] = [phi - step, phi + step].map(|phi| wide.motion(phi).psi);
    let slope = (after - before) / (step + step);
    let known = DoubleDouble::from_str("0.2825334365317718316093827576657")?;
    println!("       dpsi/dphi {slope:.18}");
    let error = (slope - known).lane(0);
    check.all_near("against the derivative", [(error, 0.0)], 1e-16);

    println!("What cannot be assembled:");
    let impossible = CrankRocker {
        coupler: "300".parse()?,
        ..mechanism.cast::<DoubleDouble>()
    };
    check.holds(
        "a coupler of 300 mm is refused",
        impossible.assemble().is_err(),
    );
    check.finish()
}

/// Compares all numbers of a motion with the known digits.
fn compare(
    check: &mut Check,
    motion: &Motion<DoubleDouble>,
    known: &Known,
) -> Result<(), Box<dyn Error>> {
    let mut errors = Vec::new();
    for (value, (_, digits)) in numbers(motion).into_iter().zip(known) {
        let known: DoubleDouble = digits.parse()?;
        errors.push((((value - known) / known).lane(0), 0.0));
    }
    check.all_near("relative to 40 known digits", errors, 1e-30);
    Ok(())
}
