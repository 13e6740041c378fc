//! What a part is given: expressions for its inputs, and where it stands.

use super::embed::Embedding;
use super::names::{Resolver, Symbol, kind};
use super::part::PartBody;
use super::place::{Context, Place, refusal};
use super::types::{Dimension, Expr, ExprKind, Let, Mechanism, Name, Parameter, Placed, Type};
use crate::diagnostic::SourceSpan;
use crate::diagnostic::text::{list, nearest};
use crate::syntax::{self, GivenPart, PartItem};

impl Resolver<'_> {
    /// A part's derived quantities and loops, behind what they are made of.
    pub(super) fn part_item(
        &mut self,
        item: &PartItem,
        position: usize,
        mechanism: &mut Mechanism,
    ) {
        let context = Context {
            place: Place::LetOrLoop,
            item: position,
        };
        let mut parts = self.parts.iter();
        let own = parts.position(|part| part.item == position);
        let Some((own, body)) = own.and_then(|own| Some((own, self.parts[own].body.clone()?)))
        else {
            let given = item.given.iter().map(|given| &given.value);
            let all: Vec<&syntax::Expr> = given.chain(&item.at).chain(&item.turned).collect();
            for value in all {
                self.expression(value, context);
            }
            return;
        };
        self.check_given(item, &body);
        let first = mechanism.lets.len();
        for (index, input) in body.mechanism().inputs.iter().enumerate() {
            let what = format!("the input `{}` of the part `{}`", input.name, item.name);
            let value = match given(item, &input.name) {
                Some(own) => {
                    let mut value = self.expression(&own.value, context);
                    self.refuse_argument(&mut value, &what);
                    self.fitted(value, &Type::Scalar(input.dimension), &what)
                }
                // It has been told that it is missing.
                None => self.failed((&item.name).into()),
            };
            self.pass_rates_on(own, index, &value);
            self.add_let(mechanism, item, &input.name, value);
        }
        for argument in &body.mechanism().arguments {
            if let Some(own) = given(item, &argument.name) {
                let what = format!(
                    "the argument `{}` of the part `{}`",
                    argument.name, item.name
                );
                let value = self.expression(&own.value, context);
                let value = self.fitted(value, &Type::Scalar(argument.dimension), &what);
                self.add_let(mechanism, item, &argument.name, value);
            }
        }
        let of_parameters = Context {
            place: Place::PartParameter,
            ..context
        };
        for parameter in &body.mechanism().parameters {
            if let Some(own) = given(item, &parameter.name) {
                let what = format!(
                    "the parameter `{}` of the part `{}`",
                    parameter.name, item.name
                );
                let value = self.expression(&own.value, of_parameters);
                let value = self.fitted(value, &parameter.ty, &what);
                self.add_let(mechanism, item, &parameter.name, value);
            }
        }
        self.refuse_open_arguments(item, own);
        self.place(item, &body, context, mechanism);
        debug_assert!(mechanism.lets.len() - first == body.own_lets() - body.first_let);
        let Some(embedding) = Embedding::new(&self.parts[own], &mechanism.lets, &self.placed)
        else {
            return;
        };
        let lets: Vec<Let> = embedding.lets().collect();
        mechanism.loops.extend(embedding.loops());
        let inner: Vec<Placed> = embedding.placed().collect();
        mechanism.parts.push(embedding.part());
        self.placed.extend(inner);
        for own in lets {
            self.arguments_of_lets.push(self.argument_below(&own.value));
            mechanism.lets.push(own);
        }
    }

    /// Reports what is given twice, is no input, argument or parameter, or is missing.
    fn check_given(&mut self, item: &PartItem, body: &PartBody) {
        let mechanism = body.mechanism();
        let inputs: Vec<&str> = mechanism
            .inputs
            .iter()
            .map(|own| own.name.as_str())
            .collect();
        let parameters = mechanism.parameters.iter().map(|own| own.name.as_str());
        let arguments = mechanism.arguments.iter().map(|own| own.name.as_str());
        let others: Vec<&str> = parameters.chain(arguments).collect();
        for (index, own) in item.given.iter().enumerate() {
            let text = own.name.to_string();
            if item.given[..index]
                .iter()
                .any(|before| before.name == own.name)
            {
                let fact = format!("`{text}` is given twice to the part `{}`", item.name);
                let help = "leave one of them out";
                self.diagnostics
                    .error_with_help((&own.name).into(), fact, help);
            } else if !inputs.contains(&text.as_str()) && !others.contains(&text.as_str()) {
                let known = inputs.iter().chain(&others).copied();
                let help = match nearest(&text, known) {
                    Some(name) => format!("did you mean `{name}`?"),
                    None if inputs.is_empty() => format!("`{}` has no input", mechanism.name),
                    None => format!("its inputs are {}", list(&inputs)),
                };
                let fact = format!(
                    "`{text}` is no input, parameter or argument of `{}`",
                    mechanism.name
                );
                self.diagnostics
                    .error_with_help((&own.name).into(), fact, help);
            }
        }
        let open = inputs.iter().filter(|input| given(item, input).is_none());
        let open: Vec<&str> = open.copied().collect();
        if let ([first, ..], true) = (&open[..], item.whole) {
            let fact = format!(
                "{} of `{}` {} left open in the part `{}`",
                list(&open),
                mechanism.name,
                if open.len() == 1 { "is" } else { "are" },
                item.name
            );
            let help = format!("write `{first} = ...` between the braces");
            let span = SourceSpan::from(&item.name).to((&item.mechanism).into());
            self.diagnostics.error_with_help(span, fact, help);
        }
    }

    /// An expression of the type that something of a part has; another is reported.
    fn fitted(&mut self, mut value: Expr, wanted: &Type, what: &str) -> Expr {
        if value.ty.is_error() {
            return value;
        }
        if Type::common(&value.ty, wanted).is_some() {
            value.settle(wanted);
            if wanted.dimension().is_some_and(|own| own.angle) {
                self.refuse_bare_angle(&value, what);
            }
            return value;
        }
        self.suspect(&value, wanted);
        let fact = format!("{what} is {wanted}, found {}", value.ty);
        let help = self
            .hidden_unit(&value)
            .unwrap_or_else(|| format!("give it {wanted}"));
        let span = self.origins.span(value.origin);
        self.diagnostics.error_with_help(span, fact, help);
        self.failed(span)
    }

    fn add_let(&mut self, mechanism: &mut Mechanism, item: &PartItem, name: &str, value: Expr) {
        self.arguments_of_lets.push(self.argument_below(&value));
        let name = format!("{}.{name}", item.name);
        mechanism.lets.push(Let { name, value });
    }

    /// Where an input of a part is an input itself, their speeds and accelerations are one.
    fn pass_rates_on(&mut self, part: usize, input: usize, value: &Expr) {
        let Some(Name::Input(outer)) = value.as_name() else {
            return;
        };
        let outer = self.rates[outer];
        let Some(body) = &mut self.parts[part].body else {
            return;
        };
        let own = &body.model.mechanism.inputs[input];
        for (own, outer) in [own.speed, own.acceleration].into_iter().zip(outer) {
            if let (Some(own), Some(outer)) = (own, outer) {
                body.arguments[own].get_or_insert(Name::Argument(outer));
            }
        }
    }

    /// Reports arguments that something of a part is made of and that are not given.
    fn refuse_open_arguments(&mut self, item: &PartItem, part: usize) {
        let Some(body) = &self.parts[part].body else {
            return;
        };
        let mechanism = body.mechanism();
        let values = mechanism.lets.iter().map(|own| &own.value);
        let values = values.chain(mechanism.expressions_of_mechanics());
        let names = values.flat_map(Expr::parts).filter_map(Expr::as_name);
        let used: Vec<usize> = names
            .filter_map(|name| match name {
                Name::Argument(index) => Some(index),
                _ => None,
            })
            .collect();
        let all = mechanism.arguments.iter().enumerate();
        let open =
            all.filter(|(index, _)| body.arguments[*index].is_none() && used.contains(index));
        let open: Vec<String> = open.map(|(_, own)| own.name.clone()).collect();
        let of = mechanism.name.clone();
        for name in open.iter().filter(|_| item.whole) {
            let fact = format!(
                "the argument `{name}` of `{of}` is left open in the part `{}`",
                item.name
            );
            let help =
                format!("write `{name} = ...` between the braces: an `argument` or a number");
            self.diagnostics
                .error_with_help((&item.name).into(), fact, help);
        }
    }

    /// Reports a parameter of a part whose field has the name of another one.
    pub(super) fn check_field(&mut self, name: &str, part: usize, before: &[Parameter]) {
        let field = |name: &str| name.replace('.', "_");
        let mut before = before.iter();
        if let Some(other) = before.find(|other| field(&other.name) == field(name)) {
            let fact = format!(
                "`{name}` and `{}` have one field, `{}`",
                other.name,
                field(name)
            );
            let span = self.parts[part].span;
            self.diagnostics
                .error_with_help(span, fact, "choose another name for one of them");
        }
    }

    /// Where the part stands.
    fn place(
        &mut self,
        item: &PartItem,
        body: &PartBody,
        context: Context,
        mechanism: &mut Mechanism,
    ) {
        let mut names = [&item.at, &item.turned].into_iter().zip(["at", "turned"]);
        let mut next = |resolver: &mut Self| {
            let (value, name) = names.next()?;
            let value = value.as_ref()?;
            let what = format!("where the part `{}` stands", item.name);
            let mut value = resolver.expression(value, context);
            resolver.refuse_argument(&mut value, &what);
            let value = match name {
                "at" => resolver.place_of(value, item, body),
                _ => resolver.angle_of(value, item),
            };
            let (ty, origin) = (value.ty.clone(), value.origin);
            let kind = ExprKind::Name(Name::Let(mechanism.lets.len()));
            resolver.add_let(mechanism, item, name, value);
            Some(Expr { kind, ty, origin })
        };
        let [at, turned] = [next(self), next(self)];
        let in_space = |own: &Expr| own.ty.components() == Some(3) || own.ty == Type::Frame;
        if let (Some(at), Some(angle)) = (&at, &turned)
            && in_space(at)
        {
            let help = "write a frame for its place: `at frame(point, x, z)`";
            let fact = "a part in space is turned by its frame, not by an angle";
            let span = self.origins.span(angle.origin);
            self.diagnostics.error_with_help(span, fact, help);
        }
        if at.is_some() || turned.is_some() {
            let path = item.name.to_string();
            self.placed.push(Placed { path, at, turned });
        }
    }

    /// A point, or a frame in space.
    fn place_of(&mut self, mut value: Expr, item: &PartItem, body: &PartBody) -> Expr {
        if value.ty.is_error() {
            return value;
        }
        let points = components_of_points(body.mechanism());
        if let Type::Zero(count) = value.ty {
            let count = count.max(points.first().copied().unwrap_or(2));
            value.settle(&Type::Vector(count, Dimension::LENGTH));
        }
        let count = match &value.ty {
            Type::Vector(count, dimension) if dimension.fits(Dimension::LENGTH) => *count,
            Type::Frame => 3,
            other => {
                let fact = format!("a part stands at a point or in a frame, found {other}");
                let help = "write it like `at pivot`";
                self.suspect(&value, &Type::Vector(2, Dimension::LENGTH));
                let span = self.origins.span(value.origin);
                self.diagnostics.error_with_help(span, fact, help);
                return self.failed(span);
            }
        };
        if let Some(own) = points.iter().find(|own| **own != count) {
            let words = |count| if count == 3 { "space" } else { "the plane" };
            let fact = format!(
                "the part `{}` has vectors of {}, and stands at a place of {}",
                item.name,
                words(*own),
                words(count)
            );
            let help = "place it by a point of its own kind, or write what is asked of it with `point_in`; that a plane cannot be \
                        placed in space is a limit of linkage";
            let span = self.origins.span(value.origin);
            self.diagnostics.error_with_help(span, fact, help);
            return self.failed(span);
        }
        value
    }

    fn angle_of(&mut self, value: Expr, item: &PartItem) -> Expr {
        let what = format!("the angle by which the part `{}` is turned", item.name);
        self.fitted(value, &Type::Scalar(Dimension::ANGLE), &what)
    }

    /// `hook.tip`: a name of a part, seen from where the part stands.
    pub(super) fn member(
        &mut self,
        path: &str,
        member: &proc_macro2::Ident,
        context: Context,
        span: SourceSpan,
    ) -> Expr {
        let text = format!("{path}.{member}");
        if self.is_part(&text) {
            self.lonely_part(&text, span);
            return self.failed(span);
        }
        let Some(symbol) = self.find(&text) else {
            self.unknown_member(path, member);
            return self.failed(span);
        };
        let refused = self.refused_order(symbol, context);
        let refused = refused.or_else(|| refusal(symbol, context));
        if let Some((fact, help)) = refused {
            self.diagnostics.error_with_help(span, fact, help);
            return self.failed(span);
        }
        let (name, ty) = (symbol.name, symbol.ty.clone());
        let mut value = self.make(ExprKind::Name(name), ty, span);
        let around = self.placed.iter();
        let around = around.filter(|own| {
            let rest = text.strip_prefix(own.path.as_str());
            rest.is_some_and(|rest| rest.starts_with('.'))
        });
        let mut around: Vec<&Placed> = around.collect();
        // From the innermost part outwards.
        around.sort_by_key(|own| std::cmp::Reverse(own.path.len()));
        for own in around {
            value = own.frame().seen(value);
        }
        value
    }

    /// What a part is made of, and where it stands, is known behind its item.
    fn refused_order(&self, symbol: &Symbol, context: Context) -> Option<(String, String)> {
        let text = &symbol.text;
        let first = text.split('.').next().unwrap_or_default();
        let part = self.parts.iter().find(|part| part.name == first)?;
        let body = part.body.as_ref();
        let placed = body.is_some_and(|own| own.is_placed || own.is_turned);
        let ordered = matches!(context.place, Place::LetOrLoop) && part.item > context.item;
        let fact = match symbol.name {
            _ if !ordered => return None,
            Name::Let(_) => format!("`{text}` is used before the part `{first}`"),
            _ if placed => format!("`{text}` is used before it is known where `{first}` stands"),
            _ => return None,
        };
        Some((fact, format!("move the part `{first}` up")))
    }

    /// A part is no value.
    pub(super) fn lonely_part(&mut self, path: &str, span: SourceSpan) {
        if self.is_broken_part(path) {
            return;
        }
        let before = format!("{path}.");
        let mut symbols = self.symbols.iter();
        let example = symbols.find(|symbol| {
            matches!(symbol.name, Name::Let(_) | Name::Unknown(_))
                && symbol.text.starts_with(&before)
        });
        let fact = format!("`{path}` is a part, which has no value of its own");
        let help = match example {
            Some(symbol) => format!(
                "name what of it, like `{}`, {}",
                symbol.text,
                kind(symbol.name)
            ),
            None => "name what of it".to_owned(),
        };
        self.diagnostics.error_with_help(span, fact, help);
    }
}

fn given<'i>(item: &'i PartItem, name: &str) -> Option<&'i GivenPart> {
    item.given.iter().find(|given| given.name == name)
}

/// How many components the points of a mechanism have: 2, 3, or both.
fn components_of_points(mechanism: &Mechanism) -> Vec<usize> {
    let lets = mechanism.lets.iter().map(|own| &own.value.ty);
    let unknowns = mechanism.unknowns.iter().map(|own| &own.ty);
    let parameters = mechanism.parameters.iter().map(|own| &own.ty);
    let mut all: Vec<usize> = lets
        .chain(unknowns)
        .chain(parameters)
        .filter_map(|ty| match ty {
            Type::Vector(count, _) => Some(*count),
            Type::Frame => Some(3),
            Type::Scalar(_) | Type::Array(_) | Type::Zero(_) | Type::Error => None,
        })
        .collect();
    all.sort_unstable();
    all.dedup();
    all
}
