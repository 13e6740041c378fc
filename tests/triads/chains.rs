//! Coupled groups behind each other, and behind angles that count their turns.

use super::circuits::{BESIDE, alone, covers, turning};
use linkage::{BranchEnd, Circuits};
use linkage_interpreted::interpreted;
use linkage_random::Random;
use std::f64::consts::TAU;

interpreted! {
    /// A platform hangs on another.
    struct Two {
        unit mm;
        param reach = 50mm;
        input phi = 60deg in 58deg..62deg;
        unknown tilt = 20deg;
        unknown leg_a = 20deg;
        unknown leg_b = 100deg;
        unknown leg_c = 290deg;
        unknown second = 20deg;
        unknown second_a = 20deg;
        unknown second_b = 100deg;
        unknown second_c = 290deg;
        let a = polar(40mm, phi) + polar(50mm, leg_a);
        loop a + polar(60mm, tilt) = (120mm, 0) + polar(50mm, leg_b);
        loop a + polar(60mm, tilt + 60deg) = (60mm, 110mm) + polar(50mm, leg_c);
        let b = a + polar(reach, second_a);
        loop b + polar(60mm, second) = (167mm, 17mm) + polar(reach, second_b);
        loop b + polar(60mm, second + 60deg) = (107mm, 127mm) + polar(reach, second_c);
    }
    impl Two {
        fn places(phi) -> Places { a, b }
    }
}

#[test]
fn an_assembly_of_the_first_group_alone_hides_no_other() {
    // With short legs, the second platform reaches the first in one of its assemblies only.
    for reach in [37.5, 38.0, 50.0] {
        let two = Two { reach };
        let chosen = two.assemble().expect("it closes").places(1.05);
        let all = two.assemblies().expect("they can be listed");
        let near = |one: &TwoAssembly| (one.places(1.05).b - chosen.b).norm() < 1e-9;
        assert!(all.iter().any(near), "{reach}: {} assemblies", all.len());
    }
}

interpreted! {
    /// A triad driven by half of an angle that turns fully.
    struct Geared {
        unit mm;
        param crank = 4mm;
        input phi = 60deg in 0deg..720deg;
        unknown theta = 20deg;
        unknown psi = 60deg;
        unknown tilt = 20deg;
        unknown leg_a = 20deg;
        unknown leg_b = 100deg;
        unknown leg_c = 290deg;
        loop polar(60mm, phi) + polar(50mm, theta) = (20mm, 0) + polar(55mm, psi);
        let a = (35mm, 35mm) + polar(crank, psi / 2) + polar(50mm, leg_a);
        loop a + polar(60mm, tilt) = (120mm, 0) + polar(50mm, leg_b);
        loop a + polar(60mm, tilt + 60deg) = (60mm, 110mm) + polar(50mm, leg_c);
    }
    impl Geared {
        fn motion(phi) -> Motion { psi, tilt, v: velocity(tilt) }
    }
}

#[test]
fn turns_of_an_angle_are_counted_before_a_group_that_needs_them() {
    let linkage = Geared::default().assemble().expect("it closes");
    let step = 1e-3;
    for row in 1..2000 {
        let phi = 2.0 * TAU * f64::from(row) / 2001.0;
        let [before, here, after] = [phi - step, phi, phi + step].map(|x| linkage.motion(x));
        let slope = (after.tilt - before.tilt) / (2.0 * step);
        assert!(
            (slope - here.v).abs() < 1e-5,
            "{phi}: {slope}, not {}",
            here.v
        );
    }
    let turns = linkage.motion(2.0 * TAU).psi - linkage.motion(0.0).psi;
    assert!((turns - 2.0 * TAU).abs() < 1e-12);
}

// Coupled groups between groups that turn back themselves.

/// Mechanisms of a dyad, a triad and another dyad.
const CHAINS: usize = 20;

/// Inputs at which the assemblies of a chain are counted.
const LISTED: usize = 6;

/// Where on its way from end to end an assembly is looked at.
const SHARES: [f64; 5] = [0.02, 0.2, 0.5, 0.8, 0.98];

interpreted! {
    /// A four-bar whose crank may be too long to turn, a platform on its rocker, and a dyad on the platform.
    struct Chain {
        unit mm;
        param crank = 20mm;
        param rocker = 60mm;
        param leg = 50mm;
        param rod = 70mm;
        input phi = 60deg;
        unknown theta = 80deg;
        unknown psi = 130deg;
        unknown tilt = 20deg;
        unknown leg_a = 20deg;
        unknown leg_b = 100deg;
        unknown leg_c = 290deg;
        unknown lean = 100deg;
        unknown slide = 80mm;
        loop (-60mm, -30mm) + polar(crank, phi) + polar(60mm, theta) = polar(rocker, psi);
        let a = polar(40mm, psi) + polar(leg, leg_a);
        loop a + polar(60mm, tilt) = (120mm, 0) + polar(leg, leg_b);
        loop a + polar(60mm, tilt + 60deg) = (60mm, 110mm) + polar(leg, leg_c);
        loop a + polar(rod, lean) = (0, slide);
    }
    impl Chain {
        fn places(phi) -> LinkPlaces { a, slide }
    }
}

/// A chain whose platform has solutions that are farthest from singular beside a turning point of the four-bar, where nothing can be
/// prepared from.
const STEEP: Chain = Chain {
    crank: 70.85757685172423,
    rocker: 74.96030584329164,
    leg: 56.177762131241714,
    rod: 73.02487326524478,
};

/// A chain with assemblies that end after 0.0003 degrees, and an input there, in degrees.
const SHORT: (Chain, f64) = (
    Chain {
        crank: 65.02299848476191,
        rocker: 50.13139601926462,
        leg: 41.871892788541935,
        rod: 54.395321837427154,
    },
    34.9456,
);

type Found = Circuits<ChainAssembly>;

/// How many assemblies a chain has at an input: from its circuits, and listed.
fn counts(chain: &Chain, circuits: &Found, phi: f64) -> [usize; 2] {
    let branches = circuits.branches.iter();
    let here = branches.filter(|branch| covers(branch, phi));
    let listed = chain.assemblies_at(phi).map_or(0, |all| all.len());
    [here.count(), listed]
}

/// How many places on the way of assemblies from end to end are not known.
fn unserved(circuits: &Found) -> usize {
    let branches = circuits.branches.iter();
    let unknown = branches.flat_map(|branch| {
        let [low, high] = branch.ends.map(BranchEnd::x);
        let places = SHARES.map(|share| branch.assembly.places(low + share * (high - low)));
        places
            .into_iter()
            .filter(|places| !places.slide.is_finite())
    });
    unknown.count()
}

/// Counts the assemblies of a chain at some inputs that are not beside an end.
fn assert_counted(chain: &Chain, circuits: &Found, random: &mut Random) {
    for _ in 0..LISTED {
        let [low, high] = [circuits.cycle.low, circuits.cycle.high];
        let phi = random.between(low, high);
        let ends = circuits.branches.iter().flat_map(|branch| branch.ends);
        if ends.map(BranchEnd::x).all(|x| (x - phi).abs() >= BESIDE) {
            let [here, listed] = counts(chain, circuits, phi);
            assert_eq!(here, listed, "{chain:?} at {phi}\n{circuits}");
        }
    }
}

#[test]
fn solutions_that_are_farthest_from_singular_beside_an_end_are_kept() {
    let circuits = STEEP.circuits().expect("it can be listed");
    assert_eq!(alone(&turning(&circuits)), 0, "{circuits}");
    assert_eq!(unserved(&circuits), 0, "{circuits}");
    assert_counted(&STEEP, &circuits, &mut Random::new(18));
}

#[test]
fn assemblies_between_ends_that_are_close_together_are_known() {
    let (chain, at) = SHORT;
    let circuits = chain.circuits().expect("it can be listed");
    let [here, listed] = counts(&chain, &circuits, at.to_radians());
    assert!(listed > 0);
    assert_eq!(here, listed, "{circuits}");
    assert_eq!(unserved(&circuits), 0, "{circuits}");
}

#[test]
fn groups_before_and_behind_turn_back_with_it() {
    let mut random = Random::new(17);
    let mut places = Random::new(19);
    let (mut ends, mut lonely) = (0, 0);
    for _ in 0..CHAINS * crate::effort() {
        let Chain {
            crank,
            rocker,
            leg,
            rod,
        } = Chain::default();
        let [rocker, leg, rod] = random.near([rocker, leg, rod], 0.3);
        let crank = crank * random.ratio(0.7, 4.0);
        let chain = Chain {
            crank,
            rocker,
            leg,
            rod,
        };
        let circuits = chain.circuits().expect("it can be listed");
        let turning = turning(&circuits);
        let alone = alone(&turning);
        if alone > 0 {
            println!("{chain:?}\n{circuits}");
        }
        assert_eq!(unserved(&circuits), 0, "{chain:?}\n{circuits}");
        assert_counted(&chain, &circuits, &mut places);
        ends += turning.len();
        lonely += alone;
    }
    println!("{lonely} of {ends} ends");
    assert!(ends > CHAINS);
    assert_eq!(lonely, 0);
}
