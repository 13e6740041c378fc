//! Quick return of a shaper: two positions with derivatives; the example `quick_return` has the other checks.

use crate::check::Check;
use std::error::Error;

include!("../../mechanisms/quick_return.rs");

#[test]
fn known_answers_are_met() -> Result<(), Box<dyn Error>> {
    let mut check = Check::default();
    let linkage = QuickReturn::default().assemble()?;
    println!("The ram at 40 and at 300 degrees:");
    for (degrees, ram, v, a) in [
        (40f64, 341.930680727791, -146.636274408555, -67.709559126460),
        (300.0, 375.561565667032, 228.487084786513, -493.841510119317),
    ] {
        let s = linkage.stroke(degrees.to_radians());
        check.near("ram, mm", s.ram, ram, 1e-10);
        check.near("d ram / d phi, mm", s.v, v, 1e-10);
        check.near("d2 ram / d phi2, mm", s.a, a, 1e-9);
    }
    check.finish()
}
