//! A mechanism with known positions: the needle drive of a sewing machine, a platform on three
//! turning legs.

use crate::has;
use crate::laurent::{Complex, complex, unit};
use crate::triad::{Leg, Triad};

/// Angle of the crank and the three joints of the platform, to more digits than are compared.
const POSITIONS: [(f64, [Complex; 3]); 4] = [
    (
        0.0,
        [
            complex(176.915_674_857_736_25, 241.140_335_645_875_25),
            complex(110.076_626_044_925_54, 286.895_570_906_976_3),
            complex(6.250_791_418_016_14, 275.044_576_685_998),
        ],
    ),
    (
        1.658_062_789_394_613_2,
        [
            complex(182.143_367_910_316_2, 248.489_298_941_440_58),
            complex(113.263_966_509_111_37, 291.111_218_919_448_4),
            complex(10.095_665_481_966_05, 274.481_376_371_416_7),
        ],
    ),
    (
        3.490_658_503_988_659,
        [
            complex(138.347_983_125_316_53, 182.669_040_956_329_48),
            complex(93.288_360_427_092_83, 249.978_998_631_949_24),
            complex(-7.510_477_304_439_891, 277.544_272_292_338_25),
        ],
    ),
    (
        5.410_520_681_182_422,
        [
            complex(153.115_845_643_245_45, 205.871_783_171_508_06),
            complex(98.228_428_312_758_22, 265.439_991_292_861_9),
            complex(-5.612_935_117_045_515, 277.154_138_339_890_97),
        ],
    ),
];

const CRANK: f64 = 50.0;
const LEGS: [f64; 3] = [272.5, 104.5, 261.0];
const PIVOTS: [Complex; 2] = [complex(195.0, 226.0), complex(46.0, 533.0)];
/// Sides of the platform: 3 to 4, 3 to 5, 4 to 5.
const SIDES: [f64; 3] = [81.0, 174.0, 104.5];

fn needle_drive(crank: f64) -> Triad {
    let [a, b, c] = SIDES;
    let along = (a * a + b * b - c * c) / (2.0 * a);
    let across = (b * b - along * along).sqrt();
    Triad {
        legs: LEGS.map(|length| Leg::Turning { length }),
        pivots: [unit(crank).scaled(CRANK), PIVOTS[0], PIVOTS[1]],
        points: [complex(0.0, 0.0), complex(a, 0.0), complex(along, across)],
    }
}

#[test]
fn the_needle_drive_is_found_among_its_six_poses() {
    for (crank, joints) in POSITIONS {
        let drive = needle_drive(crank);
        let listing = drive.equations().solve().expect("six solutions");
        assert_eq!(
            (listing.paths, listing.complex, listing.multiple),
            (8, 6, 0)
        );
        let leg = (joints[0] - drive.pivots[0]).scaled(1.0 / LEGS[0]);
        let platform = (joints[1] - joints[0]).scaled(1.0 / SIDES[0]);
        assert!(has(&listing.real, &[leg, platform], 1e-12), "{listing:?}");
        assert_eq!(listing.real.len(), drive.count_poses(20_000));
    }
}

#[test]
fn six_poses_at_every_angle_of_the_crank() {
    const ANGLES: u32 = if cfg!(debug_assertions) { 12 } else { 720 };
    for index in 0..ANGLES {
        let crank = std::f64::consts::TAU * f64::from(index) / f64::from(ANGLES);
        let listing = needle_drive(crank).equations().solve();
        let listing = listing.unwrap_or_else(|e| panic!("{crank}: {e}"));
        assert_eq!((listing.complex, listing.multiple), (6, 0), "{crank}");
        assert!(!listing.real.is_empty(), "{crank}");
    }
}

#[test]
fn solutions_are_real_to_the_last_digit_and_in_order() {
    let listing = needle_drive(0.3).equations().solve().expect("solutions");
    let angles: Vec<f64> = listing
        .real
        .iter()
        .map(|solution| solution[0][1].atan2(solution[0][0]))
        .collect();
    assert!(angles.is_sorted(), "{angles:?}");
    for [re, im] in listing.real.into_iter().flatten() {
        assert!((re * re + im * im - 1.0).abs() < 1e-15);
    }
}

#[test]
fn the_same_system_gives_the_same_bits() {
    let equations = needle_drive(1.0).equations();
    let listings = [equations.solve(), equations.solve()];
    assert_eq!(listings[0], listings[1]);
    let bits = |listing: &Result<linkage_core::numeric::roots::Listing, _>| -> Vec<u64> {
        let real = listing.as_ref().expect("solutions").real.iter();
        real.flatten()
            .flatten()
            .map(|part| part.to_bits())
            .collect()
    };
    assert_eq!(bits(&listings[0]), bits(&listings[1]));
}
