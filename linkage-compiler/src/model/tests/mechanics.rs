//! What is said about mistakes in bodies, joints and loads.

use super::{check, model};

const PLANE: &str = "unit mm; param crank = 30mm; unknown psi = 40deg; let p = polar(crank, phi);
    let q = (90mm, 0mm) + polar(20mm, psi); loop distance(p, q) = 80mm; argument press = 500N;
    input phi = 30deg in 0deg..360deg at omega, epsilon;
    body crank = pin b1 on frame at (0, 0), turns phi, mass 100g at p / 2;";
const SPACE: &str = "unit mm; param crank = 30mm; param tilt = 5deg; argument press = 500N;
    input phi = 30deg in 0deg..360deg at omega; input lift = 3mm;
    let p = turn((crank, 0mm, 0mm), (0, 0, 1), phi); let arm = frame((0, 0, 0), p, (0, 0, 1));
    body crank = pin b1 on frame at (0, 0, 0) about (0, 0, 1), turns phi, mass 100g at p / 2;";

/// Each item behind the plane mechanism, and the parts of its messages.
fn in_plane(cases: &[(&str, &[&str])]) {
    for (item, messages) in cases {
        check(&format!("struct A {{ {PLANE} {item} }}"), messages);
    }
}

fn in_space(cases: &[(&str, &[&str])]) {
    for (item, messages) in cases {
        check(&format!("struct A {{ {SPACE} {item} }}"), messages);
    }
}

/// Each quantity in a function of everything.
fn asked(cases: &[(&str, &[&str])]) {
    let items = "body rocker = pin b4 on frame at (90mm, 0), turns psi;
        body needle = slide on rocker at q along dir(psi); pin b2 = crank on rocker at p; input lift = 3mm;";
    for (quantity, messages) in cases {
        let function = format!("fn f(phi, omega) -> F {{ a: {quantity} }}");
        let source = format!("struct A {{ {PLANE} {items} }} impl A {{ {function} }}");
        check(&source, messages);
    }
}

#[test]
fn names_of_bodies_and_joints() {
    in_plane(&[
        ("body phi = pin crank_pin on crank at p, turns psi;", &[]),
        (
            "body crank = pin on frame at p, turns psi;",
            &[
                "the name `crank` is given to two bodies or joints\nhelp: choose another name",
                "`crank` is first defined here",
            ],
        ),
        (
            "body b1 = pin on frame at p, turns psi;",
            &[
                "the name `b1` is given to two bodies or joints",
                "`b1` is first",
            ],
        ),
        (
            "pin b1 = crank on frame at p;",
            &[
                "the name `b1` is given to two bodies or joints",
                "`b1` is first",
            ],
        ),
        (
            "body frame = pin on crank at p, turns psi;",
            &["`frame` is the fixed link\nhelp: choose another name"],
        ),
        (
            "body __a = pin on crank at p, turns psi;",
            &["the name `__a` starts with `__`"],
        ),
        (
            "body rod = pin on crnk at p, turns psi;",
            &["unknown body `crnk`\nhelp: did you mean `crank`?"],
        ),
        (
            "force (0, 1N) on press at p;",
            &["unknown body `press`\nhelp: bodies are `crank`, `frame`"],
        ),
        (
            "force (0, 1N) on b1 at p;",
            &["`b1` is a joint, not a body"],
        ),
        (
            "spring 1N*mm on crank;",
            &[
                "`crank` is a body, not a joint\nhelp: give the joint that it hangs on a name: `pin NAME on ...`",
            ],
        ),
        (
            "spring 1N*mm on b2;",
            &["unknown joint `b2`\nhelp: did you mean `b1`?"],
        ),
    ]);
}

#[test]
fn what_bodies_hang_on() {
    in_plane(&[
        (
            "body rod = fixed on rocker at p; body rocker = fixed on crank at q;",
            &[],
        ),
        (
            "body rod = fixed on rod at p;",
            &["`rod` hangs on itself\nhelp: let one of them hang on `frame`"],
        ),
        (
            "body x = fixed on y at p; body y = fixed on z at p; body z = fixed on y at q;",
            &["`y` hangs on itself: on `z`, on `y`"],
        ),
        (
            "pin b2 = frame on crank at p;",
            &[
                "the body of a joint moves, `frame` does not\nhelp: name the frame second: `pin NAME = BODY on frame`",
            ],
        ),
        (
            "pin b2 = crank on crank at p;",
            &["a joint between `crank` and itself\nhelp: name two bodies"],
        ),
    ]);
}

#[test]
fn joints_of_the_plane() {
    in_plane(&[
        ("slide s = crank on frame at p along q - p;", &[]),
        (
            "ball s = crank on frame at p;",
            &["a `ball` in the plane\nhelp: write `pin`"],
        ),
        (
            "cylinder s = crank on frame at p along (1, 0);",
            &["a `cylinder` in the plane\nhelp: write `slide`"],
        ),
        (
            "slide s = crank on frame at p;",
            &["a `slide` without `along`\nhelp: name the direction of its guide: `along dir(phi)`"],
        ),
        (
            "pin s = crank on frame at p about (1, 0);",
            &["a `pin` in the plane has no axis to choose\nhelp: leave out `about`"],
        ),
        (
            "slide s = crank on frame at p along phi;",
            &["`along` takes a vector, found an angle\nhelp: write it like `dir(phi)`"],
        ),
        (
            "pin s = crank on frame at press * (1, 0);",
            &["`at` takes a plane vector of lengths, found a plane vector of forces"],
        ),
        (
            "pin s = crank on frame at 0;",
            &["`at` takes a plane vector of lengths, found zero"],
        ),
        (
            "pin s = crank on frame at (0, 0, 0);",
            &[
                "`at` takes a space vector of lengths, but the bodies before it are in the plane\nhelp: leave out",
            ],
        ),
        (
            "pin s = crank on frame at p * (press / 1N);",
            &[
                "a point depends on the argument `press`\nhelp: nothing that moves depends on arguments",
            ],
        ),
        (
            "let reach = press / 1N; slide s = crank on frame at p along dir(reach);",
            &["a direction depends on the argument `press`"],
        ),
    ]);
}

#[test]
fn joints_of_space() {
    in_space(&[
        (
            "ball s = crank on frame at p; cylinder c = crank on frame at p along p;",
            &[],
        ),
        (
            "fixed s = crank on frame at p; slide c = crank on frame at p along p;",
            &[],
        ),
        (
            "pin s = crank on frame at p;",
            &["a `pin` in space without `about`\nhelp: name its axis: `about (0, 0, 1)`"],
        ),
        (
            "cylinder s = crank on frame at p;",
            &["a `cylinder` in space without `about`"],
        ),
        (
            "force (0, 3N) on crank at p;",
            &[
                "`force` takes a plane vector of forces, but the bodies before it are in space\nhelp: give it a third component",
            ],
        ),
        (
            "torque 3N*mm on crank;",
            &[
                "`torque` takes a space vector of moments, found a moment\nhelp: write it like `(0, 0, 3N*mm)`",
            ],
        ),
        (
            "gravity = (0, -9.80665m/s^2);",
            &["but the bodies before it are in space"],
        ),
    ]);
}

#[test]
fn how_bodies_turn() {
    in_plane(&[
        ("body x = slide on crank at p along (1, 0), turns 0;", &[]),
        (
            "body x = pin on crank at p;",
            &["how does `x` turn? A `turns` is missing\nhelp: name its angle: `turns phi`"],
        ),
        (
            "body x = fixed on crank at p, turns crank;",
            &["`turns` takes an angle, found a length\nhelp: write it like `turns phi`"],
        ),
        (
            "body x = pin on crank at p, turns phi * (press / 1N);",
            &["what a body turns with depends on the argument `press`"],
        ),
    ]);
    in_space(&[
        (
            "body x = ball on crank at p, turns arm; body y = ball on x at p, turns p;",
            &[],
        ),
        (
            "body x = slide on crank at p along p, turns arm; body y = fixed on x at p;",
            &[],
        ),
        (
            "body x = ball on crank at p;",
            &["how does `x` turn? A `turns` is missing\nhelp: name the frame that it turns with"],
        ),
        (
            "body x = ball on crank at p, turns phi;",
            &["`turns` takes a frame or the vector along a slender rod, found an angle"],
        ),
        (
            "body x = pin on crank at p about p, turns p;",
            &[
                "`turns` takes the angle about the joint's axis or a frame, found a space vector of lengths",
            ],
        ),
        (
            "body x = fixed on crank at p, turns phi;",
            &["`turns` takes a frame, found an angle"],
        ),
    ]);
}

#[test]
fn masses_and_inertias() {
    in_plane(&[
        (
            "body x = fixed on crank at p, mass 1kg + 3g at p, inertia 1kg*m^2 at (0, 0), mass 0 at p;",
            &[],
        ),
        (
            "body x = fixed on crank at p, mass press * s^2 / m at p;",
            &[],
        ),
        (
            "body x = fixed on crank at p, mass 3N at p;",
            &["`mass` takes a mass, found a force\nhelp: write it like `100g`"],
        ),
        (
            "body x = fixed on crank at p, inertia 3kg;",
            &["`inertia` takes a moment of inertia, found a mass\nhelp: write it like `250g*mm^2`"],
        ),
        (
            "body x = fixed on crank at p, inertia (1g*mm^2, 1g*mm^2, 1g*mm^2);",
            &["in the plane there is one moment of inertia"],
        ),
    ]);
    let body = "body x = ball on crank at p, turns arm, inertia";
    let loose = "body x = ball on crank at p, turns p, inertia";
    in_space(&[
        (&format!("{body} 1kg*mm^2;"), &[]),
        (&format!("{loose} 1kg*mm^2;"), &[]),
        (&format!("{body} (1g*mm^2, 0, 1g*mm^2);"), &[]),
        (
            &format!("{body} (1g, 1g, 1g);"),
            &["`inertia` takes a moment of inertia, found a mass"; 3],
        ),
        (
            &format!("{loose} (1g*mm^2, 0, 1g*mm^2);"),
            &[
                "several moments of inertia of a body without a frame\nhelp: name the frame in whose axes they are",
            ],
        ),
        (
            &format!("{body} ((1g*mm^2, 0, 1g*mm^2), (0, 1g*mm^2, 0));"),
            &["a matrix of moments of inertia has three rows of three\nhelp: write `((ixx,"],
        ),
        (
            &format!("{body} ((1g*mm^2, 2g*mm^2, 0), (3g*mm^2, 1g*mm^2, 0), (0, 0, 1g*mm^2));"),
            &[
                "a matrix of moments of inertia is symmetric, these two entries differ",
                "the other one is here",
            ],
        ),
        (
            &format!("{body} (1g*mm^2, 1g*mm^2);"),
            &["`inertia` takes a moment of inertia, found a plane vector of moments of inertia"],
        ),
    ]);
}

#[test]
fn loads() {
    in_plane(&[
        (
            "force (0, -press) on crank at p; torque press * crank on crank from frame;",
            &[],
        ),
        (
            "force 0 * p / 1s on crank at p;",
            &["`force` takes a plane vector of forces, found a plane vector of speeds"],
        ),
        (
            "force (0, 1N) on frame at p;",
            &["this acts on `frame` alone, which has no effect\nhelp: name a body that moves"],
        ),
        (
            "torque 1N*mm on crank from crank;",
            &["this acts between `crank` and itself, which has no effect"],
        ),
        (
            "force 3N on crank at p;",
            &["`force` takes a plane vector of forces, found a force"],
        ),
        (
            "torque 3N on crank;",
            &["`torque` takes a moment, found a force\nhelp: write it like `3N*mm`"],
        ),
        (
            "gravity = (0, -9.80665m/s^2); gravity = (0, 1m/s^2);",
            &[
                "a second `gravity`\nhelp: leave one of them out",
                "`gravity` is first given here",
            ],
        ),
        (
            "gravity = (0, -9.80665m/s);",
            &[
                "`gravity` takes a plane vector of accelerations, found a plane vector of speeds\nhelp: write it like `(0, -9.80665m/s^2)`",
            ],
        ),
    ]);
}

#[test]
fn springs_and_dampers() {
    in_plane(&[
        (
            "spring 1N/mm from frame at p to crank at q, free 3mm; damper 1N*s/mm from frame at p to crank at q;",
            &[],
        ),
        (
            "spring 1N*mm on b1, free 3deg; damper 1N*mm*s on b1; damper 0 on b1;",
            &[],
        ),
        (
            "slide b5 = crank on frame at p along dir(phi); spring 1N/mm on b5, free 2mm; damper 1N*s/mm on b5;",
            &[],
        ),
        (
            "spring 1N/mm on b1;",
            &["`spring` takes a moment, found a stiffness\nhelp: write it like `300N*mm`"],
        ),
        (
            "spring 1N*mm from frame at p to crank at q, free 3deg;",
            &[
                "`spring` takes a stiffness, found a moment\nhelp: write it like `2.5N/mm`",
                "`free` takes a length, found an angle\nhelp: write it like `40mm`",
            ],
        ),
        (
            "damper 1N/mm on b1;",
            &["`damper` takes a damping of rotation, found a stiffness"],
        ),
        (
            "spring 1N/mm from crank at p to crank at q;",
            &["this acts between `crank` and itself"],
        ),
        (
            "fixed b6 = crank on frame at p; spring 1N*mm on b6;",
            &[
                "`b6` is a `fixed`\nhelp: springs and dampers act on a `pin`, on a `slide`, or between two points",
            ],
        ),
        (
            "let s = 3mm; damper 5N*mm*s on b1;",
            &[
                "found a force*length^2\nhelp: `s` is a derived quantity here, not the unit: give it another name",
            ],
        ),
    ]);
}

#[test]
fn quantities() {
    asked(&[
        ("reaction(b1)", &[]),
        ("torque(phi) + power() / omega", &[]),
        ("(force(lift), 3N)", &[]),
        ("shaking_moment(p) * 2 + shaking_moment()", &[]),
        ("velocity(reaction(b2).x + norm(shaking_force()))", &[]),
        ("sensitivity(kinetic_energy() - potential_energy())", &[]),
        (
            "reaction(b9)",
            &["unknown joint `b9`\nhelp: did you mean `b1`?"],
        ),
        (
            "reaction(needle)",
            &[
                "`needle` is a body, not a joint\nhelp: give the joint that it hangs on a name: `slide NAME on ...`",
            ],
        ),
        (
            "reaction()",
            &["`reaction` takes 1 argument, found 0\nhelp: write `reaction(joint)`"],
        ),
        (
            "reaction(p + q)",
            &[
                "`reaction` takes the name of a joint, found an expression\nhelp: write `reaction(joint)`",
            ],
        ),
        (
            "moment(b1)",
            &["a `pin` takes no moment\nhelp: ask for its `reaction`"],
        ),
        (
            "torque(lift)",
            &["the input `lift` is a length, it is driven by a force\nhelp: write `force(lift)`"],
        ),
        (
            "force(phi)",
            &["the input `phi` is an angle, it is driven by a torque\nhelp: write `torque(phi)`"],
        ),
        (
            "torque(psi)",
            &["`torque` takes an input, `psi` is none\nhelp: inputs are `phi` and `lift`"],
        ),
        (
            "power(phi)",
            &["`power` takes no argument, found 1\nhelp: write `power()`"],
        ),
        (
            "shaking_moment(p, q)",
            &["`shaking_moment` takes 1 argument, found 2"],
        ),
        (
            "shaking_moment(psi)",
            &["`shaking_moment` takes a plane vector of lengths, found an angle"],
        ),
        (
            "forces()",
            &["unknown function `forces`\nhelp: did you mean `force`?"],
        ),
        (
            "shaking_force() + 3mm",
            &["cannot add a plane vector of forces and a length"],
        ),
    ]);
}

#[test]
fn quantities_need_something_that_moves() {
    let function = |arguments: &str, quantity: &str| {
        format!("struct A {{ {PLANE} }} impl A {{ fn f({arguments}) -> F {{ a: {quantity} }} }}")
    };
    for quantity in [
        "power()",
        "kinetic_energy()",
        "shaking_force()",
        "shaking_moment()",
    ] {
        check(&function("phi, omega", quantity), &[]);
        let word = quantity.trim_end_matches("()");
        let fact =
            format!("`{word}` at rest is zero: the function lists no speed\nhelp: list the speed");
        check(&function("phi", quantity), &[&fact]);
    }
    check(&function("phi, epsilon", "shaking_force()"), &[]);
    check(
        &function("phi, epsilon", "power()"),
        &["`power` at rest is zero"],
    );
    check(&function("phi", "torque(phi)"), &[]);
    check(
        "struct A { input phi = 3deg; body a = pin on frame at (0, 0), turns phi; } impl A { fn f(phi) -> F { a: power() } }",
        &["help: declare one, `input phi = ... at omega`, and list it as an argument"],
    );
    check(
        "struct A { input phi = 3deg; } impl A { fn f(phi) -> F { a: torque(phi) } }",
        &["`torque` in a mechanism without bodies\nhelp: declare what moves: `body"],
    );
    check(
        &format!("struct A {{ {PLANE} let a = power(); }}"),
        &["`power` is only known in the functions of the `impl` block"],
    );
}

#[test]
fn words_of_the_mechanics_are_names_like_others() {
    let (mechanism, messages) = model(
        "struct A { param force = 3; param torque = force; let reaction = 2 * force; let power = reaction; } \
         impl A { fn f() -> F { power, moment: reaction + force } }",
    );
    assert!(mechanism.is_none(), "a parameter is no constant");
    assert_eq!(messages.len(), 1, "{messages:#?}");
    check(
        "struct A { param force = 3; let reaction = 2 * force; let power = reaction; } \
         impl A { fn f() -> F { power, moment: reaction + force } }",
        &[],
    );
}
