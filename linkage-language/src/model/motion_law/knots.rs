//! Knots, and the words of laws and ends.

use crate::diagnostic::text::{count, nearest};
use crate::model::symbols::operands::Operands;
use crate::model::symbols::sink::Sink;
use crate::model::types::{Knot, Law, MotionLawWord, Repeating, SplineWord};
use crate::syntax::{self, Word};

/// The word that permits a jump of speed or acceleration at a knot.
const JUMP: &str = "jump";

pub(in crate::model) fn resolve_knots(
    operands: Operands,
    sink: &mut Sink,
    word: MotionLawWord,
    list: &syntax::Expr,
) -> Option<Vec<Knot>> {
    let syntax::ExprKind::List(entries) = &list.kind else {
        let fact = format!("`{}` takes a list of knots, found none", word.word());
        sink.error_with_help(list.span, fact, format!("write `{}`", word.form()));
        return None;
    };
    if entries.len() < 2 {
        let found = count(entries.len(), "knot");
        let fact = format!(
            "`{}` leads through at least two knots, found {found}",
            word.word()
        );
        sink.error_with_help(list.span, fact, format!("write `{}`", word.form()));
        return None;
    }
    let knots: Vec<Option<Knot>> = entries
        .iter()
        .map(|entry| resolve_knot(operands, sink, word, entry))
        .collect();
    knots.into_iter().collect()
}

/// `(place, value)`, then a law, of a spline a slope, then `jump`.
fn resolve_knot(
    operands: Operands,
    sink: &mut Sink,
    word: MotionLawWord,
    entry: &syntax::Expr,
) -> Option<Knot> {
    let parts = match &entry.kind {
        syntax::ExprKind::Tuple(parts) if (2..=4).contains(&parts.len()) => parts,
        syntax::ExprKind::Error => return None,
        _ => {
            let fact = "a knot is a place and a value in parentheses";
            sink.error_with_help(entry.span, fact, format!("write `{}`", word.form()));
            return None;
        }
    };
    let (words, may_jump) = match &parts[2..] {
        [before @ .., last] if named(last).is_some_and(|name| name == JUMP) => (before, true),
        words => (words, false),
    };
    let abscissa = operands.resolve(sink, &parts[0]);
    let value = operands.resolve(sink, &parts[1]);
    let is_slope = |operand: &syntax::Expr| {
        let law = named(operand).and_then(|name| Law::from_word(&name));
        matches!(word, MotionLawWord::Spline) && law.is_none()
    };
    let mut slope = None;
    let law = match words {
        [] => None,
        [operand] if is_slope(operand) => {
            slope = Some(operands.resolve(sink, operand));
            None
        }
        [law] => Some(read_law(sink, law)?),
        [_, other, ..] => {
            let fact = "behind its law a knot has nothing but `jump`";
            let help = "`jump` accepts that speed or acceleration jumps there";
            sink.error_with_help(other.span, fact, help);
            return None;
        }
    };
    let values = [&abscissa, &value].into_iter().chain(&slope);
    if values.into_iter().any(|value| value.ty.is_error()) {
        return None;
    }
    let origin = sink.add_origin(entry.span);
    Some(Knot {
        abscissa,
        value,
        slope,
        law,
        may_jump,
        origin,
    })
}

pub(in crate::model) fn read_law(sink: &mut Sink, expr: &syntax::Expr) -> Option<Law> {
    read_word(sink, expr, "a law of motion", "laws are")
}

pub(in crate::model) fn read_spline_word(
    sink: &mut Sink,
    expr: &syntax::Expr,
) -> Option<SplineWord> {
    read_word(sink, expr, "how the spline ends", "it may be")
}

pub(in crate::model) fn read_repeating(sink: &mut Sink, expr: &syntax::Expr) -> Option<Repeating> {
    read_word(sink, expr, "how the course goes on", "it may be")
}

/// A word of one kind, which is no name of the mechanism.
fn read_word<W: Word>(
    sink: &mut Sink,
    expr: &syntax::Expr,
    wanted: &str,
    known: &str,
) -> Option<W> {
    let name = named(expr);
    if let Some(word) = name.as_deref().and_then(W::from_word) {
        return Some(word);
    }
    if matches!(expr.kind, syntax::ExprKind::Error) {
        return None;
    }
    let words = || W::all().map(W::word);
    let fact = match &name {
        Some(name) => format!("expected {wanted}, found `{name}`"),
        None => format!("expected {wanted}"),
    };
    let help = match name.as_deref().and_then(|name| nearest(name, words())) {
        Some(near) => format!("did you mean `{near}`?"),
        None => format!("{known} {}", words().collect::<Vec<_>>().join(" ")),
    };
    sink.error_with_help(expr.span, fact, help);
    None
}

/// The name that an expression is.
fn named(expr: &syntax::Expr) -> Option<String> {
    match &expr.kind {
        syntax::ExprKind::Name(ident) => Some(ident.to_string()),
        _ => None,
    }
}
