//! The links that hold the carrier: wishbones, rods, the strut and the tie rod; the wheel.

use super::axes::Meaning;
use super::roles::Points;
use super::suspension::{LinkLine, Suspension};
use super::wheel_travel::Hold;
use crate::error::ImportError;
use crate::placement::{difference, length, normals, scaled, sum, unit};

/// The letters of both points beside the strut.
const BESIDE: [&str; 2] = ["strut_n", "strut_m"];

impl Suspension {
    /// Adds all links that hold the carrier.
    pub(super) fn suspended(&mut self, points: &Points) -> Result<(), ImportError> {
        match points.kind {
            "five rods" => {
                for number in 1..=5 {
                    let [inner, outer] = ["inner", "outer"].map(|end| format!("rod{number}_{end}"));
                    self.rod(points, &format!("rod{number}"), [&inner, &outer]);
                }
                return Ok(());
            }
            "strut" => {
                self.wishbone(points, "lower")?;
                self.strut(points)?;
            }
            _ => {
                self.wishbone(points, "lower")?;
                self.wishbone(points, "upper")?;
            }
        }
        self.tie_rod(points);
        Ok(())
    }

    /// A wishbone turns about the line of its pivots.
    fn wishbone(&mut self, points: &Points, arm: &str) -> Result<(), ImportError> {
        let [front, rear, ball] = ["front", "rear", "ball"].map(|end| format!("{arm}_{end}"));
        let (Some(front_at), Some(rear_at), Some(ball_at)) = (
            self.chassis(points, &front),
            self.chassis(points, &rear),
            self.on_carrier(points, &ball),
        ) else {
            return Ok(());
        };
        if unit(difference(rear_at, front_at)).is_none() {
            return Err(ImportError::new(format!(
                "both pivots of the {arm} wishbone are one point"
            )));
        }
        for fixed in [front_at, rear_at] {
            let moving = ball_at;
            self.holds.push(Hold::Rod { fixed, moving });
        }
        self.links.push(LinkLine {
            name: format!("{arm}_arm"),
            joints: vec![front.clone(), ball.clone()],
            clause: format!(" about {rear} - {front}"),
            lengths: [front, rear].map(|pivot| [pivot, ball.clone()]).to_vec(),
        });
        Ok(())
    }

    fn rod(&mut self, points: &Points, name: &str, [inner, outer]: [&str; 2]) {
        let (Some(fixed), Some(moving)) =
            (self.chassis(points, inner), self.on_carrier(points, outer))
        else {
            return;
        };
        self.rod_link(name, [inner, outer]);
        self.holds.push(Hold::Rod { fixed, moving });
    }

    /// The inner end of the tie rod is on the rack, which goes across the car.
    fn tie_rod(&mut self, points: &Points) {
        let (Some(fixed), Some(moving)) = (
            points.point("tie_inner"),
            self.on_carrier(points, "tie_outer"),
        ) else {
            return;
        };
        let unit = self.unit;
        let at = self.point(fixed);
        self.parameters.push(format!(
            "param rack = 0{unit};    // shift of the rack to the left; which way it steers follows"
        ));
        self.parameters
            .push(format!("let tie_inner = {at} + (0{unit}, rack, 0{unit});"));
        self.rack_end = Some(fixed);
        self.rod_link("tie_rod", ["tie_inner", "tie_outer"]);
        self.holds.push(Hold::Rod { fixed, moving });
    }

    /// The upper mount is on the axis of the strut, which is fixed on the carrier: two points beside
    /// the axis give the directions across.
    fn strut(&mut self, points: &Points) -> Result<(), ImportError> {
        let (Some(fixed), Some(moving)) = (
            self.chassis(points, "strut_top"),
            self.on_carrier(points, "strut_bottom"),
        ) else {
            return Ok(());
        };
        let axis = difference(fixed, moving);
        let Some(along) = unit(axis) else {
            return Err(ImportError::new("both ends of the strut are one point"));
        };
        let across = normals(along);
        for (name, normal) in BESIDE.iter().zip(across) {
            self.beside_carrier(name, sum(moving, scaled(normal, length(axis))));
            self.loops.push(format!(
                "loop dot(strut_top - strut_bottom, {name} - strut_bottom) = 0;"
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
    pub(super) fn wheel(&mut self, points: &Points, meaning: &Meaning) {
        self.on_carrier(points, "contact");
        let Some(at) = points.point("spindle") else {
            self.warnings.push(
                "no point has the role `spindle`: the axis of the wheel is not known, so there is no camber and no toe"
                    .to_owned(),
            );
            return;
        };
        let axis = difference(at, self.centre);
        if unit(axis).is_none() {
            self.warnings
                .push("the `spindle` is the wheel centre: no camber and no toe".to_owned());
            return;
        }
        self.on_carrier(points, "spindle");
        let outwards = match axis[1] * meaning.outside() < 0.0 {
            true => "wheel_centre - spindle",
            false => "spindle - wheel_centre",
        };
        self.lets.push(format!(
            "let wheel_axis = ({outwards}) / norm({outwards});    // to the outside"
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
