//! Requested quantities as graph nodes: values, derivatives, sensitivities, margins.

use linkage_symbolic::program::Binary;
use linkage_symbolic::{NodeId, SymbolId};

use crate::algebra::{Algebra, Direction, Translate, Value};
use crate::forces::Forces;
use crate::formulate::Formulation;
use crate::model::{EvaluatorDef, Expr, ExprKind, Type, Variable};

/// What one function computes.
#[derive(Debug, Default)]
pub(super) struct Requested {
    /// All scalars in the order of the fields.
    pub(super) nodes: Vec<NodeId>,
    /// The quantities before they were differentiated: they tell which inputs the function is about.
    pub(super) underlying: Vec<NodeId>,
    /// Inputs that the function differentiates by.
    pub(super) variables: Vec<usize>,
    /// Whether it differentiates by parameters.
    pub(super) by_parameters: bool,
}

pub(super) fn request<'m>(
    (algebra, forces, formulation): (&mut Algebra<'m>, &mut Forces, &Formulation),
    definition: &EvaluatorDef,
    direction: Direction,
) -> Requested {
    let mut request = Request {
        algebra,
        forces,
        definition,
        direction,
        margin: None,
        asks_margin: false,
        with_reactions: definition.asks_for_reactions(),
        requested: Requested::default(),
    };
    let nodes = request.all();
    if !request.asks_margin {
        request.requested.nodes = nodes;
        return request.requested;
    }
    // Which groups the margin is taken over follows from the other quantities.
    let margin = request.margin_over(formulation, &nodes);
    request.margin = Some(margin);
    request.requested = Requested::default();
    request.requested.nodes = request.all();
    request.requested
}

struct Request<'a, 'm> {
    algebra: &'a mut Algebra<'m>,
    forces: &'a mut Forces,
    definition: &'a EvaluatorDef,
    /// How derivatives by parameters are found.
    direction: Direction,
    /// The smallest margin; `None` while it is not known yet.
    margin: Option<NodeId>,
    asks_margin: bool,
    with_reactions: bool,
    requested: Requested,
}

impl Request<'_, '_> {
    fn all(&mut self) -> Vec<NodeId> {
        let mut nodes = Vec::new();
        for quantity in &self.definition.quantities {
            let mut value = self.translate(&quantity.value);
            if !quantity.is_picture() {
                value = self.in_unit(value, &quantity.value.ty);
            }
            self.flatten(&value, &mut nodes);
        }
        self.requested.underlying.extend(&nodes);
        nodes
    }

    /// What the program has computed in the unit in which the result is given.
    fn in_unit(&mut self, value: Value, ty: &Type) -> Value {
        match (value, ty) {
            (Value::Array(entries), Type::Array(types)) => {
                let entries = entries.into_iter().zip(types);
                Value::Array(entries.map(|(entry, ty)| self.in_unit(entry, ty)).collect())
            }
            (value, ty) => {
                let scale = self.algebra.internal_per_unit(ty);
                self.divided(value, scale)
            }
        }
    }

    fn divided(&mut self, value: Value, divisor: f64) -> Value {
        if divisor == 1.0 {
            return value;
        }
        match value {
            Value::Scalar(scalar) => Value::Scalar(self.algebra.scale(&scalar, 1.0 / divisor)),
            Value::Vector(components) => {
                let graph = &mut self.algebra.graph;
                let factor = graph.constant(1.0 / divisor);
                let components = components.into_iter();
                Value::Vector(components.map(|x| graph.mul(factor, x)).collect())
            }
            Value::Array(entries) => {
                let entries = entries.into_iter();
                Value::Array(entries.map(|entry| self.divided(entry, divisor)).collect())
            }
        }
    }

    fn flatten(&mut self, value: &Value, nodes: &mut Vec<NodeId>) {
        match value {
            Value::Scalar(scalar) => nodes.push(self.algebra.node(scalar)),
            Value::Vector(components) => nodes.extend(components),
            Value::Array(entries) => entries.iter().for_each(|entry| self.flatten(entry, nodes)),
        }
    }

    /// The smallest margin of the groups that `nodes` use; if they use none, of the groups that the function's inputs
    /// determine, else of all. At most 1: rounding may not go beyond.
    fn margin_over(&mut self, formulation: &Formulation, nodes: &[NodeId]) -> NodeId {
        let mut groups = formulation.groups_of(self.algebra, nodes);
        let margin_of = |group: usize| formulation.groups[group].closed.margin;
        if groups.is_empty() {
            let listed = &self.definition.inputs;
            let all = 0..formulation.groups.len();
            let mut determined = |group: &usize| {
                let inputs = self.algebra.inputs_below(&[margin_of(*group)]);
                inputs.iter().all(|input| listed.contains(input))
            };
            groups = all.clone().filter(&mut determined).collect();
            if groups.is_empty() {
                groups = all.collect();
            }
        }
        let one = self.algebra.graph.one();
        groups
            .into_iter()
            .map(margin_of)
            .fold(one, |least, margin| match least == margin {
                true => least,
                false => self.algebra.graph.binary(Binary::Min, least, margin),
            })
    }

    fn derivative(&mut self, value: &Value, variable: Variable) -> Value {
        match variable {
            Variable::Input(input) => self.requested.variables.push(input),
            Variable::Parameter(_) => self.requested.by_parameters = true,
        }
        let symbol = self.algebra.variable(variable);
        let (direction, ty) = match variable {
            Variable::Input(_) => (Direction::Forward, None),
            Variable::Parameter(id) => {
                let parameter = &self.algebra.mechanism.scalar_parameters[id.0];
                (self.direction, Some(Type::Scalar(parameter.dimension)))
            }
        };
        let slope = self.slope(value, symbol, direction);
        // By the field, which is given in its own unit.
        let field_unit = ty.map_or(1.0, |ty| self.algebra.internal_per_unit(&ty));
        self.divided(slope, field_unit)
    }

    fn slope(&mut self, value: &Value, variable: SymbolId, direction: Direction) -> Value {
        match value {
            Value::Scalar(scalar) => {
                let node = self.algebra.node(scalar);
                let slope = self.algebra.derivative(node, variable, direction);
                Value::Scalar(slope.into())
            }
            Value::Vector(components) => Value::Vector(
                components
                    .iter()
                    .map(|&x| self.algebra.derivative(x, variable, direction))
                    .collect(),
            ),
            Value::Array(entries) => Value::Array(
                entries
                    .iter()
                    .map(|entry| self.slope(entry, variable, direction))
                    .collect(),
            ),
        }
    }

    /// The quantity to be differentiated; what it depends on counts even if the derivative does not.
    fn underlying(&mut self, quantity: &Expr) -> Value {
        let value = self.translate(quantity);
        let mut nodes = Vec::new();
        self.flatten(&value, &mut nodes);
        self.requested.underlying.extend(nodes);
        value
    }

    /// The derivative of an order by all inputs of the function: nested arrays if there are several.
    fn by_inputs(&mut self, value: &Value, order: u8) -> Value {
        if order == 0 {
            return value.clone();
        }
        let drives = 0..self.algebra.mechanism.inputs.len();
        let inputs = self.definition.inputs.iter().copied();
        let inputs: Vec<usize> = inputs.filter(|input| drives.contains(input)).collect();
        let mut entries = inputs.iter().map(|&input| {
            let slope = self.derivative(value, Variable::Input(input));
            self.by_inputs(&slope, order - 1)
        });
        match inputs.len() {
            1 => entries.next().expect("one entry"),
            _ => Value::Array(entries.collect()),
        }
    }
}

impl<'m> Translate<'m> for Request<'_, 'm> {
    fn algebra(&mut self) -> &mut Algebra<'m> {
        self.algebra
    }

    fn quantity(&mut self, expr: &Expr) -> Value {
        match &expr.kind {
            ExprKind::Derivative(quantity, variables) => {
                let value = self.underlying(quantity);
                variables
                    .iter()
                    .fold(value, |value, &variable| self.derivative(&value, variable))
            }
            ExprKind::InputDerivative(quantity, order) => {
                let value = self.underlying(quantity);
                self.by_inputs(&value, *order)
            }
            ExprKind::Sensitivity(quantity, parameters) => {
                let value = self.underlying(quantity);
                let entries = parameters
                    .iter()
                    .map(|&parameter| self.derivative(&value, Variable::Parameter(parameter)));
                Value::Array(entries.collect())
            }
            ExprKind::Mechanics(quantity) => {
                // About the whole motion, whether the values depend on an input or a speed or not. A load must matter.
                let listed = &self.definition.inputs;
                let mechanism = self.algebra.mechanism;
                let motion = listed.iter().filter(|&&input| !mechanism.is_load(input));
                self.requested.variables.extend(motion);
                let mut mechanics = self.forces.at(self.algebra, listed, self.with_reactions);
                mechanics.quantity(quantity)
            }
            ExprKind::Picture(_) => {
                let vectors = self.algebra.pictured.iter().cloned();
                Value::Array(vectors.map(Value::Vector).collect())
            }
            _ => {
                self.asks_margin = true;
                let one = self.algebra.graph.one();
                Value::Scalar(self.margin.unwrap_or(one).into())
            }
        }
    }
}
