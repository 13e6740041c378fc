//! Which part of the ranges of several inputs is served: against positions that are reached on a fine lattice, in another manner.

use crate::legs::{Leg, Pose, distance, turned};
use crate::newton::follow_pose;
use linkage::{AssemblyError, CoupledCause};
use linkage_random::Random;
use std::collections::VecDeque;

linkage_interpreted::interpreted! {
    /// Three cranks hold a plate, all triangles with equal sides; offsets choose where the cranks' ranges lie.
    struct Cranks {
        unit mm;
        param r = 50mm;
        param l = 90mm;
        param s = 80mm;
        param g = 200mm;
        param o1 = 90deg;
        param o2 = 210deg;
        param o3 = 330deg;
        input f1 = 0deg in -15deg..15deg;
        input f2 = 0deg in -15deg..15deg;
        input f3 = 0deg in -15deg..15deg;
        unknown x1 = 0deg;
        unknown x2 = 120deg;
        unknown x3 = 240deg;
        unknown t = 40deg;
        let e1 = polar(r, f1 + o1) + polar(l, x1);
        loop e1 + polar(s, t) = (g, 0) + polar(r, f2 + o2) + polar(l, x2);
        loop e1 + polar(s, t + 60deg) = polar(g, 60deg) + polar(r, f3 + o3) + polar(l, x3);
    }

    impl Cranks { fn plate(f1, f2, f3) -> Plate { e1, direction: dir(t) } }
}

const HALF: f64 = 15.0 / 180.0 * std::f64::consts::PI;

/// Positions along each input.
const SIDE: usize = 7;

/// Lengths of poses are measured by this.
const SIZE: f64 = 100.0;

impl Cranks {
    fn legs(&self, f: [f64; 3]) -> [Leg; 3] {
        let offsets = [self.o1, self.o2, self.o3];
        let corner = |side: f64, k: usize| match k {
            0 => [0.0, 0.0],
            1 => [side, 0.0],
            _ => turned([side, 0.0], 60_f64.to_radians()),
        };
        std::array::from_fn(|k| {
            let [x, y] = turned([self.r, 0.0], f[k] + offsets[k]);
            let [u, v] = corner(self.g, k);
            Leg::Rr {
                pivot: [u + x, v + y],
                length: self.l,
                at: corner(self.s, k),
            }
        })
    }
}

/// The inputs at a place of the lattice, from edge to edge of the ranges.
fn inputs(place: usize) -> [f64; 3] {
    let share = |k: u32| (place / SIDE.pow(k) % SIDE) as f64 / (SIDE - 1) as f64;
    [0, 1, 2].map(|k| HALF * (2.0 * share(k) - 1.0))
}

/// The part of the ranges that belongs to a place: half as wide at an edge.
fn weight(place: usize) -> f64 {
    let one = |k: u32| match place / SIDE.pow(k) % SIDE {
        0 => 0.5,
        at if at + 1 == SIDE => 0.5,
        _ => 1.0,
    };
    [0, 1, 2]
        .map(|k| one(k) / (SIDE - 1) as f64)
        .iter()
        .product()
}

/// The pose at every place of the lattice that fine steps reach, from neighbour to neighbour.
fn tracked(cranks: &Cranks, start: Pose) -> Vec<Option<Pose>> {
    let mut found = vec![None; SIDE.pow(3)];
    let between = |from: [f64; 3], to: [f64; 3], pose: Pose| {
        let length = from.iter().zip(to).map(|(a, b)| (b - a).abs());
        let length = length.fold(0.0, f64::max) / (2.0 * HALF);
        let way = |t: f64| {
            cranks.legs(std::array::from_fn(|k| {
                from[k] + t / length * (to[k] - from[k])
            }))
        };
        follow_pose(way, pose, (0.0, length)).ok()
    };
    let middle = SIDE.pow(3) / 2;
    found[middle] = Some(start);
    let mut queue = VecDeque::from([middle]);
    while let Some(place) = queue.pop_front() {
        let Some(pose) = found[place] else { continue };
        for k in 0..3 {
            let (stride, at) = (SIDE.pow(k), place / SIDE.pow(k) % SIDE);
            let below = (at > 0).then(|| place - stride);
            let above = (at + 1 < SIDE).then(|| place + stride);
            for next in [below, above].into_iter().flatten() {
                if found[next].is_none() {
                    found[next] = between(inputs(place), inputs(next), pose);
                    queue.extend(found[next].map(|_| next));
                }
            }
        }
    }
    found
}

/// What an assembly gives at the places of the lattice.
#[derive(Debug, Default)]
struct Survey {
    served: usize,
    /// As a share of the ranges.
    share: f64,
    /// Where the pose exists, and nothing is given.
    missing: usize,
    /// Where another pose is given.
    other: usize,
}

fn survey(cranks: &Cranks, assembly: &CranksAssembly) -> Survey {
    let pose = |[f1, f2, f3]: [f64; 3]| {
        let Plate { e1, direction } = assembly.plate(f1, f2, f3);
        Pose {
            x: e1.x,
            y: e1.y,
            theta: direction.y.atan2(direction.x),
        }
    };
    let expected = tracked(cranks, pose([0.0; 3]));
    let mut survey = Survey::default();
    for (place, expected) in expected.iter().enumerate() {
        let found = pose(inputs(place));
        let served = found.x.is_finite();
        survey.served += usize::from(served);
        survey.share += if served { weight(place) } else { 0.0 };
        if let Some(expected) = expected {
            survey.missing += usize::from(!served);
            survey.other += usize::from(served && distance(&found, expected, SIZE) > 1e-9);
        }
    }
    survey
}

/// Five percent from the nominal dimensions, and regular in the whole ranges: a quarter of the positions was left out without a word.
#[test]
fn regular_positions_are_served() {
    let cranks = |offsets: [f64; 3]| {
        let [o1, o2, o3] = offsets.map(f64::to_radians);
        Cranks {
            r: 51.625226211815686,
            l: 89.14192720637995,
            s: 83.92520818386438,
            g: 191.9884433200727,
            o1,
            o2,
            o3,
        }
    };
    for (offsets, tilt) in [
        ([210.0, 140.0, 300.0], -23.2_f64),
        ([30.0, 190.0, 80.0], -47.7),
    ] {
        let cranks = cranks(offsets);
        let assemblies = cranks.assemblies().expect("they are listed");
        let tilt = tilt.to_radians();
        let near = |assembly: &&CranksAssembly| {
            let direction = assembly.plate(0.0, 0.0, 0.0).direction;
            direction.x * tilt.cos() + direction.y * tilt.sin() > 0.999
        };
        let assembly = assemblies.iter().find(near).expect("it is among them");
        let Survey { missing, other, .. } = survey(&cranks, assembly);
        let told = assembly.served();
        assert!(missing <= 1 && other == 0, "{missing}, {other}");
        assert!(told > 0.99 && (told < 1.0 || missing == 0), "{told}");
    }
}

/// Random platforms: what is left out is told, by `assemble()` or by `served()`.
#[test]
fn nothing_is_left_out_silently() {
    let count = match crate::effort() {
        1 => 50,
        more => 100 * more,
    };
    let mut random = Random::new(1607);
    let (mut whole, mut part, mut refused, mut ambiguous, mut beside) = (0, 0, 0, 0, 0);
    let mut all = Survey::default();
    let mut slowest = 0.0_f64;
    while whole + part + refused + beside < count {
        let mut near = |nominal: f64| nominal * random.between(0.9, 1.1);
        let cranks = Cranks {
            r: near(50.0),
            l: near(90.0),
            s: near(80.0),
            g: near(200.0),
            o1: random.angle(),
            o2: random.angle(),
            o3: random.angle(),
        };
        let start = std::time::Instant::now();
        let assembled = cranks.assemble();
        slowest = slowest.max(start.elapsed().as_secs_f64());
        let assembly = match assembled {
            Ok(assembly) => assembly,
            Err(AssemblyError::Coupled(error)) => {
                match error.cause {
                    CoupledCause::LeavesOut { share, .. } if share > 0.005 => refused += 1,
                    CoupledCause::BesideDeadPoint(_) => beside += 1,
                    CoupledCause::NoneReal { .. } | CoupledCause::Ambiguous { .. } => {
                        ambiguous += 1;
                    }
                    cause => panic!("{cranks:?}: {cause}"),
                }
                continue;
            }
            Err(error) => panic!("{cranks:?}: {error}"),
        };
        let own = survey(&cranks, &assembly);
        let told = assembly.served();
        if told == 1.0 {
            assert!(own.missing == 0 && own.other == 0, "{cranks:?}: {own:?}");
        }
        assert!(
            (told - own.share).abs() < 0.05,
            "{cranks:?}: {told}, {own:?}"
        );
        if told < 1.0 {
            part += 1;
        } else {
            whole += 1;
        }
        all.share += own.share / count as f64;
        all.served += own.served;
        all.missing += own.missing;
        all.other += own.other;
    }
    println!(
        "{whole} served wholly, {part} in part, {refused} refused, {beside} beside a dead point, {ambiguous} not real or ambiguous; {all:?}; slowest {slowest:.3} s"
    );
    // Around a cusp the pose depends on the way to it.
    assert!(200 * all.missing < all.served && 500 * all.other < all.served);
    assert!(20 * (refused + beside) <= count);
}
