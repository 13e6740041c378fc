//! What is known of vectors: of which one a length is, and which ones have length 1.

use linkage_symbolic::lookup::Map;
use linkage_symbolic::program::{Binary, Unary};
use linkage_symbolic::{Ex, Graph, Node, Vector, Vn};

use crate::{inputs, value};

#[test]
fn lengths_and_squares_know_their_vectors() {
    let graph = Graph::new();
    let [x, y, z] = inputs(&graph);
    let (flat, tall) = (Vector([x, y]), Vector([x, y, z]));
    let lengths = [flat.length(), tall.length()];
    let squares = [flat.square(), tall.square()];
    for (known, vector) in [flat.ids().to_vec(), tall.ids().to_vec()]
        .into_iter()
        .enumerate()
    {
        let of_length = graph.vector_of_length(lengths[known].id());
        let of_square = graph.vector_of_square(squares[known].id());
        assert_eq!([of_length, of_square], [Some(vector.clone()), Some(vector)]);
        assert_eq!(graph.vector_of_length(squares[known].id()), None);
        assert_eq!(graph.vector_of_square(lengths[known].id()), None);
    }
    // 1, 4, 8 and 9 are a quadruple as 3, 4 and 5 are a triple.
    let at = [4.0, 3.0, 0.0];
    assert_eq!(
        [lengths[0], squares[0]].map(|own| value(own, &at)),
        [5.0, 25.0]
    );
    let at = [1.0, 4.0, 8.0];
    assert_eq!(
        [lengths[1], squares[1]].map(|own| value(own, &at)),
        [9.0, 81.0]
    );
    let large = value(lengths[0], &[3e200, 4e200, 0.0]);
    assert!(
        (large / 5e200 - 1.0).abs() < 1e-15,
        "no overflow on the way"
    );
    assert_eq!(flat.dot(flat), squares[0]);
}

#[test]
fn lengths_stay_known_when_symbols_are_replaced() {
    let graph = Graph::new();
    let [x, y, z] = inputs(&graph);
    let (symbol, unknown) = graph.unknown("u");
    let unknown = graph.ex(unknown);
    let vector = Vector([x, unknown + z]);
    let root = vector.length() * y + vector.square();
    let map = Map::from([(symbol, y)]);
    graph.substitute_lengths(&[root], &map);
    let renewed = Vector([x, y + z]);
    let length = renewed.0[0].binary(Binary::Hypot, renewed.0[1]);
    let square = x.square() + (y + z).square();
    assert_eq!(
        graph.vector_of_length(length.id()),
        Some(renewed.ids().to_vec())
    );
    assert_eq!(
        graph.vector_of_square(square.id()),
        Some(renewed.ids().to_vec())
    );
}

#[test]
fn numbers_are_units_by_their_squares() {
    let graph = Graph::new();
    let is_unit = |numbers: &[f64]| {
        let ids: Vec<_> = numbers.iter().map(|&x| graph.constant(x)).collect();
        graph.components(&ids).is_unit()
    };
    let third = 1.0_f64.to_radians();
    for unit in [
        &[0.6, -0.8][..],
        &[0.0, 0.0, -1.0],
        &[third.cos(), 0.0, third.sin()],
    ] {
        assert!(is_unit(unit), "{unit:?}");
    }
    for other in [
        &[0.6, 0.8001][..],
        &[1.0, 1.0],
        &[0.5, 0.5],
        &[0.6, 0.8 - 1e-14],
        &[0.0, 0.0],
    ] {
        assert!(!is_unit(other), "{other:?}");
    }
}

#[test]
fn a_unit_is_one_turned_by_quarters() {
    let graph = Graph::new();
    let [x, y, z] = inputs(&graph);
    let flat = Vector([x, y]);
    assert!(!flat.is_unit());
    flat.mark_unit();
    let mut turned = flat;
    for _ in 0..4 {
        assert!(turned.is_unit(), "{turned:?}");
        turned = turned.perp();
    }
    assert!(!flat.conjugate().is_unit() && !Vector([y, x]).is_unit());
    let tall = Vector([x, y, z]);
    tall.mark_unit();
    assert!(tall.is_unit() && (-tall).is_unit() && !Vector([-x, y, z]).is_unit());
}

#[test]
fn only_what_is_no_unit_is_divided() {
    let graph = Graph::new();
    let [x, y, z] = inputs(&graph);
    let flat = Vector([x, y]);
    let (length, unit) = flat.length_and_unit();
    let at = [3.0, -4.0, 12.0];
    assert_eq!(
        [length, unit[0], unit[1]].map(|own| value(own, &at)),
        [5.0, 0.6, -0.8]
    );
    assert_eq!(Vn::from(flat).unit(), Vn::from(unit));
    let (one, same) = unit.length_and_unit();
    assert_eq!((one.constant_value(), same), (Some(1.0), unit));

    let tall = Vector([x, y, z]).unit();
    let expected = at.map(|own| own / 13.0);
    assert_eq!(tall.0.map(|own| value(own, &at)), expected);
    assert_eq!(tall.unit(), tall);
    let [sin, cos] = [Unary::Sin, Unary::Cos].map(|op| x.unary(op));
    let turning = Vector([cos, graph.number(0.0), sin]);
    assert_eq!(turning.unit(), turning, "of length 1 by its formula");
    assert_eq!(Vn::from(turning).unit(), Vn::from(turning));
    let divided = |own: Ex| matches!(own.node(), Node::Binary(Binary::Div, ..));
    assert!(tall.0.iter().all(|&own| divided(own)));
    // Nearly a unit vector is none.
    let nearly = Vector([cos, graph.number(1e-7), sin]);
    assert!(nearly.unit() != nearly);
}

#[test]
fn turned_vectors_are_perpendicular_and_as_long() {
    let graph = Graph::new();
    let [x, y, z] = inputs(&graph);
    let vector = Vector([x + z, y]);
    let is_turned = |own| Vn::from(vector).is_turned(Vn::from(own));
    assert!(is_turned(vector.perp()) && is_turned(-vector.perp()));
    assert!(!is_turned(Vector([y, x + z])), "not perpendicular");
    assert!(!is_turned(graph.number(2.0) * vector.perp()), "longer");
    assert!(!is_turned(vector));
    assert!(!is_turned(Vector([x, z])));
}
