//! Messages about unknown frames: a body in space has six freedoms, one in the plane three,
//! whatever unknowns and loops of its own it is made of.

use crate::algebra::{Names, Nominal};
use crate::message_format::loop_names;
use crate::mobility::freedom;
use crate::structure::equations::{Coordinate, Equation};
use crate::structure::fault::StructureFault;
use crate::structure::link_faults::link_count;
use crate::structure::matching::Matching;
use crate::structure::overheld_frame::frame_held_twice;
use crate::structure::unknown_frame::{UnknownFrame, position, unknown_frames};
use crate::structure::{matching, naming};

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
