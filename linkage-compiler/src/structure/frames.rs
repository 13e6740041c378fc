//! Messages about unknown frames: a body in space has six freedoms, one in the plane three,
//! whatever unknowns and loops of its own it is made of.

use crate::algebra::{Names, Nominal};
use crate::message_format::{MessageFormat, loop_names};
use crate::mobility::{Position, freedom, overconstrained};
use crate::model::{Mechanism, unknown_frames};
use crate::structure::equations::{Coordinate, Equation};
use crate::structure::fault::StructureFault;
use crate::structure::link_faults::link_count;
use crate::structure::matching::Matching;
use crate::structure::{matching, naming, redundant};

/// An unknown frame of the model.
struct UnknownFrame {
    /// Its origin, and two axes or an angle.
    unknowns: Vec<usize>,
    /// 6 in space, 3 in the plane.
    freedoms: usize,
    /// A loop that holds it, for example.
    example: &'static str,
    name: String,
    /// The loops that mention it, without its own.
    loops: Vec<usize>,
}

/// The text about a body that too many loops hold.
struct HeldTwice {
    fact: String,
    help: String,
}

fn unknown_frames(mechanism: &Mechanism) -> Vec<UnknownFrame> {
    let lets = mechanism.lets.iter();
    let frames = lets.filter_map(|item| {
        Some((
            item.name.clone(),
            unknown_frames::unknowns_of(mechanism, &item.value)?,
        ))
    });
    let frames = frames.map(|(name, unknowns)| {
        let mentions = |&k: &usize| {
            let written = mechanism.usage(&[k]).unknowns;
            !unknown_frames::is_loop_of_frame(mechanism, k)
                && unknowns.iter().any(|&unknown| written[unknown])
        };
        let loops = (0..mechanism.loops.len()).filter(mentions).collect();
        let in_plane = unknowns.len() == 2;
        UnknownFrame {
            loops,
            name,
            freedoms: if in_plane { 3 } else { 6 },
            example: if in_plane {
                "distance(point_in(BODY, p), q) = l` for a link with two pins"
            } else {
                "distance(point_in(BODY, p), q) = l` for a rod with two ball joints"
            },
            unknowns,
        }
    });
    frames.collect()
}

/// Bodies that too few loops hold, or too many.
#[derive(Default)]
pub(crate) struct FrameFaults {
    pub(crate) faults: Vec<StructureFault>,
    /// The coordinates that these are about.
    pub(crate) coordinates: Vec<usize>,
}

/// Returns the bodies that too few loops hold, or too many.
pub(crate) fn frame_faults<'m>(
    names: &Names<'m>,
    nominal: &Nominal,
    equations: &[Equation<'m>],
    coordinates: &[Coordinate],
    incidence: &[Vec<usize>],
    matching: &Matching,
) -> FrameFaults {
    let mut found_faults = FrameFaults::default();
    for found in unknown_frames(names.mechanism) {
        let is_own = |&k: &usize| {
            let unknown = coordinates[k].unknown;
            unknown.is_some_and(|unknown| found.unknowns.contains(&unknown))
        };
        let members: Vec<usize> = (0..coordinates.len()).filter(is_own).collect();
        let open: Vec<usize> = members
            .iter()
            .copied()
            .filter(|&k| matching.equation_of[k].is_none())
            .collect();
        let surplus = (0..equations.len()).map(|k| {
            let is_about = incidence[k].iter().any(|own_k| members.contains(own_k));
            let free = equations[k].rows.len() - matching.coordinates_of[k].len();
            if is_about { free } else { 0 }
        });
        let surplus: usize = surplus.sum();
        if !open.is_empty() {
            let count = open.len();
            found_faults.faults.push(open_frame(
                names,
                nominal,
                &found,
                count,
                coordinates,
                equations,
            ));
            let undetermined = |&k: &usize| matching::undetermined_with(k, incidence, matching).0;
            found_faults
                .coordinates
                .extend(open.iter().flat_map(undetermined));
            found_faults.coordinates.extend(members);
        } else if surplus > 0 && found_faults.coordinates.is_empty() {
            let fault = frame_held_twice(names, nominal, &found, surplus, coordinates, equations);
            found_faults.faults.extend(fault);
            found_faults.coordinates.extend(members);
        }
    }
    found_faults
}

fn open_frame<'m>(
    names: &Names<'m>,
    nominal: &Nominal,
    found: &UnknownFrame,
    open: usize,
    all: &[Coordinate],
    equations: &[Equation<'m>],
) -> StructureFault {
    let UnknownFrame {
        name,
        unknowns,
        loops,
        freedoms,
        example,
    } = found;
    let mechanism = names.mechanism;
    let inputs = mechanism.inputs.len();
    let held = freedoms.saturating_sub(open);
    let example = example.replace("BODY", name);
    let by = match &loops[..] {
        [] => "no loop mentions it".to_owned(),
        [_] => format!("{} holds {held} of them", loop_names(mechanism, loops)),
        _ => format!("{} hold {held} of them", loop_names(mechanism, loops)),
    };
    let rows: usize = equations.iter().map(|e| e.rows.len()).sum();
    let mobility = (inputs + all.len()).saturating_sub(rows);
    // Without a loop it moves in every way.
    let motion = if loops.is_empty() {
        None
    } else {
        position(names, nominal, &nominal.estimates, freedom::motion_left)
    };
    let motion = motion.map_or_else(String::new, |motion| {
        format!("; where the estimates are, {motion}")
    });
    if let Some(links) = link_count(mechanism, equations, all) {
        let text = format!(
            "more motions than inputs: the body `{name}` has {freedoms} freedoms, and {}; {}{motion}\n\
             help: hold it by {}, `link NAME: P, Q;`, from a joint of `{name}` to a joint of another link",
            if loops.is_empty() {
                "no rod holds it"
            } else {
                &by
            },
            links.mobility(),
            naming::counted(open, "further rod"),
        );
        return StructureFault {
            origin: mechanism.unknowns[unknowns[0]].origin,
            text,
        };
    }
    let text = format!(
        "more unknowns than equations: the frame `{name}` has {freedoms} freedoms, and {by}; mobility {mobility}, driven \
             inputs {inputs}{motion}\n\
             help: add {}, like `{example}",
        naming::counted(open, "equation"),
    );
    StructureFault {
        origin: mechanism.unknowns[unknowns[0]].origin,
        text,
    }
}

fn frame_held_twice<'m>(
    names: &Names<'m>,
    nominal: &Nominal,
    found: &UnknownFrame,
    surplus: usize,
    coordinates: &[Coordinate],
    equations: &[Equation<'m>],
) -> Option<StructureFault> {
    let UnknownFrame {
        name,
        loops,
        freedoms,
        ..
    } = found;
    let mechanism = names.mechanism;
    let last = loops.last()?;
    let inputs = mechanism.inputs.len();
    let about = equations
        .iter()
        .filter(|e| e.loops.iter().any(|k| loops.contains(k)));
    let rows: usize = about.map(|e| e.rows.len()).sum();
    let all: usize = equations.iter().map(|e| e.rows.len()).sum();
    let mobility = (inputs + coordinates.len()) as isize - all as isize;
    let too_many = too_many(names, nominal, surplus, equations, coordinates);
    if let Some(links) = link_count(mechanism, equations, coordinates) {
        let text = format!(
            "more joints than motions: the body `{name}` has {freedoms} freedoms, and {} hold{} more than these; {}{}\n\
             help: {}",
            loop_names(mechanism, loops),
            if loops.len() == 1 { "s" } else { "" },
            links.mobility(),
            too_many.fact,
            too_many.help,
        );
        return Some(StructureFault {
            origin: mechanism.loops[*last].origin,
            text,
        });
    }
    let text = format!(
        "more equations than unknowns: the frame `{name}` has {freedoms} freedoms, and {} {} {rows} equations about it, {surplus} \
             too many (mobility {mobility}, driven inputs {inputs}){}\n\
             help: {}",
        loop_names(mechanism, loops),
        if loops.len() == 1 { "has" } else { "have" },
        too_many.fact,
        too_many.help,
    );
    Some(StructureFault {
        origin: mechanism.loops[*last].origin,
        text,
    })
}

/// Returns the loops about a frame that depend on others, and the remedy.
fn too_many<'m>(
    names: &Names<'m>,
    nominal: &Nominal,
    surplus: usize,
    equations: &[Equation<'m>],
    coordinates: &[Coordinate],
) -> HeldTwice {
    let closed = redundant::all_closed(names, nominal, equations, coordinates);
    let at = closed.as_ref().unwrap_or(&nominal.estimates);
    let Some(found) = position(names, nominal, at, |at| overconstrained::surplus(at)) else {
        return HeldTwice {
            fact: String::new(),
            help: "remove a loop, or make a dimension or an input of one an `unknown`".to_owned(),
        };
    };
    let all = match closed {
        Some(_) => "; with these dimensions all of them close, and where they do, ",
        None => "; where the estimates are, ",
    };
    let motion = found
        .motion
        .map_or_else(String::new, |motion| format!("; and yet {motion}"));
    let enough = found.spare.len() >= surplus && motion.is_empty();
    let [they, depend, them, each] = match found.spare.len() {
        1 => ["it", "depends", "it", "it"],
        _ => ["they", "depend", "them", "each"],
    };
    let spare = loop_names(names.mechanism, &found.spare);
    let linked = spare_of_links(names.mechanism, &found.spare);
    let help = match &closed {
        _ if linked && enough => {
            format!("leave {spare} out, or a link on which {they} {depend}; or do not drive a link")
        }
        _ if linked => {
            "leave out links that depend on others, and add some that hold what can still move"
                .to_owned()
        }
        Some(_) if enough => format!(
            "write `redundant` at the end of {spare}, to have it checked whether {they} follow{} from the others; or leave {them} out",
            if found.spare.len() == 1 { "s" } else { "" }
        ),
        None if enough => format!(
            "remove {spare}, or a loop on which {they} {depend}; or make a dimension or an input of {each} an `unknown`"
        ),
        _ => "remove loops that depend on others, and write some that hold what can still move"
            .to_owned(),
    };
    HeldTwice {
        fact: format!("{all}{}{motion}", found.dependences),
        help,
    }
}

/// Returns true if all these loops stand for joints and links.
fn spare_of_links(mechanism: &Mechanism, loops: &[usize]) -> bool {
    loops
        .iter()
        .all(|&index| mechanism.loops[index].of.is_some())
}

/// Runs a check of the loops where the unknowns have these values; nothing if one has no estimate.
fn position<'m, R>(
    names: &Names<'m>,
    nominal: &Nominal,
    values: &[Vec<f64>],
    question: impl FnOnce(&Position<'_, 'm>) -> Option<R>,
) -> Option<R> {
    let mechanism = names.mechanism;
    let mut unknowns = mechanism.unknowns.iter();
    if unknowns.any(|unknown| unknown.estimate.is_none()) {
        return None;
    }
    let words = MessageFormat::new(mechanism);
    question(&Position::new(
        &words,
        nominal,
        redundant::longest(names, nominal),
        values.to_vec(),
    ))
}
