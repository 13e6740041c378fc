//! Closed forms.

use super::{Outcome, near, quantities};
use linkage::tolerance::{Distribution, Tolerances, Uncertainties};

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
