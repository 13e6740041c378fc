//! Groups of more than one platform, and a platform in Cartesian coordinates.

use crate::laurent::{Complex, Equations, Laurent, complex};
use crate::triad::{direction, point};
use linkage_core::numeric::roots::Variable;
use linkage_random::Random;

/// Two platforms that share a joint, each on two legs: three loops, six links.
#[derive(Clone, Debug)]
pub(crate) struct Twins {
    /// The legs at 0 and 1 carry the first platform, those at 2 and 3 the second one.
    pivots: [Complex; 4],
    lengths: [f64; 4],
    /// Seen from the joint of the first leg: the joint of the second leg, the shared joint.
    first: [Complex; 2],
    /// Seen from the shared joint: the joints of the third and of the fourth leg.
    second: [Complex; 2],
}

impl Twins {
    /// A random one, with a pose: unit vectors of the first leg, the first and the second
    /// platform.
    pub(crate) fn random(random: &mut Random) -> (Self, [Complex; 3]) {
        let pivots = std::array::from_fn(|_| point(random));
        let first = std::array::from_fn(|_| point(random));
        let second = std::array::from_fn(|_| point(random));
        let (start, y, z) = (point(random), direction(random), direction(random));
        let shared = start + first[1] * y;
        let ends = [
            start,
            start + first[0] * y,
            shared + second[0] * z,
            shared + second[1] * z,
        ];
        let lengths = std::array::from_fn(|k: usize| (ends[k] - pivots[k]).size());
        let x = (start - pivots[0]).scaled(1.0 / lengths[0]);
        let twins = Self {
            pivots,
            lengths,
            first,
            second,
        };
        (twins, [x, y, z])
    }

    /// In the unit vectors of the first leg and the platforms.
    pub(crate) fn equations(&self) -> Equations {
        let variables = [Variable::Unit; 3];
        let [x, y, z] = [0, 1, 2].map(|index| Laurent::variable(index, 3));
        let real = |value| complex(value, 0.0);
        let constant = |value| Laurent::constant(value, 3);
        let start = constant(self.pivots[0]).plus(&x.scaled(real(self.lengths[0])));
        let shared = start.plus(&y.scaled(self.first[1]));
        let ends = [
            start.plus(&y.scaled(self.first[0])),
            shared.plus(&z.scaled(self.second[0])),
            shared.plus(&z.scaled(self.second[1])),
        ];
        let equations = [1, 2, 3].map(|k| {
            let leg = ends[k - 1].minus(&constant(self.pivots[k]));
            let square = self.lengths[k] * self.lengths[k];
            leg.square(&variables).minus(&constant(real(square)))
        });
        Equations::new(&variables, &equations)
    }

    /// In the unit vector of the first platform and the coordinates of the shared joint and of the
    /// third leg's joint.
    pub(crate) fn equations_of_points(&self) -> Equations {
        use Variable::{Conjugate, Point, Unit};
        let variables = [Unit, Point, Conjugate, Point, Conjugate];
        let [y, shared, _, third, _] = [0, 1, 2, 3, 4].map(|index| Laurent::variable(index, 5));
        let real = |value| complex(value, 0.0);
        let constant = |value| Laurent::constant(value, 5);
        let start = shared.minus(&y.scaled(self.first[1]));
        let side = third.minus(&shared);
        let [a, b] = self.second;
        let quotient = (b * a.conjugate()).scaled(1.0 / (a.size() * a.size()));
        let ends = [
            start.clone(),
            start.plus(&y.scaled(self.first[0])),
            third.clone(),
            shared.plus(&side.scaled(quotient)),
        ];
        let mut equations: Vec<Laurent> = (0..4)
            .map(|k| {
                let leg = ends[k].minus(&constant(self.pivots[k]));
                let square = self.lengths[k] * self.lengths[k];
                leg.square(&variables).minus(&constant(real(square)))
            })
            .collect();
        let square = a.size() * a.size();
        equations.push(side.square(&variables).minus(&constant(real(square))));
        Equations::new(&variables, &equations)
    }

    /// The shared joint and the third leg's joint in a pose.
    pub(crate) fn joints(&self, [x, y, z]: [Complex; 3]) -> [Complex; 2] {
        let start = self.pivots[0] + x.scaled(self.lengths[0]);
        let shared = start + y * self.first[1];
        [shared, shared + z * self.second[0]]
    }
}
