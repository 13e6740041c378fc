//! A double wishbone whose lower arm is driven: one joint follows from the other, all in closed form.

use linkage_interpreted::interpreted;

use super::{close, number, numbers, read};

interpreted! {
    pub struct DrivenArm {
        unit mm;
        input arm = 0deg in -15deg..15deg;
        input rack = 0mm in -40mm..40mm;
        const D_LOWER = (10mm, 715mm, 200mm);
        const D_UPPER = (-12mm, 680mm, 520mm);
        const D_ROD = (-135mm, 695mm, 258mm);
        const D_WHEEL = (0mm, 770mm, 320mm);
        const INNER = (-125mm, 422mm, 267mm);
        let lower = (170mm, 380mm, 225mm) + turn((-160mm, 335mm, -25mm), (-360, 20, -10), arm);
        unknown high = 0deg;
        unknown rod = (-135mm, 695mm, 258mm);
        unknown wheel = (0mm, 770mm, 320mm);
        let upper = (95mm, 455mm, 505mm) + turn((-107mm, 225mm, 15mm), (-220, 25, -15), high);
        loop distance(lower, upper) = distance(D_LOWER, D_UPPER);
        loop distance(rod, lower) = distance(D_ROD, D_LOWER);
        loop distance(rod, upper) = distance(D_ROD, D_UPPER);
        loop distance(rod, INNER + (0mm, rack, 0mm)) = distance(D_ROD, INNER);
        loop distance(wheel, lower) = distance(D_WHEEL, D_LOWER);
        loop distance(wheel, upper) = distance(D_WHEEL, D_UPPER);
        loop distance(wheel, rod) = distance(D_WHEEL, D_ROD);
    }

    impl DrivenArm {
        pub fn place(arm, rack) -> Place { high, wheel }
        pub fn rates(arm, rack) -> Rates { high: d(high, arm), wheel: d(wheel, arm) }
    }
}

/// By the travel of the wheel the references know the angles of both arms and how these change.
#[test]
fn the_wheel_is_where_the_arm_leads_it() {
    let kinds = DrivenArm::structure().groups.iter().map(|group| group.kind);
    let kinds: Vec<&str> = kinds.collect();
    assert_eq!(kinds, ["SSR", "three distances", "three distances"]);
    let suspension = DrivenArm::default().assemble().expect("it assembles");
    let references = read(include_str!("double_wishbone.json"));
    assert_eq!(references.len(), 85);
    for known in references {
        let [low, high] = numbers::<2>(&known["arms"]);
        let rack = number(&known["u"]);
        let place = suspension.place(low, rack);
        close(place.high, high, 1.0, 1e-14);
        for (found, known) in place.wheel.iter().zip(numbers::<3>(&known["p"])) {
            close(*found, known, 770.0, 1e-14);
        }
        // All of it is divided by what the travel does to the arm.
        let [by_low, by_high] = numbers::<2>(&known["arms_dz"]);
        let rates = suspension.rates(low, rack);
        close(rates.high, by_high / by_low, 1.0, 1e-13);
        let by_travel = [
            number(&known["d_dz"]["x"]),
            number(&known["d_dz"]["y"]),
            1.0,
        ];
        for (found, known) in rates.wheel.iter().zip(by_travel) {
            close(*found, known / by_low, 300.0, 1e-13);
        }
    }
}
