//! `assemble_from` where a dyad behind a triad is stretched most somewhere in between: it may be too short there, and long enough at both
//! ends of the way.

use crate::legs::{Leg, poses, turned};
use crate::track::track;
use linkage::AssemblyError;
use linkage_interpreted::interpreted;
use linkage_random::Random;

/// Ways.
const BULGES: usize = 6;

/// The reference input.
const PHI: f64 = 30.0 / 180.0 * std::f64::consts::PI;

fn mixed(from: &Triad, to: &Triad, share: f64) -> Triad {
    std::array::from_fn(|k| from[k] + share * (to[k] - from[k]))
}

interpreted! {
    /// A triad, and behind it a dyad that may be too short on the way from some dimensions to others.
    struct Behind {
        unit mm;
        param crank = 18mm;
        param b = 110mm;
        param c = 107mm;
        param q1 = 79mm;
        param q2 = 69mm;
        param q3 = 107mm;
        param rod = 60mm;
        param rail = 20mm;
        input phi = 30deg;
        unknown x1 = 86deg;
        unknown x2 = -177deg;
        unknown x3 = -24deg;
        unknown theta = -71deg;
        unknown lean = 80deg;
        unknown slide = 100mm;
        let e1 = polar(crank, phi) + polar(q1, x1);
        loop e1 + polar(b, theta) = (126mm, -13mm) + polar(q2, x2);
        loop e1 + polar(c, theta + 75deg) = (30mm, 139mm) + polar(q3, x3);
        loop e1 + polar(rod, lean) = (rail, slide);
    }
    impl Behind {
        fn joint(phi) -> Joint { e1, slide }
    }
}

/// The triad's dimensions: crank, sides of the ternary link, legs.
type Triad = [f64; 6];

fn triad([crank, b, c, q1, q2, q3]: Triad) -> [Leg; 3] {
    let leg = |pivot, length, at| Leg::Rr { pivot, length, at };
    [
        leg(turned([crank, 0.0], PHI), q1, [0.0, 0.0]),
        leg([126.0, -13.0], q2, [b, 0.0]),
        leg([30.0, 139.0], q3, turned([c, 0.0], 75_f64.to_radians())),
    ]
}

fn behind([crank, b, c, q1, q2, q3]: Triad, rod: f64, rail: f64) -> Behind {
    Behind {
        crank,
        b,
        c,
        q1,
        q2,
        q3,
        rod,
        rail,
    }
}

/// By how much of its bulge the dyad is too short, or long enough, where it is stretched most.
const SHORT: [f64; 4] = [1e-1, 1e-3, 1e-5, 1e-7];

/// The rail's distance from the straight line between the ends of the joint's way.
const AWAY: f64 = 40.0;

#[test]
fn a_dyad_behind_a_triad_may_be_too_short_in_between() {
    let mut random = Random::new(910);
    let m = Behind::default();
    let from = [m.crank, m.b, m.c, m.q1, m.q2, m.q3];
    let start = m.assemble().expect("as written").joint(PHI).e1;
    let start = poses(&triad(from))
        .expect("they are apart")
        .into_iter()
        .min_by(|a, b| (a.x - start.x).abs().total_cmp(&(b.x - start.x).abs()))
        .expect("one is the assembly");
    let (mut ended, mut reached) = (0, 0);
    for _ in 0..BULGES * crate::effort() {
        let to = random.near(from, 0.35);
        let at = |share: f64| track(start, |part| triad(mixed(&from, &to, part * share)));
        let Ok(last) = at(1.0) else { continue };
        let straight = |share: f64| start.x + share * (last.x - start.x);
        let bulge = |share: f64| at(share).map_or(f64::NAN, |pose| pose.x - straight(share));
        // The joint bulges to one side, once; the rail is on the other.
        let side = bulge(0.5).signum();
        let (mut low, mut high) = (0.0, 1.0);
        for _ in 0..30 {
            let [one, two] = [1.0, 2.0].map(|third| low + third / 3.0 * (high - low));
            match side * bulge(one) < side * bulge(two) {
                true => low = one,
                false => high = two,
            }
        }
        let most = side * bulge(low);
        if most.is_nan() || most < 0.05 {
            continue;
        }
        for short in SHORT {
            for (sign, fits) in [(-1.0, false), (1.0, true)] {
                let rod = AWAY + most * (1.0 + sign * short);
                let rails = [start.x, last.x].map(|x| x - side * AWAY);
                let first = behind(from, rod, rails[0]);
                let Some(first) = assembled(&first) else {
                    continue;
                };
                match behind(to, rod, rails[1]).assemble_from(&first) {
                    Ok(_) => {
                        assert!(fits, "{short:e} of {most} too short at {low}: {to:?}");
                        reached += 1;
                    }
                    Err(AssemblyError::Blocked { share, group, .. }) => {
                        assert!(!fits && group.index == 1, "{group} at {share}: {to:?}");
                        // The dip is as wide as the root of its depth.
                        assert!(
                            share < low && low - share < 2.0 * short.sqrt(),
                            "{share}, {low}"
                        );
                        ended += 1;
                    }
                    Err(why) => panic!("{why}: {to:?}"),
                }
            }
        }
    }
    println!("{reached} reached, {ended} ended");
    assert!(reached > BULGES && ended > BULGES);
}

/// The assembly at the estimates of the triad, the dyad's aside.
fn assembled(mechanism: &Behind) -> Option<BehindAssembly> {
    let known = Behind::default()
        .assemble()
        .expect("as written")
        .joint(PHI)
        .e1;
    let all = mechanism.assemblies().expect("they can be listed");
    all.into_iter()
        .find(|one| (one.joint(PHI).e1 - known).norm() < 1e-9)
}
