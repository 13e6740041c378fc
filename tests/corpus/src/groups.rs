//! The groups that a mechanism is chained of, each in several written forms.

use crate::builder::{Body, Builder, Point};
use crate::builder::{Vector, along_and_across, angle, cross, direction, dot, length, minus, step};

/// Every group keeps this far from its dead points (sine of the transmission angle).
const CLEAR: f64 = 0.5;

impl Builder {
    /// Appends one group at random; false if no configuration was found for it.
    pub(crate) fn add_group(&mut self) -> bool {
        match self.random.below(12) {
            0..4 => self.two_rotors(),
            4 | 5 => self.rotor_and_slide(),
            6 | 7 => self.slide_on_rotor(),
            8 => self.two_slides(),
            9 => self.scalar_rotor(),
            10 => self.scalar_slide(),
            _ => self.relation(),
        }
    }

    /// A moving point and another one, moving or fixed.
    pub(crate) fn pair(&mut self) -> (Point, Point) {
        let moving: Vec<Point> = self
            .points
            .iter()
            .filter(|p| p.inputs != 0)
            .cloned()
            .collect();
        // The last points are taken more often, so that groups chain.
        let last = moving.len().saturating_sub(3);
        let place = if self.random.chance(0.7) { last } else { 0 };
        let a = self.random.pick(&moving[place..]).clone();
        let others: Vec<Point> = self
            .points
            .iter()
            .filter(|p| length(minus(p.at, a.at)) > 20.0)
            .cloned()
            .collect();
        if others.is_empty() || self.random.chance(0.6) {
            let at = step(
                a.at,
                self.random.between(50.0, 110.0),
                self.random.between(-3.1, 3.1),
            );
            return (a, self.pivot(at));
        }
        let b = self.random.pick(&others).clone();
        (a, b)
    }

    /// A place that satisfies a condition.
    fn place(&mut self, about: Vector, good: impl Fn(Vector) -> bool) -> Option<Vector> {
        (0..400)
            .map(|_| {
                let x = self.random.between(-100.0, 100.0);
                [about[0] + x, about[1] + self.random.between(-100.0, 100.0)]
            })
            .find(|&p| good(p))
    }

    /// A direction for a guide: fixed, or turning with a link.
    fn guide(&mut self) -> Body {
        if self.random.chance(0.25) {
            return self.axis();
        }
        if self.random.chance(0.5) || self.bodies.is_empty() {
            let value = self.random.between(-3.1, 3.1);
            let text = self.angle(value);
            return Body {
                text,
                angle: value,
                inputs: 0,
            };
        }
        let bodies = self.bodies.clone();
        let body = self.random.pick(&bodies).clone();
        let offset = self.random.between(-1.5, 1.5);
        let name = self.angle(offset);
        let text = format!("{} + {name}", body.text);
        Body {
            text,
            angle: body.angle + offset,
            inputs: body.inputs,
        }
    }

    /// RRR
    fn two_rotors(&mut self) -> bool {
        let (a, b) = self.pair();
        let Some(c) = self.place(a.at, |c| joint(c, a.at, b.at)) else {
            return false;
        };
        let (ac, bc) = (minus(c, a.at), minus(c, b.at));
        let (l1, l2) = (length(ac), length(bc));
        let (t1, t2) = (angle(ac), angle(bc));
        let form = self.random.below(11);
        if form == 7 {
            return self.two_distances(&a, &b, c);
        }
        let mut inputs = a.inputs | b.inputs;
        let first_length = if (form == 6 || form == 10) && self.inputs.len() < 3 {
            let closed = self.random.between(0.3, 0.7) * l1;
            let dead = self.length(closed);
            let (stroke, bit) = self.input("x", l1 - closed, false);
            inputs |= bit;
            format!("({dead} + {stroke})")
        } else {
            self.length(l1)
        };
        let theta = self.unknown_angle(t1, inputs);
        let (a, b) = (&a.text, &b.text);
        let second = match form {
            1 => {
                let relative = self.unknown_angle(t2 - t1, inputs);
                format!("{theta} + {relative}")
            }
            _ => self.unknown_angle(t2, inputs),
        };
        let l2 = match form {
            2 => format!("(-{})", self.length(-l2)),
            _ => self.length(l2),
        };
        let end = format!("{a} + polar({first_length}, {theta})");
        match form {
            3 => self.close(
                format!("polar({first_length}, {theta}) - {l2} * dir({second})"),
                format!("{b} - {a}"),
                inputs,
                true,
            ),
            4 => self.close(
                format!("{a} + rotate(({first_length}, 0mm), {theta})"),
                format!("{b} + polar(-{l2}, {second} + 180deg)"),
                inputs,
                true,
            ),
            _ => self.close(
                end.clone(),
                format!("{b} + polar({l2}, {second})"),
                inputs,
                true,
            ),
        }
        let body = Body {
            text: theta,
            angle: t1,
            inputs,
        };
        self.add_point(&end, c, inputs);
        if self.random.chance(0.6) {
            self.add_ternary(a, minus(c, ac), &body);
        }
        self.bodies.push(body);
        self.add_body(&second, t2, inputs);
        true
    }

    /// RRR by an unknown point at two distances.
    fn two_distances(&mut self, a: &Point, b: &Point, c: Vector) -> bool {
        let inputs = a.inputs | b.inputs;
        let p = self.unknown_point(c, inputs);
        for end in [a, b] {
            let link = self.length(length(minus(c, end.at)));
            let text = &end.text;
            let left = match self.random.below(3) {
                0 => format!("norm({p} - {text})"),
                1 => format!("norm({text} - {p})"),
                _ => format!("distance({p}, {text})"),
            };
            self.close(left, link, inputs, true);
        }
        self.add_point(&p, c, inputs);
        true
    }

    /// RRP, PRR
    fn rotor_and_slide(&mut self) -> bool {
        let (a, b) = self.pair();
        let guide = self.guide();
        let good = |c: Vector| {
            let rod = minus(c, a.at);
            let (along, across) = along_and_across(minus(c, b.at), guide.angle);
            dot(rod, direction(guide.angle)).abs() > CLEAR * length(rod)
                && reasonable(rod)
                && along.abs() < 150.0
                && across.abs() < 40.0
        };
        let Some(c) = self.place(a.at, good) else {
            return false;
        };
        let inputs = a.inputs | b.inputs | guide.inputs;
        let rod = minus(c, a.at);
        let (along, across) = along_and_across(minus(c, b.at), guide.angle);
        let (l, e) = (self.length(length(rod)), self.length(across));
        let theta = self.unknown_angle(angle(rod), inputs);
        let slide = self.unknown_length(along, inputs);
        let (start, foot, way) = (&a.text, &b.text, &guide.text);
        let left = format!("{start} + polar({l}, {theta})");
        let right = match self.random.below(3) {
            0 => format!("{foot} + polar({slide}, {way}) + polar({e}, {way} + 90deg)"),
            1 => format!("{foot} + rotate(({slide}, {e}), {way})"),
            _ => format!("{foot} + dir({way}) * {slide} + {e} * dir(90deg + {way})"),
        };
        self.close(left.clone(), right, inputs, true);
        self.add_point(&left, c, inputs);
        let body = Body {
            text: theta,
            angle: angle(rod),
            inputs,
        };
        if self.random.chance(0.6) {
            self.add_ternary(start, a.at, &body);
        }
        self.bodies.push(body);
        true
    }

    /// RPR: the guide turns.
    fn slide_on_rotor(&mut self) -> bool {
        let (a, b) = self.pair();
        let reach = minus(a.at, b.at);
        let across = self.random.between(-0.4, 0.4) * length(reach);
        let across = if self.random.chance(0.3) { 0.0 } else { across };
        let along = (length(reach).powi(2) - across * across).sqrt();
        let along = if self.random.chance(0.2) {
            -along
        } else {
            along
        };
        let t = angle(reach) - across.atan2(along);
        let inputs = a.inputs | b.inputs;
        let e = if across == 0.0 {
            "0mm".to_owned()
        } else {
            self.length(across)
        };
        let theta = self.unknown_angle(t, inputs);
        let slide = self.unknown_length(along, inputs);
        let right = match self.random.below(3) {
            _ if across == 0.0 => format!("{} + polar({slide}, {theta})", b.text),
            0 => format!("{} + rotate(({slide}, {e}), {theta})", b.text),
            1 => format!(
                "{} + polar({slide}, {theta}) + polar({e}, {theta} + 90deg)",
                b.text
            ),
            _ => format!(
                "{} + {slide} * dir({theta}) - polar({e}, {theta} - 90deg)",
                b.text
            ),
        };
        self.close(a.text.clone(), right, inputs, true);
        let body = Body {
            text: theta,
            angle: t,
            inputs,
        };
        self.add_ternary(&b.text, b.at, &body);
        self.bodies.push(body);
        true
    }

    /// PRP, RPP
    fn two_slides(&mut self) -> bool {
        let (a, b) = self.pair();
        let (first, second) = (self.guide(), self.guide());
        let sine = cross(direction(first.angle), direction(second.angle));
        if sine.abs() < CLEAR {
            return false;
        }
        let reach = minus(b.at, a.at);
        let s1 = cross(reach, direction(second.angle)) / sine;
        let s2 = cross(reach, direction(first.angle)) / sine;
        let inputs = a.inputs | b.inputs | first.inputs | second.inputs;
        let (x, y) = (
            self.unknown_length(s1, inputs),
            self.unknown_length(s2, inputs),
        );
        let end = format!("{} + polar({x}, {})", a.text, first.text);
        let right = format!("{} + polar({y}, {})", b.text, second.text);
        self.close(end.clone(), right, inputs, true);
        self.add_point(&end, step(a.at, s1, first.angle), inputs);
        true
    }
}

/// A joint between two links from `a` and `b`, away from dead points.
pub(crate) fn joint(c: Vector, a: Vector, b: Vector) -> bool {
    let (ac, bc) = (minus(c, a), minus(c, b));
    reasonable(ac) && reasonable(bc) && cross(ac, bc).abs() > CLEAR * length(ac) * length(bc)
}

fn reasonable(link: Vector) -> bool {
    (25.0..150.0).contains(&length(link))
}
