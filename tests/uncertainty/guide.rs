//! Examples of the Guide to the Expression of Uncertainty in Measurement.

use super::{Outcome, near, quantities};
use linkage::tolerance::{Distribution, Tolerances, Uncertainties};
use std::array;

/// JCGM 100:2008, H.2: resistance, reactance and impedance from correlated readings.
#[test]
fn simultaneous_resistance_and_reactance() -> Outcome {
    // Volts, amperes, radians: five sets of simultaneous readings.
    let readings = [
        [5.007, 4.994, 5.005, 4.990, 4.999],
        [19.663e-3, 19.639e-3, 19.640e-3, 19.685e-3, 19.678e-3],
        [1.0456, 1.0438, 1.0468, 1.0428, 1.0433],
    ];
    let means: [f64; 3] = readings.map(|values| values.iter().sum::<f64>() / 5.0);
    // Of the means: the sum of products over n (n - 1).
    let covariance: [[f64; 3]; 3] = array::from_fn(|a| {
        array::from_fn(|b| {
            let product = |k: usize| (readings[a][k] - means[a]) * (readings[b][k] - means[b]);
            (0..5).map(product).sum::<f64>() / 20.0
        })
    });
    let [v, i, phi] = means;
    let uncertain =
        Uncertainties::covariance(&quantities([("V", v), ("I", i), ("phi", phi)]), &covariance)?;
    for (found, printed) in uncertain
        .standard_uncertainties()
        .into_iter()
        .zip([0.0032, 0.0095e-3, 0.00075])
    {
        near(found, printed, 0.01);
    }
    let (z, [sin, cos]) = (v / i, [phi.sin(), phi.cos()]);
    let by_readings = [
        [cos / i, sin / i, 1.0 / i],
        [-z / i * cos, -z / i * sin, -z / i],
        [-z * sin, z * cos, 0.0],
    ];
    let budget = uncertain.budget(&by_readings);
    // As printed there.
    for (found, printed) in budget.standard().into_iter().zip([0.071, 0.295, 0.236]) {
        assert!((found - printed).abs() < 0.0006, "{found}");
    }
    let r = budget.correlation();
    for (found, printed) in [(r[0][1], -0.588), (r[0][2], -0.485), (r[1][2], 0.993)] {
        assert!((found - printed).abs() < 0.0006, "{found}");
    }
    for k in 0..3 {
        near(
            budget.lines(k).iter().map(|line| line.share).sum(),
            1.0,
            1e-13,
        );
    }
    // The same by correlations.
    let [a, b, c] = *uncertain.correlation_matrix();
    let mut alone = Uncertainties::new(uncertain.tolerances(), Distribution::Normal);
    for (index, standard) in uncertain.standard_uncertainties().into_iter().enumerate() {
        alone = alone.standard(index, standard)?;
    }
    let again = alone.correlations(&[(0, 1, a[1]), (2, 0, c[0]), (1, 2, b[2])])?;
    for (a, b) in again
        .budget(&by_readings)
        .standard()
        .into_iter()
        .zip(budget.standard())
    {
        near(a, b, 1e-12);
    }
    Ok(())
}

/// JCGM 100:2008, H.1: an end gauge, in nm, with effective degrees of freedom and second order.
#[test]
fn end_gauge() -> Outcome {
    let (ls, alpha, theta) = (50_000_623.0, 11.5e-6, -0.1);
    let list = [
        ("standard", ls),
        ("comparator", 215.0),
        ("comparator, random", 0.0),
        ("comparator, systematic", 0.0),
        ("expansion", alpha),
        ("bed", theta),
        ("bed, cyclic", 0.0),
        ("difference of expansions", 0.0),
        ("difference of temperatures", 0.0),
    ];
    let limits = [0.0, 0.0, 0.0, 0.0, 2e-6, 0.0, 0.5, 1e-6, 0.05];
    let tolerances = Tolerances::new(&quantities(list), &limits)?;
    let mut uncertain = Uncertainties::new(&tolerances, Distribution::Uniform)
        .distribution_of(6, Distribution::Arcsine)?
        .degrees_of_freedom(7, 50.0)?
        .degrees_of_freedom(8, 2.0)?;
    for (i, standard, degrees) in [
        (0, 25.0, 18.0),
        (1, 5.8, 24.0),
        (2, 3.9, 5.0),
        (3, 6.7, 8.0),
        (5, 0.2, f64::INFINITY),
    ] {
        uncertain = uncertain
            .standard(i, standard)?
            .degrees_of_freedom(i, degrees)?;
    }
    // l = ls + d - ls * (difference of expansions * bed + expansion * difference of temperatures)
    let first = [1.0, 1.0, 1.0, 1.0, 0.0, 0.0, 0.0, -ls * theta, -ls * alpha];
    let budget = uncertain.budget(&first);
    assert!((budget.standard()[0] - 32.0).abs() < 0.5);
    assert!((budget.degrees_of_freedom(0) - 16.7).abs() < 0.3);
    assert!((budget.expanded(0, 0.99) - 93.0).abs() < 1.5);
    let mut second = [[0.0; 9]; 9];
    for (i, j, value) in [
        (5, 7, -ls),
        (6, 7, -ls),
        (4, 8, -ls),
        (0, 7, -theta),
        (0, 8, -alpha),
    ] {
        (second[i][j], second[j][i]) = (value, value);
    }
    let order = uncertain.second_order(&first, &second);
    assert!((order.quadratic[0][0].sqrt() - 11.7_f64.hypot(1.7)).abs() < 0.2);
    assert!((order.standard()[0] - 34.0).abs() < 0.5);
    assert_eq!(order.shift, [0.0]);
    let table = budget.to_string();
    assert!(table.contains("difference of temperatures"), "{table}");
    assert!(table.contains("arcsine"), "{table}");
    Ok(())
}

// Closed forms.

/// Powers and products, whose moments are polynomials.
#[test]
fn closed_forms() -> Outcome {
    let x = quantities([("x", 3.0)]);
    let half = Tolerances::<1>::new(&x, &[0.5])?;
    for (distribution, variance, fourth) in [
        (Distribution::Normal, 1.0 / 36.0, 3.0 / 1296.0),
        (Distribution::Uniform, 1.0 / 12.0, 1.0 / 80.0),
        (Distribution::Triangular, 1.0 / 24.0, 1.0 / 240.0),
        (Distribution::Arcsine, 1.0 / 8.0, 3.0 / 128.0),
    ] {
        let square = Uncertainties::new(&half, distribution).second_order(&[6.0], &[[2.0]]);
        near(square.shift[0], variance, 1e-14);
        let exact = 36.0 * variance + fourth - variance * variance;
        near(square.covariance()[0][0], exact, 1e-14);
        let cube = Uncertainties::new(&half, distribution).second_order(&[27.0], &[[18.0]]);
        let cube = cube.with_third(&[[[6.0]]]);
        // All but the sixth power of the deviation: 729 u^2 + 81 (k - 1) u^4 + 54 k u^4.
        let exact = 729.0 * variance + 135.0 * fourth - 81.0 * variance * variance;
        near(cube.covariance()[0][0], exact, 1e-14);
    }
    let pair = Tolerances::<2>::new(&quantities([("a", 2.0), ("b", 5.0)]), &[0.3, 0.6])?;
    let pair = Uncertainties::new(&pair, Distribution::Normal).correlations(&[(0, 1, 0.5)])?;
    let product = pair.second_order(&[5.0, 2.0], &[[0.0, 1.0], [1.0, 0.0]]);
    // Of normal variables: mean a b + c, variance a^2 v + b^2 u + 2 a b c + u v + c^2.
    near(product.shift[0], 0.01, 1e-14);
    let exact = 4.0 * 0.04 + 25.0 * 0.01 + 2.0 * 10.0 * 0.01 + 0.0004 + 0.0001;
    near(product.covariance()[0][0], exact, 1e-14);
    Ok(())
}
