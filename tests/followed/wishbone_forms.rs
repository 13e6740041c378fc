//! Double wishbones in other natural forms: driven by an arm, with the wheel as a point of three distances, and by the joint of the tie rod.

use super::{close, number, numbers, read};
use linkage_interpreted::interpreted;

// A double wishbone whose lower arm is driven: one joint follows from the other, all in closed form.

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

// Other natural forms of a double wishbone whose arms turn: its wheel as a point of three distances, and driven by the height of the joint of the
// tie rod. The first has too many unknowns for a listing, of the second all assemblies are listed.

interpreted! {
    pub struct WheelByDistances {
        unit mm;
        input travel = 0mm in -80mm..80mm;
        const D_LOWER = (10mm, 715mm, 200mm);
        const D_UPPER = (-12mm, 680mm, 520mm);
        const D_ROD = (-135mm, 695mm, 258mm);
        const D_WHEEL = (0mm, 770mm, 320mm);
        const INNER = (-125mm, 422mm, 267mm);
        unknown low = 0deg;
        unknown high = 0deg;
        unknown rod = (-135mm, 695mm, 258mm);
        unknown wheel = (0mm, 770mm, 320mm);
        let lower = (170mm, 380mm, 225mm) + turn((-160mm, 335mm, -25mm), (-360, 20, -10), low);
        let upper = (95mm, 455mm, 505mm) + turn((-107mm, 225mm, 15mm), (-220, 25, -15), high);
        loop distance(lower, upper) = distance(D_LOWER, D_UPPER);
        loop distance(rod, lower) = distance(D_ROD, D_LOWER);
        loop distance(rod, upper) = distance(D_ROD, D_UPPER);
        loop distance(rod, INNER) = distance(D_ROD, INNER);
        loop distance(wheel, lower) = distance(D_WHEEL, D_LOWER);
        loop distance(wheel, upper) = distance(D_WHEEL, D_UPPER);
        loop distance(wheel, rod) = distance(D_WHEEL, D_ROD);
        loop wheel.z = 320mm + travel;
    }
    impl WheelByDistances {
        pub fn place(travel) -> PlaceByDistances { low, high, wheel }
    }
}

interpreted! {
    pub struct ByTieRod {
        unit mm;
        input height = 258mm in 175mm..340mm;
        const D_LOWER = (10mm, 715mm, 200mm);
        const D_UPPER = (-12mm, 680mm, 520mm);
        const D_ROD = (-135mm, 695mm, 258mm);
        const INNER = (-125mm, 422mm, 267mm);
        unknown low = 0deg;
        unknown high = 0deg;
        unknown rod = (-135mm, 695mm, 258mm);
        let lower = (170mm, 380mm, 225mm) + turn((-160mm, 335mm, -25mm), (-360, 20, -10), low);
        let upper = (95mm, 455mm, 505mm) + turn((-107mm, 225mm, 15mm), (-220, 25, -15), high);
        loop distance(lower, upper) = distance(D_LOWER, D_UPPER);
        loop distance(rod, lower) = distance(D_ROD, D_LOWER);
        loop distance(rod, upper) = distance(D_ROD, D_UPPER);
        loop distance(rod, INNER) = distance(D_ROD, INNER);
        loop rod.z = height;
    }
    impl ByTieRod {
        pub fn place(height) -> PlaceByTieRod { low, high, rod }
    }
}

/// What is known where the rack stands in the middle.
fn references() -> Vec<serde_json::Value> {
    let all = read(include_str!("double_wishbone.json"));
    let middle = all.into_iter().filter(|known| number(&known["u"]) == 0.0);
    let middle: Vec<_> = middle.collect();
    assert_eq!(middle.len(), 17);
    middle
}

#[test]
fn a_wheel_at_three_distances_is_where_it_was_computed_with_80_digits() {
    let group = WheelByDistances::structure()
        .groups
        .last()
        .expect("a group");
    assert!(group.method.starts_with("followed from the estimates"));
    let suspension = WheelByDistances::default()
        .assemble()
        .expect("it assembles");
    for known in references() {
        let found = suspension.place(number(&known["z"]));
        let [low, high] = numbers::<2>(&known["arms"]);
        close(found.low, low, 1.0, 1e-14);
        close(found.high, high, 1.0, 1e-14);
        for (found, known) in found.wheel.iter().zip(numbers::<3>(&known["p"])) {
            close(*found, known, 770.0, 1e-13);
        }
    }
}

#[test]
fn a_tie_rod_that_drives_leads_the_arms_where_they_were_computed_with_80_digits() {
    let suspension = ByTieRod::default().assemble().expect("it assembles");
    assert!(
        ByTieRod::default()
            .assemblies()
            .expect("they are listed")
            .len()
            > 1
    );
    for known in references() {
        let joint = numbers::<3>(&known["rod"]);
        let found = suspension.place(joint[2]);
        let [low, high] = numbers::<2>(&known["arms"]);
        close(found.low, low, 1.0, 1e-14);
        close(found.high, high, 1.0, 1e-14);
        for (found, known) in found.rod.iter().zip(joint) {
            close(*found, known, 770.0, 1e-13);
        }
    }
}
