//! The same readings with the errors of many other days.

use super::{COUNT, FourBar, from_points, names, off, points, truth};
use crate::check::Check;
use linkage::Dimensions;
use linkage::design::Identified;
use linkage::tolerance::Uncertainties;
use std::error::Error;

/// Days with other errors.
pub(super) const DAYS: u64 = 100;

/// Estimates over many days against what each day says of itself.
pub(super) fn check_days(check: &mut Check) -> Result<(), Box<dyn Error>> {
    let days = (1..=DAYS).map(|seed| from_points(points(seed)?));
    let days: Vec<_> = days.collect::<Result<_, _>>()?;
    let count = DAYS as f64;
    let all: Vec<[f64; COUNT]> = days.iter().map(off).collect();
    let mean = |of: &dyn Fn(&[f64; COUNT]) -> f64| all.iter().map(of).sum::<f64>() / count;
    for (i, name) in names().enumerate() {
        let bias = mean(&|day| day[i]);
        let spread = mean(&|day| (day[i] - bias).powi(2)).sqrt();
        let within = mean(&|day| f64::from(u8::from(day[i].abs() < 1.96)));
        // Four standard deviations of what is found from so many days.
        check.near(&format!("{name}: mean off"), bias, 0.0, 4.0 / count.sqrt());
        check.near(
            &format!("{name}: spread"),
            spread,
            1.0,
            4.0 / (2.0 * count).sqrt(),
        );
        check.near(
            &format!("{name}: part within 95 %"),
            within,
            0.95,
            4.0 * (0.95 * 0.05 / count).sqrt(),
        );
    }
    let freedom = days[0].degrees_of_freedom as f64;
    let squares = days.iter().map(|day| day.sum_of_squares).sum::<f64>() / count;
    check.near(
        "sum of squares",
        squares,
        freedom,
        4.0 * (2.0 * freedom / count).sqrt(),
    );
    // One correlation, and what one day's covariance says of the coupler point at another position.
    let (i, j) = (FourBar::INDEX_BASE_Y, FourBar::INDEX_COUPLER);
    let product = mean(&|day| day[i] * day[j]) / mean(&|day| day[i] * day[i]);
    let product = product * (mean(&|day| day[i] * day[i]) / mean(&|day| day[j] * day[j])).sqrt();
    check.near(
        "correlation of base.y and coupler",
        product,
        days[0].correlation(i, j),
        0.02,
    );
    let phi = 1.234;
    let real = truth().assemble()?.path(phi).tracer;
    let at = |day: &Identified<FourBar, COUNT>| {
        Ok::<_, Box<dyn Error>>(day.mechanism.assemble()?.path(phi))
    };
    let squares = days
        .iter()
        .map(|day| Ok((at(day)?.tracer.x - real.x).powi(2)));
    let spread = (squares.sum::<Result<f64, Box<dyn Error>>>()? / count).sqrt();
    let uncertain =
        Uncertainties::covariance(&days[0].mechanism.parameters(), days[0].covariance())?;
    let [x, _] = uncertain.budget(&at(&days[0])?.s).standard();
    check.near(
        "uncertainty of a place, in um",
        1e3 * x,
        1e3 * spread,
        4e3 * x / (2.0 * count).sqrt(),
    );
    Ok(())
}
