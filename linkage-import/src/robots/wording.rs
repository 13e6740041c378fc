//! Text of the language: numbers, vectors, names of a robot's bodies and joints, lists of lines.

use std::fmt::Write;

use super::analysis::Analysis;
use super::chain::Chain;
use super::model::{Body, Joint, Motion};
use crate::names::{Names, shown};
use crate::number::{plain, short};
use crate::placement::Vector;

/// The lines of a mechanism, section by section.
#[derive(Default)]
pub(super) struct Sections {
    pub(super) parameters: Vec<String>,
    pub(super) inputs: Vec<String>,
    pub(super) unknowns: Vec<String>,
    pub(super) lets: Vec<String>,
    pub(super) loops: Vec<String>,
    pub(super) bodies: Vec<String>,
    /// Quantities of the function `motion`.
    pub(super) quantities: Vec<String>,
    /// The points among them.
    pub(super) points: Vec<NamedPoint>,
    /// The points of each link, for the picture.
    pub(super) links: Vec<Vec<String>>,
    /// The same points where they are drawn, with their bodies.
    pub(super) drawn: Vec<(usize, Vector)>,
    pub(super) warnings: Vec<String>,
}

/// A point of the text, where it is drawn.
pub(super) struct NamedPoint {
    pub(super) name: String,
    /// The bodies that have it.
    pub(super) bodies: Vec<usize>,
    pub(super) at: Vector,
}

impl Sections {
    /// Adds a point to the quantities.
    pub(super) fn point(&mut self, name: String, bodies: Vec<usize>, at: Vector) {
        self.quantities.push(name.clone());
        self.points.push(NamedPoint { name, bodies, at });
    }
}

/// Names and numbers of a robot.
pub(super) struct Wording<'c> {
    pub(super) chain: &'c Chain<'c>,
    pub(super) analysis: &'c Analysis,
    /// The bodies whose joints follow others, each after the one that leads it.
    pub(super) followers: Vec<usize>,
    /// Names of bodies, of joints as coordinates, and of points of joints.
    pub(super) bodies: Vec<String>,
    pub(super) joints: Vec<String>,
    pub(super) pivots: Vec<String>,
    pub(super) names: Names,
    /// The last digit of lengths.
    digit: f64,
}

impl<'c> Wording<'c> {
    pub(super) fn new(chain: &'c Chain<'c>, analysis: &'c Analysis) -> Self {
        let mut names = Names::new();
        let robot = chain.robot;
        let joints: Vec<String> = robot
            .bodies
            .iter()
            .map(|body| match &body.joint {
                Some(joint) => names.unique(&joint.name, "joint_"),
                None => String::new(),
            })
            .collect();
        let pivots = joints.iter().map(|joint| match joint.is_empty() {
            true => String::new(),
            false => names.unique(&format!("at_{joint}"), "at_"),
        });
        let pivots = pivots.collect();
        let mut of_bodies = Names::new();
        let bodies = robot.bodies.iter().enumerate();
        let bodies = bodies.map(|(index, body)| match index {
            0 => "frame".to_owned(),
            _ => of_bodies.unique(&body.name, "body_"),
        });
        Self {
            chain,
            analysis,
            followers: followers(chain),
            bodies: bodies.collect(),
            joints,
            pivots,
            names,
            digit: match chain.size > 1e-9 {
                true => 10f64.powf(chain.size.log10().floor() - 14.0),
                // A robot of one joint.
                false => 1e-15,
            },
        }
    }

    /// Returns the name of the joint that a body hangs on after a space; nothing if a body has this
    /// name, since bodies and joints share a name space.
    pub(super) fn joint_name(&self, body: usize) -> String {
        let name = &self.joints[body];
        match self.bodies.contains(name) {
            true => String::new(),
            false => format!(" {name}"),
        }
    }

    pub(super) fn body(&self, body: usize) -> &Body {
        &self.chain.robot.bodies[body]
    }

    /// Returns true if an input moves the joint of a body.
    pub(super) fn is_input(&self, body: usize) -> bool {
        let mut inputs = self.analysis.inputs.iter();
        inputs.any(|index| self.chain.coordinates[*index].body == body)
    }

    /// A length in metres, without what rounding leaves of zero.
    pub(super) fn metres(&self, value: f64) -> String {
        format!("{}m", self.rounded(value))
    }

    fn rounded(&self, value: f64) -> String {
        let inverse = (1.0 / self.digit).round();
        let found = match self.digit < 1.0 {
            true => (value * inverse).round() / inverse,
            false => value,
        };
        plain(found)
    }

    pub(super) fn point(&self, point: &[f64]) -> String {
        let all: Vec<String> = point.iter().map(|value| self.metres(*value)).collect();
        format!("({})", all.join(", "))
    }

    pub(super) fn direction(&self, direction: &[f64]) -> String {
        let all: Vec<String> = direction
            .iter()
            .map(|value| plain((value * 1e15).round() / 1e15))
            .collect();
        format!("({})", all.join(", "))
    }

    /// The value of a joint that follows another one, as a sum of powers of a text.
    fn followed(&self, joint: &Joint, leader: &Joint, led_by: &str) -> String {
        let is_length = |joint: &Joint| matches!(joint.motion, Motion::Slide(_));
        let unit = if is_length(joint) { "m" } else { "rad" };
        let factor = match is_length(leader) {
            true => format!(" * ({led_by} / 1m)"),
            false => format!(" * ({led_by})"),
        };
        let Some((_, powers)) = &joint.follows else {
            return format!("0{unit}");
        };
        let mut text = String::new();
        for (power, coefficient) in powers.iter().enumerate() {
            if *coefficient == 0.0 {
                continue;
            }
            let sign = match (text.is_empty(), *coefficient < 0.0) {
                (true, false) => "",
                (true, true) => "-",
                (false, false) => " + ",
                (false, true) => " - ",
            };
            let is_plain = power == 1 && coefficient.abs() == 1.0;
            if is_plain && is_length(joint) == is_length(leader) && is_name(led_by) {
                let _ = write!(text, "{sign}{led_by}");
                continue;
            }
            let value = plain(coefficient.abs());
            let _ = write!(text, "{sign}{value}{unit}{}", factor.repeat(power));
        }
        match text.is_empty() {
            true => format!("0{unit}"),
            false => text,
        }
    }

    /// The lines that define the joints that follow others.
    pub(super) fn lets_of_followers(&self) -> Vec<String> {
        let line = |body: &usize| {
            let joint = self.chain.robot.bodies[*body].joint.as_ref()?;
            let (leader, _) = joint.follows.as_ref()?;
            let led_by = self.chain.robot.bodies[*leader].joint.as_ref()?;
            let text = self.followed(joint, led_by, &self.joints[*leader]);
            Some(format!("let {} = {text};", self.joints[*body]))
        };
        self.followers.iter().filter_map(line).collect()
    }

    /// Writes the point of one end of a closure, and returns its name.
    pub(super) fn closing_point(
        &mut self,
        closure: &str,
        end: usize,
        text: &str,
        sections: &mut Sections,
    ) -> String {
        let wanted = format!("{closure}_{}", ["a", "b"][end]);
        let point = self.names.unique(&wanted, "loop_");
        sections.lets.push(format!("let {point} = {text};"));
        point
    }

    /// The comment of a gap, if a closure has one.
    pub(super) fn gap(&self, closure: usize, sections: &mut Sections) {
        let gap = self.analysis.gaps[closure];
        // The rounding of twelve digits is none.
        if gap > 1e-12 {
            sections.warnings.push(format!(
                "the loop `{}` is open by {} of the size where it is drawn: the mechanism closes it",
                shown(&self.chain.robot.closures[closure].name),
                short(gap)
            ));
        }
    }

    /// Adds the equations of a closure: those that follow from others are comments. Returns true if
    /// none follows.
    pub(super) fn equations(
        &self,
        closure: usize,
        texts: &[(Vec<String>, [String; 2])],
        sections: &mut Sections,
    ) -> bool {
        let rows = self.analysis.rows.iter().zip(&self.analysis.is_needed);
        let of_closure = rows.filter(|(row, _)| row.closure == closure);
        let mut needed = of_closure.map(|(_, is_needed)| *is_needed);
        let mut dropped = 0;
        for (components, [left, right]) in texts {
            let count = components.len().max(1);
            let flags: Vec<bool> = needed.by_ref().take(count).collect();
            dropped += flags.iter().filter(|is_needed| !**is_needed).count();
            if flags.iter().all(|is_needed| *is_needed) {
                sections.loops.push(format!("loop {left} = {right};"));
            } else if flags.iter().all(|is_needed| !*is_needed) {
                let line = format!("// follows from the others: loop {left} = {right};");
                sections.loops.push(line);
            } else {
                for (component, is_needed) in components.iter().zip(&flags) {
                    let follows = if *is_needed {
                        ""
                    } else {
                        "// follows from the others: "
                    };
                    let line = format!("{follows}loop {left}.{component} = {right}.{component};");
                    sections.loops.push(line);
                }
            }
        }
        if dropped > 0 {
            sections.warnings.push(format!(
                "{dropped} of the equations of the loop `{}` follow from the others, and are left out",
                shown(&self.chain.robot.closures[closure].name)
            ));
        }
        dropped == 0
    }
}

/// Returns the bodies whose joints follow others, so that leaders come first.
fn followers(chain: &Chain) -> Vec<usize> {
    let leader = |body: usize| {
        let joint = chain.robot.bodies[body].joint.as_ref()?;
        joint.follows.as_ref().map(|(leader, _)| *leader)
    };
    // The readers have refused circles.
    let depth = |body: usize| std::iter::successors(leader(body), |next| leader(*next)).count();
    let bodies = 0..chain.robot.bodies.len();
    let mut followers: Vec<usize> = bodies.filter(|body| leader(*body).is_some()).collect();
    followers.sort_by_key(|body| depth(*body));
    followers
}

/// A number with fifteen digits.
pub(super) fn digits(value: f64) -> String {
    plain(format!("{value:.14e}").parse().unwrap_or(value))
}

/// Returns true if a text is one name, which takes a sign without brackets.
fn is_name(text: &str) -> bool {
    let is_part = |letter: char| letter.is_ascii_alphanumeric() || letter == '_';
    text.chars().all(is_part)
}
