//! Lines along which points slide.

use linkage_symbolic::NodeId;

use crate::algebra::Translate;
use crate::model::{BinaryOp, Expr, ExprKind, Function, Type};

use super::GuideOn;
use super::chains::{Line, Segment, Shape, Sketch};
use super::links::Links;
use super::seen::Seen;

/// Unit vectors whose product misses 1 by less point along one line: 4e-5 radians, far above rounding, far below any angle that is meant.
const PARALLEL: f64 = 1e-9;

pub(super) struct Guides {
    pub(super) all: Vec<RawGuide>,
}

pub(super) struct RawGuide {
    pub(super) name: String,
    /// Points, each the first of those that coincide.
    pub(super) origin: usize,
    pub(super) slider: usize,
    pub(super) along: Vec<NodeId>,
    pub(super) on: GuideOn,
}

/// A guide before it is known what carries it.
struct Candidate {
    name: String,
    origin: usize,
    slider: usize,
    along: Vec<NodeId>,
}

impl Guides {
    pub(super) fn find(sketch: &mut Sketch, seen: &mut Seen, links: &Links) -> Self {
        let mut candidates = Vec::new();
        for segment in sketch.segments.clone() {
            let (from, to) = (seen.same[segment.from], seen.same[segment.to]);
            if from != to && !seen.keep_distance(from, to) {
                candidates.extend(sketch.slide(&segment, seen));
            }
        }
        for line in sketch.lines.clone() {
            candidates.push(sketch.candidate(line));
        }
        let known = seen.same.len();
        seen.add(sketch.algebra, &sketch.points[known..]);

        let mut guides = Self { all: Vec::new() };
        for candidate in candidates {
            guides.add(candidate, sketch, seen, links);
        }
        guides
    }

    /// Whether a point slides or lies on a guide.
    pub(super) fn have(&self, point: usize) -> bool {
        let mut guides = self.all.iter();
        guides.any(|guide| guide.slider == point || guide.origin == point)
    }

    /// Adds a guide unless it is known.
    fn add(&mut self, candidate: Candidate, sketch: &Sketch, seen: &Seen, links: &Links) {
        let (origin, slider) = (seen.same[candidate.origin], seen.same[candidate.slider]);
        let along = seen.track(sketch.algebra, &candidate.along);
        if along.iter().flatten().any(|x| !x.is_finite()) {
            return;
        }
        let known = self.all.iter().any(|guide| {
            let other = seen.track(sketch.algebra, &guide.along);
            guide.slider == slider && parallel(&along, &other)
        });
        if known {
            return;
        }
        let mut each = links.all.iter();
        let carrier = each.position(|link| {
            let mut points = link.points.iter();
            points.all(|&point| {
                seen.keep_distance(point, origin) && seen.carries(point, origin, &along)
            })
        });
        let on = match carrier {
            _ if seen.is_fixed(origin) && seen.is_steady(&along) => GuideOn::Frame,
            Some(link) => GuideOn::Link(link),
            None => GuideOn::Itself,
        };
        self.all.push(RawGuide {
            name: candidate.name,
            origin,
            slider,
            along: candidate.along,
            on,
        });
    }
}

impl<'m> Sketch<'_, 'm> {
    /// The guide of a segment that changes its length.
    fn slide(&mut self, segment: &Segment<'m>, seen: &Seen) -> Option<Candidate> {
        let (mut origin, mut slider) = (segment.from, segment.to);
        let from = self.points[segment.from].nodes.clone();
        let (offset, along) = match segment.shape {
            Shape::Term(sign, term) => {
                let (offset, along) = self.direction_of(term)?;
                (
                    offset.map(|offset| self.scaled_by_sign(offset, sign)),
                    along,
                )
            }
            Shape::Distance => {
                let to = self.points[segment.to].nodes.clone();
                // A cylinder hangs on its fixed end.
                if seen.is_fixed(slider) {
                    (origin, slider) = (slider, origin);
                }
                let rod = self.algebra.difference(&to, &from);
                (None, self.unit(&rod))
            }
            Shape::Body => return None,
        };
        if let Some(offset) = offset {
            let graph = &mut self.algebra.graph;
            let pairs = from.into_iter().zip(offset);
            let nodes = pairs.map(|(a, b)| graph.add(a, b)).collect();
            origin = self.point(nodes);
        }
        let name = segment.title.as_ref().map(|title| title.text.clone());
        Some(Candidate {
            name: name.unwrap_or_else(|| "slide".to_owned()),
            origin,
            slider,
            along,
        })
    }

    /// Along which unit vector a term changes its length, and what it contains across that.
    fn direction_of(&mut self, term: &'m Expr) -> Option<(Option<Vec<NodeId>>, Vec<NodeId>)> {
        match &term.kind {
            ExprKind::Call(Function::Polar, arguments) => {
                let angle = self.algebra.translate(&arguments[1]);
                let unit = self.algebra.call(Function::Dir, vec![angle]);
                Some((None, self.algebra.components(&unit)))
            }
            ExprKind::Binary(BinaryOp::Mul, a, b) => {
                let vector = if matches!(a.ty, Type::Vector(..)) {
                    a
                } else {
                    b
                };
                let vector = self.vector(vector);
                Some((None, self.unit(&vector)))
            }
            ExprKind::Vector(components) => {
                let (varying, rest) = self.varying(components)?;
                let (zero, one) = (self.algebra.graph.zero(), self.algebra.graph.one());
                let mut along = vec![zero; self.dimension];
                along[varying] = one;
                Some((Some(rest), along))
            }
            ExprKind::Call(function @ (Function::Rotate | Function::Turn), arguments) => {
                let ExprKind::Vector(components) = &arguments[0].kind else {
                    return None;
                };
                let (varying, rest) = self.varying(components)?;
                let (zero, one) = (self.algebra.graph.zero(), self.algebra.graph.one());
                let mut along = vec![zero; self.dimension];
                along[varying] = one;
                let mut turned = |vector: Vec<NodeId>| {
                    let others = arguments[1..].iter().map(|own| self.algebra.translate(own));
                    let mut values = vec![crate::algebra::Value::Vector(vector)];
                    values.extend(others.collect::<Vec<_>>());
                    let value = self.algebra.call(*function, values);
                    self.algebra.components(&value)
                };
                let (rest, along) = (turned(rest), turned(along));
                Some((Some(rest), along))
            }
            // Of anything else nobody knows along what it changes.
            _ => None,
        }
    }

    /// The one component that changes, and the vector without it.
    fn varying(&mut self, components: &'m [Expr]) -> Option<(usize, Vec<NodeId>)> {
        let mut nodes: Vec<NodeId> = components
            .iter()
            .map(|own| {
                let value = self.algebra.translate(own);
                self.algebra.as_node(&value)
            })
            .collect();
        let changes =
            (0..nodes.len()).filter(|&k| !self.algebra.inputs_below(&[nodes[k]]).is_empty());
        let changes: Vec<usize> = changes.collect();
        let [varying] = changes[..] else { return None };
        nodes[varying] = self.algebra.graph.zero();
        Some((varying, nodes))
    }

    /// A guide whose origin is the point of the line that is nearest to the carrier's point.
    fn candidate(&mut self, line: Line) -> Candidate {
        let zero = self.algebra.graph.zero();
        let base = match line.carrier {
            Some(carrier) => self.points[carrier].nodes.clone(),
            None => vec![zero; self.dimension],
        };
        let slider = self.points[line.slider].nodes.clone();
        let arm = self.algebra.difference(&slider, &base);
        let reach = self.algebra.dot(&arm, &line.along);
        let graph = &mut self.algebra.graph;
        let pairs = slider.into_iter().zip(&line.along);
        let foot = pairs.map(|(x, &d)| {
            let along = graph.mul(reach, d);
            graph.sub(x, along)
        });
        let foot = foot.collect();
        let origin = self.point(foot);
        Candidate {
            name: line.name,
            origin,
            slider: line.slider,
            along: line.along,
        }
    }

    fn scaled_by_sign(&mut self, vector: Vec<NodeId>, sign: f64) -> Vec<NodeId> {
        match sign > 0.0 {
            true => vector,
            false => vector
                .into_iter()
                .map(|x| self.algebra.graph.neg(x))
                .collect(),
        }
    }

    pub(super) fn unit(&mut self, vector: &[NodeId]) -> Vec<NodeId> {
        match vector[..] {
            [x, y, z] => self.algebra.unit_vector([x, y, z]).to_vec(),
            _ => self
                .algebra
                .length_and_unit([vector[0], vector[1]])
                .1
                .to_vec(),
        }
    }
}

/// Whether two unit vectors always point along one line.
fn parallel(a: &[Vec<f64>], b: &[Vec<f64>]) -> bool {
    a.iter().zip(b).all(|(a, b)| {
        let along: f64 = a.iter().zip(b).map(|(x, y)| x * y).sum();
        (1.0 - along.abs()).abs() < PARALLEL
    })
}
