//! Every position of a ternary link on three legs, found without the compiler's method.
//!
//! For a given direction of the link each leg leaves its first point on a circle or on a line. The
//! differences of the circles are lines, two lines have one point, and what the third leg misses there
//! is a trigonometric polynomial in the direction. Its zeros are isolated with bounds for its
//! derivatives, so that none can be missed; positions are polished by Newton's method.

use crate::polynomial::Trigonometric;

/// A point or a vector of the plane.
pub(crate) type Point = [f64; 2];

/// How one leg holds the ternary link at the point `at`, given in the link's own frame.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Leg {
    /// A binary link of a length, turning about a pivot.
    Rr {
        pivot: Point,
        length: f64,
        at: Point,
    },
    /// The point slides on a line through the pivot, at an angle.
    Pr { pivot: Point, angle: f64, at: Point },
    /// The pivot slides on a line of the ternary link through the point, at an angle in the link.
    Rp { pivot: Point, angle: f64, at: Point },
    /// Two slides, which leave the link its direction only.
    Pp { direction: f64 },
}

/// Where the ternary link is: its first point and its direction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Pose {
    pub(crate) x: f64,
    pub(crate) y: f64,
    pub(crate) theta: f64,
}

/// `round (x^2 + y^2) + a x + b y + c = 0`.
#[derive(Clone, Copy, Debug)]
struct Curve {
    round: f64,
    a: f64,
    b: f64,
    c: f64,
}

impl Leg {
    fn curve(&self, theta: f64) -> Curve {
        let line = |normal: Point, through: Point| Curve {
            round: 0.0,
            a: normal[0],
            b: normal[1],
            c: -normal[0] * through[0] - normal[1] * through[1],
        };
        let from = |pivot: Point, at: Point| {
            let at = turned(at, theta);
            [pivot[0] - at[0], pivot[1] - at[1]]
        };
        match *self {
            Leg::Rr { pivot, length, at } => {
                let [x, y] = from(pivot, at);
                let c = x * x + y * y - length * length;
                Curve {
                    round: 1.0,
                    a: -2.0 * x,
                    b: -2.0 * y,
                    c,
                }
            }
            Leg::Pr { pivot, angle, at } => line([-angle.sin(), angle.cos()], from(pivot, at)),
            Leg::Rp { pivot, angle, at } => {
                let angle = theta + angle;
                line([-angle.sin(), angle.cos()], from(pivot, at))
            }
            Leg::Pp { .. } => unreachable!("it leaves the point free"),
        }
    }

    /// What the leg misses at a pose, as a length, and its derivatives by x, y and theta.
    fn miss(&self, pose: &Pose) -> [f64; 4] {
        let Pose { x, y, theta } = *pose;
        if let Leg::Pp { direction } = *self {
            // Any length does: the equation stands alone.
            return [
                (theta - direction).sin(),
                0.0,
                0.0,
                (theta - direction).cos(),
            ];
        }
        let value = |x: f64, y: f64, theta: f64| {
            let Curve { round, a, b, c } = self.curve(theta);
            let value = round * (x * x + y * y) + a * x + b * y + c;
            let (dx, dy) = (2.0 * round * x + a, 2.0 * round * y + b);
            let steep = dx.hypot(dy);
            (value, dx, dy, steep)
        };
        let (miss, dx, dy, steep) = value(x, y, theta);
        // Exact for circles and lines that turn: they are of second degree in sine and cosine.
        let h = 1e-4;
        let slope = |h: f64| (value(x, y, theta + h).0 - value(x, y, theta - h).0) / (2.0 * h);
        let by_theta = (4.0 * slope(h) - slope(2.0 * h)) / 3.0;
        [miss / steep, dx / steep, dy / steep, by_theta / steep]
    }
}

/// All poses; `None` where two of them nearly coincide, so that rounding decides whether they are
/// there.
pub(crate) fn poses(legs: &[Leg; 3]) -> Option<Vec<Pose>> {
    let found = uncertain(legs)?.into_iter().collect::<Option<Vec<_>>>()?;
    simple(legs, found)
}

/// The poses that a condition holds for; `None` where one of them nearly coincides with another. What the others do does not matter: they may
/// run off to infinity.
pub(crate) fn poses_where(legs: &[Leg; 3], wanted: impl Fn(&Pose) -> bool) -> Option<Vec<Pose>> {
    let found = uncertain(legs)?.into_iter().flatten();
    simple(legs, found.filter(wanted).collect())
}

/// The pose for every direction of the link, `None` for one that is at infinity but for rounding.
fn uncertain(legs: &[Leg; 3]) -> Option<Vec<Option<Pose>>> {
    let free = legs.iter().find_map(|leg| match leg {
        Leg::Pp { direction } => Some(*direction),
        _ => None,
    });
    let mut found: Vec<Option<Pose>> = match free {
        Some(direction) => held_by_two(legs, direction)?
            .into_iter()
            .map(Some)
            .collect(),
        None => {
            let zeros = characteristic(legs).zeros()?;
            zeros.into_iter().map(|theta| point(legs, theta)).collect()
        }
    };
    for pose in found.iter_mut().flatten() {
        (0..4).for_each(|_| step(legs, pose));
    }
    Some(found)
}

/// The poses, if rounding does not decide whether they are there.
fn simple(legs: &[Leg; 3], poses: Vec<Pose>) -> Option<Vec<Pose>> {
    let mut all = poses.iter();
    all.all(|pose| determinant(legs, pose).abs() > 1e-5)
        .then_some(poses)
}

/// The characteristic polynomial in the direction of the ternary link.
pub(crate) fn characteristic(legs: &[Leg; 3]) -> Trigonometric {
    Trigonometric::through(|theta| {
        let (curve, [one, two]) = reduced(legs, theta);
        let [x, y, d] = meeting(&one, &two);
        let Curve { round, a, b, c } = curve;
        if round == 0.0 {
            a * x + b * y + c * d
        } else {
            x * x + y * y + (a * x + b * y + c * d) * d
        }
    })
}

/// A circle, if there is one, and two lines; three lines otherwise.
fn reduced(legs: &[Leg; 3], theta: f64) -> (Curve, [Curve; 2]) {
    let mut curves = legs.map(|leg| leg.curve(theta));
    curves.sort_by(|a, b| b.round.total_cmp(&a.round));
    let [first, second, third] = curves;
    let line = |other: Curve| Curve {
        round: 0.0,
        a: other.a - other.round * first.a,
        b: other.b - other.round * first.b,
        c: other.c - other.round * first.c,
    };
    (first, [line(second), line(third)])
}

/// The point of two lines in homogeneous coordinates.
fn meeting(one: &Curve, two: &Curve) -> [f64; 3] {
    [
        one.b * two.c - two.b * one.c,
        one.c * two.a - two.c * one.a,
        one.a * two.b - two.a * one.b,
    ]
}

fn point(legs: &[Leg; 3], theta: f64) -> Option<Pose> {
    let (first, [one, two]) = reduced(legs, theta);
    let mut pairs = vec![meeting(&one, &two)];
    if first.round == 0.0 {
        pairs.extend([meeting(&first, &one), meeting(&first, &two)]);
    }
    let [x, y, d] = pairs
        .into_iter()
        .max_by(|p, q| p[2].abs().total_cmp(&q[2].abs()))?;
    let scale = (one.a.hypot(one.b)) * (two.a.hypot(two.b));
    (d.abs() > 1e-7 * scale).then_some(Pose {
        x: x / d,
        y: y / d,
        theta,
    })
}

/// The poses of a link of known direction on two legs.
fn held_by_two(legs: &[Leg; 3], theta: f64) -> Option<Vec<Pose>> {
    let others = legs.iter().filter(|leg| !matches!(leg, Leg::Pp { .. }));
    let mut curves: Vec<Curve> = others.map(|leg| leg.curve(theta)).collect();
    curves.sort_by(|a, b| b.round.total_cmp(&a.round));
    let &[first, second] = curves.as_slice() else {
        return None;
    };
    if first.round == 0.0 {
        let [x, y, d] = meeting(&first, &second);
        return (d.abs() > 1e-6).then(|| {
            vec![Pose {
                x: x / d,
                y: y / d,
                theta,
            }]
        });
    }
    let a = second.a - second.round * first.a;
    let b = second.b - second.round * first.b;
    let c = second.c - second.round * first.c;
    // The foot of the circle's centre on the line, and half of the chord.
    let (centre, square) = ([-first.a / 2.0, -first.b / 2.0], a * a + b * b);
    let over = (a * centre[0] + b * centre[1] + c) / square;
    let radius = centre[0] * centre[0] + centre[1] * centre[1] - first.c;
    let rest = radius - over * over * square;
    if rest.abs() < 1e-7 * radius {
        return None;
    }
    if rest < 0.0 {
        return Some(Vec::new());
    }
    let half = (rest / square).sqrt();
    let pose = |w: f64| Pose {
        x: centre[0] - over * a - w * half * b,
        y: centre[1] - over * b + w * half * a,
        theta,
    };
    Some(vec![pose(1.0), pose(-1.0)])
}

/// One step of Newton's method.
pub(crate) fn step(legs: &[Leg; 3], pose: &mut Pose) {
    let rows = legs.map(|leg| leg.miss(pose));
    let full = determinant_of(&rows.map(|[_, x, y, t]| [x, y, t]));
    pose.x -= determinant_of(&rows.map(|[m, _, y, t]| [m, y, t])) / full;
    pose.y -= determinant_of(&rows.map(|[m, x, _, t]| [x, m, t])) / full;
    pose.theta -= determinant_of(&rows.map(|[m, x, y, _]| [x, y, m])) / full;
}

/// Determinant of the equations, each over its own size: 0 where two poses meet.
pub(crate) fn determinant(legs: &[Leg; 3], pose: &Pose) -> f64 {
    let size = reach(legs);
    let rows = legs.map(|leg| {
        let [_, x, y, t] = leg.miss(pose);
        let t = t / size;
        let length = (x * x + y * y + t * t).sqrt();
        [x / length, y / length, t / length]
    });
    determinant_of(&rows)
}

pub(crate) fn reach(legs: &[Leg; 3]) -> f64 {
    let of = |leg: &Leg| match leg {
        Leg::Rr { at, .. } | Leg::Pr { at, .. } | Leg::Rp { at, .. } => at[0].hypot(at[1]),
        Leg::Pp { .. } => 0.0,
    };
    legs.iter().map(of).fold(1.0, f64::max)
}

fn determinant_of(rows: &[[f64; 3]; 3]) -> f64 {
    let [a, b, c] = rows;
    a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0])
        + a[2] * (b[0] * c[1] - b[1] * c[0])
}

/// How far two poses are apart: the link's direction, and its point over the size of the link.
pub(crate) fn distance(one: &Pose, two: &Pose, size: f64) -> f64 {
    let turned = (one.theta - two.theta) / 2.0;
    (2.0 * turned.sin()).hypot((one.x - two.x).hypot(one.y - two.y) / size)
}

/// A vector turned by an angle.
pub(crate) fn turned([x, y]: Point, angle: f64) -> Point {
    let (s, c) = angle.sin_cos();
    [c * x - s * y, s * x + c * y]
}
