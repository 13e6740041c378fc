//! A double wishbone by the travel of the wheel and of the rack, its ball joints and its wheel as points: eleven unknowns remain. With the arms
//! as angles seven do.

use linkage_interpreted::interpreted;

use super::{close, number, numbers, read};

interpreted! {
    /// Ball joints `lower`, `upper` and `rod`, the wheel at `wheel`.
    pub struct DoubleWishbone {
        unit mm;
        input travel = 0mm in -80mm..80mm;
        input rack = 0mm in -40mm..40mm;
        const D_LOWER = (10mm, 715mm, 200mm);
        const D_UPPER = (-12mm, 680mm, 520mm);
        const D_ROD = (-135mm, 695mm, 258mm);
        const D_WHEEL = (0mm, 770mm, 320mm);
        const LF = (170mm, 380mm, 225mm);
        const LR = (-190mm, 400mm, 215mm);
        param upper_to_front = 249.59767627123454452mm;
        param upper_to_rear = 231.66570743206686351mm;
        param lower_to_front = 372.08869910278113686mm;
        param lower_to_rear = 373.43004699677681025mm;
        param tie = 273.33130080545111253mm;
        param uf = (95mm, 455mm, 505mm);
        param ur = (-125mm, 480mm, 490mm);
        param inner = (-125mm, 422mm, 267mm);
        unknown lower = (10mm, 715mm, 200mm);
        unknown upper = (-12mm, 680mm, 520mm);
        unknown rod = (-135mm, 695mm, 258mm);
        unknown wheel = (0mm, 770mm, 320mm);
        loop distance(lower, LF) = lower_to_front;
        loop distance(lower, LR) = lower_to_rear;
        loop distance(upper, uf) = upper_to_front;
        loop distance(upper, ur) = upper_to_rear;
        loop distance(lower, upper) = distance(D_LOWER, D_UPPER);
        loop distance(rod, lower) = distance(D_ROD, D_LOWER);
        loop distance(rod, upper) = distance(D_ROD, D_UPPER);
        loop distance(rod, inner + (0mm, rack, 0mm)) = tie;
        loop distance(wheel, lower) = distance(D_WHEEL, D_LOWER);
        loop distance(wheel, upper) = distance(D_WHEEL, D_UPPER);
        loop distance(wheel, rod) = distance(D_WHEEL, D_ROD);
        loop wheel.z = 320mm + travel;
    }

    impl DoubleWishbone {
        pub fn place(travel, rack) -> Place { wheel }
        pub fn rates(travel, rack) -> Rates { v: velocity(wheel), a: acceleration(wheel) }
        pub fn adjustment(travel, rack) -> Adjustment { x: sensitivity(wheel.x), y: sensitivity(wheel.y) }
    }
}

#[test]
fn the_wheel_is_where_it_was_computed_with_80_digits() {
    let suspension = DoubleWishbone::default().assemble().expect("it assembles");
    let references = read(include_str!("double_wishbone.json"));
    assert_eq!(references.len(), 85);
    let (mut nothing, mut adjusted) = (0, 0);
    for known in references {
        let [z, u] = [number(&known["z"]), number(&known["u"])];
        let found: [f64; 3] = suspension.place(z, u).wheel.into();
        if found[0].is_nan() {
            nothing += 1;
            continue;
        }
        for (found, known) in found.into_iter().zip(numbers::<3>(&known["p"])) {
            close(found, known, 770.0, 1e-13);
        }
        let rates = suspension.rates(z, u);
        for (k, name) in ["x", "y"].into_iter().enumerate() {
            close(rates.v[0][k], number(&known["d_dz"][name]), 1.0, 1e-11);
            close(rates.v[1][k], number(&known["d_du"][name]), 1.0, 1e-11);
            let second = ["d2_dz2", "d2_dzdu", "d2_du2"].map(|own| number(&known[own][name]));
            let found = [rates.a[0][0][k], rates.a[0][1][k], rates.a[1][1][k]];
            for (found, known) in found.into_iter().zip(second) {
                close(found, known, 1.0, 1e-11);
            }
        }
        // At all positions that the program `double_wishbone` leaves out.
        if known["sensitivity_x"].is_null() {
            continue;
        }
        adjusted += 1;
        let found = suspension.adjustment(z, u);
        for (found, name) in [(found.x, "sensitivity_x"), (found.y, "sensitivity_y")] {
            let pairs = found.into_iter().zip(numbers::<14>(&known[name]));
            pairs.for_each(|(found, known)| close(found, known, 1.0, 1e-11));
        }
    }
    assert_eq!((nothing, adjusted), (0, 60));
}

interpreted! {
    /// The arms turn about their axes; the wheel hangs on the three ball joints. Four unknowns remain, few enough for a listing, although many
    /// paths end far out, close to each other.
    pub struct TurningArms {
        unit mm;
        input travel = 0mm in -80mm..80mm;
        const D_LOWER = (10mm, 715mm, 200mm);
        const D_UPPER = (-12mm, 680mm, 520mm);
        const D_ROD = (-135mm, 695mm, 258mm);
        const INNER = (-125mm, 422mm, 267mm);
        unknown low = 0deg;
        unknown high = 0deg;
        unknown rod = (-135mm, 695mm, 258mm);
        let lower = (170mm, 380mm, 225mm) + turn((-160mm, 335mm, -25mm), (-360, 20, -10), low);
        let upper = (95mm, 455mm, 505mm) + turn((-107mm, 225mm, 15mm), (-220, 25, -15), high);
        let pin = upper - lower;
        let arm = rod - lower;
        let across = cross(pin, arm);
        loop distance(lower, upper) = distance(D_LOWER, D_UPPER);
        loop distance(rod, lower) = distance(D_ROD, D_LOWER);
        loop distance(rod, upper) = distance(D_ROD, D_UPPER);
        loop distance(rod, INNER) = distance(D_ROD, INNER);
        // The wheel's place among the ball joints of the design position.
        let d_pin = D_UPPER - D_LOWER;
        let d_arm = D_ROD - D_LOWER;
        let d_across = cross(d_pin, d_arm);
        let d_wheel = (0mm, 770mm, 320mm) - D_LOWER;
        let size = dot(d_across, d_across);
        let wheel = lower + dot(cross(d_wheel, d_arm), d_across) / size * pin
            + dot(cross(d_pin, d_wheel), d_across) / size * arm
            + dot(d_wheel, d_across) / size * across;
        loop wheel.z = 320mm + travel;
    }

    impl TurningArms {
        pub fn wheel_of_arms(travel) -> WheelOfArms { wheel, v: velocity(wheel) }
        pub fn arms(travel) -> Arms { low, high }
    }
}

#[test]
fn arms_that_turn_lead_the_wheel_along_the_same_way() {
    let arms = TurningArms::default().assemble().expect("it assembles");
    let mut compared = 0;
    for known in read(include_str!("double_wishbone.json")) {
        if number(&known["u"]) != 0.0 {
            continue;
        }
        compared += 1;
        let found = arms.wheel_of_arms(number(&known["z"]));
        for (found, known) in found.wheel.iter().zip(numbers::<3>(&known["p"])) {
            close(*found, known, 770.0, 1e-13);
        }
        close(found.v.x, number(&known["d_dz"]["x"]), 1.0, 1e-11);
        close(found.v.y, number(&known["d_dz"]["y"]), 1.0, 1e-11);
    }
    assert!(compared > 10);
}

/// The arms where the wheel is at the height of the design: of each lower arm's angle that brings the wheel there, found by bisection over a turn,
/// with the two upper arms and the two rods that go with it.
const ARMS: [[f64; 2]; 8] = [
    [-3.073940028937305, -2.92205059841074],
    [-2.6228811523719586, 1.9068013764092777],
    [-2.5361977197985346, 1.874962558744963],
    [-0.465701200080899, 2.1573190732191803],
    [-0.23464315626630428, 2.056052762656172],
    [-0.04799872214118756, -0.07269755037032555],
    [0.0, 0.0],
    [3.036155744551493, 3.0822962929160007],
];

#[test]
fn all_arms_that_bring_the_wheel_to_its_height_are_listed() {
    let all = TurningArms::default()
        .assemblies()
        .expect("they are listed");
    assert_eq!(all.len(), ARMS.len());
    for known in ARMS {
        let apart = |own: &TurningArmsAssembly| {
            let found = own.arms(0.0);
            let [low, high] = [found.low - known[0], found.high - known[1]];
            low.sin().hypot(high.sin()).max(-low.cos()).max(-high.cos())
        };
        let near = all.iter().filter(|own| apart(own) < 1e-12);
        assert_eq!(near.count(), 1, "{known:?}");
    }
}
