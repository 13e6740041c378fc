//! Cranks that a law of motion or a spline turns. All of them are symmetric about their middle, where the configuration stands: there the value
//! is the mean of those at the ends.

use crate::builder::{Builder, radians};
use crate::plane::step;

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
