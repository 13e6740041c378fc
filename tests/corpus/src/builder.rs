//! The mechanism under construction: its text, and the configuration that it assembles in.

use crate::space::Place;
use linkage_random::Random;

/// A named point of the mechanism.
#[derive(Clone, Debug)]
pub(crate) struct Point {
    pub(crate) text: String,
    pub(crate) at: Vector,
    /// Bit `k`: depends on input `k`.
    pub(crate) inputs: u32,
}

/// A direction that turns with a link, or a fixed one.
#[derive(Clone, Debug)]
pub(crate) struct Body {
    pub(crate) text: String,
    pub(crate) angle: f64,
    pub(crate) inputs: u32,
}

/// An unknown with its value in the configuration: millimetres or radians.
#[derive(Clone, Debug)]
pub struct Unknown {
    /// Its name.
    pub name: String,
    /// Components of its value.
    pub value: Vec<f64>,
    /// True for an angle, or for the numbers of a direction.
    pub is_angle: bool,
    /// Bit `k`: depends on input `k`.
    pub inputs: u32,
}

#[derive(Clone, Debug)]
pub(crate) struct Input {
    pub(crate) name: String,
    pub(crate) value: f64,
    pub(crate) is_angle: bool,
}

/// A loop whose two sides are computed differently, so that their difference tells something.
#[derive(Clone, Debug)]
pub(crate) struct Closure {
    pub(crate) left: String,
    pub(crate) right: String,
    pub(crate) inputs: u32,
}

#[derive(Debug)]
pub(crate) struct Builder {
    pub(crate) random: Random,
    pub(crate) items: Vec<String>,
    pub(crate) points: Vec<Point>,
    pub(crate) places: Vec<Place>,
    pub(crate) bodies: Vec<Body>,
    pub(crate) inputs: Vec<Input>,
    pub(crate) unknowns: Vec<Unknown>,
    pub(crate) closures: Vec<Closure>,
    /// Scalar parameters: name, true for an angle or a number.
    pub(crate) parameters: Vec<(String, bool)>,
    count: usize,
}

impl Builder {
    pub(crate) fn new(seed: u64) -> Self {
        Self {
            random: Random::new(seed),
            items: Vec::new(),
            points: Vec::new(),
            places: Vec::new(),
            bodies: Vec::new(),
            inputs: Vec::new(),
            unknowns: Vec::new(),
            closures: Vec::new(),
            parameters: Vec::new(),
            count: 0,
        }
    }

    /// A fresh name.
    pub(crate) fn name(&mut self, start: &str) -> String {
        self.count += 1;
        format!("{start}{}", self.count)
    }

    /// A length of the mechanism: a parameter, sometimes a constant.
    pub(crate) fn length(&mut self, value: f64) -> String {
        let name = self.name("l");
        let literal = millimetres(value);
        if self.random.chance(0.1) {
            self.items.push(format!("const {name} = {literal};"));
        } else {
            let tolerance = if self.random.chance(0.3) {
                " +- 20um"
            } else {
                ""
            };
            self.items
                .push(format!("param {name} = {literal}{tolerance};"));
            self.parameters.push((name.clone(), false));
        }
        name
    }

    /// A fixed angle of the mechanism.
    pub(crate) fn angle(&mut self, value: f64) -> String {
        let name = self.name("w");
        self.items
            .push(format!("param {name} = {};", radians(value)));
        self.parameters.push((name.clone(), true));
        name
    }

    /// A point of the frame.
    pub(crate) fn pivot(&mut self, at: Vector) -> Point {
        let name = self.name("f");
        let (x, y) = (millimetres(at[0]), millimetres(at[1]));
        if self.random.chance(0.15) {
            self.items.push(format!("const {name} = ({x}, {y});"));
        } else {
            self.items.push(format!("param {name} = ({x}, {y});"));
            self.parameters.push((format!("{name}.x"), false));
            self.parameters.push((format!("{name}.y"), false));
        }
        let text = name;
        Point {
            text,
            at,
            inputs: 0,
        }
    }

    pub(crate) fn unknown_angle(&mut self, value: f64, inputs: u32) -> String {
        let name = self.name("t");
        let estimate = value.to_degrees().round();
        self.items.push(format!("unknown {name} = {estimate}deg;"));
        self.unknowns.push(Unknown {
            name: name.clone(),
            value: vec![value],
            is_angle: true,
            inputs,
        });
        name
    }

    pub(crate) fn unknown_length(&mut self, value: f64, inputs: u32) -> String {
        let name = self.name("s");
        self.items.push(format!("unknown {name} = {value:.1}mm;"));
        self.unknowns.push(Unknown {
            name: name.clone(),
            value: vec![value],
            is_angle: false,
            inputs,
        });
        name
    }

    pub(crate) fn unknown_point(&mut self, at: Vector, inputs: u32) -> String {
        let name = self.name("p");
        self.items.push(format!(
            "unknown {name} = ({:.1}mm, {:.1}mm);",
            at[0], at[1]
        ));
        let value = at.to_vec();
        self.unknowns.push(Unknown {
            name: name.clone(),
            value,
            is_angle: false,
            inputs,
        });
        name
    }

    /// A loop; `telling` if its two sides are not one expression for the compiler.
    pub(crate) fn close(&mut self, left: String, right: String, inputs: u32, telling: bool) {
        let (left, right) = if self.random.chance(0.5) {
            (left, right)
        } else {
            (right, left)
        };
        self.items.push(format!("loop {left} = {right};"));
        if telling {
            self.closures.push(Closure {
                left,
                right,
                inputs,
            });
        }
    }

    /// A `let` for a point, to which later groups can be joined.
    pub(crate) fn add_point(&mut self, expression: &str, at: Vector, inputs: u32) {
        let text = self.name("q");
        self.items.push(format!("let {text} = {expression};"));
        self.points.push(Point { text, at, inputs });
    }

    pub(crate) fn add_body(&mut self, text: &str, angle: f64, inputs: u32) {
        self.bodies.push(Body {
            text: text.to_owned(),
            angle,
            inputs,
        });
    }

    /// A point fixed on a link that turns: a ternary link.
    pub(crate) fn add_ternary(&mut self, base: &str, at: Vector, body: &Body) {
        let arm = self.random.between(20.0, 60.0);
        let lift = self.random.between(-2.5, 2.5);
        let place = step(at, arm, body.angle + lift);
        let (arm, lift) = (self.length(arm), self.angle(lift));
        self.add_point(
            &format!("{base} + polar({arm}, {} + {lift})", body.text),
            place,
            body.inputs,
        );
    }

    /// A driving coordinate.
    pub(crate) fn input(&mut self, start: &str, value: f64, is_angle: bool) -> (String, u32) {
        let name = self.name(start);
        self.inputs.push(Input {
            name: name.clone(),
            value,
            is_angle,
        });
        (name, 1 << (self.inputs.len() - 1))
    }
}

pub(crate) fn millimetres(value: f64) -> String {
    format!("{value:.4}mm")
}

pub(crate) fn radians(value: f64) -> String {
    format!("{value:.7}rad")
}

// Plane vectors of the chosen configuration.

/// A vector or point, millimetres.
pub(crate) type Vector = [f64; 2];

pub(crate) fn direction(angle: f64) -> Vector {
    [angle.cos(), angle.sin()]
}

/// `a + length (cos angle, sin angle)`
pub(crate) fn step(a: Vector, length: f64, angle: f64) -> Vector {
    let [c, s] = direction(angle);
    [a[0] + length * c, a[1] + length * s]
}

pub(crate) fn minus(a: Vector, b: Vector) -> Vector {
    [a[0] - b[0], a[1] - b[1]]
}

pub(crate) fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

pub(crate) fn cross(a: Vector, b: Vector) -> f64 {
    a[0] * b[1] - a[1] * b[0]
}

pub(crate) fn length(a: Vector) -> f64 {
    a[0].hypot(a[1])
}

pub(crate) fn angle(a: Vector) -> f64 {
    a[1].atan2(a[0])
}

/// A point in polar coordinates about `b`: `(cos, sin)` components of `a` along and across `guide`.
pub(crate) fn along_and_across(a: Vector, guide: f64) -> (f64, f64) {
    let g = direction(guide);
    (dot(g, a), cross(g, a))
}
