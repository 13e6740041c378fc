//! Differences of expressions without the terms that both contain.

use linkage_symbolic::program::{Binary, Unary};
use linkage_symbolic::{Ex, Node, numerically_equal_within};

/// Terms that differ by less than this share cancel: a thousand roundings. Dimensions that are
/// written with nine digits and differ by less than a roundoff of these stay different.
const CANCELLED: f64 = 1e-13;

/// Returns the ratio of the first term of a sum to the same term of another one, or that of two
/// values that are known before a call.
pub(crate) fn ratio_of_terms<'m>(a: Ex<'m>, b: Ex<'m>) -> Option<Ex<'m>> {
    if a.is_fixed() && b.is_fixed() {
        return (!b.is_zero()).then(|| a / b);
    }
    let (factor, term) = *moving_and_fixed(a).0.first()?;
    let (others, _) = moving_and_fixed(b);
    let (divisor, _) = others.into_iter().find(|(_, other)| *other == term)?;
    Some(factor / divisor)
}

pub(crate) fn equal<'m>(a: Ex<'m>, b: Ex<'m>) -> bool {
    numerically_equal_within(a, b, CANCELLED)
}

/// `a - b`, without the terms that both contain.
pub(crate) fn difference<'m>(a: Ex<'m>, b: Ex<'m>) -> Ex<'m> {
    let zero = a.number(0.0);
    if equal(a, b) {
        return zero;
    }
    let (mut terms, first) = moving_and_fixed(a);
    let (others, second) = moving_and_fixed(b);
    let mut is_shared = !first.is_zero() && !second.is_zero();
    for (factor, term) in others {
        match terms.iter_mut().find(|(_, other)| *other == term) {
            Some((sum, _)) => {
                is_shared = true;
                *sum = less(*sum, factor);
            }
            None => terms.push((-factor, term)),
        }
    }
    if !is_shared {
        return a - b;
    }
    terms.retain(|(factor, _)| !factor.is_zero());
    let terms = terms.into_iter().map(|(factor, term)| factor * term);
    let fixed = less(first, second);
    match terms.reduce(|sum, term| sum + term) {
        Some(sum) => sum + fixed,
        None => fixed,
    }
}

/// The difference of two factors, 0 if it is rounding.
fn less<'m>(a: Ex<'m>, b: Ex<'m>) -> Ex<'m> {
    if equal(a, b) { a.number(0.0) } else { a - b }
}

/// The terms of a sum that are known in a call, with their factors, and the sum of the others.
/// Sums that are multiplied as a whole stay whole: they are shared with other loops.
fn moving_and_fixed<'m>(sum: Ex<'m>) -> (Vec<(Ex<'m>, Ex<'m>)>, Ex<'m>) {
    let one = sum.number(1.0);
    let ex = |id| sum.graph().ex(id);
    let mut fixed = sum.number(0.0);
    let mut moving = Vec::new();
    let mut open = vec![(one, sum)];
    while let Some((factor, x)) = open.pop() {
        match x.node() {
            _ if x.is_fixed() => fixed += factor * x,
            Node::Unary(Unary::Neg, a) => open.push((-factor, ex(a))),
            Node::Binary(Binary::Add, a, b) => open.extend([(factor, ex(b)), (factor, ex(a))]),
            Node::Binary(Binary::Sub, a, b) => open.extend([(-factor, ex(b)), (factor, ex(a))]),
            Node::Binary(Binary::Mul, a, b) if ex(a).is_fixed() => {
                moving.push((factor * ex(a), ex(b)));
            }
            _ => moving.push((factor, x)),
        }
    }
    (moving, fixed)
}
