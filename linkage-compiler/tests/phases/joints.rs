//! Mechanisms that are given by joints and links, written as vectors and as points: both spellings have the same coupled
//! groups.

use std::fmt::Write;

use linkage_compiler::trace::trace;

/// A position in the drawing, in millimetres.
type Position = (f64, f64);

/// Joints by their numbers, links as lists of joints. The first `fixed` joints are on the frame.
struct Drawing {
    joints: &'static [Position],
    fixed: usize,
    links: &'static [&'static [usize]],
    /// The link that is driven about its first joint.
    crank: usize,
    /// Joints that slide on the line through two joints of a link; `FRAME` for the frame.
    slides: &'static [(usize, usize, [usize; 2])],
    /// The groups that are solved together, in both spellings.
    coupled: &'static [&'static str],
}

const FRAME: usize = usize::MAX;

fn distance(a: Position, b: Position) -> f64 {
    (b.0 - a.0).hypot(b.1 - a.1)
}

fn angle(a: Position, b: Position) -> f64 {
    (b.1 - a.1).atan2(b.0 - a.0).to_degrees()
}

/// The items of a mechanism, and the expression of each joint so far.
struct Text<'d> {
    drawing: &'d Drawing,
    items: String,
    loops: String,
    joints: Vec<Option<String>>,
}

impl<'d> Text<'d> {
    /// Joints of the frame, and those of the crank, from its angle.
    fn new(drawing: &'d Drawing) -> Self {
        let fixed = |k: usize| (k < drawing.fixed).then(|| point(drawing.joints[k]));
        let mut text = Self {
            drawing,
            items: String::new(),
            loops: String::new(),
            joints: (0..drawing.joints.len()).map(fixed).collect(),
        };
        let crank = drawing.links[drawing.crank];
        let start = angle(drawing.joints[crank[0]], drawing.joints[crank[1]]);
        let (low, high) = (start - 2.0, start + 2.0);
        let _ = writeln!(
            text.items,
            "input phi = {start:.9}deg in {low:.9}deg..{high:.9}deg;"
        );
        text.turn(drawing.crank, "phi", crank[0], start);
        text
    }

    /// Writes the joints of a link by the angle of its first side, which is drawn at `start`.
    fn turn(&mut self, link: usize, name: &str, base: usize, start: f64) {
        let at = &self.drawing.joints;
        let from = self.joints[base].clone().expect("it is known");
        for &joint in self.drawing.links[link] {
            if joint == base {
                continue;
            }
            let (length, turned) = (
                distance(at[base], at[joint]),
                angle(at[base], at[joint]) - start,
            );
            let end = format!("{from} + polar({length:.9}mm, {name} + {turned:.9}deg)");
            match &self.joints[joint] {
                Some(known) => {
                    let _ = writeln!(self.loops, "loop {end} = {known};");
                }
                None => {
                    let _ = writeln!(self.items, "let j{joint} = {end};");
                    self.joints[joint] = Some(format!("j{joint}"));
                }
            }
        }
    }

    /// Writes a joint as an unknown point.
    fn unknown(&mut self, joint: usize) {
        if self.joints[joint].is_none() {
            let drawn = point(self.drawing.joints[joint]);
            let _ = writeln!(self.items, "unknown j{joint} = {drawn};");
            self.joints[joint] = Some(format!("j{joint}"));
        }
    }

    fn joint(&self, joint: usize) -> &str {
        self.joints[joint].as_deref().expect("it is known")
    }

    fn finish(self) -> String {
        let (items, loops) = (self.items, self.loops);
        format!("pub struct M {{ unit mm; {items} {loops} }}")
    }
}

fn point((x, y): Position) -> String {
    format!("({x:.9}mm, {y:.9}mm)")
}

/// Each link turns by an angle about the joint by which it is reached first.
fn vectors(drawing: &Drawing) -> String {
    let mut text = Text::new(drawing);
    let mut angles: Vec<Option<f64>> = vec![None; drawing.links.len()];
    let crank = drawing.links[drawing.crank];
    angles[drawing.crank] = Some(angle(drawing.joints[crank[0]], drawing.joints[crank[1]]));
    while let Some(first_left) = angles.iter().position(Option::is_none) {
        let reached = |joint: &usize| text.joints[*joint].is_some();
        let mut left = (0..angles.len()).filter(|&k| angles[k].is_none());
        let link = left
            .find(|&k| drawing.links[k].iter().any(&reached))
            .unwrap_or(first_left);
        let joints = drawing.links[link];
        let base = joints.iter().copied().find(reached).unwrap_or(joints[0]);
        text.unknown(base);
        let other = joints.iter().copied().find(|joint| *joint != base);
        let other = other.expect("a link has two joints");
        let start = angle(drawing.joints[base], drawing.joints[other]);
        let name = format!("t{link}");
        let _ = writeln!(text.items, "unknown {name} = {start:.9}deg;");
        text.turn(link, &name, base, start);
        angles[link] = Some(start);
    }
    for &(pin, link, [a, b]) in drawing.slides {
        text.unknown(pin);
        let across = angle(drawing.joints[a], drawing.joints[b]) + 90.0;
        let direction = match link {
            FRAME => format!("{across:.9}deg"),
            link => format!(
                "t{link} + {:.9}deg",
                across - angles[link].expect("it is written")
            ),
        };
        let (pin, a) = (text.joint(pin), text.joint(a));
        let row = format!("loop dot({pin} - {a}, dir({direction})) = 0;\n");
        text.loops += &row;
    }
    text.finish()
}

/// Each joint is a point, each link its distances from the first two joints.
fn points(drawing: &Drawing) -> String {
    let mut text = Text::new(drawing);
    for (index, link) in drawing.links.iter().enumerate() {
        if index == drawing.crank {
            continue;
        }
        link.iter().for_each(|&joint| text.unknown(joint));
        for (k, &joint) in link.iter().enumerate() {
            for &other in &link[..k.min(2)] {
                let length = distance(drawing.joints[other], drawing.joints[joint]);
                let (from, to) = (text.joint(other), text.joint(joint));
                let row = format!("loop distance({from}, {to}) = {length:.9}mm;\n");
                text.loops += &row;
            }
        }
    }
    for &(pin, _, [a, b]) in drawing.slides {
        text.unknown(pin);
        let [pin, a, b] = [pin, a, b].map(|joint| text.joint(joint));
        let row = format!("loop cross({pin} - {a}, {b} - {a}) = 0;\n");
        text.loops += &row;
    }
    text.finish()
}

/// The kinds of the coupled groups of a mechanism, in order.
fn coupled(text: &str) -> Vec<String> {
    let trace = trace(text.parse().expect("tokens"));
    // A range may be too large for the drawing; other mistakes leave no groups.
    assert!(!trace.formulate.is_empty(), "{:?}: {text}", trace.messages);
    let groups = trace.formulate.lines();
    let groups = groups.filter(|line| line.contains("assemblies listed"));
    groups
        .filter_map(|line| Some(line.split_once(", class")?.0.to_owned()))
        .collect()
}

#[track_caller]
fn same_groups(drawing: &Drawing) {
    for text in [vectors(drawing), points(drawing)] {
        assert_eq!(coupled(&text), drawing.coupled, "{text}");
    }
}

/// The joints of a walking leg.
const LEG: [(f64, f64); 10] = [
    (171.60, -290.48),
    (256.00, -187.00),
    (162.60, -192.48),
    (349.00, -374.00),
    (306.00, -563.00),
    (349.90, -330.02),
    (146.00, -307.00),
    (172.50, -246.50),
    (137.00, -209.00),
    (256.24, -163.97),
];

/// A walking leg, driven by its crank.
#[test]
fn a_leg_of_three_ternary_links() {
    same_groups(&Drawing {
        joints: &LEG,
        fixed: 2,
        links: &[
            &[0, 2, 3],
            &[4, 5, 3],
            &[6, 7, 0],
            &[8, 9, 2],
            &[6, 8],
            &[5, 7],
            &[1, 9],
        ],
        crank: 6,
        slides: &[],
        coupled: &[],
    });
}

/// Five dyads; the long way round leads through a quadrilateral.
#[test]
fn a_folding_roof() {
    same_groups(&Drawing {
        joints: &[
            (534.00, -474.00),
            (510.00, -414.00),
            (521.00, -446.00),
            (620.00, -549.00),
            (507.00, -241.00),
            (502.00, -322.00),
            (552.00, -372.00),
            (448.50, -240.50),
            (306.00, -266.00),
            (281.00, -246.00),
            (212.00, -273.00),
            (267.00, -273.50),
            (439.00, -194.00),
            (279.00, -235.00),
            (598.00, -492.00),
        ],
        fixed: 4,
        links: &[
            &[0, 4],
            &[1, 5, 7, 12],
            &[2, 6],
            &[6, 5],
            &[8, 7, 4, 9],
            &[10, 11, 9],
            &[13, 11],
            &[8, 13],
            &[12, 13],
            &[3, 14],
            &[6, 14],
        ],
        crank: 9,
        slides: &[],
        coupled: &[],
    });
}

/// A plate with a slot on two pins of the frame, its end in the slot of a rocker.
#[test]
fn a_plate_on_two_pins() {
    same_groups(&Drawing {
        joints: &[
            (301.98, -236.00),
            (361.95, -236.00),
            (605.00, -190.00),
            (437.00, -309.00),
            (238.00, -236.00),
            (339.00, -192.00),
            (437.00, -236.00),
            (605.00, -130.00),
            (437.00, -205.00),
        ],
        fixed: 4,
        links: &[&[4, 5, 6], &[2, 7], &[3, 8], &[7, 8]],
        crank: 1,
        slides: &[(6, 2, [3, 8]), (0, 0, [4, 6]), (1, 0, [4, 6])],
        coupled: &[],
    });
}

/// Two pins of cranks in the slot of a lever.
#[test]
fn two_cranks_in_blocks_of_one_lever() {
    same_groups(&Drawing {
        joints: &[
            (4.98, 0.84),
            (1.40, 0.66),
            (-1.83, 3.80),
            (1.05, 2.55),
            (2.74, 1.81),
        ],
        fixed: 2,
        links: &[&[0, 2], &[1, 3], &[1, 4]],
        crank: 1,
        slides: &[(3, 0, [0, 2]), (4, 0, [0, 2])],
        coupled: &[],
    });
}

/// Five dyads near a change point.
#[test]
fn folding_levers() {
    same_groups(&Drawing {
        joints: &[
            (17.0000, -19.0000),
            (17.0000, -107.0833),
            (42.0000, -45.2500),
            (75.5000, -45.0000),
            (108.8819, -45.0000),
            (160.5000, -44.7500),
            (75.2500, -80.0000),
            (132.8819, -21.5972),
            (185.4653, -21.1736),
            (108.7917, -80.2917),
            (76.3043, -104.3817),
            (132.0260, -104.8377),
            (221.6968, -20.8773),
        ],
        fixed: 2,
        links: &[
            &[0, 2, 6],
            &[1, 3],
            &[1, 10],
            &[2, 3],
            &[3, 9, 11],
            &[3, 4, 5],
            &[4, 6, 7],
            &[5, 8],
            &[6, 9],
            &[7, 8, 12],
            &[10, 11],
        ],
        crank: 0,
        slides: &[],
        coupled: &[],
    });
}

/// The leg driven by another link: a triad remains.
#[test]
fn a_leg_driven_by_its_shank() {
    same_groups(&Drawing {
        joints: &LEG,
        fixed: 2,
        links: &[
            &[0, 2, 3],
            &[4, 5, 3],
            &[0, 6, 7],
            &[8, 9, 2],
            &[6, 8],
            &[5, 7],
            &[1, 9],
        ],
        crank: 2,
        slides: &[],
        coupled: &["RR-RR-RR"],
    });
}

/// A six-bar driven by the crank that is no part of its four-bar.
#[test]
fn a_six_bar_driven_by_its_far_crank() {
    same_groups(&Drawing {
        joints: &[
            (-3.18, -1.21),
            (3.46, -1.00),
            (6.43, 4.51),
            (-2.69, 2.69),
            (3.18, 3.23),
            (0.30, 2.97),
            (0.87, 6.94),
        ],
        fixed: 3,
        links: &[&[0, 3], &[3, 4, 5], &[4, 1], &[5, 6], &[2, 6]],
        crank: 4,
        slides: &[],
        coupled: &["RR-RR-RR"],
    });
}
