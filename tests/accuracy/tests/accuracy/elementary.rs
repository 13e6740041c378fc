//! The elementary functions of `f64` and `f32`, with and without fused multiply-add, against 154
//! digits. The largest errors are printed (`--nocapture`).

use core::f64::consts::{FRAC_PI_2, FRAC_PI_4};
use linkage::Scalar;
use linkage_reference::{Big, Random};

/// Half the distance of numbers next to 1 on the upper side.
const ROUNDOFF: f64 = f64::EPSILON / 2.0;

/// Distance between the numbers of `digits` binary digits around `x`.
fn unit(x: f64, digits: i32, least: i32) -> f64 {
    let exponent = (x.abs().to_bits() >> 52) as i32 - 1023;
    2f64.powi((exponent + 1 - digits).max(least))
}

fn unit_f64(x: f64) -> f64 {
    unit(x, 53, -1074)
}

fn unit_f32(x: f64) -> f64 {
    unit(x, 24, -149)
}

/// The largest error of a function so far, and where it was.
#[derive(Default)]
struct Largest {
    error: f64,
    place: f64,
}

impl Largest {
    fn see(&mut self, error: f64, place: f64) {
        let error = if error.is_nan() { f64::INFINITY } else { error };
        if error > self.error {
            *self = Self { error, place };
        }
    }

    fn within(&self, limit: f64, what: &str) {
        println!("{what}: {:.3} at {:e}", self.error, self.place);
        assert!(
            self.error <= limit,
            "{what}: {} at {:e}",
            self.error,
            self.place
        );
    }
}

/// The sine pairs of rows are allowed so much more.
const IN_ROWS: f64 = 1.8;

/// Errors of the sine pairs of `f64` in the given units of the exact value, those of single calls among them.
fn sine_pair(inputs: impl Iterator<Item = f64>, unit: fn(f64) -> f64, limit: f64, what: &str) {
    let mut fused = Largest::default();
    let mut plain = Largest::default();
    let mut alone = Largest::default();
    let mut rows = Largest::default();
    for x in inputs {
        let (sine, cosine) = Big::from(x).sin_cos();
        let (sine_unit, cosine_unit) = (unit(sine.to_f64()), unit(cosine.to_f64()));
        let see = |largest: &mut Largest, (s, c): (f64, f64), least: f64| {
            largest.see((&sine - s).to_f64().abs() / sine_unit.max(least), x);
            largest.see((&cosine - c).to_f64().abs() / cosine_unit.max(least), x);
        };
        see(&mut fused, x.sin_cos_with::<true>(), 0.0);
        see(&mut plain, x.sin_cos_with::<false>(), 0.0);
        see(&mut alone, x.sin_cos_shortest::<true, false>(), 0.0);
        // What rows lose next to a multiple of a right angle is little beside 1.
        let least = 2f64.powi(-10) * ROUNDOFF;
        see(&mut rows, x.sin_cos_shortest::<true, true>(), least);
    }
    rows.within(IN_ROWS * limit, &format!("sine pair {what}, rows"));
    alone.within(limit, &format!("sine pair {what}, alone"));
    fused.within(limit, &format!("sine pair {what}, fused"));
    plain.within(limit, &format!("sine pair {what}, plain"));
}

#[test]
fn a_sine_pair_is_within_a_unit_up_to_1e5() {
    let mut random = Random::new(301);
    for bound in [FRAC_PI_4, 3.2, 100.0, 1e5] {
        let inputs = (0..1500).map(|_| random.between(-bound, bound));
        sine_pair(inputs, unit_f64, 0.9, &format!("up to {bound}"));
    }
    let tiny = (0..1000).map(|_| random.ratio(1e-9, 1.0));
    sine_pair(tiny, unit_f64, 0.9, "of small angles");
    // Beyond half a step of the table the remainder is half of the sine, and errs by as much.
    let first = (0..3000).map(|_| random.between(0.0245, 0.04));
    sine_pair(first, unit_f64, 0.9, "of the first direction");
}

#[test]
fn a_sine_pair_is_within_a_unit_next_to_right_angles_and_half_of_them() {
    // A right angle in three words, its double exact up to 2^-160.
    let right = Big::from(FRAC_PI_2)
        + Big::from(6.123_233_995_736_766e-17)
        + Big::from(-1.497_384_904_859_183_3e-33);
    let step = right * 0.5;
    let inputs = (1..600)
        .chain((600..130_000).step_by(97))
        .flat_map(move |n| {
            let x = (&step * f64::from(n)).to_f64();
            [x, -x.next_up(), x.next_down()]
        });
    sine_pair(inputs, unit_f64, 0.9, "next to right angles");
}

#[test]
fn a_sine_pair_is_within_roundoffs_up_to_the_limit() {
    let mut random = Random::new(302);
    let limit = 2f64.powi(30).next_down();
    let inputs = (0..3000)
        .map(|_| random.between(-limit, limit))
        .chain([limit, -limit]);
    sine_pair(inputs, |_| ROUNDOFF, 1.0, "up to 2^30, in roundoffs");
}

#[test]
fn a_single_sine_pair_is_within_a_unit_up_to_its_limit() {
    let mut fused = Largest::default();
    let mut plain = Largest::default();
    let mut see = |x: f32| {
        let (sine, cosine) = f64::from(x).sin_cos();
        let one = |largest: &mut Largest, (s, c): (f32, f32)| {
            largest.see((f64::from(s) - sine).abs() / unit_f32(sine), x.into());
            largest.see((f64::from(c) - cosine).abs() / unit_f32(cosine), x.into());
        };
        one(&mut fused, x.sin_cos_with::<true>());
        one(&mut plain, x.sin_cos_with::<false>());
    };
    let mut random = Random::new(303);
    for bound in [FRAC_PI_4, 3.2, 100.0, 1e5, 1_048_575.0] {
        (0..50_000).for_each(|_| see(random.between(-bound, bound) as f32));
    }
    for n in 1..65_000 {
        let x = (f64::from(n) * FRAC_PI_2) as f32;
        [x, -x, x.next_up(), x.next_down()]
            .into_iter()
            .for_each(&mut see);
    }
    // One of a thousand of all numbers up to the limit; below 1e-4 the sine is the angle.
    let [first, limit] = [1e-4_f32, 1_048_576.0].map(f32::to_bits);
    for bits in (first..limit).step_by(1009) {
        see(f32::from_bits(bits));
    }
    fused.within(0.95, "single sine pair, fused");
    plain.within(0.85, "single sine pair, plain");
}

/// How far `angle` is from the angle of a vector, both taken as exact.
fn angle_error(angle: f64, y: f64, x: f64) -> f64 {
    // Not so small that the reference loses digits.
    let scale = if y.abs().max(x.abs()) < 1e-200 {
        2f64.powi(500)
    } else {
        1.0
    };
    let (y, x) = (Big::from(y * scale), Big::from(x * scale));
    let (sine, cosine) = Big::from(angle).sin_cos();
    let ahead = &x * &cosine + &y * &sine;
    if ahead.is_negative() || angle.is_nan() {
        return f64::INFINITY;
    }
    let aside = &y * &cosine - &x * &sine;
    (aside / (&x * &x + &y * &y).sqrt()).to_f64().abs()
}

/// Errors of angles of vectors in units in the last place.
fn angles(vectors: impl Iterator<Item = (f64, f64)>, what: &str) {
    let mut fused = Largest::default();
    let mut plain = Largest::default();
    for (y, x) in vectors {
        let see = |largest: &mut Largest, angle: f64| {
            largest.see(angle_error(angle, y, x) / unit_f64(angle), y / x);
        };
        see(&mut fused, y.atan2_with::<true>(x));
        see(&mut plain, y.atan2_with::<false>(x));
    }
    fused.within(1.1, &format!("angle {what}, fused"));
    plain.within(1.2, &format!("angle {what}, plain"));
}

#[test]
fn angles_are_within_about_a_unit() {
    let mut random = Random::new(304);
    let mut vector = |scale: fn(&mut Random) -> f64| {
        let scale = scale(&mut random);
        (random.between(-scale, scale), random.between(-scale, scale))
    };
    angles((0..1500).map(|_| vector(|_| 1.0)), "in a square");
    angles(
        (0..1000).map(|_| vector(|r| r.ratio(1e-300, 1e300))),
        "of any size",
    );
    angles((0..500).map(|_| vector(|_| 1e-307)), "of tiny vectors");
    angles((0..500).map(|_| vector(|_| 8e307)), "of huge vectors");
}

#[test]
fn angles_are_within_about_a_unit_at_any_slope() {
    let mut random = Random::new(305);
    let near_diagonal: Vec<_> = (0..1000)
        .map(|_| (random.between(0.8, 1.25), 1.0))
        .collect();
    angles(near_diagonal.into_iter(), "near the diagonal");
    let any: Vec<_> = (0..300)
        .map(|_| (random.ratio(1e-150, 1e150), random.ratio(1e-150, 1e150)))
        .flat_map(|(y, x)| [(y, x), (-y, x), (y, -x), (-y, -x)])
        .collect();
    angles(any.into_iter(), "of any slope");
}

#[test]
fn single_angles_are_within_about_a_unit() {
    let mut random = Random::new(306);
    let mut fused = Largest::default();
    let mut plain = Largest::default();
    for k in 0..400_000 {
        let scale = if k % 2 == 0 {
            1.0
        } else {
            random.ratio(1e-36, 1e36)
        };
        let y = (scale * random.between(-1.0, 1.0)) as f32;
        let x = (scale * random.between(-1.0, 1.0)) as f32;
        let exact = f64::from(y).atan2(f64::from(x));
        let place = f64::from(y) / f64::from(x);
        let see = |largest: &mut Largest, angle: f32| {
            largest.see((f64::from(angle) - exact).abs() / unit_f32(exact), place);
        };
        see(&mut fused, y.atan2_with::<true>(x));
        see(&mut plain, y.atan2_with::<false>(x));
    }
    fused.within(1.1, "single angle, fused");
    plain.within(1.4, "single angle, plain");
}
