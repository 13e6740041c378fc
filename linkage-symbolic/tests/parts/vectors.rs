//! Vectors against lengths and directions, and against what products in space must be.

use linkage_random::Random;
use linkage_symbolic::{Graph, V2, V3, Vector, Vn};

use crate::{assert_near, inputs, value, values};

const ERROR: f64 = 1e-14;

/// A vector of the plane from its length and direction.
fn polar(length: f64, angle: f64) -> [f64; 2] {
    [length * angle.cos(), length * angle.sin()]
}

/// Two vectors of the plane and a number, all of them inputs.
fn plane(graph: &Graph) -> [V2<'_>; 2] {
    let [ax, ay, bx, by] = inputs(graph);
    [Vector([ax, ay]), Vector([bx, by])]
}

/// Two vectors of space, all of their components inputs.
fn space(graph: &Graph) -> [V3<'_>; 2] {
    let [a, b, c, d, e, f] = inputs(graph);
    [Vector([a, b, c]), Vector([d, e, f])]
}

#[test]
fn vectors_of_the_plane_turn_and_stretch() {
    let graph = Graph::new();
    let [a, b] = plane(&graph);
    let mut random = Random::new(31);
    for _ in 0..50 {
        let [r, s] = [0, 1].map(|_| random.between(0.5, 2.0));
        let [alpha, beta] = [0, 1].map(|_| random.angle());
        let at = [polar(r, alpha), polar(s, beta)].concat();
        let near = |v: V2, length: f64, angle: f64| {
            assert_near(&values(v.0, &graph, &at), &polar(length, angle), ERROR);
        };
        near(a.turned(b), r * s, alpha + beta);
        near(a.turned_back(b), r / s, alpha - beta);
        near(a.conjugate(), r, -alpha);
        near(a.perp(), r, alpha + std::f64::consts::FRAC_PI_2);
        near(-a, r, alpha + std::f64::consts::PI);
        let products = [a.dot(b), a.cross(b), a.square(), a.length()];
        let between = beta - alpha;
        let expected = [r * s * between.cos(), r * s * between.sin(), r * r, r];
        assert_near(&values(products, &graph, &at), &expected, ERROR);
    }
}

#[test]
fn a_real_number_turns_nothing() {
    let graph = Graph::new();
    let [a, b] = plane(&graph);
    let stretch = Vector([b[0], graph.number(0.0)]);
    let [forth, back] = [a.turned(stretch), a.turned_back(stretch)];
    assert_near(
        &values(forth.0, &graph, &[3.0, -5.0, 4.0, 0.0]),
        &[12.0, -20.0],
        0.0,
    );
    assert_near(
        &values(back.0, &graph, &[3.0, -5.0, 4.0, 0.0]),
        &[0.75, -1.25],
        0.0,
    );
    assert_eq!(back, a / b[0], "no square of the number is divided by");
}

#[test]
fn vectors_are_joined_component_by_component() {
    let graph = Graph::new();
    let [a, b] = space(&graph);
    let at = [1.0, -2.0, 5.0, 4.0, 0.5, -3.0];
    let is = |v: V3, expected: [f64; 3]| assert_near(&values(v.0, &graph, &at), &expected, 0.0);
    is(a + b, [5.0, -1.5, 2.0]);
    is(a - b, [-3.0, -2.5, 8.0]);
    is(-a, [-1.0, 2.0, -5.0]);
    is(b[0] * a, [4.0, -8.0, 20.0]);
    is(a / b[0], [0.25, -0.5, 1.25]);
    is(a.map(|x| x.abs()), [1.0, 2.0, 5.0]);
    assert_eq!(a.components().collect::<Vec<_>>(), a.0);
    assert_eq!(graph.vector(a.ids()), a);
    assert_eq!(value(a.dot(b), &at), -12.0);
}

/// `a x b` is across both, as long as the area between them, and right-handed.
#[test]
fn products_in_space_are_across_both() {
    let graph = Graph::new();
    let [a, b] = space(&graph);
    let product = a.cross(b);
    let triple = [product.dot(a), product.dot(b), product.square()];
    let area = a.square() * b.square() - a.dot(b) * a.dot(b);
    let mut random = Random::new(32);
    for _ in 0..20 {
        let at = [0; 6].map(|_| random.between(-2.0, 2.0));
        let area = value(area, &at);
        assert_near(&values(triple, &graph, &at), &[0.0, 0.0, area], 1e-13);
    }
    let axes = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    for k in 0..3 {
        let at = [axes[k], axes[(k + 1) % 3]].concat();
        assert_eq!(values(product.0, &graph, &at), axes[(k + 2) % 3]);
    }
}

#[test]
fn zeros_and_fixed_vectors_are_seen() {
    let graph = Graph::new();
    let [x] = inputs(&graph);
    let zero = graph.number(0.0);
    let p = graph.ex(graph.source(linkage_symbolic::program::Source::Parameter(0)));
    for (vector, is_zero, is_fixed) in [
        (Vector([zero, zero]), true, true),
        (Vector([zero, p]), false, true),
        (Vector([x, zero]), false, false),
        (Vector([p, x]), false, false),
    ] {
        assert_eq!(
            (vector.is_zero(), vector.is_fixed()),
            (is_zero, is_fixed),
            "{vector:?}"
        );
        assert_eq!(Vn::from(vector).is_zero(), is_zero);
    }
    let fixed = [zero, p, x].map(|x| x.is_fixed());
    assert_eq!(fixed, [true, true, false]);
}

/// What reads the same in the plane and in space gives the same, the plane being that of the first two axes.
#[test]
fn the_plane_is_a_part_of_space() {
    let graph = Graph::new();
    let [a, b] = plane(&graph);
    let zero = graph.number(0.0);
    let [flat_a, flat_b] = [a, b].map(|v| Vn::from(v).resized(3));
    assert_eq!(flat_a.ids(), [a[0], a[1], zero].map(|x| x.id()));
    let turn = Vn::from(Vector([b[0]]));
    let axis = Vn::from(Vector([zero, zero, b[0]]));
    let [a, b] = [a, b].map(Vn::from);
    let at = [3.0, 0.5, -1.5, 2.0];
    let of = |v: Vn| values(v.iter(), &graph, &at);
    // 3 * 2 - 0.5 * (-1.5)
    assert_eq!(of(a.moment_of(b)), [6.75]);
    assert_eq!(of(flat_a.moment_of(flat_b)), [0.0, 0.0, 6.75]);
    assert_eq!(of(turn.sweeping(a)), [0.75, -4.5]);
    assert_eq!(of(axis.sweeping(flat_a)), [0.75, -4.5, 0.0]);
    assert_eq!(value(a.dot(b), &at), value(flat_a.dot(flat_b), &at));
    assert_eq!((flat_a.resized(2), a.in_space()), (a, None));
    assert_eq!(flat_a.in_space().map(Vn::from), Some(flat_a));
}

#[test]
fn vectors_of_any_size_are_joined() {
    let graph = Graph::new();
    let [a, b] = space(&graph);
    let flat = Vn::from(Vector([b[0], b[1]]));
    let vector = Vn::from(a);
    let at = [1.0, -2.0, 5.0, 4.0, 0.5, -3.0];
    let of = |v: Vn| values(v.iter(), &graph, &at);
    assert_eq!(of(vector + flat), [5.0, -1.5, 5.0], "what is missing is 0");
    assert_eq!(of(flat - vector), [3.0, 2.5, -5.0]);
    assert_eq!(of(graph.zeros(1) - flat), [-4.0, -0.5]);
    assert_eq!(of(-flat), [-4.0, -0.5]);
    assert_eq!(of(b[1] * vector), [0.5, -1.0, 2.5]);
    assert_eq!(of(vector / b[1]), [2.0, -4.0, 10.0]);
    assert_eq!((vector.len(), flat.len(), graph.zeros(1).len()), (3, 2, 1));
    assert!(graph.zeros(0).is_empty() && !flat.is_empty());
    assert!(graph.zeros(3).is_zero() && !vector.is_zero());
    assert_eq!((vector[1], vector.at(2)), (a[1].id(), a[2]));
    assert_eq!(format!("{vector:?}"), format!("{:?}", a.ids()));
    assert!(vector == graph.components(&a.ids()) && vector != Vn::from(b));
}

#[test]
fn a_vector_is_its_parts_along_and_across() {
    let graph = Graph::new();
    let [v, direction] = space(&graph);
    let unit = Vn::from(direction).unit();
    let v = Vn::from(v);
    let (along, across) = (v.along(unit), v.across(unit));
    let checks = [
        across.dot(unit),
        Vn::from(direction).moment_of(along).square(),
        (along + across - v).square(),
        unit.square(),
    ];
    let mut random = Random::new(33);
    for _ in 0..20 {
        let at = [0; 6].map(|_| random.between(0.5, 2.0));
        assert_near(&values(checks, &graph, &at), &[0.0, 0.0, 0.0, 1.0], 1e-14);
        assert!(value(along.square(), &at) > 0.01);
    }
}
