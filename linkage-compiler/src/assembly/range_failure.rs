//! Messages about a mechanism that comes apart in its range: dead points, change points.

use std::f64::consts::TAU;

use linkage_core::range_check::{self, Comes, Reaches, not_finite, rounded_inwards};
use linkage_symbolic::program::Ternary;

use crate::algebra::derivatives::dependence;
use crate::algebra::{ALIKE, Algebra, Bound, ConstantRatio, constant_ratio};
use crate::diagnostic::OriginId;
use crate::message_format::{MessageFormat, loop_numbers};
use crate::model::Mechanism;

use super::dead_point::DeadPoint;
use super::ranges::{Break, Broken, GRID, Ranges};
use super::refused_range::{FoundBox, OR_LENGTHS, RefusedRange, range_of};

/// Positions between the reference and a change point at which angles are compared.
const COMPARED: usize = 8;

/// A message with the words it underlines.
pub(super) struct Apart {
    pub(super) origins: [OriginId; 2],
    pub(super) message: String,
    /// A range that works, as it is written; `None` if it is not known.
    pub(super) range: Option<String>,
}

impl<'m> Ranges<'_, 'm> {
    /// A range that meets a dead point.
    pub(super) fn apart(&mut self, algebra: &mut Algebra<'m>, at: Break) -> Apart {
        let words = MessageFormat::new(algebra.mechanism);
        let input = &algebra.mechanism.inputs[at.input];
        let solved = &self.formulation.groups[at.dead_point.group];
        let concerned = dependence::inputs_below(
            algebra.graph,
            &mut algebra.derivatives.dependence,
            &[solved.closed.slack],
        );
        let position = words.inputs(&at.dead_point.inputs, &concerned);
        let loops = words.loops(&solved.group.loops);
        let unknowns = words.unknowns(&solved.group.unknowns);
        let group = Comes {
            loops: &loops,
            several: solved.group.loops.len() != 1,
            unknowns: &unknowns,
        };
        let works = self.works(algebra, &words, &at);
        let [low, high] = works.range.each_ref().map(String::as_str);
        let range = Some(format!("{low}..{high}"));
        if !at.dead_point.finite {
            let message = not_finite(group, &position, "", Some([low, high]));
            return Apart {
                origins: range_of(input),
                message: with_help(&message),
                range,
            };
        }
        let miss = self.largest_miss(&at);
        let even = match miss == 0.0 {
            true => self.even(algebra, &at),
            false => None,
        };
        let reaches = |picture| Reaches {
            group,
            change: miss == 0.0,
            position: &position,
            picture,
            works: works.fact.each_ref().map(String::as_str),
            range: [low, high],
        };
        let message = match even {
            Some(even) => {
                let loops = &solved.group.loops;
                parallelogram(algebra.mechanism, &words, &at, loops, &even, &reaches(""))
            }
            None => {
                let picture = DeadPoint {
                    algebra,
                    machine: &self.reference.machine,
                    words: &words,
                    solved,
                    inputs: &at.dead_point.inputs,
                    reference: &self.nominal.inputs,
                    miss,
                }
                .picture();
                let picture = picture.map_or_else(String::new, |picture| format!(", {picture}"));
                let reaches = reaches(&picture);
                with_help(&[reaches.fact(), reaches.help()])
            }
        };
        Apart {
            origins: range_of(input),
            message,
            range,
        }
    }

    /// A position of a grid over several ranges that does not close.
    pub(super) fn apart_on_grid(
        &mut self,
        algebra: &mut Algebra<'m>,
        declared: &[usize],
        at: &Broken,
    ) -> RefusedRange {
        let words = MessageFormat::new(algebra.mechanism);
        let solved = &self.formulation.groups[at.group];
        let concerned = dependence::inputs_below(
            algebra.graph,
            &mut algebra.derivatives.dependence,
            &[solved.closed.slack],
        );
        let loops = words.loops(&solved.group.loops);
        let unknowns = words.unknowns(&solved.group.unknowns);
        let group = Comes {
            loops: &loops,
            several: solved.group.loops.len() != 1,
            unknowns: &unknowns,
        };
        let mut declared = declared.iter();
        let input = declared.clone().find(|k| concerned.contains(k));
        let input = input.or_else(|| declared.next());
        let origin = algebra.mechanism.loops[solved.group.written].origin;
        let position = words.inputs(&at.inputs, &concerned);
        let how = format!(" (found on a grid of at most {GRID} positions)");
        let (fact, narrower, otherwise) = match at.finite {
            true => (
                format!("{} a dead point at {position}{how}", group.apart()),
                "restrict the range",
                OR_LENGTHS.to_owned(),
            ),
            false => {
                let [fact, help] = not_finite(group, &position, &how, None);
                (fact, "", help)
            }
        };
        RefusedRange {
            origins: input.map_or([origin; 2], |&k| range_of(&algebra.mechanism.inputs[k])),
            fact,
            narrower,
            otherwise,
            found: FoundBox::Largest,
        }
    }

    /// The stretch around the reference in which it works.
    fn works(&mut self, algebra: &Algebra, words: &MessageFormat, at: &Break) -> Works {
        let input = &algebra.mechanism.inputs[at.input];
        let reference = self.nominal.inputs[at.input];
        let (low, high) = self.nominal.ranges[at.input].unwrap_or((reference, reference));
        let closure = &self.reference.machine.closure;
        // Whole turns of an angle look alike, unless something is prepared over the range only.
        let turns = input.dimension.half_lengths == 0
            && closure.coupled.is_empty()
            && closure.valued.is_empty();
        let (from, to) = match turns {
            true => (reference - TAU, reference + TAU),
            false => (low, high),
        };
        let [from, to] = [from, to].map(|end| self.reach(at.input, input.dimension, end));
        let angle = input.dimension.half_lengths == 0;
        let ([a, b], step) = rounded_inwards([from, to], reference, [low, high], angle);
        let show = |x| words.rounded_to(input.dimension, x, step);
        Works {
            fact: [a, b].map(show),
            range: [a.max(low), b.min(high)].map(show),
        }
    }

    /// Returns the angles of a group, if all of them turn evenly with the input from the reference
    /// to its change point.
    fn even(&mut self, algebra: &Algebra, at: &Break) -> Option<Vec<ConstantRatio>> {
        let mechanism = algebra.mechanism;
        if mechanism.inputs[at.input].dimension.half_lengths != 0 {
            return None;
        }
        let (from, to) = (
            self.nominal.inputs[at.input],
            at.dead_point.inputs[at.input],
        );
        let outputs = self.reference.machine.closure.groups[at.dead_point.group]
            .unknowns
            .clone();
        let mut inputs = self.nominal.inputs.clone();
        let mut even = Vec::new();
        for (unknown, output) in outputs {
            let Bound::Angle(_) = algebra.names.bound[unknown] else {
                return None;
            };
            let estimate = self.nominal.estimates[unknown][0];
            let mut angle = |ranges: &mut Self, x: f64, near: f64| {
                inputs[at.input] = x;
                let machine = &ranges.reference.machine;
                machine.run_staged(&mut ranges.program, &inputs);
                let [cos, sin] = [output, output + 1].map(|k| ranges.program.output(k));
                Ternary::AngleNear.apply([sin, cos, near])
            };
            let here = angle(self, from, estimate);
            let rate = constant_ratio::candidate_rates(&algebra.names, at.input)
                .into_iter()
                .find(|rate| {
                    // Short of the change point itself, where digits are lost.
                    (1..COMPARED).all(|k| {
                        let x = from + (to - from) * (k as f64 / COMPARED as f64);
                        let expected = here + rate * (x - from);
                        (angle(self, x, expected) - expected).abs() < ALIKE
                    })
                })?;
            let offset = here - rate * from;
            even.push(ConstantRatio {
                unknown,
                rate,
                offset,
            });
        }
        (!even.is_empty()).then_some(even)
    }
}

/// A stretch of an input in which the mechanism works: the exact one, and the one to write.
struct Works {
    fact: [String; 2],
    range: [String; 2],
}

/// Returns a message of the fact and of the advice.
fn with_help([fact, help]: &[String; 2]) -> String {
    format!("{fact}\nhelp: {help}")
}

/// Finds links that stay parallel to others up to the change point: relations state this without a
/// second assembly.
fn parallelogram(
    mechanism: &Mechanism,
    words: &MessageFormat,
    at: &Break,
    loops: &[usize],
    even: &[ConstantRatio],
    reaches: &Reaches,
) -> String {
    let input = &mechanism.inputs[at.input].name;
    let relations: Vec<String> = even
        .iter()
        .map(|ratio| {
            let name = &mechanism.unknowns[ratio.unknown].name;
            format!("`let {name} = {};`", ratio.relation(input))
        })
        .collect();
    let instead = match even.len() {
        1 => "unknown",
        _ => "unknowns",
    };
    let written = mechanism.loops[loops[0]].of.is_none();
    // Loops are links, joints close them.
    let is = match (written, reaches.group.several) {
        (true, false) => "is",
        (true, true) => "are",
        (false, false) => "closes",
        (false, true) => "close",
    };
    let numbers = range_check::loop_list(&loop_numbers(loops));
    let help = match written {
        true => format!(
            "if it stays a parallelogram, write {} instead of the {instead} and leave {numbers} out; else {}",
            relations.join(" and "),
            reaches.range(),
        ),
        false => format!(
            "{}; if it stays a parallelogram, write it with loops, which `linkage loops FILE` prints, and {} instead of the {instead} and of {numbers}",
            reaches.range(),
            relations.join(" and "),
        ),
    };
    format!(
        "the mechanism comes apart in this range: {} ({}) {is} a parallelogram, and at {} it reaches its change point, where all links lie in \
         line and it may go on as a crossed one; {}\n\
         help: {help}",
        reaches.group.loops,
        reaches.group.unknowns,
        words.inputs(&at.dead_point.inputs, &[at.input]),
        reaches.works(),
    )
}
