//! Parameters: defaults, tolerances, scalar components.

use super::scalars::add_scalars;
use crate::diagnostic::SourceSpan;
use crate::model::dispatch::resolve_expression;
use crate::model::expression::composite::make_vector;
use crate::model::expression::frame_items::refuse_frame_item;
use crate::model::expression::missing_units::note_unitless;
use crate::model::symbols::scope::Scope;
use crate::model::symbols::sink::Sink;
use crate::model::symbols::site::{Context, Site};
use crate::model::types::{Dimension, Expr, Name, Parameter, Type};
use crate::syntax::{self, Attribute, ParamItem, Toleranced, documentation};

pub(in crate::model) fn resolve_parameter(
    scope: &mut Scope,
    sink: &mut Sink,
    item: &ParamItem,
    index: usize,
    position: usize,
) -> Parameter {
    let context = Context {
        site: Site::Parameter,
        item: position,
    };
    let (mut nominal, mut tolerances) = match &item.value {
        Toleranced::Single { nominal, tolerance } => {
            let nominal = resolve_expression(scope, sink, nominal, context);
            let tolerance = tolerance
                .as_ref()
                .map(|tolerance| resolve_tolerance(scope, sink, tolerance, context));
            let tolerances = spread_tolerance(sink, &nominal, tolerance);
            (nominal, tolerances)
        }
        Toleranced::Components { components, span } => {
            resolve_components(scope, sink, components, *span, context)
        }
    };
    refuse_frame_item(sink, &mut nominal, "a parameter is a scalar or a vector");
    let mut ty = nominal.ty.clone();
    let mut bare_zero = matches!(ty, Type::Zero(_));
    if bare_zero && let Some(tolerance) = tolerances.iter().flatten().next() {
        // `0 +- 0.1mm` is a length.
        if let (Type::Scalar(dimension), Some(count)) = (&tolerance.ty, ty.components()) {
            ty = if count == 1 {
                tolerance.ty.clone()
            } else {
                Type::Vector(count, *dimension)
            };
            bare_zero = false;
        }
    }
    let name = Name::Parameter(index);
    let ty = scope.units.declared(name, &ty);
    nominal.settle(&ty);
    let is_bare = |tolerance: &Expr| tolerance.bare_number().is_some();
    let beside = tolerances.iter().flatten().any(is_bare);
    note_unitless(
        &scope.names,
        &mut scope.units,
        sink,
        name,
        &nominal,
        beside.then_some("the tolerance"),
    );
    let unitless = scope.units.is_taken_for_length(name);
    let mut checked = None;
    let wanted = Type::Scalar(ty.dimension().unwrap_or(Dimension::NUMBER));
    for tolerance in tolerances.iter_mut().flatten().filter(|_| !ty.is_error()) {
        tolerance.settle(&wanted);
        // One tolerance for all components is one mistake. One without a unit is reported with the
        // value.
        if checked != Some(tolerance.origin) && !(unitless && is_bare(tolerance)) {
            check_tolerance(scope, sink, tolerance, &wanted);
        }
        checked = Some(tolerance.origin);
    }
    scope.names.set_type(name, ty.clone(), bare_zero);
    let first_scalar = add_scalars(&mut scope.values, &item.name.to_string(), index, &ty);
    Parameter {
        name: item.name.to_string(),
        documentation: documentation(&item.attributes),
        ty,
        origin: sink.add_origin((&item.name).into()),
        may_be_unused: item.name.is_of_link()
            || item.attributes.iter().any(Attribute::allows_unused),
        nominal,
        tolerances,
        first_scalar,
    }
}

/// One tolerance for each component.
fn spread_tolerance(sink: &mut Sink, nominal: &Expr, tolerance: Option<Expr>) -> Vec<Option<Expr>> {
    let count = nominal.ty.components().unwrap_or(1);
    let Some(tolerance) = tolerance else {
        return vec![None; count];
    };
    match tolerance.ty.components() {
        Some(found) if found > 1 && found == count => (0..count)
            .map(|component| Some(tolerance.component(component)))
            .collect(),
        Some(found) if found > 1 && !nominal.ty.is_error() => {
            let fact = format!("{} cannot have {} as tolerance", nominal.ty, tolerance.ty);
            let help = match count {
                1 => "write one tolerance",
                _ => "write one tolerance for each component",
            };
            let span = sink.span(tolerance.origin);
            sink.error_with_help(span, fact, help);
            vec![None; count]
        }
        _ => vec![Some(tolerance); count],
    }
}

/// `(x +- tx, y +- ty)`
fn resolve_components(
    scope: &Scope,
    sink: &mut Sink,
    components: &[(syntax::Expr, Option<syntax::Expr>)],
    span: SourceSpan,
    context: Context,
) -> (Expr, Vec<Option<Expr>>) {
    let mut nominals = Vec::new();
    let mut tolerances = Vec::new();
    for (nominal, tolerance) in components {
        nominals.push(resolve_expression(scope, sink, nominal, context));
        let tolerance = tolerance
            .as_ref()
            .map(|tolerance| resolve_tolerance(scope, sink, tolerance, context));
        tolerances.push(tolerance);
    }
    (
        make_vector(&scope.names, &scope.units, sink, nominals, span),
        tolerances,
    )
}

fn resolve_tolerance(
    scope: &Scope,
    sink: &mut Sink,
    tolerance: &syntax::Expr,
    context: Context,
) -> Expr {
    if let syntax::ExprKind::Negate(value) = &tolerance.kind
        && let syntax::ExprKind::Number { text, suffix } = &value.kind
    {
        let fact = format!("the tolerance -{text}{suffix} is negative");
        let help = format!("write `+- {text}{suffix}`");
        sink.error_with_help(tolerance.span, fact, help);
    }
    resolve_expression(scope, sink, tolerance, context)
}

fn check_tolerance(scope: &Scope, sink: &mut Sink, tolerance: &Expr, wanted: &Type) {
    if tolerance.ty.is_error() || Type::common(&tolerance.ty, wanted).is_some() {
        return;
    }
    let fact = format!(
        "the nominal value is {wanted}, its tolerance {}",
        tolerance.ty
    );
    let help = "give both the same dimension, for example `50mm +- 0.01mm`";
    let span = sink.span(tolerance.origin);
    let message = sink.error_with_help(span, fact, help);
    let number = tolerance.bare_number();
    let number = number.filter(|_| *wanted == Type::Scalar(Dimension::LENGTH));
    if let Some(number) = number {
        let length = format!("{number}{}", scope.units.length.name());
        message.suggest(format!("write `{length}`"), span, length);
    }
}
