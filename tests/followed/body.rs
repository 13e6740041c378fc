//! Bodies as unknowns that are followed, and how they turn.

use super::{FEET, JOINTS, STEP, close, near, number, numbers, path_of_platform, read};
use linkage::jacobian::Jacobian;
use linkage::mechanism;
use linkage_interpreted::interpreted;
use nalgebra::Vector3;
use platform::ToPose;

// Bodies as unknowns that are followed: a wheel carrier on five rods and the travel, a platform on six legs.

mechanism! {
    pub struct Axle {
        unit mm;
        param l1 = 287.31515797117283314mm;
        param l2 = 256.75864152935534645mm;
        param l3 = 318.62987932709637832mm;
        param l4 = 451.60823730308551581mm;
        param l5 = 376.15422369023054744mm;
        param inner1 = (110mm, 420mm, 430mm);
        input travel = 0mm in -80mm..80mm;
        unknown carrier = frame((0mm, 760mm, 320mm), (1, 0, 0), (0, 0, 1));
        loop distance(point_in(carrier, (15mm, -70mm, 135mm)), inner1) = l1;
        loop distance(point_in(carrier, (-30mm, -75mm, 140mm)), (-85mm, 435mm, 440mm)) = l2;
        loop distance(point_in(carrier, (40mm, -60mm, -105mm)), (265mm, 480mm, 265mm)) = l3;
        loop distance(point_in(carrier, (-25mm, -55mm, -120mm)), (-60mm, 255mm, 215mm)) = l4;
        loop distance(point_in(carrier, (-150mm, -70mm, -58mm)), (-190mm, 316mm, 258mm)) = l5;
        loop carrier.origin.z = 320mm + travel;
        let spindle = unit(0.0035 * carrier.x + carrier.y + 0.0175 * carrier.z);
        let toe = atan2(spindle.x, spindle.y);
        let camber = asin(-spindle.z);
    }

    impl Axle {
        pub fn wheel(travel) -> Wheel { carrier, toe, camber }
        pub fn adjustment(travel) -> Adjustment {
            x: sensitivity(carrier.origin.x), y: sensitivity(carrier.origin.y), toe: sensitivity(toe), camber: sensitivity(camber),
        }
        pub fn motion(travel) -> Motion {
            v: velocity(carrier.origin), toe: velocity(toe), camber: velocity(camber), bend: acceleration(toe),
            tilt: acceleration(camber),
            w: omega(carrier), s: velocity(spindle), spindle,
        }
    }
}

/// The reference's names of the dimensions, in the order of the parameters.
const DIMENSIONS: [&str; 8] = ["L1", "L2", "L3", "L4", "L5", "A1.x", "A1.y", "A1.z"];

#[test]
fn it_is_known_how_many_solutions_a_body_has() {
    let known = "followed from the estimates; up to 40 complex solutions (a body on six distances) not listed; ";
    let groups = [
        Axle::<f64>::STRUCTURE.groups[1],
        ToPose::<f64>::STRUCTURE.groups[0],
    ];
    assert!(groups.iter().all(|group| group.method.starts_with(known)));
}

#[test]
fn it_is_where_and_moves_as_it_was_computed_with_80_digits() {
    let axle = Axle::default().assemble().expect("it assembles");
    let references = read(include_str!("five_link_axle.json"));
    assert_eq!(references.len(), 17);
    for known in references {
        let z = number(&known["z"]);
        let (wheel, motion) = (axle.wheel(z), axle.motion(z));
        let origin: [f64; 3] = wheel.carrier.origin.into();
        for (found, known) in origin.into_iter().zip(numbers::<3>(&known["p"])) {
            close(found, known, 760.0, 1e-14);
        }
        let (s, w) = (motion.spindle, motion.w);
        for (found, known) in (0..3).map(|k| s[k]).zip(numbers::<3>(&known["spindle"])) {
            close(found, known, 1.0, 1e-14);
        }
        // What is fixed on the body turns by its angular velocity.
        assert!((w.cross(&s) - motion.s).norm() < 1e-16);
        let toe = numbers::<3>(&known["spindle"]);
        close(wheel.toe, toe[0].atan2(toe[1]), 1.0, 1e-14);
        close(wheel.camber, (-toe[2]).asin(), 1.0, 1e-14);
        close(motion.toe, number(&known["d_dz"]["toe"]), 1e-3, 1e-12);
        close(motion.camber, number(&known["d_dz"]["camber"]), 1e-3, 1e-12);
        close(motion.bend, number(&known["d2_dz2"]["toe"]), 1e-5, 1e-10);
        close(motion.tilt, number(&known["d2_dz2"]["camber"]), 1e-5, 1e-10);
        for (k, name) in ["x", "y"].into_iter().enumerate() {
            close(motion.v[k], number(&known["d_dz"][name]), 1.0, 1e-13);
        }
        let found = axle.adjustment(z);
        let of = |name: &str| DIMENSIONS.map(|own| number(&known["sensitivity"][own][name]));
        for (name, found, scale) in [
            ("x", found.x, 1.0),
            ("y", found.y, 1.0),
            ("toe", found.toe, 1e-2),
            ("camber", found.camber, 1e-2),
        ] {
            let pairs = found.into_iter().zip(of(name));
            pairs.for_each(|(found, known)| close(found, known, scale, 1e-12));
        }
    }
}

mod platform {
    include!("../../mechanisms/hexapod.rs");
}

#[test]
fn the_jacobian_of_a_platform_is_what_its_legs_say() {
    let platform = ToPose::default().assemble().expect("it assembles");
    let path = path_of_platform();
    assert_eq!(path.len(), 20);
    let [a, b, c, d, e, f] = numbers::<6>(&path[0]["legs"]);
    let mut at = platform.follower(a, b, c, d, e, f).expect("the reference");
    for known in &path {
        let [a, b, c, d, e, f] = numbers::<6>(&known["legs"]);
        at.follow(a, b, c, d, e, f).expect("it is followed");
        let (body, rates) = (at.pose().body, at.rates());
        let columns = std::array::from_fn(|leg| {
            let (v, w) = (rates.v[leg], rates.w[leg]);
            [v.x, v.y, v.z, w.x, w.y, w.z]
        });
        let jacobian = Jacobian::of_inputs(columns);
        for (row, found) in jacobian.rows().into_iter().enumerate() {
            for (leg, found) in found.into_iter().enumerate() {
                close(found, number(&known["jacobian"][row][leg]), 1.0, 1e-12);
            }
        }
        // In mm and radians, and with 100 mm for a radian.
        let [raw, scaled] = ["condition", "scaled"].map(|name| number(&known[name]));
        close(jacobian.condition(), raw, raw, 1e-12);
        let units = [1.0, 1.0, 1.0, 0.01, 0.01, 0.01];
        close(
            jacobian.in_units(units, [1.0; 6]).condition(),
            scaled,
            scaled,
            1e-12,
        );
        // The other way round each leg feels the body along itself, and about the origin by its arm.
        for (leg, row) in jacobian.inverse().rows().into_iter().enumerate() {
            let joint = body.point(Vector3::from(JOINTS[leg]));
            let along = (joint - Vector3::from(FEET[leg])).normalize();
            let moment = (joint - body.origin).cross(&along);
            let expected = [along.x, along.y, along.z, moment.x, moment.y, moment.z];
            let pairs = row.into_iter().zip(expected);
            pairs.for_each(|(found, known)| close(found, known, 160.0, 1e-13));
        }
    }
}

// How a followed body turns, where an input moves it, changes the length of a rod, and changes where on the body that rod ends: each
// derivative against differences of the one before it.

interpreted! {
    pub struct Shimmed {
        unit mm;
        param l1 = 287.31515797117283314mm;
        param inner1 = (110mm, 420mm, 430mm);
        param outer2 = (-30mm, -75mm, 140mm);
        input travel = 0mm in -20mm..20mm;
        input shim   = 0mm in -3mm..3mm;
        unknown carrier = frame((0mm, 760mm, 320mm), (1, 0, 0), (0, 0, 1));
        loop distance(point_in(carrier, (15mm, -70mm, 135mm)), inner1) = l1;
        loop distance(point_in(carrier, outer2), (-85mm, 435mm, 440mm)) = 256.75864152935534645mm;
        loop distance(point_in(carrier, (40mm, -60mm, -105mm)), (265mm, 480mm, 265mm)) = 318.62987932709637832mm;
        loop distance(point_in(carrier, (-25mm, -55mm, -120mm)), (-60mm, 255mm, 215mm)) = 451.60823730308551581mm;
        loop distance(point_in(carrier, (-150mm, -70mm + shim, -58mm)), (-190mm, 316mm, 258mm))
            = 376.15422369023054744mm + 0.5 * shim;
        loop carrier.origin.z = 320mm + travel;
    }

    impl Shimmed {
        pub fn body(travel, shim) -> Body { p: carrier.origin, x: carrier.x, y: carrier.y }
        pub fn first(travel, shim) -> First { p: velocity(carrier.origin), x: velocity(carrier.x), y: velocity(carrier.y), w: omega(carrier) }
        pub fn second(travel, shim) -> Second {
            p: acceleration(carrier.origin), x: acceleration(carrier.x), y: acceleration(carrier.y), a: alpha(carrier),
        }
        pub fn by_dimensions(travel, shim) -> ByDimensions {
            w: sensitivity(omega(carrier)), x: sensitivity(velocity(carrier.x)), p: sensitivity(carrier.origin),
        }
    }
}

interpreted! {
    /// The first rod ends beside the body, in the direction across its own x axis and an axis that is fixed: no body carries that as it is.
    pub struct Offset {
        unit mm;
        input travel = 0mm in -20mm..20mm;
        unknown carrier = frame((0mm, 760mm, 320mm), (1, 0, 0), (0, 0, 1));
        loop distance(point_in(carrier, (15mm, -70mm, 135mm)) + 40mm * cross(carrier.x, (0, 0, 1)), (110mm, 420mm, 430mm)) = 250mm;
        loop distance(point_in(carrier, (-30mm, -75mm, 140mm)), (-85mm, 435mm, 440mm)) = 256.75864152935534645mm;
        loop distance(point_in(carrier, (40mm, -60mm, -105mm)), (265mm, 480mm, 265mm)) = 318.62987932709637832mm;
        loop distance(point_in(carrier, (-25mm, -55mm, -120mm)), (-60mm, 255mm, 215mm)) = 451.60823730308551581mm;
        loop distance(point_in(carrier, (-150mm, -70mm, -58mm)), (-190mm, 316mm, 258mm)) = 376.15422369023054744mm;
        loop carrier.origin.z = 320mm + travel;
    }

    impl Offset {
        pub fn body(travel) -> OffsetBody { p: carrier.origin, x: carrier.x, y: carrier.y }
        pub fn first(travel) -> OffsetFirst { p: velocity(carrier.origin), x: velocity(carrier.x), y: velocity(carrier.y), w: omega(carrier) }
        pub fn second(travel) -> OffsetSecond {
            p: acceleration(carrier.origin), x: acceleration(carrier.x), y: acceleration(carrier.y), a: alpha(carrier),
        }
        pub fn third(travel) -> OffsetThird { p: jerk(carrier.origin), x: jerk(carrier.x), y: jerk(carrier.y) }
    }
}

const PLACES: [[f64; 2]; 4] = [[0.0, 0.0], [13.0, -2.1], [-17.5, 1.4], [6.0, 2.6]];

#[test]
fn derivatives_are_those_of_what_is_differentiated() {
    let axle = Shimmed::default().assemble().expect("it assembles");
    for [travel, shim] in PLACES {
        let steps = [[STEP, 0.0], [0.0, STEP]];
        let (first, second) = (axle.first(travel, shim), axle.second(travel, shim));
        let body = axle.body(travel, shim);
        for (k, [a, b]) in steps.into_iter().enumerate() {
            let ends = [1.0, -1.0].map(|s| (travel + s * a, shim + s * b));
            let [after, before] = ends.map(|(travel, shim)| axle.body(travel, shim));
            near(first.p[k], [after.p, before.p], 1.0);
            near(first.x[k], [after.x, before.x], 1e-2);
            near(first.y[k], [after.y, before.y], 1e-2);
            // The body's directions turn by its angular velocity.
            assert!((first.w[k].cross(&body.x) - first.x[k]).norm() < 1e-16);
            assert!((first.w[k].cross(&body.y) - first.y[k]).norm() < 1e-16);
            let [after, before] = ends.map(|(travel, shim)| axle.first(travel, shim));
            for j in 0..2 {
                near(second.p[j][k], [after.p[j], before.p[j]], 1e-2);
                near(second.x[j][k], [after.x[j], before.x[j]], 1e-4);
                near(second.y[j][k], [after.y[j], before.y[j]], 1e-4);
                near(second.a[j][k], [after.w[j], before.w[j]], 1e-4);
            }
        }
    }
}

#[test]
fn sensitivities_are_those_of_other_dimensions() {
    let own = Shimmed::default();
    let axle = own.assemble().expect("it assembles");
    let changed = |index: usize, step: f64| {
        let mut values = linkage::Dimensions::values(&own);
        values[index] += step;
        let other = <Shimmed as linkage::Dimensions<7>>::from_values(&values);
        other.assemble_from(&axle).expect("it is followed")
    };
    for index in 0..7 {
        let [after, before] = [STEP, -STEP].map(|step| changed(index, step));
        for [travel, shim] in PLACES {
            let found = axle.by_dimensions(travel, shim);
            let [a, b] = [&after, &before].map(|axle| axle.body(travel, shim));
            near(found.p[index], [a.p, b.p], 1.0);
            let [a, b] = [&after, &before].map(|axle| axle.first(travel, shim));
            for k in 0..2 {
                near(found.w[index][k], [a.w[k], b.w[k]], 1e-4);
                near(found.x[index][k], [a.x[k], b.x[k]], 1e-4);
            }
        }
    }
}

#[test]
fn what_no_body_carries_turns_otherwise() {
    let axle = Offset::default().assemble().expect("it assembles");
    for travel in [0.0, 13.0, -17.5] {
        let ends = [travel + STEP, travel - STEP];
        let first = axle.first(travel);
        let [after, before] = ends.map(|travel| axle.body(travel));
        near(first.p, [after.p, before.p], 1.0);
        near(first.x, [after.x, before.x], 1e-2);
        near(first.y, [after.y, before.y], 1e-2);
        let second = axle.second(travel);
        let [after, before] = ends.map(|travel| axle.first(travel));
        near(second.p, [after.p, before.p], 1e-2);
        near(second.x, [after.x, before.x], 1e-4);
        near(second.y, [after.y, before.y], 1e-4);
        near(second.a, [after.w, before.w], 1e-4);
        let third = axle.third(travel);
        let [after, before] = ends.map(|travel| axle.second(travel));
        near(third.p, [after.p, before.p], 1e-4);
        near(third.x, [after.x, before.x], 1e-6);
        near(third.y, [after.y, before.y], 1e-6);
    }
}
