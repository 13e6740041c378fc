//! Chains of four-bars: the time of a step over their number.

use crate::timing::best;
use linkage::dynamics::Problem;
use linkage_engine::Mechanism;
use linkage_peers::timing::only_tested;
use std::error::Error;
use std::hint::black_box;

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
pub(crate) fn print() -> Result<(), Box<dyn Error>> {
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
        let time = 1e3
            * best(|| {
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
