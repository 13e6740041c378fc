//! Unknown frames in words: a body in space has six freedoms, one in the plane three, whatever unknowns and loops of its own it is made of.

use super::Analysis;
use super::equations::{Coordinate, Equation};
use super::matching::{self, Matching};
use super::report::counted;
use crate::message_format::MessageFormat;
use crate::message_format::loop_list;
use crate::mobility::Position;
use crate::mobility::overconstrained;
use crate::model::{Expr, ExprKind, Function, Mechanism, Name};
use crate::structure::redundant;

/// An unknown frame of the model.
struct Found {
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

/// What is said of a body that too many loops hold.
struct TooMany {
    fact: String,
    help: String,
}

impl Mechanism {
    /// True for a loop that says what the axes of an unknown frame are.
    pub(crate) fn is_loop_of_frame(&self, index: usize) -> bool {
        let origin = self.loops[index].origin;
        let mut unknowns = self.unknowns.iter();
        unknowns.any(|unknown| unknown.origin == origin)
    }

    /// The bodies of space that are unknowns, each with its name, its origin and two of its axes.
    pub(crate) fn bodies_of_space(&self) -> Vec<(String, Vec<usize>)> {
        let lets = self.lets.iter();
        let frames = lets.filter_map(|own| Some((own.name.clone(), self.unknowns_of(&own.value)?)));
        frames.filter(|(_, parts)| parts.len() == 3).collect()
    }

    fn unknown_frames(&self) -> Vec<Found> {
        let lets = self.lets.iter();
        let frames = lets.filter_map(|own| Some((own.name.clone(), self.unknowns_of(&own.value)?)));
        let frames = frames.map(|(name, unknowns)| {
            let mentions = |&k: &usize| {
                let written = self.usage(&[k]).unknowns;
                !self.is_loop_of_frame(k) && unknowns.iter().any(|&own| written[own])
            };
            let loops = (0..self.loops.len()).filter(mentions).collect();
            let in_plane = unknowns.len() == 2;
            Found {
                loops,
                name,
                freedoms: if in_plane { 3 } else { 6 },
                example: match in_plane {
                    true => "distance(point_in(BODY, p), q) = l` for a link with two pins",
                    false => "distance(point_in(BODY, p), q) = l` for a rod with two ball joints",
                },
                unknowns,
            }
        });
        frames.collect()
    }

    /// The unknowns of a frame that is unknown.
    fn unknowns_of(&self, value: &Expr) -> Option<Vec<usize>> {
        let ExprKind::Call(Function::Frame, parts) = &value.kind else {
            return None;
        };
        let names = parts.iter().filter_map(Expr::as_name);
        let unknowns = names.filter_map(|name| match name {
            Name::Unknown(index) => Some(index),
            // Other frames have other parts.
            _ => None,
        });
        let of_frame = |index: &usize| self.unknowns[*index].origin == value.origin;
        let unknowns: Vec<usize> = unknowns.filter(of_frame).collect();
        (!unknowns.is_empty()).then_some(unknowns)
    }
}

/// Reports bodies that too few loops hold, or too many; the coordinates of which something has been said.
pub(super) fn report_frames<'m>(
    analysis: &mut Analysis<'_, 'm>,
    equations: &[Equation<'m>],
    coordinates: &[Coordinate],
    incidence: &[Vec<usize>],
    matching: &Matching,
) -> Vec<usize> {
    let mut told = Vec::new();
    for found in analysis.algebra.mechanism.unknown_frames() {
        let is_own = |&k: &usize| {
            let unknown = coordinates[k].unknown;
            unknown.is_some_and(|own| found.unknowns.contains(&own))
        };
        let own: Vec<usize> = (0..coordinates.len()).filter(is_own).collect();
        let open: Vec<usize> = own
            .iter()
            .copied()
            .filter(|&k| matching.equation_of[k].is_none())
            .collect();
        let surplus = (0..equations.len()).map(|k| {
            let is_about = incidence[k].iter().any(|own_k| own.contains(own_k));
            let free = equations[k].rows.len() - matching.coordinates_of[k].len();
            if is_about { free } else { 0 }
        });
        let surplus: usize = surplus.sum();
        if !open.is_empty() {
            report_open(analysis, &found, open.len(), coordinates.len(), equations);
            let undetermined = |&k: &usize| matching::undetermined_with(k, incidence, matching).0;
            told.extend(open.iter().flat_map(undetermined));
            told.extend(own);
        } else if surplus > 0 && told.is_empty() {
            report_held_twice(analysis, &found, surplus, coordinates, equations);
            told.extend(own);
        }
    }
    told
}

fn report_open<'m>(
    analysis: &mut Analysis<'_, 'm>,
    found: &Found,
    open: usize,
    coordinates: usize,
    equations: &[Equation<'m>],
) {
    let Found {
        name,
        unknowns,
        loops,
        freedoms,
        example,
    } = found;
    let mechanism = analysis.algebra.mechanism;
    let inputs = mechanism.inputs.len();
    let held = freedoms.saturating_sub(open);
    let example = example.replace("BODY", name);
    let by = match &loops[..] {
        [] => "no loop mentions it".to_owned(),
        [_] => format!("{} holds {held} of them", loop_list(loops)),
        _ => format!("{} hold {held} of them", loop_list(loops)),
    };
    let rows: usize = equations.iter().map(|e| e.rows.len()).sum();
    let mobility = (inputs + coordinates).saturating_sub(rows);
    // Without a loop it moves in every way.
    let motion = match loops.is_empty() {
        true => None,
        false => position(analysis, &analysis.nominal.estimates, |at| at.motion_left()),
    };
    let motion = motion.map_or_else(String::new, |motion| {
        format!("; where the estimates are, {motion}")
    });
    let message = format!(
        "more unknowns than equations: the frame `{name}` has {freedoms} freedoms, and {by}; mobility {mobility}, driven \
             inputs {inputs}{motion}\n\
             help: add {}, like `{example}",
        counted(open, "equation"),
    );
    analysis
        .reporter
        .error(mechanism.unknowns[unknowns[0]].origin, message);
}

fn report_held_twice<'m>(
    analysis: &mut Analysis<'_, 'm>,
    found: &Found,
    surplus: usize,
    coordinates: &[Coordinate],
    equations: &[Equation<'m>],
) {
    let Found {
        name,
        loops,
        freedoms,
        ..
    } = found;
    let mechanism = analysis.algebra.mechanism;
    let Some(last) = loops.last() else {
        return;
    };
    let inputs = mechanism.inputs.len();
    let about = equations
        .iter()
        .filter(|e| e.loops.iter().any(|k| loops.contains(k)));
    let rows: usize = about.map(|e| e.rows.len()).sum();
    let all: usize = equations.iter().map(|e| e.rows.len()).sum();
    let mobility = (inputs + coordinates.len()) as isize - all as isize;
    let too_many = too_many(analysis, surplus, equations, coordinates);
    let message = format!(
        "more equations than unknowns: the frame `{name}` has {freedoms} freedoms, and {} {} {rows} equations about it, {surplus} \
             too many (mobility {mobility}, driven inputs {inputs}){}\n\
             help: {}",
        loop_list(loops),
        if loops.len() == 1 { "has" } else { "have" },
        too_many.fact,
        too_many.help,
    );
    analysis
        .reporter
        .error(mechanism.loops[*last].origin, message);
}

/// Which loops about a frame depend on which, and what to do about that.
fn too_many<'m>(
    analysis: &Analysis<'_, 'm>,
    surplus: usize,
    equations: &[Equation<'m>],
    coordinates: &[Coordinate],
) -> TooMany {
    let closed = redundant::all_closed(analysis, equations, coordinates);
    let at = closed.as_ref().unwrap_or(&analysis.nominal.estimates);
    let Some(found) = position(analysis, at, |at| overconstrained::surplus(at)) else {
        return TooMany {
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
    let spare = loop_list(&found.spare);
    let help = match &closed {
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
    TooMany {
        fact: format!("{all}{}{motion}", found.dependences),
        help,
    }
}

/// What is found out about the loops where the unknowns have these values; nothing if one has no estimate.
fn position<'m, R>(
    analysis: &Analysis<'_, 'm>,
    values: &[Vec<f64>],
    question: impl FnOnce(&Position<'_, 'm>) -> Option<R>,
) -> Option<R> {
    let mechanism = analysis.algebra.mechanism;
    let mut unknowns = mechanism.unknowns.iter();
    if unknowns.any(|unknown| unknown.estimate.is_none()) {
        return None;
    }
    let words = MessageFormat::new(mechanism);
    question(&Position::new(
        &words,
        analysis.nominal,
        redundant::longest(analysis),
        values.to_vec(),
    ))
}
