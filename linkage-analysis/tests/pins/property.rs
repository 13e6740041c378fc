//! Diameter and stress are the inverse of each other, for any numbers and in any units.

use linkage_analysis::pins::{Fit, Limit, Member, Mounting, Pin, PinError, Width};

use linkage_random::Random;

/// A positive number of any size from `10^-decades` to `10^decades`.
fn any(random: &mut Random, decades: f64) -> f64 {
    10_f64.powf(random.between(-decades, decades))
}

fn limit(random: &mut Random, decades: f64) -> Limit {
    Limit::new(any(random, decades), random.between(1.0, 6.0))
}

fn member(random: &mut Random, decades: f64) -> Member {
    let size = any(random, decades);
    let width = if random.between(0.0, 1.0) < 0.5 {
        Width::Fixed(size)
    } else {
        Width::Ratio(size)
    };
    let pressure = limit(random, decades);
    Member { width, pressure }
}

fn random_pin(random: &mut Random, decades: f64) -> Pin {
    let [first, second] = [0, 1].map(|_| member(random, decades));
    let clevis = |fit| Mounting::Clevis {
        fit,
        rod: first,
        fork: second,
    };
    let overhung = |gap| Mounting::Overhung {
        hub: first,
        seat: second,
        gap,
    };
    let mounting = match random.between(0.0, 5.0) as usize {
        0 => clevis(Fit::Loose),
        1 => clevis(Fit::PressedInFork),
        2 => clevis(Fit::PressedInRod),
        3 => overhung(0.0),
        _ => overhung(any(random, decades)),
    };
    Pin {
        load: any(random, decades),
        mounting,
        bending: limit(random, decades),
        shear: limit(random, decades),
    }
}

/// At the diameter that a check requires, its stress is the allowable one; the largest diameter holds all checks, and a
/// smaller one does not.
#[test]
fn stresses_at_the_diameter_are_the_allowable_ones() {
    let mut random = Random::new(1);
    let mut solved = 0;
    for decades in [0.5, 2.0, 6.0, 20.0] {
        for _ in 0..2000 {
            let pin = random_pin(&mut random, decades);
            let size = match pin.diameter() {
                Ok(size) => size,
                Err(PinError::SeatTooShort { least, allowable }) => {
                    seat_is_too_short(&pin, least, allowable);
                    continue;
                }
                Err(error) => panic!("{pin:?}: {error}"),
            };
            solved += 1;
            let at = |diameter| pin.check(diameter).expect("it is valid");
            let met = [
                at(size.bending).bending,
                at(size.shear).shear,
                at(size.bearing[0]).bearing[0],
                at(size.bearing[1]).bearing[1],
            ];
            for stress in met {
                assert!(
                    (stress.utilization() - 1.0).abs() < 1e-12,
                    "{pin:?} {size:?}"
                );
            }
            assert!(at(size.diameter).holds(), "{pin:?} {size:?}");
            assert!(!at(0.999_999 * size.diameter).holds(), "{pin:?} {size:?}");
            assert!(at(1.000_001 * size.diameter).holds(), "{pin:?} {size:?}");
        }
    }
    assert!(solved > 6000, "{solved}");
}

fn seat_is_too_short(pin: &Pin, least: f64, allowable: f64) {
    assert!(least >= allowable);
    for diameter in [1e-3, 1.0, 1e3, 1e6] {
        let stress = pin.check(diameter).expect("it is valid").bearing[1];
        assert!(stress.value >= least * (1.0 - 1e-12), "{pin:?}");
    }
}

/// The same pin in metres and kilonewtons.
#[test]
fn units_only_need_to_fit_each_other() {
    let mut random = Random::new(2);
    for _ in 0..500 {
        let pin = random_pin(&mut random, 1.0);
        let (length, force) = (1e-3, 1e-3);
        let stress = force / (length * length);
        let limit = |limit: Limit| Limit::new(stress * limit.strength, limit.safety);
        let member = |member: Member| Member {
            width: match member.width {
                Width::Fixed(width) => Width::Fixed(length * width),
                ratio => ratio,
            },
            pressure: limit(member.pressure),
        };
        let other = Pin {
            load: force * pin.load,
            mounting: match pin.mounting {
                Mounting::Clevis { fit, rod, fork } => Mounting::Clevis {
                    fit,
                    rod: member(rod),
                    fork: member(fork),
                },
                Mounting::Overhung { hub, seat, gap } => Mounting::Overhung {
                    hub: member(hub),
                    seat: member(seat),
                    gap: length * gap,
                },
            },
            bending: limit(pin.bending),
            shear: limit(pin.shear),
        };
        match (pin.diameter(), other.diameter()) {
            (Ok(size), Ok(other)) => {
                let ratio = other.diameter / (length * size.diameter);
                assert!((ratio - 1.0).abs() < 1e-9, "{pin:?}");
                assert_eq!(size.governing, other.governing);
            }
            (Err(PinError::SeatTooShort { .. }), Err(PinError::SeatTooShort { .. })) => {}
            (one, other) => panic!("{pin:?}: {one:?} and {other:?}"),
        }
    }
}
