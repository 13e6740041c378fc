//! What inputs move, and wheels whose angles belong together.

use std::collections::BTreeSet;

use linkage_symbolic::program::Source;
use linkage_symbolic::{SymbolId, Vn};

use crate::algebra::Bound;
use crate::model::{Dimension, Expr, Loop, Name};
use crate::unit::{Drive, DriveOn, Gear, Part, Picture};

use super::chains::Sketch;
use super::free::relates_angles;
use super::marks::{Segment, Shape};
use super::seen::Seen;

/// A link that turns about a point of the frame by one angle alone.
struct Wheel {
    centre: usize,
    end: usize,
    segment: (usize, usize),
    angle: BTreeSet<SymbolId>,
}

impl<'m> Sketch<'_, 'm> {
    /// The input that is a length in an expression.
    pub(super) fn driving(&self, expr: &Expr) -> Option<usize> {
        let mechanism = self.algebra.mechanism;
        expr.parts().find_map(|part| match part.as_name()? {
            Name::Input(input) => {
                let is_length = mechanism.inputs[input].dimension.fits(Dimension::LENGTH);
                is_length.then_some(input)
            }
            name => self.driving(mechanism.value_of(name)?),
        })
    }

    /// For each input a link that it turns, or the guide that is called after it. Points are those of the picture, `place` tells
    /// which.
    pub(super) fn drives(
        &self,
        picture: &Picture,
        place: &dyn Fn(usize) -> Option<usize>,
    ) -> Vec<Drive> {
        let inputs = self.algebra.mechanism.inputs.iter().enumerate();
        let drives = inputs.filter_map(|(input, own)| {
            let mut guides = picture.guides.iter();
            let slides = guides.position(|guide| guide.name == own.name);
            let on = match slides {
                Some(guide) => DriveOn::Slide(guide),
                None => DriveOn::Turn(self.turned_by(Source::Input(input), picture, place)?),
            };
            Some(Drive { input, on })
        });
        drives.collect()
    }

    /// The ends of a step that this turns: if there is one, that nothing else turns.
    fn turned_by(
        &self,
        source: Source,
        picture: &Picture,
        place: &dyn Fn(usize) -> Option<usize>,
    ) -> Option<[usize; 2]> {
        let symbol = self.algebra.graph.find_source(source)?;
        let all = self.segments.iter().filter_map(|own| {
            let angle = self.turning(own.step);
            let turns = angle.contains(&symbol);
            Some((angle.len(), ends(own, picture, place)?)).filter(|_| turns)
        });
        all.min_by_key(|(count, _)| *count).map(|(_, ends)| ends)
    }

    /// Wheels that turn by one angle, or by angles with a relation between them. The first one of several turns the others.
    pub(super) fn gears(
        &self,
        picture: &Picture,
        place: &dyn Fn(usize) -> Option<usize>,
        seen: &Seen,
    ) -> Vec<Gear> {
        let mut wheels: Vec<Wheel> = Vec::new();
        for segment in self.segments.iter() {
            // A distance does not say what turns it.
            let is_step = matches!(segment.shape, Shape::Term(..) | Shape::Part(..));
            if !is_step || !seen.is_fixed(segment.from) {
                continue;
            }
            let Some([centre, end]) = ends(segment, picture, place) else {
                continue;
            };
            let angle = self.turning(segment.step);
            if self.is_one_angle(&angle) && wheels.iter().all(|own| own.centre != centre) {
                wheels.push(Wheel {
                    centre,
                    end,
                    segment: (segment.from, segment.to),
                    angle,
                });
            }
        }
        let loops = self.algebra.mechanism.loops.iter();
        let relations: Vec<BTreeSet<SymbolId>> = loops
            .filter(|own| relates_angles(own))
            .map(|own| self.related(own))
            .collect();
        let belong = |a: &Wheel, b: &Wheel| {
            let both: BTreeSet<SymbolId> = a.angle.union(&b.angle).copied().collect();
            // Links that turn alike are held together by something else than wheels.
            let differ = a.angle == b.angle && !seen.turn_alike(a.segment, b.segment);
            // Parts on one shaft are each driven by it.
            let differ = differ && !are_of_two_parts(picture, a.end, b.end);
            differ || relations.iter().any(|own| both.is_subset(own))
        };
        let mut gears = Vec::new();
        for (index, own) in wheels.iter().enumerate() {
            let turning = wheels[..index].iter().find(|other| belong(other, own));
            gears.extend(turning.map(|other| Gear {
                centres: [other.centre, own.centre],
                ends: [other.end, own.end],
            }));
        }
        gears
    }

    /// What a step turns by.
    fn turning(&self, step: Vn) -> BTreeSet<SymbolId> {
        let graph = self.algebra.graph;
        let all = graph.symbols_of(step.ids()).into_iter();
        let moves = |own: &SymbolId| {
            let source = graph.symbol(*own).source;
            !matches!(source, Some(Source::Parameter(_)))
        };
        all.filter(moves).collect()
    }

    fn is_one_angle(&self, all: &BTreeSet<SymbolId>) -> bool {
        let names = &self.algebra.names;
        let mut angles = names.angles.iter().map(|own| own.symbols());
        let is_unknown = angles.any(|own| all.iter().all(|symbol| own.contains(symbol)));
        let graph = self.algebra.graph;
        let mut sources = all.iter().map(|own| graph.symbol(*own).source);
        let is_input = all.len() == 1 && sources.all(|own| matches!(own, Some(Source::Input(_))));
        !all.is_empty() && (is_unknown || is_input)
    }

    /// All symbols of the angles that an equation names.
    fn related(&self, own: &Loop) -> BTreeSet<SymbolId> {
        let names = &self.algebra.names;
        let parts = own.left.parts().chain(own.right.parts());
        let symbols = parts.filter_map(|part| match part.as_name()? {
            Name::Input(input) => {
                let source = Source::Input(input);
                Some(vec![self.algebra.graph.find_source(source)?])
            }
            Name::Unknown(unknown) => match names.bound[unknown] {
                Bound::Angle(angle) => Some(names.angles[angle].symbols().to_vec()),
                Bound::Lengths(_) => None,
            },
            Name::Const(_) | Name::Parameter(_) | Name::Let(_) | Name::Argument(_) | Name::Pi => {
                None
            }
        });
        symbols.flatten().collect()
    }
}

/// The points of a segment, if they belong to one link of the picture.
fn ends(
    segment: &Segment,
    picture: &Picture,
    place: &dyn Fn(usize) -> Option<usize>,
) -> Option<[usize; 2]> {
    let (from, to) = (place(segment.from)?, place(segment.to)?);
    let has_both = |points: &[usize]| points.contains(&from) && points.contains(&to);
    let mut links = picture.links.iter();
    links
        .any(|link| has_both(&link.points))
        .then_some([from, to])
}

/// Whether each of two points belongs to a part, and none to both.
fn are_of_two_parts(picture: &Picture, a: usize, b: usize) -> bool {
    let has = |part: &Part, point: usize| part.points.contains(&point);
    let parts = &picture.parts;
    let each = [a, b].map(|point| parts.iter().any(|part| has(part, point)));
    let both = parts.iter().any(|part| has(part, a) && has(part, b));
    each == [true; 2] && !both
}
