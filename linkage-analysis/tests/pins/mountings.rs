//! What each mounting gives.

use std::f64::consts::PI;

use linkage_analysis::pins::{
    BearingPart, Criterion, Fit, Limit, Member, Mounting, STANDARD_DIAMETERS, Width,
    standard_diameter,
};

use super::{clevis, near, pin, strong};

/// Textbooks give `d = k sqrt(F / stress)` for widths in proportion to the diameter, `k` to two digits: rod and cheek of 1.0
/// and 0.5 diameters at rest, both of 1.6 and 0.6 where they slide.
#[test]
fn bending_has_the_textbook_factors() {
    let factors = [
        (Fit::Loose, 1.6, 1.9),
        (Fit::PressedInFork, 1.1, 1.4),
        (Fit::PressedInRod, 1.1, 1.2),
    ];
    for (fit, at_rest, sliding) in factors {
        for (rod, fork, factor) in [(1.0, 0.5, at_rest), (1.6, 0.6, sliding)] {
            let mounting = clevis(fit, strong(Width::Ratio(rod)), strong(Width::Ratio(fork)));
            let size = pin(14_500.0, mounting).diameter().expect("it is valid");
            let found = size.bending / (14_500.0_f64 / 90.0).sqrt();
            near(found, factor, 0.05);
        }
    }
}

/// The bending moment in the middle from loads spread evenly over many slices of half a beam.
#[test]
fn a_loose_pin_bends_as_a_beam() {
    let (load, rod, fork, d) = (800.0, 14.0, 9.0, 11.0);
    let slices = 1000;
    let places = |from: f64, width: f64| {
        (0..slices).map(move |i| from + width * (f64::from(i) + 0.5) / f64::from(slices))
    };
    let each = load / 2.0 / f64::from(slices);
    let held: f64 = places(rod / 2.0, fork).map(|x| each * x).sum();
    let pulled: f64 = places(0.0, rod / 2.0).map(|x| each * x).sum();
    let mounting = clevis(
        Fit::Loose,
        strong(Width::Fixed(rod)),
        strong(Width::Fixed(fork)),
    );
    let check = pin(load, mounting).check(d).expect("it is valid");
    let section = PI * d * d * d / 32.0;
    near(check.bending.value, (held - pulled) / section, 1e-9);
}

/// The pressure in a seat is linear; it holds the force and its moment about the seat's mouth.
#[test]
fn the_seat_holds_force_and_moment() {
    let (load, hub, seat, gap, d) = (350.0, 12.0, 15.0, 3.0, 8.0);
    let mounting = Mounting::Overhung {
        hub: strong(Width::Fixed(hub)),
        seat: strong(Width::Fixed(seat)),
        gap,
    };
    let check = pin(load, mounting).check(d).expect("it is valid");
    let mouth = check.bearing[1].value;
    let end = 2.0 * load / (d * seat) - mouth;
    let slices = 10_000;
    let moment: f64 = (0..slices)
        .map(|i| {
            let x = (f64::from(i) + 0.5) / f64::from(slices);
            let pressure = mouth + (end - mouth) * x;
            pressure * d * (x * seat) * (seat / f64::from(slices))
        })
        .sum();
    let arm = gap + hub / 2.0;
    near(moment, -load * arm, 1e-5 * load * arm);
    near(
        check.bending.value,
        32.0 * load * arm / (PI * d.powi(3)),
        1e-10,
    );
    near(
        check.shear.value,
        4.0 / 3.0 * load / (PI * d * d / 4.0),
        1e-12,
    );
    near(check.bearing[0].value, load / (d * hub), 1e-12);
}

#[test]
fn pressures_and_shear_of_a_clevis() {
    let mounting = clevis(
        Fit::PressedInRod,
        strong(Width::Fixed(10.0)),
        strong(Width::Ratio(0.5)),
    );
    let check = pin(600.0, mounting).check(6.0).expect("it is valid");
    near(check.bearing[0].value, 10.0, 1e-13);
    near(check.bearing[1].value, 600.0 / (2.0 * 6.0 * 3.0), 1e-13);
    near(check.shear.value, 600.0 * 8.0 / (3.0 * PI * 36.0), 1e-12);
    near(
        check.bending.value,
        32.0 * 600.0 * 3.0 / 4.0 / (PI * 216.0),
        1e-12,
    );
}

/// One limit after the other is made so low that it governs.
#[test]
fn every_rule_can_govern() {
    let weak = |mut mounting: Mounting, which: usize| {
        match &mut mounting {
            Mounting::Clevis { rod, fork, .. } => {
                [rod, fork][which].pressure = Limit::new(10.0, 4.0);
            }
            Mounting::Overhung { hub, seat, .. } => {
                [hub, seat][which].pressure = Limit::new(10.0, 4.0);
            }
        }
        mounting
    };
    let width = |length| strong(Width::Fixed(length));
    let fork = clevis(Fit::Loose, width(20.0), width(10.0));
    let overhung = Mounting::Overhung {
        hub: width(20.0),
        seat: width(30.0),
        gap: 1.0,
    };
    let parts = [
        (fork, [BearingPart::Rod, BearingPart::Fork]),
        (overhung, [BearingPart::Hub, BearingPart::Seat]),
    ];
    for (mounting, parts) in parts {
        let mut cases = vec![(pin(1000.0, mounting), Criterion::Bending)];
        let mut sheared = pin(1000.0, mounting);
        sheared.shear = Limit::new(1.0, 2.0);
        cases.push((sheared, Criterion::Shear));
        for (which, part) in parts.into_iter().enumerate() {
            cases.push((pin(1000.0, weak(mounting, which)), Criterion::Bearing(part)));
        }
        for (pin, criterion) in cases {
            let size = pin.diameter().expect("it is valid");
            assert_eq!(size.governing, criterion);
            let check = pin.check(size.diameter).expect("it is valid");
            assert_eq!(check.governing, criterion);
        }
    }
}

#[test]
fn a_safety_factor_divides_the_strength() {
    let mounting = clevis(
        Fit::Loose,
        strong(Width::Fixed(8.0)),
        strong(Width::Fixed(4.0)),
    );
    let mut safe = pin(500.0, mounting);
    safe.bending = Limit::new(360.0, 4.0);
    assert_eq!(safe.diameter(), pin(500.0, mounting).diameter());
    let stress = safe.check(10.0).expect("it is valid").bending;
    near(stress.safety, 360.0 / stress.value, 1e-12);
    near(stress.utilization(), 4.0 / stress.safety, 1e-12);
}

#[test]
fn the_next_diameter_that_can_be_bought() {
    for diameter in STANDARD_DIAMETERS {
        assert_eq!(standard_diameter(diameter), Some(diameter));
        assert!(standard_diameter(diameter.next_up()).is_none_or(|next| next > diameter));
    }
    assert_eq!(standard_diameter(1e-3), Some(3.0));
    for none in [100.1, 0.0, -5.0, f64::NAN, f64::INFINITY] {
        assert_eq!(standard_diameter(none), None);
    }
}

#[test]
fn the_line_of_a_size() {
    let member = |length, pressure| Member {
        width: Width::Fixed(length),
        pressure: Limit::allowable(pressure),
    };
    let size = pin(
        900.0,
        clevis(Fit::Loose, member(10.0, 9.0), member(5.0, 10.0)),
    )
    .diameter()
    .expect("it is valid");
    assert_eq!(
        size.to_string(),
        "10 by bearing pressure in the rod (bending 6.33841, shear 3.56825, bearing 10 and 9)"
    );
}
