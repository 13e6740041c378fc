//! `assemble_from`: the assembly that a straight way leads to, against poses that are found at many places of the way in another manner.

use crate::kinds;
use crate::legs::poses;
use crate::track::{apart, pose, track};
use linkage::AssemblyError;
use linkage_random::Random;

/// Ways of all kinds together.
const WAYS: usize = 60;

/// By how much of themselves dimensions change.
const PARTS: [f64; 2] = [0.2, 0.5];

/// The reference input.
const PHI: f64 = 30.0 / 180.0 * std::f64::consts::PI;

fn mixed<const N: usize>(from: &[f64; N], to: &[f64; N], share: f64) -> [f64; N] {
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
        let known = track(start, |share| kind.legs(&mixed(&from, &to, share), PHI));
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
    let legs = |share: f64| kind.legs(&mixed(&from, &to, share), PHI);
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
