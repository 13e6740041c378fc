//! Sweeps over mechanisms whose dimensions differ much from those of the assembly: each is where the straight way from there leads, against
//! poses that are found at many places of the way in another manner.

use crate::kinds::{self, Dimensions};
use crate::legs::{Leg, turned};
use crate::newton::{apart, pose, track};
use crate::sweeps::{EyeNeedle, EyeNeedleAssembly};
use linkage_interpreted::interpreted;
use linkage_random::Random;
use std::f64::consts::{PI, TAU};

/// Mechanisms of every kind, eye-needle drives and platforms, for each of these changes.
const MECHANISMS: usize = 4;
const NEEDLES: usize = 10;
const PLATFORMS: usize = 20;

/// By how much of themselves dimensions change.
const PARTS: [f64; 4] = [0.02, 0.05, 0.1, 0.2];

/// A way that ends may have ended shortly before the last of it.
const NEAR: f64 = 1e-4;

/// What became of the ways.
#[derive(Debug, Default)]
struct Count {
    reached: usize,
    blocked: usize,
    missed: usize,
    wrong: usize,
}

impl Count {
    /// Where a sweep has the ternary link, and where the way from another mechanism at the same input leads.
    fn add(&mut self, found: [[f64; 2]; 2], from: [[f64; 2]; 2], legs: impl Fn(f64) -> [Leg; 3]) {
        let [start, found] = [from, found].map(|[point, direction]| pose(point, direction));
        match track(start, legs) {
            Ok(known) if apart(&found, &known) < 1e-6 => self.reached += 1,
            Ok(_) if found.x.is_nan() => self.missed += 1,
            Err(_) if found.x.is_nan() => self.blocked += 1,
            Err(share) if share > 1.0 - NEAR => self.reached += 1,
            _ => self.wrong += 1,
        }
    }

    fn all(&self) -> usize {
        self.reached + self.blocked + self.missed + self.wrong
    }
}

fn between<const N: usize>(from: &[f64; N], to: &[f64; N], share: f64) -> [f64; N] {
    std::array::from_fn(|k| from[k] + share * (to[k] - from[k]))
}

fn check(part: f64, count: &Count) {
    println!("changed by up to {part}: {count:?} of {}", count.all());
    assert_eq!(count.wrong, 0);
    // Next to the end of a way it may be given up early.
    assert!(100 * count.missed <= count.all());
    assert!(2 * count.reached > count.all());
}

#[test]
fn sets_are_where_the_straight_way_leads() {
    let mut random = Random::new(1609);
    for part in PARTS {
        let mut count = Count::default();
        for kind in &kinds::KINDS {
            let from = kind.dimensions();
            let first = kind.assemble(&from).expect("as written");
            let many = MECHANISMS * crate::effort();
            let sets: Vec<Dimensions> = (0..many).map(|_| random.near(from, part)).collect();
            let phi: Vec<f64> = sets.iter().map(|_| random.between(0.0, TAU)).collect();
            let rows = kind.sets(&from, &sets, &phi);
            for ((to, phi), found) in sets.iter().zip(&phi).zip(rows) {
                let here = first(*phi);
                count.add(found, [here.point, here.direction], |share| {
                    kind.legs(&between(&from, to, share), *phi)
                });
            }
        }
        check(part, &count);
    }
}

/// `l12`, `l23`, `l34`, `l45`, `l35`, `l46`, `l57`.
type Links = [f64; 7];

fn needle([l12, l23, l34, l45, l35, l46, l57]: Links) -> EyeNeedle {
    EyeNeedle {
        l12,
        l23,
        l34,
        l45,
        l35,
        l46,
        l57,
        ..EyeNeedle::default()
    }
}

fn legs([l12, l23, l34, l45, l35, l46, l57]: Links, phi: f64) -> [Leg; 3] {
    let kappa = ((l34 * l34 + l35 * l35 - l45 * l45) / (2.0 * l34 * l35)).acos();
    let leg = |pivot, length, at| Leg::Rr { pivot, length, at };
    [
        leg(turned([l12, 0.0], phi), l23, [0.0, 0.0]),
        leg([195.0, 226.0], l46, [l34, 0.0]),
        leg([46.0, 533.0], l57, turned([l35, 0.0], kappa)),
    ]
}

#[test]
fn eye_needle_drives_are_where_the_straight_way_leads() {
    let m = EyeNeedle::default();
    let from = [m.l12, m.l23, m.l34, m.l45, m.l35, m.l46, m.l57];
    let linkage: EyeNeedleAssembly = m.assemble().expect("as written");
    let link = |needle: crate::sweeps::Link| [needle.p3.into(), needle.direction.into()];
    let mut random = Random::new(1610);
    for part in PARTS {
        let mut count = Count::default();
        let many = NEEDLES * crate::effort();
        let sets: Vec<Links> = (0..many).map(|_| random.near(from, part)).collect();
        let phi: Vec<f64> = sets.iter().map(|_| random.between(0.0, TAU)).collect();
        let mechanisms: Vec<EyeNeedle> = sets.iter().copied().map(needle).collect();
        let rows = linkage.link_sweep_sets(&mechanisms, &phi);
        for ((to, phi), found) in sets.iter().zip(&phi).zip(rows.iter()) {
            count.add(link(found), link(linkage.link(*phi)), |share| {
                legs(between(&from, to, share), *phi)
            });
        }
        check(part, &count);
    }
}

interpreted! {
    /// A ternary link on three legs that are driven.
    struct Platform {
        unit mm;
        param b = (150mm, -10mm);
        param c = (60mm, 130mm);
        param side = 60mm;
        param other = 55mm;
        input l1 = 70mm in 60mm..80mm;
        input l2 = 75mm in 65mm..85mm;
        input l3 = 72mm in 62mm..82mm;
        unknown theta = 10deg;
        unknown x1 = 50deg;
        unknown x2 = 120deg;
        unknown x3 = -80deg;
        let a = polar(l1, x1);
        loop a + polar(side, theta) = b + polar(l2, x2);
        loop a + polar(other, theta + 60deg) = c + polar(l3, x3);
    }
    impl Platform {
        fn link(l1, l2, l3) -> Pose { a, direction: dir(theta) }
    }
}

#[test]
fn platforms_with_several_inputs_are_where_the_straight_way_leads() {
    let m = Platform::default();
    let from = [m.b.x, m.b.y, m.c.x, m.c.y, m.side, m.other];
    let linkage = m.assemble().expect("as written");
    let legs = |d: [f64; 6], l: [f64; 3]| {
        let [bx, by, cx, cy, side, other] = d;
        let ends = [[0.0, 0.0], [side, 0.0], turned([other, 0.0], PI / 3.0)];
        let pivots = [[0.0, 0.0], [bx, by], [cx, cy]];
        std::array::from_fn(|i| Leg::Rr {
            pivot: pivots[i],
            length: l[i],
            at: ends[i],
        })
    };
    let mut random = Random::new(1611);
    for part in PARTS {
        let mut count = Count::default();
        let many = PLATFORMS * crate::effort();
        let sets: Vec<[f64; 6]> = (0..many).map(|_| random.near(from, part)).collect();
        let mechanisms: Vec<Platform> = sets
            .iter()
            .map(|&[bx, by, cx, cy, side, other]| Platform {
                b: [bx, by].into(),
                c: [cx, cy].into(),
                side,
                other,
            })
            .collect();
        let lengths = [(60.0, 80.0), (65.0, 85.0), (62.0, 82.0)];
        let [l1, l2, l3] = lengths.map(|(low, high)| -> Vec<f64> {
            sets.iter().map(|_| random.between(low, high)).collect()
        });
        let rows = linkage.link_sweep_sets(&mechanisms, &l1, &l2, &l3);
        for (k, found) in rows.into_iter().enumerate() {
            let l = [l1[k], l2[k], l3[k]];
            let here = linkage.link(l1[k], l2[k], l3[k]);
            let [here, found] = [here, found].map(|pose| [pose.a.into(), pose.direction.into()]);
            count.add(found, here, |share| {
                legs(between(&from, &sets[k], share), l)
            });
        }
        check(part, &count);
    }
}
