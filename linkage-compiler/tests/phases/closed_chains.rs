//! What positions and derivatives of closed chains cost: the examples of vehicles and robots.

use linkage_compiler::ir::CompiledMechanism;
use linkage_corpus::given::{Given, written};

/// The operations of functions of the mechanisms in a file.
fn operations<const COUNT: usize>(file: &str, functions: [&str; COUNT]) -> [u32; COUNT] {
    let units = written(file)
        .into_iter()
        .map(|text| Given::text(&text).unit);
    let all: Vec<_> = units.flat_map(|unit| unit.functions).collect();
    functions.map(|name| {
        let found = all.iter().find(|own| own.name == name);
        let count = found.expect("it has the function").called.count;
        println!("{name}: {count:?}");
        count.total()
    })
}

/// Its lower arm is two rods from one ball joint, its strut two scalar products.
#[test]
fn mcpherson_strut() {
    let asked = ["wheel", "motion", "adjustment"];
    let [wheel, motion, adjustment] = operations("mechanisms/mcpherson.rs", asked);
    assert!(wheel <= 550);
    assert!(motion <= 825);
    assert!(adjustment <= 1975);
}

/// Each of its arms is two rods from one ball joint.
#[test]
fn double_wishbone() {
    let asked = ["wheel", "motion", "adjustment"];
    let [wheel, motion, adjustment] = operations("mechanisms/double_wishbone.rs", asked);
    assert!(wheel <= 550);
    assert!(motion <= 2100);
    assert!(adjustment <= 1625);
}

/// Rods that share no joint.
#[test]
fn five_link_axle() {
    let asked = ["wheel", "motion", "body", "adjustment"];
    let [wheel, motion, body, adjustment] = operations("mechanisms/five_link_axle.rs", asked);
    assert!(wheel <= 740);
    assert!(motion <= 2800);
    assert!(body <= 1450);
    assert!(adjustment <= 2450);
}

/// All legs of a platform are known: how it moves is six columns.
#[test]
fn platform_from_its_legs() {
    let [pose, rates] = operations("mechanisms/hexapod.rs", ["pose", "rates"]);
    assert!(pose <= 2700);
    assert!(rates <= 3500);
}

/// A universal joint and two rods, both ways.
#[test]
fn ankle() {
    let [foot, motors] = operations("mechanisms/ankle.rs", ["foot", "motors"]);
    assert!(foot <= 350);
    assert!(motors <= 120);
}

/// From the pose to the drives every leg is a closed form of its own.
#[test]
fn from_a_pose_to_the_drives() {
    let [legs] = operations("mechanisms/hexapod.rs", ["legs"]);
    assert!(legs <= 200);
    let [sleds, motors] = operations("tests/space/sleds.rs", ["sleds", "motors"]);
    assert!(sleds <= 175);
    assert!(motors <= 425);
}

/// Three servos, both ways.
#[test]
fn swashplate() {
    let [servos, plate] = operations("tests/space/swashplate.rs", ["servos", "plate"]);
    assert!(servos <= 180);
    assert!(plate <= 960);
}

/// A wishbone whose arm is driven is solved joint by joint.
#[test]
fn double_wishbone_by_an_arm() {
    let [place] = operations("tests/followed/wishbone_forms.rs", ["place"]);
    assert!(place <= 280);
}

/// A wheel carrier with two rods in its ball joint.
fn carrier(loops: &str) -> CompiledMechanism {
    let text = format!(
        "pub struct Carrier {{
            unit mm;
            param front_rod = 346mm; param rear_rod = 447mm; param tie_rod = 350mm;
            param front = (15mm, 380mm, 215mm); param rear = (-300mm, 400mm, 222mm);
            param tie = (-130mm, 350mm, 288mm); param top = (-25mm, 580mm, 850mm);
            input travel = 0mm in -60mm..60mm;
            unknown body = frame((0mm, 760mm, 310mm), (1, 0, 0), (0, 0, 1));
            let ball = point_in(body, (5mm, -35mm, -120mm));
            let strut = top - point_in(body, (-8mm, -108mm, 90mm));
            loop distance(ball, front) = front_rod;
            loop distance(ball, rear) = rear_rod;
            loop dot(strut, body.x + 17 / 450 * body.z) = 0;
            {loops}
        }}
        impl Carrier {{ pub fn place(travel) -> Place {{ body }} }}"
    );
    let checked = linkage_compiler::check(text.parse().expect("tokens"));
    assert!(checked.messages.is_empty(), "{:?}", checked.messages);
    checked.unit.expect("a mechanism without a mistake")
}

/// An angle, and all six numbers of the axes, whatever of the origin is known and whatever else is linear in them.
#[test]
fn a_body_with_two_rods_in_one_point_has_an_angle_instead_of_an_origin() {
    let across = "loop dot(strut, body.y + 72 / 450 * body.z) = 0;";
    let tie = "loop distance(point_in(body, (-140mm, -60mm, -28mm)), tie) = tie_rod;";
    for loops in [
        format!("{across} {tie} loop body.origin.z = 310mm + travel;"),
        format!(
            "{across} {tie} loop distance(body.origin, (20mm, 760mm, -800mm)) = 1110mm + travel;"
        ),
        // No link is left that would say how large it is.
        format!(
            "{across} loop dot(body.x, (0.1, 1, 0)) = 0.1; loop body.origin.z = 310mm + travel;"
        ),
        format!(
            "{across} loop dot(body.x, (0.1, 1, 0)) = 0.1; loop dot(strut, (0, 0, 1)) = 450mm - travel;"
        ),
    ] {
        let unit = carrier(&loops);
        let [coupled] = &unit.coupled[..] else {
            panic!("one group: {loops}");
        };
        assert!(
            coupled.followed && coupled.size == 8,
            "{loops}: {}",
            coupled.size
        );
    }
}

/// The fixed ends of both rods lie along x, so that the place along z is known, and the circle says nothing of x.
#[test]
fn a_circle_across_an_axis_of_coordinates() {
    let wheel = "pub struct Wheel {
        unit mm;
        input travel = 0mm in -60mm..60mm;
        unknown carrier = frame((0mm, 760mm, 320mm), (1, 0, 0), (0, 0, 1));
        let lower = point_in(carrier, (0mm, -60mm, -70mm));
        let upper = point_in(carrier, (0mm, -70mm, 130mm));
        let lever = point_in(carrier, (-130mm, -60mm, -70mm));
        let low = (0mm, 700mm, 250mm);
        let high = (0mm, 690mm, 450mm);
        loop distance(lower, (150mm, 400mm, 250mm)) = distance(low, (150mm, 400mm, 250mm));
        loop distance(lower, (-150mm, 400mm, 250mm)) = distance(low, (-150mm, 400mm, 250mm));
        loop distance(upper, (120mm, 450mm, 450mm)) = distance(high, (120mm, 450mm, 450mm));
        loop distance(upper, (-120mm, 450mm, 450mm)) = distance(high, (-120mm, 450mm, 450mm));
        loop distance(lever, (-130mm, 400mm, 250mm)) = 300mm;
        loop carrier.origin.z = 320mm + travel;
    }
    impl Wheel { pub fn place(travel) -> Place { lower, v: velocity(lower) } }";
    let checked = linkage_compiler::check(wheel.parse().expect("tokens"));
    assert!(checked.messages.is_empty(), "{:?}", checked.messages);
    let unit = checked.unit.expect("a mechanism without a mistake");
    assert_eq!(unit.coupled.len(), 1);
}
