//! A boom lifted by a hydraulic cylinder: the drive is a length, inside a link that turns.
//!
//! The cylinder's force follows from the motion alone: by virtual work it holds a load with
//! `force = load * d(height) / d(stroke)`.

mod check;

use check::Check;
use std::error::Error;

include!("../mechanisms/hydraulic_cylinder.rs");

/// Stroke, cylinder and boom angle (deg), tip, d lift/d stroke, first and second derivative of the
/// tip's height.
const KNOWN: [[f64; 8]; 3] = [
    [
        0.0,
        67.700395077632,
        16.382582531121,
        2.981405276778,
        0.333500488155,
        1.164568391310,
        3.472050347020,
        0.930315353447,
    ],
    [
        0.3,
        79.713540689440,
        37.911696496299,
        2.651010262117,
        1.404330655561,
        1.363861813975,
        3.615611664957,
        -0.112141516570,
    ],
    [
        0.6,
        94.186433888121,
        64.786236651283,
        1.729885771837,
        2.451019219915,
        1.851860672273,
        3.203507428390,
        -3.482532798743,
    ],
];

fn main() -> Result<(), Box<dyn Error>> {
    let mut check = Check::default();
    let mechanism = Boom::default();
    let linkage = mechanism.assemble()?;
    println!("{}", Boom::STRUCTURE);

    for [stroke, cylinder, lift, x, y, rate, height, bend] in KNOWN {
        println!("Stroke {stroke} m:");
        let p = linkage.position(stroke);
        let m = linkage.motion(stroke);
        check.near("cylinder, deg", p.cylinder.to_degrees(), cylinder, 1e-10);
        check.near("boom, deg", p.lift.to_degrees(), lift, 1e-10);
        check.near("tip x, m", p.tip.x, x, 1e-11);
        check.near("tip y, m", p.tip.y, y, 1e-11);
        check.near("boom, rad per m of stroke", m.rate, rate, 1e-11);
        check.near("tip's rise per stroke", m.height, height, 1e-11);
        check.near("its change, 1/m", m.bend, bend, 1e-10);
        let between = p.lift - p.cylinder;
        check.near(
            "margin: |sin| between cylinder and arm",
            m.margin,
            between.sin().abs(),
            1e-12,
        );
        println!(
            "       cylinder force for 10 kN at the tip: {:.2} kN",
            10.0 * m.height
        );
    }

    let beyond = linkage.position(0.95);
    check.holds(
        "a stroke of 0.95 m cannot be reached: NaN",
        beyond.lift.is_nan() && beyond.tip.x.is_nan(),
    );
    check.finish()
}
