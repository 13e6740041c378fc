//! What mechanisms print about themselves and their errors.

use linkage_runtime::{
    AssemblyError, AssemblyMode, FunctionInfo, Group, GroupRef, Operations, Parameter, Structure,
    true_acceleration, true_jerk, true_velocity,
};

const NONE: Operations = Operations {
    add: 0,
    mul: 0,
    div: 0,
    sqrt: 0,
    sin_cos: 0,
    atan2: 0,
    other: 0,
};

#[test]
fn a_structure_is_a_table() {
    const STRUCTURE: Structure = Structure {
        mobility: 1,
        groups: &[
            Group {
                class: 2,
                order: 2,
                kind: "RRR",
                loops: &[1],
                joints: "",
                unknowns: &["theta", "psi"],
                mode: Some(0),
                method: "quadratic",
            },
            Group {
                class: 0,
                order: 0,
                kind: "",
                loops: &[2, 3],
                joints: "",
                unknowns: &["s"],
                mode: None,
                method: "linear",
            },
        ],
        functions: &[FunctionInfo {
            name: "path",
            operations: Operations { sqrt: 2, ..NONE },
        }],
        prepare: NONE,
    };
    let expected = "\
mobility 1
group  kind  class  order  mode  loops  unknowns    method
1      RRR   2      2      0     1      theta, psi  quadratic
2            0      0      -     2, 3   s           linear
assemble: 0 operations (none)
path: 2 operations (2 sqrt)
";
    assert_eq!(STRUCTURE.to_string(), expected);
    let empty = Structure {
        mobility: 0,
        groups: &[],
        functions: &[],
        prepare: NONE,
    };
    assert_eq!(
        empty.to_string(),
        "mobility 0\nassemble: 0 operations (none)\n"
    );
}

#[test]
fn operations_are_counted() {
    let all = Operations {
        add: 1,
        mul: 2,
        div: 3,
        sqrt: 4,
        sin_cos: 5,
        atan2: 6,
        other: 7,
    };
    assert_eq!(all.total(), 28);
    let expected = "1 add, 2 mul, 3 div, 4 sqrt, 5 sin_cos, 6 atan2, 7 other";
    assert_eq!(all.to_string(), expected);
}

#[test]
fn parameters_and_modes_print() {
    let crank = Parameter {
        name: "crank",
        unit: "mm",
        nominal: 50.0,
        tolerance: 0.012,
    };
    assert_eq!(crank.to_string(), "crank = 50 +- 0.012 mm");
    let ratio = Parameter {
        name: "ratio",
        unit: "",
        nominal: 2.0,
        tolerance: 0.0,
    };
    assert_eq!(ratio.to_string(), "ratio = 2");
    assert_eq!(AssemblyMode::Plus.flipped(), AssemblyMode::Minus);
    assert_eq!(
        AssemblyMode::Minus.flipped().sign() + AssemblyMode::Minus.sign(),
        0.0
    );
    assert_eq!(
        format!("{}{:>3}", AssemblyMode::Plus, AssemblyMode::Minus),
        "+  -"
    );
}

fn miss(loops: &'static [usize], kind: &'static str, miss: f64, unit: &'static str) -> String {
    let unknowns: &[_] = if loops.is_empty() {
        &[]
    } else {
        &["theta", "s"]
    };
    AssemblyError::CannotClose {
        group: GroupRef {
            mechanism: "M",
            index: 1,
            kind,
            loops,
            joints: "",
            unknowns,
        },
        miss,
        unit,
    }
    .to_string()
}

/// A text with joints and links has no loops for the user.
#[test]
fn errors_and_tables_name_joints() {
    const GROUP: Group = Group {
        class: 2,
        order: 2,
        kind: "RRR",
        loops: &[1],
        joints: "joint `c` of `rocker`",
        unknowns: &["coupler.angle", "rocker.angle"],
        mode: Some(0),
        method: "quadratic",
    };
    let group = GroupRef {
        mechanism: "M",
        index: 0,
        kind: GROUP.kind,
        loops: GROUP.loops,
        joints: GROUP.joints,
        unknowns: GROUP.unknowns,
    };
    let expected = "M: joint `c` of `rocker` (coupler.angle, rocker.angle; RRR)";
    assert_eq!(group.to_string(), expected);
    assert_eq!(GROUP.loop_names(), GROUP.joints);
    let written = Group {
        joints: "",
        loops: &[1, 2],
        ..GROUP
    };
    assert_eq!(written.loop_names(), "loops 1 and 2");
    const STRUCTURE: Structure = Structure {
        mobility: 1,
        groups: &[
            GROUP,
            Group {
                joints: "",
                loops: &[2, 3],
                ..GROUP
            },
        ],
        functions: &[],
        prepare: NONE,
    };
    let expected = "\
mobility 1
group  kind  class  order  mode  joints                 unknowns                     method
1      RRR   2      2      0     joint `c` of `rocker`  coupler.angle, rocker.angle  quadratic
2      RRR   2      2      0     2, 3                   coupler.angle, rocker.angle  quadratic
assemble: 0 operations (none)
";
    assert_eq!(STRUCTURE.to_string(), expected);
}

#[test]
fn an_error_names_the_loop_and_the_miss() {
    assert_eq!(
        miss(&[1, 2, 4], "RRP", 0.1 + 0.2, "mm"),
        "M: loops 1, 2 and 4 (theta, s; RRP) cannot close at the reference input: it misses by \
         0.3 mm"
    );
    assert_eq!(
        miss(&[], "", 2.0, ""),
        "M: group 2 cannot close at the reference input: it misses by 2"
    );
    for (size, expected) in [
        (12.499999999999, "12.5 mm"),
        (123456.7, "123457 mm"),
        (0.000123456789, "0.000123457 mm"),
        (1.0 / 3.0, "0.333333 mm"),
        (4.2e9, "4.20000e9 mm"),
        (-2.5, "-2.5 mm"),
        (0.0, "0 mm"),
        (f64::NAN, "NaN mm"),
    ] {
        assert!(
            miss(&[1], "RRR", size, "mm").ends_with(&format!(" by {expected}")),
            "{size}"
        );
    }
}

#[test]
fn other_errors_say_what_is_wrong() {
    let errors: [&dyn core::error::Error; 3] = [
        &AssemblyError::Undefined {
            group: GroupRef {
                mechanism: "M",
                index: 0,
                kind: "RRR",
                loops: &[1],
                joints: "",
                unknowns: &["theta", "psi"],
            },
        },
        &AssemblyError::NoWinding {
            mechanism: "M",
            unknown: "theta",
        },
        &AssemblyError::TooManyAssemblies {
            mechanism: "M",
            modes: 17,
        },
    ];
    for (error, words) in errors
        .iter()
        .zip(["loop 1 (theta, psi; RRR) has no", "theta", "17"])
    {
        assert!(error.to_string().starts_with("M: ") && error.to_string().contains(words));
    }
}

#[cfg(feature = "alloc")]
#[test]
fn groups_without_a_closed_form_say_what_is_wrong() {
    use linkage_runtime::numeric::roots::Unlisted;
    use linkage_runtime::{CoupledCause, CoupledError, GroupRef, Placed, Value};

    let angle = |name, value: f64| Value {
        name,
        value: value.to_radians(),
        unit: "",
        angle: true,
    };
    let slide = |value| Value {
        name: "s",
        value,
        unit: "mm",
        angle: false,
    };
    let placed = |theta, s| Placed(vec![angle("theta", theta), slide(s)]);
    let at = "at the reference input";
    for (cause, expected) in [
        (
            CoupledCause::NoneReal { complex: 4 },
            format!("cannot close {at}: none of the 4 solutions is real"),
        ),
        (
            CoupledCause::NoneReal { complex: 0 },
            format!("cannot close {at}: there is no solution"),
        ),
        (
            CoupledCause::Ambiguous {
                assemblies: vec![placed(12.5, 3.0), placed(-90.0, 0.25)],
            },
            "can close in 2 ways, of which two are equally near to the start estimates: \
             theta = 12.5 deg, s = 3 mm; theta = -90 deg, s = 0.25 mm"
                .into(),
        ),
        (
            CoupledCause::NotListed(Unlisted::Degenerate),
            format!(
                "cannot be solved: the solutions {at} cannot be listed: they may not be isolated, as where legs coincide, guides are \
                 parallel or lengths are zero; otherwise this is a limit of linkage: `assemble_from` follows an assembly of other \
                 dimensions to these, without a listing"
            ),
        ),
        (
            CoupledCause::NotListed(Unlisted::Lost { lost: 1, paths: 8 }),
            format!(
                "cannot be solved: the solutions {at} cannot all be listed: 1 of 8 paths have no \
                 certain end; this is a limit of linkage, not of the mechanism: `assemble_from` follows an assembly of other \
                 dimensions to these, without a listing"
            ),
        ),
        (
            CoupledCause::Singular,
            "cannot run from the reference input: it is a dead point".into(),
        ),
        (
            CoupledCause::DeadPoint(angle("phi", 84.25)),
            "cannot run through the range of the input: it reaches a dead point at phi = 84.25 deg"
                .into(),
        ),
        (
            CoupledCause::NotFollowed(slide(2.0)),
            "cannot be followed through the range of the input beyond s = 2 mm: another assembly \
             is too near"
                .into(),
        ),
        (
            CoupledCause::LeavesOut {
                share: 0.0125,
                example: Placed(vec![angle("phi", 84.25), slide(2.0)]),
            },
            "cannot be prepared over these ranges of the inputs: 1.2 % of their positions would be left out, \
             phi = 84.25 deg, s = 2 mm among them, though no dead point is near; this is a limit of linkage: shorten the ranges"
                .into(),
        ),
        (
            CoupledCause::BesideDeadPoint(Placed(vec![angle("phi", 84.25), slide(2.0)])),
            "cannot be prepared at the reference inputs, phi = 84.25 deg, s = 2 mm: a dead point is so near that the smallest cells \
             of linkage do not reach the assembly there; move the reference away from it, or shorten the ranges"
                .into(),
        ),
    ] {
        let error = CoupledError {
            group: GroupRef {
                mechanism: "M",
                index: 2,
                kind: "RR-RR-PR",
                loops: &[1, 2],
                joints: "",
                unknowns: &["theta", "s"],
            },
            cause,
        };
        let expected = format!("M: loops 1 and 2 (theta, s; RR-RR-PR) {expected}");
        assert_eq!(error.to_string(), expected);
        assert_eq!(
            AssemblyError::Coupled(Box::new(error)).to_string(),
            expected
        );
    }
}

#[test]
fn true_motion_of_numbers() {
    assert_eq!(true_velocity(0.5_f32, 10.0), 5.0);
    assert_eq!(true_acceleration(0.5, -0.2, 10.0, 4.0), -18.0);
    assert_eq!(true_jerk(0.5, -0.25, 0.125, 10.0, 4.0, 6.0), 98.0);
}

#[cfg(feature = "nalgebra")]
#[test]
fn true_motion_of_vectors() {
    use linkage_runtime::{Vector2, Vector3};
    let (v1, a1) = (Vector2::new(1.0, 2.0), Vector2::new(-1.0, 0.5));
    assert_eq!(true_velocity(v1, 3.0), Vector2::new(3.0, 6.0));
    assert_eq!(true_acceleration(v1, a1, 3.0, 2.0), Vector2::new(-7.0, 8.5));
    assert_eq!(
        true_jerk(v1, a1, v1, 3.0, 2.0, 4.0),
        Vector2::new(13.0, 71.0)
    );
    assert_eq!(
        true_velocity(Vector3::new(1.0_f32, 2.0, 3.0), 2.0),
        Vector3::new(2.0, 4.0, 6.0)
    );
}

#[test]
fn true_motion_of_vectors_of_dual_numbers() {
    use linkage_core::Dual;
    use linkage_runtime::{Scalar, Vector2};
    let number = |x: f64| Dual::<num_dual::Dual64>::from_f64(x);
    let v1 = Vector2::new(number(1.0), number(2.0));
    assert_eq!(
        true_acceleration(v1, v1, number(3.0), number(2.0))
            .y
            .lane(0),
        22.0
    );
}
