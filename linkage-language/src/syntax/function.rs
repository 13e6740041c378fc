//! The functions of the `impl` block.

use proc_macro2::{Delimiter, Ident};

use super::ast::{Attribute, FunctionDef, QuantityDef};
use super::expression_tree::{Expr, ExprKind};
use super::parser::{Parsed, Parser};

impl Parser<'_> {
    /// Reads all functions up to the end of the block. Functions with a mistake are reported and
    /// left out.
    pub(super) fn functions(&mut self) -> Vec<FunctionDef> {
        let mut functions = Vec::new();
        while !self.stream.at_end() {
            match self.function() {
                Ok(function) => functions.push(function),
                Err(_) => self.skip_function(),
            }
        }
        functions
    }

    fn function(&mut self) -> Parsed<FunctionDef> {
        let attributes = self.attributes()?;
        let visibility = self.visibility();
        if !self.stream.eat_word("fn") {
            let help = "write `pub fn NAME(inputs) -> TYPE { quantities }`";
            return self.expected("a function", help);
        }
        let name = self.name("the name of the function")?;
        let inputs = self.arguments(&name)?;
        let result = self.result(&name)?;
        let Some(body) = self.stream.group(0, Delimiter::Brace).cloned() else {
            let help = "write the quantities between braces: `{ tracer, v: velocity(tracer) }`";
            return self.expected("`{`", help);
        };
        self.stream.skip(1);
        if body.stream().is_empty() {
            let fact = format!("the function `{name}` has no quantity");
            let help = "list what it computes between its braces";
            self.diagnostics.error_with_help((&name).into(), fact, help);
        }
        let quantities = self.within(&body, |parser| parser.quantities());
        Ok(FunctionDef {
            attributes,
            visibility,
            name,
            inputs,
            result,
            quantities,
        })
    }

    fn arguments(&mut self, function: &Ident) -> Parsed<Vec<Ident>> {
        let Some(group) = self.stream.group(0, Delimiter::Parenthesis).cloned() else {
            return self.expected(&format!("`(` after `{function}`"), "");
        };
        self.stream.skip(1);
        self.within(&group, |parser| {
            let mut inputs = Vec::new();
            while !parser.stream.at_end() {
                if parser.stream.is_punct(0, '&') || parser.stream.is_word(0, "self") {
                    let help = "list the inputs only: `(phi)`";
                    return parser.expected("the name of an input", help);
                }
                inputs.push(parser.name("the name of an input")?);
                if parser.stream.is_punct(0, ':') {
                    return parser.expected("`,` or `)`", "leave the type out: inputs are scalars");
                }
                if parser.stream.is_punct(0, '=') {
                    let help = "leave the value out: items of the struct give it, as `argument load = 100N;`";
                    return parser.expected("`,` or `)`", help);
                }
                if !parser.stream.eat_punct(',') && !parser.stream.at_end() {
                    return parser.expected("`,` or `)`", "");
                }
            }
            Ok(inputs)
        })
    }

    fn result(&mut self, function: &Ident) -> Parsed<Ident> {
        if !self.stream.is_puncts("->") {
            let help = "name the type that holds the quantities: `-> Motion`";
            return self.expected(&format!("`->` after `{function}(...)`"), help);
        }
        self.stream.skip(2);
        let result = self.name("the name of the result type")?;
        if self.stream.group(0, Delimiter::Brace).is_none() {
            let help = match self.stream.is_word(0, "as") {
                // rustc suggests this where a module has two types of a name.
                true => "write the other name alone: `-> OtherMotion`",
                false => "the result is a plain name; the macro generates a struct of that name",
            };
            return self.expected(&format!("`{{` after `{result}`"), help);
        }
        Ok(result)
    }

    /// `name` or `field: expr`, separated by commas.
    fn quantities(&mut self) -> Vec<QuantityDef> {
        let mut quantities = Vec::new();
        while !self.stream.at_end() {
            self.start_item();
            if self.quantity(&mut quantities).is_err() {
                self.skip_quantity();
            }
        }
        quantities
    }

    fn quantity(&mut self, quantities: &mut Vec<QuantityDef>) -> Parsed<()> {
        let attributes = self.attributes()?;
        self.only_documentation(&attributes, "a quantity");
        let has_equals = self.stream.ident(0).is_some() && self.stream.is_punct(1, '=');
        let named = self.stream.is_punct(1, ':') && !self.stream.is_punct(2, ':');
        if !named && !has_equals {
            quantities.push(self.shorthand(attributes)?);
            return self.end_of_quantity();
        }
        let field = self.name("the name of a field")?;
        if has_equals {
            // The value is read as if the mark were right.
            let _ = self.expected_mark::<()>(":", &field, &format!("{field}: ..."));
        }
        self.stream.skip(1);
        let value = self.expression();
        let result = value.as_ref().map(|_| ()).map_err(|reported| *reported);
        let value = value.unwrap_or_else(|_| Expr::error((&field).into()));
        quantities.push(QuantityDef {
            attributes,
            field,
            value,
        });
        result?;
        self.end_of_quantity()
    }

    /// A name, which names the field too.
    fn shorthand(&mut self, attributes: Vec<Attribute>) -> Parsed<QuantityDef> {
        let start = self.stream.ident(0).cloned();
        let value = self.expression()?;
        match value.kind {
            ExprKind::Name(ref field) => {
                let field = field.clone();
                Ok(QuantityDef {
                    attributes,
                    field,
                    value,
                })
            }
            _ => {
                let help = match &value.kind {
                    ExprKind::Field(point, field) if matches!(point.kind, ExprKind::Name(_)) => {
                        format!("write `{point}_{field}: {value}` or another name before it")
                    }
                    _ => {
                        let start = start.map(|start| start.to_string());
                        let field = start.unwrap_or_else(|| "field".to_owned());
                        format!("write `{field}: ...` or another name before it")
                    }
                };
                self.fail_at(value.span, "the quantity has no field name", &help)
            }
        }
    }

    fn end_of_quantity(&mut self) -> Parsed<()> {
        if self.stream.eat_punct(',') || self.stream.at_end() {
            return Ok(());
        }
        if self.stream.is_punct(0, ';') {
            return self.expected("`,`", "quantities are separated by commas");
        }
        self.unexpected_after_expression("`,`")
    }

    fn skip_quantity(&mut self) {
        while !self.stream.at_end() {
            if self.stream.eat_punct(',') || self.stream.eat_punct(';') {
                return;
            }
            self.stream.skip(1);
        }
    }

    /// Past the next braces, or to the next `fn`, after a mistake.
    fn skip_function(&mut self) {
        while !self.stream.at_end() && self.stream.group(0, Delimiter::Brace).is_none() {
            self.stream.skip(1);
            if self.at_function() {
                return;
            }
        }
        self.stream.skip(1);
    }

    fn at_function(&self) -> bool {
        self.stream.is_word(0, "fn")
            || self.stream.is_word(0, "pub")
            || self.stream.is_punct(0, '#')
    }
}
