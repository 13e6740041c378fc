//! Guides before their carriers are known.

use linkage_symbolic::program::Source;
use linkage_symbolic::{Ex, NodeId, SymbolId, Vn};

use crate::algebra::Algebra;
use crate::algebra::names::Bound;
use crate::model::Dimension;
use crate::picture::layout::Layout;
use crate::picture::marks::{Arc, Line, Segment, Shape, Slide, Slot, Spot};
use crate::picture::samples::Samples;
use crate::picture::sketch::Sketch;
use crate::picture::{directions, links, sketch};

/// A guide before its carrier is known.
pub(super) struct Candidate<'m> {
    pub(super) name: String,
    pub(super) origin: usize,
    pub(super) slider: usize,
    pub(super) along: Vn<'m>,
    /// True if the program says that it is on the frame.
    pub(super) on_frame: bool,
    pub(super) is_distance: bool,
    /// True if an input is its length.
    pub(super) is_driven: bool,
    pub(super) is_arc: bool,
    /// True for a straight slot that the text has.
    pub(super) is_slot: bool,
}

/// Returns all guides of declared slots, segments, lines and arcs. Their points are added to the
/// sketch.
pub(super) fn collect<'m>(
    algebra: &mut Algebra<'m>,
    layout: &Layout<'m>,
    sketch: &mut Sketch<'m>,
    samples: &Samples,
) -> Vec<Candidate<'m>> {
    let Sketch {
        points,
        segments,
        lines,
        arcs,
        slots,
        ..
    } = sketch;
    let mut candidates: Vec<Candidate> = slots.iter().map(of_slot).collect();
    for segment in segments.iter() {
        let (from, to) = (samples.same[segment.from], samples.same[segment.to]);
        let is_written = !segment.is_aside || has_written_length(algebra, segment);
        if from != to && is_written && !links::is_rigid(segment, samples) {
            candidates.extend(slide(algebra, layout, points, segment, samples));
        }
    }
    for line in lines.iter() {
        candidates.push(of_line(algebra, layout, points, line));
    }
    candidates.extend(arcs.iter().map(of_arc));
    candidates
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
        is_arc: false,
        is_slot: false,
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
fn of_line<'m>(
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
        is_arc: false,
        is_slot: false,
    }
}

/// The guide of a straight slot that the text has.
fn of_slot<'m>(slot: &Slot<'m>) -> Candidate<'m> {
    Candidate {
        name: slot.name.clone(),
        origin: slot.start,
        slider: slot.slider,
        along: slot.direction,
        on_frame: false,
        is_distance: false,
        is_driven: false,
        is_arc: false,
        is_slot: true,
    }
}

/// The guide of a curved slot.
fn of_arc<'m>(arc: &Arc<'m>) -> Candidate<'m> {
    Candidate {
        name: arc.name.clone(),
        origin: arc.centre,
        slider: arc.slider,
        along: arc.direction,
        on_frame: false,
        is_distance: false,
        is_driven: false,
        is_arc: true,
        is_slot: false,
    }
}
