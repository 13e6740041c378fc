//! Closed chains of robots and vehicles against their limits, by the command
//! `RUSTFLAGS="-C target-cpu=x86-64-v3" cargo bench -p linkage-benches --bench chains`, and without the flags.
//!
//! The mechanisms are those of the folder `mechanisms`: the ankle both ways, the platform on six legs with its follower, the five-link axle, the double
//! wishbone, the McPherson strut. Times of single calls, of a sweep and of `assemble()`; operations as `STRUCTURE` counts them.

mod ankle {
    include!("../mechanisms/ankle.rs");
}
mod double_wishbone {
    include!("../mechanisms/double_wishbone.rs");
}
mod five_link_axle {
    include!("../mechanisms/five_link_axle.rs");
}
mod hexapod {
    include!("../mechanisms/hexapod.rs");
}
mod mcpherson {
    include!("../mechanisms/mcpherson.rs");
}

use ankle::{ToFoot, ToMotors};
use double_wishbone::DoubleWishbone;
use five_link_axle::FiveLinkAxle;
use hexapod::{ToLegs, ToPose};
use linkage::Structure;
use linkage_peers::environment;
use linkage_peers::timing::{Candidate, Times, clock, interleave, only_tested};
use mcpherson::McPherson;
use std::f64::consts::TAU;
use std::hint::black_box;
use std::time::Duration;

/// Positions in one run.
const POSITIONS: u32 = 1024;

/// Poses on a closed path of the platform: neighbours are some tenths of a millimetre apart.
const POSES: u32 = 10_000;

/// The goal for `assemble()` of any of them, in nanoseconds.
const ASSEMBLE: f64 = 5e6;

/// The goal for the operations of a McPherson strut.
const OPERATIONS: u32 = 700;

/// Pieces of work, and the nanoseconds that each may take.
#[derive(Default)]
struct Rows {
    goals: Vec<Option<f64>>,
    candidates: Vec<Candidate<'static>>,
}

impl Rows {
    fn add(&mut self, name: &str, goal: f64, items: usize, run: impl FnMut() + 'static) {
        self.goals.push(Some(goal));
        self.candidates.push(Candidate::new(name, items, run));
    }

    /// Times them in turn, and prints that.
    fn run(self) {
        let time = Duration::from_millis(if only_tested() { 1 } else { 2000 });
        let Self {
            goals,
            mut candidates,
        } = self;
        candidates.push(clock());
        let times = interleave(candidates, time);
        let (clock, times) = times.split_last().expect("the clock is the last one");
        for (times, goal) in times.iter().zip(goals) {
            print(times, goal, clock);
        }
    }

    /// Something that no goal is set for.
    fn beside(&mut self, name: &str, items: usize, run: impl FnMut() + 'static) {
        self.goals.push(None);
        self.candidates.push(Candidate::new(name, items, run));
    }
}

fn main() {
    println!(
        "{}; {}. Medians; c = core cycles.",
        environment::processor(),
        environment::build()
    );
    println!("{:<42} {:>12} {:>10} {:>12}", "", "ns", "(c)", "goal");
    // Each mechanism in rounds of its own: after another one its prepared states would have to come back into the cache first.
    for pieces in [ankles, platform, axle, assemblies] {
        let mut rows = Rows::default();
        pieces(&mut rows);
        rows.run();
    }
    operations(McPherson::<f64>::STRUCTURE);
}

/// Both ways, all over the ranges.
fn ankles(rows: &mut Rows) {
    let to_motors = ToMotors::default().assemble().expect("it assembles");
    let to_foot = ToFoot::default().assemble().expect("it assembles");
    let feet = scattered([[-45.0, 25.0], [-20.0, 20.0]].map(|range| range.map(f64::to_radians)));
    let motors = feet.iter().map(|&[pitch, roll]| {
        let motors = to_motors.motors(pitch, roll);
        [motors.left, motors.right]
    });
    let range = -25_f64.to_radians()..35_f64.to_radians();
    let motors = motors.filter(|own| own.iter().all(|angle| range.contains(angle)));
    let motors: Vec<[f64; 2]> = motors.collect();
    rows.add(
        "ankle to motors, Jacobian and Hessian",
        60.0,
        feet.len(),
        move || {
            for &[pitch, roll] in &feet {
                black_box(to_motors.motion(pitch, roll));
            }
        },
    );
    let copy = to_foot.clone();
    let places = motors.clone();
    rows.add("ankle to foot, certified", 100.0, motors.len(), move || {
        for &[left, right] in &motors {
            black_box(to_foot.foot(left, right));
        }
    });
    rows.beside(
        "ankle to foot, Jacobian and Hessian",
        places.len(),
        move || {
            for &[left, right] in &places {
                black_box(copy.tilt(left, right));
            }
        },
    );
}

/// From pose to pose along a path, with all derivatives at each.
fn platform(rows: &mut Rows) {
    // As long as the program: a follower borrows its assembly.
    let to_pose = ToPose::default().assemble().expect("it assembles");
    let to_pose: &'static _ = Box::leak(Box::new(to_pose));
    let to_legs = ToLegs::default().assemble().expect("it assembles");
    let legs = (0..POSES).map(|k| {
        let t = TAU * f64::from(k) / f64::from(POSES);
        let own = to_legs.legs(
            12.0 + 40.0 * t.sin(),
            -18.0 + 35.0 * (2.0 * t).sin(),
            420.0 + 30.0 * (3.0 * t).sin(),
            0.08 + 0.10 * t.sin(),
            -0.05 + 0.12 * (2.0 * t).sin(),
            0.35 + 0.15 * (3.0 * t).sin(),
        );
        [own.l1, own.l2, own.l3, own.l4, own.l5, own.l6]
    });
    let legs: Vec<[f64; 6]> = legs.collect();
    let [a, b, c, d, e, f] = std::array::from_fn(|k| ToPose::INPUTS[k].reference);
    let mut at = to_pose.follower(a, b, c, d, e, f).expect("it stands there");
    let [a, b, c, d, e, f] = legs[0];
    at.follow(a, b, c, d, e, f).expect("the path begins near");
    let (mut alone, path) = (at, legs.clone());
    rows.add(
        "platform followed, with Jacobian",
        400.0,
        legs.len(),
        move || {
            for &[a, b, c, d, e, f] in &legs {
                at.follow(a, b, c, d, e, f).expect("a small step");
                black_box(at.rates());
            }
        },
    );
    rows.beside("platform followed, pose alone", path.len(), move || {
        for &[a, b, c, d, e, f] in &path {
            alone.follow(a, b, c, d, e, f).expect("a small step");
            black_box(alone.pose());
        }
    });
}

/// The wheel's angles and place with both derivatives by travel and rack.
fn axle(rows: &mut Rows) {
    let axle = FiveLinkAxle::default().assemble().expect("it assembles");
    let places = scattered([[-80.0, 80.0], [-15.0, 15.0]]);
    let [travel, rack] = [0, 1].map(|k| places.iter().map(|place| place[k]).collect::<Vec<f64>>());
    let mut columns = axle.motion_sweep(&travel, &rack);
    let others = axle.clone();
    let own = others.clone();
    let copy = places.clone();
    rows.beside("five-link axle, position alone", places.len(), move || {
        for &[travel, rack] in &copy {
            black_box(own.wheel(travel, rack));
        }
    });
    rows.add(
        "five-link axle, both derivatives",
        300.0,
        places.len(),
        move || {
            for &[travel, rack] in &places {
                black_box(axle.motion(travel, rack));
            }
        },
    );
    rows.add(
        "five-link axle, both derivatives, sweep",
        60.0,
        travel.len(),
        move || {
            others.motion_sweep_into(black_box(&travel), &rack, &mut columns);
            black_box(&mut columns);
        },
    );
}

fn assemblies(rows: &mut Rows) {
    macro_rules! assemble {
        ($($mechanism:ident),*) => {$(
            let mechanism = $mechanism::default();
            rows.add(concat!("assemble() of ", stringify!($mechanism)), ASSEMBLE, 1, move || {
                black_box(black_box(&mechanism).assemble()).expect("it assembles");
            });
        )*};
    }
    assemble!(
        ToMotors,
        ToFoot,
        ToPose,
        FiveLinkAxle,
        DoubleWishbone,
        McPherson
    );
}

/// Places all over two ranges in an order in which neighbours are far apart.
fn scattered([first, second]: [[f64; 2]; 2]) -> Vec<[f64; 2]> {
    let places = (0..POSITIONS).map(|k| {
        let within = |[low, high]: [f64; 2], prime: f64| {
            low + (high - low) * ((f64::from(k) + 0.5) * prime.sqrt() % 1.0)
        };
        [within(first, 2.0), within(second, 3.0)]
    });
    places.collect()
}

fn print(times: &Times, goal: Option<f64>, clock: &Times) {
    let (time, cycles) = (times.spread().median, times.ratio(clock).median);
    let met = |goal: f64| match time <= goal {
        true => format!("{goal:12.0} met"),
        false => format!("{goal:12.0} MISSED"),
    };
    let goal = goal.map(met).unwrap_or_default();
    println!("{:<42} {time:12.1} {cycles:10.0} {goal}", times.name);
}

/// Of a position, which the first function gives.
fn operations(structure: &Structure) {
    let function = structure.functions[0];
    let count = function.operations.total();
    let met = if count <= OPERATIONS { "met" } else { "MISSED" };
    println!(
        "McPherson strut, operations of {}: {count}, goal {OPERATIONS} {met}",
        function.name
    );
}
