//! Ends, assemblies and special cases of the slider-crank in space; the example `spatial_slider_crank` has positions.
//!
//! A line through the
//! crank's plane gives the slider-crank of the plane, which is compared with its formulas.

use crate::check::Check;
use std::error::Error;

include!("../../mechanisms/spatial_slider_crank.rs");

/// Crank angle in degrees and slide in mm where the slide turns back, from the same solution.
const FAR: (f64, f64) = (34.484966428375095, 122.79883186926125);
const NEAR: (f64, f64) = (214.17618026519577, 46.95053283594991);

#[test]
fn known_answers_are_met() -> Result<(), Box<dyn Error>> {
    let mut check = Check::default();
    let linkage = SpatialSlider::default().assemble()?;
    ends(&mut check, &linkage);
    assemblies(&mut check)?;
    plane(&mut check)?;
    accuracy(&mut check, &linkage);
    check.finish()
}

/// Where the slide turns back.
fn ends(check: &mut Check, linkage: &SpatialSliderAssembly) {
    println!("Ends of the stroke:");
    let still =
        |lo: f64, hi: f64| bisect(lo.to_radians(), hi.to_radians(), |x| linkage.stroke(x).v);
    let (far, near) = (still(0.0, 120.0), still(180.0, 300.0));
    check.near("far end at, deg", far.to_degrees(), FAR.0, 1e-11);
    check.near("near end at, deg", near.to_degrees(), NEAR.0, 1e-11);
    let stroke = linkage.stroke(far).s - linkage.stroke(near).s;
    check.near("stroke, mm", stroke, FAR.1 - NEAR.1, 1e-12);
    for phi in [far, near] {
        // The rod is at a right angle to the velocity of the pin: it meets the axis of the crank.
        let Joints { pin, slide } = linkage.joints(phi);
        let rod = slide - pin;
        let lever = pin.x * rod.y - pin.y * rod.x;
        check.near("lever of the rod about the crank, mm2", lever, 0.0, 1e-9);
    }
    let back = (near - far).to_degrees();
    println!("       time ratio {:.6}", (360.0 - back) / back);
}

/// The rod reaches the line at two places.
fn assemblies(check: &mut Check) -> Result<(), Box<dyn Error>> {
    println!("Both assemblies at 60 degrees:");
    let phi = 60_f64.to_radians();
    let mechanism = SpatialSlider::default();
    let found = mechanism.assemblies_at(phi)?;
    check.holds("two of them", found.len() == 2);
    let s: Vec<f64> = found.iter().map(|l| l.stroke(phi).s).collect();
    let Joints { pin, .. } = found[0].joints(phi);
    // Sum and product of the roots of s^2 + 2 p s + c.
    let (sin, cos) = mechanism.rise.sin_cos();
    let along = [
        cos * mechanism.bearing.cos(),
        cos * mechanism.bearing.sin(),
        sin,
    ];
    let offset = mechanism.foot - pin;
    let p = offset.x * along[0] + offset.y * along[1] + offset.z * along[2];
    let c = offset.norm_squared() - mechanism.rod.powi(2);
    check.near("sum of the slides, mm", s[0] + s[1], -2.0 * p, 1e-12);
    check.near("product, mm2", s[0] * s[1], c, 1e-10);

    let short = SpatialSlider {
        rod: 20.0,
        ..mechanism
    }
    .assemble();
    if let Err(error) = &short {
        println!("       rod of 20 mm: {error}");
    }
    check.holds("a rod of 20 mm is refused", short.is_err());
    Ok(())
}

/// A line in the plane of the crank.
fn plane(check: &mut Check) -> Result<(), Box<dyn Error>> {
    println!("The slider-crank of the plane, offset 12 mm:");
    let flat = SpatialSlider {
        bearing: 0.0,
        rise: 0.0,
        ..SpatialSlider::default()
    };
    let flat = SpatialSlider {
        foot: [0.0, 12.0, 0.0].into(),
        ..flat
    }
    .assemble()?;
    let rows = (0..360).map(|i| {
        let phi = f64::from(i).to_radians();
        let (sin, cos) = phi.sin_cos();
        let drop = 35.0 * sin - 12.0;
        let reach = (150.0 * 150.0 - drop * drop).sqrt();
        let known = [35.0 * cos + reach, -35.0 * sin - drop * 35.0 * cos / reach];
        (flat.stroke(phi), known)
    });
    let rows: Vec<(Stroke, [f64; 2])> = rows.collect();
    check.all_near(
        "slide, mm",
        rows.iter().map(|(m, known)| (m.s, known[0])),
        1e-12,
    );
    check.all_near(
        "ds/dphi, mm",
        rows.iter().map(|(m, known)| (m.v, known[1])),
        1e-12,
    );
    Ok(())
}

/// A foot that moves along the line takes the origin of the slide with it.
fn accuracy(check: &mut Check, linkage: &SpatialSliderAssembly) {
    println!("Sensitivity of the slide at 60 degrees:");
    let found = linkage.accuracy(60_f64.to_radians());
    let (sin, cos) = 25_f64.to_radians().sin_cos();
    let (s35, c35) = 35_f64.to_radians().sin_cos();
    let place = SpatialSlider::INDEX_FOOT_X;
    let shift =
        cos * c35 * found.e[place] + cos * s35 * found.e[place + 1] + sin * found.e[place + 2];
    check.near("ds / d(foot along the line)", shift, -1.0, 1e-13);
}

/// Where `f` changes its sign between `lo` and `hi`.
fn bisect(mut lo: f64, mut hi: f64, f: impl Fn(f64) -> f64) -> f64 {
    let rising = f(hi) > f(lo);
    for _ in 0..60 {
        let middle = 0.5 * (lo + hi);
        if (f(middle) > 0.0) == rising {
            hi = middle;
        } else {
            lo = middle;
        }
    }
    0.5 * (lo + hi)
}
