//! Enclosures hold all values and slopes of a function, and are tight by the square of the interval.

use linkage_core::{Dual, Enclosure, Scalar};
use linkage_random::Random;
use num_dual::Dual64;

/// A function of one variable, and what it is called.
type Named<T> = (&'static str, fn(T) -> T);

/// Functions that together call everything.
fn functions<T: Scalar>() -> [Named<T>; 14] {
    let all: [Named<T>; 14] = [
        ("polynomial", |x| {
            (x * x - T::from_f64(2.0)) * x + T::from_f64(0.3)
        }),
        ("quotient", |x| x / (x * x + T::from_f64(0.7))),
        ("wave", |x| {
            let (sin, cos) = (x + x).sin_cos();
            sin * sin - cos * T::from_f64(0.3) + x.sin_cos().0
        }),
        ("root", |x| {
            let square = x * x + T::from_f64(0.1);
            square.root_with::<false>(square.slack(), T::from_f64(1.0)) + square.sqrt()
        }),
        ("abs", |x| (x - T::from_f64(0.2)).abs() * x),
        ("min", |x| x.min(x * x) + (x + x).max(T::from_f64(0.5))),
        ("hypot", |x| x.hypot(x - T::from_f64(1.0))),
        ("tan", |x| (x * T::from_f64(0.3)).tan()),
        ("asin", |x| (x * T::from_f64(0.24)).asin()),
        ("acos", |x| (x * T::from_f64(0.24)).acos()),
        ("atan", |x| (x + x).atan()),
        ("atan2", |x| (x * x + T::from_f64(0.2)).atan2(x)),
        ("angle", |x| {
            let (sin, cos) = (x + x).sin_cos();
            let three = T::from_f64(3.0);
            T::angle_near(sin * three, cos * three, x + x + T::from_f64(0.2)) * x
        }),
        ("select", |x| {
            T::select(x - T::from_f64(0.4), x * x, -x)
                + x.sign() * x * x.inverse_scale() * x.inverse_scale().inverse_scale()
        }),
    ];
    all
}

#[test]
fn all_values_and_slopes_are_within() {
    let mut random = Random::new(7);
    let plain = functions::<f64>();
    let dual = functions::<Dual<Dual64>>();
    for (k, (name, own)) in functions::<Enclosure>().into_iter().enumerate() {
        let (mut known, mut steep) = (0, 0);
        for _ in 0..2000 {
            let width = 10.0_f64.powf(random.between(-12.0, 0.5));
            let low = random.between(-4.0, 4.0 - width).max(-4.0);
            let high = (low + width).min(4.0);
            let bounds = own(Enclosure::over(low, high));
            let ([least, most], [falls, rises]) = (bounds.range(), bounds.slopes());
            known += usize::from(least <= most);
            steep += usize::from(falls <= rises);
            for i in 0..=20 {
                let x = if i == 20 {
                    high
                } else {
                    low + (high - low) * (f64::from(i) / 20.0)
                };
                let value = plain[k].1(x);
                // What is computed is rounded itself; the true value is within.
                let room = 1e-14 * (1.0 + value.abs());
                // Bounds that are not known are NaN.
                let beyond = least - value > room || value - most > room;
                assert!(!beyond, "{name} at {x}: {value} not in {least} to {most}");
                let slope = dual[k].1(Dual(Dual64::new(x, 1.0))).0.eps;
                let room = 1e-12 * (1.0 + slope.abs());
                let beyond = falls - slope > room || slope - rises > room;
                assert!(
                    !beyond,
                    "{name} at {x}: slope {slope} not in {falls} to {rises}"
                );
            }
        }
        assert!(
            known > 1500 && steep > 1000,
            "{name}: {known} and {steep} are known"
        );
    }
}

/// A tenth of the interval, a hundredth of what the bounds are too wide.
#[test]
fn short_intervals_are_tight() {
    for (k, (name, own)) in functions::<Enclosure>().into_iter().enumerate() {
        let centre = 1.17;
        let excess = |half: f64| {
            let [least, most] = own(Enclosure::over(centre - half, centre + half)).range();
            let ends = [centre - half, centre + half].map(functions::<f64>()[k].1);
            (most - least) - (ends[0] - ends[1]).abs()
        };
        let [wide, narrow] = [excess(1e-2), excess(1e-3)];
        assert!(narrow < 0.02 * wide + 1e-13, "{name}: {wide:e}, {narrow:e}");
    }
}

/// Nothing is known where a part of a function has no value, or jumps.
#[test]
fn what_is_not_known_is_said() {
    let x = Enclosure::over(-0.1, 0.1);
    let one = Enclosure::from_f64(1.0);
    assert!((one / x).range()[0].is_nan());
    assert!(x.sqrt().range()[0].is_nan());
    assert!((one / x * Enclosure::from_f64(0.0)).range()[0].is_nan());
    assert!(x.sign().slopes()[0].is_nan());
    assert_eq!(x.sign().range(), [-1.0, 1.0]);
    assert!(x.atan2(-one).range()[0].is_nan());
    // A root is that of what is not negative; its slope has no bounds beside zero.
    let root = x.root_with::<false>(one.slack(), one);
    assert!(root.range()[0] == 0.0 && root.slopes()[0].is_nan());
}

#[test]
fn constants_have_no_slope_and_none_is_rounded_into_others() {
    let [third, two] = [
        Enclosure::from_f64(1.0) / Enclosure::from_f64(3.0),
        Enclosure::from_f64(2.0),
    ];
    assert_eq!((third * two + third).slopes(), [0.0, 0.0]);
    let x = Enclosure::over(0.5, 0.75);
    assert_eq!((x + third).slopes(), [1.0, 1.0]);
    let [least, most] = (third * x).slopes();
    assert!(least < 1.0 / 3.0 && 1.0 / 3.0 < most && most - least < 3e-16);
    // Nothing times what is not known, or infinite, is not known.
    let unknown = Enclosure::from_f64(-1.0).sqrt();
    assert!((third * unknown).slopes()[0].is_nan());
    assert!((Enclosure::from_f64(0.0) * Enclosure::over(0.0, f64::INFINITY)).range()[0].is_nan());
}
