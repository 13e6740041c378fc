//! The facts about joints and links that stay known when loops have taken their place. Messages name
//! links and joints by them.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::{self, Display, Formatter};

/// The links and joints of a mechanism that is written with them.
#[derive(Clone, Debug)]
pub struct LinkInventory {
    /// True for a mechanism of space.
    pub spatial: bool,
    /// The number of rigid bodies with the frame. A cylinder consists of two.
    pub bodies: usize,
    /// The joints by kind, without kinds that the mechanism has not.
    pub joints: Vec<JointCount>,
    /// The number of rods of space. Each can turn about its line without effect.
    pub idle: usize,
    /// The links and sliders whose motion is given.
    pub driven: Vec<String>,
    /// The link, slider or joint that an unknown moves, by the first part of the unknown's name.
    pub moved: BTreeMap<String, String>,
    /// The joints of each link, in their order.
    pub members: BTreeMap<String, Vec<String>>,
    /// The joints of links that have no other one: pivots of wheels and blocks.
    pub pivots: BTreeSet<String>,
    /// Messages about names of joints and links that are no joints of forces.
    pub reactions: BTreeMap<String, ReactionHint>,
    /// The drawn distances in metres of links with a given length, by the name of the length.
    pub drawn_lengths: BTreeMap<String, f64>,
}

/// A message about a joint or link that has no reaction of this name.
#[derive(Clone, Debug)]
pub struct ReactionHint {
    pub fact: String,
    pub help: String,
}

/// A kind of joint.
#[derive(Clone, Debug)]
pub struct JointCount {
    /// Its name in the singular.
    pub noun: &'static str,
    pub count: usize,
    /// The number of relative motions that one joint holds.
    pub held: usize,
}

/// The joint or link that a loop stands for.
#[derive(Clone, Debug)]
pub enum LinkLoop {
    /// A joint of a link, which other links hold, too.
    Joint {
        link: String,
        joint: String,
        /// The ends of the link if it has no other joints.
        ends: Option<[String; 2]>,
    },
    /// A rod of space between two ball joints.
    Rod {
        link: String,
        ends: [String; 2],
    },
    Slider(String),
    Wheels([String; 2]),
}

impl LinkInventory {
    /// Returns the number of independent motions by the formula of Gruebler, in space without the
    /// idle turns of rods.
    pub fn mobility(&self) -> isize {
        let held: usize = self.joints.iter().map(|kind| kind.count * kind.held).sum();
        let free = self.freedoms() * self.bodies.saturating_sub(1);
        free as isize - held as isize - self.idle as isize
    }

    fn freedoms(&self) -> usize {
        if self.spatial { 6 } else { 3 }
    }

    /// Returns the formula with its numbers: `3 * 3 - 2 * 4`.
    pub fn formula(&self) -> String {
        let moving = self.bodies.saturating_sub(1);
        let mut text = format!("{} * {moving}", self.freedoms());
        for JointCount { count, held, .. } in &self.joints {
            text += &format!(" - {held} * {count}");
        }
        match self.idle {
            0 => text,
            idle => format!("{text} - {idle} for idle turns of rods"),
        }
    }

    /// Returns the numbers of links and joints: `4 links with the frame and 4 pins`.
    pub fn counts(&self) -> String {
        let ending = |count: usize| if count == 1 { "" } else { "s" };
        let bodies = self.bodies;
        let mut text = format!("{bodies} link{} with the frame", ending(bodies));
        for (index, JointCount { noun, count, .. }) in self.joints.iter().enumerate() {
            let is_last = index + 1 == self.joints.len();
            let separator = if is_last { " and " } else { ", " };
            text += &format!("{separator}{count} {noun}{}", ending(*count));
        }
        text
    }
}

impl LinkLoop {
    /// Returns the same with other names.
    pub fn renamed(&self, name: impl Fn(&str) -> String) -> Self {
        let both = |names: &[String; 2]| names.each_ref().map(|text| name(text));
        match self {
            LinkLoop::Joint { link, joint, ends } => LinkLoop::Joint {
                link: name(link),
                joint: name(joint),
                ends: ends.as_ref().map(both),
            },
            LinkLoop::Rod { link, ends } => LinkLoop::Rod {
                link: name(link),
                ends: both(ends),
            },
            LinkLoop::Slider(slider) => LinkLoop::Slider(name(slider)),
            LinkLoop::Wheels(wheels) => LinkLoop::Wheels(both(wheels)),
        }
    }
}

impl Display for LinkLoop {
    fn fmt(&self, f: &mut Formatter) -> fmt::Result {
        match self {
            LinkLoop::Joint { link, joint, .. } => write!(f, "joint `{joint}` of `{link}`"),
            LinkLoop::Rod { link, .. } => write!(f, "`{link}`"),
            LinkLoop::Slider(slider) => write!(f, "slider `{slider}`"),
            LinkLoop::Wheels([one, other]) => write!(f, "wheels `{one}` and `{other}`"),
        }
    }
}
