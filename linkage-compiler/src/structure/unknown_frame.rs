//! The unknown frames of a model, with the loops about each.

use crate::algebra::{Names, Nominal};
use crate::message_format::MessageFormat;
use crate::mobility::Position;
use crate::model::{Mechanism, unknown_frames};
use crate::structure::loops_together;

/// An unknown frame of the model.
pub(crate) struct UnknownFrame {
    /// Its origin, and two axes or an angle.
    pub(crate) unknowns: Vec<usize>,
    /// 6 in space, 3 in the plane.
    pub(crate) freedoms: usize,
    /// A loop that holds it, for example.
    pub(crate) example: &'static str,
    pub(crate) name: String,
    /// The loops that mention it, without its own.
    pub(crate) loops: Vec<usize>,
}

/// Returns all unknown frames of a mechanism.
pub(crate) fn unknown_frames(mechanism: &Mechanism) -> Vec<UnknownFrame> {
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

/// Runs a check of the loops where the unknowns have these values; nothing if one has no estimate.
pub(crate) fn position<'m, R>(
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
        loops_together::longest(names, nominal),
        values.to_vec(),
    ))
}
