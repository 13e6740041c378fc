//! Burmester's problem: a body is to take five poses. All links that lead it through them, and all four-bars of two links.
//!
//! There are four links at most; here all are real, and there are six four-bars. Five of them pass the poses in their order
//! without being taken apart, three of those with a crank. The links are compared with numbers of 18 digits from resultants
//! with 90; each four-bar is compiled as a mechanism, too, whose assemblies at its crank's angles have the poses.
//!
//! The picture `target/burmester.svg` has poses, links and the centre-point curve of the first four poses, on which the four
//! fixed joints are.

use crate::check::Check;
use crate::folders;
use linkage::design::exact::{CentreCurve, Dyads, FourBar, Pose};
use std::error::Error;
use std::fmt::Write;

include!("../../mechanisms/burmester.rs");

/// In millimetres and degrees.
const POSES: [([f64; 2], f64); 5] = [
    ([-18.0, 54.9], 54.6),
    ([38.9, 77.8], 69.1),
    ([89.3, 141.0], 57.6),
    ([99.7, 204.2], 32.7),
    ([42.5, 196.5], 24.3),
];

/// Fixed joint and moving joint of the links, computed with 90 digits.
const LINKS: [[f64; 4]; 4] = [
    [
        -0.34438488702861586,
        -0.023792060701033655,
        -118.40636357239248,
        -73.34809603273813,
    ],
    [
        288.461660569115,
        0.33740748590341435,
        110.00541869458759,
        -72.86276766285538,
    ],
    [
        364.3173879911415,
        202.37622060485066,
        273.2740368535989,
        -197.70304672845253,
    ],
    [
        569.461884969872,
        -363.8885050236603,
        145.79617634946584,
        153.21864505210365,
    ],
];

#[test]
fn known_answers_are_met() -> Result<(), Box<dyn Error>> {
    let mut check = Check::default();
    let poses = POSES.map(|(point, angle)| Pose::new(point, angle.to_radians()));
    let dyads = Dyads::of_poses(&poses)?;

    println!("Links through five poses, in mm:");
    check.holds(
        "four real links, shown to be all",
        dyads.certified && dyads.links().count() == 4,
    );
    for (link, known) in dyads.links().zip(LINKS) {
        let numbers = [link.fixed, link.moving].concat();
        println!(
            "  from {:?} to {:?} of the body, length {:.6}",
            link.fixed,
            link.moving,
            link.length(&poses[0])
        );
        check.all_near("  joints", numbers.into_iter().zip(known), 1e-10);
        let length = link.length(&poses[0]);
        let lengths = poses.map(|pose| (link.length(&pose) / length, 1.0));
        check.all_near("  length in all poses, relative", lengths, 1e-13);
    }

    let four_bars = dyads.four_bars();
    check.holds("six four-bars", four_bars.len() == 6);
    let mut in_order = 0;
    for four_bar in &four_bars {
        let passage = four_bar.passage(&poses);
        let [frame, crank, coupler, rocker] = four_bar.lengths(&poses[0]);
        println!(
            "  frame {frame:.1}, link 0 {crank:.1}, coupler {coupler:.1}, link 1 {rocker:.1}: {:?}, one circuit: {}, in order: {}, \
             driven by link 0 without a dead point: {}",
            four_bar.turning(&poses[0]),
            passage.one_circuit(),
            passage.in_order,
            passage.one_branch(0),
        );
        in_order += usize::from(passage.in_order);
        check.all_near(
            "  angles of the coupler, as compiled",
            compiled(four_bar, &poses)?,
            1e-10,
        );
        check.holds(
            "  circuits as of the compiled mechanism",
            same_circuits(four_bar, &poses)?,
        );
    }
    check.holds("five of them pass the poses in their order", in_order == 5);

    let curve = CentreCurve::of_poses(&[poses[0], poses[1], poses[2], poses[3]])?;
    let pole = curve.pole();
    let ways = dyads.links().map(|link| {
        let [x, y] = link.fixed;
        let places = curve
            .points_at((y - pole[1]).atan2(x - pole[0]))
            .into_iter();
        let ways = places.map(|own| (own.pivots.fixed[0] - x).hypot(own.pivots.fixed[1] - y));
        (ways.fold(f64::INFINITY, f64::min), 0.0)
    });
    check.all_near("fixed joints on the curve of four poses", ways, 1e-9);
    let path = folders::target("burmester.svg");
    std::fs::write(&path, picture(&poses, &dyads, &curve))?;
    println!("{}", path.display());
    check.finish()
}

/// Angles of link 0 and of the coupler in a pose, against the frame.
fn angles(four_bar: &FourBar, pose: &Pose) -> [f64; 2] {
    let ([a, b], [x, y]) = (
        four_bar.fixed,
        four_bar.moving.map(|joint| pose.place(joint)),
    );
    let angle = |from: [f64; 2], to: [f64; 2]| (to[1] - from[1]).atan2(to[0] - from[0]);
    [angle(a, x) - angle(a, b), angle(x, y) - angle(a, b)]
}

fn guide(four_bar: &FourBar, pose: &Pose) -> Guide {
    let [frame, crank, coupler, rocker] = four_bar.lengths(pose).map(|length| 0.001 * length);
    Guide {
        frame,
        crank,
        coupler,
        rocker,
    }
}

/// For each pose, how far the nearest assembly of the compiled mechanism is from it.
fn compiled(four_bar: &FourBar, poses: &[Pose]) -> Result<Vec<(f64, f64)>, Box<dyn Error>> {
    let mut differences = Vec::new();
    for pose in poses {
        let [phi, theta] = angles(four_bar, pose);
        let assemblies = guide(four_bar, pose).assemblies_at(phi)?;
        let ways = assemblies
            .iter()
            .map(|assembly| (0.5 * (assembly.coupler(phi).theta - theta)).sin().abs());
        differences.push((ways.fold(f64::INFINITY, f64::min), 0.0));
    }
    Ok(differences)
}

/// Whether `circuits()` of the compiled mechanism tells the same poses to be on one circuit.
fn same_circuits(four_bar: &FourBar, poses: &[Pose]) -> Result<bool, Box<dyn Error>> {
    let circuits = guide(four_bar, &poses[0]).circuits()?;
    let mut own = Vec::new();
    for pose in poses {
        let [phi, theta] = angles(four_bar, pose);
        let branch = circuits.branches.iter().find(|branch| {
            let found = branch.assembly.coupler(phi).theta;
            let [low, high] = [branch.ends[0].x(), branch.ends[1].x()];
            (low..=high).contains(&phi) && (0.5 * (found - theta)).sin().abs() < 1e-9
        });
        own.push(branch.ok_or("a pose is on no branch")?.circuit);
    }
    let one = own.iter().all(|&circuit| circuit == own[0]);
    Ok(one == four_bar.passage(poses).one_circuit())
}

/// Poses as arrows, links in the first pose, the curve of the first four poses as points.
fn picture(poses: &[Pose], dyads: &Dyads, curve: &CentreCurve) -> String {
    let mut svg = String::from(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"-250 -600 900 1100\" fill=\"none\" stroke=\"black\">\n",
    );
    let mut line = |[a, b]: [f64; 2], [c, d]: [f64; 2], colour: &str| {
        let _ = writeln!(
            svg,
            "<path d=\"M{a:.2} {:.2}L{c:.2} {:.2}\" stroke=\"{colour}\" stroke-width=\"2\"/>",
            -b, -d
        );
    };
    for pose in poses {
        line(pose.point, pose.place([60.0, 0.0]), "#c0392b");
        line(pose.point, pose.place([0.0, 20.0]), "#c0392b");
    }
    for link in dyads.links() {
        line(link.fixed, poses[0].place(link.moving), "#2c3e50");
    }
    for point in curve.points(720) {
        let [x, y] = point.pivots.fixed;
        let _ = writeln!(
            svg,
            "<circle cx=\"{x:.2}\" cy=\"{:.2}\" r=\"1.5\" stroke=\"#2980b9\"/>",
            -y
        );
    }
    svg.push_str("</svg>\n");
    svg
}
