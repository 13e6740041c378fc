//! Requested quantities as graph nodes: values, derivatives, sensitivities, margins.

use linkage_symbolic::{Ex, SymbolId, Vector, Vn};

use crate::algebra::derivatives::{dependence, direction, links, rotation_variation};
use crate::algebra::{
    Algebra, Direction, Names, Shortcuts, Translate, Value, frame, scalar, translate, via_slider,
};
use crate::forces::{Forces, Question, quantities};
use crate::model::{EvaluatorDef, Expr, ExprKind, Type, VECTORS_OF_PLANE, Variable};
use crate::solve::Formulation;

use super::state::State;

/// The results of one function.
#[derive(Debug, Default)]
pub(super) struct Requested<'m> {
    /// All scalars in the order of the fields.
    pub(super) scalars: Vec<Ex<'m>>,
    /// The quantities before they were differentiated: they determine which inputs the function is
    /// about.
    pub(super) underlying: Vec<Ex<'m>>,
    /// Inputs that the function differentiates by.
    pub(super) variables: Vec<usize>,
    /// The quantities that it differentiates by parameters, each once.
    pub(super) sensed: Vec<Ex<'m>>,
}

/// The method by which a function computes its results; all strategies have equal results.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Strategy {
    /// The direction of derivatives by parameters.
    pub(super) direction: Direction,
    /// True if points at the ends of links are reached by the other sides of the loops that the
    /// links close.
    pub(super) other_sides: bool,
    /// The shortcuts that derivatives use.
    pub(super) shortcuts: Shortcuts,
}

/// Returns the results that a function requests, as expressions.
pub(super) fn request<'m>(
    state: &mut State<'_, 'm>,
    definition: &EvaluatorDef,
    strategy: Strategy,
) -> Requested<'m> {
    let algebra = &mut *state.algebra;
    let (solutions, derivatives) = (&mut algebra.solutions, &mut algebra.derivatives);
    if links::use_shortcuts(solutions, derivatives, strategy.shortcuts) {
        state.forces.forget_derivatives();
    }
    let mut request = Request {
        algebra: &mut *state.algebra,
        forces: &mut *state.forces,
        drawn: &state.drawn,
        definition,
        strategy,
        margin: None,
        asks_margin: false,
        with_reactions: definition.asks_for_reactions(),
        requested: Requested::default(),
    };
    let scalars = request.all();
    if !request.asks_margin {
        request.requested.scalars = scalars;
        return request.requested;
    }
    // The other quantities determine the groups over which the margin is taken.
    let margin = request.margin_over(state.formulation, &scalars);
    request.margin = Some(margin);
    request.requested = Requested::default();
    request.requested.scalars = request.all();
    request.requested
}

struct Request<'a, 'm> {
    algebra: &'a mut Algebra<'m>,
    forces: &'a mut Forces<'m>,
    /// The vectors that `picture()` shows.
    drawn: &'a [Vn<'m>],
    definition: &'a EvaluatorDef,
    strategy: Strategy,
    /// The smallest margin; `None` while it is not known yet.
    margin: Option<Ex<'m>>,
    asks_margin: bool,
    with_reactions: bool,
    requested: Requested<'m>,
}

impl<'m> Request<'_, 'm> {
    fn all(&mut self) -> Vec<Ex<'m>> {
        let mut scalars = Vec::new();
        for quantity in &self.definition.quantities {
            let mut value = self.translate(&quantity.value);
            value = self.by_other_sides(value);
            if !quantity.is_picture() {
                value = self.in_unit(value, &quantity.value.ty);
            }
            if let (Type::PlaneFrame, Value::Array(parts)) = (&quantity.value.ty, &mut value) {
                // The angle of a plane frame follows from its axes.
                parts.truncate(VECTORS_OF_PLANE);
            }
            self.flatten(&value, &mut scalars);
        }
        self.requested.underlying.extend(&scalars);
        scalars
    }

    /// The same by the other sides of loops, if that is the strategy.
    fn by_other_sides(&mut self, value: Value<'m>) -> Value<'m> {
        match value {
            value if !self.strategy.other_sides => value,
            Value::Vector(vector) if vector.len() == 2 => {
                let plane = Vector([vector.at(0), vector.at(1)]);
                Value::Vector(
                    via_slider::via_sliders(
                        &self.algebra.names,
                        &mut self.algebra.solutions,
                        plane,
                    )
                    .into(),
                )
            }
            Value::Array(entries) => {
                let entries = entries.into_iter();
                Value::Array(entries.map(|entry| self.by_other_sides(entry)).collect())
            }
            other => other,
        }
    }

    /// Returns a value that the program has computed in the unit in which the result is given.
    fn in_unit(&self, value: Value<'m>, ty: &Type) -> Value<'m> {
        match (value, ty) {
            (Value::Array(entries), Type::Array(types)) => {
                let entries = entries.into_iter().zip(types);
                Value::Array(entries.map(|(entry, ty)| self.in_unit(entry, ty)).collect())
            }
            (value, ty) => divided(
                value,
                translate::internal_per_unit(self.algebra.mechanism, ty),
            ),
        }
    }

    fn flatten(&self, value: &Value<'m>, scalars: &mut Vec<Ex<'m>>) {
        match value {
            Value::Scalar(scalar) => scalars.push(scalar::value_of(&self.algebra.names, scalar)),
            Value::Vector(vector) => scalars.extend(vector.iter()),
            Value::Array(entries) => entries
                .iter()
                .for_each(|entry| self.flatten(entry, scalars)),
        }
    }

    /// Returns the smallest margin of the groups that `scalars` use; if they use none, of the
    /// groups that the function's inputs determine, else of all. At most 1: rounding may not go
    /// beyond.
    fn margin_over(&mut self, formulation: &Formulation<'m>, scalars: &[Ex<'m>]) -> Ex<'m> {
        let mut groups = formulation.groups_of(self.algebra, scalars);
        let margin_of = |group: usize| formulation.groups[group].closed.margin;
        if groups.is_empty() {
            let listed = &self.definition.inputs;
            let all = 0..formulation.groups.len();
            let mut determined = |group: &usize| {
                let inputs = dependence::inputs_below(
                    self.algebra.graph,
                    &mut self.algebra.derivatives.dependence,
                    &[margin_of(*group)],
                );
                inputs.iter().all(|input| listed.contains(input))
            };
            groups = all.clone().filter(&mut determined).collect();
            if groups.is_empty() {
                groups = all.collect();
            }
        }
        let one = self.algebra.one();
        groups
            .into_iter()
            .map(margin_of)
            .fold(one, |least, margin| match least == margin {
                true => least,
                false => least.min(margin),
            })
    }

    fn derivative(&mut self, value: &Value<'m>, variable: Variable) -> Value<'m> {
        match variable {
            Variable::Input(input) => self.requested.variables.push(input),
            Variable::Parameter(_) => {
                let mut scalars = Vec::new();
                self.flatten(value, &mut scalars);
                let sensed = &mut self.requested.sensed;
                let known = sensed.len();
                scalars.retain(|x| !sensed[..known].contains(x));
                sensed.extend(scalars);
            }
        }
        let symbol = self.algebra.variable(variable);
        let (direction, ty) = match variable {
            Variable::Input(_) => (Direction::Forward, None),
            Variable::Parameter(id) => {
                let parameter = &self.algebra.mechanism.scalar_parameters[id.0];
                (
                    self.strategy.direction,
                    Some(Type::Scalar(parameter.dimension)),
                )
            }
        };
        let slope = self.slope(value, symbol, direction);
        // The derivative is with respect to the field, which is given in its own unit.
        let field_unit = ty.map_or(1.0, |ty| {
            translate::internal_per_unit(self.algebra.mechanism, &ty)
        });
        divided(slope, field_unit)
    }

    fn slope(&mut self, value: &Value<'m>, variable: SymbolId, direction: Direction) -> Value<'m> {
        let algebra = &mut *self.algebra;
        match value {
            Value::Scalar(scalar) => {
                let x = scalar::value_of(&algebra.names, scalar);
                direction::derivative(algebra, x, variable, direction).into()
            }
            Value::Vector(vector) => Value::Vector(
                vector.map(|x| direction::derivative(algebra, x, variable, direction)),
            ),
            Value::Array(entries) => {
                let entries = entries.iter();
                let slopes = entries.map(|entry| self.slope(entry, variable, direction));
                Value::Array(slopes.collect())
            }
        }
    }

    /// Returns the quantity to be differentiated; its dependencies count even if those of the
    /// derivative do not.
    fn underlying(&mut self, quantity: &Expr) -> Value<'m> {
        let value = self.translate(quantity);
        let value = self.by_other_sides(value);
        let mut scalars = Vec::new();
        self.flatten(&value, &mut scalars);
        self.requested.underlying.extend(scalars);
        value
    }

    /// Returns the derivative of an order by all inputs of the function: nested arrays if there are
    /// several.
    fn by_inputs(&mut self, value: &Value<'m>, order: u8) -> Value<'m> {
        if order == 0 {
            return value.clone();
        }
        self.by_each_input(|request, input| {
            let slope = request.derivative(value, Variable::Input(input));
            request.by_inputs(&slope, order - 1)
        })
    }

    /// The turning of a frame by all inputs of the function, and the derivatives of that.
    fn turning(&mut self, frame: &Value<'m>, order: u8) -> Value<'m> {
        self.by_each_input(|request, input| {
            let variable = request.algebra.variable(Variable::Input(input));
            let turning =
                match rotation_variation::rotation_of_frame(request.algebra, frame, variable) {
                    Some(turn) => turn,
                    None => {
                        let slope = request.derivative(frame, Variable::Input(input));
                        frame::turning_of_frame(&request.algebra.names, frame, &slope)
                    }
                };
            request.by_inputs(&turning, order - 1)
        })
    }

    fn by_each_input(
        &mut self,
        mut derivative: impl FnMut(&mut Self, usize) -> Value<'m>,
    ) -> Value<'m> {
        let drives = 0..self.algebra.mechanism.inputs.len();
        let inputs = self.definition.inputs.iter().copied();
        let inputs: Vec<usize> = inputs.filter(|input| drives.contains(input)).collect();
        let mut entries = inputs.iter().map(|&input| derivative(self, input));
        match inputs.len() {
            1 => entries.next().expect("one entry"),
            _ => Value::Array(entries.collect()),
        }
    }
}

impl<'m> Translate<'m> for Request<'_, 'm> {
    fn names(&mut self) -> &mut Names<'m> {
        &mut self.algebra.names
    }

    fn quantity(&mut self, expr: &Expr) -> Value<'m> {
        match &expr.kind {
            ExprKind::Derivative(quantity, variables) => {
                let value = self.underlying(quantity);
                variables
                    .iter()
                    .fold(value, |value, &variable| self.derivative(&value, variable))
            }
            ExprKind::InputDerivative(quantity, order) => {
                let value = self.underlying(quantity);
                match quantity.ty {
                    Type::Frame => self.turning(&value, *order),
                    _ => self.by_inputs(&value, *order),
                }
            }
            ExprKind::Sensitivity(quantity, parameters) => {
                let value = self.underlying(quantity);
                let entries = parameters
                    .iter()
                    .map(|&parameter| self.derivative(&value, Variable::Parameter(parameter)));
                Value::Array(entries.collect())
            }
            ExprKind::Mechanics(quantity) => {
                // The whole motion counts, even if the values depend on no input or speed. A load
                // must matter.
                let listed = &self.definition.inputs;
                let mechanism = self.algebra.mechanism;
                let motion = listed.iter().filter(|&&input| !mechanism.is_load(input));
                self.requested.variables.extend(motion);
                let question = Question::new(mechanism, listed, self.with_reactions);
                quantities::quantity(self.algebra, self.forces, &question, quantity)
            }
            ExprKind::Picture(_) => {
                let vectors = self.drawn.iter().copied();
                Value::Array(vectors.map(Value::Vector).collect())
            }
            ExprKind::Margin => {
                self.asks_margin = true;
                let one = self.algebra.one();
                self.margin.unwrap_or(one).into()
            }
            ExprKind::Number(_)
            | ExprKind::Name(_)
            | ExprKind::Vector(_)
            | ExprKind::Component(..)
            | ExprKind::Index(..)
            | ExprKind::Negate(_)
            | ExprKind::Binary(..)
            | ExprKind::Call(..)
            | ExprKind::MotionLaw(_)
            | ExprKind::Error => unreachable!("no quantity: translated as it stands"),
        }
    }
}

/// A value in a unit that is `divisor` times the one before.
fn divided(value: Value, divisor: f64) -> Value {
    if divisor == 1.0 {
        return value;
    }
    match value {
        Value::Scalar(scalar) => Value::Scalar(scalar.scaled(1.0 / divisor)),
        Value::Vector(vector) => {
            let factor = vector.at(0).number(1.0 / divisor);
            Value::Vector(factor * vector)
        }
        Value::Array(entries) => {
            let entries = entries.into_iter();
            Value::Array(entries.map(|entry| divided(entry, divisor)).collect())
        }
    }
}
