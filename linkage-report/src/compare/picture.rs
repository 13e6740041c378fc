//! The drawing of a design among others.

use serde_json::{Value, json};
use std::collections::BTreeMap;
use std::vec::Vec;

use crate::arc_slot::ArcSlot;
use crate::builder::Report;
use crate::drawing::View;
use crate::positioned_picture;
use crate::positioned_picture::PositionedPicture;
use crate::traced_points::traced_points;
use linkage_core::{GuideOn, PointKind};

/// The number of steps across a drawing, finer than a screen shows them.
const STEPS: f64 = 10_000.0;

/// Places in the plane of the page, over the rows that are shown.
pub(super) struct Drawn<'a> {
    shown: PositionedPicture<'a>,
    report: &'a Report,
    view: View,
}

impl<'a> Drawn<'a> {
    pub(super) fn new(report: &'a Report) -> Option<Self> {
        let shown = positioned_picture::find_picture(report)?;
        let view = View::new(shown.picture.dimension);
        Some(Self {
            shown,
            report,
            view,
        })
    }

    /// Returns the limits of all drawn points over these rows, in both directions.
    pub(super) fn extent(&self, rows: &[usize]) -> [[f64; 2]; 2] {
        let mut extent = [[f64::INFINITY, f64::NEG_INFINITY]; 2];
        let mut hold = |point: [f64; 2]| {
            for (ends, x) in extent.iter_mut().zip(point).filter(|(_, x)| x.is_finite()) {
                *ends = [ends[0].min(x), ends[1].max(x)];
            }
        };
        for point in self.points() {
            rows.iter()
                .for_each(|&row| hold(self.on_screen(point, row)));
        }
        self.rails(rows).into_iter().flatten().for_each(hold);
        extent
    }

    /// Points with their places, links, guides of the frame and paths; indices are those of the
    /// points here. Places are rounded to a step of the drawing.
    pub(super) fn value(&self, rows: &[usize], size: f64) -> Value {
        let step = 10f64.powf((size / STEPS).log10().floor());
        // The divisor is a whole number, so that decimals are read back as they were.
        let rounded = |x: f64| match step < 1.0 {
            true => (x / step).round() / (1.0 / step).round(),
            false => (x / step).round() * step,
        };
        let points = self.points();
        let number: BTreeMap<usize, usize> = points
            .iter()
            .enumerate()
            .map(|(k, &point)| (point, k))
            .collect();
        let coordinate = |point: usize, k: usize| -> Value {
            let all: Vec<f64> = rows
                .iter()
                .map(|&row| rounded(self.on_screen(point, row)[k]))
                .collect();
            match all.iter().all(|x| *x == all[0]) {
                true => json!(all[0]),
                false => json!(all),
            }
        };
        let kinds = self.shown.picture.points;
        let all = points.iter().map(|&point| {
            json!({
                "name": kinds[point].name,
                "ground": kinds[point].kind == PointKind::Ground,
                "x": coordinate(point, 0),
                "y": coordinate(point, 1),
            })
        });
        let links = self.shown.picture.links.iter();
        let links = links.map(|link| {
            link.points
                .iter()
                .map(|point| number[point])
                .collect::<Vec<_>>()
        });
        let rails = self.rails(rows).into_iter().map(|line| -> Vec<[f64; 2]> {
            line.into_iter().map(|point| point.map(rounded)).collect()
        });
        let traces = traced_points(self.report, &self.shown);
        json!({
            "points": all.collect::<Vec<_>>(),
            "links": links.collect::<Vec<_>>(),
            "rails": rails.collect::<Vec<_>>(),
            "traces": traces.iter().map(|point| number[point]).collect::<Vec<_>>(),
        })
    }

    /// Returns the points that links join and paths follow.
    fn points(&self) -> Vec<usize> {
        let picture = self.shown.picture;
        let of_links = picture
            .links
            .iter()
            .flat_map(|link| link.points.iter().copied());
        let sliders = picture.guides.iter().map(|guide| guide.slider);
        let traced = traced_points(self.report, &self.shown);
        let mut all: Vec<usize> = of_links.chain(sliders).chain(traced).collect();
        all.sort_unstable();
        all.dedup();
        all
    }

    /// Guides of the frame, as far as their sliders go.
    fn rails(&self, rows: &[usize]) -> Vec<Vec<[f64; 2]>> {
        let guides = self.shown.picture.guides.iter();
        let fixed = guides.filter(|guide| guide.on == GuideOn::Frame);
        let ends = fixed.filter_map(|guide| {
            let row = *rows.iter().find(|&&row| self.shown.is_assembled(row))?;
            if let Some(slot) = ArcSlot::new(&self.shown, guide, row) {
                return Some(slot.middle_line());
            }
            let (from, way) = (
                self.shown.point_at(guide.origin, row),
                self.shown.way(guide.direction, row),
            );
            let at = |t: f64| {
                self.view
                    .project(core::array::from_fn(|k| from[k] + t * way[k]))
            };
            Some(Vec::from(self.shown.rail(guide).map(at)))
        });
        ends.collect()
    }

    fn on_screen(&self, point: usize, row: usize) -> [f64; 2] {
        self.view.project(self.shown.point_at(point, row))
    }
}
