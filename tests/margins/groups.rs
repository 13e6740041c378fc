//! Guides, closed contours, groups that could have been solved one after the other.

use crate::{expect_alike, spellings};

// Two bodies, joined by two links.
spellings! {
    [
        input phi = 30deg;
        unknown alpha = -47deg; unknown beta = -106deg; unknown gamma = 11deg; unknown delta = 98deg;
        let a = polar(11mm, phi);
        let base = (150mm, 27mm);
        let c1 = a + polar(84mm, alpha); let d1 = a + polar(70mm, alpha + 25deg);
        let c2 = base + polar(73mm, beta); let d2 = base + polar(86mm, beta - 85deg);
        let c = c1 + polar(64mm, gamma) - c2; let d = d1 + polar(64mm, delta) - d2;
    ]
    two_chains { loop c = (0, 0); loop d = (0, 0); }
    around_the_contour { loop c = (0, 0); loop c = d; }
    mixed { loop c + d = (0, 0); loop c = 2 * d; }
}

#[test]
fn a_contour() {
    for k in 0..12 {
        let phi = 0.5 * f64::from(k);
        expect_alike(&[
            ("two chains", two_chains(phi)),
            ("around the contour", around_the_contour(phi)),
            ("mixed", mixed(phi)),
        ]);
    }
}

// A link with three joints: on a crank by a link, on a guide, and on a guide of its own through a fixed point.
spellings! {
    [
        input phi = 30deg;
        unknown x2 = -121mm; unknown x3 = 153mm; unknown theta = 1deg;
        let p1 = polar(27mm, phi);
        let guide = (96mm, -1mm) + polar(x2, 170deg);
        let fixed = (28mm, 84mm);
    ]
    from_the_link {
        unknown x1 = -21deg;
        let e1 = p1 + polar(102mm, x1);
        loop e1 + polar(97mm, theta) = guide;
        loop e1 + polar(42mm, theta + 30deg) = fixed + polar(x3, theta - 35deg);
    }
    from_the_guide {
        unknown x1 = -21deg;
        let e1 = guide - polar(97mm, theta);
        loop p1 + polar(102mm, x1) = e1;
        loop e1 + polar(42mm, theta + 30deg) = fixed + polar(x3, theta - 35deg);
    }
    a_distance_and_centimetres {
        let e1 = guide - polar(97mm, theta);
        loop distance(e1, p1) = 102mm;
        loop 0.1 * (e1 + polar(42mm, theta + 30deg) - fixed - polar(x3, theta - 35deg)) = (0, 0);
    }
}

#[test]
fn guides() {
    for k in 0..12 {
        let phi = 0.5 * f64::from(k);
        expect_alike(&[
            ("from the link", from_the_link(phi)),
            ("from the guide", from_the_guide(phi)),
            ("a distance", a_distance_and_centimetres(phi)),
        ]);
    }
}

/// Two dyads, the second of which hangs on the first: the sines of their transmission angles and the margin of all assemblies.
macro_rules! dyads {
    ($name:ident { $($loops:tt)* }) => {
        fn $name(phi: f64) -> Vec<([f64; 2], f64)> {
            linkage_interpreted::interpreted! {
                struct Mechanism {
                    unit mm;
                    input phi = 60deg;
                    unknown theta = 30deg; unknown psi = 80deg; unknown alpha = 10deg; unknown beta = 95deg;
                    let first = polar(40mm, phi) + polar(140mm, theta) - (150mm, 0) - polar(90mm, psi);
                    let second = polar(70mm, psi + 40deg) + polar(150mm, alpha) - (130mm, 20mm) - polar(100mm, beta);
                    $($loops)*
                }
                impl Mechanism {
                    fn position(phi) -> Position { mu: theta - psi, nu: alpha - beta, margin: margin() }
                }
            }
            let found = Mechanism::default().assemblies_at(phi).expect("it is no dead point");
            let places = found.iter().map(|one| one.position(phi));
            places.map(|p| ([p.mu.sin().abs(), p.nu.sin().abs()], p.margin)).collect()
        }
    };
}

dyads! { one_after_the_other { loop first = (0, 0); loop second = (0, 0); } }
dyads! { together { loop first + second = (0, 0); loop first = second; } }

/// Mixed loops of two groups fall apart again: the margin is the least one of both, as for separate loops.
#[test]
fn dyads_in_mixed_loops() {
    for k in 0..12 {
        let phi = 0.5 * f64::from(k);
        let (separate, mixed) = (one_after_the_other(phi), together(phi));
        assert!(!mixed.is_empty());
        assert_eq!(separate.len(), mixed.len());
        for ([mu, nu], margin) in separate.into_iter().chain(mixed) {
            assert!((margin - mu.min(nu)).abs() < 1e-12, "{mu} {nu}: {margin}");
        }
    }
}

// A guide at a joint of a coupled group, which all of its legs lead to.
spellings! {
    [
        input phi = 30deg;
        unknown x1 = 86deg; unknown x2 = -177deg; unknown x3 = -24deg; unknown theta = -71deg;
        let e1 = polar(18mm, phi) + polar(79mm, x1);
        let e2 = (126mm, -13mm) + polar(69mm, x2);
        loop e1 + polar(110mm, theta) = e2;
        loop e1 + polar(107mm, theta + 75deg) = (30mm, 139mm) + polar(107mm, x3);
        unknown tau = -11deg; unknown s = 48mm;
        let slider = (-3mm, -77mm) + polar(s, tau) + polar(70mm, tau + 90deg);
    ]
    at_the_leg { loop slider = e2; }
    at_the_link { loop slider = e1 + polar(110mm, theta); }
    by_the_third_leg { loop slider + polar(107mm, theta + 75deg) - polar(110mm, theta) = (30mm, 139mm) + polar(107mm, x3); }
}

#[test]
fn a_guide_at_a_coupled_group() {
    for k in 0..12 {
        let phi = 0.5 * f64::from(k);
        expect_alike(&[
            ("at the leg", at_the_leg(phi)),
            ("at the link", at_the_link(phi)),
            ("by the third leg", by_the_third_leg(phi)),
        ]);
    }
}
