//! Drawings as DXF, read back by a library that other programs read it with.

use crate::fixture::{FourBar, PHI, curved_slots, quick_return, spatial};
use crate::four_bar;
use dxf::entities::EntityType;
use dxf::{Drawing, Point};
use linkage_report::Report;
use linkage_runtime::Table;
use std::collections::BTreeSet;
use std::f64::consts::TAU;

fn read(text: &str) -> Drawing {
    Drawing::load(&mut text.as_bytes()).expect("a program reads it")
}

fn on<'a>(drawing: &'a Drawing, layer: &str) -> Vec<&'a EntityType> {
    let entities = drawing.entities();
    let entities = entities.filter(|entity| entity.common.layer == layer);
    entities.map(|entity| &entity.specific).collect()
}

fn place(point: &Point) -> [f64; 3] {
    [point.x, point.y, point.z]
}

/// Both ends of lines, all corners of polylines.
fn corners(entity: &EntityType) -> Vec<[f64; 3]> {
    match entity {
        EntityType::Line(line) => vec![place(&line.p1), place(&line.p2)],
        EntityType::Polyline(line) => line.vertices().map(|v| place(&v.location)).collect(),
        other => panic!("{other:?} has no corners"),
    }
}

/// Places of points and names, in their order.
fn points(drawing: &Drawing) -> Vec<[f64; 3]> {
    let points = on(drawing, "joints").into_iter();
    let points = points.filter_map(|entity| match entity {
        EntityType::ModelPoint(point) => Some(place(&point.location)),
        _ => None,
    });
    points.collect()
}

fn words(drawing: &Drawing) -> Vec<String> {
    let texts = on(drawing, "names").into_iter();
    let texts = texts.filter_map(|entity| match entity {
        EntityType::Text(text) => Some(text.value.clone()),
        _ => None,
    });
    texts.collect()
}

fn flat([x, y]: [f64; 2]) -> [f64; 3] {
    [x, y, 0.0]
}

/// Unordered, to the last bit.
fn set(places: &[[f64; 3]]) -> BTreeSet<[u64; 3]> {
    // A zero has no sign in places.
    let bits = |place: &[f64; 3]| place.map(|x| (x + 0.0).to_bits());
    places.iter().map(bits).collect()
}

#[test]
fn every_place_is_that_of_the_picture_to_the_last_digit() {
    let report = four_bar(FourBar::NOMINAL).trace("tracer").trace("b");
    let phi = PHI.positions(361);
    for at in [0.0, 1.0, 3.7] {
        let drawing = read(&report.drawing().unwrap().position(at).dxf().unwrap());
        let row = at.to_degrees().round() as usize;
        let here = FourBar::NOMINAL.points(phi[row]).map(flat);
        assert_eq!(points(&drawing), here);
        let links: Vec<_> = on(&drawing, "links").into_iter().map(corners).collect();
        assert_eq!(links.len(), 3);
        assert_eq!(links[0], [here[0], here[2]]);
        assert_eq!(set(&links[1]), set(&[here[2], here[3], here[4]]));
        assert_eq!(links[2], [here[1], here[3]]);
        let paths: Vec<_> = on(&drawing, "paths").into_iter().map(corners).collect();
        for (path, point) in paths.iter().zip([4, 3]) {
            let whole: Vec<_> = phi
                .iter()
                .map(|phi| flat(FourBar::NOMINAL.points(*phi)[point]))
                .collect();
            assert_eq!(*path, whole);
        }
        assert_eq!(paths.len(), 2);
    }
    let drawing = read(&report.drawing().unwrap().position(1.0).dxf().unwrap());
    assert_eq!(
        words(&drawing),
        [
            "pivot_a",
            "pivot_d",
            "a",
            "b",
            "tracer",
            "phi = 57 deg, lengths in mm"
        ]
    );
    let bare = report.drawing().unwrap().names(false).dxf().unwrap();
    assert_eq!(words(&read(&bare)), ["phi = 29 deg, lengths in mm"]);
    let circles = on(&drawing, "joints").into_iter();
    let circles = circles.filter(|entity| matches!(entity, EntityType::Circle(_)));
    assert_eq!(circles.count(), 4, "a tip is none");
}

#[test]
fn there_is_a_layer_for_each_kind() {
    let text = four_bar(FourBar::NOMINAL).drawing().unwrap().dxf().unwrap();
    let drawing = read(&text);
    let layers: Vec<&str> = drawing.layers().map(|layer| layer.name.as_str()).collect();
    for name in [
        "links", "joints", "paths", "guides", "gears", "axes", "names",
    ] {
        assert!(layers.contains(&name), "{name} is not among {layers:?}");
    }
    let again = four_bar(FourBar::NOMINAL).drawing().unwrap().dxf().unwrap();
    assert_eq!(text, again, "the same report is the same file");
    assert!(text.is_ascii() && text.lines().count().is_multiple_of(2));
}

#[test]
fn gaps_break_paths() {
    let drawing = read(&four_bar(FourBar::GAPPED).drawing().unwrap().dxf().unwrap());
    let paths: Vec<_> = on(&drawing, "paths").into_iter().map(corners).collect();
    assert_eq!(paths.len(), 2);
    let known = |phi: &f64| FourBar::GAPPED.points(*phi)[4][0].is_finite();
    let known = PHI.positions(361).iter().filter(|phi| known(phi)).count();
    assert_eq!(paths[0].len() + paths[1].len(), known);
    assert!(paths.iter().flatten().flatten().all(|x| x.is_finite()));
}

#[test]
fn sliders_stand_on_their_guides() {
    let phi = PHI.positions(361);
    let report = Report::new("Shaper", &PHI, &phi).table(&quick_return(&phi));
    let drawing = read(&report.drawing().unwrap().position(2.0).dxf().unwrap());
    let guides: Vec<_> = on(&drawing, "guides").into_iter().map(corners).collect();
    // A line and a block each for the slot and the way, the cylinder from end to end.
    let sizes: Vec<usize> = guides.iter().map(Vec::len).collect();
    assert_eq!(sizes, [2, 4, 2, 4, 2]);
    let [.., pin, _, ram] = points(&drawing)[..] else {
        panic!("points")
    };
    let middle =
        |block: &[[f64; 3]]| [0, 1].map(|k| block.iter().map(|at| at[k]).sum::<f64>() / 4.0);
    for (block, slider) in [(&guides[1], pin), (&guides[3], ram)] {
        let [x, y] = middle(block);
        assert!((x - slider[0]).hypot(y - slider[1]) < 1e-12, "{block:?}");
    }
    assert!(
        guides[2].iter().all(|end| end[1] == 150.0),
        "{:?}",
        guides[2]
    );
    let [low, high] = [guides[2][0][0], guides[2][1][0]];
    let ways = (0..361).map(|row| quick_return(&phi).column(12)[row]);
    let [least, most] = ways.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], x| {
        [low.min(x), high.max(x)]
    });
    assert!((low - least).abs() < 1e-12 && (high - most).abs() < 1e-12);
    assert_eq!(guides[4], [[-130.0, -60.0, 0.0], pin]);
}

/// Two concentric arcs with round ends each, and two circles for the ring.
#[test]
fn curved_slots_have_outlines() {
    let phi = PHI.positions(73);
    let report = Report::new("Slots", &PHI, &phi).table(&curved_slots(&phi));
    let drawing = report.drawing().unwrap().position(phi[9]);
    let drawing = read(&drawing.dxf().unwrap());
    let guides = on(&drawing, "guides").into_iter();
    let (arcs, circles): (Vec<_>, Vec<_>) =
        guides.partition(|entity| matches!(entity, EntityType::Arc(_)));
    let arcs = arcs.into_iter().map(|entity| match entity {
        EntityType::Arc(arc) => arc,
        other => panic!("{other:?}"),
    });
    let arcs: Vec<_> = arcs.collect();
    assert_eq!((arcs.len(), circles.len()), (8, 2));
    let [of_lever, of_frame] = curved_slots::PINS;
    let lever = 0.3 * phi[9].sin();
    for (arcs, radius, ends) in [
        (
            &arcs[..4],
            curved_slots::RADII[0],
            [of_lever[0] + lever, of_lever[1]],
        ),
        (&arcs[4..], curved_slots::RADII[1], of_frame),
    ] {
        let [inner, outer, first, second] = arcs else {
            panic!("{arcs:?}")
        };
        assert!((inner.radius + outer.radius - 2.0 * radius).abs() < 1e-9);
        let half = 0.5 * (outer.radius - inner.radius);
        let turn = |angle: f64| angle.to_degrees().rem_euclid(360.0);
        let wanted = [ends[0] - ends[1], ends[0] + ends[1]];
        for side in [inner, outer] {
            let found = [side.start_angle, side.end_angle];
            let apart = [0, 1].map(|k| (found[k] - turn(wanted[k])).abs());
            assert!(apart.iter().all(|apart| *apart < 1e-8), "{found:?}");
        }
        // The round ends lead on from one side to the other.
        for (end, angle, begin) in [(first, wanted[0], 180.0), (second, wanted[1], 0.0)] {
            assert!((end.radius - half).abs() < 1e-9);
            let from = [end.center.x - inner.center.x, end.center.y - inner.center.y];
            let [x, y] = [radius * angle.cos(), radius * angle.sin()];
            assert!((from[0] - x).hypot(from[1] - y) < 1e-9);
            let begin = (angle.to_degrees() + begin).rem_euclid(360.0);
            assert!((end.start_angle - begin).abs() < 1e-8);
        }
    }
}

#[test]
fn space_is_not_projected() {
    let phi = PHI.positions(361);
    let report = Report::new("RSSR", &PHI, &phi)
        .table(&spatial(&phi))
        .trace("q");
    let drawing = report.drawing().unwrap().view(0.3, 0.2).position(1.0);
    let drawing = read(&drawing.dxf().unwrap());
    let sweep = spatial(&phi);
    let at = |point: usize, row: usize| [0, 1, 2].map(|k| sweep.column(3 * point + k)[row]);
    assert_eq!(points(&drawing), [0, 1, 2, 3].map(|point| at(point, 57)));
    let links: Vec<_> = on(&drawing, "links").into_iter().map(corners).collect();
    assert_eq!(links[1], [at(2, 57), at(3, 57)]);
    let paths: Vec<_> = on(&drawing, "paths").into_iter().map(corners).collect();
    let whole: Vec<_> = (0..361).map(|row| at(3, row)).collect();
    assert_eq!(paths, [whole]);
    assert!(!on(&drawing, "axes").is_empty());
}

#[test]
fn lengths_of_any_size_keep_their_digits() {
    for factor in [1e-9, 1e-3, 1e9, 1e17] {
        let huge = FourBar {
            crank: 50.0 * factor,
            coupler: 120.0 * factor,
            rocker: 100.0 * factor,
            frame: 140.0 * factor,
        };
        let phi = PHI.positions(19);
        let report = Report::new("size", &PHI, &phi).table(&huge.picture(&phi));
        let text = report
            .drawing()
            .unwrap()
            .position(TAU / 18.0)
            .dxf()
            .unwrap();
        let numbers = points(&read(&text));
        assert_eq!(numbers, huge.points(phi[1]).map(flat));
    }
}

#[test]
fn it_is_written_by_its_ending() {
    let report = four_bar(FourBar::NOMINAL);
    let folder = std::path::Path::new(env!("CARGO_TARGET_TMPDIR")).join("dxf");
    std::fs::create_dir_all(&folder).unwrap();
    let file = report
        .drawing()
        .unwrap()
        .write(folder.join("it.dxf"))
        .unwrap();
    let text = std::fs::read_to_string(file).unwrap();
    assert_eq!(text, report.drawing().unwrap().dxf().unwrap());
    let error = report.drawing().unwrap().trace("z").dxf().unwrap_err();
    assert!(
        error.to_string().starts_with("no point `z`; there is "),
        "{error}"
    );
}
