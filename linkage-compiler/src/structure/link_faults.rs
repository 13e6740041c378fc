//! Messages about the numbers of links and joints, for mechanisms that are written with them alone.

use linkage_core::range_check::listed;
use linkage_symbolic::MAX_DEGREE;

use crate::algebra::Nominal;
use crate::message_format::loop_names;
use crate::model::{LinkInventory, LinkLoop, Mechanism, unknown_frames};
use crate::structure::equations::{Coordinate, Equation};
use crate::structure::fault::OURS;

/// The links and joints of a mechanism whose loops stand for nothing else.
pub(crate) struct LinkCount<'m> {
    mechanism: &'m Mechanism,
    inventory: &'m LinkInventory,
}

/// Returns the links and joints of a mechanism, if all loops and unknowns stand for them and the
/// formula of Gruebler gives the mobility that the equations give.
pub(crate) fn link_count<'m>(
    mechanism: &'m Mechanism,
    equations: &[Equation<'m>],
    coordinates: &[Coordinate],
) -> Option<LinkCount<'m>> {
    let inventory = mechanism.links.as_ref()?;
    let count = LinkCount {
        mechanism,
        inventory,
    };
    let mut loops = mechanism.loops.iter().enumerate();
    let linked = loops.all(|(index, equation)| {
        equation.of.is_some() || unknown_frames::is_loop_of_frame(mechanism, index)
    });
    let mut unknowns = mechanism.unknowns.iter();
    let named = unknowns.all(|unknown| count.moved_by(&unknown.name).is_some());
    let rows: usize = equations.iter().map(|equation| equation.rows.len()).sum();
    let free = coordinates.len() as isize - rows as isize;
    let agrees = inventory.mobility() - inventory.driven.len() as isize == free;
    (linked && named && agrees).then_some(count)
}

impl LinkCount<'_> {
    /// Returns the link, slider or joint that an unknown moves.
    fn moved_by(&self, unknown: &str) -> Option<&str> {
        let name = unknown.split('.').next()?;
        self.inventory.moved.get(name).map(String::as_str)
    }

    /// Returns all that unknowns move, each once.
    pub(crate) fn moved(&self, coordinates: &[&Coordinate]) -> Vec<String> {
        let mut unknowns: Vec<usize> = coordinates.iter().filter_map(|c| c.unknown).collect();
        unknowns.sort_unstable();
        self.moved_with(&unknowns)
    }

    fn moved_with(&self, unknowns: &[usize]) -> Vec<String> {
        let names = unknowns.iter().filter_map(|&unknown| {
            let name = &self.mechanism.unknowns[unknown].name;
            self.moved_by(name).map(str::to_owned)
        });
        let mut names: Vec<String> = names.collect();
        names.dedup();
        names
    }

    /// Returns the mobility and the links that are driven: ``4 links with the frame and 4 pins have
    /// mobility 1 by Gruebler's formula (3 * 3 - 2 * 4), and `crank` is driven``.
    pub(crate) fn mobility(&self) -> String {
        let inventory = self.inventory;
        let driven = match &inventory.driven[..] {
            [] => "nothing is driven".to_owned(),
            [one] => format!("`{one}` is driven"),
            several => format!("{} are driven", quoted(several)),
        };
        format!(
            "{} have mobility {} by Gruebler's formula ({}), and {driven}",
            inventory.counts(),
            inventory.mobility(),
            inventory.formula()
        )
    }

    /// Returns the text about links that too few joints hold. `free` is the number of their motions
    /// that nothing holds.
    pub(crate) fn moving(&self, coordinates: &[&Coordinate], free: usize) -> String {
        let moved = self.moved(coordinates);
        let surplus = self.inventory.mobility() - self.inventory.driven.len() as isize;
        let still = match &moved[..] {
            [_] => "still moves",
            _ => "still move",
        };
        let fact = match surplus {
            1.. => "more motions than inputs",
            _ => "links that move freely, and others that are held too often",
        };
        format!(
            "{fact}: {}; {} {still}\nhelp: {}",
            self.mobility(),
            listed(&moved),
            self.hold(&moved, free),
        )
    }

    /// Returns the advice for links that too few joints hold.
    fn hold(&self, moved: &[String], free: usize) -> String {
        let hold = match (moved, free) {
            ([one], _) => format!("hold {one}"),
            (_, 1) => "hold one of them".to_owned(),
            _ => format!("hold {free} of these motions"),
        };
        let (further, drive) = if self.inventory.spatial {
            ("a further link", "an angle of its hinge: `at ANGLE`")
        } else {
            (
                "a further link or slider, by `gears` or `weld`",
                "its direction: `at ANGLE`",
            )
        };
        let inputs = self.mechanism.inputs.iter();
        let inputs: Vec<String> = inputs.map(|input| input.name.clone()).collect();
        match &inputs[..] {
            [] if free == 1 => format!(
                "declare an input, as in `input phi = 60deg in 0deg..360deg;`, and give a link {}; or {hold} by {further}",
                drive.replace("ANGLE", "phi")
            ),
            [input] if self.inventory.driven.is_empty() && free == 1 => format!(
                "`{input}` drives no link: give one {}; or {hold} by {further}",
                drive.replace("ANGLE", input)
            ),
            _ => format!("{hold} by {further}, or give a link {drive}"),
        }
    }

    /// Returns the text about joints that hold what others hold. `fact` has more about the loop.
    pub(crate) fn held(
        &self,
        equation: &Equation,
        contained: &[&Coordinate],
        fact: &str,
    ) -> String {
        let driven = self.inventory.driven.len() as isize;
        let joint = loop_names(self.mechanism, &equation.loops);
        let surplus = driven - self.inventory.mobility();
        format!(
            "more joints than motions: {}; {joint} {} {}{fact}",
            self.mobility(),
            match &self.mechanism.loops[equation.loops[0]].of {
                Some(LinkLoop::Wheels(_)) => "hold",
                Some(LinkLoop::Joint { .. } | LinkLoop::Rod { .. } | LinkLoop::Slider(_))
                | None => {
                    "holds"
                }
            },
            match &self.moved(contained)[..] {
                [] => "links whose motion is given already".to_owned(),
                moved if surplus == 1 => format!("{} once too often", listed(moved)),
                moved => format!("{} too often", listed(moved)),
            },
        )
    }

    /// Returns the advice for a joint that is one too many.
    pub(crate) fn leave_out(&self, equation: &Equation) -> String {
        let LinkInventory {
            driven, spatial, ..
        } = self.inventory;
        let mobility = self.inventory.mobility();
        let link = link_to_leave_out(self.mechanism, &equation.loops);
        let link = link.unwrap_or_else(|| "a link".to_owned());
        let slide = match self.joint_of(equation).filter(|_| !spatial) {
            Some(joint) => {
                format!(", or let `{joint}` slide: `slider NAME: {joint} on LINK along ...`")
            }
            None => String::new(),
        };
        let ends = self.ends_of(equation).filter(|_| driven.len() < 2);
        let slide = match ends.filter(|_| !spatial) {
            Some(_) => format!(
                "{slide}; a strut whose length is free holds nothing: write it as `spring` or `damper`"
            ),
            None => slide,
        };
        match &driven[..] {
            [] => format!("leave {link} or another one out{slide}"),
            [one] => format!("leave {link} out, do not drive `{one}`{slide}"),
            several if mobility > 0 => format!(
                "drive only {mobility} of {}; or leave {link} out{slide}",
                quoted(several)
            ),
            several => format!("leave {link} out, do not drive {}{slide}", quoted(several)),
        }
    }

    /// Returns the ends of the link of two joints that a loop stands for.
    fn ends_of(&self, equation: &Equation) -> Option<&[String; 2]> {
        match self.mechanism.loops[equation.loops[0]].of.as_ref()? {
            LinkLoop::Joint { ends, .. } => ends.as_ref(),
            LinkLoop::Rod { ends, .. } => Some(ends),
            LinkLoop::Slider(_) | LinkLoop::Wheels(_) => None,
        }
    }

    fn joint_of(&self, equation: &Equation) -> Option<&str> {
        match self.mechanism.loops[equation.loops[0]].of.as_ref()? {
            LinkLoop::Joint { joint, .. } => Some(joint),
            LinkLoop::Rod { .. } | LinkLoop::Slider(_) | LinkLoop::Wheels(_) => None,
        }
    }
}

/// Returns the wheels of a group that cannot be solved, with all links of the group, if its loops
/// stand for links.
pub(crate) fn coupled_wheels(
    mechanism: &Mechanism,
    equations: &[Equation],
    unknowns: &[usize],
) -> Option<String> {
    let inventory = mechanism.links.as_ref()?;
    let count = LinkCount {
        mechanism,
        inventory,
    };
    let loops = equations.iter().flat_map(|equation| &equation.loops);
    let linked = loops.map(|&index| mechanism.loops[index].of.as_ref());
    let linked: Vec<&LinkLoop> = linked.collect::<Option<_>>()?;
    let wheels = linked.into_iter().find(|of| match of {
        LinkLoop::Wheels(_) => true,
        LinkLoop::Joint { .. } | LinkLoop::Rod { .. } | LinkLoop::Slider(_) => false,
    })?;
    Some(format!(
        "{} cannot be solved together: {wheels} are among them, and do not turn in a whole ratio up to {MAX_DEGREE}; \
         {OURS}\n\
         help: choose such a ratio, or drive one of these links instead of another one: `at ANGLE`",
        listed(&count.moved_with(unknowns)),
    ))
}

/// `` `a`, `b` and `c` ``
fn quoted(names: &[String]) -> String {
    let names: Vec<String> = names.iter().map(|name| format!("`{name}`")).collect();
    listed(&names)
}

/// Returns the link, slider or joint to leave out, if loops stand for one.
pub(crate) fn link_to_leave_out(mechanism: &Mechanism, loops: &[usize]) -> Option<String> {
    let [number] = loops else { return None };
    Some(match mechanism.loops[*number].of.as_ref()? {
        LinkLoop::Joint {
            link,
            ends: Some(_),
            ..
        }
        | LinkLoop::Rod { link, .. } => format!("the link `{link}`"),
        LinkLoop::Joint { link, joint, .. } => format!("`{joint}` of `{link}`"),
        LinkLoop::Slider(slider) => format!("the slider `{slider}`"),
        LinkLoop::Wheels([one, other]) => format!("the relation of `{one}` and `{other}`"),
    })
}

/// Returns the loop that checks a link which repeats others, without its length.
pub(crate) fn distance_of_ends(mechanism: &Mechanism, loops: &[usize]) -> Option<String> {
    let [number] = loops else { return None };
    match mechanism.loops[*number].of.as_ref()? {
        LinkLoop::Joint {
            ends: Some([one, other]),
            ..
        }
        | LinkLoop::Rod {
            ends: [one, other], ..
        } => Some(format!("distance({one}, {other})")),
        LinkLoop::Joint { .. } | LinkLoop::Slider(_) | LinkLoop::Wheels(_) => None,
    }
}

/// Returns the length of the link that a loop stands for, as it is written.
pub(crate) fn length_of_link(
    mechanism: &Mechanism,
    nominal: &Nominal,
    loops: &[usize],
) -> Option<String> {
    let [number] = loops else { return None };
    let (LinkLoop::Joint { link, .. } | LinkLoop::Rod { link, .. }) =
        mechanism.loops[*number].of.as_ref()?
    else {
        return None;
    };
    let name = format!("{link}.length");
    let scalar = mechanism
        .scalar_parameters
        .iter()
        .position(|scalar| scalar.name == name)?;
    let length = nominal.parameters[scalar];
    // More digits than the check of redundant loops needs, and no rounding errors of square roots.
    let length: f64 = format!("{length:.11e}").parse().unwrap_or(length);
    Some(format!("{length}{}", mechanism.unit.name()))
}
