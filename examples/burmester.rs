//! Burmester's problem: a body is to take five poses. A synthesis finds all links that lead it through them, and all
//! four-bars of two links.
//!
//! There are four links at most; here all are real, and there are six four-bars. Five of them pass the poses in their order
//! without being taken apart. `cargo example burmester --features design` runs this example.

mod check;

use check::Check;
use linkage::design::exact::{Dyads, Pose};
use std::error::Error;

include!("../mechanisms/burmester.rs");

/// In millimetres and degrees.
const POSES: [([f64; 2], f64); 5] = [
    ([-18.0, 54.9], 54.6),
    ([38.9, 77.8], 69.1),
    ([89.3, 141.0], 57.6),
    ([99.7, 204.2], 32.7),
    ([42.5, 196.5], 24.3),
];

/// The fixed joints of the links, computed with 90 digits.
const FIXED: [[f64; 2]; 4] = [
    [-0.34438488702861586, -0.023792060701033655],
    [288.461660569115, 0.33740748590341435],
    [364.3173879911415, 202.37622060485066],
    [569.461884969872, -363.8885050236603],
];

fn main() -> Result<(), Box<dyn Error>> {
    let mut check = Check::default();
    let poses = POSES.map(|(point, angle)| Pose::new(point, angle.to_radians()));
    let dyads = Dyads::of_poses(&poses)?;

    println!("Links through five poses, in mm:");
    let all = dyads.certified && dyads.links().count() == 4;
    check.holds("four real links, and no others", all);
    for (link, known) in dyads.links().zip(FIXED) {
        let length = link.length(&poses[0]);
        println!("  from {:?} to {:?} of the body", link.fixed, link.moving);
        check.all_near("  fixed joint", link.fixed.into_iter().zip(known), 1e-10);
        let lengths = poses.map(|pose| (link.length(&pose), length));
        check.all_near("  length in all poses", lengths, 1e-10);
    }

    println!("Four-bars of two links:");
    let four_bars = dyads.four_bars();
    check.holds("six four-bars", four_bars.len() == 6);
    for four_bar in &four_bars {
        let passage = four_bar.passage(&poses);
        println!(
            "  {:?}, one circuit: {}, in order: {}, without a dead point: {}",
            four_bar.turning(&poses[0]),
            passage.one_circuit(),
            passage.in_order,
            passage.one_branch(0),
        );
    }
    let passages = four_bars.iter().map(|four_bar| four_bar.passage(&poses));
    let in_order = passages.filter(|passage| passage.in_order).count();
    check.holds("five pass the poses in their order", in_order == 5);

    println!("The first four-bar as a compiled mechanism, in the third pose:");
    let (four_bar, pose) = (&four_bars[0], &poses[2]);
    let [frame, crank, coupler, rocker] = four_bar.lengths(pose).map(|length| 1e-3 * length);
    let guide = Guide {
        frame,
        crank,
        coupler,
        rocker,
    };
    let angle = |from: [f64; 2], to: [f64; 2]| (to[1] - from[1]).atan2(to[0] - from[0]);
    let ([a, b], [x, y]) = (
        four_bar.fixed,
        four_bar.moving.map(|joint| pose.place(joint)),
    );
    let [phi, theta] = [angle(a, x), angle(x, y)].map(|own| own - angle(a, b));
    let assemblies = guide.assemblies_at(phi)?;
    let differences = assemblies.iter().map(|assembly| {
        let difference = assembly.coupler(phi).theta - theta;
        (0.5 * difference).sin().abs()
    });
    let least = differences.fold(f64::INFINITY, f64::min);
    check.near("angle of the coupler, rad", least, 0.0, 1e-10);
    check.finish()
}
