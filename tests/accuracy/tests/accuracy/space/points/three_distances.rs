//! An unknown point at three distances, or at two distances in a plane.

use super::{PHI, directions, distance, pin, pin_of, plane, radical};
use crate::space::{LIMITS, direction};
use linkage_reference::{
    Depth, Form, Plan, Random, System, compare, cycle_cases, data, edge, forms, line_gap,
    planes_line, proportion_cases, scale_cases, unknowns,
};
use nalgebra::Vector3;

// Three distances.

const THREE: System = System {
    name: "three distances",
    data: data! {
        length "crank" 10.0, "two.x" 60.0, "two.y" 5.0, "two.z" 3.0, "three.x" 20.0,
            "three.y" 55.0, "three.z" -2.0, "l1" 45.0, "l2" 57.0, "l3" 52.0;
        degrees "phi" 30.0;
    },
    parameters: 10,
    unknowns: unknowns! {
        slide "p.x" 26.0, "p.y" 20.0, "p.z" -40.0;
    },
    residual: |p| {
        vec![
            distance(p, &pin(p), "l1"),
            distance(p, &p.space("two"), "l2"),
            distance(p, &p.space("three"), "l3"),
        ]
    },
    gap: |p| {
        let (one, l1) = (pin(p), p.value("l1"));
        let [(n2, d2), (n3, d3)] = [("two", "l2"), ("three", "l3")]
            .map(|(point, length)| radical([(&one, l1), (&p.space(point), p.value(length))]));
        let (on_line, direction) = planes_line([(&n2, &d2), (&n3, &d3)]);
        line_gap(l1, &one, (&on_line, &direction))
    },
    pairs: &[(0, 7), (8, 9)],
    ..System::PLAIN
};

macro_rules! three {
    ($name:ident [$($pairs:tt)*] { $($items:tt)* }) => {
        linkage_reference::form! {
            $name(phi) -> [p];
            $($pairs)*
            fields |g| {
                crank: g[0], two: [g[1], g[2], g[3]], three: [g[4], g[5], g[6]],
                l1: g[7], l2: g[8], l3: g[9]
            }
            {
                unit mm;
                param crank = 10mm;
                param two = (60mm, 5mm, 3mm);
                param three = (20mm, 55mm, -2mm);
                param l1 = 45mm;
                param l2 = 57mm;
                param l3 = 52mm;
                input phi = 30deg in 0deg..360deg;
                unknown p = (26mm, 20mm, -40mm);
                let one = turn((crank, 0mm, 0mm), (0, 1, 0), phi);
                $($items)*
            }
        }
    };
}

three!(distances [pairs crank l1, l2 l3;] {
    loop distance(p, one) = l1;
    loop distance(p, two) = l2;
    loop distance(p, three) = l3;
});

three!(mixed [] {
    loop norm(three - p) - l3 = 0mm;
    loop dot(p - two, p - two) = l2 * l2;
    loop l1 = norm(p - one);
});

pub(crate) const PLAN: Plan = Plan {
    geometry: |random, spread| {
        let crank = random.length(spread);
        // As in the mechanism as written, the first distance is the shortest: the others refer to it.
        let mut lengths = [0; 3].map(|_| random.length(spread).abs());
        lengths.sort_by(f64::total_cmp);
        let [u1, u2, u3] = directions(random, -1.0);
        let p = pin_of(crank) + lengths[0] * u1;
        closed(crank, [p - lengths[1] * u2, p - lengths[2] * u3], lengths)
    },
    dead_points: &[(7, 1e-3), (8, 30.0), (9, 30.0)],
};

fn closed(crank: f64, [two, three]: [Vector3<f64>; 2], lengths: [f64; 3]) -> Vec<f64> {
    [&[crank][..], two.as_slice(), three.as_slice(), &lengths[..]].concat()
}

/// Three known points so near to each other beside the distances.
fn near_points(random: &mut Random, ratio: f64) -> Vec<f64> {
    let crank = 50.0 * ratio;
    let base = [pin_of(crank), Vector3::zeros(), Vector3::zeros()];
    let [one, two, three] = base.map(|v| v + ratio * random.length(6.0) * direction(random));
    let one = pin_of(crank) + 0.0 * one;
    let normal = (two - one).cross(&(three - one)).normalize();
    let beside = random.length(3.0).abs();
    let p = one + beside * (normal + 0.5 * direction(random)).normalize();
    let sign = (p - one).dot(&(p - two).cross(&(p - three)));
    let p = if sign > 0.0 { one - (p - one) } else { p };
    closed(
        crank,
        [two, three],
        [one, two, three].map(|v| (p - v).norm()),
    )
}

pub(crate) const FORMS: &[Form] = forms![distances, mixed];

#[test]
fn cycles() {
    assert_eq!(THREE.reference_input(), PHI);
    let cases = cycle_cases(&THREE, &PLAN, 8, 231);
    compare(&THREE, FORMS, &cases, Depth::Full)
        .at_least(19)
        .check("cycles", &LIMITS);
}

linkage_reference::sets! { THREE, FORMS;
    dead_points "dead points": dead_point_cases(&PLAN, 4, 232), Usual, LIMITS, at least 55;
    proportions "proportions":
        proportion_cases(&PLAN, 20, 233), Usual, LIMITS.any_proportions(), at least 25;
    near_each_other "near points":
        decade_cases(near_points, 3, 234), Usual, LIMITS.any_proportions(), at least 30;
    scales "scales": scale_cases(&PLAN, 4, 235), Usual, LIMITS, at least 15;
}

#[test]
fn both_sides_of_the_dead_point() {
    edge(&THREE, FORMS, &PLAN, 2, 236).check("three distances");
}

// Two distances and a plane.

const TWO: System = System {
    name: "two distances and a plane",
    data: data! {
        length "crank" 10.0, "two.x" 60.0, "two.y" 5.0, "two.z" 3.0, "l1" 45.0, "l2" 57.0;
        ratio "normal.x" 0.1, "normal.y" 0.9, "normal.z" 0.2;
        length "height" 13.0;
        degrees "phi" 30.0;
    },
    parameters: 10,
    unknowns: unknowns! {
        slide "p.x" 25.0, "p.y" 21.0, "p.z" -40.0;
    },
    residual: |p| {
        vec![
            distance(p, &pin(p), "l1"),
            distance(p, &p.space("two"), "l2"),
            plane(p, "normal", "height"),
        ]
    },
    gap: |p| {
        let (one, l1) = (pin(p), p.value("l1"));
        let (normal, offset) = radical([(&one, l1), (&p.space("two"), p.value("l2"))]);
        let given = (&p.space("normal"), p.value("height"));
        let (on_line, direction) = planes_line([(&normal, &offset), given]);
        line_gap(l1, &one, (&on_line, &direction))
    },
    pairs: &[(4, 5), (0, 9)],
    ..System::PLAIN
};

macro_rules! two {
    ($name:ident [$($pairs:tt)*] { $($items:tt)* }) => {
        linkage_reference::form! {
            $name(phi) -> [p];
            $($pairs)*
            fields |g| {
                crank: g[0], two: [g[1], g[2], g[3]], l1: g[4], l2: g[5],
                normal: [g[6], g[7], g[8]], height: g[9]
            }
            {
                unit mm;
                param crank = 10mm;
                param two = (60mm, 5mm, 3mm);
                param l1 = 45mm;
                param l2 = 57mm;
                param normal = (0.1, 0.9, 0.2);
                param height = 13mm;
                input phi = 30deg in 0deg..360deg;
                unknown p = (25mm, 21mm, -40mm);
                let one = turn((crank, 0mm, 0mm), (0, 1, 0), phi);
                $($items)*
            }
        }
    };
}

two!(height_along_normal [pairs l1 l2, crank height;] {
    loop distance(p, one) = l1;
    loop distance(p, two) = l2;
    loop dot(normal, p) = height;
});

two!(point_in_plane [] {
    loop dot(normal, p - height / dot(normal, normal) * normal) = 0mm;
    loop l2 = norm(two - p);
    loop dot(p - one, p - one) = l1 * l1;
});

const TWO_PLAN: Plan = Plan {
    geometry: |random, spread| {
        let crank = random.length(spread);
        // As in the mechanism as written, the first distance is the shortest: the others refer to it.
        let mut lengths = [0; 2].map(|_| random.length(spread).abs());
        lengths.sort_by(f64::total_cmp);
        let size = random.ratio(0.5, 2.0);
        let [u1, u2, normal] = directions(random, 1.0);
        let p = pin_of(crank) + lengths[0] * u1;
        let (two, normal) = (p - lengths[1] * u2, size * normal);
        let height = normal.dot(&p);
        vec![
            crank, two.x, two.y, two.z, lengths[0], lengths[1], normal.x, normal.y, normal.z,
            height,
        ]
    },
    dead_points: &[(4, 1e-3), (5, 30.0), (9, 1e3)],
};

const TWO_FORMS: &[Form] = forms![height_along_normal, point_in_plane];

linkage_reference::sets! { TWO, TWO_FORMS;
    cycles_in_a_plane "cycles": cycle_cases(&TWO_PLAN, 8, 241), Full, LIMITS, at least 20;
    dead_points_in_a_plane "dead points": dead_point_cases(&TWO_PLAN, 4, 242), Usual, LIMITS, at least 55;
}

#[test]
fn proportions_and_scales() {
    let cases = proportion_cases(&TWO, &TWO_PLAN, 20, 243);
    compare(&TWO, TWO_FORMS, &cases, Depth::Usual)
        .at_least(25)
        .check("proportions", &LIMITS.any_proportions());
    let cases = scale_cases(&TWO, &TWO_PLAN, 4, 244);
    compare(&TWO, TWO_FORMS, &cases, Depth::Usual)
        .at_least(16)
        .check("scales", &LIMITS);
}

#[test]
fn both_sides_of_the_dead_point_in_a_plane() {
    edge(&TWO, TWO_FORMS, &TWO_PLAN, 2, 245).check("two distances and a plane");
}
