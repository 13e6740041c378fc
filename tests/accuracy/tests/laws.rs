//! Laws of motion against 30 digits, with three derivatives, from both sides of their borders; pieces against laws; splines
//! against 30 digits; derivatives against dual numbers.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use linkage::{Dual, Scalar};
use linkage_random::Random;
use linkage_reference::Fused;
use num_dual::{Dual3_64, Dual64};

linkage::mechanism! {
    struct Laws {
        input x = 0.3 in -1..2;
        let line = rise(x, line);
        let cubic = rise(x, cubic);
        let poly345 = rise(x, poly345);
        let poly4567 = rise(x, poly4567);
        let harmonic = rise(x, harmonic);
        let cycloidal = rise(x, cycloidal);
        let sine = rise(x, modified_sine);
        let trapezoid = rise(x, modified_trapezoid);
    }

    impl Laws {
        fn values(x) -> Values { line, cubic, poly345, poly4567, harmonic, cycloidal, sine, trapezoid }
        fn first(x) -> First {
            line: velocity(line), cubic: velocity(cubic), poly345: velocity(poly345),
            poly4567: velocity(poly4567), harmonic: velocity(harmonic), cycloidal: velocity(cycloidal),
            sine: velocity(sine), trapezoid: velocity(trapezoid),
        }
        fn second(x) -> Second {
            line: acceleration(line), cubic: acceleration(cubic), poly345: acceleration(poly345),
            poly4567: acceleration(poly4567), harmonic: acceleration(harmonic),
            cycloidal: acceleration(cycloidal), sine: acceleration(sine), trapezoid: acceleration(trapezoid),
        }
        fn third(x) -> Third {
            line: jerk(line), cubic: jerk(cubic), poly345: jerk(poly345), poly4567: jerk(poly4567),
            harmonic: jerk(harmonic), cycloidal: jerk(cycloidal), sine: jerk(sine),
            trapezoid: jerk(trapezoid),
        }
    }
}

linkage::mechanism! {
    /// All laws in one course, and splines.
    struct Courses {
        unit mm;
        param lift = 20mm;
        param start = 40deg;
        param second = 3mm;
        input phi = 30deg in 0deg..360deg;
        let s = piecewise(phi, [
            (0deg, 2mm), (start, 2mm), (90deg, lift, modified_sine), (120deg, lift), (160deg, 9mm, poly345),
            (200deg, 12mm, modified_trapezoid), (220deg, 10mm, cycloidal), (225deg, 10mm),
            (260deg, 6mm, poly4567, jump), (300deg, 4mm, line, jump), (330deg, 3mm, harmonic, jump),
            (360deg, 2mm, cubic, jump),
        ]);
        // It begins within a turn, ends within the next one, and the first and the last knot accept a jump.
        let once = piecewise(phi, [(30deg, 2mm, jump), (90deg, lift, line, jump), (180deg, 2mm, line, jump)]);
        let spline = spline(phi, [
            (0deg, 0mm), (40deg, 3.5mm), (90deg, 11.25mm), (130deg, 12mm), (180deg, 10.5mm),
            (235deg, 6.75mm), (280deg, -1.5mm), (325deg, -2.25mm), (360deg, 0mm),
        ]);
        let natural = spline(phi, [(start, 2mm), (90deg, second), (180deg, 5mm), (250deg, 1mm)]);
        let clamped = spline(phi, [(start, 2mm), (90deg, second), (180deg, 5mm), (250deg, 1mm)], clamped);
        let again = spline(phi, [(10deg, 2mm), (start, second), (70deg, 5mm), (90deg, 2mm)], periodic);
    }

    impl Courses {
        fn values(phi) -> CourseValues { s, once, spline, natural, clamped, again }
        fn rates(phi) -> CourseRates {
            s: velocity(s), once: velocity(once), spline: velocity(spline), natural: velocity(natural),
            clamped: velocity(clamped), again: velocity(again),
        }
        fn accelerations(phi) -> CourseAccelerations {
            s: acceleration(s), once: acceleration(once), spline: acceleration(spline),
            natural: acceleration(natural), clamped: acceleration(clamped), again: acceleration(again),
        }
        fn jerks(phi) -> CourseJerks {
            s: jerk(s), once: jerk(once), spline: jerk(spline), natural: jerk(natural),
            clamped: jerk(clamped), again: jerk(again),
        }
        fn by_dimensions(phi) -> ByDimensions {
            s: sensitivity(s, [lift, start]),
            s_rate: sensitivity(velocity(s), [lift, start]),
            natural: sensitivity(natural, [second, start]),
            clamped: sensitivity(clamped, [second, start]),
            again: sensitivity(velocity(again), [second, start]),
        }
    }
}

/// The fields of a result in the order of the laws or courses.
macro_rules! list {
    ($result:expr; $($field:ident)*) => {{
        let result = $result;
        [$(result.$field),*]
    }};
}

macro_rules! laws {
    ($result:expr) => {
        list!($result; line cubic poly345 poly4567 harmonic cycloidal sine trapezoid)
    };
}

macro_rules! courses {
    ($result:expr) => {
        list!($result; s once spline natural clamped again)
    };
}

/// In the order of the results. With the largest values of four derivatives.
const LAWS: [(&str, [f64; 4]); 8] = [
    ("line", [1.0, 0.0, 0.0, 0.0]),
    ("cubic", [1.5, 6.0, 12.0, 0.0]),
    ("poly345", [1.875, 5.7735, 60.0, 360.0]),
    ("poly4567", [2.1875, 7.5132, 52.5, 840.0]),
    ("harmonic", [FRAC_PI_2, 4.9348, 15.503, 48.705]),
    ("cycloidal", [2.0, TAU, 39.478, 248.05]),
    ("modified_sine", [1.7596, 5.5280, 69.466, 872.94]),
    ("modified_trapezoid", [2.0, 4.8881, 61.426, 771.9]),
];

/// A line of the references.
struct Reference {
    law: &'static str,
    at: f64,
    side: &'static str,
    values: [f64; 4],
}

fn references() -> impl Iterator<Item = Reference> {
    let lines = include_str!("laws/values.txt").lines();
    lines.filter(|line| !line.starts_with('#')).map(|line| {
        let mut words = line.split(' ');
        let mut word = || words.next().expect("law, place, side and four values");
        let (law, at, side) = (word(), word(), word());
        let mut number = || word().parse().expect("a number");
        Reference {
            law,
            at: at.parse().expect("a number"),
            side,
            values: [(); 4].map(|()| number()),
        }
    })
}

/// A law and its derivatives, for every law.
fn laws<T: Scalar>(x: T) -> [[f64; 8]; 4] {
    let linkage = Laws::default()
        .cast::<T>()
        .assemble()
        .expect("it has no loop");
    let all = [
        laws!(linkage.values(x)),
        laws!(linkage.first(x)),
        laws!(linkage.second(x)),
        laws!(linkage.third(x)),
    ];
    all.map(|own| own.map(|x| x.lane(0)))
}

/// Largest errors of all laws against the references, of the largest value of each derivative.
fn worst<T: Scalar>(next: impl Fn(f64, &str) -> T, roundoff: f64) -> f64 {
    let mut worst: f64 = 0.0;
    let mut count = 0;
    for reference in references() {
        let Some(law) = LAWS.iter().position(|own| own.0 == reference.law) else {
            continue;
        };
        let x = next(reference.at / 40.0, reference.side);
        // Fortieths are rounded when they become numbers, and both sides of a border are a number apart.
        let moved = 0.5 * roundoff + (x.lane(0) - reference.at / 40.0).abs();
        let moved = if reference.at % 5.0 == 0.0 && reference.side == "value" {
            0.0
        } else {
            moved
        };
        let found = laws(x);
        let largest = |order: usize| {
            if order == 0 {
                1.0
            } else {
                LAWS[law].1[order - 1]
            }
        };
        for (order, (own, expected)) in found.iter().zip(reference.values).enumerate() {
            let error = (own[law] - expected).abs();
            let of_place = moved * LAWS[law].1[order];
            worst = worst.max((error - of_place) / largest(order));
            count += 1;
        }
    }
    assert!(count > 300, "{count}");
    worst
}

/// The number at a place as it is seen from one side of it.
fn at_side(x: f64, side: &str) -> f64 {
    if side == "left" { x.next_down() } else { x }
}

#[test]
fn laws_have_fifteen_digits_up_to_the_third_derivative() {
    let found = worst(at_side, f64::EPSILON);
    let fused = worst(|x, side| Fused(at_side(x, side)), f64::EPSILON);
    let single = worst(
        |x, side| {
            if side == "left" {
                (x as f32).next_down()
            } else {
                x as f32
            }
        },
        f64::from(f32::EPSILON),
    );
    println!(
        "laws, of their largest values: {found:e}, fused {fused:e}, single precision {single:e}"
    );
    assert!(found <= 1e-15 && fused <= 1e-15 && single <= 5e-7);
}

#[test]
fn laws_rest_outside_and_pass_nan_on() {
    for x in [-1e300, -1.0, -f64::MIN_POSITIVE, 1.0, 2.0, 1e300] {
        let end = if x < 0.0 { 0.0 } else { 1.0 };
        let [values, rates @ ..] = laws(x);
        assert_eq!(values, [end; 8], "{x}");
        assert_eq!(rates, [[0.0; 8]; 3], "{x}");
    }
    assert_eq!(laws(0.0)[0], [0.0; 8]);
    let nowhere = laws(f64::NAN);
    assert!(nowhere[..2].as_flattened().iter().all(|x| x.is_nan()));
    // The line has no acceleration anywhere.
    assert!(
        nowhere[2..]
            .iter()
            .all(|own| own[1..].iter().all(|x| x.is_nan()))
    );
}

/// Every derivative against that of dual numbers, which know nothing of the formulas for slopes.
#[test]
fn derivatives_are_those_of_dual_numbers() {
    let mut random = Random::new(61);
    let linkage = Laws::default()
        .cast::<Dual<Dual3_64>>()
        .assemble()
        .expect("it has no loop");
    for _ in 0..200 {
        let x = random.between(-0.2, 1.2);
        let [_, first, second, third] = laws(x);
        let dual = laws!(linkage.values(Dual(Dual3_64::new(x, 1.0, 0.0, 0.0))));
        for (law, Dual(own)) in dual.into_iter().enumerate() {
            let pairs = [(first, own.v1), (second, own.v2), (third, own.v3)];
            for (order, (found, expected)) in pairs.into_iter().enumerate() {
                let error = (found[law] - expected).abs();
                let allowed = 1e-14 * LAWS[law].1[order].max(1.0);
                assert!(
                    error <= allowed,
                    "{} {order} at {x}: {} {expected}",
                    LAWS[law].0,
                    found[law]
                );
            }
        }
    }
}

/// A course and its derivatives, for every course.
fn courses(phi: f64) -> [[f64; 6]; 4] {
    let linkage = Courses::default().assemble().expect("it has no loop");
    [
        courses!(linkage.values(phi)),
        courses!(linkage.rates(phi)),
        courses!(linkage.accelerations(phi)),
        courses!(linkage.jerks(phi)),
    ]
}

/// The number nearest to so many degrees in radians, as the compiler takes literals.
fn radians(degrees: f64) -> f64 {
    // Pi less the number nearest to it.
    const REST: f64 = 1.224_646_799_147_353_2e-16;
    let product = degrees * PI;
    let lost = degrees.mul_add(PI, -product) + degrees * REST;
    let quotient = product / 180.0;
    quotient + ((-quotient).mul_add(180.0, product) + lost) / 180.0
}

/// From which knot to which one, from which value to which one, by which of [`LAWS`]; none where it rests.
const PIECES: [(f64, f64, f64, f64, Option<usize>); 11] = [
    (0.0, 40.0, 2.0, 2.0, None),
    (40.0, 90.0, 2.0, 20.0, Some(6)),
    (90.0, 120.0, 20.0, 20.0, None),
    (120.0, 160.0, 20.0, 9.0, Some(2)),
    (160.0, 200.0, 9.0, 12.0, Some(7)),
    (200.0, 220.0, 12.0, 10.0, Some(5)),
    (220.0, 225.0, 10.0, 10.0, None),
    (225.0, 260.0, 10.0, 6.0, Some(3)),
    (260.0, 300.0, 6.0, 4.0, Some(0)),
    (300.0, 330.0, 4.0, 3.0, Some(4)),
    (330.0, 360.0, 3.0, 2.0, Some(1)),
];

/// Each piece is its law, at its knots from both sides, in its middle, and turns later.
#[test]
fn pieces_are_their_laws() {
    let mut worst: f64 = 0.0;
    for (from, to, before, behind, law) in PIECES {
        let [begin, end]: [f64; 2] = [from, to].map(radians);
        let width = end - begin;
        for part in [0.0, 0.2, 0.5, 0.77, 1.0] {
            let phi: f64 = if part == 1.0 {
                end.next_down()
            } else {
                begin + part * width
            };
            // Where a piece begins within rounding, its law does; it ends with its last number.
            let x = ((phi - begin) / width).max(0.0).min(1.0_f64.next_down());
            let shape = law.map_or([0.0; 4], |law| laws(x).map(|own| own[law]));
            let sizes = law.map_or([0.0; 4], |law| LAWS[law].1);
            for turns in [0.0, 1.0, -3.0, 40.0] {
                let moved = phi + turns * TAU;
                // Where rounding leads across a knot, the next piece counts.
                if turns != 0.0 && (part == 0.0 || part == 1.0) {
                    continue;
                }
                let found = courses(moved).map(|own| own[0]);
                for order in 0..4 {
                    let scale = (behind - before) / width.powi(order as i32);
                    let base = if order == 0 { before } else { 0.0 };
                    let error = (found[order] - (base + scale * shape[order])).abs();
                    let size = if order == 0 { 1.0 } else { sizes[order - 1] };
                    // What rounding of the place does; turns are rounded, too.
                    let wound = if turns == 0.0 {
                        0.0
                    } else {
                        (phi + moved.abs()) / width
                    };
                    let rounding = f64::EPSILON * (2.0 + wound);
                    let of_place = rounding * sizes[order] * scale.abs();
                    let roundoff = f64::EPSILON
                        * (20.0 * f64::from(u8::from(order == 0)) + scale.abs() * size);
                    worst = worst.max(error / (of_place + 2.0 * roundoff));
                    assert!(
                        error <= of_place + 2.0 * roundoff,
                        "order {order} at {moved}: {error:e} {roundoff:e}"
                    );
                }
            }
        }
    }
    println!("pieces: {worst:.2} of what is allowed");
}

#[test]
fn courses_without_a_period_end_and_others_do_not() {
    let at = |degrees: f64| courses(radians(degrees));
    for degrees in [-1000.0, 0.0, 29.0, 181.0, 390.0] {
        assert_eq!(
            at(degrees).map(|own| own[1]),
            [2.0, 0.0, 0.0, 0.0],
            "{degrees}"
        );
    }
    let [before, behind] = [30.0, 250.0].map(at);
    let [natural, clamped] = [3, 4];
    // Straight on, and level.
    assert_eq!(
        (before[2][natural], before[3][natural], before[1][clamped]),
        (0.0, 0.0, 0.0)
    );
    let further = at(300.0);
    let straight = behind[0][natural] + behind[1][natural] * radians(50.0);
    assert!((further[0][natural] - straight).abs() < 1e-13);
    assert_eq!((further[0][clamped], further[1][clamped]), (1.0, 0.0));
    // A period that is no turn.
    for degrees in [15.0, 37.0, 88.0] {
        let [here, later] = [degrees, degrees + 240.0].map(at);
        for order in 0..4 {
            let size = here[order][5].abs().max(1.0);
            assert!(
                (here[order][5] - later[order][5]).abs() < 1e-12 * size,
                "{degrees} {order}"
            );
        }
    }
    assert!(at(f64::NAN)[..2].as_flattened().iter().all(|x| x.is_nan()));
}

#[test]
fn splines_have_fifteen_digits() {
    // The largest values of the spline and its derivatives, by degrees.
    let sizes = [12.3, 0.21, 0.0056, 2.6e-4];
    let mut worst: f64 = 0.0;
    for Reference {
        at, side, values, ..
    } in references().filter(|own| own.law == "spline")
    {
        let place = radians(at);
        let place = if side == "left" {
            if at == 0.0 { -1e-15 } else { place.next_down() }
        } else {
            place
        };
        let found = courses(place).map(|own| own[2]);
        let mut per = 1.0;
        for order in 0..4 {
            let error = (found[order] * per - values[order]).abs();
            // Degrees are rounded when they become radians.
            let of_place = match order {
                3 => 0.0,
                _ => 2.0 * f64::EPSILON * at * sizes[order + 1],
            };
            worst = worst.max((error - of_place) / sizes[order]);
            per *= radians(1.0);
        }
    }
    println!("spline, of its largest values: {worst:e}");
    assert!(worst <= 2e-15);
}

/// Sensitivities to values and places of knots against dual numbers, which follow the whole formula.
#[test]
fn dimensions_of_courses_have_exact_sensitivities() {
    let linkage = Courses::default().assemble().expect("it has no loop");
    let of = |name: &str| {
        let mut moving = Courses::default().cast::<Dual<Dual64>>();
        let field = match name {
            "lift" => &mut moving.lift,
            "start" => &mut moving.start,
            _ => &mut moving.second,
        };
        field.0.eps = 1.0;
        moving.assemble().expect("it has no loop")
    };
    let [lift, start, second] = ["lift", "start", "second"].map(of);
    let mut random = Random::new(62);
    for _ in 0..100 {
        let phi = random.between(-7.0, 14.0);
        let found = linkage.by_dimensions(phi);
        let constant = Dual(Dual64::from(phi));
        let [by_lift, by_start, by_second] =
            [&lift, &start, &second].map(|own| own.values(constant));
        let [rate_lift, rate_start, rate_second] =
            [&lift, &start, &second].map(|own| own.rates(constant));
        let pairs = [
            (found.s, [by_lift.s, by_start.s]),
            (found.s_rate, [rate_lift.s, rate_start.s]),
            (found.natural, [by_second.natural, by_start.natural]),
            (found.clamped, [by_second.clamped, by_start.clamped]),
            (found.again, [rate_second.again, rate_start.again]),
        ];
        for (found, expected) in pairs {
            for (found, Dual(expected)) in found.into_iter().zip(expected) {
                let error = (found - expected.eps).abs();
                assert!(
                    error <= 1e-12 * expected.eps.abs().max(10.0),
                    "{phi}: {found} {}",
                    expected.eps
                );
            }
        }
    }
    // Knots that other dimensions put out of order have no course between them.
    let crossed = Courses {
        start: 2.0,
        ..Courses::default()
    }
    .assemble()
    .expect("it has no loop");
    assert!(crossed.values(1.7).s.is_nan() && crossed.rates(5.0).s.is_nan());
    assert!(crossed.values(1.9).natural.is_nan() && crossed.values(1.9).spline.is_finite());
}

/// Rows of sweeps are single calls, to the last bit.
#[test]
fn sweeps_of_courses_are_single_calls() {
    let linkage = Courses::default().assemble().expect("it has no loop");
    let inputs: Vec<f64> = (0..1001).map(|k| -20.0 + 0.04 * f64::from(k)).collect();
    let rows = linkage.values_sweep(&inputs);
    for (k, &phi) in inputs.iter().enumerate() {
        let single = linkage.values(phi);
        assert_eq!(
            (rows.s()[k], rows.spline()[k], rows.again()[k]),
            (single.s, single.spline, single.again)
        );
    }
}
