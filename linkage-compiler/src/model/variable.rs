//! What one differentiates by: inputs, scalar parameters, components of vector parameters.

use proc_macro2::Ident;

use super::names::Resolver;
use super::parameter::COMPONENTS;
use super::place::{Context, Place};
use super::types::{Name, ScalarParameterId, Type, Variable};
use crate::diagnostic::SourceSpan;
use crate::diagnostic::text::list;
use crate::syntax;

/// Functions may use all names.
const IN_FUNCTIONS: Context = Context {
    place: Place::Function(None),
    item: usize::MAX,
};

impl Resolver<'_> {
    /// A variable of `d`; `None` after a report.
    pub(super) fn variable(&mut self, expr: &syntax::Expr) -> Option<Variable> {
        let (text, field) = match &expr.kind {
            syntax::ExprKind::Error => return None,
            syntax::ExprKind::Number { .. } => {
                return self.not_a_variable("a constant", expr.span);
            }
            syntax::ExprKind::Field(value, field) => {
                match (self.dotted(expr), self.dotted(value)) {
                    (Some(text), _) => (text, None),
                    (None, Some(text)) => (text, Some(field)),
                    (None, None) => return self.not_a_variable("an expression", expr.span),
                }
            }
            _ => match self.dotted(expr) {
                Some(text) => (text, None),
                None => return self.not_a_variable("an expression", expr.span),
            },
        };
        let Some((name, ty, kind)) = self
            .find(&text)
            .map(|symbol| (symbol.name, symbol.ty.clone(), symbol.kind()))
        else {
            if text == "PI" {
                return self.not_a_variable("a constant", expr.span);
            }
            match &expr.kind {
                syntax::ExprKind::Name(ident) if !self.is_part(&text) => {
                    self.unknown_name(ident, None)
                }
                // It is reported as any other name that a part does not have.
                _ => drop(self.expression(expr, IN_FUNCTIONS)),
            }
            return None;
        };
        if ty.is_error() {
            return None;
        }
        match (name, field) {
            (Name::Input(input), None) => Some(Variable::Input(input)),
            (Name::Parameter(parameter), _) => {
                let scalars = self.scalars(&text, parameter, &ty, field)?;
                match scalars[..] {
                    [scalar] => Some(Variable::Parameter(scalar)),
                    _ => {
                        let fact = format!("derivative with respect to `{text}`, a vector");
                        let help = format!("name a component, like `{text}.x`");
                        self.diagnostics.error_with_help(expr.span, fact, help);
                        None
                    }
                }
            }
            _ => self.not_a_variable(&format!("`{text}`, {kind}"), expr.span),
        }
    }

    fn not_a_variable<T>(&mut self, what: &str, span: SourceSpan) -> Option<T> {
        let inputs = self.names_of(|name| matches!(name, Name::Input(_)));
        let parameters: Vec<&str> = self
            .scalar_parameters
            .iter()
            .map(|scalar| scalar.name.as_str())
            .collect();
        let variables = [&inputs[..], &parameters[..]].concat();
        let help = match variables.is_empty() {
            true => "declare an `input` or a `param`".to_owned(),
            false => format!("variables are {}", list(&variables)),
        };
        let fact = format!("derivative with respect to {what}");
        self.diagnostics.error_with_help(span, fact, help);
        None
    }

    /// The scalar parameters of a parameter, or one of its components.
    fn scalars(
        &mut self,
        text: &str,
        parameter: usize,
        ty: &Type,
        field: Option<&Ident>,
    ) -> Option<Vec<ScalarParameterId>> {
        let all = self.scalar_parameters.iter().enumerate();
        let mine = all.filter(|(_, scalar)| scalar.parameter == parameter);
        let mine: Vec<_> = mine.map(|(index, _)| ScalarParameterId(index)).collect();
        let Some(field) = field else {
            return Some(mine);
        };
        let component = COMPONENTS.iter().position(|component| field == component);
        match component.and_then(|component| mine.get(component)) {
            Some(scalar) if mine.len() > 1 => Some(vec![*scalar]),
            _ => {
                let fact = format!("`{text}`, {ty}, has no component `{field}`");
                let help = match mine.len() {
                    1 => format!("write `{text}`"),
                    count => format!("components are `.{}`", COMPONENTS[..count].join("`, `.")),
                };
                self.diagnostics.error_with_help(field.into(), fact, help);
                None
            }
        }
    }

    pub(super) fn all_parameters(&mut self, span: SourceSpan) -> Option<Vec<ScalarParameterId>> {
        if self
            .symbols
            .iter()
            .any(|symbol| matches!(symbol.name, Name::Parameter(_)))
        {
            return Some(
                (0..self.scalar_parameters.len())
                    .map(ScalarParameterId)
                    .collect(),
            );
        }
        let fact = "`sensitivity` in a mechanism without parameters";
        self.diagnostics
            .error_with_help(span, fact, "declare a `param`");
        None
    }

    /// `[crank, pivot_d.x]`; a vector stands for its components.
    pub(super) fn listed_parameters(
        &mut self,
        expr: &syntax::Expr,
    ) -> Option<Vec<ScalarParameterId>> {
        let syntax::ExprKind::List(entries) = &expr.kind else {
            let fact = "expected a list of parameters";
            let help = "write them in brackets: `[crank, rocker]`";
            self.diagnostics.error_with_help(expr.span, fact, help);
            return None;
        };
        if entries.is_empty() {
            let fact = "the list of parameters is empty";
            let help = "leave it out for all parameters";
            self.diagnostics.error_with_help(expr.span, fact, help);
            return None;
        }
        let mut found = Vec::new();
        let mut sound = true;
        for entry in entries {
            match self.listed(entry) {
                Some(scalars) if scalars.iter().any(|scalar| found.contains(scalar)) => {
                    let fact = "a parameter is listed twice";
                    self.diagnostics
                        .error_with_help(entry.span, fact, "leave one of them out");
                    sound = false;
                }
                Some(scalars) => found.extend(scalars),
                None => sound = false,
            }
        }
        sound.then_some(found)
    }

    fn listed(&mut self, entry: &syntax::Expr) -> Option<Vec<ScalarParameterId>> {
        let text = self.dotted(entry);
        if let Some(text) = &text
            && let Some(symbol) = self.find(text)
            && let Name::Parameter(parameter) = symbol.name
        {
            let ty = symbol.ty.clone();
            return if ty.is_error() {
                None
            } else {
                self.scalars(text, parameter, &ty, None)
            };
        }
        if let Some(text) = &text
            && let Some(symbol) = self.find(text)
            && !matches!(symbol.name, Name::Input(_))
            && !symbol.ty.is_error()
        {
            let fact = format!(
                "a sensitivity is with respect to parameters, found {}",
                symbol.kind()
            );
            let parameters = self.names_of(|name| matches!(name, Name::Parameter(_)));
            let help = match parameters.is_empty() {
                true => "declare a `param`".to_owned(),
                false => format!("parameters are {}", list(&parameters)),
            };
            self.diagnostics.error_with_help(entry.span, fact, help);
            return None;
        }
        match self.variable(entry)? {
            Variable::Parameter(scalar) => Some(vec![scalar]),
            Variable::Input(_) => {
                let fact = "a sensitivity is with respect to parameters, found an input";
                let help = "write `d(q, x)` for the derivative with respect to an input";
                self.diagnostics.error_with_help(entry.span, fact, help);
                None
            }
        }
    }
}
