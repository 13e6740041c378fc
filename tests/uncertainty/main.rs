//! Accuracy of generated mechanisms: tolerances, budgets, correlations, second order.

mod engine;
mod guide;
mod mechanism;
mod tolerances;

use linkage::tolerance::{Distribution, ToleranceError, Tolerances, Uncertainties};
use linkage::{Parameter, mechanism};
use std::error::Error;

mechanism! {
    struct CrankRocker {
        unit mm;
        param pivot   = (140mm, 5mm) +- 20um;
        param crank   = 50mm  +- 12um;
        param coupler = 120mm +- 20um;
        param rocker  = 100mm +- 20um;
        param arm     = 70mm  +- 15um;
        param lift    = 25deg +- 30arcsec;
        input phi = 30deg in 0deg..360deg;
        unknown theta = 40deg;
        unknown psi   = 80deg;
        let a = polar(crank, phi);
        loop a + polar(coupler, theta) = pivot + polar(rocker, psi);
        let tracer = a + polar(arm, theta + lift);
    }
    impl CrankRocker {
        fn path(phi) -> Path { tracer }
        fn accuracy(phi) -> Accuracy { e: sensitivity(tracer), by_rods: sensitivity(tracer, [coupler, rocker]) }
        fn swing(phi) -> Swing { e: sensitivity(psi) }
        fn first(phi) -> First { e: sensitivity(tracer) }
        fn second(phi) -> Second { e: sensitivity(tracer), h: sensitivity(sensitivity(tracer)) }
        fn third(phi) -> Third {
            e: sensitivity(tracer),
            h: sensitivity(sensitivity(tracer)),
            t: sensitivity(sensitivity(sensitivity(tracer)))
        }
    }
}

type Outcome = Result<(), Box<dyn Error>>;

/// Position of all tests, in radians.
const PHI: f64 = 1.2;
/// Standard uncertainties that are large enough for their second order to show, in mm and rad.
const STANDARD: [f64; 7] = [0.5, 0.25, 0.75, 1.0, 0.625, 0.375, 0.015625];
const CORRELATIONS: [(usize, usize, f64); 3] = [(3, 4, 0.75), (2, 3, -0.5), (0, 1, 0.25)];

fn uncertain() -> Result<Uncertainties<7>, ToleranceError> {
    let exact = Tolerances::new(CrankRocker::PARAMETERS, &[0.0; 7])?;
    let mut uncertain = Uncertainties::new(&exact, Distribution::Normal);
    for (i, standard) in STANDARD.into_iter().enumerate() {
        uncertain = uncertain.standard(i, standard)?;
    }
    uncertain.correlations(&CORRELATIONS)
}

fn near(found: f64, reference: f64, part: f64) {
    let off = (found / reference - 1.0).abs();
    assert!(off <= part, "{found} instead of {reference}: {off:e}");
}

fn quantities<const N: usize>(list: [(&'static str, f64); N]) -> [Parameter; N] {
    list.map(|(name, nominal)| Parameter {
        name,
        unit: "",
        nominal,
        tolerance: 0.0,
    })
}
