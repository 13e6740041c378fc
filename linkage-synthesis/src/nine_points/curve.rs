//! Points on a circle or a line, which leave no isolated four-bars.
//!
//! A coupler curve is of the sixth degree and passes each of the two circular points three times:
//! it meets a circle in six finite points at most (12 by Bezout, less 6 at the circular points),
//! and a line in six, unless the circle or the line is a part of it. So with seven points on a
//! circle the whole circle is a part of the curve, as of a crank whose pin is the point, or of a
//! parallelogram, and there are infinitely many of these or none.

use super::super::error::Unsolved;
use linkage_core::numeric::complex::Complex;

/// Points of a coupler curve on a circle or a line, at most.
const MOST: usize = 6;

/// Points are on a circle if they are off it by no more than this part of the extent of all points.
/// Solutions for points next to a circle are next to those that are not isolated: all of them are
/// still found at this distance, in half a minute.
const ON: f64 = 1e-5;

/// Refuses points of which more than six are on a circle or a line.
pub(super) fn check(points: &[[f64; 2]; 9]) -> Result<(), Unsolved> {
    let extent = extent(points);
    let all = 0..points.len();
    let triples = all.clone().flat_map(|i| {
        let others = i + 1..points.len();
        others.flat_map(move |j| (j + 1..points.len()).map(move |k| [i, j, k]))
    });
    let curves = triples.map(|triple| Curve::through(triple.map(|i| points[i]), extent));
    let counted = curves.map(|curve| {
        let off = points.iter().map(|&point| curve.off(point, extent));
        let on = off.filter(|off| *off <= ON);
        let (count, off) = on.fold((0, 0.0), |(count, most), off| (count + 1, off.max(most)));
        (count, off * extent, curve)
    });
    let most = counted.max_by(|a, b| a.0.cmp(&b.0).then(b.1.total_cmp(&a.1)));
    let Some((count, off, curve)) = most.filter(|(count, ..)| *count > MOST) else {
        return Ok(());
    };
    Err(match curve.circle(extent) {
        Some((centre, radius)) => Unsolved::OnCircle {
            count,
            centre,
            radius,
            off,
        },
        None => Unsolved::OnLine { count, off },
    })
}

/// The largest distance of two points.
fn extent(points: &[[f64; 2]; 9]) -> f64 {
    let pairs = points
        .iter()
        .flat_map(|a| points.iter().map(move |b| (a[0] - b[0]).hypot(a[1] - b[1])));
    pairs.fold(0.0, f64::max)
}

/// `bend |z|^2 + 2 Re(slope^ z) = 0` in lengths of the extent, from a point of it; `slope` has the
/// length 1/2.
struct Curve {
    from: [f64; 2],
    bend: f64,
    slope: Complex,
}

impl Curve {
    /// Through three points.
    fn through([from, a, b]: [[f64; 2]; 3], extent: f64) -> Self {
        let [a, b] = [a, b].map(|point| way(from, point, extent));
        // The centre is `i (a |b|^2 - b |a|^2) / (2 a x b)`.
        let across = a.re * b.im - a.im * b.re;
        let toward = a.scaled(b.square()) - b.scaled(a.square());
        let toward = Complex::new(-toward.im, toward.re);
        let size = toward.size();
        Self {
            from,
            bend: across / size,
            slope: toward.scaled(-1.0 / (2.0 * size)),
        }
    }

    /// Returns the distance of a point, as a part of the extent.
    fn off(&self, point: [f64; 2], extent: f64) -> f64 {
        let z = way(self.from, point, extent);
        let value = self.bend * z.square() + 2.0 * (self.slope.re * z.re + self.slope.im * z.im);
        let gradient = z.scaled(self.bend) + self.slope;
        // To the nearer of the two roots along the gradient.
        let along = 2.0 * gradient.size();
        value.abs() / (0.5 * (along + (along * along - 4.0 * self.bend * value).max(0.0).sqrt()))
    }

    /// Centre and radius; `None` for a line, of which no point is off by more than rounding.
    fn circle(&self, extent: f64) -> Option<([f64; 2], f64)> {
        let centre = self.slope.scaled(-extent / self.bend);
        // An arc as long as the extent rises by an eighth of its square over the radius.
        let rise = self.bend.abs() / 4.0;
        (rise > ON).then(|| {
            let [x, y] = self.from;
            ([x + centre.re, y + centre.im], centre.size())
        })
    }
}

fn way(from: [f64; 2], to: [f64; 2], unit: f64) -> Complex {
    Complex::new((to[0] - from[0]) / unit, (to[1] - from[1]) / unit)
}
