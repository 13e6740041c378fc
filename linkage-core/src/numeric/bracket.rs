//! The root of a function between two points where its signs differ.

/// A place and the value there.
pub type Sample = (f64, f64);

/// More than Newton's steps and all bisections of a bracket together.
const STEPS: usize = 200;

/// The root between `a` and `b`, to the last digit of the bracket's ends, if `g` gives value and
/// slope: by Newton's method, by interpolation where there is no slope (NaN), and by bisection
/// where either leaves the bracket or is slow.
pub fn root(mut a: Sample, mut b: Sample, g: &mut impl FnMut(f64) -> [f64; 2]) -> f64 {
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
            return x;
        }
        // The new place, the end of the other sign, and the end that the new place takes the place
        // of.
        let (old, other) = if (value > 0.0) == (a.1 > 0.0) {
            (a, b)
        } else {
            (b, a)
        };
        (a, b) = ((x, value), other);
        let newton = -value / slope;
        let next = x + newton;
        let inside = (next > a.0.min(b.0)) && (next < a.0.max(b.0));
        if inside && newton.abs() <= 0.5 * step.abs() {
            step = newton;
        } else if slope.is_nan() {
            let share = share(a, b, old);
            // Not nearer to an end than a digit, so that the far end moves, too.
            let least = (tolerance / (b.0 - a.0).abs()).min(0.5);
            step = (b.0 - a.0) * share.clamp(least, 1.0 - least);
        } else {
            step = 0.5 * (b.0 - a.0);
        }
        x = a.0 + step;
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

/// Share of the way from `a` to `b` at which the root is, by inverse quadratic interpolation
/// through three places, if that is monotone; otherwise one half (Chandrupatla 1997).
fn share(a: Sample, b: Sample, c: Sample) -> f64 {
    let ratio = (a.0 - b.0) / (c.0 - b.0);
    let level = (a.1 - b.1) / (c.1 - b.1);
    if !(level * level < ratio && (1.0 - level) * (1.0 - level) < 1.0 - ratio) {
        return 0.5;
    }
    let near = a.1 / (b.1 - a.1) * (c.1 / (b.1 - c.1));
    let far = a.1 / (c.1 - a.1) * (b.1 / (c.1 - b.1));
    near + far * ((c.0 - a.0) / (b.0 - a.0))
}

#[cfg(test)]
mod tests {
    use super::root;

    /// Without a slope a smooth root takes a dozen values, not the fifty of bisection; one at which
    /// nothing is smooth is found, too.
    #[test]
    fn roots_without_slopes() {
        let solve = |f: fn(f64) -> f64, a: f64, b: f64| {
            let mut calls = 0;
            let found = root((a, f(a)), (b, f(b)), &mut |x| {
                calls += 1;
                [f(x), f64::NAN]
            });
            (found, calls)
        };
        let (found, calls) = solve(|x| x * x * x - 2.0, 1.0, 2.0);
        assert!(
            (found - 2f64.cbrt()).abs() < 1e-15 && calls <= 14,
            "{found} {calls}"
        );
        let (found, calls) = solve(|x| if x < 0.3 { -1e-9 } else { 1e3 }, 0.0, 1.0);
        assert!((found - 0.3).abs() < 1e-15 && calls < 70, "{found} {calls}");
        let (found, calls) = solve(|x| (x - 0.7).powi(9), 0.0, 1.0);
        assert!((found - 0.7).abs() < 1e-3 && calls < 120, "{found} {calls}");
    }
}
