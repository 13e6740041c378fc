//! Dimensions from measured positions: what is found, what cannot be, what is told of it.

mod estimates;
mod messages;
mod undetermined;
mod verified;

use linkage::design::Identification;
use linkage::mechanism;
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
