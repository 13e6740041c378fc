//! The order in which bodies are reached from the frame: a body begins at a joint whose position is
//! written already, and every further joint of it that is written already closes a loop.
//!
//! A body with two such joints comes first, then two bodies that share a joint and have one each: a
//! dyad. In this way points are written from the nearest pivots, and a group is closed before the
//! next one begins.

use super::drawing::names;
use super::frame_faults::report_unreached;
use super::linkage::{FRAME, Linkage, is_fixed};
use super::rigid_bodies::Bodies;
use super::slides::{guide, in_one_slot, start_joint};
use crate::diagnostic::Diagnostics;

pub(super) enum Step {
    /// A body begins at a joint, and these joints of it get their positions.
    Reach {
        body: usize,
        from: usize,
        angle: AngleOf,
        /// The slider that gives the joint its position, if the slot is that of the body.
        slot: Option<usize>,
        new: Vec<usize>,
    },
    /// A joint of a body that begins at another one has a position already.
    Close {
        body: usize,
        from: usize,
        joint: usize,
    },
    /// The pin of a slider gets its position from the slot.
    PlacePin { slider: usize },
    /// Pin and slot have positions.
    CloseSlide { slider: usize },
    /// The pin is in its slot because of another pin of the same body.
    Follow { slider: usize },
}

/// The angle of a body.
pub(super) enum AngleOf {
    Unknown,
    /// Given by `at` of this link.
    Given {
        link: usize,
    },
    /// It keeps its angle to the slot, or to the block.
    Block {
        slider: usize,
    },
    /// Two pins are in one slot: the body turns with it.
    Pins {
        sliders: [usize; 2],
    },
}

pub(super) struct Plan {
    pub(super) steps: Vec<Step>,
    /// The body by which each joint got its position; `None` for a pin that got it from its slot.
    pub(super) seats: Vec<Option<usize>>,
}

/// Bodies, joints and sliders that are written so far.
struct State<'a> {
    linkage: &'a Linkage<'a>,
    bodies: &'a Bodies,
    located: Vec<bool>,
    reached: Vec<bool>,
    used: Vec<bool>,
    plan: Plan,
}

pub(super) fn plan(linkage: &Linkage, bodies: &Bodies, diagnostics: &mut Diagnostics) -> Plan {
    let count = linkage.joints.len();
    let mut state = State {
        linkage,
        bodies,
        located: vec![false; count],
        reached: vec![false; bodies.list.len()],
        used: vec![false; linkage.sliders.len()],
        plan: Plan {
            steps: Vec::new(),
            seats: vec![None; count],
        },
    };
    state.reached[FRAME] = true;
    for joint in 0..count {
        if is_fixed(linkage, joint) || bodies.list[FRAME].joints.contains(&joint) {
            state.located[joint] = true;
            state.plan.seats[joint] = Some(FRAME);
        }
    }
    state.close_slides();
    while let Some(next) = state.next() {
        match next {
            Next::Body(body) => state.reach(body),
            Next::Pin(slider) => state.place_pin(slider),
        }
        state.close_slides();
    }
    report_unreached(linkage, bodies, &state.reached, diagnostics);
    state.plan
}

enum Next {
    Body(usize),
    Pin(usize),
}

impl State<'_> {
    fn next(&self) -> Option<Next> {
        let open = || (0..self.reached.len()).filter(|body| !self.reached[*body]);
        let driven = open().find(|body| {
            let has_joint = self.located_joints(*body) > 0;
            has_joint && self.given_angle(*body).is_some()
        });
        if let Some(body) = driven {
            return Some(Next::Body(body));
        }
        let sliders = self.linkage.sliders.iter().enumerate();
        let mut sliders = sliders.filter(|(index, slider)| {
            let is_open = !self.used[*index] && !self.located[slider.pin];
            is_open && slider.at.is_some() && self.reached[guide(self.bodies, slider)]
        });
        if let Some((slider, _)) = sliders.next() {
            return Some(Next::Pin(slider));
        }
        if let Some(body) = open().find(|body| self.constraints(*body) >= 2) {
            return Some(Next::Body(body));
        }
        let held: Vec<usize> = open().filter(|body| self.constraints(*body) > 0).collect();
        let in_dyad = held.iter().find(|one| {
            held.iter()
                .any(|other| *other != **one && self.are_joined(**one, *other))
        });
        in_dyad.or(held.first()).copied().map(Next::Body)
    }

    fn located_joints(&self, body: usize) -> usize {
        let joints = self.bodies.list[body].joints.iter();
        joints.filter(|joint| self.located[**joint]).count()
    }

    /// Returns the number of joints and slots that hold a body; a block counts twice.
    fn constraints(&self, body: usize) -> usize {
        let sliders = self.linkage.sliders.iter().enumerate();
        let sliders = sliders.filter(|(index, _)| !self.used[*index]);
        let slots = sliders.map(|(_, slider)| {
            let guide = guide(self.bodies, slider);
            let has_pin = self.bodies.list[body].joints.contains(&slider.pin);
            let block = slider.block.map(|link| self.bodies.of_link[link]);
            if guide == body && self.located[slider.pin] {
                1 + usize::from(block.is_some_and(|block| self.reached[block]))
            } else if has_pin && self.reached[guide] && !self.located[slider.pin] {
                1 + usize::from(block == Some(body))
            } else {
                0
            }
        });
        self.located_joints(body) + slots.sum::<usize>()
    }

    /// Returns true if bodies share a joint without a position, or one slides on the other.
    fn are_joined(&self, one: usize, other: usize) -> bool {
        let joints = &self.bodies.list[other].joints;
        let mut shared = self.bodies.list[one].joints.iter();
        let mut sliders = self.linkage.sliders.iter();
        let slides = |slider: &super::linkage::Slider, pin: usize, slot: usize| {
            guide(self.bodies, slider) == slot && self.bodies.list[pin].joints.contains(&slider.pin)
        };
        shared.any(|joint| joints.contains(joint) && !self.located[*joint])
            || sliders.any(|slider| slides(slider, one, other) || slides(slider, other, one))
    }

    /// Returns the link of a body whose angle is given by values that are written already.
    fn given_angle(&self, body: usize) -> Option<usize> {
        let mut links = self.bodies.list[body].links.iter().copied();
        links.find(|link| {
            let Some(at) = self.linkage.links[*link].at else {
                return false;
            };
            names(at).into_iter().all(|name| {
                let mut links = self.linkage.links.iter();
                let named = links.position(|link| link.name == *name);
                named.is_none_or(|link| self.reached[self.bodies.of_link[link]])
            })
        })
    }

    fn reach(&mut self, body: usize) {
        let joints = &self.bodies.list[body].joints;
        let begin = |joint: &&usize| self.located[**joint];
        let fixed = |joint: &&usize| self.plan.seats[**joint] == Some(FRAME);
        let from = joints
            .iter()
            .find(fixed)
            .or_else(|| joints.iter().find(begin));
        let (from, slot) = match from {
            Some(from) => (*from, None),
            None => match self.place_on_slot(body) {
                Some(found) => found,
                None => return,
            },
        };
        let angle = self.angle_of(body);
        if let AngleOf::Pins { sliders } = angle {
            self.used[sliders[1]] = true;
        }
        let joints = &self.bodies.list[body].joints;
        let new: Vec<usize> = joints
            .iter()
            .copied()
            .filter(|joint| !self.located[*joint])
            .collect();
        let closed: Vec<usize> = joints
            .iter()
            .copied()
            .filter(|joint| self.located[*joint] && *joint != from)
            .collect();
        for joint in &new {
            self.located[*joint] = true;
            self.plan.seats[*joint] = Some(body);
        }
        self.plan.seats[from].get_or_insert(body);
        self.reached[body] = true;
        let follows = match angle {
            AngleOf::Pins { sliders } => Some(sliders[1]),
            _ => None,
        };
        self.plan.steps.push(Step::Reach {
            body,
            from,
            angle,
            slot,
            new,
        });
        for joint in closed {
            self.plan.seats[joint].get_or_insert(body);
            self.plan.steps.push(Step::Close { body, from, joint });
        }
        if let Some(slider) = follows {
            self.plan.steps.push(Step::Follow { slider });
        }
    }

    fn place_pin(&mut self, slider: usize) {
        self.used[slider] = true;
        self.located[self.linkage.sliders[slider].pin] = true;
        self.plan.steps.push(Step::PlacePin { slider });
    }

    /// Gives a joint of a body its position by a slot. Returns it, with the slider if the slot is
    /// that of the body.
    fn place_on_slot(&mut self, body: usize) -> Option<(usize, Option<usize>)> {
        let sliders = 0..self.linkage.sliders.len();
        for index in sliders
            .filter(|index| !self.used[*index])
            .collect::<Vec<_>>()
        {
            let slider = &self.linkage.sliders[index];
            let slot = guide(self.bodies, slider);
            let has_pin = self.bodies.list[body].joints.contains(&slider.pin);
            if has_pin && self.reached[slot] {
                self.place_pin(index);
                return Some((slider.pin, None));
            }
            if slot == body && self.located[slider.pin] {
                let start = start_joint(slider)?;
                self.used[index] = true;
                self.located[start] = true;
                return Some((start, Some(index)));
            }
        }
        None
    }

    fn angle_of(&self, body: usize) -> AngleOf {
        if let Some(link) = self.given_angle(body) {
            return AngleOf::Given { link };
        }
        let sliders = self.linkage.sliders.iter();
        let of_block = |slider: &super::linkage::Slider| {
            let block = slider.block.map(|link| self.bodies.of_link[link]);
            let slot = guide(self.bodies, slider);
            block == Some(body) && self.reached[slot]
                || slot == body && block.is_some_and(|block| self.reached[block])
        };
        if let Some(slider) = sliders.clone().position(of_block) {
            return AngleOf::Block { slider };
        }
        let count = self.linkage.sliders.len();
        for first in 0..count {
            for second in first + 1..count {
                if !self.used[second] && self.turns_together(body, first, second) {
                    return AngleOf::Pins {
                        sliders: [first, second],
                    };
                }
            }
        }
        AngleOf::Unknown
    }

    /// Returns true if a body has two pins in one slot of a body that is written, or the slot of
    /// two pins of such a body.
    fn turns_together(&self, body: usize, first: usize, second: usize) -> bool {
        let [one, other] = [first, second].map(|index| &self.linkage.sliders[index]);
        let slot = guide(self.bodies, one);
        let holds = |body: usize| {
            let joints = &self.bodies.list[body].joints;
            joints.contains(&one.pin) && joints.contains(&other.pin)
        };
        let mut reached = (0..self.reached.len()).filter(|body| self.reached[*body]);
        in_one_slot(one, other)
            && (holds(body) && slot != body && self.reached[slot]
                || slot == body && reached.any(holds))
    }

    /// Closes the loops of sliders whose pin and slot are written.
    fn close_slides(&mut self) {
        for (index, slider) in self.linkage.sliders.iter().enumerate() {
            let is_written = self.located[slider.pin] && self.reached[guide(self.bodies, slider)];
            if is_written && !self.used[index] {
                self.used[index] = true;
                self.plan.steps.push(Step::CloseSlide { slider: index });
            }
        }
    }
}
