//! The text of a suspension.

use super::axes::Meaning;
use super::rocker::Rocker;
use super::roles::Points;
use super::wheel_travel::{Hold, reach};
use crate::drawn::{Drawn, DrawnPoint, Drive, Measure};
use crate::error::ImportError;
use crate::number::plain;
use crate::robots::{Placement, Vector, difference, length, normals, unit};

/// The largest travel that is tried, as a part of the distance from the chassis to the wheel.
const MOST_TRAVEL: f64 = 0.15;

/// The part of a reach that is left out next to a dead point.
const BESIDE: f64 = 0.9;

/// The lines of a suspension.
#[derive(Default)]
pub(super) struct Suspension {
    pub(super) parameters: Vec<String>,
    pub(super) unknowns: Vec<String>,
    pub(super) lets: Vec<String>,
    pub(super) loops: Vec<String>,
    pub(super) quantities: Vec<String>,
    pub(super) warnings: Vec<String>,
    /// The quantities that are points, where they are drawn.
    points: Vec<(String, Vector)>,
    holds: Vec<Hold>,
    pub(super) rocker: Option<Rocker>,
    unit: &'static str,
    centre: Vector,
}

/// A rod of the carrier: its name, its roles on the chassis and on the carrier.
type RodRoles = (&'static str, &'static str, &'static str);

const WISHBONES: [RodRoles; 5] = [
    ("lower_front_arm", "lower_front", "lower_ball"),
    ("lower_rear_arm", "lower_rear", "lower_ball"),
    ("upper_front_arm", "upper_front", "upper_ball"),
    ("upper_rear_arm", "upper_rear", "upper_ball"),
    ("tie_rod", "tie_inner", "tie_outer"),
];

const STRUT: [RodRoles; 3] = [WISHBONES[0], WISHBONES[1], WISHBONES[4]];

const RODS: [RodRoles; 5] = [
    ("rod1", "rod1_inner", "rod1_outer"),
    ("rod2", "rod2_inner", "rod2_outer"),
    ("rod3", "rod3_inner", "rod3_outer"),
    ("rod4", "rod4_inner", "rod4_outer"),
    ("rod5", "rod5_inner", "rod5_outer"),
];

impl Suspension {
    /// Writes all parts of the suspension.
    pub(super) fn new(points: &Points, meaning: &Meaning) -> Result<Self, ImportError> {
        let centre = points.point("wheel_centre").unwrap_or_default();
        let mut suspension = Self {
            unit: meaning.unit,
            centre,
            ..Self::default()
        };
        if centre[1] * meaning.outside() <= 0.0 {
            return Err(ImportError::new(format!(
                "with these axes the wheel centre is {} of the middle, which is not the {} side\nhelp: another `--side`, or other `--axes`; a middle that is not at 0 must be moved there",
                if centre[1] > 0.0 {
                    "left"
                } else {
                    "right or on it"
                },
                if meaning.is_left { "left" } else { "right" }
            )));
        }
        suspension.unknowns.push(format!(
            "unknown carrier = frame({}, (1, 0, 0), (0, 0, 1));",
            suspension.point(centre)
        ));
        suspension.loops.push(format!(
            "loop carrier.origin.z = {} + travel;",
            suspension.length(centre[2])
        ));
        suspension
            .lets
            .push("let wheel_centre = carrier.origin;".to_owned());
        suspension.quantity("wheel_centre", centre);
        let rods: &[RodRoles] = match points.kind {
            "five rods" => &RODS,
            "strut" => &STRUT,
            _ => &WISHBONES,
        };
        for rod in rods {
            suspension.rod(points, *rod);
        }
        if points.kind == "strut" {
            suspension.strut(points)?;
        }
        suspension.wheel(points, meaning);
        suspension.rocker(points)?;
        suspension.damper(points);
        Ok(suspension)
    }

    /// Adds a point that moves to the quantities.
    pub(super) fn quantity(&mut self, role: &str, at: Vector) {
        self.quantities.push(role.to_owned());
        self.points.push((role.to_owned(), at));
    }

    /// The drawn pose; the travel shifts the wheel centre.
    pub(super) fn drawn(&self) -> Drawn {
        let points = self.points.iter().map(|(name, position)| DrawnPoint {
            name: name.clone(),
            position: *position,
            is_fixed: false,
        });
        let travel = Drive {
            input: "travel".to_owned(),
            rate: 1.0,
            measure: Measure::Shift {
                point: 0,
                origin: None,
                along: [0.0, 0.0, 1.0],
                base: None,
            },
        };
        Drawn {
            function: "motion",
            unit: self.unit,
            band: 0.0,
            points: points.collect(),
            drives: vec![travel],
        }
    }

    /// The input, with the range in which the carrier is held.
    pub(super) fn input(&mut self, points: &Points) -> Result<String, ImportError> {
        let inner = points
            .by_role
            .values()
            .map(|point| length(difference(*point, self.centre)));
        let size = inner.fold(0.0, f64::max);
        let most = MOST_TRAVEL * size;
        let most = round_down(most);
        let found = reach(&self.holds, self.centre, most, size, |placement| {
            self.rocker
                .is_none_or(|rocker| rocker.is_reached(placement))
        });
        let drawn = Placement::shifted([0.0; 3]);
        if self.rocker.is_some_and(|rocker| !rocker.is_reached(&drawn)) {
            return Err(ImportError::new(
                "the push rod points at the axis of the rocker where it is drawn: a dead point",
            ));
        }
        if found[0] == 0.0 || found[1] == 0.0 {
            return Err(ImportError::new(
                "the drawn position is a dead point, or the carrier cannot move: the points do not make a suspension",
            ));
        }
        let ends = [0, 1].map(|end| match found[end].abs() == most {
            true => found[end],
            false => found[end].signum() * round_down(BESIDE * found[end].abs()),
        });
        let [low, high] = ends.map(|end| self.length(end));
        Ok(format!(
            "input travel = 0{} in {low}..{high};    // of the wheel centre, up is bump",
            self.unit
        ))
    }

    pub(super) fn length(&self, value: f64) -> String {
        format!("{}{}", plain(value), self.unit)
    }

    pub(super) fn point(&self, point: Vector) -> String {
        let all = point.map(|value| self.length(value));
        format!("({})", all.join(", "))
    }

    pub(super) fn chassis(&mut self, points: &Points, role: &str) -> Option<Vector> {
        let at = points.point(role)?;
        let line = format!("param {role} = {};", self.point(at));
        if !self.parameters.contains(&line) {
            self.parameters.push(line);
        }
        Some(at)
    }

    /// A point of the carrier, as a name.
    pub(super) fn on_carrier(&mut self, points: &Points, role: &str) -> Option<Vector> {
        let at = points.point(role)?;
        let line = format!("let {role} = point_in(carrier, carrier_{role});");
        if !self.lets.contains(&line) {
            let local = self.point(difference(at, self.centre));
            self.parameters.push(format!(
                "param carrier_{role} = {local};    // from the wheel centre"
            ));
            self.lets.push(line);
            self.quantity(role, at);
        }
        Some(at)
    }

    fn rod(&mut self, points: &Points, (name, inner, outer): RodRoles) {
        let (Some(fixed), Some(moving)) =
            (self.chassis(points, inner), self.on_carrier(points, outer))
        else {
            return;
        };
        let long = self.length(length(difference(moving, fixed)));
        self.parameters.push(format!("param {name} = {long};"));
        let mut on_chassis = inner.to_owned();
        if inner == "tie_inner" {
            // The rack goes across the car.
            self.parameters.push(format!(
                "param rack = 0{};    // shift of the rack to the left; which way it steers follows",
                self.unit
            ));
            on_chassis = format!("{inner} + (0{u}, rack, 0{u})", u = self.unit);
        }
        self.loops
            .push(format!("loop distance({outer}, {on_chassis}) = {name};"));
        self.holds.push(Hold::Rod { fixed, moving });
    }

    /// The upper mount is on the axis of the strut, which is fixed on the carrier.
    fn strut(&mut self, points: &Points) -> Result<(), ImportError> {
        let (Some(fixed), Some(moving)) = (
            self.chassis(points, "strut_top"),
            self.on_carrier(points, "strut_bottom"),
        ) else {
            return Ok(());
        };
        let Some(along) = unit(difference(fixed, moving)) else {
            return Err(ImportError::new("both ends of the strut are one point"));
        };
        let across = normals(along);
        for (name, normal) in ["strut_n", "strut_m"].iter().zip(across) {
            let [x, y, z] = normal.map(plain);
            self.lets.push(format!(
                "let {name} = {x} * carrier.x + {y} * carrier.y + {z} * carrier.z;"
            ));
            self.loops.push(format!(
                "loop dot(strut_top - strut_bottom, {name}) = 0{};",
                self.unit
            ));
        }
        self.quantities
            .push("strut: distance(strut_top, strut_bottom)".to_owned());
        self.holds.push(Hold::Line {
            fixed,
            moving,
            normals: across,
        });
        Ok(())
    }

    /// Camber and toe, if the axis of the wheel is known.
    fn wheel(&mut self, points: &Points, meaning: &Meaning) {
        if points.point("contact").is_some() {
            self.on_carrier(points, "contact");
        }
        let Some(at) = points.point("spindle") else {
            self.warnings.push(
                "no point has the role `spindle`: the axis of the wheel is not known, so there is no camber and no toe"
                    .to_owned(),
            );
            return;
        };
        let axis = difference(at, self.centre);
        // Towards the outside.
        let sign = if axis[1] * meaning.outside() < 0.0 {
            -1.0
        } else {
            1.0
        };
        let Some(axis) = unit(axis.map(|component| sign * component)) else {
            self.warnings
                .push("the `spindle` is the wheel centre: no camber and no toe".to_owned());
            return;
        };
        let [x, y, z] = axis.map(plain);
        self.lets.push(format!(
            "let wheel_axis = {x} * carrier.x + {y} * carrier.y + {z} * carrier.z;    // to the outside"
        ));
        let across = if meaning.is_left {
            "wheel_axis.y"
        } else {
            "-wheel_axis.y"
        };
        self.lets.push(
            "let camber = -asin(wheel_axis.z);    // positive: the top is outside".to_owned(),
        );
        self.lets.push(format!(
            "let toe = atan2(wheel_axis.x, {across});    // positive: the front is inside"
        ));
        self.quantities
            .extend(["camber", "toe"].map(ToOwned::to_owned));
    }
}

/// A length with two digits, not above the given one.
fn round_down(value: f64) -> f64 {
    let step = 10f64.powf(value.abs().log10().floor() - 1.0);
    let found = (value / step).floor() * step;
    // Without the noise of the product.
    format!("{found:.4e}").parse().unwrap_or(found)
}
