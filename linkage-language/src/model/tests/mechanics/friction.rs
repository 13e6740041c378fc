//! Mistakes in friction of joints.

use super::super::check;
use super::{PLANE, in_plane, in_space};

#[test]
fn friction_of_pins_and_slides() {
    let slide = "slide b5 = crank on frame at p along dir(phi); friction 0.1 on b5";
    in_plane(&[
        ("friction 0.1 on b1, radius 8mm;", &[]),
        ("friction crank / 300mm on b1 radius crank / 4;", &[]),
        (&format!("{slide};"), &[]),
        (&format!("{slide}, length 40mm;"), &[]),
        (
            "friction 0.1 on b1;",
            &[
                "the friction of the pin `b1` lacks its radius\nhelp: the force of friction acts on the surface: `friction 0.1 on b1, radius 8mm`",
            ],
        ),
        (
            "friction 0.1 on b1, radius 8mm, length 40mm;",
            &[
                "the friction of the pin `b1` has a `length`, which is that of a slide's block\nhelp: leave out `length`",
            ],
        ),
        (
            &format!("{slide}, radius 8mm;"),
            &[
                "the friction of the slide `b5` has a `radius`, which is that of a pin\nhelp: leave out `radius`",
            ],
        ),
        (
            "friction 3N on b1, radius 8mm;",
            &["`friction` takes a number, found a force\nhelp: write it like `0.1`"],
        ),
        (
            "friction 0.1 on b1, radius 8deg;",
            &["`radius` takes a length, found an angle\nhelp: write it like `8mm`"],
        ),
        (
            "friction 0.1 on b7, radius 8mm;",
            &["unknown joint `b7`\nhelp: did you mean `b1`?"],
        ),
        (
            "friction 0.1 on crank, radius 8mm;",
            &["`crank` is a body, not a joint\nhelp: it hangs on the joint `b1`"],
        ),
        (
            "fixed b6 = crank on frame at p; friction 0.1 on b6;",
            &["`b6` is a `fixed`\nhelp: friction acts in a `pin` or in a `slide`"],
        ),
        (
            "friction 0.1 on b1, radius 8mm; friction 0.2 on b1, radius 8mm;",
            &["a second `friction` on `b1`\nhelp: write the sum of both in one item"],
        ),
    ]);
}

#[test]
fn friction_where_it_is_not_computed() {
    in_space(&[(
        "friction 0.1 on b1, radius 8mm;",
        &[
            "friction of joints in space is not computed\nhelp: write what resists as `damper VALUE on b1`, or as a load",
        ],
    )]);
    check(
        "struct A { unit mm; input phi = 30deg; body crank = pin b1 on frame at (0mm, 0mm), turns phi;
            friction 0.1 on b1, radius 8mm; }",
        &[
            "friction acts against a speed, and no input has one\nhelp: name the speed of an input and list it in functions: `input phi = ... at omega`",
        ],
    );
}

#[test]
fn quantities_of_friction() {
    let asked = |item: &str, function: &str, messages: &[&str]| {
        check(
            &format!("struct A {{ {PLANE} {item} }} impl A {{ {function} }}"),
            messages,
        );
    };
    let friction = "friction 0.1 on b1, radius 8mm;";
    asked(
        friction,
        "fn f(phi, omega) -> F { e: efficiency() + 3, p: friction_power() + power(), q: generalised_force(phi) }",
        &[],
    );
    asked(
        friction,
        "fn f(phi, omega) -> F { e: efficiency(phi) }",
        &["`efficiency` takes no argument, found 1\nhelp: write `efficiency()`"],
    );
    asked(
        friction,
        "fn f(phi) -> F { e: efficiency(), p: friction_power() }",
        &[
            "`efficiency` is that of a motion: the function lists no speed\nhelp: list the speed as an argument: `omega`",
            "`friction_power` at rest is zero: the function lists no speed",
        ],
    );
    asked(
        "",
        "fn f(phi, omega) -> F { e: efficiency(), p: friction_power() }",
        &[
            "`efficiency` in a mechanism without friction\nhelp: declare it: `friction 0.1 on PIN, radius 8mm`, `friction 0.1 on SLIDE`",
            "`friction_power` in a mechanism without friction",
        ],
    );
}
