//! Joints, gears and driven links of a picture.

use serde_json::{Value, json};
use std::vec::Vec;

use crate::drawing::PitchCircles;
use crate::joint_signs::sign;
use crate::positioned_picture::PositionedPicture;
use linkage_core::DriveOn;

/// Adds it to the picture.
pub(super) fn add(picture: &mut Value, shown: &PositionedPicture<'_>) {
    picture["joints"] = joints(shown);
    picture["gears"] = gears(shown);
    picture["drives"] = drives(shown);
}

fn joints(shown: &PositionedPicture<'_>) -> Value {
    let joints = shown.picture.joints.iter();
    let joint = |joint: &linkage_runtime::PictureJoint| {
        json!({
            "point": joint.point,
            "shape": sign(joint.shape).name,
        })
    };
    joints.map(joint).collect::<Vec<_>>().into()
}

/// Those whose wheels have a size.
fn gears(shown: &PositionedPicture<'_>) -> Value {
    let gears = shown.picture.gears.iter();
    let gears = gears.filter_map(|gear| {
        let wheels = PitchCircles::new(shown, gear)?;
        let PitchCircles { radii, ratio, belt } = wheels;
        Some(json!({ "centres": gear.centres, "radii": radii, "ratio": ratio, "belt": belt }))
    });
    gears.collect::<Vec<_>>().into()
}

fn drives(shown: &PositionedPicture<'_>) -> Value {
    let drives = shown.picture.drives.iter().map(|drive| match drive.on {
        DriveOn::Turn(points) => json!({ "turn": points }),
        DriveOn::Slide(guide) => json!({ "slide": guide }),
    });
    drives.collect::<Vec<_>>().into()
}
