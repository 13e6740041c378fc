//! Estimates are verified without the descent: never worse than the start, standard errors at least sums of squares only.

use super::{FourBar, FourBarAssembly, LENGTHS, Outcome, drawn, inputs, points};
use linkage::Dimensions;
use linkage::design::{DesignError, Measured};
use linkage_random::Random;

/// The sum of squares of differences over standard deviations, by single calls.
fn sum_of(mechanism: FourBar, read: &[[f64; 2]], at: &[f64], deviation: f64) -> Option<f64> {
    let linkage = mechanism.assemble().ok()?;
    let square = |(phi, [x, y]): (&f64, &[f64; 2])| {
        let b = linkage.path(*phi).b;
        ((b.x - x) / deviation).powi(2) + ((b.y - y) / deviation).powi(2)
    };
    let sum: f64 = at.iter().zip(read).map(square).sum();
    sum.is_finite().then_some(sum)
}

/// Readings beyond the place where coupler and rocker are in line: the fit ends there, and errors from its slopes would be nearly 0.
#[test]
fn beside_a_flat_triangle_there_are_no_standard_errors() -> Outcome {
    let flat = FourBar {
        crank: 78.0,
        ..FourBar::default()
    };
    let (pivot, phi) = ([150.0, 8.0], std::f64::consts::PI);
    let linkage = flat.assemble()?;
    // The joint mirrored by the line of the pivots of crank and rocker: the other assembly.
    let turned = phi + flat.zero;
    let pin = [
        10.0 + flat.crank * turned.cos(),
        5.0 + flat.crank * turned.sin(),
    ];
    let along = [pin[0] - pivot[0], pin[1] - pivot[1]];
    let size = along[0].hypot(along[1]);
    let [c, s] = along.map(|x| x / size);
    let b = linkage.path(phi).b;
    let (x, y) = (b.x - pivot[0], b.y - pivot[1]);
    let (ahead, aside) = (c * x + s * y, c * y - s * x);
    let read = [[
        pivot[0] + c * ahead + s * aside,
        pivot[1] + s * ahead - c * aside,
    ]];
    let measured = Measured::new("b", read)
        .at_inputs([phi])
        .deviations([0.01; 2]);
    let run = drawn()?
        .unknown(["crank"])
        .measured(measured.computed_by(FourBarAssembly::path_sweep_sets_into))
        .run();
    let found = match run {
        Ok(found) => found,
        Err(DesignError::Unsettled { .. }) => return Ok(()),
        Err(other) => return Err(other.into()),
    };
    assert!(!found.converged, "{found}");
    assert!(found.parameters[0].standard_error.is_nan());
    let index = FourBar::INDEX_CRANK;
    assert!(found.covariance()[index][index].is_nan());
    let text = found.to_string();
    assert!(
        text.contains("not converged: the sum of squares still falls"),
        "{text}"
    );
    let start = sum_of(FourBar::default(), &read, &[phi], 0.01).ok_or("the start")?;
    assert!(found.sum_of_squares <= start);
    Ok(())
}

/// Readings of something else: what is returned is never worse than the start, and where it has standard errors, its slope is nothing
/// beside them. `LINKAGE_LONG=1` takes 10,000 fits.
#[test]
fn estimates_are_stationary_and_not_worse_than_the_start() -> Outcome {
    let long = std::env::var_os("LINKAGE_LONG").is_some();
    let mut random = Random::new(5);
    let (mut counts, mut at_the_edge) = ([0; 3], 0);
    let at = inputs(12);
    let good = points(&at)?;
    for _ in 0..if long { 10_000 } else { 40 } {
        let off = 10_f64.powf(random.between(-2.0, 3.0));
        let read: Vec<[f64; 2]> = good
            .iter()
            .map(|b| b.map(|x| x + random.between(-off, off)))
            .collect();
        let measured = Measured::new("b", read.iter().copied()).at_inputs(at.iter().copied());
        let run = drawn()?
            .unknown(LENGTHS)
            .measured(measured.computed_by(FourBarAssembly::path_sweep_sets_into))
            .run();
        let found = match run {
            Ok(found) => found,
            Err(DesignError::Unsettled { .. }) => {
                counts[2] += 1;
                continue;
            }
            Err(other) => return Err(other.into()),
        };
        let sum = sum_of(found.mechanism, &read, &at, 1.0).ok_or("the estimate")?;
        let start = sum_of(FourBar::default(), &read, &at, 1.0).ok_or("the start")?;
        assert!(found.sum_of_squares <= start, "{found}");
        assert!(
            (sum - found.sum_of_squares).abs() <= 1e-9 * sum,
            "{sum} {found}"
        );
        for own in &found.parameters {
            assert!(
                found.converged || !own.standard_error.is_finite(),
                "{found}"
            );
        }
        // Within a few millimetres the readings are those of a mechanism that is not at its end.
        assert!(found.converged || off > 3.0, "{off} {found}");
        counts[usize::from(found.converged)] += 1;
        if !found.converged {
            continue;
        }
        // By differences: the slope over that of the standard error, which other parameters do not share.
        for own in found
            .parameters
            .iter()
            .filter(|own| own.standard_error.is_finite())
        {
            let moved = |by: f64| {
                let mut values = found.mechanism.values();
                values[own.index] += by;
                sum_of(FourBar::from_values(&values), &read, &at, 1.0)
            };
            let step = (1e-3 * own.standard_error).min(1e-4);
            let (Some(more), Some(less)) = (moved(step), moved(-step)) else {
                at_the_edge += 1;
                continue;
            };
            let curvature = (more + less - 2.0 * sum) / (step * step);
            let slope = (more - less) / (2.0 * step);
            let alone = found.deviation * (2.0 / curvature.max(1e-9)).sqrt();
            let length = slope * alone / (2.0 * found.deviation * found.deviation);
            assert!(length.abs() < 0.02 || curvature <= 0.0, "{length} {found}");
        }
    }
    println!(
        "{counts:?} not converged, converged, without a least sum; {at_the_edge} estimates of these fall apart beside themselves"
    );
    assert!(100 * at_the_edge <= counts[1], "{at_the_edge}");
    assert!(counts[1] > 20, "{counts:?}");
    Ok(())
}
