//! Ways of `assemble_from`: the assembly that a straight way leads to, also past bulges.

use crate::kinds;
use crate::legs::{Leg, poses, turned};
use crate::newton::{apart, pose, track};
use linkage::AssemblyError;
use linkage_interpreted::interpreted;
use linkage_random::Random;

// `assemble_from` where a dyad behind a triad is stretched most somewhere in between: it may be too short there, and long enough at both
// ends of the way.

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

// `assemble_from`: the assembly that a straight way leads to, against poses that are found at many places of the way in another manner.

/// Ways of all kinds together.
const WAYS: usize = 60;

/// By how much of themselves dimensions change.
const PARTS: [f64; 2] = [0.2, 0.5];

fn mixed_parameters<const N: usize>(from: &[f64; N], to: &[f64; N], share: f64) -> [f64; N] {
    std::array::from_fn(|k| from[k] + share * (to[k] - from[k]))
}

#[test]
fn the_assembly_is_the_one_that_the_way_leads_to() {
    let mut random = Random::new(909);
    let (mut reached, mut ended, mut refused, mut changed) = (0, 0, 0, 0);
    let ways = match crate::effort() {
        1 => WAYS,
        more => 2 * WAYS * more,
    };
    for (number, kind) in kinds::KINDS.iter().cycle().take(ways).enumerate() {
        let from = kind.dimensions();
        let part = PARTS[number / kinds::KINDS.len() % 2];
        let to = random.near(from, part);
        let first = kind.assemble(&from).expect("as written")(PHI);
        let start = pose(first.point, first.direction);
        let known = track(start, |share| {
            kind.legs(&mixed_parameters(&from, &to, share), PHI)
        });
        let context = || format!("{}: {to:?}", kind.name);
        match (kind.assemble_from(&from, &to), known) {
            (Ok(found), Ok(known)) => {
                let found = found(PHI);
                let found = pose(found.point, found.direction);
                assert!(
                    apart(&found, &known) < 1e-6,
                    "{found:?}, not {known:?}: {}",
                    context()
                );
                reached += 1;
                // What the estimates choose may be another one.
                let chosen = kind.assemble(&to).map(|chosen| chosen(PHI).point);
                changed +=
                    usize::from(chosen.is_ok_and(|[x, y]| (x - known.x).hypot(y - known.y) > 1e-6));
            }
            (Err(AssemblyError::Blocked { share, .. }), Err(lost)) => {
                assert!(
                    (share - lost).abs() < 1e-4,
                    "{share}, not {lost}: {}",
                    context()
                );
                ended += 1;
            }
            // The range of the input runs into a dead point at these dimensions, as `assemble()` would say.
            (Err(AssemblyError::Coupled(_)), Ok(_)) => refused += 1,
            (Ok(_), Err(lost)) => panic!("it ends at {lost}: {}", context()),
            (Err(why), known) => panic!("{why}, not {known:?}: {}", context()),
        }
    }
    println!(
        "{reached} reached, {ended} ended, {refused} refused over the range; the estimates choose another assembly for {changed}"
    );
    assert!(reached > ways / 3 && ended + refused > 0);
}

/// Where two slides on the ternary link become parallel two of the four assemblies run off to infinity and come back from its other side. The
/// others do not notice.
#[test]
fn assemblies_go_on_where_others_are_at_infinity() {
    let kind = kinds::KINDS.iter().find(|kind| kind.name == "PR-RP-RP");
    let kind = kind.expect("it is one of the kinds");
    let from = kind.dimensions();
    let mut to = from;
    to[9] = from[10] - (from[9] - from[10]);
    let legs = |share: f64| kind.legs(&mixed_parameters(&from, &to, share), PHI);
    let far = |share: f64| {
        let poses = poses(&legs(share)).expect("all are finite there");
        poses
            .iter()
            .filter(|pose| pose.x.hypot(pose.y) > 800.0)
            .count()
    };
    assert_eq!((far(0.0), poses(&legs(0.5)), far(1.0)), (2, None, 2));
    let first = kind.assemble(&from).expect("as written")(PHI);
    let known = track(pose(first.point, first.direction), legs).expect("it goes on");
    let found = kind.assemble_from(&from, &to).expect("it goes on")(PHI);
    let found = pose(found.point, found.direction);
    assert!(apart(&found, &known) < 1e-9, "{found:?}, not {known:?}");
}
