//! Mistakes in masses, loads, springs and dampers.

use super::{in_plane, in_space};

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
            "body x = fixed on crank at p, inertia 240kg*mm;",
            &["`inertia` takes a moment of inertia, found a mass*length\nhelp: write it like"],
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
    in_plane(&[
        (
            "body x = fixed on crank at p, inertia 1kg*m^2 at (0, 0), inertia 1kg*m^2;",
            &[],
        ),
        (
            "body x = fixed on crank at p, inertia 1kg*m^2 at p, inertia 1kg*m^2 at p;",
            &[
                "a second `inertia` of `x` about a point: each is that of the whole body\nhelp: write the sum about one point",
            ],
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
            "spring 1N/mm on crank, free 3mm;",
            &["`crank` is a body, not a joint\nhelp: it hangs on the joint `b1`"],
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
fn springs_in_pins_of_space() {
    let fact = "a spring in a pin of space needs the angle about its axis";
    let body = "body x = pin b2 on crank at p about (0, 0, 1), turns";
    in_space(&[
        ("spring 1N*mm on b1, free 3deg; damper 1N*mm*s on b1;", &[]),
        (&format!("{body} arm; damper 1N*mm*s on b2;"), &[]),
        (
            &format!("{body} arm; spring 1N*mm on b2;"),
            &[&format!(
                "{fact}\nhelp: let the body turn with that angle: `turns phi`"
            )],
        ),
        (
            &format!("{body} 0deg; pin b3 = x on frame at p about (0, 0, 1); spring 1N*mm on b3;"),
            &[&format!(
                "{fact}\nhelp: let one of its bodies hang by this pin"
            )],
        ),
        ("spring 1N*mm on b9;", &["unknown joint `b9`"]),
    ]);
}
