//! Lines along which points slide.

use linkage_symbolic::program::Source;
use linkage_symbolic::{Ex, NodeId, SymbolId, Vn};

use crate::algebra::Algebra;
use crate::algebra::names::Bound;
use crate::ir::GuideOn;
use crate::model::Dimension;
use crate::picture::layout::Layout;
use crate::picture::links::Links;
use crate::picture::marks::{Line, Segment, Shape, Slide, Spot};
use crate::picture::samples::Samples;
use crate::picture::sketch::Sketch;
use crate::picture::track::Track;
use crate::picture::{directions, links, sketch};

/// Unit vectors whose product misses 1 by less point along one line: 4e-5 radians, far above
/// rounding, far below any angle that is meant.
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
    /// A cylinder between two pins: a distance, or a length that an input drives.
    pub(super) is_cylinder: bool,
}

/// A guide before its carrier is known.
struct Candidate<'m> {
    name: String,
    origin: usize,
    slider: usize,
    along: Vn<'m>,
    /// True if the program says that it is on the frame.
    on_frame: bool,
    is_distance: bool,
    /// True if an input is its length.
    is_driven: bool,
}

impl<'m> Guides<'m> {
    pub(super) fn find(
        algebra: &mut Algebra<'m>,
        layout: &Layout<'m>,
        sketch: &mut Sketch<'m>,
        samples: &mut Samples,
        links: &Links,
    ) -> Self {
        let Sketch {
            points,
            segments,
            lines,
            ..
        } = sketch;
        let mut candidates = Vec::new();
        for segment in segments.iter() {
            let (from, to) = (samples.same[segment.from], samples.same[segment.to]);
            let is_written = !segment.is_aside || has_written_length(algebra, segment);
            if from != to && is_written && !links::is_rigid(segment, samples) {
                candidates.extend(slide(algebra, layout, points, segment, samples));
            }
        }
        for line in lines.iter() {
            candidates.push(candidate(algebra, layout, points, line));
        }
        let known = samples.same.len();
        samples.add(&points[known..]);

        let mut guides = Self { all: Vec::new() };
        let ways: Vec<Vn> = candidates.iter().map(|candidate| candidate.along).collect();
        for (candidate, along) in candidates.into_iter().zip(samples.tracks_of(&ways)) {
            guides.add(candidate, &along, samples, links);
        }
        guides
    }

    /// The points that slide, and those at which guides begin.
    pub(super) fn ends(&self) -> impl Iterator<Item = usize> {
        let guides = self.all.iter();
        guides.flat_map(|guide| [guide.slider, guide.origin])
    }

    /// Adds a guide unless it is known.
    fn add(&mut self, candidate: Candidate<'m>, along: &Track, samples: &Samples, links: &Links) {
        let (origin, slider) = (
            samples.same[candidate.origin],
            samples.same[candidate.slider],
        );
        if along.iter().flatten().any(|x| !x.is_finite()) {
            return;
        }
        let known = self.all.iter().any(|guide| {
            guide.slider == slider && {
                let other = samples.tracks_of(&[guide.along]);
                parallel(along, &other[0])
            }
        });
        if known {
            return;
        }
        let carrier = links.all.iter().position(|link| {
            let mut points = link.points.iter();
            points.all(|&point| {
                samples.keep_distance(point, origin) && samples.carries(point, origin, along)
            })
        });
        let fixed = candidate.on_frame || samples.is_fixed(origin);
        let on = match carrier {
            _ if candidate.is_distance => GuideOn::Itself,
            _ if fixed && samples.is_steady(along) => GuideOn::Frame,
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
        let pushes = candidate.is_driven && on == GuideOn::Itself && !samples.is_steady(along);
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

/// Returns true if an unknown or an input is a length of the step. The length of any other step is
/// a formula, `(0, arm * sin(phi))`: it is the path of a point, and tells of no slide.
fn has_written_length(algebra: &Algebra, segment: &Segment) -> bool {
    let lengths = algebra.names.bound.iter().flat_map(|bound| match bound {
        Bound::Lengths(symbols) => &symbols[..],
        Bound::Angle(_) => &[],
    });
    let lengths: Vec<SymbolId> = lengths.map(|(symbol, _)| *symbol).collect();
    let components: Vec<NodeId> = segment.step.iter().map(Ex::id).collect();
    let inputs = &algebra.mechanism.inputs;
    algebra
        .graph
        .symbols_of(&components)
        .into_iter()
        .any(|symbol| {
            let is_length_input = match algebra.graph.symbol(symbol).source {
                Some(Source::Input(index)) => inputs
                    .get(index)
                    .is_some_and(|input| input.dimension.fits(Dimension::LENGTH)),
                _ => false,
            };
            is_length_input || lengths.contains(&symbol)
        })
}

/// The guide of a segment that changes its length.
fn slide<'m>(
    algebra: &mut Algebra<'m>,
    layout: &Layout<'m>,
    points: &mut Vec<Spot<'m>>,
    segment: &Segment<'m>,
    samples: &Samples,
) -> Option<Candidate<'m>> {
    let (mut origin, mut slider) = (segment.from, segment.to);
    let from = points[segment.from].at;
    let (sign, slide) = match segment.shape {
        Shape::Term(sign, term) => {
            let slide = directions::direction_of(algebra, layout.dimension, term)?;
            (sign, seen_slide(algebra, layout, &segment.frames, slide))
        }
        Shape::Part(sign, slide) => (sign, seen_slide(algebra, layout, &segment.frames, slide?)),
        Shape::Distance => {
            // A cylinder hangs on its fixed end.
            if samples.is_fixed(slider) {
                (origin, slider) = (slider, origin);
            }
            let slide = Slide {
                offset: None,
                along: (points[slider].at - points[origin].at).unit(),
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
        origin = sketch::point(algebra, layout, points, &[], from + offset);
    }
    let inputs = &algebra.mechanism.inputs;
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
fn seen_slide<'m>(
    algebra: &mut Algebra<'m>,
    layout: &Layout<'m>,
    frames: &[usize],
    slide: Slide<'m>,
) -> Slide<'m> {
    let mut seen = |way| layout.seen_way(algebra, frames, way);
    Slide {
        offset: slide.offset.map(&mut seen),
        along: seen(slide.along),
        input: slide.input,
    }
}

/// A guide whose origin is a point that the line goes through, or the one that is nearest to the
/// carrier's point.
fn candidate<'m>(
    algebra: &mut Algebra<'m>,
    layout: &Layout<'m>,
    points: &mut Vec<Spot<'m>>,
    line: &Line<'m>,
) -> Candidate<'m> {
    let base = match line.carrier {
        Some(carrier) => points[carrier].at,
        None => algebra.graph.zeros(layout.dimension),
    };
    let slider = points[line.slider].at;
    let origin = match (line.carrier, line.foot) {
        (Some(carrier), Some(foot))
            if foot
                .iter()
                .all(|component| component.constant_value() == Some(0.0)) =>
        {
            carrier
        }
        (_, Some(foot)) => sketch::point(algebra, layout, points, &[], base + foot),
        (_, None) => {
            let reach = (slider - base).dot(line.along);
            sketch::point(algebra, layout, points, &[], slider - reach * line.along)
        }
    };
    Candidate {
        name: line.name.clone(),
        origin,
        slider: line.slider,
        along: line.along,
        on_frame: line.carrier.is_none(),
        is_distance: false,
        is_driven: false,
    }
}

/// True if two unit vectors always point along one line.
fn parallel(a: &[Vec<f64>], b: &[Vec<f64>]) -> bool {
    a.iter().zip(b).all(|(a, b)| {
        let along: f64 = a.iter().zip(b).map(|(x, y)| x * y).sum();
        (1.0 - along.abs()).abs() < PARALLEL
    })
}
