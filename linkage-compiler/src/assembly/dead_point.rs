//! Description of a dead point in a range: the links that are stretched or folded, the sum of their
//! lengths, and the distance by which they miss.

use linkage_symbolic::lookup::Map;
use linkage_symbolic::{Ex, SymbolId, V2, substitute};

use crate::algebra::{Algebra, Bound, Translate, Value, translate};
use crate::machine::Machine;
use crate::message_format::MessageFormat;
use crate::model::{Expr, Name, Type};
use crate::solve::Solved;
use crate::structure::Form;
use crate::vector::norm;

/// Points nearer than this share of their distance from the origin and each other are one.
const SAME: f64 = 1e-9;

/// Coordinates below this share of the others are rounding: a dead point that is only touched is
/// found to half of the digits.
const NOISE: f64 = 1e-6;

/// A position at which a group is at its dead point.
pub(super) struct DeadPoint<'a, 'm> {
    pub(super) algebra: &'a mut Algebra<'m>,
    pub(super) machine: &'a Machine,
    pub(super) words: &'a MessageFormat<'m>,
    pub(super) solved: &'a Solved<'m>,
    pub(super) inputs: &'a [f64],
    /// Another position, by which names are recognised.
    pub(super) reference: &'a [f64],
    /// The largest distance by which the group misses beyond the dead point; 0 if it closes there,
    /// too.
    pub(super) miss: f64,
}

impl<'m> DeadPoint<'_, 'm> {
    /// Returns `where its links are stretched between ...`; `None` for groups of which nothing is
    /// known except that they miss.
    pub(super) fn picture(&mut self) -> Option<String> {
        let solved = self.solved;
        match &solved.group.form {
            Form::TwoRotors {
                first,
                second,
                known,
            } => {
                let [a, b] = [first.z, second.z].map(|z| self.length(z));
                Some(self.two_links(a, b, self.length(*known)))
            }
            Form::RotorAndSlide {
                rotor,
                slide,
                guide,
                known,
            } => {
                let link = self.length(rotor.z);
                let slide = &self.algebra.graph.symbol(*slide).name;
                let across = guide.cross(*known) / guide.length();
                let [across] = self.numbers(&[across])[..] else {
                    return None;
                };
                let [link_words, far] = [link, across.abs()].map(|x| self.words.gap(solved, x));
                Some(format!(
                    "where its link stands square to the guide of `{slide}`: it is {link_words} long, and its other end is {far} from the \
                     guide{}",
                    self.beyond(link + self.miss, |far, miss| format!(
                        ", but in this range up to {far}, {miss} too far"
                    ))
                ))
            }
            Form::SlideOnRotor {
                rotor,
                slide,
                guide,
                known,
            } => {
                let slide = &self.algebra.graph.symbol(*slide).name;
                let offset = guide.cross(rotor.z) / guide.length();
                let [offset] = self.numbers(&[offset])[..] else {
                    return None;
                };
                let offset = offset.abs();
                if offset <= SAME * (self.length(*known) + self.length(rotor.z)) {
                    return Some(format!(
                        "where the slider of `{slide}` meets the pivot of its guide"
                    ));
                }
                Some(format!(
                    "where the slider of `{slide}` comes to the foot of its guide: the guide passes its pivot at {}, as far as the slider \
                     is from the pivot{}",
                    self.words.gap(solved, offset),
                    self.beyond(offset - self.miss, |near, miss| format!(
                        ", but in this range it comes as near as {near}, {miss} too near"
                    ))
                ))
            }
            Form::Trigonometric { .. }
            | Form::Quadratic { .. }
            | Form::LinkToRotor { .. }
            | Form::LinkToSlide { .. }
            | Form::Point { .. } => (self.miss > 0.0).then(|| {
                let miss = self.words.gap(solved, self.miss);
                format!("beyond which it misses by up to {miss}")
            }),
            // One solution, or followed with messages of its own.
            Form::TwoSlides { .. }
            | Form::Linear { .. }
            | Form::ThreeSlides { .. }
            | Form::Relation { .. }
            | Form::Parallel { .. }
            | Form::Coupled(_) => None,
        }
    }

    /// Two links that are in line between two points at a distance.
    fn two_links(&mut self, a: f64, b: f64, distance: f64) -> String {
        let (long, short) = (a.max(b), a.min(b));
        let between = self.ends(distance);
        let length = |x| self.words.gap(self.solved, x);
        let [a, b, l, s] = [a, b, long, short].map(length);
        match distance > long {
            true => format!(
                "where its links are stretched{between}: {a} + {b} = {}{}",
                length(long + short),
                self.beyond(long + short + self.miss, |apart, miss| format!(
                    ", but in this range the points are up to {apart} apart, {miss} too far"
                ))
            ),
            false => format!(
                "where its links are folded{between}: {l} - {s} = {}{}",
                length(long - short),
                self.beyond(long - short - self.miss, |apart, miss| format!(
                    ", but in this range the points come as near as {apart}, {miss} too near"
                ))
            ),
        }
    }

    /// Returns the text for a point that is `140mm` away at worst, which is `10mm` too far.
    fn beyond(&self, extreme: f64, words: impl Fn(&str, &str) -> String) -> String {
        if self.miss == 0.0 {
            return String::new();
        }
        let [extreme, miss] = [extreme.max(0.0), self.miss].map(|x| self.words.gap(self.solved, x));
        words(&extreme, &miss)
    }

    /// Returns ` between `a` at (1mm, 2mm) and (3mm, 4mm)`, the end points of two links; empty if
    /// the loop does not give their positions.
    fn ends(&mut self, distance: f64) -> String {
        let mechanism = self.algebra.mechanism;
        let written = &mechanism.loops[self.solved.group.written];
        let sides = [&written.left, &written.right].map(|side| self.known_part(side));
        let [Some(left), Some(right)] = sides else {
            return String::new();
        };
        let places = [left, right].map(|end| self.coordinates_of(end));
        let apart = (places[0][0] - places[1][0]).hypot(places[0][1] - places[1][1]);
        let size = places
            .iter()
            .flatten()
            .fold(distance, |size: f64, x| size.max(x.abs()));
        let fits = (apart - distance).abs() <= SAME * size;
        if !fits {
            return String::new();
        }
        let [a, b] = [left, right].map(|end| self.point(end));
        format!(" between {a} and {b}")
    }

    /// A side of a vector loop without the links that the group turns.
    fn known_part(&mut self, side: &Expr) -> Option<V2<'m>> {
        let Value::Vector(vector) = self.algebra.translate(side) else {
            return None;
        };
        let zero = self.algebra.zero();
        let mut nothing: Map<SymbolId, Ex<'m>> = Map::new();
        for &unknown in &self.solved.group.unknowns {
            let Bound::Angle(angle) = self.algebra.names.bound[unknown] else {
                return None;
            };
            let angle = &self.algebra.names.angles[angle];
            nothing.extend([(angle.cos, zero), (angle.sin, zero)]);
        }
        let rows: Vec<Ex> = vector.iter().collect();
        let rows = substitute(&rows, &nothing);
        <[Ex; 2]>::try_from(rows).ok().map(linkage_symbolic::Vector)
    }

    /// `` `a` at (1mm, 2mm)``
    fn point(&mut self, end: V2<'m>) -> String {
        let position = self.coordinates_of(end);
        let size = position[0].hypot(position[1]);
        let position = position.map(|x| if x.abs() < NOISE * size { 0.0 } else { x });
        let dimension = self.solved.gap_dimension(self.algebra.mechanism);
        let coordinates = self.words.vector(&Type::Vector(2, dimension), &position);
        match self.name(end) {
            Some(name) => format!("`{name}` at {coordinates}"),
            None => coordinates,
        }
    }

    /// The name of a point of the plane that is here at both positions.
    fn name(&mut self, end: V2<'m>) -> Option<String> {
        let mechanism = self.algebra.mechanism;
        let constants = mechanism.constants.iter().enumerate();
        let constants = constants.map(|(k, item)| (Name::Const(k), &item.value.ty, &item.name));
        let parameters = mechanism.parameters.iter().enumerate();
        let parameters = parameters.map(|(k, item)| (Name::Parameter(k), &item.ty, &item.name));
        let lets = mechanism.lets.iter().enumerate();
        let lets = lets.map(|(k, item)| (Name::Let(k), &item.value.ty, &item.name));
        let named: Vec<_> = constants.chain(parameters).chain(lets).collect();
        named.into_iter().find_map(|(name, ty, word)| {
            if !matches!(ty, Type::Vector(2, _)) {
                return None;
            }
            let Value::Vector(vector) = translate::value_of_name(&mut self.algebra.names, name)
            else {
                return None;
            };
            let components: Vec<Ex> = vector.iter().collect();
            let [x, y] = components[..] else { return None };
            let positions = [self.inputs, self.reference];
            let same = positions.into_iter().all(|inputs| {
                let all = self.machine.evaluate(&[x, y, end.0[0], end.0[1]], inputs);
                let size = all.iter().fold(0.0, |size: f64, x| size.max(x.abs()));
                (all[0] - all[2]).hypot(all[1] - all[3]) <= SAME * size
            });
            same.then(|| word.clone())
        })
    }

    fn coordinates_of(&self, end: V2<'m>) -> [f64; 2] {
        let numbers = self.numbers(&end.0);
        [numbers[0], numbers[1]]
    }

    fn length(&self, vector: V2<'m>) -> f64 {
        let [x, y] = self.coordinates_of(vector);
        norm([x, y, 0.0])
    }

    fn numbers(&self, all: &[Ex<'m>]) -> Vec<f64> {
        self.machine.evaluate(all, self.inputs)
    }
}
