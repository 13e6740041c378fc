//! Suspensions from tables of hard points.

use super::{SPACE, compare};
use crate::hard_points;
use crate::solver::{Condition, Point, Points};

/// The points of a carrier and of the chassis, forward, left, up.
fn suspension(
    chassis: &[(&str, Point)],
    carrier: &[(&str, Point)],
    rods: &[(&str, &str)],
) -> Points {
    let mut facts = Points::default();
    for (name, at) in chassis {
        facts.add(name, *at, true);
    }
    let all: Vec<usize> = carrier
        .iter()
        .map(|(name, at)| facts.add(name, *at, false))
        .collect();
    facts.rigid(&all);
    let find = |facts: &Points, name: &str| {
        let mut names = facts.names.iter();
        names.position(|other| other == name).expect("a point")
    };
    for (a, b) in rods {
        let (a, b) = (find(&facts, a), find(&facts, b));
        facts.conditions.push(Condition::Distance(a, b));
    }
    let centre = find(&facts, "wheel_centre");
    facts.conditions.push(Condition::Coordinate(centre, 2, 1.0));
    // The chassis is not a result.
    for index in 0..chassis.len() {
        facts.names[index].clear();
    }
    facts
}

#[test]
fn a_double_wishbone() {
    let chassis = [
        ("lf", [180.0, 250.0, 125.0]),
        ("lr", [-175.0, 280.0, 126.0]),
        ("uf", [178.0, 252.0, 281.0]),
        ("ur", [-176.0, 280.0, 264.0]),
        ("ti", [76.0, 230.0, 201.0]),
        ("pivot", [30.0, 216.5, 498.0]),
        ("axis", [60.0, 218.5, 497.0]),
    ];
    let carrier = [
        ("lower_ball", [9.0, 560.0, 140.0]),
        ("upper_ball", [-15.0, 545.0, 324.0]),
        ("tie_outer", [76.0, 552.0, 241.0]),
        ("wheel_centre", [0.0, 600.0, 232.0]),
        ("contact", [0.0, 601.0, 0.0]),
    ];
    let rods = [
        ("lf", "lower_ball"),
        ("lr", "lower_ball"),
        ("uf", "upper_ball"),
        ("ur", "upper_ball"),
        ("ti", "tie_outer"),
    ];
    let mut facts = suspension(&chassis, &carrier, &rods);
    let find = |facts: &Points, at: Point| {
        let mut drawn = facts.drawn.iter();
        drawn.position(|other| *other == at).expect("a point")
    };
    // The end of the push rod is on the lower wishbone, a triangle that it does not leave: with a
    // point beside it, which is as far from both pivots and from the ball.
    let push = facts.add("push_lower", [15.0, 510.0, 138.5], false);
    let [lf, lr] = [chassis[0].1, chassis[1].1].map(|at| find(&facts, at));
    let ball = find(&facts, carrier[0].1);
    let above = facts.add("", [10.0, 400.0, 400.0], false);
    for other in [lf, lr, ball] {
        facts.conditions.push(Condition::Distance(push, other));
        facts.conditions.push(Condition::Distance(above, other));
    }
    facts.conditions.push(Condition::Distance(push, above));
    let [pivot, axis] = [chassis[5].1, chassis[6].1].map(|at| find(&facts, at));
    let rocker = facts.add("push_rocker", [30.0, 243.0, 520.0], false);
    let damper = facts.add("damper_rocker", [30.0, 188.5, 526.0], false);
    for point in [rocker, damper] {
        facts.conditions.push(Condition::Distance(point, pivot));
        facts.conditions.push(Condition::Distance(point, axis));
    }
    facts.rigid(&[rocker, damper]);
    facts.rigid(&[push, rocker]);
    compare(
        "double_wishbone.csv",
        &hard_points("forward,left,up", "left"),
        &facts,
        &SPACE,
    );
}

#[test]
fn a_strut_with_other_axes() {
    // The file has x to the rear and y to the right.
    let of_file = |p: Point| [-p[0], -p[1], p[2]];
    let chassis = [
        ("lf", of_file([-150.0, 350.0, 200.0])),
        ("lr", of_file([180.0, 345.0, 205.0])),
        ("ti", of_file([130.0, 330.0, 240.0])),
        ("top", of_file([40.0, 560.0, 850.0])),
    ];
    let carrier = [
        ("lower_ball", of_file([0.0, 700.0, 185.0])),
        ("tie_outer", of_file([135.0, 690.0, 235.0])),
        ("wheel_centre", of_file([0.0, 750.0, 300.0])),
        ("strut_bottom", of_file([10.0, 640.0, 400.0])),
        ("damper_carrier", of_file([0.0, 690.0, 250.0])),
        // A third of the way up the strut.
        ("", of_file([20.0, 640.0 - 80.0 / 3.0, 550.0])),
    ];
    let rods = [
        ("lf", "lower_ball"),
        ("lr", "lower_ball"),
        ("ti", "tie_outer"),
    ];
    let mut facts = suspension(&chassis, &carrier, &rods);
    let count = facts.names.len();
    facts
        .conditions
        .push(Condition::Line(3, count - 3, count - 1));
    compare(
        "strut.yaml",
        &hard_points("rear,right,up", "right"),
        &facts,
        &SPACE,
    );
}

#[test]
fn five_rods_with_names_of_the_file() {
    let mut options = hard_points("forward,left,up", "left");
    for number in 1..=5 {
        options.roles.push(format!("rod{number}_inner=P{number}"));
        options.roles.push(format!("rod{number}_outer=Q{number}"));
    }
    options.roles.push("wheel_centre=hub".to_owned());
    let chassis = [
        ("P1", [110.0, 420.0, 430.0]),
        ("P2", [-85.0, 435.0, 440.0]),
        ("P3", [265.0, 480.0, 265.0]),
        ("P4", [-60.0, 255.0, 215.0]),
        ("P5", [-190.0, 316.0, 258.0]),
    ];
    let carrier = [
        ("rod1_outer", [15.0, 690.0, 455.0]),
        ("rod2_outer", [-30.0, 685.0, 460.0]),
        ("rod3_outer", [40.0, 700.0, 215.0]),
        ("rod4_outer", [-25.0, 705.0, 200.0]),
        ("rod5_outer", [-150.0, 690.0, 262.0]),
        ("wheel_centre", [0.0, 760.0, 320.0]),
    ];
    let rods = [
        ("P1", "rod1_outer"),
        ("P2", "rod2_outer"),
        ("P3", "rod3_outer"),
        ("P4", "rod4_outer"),
        ("P5", "rod5_outer"),
    ];
    let facts = suspension(&chassis, &carrier, &rods);
    compare("five_rods.csv", &options, &facts, &SPACE);
}
