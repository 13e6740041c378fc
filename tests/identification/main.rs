//! Dimensions from measured positions: what is found, what cannot be, what is told of it.

mod estimates;
mod undetermined;
mod verified;

use linkage::design::{DesignError, Identification, Measured};
use linkage::mechanism;
use linkage_random::Random;
use std::error::Error;
use std::f64::consts::TAU;

mechanism! {
    struct FourBar {
        unit mm;
        param pivot_a = (10mm, 5mm);
        param pivot_d = (150mm, 8mm);
        param shim    = 0mm;
        param zero    = 2deg;
        param turned  = -1deg;
        param crank   = 50mm;
        param coupler = 120mm;
        param rocker  = 100mm;
        input phi = 30deg in 0deg..360deg;
        unknown theta = 40deg;
        unknown psi   = 80deg;
        let a = pivot_a + polar(crank, phi + zero);
        let d = pivot_d + (shim, 0);
        loop a + polar(coupler, theta) = d + polar(rocker, psi);
        let b = d + polar(rocker, psi);
        let reading = psi + turned;
        let away = norm(b);
    }
    impl FourBar {
        fn angle(phi) -> Angle { psi, s: sensitivity(psi) }
        fn encoder(phi) -> Encoder { reading, s: sensitivity(reading) }
        fn path(phi) -> Path { b, s: sensitivity(b) }
        fn distance(phi) -> Distance { away, s: sensitivity(away) }
        fn some(phi) -> Some { b, s: sensitivity(b, [crank, coupler]) }
    }
}

type Outcome = Result<(), Box<dyn Error>>;

const LENGTHS: [&str; 3] = ["crank", "coupler", "rocker"];

fn inputs(count: usize) -> Vec<f64> {
    (0..count).map(|i| TAU * i as f64 / count as f64).collect()
}

/// A four-bar that is a little off.
fn real() -> FourBar {
    let drawn = FourBar::default();
    FourBar {
        crank: drawn.crank + 0.2,
        coupler: drawn.coupler - 0.3,
        rocker: drawn.rocker + 0.1,
        ..drawn
    }
}

fn points(inputs: &[f64]) -> Result<Vec<[f64; 2]>, Box<dyn Error>> {
    let real = real().assemble()?;
    Ok(inputs.iter().map(|&phi| real.path(phi).b.into()).collect())
}

fn drawn() -> Result<Identification<'static, FourBar, FourBarAssembly, 10>, Box<dyn Error>> {
    let drawn = FourBar::default();
    Ok(Identification::new(drawn, drawn.assemble()?))
}

// All that is wrong is told.

#[test]
fn all_that_is_wrong_is_told() -> Outcome {
    let at = inputs(3);
    let read = || Measured::new("b", [[1.0, 2.0]; 3]).at_inputs(inputs(3));
    let path = FourBarAssembly::path_sweep_sets_into;
    let error = drawn()?
        .unknown(["crank", "rod", "crank"])
        .vary("rocker", 3.0, 2.0)
        .measured(
            Measured::new("c", [[1.0]])
                .at_inputs([0.0, 1.0])
                .deviations([-1.0])
                .computed_by(path),
        )
        .measured(read().computed_by(FourBarAssembly::some_sweep_sets_into))
        .run();
    let text = error.unwrap_err().to_string();
    for part in [
        "there is no parameter `rod`; the mechanism has pivot_a.x, ",
        "`crank` is listed twice",
        "the bounds of `rocker` contradict each other",
        "c: 2 inputs, where 1 are needed",
        "the standard deviation of `c` is -1: it must be positive and finite",
        "has no quantity `c`",
        "no derivatives of `b` by rocker",
        "no standard deviations are given for b, but for others",
    ] {
        assert!(text.contains(part), "{part}: {text}");
    }
    let missing = Measured::new("b", [[f64::NAN; 2]; 3]).at_inputs(at);
    let error = drawn()?
        .unknown(LENGTHS)
        .measured(missing.computed_by(path))
        .run();
    assert!(
        error
            .unwrap_err()
            .to_string()
            .contains("all readings are missing")
    );
    let short = FourBar {
        crank: 5.0,
        coupler: 90.0,
        ..FourBar::default()
    };
    let assembly = FourBar::default().assemble()?;
    let error = Identification::new(
        FourBar {
            coupler: 30.0,
            ..short
        },
        assembly,
    )
    .unknown(LENGTHS)
    .measured(read().computed_by(path))
    .run();
    let text = error.unwrap_err().to_string();
    assert!(
        text.starts_with("the mechanism that the fit begins with does not assemble"),
        "{text}"
    );
    // Fewer readings than unknowns are no mistake: what they leave open is told.
    let one = Measured::new("b", points(&[0.3])?)
        .at_inputs([0.3])
        .deviations([0.01; 2]);
    let found = drawn()?
        .unknown(LENGTHS)
        .measured(one.computed_by(path))
        .run()?;
    assert_eq!((found.degrees_of_freedom, found.undetermined.len()), (0, 1));
    Ok(())
}

/// Bounds that are one number hold a parameter there: no mistake.
#[test]
fn numbers_of_the_case_are_told() -> Outcome {
    // The end of its crank is up to 230 mm from the other pivot, coupler and rocker together are 220 mm.
    let long = FourBar {
        crank: 90.0,
        shim: 0.0,
        pivot_a: [10.0, 8.0].into(),
        zero: 0.0,
        ..FourBar::default()
    };
    let read = Measured::new("b", [[1.0, 2.0]; 4]).at_inputs(inputs(4));
    let error = Identification::new(long, FourBar::default().assemble()?)
        .unknown(LENGTHS)
        .measured(read.computed_by(FourBarAssembly::path_sweep_sets_into))
        .run();
    assert_eq!(
        error.unwrap_err().to_string(),
        "the mechanism that the fit begins with does not assemble, or stands at a dead point, for 2 of 8 readings, \
         the first at input 3.14159; begin with dimensions that are nearer"
    );
    assert_eq!(
        DesignError::Unsettled { steps: 1000 }.to_string(),
        "no least sum of squares in 1000 evaluations, which is our limit; give bounds with `vary`, or begin nearer"
    );

    let at = inputs(12);
    let read = Measured::new("b", points(&at)?)
        .at_inputs(at)
        .deviations([0.01; 2]);
    let found = drawn()?
        .vary("crank", 50.2, 50.2)
        .unknown(["coupler", "rocker"])
        .measured(read.computed_by(FourBarAssembly::path_sweep_sets_into))
        .run()?;
    assert!((found.mechanism.crank - 50.2).abs() < 1e-12);
    assert!((found.mechanism.rocker - 100.1).abs() < 1e-6, "{found}");
    Ok(())
}

/// Readings that have nothing to do with the mechanism pull it to where it falls apart: some fits end nowhere. As the message says, bounds help.
#[test]
fn readings_of_something_else_may_have_no_best_fit() -> Outcome {
    let mut random = Random::new(1);
    let mut unsettled = 0;
    for _ in 0..60 {
        let at = inputs(12);
        let far = |[x, y]: [f64; 2], random: &mut Random| {
            [x, y].map(|x| x + random.between(-1000.0, 1000.0))
        };
        let read: Vec<[f64; 2]> = points(&at)?
            .into_iter()
            .map(|b| far(b, &mut random))
            .collect();
        let read = || {
            let read = Measured::new("b", read.iter().copied()).at_inputs(inputs(12));
            read.computed_by(FourBarAssembly::path_sweep_sets_into)
        };
        match drawn()?.unknown(LENGTHS).measured(read()).run() {
            Ok(_) => continue,
            Err(DesignError::Unsettled { steps: 1000 }) => unsettled += 1,
            Err(other) => return Err(other.into()),
        }
        let values = [50.0, 120.0, 100.0];
        let bounded = LENGTHS.iter().zip(values).fold(drawn()?, |fit, (name, x)| {
            fit.vary(name, 0.98 * x, 1.02 * x)
        });
        bounded.measured(read()).run()?;
    }
    assert!(unsettled > 0 && unsettled < 30, "{unsettled}");
    Ok(())
}
