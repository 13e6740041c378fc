//! Frames: types, and every message about them.

use super::dimensions::NAMES;
use super::{check, model};
use crate::model::dump;

const BODY: &str = "const fixed = frame((1mm, 0mm, 0mm), (0, 1, 0), (1, 0, 0)); \
    let body = frame(s, (cos(b), sin(b), 0), t);";

fn with_items(items: &str) -> String {
    format!("struct A {{ {NAMES} {BODY} {items} }}")
}

fn with_function(inputs: &str, quantity: &str) -> String {
    format!("struct A {{ {NAMES} {BODY} }} impl A {{ fn f({inputs}) -> F {{ q: {quantity} }} }}")
}

#[test]
fn types() {
    for (quantity, expected) in [
        ("body", "q: body: a frame"),
        ("fixed", "q: fixed: a frame"),
        ("frame(0, s, t)", "frame((0.0, 0.0, 0.0), s, t): a frame"),
        (
            "frame((0, 0, 0), s, (0, 0, 1))",
            "frame((0.0, 0.0, 0.0), s, (0.0, 0.0, 1.0)): a frame",
        ),
        ("body.origin", "body.origin: a space vector of lengths"),
        ("body.y", "body.y: a space vector of numbers"),
        ("body.z.x", "body.z.x: a number"),
        ("point_in(body, s)", "a space vector of lengths"),
        (
            "point_in(fixed, 0)",
            "point_in(fixed, (0.0, 0.0, 0.0)): a space vector of lengths",
        ),
        (
            "coordinates_in(body, fixed.origin).z",
            "coordinates_in(body, fixed.origin).z: a length",
        ),
        (
            "velocity(point_in(body, (1mm, 0, 0)))",
            "a space vector of lengths",
        ),
        ("d(body.x, s.x)", "a space vector of length^-1"),
    ] {
        let (mechanism, messages) = model(&with_function("b", quantity));
        let mechanism = mechanism.unwrap_or_else(|| panic!("{quantity}: {messages:#?}"));
        let text = dump(&mechanism);
        assert!(text.trim_end().ends_with(expected), "{quantity}: {text}");
    }
}

#[test]
fn constant_frames_may_stand_in_defaults() {
    let (mechanism, messages) = model(&with_items(
        "param place = point_in(fixed, (1mm, 2mm, 3mm)) +- 0.1mm; unknown at = fixed.origin;",
    ));
    assert!(mechanism.is_some(), "{messages:#?}");
}

#[test]
fn arguments() {
    for (value, expected) in [
        (
            "frame(s, t)",
            "`frame` takes 3 arguments, found 2\nhelp: write `frame(origin, x, z)`",
        ),
        (
            "frame(p, s, t)",
            "`frame` takes a space vector here, found a plane vector of lengths\n\
             help: write `(p.x, p.y, 0)`",
        ),
        ("frame(s, (0, 0), t)", "found a plane vector of numbers"),
        ("frame(s, t, u)", "found a plane vector of numbers"),
        (
            "frame(s, l, t)",
            "`frame` takes a space vector here, found a length\nhelp: write it as `(x, y, z)`",
        ),
        (
            "frame(unit(s), s, t)",
            "the origin of a frame is a space vector of lengths, found a space vector of numbers\n\
             help: give its components a unit, or multiply it by a length",
        ),
        (
            "frame(l * s, s, t)",
            "found a space vector of length^2\nhelp: divide by a length",
        ),
        (
            "point_in(s, body)",
            "the arguments of `point_in` are swapped: found a space vector of lengths and a frame\n\
             help: write `point_in(frame, vector)`",
        ),
        (
            "coordinates_in(p, body)",
            "found a plane vector of lengths and a frame\nhelp: write `coordinates_in(frame, point)`",
        ),
        (
            "point_in(s, s)",
            "`point_in` takes a frame here, found a space vector of lengths\n\
             help: `frame(origin, x, z)` makes a frame",
        ),
        (
            "point_in(body, p)",
            "`point_in` takes a space vector here, found a plane vector of lengths",
        ),
        (
            "point_in(body, fixed)",
            "a frame cannot be used in an expression\nhelp: take `fixed.origin`, an axis",
        ),
        (
            "point_in(body, unit(s))",
            "coordinates in a frame are a space vector of lengths, found a space vector of numbers",
        ),
        (
            "coordinates_in(body, unit(s))",
            "a point is a space vector of lengths, found a space vector of numbers",
        ),
    ] {
        check(&with_items(&format!("let value = {value};")), &[expected]);
    }
}

#[test]
fn places() {
    let parts = "help: take `body.origin`, an axis like `body.x`, or `point_in(body, v)`";
    for value in [
        "body + s",
        "2 * body",
        "-body",
        "norm(body)",
        "frame(body, s, t)",
        "(body, l)",
        "min(body, l)",
    ] {
        let expected = format!("a frame cannot be used in an expression\n{parts}");
        check(&with_items(&format!("let value = {value};")), &[&expected]);
    }
    let consists = "found a frame\nhelp: declare what it consists of, and the frame with `let`";
    for (items, expected) in [
        (
            "let value = body.w;",
            "a frame has no part `w`\nhelp: parts of a frame are `.origin`, `.x`, `.y` and `.z`",
        ),
        (
            "let value = body[0];",
            "a frame has no entries\nhelp: parts of a frame are",
        ),
        ("param value = fixed; let more = value + l;", consists),
        (
            "param value = 1mm +- fixed;",
            "the nominal value is a length, its tolerance a frame",
        ),
        ("input value = fixed;", consists),
        ("unknown value = fixed;", consists),
        (
            "loop body = fixed;",
            "the sides of a loop are scalars or vectors, found a frame\nhelp: write a loop for `.origin`",
        ),
        (
            "loop body = 0;",
            "the sides of a loop are scalars or vectors",
        ),
        (
            "const value = body;",
            "`body` is a derived quantity, which cannot be used here",
        ),
    ] {
        check(&with_items(items), &[expected]);
    }
}

#[test]
fn derivatives() {
    let help = "help: differentiate `body.origin`, an axis like `body.x`, or `point_in(body, v)`";
    for quantity in [
        "d(body, l)",
        "velocity(body)",
        "acceleration(body)",
        "sensitivity(body)",
        "sensitivity(frame(s, t, s), [l])",
    ] {
        let expected = format!("a frame has no derivative\n{help}");
        check(&with_function("b", quantity), &[&expected]);
    }
    check(
        &with_function("b", "d(s, body)"),
        &["derivative with respect to `body`, a derived quantity"],
    );
}
