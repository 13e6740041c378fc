//! Relations between joints that no declared joint holds, as in `let right = -left`: polynomials
//! that are exact up to rounding wherever the inputs are.

use linkage_engine::Mechanism;

use super::super::rounded::rounded;
use super::closures::{freedoms_left, motions};
use super::coordinates::{Coordinate, values_at};
use super::driven_joints::Motion;
use super::heading::TURN;
use super::joint_relations::{EXACT, JointPolynomial, Leader, Relations};
use super::minimax::polynomial;
use super::skeleton::Skeleton;
use super::wheel_relations::Relation;

/// Steps on the way from the reference to a target in the box of the inputs.
const STEPS: usize = 24;

/// Places within the box, besides the ends of each input.
const INNER_TARGETS: usize = 8;

/// Multiples of the golden section spread evenly.
const GOLDEN: f64 = 0.618_033_988_749_894_9;

/// Digits that a coefficient keeps if it is exact with them.
const DIGITS: usize = 12;

/// Adds polynomials between joints to the relations of wheels as long as the declared joints leave
/// more motions than the mechanism has. A polynomial that holds nothing is left out. `degree` is the
/// highest one of the format.
pub(super) fn with_polynomials(
    wheels: Vec<Relation>,
    mechanism: &Mechanism,
    skeleton: &Skeleton,
    motion: &Motion,
    degree: usize,
) -> Relations {
    let coordinates = &motion.coordinates;
    let expected = motions(mechanism, skeleton);
    let mut relations = Relations {
        wheels,
        polynomials: Vec::new(),
        leaders: Vec::new(),
    };
    let mut left = freedoms_left(skeleton, &relations, coordinates);
    if left <= expected && skeleton.inputs().len() < 2 {
        return relations;
    }
    let samples = samples(skeleton, motion);
    relations.leaders = leaders(&samples, skeleton, motion);
    let leads = |index: usize| {
        let mut leaders = relations.leaders.iter();
        leaders.any(|leader| leader.coordinate == index)
    };
    let (first, others): (Vec<usize>, Vec<usize>) =
        (0..coordinates.len()).partition(|index| leads(*index));
    for follower in others.iter().copied() {
        if left <= expected {
            break;
        }
        let follows = |index: &usize| relations.polynomials.iter().any(|f| f.follower == *index);
        let leaders = first.iter().chain(&others).copied();
        let mut leaders = leaders.filter(|index| *index != follower && !follows(index));
        let fit = Fit {
            samples: &samples,
            follower,
            scale: scale(skeleton, &coordinates[follower]),
        };
        let found = fit.still();
        let found = found.or_else(|| leaders.find_map(|leader| fit.polynomial(leader, degree)));
        let Some(found) = found else { continue };
        relations.polynomials.push(found);
        let now = freedoms_left(skeleton, &relations, coordinates);
        if now == left {
            relations.polynomials.pop();
        }
        left = now;
    }
    relations
}

/// Returns the relations of a mechanism of several inputs without loops and wheels whose joints move
/// as its inputs, or follow such joints by exact polynomials. `None` for another mechanism.
pub(super) fn exact_tree(
    mechanism: &Mechanism,
    skeleton: &Skeleton,
    motion: &Motion,
    degree: usize,
) -> Option<Relations> {
    if skeleton.inputs().len() < 2 || !skeleton.closures.is_empty() {
        return None;
    }
    let found = with_polynomials(Vec::new(), mechanism, skeleton, motion, degree);
    let led = found.leaders.len() + found.polynomials.len();
    (led == motion.coordinates.len()).then_some(found)
}

/// Inputs and coordinates at one position.
struct Sample {
    /// Changes of the inputs since the reference.
    inputs: Vec<f64>,
    values: Vec<f64>,
}

/// Returns positions on the ways from the reference to targets of the box of all inputs, as far as
/// the mechanism can be assembled.
fn samples(skeleton: &Skeleton, motion: &Motion) -> Vec<Sample> {
    let inputs = skeleton.inputs();
    let arguments = skeleton.arguments();
    let mut targets: Vec<Vec<f64>> = Vec::new();
    for (argument, ends) in &inputs {
        for end in ends {
            let mut target = arguments.to_vec();
            target[*argument] = *end;
            targets.push(target);
        }
    }
    for number in 0..INNER_TARGETS {
        let mut target = arguments.to_vec();
        for (index, (argument, [low, high])) in inputs.iter().enumerate() {
            let share = (number as f64 + 0.5) * GOLDEN.powi(index as i32 + 1);
            target[*argument] = low + (high - low) * share.fract();
        }
        targets.push(target);
    }
    let mut samples = Vec::new();
    for target in targets {
        let mut before = vec![0.0; motion.coordinates.len()];
        for step in 1..=STEPS {
            let share = step as f64 / STEPS as f64;
            let ends = arguments.iter().zip(&target);
            let position: Vec<f64> = ends.map(|(from, to)| from + share * (to - from)).collect();
            let values = values_at(skeleton, &skeleton.poses_at(&position), Some(&before));
            if values.iter().any(|value| !value.is_finite()) {
                break;
            }
            let changes = inputs.iter();
            let changes = changes.map(|(argument, _)| position[*argument] - arguments[*argument]);
            samples.push(Sample {
                inputs: changes.collect(),
                values: values.clone(),
            });
            before = values;
        }
    }
    samples
}

/// Returns the joints that lead: the one that drives, and for each further input the first joint
/// that is a multiple of it, with its limits.
fn leaders(samples: &[Sample], skeleton: &Skeleton, motion: &Motion) -> Vec<Leader> {
    let mut leaders = vec![Leader {
        coordinate: motion.driver,
        limits: None,
    }];
    for (input, (argument, ends)) in skeleton.inputs().iter().enumerate() {
        let rate = |coordinate: usize| {
            let coordinates = &motion.coordinates;
            let limit = EXACT * scale(skeleton, &coordinates[coordinate]);
            rate(samples, coordinate, input, limit)
        };
        if leaders.iter().any(|known| rate(known.coordinate).is_some()) {
            continue;
        }
        let mut indices = 0..motion.coordinates.len();
        let found = indices.find_map(|index| Some((index, rate(index)?)));
        let Some((coordinate, rate)) = found else {
            continue;
        };
        let reference = skeleton.arguments()[*argument];
        let [one, other] = ends.map(|end| rate * (end - reference));
        let is_turn = !motion.coordinates[coordinate].is_length()
            && (one - other).abs() > std::f64::consts::TAU - TURN;
        leaders.push(Leader {
            coordinate,
            limits: (!is_turn).then(|| [one.min(other), one.max(other)]),
        });
    }
    leaders
}

/// Returns the change of a coordinate for a change of 1 of an input, if it is a multiple of it.
fn rate(samples: &[Sample], coordinate: usize, input: usize, limit: f64) -> Option<f64> {
    let mut changes = samples.iter().map(|sample| &sample.inputs[input]);
    let first = changes.next()?;
    let largest = changes.fold(*first, |largest, next| match next.abs() > largest.abs() {
        true => *next,
        false => largest,
    });
    let at_largest = samples
        .iter()
        .find(|sample| sample.inputs[input] == largest)?;
    let rate = at_largest.values[coordinate] / largest;
    let mut samples = samples.iter();
    let fits =
        |sample: &Sample| (sample.values[coordinate] - rate * sample.inputs[input]).abs() <= limit;
    (rate != 0.0 && samples.all(fits)).then_some(rate)
}

/// The search for the relation of one joint.
struct Fit<'s> {
    samples: &'s [Sample],
    follower: usize,
    /// The size of the mechanism for a joint that slides, else 1.
    scale: f64,
}

impl Fit<'_> {
    /// Returns the relation of a joint that stands still.
    fn still(&self) -> Option<JointPolynomial> {
        Some(self.relation(None, Vec::new())).filter(|found| self.holds(found))
    }

    /// Returns the polynomial of the lowest degree in another joint, if one is exact.
    fn polynomial(&self, leader: usize, degree: usize) -> Option<JointPolynomial> {
        let points = self.samples.iter();
        let points = points.map(|sample| [sample.values[leader], sample.values[self.follower]]);
        let mut points: Vec<[f64; 2]> = points.chain([[0.0, 0.0]]).collect();
        points.sort_by(|a, b| a[0].total_cmp(&b[0]));
        let span = points[points.len() - 1][0] - points[0][0];
        points.dedup_by(|next, before| next[0] - before[0] <= EXACT * span);
        let (x, y): (Vec<f64>, Vec<f64>) = points.iter().map(|[x, y]| (*x, *y)).unzip();
        let mut degrees = (1..=degree).filter(|degree| x.len() > degree + 2);
        let found = degrees.find_map(|degree| {
            let (coefficients, _) = polynomial(&x, &y, degree);
            Some(self.relation(Some(leader), coefficients)).filter(|found| self.holds(found))
        })?;
        let digits = found.coefficients.iter().map(|number| short(*number));
        let short = self.relation(Some(leader), digits.collect());
        Some(if self.holds(&short) { short } else { found })
    }

    fn relation(&self, leader: Option<usize>, coefficients: Vec<f64>) -> JointPolynomial {
        let values = self
            .samples
            .iter()
            .map(|sample| sample.values[self.follower]);
        let ends = values.fold([0.0f64; 2], |[low, high], value| {
            [low.min(value), high.max(value)]
        });
        JointPolynomial {
            follower: self.follower,
            leader,
            coefficients,
            scale: self.scale,
            ends,
        }
    }

    fn holds(&self, found: &JointPolynomial) -> bool {
        let mut samples = self.samples.iter();
        samples.all(|sample| found.miss(&sample.values).abs() <= EXACT)
    }
}

/// Returns a number without digits that can be rounding, and none below [`EXACT`].
fn short(number: f64) -> f64 {
    match number.abs() < EXACT {
        true => 0.0,
        false => rounded(number, DIGITS),
    }
}

fn scale(skeleton: &Skeleton, coordinate: &Coordinate) -> f64 {
    match coordinate.is_length() {
        true => skeleton.size(),
        false => 1.0,
    }
}
