//! The functions of the `impl` block: names that do not collide, inputs, quantities.

use std::collections::BTreeMap;

use proc_macro2::Ident;

use super::functions::MotionWord;
use super::generated::{ASSEMBLY, COLUMNS, FOLLOWER, Sweep};
use super::names::{Resolver, kind};
use super::operators::settle_alone;
use super::place::{Context, Place};
use super::types::{EvaluatorDef, Name, Quantity};
use crate::diagnostic::text::{list, nearest};
use crate::diagnostic::{OriginId, SourceSpan};
use crate::syntax::{
    Expr, ExprKind, FunctionDef, Item, MechanismDef, QuantityDef, Word, documentation,
};

/// Names taken so far: where, and by what if not by the user's own word.
type Taken = BTreeMap<String, (SourceSpan, Option<String>)>;

impl Resolver<'_> {
    pub(super) fn functions(&mut self, definition: &MechanismDef) -> Vec<EvaluatorDef> {
        self.check_function_names(definition);
        self.check_type_names(definition);
        let functions = definition.functions.iter();
        let functions: Vec<_> = functions.map(|function| self.function(function)).collect();
        self.check_one_picture(&functions);
        functions
    }

    /// Two functions of one name, or one with the name of a generated one.
    fn check_function_names(&mut self, definition: &MechanismDef) {
        let mut taken = Taken::new();
        for function in &definition.functions {
            self.check_reserved(&function.name);
            self.take(&mut taken, &function.name, "function");
        }
        for function in &definition.functions {
            for sweep in Sweep::all() {
                let generated = format!("{}{}", function.name, sweep.word());
                if let Some((span, _)) = taken.get(&generated).cloned() {
                    let fact = format!(
                        "the function `{generated}` is also generated for `{}`",
                        function.name
                    );
                    self.diagnostics
                        .error_with_help(span, fact, "choose another name");
                }
            }
        }
    }

    fn check_type_names(&mut self, definition: &MechanismDef) {
        let name = &definition.name;
        self.check_type_parameter(name);
        let mut taken = Taken::new();
        let span = SourceSpan::from(name);
        taken.insert(name.to_string(), (span, Some("the mechanism".to_owned())));
        let assembly = Some(format!("the assembly of `{name}`"));
        taken.insert(format!("{name}{ASSEMBLY}"), (span, assembly));
        let inputs = definition.items.iter();
        let inputs = inputs.filter(|item| matches!(item, Item::Input(_)));
        if inputs.count() > 1 {
            let follower = Some(format!("the follower of `{name}`"));
            taken.insert(format!("{name}{FOLLOWER}"), (span, follower));
        }
        for function in &definition.functions {
            self.check_reserved(&function.result);
            self.check_new_type(&function.result);
            self.take(&mut taken, &function.result, "result type");
        }
        for function in &definition.functions {
            let generated = format!("{}{COLUMNS}", function.result);
            if let Some((span, owner)) = taken.get(&generated).cloned() {
                let fact = format!(
                    "the type `{generated}` is also generated for sweeps of `{}`",
                    function.name
                );
                let span = if owner.is_some() {
                    (&function.result).into()
                } else {
                    span
                };
                self.diagnostics
                    .error_with_help(span, fact, "choose another name");
            }
        }
    }

    fn take(&mut self, taken: &mut Taken, ident: &Ident, what: &str) {
        let text = ident.to_string();
        match taken.get(&text).cloned() {
            None => {
                taken.insert(text, (ident.into(), None));
            }
            Some((first, None)) => {
                let fact = format!("the {what} `{text}` is named twice");
                self.duplicate(&fact, &text, ident.into(), first);
            }
            Some((_, Some(owner))) => {
                let fact = format!("the {what} `{text}` has the name of {owner}");
                self.diagnostics
                    .error_with_help(ident.into(), fact, "choose another name");
            }
        }
    }

    fn function(&mut self, function: &FunctionDef) -> EvaluatorDef {
        let inputs: Vec<Option<usize>> = function
            .inputs
            .iter()
            .map(|ident| self.argument(ident))
            .collect();
        let repeated = self.check_repeated(&function.inputs);
        let sound: Option<Vec<usize>> = inputs.iter().copied().collect();
        let sound = sound.filter(|_| !repeated);
        let place = Place::Function(sound.as_deref());
        let context = Context {
            place,
            item: usize::MAX,
        };
        let mut fields = BTreeMap::new();
        let quantities = function
            .quantities
            .iter()
            .map(|quantity| self.quantity(quantity, &mut fields, context))
            .collect();
        EvaluatorDef {
            name: function.name.to_string(),
            documentation: documentation(&function.attributes),
            result: function.result.to_string(),
            inputs: inputs.into_iter().flatten().collect(),
            input_origins: self.argument_origins(function),
            quantities,
            origin: self.origins.add((&function.name).into()),
        }
    }

    fn argument_origins(&mut self, function: &FunctionDef) -> Vec<OriginId> {
        function
            .inputs
            .iter()
            .map(|ident| self.origins.add(ident.into()))
            .collect()
    }

    fn argument(&mut self, ident: &Ident) -> Option<usize> {
        let text = ident.to_string();
        let inputs = self.names_of(|name| matches!(name, Name::Input(_) | Name::Argument(_)));
        let fact = match self.find(&text) {
            Some(symbol) => match symbol.name {
                Name::Input(input) => return Some(input),
                Name::Argument(argument) => return Some(self.input_count + argument),
                other => format!("`{text}` is {}, not an input", kind(other)),
            },
            None => format!("unknown input `{text}`"),
        };
        let others = inputs.iter().copied().filter(|input| *input != text);
        let help = match nearest(&text, others) {
            Some(input) => format!("did you mean `{input}`?"),
            None if inputs.is_empty() => "the mechanism has no input: write `()`".to_owned(),
            None => format!("inputs are {}", list(&inputs)),
        };
        self.diagnostics.error_with_help(ident.into(), fact, help);
        None
    }

    fn check_repeated(&mut self, inputs: &[Ident]) -> bool {
        let mut repeated = false;
        for (index, ident) in inputs.iter().enumerate() {
            if inputs[..index].contains(ident) {
                let fact = format!("the input `{ident}` is listed twice");
                self.diagnostics
                    .error_with_help(ident.into(), fact, "leave one of them out");
                repeated = true;
            }
        }
        repeated
    }

    fn quantity(
        &mut self,
        quantity: &QuantityDef,
        fields: &mut BTreeMap<String, SourceSpan>,
        context: Context,
    ) -> Quantity {
        let field = quantity.field.to_string();
        self.check_reserved_field(quantity);
        let span = SourceSpan::from(&quantity.field);
        match fields.get(&field) {
            Some(first) => {
                let fact = format!("the field `{field}` is listed twice");
                self.duplicate(&fact, &field, span, *first);
            }
            None => {
                fields.insert(field.clone(), span);
            }
        }
        let mut value = match self.picture_call(&quantity.value, context) {
            Some(picture) => picture,
            None => self.expression(&quantity.value, context),
        };
        settle_alone(&mut value);
        Quantity {
            field,
            documentation: documentation(&quantity.attributes),
            value,
            written: written(&quantity.value),
            subject: written(subject(&quantity.value)),
            origin: self.origins.add(span),
        }
    }

    /// The shorthand `__a` is reported where `__a` is declared.
    fn check_reserved_field(&mut self, quantity: &QuantityDef) {
        if self.find(&quantity.field.to_string()).is_none() {
            self.check_reserved(&quantity.field);
        }
    }
}

/// What is differentiated, below all derivatives.
fn subject(value: &Expr) -> &Expr {
    match &value.kind {
        ExprKind::Call(function, arguments) => {
            let word = MotionWord::from_word(&function.to_string());
            match (
                word.is_some_and(MotionWord::differentiates),
                arguments.first(),
            ) {
                (true, Some(inner)) => subject(inner),
                _ => value,
            }
        }
        _ => value,
    }
}

/// An expression as text, without parentheses around all of it.
fn written(value: &Expr) -> String {
    let text = value.to_string();
    match (&value.kind, text.strip_prefix('(')) {
        (ExprKind::Binary(..) | ExprKind::Negate(_), Some(rest)) => {
            rest.strip_suffix(')').unwrap_or(rest).to_owned()
        }
        _ => text,
    }
}
