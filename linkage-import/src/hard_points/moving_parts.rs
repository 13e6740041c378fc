//! The rocker with its push rod, and the damper.

use super::rocker::{Outer, Rocker, wishbone_axes};
use super::roles::Points;
use super::suspension::{LinkLine, Suspension};
use crate::error::ImportError;
use crate::placement::{Vector, difference, dot, length, unit};

/// The roles that a rocker needs.
const ROCKER: [&str; 3] = ["rocker_pivot", "rocker_axis", "push_rocker"];

impl Suspension {
    /// A point of a wishbone, where it is drawn and in the frame of the wishbone.
    fn on_wishbone(&mut self, points: &Points, role: &str, arm: &str) -> Option<(Vector, Outer)> {
        let [front, rear, ball] =
            ["front", "rear", "ball"].map(|end| points.point(&format!("{arm}_{end}")));
        let at = self.on_link(points, role, &format!("{arm}_arm"))?;
        let axes = wishbone_axes(front?, rear?, ball?)?;
        let apart = difference(at, front?);
        let outer = Outer::Wishbone {
            front: front?,
            rear: rear?,
            ball: ball?,
            local: axes.map(|axis| dot(axis, apart)),
        };
        Some((at, outer))
    }

    /// A point that moves: with the carrier, a wishbone or the rocker.
    fn moving(&mut self, points: &Points, prefix: &str) -> Option<(String, Vector, Outer)> {
        for end in ["carrier", "lower", "upper", "rocker"] {
            let role = format!("{prefix}_{end}");
            if points.point(&role).is_none() || prefix == "push" && end == "rocker" {
                continue;
            }
            let has_link = |link: &str| self.links.iter().any(|line| line.name == link);
            let at = match end {
                "carrier" => self
                    .on_carrier(points, &role)
                    .map(|at| (at, Outer::Carrier(at))),
                // Only of a damper, whose end needs no reach.
                "rocker" if has_link("rocker") => self
                    .on_link(points, &role, "rocker")
                    .map(|at| (at, Outer::Carrier(at))),
                arm if has_link(&format!("{arm}_arm")) => self.on_wishbone(points, &role, arm),
                _ => None,
            };
            match at {
                Some((at, outer)) => return Some((role, at, outer)),
                None => self.warnings.push(format!(
                    "the point `{role}` is on a part that the suspension does not have: it is left out"
                )),
            }
        }
        None
    }

    /// The rocker turns with the push rod.
    pub(super) fn rocker(&mut self, points: &Points) -> Result<(), ImportError> {
        if !points.has(&ROCKER) {
            for role in ROCKER.iter().filter(|role| points.has(&[**role])) {
                self.warnings.push(format!(
                    "the point `{role}` needs also {}: it is left out",
                    ROCKER.join(", ").replace(&format!("{role}, "), "")
                ));
            }
            return Ok(());
        }
        let Some((outer, outer_at, on)) = self.moving(points, "push") else {
            self.warnings.push(
                "no point has the role `push_carrier`, `push_lower` or `push_upper`: the rocker is left out"
                    .to_owned(),
            );
            return Ok(());
        };
        let (Some(pivot), Some(axis)) = (
            self.chassis(points, "rocker_pivot"),
            self.chassis(points, "rocker_axis"),
        ) else {
            return Ok(());
        };
        if unit(difference(axis, pivot)).is_none() {
            return Err(ImportError::new(
                "both points on the axis of the rocker are one",
            ));
        }
        self.links.push(LinkLine {
            name: "rocker".to_owned(),
            joints: vec!["rocker_pivot".to_owned()],
            clause: " about rocker_axis - rocker_pivot".to_owned(),
            lengths: Vec::new(),
        });
        let Some(inner) = self.on_link(points, "push_rocker", "rocker") else {
            return Ok(());
        };
        self.rod_link("push_rod", [&outer, "push_rocker"]);
        self.rocker = Some(Rocker {
            outer: on,
            pivot,
            axis,
            inner,
            push_rod: length(difference(outer_at, inner)),
        });
        self.quantities.push("rocker: rocker.angle".to_owned());
        Ok(())
    }

    /// The length of the damper.
    pub(super) fn damper(&mut self, points: &Points) {
        if self.chassis(points, "damper_chassis").is_none() {
            return;
        }
        match self.moving(points, "damper") {
            Some((role, ..)) => {
                self.lets
                    .push(format!("let damper = distance({role}, damper_chassis);"));
                self.quantities.push("damper".to_owned());
                self.quantities
                    .push("damper_ratio: velocity(damper)".to_owned());
            }
            None => self.warnings.push(
                "the damper has no moving end: `damper_rocker`, `damper_lower`, `damper_upper` or `damper_carrier`"
                    .to_owned(),
            ),
        }
    }
}
