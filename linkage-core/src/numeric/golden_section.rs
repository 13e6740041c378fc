//! The lowest point of a function in an interval.

/// An input value and the margin there.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Point {
    pub x: f64,
    pub margin: f64,
}

impl Point {
    pub fn evaluate(x: f64, margin: &mut impl FnMut(f64) -> f64) -> Self {
        Self {
            x,
            margin: margin(x),
        }
    }

    /// The lower of two points; one without a margin is the lowest of all.
    pub fn lower(self, other: Self) -> Self {
        if self.margin.is_nan() || self.margin <= other.margin {
            self
        } else {
            other
        }
    }
}

/// The share of an interval that each step keeps.
pub const RATIO: f64 = 0.618_033_988_749_894_9;

/// Golden section search between `a` and `b`: the lowest point seen, or the first one for which
/// `enough` holds.
pub fn descend(
    a: Point,
    b: Point,
    margin: &mut impl FnMut(f64) -> f64,
    enough: impl Fn(Point) -> bool,
) -> Point {
    const STEPS: usize = 70;

    let (mut low, mut high) = (a.x, b.x);
    let mut left = Point::evaluate(high - RATIO * (high - low), margin);
    let mut right = Point::evaluate(low + RATIO * (high - low), margin);
    let mut best = a.lower(b).lower(left).lower(right);
    for _ in 0..STEPS {
        if enough(best) || left.x >= right.x {
            break;
        }
        if left.margin <= right.margin {
            high = right.x;
            right = left;
            left = Point::evaluate(high - RATIO * (high - low), margin);
            best = best.lower(left);
        } else {
            low = left.x;
            left = right;
            right = Point::evaluate(low + RATIO * (high - low), margin);
            best = best.lower(right);
        }
    }
    best
}
