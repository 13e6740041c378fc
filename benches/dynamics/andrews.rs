//! Andrews' squeezing mechanism to 0.03 s: tolerances and errors of ours, and the task for all solvers.

use crate::comparison::Method;
use crate::links::{Coupling, Links, Loop, Part, Spring};
use crate::task::Task;
use crate::timing::best;
use linkage::dynamics::{Conservative, Method as Integrator, Problem};
use std::error::Error;
use std::f64::consts::FRAC_PI_2;
use std::hint::black_box;

include!("../../mechanisms/andrews.rs");

/// The angle of the crank at the start (Test set for IVP solvers, release 2.4, problem "Andrews' squeezing mechanism").
const START: f64 = -0.061_713_890_014_276_45;
const MOMENT: f64 = 0.033;
const END: f64 = 0.03;
/// Its angle after 0.03 s. The test set has 15.81077119629904, which is off by 1.1e-9.
const REFERENCE: f64 = 15.810_771_195_153_707;

/// The same bodies with a coordinate for each: the angles of K1 to K7 against the frame, of K3 and K5 to K7 those of
/// their links to the frame or to P.
fn links(m: &Andrews) -> Links {
    let square = |point: [f64; 2]| point[0] * point[0] + point[1] * point[1];
    let arm = |length, shift| Part::Arm { length, shift };
    let [centre_4, centre_6] = [m.e - m.ea, m.zf - m.fa];
    let crank = || [(0, arm(m.rr, 0.0)), (1, arm(-m.d, 0.0))];
    let chain = |fixed: [f64; 2], parts: Vec<(usize, Part)>| Loop {
        constant: [-fixed[0], -fixed[1]],
        parts: crank().into_iter().chain(parts).collect(),
    };
    let mut moments = vec![0.0; 7];
    moments[0] = MOMENT;
    Links {
        inertias: vec![
            m.i1 + m.m1 * m.ra * m.ra + m.m2 * m.rr * m.rr,
            m.i2 + m.m2 * m.da * m.da,
            m.i3 + m.m3 * square([m.sa, m.sb]),
            m.i4 + m.m4 * centre_4 * centre_4,
            m.i5 + m.m5 * square([m.ta, m.tb]) + m.m4 * m.zt * m.zt,
            m.i6 + m.m6 * centre_6 * centre_6,
            m.i7 + m.m7 * square([m.ua, m.ub]) + m.m6 * m.u * m.u,
        ],
        couplings: vec![
            Coupling {
                coordinates: [0, 1],
                moment: -m.m2 * m.rr * m.da,
                shift: 0.0,
            },
            Coupling {
                coordinates: [4, 3],
                moment: m.m4 * m.zt * centre_4,
                shift: -FRAC_PI_2,
            },
            Coupling {
                coordinates: [6, 5],
                moment: m.m6 * m.u * centre_6,
                shift: FRAC_PI_2,
            },
        ],
        loops: vec![
            chain([m.b.x, m.b.y], vec![(2, arm(-m.ss, -FRAC_PI_2))]),
            chain(
                [m.a.x, m.a.y],
                vec![(4, arm(-m.zt, 0.0)), (3, arm(-m.e, -FRAC_PI_2))],
            ),
            chain(
                [m.a.x, m.a.y],
                vec![(6, arm(-m.u, -FRAC_PI_2)), (5, arm(-m.zf, 0.0))],
            ),
        ],
        moments,
        weights: vec![0.0; 7],
        spring: Some(Spring {
            coordinate: 2,
            arm: [m.sd.hypot(m.sc), (-m.sc).atan2(m.sd)],
            base: [m.b.x - m.c.x, m.b.y - m.c.y],
            stiffness: m.stiffness,
            free: m.l0,
        }),
    }
}

/// Returns all methods.
pub(crate) fn methods() -> Result<Vec<Method>, Box<dyn Error>> {
    let mechanism = Andrews::default();
    let linkage = mechanism.assemble()?;
    let at = linkage.position(START);
    let task = Task {
        links: links(&mechanism),
        positions: vec![
            START,
            at.theta + START,
            at.gamma,
            at.phi + at.delta,
            at.delta,
            at.omega + at.epsilon,
            at.epsilon,
        ],
        speeds: vec![0.0; 7],
        end: END,
        solution: REFERENCE,
    };
    let calls = 1000;
    let time = best(|| {
        for call in 0..calls {
            black_box(linkage.motion(START + f64::from(call) * 0.016, 1.0, MOMENT));
        }
    });
    println!(
        "a call of the acceleration: {:.0} ns",
        1e9 * time / f64::from(calls)
    );
    let accelerate =
        |_, [beta]: [f64; 1], [speed]: [f64; 1]| [linkage.motion(beta, speed, MOMENT).acceleration];
    let integrated = |tolerance: f64, method: Integrator| {
        let problem = Problem::new(accelerate).start([START], [0.0]);
        let problem = problem.tolerance(tolerance).method(method).only_end();
        task.run(|end| Some(problem.until(end).ok()?.end().inputs[0]))
    };
    let energy = |tolerance: f64| {
        let function = |beta: f64| {
            let energy = linkage.energy(beta, 1.0);
            [2.0 * energy.kinetic, MOMENT * beta - energy.potential]
        };
        let energy = Conservative::new(function).start(START, 0.0);
        let energy = energy.force(|beta| linkage.terms(beta, 0.0, MOMENT).force);
        let energy = energy.tolerance(tolerance);
        task.run(|end| energy.input(end).ok())
    };
    let explicit = |tolerance| integrated(tolerance, Integrator::Explicit);
    let implicit = |tolerance| integrated(tolerance, Integrator::Implicit);
    let mut methods = vec![
        Method::ours("ours, Problem, explicit", 3..=13, explicit),
        Method::ours("ours, Problem, implicit", 6..=9, implicit),
        Method::ours("ours, Conservative", 2..=12, energy),
    ];
    println!("Andrews' mechanism to 0.03 s: error of beta, rad, and ms for each tolerance");
    for method in &methods {
        println!("  {}", method.name);
        for run in &method.runs {
            println!("    {:9.1e} {:7.4}", run.error, 1e3 * run.seconds);
        }
    }
    methods.extend(task.others());
    Ok(methods)
}
