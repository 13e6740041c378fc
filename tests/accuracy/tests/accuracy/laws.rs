//! Laws of motion against 30 digits, with three derivatives, from both sides of their borders; pieces against laws; splines
//! against 30 digits; derivatives against dual numbers.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use linkage::Scalar;

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
        let clamped = spline(phi, [(start, 2mm, jump), (90deg, second), (180deg, 5mm), (250deg, 1mm, jump)], clamped);
        let again = spline(phi, [(10deg, 2mm), (start, second), (70deg, 5mm), (90deg, 2mm)], periodic);
        let quintic = spline(phi, [
            (0deg, 0mm), (40deg, 3.5mm), (90deg, 11.25mm), (130deg, 12mm), (180deg, 10.5mm),
            (235deg, 6.75mm), (280deg, -1.5mm), (325deg, -2.25mm), (360deg, 0mm),
        ], quintic);
        let sloped = spline(phi, [
            (0deg, 0mm, 0.05mm / 1deg), (40deg, 3.5mm, 0.12mm / 1deg), (90deg, 11.25mm, 0.1mm / 1deg),
            (130deg, 12mm, -0.02mm / 1deg), (180deg, 10.5mm, -0.06mm / 1deg), (235deg, 6.75mm, -0.14mm / 1deg),
            (280deg, -1.5mm, -0.1mm / 1deg), (325deg, -2.25mm, 0.03mm / 1deg), (360deg, 0mm, 0.05mm / 1deg),
        ]);
        let bent = spline(phi, [(start, 2mm), (90deg, second), (180deg, 5mm), (250deg, 1mm)], clamped, quintic);
        let free = spline(phi, [(start, 2mm), (90deg, second), (180deg, 5mm), (250deg, 1mm)], quintic);
        let led = spline(phi, [(start, 2mm, second / 2), (90deg, second, 0mm / 1deg), (180deg, 5mm, -1mm)]);
        let circle = spline(phi, [(10deg, 2mm), (start, second), (70deg, 5mm), (90deg, 2mm)], quintic, periodic);
    }

    impl Courses {
        fn values(phi) -> CourseValues { s, once, spline, natural, clamped, again, quintic, sloped }
        /// Quintic splines by parameters, as far as [`ByDimensions`] asks.
        fn quintics(phi) -> Quintics {
            bent, free: velocity(free), led: velocity(led), circle: acceleration(circle),
            bent_slope: slope(bent), led_curvature: slope(slope(led)),
        }
        fn rates(phi) -> CourseRates {
            s: velocity(s), once: velocity(once), spline: velocity(spline), natural: velocity(natural),
            clamped: velocity(clamped), again: velocity(again), quintic: velocity(quintic), sloped: velocity(sloped),
        }
        fn accelerations(phi) -> CourseAccelerations {
            s: acceleration(s), once: acceleration(once), spline: acceleration(spline),
            natural: acceleration(natural), clamped: acceleration(clamped), again: acceleration(again),
            quintic: acceleration(quintic), sloped: acceleration(sloped),
        }
        fn jerks(phi) -> CourseJerks {
            s: jerk(s), once: jerk(once), spline: jerk(spline), natural: jerk(natural),
            clamped: jerk(clamped), again: jerk(again), quintic: jerk(quintic), sloped: jerk(sloped),
        }
        fn by_dimensions(phi) -> ByDimensions {
            s: sensitivity(s, [lift, start]),
            s_rate: sensitivity(velocity(s), [lift, start]),
            natural: sensitivity(natural, [second, start]),
            clamped: sensitivity(clamped, [second, start]),
            again: sensitivity(velocity(again), [second, start]),
            bent: sensitivity(bent, [second, start]),
            free: sensitivity(velocity(free), [second, start]),
            led: sensitivity(velocity(led), [second, start]),
            circle: sensitivity(acceleration(circle), [second, start]),
            bent_slope: sensitivity(slope(bent), [second, start]),
            led_curvature: sensitivity(slope(slope(led)), [second, start]),
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
        list!($result; s once spline natural clamped again quintic sloped)
    };
}

// Behind the macros, which they use.
mod courses;
mod rises;

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

/// A course and its derivatives, for every course.
fn courses(phi: f64) -> [[f64; 8]; 4] {
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
