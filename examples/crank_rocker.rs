//! A crank-rocker: assemblies, a sweep, changed dimensions, sensitivities, tolerances.
//!
//! The text of the mechanism is in `mechanisms/crank_rocker.rs`. Its crank is 40 mm long, coupler, rocker and frame are
//! 120, 80 and 100 mm.

mod check;

use check::Check;
use std::error::Error;

include!("../mechanisms/crank_rocker.rs");

fn main() -> Result<(), Box<dyn Error>> {
    let mut check = Check::default();
    let mechanism = CrankRocker::default();
    let linkage = mechanism.assemble()?;
    let phi = 40f64.to_radians();
    println!("{}", CrankRocker::STRUCTURE);

    println!("Coupler point and margin at 40 degrees:");
    let m = linkage.motion(phi);
    check.near("x, mm", m.tracer.x, 68.969552615300, 1e-10);
    check.near("y, mm", m.tracer.y, 71.874061421707, 1e-10);
    check.near("dx/dphi, mm", m.v.x, -18.102226518192, 1e-10);
    check.near("dy/dphi, mm", m.v.y, 24.323958522574, 1e-10);
    check.near(
        "|sin| of transmission angle",
        m.margin,
        0.602191266564,
        1e-11,
    );

    println!("Assemblies at 40 degrees:");
    let assemblies = mechanism.assemblies()?;
    check.holds("two of them", assemblies.len() == 2);
    let mut angles: Vec<Angles> = assemblies.iter().map(|l| l.angles(phi)).collect();
    angles.sort_by(|a, b| b.psi.total_cmp(&a.psi));
    for (angles, known) in angles.iter().zip([57.324880070, -98.004964078]) {
        check.near("psi, deg", angles.psi.to_degrees(), known, 1e-9);
    }

    println!("The rocker over a turn of the crank:");
    let degrees = (0..=3600).map(|i| f64::from(i) / 10.0);
    let cycle: Vec<f64> = degrees.map(f64::to_radians).collect();
    let columns = linkage.angles_sweep(&cycle);
    let lowest = columns.psi().iter().copied().fold(f64::INFINITY, f64::min);
    let highest = columns.psi().iter().copied().fold(0.0, f64::max);
    // At the limits crank and coupler are in line: a triangle with sides 120 +- 40, 80, 100.
    check.near("lower limit, deg", lowest.to_degrees(), 54.900367805, 1e-4);
    check.near(
        "upper limit, deg",
        highest.to_degrees(),
        128.682187453,
        1e-4,
    );

    println!("Other dimensions at run time:");
    let longer = CrankRocker {
        crank: 41.0,
        ..mechanism
    };
    let psi = longer.assemble()?.angles(phi).psi;
    check.near(
        "crank 41 mm: psi, deg",
        psi.to_degrees(),
        56.203192375,
        1e-9,
    );
    let impossible = CrankRocker {
        coupler: 300.0,
        ..mechanism
    };
    let refused = impossible.assemble();
    check.holds("a coupler of 300 mm is refused", refused.is_err());

    println!("Sensitivities at 40 degrees:");
    let accuracy = linkage.accuracy(phi);
    let known = [
        -0.019542339369,
        -0.020757524551,
        0.016571808154,
        0.019468518686,
    ];
    let parameters = CrankRocker::PARAMETERS.iter();
    for ((parameter, value), known) in parameters.zip(accuracy.rocker_angle).zip(known) {
        let name = format!("dpsi/d{}, rad/mm", parameter.name);
        check.near(&name, value, known, 1e-11);
    }

    println!("Effects of the tolerances on the coupler point, in micrometres:");
    let mut worst = 0.0;
    for (parameter, s) in CrankRocker::PARAMETERS.iter().zip(&accuracy.point) {
        let share = 1e3 * s.norm() * parameter.tolerance;
        println!("       {:<8} {share:7.2}", parameter.name);
        worst += share;
    }
    println!("       at worst {worst:7.2}");
    check.finish()
}
