//! Sealed cylinders of newer pages: a barrel and a rod, whose inner joints follow from the mounts.

use crate::document::{FRAME, Input, InputKind};
use crate::error::ImportError;
use crate::names::shown;

use super::conversion::Assembly;
use super::page_drawing::PageJoint;

/// Replaces barrel and rod by a link between the mounts, whose length is the input. Returns false
/// if the slide is no cylinder, or if its barrel or rod has more joints.
pub(super) fn read(assembly: &mut Assembly, slide: &PageJoint) -> Result<bool, ImportError> {
    let (true, Some([carrier, first, second])) = (slide.is_sealed, &slide.carrier) else {
        return Ok(false);
    };
    let Some(barrel) = assembly.links.get(carrier).copied() else {
        return Ok(false);
    };
    let pin = assembly.joint(&slide.id)?;
    let ends = [assembly.joint(first)?, assembly.joint(second)?];
    let document = &assembly.document;
    let rods = document.links_of(pin).into_iter();
    let rods: Vec<usize> = rods
        .filter(|link| *link != barrel && *link != FRAME)
        .collect();
    let [rod] = rods[..] else {
        return Ok(false);
    };
    let is_plain = |link: usize, joints: [usize; 2]| {
        let of_link = &document.links[link].joints;
        of_link.len() == 2 && joints.iter().all(|joint| of_link.contains(joint))
    };
    let mount = document.links[rod]
        .joints
        .iter()
        .find(|joint| **joint != pin);
    let Some(mount) = mount.copied() else {
        return Ok(false);
    };
    if !is_plain(barrel, ends) || !is_plain(rod, [pin, mount]) {
        return Ok(false);
    }
    // The inner end of the barrel is nearer to the mount of the rod. Older pages have any order.
    let [first, second] = ends.map(|joint| (joint, document.distance(joint, mount)));
    let (fixed, inner) = if first.1 >= second.1 {
        (first.0, second.0)
    } else {
        (second.0, first.0)
    };
    let names = [inner, pin].map(|joint| shown(&document.joints[joint].name));
    let is_input = slide.is_input || assembly.pin(slide).is_some_and(|pin| pin.is_input);
    let document = &mut assembly.document;
    document.links[barrel].joints.clear();
    document.links[rod].joints.clear();
    if is_input {
        let name = document.links[barrel].name.clone();
        let link = document.add_link(name, vec![fixed, mount]);
        document.inputs.push(Input {
            kind: InputKind::Length { link },
            travel: None,
            speed: None,
            rate: None,
        });
        document.remarks.push(format!(
            "The joints {} and {} inside of a cylinder follow from its mounts and are left out.",
            names[0], names[1]
        ));
    } else {
        document.warnings.push(format!(
            "a cylinder without a drive between `{}` and `{}` holds nothing and is left out",
            shown(&document.joints[fixed].name),
            shown(&document.joints[mount].name)
        ));
    }
    Ok(true)
}
