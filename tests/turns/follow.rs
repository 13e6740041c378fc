//! Following an angle from position to position, by its direction alone.

use core::f64::consts::{PI, TAU};
use linkage::Dimensions;
use linkage_random::Random;

/// Steps from the reference to an end of the range.
const STEPS: usize = 400;
/// A step in which the angle turns by more, in radians, is halved.
const MUCH: f64 = 0.5;
const HALVINGS: usize = 40;

/// Random dimensions: up to four times as long or short, some negative; in one of four cases all of about the same length, near a change point.
pub(crate) fn dimensions<M: Dimensions<N>, const N: usize>(nominal: &M, random: &mut Random) -> M {
    let near = random.chance(0.25).then(|| random.ratio(1e-2, 0.1));
    M::from_values(&nominal.values().map(|value| match near {
        Some(near) => 50.0 * value.signum() * (1.0 + near * random.between(-1.0, 1.0)),
        None => {
            let sign = if random.chance(0.05) { -1.0 } else { 1.0 };
            sign * value * random.ratio(0.25, 4.0)
        }
    }))
}

/// An angle and its direction by the input.
pub(crate) type Turning<'a> = &'a dyn Fn(f64) -> (f64, [f64; 2]);

/// Compares the values of an angle with the angle that its direction turns by from the reference, as far as it goes. Gives the number of
/// positions, and by how much the angle turned in all.
pub(crate) fn compare(turning: Turning, [low, at, high]: [f64; 3], estimate: f64) -> (usize, f64) {
    let (start, _) = turning(at);
    if !start.is_finite() {
        return (0, 0.0);
    }
    assert!(
        (start - estimate).abs() < PI + 1e-9,
        "{start} for an estimate of {estimate}"
    );
    let (below, least) = one_way(turning, at, low, start);
    let (above, most) = one_way(turning, at, high, start);
    (below + above, (most - least).abs())
}

fn one_way(turning: Turning, from: f64, to: f64, start: f64) -> (usize, f64) {
    let mut last = (from, start);
    for step in 1..=STEPS {
        let target = from + (to - from) * (step as f64 / STEPS as f64);
        while last.0 != target {
            let Some(next) = advance(turning, last, target) else {
                return (step, last.1);
            };
            let (value, _) = turning(next.0);
            assert!(
                (value - next.1).abs() < 1e-9,
                "{value} at {} where the direction has turned to {}",
                next.0,
                next.1
            );
            last = next;
        }
    }
    (STEPS, last.1)
}

/// Nothing where the angle ends, or jumps.
fn advance(turning: Turning, from: (f64, f64), mut to: f64) -> Option<(f64, f64)> {
    for _ in 0..HALVINGS {
        let (_, [cosine, sine]) = turning(to);
        let behind = f64::atan2(sine, cosine) - from.1;
        let turn = behind - TAU * (behind / TAU).round();
        if turn.abs() <= MUCH {
            return Some((to, from.1 + turn));
        }
        to = from.0 + 0.5 * (to - from.0);
        if to == from.0 {
            break;
        }
    }
    None
}

/// How many mechanisms each test makes.
pub(crate) fn count() -> usize {
    if std::env::var_os("LINKAGE_LONG").is_some() {
        1000
    } else {
        50
    }
}

/// A test of a mechanism's angles, each with its direction and its estimate, over a range in degrees: lower end, reference, upper end. More positions than
/// `$least` for each mechanism are compared.
macro_rules! turns {
    ($name:ident: $mechanism:ident [$low:literal $at:literal $high:literal], $least:literal $(where $decided:path)?, $($angle:ident $direction:ident $estimate:literal)*) => {
        #[test]
        fn $name() {
            let mut random = linkage_random::Random::new(0x7475_726e);
            let (mut compared, mut turned, mut refused) = (0, 0.0, 0);
            for _ in 0..crate::follow::count() {
                let dimensions = crate::follow::dimensions(&$mechanism::default(), &mut random);
                $(if !$decided(&dimensions) {
                    continue;
                })?
                let assemblies = match dimensions.assemblies() {
                    Ok(assemblies) => assemblies,
                    Err(linkage::AssemblyError::NoWinding { .. }) => {
                        refused += 1;
                        continue;
                    }
                    // A number computed from the dimensions is not finite.
                    Err(_) => continue,
                };
                for assembly in assemblies {
                    $(
                        let turning = |x: f64| {
                            let there = assembly.angles(x);
                            (there.$angle, [there.$direction.x, there.$direction.y])
                        };
                        let range = [$low, $at, $high].map(|x: i32| f64::from(x).to_radians());
                        let (count, turn) = crate::follow::compare(&turning, range, f64::from($estimate).to_radians());
                        compared += count;
                        turned += turn;
                    )*
                }
            }
            println!("{}: {compared} positions, {turned} rad, {refused} refused", stringify!($name));
            assert!(compared > $least * crate::follow::count(), "{compared}");
        }
    };
}
pub(crate) use turns;
