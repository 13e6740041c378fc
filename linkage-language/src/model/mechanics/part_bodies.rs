//! Bodies, joints and loads of parts.

use crate::diagnostic::SourceSpan;
use crate::model::expression::members::find_body;
use crate::model::parts::embed::Embedding;
use crate::model::parts::embed_bodies::MemberNumbers;
use crate::model::symbols::member_names::MemberNames;
use crate::model::symbols::part_scopes::Parts;
use crate::model::symbols::sink::Sink;
use crate::model::types::Mechanism;
use crate::syntax::PartItem;

/// Bodies of parts, with the joints that they hang on.
pub(in crate::model) fn embed_bodies(
    parts: &Parts,
    members: &MemberNames,
    sink: &mut Sink,
    items: &[&PartItem],
    numbers: &mut [MemberNumbers],
    mechanism: &mut Mechanism,
) {
    for ((part, item), numbers) in items.iter().enumerate().zip(numbers) {
        if let Some(on) = &item.on {
            numbers.on = find_body(parts, members, sink, on).flatten();
        }
        let embedding = Embedding::new(&parts.scopes[part], &mechanism.lets, &parts.placed);
        let Some(embedding) = embedding else { continue };
        let bodies: Vec<_> = embedding.bodies(*numbers).collect();
        let joints: Vec<_> = embedding.joints(*numbers, true).collect();
        if let Some(joint) = joints.first() {
            let count = joint.at.ty.components().unwrap_or(2);
            let expected = *sink.components.get_or_insert(count);
            if expected != count {
                refuse_other_space(sink, item, count);
            }
        }
        mechanism.bodies.extend(bodies);
        mechanism.joints.extend(joints);
    }
}

fn refuse_other_space(sink: &mut Sink, item: &PartItem, count: usize) {
    let (here, others) = match count {
        3 => ("in space", "in the plane"),
        _ => ("in the plane", "in space"),
    };
    let fact = format!(
        "the bodies of the part `{}` are {here}, those before it {others}",
        item.name
    );
    let help = "forces are those of the plane or of space: write all points alike";
    let span = SourceSpan::from(&item.name);
    sink.error_with_help(span, fact, help);
}

/// Adds joints of parts that close loops, loads on their bodies, and gravity if the mechanism
/// itself has none.
pub(in crate::model) fn embed_mechanics(
    parts: &Parts,
    sink: &mut Sink,
    items: &[&PartItem],
    numbers: &[MemberNumbers],
    mechanism: &mut Mechanism,
) {
    let said = mechanism.gravity.is_some();
    for ((part, item), numbers) in items.iter().enumerate().zip(numbers) {
        let embedding = Embedding::new(&parts.scopes[part], &mechanism.lets, &parts.placed);
        let Some(embedding) = embedding else { continue };
        let gravity = embedding.gravity();
        let joints: Vec<_> = embedding.joints(*numbers, false).collect();
        let loads: Vec<_> = embedding.loads(*numbers).collect();
        let elements: Vec<_> = embedding.elements(*numbers).collect();
        let frictions: Vec<_> = embedding.frictions(*numbers).collect();
        mechanism.joints.extend(joints);
        mechanism.loads.extend(loads);
        mechanism.elements.extend(elements);
        mechanism.frictions.extend(frictions);
        match (&mechanism.gravity, gravity) {
            (_, None) => {}
            (None, gravity) => mechanism.gravity = gravity,
            (Some(first), Some(other)) if !said && *first != other => {
                let fact = format!(
                    "the gravity of the part `{}` is not that of the parts before it",
                    item.name
                );
                let help = "write the `gravity` of the whole mechanism, which counts for all parts";
                sink.error_with_help((&item.name).into(), fact, help);
            }
            (Some(_), Some(_)) => {}
        }
    }
}
