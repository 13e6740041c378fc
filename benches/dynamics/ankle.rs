//! The ankle of a humanoid with its masses: mass matrix, bias and their derivatives.

use crate::timing::best;
use std::error::Error;
use std::hint::black_box;

linkage::mechanism! {
    /// Two motors in the shank turn a foot through two rods.
    struct HeavyAnkle {
        unit mm;
        param height = 230mm;
        param crank = 60mm;
        param side = 45mm;
        param heel = 50mm;
        param rise = 10mm;
        param rod = 230mm;
        param rotor = 900kg*mm^2;
        param ixx = 2100kg*mm^2;
        param iyy = 5200kg*mm^2;
        param izz = 6300kg*mm^2;
        input pitch = 0deg in -45deg..25deg at pitching;
        input roll = 0deg in -20deg..20deg at rolling;
        unknown left = 0deg;
        unknown right = 0deg;
        const x = (1, 0, 0);
        const y = (0, 1, 0);
        let along = turn(turn(x, x, roll), y, pitch);
        let up = turn(turn((0, 0, 1), x, roll), y, pitch);
        let foot = frame((0mm, 0mm, 0mm), along, up);
        let pivot_left = (0mm, side, height);
        let pivot_right = (0mm, -side, height);
        loop distance(pivot_left + turn((-crank, 0mm, 0mm), y, left), point_in(foot, (-heel, side, rise))) = rod;
        loop distance(pivot_right + turn((-crank, 0mm, 0mm), y, right), point_in(foot, (-heel, -side, rise))) = rod;
        body foot = ball on frame at (0mm, 0mm, 0mm), turns foot, inertia (ixx, iyy, izz);
        body left = pin on frame at pivot_left about y, turns left, inertia rotor;
        body right = pin on frame at pivot_right about y, turns right, inertia rotor;
    }
    impl HeavyAnkle {
        fn mass_matrix(pitch, roll) -> MassMatrix { mass: inertia() }
        fn terms(pitch, roll, pitching, rolling) -> Terms { mass: inertia(), first: bias(pitch), second: bias(roll) }
        fn slopes(pitch, roll, pitching, rolling) -> Slopes {
            mass: inertia(), first: bias(pitch), second: bias(roll),
            mass_by: velocity(inertia()), first_by: velocity(bias(pitch)), second_by: velocity(bias(roll)),
        }
    }
}

/// Positions in one run.
const POSITIONS: u32 = 1024;

/// Prints ns for a call.
pub(crate) fn print() -> Result<(), Box<dyn Error>> {
    let ankle = HeavyAnkle::default().assemble()?;
    // Scattered over the ranges, by multiples of two irrational numbers.
    let positions: Vec<[f64; 2]> = (0..POSITIONS)
        .map(|k| [0.618, 0.755].map(|share| (f64::from(k) * share).fract()))
        .map(|[a, b]| {
            [
                (-45.0 + 70.0 * a).to_radians(),
                (-20.0 + 40.0 * b).to_radians(),
            ]
        })
        .collect();
    let each = |name: &str, call: &dyn Fn(f64, f64)| {
        let time = best(|| {
            for &[pitch, roll] in &positions {
                call(pitch, roll);
            }
        });
        println!("  {name:<44} {:6.0}", 1e9 * time / f64::from(POSITIONS));
    };
    println!("parallel ankle: ns for a call");
    each("mass matrix", &|pitch, roll| {
        black_box(ankle.mass_matrix(pitch, roll));
    });
    each("mass matrix and bias", &|pitch, roll| {
        black_box(ankle.terms(pitch, roll, 1.0, -2.0));
    });
    each("mass matrix, bias, derivatives of both", &|pitch, roll| {
        black_box(ankle.slopes(pitch, roll, 1.0, -2.0));
    });
    println!("{}", HeavyAnkle::<f64>::STRUCTURE);
    Ok(())
}
