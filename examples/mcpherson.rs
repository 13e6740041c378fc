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
        0.014675161481191659,
        0.027287510667899667,
        -1.03059019324084,
        749.2396354943455,
        530.2844031945009,
    ],
    [
        0.0,
        0.001699998362336173,
        -0.00869976793844659,
        0.0,
        760.0,
        456.0405683708413,
    ],
    [
        80.0,
        -0.01628771385563514,
        -0.023140664647893987,
        -0.48163486148192447,
        754.7602836448934,
        377.7680434237684,
    ],
];

/// Changes of toe and camber by the length of the tie rod without travel, in radians per mm.
const BY_TIE_ROD: [f64; 2] = [0.007141988503358234, -0.0003148916014276752];

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
