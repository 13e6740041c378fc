//! Links that inputs move, and wheels whose angles belong together.

use std::collections::BTreeSet;

use linkage_symbolic::lookup::{Map, Set};
use linkage_symbolic::program::Source;
use linkage_symbolic::{Graph, SymbolId, Vn};

use crate::algebra::{Algebra, Bound, Names};
use crate::ir::{Drive, DriveOn, Gear, GuideShape, Picture, PicturePart, WheelContact, WheelTurn};
use crate::model::{Loop, Name};
use crate::picture::by_point::ByPoint;
use crate::picture::marks::{Segment, Shape};
use crate::picture::open_loop;
use crate::picture::samples::Samples;

/// A link that turns about a point of the frame by one angle alone.
struct Wheel {
    centre: usize,
    end: usize,
    segment: (usize, usize),
    angle: BTreeSet<SymbolId>,
}

/// For each input a link that it turns, or the guide that is called after it. Points are those of
/// the picture, `place` tells which.
pub(super) fn drives(
    algebra: &Algebra,
    segments: &[Segment],
    picture: &Picture,
    index_of: &dyn Fn(usize) -> Option<usize>,
) -> Vec<Drive> {
    let links = &ByPoint::of_lists(picture.links.iter().map(|link| &link.points));
    // What turns each step, and the steps that each symbol turns.
    let steps = segments.iter().filter_map(|segment| {
        let ends = ends(segment, picture, links, index_of)?;
        Some((turning(algebra.graph, segment.step), ends))
    });
    let steps: Vec<(BTreeSet<SymbolId>, [usize; 2])> = steps.collect();
    let mut turned: Map<SymbolId, Vec<usize>> = Map::new();
    for (index, (angle, _)) in steps.iter().enumerate() {
        for &symbol in angle {
            turned.entry(symbol).or_default().push(index);
        }
    }
    // The ends of the step that fewest others turn, too.
    let turned_by = |input: usize| {
        let symbol = algebra.graph.find_source(Source::Input(input))?;
        let turned_steps = turned.get(&symbol)?.iter().map(|&index| &steps[index]);
        let (_, ends) = turned_steps.min_by_key(|(angle, _)| angle.len())?;
        Some(*ends)
    };
    let inputs = algebra.mechanism.inputs.iter().enumerate();
    let drives = inputs.filter_map(|(input, declared)| {
        let mut guides = picture.guides.iter();
        let slides =
            guides.position(|guide| guide.shape != GuideShape::Arc && guide.name == declared.name);
        let on = match slides {
            Some(guide) => DriveOn::Slide(guide),
            None => DriveOn::Turn(turned_by(input)?),
        };
        Some(Drive { input, on })
    });
    drives.collect()
}

/// Wheels that turn by one angle, or by angles with a relation between them. The first one of
/// several turns the others.
pub(super) fn gears(
    algebra: &Algebra,
    segments: &[Segment],
    picture: &Picture,
    index_of: &dyn Fn(usize) -> Option<usize>,
    samples: &Samples,
) -> Vec<Gear> {
    let wheels = wheels(algebra, segments, picture, index_of, samples);
    let loops = algebra.mechanism.loops.iter();
    let relations: Vec<BTreeSet<SymbolId>> = loops
        .filter(|equation| open_loop::relates_angles(equation))
        .map(|equation| related(algebra.graph, &algebra.names, equation))
        .collect();
    let belong = |a: &Wheel, b: &Wheel| {
        // Links that turn alike are held together by something else than wheels.
        let differ = a.angle == b.angle && !samples.turn_alike(a.segment, b.segment);
        // Parts on one shaft are each driven by it.
        let differ = differ && !are_of_two_parts(picture, a.end, b.end);
        let has_both = |relation: &BTreeSet<SymbolId>| {
            a.angle.is_subset(relation) && b.angle.is_subset(relation)
        };
        differ || relations.iter().any(has_both)
    };
    let mut candidates = Candidates::new(&relations);
    let mut gears = Vec::new();
    for (index, wheel) in wheels.iter().enumerate() {
        let mut before = candidates.before(&wheel.angle).into_iter();
        let turning = before.find(|&other| belong(&wheels[other], wheel));
        candidates.add(index, &wheel.angle);
        let turning = turning.map(|other| &wheels[other]);
        gears.extend(turning.map(|other| Gear {
            centres: [other.centre, wheel.centre],
            turns: [other.end, wheel.end].map(WheelTurn::End),
            contact: WheelContact::BySense,
        }));
    }
    gears
}

/// The links that turn about points of the frame, one for each point.
fn wheels(
    algebra: &Algebra,
    segments: &[Segment],
    picture: &Picture,
    index_of: &dyn Fn(usize) -> Option<usize>,
    samples: &Samples,
) -> Vec<Wheel> {
    let links = &ByPoint::of_lists(picture.links.iter().map(|link| &link.points));
    let mut wheels: Vec<Wheel> = Vec::new();
    let mut centres: Set<usize> = Set::new();
    for segment in segments.iter() {
        // A distance does not say what turns it.
        let is_step = matches!(segment.shape, Shape::Term(..) | Shape::Part(..));
        if !is_step || !samples.is_fixed(segment.from) {
            continue;
        }
        let Some([centre, end]) = ends(segment, picture, links, index_of) else {
            continue;
        };
        let angle = turning(algebra.graph, segment.step);
        if !centres.contains(&centre) && is_one_angle(algebra.graph, &algebra.names, &angle) {
            centres.insert(centre);
            wheels.push(Wheel {
                centre,
                end,
                segment: (segment.from, segment.to),
                angle,
            });
        }
    }
    wheels
}

/// The symbols that turn a step.
fn turning(graph: &Graph, step: Vn) -> BTreeSet<SymbolId> {
    let symbols = graph.symbols_of(step.ids()).into_iter();
    let moves = |symbol: &SymbolId| {
        let source = graph.symbol(*symbol).source;
        !matches!(source, Some(Source::Parameter(_)))
    };
    symbols.filter(moves).collect()
}

fn is_one_angle(graph: &Graph, names: &Names, symbols: &BTreeSet<SymbolId>) -> bool {
    // An angle has three symbols.
    let few = symbols.len() <= 3;
    let mut angles = names.angles.iter().map(|angle| angle.symbols());
    let is_unknown = few && angles.any(|angle| symbols.iter().all(|symbol| angle.contains(symbol)));
    let mut sources = symbols.iter().map(|symbol| graph.symbol(*symbol).source);
    let is_input =
        symbols.len() == 1 && sources.all(|source| matches!(source, Some(Source::Input(_))));
    !symbols.is_empty() && (is_unknown || is_input)
}

/// All symbols of the angles that an equation names.
fn related(graph: &Graph, names: &Names, equation: &Loop) -> BTreeSet<SymbolId> {
    let parts = equation.left.parts().chain(equation.right.parts());
    let symbols = parts.filter_map(|part| match part.as_name()? {
        Name::Input(input) => {
            let source = Source::Input(input);
            Some(vec![graph.find_source(source)?])
        }
        Name::Unknown(unknown) => match names.bound[unknown] {
            Bound::Angle(angle) => Some(names.angles[angle].symbols().to_vec()),
            Bound::Lengths(_) => None,
        },
        Name::Const(_) | Name::Parameter(_) | Name::Let(_) | Name::Argument(_) | Name::Pi => None,
    });
    symbols.flatten().collect()
}

/// The points of a segment, if they belong to one link of the picture.
fn ends(
    segment: &Segment,
    picture: &Picture,
    links: &ByPoint,
    index_of: &dyn Fn(usize) -> Option<usize>,
) -> Option<[usize; 2]> {
    let (from, to) = (index_of(segment.from)?, index_of(segment.to)?);
    let mut links = links
        .at_point(from)
        .iter()
        .map(|&link| &picture.links[link]);
    links
        .any(|link| link.points.contains(&to))
        .then_some([from, to])
}

/// Wheels that may belong together, by the symbols that they turn by.
struct Candidates<'a> {
    relations: &'a [BTreeSet<SymbolId>],
    /// For each symbol: the relations that it is in.
    related: Map<SymbolId, Vec<usize>>,
    /// For each symbol: the wheels that turn by it.
    turning: Map<SymbolId, Vec<usize>>,
}

impl<'a> Candidates<'a> {
    fn new(relations: &'a [BTreeSet<SymbolId>]) -> Self {
        let mut related: Map<SymbolId, Vec<usize>> = Map::new();
        for (index, symbols) in relations.iter().enumerate() {
            for &symbol in symbols {
                related.entry(symbol).or_default().push(index);
            }
        }
        Self {
            relations,
            related,
            turning: Map::new(),
        }
    }

    fn add(&mut self, wheel: usize, angle: &BTreeSet<SymbolId>) {
        for &symbol in angle {
            self.turning.entry(symbol).or_default().push(wheel);
        }
    }

    /// The wheels that turn by this angle, or by one that has a relation with it, in order.
    fn before(&self, angle: &BTreeSet<SymbolId>) -> BTreeSet<usize> {
        let related = angle.iter().filter_map(|symbol| self.related.get(symbol));
        let related: BTreeSet<usize> = related.flatten().copied().collect();
        let others = related
            .into_iter()
            .flat_map(|relation| &self.relations[relation]);
        let wheels = angle.iter().chain(others);
        let wheels = wheels.filter_map(|symbol| self.turning.get(symbol));
        wheels.flatten().copied().collect()
    }
}

/// True if each of two points belongs to a part, and none to both.
fn are_of_two_parts(picture: &Picture, a: usize, b: usize) -> bool {
    let has = |part: &PicturePart, point: usize| part.points.contains(&point);
    let parts = &picture.parts;
    let each = [a, b].map(|point| parts.iter().any(|part| has(part, point)));
    let both = parts.iter().any(|part| has(part, a) && has(part, b));
    each == [true; 2] && !both
}
