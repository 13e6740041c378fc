//! What the readings do not determine, and what would tell.

use super::{FourBar, FourBarAssembly, Outcome, drawn, inputs, points, real};
use linkage::Dimensions;
use linkage::design::{DesignError, Identification, Measured};
use linkage_random::Random;
use std::error::Error;

fn told(
    identification: &Identification<'_, FourBar, FourBarAssembly, 10>,
) -> Result<Vec<String>, DesignError> {
    Ok(identification
        .run()?
        .undetermined
        .into_iter()
        .map(|own| own.words)
        .collect())
}

/// What an angle, an encoder, a distance and a point cannot tell.
#[test]
fn what_cannot_be_told_apart_is_named() -> Outcome {
    let at = inputs(24);
    let real = real().assemble()?;
    let angles: Vec<[f64; 1]> = at.iter().map(|&phi| [real.encoder(phi).reading]).collect();
    let angles = Measured::new("reading", angles)
        .at_inputs(at.clone())
        .deviations([1e-4]);
    let point = Measured::offer("b")
        .at_inputs(at.clone())
        .deviations([0.01; 2]);
    let all = || FourBar::PARAMETERS.iter().map(|parameter| parameter.name);
    let words = told(
        &drawn()?
            .unknown(all())
            .measured(
                angles
                    .clone()
                    .computed_by(FourBarAssembly::encoder_sweep_sets_into),
            )
            .offered(point.computed_by(FourBarAssembly::path_sweep_sets_into)),
    )?;
    let start = |start: &str| words.iter().any(|words| words.starts_with(start));
    assert_eq!(words.len(), 5, "{words:#?}");
    assert!(
        start(
            "`pivot_a.x` and `pivot_d.x` cannot be told apart: what was measured stays when they change together, `pivot_a.x` by 1 mm, `pivot_d.x` by 1 mm; `b.x` would tell"
        ),
        "{words:#?}"
    );
    assert!(
        start("`pivot_a.x` and `shim` cannot be told apart"),
        "{words:#?}"
    );
    assert!(
        start("`pivot_a.y` and `pivot_d.y` cannot be told apart"),
        "{words:#?}"
    );
    assert!(start("a common scale of `pivot_a.x`,"), "{words:#?}");
    assert!(
        start("a common rotation about the origin of `pivot_a.x`,"),
        "{words:#?}"
    );
    // What the point tells: all but the encoder's zero, which moves nothing, and the shim.
    let read = Measured::new("b", points(&at)?)
        .at_inputs(at.clone())
        .deviations([0.01; 2]);
    let encoder = Measured::offer("reading")
        .at_inputs([0.5])
        .deviations([1e-4]);
    let words = told(
        &drawn()?
            .unknown(all())
            .measured(
                read.clone()
                    .computed_by(FourBarAssembly::path_sweep_sets_into),
            )
            .offered(encoder.computed_by(FourBarAssembly::encoder_sweep_sets_into)),
    )?;
    assert_eq!(
        words,
        [
            "`turned` changes nothing that was measured; `reading` would tell, best at `phi` = 0.5",
            "`pivot_d.x` and `shim` cannot be told apart: what was measured stays when they change together, `pivot_d.x` by 1 mm, \
             `shim` by -1 mm",
        ]
    );
    // A ruler for the shim, and the encoder: everything.
    let words = told(
        &drawn()?
            .unknown(all())
            .measured(read.computed_by(FourBarAssembly::path_sweep_sets_into))
            .measured(angles.computed_by(FourBarAssembly::encoder_sweep_sets_into))
            .measured_itself("shim", 0.0, 0.01),
    )?;
    assert_eq!(words, [""; 0]);
    // A distance from the origin stays when everything turns about it.
    let away: Vec<[f64; 1]> = at.iter().map(|&phi| [real.distance(phi).away]).collect();
    let away = Measured::new("away", away).at_inputs(at).deviations([0.01]);
    let unknown = [
        "pivot_a.x",
        "pivot_a.y",
        "pivot_d.x",
        "pivot_d.y",
        "zero",
        "crank",
        "coupler",
        "rocker",
    ];
    let words = told(
        &drawn()?
            .unknown(unknown)
            .measured(away.computed_by(FourBarAssembly::distance_sweep_sets_into)),
    )?;
    assert_eq!(words.len(), 1, "{words:#?}");
    assert!(
        words[0].starts_with("a common rotation about the origin of `pivot_a.x`,"),
        "{words:#?}"
    );
    Ok(())
}

/// Whatever is unknown and read: as many combinations are told as are missing, and a mechanism that is moved along one
/// that changes nothing gives the same readings, but for the square of the step.
#[test]
fn what_is_told_changes_nothing() -> Outcome {
    let mut random = Random::new(5);
    let at = inputs(24);
    let nominal = FourBar::default();
    let linkage = nominal.assemble()?;
    let angles = |linkage: &FourBarAssembly, phi| [linkage.encoder(phi).reading];
    let points = |linkage: &FourBarAssembly, phi| <[f64; 2]>::from(linkage.path(phi).b);
    let distances = |linkage: &FourBarAssembly, phi| [linkage.distance(phi).away];
    let mut told = 0;
    for case in 0..60 {
        let unknown: Vec<&str> = FourBar::PARAMETERS
            .iter()
            .map(|parameter| parameter.name)
            .filter(|_| random.chance(0.7))
            .collect();
        if unknown.is_empty() {
            continue;
        }
        let all = drawn()?.unknown(unknown.iter().copied());
        let measured = match case % 3 {
            0 => {
                let read = Measured::new("reading", at.iter().map(|&phi| angles(&linkage, phi)));
                let read = read.at_inputs(at.clone()).deviations([1e-6]);
                all.measured(read.computed_by(FourBarAssembly::encoder_sweep_sets_into))
            }
            1 => {
                let read = Measured::new("b", at.iter().map(|&phi| points(&linkage, phi)));
                let read = read.at_inputs(at.clone()).deviations([1e-4; 2]);
                all.measured(read.computed_by(FourBarAssembly::path_sweep_sets_into))
            }
            _ => {
                let read = Measured::new("away", at.iter().map(|&phi| distances(&linkage, phi)));
                let read = read.at_inputs(at.clone()).deviations([1e-4]);
                all.measured(read.computed_by(FourBarAssembly::distance_sweep_sets_into))
            }
        };
        let found = measured.run()?;
        let rank = found.residuals.len() - found.degrees_of_freedom;
        assert_eq!(rank + found.undetermined.len(), unknown.len(), "{found}");
        for own in found.undetermined.iter().filter(|own| own.exactly) {
            told += 1;
            let size = own
                .parts
                .iter()
                .map(|(_, change)| change.abs())
                .fold(0.0, f64::max);
            let change = |step: f64| -> Result<f64, Box<dyn Error>> {
                let mut values = nominal.values();
                for (name, change) in &own.parts {
                    let mut all = FourBar::PARAMETERS.iter();
                    let index = all.position(|parameter| parameter.name == *name);
                    values[index.ok_or("no such parameter")?] += step * change / size;
                }
                let moved = FourBar::from_values(&values).assemble()?;
                let differences = at.iter().map(|&phi| match case % 3 {
                    0 => (angles(&moved, phi)[0] - angles(&linkage, phi)[0]).abs() * 100.0,
                    1 => (moved.path(phi).b - linkage.path(phi).b).norm(),
                    _ => (distances(&moved, phi)[0] - distances(&linkage, phi)[0]).abs(),
                });
                Ok(differences.fold(0.0, f64::max))
            };
            let step = if own
                .parts
                .iter()
                .any(|(name, _)| ["zero", "turned"].contains(name))
            {
                1e-5
            } else {
                1e-3
            };
            assert!(change(step)? < 1e-2 * step, "{own}: {}", change(step)?);
        }
    }
    assert!(told > 60, "{told}");
    Ok(())
}

/// Readings too coarse for what a bound leaves open.
#[test]
fn what_readings_are_not_good_enough_for() -> Outcome {
    let at = inputs(6);
    let read = Measured::new("b", points(&at)?)
        .at_inputs(at.clone())
        .deviations([0.05; 2]);
    let found = drawn()?
        .vary("crank", 49.999, 50.001)
        .unknown(["coupler", "rocker"])
        .measured(read.computed_by(FourBarAssembly::path_sweep_sets_into))
        .run()?;
    assert_eq!(
        found.undetermined[0].words,
        "`crank` changes nothing that was measured, within what the readings are good for"
    );
    assert!(!found.undetermined[0].exactly);
    assert!((49.999..=50.001).contains(&found.mechanism.crank));
    assert!(found.parameters[0].is_at_bound && !found.parameters[1].is_at_bound);
    assert!(
        found.to_string().contains("not determined, at its bound"),
        "{found}"
    );
    assert!(found.parameters[0].standard_error.is_infinite());
    Ok(())
}
