//! Messages about mistakes in quantities of the equation of motion.

use super::super::{check, last_of};
use super::PLANE;

/// Each quantity in a function of these arguments.
fn asked(arguments: &str, cases: &[(&str, &[&str])]) {
    let items = "body rocker = pin b4 on frame at (90mm, 0), turns psi; torque press * 1mm on rocker; input lift = 3mm;";
    for (quantity, messages) in cases {
        let function = format!("fn f({arguments}) -> F {{ a: {quantity} }}");
        let source = format!("struct A {{ {PLANE} {items} }} impl A {{ {function} }}");
        check(&source, messages);
    }
}

#[test]
fn dimensions_follow_from_the_inputs() {
    asked(
        "phi, lift, omega, press",
        &[
            ("inertia(phi) + 3kg*mm^2", &[]),
            ("inertia(phi, lift) + inertia(lift, phi) + 3kg*mm", &[]),
            ("inertia()[1][1] + inertia(lift) + 3kg", &[]),
            ("velocity(inertia())[0][0][1] * 1rad + 3kg*mm", &[]),
            ("bias(phi) + generalised_force(phi) + 3N*mm", &[]),
            ("bias(lift) + generalised_force(lift) + 3N", &[]),
            ("driven_acceleration(phi) + 3rad/s^2", &[]),
            ("driven_acceleration(lift) + 3mm/s^2", &[]),
            (
                "inertia(phi) + 3kg",
                &["cannot add a moment of inertia and a mass"],
            ),
            (
                "inertia() + 3kg",
                &["an array of 2 entries cannot be used in an expression"],
            ),
        ],
    );
    asked("phi", &[("inertia() + 3kg*mm^2", &[])]);
}

#[test]
fn mistakes_in_arguments() {
    asked(
        "phi, lift, omega, press",
        &[
            (
                "inertia(psi)",
                &["`inertia` takes an input, `psi` is none\nhelp: inputs are `phi` and `lift`"],
            ),
            (
                "inertia(phi, press)",
                &["`inertia` takes an input, `press` is none\nhelp: inputs are `phi` and `lift`"],
            ),
            (
                "inertia(phi, 2 * lift)",
                &[
                    "`inertia` takes the name of an input, found an expression\nhelp: write `inertia(input)`",
                ],
            ),
            (
                "inertia(phi, lift, phi)",
                &["`inertia` takes 2 arguments, found 3\nhelp: write `inertia(input, input)`"],
            ),
            (
                "bias()",
                &["`bias` takes 1 argument, found 0\nhelp: write `bias(input)`"],
            ),
            (
                "driven_acceleration(omega)",
                &["`driven_acceleration` takes an input, `omega` is none"],
            ),
            (
                "generalized_force(phi)",
                &["unknown function `generalized_force`\nhelp: did you mean `generalised_force`?"],
            ),
        ],
    );
    asked(
        "press",
        &[(
            "inertia()",
            &["`inertia` in a function without an input\nhelp: list the input: `fn name(phi)`"],
        )],
    );
}

#[test]
fn masses_and_loads_are_needed() {
    let check_in = |item: &str, quantity: &str, messages: &[&str]| {
        let items =
            format!("unit mm; input phi = 3deg; body a = pin on frame at (0, 0), turns phi{item}");
        let source =
            format!("struct A {{ {items} }} impl A {{ fn f(phi) -> F {{ a: {quantity} }} }}");
        check(&source, messages);
    };
    for word in ["inertia", "bias", "driven_acceleration"] {
        let quantity = format!("{word}(phi)");
        let fact = format!("`{word}` in a mechanism without masses\nhelp: give a body a mass");
        check_in(";", &quantity, &[&fact]);
        check_in(", inertia 2kg*mm^2;", &quantity, &[]);
        check_in(", mass 2kg at (0, 0);", &quantity, &[]);
    }
    let fact = "`generalised_force` in a mechanism without loads\nhelp: declare a `force`";
    check_in(", mass 2kg at (0, 0);", "generalised_force(phi)", &[fact]);
    check_in("; torque 2N*m on a;", "generalised_force(phi)", &[]);
    check_in(
        "; gravity = (0, 1m/s^2); torque 2N*m on a;",
        "generalised_force(phi)",
        &[],
    );
}

#[test]
fn masses_and_loads_of_parts_count() {
    let part = "struct Disc { unit mm; input phi = 3deg; body a = pin on frame at (0, 0), turns phi, inertia 2kg*mm^2;
        torque 2N*m on a; }";
    for quantity in [
        "inertia(turn)",
        "generalised_force(turn)",
        "driven_acceleration(turn)",
    ] {
        let machine = "unit mm; input turn = 3deg; part disc: Disc { phi = turn }";
        let function = format!("fn f(turn) -> F {{ a: {quantity} }}");
        let text = format!("{part} struct A {{ {machine}; }} impl A {{ {function} }}");
        let (_, messages) = last_of(&text);
        assert!(messages.is_empty(), "{messages:#?}");
    }
}
