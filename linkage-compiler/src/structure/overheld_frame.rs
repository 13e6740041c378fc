//! Messages about unknown frames that too many loops hold.

use crate::algebra::{Names, Nominal};
use crate::message_format::loop_names;
use crate::mobility::overconstrained;
use crate::model::Mechanism;
use crate::structure::equations::{Coordinate, Equation};
use crate::structure::fault::StructureFault;
use crate::structure::link_faults::link_count;
use crate::structure::loops_together;
use crate::structure::unknown_frame::{UnknownFrame, position};

/// The text about a body that too many loops hold.
struct HeldTwice {
    fact: String,
    help: String,
}

/// Returns the fault of a frame that too many loops hold.
pub(crate) fn frame_held_twice<'m>(
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
    let closed = loops_together::all_closed(names, nominal, equations, coordinates);
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
