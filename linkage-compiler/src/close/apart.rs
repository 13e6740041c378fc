//! What is said of a mechanism that comes apart in its range: dead points, change points.

use std::f64::consts::TAU;

use linkage_symbolic::program::Ternary;

use crate::algebra::{ALIKE, Algebra, Bound, Even};
use crate::diagnostic::OriginId;
use crate::formulate::Solved;
use crate::model::Mechanism;
use crate::words::loop_list;

use super::check::range_of;
use super::dead_point::DeadPoint;
use super::ranges::{Break, Broken, GRID, Ranges};
use crate::words::Words;

/// Ends of a range that are proposed are this share of it inside the dead point, rounded to a power of ten.
const INSIDE: f64 = 1e-4;

/// Positions between the reference and a change point at which angles are compared.
const COMPARED: usize = 8;

/// A message with the words it underlines.
pub(super) struct Apart {
    pub(super) origins: [OriginId; 2],
    pub(super) message: String,
}

impl<'m> Ranges<'_, 'm> {
    /// A range that meets a dead point.
    pub(super) fn apart(&mut self, algebra: &mut Algebra<'m>, at: Break) -> Apart {
        let words = Words::new(algebra.mechanism);
        let input = &algebra.mechanism.inputs[at.input];
        let solved = &self.formulation.groups[at.place.group];
        let concerned = algebra.inputs_below(&[solved.closed.slack]);
        let place = words.inputs(&at.place.inputs, &concerned);
        if !at.place.finite {
            return Apart {
                origins: range_of(input),
                message: not_finite(&words, solved, &place, ""),
            };
        }
        let miss = self.largest_miss(&at);
        let even = match miss == 0.0 {
            true => self.even(algebra, &at),
            false => None,
        };
        let works = self.works(algebra, &words, &at);
        let message = match even {
            Some(even) => parallelogram(algebra.mechanism, &words, &at, solved, &even, &works),
            None => {
                let picture = DeadPoint {
                    algebra,
                    machine: &self.reference.machine,
                    words: &words,
                    solved,
                    inputs: &at.place.inputs,
                    reference: &self.nominal.inputs,
                    miss,
                }
                .picture();
                let picture = picture.map_or_else(String::new, |picture| format!(", {picture}"));
                let (point, beyond, other) = match miss == 0.0 {
                    true => (
                        "change",
                        "; there two of its assemblies meet, and it may go on in either",
                        "change a length so that they do not meet",
                    ),
                    false => (
                        "dead",
                        "",
                        "change the lengths so that the links reach each other all the way",
                    ),
                };
                let Works { fact, range } = works;
                format!(
                    "{} a {point} point at {place}{picture}{beyond}; {fact}\nhelp: {range}, or {other}",
                    comes_apart(&words, solved),
                )
            }
        };
        Apart {
            origins: range_of(input),
            message,
        }
    }

    /// A position of a grid over several ranges that does not close.
    pub(super) fn apart_on_grid(
        &mut self,
        algebra: &mut Algebra<'m>,
        declared: &[usize],
        at: &Broken,
    ) -> Apart {
        let words = Words::new(algebra.mechanism);
        let solved = &self.formulation.groups[at.group];
        let concerned = algebra.inputs_below(&[solved.closed.slack]);
        let mut declared = declared.iter();
        let input = declared.clone().find(|k| concerned.contains(k));
        let input = input.or_else(|| declared.next());
        let origin = algebra.mechanism.loops[solved.group.written].origin;
        let place = words.inputs(&at.inputs, &concerned);
        let how = format!(" (found on a grid of at most {GRID} positions)");
        let message = match at.finite {
            true => format!(
                "{} a dead point at {place}{how}\n\
                 help: restrict the range, or change the lengths so that the links reach each other all the way",
                comes_apart(&words, solved),
            ),
            false => not_finite(&words, solved, &place, &how),
        };
        Apart {
            origins: input.map_or([origin; 2], |&k| range_of(&algebra.mechanism.inputs[k])),
            message,
        }
    }

    /// The stretch around the reference in which it works.
    fn works(&mut self, algebra: &Algebra, words: &Words, at: &Break) -> Works {
        let input = &algebra.mechanism.inputs[at.input];
        let reference = self.nominal.inputs[at.input];
        let (low, high) = self.nominal.ranges[at.input].unwrap_or((reference, reference));
        let closing = &self.reference.machine.closing;
        // Whole turns of an angle look alike, unless something is prepared over the range only.
        let turns = input.dimension.half_lengths == 0
            && closing.coupled.is_empty()
            && closing.valued.is_empty();
        let (from, to) = match turns {
            true => (reference - TAU, reference + TAU),
            false => (low, high),
        };
        let [from, to] = [from, to].map(|end| self.reach(at.input, input.dimension, end));
        let unit = match input.dimension.half_lengths {
            0 => 1.0_f64.to_radians(),
            _ => 1.0,
        };
        let step = unit * 10.0_f64.powf(((to - from) * INSIDE / unit).log10().floor());
        let inside = |x: f64, towards: f64, end: f64| match x == end {
            true => x,
            false if towards < x => (x / step).floor() * step,
            false => (x / step).ceil() * step,
        };
        let [a, b] = [inside(from, reference, low), inside(to, reference, high)];
        let show = |x| words.rounded_to(input.dimension, x, step);
        Works {
            fact: format!(
                "around the reference it works from {} to {}",
                show(a),
                show(b)
            ),
            range: format!("write `in {}..{}`", show(a.max(low)), show(b.min(high))),
        }
    }

    /// The angles of a group, if all of them turn evenly with the input from the reference to its change point.
    fn even(&mut self, algebra: &Algebra, at: &Break) -> Option<Vec<Even>> {
        let mechanism = algebra.mechanism;
        if mechanism.inputs[at.input].dimension.half_lengths != 0 {
            return None;
        }
        let (from, to) = (self.nominal.inputs[at.input], at.place.inputs[at.input]);
        let outputs = self.reference.machine.closing.groups[at.place.group]
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
                machine.run(&mut ranges.values, &inputs);
                let [cos, sin] = [output, output + 1].map(|k| machine.output(&ranges.values, k));
                Ternary::AngleNear.apply([sin, cos, near])
            };
            let here = angle(self, from, estimate);
            let rate = algebra.candidate_rates(at.input).into_iter().find(|rate| {
                // Short of the change point itself, where digits are lost.
                (1..COMPARED).all(|k| {
                    let x = from + (to - from) * (k as f64 / COMPARED as f64);
                    let expected = here + rate * (x - from);
                    (angle(self, x, expected) - expected).abs() < ALIKE
                })
            })?;
            let offset = here - rate * from;
            even.push(Even {
                unknown,
                rate,
                offset,
            });
        }
        (!even.is_empty()).then_some(even)
    }
}

/// A stretch of an input in which the mechanism works, as a fact and as what to write.
struct Works {
    fact: String,
    range: String,
}

/// `the mechanism comes apart in this range: loop 1 (`theta`, `psi`) reaches`
fn comes_apart(words: &Words, solved: &Solved) -> String {
    let reach = match solved.group.loops.len() {
        1 => "reaches",
        _ => "reach",
    };
    format!(
        "the mechanism comes apart in this range: {} ({}) {reach}",
        loop_list(&solved.group.loops),
        words.unknowns(&solved.group.unknowns),
    )
}

/// A group whose equations have no finite value at a place.
fn not_finite(words: &Words, solved: &Solved, place: &str, how: &str) -> String {
    format!(
        "{} a division by zero, or a root or an arc function out of its range at {place}{how}\n\
         help: restrict the range, or change what is not a finite number beyond it",
        comes_apart(words, solved),
    )
}

/// Links that stay parallel to others as far as the change point: relations say so without a second assembly.
fn parallelogram(
    mechanism: &Mechanism,
    words: &Words,
    at: &Break,
    solved: &Solved,
    even: &[Even],
    works: &Works,
) -> String {
    let input = &mechanism.inputs[at.input].name;
    let relations: Vec<String> = even
        .iter()
        .map(|own| {
            let name = &mechanism.unknowns[own.unknown].name;
            format!("`let {name} = {};`", own.relation(input))
        })
        .collect();
    let loops = loop_list(&solved.group.loops);
    let is = match solved.group.loops.len() {
        1 => "is",
        _ => "are",
    };
    let instead = match even.len() {
        1 => "unknown",
        _ => "unknowns",
    };
    format!(
        "the mechanism comes apart in this range: {loops} ({}) {is} a parallelogram, and at {} it reaches its change point, where all links lie in \
         line and it may go on as a crossed one; {}\n\
         help: if it stays a parallelogram, write {} instead of the {instead} and leave {loops} out; else {}",
        words.unknowns(&solved.group.unknowns),
        words.inputs(&at.place.inputs, &[at.input]),
        works.fact,
        relations.join(" and "),
        works.range,
    )
}
