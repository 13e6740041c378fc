//! Exactly parallel guides have no solution, however multiply-adds are rounded.

use linkage::mechanism;

mechanism! {
    /// A point on two guides, one of which turns.
    pub struct Guides {
        unit mm;
        param beta = 100deg;
        param target = (70mm, 30mm);
        input phi = 10deg in 0deg..90deg;
        unknown s = 75mm;
        unknown t = 17mm;
        loop polar(s, phi) + polar(t, beta) = target;
    }
    impl Guides {
        pub fn slides(phi) -> Slides { s, t, slope: d(s, phi) }
    }
}

/// Sines that are compared are the same ones everywhere.
#[test]
fn rows_of_guides_are_single_calls_to_the_last_bit() {
    let linkage = Guides::default().assemble().expect("closes");
    let angles: Vec<f64> = (0..1000).map(|i| 0.0017 * f64::from(i)).collect();
    let rows = linkage.slides_sweep(&angles);
    let bits = |slides: Slides| [slides.s, slides.t, slides.slope].map(f64::to_bits);
    for (row, phi) in angles.into_iter().enumerate() {
        assert_eq!(bits(rows.get(row)), bits(linkage.slides(phi)), "{phi}");
    }
}

#[test]
fn parallel_guides_have_no_position() {
    let angles: Vec<f64> = (1..400).map(|i| 0.004 * f64::from(i)).collect();
    for &beta in &angles {
        let nominal = Guides::default();
        let linkage = nominal.assemble().expect("closes");
        let parallel = Guides { beta, ..nominal };
        let single = match parallel.assemble() {
            Ok(linkage) => linkage.slides(beta),
            Err(error) => panic!("{error}"),
        };
        let row = linkage.slides_sweep_sets(&[parallel], &[beta]).get(0);
        for slides in [single, row] {
            assert!(
                !slides.s.is_finite() && !slides.t.is_finite() && !slides.slope.is_finite(),
                "{beta}: {slides:?}"
            );
        }
    }
}
