//! Parts that stand elsewhere are drawn where they stand: each point of the part alone, turned and moved by hand.

use std::f64::consts::FRAC_PI_2;

use linkage::{GuideOn, Picture, Vector3, mechanism};

use super::expect_rigid;

type Outcome = Result<(), Box<dyn std::error::Error>>;

mechanism! {
    /// A slider-crank with a point on its rod.
    pub struct Press {
        unit mm;
        param crank = 40mm;
        param rod = 120mm;
        param offset = 5mm;
        input phi = 30deg in 0deg..360deg;
        unknown theta = -10deg;
        unknown slide = 150mm;
        let pin = polar(crank, phi);
        loop pin + polar(rod, theta) = (slide, offset);
        let oiler = pin + polar(60mm, theta) + polar(15mm, theta + 90deg);
    }
    impl Press { pub fn look(phi) -> PressLook { shape: picture() } }

    /// Two pivots of the frame, a coupler, and a slot on it.
    pub struct FourBar {
        unit mm;
        param ground = (140mm, 10mm);
        param crank = 50mm;
        param coupler = 120mm;
        param rocker = 100mm;
        input phi = 30deg in 0deg..360deg;
        unknown theta = 10deg;
        unknown psi = 80deg;
        let pin = polar(crank, phi);
        let knee = pin + polar(coupler, theta);
        loop knee = ground + polar(rocker, psi);
    }
    impl FourBar { pub fn look(phi) -> FourBarLook { shape: picture() } }

    /// A station is a four-bar with a press that stands beside it.
    pub struct Station {
        unit mm;
        input phi = 30deg in 0deg..360deg;
        part bars: FourBar { phi = phi };
        part press: Press { phi = -phi } at (30mm, -80mm), turned by -20deg;
        let reach = press.oiler - bars.knee;
    }

    pub struct Hall {
        unit mm;
        param place = (300mm, 100mm);
        input shaft = 30deg in 0deg..360deg;
        part left: Press { phi = shaft };
        part right: Station { phi = shaft } at place, turned by 35deg;
        let gap = right.press.oiler - left.oiler;
    }
    impl Hall { pub fn look(shaft) -> HallLook { shape: picture() } }

    /// A four-bar whose fixed link is the coupler of another one.
    pub struct Carried {
        unit mm;
        input shaft = 30deg in 0deg..360deg;
        part base: FourBar { phi = shaft };
        let seat = base.pin + polar(40mm, base.theta + 30deg);
        part small: FourBar { phi = 2 * shaft, ground = (28mm, 2mm), crank = 10mm, coupler = 24mm, rocker = 20mm }
            at seat, turned by base.theta;
    }
    impl Carried { pub fn look(shaft) -> CarriedLook { shape: picture(), seat, theta: base.theta } }

    /// A press on the same coupler: its cylinder goes along.
    pub struct Riding {
        unit mm;
        input shaft = 30deg in 0deg..360deg;
        part base: FourBar { phi = shaft };
        part ram: Press { phi = shaft, crank = 4mm, rod = 12mm, offset = 1mm } at base.knee, turned by base.theta + 90deg;
    }
    impl Riding { pub fn look(shaft) -> RidingLook { shape: picture(), knee: base.knee, theta: base.theta } }

    /// With bodies and joints.
    pub struct Lever {
        unit mm;
        input phi = 0deg in 0deg..360deg;
        let tip = (20mm, 0mm) + polar(15mm, phi);
        body lever = pin hub on frame at (20mm, 0mm), turns phi, mass 20g at tip;
    }
    pub struct Beam {
        unit mm;
        input shaft = 0deg in 0deg..360deg;
        let head = polar(50mm, shaft);
        body beam = pin pivot on frame at (0mm, 0mm), turns shaft, mass 1kg at 0.5 * head;
        part lever: Lever { phi = 3 * shaft } at head, turned by shaft, on beam;
    }
    impl Beam { pub fn look(shaft) -> BeamLook { shape: picture() } }

    /// In space: a crank on an axis of its own, and a ball on a straight guide.
    pub struct Rssp {
        unit mm;
        param crank = 40mm;
        param rod = 150mm;
        input phi = 30deg in 0deg..360deg;
        unknown s = 140mm;
        let pin = turn((0mm, crank, 0mm), (1, 0, 0), phi);
        let slider = (s, 20mm, 0mm);
        loop distance(pin, slider) = rod;
    }
    impl Rssp { pub fn look(phi) -> RsspLook { shape: picture() } }

    pub struct Tilted {
        unit mm;
        input shaft = 30deg in 0deg..360deg;
        part near: Rssp { phi = shaft };
        part far: Rssp { phi = shaft + 90deg } at frame((10mm, 200mm, -30mm), (0, 3, 4), (1, 0, 0));
        let gap = far.pin - near.pin;
    }
    impl Tilted { pub fn look(shaft) -> TiltedLook { shape: picture() } }
}

fn index(picture: &Picture, name: &str) -> usize {
    let mut points = picture.points.iter();
    let found = points.position(|point| point.name == name);
    found.unwrap_or_else(|| panic!("{name}: {:?}", picture.points))
}

/// The link that joins these points and no others.
#[track_caller]
fn expect_link(picture: &Picture, names: &[String]) {
    let mut points: Vec<usize> = names.iter().map(|name| index(picture, name)).collect();
    points.sort_unstable();
    let found = picture.links.iter().any(|link| {
        let mut own = link.points.to_vec();
        own.sort_unstable();
        own == points
    });
    assert!(found, "{names:?}: {picture:#?}");
}

#[track_caller]
fn expect_near<const N: usize>(found: [f64; N], expected: [f64; N]) {
    for (a, b) in found.iter().zip(expected) {
        assert!((a - b).abs() < 1e-11, "{found:?} {expected:?}");
    }
}

fn placed([x, y]: [f64; 2], at: [f64; 2], angle: f64) -> [f64; 2] {
    let (sin, cos) = angle.sin_cos();
    [at[0] + x * cos - y * sin, at[1] + x * sin + y * cos]
}

fn names<const N: usize>(path: &str, own: [&str; N]) -> [String; N] {
    own.map(|name| {
        let parts = name.split('/').map(|part| match part {
            "frame" => part.to_owned(),
            _ => format!("{path}.{part}"),
        });
        parts.collect::<Vec<_>>().join("/")
    })
}

const PRESS: [&str; 4] = ["crank/frame", "pin", "oiler", "rod/slide"];
const FOUR_BAR: [&str; 4] = ["crank/frame", "pin", "knee", "ground"];
const ANGLES: [f64; 5] = [0.1, 1.0, 2.5, 4.0, 6.0];

/// Beside each other, and one within another.
#[test]
fn parts_and_parts_of_parts_stand_where_they_are_written() -> Outcome {
    let (hall, press, bars) = (
        Hall::default().assemble()?,
        Press::default().assemble()?,
        FourBar::default().assemble()?,
    );
    let drawn = Hall::PICTURE;
    for phi in ANGLES {
        let shape = hall.look(phi).shape;
        let at = |name: &str| shape[index(drawn, name)].into();
        let left = press.look(phi).shape;
        for (own, name) in PRESS.iter().zip(names("left", PRESS)) {
            expect_near(at(&name), left[index(Press::PICTURE, own)].into());
        }
        let around = |p: [f64; 2]| placed(p, [300.0, 100.0], 35f64.to_radians());
        let four = bars.look(phi).shape;
        let mut own = names("right.bars", FOUR_BAR);
        own[0] = "right.at".to_owned();
        for (alone, name) in FOUR_BAR.iter().zip(own) {
            expect_near(
                at(&name),
                around(four[index(FourBar::PICTURE, alone)].into()),
            );
        }
        let inner = press.look(-phi).shape;
        let mut own = names("right.press", PRESS);
        own[0] = "right.press.at".to_owned();
        for (alone, name) in PRESS.iter().zip(own) {
            let beside = inner[index(Press::PICTURE, alone)].into();
            let beside = placed(beside, [30.0, -80.0], -20f64.to_radians());
            expect_near(at(&name), around(beside));
        }
        // The rail of the press: along the x axis of both frames.
        let rails = drawn.guides.iter().filter(|own| own.on == GuideOn::Frame);
        let along = rails.map(|own| shape[drawn.points.len() + own.direction]);
        let along: Vec<[f64; 2]> = along.map(Into::into).collect();
        assert_eq!(along.len(), 2);
        expect_near(along[0], [1.0, 0.0]);
        expect_near(along[1], placed([1.0, 0.0], [0.0, 0.0], 15f64.to_radians()));
    }
    let turn = |path: &str| names(path, ["crank/frame", "pin"]);
    expect_link(drawn, &turn("left"));
    expect_link(drawn, &["right.at".to_owned(), "right.bars.pin".to_owned()]);
    expect_link(drawn, &names("right.press", ["pin", "oiler", "rod/slide"]));
    assert!(drawn.undrawn.is_empty());
    expect_rigid(&hall.look_sweep(&Hall::INPUTS[0].positions(91)), 400.0);
    Ok(())
}

/// The pivots of the part are points of the link that carries it, and so is its rail.
#[test]
fn a_part_on_a_moving_link_goes_along() -> Outcome {
    let carried = Carried::default().assemble()?;
    let small = FourBar {
        ground: [28.0, 2.0].into(),
        crank: 10.0,
        coupler: 24.0,
        rocker: 20.0,
    };
    let small = small.assemble()?;
    let drawn = Carried::PICTURE;
    for phi in ANGLES {
        let found = carried.look(phi);
        let alone = small.look(2.0 * phi).shape;
        let mut own = names("small", FOUR_BAR);
        own[0] = "seat".to_owned();
        for (alone_name, name) in FOUR_BAR.iter().zip(own) {
            let point = alone[index(FourBar::PICTURE, alone_name)].into();
            let at = placed(point, found.seat.into(), found.theta);
            expect_near(found.shape[index(drawn, &name)].into(), at);
        }
    }
    let coupler = ["base.pin", "base.knee", "seat", "small.ground"];
    expect_link(drawn, &coupler.map(str::to_owned));
    expect_rigid(
        &carried.look_sweep(&Carried::INPUTS[0].positions(91)),
        400.0,
    );

    let riding = Riding::default().assemble()?;
    let alone = Press {
        crank: 4.0,
        rod: 12.0,
        offset: 1.0,
    }
    .assemble()?;
    let drawn = Riding::PICTURE;
    for phi in ANGLES {
        let found = riding.look(phi);
        let own = alone.look(phi).shape;
        for (alone_name, name) in PRESS.iter().zip(names("ram", PRESS)).skip(1) {
            let point = own[index(Press::PICTURE, alone_name)].into();
            let at = placed(point, found.knee.into(), found.theta + FRAC_PI_2);
            expect_near(found.shape[index(drawn, &name)].into(), at);
        }
    }
    let [rail] = drawn.guides else {
        panic!("{:?}", drawn.guides)
    };
    let GuideOn::Link(link) = rail.on else {
        panic!("{rail:?}")
    };
    assert_eq!(drawn.links[link].name, "base.coupler");
    expect_rigid(&riding.look_sweep(&Riding::INPUTS[0].positions(91)), 300.0);
    Ok(())
}

/// The body that carries a part has its pivots; the part's own bodies are its links.
#[test]
fn bodies_of_a_part_stand_on_the_body_that_carries_it() -> Outcome {
    let (beam, drawn) = (Beam::default().assemble()?, Beam::PICTURE);
    let link = |name: &str| {
        let mut links = drawn.links.iter();
        let found = links.find(|link| link.name == name).expect("a link");
        let names = found.points.iter().map(|&point| drawn.points[point].name);
        let mut names: Vec<&str> = names.collect();
        names.sort_unstable();
        names
    };
    assert_eq!(link("beam"), ["head", "lever.hub", "pivot"]);
    assert_eq!(link("lever.phi"), ["lever.hub", "lever.tip"]);
    // What carries the part is the machine's own.
    let [part] = drawn.parts else {
        panic!("{:?}", drawn.parts)
    };
    let own: Vec<&str> = part
        .links
        .iter()
        .map(|&own| drawn.links[own].name)
        .collect();
    assert_eq!(own, ["lever.phi"]);
    for phi in ANGLES {
        let shape = beam.look(phi).shape;
        let head = [50.0 * phi.cos(), 50.0 * phi.sin()];
        let tip = [20.0 + 15.0 * (3.0 * phi).cos(), 15.0 * (3.0 * phi).sin()];
        for (name, point) in [("lever.hub", [20.0, 0.0]), ("lever.tip", tip)] {
            let at = placed(point, head, phi);
            expect_near(shape[index(drawn, name)].into(), at);
        }
    }
    Ok(())
}

/// Axes and rails of space turn with the frame, which is not the one of the machine in any direction.
#[test]
fn a_part_stands_in_a_frame_of_space() -> Outcome {
    let (tilted, alone) = (Tilted::default().assemble()?, Rssp::default().assemble()?);
    let (drawn, own) = (Tilted::PICTURE, Rssp::PICTURE);
    // x along (0, 3, 4), z along (1, 0, 0), so y is z cross x.
    let axes = [[0.0, 0.6, 0.8], [0.0, -0.8, 0.6], [1.0, 0.0, 0.0]];
    let turned = |v: Vector3<f64>| {
        let v = [v.x, v.y, v.z];
        [0, 1, 2].map(|k| (0..3).map(|axis| axes[axis][k] * v[axis]).sum::<f64>())
    };
    for phi in ANGLES {
        let shape = tilted.look(phi).shape;
        let beside = alone.look(phi + FRAC_PI_2).shape;
        let points = ["crank/frame", "pin", "slider"];
        for (name, alone) in names("far", points).iter().zip(points) {
            let [x, y, z] = turned(beside[index(own, alone)]);
            let at = [x + 10.0, y + 200.0, z - 30.0];
            expect_near(shape[index(drawn, name)].into(), at);
        }
        let way = |direction: usize| shape[drawn.points.len() + direction].into();
        let far = drawn
            .axes
            .iter()
            .find(|axis| drawn.points[axis.point].name == "far.crank/frame");
        expect_near(way(far.expect("an axis").direction), axes[0]);
        let rail = drawn.guides.iter().find(|guide| guide.name == "far.s");
        expect_near(way(rail.expect("a rail").direction), axes[0]);
    }
    expect_rigid(&tilted.look_sweep(&Tilted::INPUTS[0].positions(91)), 300.0);
    Ok(())
}
