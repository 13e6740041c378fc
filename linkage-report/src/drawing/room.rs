//! Free room on paper: boxes of words against convex shapes with a width.

use std::vec::Vec;

use super::geometry::distance;

/// Left, top, right, bottom.
pub(super) type Area = [f64; 4];

/// A shape through places, with half the width of its stroke: one place is a circle, two are a bar,
/// more a convex polygon.
#[derive(Clone, Debug)]
pub(super) struct Taken {
    places: Vec<[f64; 2]>,
    half: f64,
    /// The box about the places.
    bounds: Area,
}

/// Boxes whose distance is greater by more than this, in millimetres, are farther despite rounding.
const ROUNDING: f64 = 1e-6;

impl Taken {
    pub(super) fn new(places: &[[f64; 2]], half: f64) -> Self {
        let mut bounds = [
            f64::INFINITY,
            f64::INFINITY,
            f64::NEG_INFINITY,
            f64::NEG_INFINITY,
        ];
        for [x, y] in places {
            bounds[0] = bounds[0].min(*x);
            bounds[1] = bounds[1].min(*y);
            bounds[2] = bounds[2].max(*x);
            bounds[3] = bounds[3].max(*y);
        }
        Self {
            places: Vec::from(places),
            half,
            bounds,
        }
    }

    /// Returns the box about the shape, its stroke aside.
    pub(super) fn bounds(&self) -> Area {
        self.bounds
    }

    pub(super) fn from_area([left, top, right, bottom]: Area) -> Self {
        let corners = [[left, top], [right, top], [right, bottom], [left, bottom]];
        Self::new(&corners, 0.0)
    }

    /// Returns the smaller one of a distance and the distance of a box from the shape. Most shapes
    /// are farther away, which the boxes about them show.
    pub(super) fn least_room(&self, area: Area, known: f64) -> f64 {
        let aside = (self.bounds[0] - area[2]).max(area[0] - self.bounds[2]);
        let above = (self.bounds[1] - area[3]).max(area[1] - self.bounds[3]);
        if aside.max(0.0).hypot(above.max(0.0)) - self.half > known + ROUNDING {
            return known;
        }
        known.min(self.room(area))
    }

    /// Returns the distance of a box from the shape, negative or zero where the box covers it.
    pub(super) fn room(&self, area: Area) -> f64 {
        let middle = [0.5 * (area[0] + area[2]), 0.5 * (area[1] + area[3])];
        if self.places.len() > 2 && is_within(middle, &self.places) {
            return -self.half;
        }
        let next = self.places.iter().cycle().skip(1);
        let sides = self.places.iter().zip(next);
        let distances = sides.map(|(a, b)| from_stretch(area, [*a, *b]));
        distances.fold(f64::INFINITY, f64::min) - self.half
    }

    /// Returns true if a stretch crosses the shape, which is a stretch itself.
    pub(super) fn crosses(&self, [a, b]: [[f64; 2]; 2]) -> bool {
        let [c, d] = [self.places[0], self.places[self.places.len() - 1]];
        let side = |p: [f64; 2], q: [f64; 2], r: [f64; 2]| {
            (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])
        };
        side(a, b, c) * side(a, b, d) < 0.0 && side(c, d, a) * side(c, d, b) < 0.0
    }
}

fn from_stretch(area: Area, [a, b]: [[f64; 2]; 2]) -> f64 {
    if passes_through(area, a, b) {
        return 0.0;
    }
    let [left, top, right, bottom] = area;
    let corners = [[left, top], [right, top], [right, bottom], [left, bottom]];
    let from_corners = corners.map(|corner| distance(corner, [a, b]));
    let from_ends = [a, b].map(|end| from_place(area, end));
    from_corners
        .into_iter()
        .chain(from_ends)
        .fold(f64::INFINITY, f64::min)
}

fn from_place([left, top, right, bottom]: Area, [x, y]: [f64; 2]) -> f64 {
    let aside = (left - x).max(x - right).max(0.0);
    aside.hypot((top - y).max(y - bottom).max(0.0))
}

/// Clips the stretch to the box, after Liang and Barsky.
fn passes_through([left, top, right, bottom]: Area, a: [f64; 2], b: [f64; 2]) -> bool {
    let (mut from, mut to) = (0.0f64, 1.0f64);
    for (k, low, high) in [(0, left, right), (1, top, bottom)] {
        let (step, low, high) = (b[k] - a[k], low - a[k], high - a[k]);
        if step == 0.0 {
            if low > 0.0 || high < 0.0 {
                return false;
            }
        } else {
            from = from.max((low / step).min(high / step));
            to = to.min((low / step).max(high / step));
        }
    }
    from <= to
}

fn is_within([x, y]: [f64; 2], corners: &[[f64; 2]]) -> bool {
    let next = corners.iter().cycle().skip(1);
    let sides = corners
        .iter()
        .zip(next)
        .map(|(a, b)| (b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0]));
    let sides: Vec<f64> = sides.collect();
    sides.iter().all(|side| *side > 0.0) || sides.iter().all(|side| *side < 0.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn room_is_what_is_between_box_and_shape() {
        let area = [0.0, 0.0, 4.0, 2.0];
        assert_eq!(Taken::new(&[[7.0, 6.0]], 1.0).room(area), 4.0);
        assert_eq!(Taken::new(&[[-1.0, 1.0], [9.0, 1.5]], 0.5).room(area), -0.5);
        assert_eq!(Taken::new(&[[6.0, -9.0], [6.0, 9.0]], 0.5).room(area), 1.5);
        // A box that lies wholly within.
        let around = [[-9.0, -9.0], [9.0, -9.0], [0.0, 20.0]];
        assert_eq!(Taken::new(&around, 0.25).room(area), -0.25);
        assert_eq!(Taken::from_area([5.0, 0.0, 6.0, 1.0]).room(area), 1.0);
    }

    #[test]
    fn the_least_room_is_that_of_the_nearest_shape() {
        let area = [0.0, 0.0, 4.0, 2.0];
        let shapes = [
            Taken::new(&[[7.0, 6.0]], 1.0),
            Taken::new(&[[6.0, -9.0], [9.0, 9.0]], 0.5),
            Taken::new(&[[-9.0, -9.0], [9.0, -9.0], [0.0, 20.0]], 0.25),
        ];
        for known in [9.0, 4.5, 4.0, 1.5, 0.0, -0.1, -3.0] {
            for shape in &shapes {
                assert_eq!(shape.least_room(area, known), known.min(shape.room(area)));
            }
        }
    }

    #[test]
    fn stretches_cross_or_do_not() {
        let line = Taken::new(&[[0.0, 0.0], [2.0, 2.0]], 0.0);
        assert!(line.crosses([[0.0, 2.0], [2.0, 0.0]]));
        assert!(!line.crosses([[0.0, 2.0], [0.9, 1.1]]));
    }
}
