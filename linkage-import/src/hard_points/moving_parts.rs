//! Points that move with the carrier, a wishbone or the rocker; the rocker and the damper.

use super::rocker::{Outer, Rocker, wishbone_axes};
use super::roles::Points;
use super::suspension::Suspension;
use crate::error::ImportError;
use crate::robots::{Vector, difference, dot, length, unit};

impl Suspension {
    /// A point of a wishbone, as a name; its frame is a `let`.
    fn on_wishbone(&mut self, points: &Points, role: &str, arm: &str) -> Option<(Vector, Outer)> {
        let [front, rear, ball] = ["front", "rear", "ball"].map(|end| format!("{arm}_{end}"));
        if !points.has(&[&front, &rear, &ball]) {
            return None;
        }
        let [front_at, rear_at, ball_at] =
            [&front, &rear, &ball].map(|role| points.point(role).unwrap_or_default());
        let at = points.point(role)?;
        let frame = format!("{arm}_wishbone");
        let line = format!("let {frame} = frame({front}, {rear} - {front}, {ball} - {front});");
        if !self.lets.contains(&line) {
            self.lets.push(line);
        }
        // The axes of that frame where it is drawn.
        let axes = wishbone_axes(front_at, rear_at, ball_at)?;
        let apart = difference(at, front_at);
        let inner = axes.map(|axis| dot(axis, apart));
        let local = self.point(inner);
        self.parameters.push(format!(
            "param {arm}_{role} = {local};    // in the frame of the wishbone"
        ));
        self.lets
            .push(format!("let {role} = point_in({frame}, {arm}_{role});"));
        self.quantity(role, at);
        let outer = Outer::Wishbone {
            front: front_at,
            rear: rear_at,
            ball: ball_at,
            local: inner,
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
            let at = match end {
                "carrier" => self
                    .on_carrier(points, &role)
                    .map(|at| (at, Outer::Carrier(at))),
                // Only of a damper, whose end needs no reach.
                "rocker" => self
                    .on_rocker(points, &role)
                    .map(|at| (at, Outer::Carrier(at))),
                arm => self.on_wishbone(points, &role, arm),
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

    fn on_rocker(&mut self, points: &Points, role: &str) -> Option<Vector> {
        let pivot = points.point("rocker_pivot")?;
        if !points.has(&["rocker_axis", "push_rocker"]) {
            return None;
        }
        let at = points.point(role)?;
        let local = self.point(difference(at, pivot));
        self.parameters.push(format!(
            "param rocker_{role} = {local};    // from the pivot"
        ));
        self.lets.push(format!(
            "let {role} = rocker_pivot + turn(rocker_{role}, rocker_axis - rocker_pivot, rocker);"
        ));
        self.quantity(role, at);
        Some(at)
    }

    /// The rocker turns with the push rod.
    pub(super) fn rocker(&mut self, points: &Points) -> Result<(), ImportError> {
        let roles = ["rocker_pivot", "rocker_axis", "push_rocker"];
        if !points.has(&roles) {
            for role in roles.iter().filter(|role| points.has(&[**role])) {
                self.warnings.push(format!(
                    "the point `{role}` needs also {}: it is left out",
                    roles.join(", ").replace(&format!("{role}, "), "")
                ));
            }
            return Ok(());
        }
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
        let Some((outer, outer_at, on)) = self.moving(points, "push") else {
            self.warnings.push(
                "no point has the role `push_carrier`, `push_lower` or `push_upper`: the rocker is left out"
                    .to_owned(),
            );
            return Ok(());
        };
        let Some(inner_at) = self.on_rocker(points, "push_rocker") else {
            return Ok(());
        };
        self.unknowns.push("unknown rocker = 0deg;".to_owned());
        let push_rod = length(difference(outer_at, inner_at));
        self.rocker = Some(Rocker {
            outer: on,
            pivot,
            axis,
            inner: inner_at,
            push_rod,
        });
        let long = self.length(push_rod);
        self.parameters.push(format!("param push_rod = {long};"));
        self.loops
            .push(format!("loop distance({outer}, push_rocker) = push_rod;"));
        self.quantities.push("rocker".to_owned());
        Ok(())
    }

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
