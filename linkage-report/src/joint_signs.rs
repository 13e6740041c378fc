//! The table of joints in space: their names and signs in drawings, data and pages.

use serde_json::{Map, Value, json};
use std::string::String;

use linkage_core::JointShape;

/// The name and the sign of a kind of joint.
pub(super) struct JointSign {
    /// The name in data and on pages.
    pub(super) name: &'static str,
    /// The class in drawings; `None` for a joint without a sign, whose block is drawn.
    pub(super) class: Option<&'static str>,
    /// True for a joint that turns.
    pub(super) turns: bool,
    /// True for a ring around the mark of the point.
    pub(super) ring: bool,
    /// True for a filled mark of the point.
    pub(super) filled: bool,
    /// The directions of the bars.
    pub(super) directions: Directions,
    /// The shape of the bars.
    pub(super) bar: Bar,
}

/// The directions in which a sign has bars.
#[derive(Clone, Copy)]
pub(super) enum Directions {
    /// A sign without bars.
    None,
    /// The first axis through the point.
    FirstAxis,
    /// All axes through the point.
    AllAxes,
    /// The line of the guide, or the first axis if there is no guide.
    Guide,
}

/// The shape of a bar through the point.
#[derive(Clone, Copy)]
pub(super) enum Bar {
    /// A piece of a tube.
    Sleeve,
    /// A longer piece, along which the joint slides.
    LongSleeve,
    /// A line, one arm of a cross.
    Line,
}

impl Directions {
    const fn name(self) -> &'static str {
        match self {
            Self::None => "none",
            Self::FirstAxis => "first axis",
            Self::AllAxes => "all axes",
            Self::Guide => "guide",
        }
    }
}

impl Bar {
    const fn name(self) -> &'static str {
        match self {
            Self::Sleeve => "sleeve",
            Self::LongSleeve => "long sleeve",
            Self::Line => "line",
        }
    }
}

/// All kinds of joints that pictures have.
pub(super) const ALL_SHAPES: [JointShape; 5] = [
    JointShape::Pin,
    JointShape::Slide,
    JointShape::Ball,
    JointShape::Universal,
    JointShape::Cylindrical,
];

/// Returns the name and the sign of a kind of joint.
pub(super) const fn sign(shape: JointShape) -> JointSign {
    match shape {
        JointShape::Pin => JointSign {
            name: "pin",
            class: Some("hinge"),
            turns: true,
            ring: false,
            filled: false,
            directions: Directions::FirstAxis,
            bar: Bar::Sleeve,
        },
        JointShape::Slide => JointSign {
            name: "slide",
            class: None,
            turns: false,
            ring: false,
            filled: false,
            directions: Directions::None,
            bar: Bar::Sleeve,
        },
        JointShape::Ball => JointSign {
            name: "ball",
            class: Some("ball"),
            turns: true,
            ring: true,
            filled: true,
            directions: Directions::None,
            bar: Bar::Sleeve,
        },
        JointShape::Universal => JointSign {
            name: "universal",
            class: Some("universal"),
            turns: true,
            ring: true,
            filled: false,
            directions: Directions::AllAxes,
            bar: Bar::Line,
        },
        JointShape::Cylindrical => JointSign {
            name: "cylindrical",
            class: Some("cylindrical"),
            turns: true,
            ring: false,
            filled: false,
            directions: Directions::Guide,
            bar: Bar::LongSleeve,
        },
    }
}

/// Returns the constant of the page's script with the signs of these joints.
pub(super) fn page_constant(shapes: impl Iterator<Item = JointShape>) -> String {
    let signs = shapes.map(sign);
    let table: Map<String, Value> = signs
        .map(|sign| {
            let value = json!({
                "drawn": sign.class.is_some(),
                "turns": sign.turns,
                "ring": sign.ring,
                "filled": sign.filled,
                "directions": sign.directions.name(),
                "bar": sign.bar.name(),
            });
            (String::from(sign.name), value)
        })
        .collect();
    std::format!("const JOINT_SIGNS = {};\n", Value::from(table))
}

#[cfg(test)]
mod tests {
    use super::*;

    const SCRIPT: &str = include_str!("page/signs.js");

    /// Scripts read the table: no other place has the names of joints.
    #[test]
    fn scripts_name_no_joint() {
        for shape in ALL_SHAPES {
            let quoted = std::format!("\"{}\"", sign(shape).name);
            for script in [SCRIPT, include_str!("page/points.js")] {
                assert!(!script.contains(&quoted), "{quoted}");
            }
        }
    }

    #[test]
    fn the_page_has_all_directions_and_bars_of_the_table() {
        for shape in ALL_SHAPES {
            let JointSign {
                directions, bar, ..
            } = sign(shape);
            for name in [directions.name(), bar.name()] {
                assert!(SCRIPT.contains(name), "{name}");
            }
        }
    }

    #[test]
    fn the_constant_has_the_joints_that_are_drawn() {
        const SHAPES: [JointShape; 2] = [JointShape::Pin, JointShape::Slide];
        let constant = page_constant(SHAPES.into_iter());
        assert!(constant.starts_with("const JOINT_SIGNS = {\"pin\":{"));
        assert!(
            constant
                .contains("\"slide\":{\"bar\":\"sleeve\",\"directions\":\"none\",\"drawn\":false")
        );
        assert_eq!(page_constant([].into_iter()), "const JOINT_SIGNS = {};\n");
    }
}
