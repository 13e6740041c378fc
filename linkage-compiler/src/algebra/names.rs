//! What the names of the model are in the graph: unknowns as symbols, derived names as values.

use linkage_symbolic::{Ex, Graph, SymbolId, V2, Vector};

use crate::model::{COMPONENTS, Mechanism, Type};

use super::{AngleReference, Atom, Value};

/// An unknown angle. Loops see its cosine and sine; its value is computed only where somebody asks for it.
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
    /// Where it is estimated if it is no unknown and stands for none.
    pub(crate) estimated: f64,
    /// Where its closed form says so.
    pub(crate) bearing: Option<AngleReference<'m>>,
}

/// What an introduced angle stands for.
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

/// What an unknown of the model stands for.
#[derive(Clone, Debug)]
pub(crate) enum Bound<'m> {
    Angle(usize),
    /// A slide, or the components of an unknown point.
    Lengths(Vec<(SymbolId, Ex<'m>)>),
}

/// What the names of the model stand for.
#[derive(Clone, Debug)]
pub(crate) struct Names<'m> {
    graph: &'m Graph,
    pub(crate) angles: Vec<Angle<'m>>,
    /// By unknown.
    pub(crate) bound: Vec<Bound<'m>>,
    pub(super) lets: Vec<Option<Value<'m>>>,
    pub(super) constants: Vec<Option<Value<'m>>>,
    /// Factors with which input angles turn vectors.
    turning: Vec<(Atom, f64)>,
}

impl<'m> Names<'m> {
    pub(super) fn new(mechanism: &Mechanism, graph: &'m Graph) -> Self {
        let mut names = Self {
            graph,
            angles: Vec::new(),
            bound: Vec::new(),
            lets: vec![None; mechanism.lets.len()],
            constants: vec![None; mechanism.constants.len()],
            turning: Vec::new(),
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

    fn symbol(&self, name: String) -> (SymbolId, Ex<'m>) {
        let (symbol, node) = self.graph.unknown(name);
        (symbol, self.graph.ex(node))
    }

    /// How many numbers an unknown of the model has.
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
            bearing: None,
        });
        self.angles.len() - 1
    }

    /// Remembers that vectors turn with an input angle times a factor.
    pub(super) fn add_rate(&mut self, input: Atom, factor: f64) {
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
