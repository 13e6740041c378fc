//! Polynomials against the expressions that they are found in, and what is in the way of one.

use linkage_random::Random;
use linkage_symbolic::program::{Binary, Source, Unary};
use linkage_symbolic::{
    Ex, Graph, MAX_DEGREE, Obstacle, Polynomial, SymbolId, collect, evaluate, obstacle,
};

/// Three symbols, and what coefficients are made of: a parameter and an input, which is divided by and not inverted before a call.
struct Names<'g> {
    symbols: [SymbolId; 3],
    unknowns: [Ex<'g>; 3],
    free: [Ex<'g>; 2],
}

fn names(graph: &Graph) -> Names<'_> {
    let all = ["c", "s", "t"].map(|name| graph.unknown(name));
    Names {
        symbols: all.map(|(symbol, _)| symbol),
        unknowns: all.map(|(_, node)| graph.ex(node)),
        free: [Source::Parameter(0), Source::Input(1)].map(|own| graph.ex(graph.source(own))),
    }
}

/// A random expression of total degree `degree` at most.
fn expression<'g>(random: &mut Random, names: &Names<'g>, degree: usize, depth: usize) -> Ex<'g> {
    let leaf = |random: &mut Random| match random.below(4) {
        0 => names.free[0].number(random.between(-4.0, 5.0).round()),
        1 => *random.pick(&names.free),
        _ if degree == 0 => *random.pick(&names.free),
        _ => *random.pick(&names.unknowns),
    };
    if depth == 0 {
        return leaf(random);
    }
    let mut part = |degree| expression(random, names, degree, depth - 1);
    let (a, b) = (part(degree), part(degree));
    let (low, high, early) = (part(degree / 2), part(degree - degree / 2), part(0));
    match random.below(6) {
        0 => -a,
        1 => a - b,
        2 => a + b,
        3 => a / (early.square() + 1.0),
        _ => low * high,
    }
}

/// What a polynomial is at places of the symbols.
fn at(found: &Polynomial, places: [f64; 3], load: impl Fn(Source) -> f64) -> f64 {
    let terms = found.iter().map(|(monomial, &coefficient)| {
        let powers = monomial
            .iter()
            .zip(places)
            .map(|(&k, x)| x.powi(i32::from(k)));
        evaluate(&[coefficient], &load)[0] * powers.product::<f64>()
    });
    terms.sum()
}

#[test]
fn polynomials_have_the_values_of_their_expressions() {
    let mut random = Random::new(41);
    for case in 0..300 {
        let graph = Graph::new();
        let names = names(&graph);
        let root = expression(&mut random, &names, 4, 4);
        let angle = random.angle();
        let (places, pairs): ([f64; 3], &[_]) = match case % 2 {
            0 => ([0; 3].map(|_| random.between(-2.0, 2.0)), &[]),
            _ => (
                [angle.cos(), angle.sin(), random.between(-2.0, 2.0)],
                &[(0, 1)],
            ),
        };
        let found = collect(root, &names.symbols, pairs).expect("a polynomial");
        let numbers = [0; 2].map(|_| random.between(0.5, 2.0));
        let load = |source: Source| match source {
            Source::Parameter(k) | Source::Input(k) => numbers[k],
            other => panic!("{other}"),
        };
        for (monomial, coefficient) in &found {
            assert!(monomial.iter().sum::<u8>() <= MAX_DEGREE && !coefficient.is_zero());
            assert!(
                graph
                    .symbols_of(&[coefficient.id()])
                    .iter()
                    .all(|own| !names.symbols.contains(own))
            );
            assert!(pairs.is_empty() || monomial[1] < 2, "{monomial:?}");
        }
        for (symbol, place) in names.symbols.into_iter().zip(places) {
            graph.define(symbol, graph.constant(place));
        }
        let expected = evaluate(&[root], load)[0];
        let size = found
            .values()
            .map(|&own| evaluate(&[own], load)[0].abs())
            .fold(1.0, f64::max);
        let sum = at(&found, places, load);
        assert!(
            (sum - expected).abs() < 1e-11 * size,
            "{case}: {sum} instead of {expected}"
        );
        assert_eq!(obstacle(root, &names.symbols), None);
    }
}

/// The highest degree is allowed and the next is not, however it comes about.
#[test]
fn degrees_are_counted() {
    let graph = Graph::new();
    let Names {
        symbols,
        unknowns: [x, y, z],
        free: [p, q],
    } = names(&graph);
    let fourth = x.square() * y * z;
    let cases = [
        (fourth, 4),
        (p * fourth - x / q, 4),
        (-(fourth + p), 4),
        (fourth * x, 5),
        (p + fourth * (x - z) / q, 5),
        (-fourth.square() + x, 8),
        (x.square() * (y + p * x.square()) * q, 4),
    ];
    for (root, degree) in cases {
        let expected = (degree > 4).then_some(Obstacle::Degree(degree));
        assert_eq!(obstacle(root, &symbols), expected, "{root:?}");
        let found = collect(root, &symbols, &[]);
        assert_eq!(found.is_some(), degree <= 4);
        let highest = found
            .iter()
            .flatten()
            .map(|(own, _)| own.iter().sum::<u8>())
            .max();
        assert!(highest.is_none_or(|own| u32::from(own) == degree));
    }
}

#[test]
fn functions_of_the_symbols_are_in_the_way() {
    let graph = Graph::new();
    let Names {
        symbols,
        unknowns: [x, y, _],
        free: [p, q],
    } = names(&graph);
    let cases = [
        (p * (x + y).sqrt(), Obstacle::Root),
        (x.hypot(p) - y, Obstacle::Root),
        (x.root(p), Obstacle::Root),
        (p / x, Obstacle::Division),
        (y + x / (x + p), Obstacle::Division),
        (x.abs() + y, Obstacle::Function),
        (y.unary(Unary::Sin), Obstacle::Function),
        (x.binary(Binary::Min, p), Obstacle::Function),
        (x.select(p, q), Obstacle::Function),
    ];
    for (root, expected) in cases {
        assert_eq!(obstacle(root, &symbols), Some(expected), "{root:?}");
        assert_eq!(collect(root, &symbols, &[]), None, "{root:?}");
    }
    // They are no obstacle in coefficients.
    let free = [
        (p.sqrt() + p.hypot(q)) * x,
        x / p.abs(),
        p.unary(Unary::Sin),
        q.select(p, q) * y,
    ];
    for root in free {
        assert_eq!(obstacle(root, &symbols), None, "{root:?}");
        assert!(collect(root, &symbols, &[]).is_some(), "{root:?}");
    }
    // What is a symbol here is a coefficient there.
    assert_eq!(obstacle(x.sqrt() * y, &symbols[1..]), None);
}

#[test]
fn what_cancels_is_no_term() {
    let graph = Graph::new();
    let Names {
        symbols,
        unknowns: [x, y, _],
        free: [p, q],
    } = names(&graph);
    let root = (x + p) * (y - q) + q * (x + p) - x * y;
    let found = collect(root, &symbols, &[]).expect("a polynomial");
    assert_eq!(found.into_iter().collect::<Vec<_>>(), [(vec![0, 1, 0], p)]);
    let nothing = collect(
        (x + y).square() - x.square() - y.square() - 2.0 * (x * y),
        &symbols,
        &[],
    );
    assert_eq!(nothing, Some(Polynomial::new()));
    let constant = collect(graph.number(0.0), &symbols, &[]);
    assert_eq!(constant, Some(Polynomial::new()));
    // sin^4 = (1 - cos^2)^2
    let fourth = collect(y.square() * y.square(), &symbols, &[(0, 1)]).expect("a polynomial");
    let numbers = fourth
        .into_iter()
        .map(|(own, x)| (own[0], x.constant_value()));
    assert_eq!(
        numbers.collect::<Vec<_>>(),
        [(0, Some(1.0)), (2, Some(-2.0)), (4, Some(1.0))]
    );
}
