//! Where two circles meet: the numbers behind RRR, and behind RSSR seen along the rocker's axis.

use linkage_symbolic::{Ex, V2};

use super::Solver;

/// Two circles as their radii enter: squares, scaled.
pub(super) struct Squares<'m> {
    /// What lengths are multiplied by, and half its square.
    pub(super) scale: Ex<'m>,
    pub(super) half_scale2: Ex<'m>,
    /// The scaled lengths that they were made of.
    pub(super) radii: [Ex<'m>; 2],
    /// `(r1^2 - r2^2)/2`
    pub(super) imbalance: Ex<'m>,
    /// Twice the smaller of both.
    pub(super) twice: Ex<'m>,
    /// What rounding of the second one's is measured by, if it is not given as a length.
    pub(super) noise2: Option<Ex<'m>>,
}

/// Two links between points at distance `C`.
pub(super) struct Circles<'m> {
    /// The links' vectors, whose sum is `C`.
    pub(super) vectors: [V2<'m>; 2],
    /// Scaled, 0 at the dead point.
    pub(super) h: Ex<'m>,
    /// `first x second`
    pub(super) product: Ex<'m>,
    /// The square of `h`, and the size of what it was computed from.
    pub(super) q: Ex<'m>,
    pub(super) noise: Ex<'m>,
    /// Half the square of the distance, scaled.
    pub(super) m: Ex<'m>,
}

impl<'m> Squares<'m> {
    /// Squares of lengths, scaled by a power of two near `reach`, so that extreme units neither overflow nor underflow.
    pub(super) fn of(lengths: [Ex<'m>; 2], reach: Ex<'m>) -> Self {
        let scale = reach.inverse_scale();
        let [r1, r2] = lengths.map(|r| scale * r);
        let smaller = r1.min(r2);
        let half_scale2 = invertible(0.5 * scale.square());
        let imbalance = 0.5 * r1.difference_of_squares(r2);
        Self {
            scale,
            half_scale2,
            radii: [r1, r2],
            imbalance,
            twice: 2.0 * smaller.square(),
            noise2: None,
        }
    }
}

/// A number that is NaN where its reciprocal is too large: then all of the results are, and not some infinite. Only of what `assemble()` knows.
fn invertible(x: Ex) -> Ex {
    if !x.is_fixed() {
        return x;
    }
    let room = x - f64::MIN_POSITIVE;
    room.select(x, x.number(f64::NAN))
}

/// `v1 + v2 = C` with `|v1| = r1`, `|v2| = r2`.
///
/// With `L2 = C.C` the links' vectors are `(n1 C + w h C_perp)/L2` and `(n2 C - w h C_perp)/L2`, where
/// `n1,2 = (L2 +- (r1 - r2)(r1 + r2))/2`. The root `h = sqrt(r^2 L2 - n^2)` is taken for the smaller circle, which
/// keeps it accurate in needle triangles; `|r1^2 - r2^2|` selects that one without a choice. Computed are `w n1`, `w n2`, `h` and
/// `w C/L2`.
pub(super) fn circles<'m>(
    solver: &mut Solver<'_, 'm>,
    c: V2<'m>,
    squares: &Squares<'m>,
) -> Circles<'m> {
    let w = solver.mode_sign();
    let size = squares.imbalance.abs();

    let m = squares.half_scale2 * c.square(); // L2/2, scaled
    let n = m - size; // of the smaller circle
    let q = squares.twice * m - n.square();
    // At both dead points the root's terms are of the size `r1 r2 L2`: what is there of `(m + size) n`, in one product.
    let [r1, r2] = squares.radii;
    let mut noise = (2.0 * r1 * r2) * m;
    if let Some(noise2) = squares.noise2 {
        // The derivative of `h^2` by the second circle's square is `n1`.
        let own = noise2 * (m + squares.imbalance);
        noise = ((m + size) * n).abs() + own.abs();
    }
    let h = q.root(noise);

    // The mode's sign turns what is known before a call, and the direction; only of radii that change it turns the root.
    let one = w.number(1.0);
    let [of_feet, of_root] = match squares.imbalance.is_fixed() {
        true => [w, one],
        false => [one, w],
    };
    let [n1, n2] = {
        let m = (of_feet * squares.half_scale2) * c.square();
        let imbalance = of_feet * squares.imbalance;
        [m + imbalance, m - imbalance]
    };
    let inverse = 0.5 * of_feet / m;
    // The root comes last: what does not need it is ready by then, the direction divided by its length, too.
    let (direction, factor) = match c.is_fixed() {
        true => (c, inverse),
        false => (inverse * c, one),
    };
    let [a1, a2, b] = [n1 * factor, n2 * factor, h * (factor * of_root)];
    let across = direction.perp();
    let vectors = [a1 * direction + b * across, a2 * direction - b * across];
    Circles {
        vectors,
        h,
        product: -w / squares.scale.square() * h,
        q,
        noise,
        m,
    }
}
