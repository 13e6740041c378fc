//! Quick return of a shaper: crank and slotted lever (RPR), then a rod to the ram (RRP).
//!
//! The crank pin slides in the lever: the guide turns. The ram cuts while the crank makes the
//! larger part of its turn; the time ratio is (180 + 2 b) / (180 - 2 b), sin b = crank / frame.

mod check;

use check::Check;
use std::error::Error;

include!("../mechanisms/quick_return.rs");

fn main() -> Result<(), Box<dyn Error>> {
    let mut check = Check::default();
    let mechanism = QuickReturn::default();
    let linkage = mechanism.assemble()?;
    println!("{}", QuickReturn::STRUCTURE);
    let groups = QuickReturn::STRUCTURE.groups.iter();
    let kinds: Vec<&str> = groups.map(|group| group.kind).collect();
    check.holds("groups RPR, then RRP", kinds == ["RPR", "RRP"]);

    println!("Formulas of the textbook, over a turn of the crank:");
    let QuickReturn {
        frame,
        crank,
        lever,
        rod,
        height,
        ..
    } = mechanism;
    let rows = (0..=360).map(|degrees| {
        let phi = f64::from(degrees).to_radians();
        let (sin, cos) = phi.sin_cos();
        let psi = (frame + crank * sin).atan2(crank * cos);
        let drop = height - lever * psi.sin();
        let ram = lever * psi.cos() + (rod * rod - drop * drop).sqrt();
        let along = (crank * cos).hypot(frame + crank * sin);
        (
            linkage.position(phi),
            [along, psi, (drop / rod).asin(), ram],
        )
    });
    let rows: Vec<(Position, [f64; 4])> = rows.collect();
    let pairs = |found: fn(&Position) -> f64, column: usize| {
        let pairs = rows.iter().map(|(p, known)| (found(p), known[column]));
        pairs.collect::<Vec<_>>()
    };
    check.all_near("along, mm", pairs(|p| p.along, 0), 1e-11);
    check.all_near("psi, rad", pairs(|p| p.psi, 1), 1e-11);
    check.all_near("tilt, rad", pairs(|p| p.tilt, 2), 1e-11);
    check.all_near("ram, mm", pairs(|p| p.ram, 3), 1e-11);

    println!("Ends of the stroke, where the ram stands still:");
    let still = |from: f64, to: f64| {
        let [from, to] = [from, to].map(f64::to_radians);
        bisect(from, to, |phi| linkage.stroke(phi).v)
    };
    let (left, right) = (still(180.0, 230.0), still(310.0, 359.0));
    for (name, end, known) in [
        ("left end at, deg", left, 203.578178478202),
        ("right end at, deg", right, 336.421821521798),
    ] {
        check.near(name, end.to_degrees(), known, 1e-9);
    }
    let stroke = linkage.stroke(right).ram - linkage.stroke(left).ram;
    let known = 2.0 * lever * crank / frame;
    check.near("stroke = 2 lever crank / frame, mm", stroke, known, 1e-10);
    let b = (crank / frame).asin().to_degrees();
    let back = (right - left).to_degrees();
    let known = (180.0 + 2.0 * b) / (180.0 - 2.0 * b);
    for known in [known, 1.709952781721] {
        check.near("time ratio", (360.0 - back) / back, known, 1e-10);
    }
    check.finish()
}

/// The zero of `f` between `from` and `to`.
fn bisect(mut from: f64, mut to: f64, f: impl Fn(f64) -> f64) -> f64 {
    let rising = f(to) > f(from);
    for _ in 0..60 {
        let middle = 0.5 * (from + to);
        if (f(middle) > 0.0) == rising {
            to = middle;
        } else {
            from = middle;
        }
    }
    0.5 * (from + to)
}
