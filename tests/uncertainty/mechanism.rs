//! A mechanism against many digits, random mechanisms and the worst one.

use super::{CrankRocker, Outcome, PHI, STANDARD, near, uncertain};
use linkage::Dimensions;
use linkage::tolerance::{Distribution, MonteCarlo, Samples, Tolerances, Uncertainties};
use std::error::Error;

/// Closed form of the four-bar, derivatives by differences in 90 digits, sums in 50.
#[test]
#[allow(clippy::excessive_precision, reason = "digits of the reference")]
fn all_orders_against_many_digits() -> Outcome {
    let linkage = CrankRocker::default().assemble()?;
    let d = linkage.third(PHI);
    let found = uncertain()?.second_order(&d.e, &d.h).with_third(&d.t);
    let covariance = -0.27951398838020808019668018087404;
    let pairs = [
        (found.linear[0][0], 1.1362361698132231284216891747342),
        (found.linear[1][1], 0.81811114387310741871960578855586),
        (found.linear[0][1], covariance),
        (found.linear[1][0], covariance),
        (found.shift[0], -0.0022451443976697158122133829399353),
        (found.shift[1], -0.010518570164710787031408573532462),
        (found.quadratic[0][0], 0.00010803510289987600895079830074963),
        (found.quadratic[1][1], 0.00015287376633065998252421706243441),
        (
            found.quadratic[0][1],
            0.000056885590338090081385089297138229,
        ),
        (found.cubic[0][0], -0.00031314733907349545476974053033564),
        (found.cubic[1][1], -0.000094838197389769216002844085531036),
        (found.cubic[0][1], 0.000085503363338863498624595151725148),
    ];
    for (found, reference) in pairs {
        // Sums of terms that are up to a thousand times as large.
        near(found, reference, 1e-12);
    }
    let budget = uncertain()?.budget(&d.e);
    assert_eq!(budget.covariance(), found.linear);
    let sensitivity = budget.lines(0)[CrankRocker::INDEX_LIFT].sensitivity;
    near(sensitivity, -56.190593065540540563222748545001, 1e-14);
    Ok(())
}

fn sampled(uncertain: &Uncertainties<7>, count: usize) -> Result<Samples<7, 2>, Box<dyn Error>> {
    let mechanism = CrankRocker::default();
    let linkage = mechanism.assemble()?;
    let samples = MonteCarlo::new(count).seed(5).run_correlated(
        &mechanism,
        uncertain,
        |mechanisms, [x, y]| {
            let rows = linkage.path_sweep_sets(mechanisms, &[PHI]);
            let [px, py] = rows.tracer();
            x.copy_from_slice(px);
            y.copy_from_slice(py);
        },
    )?;
    assert_eq!(samples.missing(), 0);
    Ok(samples)
}

/// The sampled mean is that of second order, far from the value of nominal dimensions; the deviations are those with
/// correlations, far from those without.
#[test]
fn random_mechanisms_that_are_correlated() -> Outcome {
    let linkage = CrankRocker::default().assemble()?;
    let (uncertain, d) = (uncertain()?, linkage.third(PHI));
    let theory = uncertain.second_order(&d.e, &d.h).with_third(&d.t);
    let samples = sampled(&uncertain, 100_000)?;
    let nominal: [f64; 2] = linkage.path(PHI).tracer.into();
    let mut alone = Uncertainties::new(uncertain.tolerances(), Distribution::Normal);
    for (i, standard) in STANDARD.into_iter().enumerate() {
        alone = alone.standard(i, standard)?;
    }
    let without = alone.budget(&d.e).standard();
    for (k, nominal) in nominal.into_iter().enumerate() {
        let statistics = samples.statistics(k);
        let mean = nominal + theory.shift[k];
        assert!(statistics.mean.low < mean && mean < statistics.mean.high);
        let standard = theory.standard()[k];
        assert!(statistics.deviation.low < standard && standard < statistics.deviation.high);
    }
    let off = without[0] / theory.standard()[0] - 1.0;
    assert!(off.abs() > 0.02, "{off}");
    let y = samples.statistics(1).mean;
    assert!(y.high < nominal[1], "{y}");
    // The covariance of both components.
    let [x, y] = [0, 1].map(|k| samples.values(k));
    let mean = |values: &[f64]| values.iter().sum::<f64>() / values.len() as f64;
    let (mx, my) = (mean(x), mean(y));
    let products: Vec<f64> = x.iter().zip(y).map(|(x, y)| (x - mx) * (y - my)).collect();
    near(mean(&products), theory.covariance()[0][1], 0.03);
    Ok(())
}

/// Uniform, triangular and arcsine zones that are not symmetrical.
#[test]
fn random_mechanisms_with_other_limits() -> Outcome {
    let mechanism = CrankRocker::default();
    let linkage = mechanism.assemble()?;
    let tolerances = Tolerances::complete(CrankRocker::PARAMETERS)?
        .limits(CrankRocker::INDEX_CRANK, -0.01, 0.03)?
        .limits(CrankRocker::INDEX_COUPLER, -0.05, -0.02)?
        .limits(CrankRocker::INDEX_ARM, 0.0, 0.04)?;
    let uncertain = Uncertainties::new(&tolerances, Distribution::Uniform)
        .distribution_of(CrankRocker::INDEX_COUPLER, Distribution::Triangular)?
        .distribution_of(CrankRocker::INDEX_ARM, Distribution::Arcsine)?;
    let samples = sampled(&uncertain, 50_000)?;
    let e = linkage.first(PHI).e;
    let (effects, budget) = (tolerances.effects(&e), uncertain.budget(&e));
    let nominal: [f64; 2] = linkage.path(PHI).tracer.into();
    for (k, nominal) in nominal.into_iter().enumerate() {
        let (statistics, mean) = (samples.statistics(k), nominal + effects.shift()[k]);
        assert!(effects.shift()[k].abs() > 1e-3);
        assert!(statistics.mean.low < mean && mean < statistics.mean.high);
        let standard = budget.standard()[k];
        assert!(statistics.deviation.low < standard && standard < statistics.deviation.high);
        let farthest = (statistics.max - nominal).max(nominal - statistics.min);
        // The linear worst case; second order is a ten-thousandth of it here.
        assert!(farthest < 1.0001 * effects.worst_case()[k]);
    }
    Ok(())
}

/// The worst mechanism of zones that are not symmetrical has its dimensions at the limits that are told.
#[test]
fn the_worst_mechanism_of_other_limits() -> Outcome {
    let nominal = CrankRocker::default();
    let linkage = nominal.assemble()?;
    let tolerances = Tolerances::<7>::complete(CrankRocker::PARAMETERS)?
        .limits(CrankRocker::INDEX_CRANK, 0.0, 0.03)?
        .limits(CrankRocker::INDEX_ROCKER, -0.04, -0.01)?;
    for degrees in (0..360).step_by(30) {
        let phi = f64::from(degrees).to_radians();
        let effects = tolerances.effects(&linkage.first(phi).e);
        let (vector, signs) = effects.worst_vector();
        let error = |signs: &dyn Fn(usize) -> f64| -> Result<_, Box<dyn Error>> {
            let mut values = nominal.values();
            for (i, value) in values.iter_mut().enumerate() {
                *value += tolerances.middles()[i] + signs(i) * tolerances.values()[i];
            }
            let worst = CrankRocker::from_values(&values).assemble()?;
            Ok(worst.path(phi).tracer - linkage.path(phi).tracer)
        };
        let worst = error(&|i| signs[i])?;
        assert!((worst.x - vector[0]).hypot(worst.y - vector[1]) < 1e-3 * worst.norm());
        near(worst.norm(), effects.worst_modulus(), 1e-3);
        for choice in 0..128 {
            let other = error(&|i| if choice >> i & 1 == 1 { 1.0 } else { -1.0 })?;
            assert!(other.norm() < 1.001 * effects.worst_modulus());
        }
        let parts = effects.contributions().map(|part| part.share_of_worst_case);
        near(parts.iter().sum(), 1.0, 1e-12);
    }
    Ok(())
}
