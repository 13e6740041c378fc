//! Assemblies of groups without a closed form, at the reference input and over the range.

use crate::triads::EyeNeedle;
use linkage_runtime::numeric::continuation::{Correction, Range, Residuals, Step, Terms};
use linkage_runtime::numeric::roots::{self, Term, Variable};
use linkage_runtime::support::{
    Coupled, CoupledGroup, CoupledInput, CoupledPrograms, CoupledUnknown, InitialState, Which,
    initial_states, list_solutions, nearest_solution,
};
use linkage_runtime::{AssemblyError, CoupledCause, FUSED, Group, Scalar};
use std::f64::consts::TAU;

const fn term(equation: usize, exponents: &'static [i8]) -> Term<'static> {
    Term {
        equation,
        exponents,
    }
}

/// `|A + a u + b t|^2 = r^2`, twice.
const TERMS: [Term<'static>; 14] = [
    term(0, &[0, 0]),
    term(0, &[1, 0]),
    term(0, &[-1, 0]),
    term(0, &[0, 1]),
    term(0, &[0, -1]),
    term(0, &[1, -1]),
    term(0, &[-1, 1]),
    term(1, &[0, 0]),
    term(1, &[1, 0]),
    term(1, &[-1, 0]),
    term(1, &[0, 1]),
    term(1, &[0, -1]),
    term(1, &[1, -1]),
    term(1, &[-1, 1]),
];

const fn unknown(name: &'static str, estimate: f64) -> CoupledUnknown {
    CoupledUnknown {
        name,
        estimate,
        scale: 1.0,
        unit: "",
        angle: true,
    }
}

const GROUP: CoupledGroup = CoupledGroup {
    mechanism: "EyeNeedle",
    group: 0,
    described: &Group {
        class: 3,
        order: 3,
        kind: "RR-RR-RR",
        loops: &[1, 2],
        joints: "",
        unknowns: &["leg", "link", "rocker", "arm"],
        mode: None,
        method: "",
    },
    unknowns: &[unknown("leg", 1.1), unknown("link", 2.5 + TAU)],
    variables: &[Variable::Unit, Variable::Unit],
    terms: &TERMS,
    list: roots::solve,
    missed: &[],
    inputs: &[CoupledInput {
        name: "phi",
        unit: "",
        index: 0,
        declared: true,
        range: Range {
            low: 0.0,
            high: TAU,
            turn: true,
        },
    }],
    in_cells: Terms::Slopes,
    reach: 1.0,
    turning: 0,
};

struct Programs(EyeNeedle);

impl Correction for Programs {
    fn correct(&mut self, x: &[f64], state: &mut [f64]) -> Step {
        self.0.correct(x, state)
    }
}

impl Residuals for Programs {}

impl CoupledPrograms for Programs {
    fn system(&mut self, x: &[f64]) -> Vec<[f64; 2]> {
        self.0.system(x[0])
    }

    fn placed(&mut self, _: &[f64], state: &[f64]) -> Vec<[f64; 2]> {
        vec![[state[0], state[1]], [state[2], state[3]]]
    }
}

/// The assembly nearest to the estimates, over the range.
fn nearest(triad: EyeNeedle) -> Result<InitialState, AssemblyError> {
    let all = initial_states(
        &[GROUP],
        [InitialState::Nothing],
        &[0.0],
        Which::Nearest,
        |_, _| Ok(Programs(triad)),
    )?;
    let [start] = all.into_iter().next().unwrap();
    Ok(start)
}

#[test]
fn all_assemblies_are_listed_and_the_nearest_is_taken() {
    let mut programs = Programs(EyeNeedle::MACHINE);
    let all = list_solutions(&GROUP, &mut programs, &[0.0]).unwrap();
    assert!(all.is_sorted_by_key(|one| one.distance));
    let one = nearest_solution(&GROUP, &mut programs, &[0.0]).unwrap();
    assert_eq!(one, all[0]);
    for (a, b) in one.state.iter().zip(EyeNeedle::start()) {
        assert!((a - b).abs() < 2e-15, "{a} {b}");
    }
    let start = nearest(EyeNeedle::MACHINE).unwrap();
    let coupled = Coupled::<4>::of::<f64>(|_| &start);
    let (state, floor) = coupled.at::<_, FUSED>(1.0);
    assert!(floor > 0.0 && (state[0].hypot(state[1]) - 1.0).abs() < 1e-9);
    let single = Coupled::<4>::of::<f32>(|_| &start);
    assert_eq!(
        single.at::<_, FUSED>(1.0_f32),
        (state.map(|number| number as f32), floor as f32)
    );
}

fn cause(error: AssemblyError) -> CoupledCause {
    match error {
        AssemblyError::Coupled(error) => error.cause,
        error => panic!("{error}"),
    }
}

/// `(cos a - 1) (cos a - 0.2) = 0`: two assemblies at 78.5 and -78.5 degrees, and two that meet at 0.
struct Meeting;

impl Correction for Meeting {
    fn correct(&mut self, _: &[f64], state: &mut [f64]) -> Step {
        let [cos, sin] = [state[0], state[1]];
        let slope = -sin * (2.0 * cos - 1.2);
        let step = -(cos - 1.0) * (cos - 0.2) / slope;
        (state[1], state[0]) = (sin.atan2(cos) + step).sin_cos();
        Step {
            size: step.abs(),
            determinant: slope,
        }
    }
}

impl Residuals for Meeting {}

impl CoupledPrograms for Meeting {
    fn system(&mut self, _: &[f64]) -> Vec<[f64; 2]> {
        [0.25, -0.6, 0.7, -0.6, 0.25].map(|c| [c, 0.0]).into()
    }

    fn placed(&mut self, _: &[f64], state: &[f64]) -> Vec<[f64; 2]> {
        vec![[state[0], state[1]]]
    }
}

#[test]
fn assemblies_that_meet_are_in_the_way_only_if_they_are_meant() {
    let chosen = |estimate: f64| {
        let group = CoupledGroup {
            unknowns: Box::leak(Box::new([unknown("a", estimate)])),
            variables: &[Variable::Unit],
            terms: &const {
                [
                    term(0, &[2]),
                    term(0, &[1]),
                    term(0, &[0]),
                    term(0, &[-1]),
                    term(0, &[-2]),
                ]
            },
            ..GROUP
        };
        assert_eq!(
            list_solutions(&group, &mut Meeting, &[0.0]).unwrap().len(),
            2
        );
        nearest_solution(&group, &mut Meeting, &[0.0]).map_err(cause)
    };
    let angle = 0.2_f64.acos();
    // Farther from where two meet than from another one, by more than what is known of where they do.
    for (estimate, expected) in [(1.2, angle), (0.72, angle), (-2.5, -angle)] {
        let found = chosen(estimate).unwrap();
        assert!((found.values[0] - expected).abs() < 1e-15, "{estimate}");
    }
    for estimate in [0.0, -0.1, 0.68, 0.69] {
        assert_eq!(chosen(estimate), Err(CoupledCause::Singular), "{estimate}");
    }
}

#[test]
fn estimates_between_two_assemblies_are_ambiguous() {
    let mut programs = Programs(EyeNeedle::MACHINE);
    let all = list_solutions(&GROUP, &mut programs, &[0.0]).unwrap();
    let middle = |i: usize| 0.5 * (all[0].values[i] + all[1].values[i]);
    let unknowns = [unknown("leg", middle(0)), unknown("link", middle(1))];
    let group = CoupledGroup {
        unknowns: Box::leak(Box::new(unknowns)),
        ..GROUP
    };
    let error = nearest_solution(&group, &mut programs, &[0.0]).unwrap_err();
    let text = error.to_string();
    let CoupledCause::Ambiguous { assemblies } = cause(error) else {
        panic!("{text}");
    };
    assert_eq!(assemblies.len(), all.len());
    assert!(text.starts_with(
        "EyeNeedle: loops 1 and 2 (leg, link, rocker, arm; RR-RR-RR) can close in 2 ways, of which \
         two are equally near to the start estimates: leg = "
    ));
    assert!(
        text.contains("leg = 62.2415 deg, link = 145.606 deg"),
        "{text}"
    );
}

#[test]
fn what_cannot_be_assembled_says_why() {
    let mut short = Programs(EyeNeedle {
        crank: 5.0,
        legs: [10.0, 20.0, 30.0],
        ..EyeNeedle::MACHINE
    });
    let error = nearest_solution(&GROUP, &mut short, &[0.0]).unwrap_err();
    assert!(matches!(
        cause(error),
        CoupledCause::NoneReal { complex: 6 }
    ));

    let long = Programs(EyeNeedle::with_crank(120.0));
    let error = nearest(long.0).unwrap_err();
    assert!(error.to_string().ends_with(
        " cannot run through the range of the input: it reaches a dead point at phi = 6.6529 deg"
    ));
    let CoupledCause::DeadPoint(at) = cause(error) else {
        panic!();
    };
    assert!((at.value - 0.116_114_962_405_6).abs() < 1e-12);

    let mut infinite = Programs(EyeNeedle {
        crank: f64::INFINITY,
        ..EyeNeedle::MACHINE
    });
    let error = nearest_solution(&GROUP, &mut infinite, &[0.0]).unwrap_err();
    assert!(matches!(error, AssemblyError::Undefined { .. }), "{error}");
}

#[test]
fn every_lane_has_its_table() {
    use linkage_core::Lanes;
    type Four = Lanes<simba::simd::AutoF64x4>;

    let cranks = [50.0, 55.0, 60.0, 65.0];
    let starts = cranks.map(|crank| nearest(EyeNeedle::with_crank(crank)).unwrap());
    let coupled = Coupled::<4>::of::<Four>(|lane| &starts[lane]);
    let x = Four::from_lanes(|lane| lane as f64);
    let (state, floor) = coupled.at::<_, FUSED>(x);
    for (lane, start) in starts.iter().enumerate() {
        let (alone, alone_floor) = Coupled::<4>::of::<f64>(|_| start).at::<_, FUSED>(lane as f64);
        assert_eq!(floor.lane(lane), alone_floor);
        assert_eq!(state.map(|number| number.lane(lane)), alone);
    }
}

#[test]
fn what_is_not_prepared_is_not_a_number() {
    let start = nearest(EyeNeedle::MACHINE).unwrap();
    for (coupled, number) in [
        (Coupled::<5>::of::<f64>(|_| &start), 0.0),
        (Coupled::<5>::of::<f64>(|_| &InitialState::Nothing), 1.0),
    ] {
        let (state, floor) = coupled.at::<f64, FUSED>(number);
        assert!(floor.is_nan() && state.iter().all(|number: &f64| number.is_nan()));
    }
}
