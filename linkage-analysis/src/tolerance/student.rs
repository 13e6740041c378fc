//! Student's distribution.

use super::distribution::normal;

/// The degrees of freedom beyond which the series about the normal distribution is good to the last
/// digits, up to confidences of 0.999999: a term is at least a hundred times as small as the one
/// before it.
const MANY: f64 = 3000.0;
/// An iteration of the continued fraction that has converged changes its value by roundoffs only.
const SETTLED: f64 = 1e-16;

/// The size that a variable of Student's distribution with these degrees of freedom exceeds with a
/// probability of `1 - confidence`. NaN if the confidence is not between 0 and 1 or the degrees of
/// freedom are below 1.
pub(super) fn two_sided(confidence: f64, degrees: f64) -> f64 {
    outside(1.0 - confidence, degrees)
}

/// The size that such a variable exceeds with this probability, which keeps the digits of a small
/// one.
pub fn outside(outside: f64, degrees: f64) -> f64 {
    if !(outside > 0.0 && outside < 1.0 && degrees >= 1.0) {
        return f64::NAN;
    }
    let z = -normal(0.5 * outside);
    if degrees.is_infinite() {
        return z;
    }
    let start = expansion(z, degrees);
    if degrees >= MANY {
        return start;
    }
    newton(start, outside, degrees)
}

/// Quantiles about those of the normal distribution, by inverse powers of the degrees of freedom
/// (Abramowitz and Stegun, 26.7.5).
fn expansion(z: f64, degrees: f64) -> f64 {
    let (w, v) = (z * z, 1.0 / degrees);
    let first = (w + 1.0) / 4.0;
    let second = ((5.0 * w + 16.0) * w + 3.0) / 96.0;
    let third = (((3.0 * w + 19.0) * w + 17.0) * w - 15.0) / 384.0;
    let fourth = ((((79.0 * w + 776.0) * w + 1482.0) * w - 1920.0) * w - 945.0) / 92160.0;
    let fifth =
        (((((27.0 * w + 339.0) * w + 930.0) * w - 1782.0) * w - 765.0) * w + 17955.0) / 368_640.0;
    z * (1.0 + v * (first + v * (second + v * (third + v * (fourth + v * fifth)))))
}

/// Solves by Newton's method, and by bisection where a step leaves the known interval.
fn newton(start: f64, outside: f64, degrees: f64) -> f64 {
    let (mut low, mut high) = (0.0, f64::INFINITY);
    let mut t = start;
    // Far more than Newton's method takes from that start.
    for _ in 0..200 {
        let found = beyond(t, degrees);
        if found > outside {
            low = t;
        } else {
            high = t;
        }
        let slope = 2.0 * density(t, degrees);
        let next = t + (found - outside) / slope;
        let next = match next > low && next < high {
            true => next,
            false if high.is_infinite() => 2.0 * t,
            false => 0.5 * (low + high),
        };
        let change = (next - t).abs();
        t = next;
        if change <= 4.0 * f64::EPSILON * t {
            break;
        }
    }
    t
}

fn density(t: f64, degrees: f64) -> f64 {
    let power = -0.5 * (degrees + 1.0) * (t * t / degrees).ln_1p();
    power.exp() / (degrees.sqrt() * beta(0.5 * degrees))
}

/// The probability of a size above `t`: the incomplete beta function of `degrees / 2` and 1/2 at
/// `degrees / (degrees + t^2)`, by its continued fraction on the side where that converges fast.
fn beyond(t: f64, degrees: f64) -> f64 {
    let (x, y) = (degrees / (degrees + t * t), t * t / (degrees + t * t));
    let (a, b) = (0.5 * degrees, 0.5);
    // The logarithm of x: of x itself it would lose digits where x is close to 1.
    let front = (-a * (t * t / degrees).ln_1p()).exp() * y.sqrt() / beta(a);
    if x < (a + 1.0) / (a + b + 2.0) {
        front * fraction([x, y], a, b) / a
    } else {
        1.0 - front * fraction([y, x], b, a) / b
    }
}

/// The beta function of `a` and 1/2: `sqrt(pi) gamma(a) / gamma(a + 1/2)`, by the asymptotic series
/// of that ratio after some steps upwards.
fn beta(a: f64) -> f64 {
    /// The series of five terms is good to 1e-17 from here on.
    const FAR: f64 = 30.0;
    let (mut a, mut factor) = (a, core::f64::consts::PI.sqrt());
    while a < FAR {
        factor *= (a + 0.5) / a;
        a += 1.0;
    }
    let v = 1.0 / (a * a);
    let series = (1.0 / 8.0
        - v * (1.0 / 192.0 - v * (1.0 / 640.0 - v * (17.0 / 14336.0 - v * 31.0 / 18432.0))))
        / a;
    factor * series.exp() / a.sqrt()
}

/// The continued fraction of the incomplete beta function, by Lentz's method (Numerical Recipes,
/// 6.4). `y` is `1 - x`.
fn fraction([x, y]: [f64; 2], a: f64, b: f64) -> f64 {
    // The number of terms grows with the square root of the larger parameter: some hundred for the
    // largest.
    const TERMS: i32 = 10_000;
    // `a + 1 - (a + b) x`, by the smaller of both parts of 1, which has more digits.
    let first = if x < 0.5 {
        a + 1.0 - (a + b) * x
    } else {
        1.0 - b + (a + b) * y
    };
    let (mut c, mut d) = (1.0, (a + 1.0) / first);
    let mut value = d;
    for m in 1..TERMS {
        let m = f64::from(m);
        let even = m * (b - m) * x / ((a + 2.0 * m - 1.0) * (a + 2.0 * m));
        let odd = -(a + m) * (a + b + m) * x / ((a + 2.0 * m) * (a + 2.0 * m + 1.0));
        let mut change = 1.0;
        for term in [even, odd] {
            d = 1.0 / (1.0 + term * d);
            c = 1.0 + term / c;
            change = c * d;
            value *= change;
        }
        if (change - 1.0).abs() <= SETTLED {
            break;
        }
    }
    value
}

#[cfg(test)]
mod tests {
    use super::two_sided;

    /// Solved with 50 digits.
    #[test]
    #[allow(clippy::excessive_precision, reason = "digits of the reference")]
    fn quantiles() {
        let known = [
            (1.0, 0.5, 1.0),
            (1.0, 0.95, 12.706204736174693314101641218977),
            (1.0, 0.999999, 636619.77234875131970185908052028),
            (2.0, 0.6827, 1.3213154624456929617853394672427),
            (2.0, 0.9973, 19.206015887810967941428162230418),
            (3.5, 0.95, 2.9400886379827288124732520398254),
            (3.5, 0.9973, 7.6028638633228334226115341856264),
            (8.0, 0.5, 0.70638661264483860007882339720153),
            (8.0, 0.999999, 13.257135102178597156198417762876),
            (16.7, 0.95, 2.1127064206595903474279525003708),
            (16.7, 0.9973, 3.5179256917124123246952760021075),
            (49.5, 0.5, 0.67947840715045127462210418688918),
            (49.5, 0.95, 2.0090619185113156946413868606832),
            (1000.0, 0.6827, 1.0005219851163688213245656894183),
            (1000.0, 0.9973, 3.0074941112886800409120453164761),
            (30000.0, 0.999999, 4.8926548211845347334224075137078),
            (2999.0, 0.5, 0.67457156461125400881857834918023),
            (2999.0, 0.95, 1.9607553192053148286509049588117),
            (2999.0, 0.999999, 4.901821908957083396926408927793),
            (3001.0, 0.5, 0.67457151008059955029749727315605),
            (3001.0, 0.95, 1.9607547916155343326513122323262),
            (3001.0, 0.999999, 4.9018151099732511636369182244641),
            (99999.0, 0.95, 1.9599877077718443991432179607088),
            (99999.0, 0.9973, 3.0000519935678873731696734739483),
            (100001.0, 0.95, 1.9599877072973788628882427500687),
            (100001.0, 0.999999, 4.891943337660666331137158954859),
            (1e7, 0.9973, 2.9999777426874566052404323712335),
            (f64::INFINITY, 0.95, 1.9599639845400538556044306498266),
        ];
        for (degrees, confidence, quantile) in known {
            let found = two_sided(confidence, degrees);
            let off = (found / quantile - 1.0).abs();
            // The effect of a digit of the confidence on the quantile, and the continued fraction's
            // loss for many degrees.
            let limit = 2e-15 / (1.0 - confidence) + 1e-17 * degrees.min(3000.0);
            assert!(off < limit, "{degrees} {confidence}: {found}, {off:e} off");
        }
    }

    #[test]
    fn no_quantile() {
        for (confidence, degrees) in [
            (0.0, 5.0),
            (1.0, 5.0),
            (f64::NAN, 5.0),
            (0.9, f64::NAN),
            (0.9, 0.5),
        ] {
            assert!(two_sided(confidence, degrees).is_nan());
        }
    }
}
