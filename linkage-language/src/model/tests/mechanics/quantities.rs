//! Messages about mistakes in quantities of forces.

use super::super::{check, model};
use super::PLANE;

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
