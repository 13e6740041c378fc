//! Bodies as unknowns that are followed: a wheel carrier on five rods and the travel, a platform on six legs.

use linkage::jacobian::Jacobian;
use linkage::mechanism;
use nalgebra::Vector3;

use super::{FEET, JOINTS, close, number, numbers, read};

mechanism! {
    pub struct Axle {
        unit mm;
        param l1 = 287.31515797117283314mm;
        param l2 = 256.75864152935534645mm;
        param l3 = 318.62987932709637832mm;
        param l4 = 451.60823730308551581mm;
        param l5 = 376.15422369023054744mm;
        input travel = 0mm in -80mm..80mm;
        unknown carrier = frame((0mm, 760mm, 320mm), (1, 0, 0), (0, 0, 1));
        loop distance(point_in(carrier, (15mm, -70mm, 135mm)), (110mm, 420mm, 430mm)) = l1;
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
        pub fn wheel(travel) -> Wheel { carrier, toe, camber, track: sensitivity(carrier.origin.y) }
        pub fn motion(travel) -> Motion {
            v: velocity(carrier.origin), toe: velocity(toe), camber: velocity(camber), bend: acceleration(toe),
            w: omega(carrier), s: velocity(spindle), spindle,
        }
    }
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
        close(motion.toe, number(&known["d_dz"]["toe"]), 1e-3, 1e-12);
        close(motion.camber, number(&known["d_dz"]["camber"]), 1e-3, 1e-12);
        close(motion.bend, number(&known["d2_dz2"]["toe"]), 1e-5, 1e-10);
        for (k, name) in ["x", "y"].into_iter().enumerate() {
            close(motion.v[k], number(&known["d_dz"][name]), 1.0, 1e-13);
        }
        for rod in 0..5 {
            let known = &known["sensitivity"][format!("L{}", rod + 1)];
            close(wheel.track[rod], number(&known["y"]), 1.0, 1e-12);
        }
    }
}

mechanism! {
    pub struct Platform {
        unit mm;
        input l1 = 454.35742mm;
        input l2 = 468.552604mm;
        input l3 = 488.341676mm;
        input l4 = 461.66999mm;
        input l5 = 410.067397mm;
        input l6 = 458.630351mm;
        unknown body = frame((10mm, -20mm, 400mm), (1, 0.15, 0.05), (0, 0, 1));
        loop distance(point_in(body, (150mm, -60mm, -14mm)), (310mm, 40mm, -12mm)) = l1;
        loop distance(point_in(body, (130mm, 85mm, 9mm)), (180mm, 275mm, 18mm)) = l2;
        loop distance(point_in(body, (10mm, 160mm, -11mm)), (-120mm, 300mm, -25mm)) = l3;
        loop distance(point_in(body, (-145mm, 75mm, 16mm)), (-325mm, 60mm, 10mm)) = l4;
        loop distance(point_in(body, (-120mm, -105mm, -7mm)), (-150mm, -290mm, 22mm)) = l5;
        loop distance(point_in(body, (35mm, -155mm, 12mm)), (205mm, -250mm, -8mm)) = l6;
    }

    impl Platform {
        pub fn pose(l1, l2, l3, l4, l5, l6) -> Pose { body }
        pub fn rates(l1, l2, l3, l4, l5, l6) -> Rates { v: velocity(body.origin), w: omega(body) }
    }
}

/// The largest singular value over the smallest at each position of the path, in mm and radians, and with 100 mm for a radian.
const CONDITIONS: [[f64; 2]; 20] = [
    [4934.24620453721, 60.18898142148565],
    [4387.870684466275, 50.20247610464304],
    [4059.008309387328, 43.924273363656646],
    [3836.6723713465335, 41.19441393764948],
    [3666.4223378055513, 40.740661636182004],
    [3520.492215411684, 40.66649926536587],
    [3384.0699368277974, 40.685813188011245],
    [3249.1330722511916, 40.748865998905536],
    [3111.7076901924884, 40.8384204495905],
    [2970.6023418970817, 40.94366750706201],
    [2826.70033730343, 41.053287692137594],
    [2682.380319781172, 41.15199204377161],
    [2540.9088068243614, 41.21897976385907],
    [2405.853085163455, 41.229001144531985],
    [2280.7158216059956, 41.155905370346886],
    [2169.0986651161174, 40.977624456956484],
    [2075.8929812706165, 40.68076691360413],
    [2010.065137245975, 40.263382740756036],
    [1984.8221543901868, 39.735086761663574],
    [1999.8096482071323, 39.11498413010571],
];

#[test]
fn the_jacobian_of_a_platform_is_what_its_legs_say() {
    let platform = Platform::default().assemble().expect("it assembles");
    let path = read(include_str!("hexapod.json"));
    let [a, b, c, d, e, f] = numbers::<6>(&path[0]["legs"]);
    let mut at = platform.follower(a, b, c, d, e, f).expect("the reference");
    for (known, [raw, scaled]) in path.iter().zip(CONDITIONS) {
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
