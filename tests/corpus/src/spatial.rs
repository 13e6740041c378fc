//! Groups in space, each in several written forms.

use crate::builder::{Body, Builder};
use crate::space::{Direction, Vector, cross, dot, length, minus, plus, spread, turn, unit};

/// Every group keeps this far from its dead points.
const CLEAR: f64 = 0.45;

/// So many configurations are tried.
const TRIALS: usize = 200;

impl Builder {
    /// Appends one group in space at random; false if no configuration was found for it.
    pub(crate) fn add_group_in_space(&mut self) -> bool {
        match self.random.below(12) {
            0 => self.link_to_slider(),
            1..4 => self.point_in_space(),
            4..7 => self.link_to_rocker(),
            7 => self.universal_joint(),
            8..10 => self.three_slides(),
            10 => self.direction_between(),
            _ => self.two_slides_and_an_angle(),
        }
    }

    /// A body that the inputs move.
    fn moving_body(&mut self) -> Body {
        let moving = self.bodies.iter().filter(|b| b.inputs != 0);
        let moving: Vec<Body> = moving.cloned().collect();
        self.random.pick(&moving).clone()
    }

    /// `|a - b| = l` for a name and an expression, in one of its forms.
    fn close_distance(&mut self, a: &str, b: &str, value: f64, inputs: u32) {
        let l = self.length(value);
        let b = match b.contains(" + ") {
            true => format!("({b})"),
            false => b.to_owned(),
        };
        let (left, right) = match self.random.below(4) {
            0 => (format!("norm({a} - {b})"), l),
            1 => (format!("dot({b} - {a}, {b} - {a})"), format!("{l} * {l}")),
            _ => (format!("distance({a}, {b})"), l),
        };
        self.close(left, right, inputs, true);
    }

    /// RSSR
    fn link_to_rocker(&mut self) -> bool {
        let a = self.moving_place();
        let axis = self.any_direction();
        for _ in 0..TRIALS {
            let pivot = self.near(a.at);
            let arm = self.unit_vector().map(|x| 60.0 * x);
            let psi = self.random.between(-3.1, 3.1);
            let turned = turn(arm, axis.unit, psi);
            let end = plus(pivot, 1.0, turned);
            let link = minus(end, a.at);
            let slope = cross(axis.unit, turned);
            if !reasonable(link)
                || length(slope) < 30.0
                || dot(link, slope).abs() < CLEAR * length(link) * length(slope)
            {
                continue;
            }
            let inputs = a.inputs;
            let pivot = self.fixed("f", pivot);
            let arm = self.fixed("v", arm);
            let name = self.unknown_angle(psi, inputs);
            let turned = format!("turn({}, {}, {name})", arm.text, axis.text);
            let text = format!("{} + {turned}", pivot.text);
            let end = self.add_place(&text, end, inputs);
            let written = if self.random.chance(0.5) {
                &text
            } else {
                &end.text
            };
            self.close_distance(&a.text, written, length(link), inputs);
            if self.random.chance(0.5) {
                self.add_projection(&end);
            }
            self.add_body(&name, psi, inputs);
            return true;
        }
        false
    }

    /// RSSP
    fn link_to_slider(&mut self) -> bool {
        let a = self.moving_place();
        let b = self.other_place(&a);
        let guide = self.guide_in_space();
        for _ in 0..TRIALS {
            let s = self.random.between(-90.0, 90.0);
            let end = plus(b.at, s, guide.unit);
            let link = minus(end, a.at);
            if !reasonable(link) || dot(link, guide.unit).abs() < CLEAR * length(link) {
                continue;
            }
            let inputs = a.inputs | b.inputs | guide.inputs;
            let (slide, way) = self.slide(s, &guide, inputs);
            let text = format!("{} + {slide} * {way}", b.text);
            self.close_distance(&a.text, &text, length(link), inputs);
            let end = self.add_place(&text, end, inputs);
            if self.random.chance(0.5) {
                self.add_projection(&end);
            }
            return true;
        }
        false
    }

    /// An unknown length along a direction, and that direction as a unit vector.
    fn slide(&mut self, s: f64, guide: &Direction, inputs: u32) -> (String, String) {
        (
            self.unknown_length(s, inputs),
            format!("unit({})", guide.text),
        )
    }

    /// A point by distances and planes, at least one distance.
    fn point_in_space(&mut self) -> bool {
        let a = self.moving_place();
        let spheres = 1 + self.random.below(3);
        let mut centres = vec![a.clone()];
        while centres.len() < spheres {
            centres.push(self.other_place(&a));
        }
        let mut normals: Vec<Direction> = Vec::new();
        while normals.len() + spheres < 3 {
            normals.push(self.guide_in_space());
        }
        for _ in 0..TRIALS {
            let p = self.near(a.at);
            let arms: Vec<Vector> = centres.iter().map(|c| minus(p, c.at)).collect();
            let rows: Vec<Vector> = arms
                .iter()
                .copied()
                .chain(normals.iter().map(|n| n.unit))
                .collect();
            if !arms.iter().all(|arm| reasonable(*arm)) || spread(rows[0], rows[1], rows[2]) < CLEAR
            {
                continue;
            }
            let of_centres = centres.iter().fold(0, |bits, c| bits | c.inputs);
            let inputs = normals.iter().fold(of_centres, |bits, n| bits | n.inputs);
            let name = self.unknown_place(p, inputs);
            for (centre, arm) in centres.iter().zip(&arms) {
                self.close_distance(&name, &centre.text, length(*arm), inputs);
            }
            for normal in &normals {
                let on = self.near(p);
                let height = dot(normal.unit, minus(p, on));
                let (on, height) = (self.fixed("f", on), self.length(height));
                let left = format!("dot(unit({}), {name} - {})", normal.text, on.text);
                self.close(left, height, inputs, true);
            }
            let place = self.add_place(&name, p, inputs);
            self.add_projection(&place);
            return true;
        }
        false
    }

    /// A direction at given angles to two known ones.
    fn direction_between(&mut self) -> bool {
        let body = self.moving_body();
        let (u, v) = (self.turning_direction(&body), self.guide_in_space());
        for _ in 0..TRIALS {
            let n = self.unit_vector();
            if spread(n, u.unit, v.unit) < CLEAR {
                continue;
            }
            let inputs = u.inputs | v.inputs;
            let name = self.unknown_direction(n, inputs);
            let norm = match self.random.below(2) {
                0 => format!("norm({name})"),
                _ => format!("dot({name}, {name})"),
            };
            self.close(norm, "1".to_owned(), inputs, true);
            for known in [&u, &v] {
                let angle = self.angle(dot(n, known.unit).acos());
                let left = format!("dot({name}, unit({}))", known.text);
                self.close(left, format!("cos({angle})"), inputs, true);
            }
            self.add_arm(&name, n, inputs);
            return true;
        }
        false
    }

    /// A point on a link along a direction.
    fn add_arm(&mut self, text: &str, direction: Vector, inputs: u32) {
        let start = self.unit_vector().map(|x| 40.0 * x);
        let arm = self.random.between(30.0, 60.0);
        let at = plus(start, arm, direction);
        let (start, arm) = (self.fixed("f", start), self.length(arm));
        self.add_place(&format!("{} + {arm} * {text}", start.text), at, inputs);
    }

    /// Two directions, each turning about its own axis, at a given angle: a universal joint, a spherical four-bar.
    fn universal_joint(&mut self) -> bool {
        let body = self.moving_body();
        let u = self.turning_direction(&body);
        let axis = self.any_direction();
        for _ in 0..TRIALS {
            let start = self.unit_vector();
            let psi = self.random.between(-3.1, 3.1);
            let w = turn(start, axis.unit, psi);
            // The known direction and the turning one as they are seen along the axis.
            let reach = length(cross(axis.unit, u.unit)) * length(cross(axis.unit, start));
            let slope = dot(u.unit, cross(axis.unit, w)).abs();
            if reach < 0.4 || slope < CLEAR * reach {
                continue;
            }
            let inputs = u.inputs;
            let start = self.direction(start);
            let name = self.unknown_angle(psi, inputs);
            let turned = format!("turn(unit({}), {}, {name})", start.text, axis.text);
            let angle = self.angle(dot(u.unit, w).acos());
            let left = format!("dot(unit({}), {turned})", u.text);
            self.close(left, format!("cos({angle})"), inputs, true);
            self.add_arm(&turned, w, inputs);
            self.add_body(&name, psi, inputs);
            return true;
        }
        false
    }

    /// Three unknown lengths.
    fn three_slides(&mut self) -> bool {
        let a = self.moving_place();
        let b = self.other_place(&a);
        let guides = [0; 3].map(|_| self.guide_in_space());
        let [e, f, g] = [0, 1, 2].map(|k| guides[k].unit);
        let determinant = dot(e, cross(f, g));
        if determinant.abs() < CLEAR {
            return false;
        }
        let reach = minus(b.at, a.at);
        let shares = [cross(f, g), cross(g, e), cross(e, f)].map(|n| dot(reach, n) / determinant);
        let inputs = guides
            .iter()
            .fold(a.inputs | b.inputs, |bits, guide| bits | guide.inputs);
        let slides = [0, 1, 2].map(|k| self.slide(shares[k], &guides[k], inputs));
        let [(s, e), (t, f), (w, g)] = slides;
        let text = format!("{} + {s} * {e}", a.text);
        let right = format!("{} - {w} * {g}", b.text);
        self.close(format!("{text} + {t} * {f}"), right, inputs, true);
        let at = plus(a.at, shares[0], guides[0].unit);
        self.add_place(&text, at, inputs);
        true
    }

    /// Two unknown lengths and an angle.
    fn two_slides_and_an_angle(&mut self) -> bool {
        let a = self.moving_place();
        let (e, f) = (self.any_direction(), self.guide_in_space());
        let axis = self.any_direction();
        let across = cross(e.unit, f.unit);
        if length(across) < 0.5 {
            return false;
        }
        let across = unit(across);
        for _ in 0..TRIALS {
            let arm = self.unit_vector().map(|x| 60.0 * x);
            let psi = self.random.between(-3.1, 3.1);
            let turned = turn(arm, axis.unit, psi);
            let reach = length(cross(axis.unit, arm)) * length(cross(axis.unit, across));
            let slope = dot(across, cross(axis.unit, turned)).abs();
            if reach < 24.0 || slope < CLEAR * reach {
                continue;
            }
            let inputs = a.inputs | f.inputs;
            let shares = [0; 2].map(|_| self.random.between(-60.0, 60.0));
            let along = plus(e.unit.map(|x| shares[0] * x), shares[1], f.unit);
            // The frame's point closes the loop.
            let base = minus(plus(a.at, 1.0, along), turned);
            let (base, arm) = (self.fixed("f", base), self.fixed("v", arm));
            let (s, ways) = self.slide(shares[0], &e, inputs);
            let (t, wayt) = self.slide(shares[1], &f, inputs);
            let name = self.unknown_angle(psi, inputs);
            let text = format!("{} + turn({}, {}, {name})", base.text, arm.text, axis.text);
            let left = format!("{} + {s} * {ways} + {t} * {wayt}", a.text);
            self.close(left, text.clone(), inputs, true);
            self.add_place(&text, plus(base.at, 1.0, turned), inputs);
            self.add_body(&name, psi, inputs);
            return true;
        }
        false
    }
}

fn reasonable(link: Vector) -> bool {
    (25.0..150.0).contains(&length(link))
}
