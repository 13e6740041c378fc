//! One counterweight in place of several masses.

use linkage_analysis::balancing::{BalanceError, Counterweight, StaticMoment};

use super::near;

#[test]
fn by_radius_and_by_mass() {
    for (m_x, m_y) in [(0.3, 0.4), (-0.3, 0.4), (0.0, -1e-9), (2e6, 5e5)] {
        let moment = StaticMoment::of_masses([m_x, m_y], 80.0);
        near(moment.angle(), f64::atan2(m_y, m_x), 1e-15);
        let size = 80.0 * f64::hypot(m_x, m_y);
        near(moment.size(), size, 1e-15 * size);
        let by_radius = moment.at_radius(50.0).expect("it is valid");
        let by_mass = moment.of_mass(by_radius.mass).expect("it is valid");
        near(by_radius.radius(), 50.0, 1e-13);
        near(by_mass.radius(), 50.0, 1e-13);
        near(by_mass.angle(), moment.angle(), 1e-15);
        near(by_mass.static_moment().x, moment.x, 1e-14 * size);
        near(by_radius.static_moment().y, moment.y, 1e-14 * size);
    }
}

/// No static moment: a mass at the origin does it, and none at a radius does.
#[test]
fn without_static_moment() {
    let none = StaticMoment::of_masses([0.0, 0.0], 80.0);
    assert_eq!(none.of_mass(2.0).expect("it is valid").radius(), 0.0);
    let error = none.at_radius(50.0).expect_err("it has no direction");
    assert_eq!(
        error.to_string(),
        "the static moment is 0: it must be positive and finite"
    );
}

#[test]
fn of_three_masses() {
    let weight = Counterweight::of_masses([0.5, 0.3, -0.4], 100.0).expect("it is valid");
    near(weight.mass, 0.4, 1e-15);
    near(weight.x, 75.0, 1e-12);
    near(weight.y, -100.0, 1e-12);
    near(weight.radius(), 125.0, 1e-12);
    // Material to be taken away, from the other side.
    let hole = Counterweight::of_masses([-1.0, 0.3, 0.0], 70.0).expect("it is valid");
    near(hole.mass, -0.7, 1e-15);
    near(hole.x, -30.0, 1e-12);
    let at_origin = Counterweight::of_masses([0.5, 0.0, 0.0], 70.0).expect("it is valid");
    assert_eq!((at_origin.mass, at_origin.radius()), (0.5, 0.0));
}

#[test]
fn numbers_that_make_no_counterweight() {
    let moment = StaticMoment::of_masses([0.1, 0.2], 10.0);
    for bad in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let messages = [
            (moment.at_radius(bad), "the radius of the counterweight"),
            (moment.of_mass(bad), "the mass of the counterweight"),
            (
                Counterweight::of_masses([1.0, 0.0, 0.0], bad),
                "the radius of the masses",
            ),
        ];
        for (made, what) in messages {
            let error = made.expect_err("it is invalid");
            assert_eq!(
                error.to_string(),
                format!("{what} is {bad}: it must be positive and finite")
            );
        }
    }
    let balanced = Counterweight::of_masses([-0.5, 0.5, 0.0], 10.0);
    assert_eq!(
        balanced,
        Err(BalanceError::Counterweight {
            what: "the sum of the masses",
            value: 0.0,
            expected: "finite and not 0"
        })
    );
    let lost = StaticMoment::of_masses([f64::NAN, 0.0], 10.0);
    assert!(lost.at_radius(1.0).is_err() && lost.of_mass(1.0).is_err());
    assert!(Counterweight::of_masses([f64::NAN, 0.0, 1.0], 10.0).is_err());
}
