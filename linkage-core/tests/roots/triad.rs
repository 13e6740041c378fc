//! A platform on three legs, each with a turning joint at one end and a turning joint or a slide
//! at the other.

use crate::laurent::{Complex, Equations, Laurent, complex, unit};
use linkage_core::numeric::roots::Variable;
use linkage_random::Random;

#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Leg {
    /// From the pivot to the point of the platform at a fixed distance.
    Turning { length: f64 },
    /// The point of the platform slides along a line of the frame.
    FrameSlide { along: Complex },
    /// The pivot slides along a line of the platform.
    PlatformSlide { along: Complex },
}

#[derive(Clone, Debug)]
pub(crate) struct Triad {
    pub(crate) legs: [Leg; 3],
    /// Pivots of the legs, or points of the lines of the frame.
    pub(crate) pivots: [Complex; 3],
    /// Points of the platform, the first being its origin.
    pub(crate) points: [Complex; 3],
}

/// Values of the first leg's variable and of the platform's unit vector.
pub(crate) type Pose = [Complex; 2];

impl Triad {
    /// A random one, and a pose in which it closes. `R` is a turning leg, `F` and `P` slide on the
    /// frame and on the platform.
    pub(crate) fn random(kinds: &str, random: &mut Random) -> (Self, Pose) {
        let pivots: [Complex; 3] = std::array::from_fn(|_| point(random));
        let zero = complex(0.0, 0.0);
        let points = [zero, point(random), point(random)];
        let (origin, platform) = (point(random), direction(random));
        let mut triad = Self {
            legs: [Leg::Turning { length: 0.0 }; 3],
            pivots,
            points,
        };
        let mut first = zero;
        for (k, kind) in kinds.chars().enumerate() {
            let leg = origin + points[k] * platform - pivots[k];
            let toward = leg.scaled(1.0 / leg.size());
            let coordinate;
            (triad.legs[k], coordinate) = match kind {
                'R' => (Leg::Turning { length: leg.size() }, toward),
                'F' => {
                    let slide = random.between(-1.0, 1.0);
                    let along = direction(random);
                    triad.pivots[k] = origin + points[k] * platform - along.scaled(slide);
                    (Leg::FrameSlide { along }, complex(slide, 0.0))
                }
                _ => {
                    let along = (toward * platform.conjugate()).scaled(-1.0);
                    (Leg::PlatformSlide { along }, complex(leg.size(), 0.0))
                }
            };
            if k == 0 {
                first = coordinate;
            }
        }
        (triad, [first, platform])
    }

    /// The equations of the second and third leg in the variable of the first leg and the unit
    /// vector of the platform.
    pub(crate) fn equations(&self) -> Equations {
        let first = match self.legs[0] {
            Leg::Turning { .. } => Variable::Unit,
            _ => Variable::Length,
        };
        let variables = [first, Variable::Unit];
        let constant = |value| Laurent::constant(value, 2);
        let (x, y) = (Laurent::variable(0, 2), Laurent::variable(1, 2));
        let way = match self.legs[0] {
            Leg::Turning { length } => x.scaled(complex(length, 0.0)),
            Leg::FrameSlide { along } => x.scaled(along),
            Leg::PlatformSlide { along } => x.times(&y).scaled(along.scaled(-1.0)),
        };
        let origin = constant(self.pivots[0]).plus(&way);
        let closing = |k: usize| {
            let point = origin.plus(&y.scaled(self.points[k]));
            let leg = point.minus(&constant(self.pivots[k]));
            match self.legs[k] {
                Leg::Turning { length } => leg
                    .square(&variables)
                    .minus(&constant(complex(length * length, 0.0))),
                Leg::FrameSlide { along } => leg.scaled(along.conjugate()).imaginary(&variables),
                Leg::PlatformSlide { along } => {
                    let line = y.scaled(along).conjugate(&variables);
                    leg.times(&line).imaginary(&variables)
                }
            }
        };
        Equations::new(&variables, &[closing(1), closing(2)])
    }

    /// Number of poses, by looking at every angle of the platform, where the first two legs put
    /// its origin to up to two places, for a change of sign of what the third leg misses.
    pub(crate) fn count_poses(&self, angles: usize) -> usize {
        let mut count = 0;
        let mut before = self.misses(0.0);
        for index in 1..=angles {
            let angle = std::f64::consts::TAU * index as f64 / angles as f64;
            let now = self.misses(angle);
            match (before, now) {
                (Some(a), Some(b)) => {
                    count += a.iter().zip(b).filter(|(a, b)| **a * b < 0.0).count();
                }
                // Both places become one somewhere in between.
                (Some([a, b]), None) | (None, Some([a, b])) => count += usize::from(a * b < 0.0),
                (None, None) => {}
            }
            before = now;
        }
        // With two lines both places are the same one.
        let slides = self.legs[..2].iter().filter(|leg| !leg.turns()).count();
        if slides == 2 { count / 2 } else { count }
    }

    /// What the third leg misses at both places of the origin.
    fn misses(&self, angle: f64) -> Option<[f64; 2]> {
        let platform = unit(angle);
        let (first, second) = (self.locus(0, platform), self.locus(1, platform));
        let places = intersections(first, second)?;
        let locus = self.locus(2, platform);
        // The only place of two lines goes through infinity where they become parallel.
        let sign = match (first.along, second.along) {
            (Some(a), Some(b)) => (a.conjugate() * b).im.signum(),
            _ => 1.0,
        };
        Some(places.map(|place| {
            let leg = place - locus.centre;
            match locus.along {
                None => leg.size() - locus.radius,
                Some(along) => (leg * along.conjugate()).im * sign,
            }
        }))
    }

    /// Where a leg lets the origin of the platform be.
    fn locus(&self, k: usize, platform: Complex) -> Locus {
        let centre = self.pivots[k] - self.points[k] * platform;
        let (radius, along) = match self.legs[k] {
            Leg::Turning { length } => (length, None),
            Leg::FrameSlide { along } => (0.0, Some(along)),
            Leg::PlatformSlide { along } => (0.0, Some(along * platform)),
        };
        Locus {
            centre,
            radius,
            along,
        }
    }
}

impl Leg {
    fn turns(self) -> bool {
        matches!(self, Self::Turning { .. })
    }
}

/// A circle, or a line through `centre`.
#[derive(Clone, Copy)]
struct Locus {
    centre: Complex,
    radius: f64,
    along: Option<Complex>,
}

fn intersections(a: Locus, b: Locus) -> Option<[Complex; 2]> {
    match (a.along, b.along) {
        (None, None) => {
            let axis = b.centre - a.centre;
            let distance = axis.size();
            let direction = axis.scaled(1.0 / distance);
            let foot = (distance * distance + a.radius * a.radius - b.radius * b.radius)
                / (2.0 * distance);
            let height = (a.radius * a.radius - foot * foot).sqrt();
            let side = |height| a.centre + direction * complex(foot, height);
            (!height.is_nan()).then(|| [side(height), side(-height)])
        }
        (Some(along), None) => {
            let foot = (b.centre - a.centre) * along.conjugate();
            let place = a.centre + along.scaled(foot.re);
            let height = (place - b.centre).size();
            let half = (b.radius * b.radius - height * height).sqrt();
            let ends = [place + along.scaled(half), place - along.scaled(half)];
            (!half.is_nan()).then_some(ends)
        }
        (None, Some(_)) => intersections(b, a),
        (Some(first), Some(second)) => {
            let sine = (first.conjugate() * second).im;
            let way = ((b.centre - a.centre).conjugate() * second).im / sine;
            let place = a.centre + first.scaled(way);
            Some([place; 2])
        }
    }
}

/// A point near the origin.
pub(crate) fn point(random: &mut Random) -> Complex {
    complex(random.between(-1.0, 1.0), random.between(-1.0, 1.0))
}

/// A unit number.
pub(crate) fn direction(random: &mut Random) -> Complex {
    unit(random.between(-3.2, 3.2))
}
