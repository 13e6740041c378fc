//! The root of a function between two places where its signs differ.

/// A place and the value there.
pub(super) type Sample = (f64, f64);

/// More than Newton's steps and all bisections of a bracket together.
const STEPS: usize = 200;

/// The root between `a` and `b`, to the last digit of the bracket's ends, if `g` gives value and slope: by Newton's
/// method, and by bisection where that leaves the bracket, is slow, or has no slope (NaN).
pub(super) fn root(mut a: Sample, mut b: Sample, g: &mut impl FnMut(f64) -> [f64; 2]) -> f64 {
    let tolerance = 0.5 * f64::EPSILON * a.0.abs().max(b.0.abs());
    let mut x = a.0 + 0.5 * (b.0 - a.0);
    let mut step = b.0 - a.0;
    let mut best = if a.1.abs() < b.1.abs() { a } else { b };
    for _ in 0..STEPS {
        let [value, slope] = g(x);
        if value.abs() <= best.1.abs() {
            best = (x, value);
        }
        if value == 0.0 {
            break;
        }
        if (value > 0.0) == (a.1 > 0.0) {
            a = (x, value);
        } else {
            b = (x, value);
        }
        let newton = -value / slope;
        let next = x + newton;
        let inside = (next > a.0.min(b.0)) && (next < a.0.max(b.0));
        if inside && newton.abs() <= 0.5 * step.abs() {
            step = newton;
            x = next;
        } else {
            step = 0.5 * (b.0 - a.0);
            x = a.0 + step;
        }
        if step.abs() <= tolerance || x == a.0 || x == b.0 {
            break;
        }
    }
    let [value, _] = g(x);
    if value.abs() <= best.1.abs() {
        x
    } else {
        best.0
    }
}
