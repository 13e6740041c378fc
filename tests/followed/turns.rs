//! How a followed body turns, where an input moves it, changes the length of a rod, and changes where on the body that rod ends: each
//! derivative against differences of the one before it.

use linkage_interpreted::interpreted;

use super::differences::{STEP, near};

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
