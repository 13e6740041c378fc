//! Messages about mistakes in bodies, joints and loads.

mod dynamics;
mod friction;
mod loads;
mod quantities;

use super::check;

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
            &["`crank` is a body, not a joint\nhelp: it hangs on the joint `b1`"],
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
            &[
                "how does `x` turn? A `turns` is missing\nhelp: name its angle: `turns phi`; a body that does not turn has `turns 0deg`",
            ],
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
            &[
                "how does `x` turn? A `turns` is missing\nhelp: name the vector along it if it is a slender rod, `turns q - p`, or its frame",
            ],
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
