//! `assemble_from`: the assembly that a straight way leads to, against poses that are found at many places of the way in another manner.

use crate::kinds::{self, Dimensions};
use crate::legs::{Pose, poses};
use linkage::AssemblyError;
use linkage_random::Random;

/// Ways of all kinds together.
const WAYS: usize = 60;

/// By how much of themselves dimensions change.
const PARTS: [f64; 2] = [0.2, 0.5];

/// Places of a way at which all poses are found.
const PLACES: usize = 1000;

/// A pose that has moved by more from one place to the next is another one: millimetres, and a hundred for a radian.
const JUMP: f64 = 2.0;

/// The reference input.
const PHI: f64 = 30.0 / 180.0 * std::f64::consts::PI;

fn between(from: &Dimensions, to: &Dimensions, share: f64) -> Dimensions {
    std::array::from_fn(|k| from[k] + share * (to[k] - from[k]))
}

fn apart(one: &Pose, other: &Pose) -> f64 {
    let turned = 2.0 * ((one.theta - other.theta) / 2.0).sin().abs();
    (one.x - other.x).hypot(one.y - other.y) + 100.0 * turned
}

/// Where a pose is at the end of the way, or the share of it where it is lost. `None` where it cannot be told.
fn track(
    kind: &kinds::Kind,
    from: &Dimensions,
    to: &Dimensions,
    start: Pose,
) -> Option<Result<Pose, f64>> {
    let mut pose = start;
    for place in 0..=PLACES {
        let share = place as f64 / PLACES as f64;
        let all = poses(&kind.legs(&between(from, to, share), PHI))?;
        let next = all
            .into_iter()
            .min_by(|a, b| apart(a, &pose).total_cmp(&apart(b, &pose)));
        match next {
            Some(next) if apart(&next, &pose) < JUMP => pose = next,
            _ => return Some(Err(share)),
        }
    }
    Some(Ok(pose))
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
        let from = (kind.dimensions)();
        let part = PARTS[number / kinds::KINDS.len() % 2];
        let to = random.near(from, part);
        let first = (kind.assemble)(&from).expect("as written")(PHI);
        let [c, s] = first.direction;
        let [x, y] = first.point;
        let start = Pose {
            x,
            y,
            theta: s.atan2(c),
        };
        let Some(known) = track(kind, &from, &to, start) else {
            continue;
        };
        let context = || format!("{}: {to:?}", kind.name);
        match ((kind.assemble_from)(&from, &to), known) {
            (Ok(found), Ok(pose)) => {
                let found = found(PHI);
                let [c, s] = found.direction;
                let [x, y] = found.point;
                let found = Pose {
                    x,
                    y,
                    theta: s.atan2(c),
                };
                assert!(
                    apart(&found, &pose) < 1e-6,
                    "{found:?}, not {pose:?}: {}",
                    context()
                );
                reached += 1;
                // What the estimates choose may be another one.
                let chosen = (kind.assemble)(&to).map(|chosen| chosen(PHI).point);
                changed +=
                    usize::from(chosen.is_ok_and(|[x, y]| (x - pose.x).hypot(y - pose.y) > 1e-6));
            }
            (Err(AssemblyError::Blocked { share, .. }), Err(lost)) => {
                assert!(
                    (share - lost).abs() < 0.01,
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
