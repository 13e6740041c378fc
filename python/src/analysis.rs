//! Effects of tolerances, and figures of a cycle.

use linkage_analysis::summary::{self, Extremes, Interval, Kind};
use linkage_engine::{Mechanism, SensitiveQuantity};
use pyo3::prelude::*;

use crate::raised::no_figures;

/// The effects on a quantity: its name, the indices of its parameters, the worst and the
/// statistical error at all positions, the part of each parameter, and the text for the first
/// position.
pub(crate) type Effects = (
    String,
    Vec<usize>,
    Vec<f64>,
    Vec<f64>,
    Vec<Vec<f64>>,
    String,
);

/// The extremes of the quantity and its derivatives, dwells within a band, both strokes, the
/// transmission angle with its inputs, the parts of the range that are assembled, and a text.
pub(crate) type Curve = (
    Vec<Vec<Extreme>>,
    Vec<Dwell>,
    Option<(f64, f64)>,
    [(f64, f64); 2],
    Vec<(f64, f64)>,
    String,
);

/// Input, value, kind, and whether it is an end of the curve.
pub(crate) type Extreme = (f64, f64, &'static str, bool);

/// Beginning, end and length of an interval, and the lowest and the highest value in it.
pub(crate) type Dwell = (f64, f64, f64, f64, f64);

/// Computes the effects of tolerances at all positions of the columns of a function, each of
/// `positions` numbers.
///
/// # Errors
///
/// The exceptions of tolerances that are negative or not finite, and of too many parameters.
pub(crate) fn effects(
    py: Python<'_>,
    mechanism: &Mechanism,
    function: usize,
    columns: &[f64],
    positions: usize,
) -> PyResult<Vec<Effects>> {
    let row = |position: usize| -> Vec<f64> {
        let columns = columns.chunks(positions.max(1));
        columns.map(|column| column[position]).collect()
    };
    let quantities = mechanism.sensitive_quantities(function).into_iter();
    let one = |quantity: SensitiveQuantity| {
        let mut found = (
            quantity.name.clone(),
            quantity.parameters.clone(),
            Vec::with_capacity(positions),
            Vec::with_capacity(positions),
            vec![Vec::with_capacity(positions); quantity.parameters.len()],
            String::new(),
        );
        for position in 0..positions {
            let effects = quantity.effects(mechanism, &row(position))?;
            found.2.push(effects.worst);
            found.3.push(effects.statistical);
            for (parts, part) in found.4.iter_mut().zip(effects.parts) {
                parts.push(part);
            }
            if position == 0 {
                found.5 = effects.text;
            }
        }
        Ok::<_, linkage_engine::ToleranceError>(found)
    };
    let all: Result<Vec<Effects>, _> = py.detach(|| quantities.map(one).collect());
    all.map_err(|error| no_figures(py, error.to_string()))
}

/// Follows a quantity over a range: `jet` returns its value and the derivatives.
///
/// # Errors
///
/// The exceptions of a range that is empty or without an assembled position.
pub(crate) fn curve(
    py: Python<'_>,
    jet: impl Fn(f64) -> Vec<f64> + Send,
    count: usize,
    range: (f64, f64),
    positions: usize,
    band: Option<f64>,
    units: &(String, String),
) -> PyResult<Curve> {
    let found = py.detach(|| match count {
        2 => figures::<2>(jet, range, positions, band, units),
        3 => figures::<3>(jet, range, positions, band, units),
        _ => figures::<4>(jet, range, positions, band, units),
    });
    found.map_err(|error| no_figures(py, error.to_string()))
}

fn figures<const N: usize>(
    jet: impl Fn(f64) -> Vec<f64>,
    range: (f64, f64),
    positions: usize,
    band: Option<f64>,
    (unit, input): &(String, String),
) -> Result<Curve, summary::SummaryError> {
    let jet = |x: f64| {
        let numbers = jet(x);
        std::array::from_fn(|index| numbers[index])
    };
    let curve = summary::Curve::<N, _>::new(range, positions, jet)?;
    let dwells = band.map_or_else(Vec::new, |band| curve.dwells(band));
    let dwells = dwells.into_iter().map(|dwell| {
        let Interval { from, to, range } = dwell.interval;
        (from, to, range, dwell.lowest, dwell.highest)
    });
    let mut text = curve.describe(unit, input).to_string();
    if let Some(band) = band {
        text += &curve.describe_dwells(band, unit, input).to_string();
    }
    // The last derivative has no extremes: its own derivative is not known.
    let extremes = (0..N).map_while(|order| curve.extremes_of(order));
    Ok((
        extremes.map(points).collect(),
        dwells.collect(),
        curve.time_ratio().map(|ratio| (ratio.rise, ratio.fall)),
        curve.transmission_angle().map(|one| (one.at, one.angle)),
        curve
            .parts()
            .iter()
            .map(|part| (part.from, part.to))
            .collect(),
        text,
    ))
}

/// All stationary places in order of the input, then the lowest and the highest.
fn points(extremes: &Extremes) -> Vec<Extreme> {
    let all = extremes.points.iter();
    let all = all.chain([&extremes.lowest, &extremes.highest]);
    all.map(|one| {
        let kind = match one.kind {
            Kind::High => "high",
            Kind::Low => "low",
            Kind::Pass => "pass",
        };
        (one.at, one.value, kind, one.end)
    })
    .collect()
}
