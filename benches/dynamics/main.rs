//! Motion under forces: `RUSTFLAGS="-C target-cpu=x86-64-v3" cargo bench -p linkage-benches --bench dynamics`, and without the flags.
//!
//! Andrews' squeezing mechanism to 0.03 s at tolerances from 1e-3 to 1e-13 and by its energy, against the corrected
//! reference; the energy of a slider-crank after many turns; the time of a step over the number of four-bars in a chain.

use linkage::dynamics::{Conservative, Method, Problem};
use linkage_engine::Mechanism;
use linkage_peers::timing::only_tested;
use std::error::Error;
use std::f64::consts::TAU;
use std::hint::black_box;
use std::time::{Duration, Instant};

include!("../mechanisms/andrews.rs");

/// The angle of the crank at the start (Test set for IVP solvers, release 2.4, problem "Andrews' squeezing mechanism").
const START: f64 = -0.061_713_890_014_276_45;
const MOMENT: f64 = 0.033;
const END: f64 = 0.03;
/// Its angle after 0.03 s. The test set has 15.81077119629904, which is off by 1.1e-9.
const REFERENCE: f64 = 15.810_771_195_153_707;

/// The best time of a function, ms, from runs of half a second.
fn best(mut run: impl FnMut()) -> f64 {
    let limit = Duration::from_millis(if only_tested() { 0 } else { 500 });
    let begin = Instant::now();
    let mut best = f64::INFINITY;
    loop {
        let start = Instant::now();
        run();
        best = best.min(start.elapsed().as_secs_f64() * 1e3);
        if begin.elapsed() >= limit {
            return best;
        }
    }
}

fn andrews() -> Result<(), Box<dyn Error>> {
    let linkage = Andrews::default().assemble()?;
    let calls = 1000;
    let time = best(|| {
        for call in 0..calls {
            black_box(linkage.motion(START + f64::from(call) * 0.016, 1.0, MOMENT));
        }
    });
    println!(
        "a call of the acceleration: {:.0} ns",
        1e6 * time / f64::from(calls)
    );
    println!(
        "Andrews' squeezing mechanism to 0.03 s: tolerance, error of beta, ms, steps, evaluations"
    );
    let mut cases: Vec<_> = (3..=13).map(|digits| (Method::Explicit, digits)).collect();
    cases.extend([(Method::Implicit, 6), (Method::Implicit, 9)]);
    for (method, digits) in cases {
        let accelerate = |_, [beta]: [f64; 1], [speed]: [f64; 1]| {
            [linkage.motion(beta, speed, MOMENT).acceleration]
        };
        let problem = Problem::new(accelerate)
            .start([START], [0.0])
            .tolerance(10_f64.powi(-digits))
            .method(method)
            .only_end();
        let motion = problem.until(END)?;
        let time = best(|| {
            black_box(problem.until(black_box(END))).ok();
        });
        println!(
            "  {method:?} 1e-{digits:02} {:9.1e} {time:7.4} {:5} {:6}",
            motion.end().inputs[0] - REFERENCE,
            motion.steps(),
            motion.evaluations(),
        );
    }
    for digits in [4, 6, 8, 10, 12] {
        let function = |beta: f64| {
            let energy = linkage.energy(beta, 1.0);
            [2.0 * energy.kinetic, MOMENT * beta - energy.potential]
        };
        let energy = Conservative::new(function).start(START, 0.0);
        let energy = energy.force(|beta| linkage.terms(beta, 0.0, MOMENT).force);
        let energy = energy.tolerance(10_f64.powi(-digits));
        let end = energy.input(END)?;
        let time = best(|| {
            black_box(energy.input(black_box(END))).ok();
        });
        println!(
            "  energy   1e-{digits:02} {:9.1e} {time:7.4}",
            end - REFERENCE
        );
    }
    Ok(())
}

linkage::mechanism! {
    /// A conservative slider-crank with a weight.
    struct SliderCrank {
        unit m;
        input phi = 0deg in 0deg..360deg at omega;
        unknown theta = 0deg;
        unknown x = 0.23m;
        let p = polar(0.05m, phi);
        loop p + polar(0.18m, theta) = (x, 0);
        gravity = (0, -9.80665m/s^2);
        body wheel = pin on frame at (0, 0), turns phi, mass 0.5kg at p / 3, inertia 0.002kg*m^2;
        body rod = pin on wheel at p, turns theta, mass 0.4kg at (p + (x, 0)) / 2, inertia 0.001kg*m^2;
        body piston = slide on frame at (x, 0) along (1, 0), mass 1.3kg at (x, 0);
        pin end = rod on piston at (x, 0);
    }
    impl SliderCrank {
        fn free(phi, omega) -> CrankFree { acceleration: driven_acceleration(phi) }
        fn energy(phi, omega) -> CrankEnergy { kinetic: kinetic_energy(), potential: potential_energy() }
    }
}

/// The energy after many turns: by the integrator, and by the energy integral.
fn drift() -> Result<(), Box<dyn Error>> {
    const SPEED: f64 = 40.0;
    let linkage = SliderCrank::default().assemble()?;
    let energy = |input: f64, speed: f64| {
        let energy = linkage.energy(input, speed);
        energy.kinetic + energy.potential
    };
    let first = energy(0.0, SPEED);
    let function = |input: f64| {
        let energy = linkage.energy(input, 1.0);
        [2.0 * energy.kinetic, -energy.potential]
    };
    let integral = Conservative::new(function).start(0.0, SPEED).period(TAU);
    let turn = integral.time(TAU)?;
    println!("slider-crank: turns, drift of the energy, off in the angle, s");
    let turns = if only_tested() {
        [1.0, 10.0]
    } else {
        [1e2, 1e4]
    };
    for turns in turns {
        let accelerate =
            |_, [phi]: [f64; 1], [omega]: [f64; 1]| [linkage.free(phi, omega).acceleration];
        let problem = Problem::new(accelerate)
            .start([0.0], [SPEED])
            .tolerance(1e-13)
            .most_steps(usize::MAX)
            .only_end();
        let start = Instant::now();
        let end = problem.until(turns * turn)?.end();
        let drift = energy(end.inputs[0], end.speeds[0]) / first - 1.0;
        let off = end.inputs[0] - turns * TAU;
        let time = start.elapsed().as_secs_f64();
        println!("  explicit 1e-13 {turns:9.0} {drift:9.1e} {off:9.1e} {time:9.6}");
    }
    for turns in [1e2, 1e4, 1e6] {
        let start = Instant::now();
        let input = integral.input((turns + 0.25) * turn)?;
        let drift = energy(input, integral.speed(input)) / first - 1.0;
        let off = input - turns * TAU - integral.input(0.25 * turn)?;
        let time = start.elapsed().as_secs_f64();
        println!("  energy         {turns:9.0} {drift:9.1e} {off:9.1e} {time:9.6}");
    }
    Ok(())
}

/// A chain of four-bars: the rocker of each is the crank of the next.
fn chain_text(count: usize) -> String {
    let mut text = String::from(
        "pub struct Chain {
            unit mm;
            input phi = 30deg in 0deg..360deg at omega;
            unknown t1 = 40deg;
            unknown s1 = 80deg;
            loop polar(40mm, phi) + polar(120mm, t1) = (140mm, 0) + polar(100mm, s1);
            body crank = pin on frame at (0, 0), turns phi, inertia 900kg*mm^2;
            body coupler1 = pin on crank at polar(40mm, phi), turns t1,
                mass 0.2kg at polar(40mm, phi) + polar(60mm, t1), inertia 200kg*mm^2;
            body rocker1 = pin on frame at (140mm, 0), turns s1, inertia 700kg*mm^2;
            pin c1 = coupler1 on rocker1 at (140mm, 0) + polar(100mm, s1);\n",
    );
    for k in 2..=count {
        let (before, left, right) = (k - 1, 140 * (k - 1), 140 * k);
        text.push_str(&format!(
            "unknown t{k} = 0deg;
            unknown s{k} = 80deg;
            let p{k} = ({left}mm, 0) + polar(50mm, s{before});
            loop p{k} + polar(140mm, t{k}) = ({right}mm, 0) + polar(50mm, s{k});
            body coupler{k} = pin on rocker{before} at p{k}, turns t{k},
                mass 0.2kg at p{k} + polar(70mm, t{k}), inertia 300kg*mm^2;
            body rocker{k} = pin on frame at ({right}mm, 0), turns s{k}, inertia 400kg*mm^2;
            pin c{k} = coupler{k} on rocker{k} at ({right}mm, 0) + polar(50mm, s{k});\n"
        ));
    }
    text + "} impl Chain { pub fn free(phi, omega) -> Free { a: driven_acceleration(phi) } }"
}

/// The time of a step over the number of four-bars, by the engine.
fn chain() -> Result<(), Box<dyn Error>> {
    println!("chain of four-bars in the engine: count, us a step, us a step and four-bar, steps");
    let counts: &[usize] = if only_tested() {
        &[1, 2]
    } else {
        &[1, 2, 5, 10, 20, 40]
    };
    for &count in counts {
        let mechanism = Mechanism::compile(&chain_text(count))?;
        let assembly = mechanism.assemble(&mechanism.dimensions())?;
        let free = mechanism.function("free")?;
        let accelerate =
            |_, [phi]: [f64; 1], [omega]: [f64; 1]| [assembly.call(free, &[phi, omega])[0]];
        let problem = Problem::new(accelerate).start([0.5], [20.0]).only_end();
        let steps = problem.until(1.0)?.steps();
        let time = best(|| {
            black_box(problem.until(black_box(1.0))).ok();
        });
        let step = 1e3 * time / steps as f64;
        println!(
            "  {count:3} {step:8.2} {:8.3} {steps:5}",
            step / count as f64
        );
    }
    Ok(())
}

fn main() -> Result<(), Box<dyn Error>> {
    andrews()?;
    drift()?;
    chain()
}
