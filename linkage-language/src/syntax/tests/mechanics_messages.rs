//! Messages about bodies, joints, loads and inputs.

use super::messages::check;

/// Items with the messages about them, before another item.
fn check_items(cases: &[(&str, &str)]) {
    for (item, expected) in cases {
        check(&format!("struct A {{ {item} let y = 1; }}"), &[expected]);
    }
}

#[test]
fn joints() {
    check_items(&[
        (
            "pin b3 on rocker at p;",
            "expected `=`, found `on`\nhelp: write `pin NAME = BODY on BODY at POINT`",
        ),
        (
            "pin = a on b at p;",
            "expected a name after `pin`, found `=`\nhelp: write `pin NAME = BODY on BODY at POINT`",
        ),
        (
            "pin b = on b at p;",
            "expected the name of a body after `=`, found `on`\nhelp: write `pin NAME = BODY on BODY at POINT`",
        ),
        (
            "pin b = a on at p;",
            "expected the name of a body after `on`, found `at`",
        ),
        (
            "pin b = a at p;",
            "the `pin` joint lacks `on`\nhelp: write `pin NAME = BODY on BODY at POINT`",
        ),
        (
            "pin b = a on b;",
            "the `pin` joint lacks `at`\nhelp: write `pin NAME = BODY on BODY at POINT`",
        ),
        (
            "pin b = a;",
            "the `pin` joint lacks `on` and `at`\nhelp: write `pin NAME = BODY on BODY at POINT`",
        ),
        (
            "pin b = a on b at;",
            "expected an expression after `at`, found `;`",
        ),
        (
            "pin b = a on b at p at q;",
            "a second `at`\nhelp: a `pin` joint has one",
        ),
        (
            "pin b = a on b at p along q;",
            "`along` does not belong to a `pin` joint\nhelp: clauses of a `pin` joint are `on`, `at` and `about`",
        ),
        (
            "slide b = a on b at p about q;",
            "`about` does not belong to a `slide` joint\nhelp: clauses of a `slide` joint are `on`, `at` and `along`",
        ),
        (
            "cylinder b = a on b at p about q along q;",
            "`along` and `about` in one `cylinder` joint\nhelp: both words name its axis: write one of them",
        ),
        (
            "pin b = a on b at p mass 3 at q;",
            "`mass` does not belong to a `pin` joint\nhelp: clauses of a `pin` joint are `on`, `at` and `about`",
        ),
        (
            "pin b = a onn b at p;",
            "expected a clause or `;`, found `onn`\nhelp: did you mean `on`?",
        ),
        (
            "pin b = a upon b at p;",
            "expected a clause or `;`, found `upon`\nhelp: clauses of a `pin` joint are `on`, `at` and `about`",
        ),
        (
            "pin b = a b at p;",
            "expected `on`, found `b`\nhelp: write `on b`",
        ),
        (
            "pin b = a, b at p;",
            "expected `on`, found `b`\nhelp: write `on b`",
        ),
    ]);
}

#[test]
fn bodies() {
    check_items(&[
        ("body;", "expected a name after `body`, found `;`"),
        (
            "body a;",
            "expected `=`, found `;`\nhelp: write `body NAME = pin on BODY at POINT, ...`",
        ),
        (
            "body a = ;",
            "expected a joint, found `;`\nhelp: joints are pin slide roller ball cylinder fixed",
        ),
        (
            "body a pin on b at p;",
            "expected `=`, found `pin`\nhelp: write `body NAME = pin on BODY at POINT, ...`",
        ),
        (
            "body a = hinge on b at p;",
            "expected a joint, found `hinge`\nhelp: did you mean `pin`?",
        ),
        (
            "body a = pinn on b at p;",
            "expected a joint, found `pinn`\nhelp: did you mean `pin`?",
        ),
        (
            "body a = pin on b at p, turns t, mass 3;",
            "`mass` lacks `at`\nhelp: write `mass ... at POINT`",
        ),
        (
            "body a = pin on b at p, turns t, mass 3, at q;",
            "`mass` lacks `at`\nhelp: leave out the comma before `at`",
        ),
        (
            "body a = pin on b at p, turns t, mass at q;",
            "expected an expression after `mass`, found `at`",
        ),
        (
            "body a = pin on b at p, turns, mass 2 at q;",
            "expected an expression after `turns`, found `,`",
        ),
        (
            "body a = pin on b at p, turn t, mass 2 at q;",
            "expected a clause or `;`, found `turn`\nhelp: did you mean `turns`?",
        ),
        (
            "body a = pin on b at p, rotates t, mass 2 at q;",
            "expected a clause or `;`, found `rotates`\nhelp: clauses of a body on a `pin` joint are `on`, `at`, `about`, `turns`, `mass` and `inertia`",
        ),
        (
            "body a = pin on b at p, mass 2,5mm at q;",
            "the number `2,5mm` has a decimal comma\nhelp: the decimal sign is a point: write `2.5mm`",
        ),
        (
            "body a = pin on b at p, mass (2,) + at q;",
            "expected an expression, found `at`",
        ),
        (
            "body a = pin b1 frame at p, turns t;",
            "expected `on`, found `frame`\nhelp: write `on frame`",
        ),
        (
            "body a = pin b1 on 3 at p, turns t;",
            "expected the name of a body after `on`, found `3`",
        ),
        (
            "body a = pin b1 on b at p, turns t, from c;",
            "`from` does not belong to a body on a `pin` joint\nhelp: clauses of a body on a `pin` joint are `on`, `at`, `about`, `turns`, `mass` and `inertia`",
        ),
        (
            "body a = pin b1 on b at p, turns t = 3, mass 2 at q;",
            "expected a clause or `;`, found `=`",
        ),
        (
            "body a = pin b1 on b at p turns t mass m at c d;",
            "expected a clause or `;`, found `d`\nhelp: clauses of a body on a `pin` joint are `on`, `at`, `about`, `turns`, `mass` and `inertia`",
        ),
        (
            "body a = pin b1 on b at p, turns t, mass 5mm +-1mm at c;",
            "a tolerance cannot stand here\nhelp: write it outermost in a `param`, or in a component of its vector",
        ),
        (
            "body a = pin type on b at p;",
            "`type` is a keyword of Rust and cannot be a name\nhelp: choose another name, like `type_`",
        ),
    ]);
}

#[test]
fn loads() {
    check_items(&[
        (
            "force (0, 1) at p;",
            "the force lacks `on`\nhelp: write `force VECTOR on BODY at POINT`",
        ),
        (
            "force (0, 1) on b;",
            "the force lacks `at`\nhelp: write `force VECTOR on BODY at POINT`",
        ),
        (
            "force on b at p;",
            "expected an expression after `force`, found `on`",
        ),
        (
            "force (0, 1) on b at p, from;",
            "expected the name of a body after `from`, found `;`",
        ),
        (
            "force (0, 1) on b at p to c;",
            "`to` does not belong to a force\nhelp: clauses of a force are `on`, `from` and `at`",
        ),
        (
            "force F on b at p q;",
            "expected a clause or `;`, found `q`\nhelp: clauses of a force are `on`, `from` and `at`",
        ),
        (
            "force = F on b at p;",
            "a force has no name and no `=`\nhelp: write `force VECTOR on BODY at POINT`",
        ),
        (
            "force f = F on b at p;",
            "a force has no name and no `=`\nhelp: write `force VECTOR on BODY at POINT`",
        ),
        (
            "torque 3 on b at p;",
            "`at` does not belong to a torque\nhelp: clauses of a torque are `on` and `from`",
        ),
        (
            "torque 3 b;",
            "expected `on`, found `b`\nhelp: write `on b`",
        ),
        (
            "torque 3;",
            "the torque lacks `on`\nhelp: write `torque VALUE on BODY`",
        ),
        (
            "torque;",
            "expected an expression after `torque`, found `;`",
        ),
        (
            "spring 3;",
            "the spring lacks its ends\nhelp: write `spring VALUE from BODY at POINT to BODY at POINT` or `spring VALUE on JOINT`",
        ),
        (
            "spring 3 from a to b at p;",
            "`from` lacks `at`\nhelp: write `from ... at POINT`",
        ),
        (
            "spring 3 from a at p to b;",
            "`to` lacks `at`\nhelp: write `to ... at POINT`",
        ),
        (
            "spring 3 from a at p;",
            "the spring lacks `to`\nhelp: write `spring VALUE from BODY at POINT to BODY at POINT` or `spring VALUE on JOINT`",
        ),
        (
            "spring 3 to a at p;",
            "the spring lacks `from`\nhelp: write `spring VALUE from BODY at POINT to BODY at POINT` or `spring VALUE on JOINT`",
        ),
        (
            "spring 3 on j from a at p to b at p;",
            "a spring has either `on`, or `from` and `to`\nhelp: write `spring VALUE from BODY at POINT to BODY at POINT` or `spring VALUE on JOINT`",
        ),
        (
            "spring 3 on j, length 3;",
            "`length` does not belong to a spring\nhelp: clauses of a spring are `from`, `to`, `on` and `free`",
        ),
        (
            "spring 3 on j, free;",
            "expected an expression after `free`, found `;`",
        ),
        (
            "spring from a at p to b at q;",
            "expected an expression after `spring`, found `from`",
        ),
        (
            "friction 0.1, radius 3;",
            "the friction lacks `on`\nhelp: write `friction VALUE on PIN, radius VALUE` or `friction VALUE on SLIDE`",
        ),
        (
            "friction 0.1 on j, at p;",
            "`at` does not belong to a friction\nhelp: clauses of a friction are `on`, `radius` and `length`",
        ),
        (
            "damper 3 on j, free 3;",
            "`free` does not belong to a damper\nhelp: clauses of a damper are `from`, `to` and `on`",
        ),
        (
            "damper 3 between a at p and b at q;",
            "expected a clause or `;`, found `between`\nhelp: clauses of a damper are `from`, `to` and `on`",
        ),
        (
            "gravity (0, 1);",
            "expected `=`, found `(`\nhelp: write `gravity = VECTOR;`",
        ),
        (
            "gravity = (0, 1) m;",
            "expected `;`, found `m`\nhelp: write `(...) * m` for a product",
        ),
        ("gravity = ;", "expected an expression, found `;`"),
        (
            "gravity g = 3;",
            "expected `=`, found `g`\nhelp: write `gravity = VECTOR;`",
        ),
    ]);
}

#[test]
fn inputs_and_the_rest() {
    check_items(&[
        (
            "argument = 3;",
            "expected a name after `argument`, found `=`",
        ),
        (
            "argument a = 3 +- 1;",
            "a tolerance cannot stand here\nhelp: write it outermost in a `param`, or in a component of its vector",
        ),
        (
            "input a = 3 at;",
            "expected a name for the speed after `at`, found `;`\nhelp: `at` names the arguments that are its speed and acceleration: `input phi = 30deg at omega, epsilon;`",
        ),
        (
            "input a = 3 at 5mm;",
            "expected a name for the speed after `at`, found `5mm`\nhelp: `at` names the arguments that are its speed and acceleration: `input phi = 30deg at omega, epsilon;`",
        ),
        (
            "input a = 3 at w,;",
            "expected a name for the acceleration after `at`, found `;`\nhelp: `at` names the arguments that are its speed and acceleration: `input phi = 30deg at omega, epsilon;`",
        ),
        (
            "input a = 3 at w, e, j;",
            "expected `;`, found `,`\nhelp: `at` names the arguments that are its speed and acceleration: `input phi = 30deg at omega, epsilon;`",
        ),
        (
            "input a = 3 at w e;",
            "expected `,` or `;`, found `e`\nhelp: `at` names the arguments that are its speed and acceleration: `input phi = 30deg at omega, epsilon;`",
        ),
        ("input a = 3 at w at e;", "expected `,` or `;`, found `at`"),
        ("input a = 3 at w, e at e;", "expected `;`, found `at`"),
        (
            "input a = 3 in 0.. at w;",
            "the range has no upper end\nhelp: write both ends: `0deg..360deg`",
        ),
        (
            "input a = 3 in 0..1 on w;",
            "expected `in`, `at` or `;`, found `on`\nhelp: `at` names the arguments that are its speed and acceleration: `input phi = 30deg at omega, epsilon;`",
        ),
        (
            "input a = 3 in at w;",
            "expected the lower end of the range, found `at`\nhelp: write `in 0deg..360deg`",
        ),
        (
            "pinn b = a on b at p;",
            "expected an item, found `pinn`\nhelp: did you mean `pin`?",
        ),
        (
            "joint b = a on b at p;",
            "expected `;`, found `on`\nhelp: write `a * on` for a product",
        ),
        (
            "mass 3 at p;",
            "expected an item, found `mass`\nhelp: a clause belongs before the `;` of its body, joint or load",
        ),
        (
            "param a = 3 \n force (0, 1) on b at p;",
            "the item lacks its `;`\nhelp: write `;` here",
        ),
        (
            "param a = \n force f on b at p;",
            "expected an expression, found `force`",
        ),
    ]);
}

#[test]
fn several_in_one_item() {
    check(
        "struct A { body a = pin on b at p, turns t, mass + at q, inertia * at p, turns t; }",
        &[
            "expected an expression, found `+`\nhelp: leave the sign `+` out",
            "expected an expression, found `*`",
            "a second `turns`\nhelp: a body on a `pin` joint has one",
        ],
    );
    check(
        "struct A { damper 3 onn j, on i, free 4; spring 4 from a to b at p, length 3; }",
        &[
            "expected a clause or `;`, found `onn`\nhelp: did you mean `on`?",
            "a second `on`\nhelp: a damper has one",
            "`free` does not belong to a damper",
            "`from` lacks `at`\nhelp: write `from ... at POINT`",
            "`length` does not belong to a spring",
        ],
    );
    check(
        "struct A { pin = on b, mass 3; force = on b at p; }",
        &[
            "expected a name after `pin`, found `=`",
            "expected the name of a body after `=`, found `on`",
            "`mass` does not belong to a `pin` joint",
            "a force has no name and no `=`",
            "expected an expression after `force`, found `on`",
        ],
    );
}
