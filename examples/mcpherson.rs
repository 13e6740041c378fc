//! A McPherson strut by the travel of the wheel: a lower arm, a tie rod, and a damper whose axis is fixed on the wheel
//! carrier and goes through the top mount.
//!
//! The wheel carrier is an unknown body in space. Toe, camber, track and the length of the strut are compared with a
//! solution in 80 digits.

mod check;

use check::Check;
use std::error::Error;

include!("../mechanisms/mcpherson.rs");

/// Travel in mm; toe and camber in radians, x and y of the wheel and the length of the strut in mm.
const KNOWN: [[f64; 6]; 3] = [
    [
        -80.0,
        0.0146751614811916576542425,
        0.0272875106678996666662584,
        -1.030590193240839817118580,
        749.23963549434551998346028,
        530.28440319450094364873490,
    ],
    [
        0.0,
        0.0016999983623361730414713,
        -0.008699767938446589552506,
        0.0,
        760.0,
        456.04056837084132377284109,
    ],
    [
        80.0,
        -0.016287713855635140699308,
        -0.023140664647893985363657,
        -0.481634861481924466907609,
        754.76028364489344026448474,
        377.76804342376841505985898,
    ],
];

/// Changes of toe and camber by the length of the tie rod without travel, in radians per mm.
const BY_TIE_ROD: [f64; 2] = [0.0071419885033582339772565, -0.000314891601427675210067];

fn main() -> Result<(), Box<dyn Error>> {
    let mut check = Check::default();
    let strut = McPherson::default().assemble()?;
    println!("{}", McPherson::<f64>::STRUCTURE);

    for [travel, toe, camber, x, y, length] in KNOWN {
        println!("Travel {travel} mm:");
        let wheel = strut.wheel(travel);
        check.near("toe, rad", wheel.toe, toe, 1e-15);
        check.near("camber, rad", wheel.camber, camber, 1e-15);
        check.near("x, mm", wheel.x, x, 1e-12);
        check.near("y, mm", wheel.y, y, 1e-12);
        check.near("strut, mm", wheel.strut_length, length, 1e-12);
    }

    println!("The curves of a suspension, in degrees and mm:");
    println!("  travel      toe   camber    track    strut  strut by travel");
    for travel in (-80..=80).step_by(20).map(f64::from) {
        let (wheel, by_travel) = (strut.wheel(travel), strut.motion(travel));
        println!(
            "  {travel:6.0} {:8.4} {:8.4} {:8.3} {:8.3} {:16.4}",
            wheel.toe.to_degrees(),
            wheel.camber.to_degrees(),
            2.0 * wheel.y,
            wheel.strut_length,
            by_travel.strut_length
        );
    }

    println!("The tie rod sets the toe and hardly changes the camber:");
    let adjustment = strut.adjustment(0.0);
    let tie_rod = McPherson::<f64>::INDEX_TIE_ROD;
    check.near("toe, rad/mm", adjustment.toe[tie_rod], BY_TIE_ROD[0], 1e-15);
    check.near(
        "camber, rad/mm",
        adjustment.camber[tie_rod],
        BY_TIE_ROD[1],
        1e-15,
    );
    check.finish()
}
