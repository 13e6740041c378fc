//! What is said of assemblies that are found from estimates alone.

use std::fs;

use crate::{folder, printed};

/// A wheel carrier on five rods: more unknowns than a listing takes.
const AXLE: &str = "
mechanism! {
    pub struct Axle {
        unit mm;
        input travel = 0mm in -10mm..10mm;
        unknown carrier = frame((0mm, 760mm, 320mm), (1, 0, 0), (0, 0, 1));
        loop distance(point_in(carrier, (15mm, -70mm, 135mm)), (110mm, 420mm, 430mm)) = 287.3mm;
        loop distance(point_in(carrier, (-30mm, -75mm, 140mm)), (-85mm, 435mm, 440mm)) = 256.8mm;
        loop distance(point_in(carrier, (40mm, -60mm, -105mm)), (265mm, 480mm, 265mm)) = 318.6mm;
        loop distance(point_in(carrier, (-25mm, -55mm, -120mm)), (-60mm, 255mm, 215mm)) = 451.6mm;
        loop distance(point_in(carrier, (-150mm, -70mm, -58mm)), (-190mm, 316mm, 258mm)) = 376.2mm;
        loop carrier.origin.z = 320mm + travel;
    }
    impl Axle {
        pub fn wheel(travel) -> Wheel { carrier }
    }
}
";

#[test]
fn what_was_found_from_estimates_is_said_to_be() {
    let folder = folder("assemblies");
    fs::write(folder.join("axle.mech"), AXLE).expect("it is written");
    let all = printed(&folder, &["assemblies", "axle.mech", "--at", "travel=5mm"]);
    assert!(
        all.starts_with("Axle at travel = 5 mm: 1 assembly\n1  carrier.origin = "),
        "{all}"
    );
    let said = "group 2 is followed from the estimates: only that assembly is found, others of the same loops are not listed\n";
    assert!(all.ends_with(said), "{all}");
    let known = printed(&folder, &["check", "axle.mech"]);
    assert!(
        known.contains(&format!("assemblies at the reference: 1 found; {said}")),
        "{known}"
    );
    // Five rods and a height are six distances.
    let many = "followed from the estimates; up to 40 complex solutions (a body on six distances) not listed; ";
    assert!(known.contains(many), "{known}");
}
