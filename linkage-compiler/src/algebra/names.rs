//! Names of the model in the graph: unknowns as symbols, derived names as values.

use linkage_symbolic::lookup::Map;
use linkage_symbolic::program::Source;
use linkage_symbolic::{Ex, Graph, NodeId, SymbolId, V2, V3, Vector};

use crate::algebra::value::{Atom, Value};
use crate::model::{COMPONENTS, Mechanism, Type};

/// An unknown angle. Loops see its cosine and sine; its value is computed only where somebody asks
/// for it.
#[derive(Clone, Debug)]
pub(crate) struct Angle<'m> {
    pub(crate) cos: SymbolId,
    pub(crate) sin: SymbolId,
    pub(crate) value: SymbolId,
    /// Cosine and sine.
    pub(crate) unit: V2<'m>,
    /// The angle itself.
    pub(crate) number: Ex<'m>,
    /// The model's unknown; `None` for an angle that the compiler introduced.
    pub(crate) unknown: Option<usize>,
    /// For an angle that the compiler introduced in place of another.
    pub(crate) stands_for: Option<StandsFor>,
    /// The estimate, if it is no unknown and stands for none.
    pub(crate) estimated: f64,
    /// The direction of a link that the compiler introduced, where the points that it joins are
    /// estimated.
    pub(crate) drawn: f64,
    /// The direction near which it stays, if its closed form has one.
    pub(crate) reference: Option<AngleReference<'m>>,
}

/// The unknowns that an introduced angle stands for.
#[derive(Clone, Debug)]
pub(crate) struct StandsFor {
    /// The unknown in whose place it stands.
    pub(crate) unknown: usize,
    /// The unknowns of which it is the sum, with their signs.
    pub(crate) summands: Vec<(usize, f64)>,
}

impl Angle<'_> {
    /// All of its symbols.
    pub(crate) fn symbols(&self) -> [SymbolId; 3] {
        [self.cos, self.sin, self.value]
    }
}

/// The symbols of an unknown of the model.
#[derive(Clone, Debug)]
pub(crate) enum Bound<'m> {
    Angle(usize),
    /// A slide, or the components of an unknown point.
    Lengths(Vec<(SymbolId, Ex<'m>)>),
}

/// A component of a vector that a body carries.
#[derive(Clone, Debug)]
pub(crate) struct BodyVector<'m> {
    /// The body's two directions.
    pub(crate) axes: [V3<'m>; 2],
    pub(crate) vector: V3<'m>,
    pub(crate) component: usize,
    /// Its coordinates on the body.
    pub(crate) coordinates: V3<'m>,
}

/// The symbols and values of the model's names: all that a translation of expressions uses.
#[derive(Clone, Debug)]
pub(crate) struct Names<'m> {
    pub(crate) mechanism: &'m Mechanism,
    pub(crate) graph: &'m Graph,
    pub(crate) angles: Vec<Angle<'m>>,
    /// The symbols of each unknown.
    pub(crate) bound: Vec<Bound<'m>>,
    pub(crate) lets: Vec<Option<Value<'m>>>,
    pub(crate) constants: Vec<Option<Value<'m>>>,
    /// Factors with which input angles turn vectors.
    turning: Vec<(Atom, f64)>,
    /// The vectors that bodies carry, by component.
    pub(crate) body_vectors: Map<NodeId, BodyVector<'m>>,
}

impl<'m> Names<'m> {
    pub(crate) fn new(mechanism: &'m Mechanism, graph: &'m Graph) -> Self {
        let mut names = Self {
            mechanism,
            graph,
            angles: Vec::new(),
            bound: Vec::new(),
            lets: vec![None; mechanism.lets.len()],
            constants: vec![None; mechanism.constants.len()],
            turning: Vec::new(),
            body_vectors: Map::default(),
        };
        for (index, unknown) in mechanism.unknowns.iter().enumerate() {
            let name = &unknown.name;
            let bound = match unknown.ty {
                Type::Scalar(dimension) if dimension.half_lengths == 0 => {
                    Bound::Angle(names.add_angle(name, Some(index)))
                }
                Type::Vector(count, _) => Bound::Lengths(
                    COMPONENTS[..count]
                        .iter()
                        .map(|axis| names.symbol(format!("{name}.{axis}")))
                        .collect(),
                ),
                Type::Scalar(_)
                | Type::Zero(_)
                | Type::Array(_)
                | Type::Frame
                | Type::PlaneFrame
                | Type::Error => Bound::Lengths(vec![names.symbol(name.clone())]),
            };
            names.bound.push(bound);
        }
        names
    }

    /// Runs `question`, then undoes all its changes to the graph and to the names.
    pub(crate) fn tried<R>(&mut self, question: impl FnOnce(&mut Self) -> R) -> R {
        let (graph, names) = (self.graph.snapshot(), self.clone());
        let answer = question(self);
        self.graph.restore(graph);
        *self = names;
        answer
    }

    /// Returns the value of an input.
    pub(crate) fn input(&self, index: usize) -> Ex<'m> {
        self.source(Source::Input(index))
    }

    /// Returns the value that a program loads from `source`.
    pub(crate) fn source(&self, source: Source) -> Ex<'m> {
        self.graph.ex(self.graph.source(source))
    }

    pub(crate) fn zero(&self) -> Ex<'m> {
        self.graph.number(0.0)
    }

    pub(crate) fn one(&self) -> Ex<'m> {
        self.graph.number(1.0)
    }

    fn symbol(&self, name: String) -> (SymbolId, Ex<'m>) {
        let (symbol, node) = self.graph.unknown(name);
        (symbol, self.graph.ex(node))
    }

    /// Returns the number of components of an unknown of the model.
    pub(crate) fn components_of(&self, unknown: usize) -> usize {
        match &self.bound[unknown] {
            Bound::Angle(_) => 1,
            Bound::Lengths(symbols) => symbols.len(),
        }
    }

    /// Cosine and sine of an unknown angle, the components of a length or point.
    pub(crate) fn numbers_of(&self, unknown: usize) -> Vec<Ex<'m>> {
        match &self.bound[unknown] {
            Bound::Angle(angle) => self.angles[*angle].unit.components().collect(),
            Bound::Lengths(symbols) => symbols.iter().map(|(_, node)| *node).collect(),
        }
    }

    /// A new unknown angle.
    pub(crate) fn add_angle(&mut self, name: &str, unknown: Option<usize>) -> usize {
        let (cos, cosine) = self.symbol(format!("cos {name}"));
        let (sin, sine) = self.symbol(format!("sin {name}"));
        let (value, number) = self.symbol(name.to_owned());
        self.graph.pair(cos, sin);
        self.angles.push(Angle {
            cos,
            sin,
            value,
            unit: Vector([cosine, sine]),
            number,
            unknown,
            stands_for: None,
            estimated: 0.0,
            drawn: 0.0,
            reference: None,
        });
        self.angles.len() - 1
    }

    /// Remembers that vectors turn with an input angle times a factor.
    pub(crate) fn add_rate(&mut self, input: Atom, factor: f64) {
        if !self.turning.contains(&(input, factor)) {
            self.turning.push((input, factor));
        }
    }

    /// The factors with which an input angle turns vectors (gear ratios).
    pub(crate) fn input_rates(&self, input: Atom) -> impl Iterator<Item = f64> {
        let turning = self.turning.iter();
        turning
            .filter(move |(atom, _)| *atom == input)
            .map(|(_, k)| *k)
    }
}

/// A vector that an angle keeps within a quarter turn of, wherever its group can be assembled.
///
/// A closed form says that the vector `z u`, which the angle turns, is `a B + w h C` with a root
/// `h`, where `B` and `C` are perpendicular: it never gets from the side of `w C` to the other one.
#[derive(Clone, Copy, Debug)]
pub(crate) struct AngleReference<'m> {
    /// `C`, or where that is `across`, `C` turned by -90 degrees.
    pub(crate) vector: V2<'m>,
    pub(crate) across: bool,
    /// `w`, 1 or -1 by the assembly, and whether its opposite is meant.
    pub(crate) mode: Ex<'m>,
    pub(crate) opposite: bool,
    /// The vector that `u` turns. Without one, the direction is that of `u` itself.
    pub(crate) z: Option<V2<'m>>,
    /// The sense: -1 if `u` turns with the negative angle.
    pub(crate) sense: f64,
}

/// A vector `coefficient e^(i a)`, where `a` is a sum of angles.
#[derive(Clone, Debug)]
pub(crate) struct Phasor<'m> {
    pub(crate) coefficient: V2<'m>,
    /// The turns for each input, with their factors; `None` where something else turns it, too.
    pub(crate) rates: Option<Vec<(usize, f64)>>,
}
