//! Remarks in a description, and the messages of mechanisms that have none.

use linkage_engine::Mechanism;

use super::closures::{freedoms_left, motions};
use super::coupling::Missed;
use super::declared::Declared;
use super::driven_joints::{Motion, RunningName};
use super::joint_relations::Relations;
use super::skeleton::Skeleton;
use crate::failure::Failure;

/// The format, with what its equations between joints can carry.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Format {
    Urdf,
    Mjcf,
}

impl Format {
    pub(super) fn degree(self) -> usize {
        match self {
            Self::Urdf => super::urdf::DEGREE,
            Self::Mjcf => super::mjcf::DEGREE,
        }
    }

    /// The element that couples joints, as messages name it.
    pub(super) fn element(self) -> &'static str {
        match self {
            Self::Urdf => "`mimic` of URDF is linear",
            Self::Mjcf => "`equality/joint` of MuJoCo has degree 4 at most",
        }
    }
}

/// The message for joints that the format cannot couple.
pub(super) fn missed(
    all: &[Missed],
    motion: &Motion,
    input: RunningName,
    format: Format,
) -> Failure {
    let mut text = format!("{}: the joints cannot follow", format.element());
    let mut cut: Option<[f64; 2]> = None;
    for Missed {
        coordinate,
        error,
        range: [low, high],
    } in all
    {
        let coordinate = &motion.coordinates[*coordinate];
        let unit = if coordinate.is_length() { "m" } else { "rad" };
        text += &format!(
            "\n  `{}`: error {error:.3e} {unit}; kept from {} to {}",
            coordinate.name,
            input.written(*low),
            input.written(*high)
        );
        let [from, to] = cut.unwrap_or([*low, *high]);
        cut = Some([from.max(*low), to.min(*high)]);
    }
    if let Some([low, high]) = cut {
        text += &format!(
            "\nhelp: cut the range by `--range {}..{}`, allow a larger `--error`",
            input.written(low),
            input.written(high)
        );
    }
    text += match format {
        Format::Urdf => {
            ", or take `linkage mjcf`, whose polynomials have degree 4 and whose loops are constraints"
        }
        Format::Mjcf => ", or leave `--error` out: loops are constraints then",
    };
    text += "; `linkage c` has the exact functions";
    Failure::Told(text)
}

/// Refuses joints that leave more motions than the mechanism has.
pub(super) fn closed(
    mechanism: &Mechanism,
    skeleton: &Skeleton,
    relations: &Relations,
    motion: &Motion,
) -> Result<(), Failure> {
    let left = freedoms_left(skeleton, relations, &motion.coordinates);
    let expected = motions(mechanism, skeleton);
    match left > expected {
        false => Ok(()),
        true => Err(Failure::Told(format!(
            "the declared joints leave {left} independent motions, but the mechanism has {expected}\nhelp: declare the joint that closes each loop, as `pin a = coupler on rocker at p;`, and write a relation of angles as `gears` or `belt` of joints and links; or give `--error`, which couples the joints by polynomials"
        ))),
    }
}

/// Remarks at the beginning of a description.
pub(super) fn remarks(
    declared: &Declared,
    skeleton: &Skeleton,
    motion: &Motion,
    ends: [f64; 2],
    input: RunningName,
) -> Vec<String> {
    let mut remarks = vec![format!(
        "all joints are zero at {} = {}, unless `ref` shifts one; metres, kilograms, radians",
        input.name,
        input.written(skeleton.reference())
    )];
    let driver = &motion.coordinates[motion.driver].name;
    if motion.rate.is_none() {
        remarks.push(format!(
            "`{driver}` drives, and is no multiple of {}, which goes from {} to {}",
            input.name,
            input.written(ends[0]),
            input.written(ends[1])
        ));
    }
    if !declared.loads.is_empty() {
        let loads = declared.loads.join(", ");
        eprintln!("note: loads are not part of a description: {loads}");
        remarks.push(format!("not written: {loads}"));
    }
    remarks
}
