//! Ranges that are refused: the message, and the largest box within them that works.

use linkage_core::numeric::largest_box::largest_box;
use linkage_core::range_check::rounded_inwards;

use crate::algebra::Nominal;
use crate::diagnostic::{OriginId, Reporter, SourceSpan};
use crate::message_format::MessageFormat;
use crate::model::{Input, Mechanism};

/// Lines along each of so many inputs with a range, one more than the index: some thousand nodes in
/// all.
const LINES: [usize; 4] = [129, 49, 13, 7];

/// The advice where links do not reach each other.
pub(super) const OR_LENGTHS: &str =
    ", or change the lengths so that the links reach each other all the way";

/// The refusal of declared ranges.
#[derive(Clone, Debug)]
pub(crate) struct RefusedRange {
    /// The words at fault.
    pub(super) origins: [OriginId; 2],
    pub(super) fact: String,
    /// The advice if it is not known how far the ranges can be.
    pub(super) narrower: &'static str,
    /// Other advice, with a comma in front if there is a first one.
    pub(super) otherwise: String,
    /// The kind of the box that works, if one is known.
    pub(super) found: FoundBox,
}

/// The kind of a box within declared ranges.
#[derive(Clone, Copy, Debug)]
pub(super) enum FoundBox {
    /// The largest one, as far as the survey of the ranges shows.
    Largest,
    /// All ranges are halved towards the reference until the box works.
    Halved,
}

impl RefusedRange {
    /// Reports it; `works` are narrower ranges that work, if they are known.
    pub(super) fn report(
        self,
        mechanism: &Mechanism,
        works: Option<&Nominal>,
        reporter: &mut Reporter,
    ) {
        let Self {
            origins,
            fact,
            narrower,
            otherwise,
            found,
        } = self;
        let help = match works {
            Some(nominal) if narrower.is_empty() => {
                format!(
                    "{otherwise}, or write {}",
                    ranges(mechanism, nominal, found)
                )
            }
            Some(nominal) => format!("write {}{otherwise}", ranges(mechanism, nominal, found)),
            None => format!("{narrower}{otherwise}"),
        };
        let narrower = works.map_or_else(Vec::new, |nominal| narrower_ranges(mechanism, nominal));
        let replaced: Vec<(SourceSpan, NarrowerRange)> = narrower
            .into_iter()
            .map(|range| (reporter.span_between(range_of(range.input)), range))
            .collect();
        let message = reporter.error_between(origins, format!("{fact}\nhelp: {help}"));
        for (span, range) in replaced {
            let title = format!("write `in {}` for `{}`", range.text, range.input.name);
            message.suggest(title, span, range.text);
        }
    }
}

/// Returns the origin of the range, or of the input's name.
pub(super) fn range_of(input: &Input) -> [OriginId; 2] {
    match &input.range {
        Some((low, high)) => [low.origin, high.origin],
        None => [input.origin; 2],
    }
}

/// A range that works, in place of a declared one.
struct NarrowerRange<'m> {
    input: &'m Input,
    /// `231mm..289mm`
    text: String,
}

/// Returns the ranges that work of all inputs with a range.
fn narrower_ranges<'m>(mechanism: &'m Mechanism, nominal: &Nominal) -> Vec<NarrowerRange<'m>> {
    let words = MessageFormat::new(mechanism);
    let pairs = mechanism.inputs.iter().zip(&nominal.ranges);
    let each = pairs.filter_map(|(input, range)| {
        let (low, high) = (*range)?;
        let [low, high] = [low, high].map(|end| words.scalar(input.dimension, end));
        Some(NarrowerRange {
            input,
            text: format!("{low}..{high}"),
        })
    });
    each.collect()
}

/// `` `in 231mm..289mm` for `left` and `in 40deg..60deg` for `phi` ``
fn ranges(mechanism: &Mechanism, nominal: &Nominal, found: FoundBox) -> String {
    let each = narrower_ranges(mechanism, nominal).into_iter();
    let each = each.map(|range| format!("`in {}` for `{}`", range.text, range.input.name));
    let each: Vec<String> = each.collect();
    match (&each[..], found) {
        ([one], FoundBox::Largest) => format!("{one}, the largest range that works"),
        ([one], FoundBox::Halved) => format!("{one}, a range that works"),
        (several, FoundBox::Largest) => {
            format!("{}, the largest box that works", several.join(" and "))
        }
        (several, FoundBox::Halved) => format!("{}, a box that works", several.join(" and ")),
    }
}

/// Returns the same mechanism with this share of the ranges of some inputs on both sides of the
/// reference, rounded inwards as far as the reference at most.
pub(super) fn shrunk(
    mechanism: &Mechanism,
    nominal: &Nominal,
    inputs: &[usize],
    share: f64,
) -> Nominal {
    let mut narrower = nominal.clone();
    for &input in inputs {
        if let Some((low, high)) = nominal.ranges[input] {
            let at = nominal.inputs[input];
            let reach = [low, high].map(|end| at + share * (end - at));
            let is_angle = mechanism.inputs[input].dimension.half_lengths == 0;
            let ([from, to], _) = rounded_inwards(reach, at, [at, at], is_angle);
            narrower.ranges[input] = Some((from.min(at), to.max(at)));
        }
    }
    narrower
}

/// Nodes all over the ranges of some inputs, with a line through the reference along each.
pub(super) struct RangeSurvey<'a> {
    inputs: &'a [usize],
    pub(super) lines: Vec<Vec<f64>>,
    /// The node of the reference.
    pub(super) start: Vec<usize>,
}

impl<'a> RangeSurvey<'a> {
    /// The survey of the declared ranges of these inputs. `None` if none has a range or too many
    /// have one.
    pub(super) fn new(nominal: &Nominal, inputs: &'a [usize]) -> Option<Self> {
        let declared = inputs.iter().filter(|&&k| nominal.ranges[k].is_some());
        let count = *LINES.get(declared.count().checked_sub(1)?)?;
        let mut survey = Self {
            inputs,
            lines: Vec::new(),
            start: Vec::new(),
        };
        for &input in inputs {
            let at = nominal.inputs[input];
            let (low, high) = nominal.ranges[input].unwrap_or((at, at));
            if !(low <= at && at <= high) {
                return None;
            }
            let steps = |length: f64| match high - low {
                0.0 => 0,
                all => ((count - 1) as f64 * length / all).ceil() as usize,
            };
            let (below, above) = (steps(at - low), steps(high - at));
            let down = (0..below).map(|k| low + (at - low) * k as f64 / below as f64);
            let up = (1..=above).map(|k| at + (high - at) * k as f64 / above as f64);
            survey.lines.push(down.chain([at]).chain(up).collect());
            survey.start.push(below);
        }
        Some(survey)
    }

    /// Returns all inputs of the mechanism at each node, the last input of the survey changing
    /// fastest.
    pub(super) fn nodes(&self, nominal: &Nominal) -> Vec<Vec<f64>> {
        let mut nodes = vec![nominal.inputs.clone()];
        for (&input, places) in self.inputs.iter().zip(&self.lines) {
            let longer = nodes.iter().flat_map(|node| {
                places.iter().map(move |&x| {
                    let mut node = node.clone();
                    node[input] = x;
                    node
                })
            });
            nodes = longer.collect();
        }
        nodes
    }

    /// The same mechanism with the ranges of the largest box of nodes that work, rounded inwards.
    pub(super) fn narrowed(
        &self,
        mechanism: &Mechanism,
        nominal: &Nominal,
        works: &[bool],
    ) -> Option<Nominal> {
        let found = largest_box(&self.lines, &self.start, works)?;
        let mut narrower = nominal.clone();
        let sides = self.inputs.iter().zip(&self.lines).zip(found);
        for ((&input, places), [first, last]) in sides {
            if nominal.ranges[input].is_some() {
                let at = nominal.inputs[input];
                let is_angle = mechanism.inputs[input].dimension.half_lengths == 0;
                let reach = [places[first], places[last]];
                let (ends, _) = rounded_inwards(reach, at, [at, at], is_angle);
                narrower.ranges[input] = Some(ends.into());
            }
        }
        Some(narrower)
    }
}
