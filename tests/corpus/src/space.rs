//! Vectors and points of the chosen configuration in space, and how they are written.

use crate::builder::{self, Body, Builder, Unknown, millimetres};

/// A vector or point in space, millimetres; a direction.
pub(crate) type Vector = [f64; 3];

/// A named point in space.
#[derive(Clone, Debug)]
pub(crate) struct Place {
    pub(crate) text: String,
    pub(crate) at: Vector,
    /// Bit `k`: depends on input `k`.
    pub(crate) inputs: u32,
}

/// A direction, of any length, as it is written and of length 1.
#[derive(Clone, Debug)]
pub(crate) struct Direction {
    pub(crate) text: String,
    pub(crate) unit: Vector,
    pub(crate) inputs: u32,
}

pub(crate) fn plus(a: Vector, factor: f64, b: Vector) -> Vector {
    [0, 1, 2].map(|k| a[k] + factor * b[k])
}

pub(crate) fn minus(a: Vector, b: Vector) -> Vector {
    plus(a, -1.0, b)
}

pub(crate) fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub(crate) fn cross(a: Vector, b: Vector) -> Vector {
    [0, 1, 2].map(|k| {
        let (i, j) = ((k + 1) % 3, (k + 2) % 3);
        a[i] * b[j] - a[j] * b[i]
    })
}

pub(crate) fn length(a: Vector) -> f64 {
    dot(a, a).sqrt()
}

pub(crate) fn unit(a: Vector) -> Vector {
    let length = length(a);
    a.map(|x| x / length)
}

/// `|det|` of three vectors over the product of their lengths.
pub(crate) fn spread(a: Vector, b: Vector, c: Vector) -> f64 {
    dot(unit(a), cross(unit(b), unit(c))).abs()
}

/// `v` turned about the unit vector `axis`.
pub(crate) fn turn(v: Vector, axis: Vector, angle: f64) -> Vector {
    let (sin, cos) = angle.sin_cos();
    let along = dot(axis, v) * (1.0 - cos);
    plus(plus(v.map(|x| x * cos), sin, cross(axis, v)), along, axis)
}

impl Builder {
    pub(crate) fn unit_vector(&mut self) -> Vector {
        loop {
            let v = [0; 3].map(|_| self.random.between(-1.0, 1.0));
            if (0.1..1.0).contains(&length(v)) {
                return unit(v);
            }
        }
    }

    /// A point of the frame, or a vector fixed in a link.
    pub(crate) fn fixed(&mut self, start: &str, at: Vector) -> Place {
        let name = self.name(start);
        let [x, y, z] = at.map(millimetres);
        if self.random.chance(0.15) {
            self.items.push(format!("const {name} = ({x}, {y}, {z});"));
        } else {
            self.items.push(format!("param {name} = ({x}, {y}, {z});"));
            self.components(&name, false);
        }
        Place {
            text: name,
            at,
            inputs: 0,
        }
    }

    /// A direction as a literal, a constant or a parameter.
    pub(crate) fn direction(&mut self, unit: Vector) -> Direction {
        let size = *self.random.pick(&[1.0, 1.0, 2.0]);
        let name = self.name("d");
        let [x, y, z] = unit.map(|x| format!("{:.7}", size * x));
        let text = match self.random.below(3) {
            0 => format!("({x}, {y}, {z})"),
            1 => {
                self.items.push(format!("const {name} = ({x}, {y}, {z});"));
                name
            }
            _ => {
                self.items.push(format!("param {name} = ({x}, {y}, {z});"));
                self.components(&name, true);
                name
            }
        };
        Direction {
            text,
            unit,
            inputs: 0,
        }
    }

    /// An axis for joints and guides: along a coordinate or not.
    pub(crate) fn any_direction(&mut self) -> Direction {
        if self.random.chance(0.4) {
            let place = self.random.below(3);
            let unit = [0, 1, 2].map(|k| if k == place { 1.0 } else { 0.0 });
            let [x, y, z] = unit;
            return Direction {
                text: format!("({x}, {y}, {z})"),
                unit,
                inputs: 0,
            };
        }
        let unit = self.unit_vector();
        self.direction(unit)
    }

    /// A direction that turns with a link about a fixed axis.
    pub(crate) fn turning_direction(&mut self, body: &Body) -> Direction {
        let axis = self.any_direction();
        let start = loop {
            let start = self.any_direction();
            if length(cross(axis.unit, start.unit)) > 0.3 {
                break start;
            }
        };
        Direction {
            text: format!("turn({}, {}, {})", start.text, axis.text, body.text),
            unit: turn(start.unit, axis.unit, body.angle),
            inputs: body.inputs,
        }
    }

    /// A guide or normal: fixed, sometimes turning with a link.
    pub(crate) fn guide_in_space(&mut self) -> Direction {
        if self.random.chance(0.7) || self.bodies.is_empty() {
            return self.any_direction();
        }
        let body = self.random.pick(&self.bodies).clone();
        self.turning_direction(&body)
    }

    fn components(&mut self, name: &str, is_angle: bool) {
        for axis in ["x", "y", "z"] {
            self.parameters.push((format!("{name}.{axis}"), is_angle));
        }
    }

    /// A moving point: one that is there, or one of the plane at a height of its own.
    pub(crate) fn moving_place(&mut self) -> Place {
        let there = self.places.iter().filter(|p| p.inputs != 0);
        let there: Vec<Place> = there.cloned().collect();
        if !there.is_empty() && self.random.chance(0.6) {
            // Later ones more often, so that groups chain.
            let last = there.len().saturating_sub(2);
            return self.random.pick(&there[last..]).clone();
        }
        let moving: Vec<_> = self.points.iter().filter(|p| p.inputs != 0).collect();
        let point = (*self.random.pick(&moving)).clone();
        let height = self.random.between(-40.0, 40.0);
        let name = self.length(height);
        let [x, y] = point.at;
        let text = format!("({0}.x, {0}.y, {name})", point.text);
        self.add_place(&text, [x, y, height], point.inputs)
    }

    /// Another point, moving or fixed, neither near nor far.
    pub(crate) fn other_place(&mut self, a: &Place) -> Place {
        let near = |p: &&Place| (30.0..150.0).contains(&length(minus(p.at, a.at)));
        let there: Vec<Place> = self.places.iter().filter(near).cloned().collect();
        if !there.is_empty() && self.random.chance(0.3) {
            return self.random.pick(&there).clone();
        }
        let at = self.near(a.at);
        self.fixed("f", at)
    }

    /// A point 40 to 120 mm away.
    pub(crate) fn near(&mut self, at: Vector) -> Vector {
        let reach = self.random.between(40.0, 120.0);
        let way = self.unit_vector();
        plus(at, reach, way)
    }

    /// A `let` for a point, to which later groups can be joined; sometimes its projection, for groups of the plane.
    pub(crate) fn add_place(&mut self, expression: &str, at: Vector, inputs: u32) -> Place {
        let text = self.name("q");
        self.items.push(format!("let {text} = {expression};"));
        let place = Place { text, at, inputs };
        self.places.push(place.clone());
        place
    }

    /// The projection of a point, for groups of the plane.
    pub(crate) fn add_projection(&mut self, place: &Place) {
        let Place { text, at, inputs } = place;
        let seen: builder::Vector = [at[0], at[1]];
        self.add_point(&format!("({text}.x, {text}.y)"), seen, *inputs);
    }

    pub(crate) fn unknown_place(&mut self, at: Vector, inputs: u32) -> String {
        let name = self.name("p");
        let [x, y, z] = at.map(|x| format!("{x:.1}mm"));
        self.items
            .push(format!("unknown {name} = ({x}, {y}, {z});"));
        self.unknowns.push(Unknown {
            name: name.clone(),
            value: at.to_vec(),
            is_angle: false,
            inputs,
        });
        name
    }

    pub(crate) fn unknown_direction(&mut self, unit: Vector, inputs: u32) -> String {
        let name = self.name("n");
        let [x, y, z] = unit.map(|x| format!("{x:.2}"));
        self.items
            .push(format!("unknown {name} = ({x}, {y}, {z});"));
        self.unknowns.push(Unknown {
            name: name.clone(),
            value: unit.to_vec(),
            is_angle: true,
            inputs,
        });
        name
    }
}
