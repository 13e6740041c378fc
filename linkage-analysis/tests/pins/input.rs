//! Wrong numbers, and the load from reactions.

use linkage_analysis::pins::{Fit, Limit, Member, Mounting, Pin, PinError, Width, largest_load};
use linkage_runtime::{Vector2, Vector3};

use super::{clevis, pin, strong};

fn good() -> Pin {
    let members = [10.0, 5.0].map(|width| strong(Width::Fixed(width)));
    pin(100.0, clevis(Fit::Loose, members[0], members[1]))
}

fn overhung(hub: Member, seat: Member, gap: f64) -> Pin {
    pin(100.0, Mounting::Overhung { hub, seat, gap })
}

fn message(pin: &Pin) -> String {
    pin.diameter().expect_err("it is invalid").to_string()
}

#[test]
fn every_number_must_make_sense() {
    type Change = fn(&mut Pin, f64);
    fn members(pin: &mut Pin) -> [&mut Member; 2] {
        match &mut pin.mounting {
            Mounting::Clevis { rod, fork, .. } => [rod, fork],
            Mounting::Overhung { hub, seat, .. } => [hub, seat],
        }
    }
    let member = strong(Width::Fixed(5.0));
    let hub = overhung(member, member, 1.0);
    let cases: [(Pin, Change, &str); 13] = [
        (good(), |p, x| p.load = x, "the load"),
        (
            good(),
            |p, x| p.bending.strength = x,
            "the strength in bending",
        ),
        (
            good(),
            |p, x| p.bending.safety = x,
            "the safety factor in bending",
        ),
        (
            good(),
            |p, x| p.shear = Limit::allowable(x),
            "the strength in shear",
        ),
        (
            good(),
            |p, x| p.shear.safety = x,
            "the safety factor in shear",
        ),
        (
            good(),
            |p, x| members(p)[0].width = Width::Fixed(x),
            "the width of the rod",
        ),
        (
            good(),
            |p, x| members(p)[0].width = Width::Ratio(x),
            "the ratio of the rod's width to the diameter",
        ),
        (
            good(),
            |p, x| members(p)[0].pressure.strength = x,
            "the strength of the rod under pressure",
        ),
        (
            good(),
            |p, x| members(p)[1].pressure.safety = x,
            "the safety factor of the fork's pressure",
        ),
        (
            good(),
            |p, x| members(p)[1].width = Width::Fixed(x),
            "the width of the fork's cheek",
        ),
        (
            hub,
            |p, x| members(p)[0].width = Width::Fixed(x),
            "the width of the hub",
        ),
        (
            hub,
            |p, x| members(p)[1].width = Width::Fixed(x),
            "the length of the seat",
        ),
        (
            hub,
            |p, x| members(p)[1].pressure.strength = x,
            "the strength of the seat under pressure",
        ),
    ];
    for (pin, change, what) in cases {
        for value in [0.0, -1.0, f64::NAN, f64::INFINITY] {
            let mut wrong = pin;
            change(&mut wrong, value);
            let expected = format!("{what} is {value}: it must be positive and finite");
            assert_eq!(message(&wrong), expected);
            assert_eq!(
                wrong.check(5.0).expect_err("it is invalid").to_string(),
                expected
            );
        }
        let mut right = pin;
        change(&mut right, 2.0);
        assert!(right.diameter().is_ok(), "{what}");
    }
}

#[test]
fn the_gap_may_be_zero_and_not_less() {
    let member = strong(Width::Fixed(5.0));
    assert!(overhung(member, member, 0.0).diameter().is_ok());
    for gap in [-0.1, f64::NAN, f64::INFINITY] {
        assert_eq!(
            message(&overhung(member, member, gap)),
            format!("the gap between seat and hub is {gap}: it must be finite and not negative")
        );
    }
}

#[test]
fn a_diameter_to_check_must_be_positive() {
    for diameter in [0.0, -3.0, f64::NAN, f64::INFINITY] {
        let error = good().check(diameter).expect_err("it is invalid");
        assert_eq!(
            error.to_string(),
            format!("the diameter is {diameter}: it must be positive and finite")
        );
    }
}

#[test]
fn a_seat_may_be_too_short_for_any_diameter() {
    let seat = Member {
        width: Width::Fixed(4.0),
        pressure: Limit::new(75.0, 2.0),
    };
    let pin = overhung(strong(Width::Ratio(2.0)), seat, 1.0);
    assert_eq!(
        message(&pin),
        "no diameter is large enough: the pressure in the seat stays above 37.5, and 37.5 is allowable: \
         make the seat longer, or its length a ratio as the hub's width is"
    );
    let seat = Member {
        width: Width::Fixed(4.1),
        ..seat
    };
    assert!(
        overhung(strong(Width::Ratio(2.0)), seat, 1.0)
            .diameter()
            .is_ok()
    );
}

#[test]
fn numbers_beyond_those_of_the_machine() {
    let mut pin = good();
    pin.load = 1e300;
    pin.bending = Limit::allowable(1e-300);
    assert_eq!(
        message(&pin),
        "bending: the numbers are too large or too small to compute with"
    );
    assert!(matches!(
        good().check(1e-200),
        Err(PinError::OutOfRange { .. })
    ));
}

#[test]
fn the_load_is_the_largest_reaction() {
    let plane = [
        Vector2::new(1.0, 1.0),
        Vector2::new(-5.0, 12.0),
        Vector2::new(0.0, 13.0),
    ];
    let largest = largest_load(plane).expect("there are reactions");
    assert_eq!((largest.load, largest.position), (13.0, 1));
    let space = [Vector3::new(2.0, -3.0, 6.0)];
    assert_eq!(largest_load(space).expect("there is one").load, 7.0);
    let normal = largest_load([3.0, -4.0, 2.0]).expect("there are reactions");
    assert_eq!((normal.load, normal.position), (4.0, 1));
    // Squares of these overflow or vanish.
    for size in [1e-200, 1e200] {
        let load = largest_load([[3.0 * size, 4.0 * size]])
            .expect("it is finite")
            .load;
        assert!((load / size - 5.0).abs() < 1e-14);
    }
}

#[test]
fn reactions_must_be_there_and_finite() {
    let nothing = largest_load::<[f64; 2], 2>([]).expect_err("there are none");
    assert_eq!(
        nothing.to_string(),
        "there are no reactions to take the largest of"
    );
    for bad in [f64::NAN, f64::INFINITY] {
        let error = largest_load([[1.0, 0.0], [0.0, bad]]).expect_err("it is not finite");
        assert_eq!(error, PinError::NotFinite { position: 1 });
        assert_eq!(
            error.to_string(),
            "position 1: the reaction is not finite: the mechanism cannot be assembled there or \
             stands at a dead point"
        );
    }
}
