//! Where parts stand, and what of them is read from outside.

use proc_macro2::Ident;

use super::names::{Resolver, Symbol};
use super::part::PartBody;
use super::place::{Context, Place, refusal};
use super::types::{Dimension, Expr, ExprKind, Mechanism, Name, Placed, Type};
use crate::diagnostic::SourceSpan;
use crate::syntax::PartItem;

impl Resolver<'_> {
    /// Where the part stands.
    pub(super) fn place_part(
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
            let first = mechanism.loops.len();
            let loops = first..first + body.mechanism().loops.len();
            self.placed.push(Placed {
                path,
                at,
                turned,
                loops,
            });
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
        member: &Ident,
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
            Some(symbol) => format!("name what of it, like `{}`, {}", symbol.text, symbol.kind()),
            None => "name what of it".to_owned(),
        };
        self.diagnostics.error_with_help(span, fact, help);
    }
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
            Type::PlaneFrame => Some(2),
            Type::Scalar(_) | Type::Array(_) | Type::Zero(_) | Type::Error => None,
        })
        .collect();
    all.sort_unstable();
    all.dedup();
    all
}
