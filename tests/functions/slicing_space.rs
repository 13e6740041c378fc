//! In space, too, a function computes what its quantities need and nothing else.

use linkage::{Operations, mechanism};

mechanism! {
    /// A rocker, a direction across the coupler, and a slide driven by the rocker.
    pub struct Space {
        unit mm;
        param crank = 30mm;
        param coupler = 130mm;
        param rocker = 70mm;
        param pivot = (110mm, 30mm, -50mm);
        param tilt = 20deg;
        param rod = 200mm;
        param rail = (-60mm, 0mm, -50mm);
        input phi = 0deg in 0deg..360deg;
        unknown psi = 102deg;
        let pin = turn((0, crank, 0), (1, 0, 0), phi);
        let end = pivot + turn((rocker, 0, 0), (0, sin(tilt), cos(tilt)), psi);
        loop distance(pin, end) = coupler;

        unknown across = (0, 0.7, 0.7);
        loop norm(across) = 1;
        loop dot(across, end - pin) = 0;
        loop dot(across, (1, 0, 0)) = 0;
        let tool = end + 40mm * across;

        unknown s = -40mm;
        loop distance(end, rail + s * (0, 1, 0)) = rod;
    }
    impl Space {
        pub fn pin(phi) -> Pin { pin }
        pub fn end(phi) -> End { end }
        pub fn angle(phi) -> Angle { psi }
        pub fn rate(phi) -> Rate { r: velocity(psi) }
        pub fn end_rate(phi) -> EndRate { end, r: velocity(psi) }
        pub fn tool(phi) -> Tool { tool }
        pub fn slide(phi) -> Slide { s }
        pub fn everything(phi) -> Everything { end, tool, s }
        pub fn twice(phi) -> Twice { end, again: end, z: end.z }
        pub fn foreign(phi) -> Foreign { end, e: sensitivity(end, [rod, rail.x]) }
        pub fn axis() -> Axis { x: sin(tilt), reach: norm(pivot) }
    }
}

mechanism! {
    /// The rocker alone.
    pub struct Rocker {
        unit mm;
        param crank = 30mm;
        param coupler = 130mm;
        param rocker = 70mm;
        param pivot = (110mm, 30mm, -50mm);
        param tilt = 20deg;
        input phi = 0deg in 0deg..360deg;
        unknown psi = 102deg;
        let pin = turn((0, crank, 0), (1, 0, 0), phi);
        let end = pivot + turn((rocker, 0, 0), (0, sin(tilt), cos(tilt)), psi);
        loop distance(pin, end) = coupler;
    }
    impl Rocker {
        pub fn end(phi) -> RockerEnd { end }
        pub fn angle(phi) -> RockerAngle { psi }
        pub fn rate(phi) -> RockerRate { r: velocity(psi) }
    }
}

const NONE: Operations = Operations {
    add: 0,
    mul: 0,
    div: 0,
    sqrt: 0,
    sin_cos: 0,
    atan2: 0,
    other: 0,
};

fn cost(name: &str) -> Operations {
    let mut functions = Space::STRUCTURE.functions.iter();
    let function = functions.find(|f| f.name == name);
    function.expect("the function is listed").operations
}

#[test]
fn later_groups_cost_nothing() {
    for function in Rocker::STRUCTURE.functions {
        assert_eq!(
            cost(function.name),
            function.operations,
            "{}",
            function.name
        );
    }
    for name in ["tool", "slide"] {
        assert!(cost(name).total() > cost("end").total(), "{name}");
    }
}

#[test]
fn a_turn_about_a_fixed_axis_is_two_products() {
    let expected = Operations {
        mul: 2,
        sin_cos: 1,
        ..NONE
    };
    assert_eq!(cost("pin"), expected);
    assert_eq!(cost("axis"), NONE);
}

#[test]
fn what_groups_share_is_computed_once() {
    assert_eq!(cost("twice"), cost("end"));
    let [end, tool, slide, all] = ["end", "tool", "slide", "everything"].map(|n| cost(n).total());
    assert!(all < tool + slide && all >= tool && all >= slide);
    // Who does not return the end itself may put its offset together with others, or turn a vector before the root that nobody else asks for.
    assert!(all <= tool + slide - end + 3, "{all} {tool} {slide} {end}");
    let [rate, both] = ["rate", "end_rate"].map(|n| cost(n).total());
    assert!(both < rate + end);
}

#[test]
fn neighbouring_groups_are_not_in_it() {
    // The direction needs the rocker's end, the slide too, but neither needs the other.
    assert_eq!(cost("foreign"), cost("end"));
    assert_eq!(cost("angle").atan2, 1);
    for name in ["end", "rate", "tool", "slide", "everything"] {
        assert_eq!(cost(name).atan2, 0, "{name}");
        assert_eq!(cost(name).sin_cos, 1, "{name}");
    }
}
