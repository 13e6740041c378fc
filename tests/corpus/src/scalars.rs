//! Groups of one scalar loop, and cranks that a law of motion or a spline turns.

use crate::builder::{
    Body, Builder, along_and_across, direction, dot, length, minus, radians, step,
};
use crate::groups::joint;
use std::f64::consts::PI;

impl Builder {
    /// One unknown angle.
    pub(crate) fn scalar_rotor(&mut self) -> bool {
        let (a, b) = self.pair();
        let (radius, t) = (
            self.random.between(30.0, 90.0),
            self.random.between(-3.1, 3.1),
        );
        let c = step(a.at, radius, t);
        if !joint(c, a.at, b.at) {
            return false;
        }
        let inputs = a.inputs | b.inputs;
        let link = self.length(radius);
        let theta = self.unknown_angle(t, inputs);
        let end = format!("{} + polar({link}, {theta})", a.text);
        if self.random.chance(0.6) {
            let other = self.length(length(minus(c, b.at)));
            self.close(format!("distance({end}, {})", b.text), other, inputs, true);
        } else {
            let normal = self.random.between(-1.0, 1.0) + t + PI / 2.0;
            let height = dot(direction(normal), minus(c, b.at));
            let (normal, height) = (self.angle(normal), self.length(height));
            let left = format!("dot(dir({normal}), {end} - {})", b.text);
            self.close(left, height, inputs, true);
        }
        self.add_point(&end, c, inputs);
        self.add_body(&theta, t, inputs);
        true
    }

    /// One unknown length: quadratic or linear.
    pub(crate) fn scalar_slide(&mut self) -> bool {
        let (a, b) = self.pair();
        let (way, s) = (
            self.random.between(-3.1, 3.1),
            self.random.between(20.0, 90.0),
        );
        let c = step(a.at, s, way);
        let rod = minus(c, b.at);
        let (along, _) = along_and_across(rod, way);
        if along.abs() < 0.5 * length(rod) || !(25.0..150.0).contains(&length(rod)) {
            return false;
        }
        let inputs = a.inputs | b.inputs;
        let guide = self.angle(way);
        let slide = self.unknown_length(s, inputs);
        let end = format!("{} + polar({slide}, {guide})", a.text);
        if self.random.chance(0.5) {
            let link = self.length(length(rod));
            self.close(format!("distance({}, {end})", b.text), link, inputs, true);
        } else {
            let normal = self.random.between(-0.8, 0.8) + way;
            let height = dot(direction(normal), minus(c, b.at));
            let (normal, height) = (self.angle(normal), self.length(height));
            let left = format!("dot({end} - {}, dir({normal}))", b.text);
            self.close(left, height, inputs, true);
        }
        self.add_point(&end, c, inputs);
        true
    }

    /// An angle relation, and a link that turns with its angle.
    pub(crate) fn relation(&mut self) -> bool {
        let moving: Vec<Body> = self
            .bodies
            .iter()
            .filter(|b| b.inputs != 0)
            .cloned()
            .collect();
        let body = self.random.pick(&moving).clone();
        let constant = self.random.between(-2.0, 2.0);
        let constant = (constant * 1e7).round() / 1e7;
        let shift = self.angle(constant);
        let (text, inputs) = (&body.text, body.inputs);
        let (value, written) = match self.random.below(4) {
            0 => (
                constant - 2.0 * body.angle,
                format!("{shift} - 2 * ({text})"),
            ),
            1 => (constant - body.angle, format!("{shift} - ({text})")),
            2 => (
                constant + 3.0 * body.angle,
                format!("3 * ({text}) + {shift}"),
            ),
            _ => (
                constant + body.angle / 2.0,
                format!("({text}) / 2 + {shift}"),
            ),
        };
        let name = self.unknown_angle(value, inputs);
        self.close(name.clone(), written, inputs, false);
        let pivot = self.pivot([0.0, 0.0]);
        let arm = self.random.between(20.0, 50.0);
        let at = step(pivot.at, arm, value);
        let arm = self.length(arm);
        if self.random.chance(0.5) {
            let point = self.unknown_point(at, inputs);
            let right = format!("{} + polar({arm}, {name})", pivot.text);
            self.close(point.clone(), right, inputs, false);
            self.add_point(&point, at, inputs);
        } else {
            self.add_point(
                &format!("{} + polar({arm}, {name})", pivot.text),
                at,
                inputs,
            );
        }
        self.add_body(&name, value, inputs);
        true
    }

    /// A direction along an axis, written as a number.
    pub(crate) fn axis(&mut self) -> Body {
        let degrees = *self.random.pick(&[0, 90, 180, -90]);
        let text = format!("{degrees}deg");
        let text = if degrees < 0 {
            format!("({text})")
        } else {
            text
        };
        let angle = f64::from(degrees).to_radians();
        Body {
            text,
            angle,
            inputs: 0,
        }
    }

    /// A driving crank, perhaps with a gear beside it.
    pub(crate) fn crank(&mut self) {
        let at = [
            self.random.between(-40.0, 40.0),
            self.random.between(-40.0, 40.0),
        ];
        let (radius, turn) = (
            self.random.between(20.0, 50.0),
            self.random.between(-3.1, 3.1),
        );
        let turn = (turn.to_degrees() * 10.0).round() / 10.0;
        let value = turn.to_radians();
        let (phi, bit) = self.input("phi", value, true);
        let origin = self.random.chance(0.2);
        let at = if origin { [0.0; 2] } else { at };
        let start = match origin {
            true => String::new(),
            false => format!("{} + ", self.pivot(at).text),
        };
        let link = self.length(radius);
        let expression = format!("{start}polar({link}, {phi})");
        self.add_point(&expression, step(at, radius, value), bit);
        self.add_body(&phi, value, bit);
        if self.random.chance(0.4) {
            let start = self.random.between(-1.0, 1.0);
            let name = self.angle(start);
            let gear = self.name("g");
            let (value, text) = match self.random.below(3) {
                0 => (start - value / 2.0, format!("{name} - {phi} / 2")),
                1 => (2.0 * value + start, format!("2 * {phi} + {name}")),
                _ => (start - value, format!("{name} - {phi}")),
            };
            self.items.push(format!("let {gear} = {text};"));
            self.add_body(&gear, value, bit);
            let at = [at[0] + self.random.between(30.0, 60.0), at[1]];
            let pivot = self.pivot(at);
            let arm = self.random.between(15.0, 40.0);
            let place = step(at, arm, value);
            let arm = self.length(arm);
            self.add_point(
                &format!("{} + polar({arm}, {gear})", pivot.text),
                place,
                bit,
            );
        }
    }
}

// Cranks that a law of motion or a spline turns. All of them are symmetric about their middle, where the configuration stands: there the value
// is the mean of those at the ends.

const LAWS: [&str; 8] = [
    "line",
    "cubic",
    "poly345",
    "poly4567",
    "harmonic",
    "cycloidal",
    "modified_sine",
    "modified_trapezoid",
];

impl Builder {
    /// A crank whose angle is a course along the first input.
    pub(crate) fn course_crank(&mut self) {
        let (phi, value) = (self.inputs[0].name.clone(), self.inputs[0].value);
        let half = self.random.between(0.6, 1.5);
        let [from, to] = [value - half, value + half].map(radians);
        let ends = [(); 2].map(|()| self.random.between(-2.0, 2.0));
        let mean = (ends[0] + ends[1]) / 2.0;
        let [a, b] = ends.map(|own| self.angle(own));
        let law = *self.random.pick(&LAWS);
        let written = match self.random.below(6) {
            0 => format!("spline({phi}, [({from}, {a}), ({to}, {b})], clamped)"),
            1 => format!("spline({phi}, [({from}, {a}), ({to}, {b})], clamped, quintic)"),
            2 => format!("spline({phi}, [({from}, {a}, {b}), ({to}, {b}, {b})])"),
            3 => {
                let width = radians(2.0 * half);
                format!("{a} + ({b} - {a}) * rise(({phi} - {from}) / {width}, {law})")
            }
            _ => {
                let back = radians(value + half + 1.0);
                format!(
                    "piecewise({phi}, [({from}, {a}), ({to}, {b}, {law}), ({back}, {a}, cycloidal)])"
                )
            }
        };
        let name = self.name("c");
        self.items.push(format!("let {name} = {written};"));
        self.add_body(&name, mean, 1);
        let at = [
            self.random.between(-60.0, -30.0),
            self.random.between(-40.0, 40.0),
        ];
        let pivot = self.pivot(at);
        let arm = self.random.between(20.0, 45.0);
        let place = step(at, arm, mean);
        let arm = self.length(arm);
        self.add_point(&format!("{} + polar({arm}, {name})", pivot.text), place, 1);
    }
}
