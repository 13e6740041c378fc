//! Lines along which points slide.

use crate::algebra::calls;
use crate::algebra::dependence;
use crate::algebra::translate;
use crate::picture::drives;
use crate::picture::frames;
use crate::picture::parts;
use linkage_symbolic::{Ex, NodeId, Vn};

use crate::algebra::Translate;
use crate::model::{BinaryOp, Expr, ExprKind, Function, Type};

use super::chains::Sketch;
use super::links::{Links, is_rigid};
use super::marks::{Line, Segment, Shape};
use super::open_loop::Track;
use super::parts::Slide;
use super::samples::Seen;
use crate::ir::GuideOn;

/// Unit vectors whose product misses 1 by less point along one line: 4e-5 radians, far above rounding, far below any angle that is meant.
const PARALLEL: f64 = 1e-9;

pub(super) struct Guides<'m> {
    pub(super) all: Vec<RawGuide<'m>>,
}

pub(super) struct RawGuide<'m> {
    pub(super) name: String,
    /// Points, each the first of those that coincide.
    pub(super) origin: usize,
    pub(super) slider: usize,
    pub(super) along: Vn<'m>,
    pub(super) on: GuideOn,
    /// A cylinder between two pins: a distance, or what an input pushes.
    pub(super) is_cylinder: bool,
}

/// A guide before it is known what carries it.
struct Candidate<'m> {
    name: String,
    origin: usize,
    slider: usize,
    along: Vn<'m>,
    /// Whether the program says that it is on the frame.
    on_frame: bool,
    is_distance: bool,
    /// Whether an input is its length.
    is_driven: bool,
}

impl<'m> Guides<'m> {
    pub(super) fn find(sketch: &mut Sketch<'_, 'm>, seen: &mut Seen, links: &Links) -> Self {
        let mut candidates = Vec::new();
        for segment in sketch.segments.clone() {
            let (from, to) = (seen.same[segment.from], seen.same[segment.to]);
            if from != to && !is_rigid(&segment, seen) {
                candidates.extend(slide(sketch, &segment, seen));
            }
        }
        for line in sketch.lines.clone() {
            candidates.push(candidate(sketch, line));
        }
        let known = seen.same.len();
        seen.add(&sketch.points[known..]);

        let mut guides = Self { all: Vec::new() };
        let ways: Vec<Vn> = candidates.iter().map(|own| own.along).collect();
        for (candidate, along) in candidates.into_iter().zip(seen.tracks_of(&ways)) {
            guides.add(candidate, &along, seen, links);
        }
        guides
    }

    /// The points that slide, and those at which guides begin.
    pub(super) fn ends(&self) -> impl Iterator<Item = usize> {
        let guides = self.all.iter();
        guides.flat_map(|guide| [guide.slider, guide.origin])
    }

    /// Adds a guide unless it is known.
    fn add(&mut self, candidate: Candidate<'m>, along: &Track, seen: &Seen, links: &Links) {
        let (origin, slider) = (seen.same[candidate.origin], seen.same[candidate.slider]);
        if along.iter().flatten().any(|x| !x.is_finite()) {
            return;
        }
        let known = self.all.iter().any(|guide| {
            guide.slider == slider && {
                let other = seen.tracks_of(&[guide.along]);
                parallel(along, &other[0])
            }
        });
        if known {
            return;
        }
        let carrier = links.all.iter().position(|link| {
            let mut points = link.points.iter();
            points.all(|&point| {
                seen.keep_distance(point, origin) && seen.carries(point, origin, along)
            })
        });
        let fixed = candidate.on_frame || seen.is_fixed(origin);
        let on = match carrier {
            _ if candidate.is_distance => GuideOn::Itself,
            _ if fixed && seen.is_steady(along) => GuideOn::Frame,
            Some(link) => GuideOn::Link(link),
            None => GuideOn::Itself,
        };
        // What belongs to the link does not slide on it.
        if let GuideOn::Link(link) = on
            && links.all[link].points.contains(&slider)
        {
            return;
        }
        // A driven length that turns about its end.
        let pushes = candidate.is_driven && on == GuideOn::Itself && !seen.is_steady(along);
        self.all.push(RawGuide {
            name: candidate.name,
            origin,
            slider,
            along: candidate.along,
            on,
            is_cylinder: candidate.is_distance || pushes,
        });
    }
}

/// The guide of a segment that changes its length.
fn slide<'m>(
    sketch: &mut Sketch<'_, 'm>,
    segment: &Segment<'m>,
    seen: &Seen,
) -> Option<Candidate<'m>> {
    let (mut origin, mut slider) = (segment.from, segment.to);
    let from = sketch.points[segment.from].at;
    let (sign, slide) = match segment.shape {
        Shape::Term(sign, term) => {
            let slide = direction_of(sketch, term)?;
            (sign, seen_slide(sketch, slide, segment))
        }
        Shape::Part(sign, slide) => (sign, seen_slide(sketch, slide?, segment)),
        Shape::Distance => {
            // A cylinder hangs on its fixed end.
            if seen.is_fixed(slider) {
                (origin, slider) = (slider, origin);
            }
            let slide = Slide {
                offset: None,
                along: (sketch.points[slider].at - sketch.points[origin].at).unit(),
                input: None,
            };
            (1.0, slide)
        }
        Shape::Body(_) | Shape::Frame(_) | Shape::Base(_) => return None,
    };
    let Slide {
        offset,
        along,
        input,
    } = slide;
    // Towards where the slider goes as the length grows.
    let signed = |vector: Vn<'m>| if sign > 0.0 { vector } else { -vector };
    let (offset, along) = (offset.map(signed), signed(along));
    if let Some(offset) = offset {
        origin = sketch.point(from + offset);
    }
    let inputs = &sketch.algebra.mechanism.inputs;
    let name = match (input, &segment.title) {
        (Some(input), _) => inputs[input].name.clone(),
        (None, Some(title)) => title.text.clone(),
        (None, None) => "slide".to_owned(),
    };
    Some(Candidate {
        name,
        origin,
        slider,
        along,
        on_frame: false,
        is_distance: matches!(segment.shape, Shape::Distance),
        is_driven: input.is_some(),
    })
}

/// In the drawing.
fn seen_slide<'m>(sketch: &mut Sketch<'_, 'm>, own: Slide<'m>, segment: &Segment<'m>) -> Slide<'m> {
    frames::within(sketch, segment.frames.clone(), |sketch| Slide {
        offset: own.offset.map(|offset| frames::seen_way(sketch, offset)),
        along: frames::seen_way(sketch, own.along),
        input: own.input,
    })
}

/// Along which unit vector a term changes its length, and what it contains across that.
pub(super) fn direction_of<'m>(sketch: &mut Sketch<'_, 'm>, term: &'m Expr) -> Option<Slide<'m>> {
    let input = drives::driving(sketch, term);
    let straight = |along: Vn<'m>| Slide {
        offset: None,
        along,
        input,
    };
    match &term.kind {
        ExprKind::Call(Function::Polar, arguments) => {
            let angle = sketch.algebra.translate(&arguments[1]);
            let unit = calls::call(sketch.algebra, Function::Dir, vec![angle]);
            // In a picture of space, the plane is that of x and y.
            let along = translate::vector(sketch.algebra, &unit).resized(sketch.dimension);
            Some(straight(along))
        }
        ExprKind::Binary(BinaryOp::Mul, a, b) => {
            let vector = if matches!(a.ty, Type::Vector(..)) {
                a
            } else {
                b
            };
            Some(straight(sketch.vector(vector).unit()))
        }
        ExprKind::Vector(components) => {
            let (varying, rest) = varying(sketch, components)?;
            Some(Slide {
                offset: Some(rest),
                along: axis_of(sketch, varying),
                input,
            })
        }
        ExprKind::Call(function @ (Function::Rotate | Function::Turn), arguments) => {
            let inner = direction_of(sketch, &arguments[0])?;
            let mut turn = |v| parts::turned_vector(sketch, *function, arguments, v);
            Some(Slide {
                offset: inner.offset.map(&mut turn),
                along: turn(inner.along),
                input,
            })
        }
        // Of anything else nobody knows along what it changes.
        _ => None,
    }
}

/// The unit vector along a coordinate axis.
pub(super) fn axis_of<'m>(sketch: &Sketch<'_, 'm>, component: usize) -> Vn<'m> {
    let graph = sketch.algebra.graph;
    let mut axis = vec![graph.zero(); sketch.dimension];
    axis[component] = graph.one();
    graph.components(&axis)
}

/// The one component that changes, and the vector without it.
fn varying<'m>(sketch: &mut Sketch<'_, 'm>, components: &'m [Expr]) -> Option<(usize, Vn<'m>)> {
    let numbers = components.iter();
    let numbers: Vec<Ex> = numbers
        .map(|own| {
            let value = sketch.algebra.translate(own);
            translate::number(sketch.algebra, &value)
        })
        .collect();
    let changes = 0..numbers.len();
    let changes: Vec<usize> = changes
        .filter(|&k| !dependence::inputs_below(sketch.algebra, &[numbers[k]]).is_empty())
        .collect();
    let [varying] = changes[..] else { return None };
    let mut rest: Vec<NodeId> = numbers.into_iter().map(Ex::id).collect();
    rest[varying] = sketch.algebra.graph.zero();
    Some((varying, sketch.algebra.graph.components(&rest)))
}

/// A guide whose origin is a point that the line goes through, or the one that is nearest to the carrier's point.
fn candidate<'m>(sketch: &mut Sketch<'_, 'm>, line: Line<'m>) -> Candidate<'m> {
    let base = match line.carrier {
        Some(carrier) => sketch.points[carrier].at,
        None => sketch.algebra.graph.zeros(sketch.dimension),
    };
    let slider = sketch.points[line.slider].at;
    let origin = match (line.carrier, line.foot) {
        (Some(carrier), Some(foot)) if foot.iter().all(|own| own.constant_value() == Some(0.0)) => {
            carrier
        }
        (_, Some(foot)) => sketch.point(base + foot),
        (_, None) => {
            let reach = (slider - base).dot(line.along);
            sketch.point(slider - reach * line.along)
        }
    };
    Candidate {
        name: line.name,
        origin,
        slider: line.slider,
        along: line.along,
        on_frame: line.carrier.is_none(),
        is_distance: false,
        is_driven: false,
    }
}

/// Whether two unit vectors always point along one line.
fn parallel(a: &[Vec<f64>], b: &[Vec<f64>]) -> bool {
    a.iter().zip(b).all(|(a, b)| {
        let along: f64 = a.iter().zip(b).map(|(x, y)| x * y).sum();
        (1.0 - along.abs()).abs() < PARALLEL
    })
}
