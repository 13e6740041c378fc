//! Triads among other groups: behind and before dyads, two of them, guides that move with the input, a
//! structure that does not move at all.

use std::f64::consts::TAU;

const ROUNDING: f64 = 4e-13;

fn cycle() -> impl Iterator<Item = f64> {
    (0..=144).map(|i| TAU * f64::from(i) / 144.0)
}

linkage_interpreted::interpreted! {
    /// A four-bar drives a triad, which drives a slider; a second triad hangs on the first one.
    struct Chain {
        unit mm;
        param crank = 15mm;
        param rocker = 40mm;
        input phi = 30deg in 0deg..360deg;

        // The four-bar: its rocker swings.
        unknown theta = 4deg;
        unknown psi = 55deg;
        loop polar(crank, phi) + polar(70mm, theta) = (60mm, -20mm) + polar(rocker, psi);

        // A triad on the rocker's end.
        let a1 = (60mm, -20mm) + polar(rocker, psi);
        unknown x1 = 96deg;
        unknown x2 = -157deg;
        unknown x3 = -34deg;
        unknown link = -64deg;
        let e1 = a1 + polar(79mm, x1);
        let e2 = e1 + polar(110mm, link);
        let e3 = e1 + polar(107mm, link + 75deg);
        loop e2 = (186mm, 20mm) + polar(69mm, x2);
        loop e3 = (90mm, 172mm) + polar(107mm, x3);

        // A slider on the triad.
        unknown rod = -3deg;
        unknown slide = 279mm;
        let pin = e1 + polar(60mm, link + 40deg);
        loop pin + polar(150mm, rod) = (slide, 60mm);

        // A second triad on the first one: three sliders on guides of its ternary link.
        unknown y1 = 45mm;
        unknown y2 = 31mm;
        unknown y3 = 37mm;
        unknown body = -11deg;
        let g1 = pin + polar(y1, body + 50deg);
        loop g1 + polar(96mm, body) = (230mm, 90mm) + polar(y2, body - 15deg);
        loop g1 + polar(73mm, body + 80deg) = (185mm, 200mm) + polar(y3, body - 70deg);
    }

    impl Chain {
        fn position(phi) -> ChainPosition {
            pin, slide, g1, margin: margin(),
            miss_1: e2 - (186mm, 20mm) - polar(69mm, x2),
            miss_2: e3 - (90mm, 172mm) - polar(107mm, x3),
            miss_3: pin + polar(150mm, rod) - (slide, 60mm),
            miss_4: g1 + polar(96mm, body) - (230mm, 90mm) - polar(y2, body - 15deg),
        }
        fn motion(phi) -> ChainMotion {
            slide, v: velocity(slide), a: acceleration(slide), g1, vg: velocity(g1), ag: acceleration(g1),
        }
        fn accuracy(phi) -> ChainAccuracy { e: sensitivity(slide), g: sensitivity(g1) }
    }
}

/// Derivatives by an input or a dimension against differences of a function of it.
#[track_caller]
fn differences(
    function: impl Fn(f64) -> f64,
    first: f64,
    second: Option<f64>,
    step: f64,
    size: f64,
) {
    let [b, f, bb, ff, here] = [-step, step, -2.0 * step, 2.0 * step, 0.0].map(&function);
    let slope = (8.0 * (f - b) - (ff - bb)) / (12.0 * step);
    assert!((slope - first).abs() < 1e-7 * size, "{first}, not {slope}");
    if let Some(second) = second {
        let bend = (16.0 * (f + b) - (ff + bb) - 30.0 * here) / (12.0 * step * step);
        assert!((bend - second).abs() < 1e-4 * size, "{second}, not {bend}");
    }
}

#[test]
fn triads_among_dyads() {
    let chain = Chain::default().assemble().expect("it closes");
    println!("{}", Chain::structure());
    let classes: Vec<_> = Chain::structure()
        .groups
        .iter()
        .map(|group| group.class)
        .collect();
    assert_eq!(classes, [2, 3, 2, 3]);
    for phi in cycle() {
        let p = chain.position(phi);
        let misses = [p.miss_1, p.miss_2, p.miss_3, p.miss_4].map(|miss| miss.norm());
        assert!(crate::largest(misses) < ROUNDING, "{p:?}");
        assert!(p.margin > 0.0 && p.margin <= 1.0, "{p:?}");
        let m = chain.motion(phi);
        differences(|h| chain.motion(phi + h).slide, m.v, Some(m.a), 1e-3, 100.0);
        differences(
            |h| chain.motion(phi + h).g1.x,
            m.vg.x,
            Some(m.ag.x),
            1e-3,
            100.0,
        );
        differences(
            |h| chain.motion(phi + h).g1.y,
            m.vg.y,
            Some(m.ag.y),
            1e-3,
            100.0,
        );
    }
    let phi = 1.2;
    let by = chain.accuracy(phi);
    let at = |crank, rocker| {
        let other = Chain { crank, rocker }.assemble().expect("it closes");
        (other.motion(phi).slide, other.motion(phi).g1.y)
    };
    differences(|h| at(15.0 + h, 40.0).0, by.e[0], None, 1e-3, 10.0);
    differences(|h| at(15.0, 40.0 + h).0, by.e[1], None, 1e-3, 10.0);
    differences(|h| at(15.0 + h, 40.0).1, by.g[0].y, None, 1e-3, 10.0);
    differences(|h| at(15.0, 40.0 + h).1, by.g[1].y, None, 1e-3, 10.0);
}

linkage_interpreted::interpreted! {
    /// Guides that turn and shift with the input, and one on a rocker.
    struct MovingGuides {
        unit mm;
        param length = 125mm;
        param swing = 10deg;
        input phi = 30deg in 0deg..360deg;
        unknown x1 = 100deg;
        unknown x2 = -83mm;
        unknown x3 = 95mm;
        unknown theta = -47deg;
        let e1 = polar(22mm, phi) + polar(length, x1);
        let e2 = (96mm, -18mm) + polar(5mm, 2 * phi) + polar(x2, -70deg + swing * sin(phi));
        let e3 = (66mm, 81mm) + polar(x3, 85deg - swing * cos(phi));
        loop e1 + polar(102mm, theta) = e2;
        loop e1 + polar(87mm, theta + 75deg) = e3;
    }

    impl MovingGuides {
        fn position(phi) -> GuidesPosition {
            e1, miss_1: e1 + polar(102mm, theta) - e2, miss_2: e1 + polar(87mm, theta + 75deg) - e3,
        }
        fn motion(phi) -> GuidesMotion {
            x2, e1, v: velocity(e1), a: acceleration(e1), v2: velocity(x2), a2: acceleration(x2),
            by: sensitivity(x2),
        }
    }
}

#[test]
fn guides_that_move_with_the_input() {
    let guides = MovingGuides::default().assemble().expect("it closes");
    for phi in cycle() {
        let p = guides.position(phi);
        assert!(
            crate::largest([p.miss_1.norm(), p.miss_2.norm()]) < ROUNDING,
            "{p:?}"
        );
        let m = guides.motion(phi);
        differences(|h| guides.motion(phi + h).x2, m.v2, Some(m.a2), 1e-3, 100.0);
        differences(
            |h| guides.motion(phi + h).e1.y,
            m.v.y,
            Some(m.a.y),
            1e-3,
            100.0,
        );
    }
    let by = guides.motion(1.2).by;
    let at = |length, swing| {
        MovingGuides { length, swing }
            .assemble()
            .expect("it closes")
            .motion(1.2)
            .x2
    };
    let swing = 10f64.to_radians();
    differences(|h| at(125.0 + h, swing), by[0], None, 1e-3, 10.0);
    differences(|h| at(125.0, swing + h), by[1], None, 1e-4, 100.0);
}

linkage_interpreted::interpreted! {
    /// A frame of bars: no input.
    struct Frame {
        unit mm;
        param bar = 79mm;
        unknown x1 = 86deg;
        unknown x2 = -177deg;
        unknown x3 = -24deg;
        unknown link = -71deg;
        let e1 = (15mm, 9mm) + polar(bar, x1);
        let e2 = e1 + polar(110mm, link);
        let e3 = e1 + polar(107mm, link + 75deg);
        loop e2 = (126mm, -13mm) + polar(69mm, x2);
        loop e3 = (30mm, 139mm) + polar(107mm, x3);
    }

    impl Frame {
        fn joints() -> Joints { e1, e2, e3, by: sensitivity(e3), margin: margin() }
    }
}

#[test]
fn a_structure_without_input() {
    let frame = Frame::default().assemble().expect("it closes");
    let found = frame.joints();
    let length =
        |a: linkage::Vector2<f64>, x: f64, y: f64| (a - linkage::Vector2::new(x, y)).norm();
    let misses = [
        length(found.e1, 15.0, 9.0) - 79.0,
        length(found.e2, 126.0, -13.0) - 69.0,
        length(found.e3, 30.0, 139.0) - 107.0,
        (found.e2 - found.e1).norm() - 110.0,
        (found.e3 - found.e1).norm() - 107.0,
    ];
    assert!(crate::largest(misses) < ROUNDING, "{misses:?}");
    assert!(found.margin > 0.1 && found.margin <= 1.0);
    let at = |bar| Frame { bar }.assemble().expect("it closes").joints().e3;
    differences(|h| at(79.0 + h).x, found.by[0].x, None, 1e-3, 10.0);
    differences(|h| at(79.0 + h).y, found.by[0].y, None, 1e-3, 10.0);
    let all = Frame::default().assemblies().expect("it can be listed");
    assert_eq!(all.len(), 6);
    assert_eq!(all[0].joints().e1, found.e1);
}
