//! `d`, `velocity`, `acceleration`, `jerk`, `omega`, `alpha`, the screw of a frame, `sensitivity`, `margin`, `picture`: only in the functions of the `impl` block.

use proc_macro2::Ident;

use super::functions::{MotionWord, QuantityWord};
use super::names::Resolver;
use super::place::{Context, Place};
use super::types::{Dimension, Expr, ExprKind, Name, Type, Variable};
use crate::diagnostic::SourceSpan;
use crate::diagnostic::text::count;
use crate::syntax::{self, Word};

/// Most entries of an array, those of inner arrays counted.
const ENTRY_LIMIT: usize = 10_000;

impl Resolver<'_> {
    pub(super) fn quantity_call(
        &mut self,
        word: QuantityWord,
        ident: &Ident,
        arguments: &[syntax::Expr],
        context: Context,
        span: SourceSpan,
    ) -> Expr {
        let Place::Function(inputs) = context.place else {
            let name = word.word();
            let fact = format!("`{name}` is only known in the functions of the `impl` block");
            let help = "move it there, as a quantity of a function";
            self.diagnostics.error_with_help(ident.into(), fact, help);
            return self.failed(span);
        };
        let word = match word {
            QuantityWord::Motion(word) => word,
            QuantityWord::Mechanics(word) => {
                return self.mechanics_call(word, arguments, context, span);
            }
        };
        match word {
            MotionWord::Margin => self.margin(arguments, span),
            MotionWord::Picture => self.picture_in_expression(span),
            MotionWord::Derivative => self.derivative(arguments, context, span),
            MotionWord::Sensitivity => self.sensitivity(arguments, context, span),
            MotionWord::Velocity
            | MotionWord::Acceleration
            | MotionWord::Jerk
            | MotionWord::Omega
            | MotionWord::Alpha => self.input_derivative(word, inputs, arguments, context, span),
            MotionWord::ScrewPoint | MotionWord::ScrewDirection | MotionWord::ScrewPitch => {
                self.screw(word, inputs, arguments, context, span)
            }
        }
    }

    fn margin(&mut self, arguments: &[syntax::Expr], span: SourceSpan) -> Expr {
        if !arguments.is_empty() {
            self.wrong_count("margin", &[], arguments.len(), span);
            return self.failed(span);
        }
        self.make(ExprKind::Margin, Type::NUMBER, span)
    }

    /// `d(q, x)`, `d(q, x, y)`
    fn derivative(
        &mut self,
        arguments: &[syntax::Expr],
        context: Context,
        span: SourceSpan,
    ) -> Expr {
        let Some(([quantity], variables)) = arguments.split_first_chunk::<1>() else {
            self.wrong_count("d", &["quantity", "x"], 0, span);
            return self.failed(span);
        };
        let value = self.differentiable(quantity, context);
        if !(1..=2).contains(&variables.len()) {
            let found = count(variables.len(), "variable");
            let fact = format!("`d` takes a quantity and one or two variables, found {found}");
            let help = "write `d(quantity, x)` or `d(quantity, x, y)`";
            self.diagnostics.error_with_help(span, fact, help);
            return self.failed(span);
        }
        let variables: Vec<_> = variables
            .iter()
            .map(|variable| self.variable(variable))
            .collect();
        let Some(variables) = variables.into_iter().collect::<Option<Vec<_>>>() else {
            return self.failed(span);
        };
        let mut ty = value.ty.clone();
        for variable in &variables {
            ty = self.by_variable(&ty, *variable);
        }
        self.finish(ExprKind::Derivative(Box::new(value), variables), ty, span)
    }

    fn sensitivity(
        &mut self,
        arguments: &[syntax::Expr],
        context: Context,
        span: SourceSpan,
    ) -> Expr {
        let (quantity, parameters) = match arguments {
            [quantity] => (quantity, self.all_parameters(span)),
            [quantity, list] => (quantity, self.listed_parameters(list)),
            _ => {
                let fact = format!(
                    "`sensitivity` takes a quantity and perhaps a list of parameters, found {}",
                    count(arguments.len(), "argument")
                );
                let help = "write `sensitivity(q)` or `sensitivity(q, [crank, rocker])`";
                self.diagnostics.error_with_help(span, fact, help);
                return self.failed(span);
            }
        };
        let value = self.differentiable(quantity, context);
        let Some(parameters) = parameters else {
            return self.failed(span);
        };
        if self.too_many_entries(&value.ty, parameters.len(), span) {
            return self.failed(span);
        }
        let variables = parameters
            .iter()
            .map(|parameter| Variable::Parameter(*parameter));
        let entries = variables
            .map(|variable| self.by_variable(&value.ty, variable))
            .collect();
        let kind = ExprKind::Sensitivity(Box::new(value), parameters);
        self.finish(kind, Type::Array(entries), span)
    }

    fn input_derivative(
        &mut self,
        word: MotionWord,
        inputs: Option<&[usize]>,
        arguments: &[syntax::Expr],
        context: Context,
        span: SourceSpan,
    ) -> Expr {
        let (name, order) = (word.word(), word.order().unwrap_or_default());
        let subject = if word.turns() { "frame" } else { "quantity" };
        let [quantity] = arguments else {
            self.wrong_count(name, &[subject], arguments.len(), span);
            return self.failed(span);
        };
        let value = match word.turns() {
            true => self.turning(name, quantity, context),
            false => self.differentiable(quantity, context),
        };
        // A mistake in the list of inputs has been reported.
        let Some(inputs) = inputs else {
            return self.failed(span);
        };
        let Some(inputs) = self.drives(name, inputs, span) else {
            return self.failed(span);
        };
        if word == MotionWord::Jerk && inputs.len() > 1 {
            let help = "differentiate an entry: `d(acceleration(q)[0][0], x)`";
            self.needs_one_input(name, inputs.len(), help, span);
            return self.failed(span);
        }
        let entries = inputs.len().pow(u32::from(order));
        if self.too_many_entries(&value.ty, entries, span) {
            return self.failed(span);
        }
        self.derivative_by(value, &inputs, order, span)
    }

    /// The inputs that a function lists among its arguments; that there is none is a mistake.
    pub(super) fn drives(
        &mut self,
        name: &str,
        arguments: &[usize],
        span: SourceSpan,
    ) -> Option<Vec<usize>> {
        let drives = arguments.iter().filter(|input| **input < self.input_count);
        let drives: Vec<usize> = drives.copied().collect();
        if drives.is_empty() {
            let fact = format!("`{name}` in a function without an input");
            let help = match self.names_of(|name| matches!(name, Name::Input(_))).first() {
                Some(input) => format!("list the input: `fn name({input})`"),
                None => "declare an `input` in the struct block".to_owned(),
            };
            self.diagnostics.error_with_help(span, fact, help);
            return None;
        }
        Some(drives)
    }

    pub(super) fn needs_one_input(
        &mut self,
        name: &str,
        count: usize,
        help: &str,
        span: SourceSpan,
    ) {
        let fact = format!("`{name}` needs one input, the function has {count}");
        self.diagnostics.error_with_help(span, fact, help);
    }

    /// The derivative by these inputs; of a frame that of the vector by which it turns.
    pub(super) fn derivative_by(
        &mut self,
        value: Expr,
        inputs: &[usize],
        order: u8,
        span: SourceSpan,
    ) -> Expr {
        let ty = match value.ty {
            Type::Frame => self.by_inputs(&Type::Vector(3, Dimension::ANGLE), inputs, order),
            _ => self.by_inputs(&value.ty, inputs, order),
        };
        self.finish(ExprKind::InputDerivative(Box::new(value), order), ty, span)
    }

    /// Derivatives of arrays multiply the numbers of entries.
    fn too_many_entries(&mut self, ty: &Type, factor: usize, span: SourceSpan) -> bool {
        let entries = leaves(ty).saturating_mul(factor);
        if entries > ENTRY_LIMIT {
            let fact = format!("an array of {entries} entries, more than {ENTRY_LIMIT}");
            let help = "differentiate single entries `[0]` or by a list of parameters";
            self.diagnostics.error_with_help(span, fact, help);
        }
        entries > ENTRY_LIMIT
    }

    /// The first argument: anything but an array literal or a frame; zero is a number.
    fn differentiable(&mut self, quantity: &syntax::Expr, context: Context) -> Expr {
        let mut value = self.expression(quantity, context);
        super::operators::settle_alone(&mut value);
        self.refuse_frame_derivative(value)
    }

    fn finish(&mut self, kind: ExprKind, ty: Type, span: SourceSpan) -> Expr {
        match ty.is_error() {
            true => self.failed(span),
            false => self.make(kind, ty, span),
        }
    }

    /// One input: the derivative itself; several: an array for each order.
    fn by_inputs(&self, ty: &Type, inputs: &[usize], order: u8) -> Type {
        if order == 0 {
            return ty.clone();
        }
        let by = |input: &usize| self.by_variable(ty, Variable::Input(*input));
        if let [input] = inputs {
            return self.by_inputs(&by(input), inputs, order - 1);
        }
        Type::Array(
            inputs
                .iter()
                .map(|input| self.by_inputs(&by(input), inputs, order - 1))
                .collect(),
        )
    }

    /// The type of a derivative: dimensions divide.
    fn by_variable(&self, ty: &Type, variable: Variable) -> Type {
        let Some(by) = self.dimension_of(variable) else {
            return Type::Error;
        };
        match ty {
            Type::Array(entries) => Type::Array(
                entries
                    .iter()
                    .map(|entry| self.by_variable(entry, variable))
                    .collect(),
            ),
            other => {
                let quotient = other.dimension().and_then(|dimension| dimension.over(by));
                quotient.map_or(Type::Error, |dimension| other.with(dimension))
            }
        }
    }

    fn dimension_of(&self, variable: Variable) -> Option<Dimension> {
        match variable {
            Variable::Parameter(scalar) => Some(self.scalar_parameters[scalar.0].dimension),
            Variable::Input(input) => {
                let symbol = self
                    .symbols
                    .iter()
                    .find(|symbol| symbol.name == Name::Input(input))?;
                symbol.ty.dimension()
            }
        }
    }
}

fn leaves(ty: &Type) -> usize {
    match ty {
        Type::Array(entries) => entries.iter().map(leaves).sum(),
        Type::Scalar(_)
        | Type::Vector(..)
        | Type::Frame
        | Type::PlaneFrame
        | Type::Zero(_)
        | Type::Error => 1,
    }
}
