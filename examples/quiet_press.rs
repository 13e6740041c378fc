//! A press that runs quietly: the least peak of the driving torque over the length of the rod, the place of the guide and the counterweights on
//! the crank, with the stroke kept and the force on the guide limited.
//!
//! The ram works against a die cushion, a spring that is pressed at the lower end of the stroke and gives its energy back. At
//! constant speed the drive must deliver what cushion, weights and inertia forces take, and the same work is returned half a turn later: the peak
//! of the torque decides about motor and gears.
//!
//! What the peak costs at the guide is a front of compromises, from the least peak alone to the least force on the guide alone; so is what shakes the
//! foundation, which is limited to what it was. `cargo run --release --example quiet_press FOLDER` writes a page of them.
//!
//! The peak is checked in three ways: by samples, by other presses nearby, and by the least peak of counterweights alone, a linear problem that
//! `linkage::balancing` solves in another way and with a proof. The exit status is 1 if anything that is printed here does not hold.

mod check;

use check::Check;
use linkage::balancing::Balance;
use linkage::design::{
    BestCycle, Compromise, Curve, CycleDesign, Figure, Peak, RootMeanSquare, Stroke,
};
use linkage::mechanism;
use linkage::report::{Aim, Compared, Comparison, Report};
use std::error::Error;
use std::f64::consts::TAU;
use std::path::{Path, PathBuf};

mechanism! {
    /// A press with a vertical ram, on whose crank two masses may be fixed: along it, and across it.
    #[derive(Clone, Copy)]
    pub struct Press {
        unit mm;
        param crank  = 40mm;
        param rod    = 160mm;
        param offset = 8mm;
        param ahead  = 0kg;
        param across = 0kg;

        input phi = 30deg in 0deg..360deg at omega;
        unknown theta = -100deg;
        unknown ram   = -140mm;
        let p = polar(crank, phi);
        let q = p + polar(rod, theta);
        loop q = (offset, ram);

        gravity = (0, -9.80665m/s^2);
        body wheel = pin on frame at (0, 0), turns phi, mass 3kg at p / 2, inertia 4000kg*mm^2,
            mass ahead at polar(100mm, phi), mass across at polar(100mm, phi + 90deg);
        body link  = pin on wheel at p, turns theta, mass 2kg at p + polar(rod / 3, theta), inertia 5000kg*mm^2;
        body block = slide guide on frame at q along (0, 1), mass 12kg at q;
        pin knee = link on block at q;
        spring 6N/mm from block at q to frame at (offset, -400mm), free 300mm;
    }
    impl Press {
        /// The driving torque, with its derivatives by the crank's angle.
        pub fn drive(phi, omega) -> Drive {
            t: torque(phi), v: velocity(torque(phi)), a: acceleration(torque(phi)),
        }
        /// What the dimensions do to it.
        pub fn effects(phi, omega) -> Effects { e: sensitivity(torque(phi)) }
        /// The force of the guide on the ram, which is horizontal.
        pub fn side(phi, omega) -> Side {
            f: reaction(guide), v: velocity(reaction(guide)), a: acceleration(reaction(guide)), e: sensitivity(reaction(guide)),
        }
        /// The force on the foundation.
        pub fn shaking(phi, omega) -> Shaking {
            f: shaking_force(), v: velocity(shaking_force()), a: acceleration(shaking_force()), e: sensitivity(shaking_force()),
        }
        pub fn motion(phi) -> Motion { ram, v: velocity(ram), a: acceleration(ram), e: sensitivity(ram) }
        pub fn picture(phi) -> Picture { shape: picture() }
    }
}

const N: usize = Press::PARAMETERS.len();
/// 270 turns a minute, in rad/s.
const SPEED: f64 = 9.0 * std::f64::consts::PI;
/// What the guide bears, in N.
const SIDE: f64 = 105.0;

type Drawn<'a> = Curve<'a, PressAssembly, N>;

fn torque() -> Drawn<'static> {
    let jet = |press: &PressAssembly, phi| {
        let Drive { t, v, a } = press.drive(phi, SPEED);
        [t, v, a]
    };
    Curve::new(jet, |press, phi| press.effects(phi, SPEED).e)
}

fn side() -> Drawn<'static> {
    let jet = |press: &PressAssembly, phi| {
        let side = press.side(phi, SPEED);
        [side.f.x, side.v.x, side.a.x]
    };
    Curve::new(jet, |press, phi| {
        press.side(phi, SPEED).e.map(|force| force.x)
    })
}

/// The size of the force that shakes the foundation.
fn shaking() -> Drawn<'static> {
    let jet = |press: &PressAssembly, phi| {
        let force = press.shaking(phi, SPEED);
        [force.f, force.v, force.a].map(|f| [f.x, f.y])
    };
    Curve::length(jet, |press, phi| {
        press.shaking(phi, SPEED).e.map(|f| [f.x, f.y])
    })
}

fn ram() -> Drawn<'static> {
    let jet = |press: &PressAssembly, phi| {
        let motion = press.motion(phi);
        [motion.ram, motion.v, motion.a]
    };
    Curve::new(jet, |press, phi| press.motion(phi).e)
}

/// What may be changed, and what must be kept: the stroke.
fn open(stroke: f64) -> Result<CycleDesign<'static, Press, PressAssembly, N>, Box<dyn Error>> {
    let design = CycleDesign::new(
        Press::default(),
        Press::assemble,
        Press::assemble_from,
        Press::circuits,
    )?;
    let design = design
        .vary("crank", 35.0, 45.0)
        .vary("rod", 120.0, 220.0)
        .vary("offset", -25.0, 25.0);
    let design = design
        .vary("ahead", -60.0, 60.0)
        .vary("across", -60.0, 60.0);
    Ok(design.want(Stroke(ram()).equal(stroke)))
}

/// With a guide that bears so much.
fn design(stroke: f64) -> Result<CycleDesign<'static, Press, PressAssembly, N>, Box<dyn Error>> {
    Ok(open(stroke)?.want(Peak(side()).at_most(SIDE)))
}

/// Samples of a turn: between them a peak of these torques rises by some 1e-6 of itself.
const SAMPLES: u32 = 1440;

/// The largest of a figure over samples of a turn, without its sign.
fn sampled(figure: impl Fn(f64) -> f64) -> f64 {
    let sample = |i: u32| figure(TAU * f64::from(i) / f64::from(SAMPLES)).abs();
    (0..SAMPLES).map(sample).fold(0.0, f64::max)
}

fn print(what: &str, press: &PressAssembly) {
    let peak = sampled(|phi| press.drive(phi, SPEED).t);
    let side = sampled(|phi| press.side(phi, SPEED).f.x);
    let Press {
        crank,
        rod,
        offset,
        ahead,
        across,
    } = *press.mechanism();
    println!(
        "{what:<22} {:6.3} N m, guide {side:5.1} N: crank {crank:.3}, rod {rod:.2}, offset {offset:.2} mm, masses {ahead:.3} and {across:.3} kg",
        1e-3 * peak
    );
}

pub(crate) fn main() -> Result<(), Box<dyn Error>> {
    let first = Press::default().assemble()?;
    let height = |phi: f64| first.motion(phi).ram;
    let stroke = height(0.25 * TAU) - height(0.75 * TAU);
    let peak = design(stroke)?.want(Peak(torque()).least()).run()?;
    let mild = design(stroke)?
        .want(RootMeanSquare(torque()).least())
        .run()?;
    println!(
        "Peaks of the driving torque at {:.0} turns a minute:",
        SPEED * 60.0 / TAU
    );
    print("as it was", &first);
    print("least peak", &peak.assembly);
    print("least mean square", &mild.assembly);
    print!("{peak}");

    let mut check = Check::default();
    let before = sampled(|phi| first.drive(phi, SPEED).t);
    check.holds(
        "the peak is less than a quarter of what it was",
        peak.goal < 0.25 * before,
    );
    compare(&peak, stroke, &mut check);
    compare_counterweights(&peak, &mut check)?;
    let square = |press: &PressAssembly| {
        (0..720)
            .map(|i| press.drive(TAU * f64::from(i) / 720.0, SPEED).t.powi(2))
            .sum::<f64>()
    };
    check.near(
        "root mean square, N m",
        1e-3 * (square(&mild.assembly) / 720.0).sqrt(),
        1e-3 * mild.goal,
        1e-6,
    );
    let lower = square(&mild.assembly) < square(&peak.assembly) && mild.goal < peak.goal;
    check.holds(
        "the least mean square is below that of the least peak",
        lower,
    );
    compare_shaking(&first, &peak, stroke, &mut check)?;
    let front = open(stroke)?.front(Peak(torque()).least(), Peak(side()).least(), COMPROMISES)?;
    compare_front(&front, &peak, &mut check);
    if let Some(folder) = std::env::args_os().nth(1).filter(|_| !cfg!(test)) {
        println!(
            "Open {}",
            page(&first, &front, Path::new(&folder))?.display()
        );
    }
    check.finish()
}

/// Compromises of peak and guide.
const COMPROMISES: usize = 6;

/// With no more shaking than before the peak is higher than without that limit, and still lower than it was.
fn compare_shaking(
    first: &PressAssembly,
    peak: &BestCycle<Press, PressAssembly>,
    stroke: f64,
    check: &mut Check,
) -> Result<(), Box<dyn Error>> {
    let of = |press: &PressAssembly| {
        sampled(|phi| {
            let force = press.shaking(phi, SPEED).f;
            force.x.hypot(force.y)
        })
    };
    let (before, shaken) = (of(first), of(&peak.assembly));
    let calm = design(stroke)?
        .want(Peak(torque()).least())
        .want(Peak(shaking()).at_most(before))
        .run()?;
    print("no more shaking", &calm.assembly);
    println!(
        "  shaking: {before:.1} N before, {shaken:.1} N at the least peak, {:.1} N within its limit",
        of(&calm.assembly)
    );
    check.holds(
        "the foundation bears no more than before",
        of(&calm.assembly) <= before * (1.0 + 1e-6),
    );
    let torques = sampled(|phi| first.drive(phi, SPEED).t);
    let between = peak.goal * (1.0 - 1e-6) <= calm.goal && calm.goal < torques;
    check.holds("which costs some of the peak, not all of it", between);
    Ok(())
}

/// The front: none of its presses is better in both, and that of our guide is on it or beside it.
fn compare_front(
    front: &[Compromise<Press, PressAssembly>],
    peak: &BestCycle<Press, PressAssembly>,
    check: &mut Check,
) {
    println!("Peak of the torque against the force on the guide:");
    for found in front {
        println!(
            "  {:8.3} N m  {:7.1} N",
            1e-3 * found.best.goal,
            found.other
        );
    }
    let falls = |pair: &[Compromise<Press, PressAssembly>]| {
        pair[0].best.goal < pair[1].best.goal && pair[0].other > pair[1].other
    };
    check.holds(
        "compromises contradict each other",
        front.len() > 2 && front.windows(2).all(falls),
    );
    let beaten = |found: &Compromise<Press, PressAssembly>| {
        found.other <= SIDE && found.best.goal < peak.goal * (1.0 - 1e-5)
    };
    check.holds(
        "none is better than the press that was found",
        !front.iter().any(beaten),
    );
}

/// A page of the press as it was and all compromises.
fn page(
    first: &PressAssembly,
    front: &[Compromise<Press, PressAssembly>],
    folder: &Path,
) -> Result<PathBuf, Box<dyn Error>> {
    let presses = || core::iter::once(first).chain(front.iter().map(|found| &found.best.assembly));
    let reports: Vec<Report> = presses().map(report).collect();
    let about = "Each press has the least peak of the driving torque for what its guide bears; the stroke is kept.";
    let mut comparison = Comparison::new("A quiet press").about(about);
    for (k, (press, report)) in presses().zip(&reports).enumerate() {
        let name = if k == 0 {
            "as it was".to_string()
        } else {
            format!("compromise {k}")
        };
        let torque = 1e-3 * sampled(|phi| press.drive(phi, SPEED).t);
        let side = sampled(|phi| press.side(phi, SPEED).f.x);
        let compared = Compared::new(name, report)
            .figure("peak of the torque", torque, "N m")
            .figure("force on the guide", side, "N");
        comparison = comparison.design(compared);
    }
    let comparison = comparison.curves(["ram", "t"]).front([
        Aim::least("peak of the torque"),
        Aim::least("force on the guide"),
    ]);
    Ok(comparison.write(folder)?)
}

fn report(press: &PressAssembly) -> Report {
    let input = &Press::INPUTS[0];
    let phi = input.positions(361);
    Report::new("Press", input, &phi)
        .dimensions(press.mechanism())
        .structure(Press::STRUCTURE)
        .table(&press.motion_sweep(&phi))
        .table(&press.drive_sweep(&phi, &[SPEED]))
        .table(&press.picture_sweep(&phi))
}

/// The peak beside samples, and beside the presses nearby.
fn compare(peak: &BestCycle<Press, PressAssembly>, stroke: f64, check: &mut Check) {
    let of = |press: &PressAssembly| sampled(|phi| press.drive(phi, SPEED).t);
    check.near(
        "peak by samples, N m",
        1e-3 * of(&peak.assembly),
        1e-3 * peak.goal,
        1e-4,
    );
    let highest = sampled(|phi| peak.assembly.side(phi, SPEED).f.x);
    check.holds("the guide bears its force", highest < SIDE * (1.0 + 1e-6));
    let ram = |i: i32| peak.assembly.motion(TAU * f64::from(i) / 7200.0).ram;
    let (low, high) = (0..7200)
        .map(ram)
        .fold((f64::MAX, f64::MIN), |(low, high), y| {
            (low.min(y), high.max(y))
        });
    check.near("stroke, mm", high - low, stroke, 1e-4);

    // Presses that keep the stroke: its crank follows from rod and offset.
    let best = peak.mechanism;
    let mut least = f64::INFINITY;
    for k in 0..60_u32 {
        let random = |j: u32| {
            f64::from((k.wrapping_mul(2_654_435_761_u32.rotate_left(7 * j))) >> 12 & 1023) / 511.5
                - 1.0
        };
        let rod = (best.rod + random(0)).clamp(120.0, 220.0);
        let offset = (best.offset + random(1)).clamp(-25.0, 25.0);
        let (mut short, mut long) = (35.0, 45.0);
        for _ in 0..60 {
            let crank = 0.5 * (short + long);
            let reach = |length: f64| (length * length - offset * offset).sqrt();
            if reach(rod + crank) - reach(rod - crank) < stroke {
                short = crank
            } else {
                long = crank
            }
        }
        let [ahead, across] = [best.ahead + 0.1 * random(2), best.across + 0.1 * random(3)];
        let Ok(other) = (Press {
            crank: short,
            rod,
            offset,
            ahead,
            across,
        })
        .assemble() else {
            continue;
        };
        if sampled(|phi| other.side(phi, SPEED).f.x) <= SIDE {
            least = least.min(of(&other));
        }
    }
    println!("  least peak of presses nearby: {:.4} N m", 1e-3 * least);
    check.holds(
        "no press nearby has a lower peak",
        least >= peak.goal * (1.0 - 1e-5) && least.is_finite(),
    );
}

/// With the lengths that were found, the best counterweights are a linear problem.
fn compare_counterweights(
    peak: &BestCycle<Press, PressAssembly>,
    check: &mut Check,
) -> Result<(), Box<dyn Error>> {
    let bare = Press {
        ahead: 0.0,
        across: 0.0,
        ..peak.mechanism
    }
    .assemble()?;
    let turn: Vec<f64> = (0..7200).map(|i| TAU * f64::from(i) / 7200.0).collect();
    let torques: Vec<f64> = turn.iter().map(|&phi| bare.drive(phi, SPEED).t).collect();
    let masses = [Press::INDEX_AHEAD, Press::INDEX_ACROSS];
    let effects: Vec<[f64; 2]> = turn
        .iter()
        .map(|&phi| masses.map(|k| bare.effects(phi, SPEED).e[k]))
        .collect();
    let least = Balance::new(&torques, &effects)?.peak()?;
    check.near(
        "peak with the best counterweights, N m",
        1e-3 * peak.goal,
        1e-3 * least.after.peak,
        1e-5,
    );
    check.near(
        "mass along the crank, kg",
        peak.mechanism.ahead,
        least.values[0],
        1e-2,
    );
    Ok(())
}
