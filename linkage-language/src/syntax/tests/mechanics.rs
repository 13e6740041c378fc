//! Bodies, joints and loads.

use proc_macro2::{Delimiter, Group, TokenStream, TokenTree};

use super::{item, read};
use crate::diagnostic::Diagnostics;
use crate::syntax::{dump, parse};

const PRESS: &str = "struct Press { unit mm;
    argument press = 500mm;
    input phi = 30deg in 0deg..360deg at omega, epsilon;
    gravity = (0, -9.80665m/s^2);
    body crank   = pin b1 on frame at pivot_1, turns phi12, mass 129.94mm at c1, inertia 31114.78mm*mm^2 at pivot_1;
    body coupler = pin b2 on crank at p2, turns phi23, mass 91.15mm at c2, inertia 49663.7mm*mm^2;
    body needle  = slide b11 on rocker at p9 along dir(phi56), turns phi56, mass m2 at p2 + polar(r, phi), inertia i;
    pin b3 = coupler on rocker at p3;
    force (0, -press) on needle at p10;
    torque 3mm*mm on crank from rocker;
    spring 2.5mm/mm from frame at q to rocker at p3, free 40mm;
    spring 300mm*mm on b4, free 20deg;
    damper 0.2mm*s/mm from frame at q to rocker at p3;
    damper 5mm*mm*s on b4;
    friction 0.1 on b4 radius 8mm; friction mu / 2 on b11, length 3 * r;
    } impl Press { fn statics(phi12, press) -> Statics { t: torque(phi12) } }";

#[test]
fn the_press() {
    let (text, messages) = read(PRESS);
    assert_eq!(messages, Vec::<String>::new());
    let expected = "struct Press
  unit mm
  argument press = 500mm
  input phi = 30deg in 0deg..360deg at omega, epsilon
  gravity = (0, ((-9.80665m) / s^2))
  body crank = pin b1 on frame at pivot_1, turns phi12, mass 129.94mm at c1, inertia (31114.78mm * mm^2) at pivot_1
  body coupler = pin b2 on crank at p2, turns phi23, mass 91.15mm at c2, inertia (49663.7mm * mm^2)
  body needle = slide b11 on rocker at p9 along dir(phi56), turns phi56, mass m2 at (p2 + polar(r, phi)), inertia i
  pin b3 = coupler on rocker at p3
  force (0, (-press)) on needle at p10
  torque (3mm * mm) on crank from rocker
  spring (2.5mm / mm) from frame at q to rocker at p3, free 40mm
  spring (300mm * mm) on b4, free 20deg
  damper ((0.2mm * s) / mm) from frame at q to rocker at p3
  damper ((5mm * mm) * s) on b4
  friction 0.1 on b4, radius 8mm
  friction (mu / 2) on b11, length (3 * r)
fn statics(phi12, press) -> Statics
  t: torque(phi12)
";
    assert_eq!(text, expected);
}

/// Sources, and the tree printed as text. The text is read to the same tree.
#[test]
fn items() {
    for (source, expected) in [
        ("argument a = 3;", "argument a = 3"),
        ("input a = 1 at w;", "input a = 1 at w"),
        (
            "input a = 1 in 0..2 at w, e;",
            "input a = 1 in 0..2 at w, e",
        ),
        (
            "input a = 1 at w, e in 0..=2;",
            "input a = 1 in 0..2 at w, e",
        ),
        ("gravity = g * e;", "gravity = (g * e)"),
        ("body a = pin on frame at p;", "body a = pin on frame at p"),
        (
            "body a = cylinder j along u on b inertia i at q mass m at p at o turns t mass n at q;",
            "body a = cylinder j on b at o about u, turns t, mass m at p, mass n at q, inertia i at q",
        ),
        (
            "body a = slide on b, inertia i, at o, along v,;",
            "body a = slide on b at o along v, inertia i",
        ),
        (
            "/// Words.\n body a = ball on b at o",
            "body a = ball on b at o",
        ),
        (
            "pin j = a on b at o about u;",
            "pin j = a on b at o about u",
        ),
        (
            "slide j = a at o, along v, on b;",
            "slide j = a on b at o along v",
        ),
        ("ball j = a on b at o;", "ball j = a on b at o"),
        (
            "cylinder j = a on b at o about u;",
            "cylinder j = a on b at o about u",
        ),
        ("fixed j = a on b at o;", "fixed j = a on b at o"),
        (
            "force f at p + q from c on b;",
            "force f on b from c at (p + q)",
        ),
        (
            "force -f.x * (0, 1) on b at p;",
            "force ((-f.x) * (0, 1)) on b at p",
        ),
        ("torque t on b;", "torque t on b"),
        ("spring k on j;", "spring k on j"),
        (
            "spring k free l to b at q from a at p;",
            "spring k from a at p to b at q, free l",
        ),
        ("damper k on j;", "damper k on j"),
    ] {
        assert_eq!(item(source), expected, "{source}");
        assert_eq!(item(expected), expected);
    }
}

/// Words of items and clauses are names like others where values stand.
#[test]
fn words_as_names() {
    for (source, expected) in [
        ("param force = 3;", "param force = 3"),
        (
            "let spring = body + pin * at;",
            "let spring = (body + (pin * at))",
        ),
        ("loop gravity = torque;", "loop gravity = torque"),
        ("let mass = force(on, to);", "let mass = force(on, to)"),
        (
            "input damper = free in from..to at at, on;",
            "input damper = free in from..to at at, on",
        ),
        ("argument at = on;", "argument at = on"),
        (
            "body at = pin body on pin at at;",
            "body at = pin body on pin at at",
        ),
        (
            "body a = pin on b at on + at, turns turns, mass mass at at, inertia on at from;",
            "body a = pin on b at (on + at), turns turns, mass mass at at, inertia on at from",
        ),
        (
            "force force on force at force;",
            "force force on force at force",
        ),
        (
            "torque spring on b from force;",
            "torque spring on b from force",
        ),
        ("torque mass on b;", "torque mass on b"),
        (
            "spring spring on spring free free;",
            "spring spring on spring, free free",
        ),
        ("pin on = a on b at body;", "pin on = a on b at body"),
    ] {
        assert_eq!(item(source), expected, "{source}");
    }
}

/// One missing token is one mistake at most, and no other item is lost.
#[test]
fn a_missing_token_is_one_mistake() {
    let tokens: TokenStream = PRESS.parse().expect("the source has tokens");
    let mut tokens: Vec<TokenTree> = tokens.into_iter().collect();
    let TokenTree::Group(block) = tokens[2].clone() else {
        panic!("the struct block is the third token");
    };
    let block: Vec<TokenTree> = block.stream().into_iter().collect();
    let lines = read(PRESS).0.lines().count();
    for missing in 0..block.len() {
        let mut rest = block.clone();
        rest.remove(missing);
        tokens[2] = TokenTree::Group(Group::new(Delimiter::Brace, rest.into_iter().collect()));
        let mut diagnostics = Diagnostics::default();
        let definition = parse(tokens.iter().cloned().collect(), &mut diagnostics).pop();
        let text = dump(&definition.expect("a struct block"));
        let message = format!(
            "token {missing}, `{}`: {diagnostics:#?}\n{text}",
            block[missing]
        );
        assert!(diagnostics.len() <= 1, "{message}");
        assert!(text.lines().count() + 1 >= lines, "{message}");
    }
}

#[test]
fn the_rest_survives_a_mistake() {
    let (text, messages) = read(
        "struct A {
            body a = pin j on frame at + , turns t, mass at p, inertia i
            body b = hinge on a at q
            pin = a on b at p;
            force (0, 1) on b
            force f at p;
            spring 3 from a at p
            gravity = ;
            torque 3 on b at p
            let x = 3
            damper 4 on j
            gravity = (0, 1)
            param y = force
            param z = 3;
        }",
    );
    let expected = "struct A
  body a = pin j on frame at <error>, turns t, mass <error> at p, inertia i
  body b = pin on a at q
  torque 3 on b
  let x = 3
  damper 4 on j
  gravity = (0, 1)
  param y = force
  param z = 3
";
    assert_eq!(text, expected, "{messages:#?}");
    let lacking = "the item lacks its `;`\nhelp: write `;` here";
    let missing = messages.iter().filter(|message| *message == lacking);
    assert_eq!(missing.count(), 7, "{messages:#?}");
    assert_eq!(messages.len(), 7 + 9, "{messages:#?}");
}
