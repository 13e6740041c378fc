//! Where the assemblies of four-bars end, against the triangle of crank, frame and the two other links in line.

use linkage::{AssemblyError, BranchEnd};
use linkage_interpreted::interpreted;
use linkage_random::Random;
use std::f64::consts::{PI, TAU};

interpreted! {
    struct FourBar {
        param crank = 0.05m;
        param coupler = 0.12m;
        param rocker = 0.1m;
        param frame = 0.14m;
        input phi = 30deg in -180deg..180deg;
        unknown theta = 40deg;
        unknown psi = 80deg;
        loop polar(crank, phi) + polar(coupler, theta) = (frame, 0) + polar(rocker, psi);
    }
    impl FourBar {
        fn joint(phi) -> Joint { joint: polar(crank, phi) + polar(coupler, theta) }
    }
}

/// Four-bars.
const FOUR_BARS: usize = 500;

/// Ends agree to this part of the range.
const SHARE: f64 = 1e-9;

/// The crank's angle, from 0 to pi, at which its end is at a distance from the frame's other pivot. Differences of lengths are taken
/// first: a half angle is accurate where it is small, and so is its complement.
fn at_distance(crank: f64, frame: f64, side: f64) -> Option<f64> {
    let product = 4.0 * crank * frame;
    let sine = (side - (crank - frame).abs()) * (side + (crank - frame).abs()) / product;
    let cosine = ((crank + frame) - side) * (crank + frame + side) / product;
    (sine > 0.0 && cosine > 0.0).then(|| match sine < cosine {
        true => 2.0 * sine.sqrt().asin(),
        false => PI - 2.0 * cosine.sqrt().asin(),
    })
}

#[test]
fn ends_are_where_two_links_are_in_line() {
    let mut random = Random::new(1616);
    let (mut ends, mut worst) = (0, 0.0_f64);
    for number in 0..FOUR_BARS * crate::effort() {
        let [crank, frame, coupler] = [0; 3].map(|_| random.ratio(0.05, 0.2));
        let rocker = match number % 2 {
            0 => random.ratio(0.05, 0.2),
            // Almost at a change point, where two ends are close together.
            _ => {
                let near = random.ratio(1e-10, 1e-2) * crank.min(frame);
                let far = crank + frame - coupler;
                let shorter = (crank - frame).abs() + coupler;
                *random.pick(&[far - near, far + near, shorter - near, shorter + near])
            }
        };
        if rocker < 0.01 {
            continue;
        }
        let four_bar = FourBar {
            crank,
            coupler,
            rocker,
            frame,
        };
        let sides = [coupler + rocker, (coupler - rocker).abs()];
        let angles = sides
            .into_iter()
            .filter_map(|side| at_distance(crank, frame, side));
        let mut known: Vec<f64> = angles.flat_map(|angle| [-angle, angle]).collect();
        known.sort_by(f64::total_cmp);
        let circuits = four_bar.circuits().expect("a list, if an empty one");
        let found = circuits.branches.iter().flat_map(|branch| branch.ends);
        let found: Vec<f64> = found
            .filter(|end| matches!(end, BranchEnd::TurningPoint(_)))
            .map(BranchEnd::x)
            .collect();
        for &x in &found {
            let off = known
                .iter()
                .map(|end| (end - x).abs())
                .fold(f64::INFINITY, f64::min);
            worst = worst.max(off);
            assert!(
                off < SHARE * TAU,
                "{four_bar:?}: {x}, {off:e} from {known:?}"
            );
        }
        // Each ends two assemblies, unless two are so close that the discriminant between them is rounding.
        let apart = known.windows(2).all(|pair| pair[1] - pair[0] > 1e-5);
        assert!(
            !apart || found.len() == 2 * known.len(),
            "{four_bar:?}: {found:?}, not {known:?}"
        );
        ends += found.len();
    }
    println!("{ends} ends, worst {worst:.1e} rad");
    assert!(ends > FOUR_BARS);
}

#[test]
fn a_list_of_ends_takes_microseconds() {
    // In a build without optimisation some 30 times as long.
    let four_bar = FourBar {
        crank: 0.2,
        ..FourBar::default()
    };
    let runs = 200;
    let start = std::time::Instant::now();
    for _ in 0..runs {
        assert_eq!(four_bar.circuits().expect("two").branches.len(), 2);
    }
    let each = start.elapsed() / runs;
    println!("circuits() of a four-bar: {each:?}");
    let most = if cfg!(debug_assertions) { 10_000 } else { 200 };
    assert!(each.as_micros() < most, "{each:?}");
}

#[test]
fn a_way_ends_where_the_links_reach_each_other_no_more() {
    let first = FourBar::default();
    let assembly = first.assemble().expect("as written");
    let near = FourBar {
        coupler: 0.15,
        ..first
    };
    let [found, known] = [near.assemble_from(&assembly), near.assemble()].map(|assembly| {
        let assembly = assembly.expect("within reach");
        assembly.joint(1.0).joint
    });
    assert_eq!(found, known);

    // The coupler is as long as the rocker and the distance of their other ends.
    let (sine, cosine) = (PI / 6.0).sin_cos();
    let distance = (first.frame - first.crank * cosine).hypot(first.crank * sine);
    let longest = distance + first.rocker;
    let far = FourBar {
        coupler: 0.3,
        ..first
    };
    let Err(AssemblyError::Blocked { share, group, .. }) = far.assemble_from(&assembly) else {
        panic!("the way ends")
    };
    let known = (longest - first.coupler) / (far.coupler - first.coupler);
    assert!(
        group.index == 0 && (share - known).abs() < 1e-9,
        "{share}, not {known}"
    );
    let text = far
        .assemble_from(&assembly)
        .map(|_| ())
        .unwrap_err()
        .to_string();
    assert!(
        text.starts_with("FourBar: loop 1 (theta, psi; RRR) meets a dead point after 44.3767 %"),
        "{text}"
    );
}
