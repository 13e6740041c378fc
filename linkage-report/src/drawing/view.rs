//! The direction from which a mechanism is seen.

/// Two directions of space that are the paper's right and up.
#[derive(Clone, Copy, Debug)]
pub(crate) struct View {
    pub(super) right: [f64; 3],
    pub(super) up: [f64; 3],
    pub(super) in_space: bool,
}

impl View {
    pub(crate) fn new(dimension: usize) -> Self {
        let plane = Self {
            right: [1.0, 0.0, 0.0],
            up: [0.0, 1.0, 0.0],
            in_space: dimension == 3,
        };
        plane.from((-60f64).to_radians(), 25f64.to_radians())
    }

    pub(super) fn from(self, azimuth: f64, elevation: f64) -> Self {
        if !self.in_space {
            return self;
        }
        let ((sa, ca), (se, ce)) = (azimuth.sin_cos(), elevation.sin_cos());
        Self {
            right: [-sa, ca, 0.0],
            up: [-se * ca, -se * sa, ce],
            ..self
        }
    }

    pub(crate) fn project(&self, v: [f64; 3]) -> [f64; 2] {
        let product = |a: [f64; 3]| a[0] * v[0] + a[1] * v[1] + a[2] * v[2];
        [product(self.right), product(self.up)]
    }

    /// Returns the coordinate towards the reader.
    pub(super) fn nearness(&self, v: [f64; 3]) -> f64 {
        let ([a, b, c], [d, e, f]) = (self.right, self.up);
        (b * f - c * e) * v[0] + (c * d - a * f) * v[1] + (a * e - b * d) * v[2]
    }
}
