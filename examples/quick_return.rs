//! Quick return of a shaper: crank and slotted lever (RPR), then a rod to the ram (RRP).
//!
//! The crank pin slides in the lever: the guide turns. The ram cuts while the crank makes the
//! larger part of its turn; the time ratio is (180 + 2 b) / (180 - 2 b), sin b = crank / frame.

mod check;

use check::Check;
use std::error::Error;

include!("../mechanisms/quick_return.rs");

pub(crate) fn main() -> Result<(), Box<dyn Error>> {
    let mut check = Check::default();
    let mechanism = QuickReturn::default();
    let linkage = mechanism.assemble()?;
    println!("{}", QuickReturn::STRUCTURE);
    let kinds: Vec<&str> = QuickReturn::STRUCTURE
        .groups
        .iter()
        .map(|g| g.kind)
        .collect();
    check.holds("groups RPR, then RRP", kinds == ["RPR", "RRP"]);

    println!("Formulas by hand, over a turn of the crank:");
    let QuickReturn {
        frame,
        crank,
        lever,
        rod,
        height,
        ..
    } = mechanism;
    let mut known = Vec::new();
    let mut found = Vec::new();
    for degrees in 0..=360 {
        let phi = f64::from(degrees).to_radians();
        let (sin, cos) = phi.sin_cos();
        let psi = (frame + crank * sin).atan2(crank * cos);
        let drop = height - lever * psi.sin();
        let ram = lever * psi.cos() + (rod * rod - drop * drop).sqrt();
        known.push([
            (crank * cos).hypot(frame + crank * sin),
            psi,
            (drop / rod).asin(),
            ram,
        ]);
        let p = linkage.position(phi);
        found.push([p.along, p.psi, p.tilt, p.ram]);
    }
    for (column, name) in ["along, mm", "psi, rad", "tilt, rad", "ram, mm"]
        .iter()
        .enumerate()
    {
        let pairs = found
            .iter()
            .zip(&known)
            .map(|(f, k)| (f[column], k[column]));
        check.all_near(name, pairs, 1e-11);
    }

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

    println!("Ends of the stroke, where the ram stands still:");
    let still =
        |lo: f64, hi: f64| bisect(lo.to_radians(), hi.to_radians(), |x| linkage.stroke(x).v);
    let left = still(180.0, 230.0);
    let right = still(310.0, 359.0);
    check.near(
        "left end at, deg",
        left.to_degrees(),
        203.578178478202,
        1e-9,
    );
    check.near(
        "right end at, deg",
        right.to_degrees(),
        336.421821521798,
        1e-9,
    );
    let stroke = linkage.stroke(right).ram - linkage.stroke(left).ram;
    check.near(
        "stroke = 2 lever crank / frame, mm",
        stroke,
        2.0 * lever * crank / frame,
        1e-10,
    );
    let b = (crank / frame).asin().to_degrees();
    let ratio = (360.0 - (right - left).to_degrees()) / (right - left).to_degrees();
    check.near(
        "time ratio",
        ratio,
        (180.0 + 2.0 * b) / (180.0 - 2.0 * b),
        1e-10,
    );
    check.near("time ratio", ratio, 1.709952781721, 1e-10);
    check.finish()
}

/// Where `f` changes its sign between `lo` and `hi`.
fn bisect(mut lo: f64, mut hi: f64, f: impl Fn(f64) -> f64) -> f64 {
    let rising = f(hi) > f(lo);
    for _ in 0..60 {
        let middle = 0.5 * (lo + hi);
        if (f(middle) > 0.0) == rising {
            hi = middle;
        } else {
            lo = middle;
        }
    }
    0.5 * (lo + hi)
}
