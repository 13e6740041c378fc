//! Estimates, their standard errors and residuals.

use super::{FourBar, FourBarAssembly, LENGTHS, Outcome, drawn, inputs, points, real};
use linkage::design::Measured;
use linkage_random::Random;
use std::error::Error;

/// Without errors the dimensions come back to the last digits, and the hold on undetermined ones leaves no trace.
#[test]
fn exact_readings_give_the_dimensions_back() -> Outcome {
    // Good readings, and such that a hold on dimensions would show.
    for deviation in [0.01, 2.0] {
        let at = inputs(20);
        let read = Measured::new("b", points(&at)?)
            .at_inputs(at)
            .deviations([deviation; 2]);
        let found = drawn()?
            .unknown(LENGTHS)
            .measured(read.computed_by(FourBarAssembly::path_sweep_sets_into))
            .run()?;
        let (found, real) = (found.mechanism, real());
        for (found, real) in [
            (found.crank, real.crank),
            (found.coupler, real.coupler),
            (found.rocker, real.rocker),
        ] {
            assert!((found - real).abs() < 1e-11, "{found} {real}");
        }
    }
    Ok(())
}

/// The normal equations, solved in another way: standard errors of a fit of three lengths by Cramer's rule.
#[test]
fn standard_errors_are_those_of_the_normal_equations() -> Outcome {
    let at = inputs(11);
    let deviations: Vec<[f64; 2]> = (0..11)
        .map(|i| [0.01 + 0.001 * f64::from(i), 0.02])
        .collect();
    let read = Measured::new("b", points(&at)?)
        .at_inputs(at.clone())
        .deviations_each(deviations.clone());
    let found = drawn()?
        .unknown(LENGTHS)
        .measured(read.computed_by(FourBarAssembly::path_sweep_sets_into))
        .measured_itself("rocker", 100.1, 0.005)
        .run()?;
    let linkage = found.mechanism.assemble()?;
    let places = [
        FourBar::INDEX_CRANK,
        FourBar::INDEX_COUPLER,
        FourBar::INDEX_ROCKER,
    ];
    let mut normal = [[0.0; 3]; 3];
    normal[2][2] = 1.0 / (0.005_f64 * 0.005);
    for (&phi, deviation) in at.iter().zip(&deviations) {
        let s = linkage.path(phi).s;
        for (k, deviation) in deviation.iter().enumerate() {
            for i in 0..3 {
                for j in 0..3 {
                    normal[i][j] += s[places[i]][k] * s[places[j]][k] / (deviation * deviation);
                }
            }
        }
    }
    let minor = |i: usize, j: usize| {
        let rest = |k: usize| [(k + 1) % 3, (k + 2) % 3];
        let ([a, b], [c, d]) = (rest(i), rest(j));
        normal[a][c] * normal[b][d] - normal[a][d] * normal[b][c]
    };
    let determinant: f64 = (0..3).map(|j| normal[0][j] * minor(0, j)).sum();
    for i in 0..3 {
        for j in 0..3 {
            let known = minor(i, j) / determinant;
            let covariance = found.covariance()[places[i]][places[j]];
            assert!(
                (covariance / known - 1.0).abs() < 1e-9,
                "{covariance} {known}"
            );
        }
    }
    assert_eq!(found.covariance()[0][0], 0.0);
    Ok(())
}

/// A reading that is left out is as far off as its residual says, divided by the part of its error that it keeps; so the
/// standardised residual is known from two fits.
#[test]
fn standardised_residuals_are_those_of_fits_without_the_reading() -> Outcome {
    let at = inputs(7);
    let mut random = Random::new(11);
    let mut read = points(&at)?;
    for place in read.iter_mut().flatten() {
        *place += random.between(-1e-5, 1e-5);
    }
    let deviation = 1e-5;
    let fit = |read: &Vec<[f64; 2]>| {
        let read = Measured::new("b", read.clone())
            .at_inputs(inputs(7))
            .deviations([deviation; 2]);
        let read = read.computed_by(FourBarAssembly::path_sweep_sets_into);
        Ok::<_, Box<dyn Error>>(drawn()?.unknown(LENGTHS).measured(read).run()?)
    };
    let all = fit(&read)?;
    for (position, &input) in at.iter().enumerate() {
        let mut without = read.clone();
        without[position][1] = f64::NAN;
        let without = fit(&without)?.mechanism.assemble()?;
        let deleted = without.path(input).b.y - read[position][1];
        let own = all
            .residuals
            .iter()
            .find(|own| own.number == "b.y" && own.input == input);
        let own = own.ok_or("no residual")?;
        let kept = own.difference / deleted;
        assert!((0.1..0.999).contains(&kept), "{kept}");
        let standardised = own.difference / (deviation * kept.sqrt());
        let off = (own.standardised / standardised - 1.0).abs();
        assert!(off < 1e-4, "{} {standardised}", own.standardised);
    }
    Ok(())
}

/// Deviations from the scatter: right on average, and an outlier is found beside them.
#[test]
fn deviations_from_the_scatter() -> Outcome {
    let at = inputs(50);
    let mut random = Random::new(3);
    let mut error = || (0..12).map(|_| random.between(-0.5, 0.5)).sum::<f64>();
    let mut read = points(&at)?;
    for place in read.iter_mut().flatten() {
        *place += 0.03 * error();
    }
    read[10][1] += 0.3;
    let measured = |read: &Vec<[f64; 2]>| {
        let read = Measured::new("b", read.clone()).at_inputs(inputs(50));
        let read = read.computed_by(FourBarAssembly::path_sweep_sets_into);
        Ok::<_, Box<dyn Error>>(drawn()?.unknown(LENGTHS).measured(read).run()?)
    };
    let found = measured(&read)?;
    let outliers: Vec<_> = found
        .outliers()
        .map(|own| (own.number, own.input))
        .collect();
    assert_eq!(outliers, [("b.y", at[10])]);
    read[10][1] = f64::NAN;
    let found = measured(&read)?;
    assert_eq!((found.residuals.len(), found.degrees_of_freedom), (99, 96));
    assert!((found.deviation / 0.03 - 1.0).abs() < 4.0 / (2.0_f64 * 96.0).sqrt());
    assert_eq!(found.outliers().count(), 0);
    Ok(())
}
