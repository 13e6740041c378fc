//! Arguments: loads and speeds that functions take at run time.

use super::names::Resolver;
use super::passes::Taken;
use super::place::{Context, Place};
use super::types::{Argument, Dimension, Expr, Input, Name, Type};
use crate::syntax::NamedItem;

impl Resolver<'_> {
    /// All arguments in the order of their names; speeds and accelerations stand at their inputs.
    pub(super) fn arguments(
        &mut self,
        items: &[(usize, Taken)],
        inputs: &[Input],
    ) -> Vec<Argument> {
        let mut arguments = Vec::new();
        let mut input = 0;
        for (position, item) in items {
            match item {
                Taken::Argument(item) => {
                    let argument = self.argument_item(item, arguments.len(), *position);
                    arguments.push(argument);
                }
                Taken::Rates(item) => {
                    let rates = [&item.speed, &item.acceleration];
                    for (order, ident) in (1..).zip(rates) {
                        let Some(ident) = ident else { continue };
                        let name = Name::Argument(arguments.len());
                        let dimension = rate(inputs[input].dimension, order);
                        self.set_type(name, Type::Scalar(dimension), false);
                        arguments.push(Argument {
                            name: ident.to_string(),
                            dimension,
                            reference: None,
                        });
                    }
                    input += 1;
                }
            }
        }
        arguments
    }

    /// `argument NAME = value;`
    fn argument_item(&mut self, item: &NamedItem, index: usize, position: usize) -> Argument {
        let context = Context {
            place: Place::Argument,
            item: position,
        };
        let mut reference = self.expression(&item.value, context);
        self.refuse_frame_item(&mut reference, "an argument is a scalar");
        let bare_zero = matches!(reference.ty, Type::Zero(1));
        let mut ty = self.declared(Name::Argument(index), &reference.ty);
        reference.settle(&ty);
        if !matches!(ty, Type::Scalar(_) | Type::Error) {
            let fact = format!("an argument is a scalar, found {ty}");
            let help = "declare one argument for each component";
            self.diagnostics
                .error_with_help(item.value.span, fact, help);
            ty = Type::Error;
        }
        let dimension = ty.dimension().unwrap_or(Dimension::NUMBER);
        self.set_type(Name::Argument(index), ty, bare_zero);
        Argument {
            name: item.name.to_string(),
            dimension,
            reference: Some(reference),
        }
    }

    /// Remembers what the next derived quantity is made of.
    pub(super) fn note_let(&mut self, value: &Expr) {
        self.arguments_of_lets.push(self.argument_below(value));
        self.courses_of_lets.push(self.course_of(value).cloned());
    }

    /// An argument that a value depends on, perhaps through derived quantities.
    pub(super) fn argument_below(&self, value: &Expr) -> Option<usize> {
        let mut names = value.parts().filter_map(Expr::as_name);
        names.find_map(|name| match name {
            Name::Argument(argument) => Some(argument),
            Name::Let(index) => self.arguments_of_lets.get(index).copied()?,
            Name::Const(_) | Name::Parameter(_) | Name::Input(_) | Name::Unknown(_) | Name::Pi => {
                None
            }
        })
    }

    /// Reports what must be known before functions are called and depends on an argument.
    pub(super) fn refuse_argument(&mut self, value: &mut Expr, what: &str) {
        let Some(argument) = self.argument_below(value) else {
            return;
        };
        let name = Name::Argument(argument);
        let symbol = self.symbols.iter().find(|symbol| symbol.name == name);
        let text = symbol.map_or("", |symbol| symbol.text.as_str());
        let fact = format!("{what} depends on the argument `{text}`");
        let help = "nothing that moves depends on arguments: declare a `param` or an `input`";
        let span = self.origins.span(value.origin);
        self.diagnostics.error_with_help(span, fact, help);
        *value = self.failed(span);
    }
}

/// The dimension of a speed (1) or acceleration (2).
pub(super) fn rate(of: Dimension, order: i32) -> Dimension {
    Dimension {
        half_times: of.half_times - 2 * order,
        ..of
    }
}
