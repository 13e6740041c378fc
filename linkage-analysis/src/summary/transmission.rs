//! Transmission angle.

use super::curve::Curve;
use super::interval::Interval;
use super::monotone_pieces::{crossing_input, monotone_pieces};
use core::f64::consts::{FRAC_PI_2, PI};

/// A transmission angle and the input where it occurs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Transmission {
    /// The input.
    pub at: f64,
    /// The angle between the links, 0 to pi/2.
    pub angle: f64,
}

/// The angles of [`Curve::transmission_angle`].
pub(super) fn transmission_angle<const N: usize, F: Fn(f64) -> [f64; N]>(
    curve: &Curve<N, F>,
) -> [Transmission; 2] {
    let first = curve.solved[0].interval.nodes[0];
    let mut found = [transmission(curve, first.u, acute(first.jet[0])); 2];
    let mut add = |u: f64, angle: f64| {
        if angle < found[0].angle {
            found[0] = transmission(curve, u, angle);
        }
        if angle > found[1].angle {
            found[1] = transmission(curve, u, angle);
        }
    };
    for part in &curve.solved {
        let chain = monotone_pieces(part);
        for piece_end in &chain {
            add(piece_end.u(), acute(piece_end.value()));
        }
        for pair in chain.windows(2) {
            let [a, b] = [&pair[0].node, &pair[1].node];
            for angle in [0.0, FRAC_PI_2] {
                if let Some(bound) = multiple(a.jet[0], b.jet[0], angle) {
                    add(crossing_input(&curve.source, a, b, bound), angle);
                }
            }
        }
    }
    found
}

fn transmission<const N: usize, F: Fn(f64) -> [f64; N]>(
    curve: &Curve<N, F>,
    u: f64,
    angle: f64,
) -> Transmission {
    let at = Interval::between(&curve.source, u, u).from;
    Transmission { at, angle }
}

/// The acute one of the angles between two lines.
fn acute(angle: f64) -> f64 {
    let angle = angle.abs() % PI;
    angle.min(PI - angle)
}

/// `angle` plus a multiple of pi that is strictly between two numbers.
fn multiple(a: f64, b: f64, angle: f64) -> Option<f64> {
    let (low, high) = (a.min(b), a.max(b));
    let below = (low - angle) % PI;
    let step = if below < 0.0 { -below } else { PI - below };
    let next = low + step;
    (next > low && next < high).then_some(next)
}

#[cfg(test)]
mod tests {
    use super::{PI, multiple};

    /// Strictly between: an angle at the lower end is met half a turn later.
    #[test]
    fn multiples_lie_between() {
        assert_eq!(multiple(0.5, 4.0, 0.5), Some(0.5 + PI));
        assert_eq!(multiple(4.0, 0.5, 0.5), Some(0.5 + PI));
        assert_eq!(multiple(0.5, 0.5 + PI, 0.5), None);
        assert_eq!(multiple(0.4, 0.6, 0.5), Some(0.5));
        assert_eq!(multiple(0.6, 0.7, 0.5), None);
    }
}
