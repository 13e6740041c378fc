//! Are two expressions equal? By evaluating both at chosen places: sums and products may be written
//! in more ways than constructors can bring to one form.

use super::ex::Ex;
use crate::graph::{Graph, Node, NodeId, SymbolId};
use crate::lookup::Map;
use crate::operation::{Binary, Ternary};

/// Places at which both sides must be defined and agree.
const POINTS: u64 = 4;

/// Places that are tried: not every function is defined everywhere.
const TRIED: u64 = 64;

/// Differences below this share of the larger terms are rounding.
const ROUNDING: f64 = 1e-10;

/// True if two expressions have equal values wherever their symbols are independent, up to
/// rounding. Definitions are not followed.
pub fn numerically_equal(a: Ex, b: Ex) -> bool {
    numerically_equal_within(a, b, ROUNDING)
}

/// The same up to a given share of the larger terms.
pub fn numerically_equal_within(a: Ex, b: Ex, share: f64) -> bool {
    if a == b {
        return true;
    }
    let (graph, a, b) = (a.graph(), a.id(), b.id());
    let near = (0..TRIED).map(|point| agree_at(graph, a, b, SamplePoint::Near(point), share));
    let near: Vec<bool> = near.flatten().take(POINTS as usize).collect();
    let analytic = || {
        graph
            .reachable(&[a, b])
            .iter()
            .all(|&id| !splits(graph, id))
    };
    let far =
        || (0..TRIED).filter_map(|point| agree_at(graph, a, b, SamplePoint::Far(point), share));
    !near.is_empty() && near.into_iter().all(|x| x) && (analytic() || far().all(|x| x))
}

/// True for functions that are different formulas on different sides of some value.
fn splits(graph: &Graph, id: NodeId) -> bool {
    match graph.node(id) {
        Node::Constant(_) | Node::Symbol(_) => false,
        Node::Unary(op, _) => op.row().splits,
        Node::Binary(op, ..) => op.row().splits,
        Node::Ternary(op, ..) => op.row().splits,
    }
}

/// A point at which expressions are evaluated.
#[derive(Clone, Copy)]
enum SamplePoint {
    /// All symbols in 0.5..1.5: roots are defined, nothing is lost beside large terms.
    Near(u64),
    /// Any signs and magnitudes.
    Far(u64),
}

/// Nothing where both sides are undefined.
fn agree_at(graph: &Graph, a: NodeId, b: NodeId, point: SamplePoint, share: f64) -> Option<bool> {
    // Each value comes with the size of the terms that it is made of: a small sum of large terms is
    // known less well.
    let mut values: Map<NodeId, (f64, f64)> = Map::new();
    for id in graph.reachable(&[a, b]) {
        let known = match graph.node(id) {
            Node::Constant(bits) => sized(f64::from_bits(bits)),
            Node::Symbol(symbol) => sized(sample(graph, symbol, point)),
            Node::Unary(op, x) => {
                let (value, size) = values[&x];
                let result = op.apply([value]);
                (result, result.abs().max(size * (result / value).abs()))
            }
            Node::Binary(op, x, y) => {
                let ((x, x_size), (y, y_size)) = (values[&x], values[&y]);
                let result = op.apply([x, y]);
                let size = match op {
                    Binary::Mul => x_size * y_size,
                    Binary::Div => x_size / y.abs(),
                    _ => x_size.max(y_size),
                };
                (result, result.abs().max(size))
            }
            Node::Ternary(op, x, y, z) => {
                let result = op.apply([x, y, z].map(|entry| values[&entry].0));
                // A root is known as well as its discriminant.
                let size = if op == Ternary::GuardedSqrt {
                    values[&x].1
                } else {
                    0.0
                };
                (result, result.abs().max(size))
            }
        };
        values.insert(id, known);
    }
    let ((a, a_size), (b, b_size)) = (values[&a], values[&b]);
    let agree = (a - b).abs() <= share * a_size.max(b_size).max(f64::MIN_POSITIVE);
    (a.is_finite() || b.is_finite()).then_some(agree)
}

fn sized(value: f64) -> (f64, f64) {
    (value, value.abs())
}

/// A value for each symbol and point; the cosine and the sine of one angle fit each other.
fn sample(graph: &Graph, symbol: SymbolId, point: SamplePoint) -> f64 {
    match graph.store().cosine_of(symbol) {
        Some(cosine) => number(cosine, point).sin(),
        None if graph.store().is_cosine(symbol) => number(symbol, point).cos(),
        None => number(symbol, point),
    }
}

/// A number without pattern.
fn number(symbol: SymbolId, point: SamplePoint) -> f64 {
    let (point, far) = match point {
        SamplePoint::Near(point) => (point, false),
        SamplePoint::Far(point) => (TRIED + point, true),
    };
    let mut x = (symbol.index() as u64 + 1).wrapping_mul(0x9e37_79b9_7f4a_7c15)
        ^ (point + 1).wrapping_mul(0xd1b5_4a32_d192_ed03);
    x = (x ^ (x >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    x = (x ^ (x >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    x ^= x >> 31;
    let near = 0.5 + (x >> 11) as f64 / (1u64 << 53) as f64;
    if !far {
        return near;
    }
    // The lowest bits are not in the number: a sign, and a power of ten from -3 to 4.
    let sign = if x & 1 == 0 { 1.0 } else { -1.0 };
    sign * near * 10f64.powi((x >> 1 & 7) as i32 - 3)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::graph::Source;

    /// Numbers of some symbols, each at many places.
    fn numbers(point: fn(u64) -> SamplePoint) -> Vec<Vec<f64>> {
        let of = |symbol| (0..TRIED).map(move |k| number(SymbolId(symbol), point(k)));
        (0..20).map(|symbol| of(symbol).collect()).collect()
    }

    fn mean(numbers: impl Iterator<Item = f64>) -> f64 {
        let numbers: Vec<f64> = numbers.collect();
        numbers.iter().sum::<f64>() / numbers.len() as f64
    }

    /// Near numbers fill 0.5 to 1.5 evenly: the mean is 1, that of the squared distances from it
    /// 1/12.
    #[test]
    fn near_numbers_fill_their_range() {
        let numbers = numbers(SamplePoint::Near);
        let mut all = numbers.concat();
        assert!(all.iter().all(|x| (0.5..1.5).contains(x)));
        assert!((mean(all.iter().copied()) - 1.0).abs() < 0.03);
        let distances = all.iter().map(|x| (x - 1.0).powi(2));
        assert!((mean(distances) - 1.0 / 12.0).abs() < 0.005);
        all.sort_by(f64::total_cmp);
        let widest = all
            .windows(2)
            .map(|pair| pair[1] - pair[0])
            .fold(0.0, f64::max);
        assert!(widest < 0.02, "{widest}");
        assert!(
            all.windows(2).all(|pair| pair[0] < pair[1]),
            "none comes twice"
        );
    }

    /// No symbol tells anything of another, nor a point of the next one.
    #[test]
    fn numbers_have_no_pattern() {
        let numbers = numbers(SamplePoint::Near);
        let product = |(x, y): (&f64, &f64)| (x - 1.0) * (y - 1.0) * 12.0;
        let mut products = Vec::new();
        for k in 1..numbers.len() {
            for other in 0..k {
                let pairs = numbers[k].iter().zip(&numbers[other]);
                products.push(mean(pairs.map(product)));
            }
            let next = numbers[k].iter().zip(&numbers[k][1..]);
            products.push(mean(next.map(product)));
        }
        // Of 64 random numbers it is 1/8 on average, and beyond 5/8 once in two millions.
        assert!(products.iter().all(|x| x.abs() < 0.625), "{products:?}");
        let size = mean(products.iter().map(|x| x * x)).sqrt();
        assert!((0.1..0.15).contains(&size), "{size}");
    }

    /// Far numbers have both signs, and sizes from a thousandth to ten thousand.
    #[test]
    fn far_numbers_have_all_signs_and_sizes() {
        let all = numbers(SamplePoint::Far).concat();
        let negative = mean(all.iter().map(|x| f64::from(x.is_sign_negative())));
        assert!((negative - 0.5).abs() < 0.05, "{negative}");
        let mut decades = [0; 8];
        let exponent = |x: f64| (x.abs() / 0.5).log10().floor();
        let rest = |x: f64| x.abs() / 10_f64.powf(exponent(x));
        for &x in &all {
            assert!((0.5..1.5).contains(&rest(x)), "{x}");
            decades[(exponent(x) + 3.0) as usize] += 1;
        }
        let share = all.len() / decades.len();
        assert!(
            decades
                .iter()
                .all(|count| (share / 2..2 * share).contains(count)),
            "{decades:?}"
        );
        // At places of their own: none is a near number with another sign or size.
        for (near, far) in numbers(SamplePoint::Near)
            .iter()
            .zip(numbers(SamplePoint::Far))
        {
            let is_near = |x: f64| near.iter().any(|y| (rest(x) - y).abs() < 1e-9);
            assert!(!far.into_iter().any(is_near));
        }
    }

    #[test]
    fn cosine_and_sine_are_of_one_angle() {
        let graph = Graph::new();
        let ((c, _), (s, _), (free, _)) = (
            graph.unknown("c"),
            graph.unknown("s"),
            graph.unknown("free"),
        );
        graph.pair(c, s);
        let of_source = graph.source(Source::Input(0));
        let of_source = graph.symbols_of(&[of_source])[0];
        for k in 0..TRIED {
            for point in [SamplePoint::Near(k), SamplePoint::Far(k)] {
                let [cos, sin] = [c, s].map(|symbol| sample(&graph, symbol, point));
                assert!((cos * cos + sin * sin - 1.0).abs() < 1e-15);
                assert_eq!(cos, number(c, point).cos());
                for symbol in [free, of_source] {
                    assert_eq!(sample(&graph, symbol, point), number(symbol, point));
                }
            }
        }
    }
}
