//! Every message about expressions, once.

use super::dimensions::with_let;
use super::{check, last_of};

#[test]
fn expressions() {
    for (value, expected) in [
        (
            "zreo + a",
            "unknown name `zreo`\nhelp: did you mean `zero`?",
        ),
        ("pi * l", "unknown name `pi`\nhelp: did you mean `PI`?"),
        ("norm * l", "`norm` is a function: write `norm(...)`"),
        ("elsewhere", "help: declare it in the struct block"),
        ("m2", "with `let`; units are written `m^2`"),
        (
            "l + a",
            "cannot add a length and an angle\nhelp: both must have the same dimension",
        ),
        (
            "l - 3",
            "cannot subtract a number from a length\nhelp: give the number its unit: `3mm`",
        ),
        (
            "l + p",
            "cannot add a length and a plane vector of lengths\nhelp: write a vector",
        ),
        (
            "p + s",
            "cannot add `p` (a plane vector of lengths) and `s` (a space vector of lengths)\nhelp: write `(p.x, p.y, 0)`, or declare `p` as `(x, y, z)`",
        ),
        (
            "(l + zero) * sin(zero)",
            "help: declare `zero` with a unit: `0mm` or `0deg`",
        ),
        (
            "p * q",
            "a product of two vectors (2 and 2 components)\nhelp: write `dot(a, b)` or `cross(a, b)`",
        ),
        (
            "l / p",
            "cannot divide by a vector\nhelp: divide by `norm(v)`",
        ),
        ("sqrt(sqrt(l))", "not a multiple of one half"),
        (
            "(l, a)",
            "the components of a vector differ in dimension: a length and an angle",
        ),
        ("(l,)", "a vector has two or three components, found 1"),
        ("(l, l, l, l)", "found 4"),
        (
            "(p, l)",
            "a component must be a scalar, found a plane vector of lengths\nhelp: write `(p.x, p.y, l)`",
        ),
        (
            "(l, p)",
            "found a plane vector of lengths\nhelp: take a component of it: `.x`",
        ),
        (
            "p.z",
            "a plane vector of lengths has no component `z`\nhelp: components are `.x`, `.y`; a space vector is written `(x, y, z)`",
        ),
        (
            "s.w",
            "a space vector of lengths has no component `w`\nhelp: components are `.x`, `.y`, `.z`",
        ),
        (
            "l.x",
            "a length has no component `x`\nhelp: only vectors have components",
        ),
        (
            "p[0]",
            "a plane vector of lengths has no entries\nhelp: components of a vector are",
        ),
        ("[l, k]", "a list in brackets cannot stand here"),
        ("1e400", "`1e400` is too large for a 64-bit number"),
        ("1e-400mm", "`1e-400mm` is so small that it becomes zero"),
        (
            "polar(a, l)",
            "the arguments of `polar` are swapped: found an angle and a length\nhelp: write `polar(length, angle)`",
        ),
        (
            "rotate(a, p)",
            "the arguments of `rotate` are swapped: found an angle and a plane vector of lengths\nhelp: write `rotate(vector, angle)`",
        ),
        (
            "rotate(s, a)",
            "`rotate` takes a plane vector here, found a space vector of lengths\nhelp: `turn(v, axis, angle)` turns space vectors",
        ),
        (
            "rotate(a, s)",
            "the arguments of `rotate` are swapped: found an angle and a space vector of lengths\nhelp: write `turn(vector, axis, angle)`",
        ),
        (
            "rotate(s, t, a)",
            "`rotate` takes 2 arguments, found 3\nhelp: write `turn(vector, axis, angle)` for a space vector",
        ),
        (
            "turn(s, a, t)",
            "the arguments of `turn` are swapped: found a space vector of lengths, an angle and a space vector of numbers\nhelp: write `turn(vector, axis, angle)`",
        ),
        (
            "turn(p, t, a)",
            "`turn` takes a space vector here, found a plane vector of lengths\nhelp: write `(p.x, p.y, 0)`, or declare `p` as `(x, y, z)`; `rotate(v, angle)` turns plane vectors",
        ),
        (
            "turn(s, (0, n), a)",
            "`turn` takes a space vector here, found a plane vector of numbers\nhelp: give it a third component: `(0, n, 0)`",
        ),
        (
            "polar(l, k)",
            "`polar` takes an angle or a number here, found a length",
        ),
        (
            "polar(p, a)",
            "`polar` takes a scalar here, found a plane vector of lengths",
        ),
        (
            "sin(l)",
            "`sin` takes an angle or a number here, found a length",
        ),
        ("sin(p)", "help: `angle(v)` is the angle of a plane vector"),
        ("asin(l)", "`asin` takes an angle or a number here"),
        (
            "atan2(l, a)",
            "the arguments of `atan2` differ in dimension: a length and an angle",
        ),
        ("min(l, 3)", "help: give the number its unit: `3mm`"),
        ("hypot(p, q)", "`hypot` takes a scalar here"),
        (
            "distance(l, k)",
            "`distance` takes a vector here, found a length",
        ),
        (
            "distance(p, s)",
            "the arguments of `distance` differ: `p` (a plane vector of lengths) and `s` (a space vector of lengths)\nhelp: write `(p.x, p.y, 0)`",
        ),
        (
            "dot(p, s)",
            "the arguments of `dot` differ: `p` (a plane vector of lengths) and `s` (a space vector of lengths)",
        ),
        (
            "cross(s, -polar(l, a))",
            "the arguments of `cross` differ: `s` (a space vector of lengths) and a plane vector of lengths\nhelp: `polar` makes plane vectors; in space write `turn((l, 0, 0), (0, 0, 1), a)`",
        ),
        (
            "s - dir(a)",
            "cannot subtract a plane vector of numbers from `s` (a space vector of lengths)\nhelp: `dir` makes plane vectors; in space write `turn((1, 0, 0), (0, 0, 1), a)`",
        ),
        (
            "s + (l, s.x)",
            "help: give it a third component: `(l, s.x, 0)`",
        ),
        (
            "s + rotate(p, a)",
            "help: `rotate` turns plane vectors; in space write `turn((p.x, p.y, 0), (0, 0, 1), a)`",
        ),
        (
            "s + (p + q)",
            "help: name the plane vector, `let p = ...;`, and write `(p.x, p.y, 0)`",
        ),
        (
            "s + l",
            "help: write a vector `(x, y, z)` on both sides, or take a component `.x`",
        ),
        (
            "cross(s, l)",
            "`cross` takes a space vector here, found a length\nhelp: write it as `(x, y, z)`",
        ),
        (
            "unit(l)",
            "`unit` takes a vector here, found a length\nhelp: write it as `(x, y)` or `(x, y, z)`",
        ),
        (
            "angle(s)",
            "`angle` takes a plane vector here, found a space vector of lengths\nhelp: the angle between two directions in space is `atan2(norm(cross(a, b)), dot(a, b))`",
        ),
        (
            "triangle_angle(l, k, a)",
            "the arguments of `triangle_angle` differ",
        ),
        (
            "norm(p, q)",
            "`norm` takes 1 argument, found 2\nhelp: write `norm(vector)`",
        ),
        (
            "nrm(p)",
            "unknown function `nrm`\nhelp: did you mean `norm`?",
        ),
        ("frobnicate(p)", "help: functions are polar dir"),
        ("pow(l, 2)", "help: write `a * a` for a square"),
        (
            "l(2)",
            "`l` is a parameter, not a function\nhelp: write `l * (...)` for a product",
        ),
        (
            "velocity(p)",
            "`velocity` is only known in the functions of the `impl` block",
        ),
        ("d(p, l)", "`d` is only known in the functions"),
        ("value + 1", "`value` is used in its own definition"),
        ("nope + nope2", "unknown name `nope`"),
    ] {
        let both = ["unknown name `nope`", "unknown name `nope2`"];
        match value {
            "nope + nope2" => check(&with_let(value), &both),
            _ => check(&with_let(value), &[expected]),
        }
    }
}

#[test]
fn parts() {
    const BAR: &str = "struct Bar { unit mm; param way = 2mm; input phi = 0deg at omega; let tip = polar(way, phi); \
        body crank = pin hub on frame at (0, 0), turns phi, mass 20g at tip; } ";
    for (machine, message) in [
        (
            "struct M { input s = 0deg; part bar: Bar { phi = s }; } impl M { fn f(s) -> F { r: reaction(bar.hob) } }",
            "unknown joint `bar.hob`\nhelp: did you mean `bar.hub`?",
        ),
        (
            "struct M { input s = 0deg; part bar: Bar { phi = s }; } impl M { fn f(s) -> F { r: reaction(bar.crank) } }",
            "`bar.crank` is a body, not a joint\nhelp: it hangs on the joint `bar.hub`",
        ),
        (
            "struct M { input s = 0deg; part bar: Bar { phi = s }; part bars: Bar { phi = bar.phi + bars.phi }; }",
            "`bars.phi` is used in its own definition",
        ),
        (
            "struct M { input s = 0deg; part bar: Bar { phi = s }; let a = 1mm + bar; }",
            "`bar` is a part, which has no value of its own",
        ),
        (
            "struct M { input s = 0deg; argument load = 3; part bar: Bar { phi = s * load }; }",
            "the input `phi` of the part `bar` depends on the argument `load`",
        ),
        (
            "struct M { input s = 0deg; part bar: Bar { phi = s } at frame((0, 0, 0), (1, 0, 0), (0, 0, 1)); }",
            "the part `bar` has vectors of the plane, and stands at a place of space",
        ),
    ] {
        let (_, messages) = last_of(&format!("{BAR}{machine}"));
        let [found] = &messages[..] else {
            panic!("{machine}: {messages:#?}");
        };
        assert!(found.contains(message), "{machine}: {found}");
    }
}
