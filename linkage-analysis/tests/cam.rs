//! Profiles of cams as files, read back as other programs do.

use linkage_analysis::cam::{Cam, Follower};

/// Up and down once a turn, as a cosine.
fn motion(angle: f64) -> [f64; 4] {
    let (sin, cos) = angle.sin_cos();
    [8.0 - 8.0 * cos, 8.0 * sin, 8.0 * cos, -8.0 * sin]
}

fn outline() -> linkage_analysis::cam::Outline {
    let follower = Follower::Roller {
        base: 40.0,
        offset: 5.0,
        radius: 9.0,
    };
    let cam = Cam::new(follower, motion).expect("a cam");
    cam.profile(0.01).expect("no undercut")
}

#[test]
fn dxf_has_closed_lines_to_the_last_bit() {
    let outline = outline();
    let text = outline.dxf();
    let read = dxf::Drawing::load(&mut text.as_bytes()).expect("a drawing");
    let lines: Vec<(String, Vec<[f64; 2]>, bool)> = read
        .entities()
        .filter_map(|entity| match &entity.specific {
            dxf::entities::EntityType::Polyline(line) => {
                let points = line.vertices().map(|own| [own.location.x, own.location.y]);
                Some((
                    entity.common.layer.clone(),
                    points.collect(),
                    line.is_closed(),
                ))
            }
            _ => None,
        })
        .collect();
    let expected = [("profile", outline.points), ("pitch", outline.pitch)];
    let expected = expected.map(|(layer, points)| (layer.to_owned(), points, true));
    assert_eq!(lines, expected);
    let layers: Vec<&str> = read.layers().map(|own| own.name.as_str()).collect();
    assert!(
        layers.contains(&"profile") && !layers.contains(&"links"),
        "{layers:?}"
    );
}

#[test]
fn svg_shows_all_of_it_with_y_upwards() {
    let outline = outline();
    let text = outline.svg();
    let document = roxmltree::Document::parse(&text).expect("a picture");
    let root = document.root_element();
    let sizes = root.attribute("viewBox").expect("a view").split(' ');
    let sizes: Vec<f64> = sizes.map(|own| own.parse().expect("a number")).collect();
    let [left, top, width, height] = sizes[..] else {
        panic!("{sizes:?}")
    };
    assert_eq!(root.attribute("width"), Some(format!("{width}mm").as_str()));
    for (class, points) in [("profile", &outline.points), ("pitch", &outline.pitch)] {
        let path = document
            .descendants()
            .find(|own| own.attribute("class") == Some(class));
        let path = path.and_then(|own| own.attribute("d")).expect("a path");
        let drawn = path
            .trim_start_matches('M')
            .trim_end_matches('Z')
            .split('L');
        let drawn: Vec<[f64; 2]> = drawn
            .map(|own| {
                let (x, y) = own.split_once(' ').expect("two numbers");
                [x, y].map(|own| own.parse().expect("a number"))
            })
            .collect();
        assert_eq!(drawn, *points);
        // The group turns y upwards.
        let inside =
            |[x, y]: &[f64; 2]| *x > left && *x < left + width && -y > top && -y < top + height;
        assert!(drawn.iter().all(inside));
    }
}
