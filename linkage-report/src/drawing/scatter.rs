//! Ellipses of tolerance at traced points.

use std::format;
use std::vec::Vec;

use crate::accuracy::Sensitive;

/// Components of points and their quantities.
pub(super) const COMPONENTS: [&str; 3] = ["x", "y", "z"];

/// The effects of tolerances on a traced point: by component and dimension, its sensitivities times
/// tolerances.
pub(super) struct Scatter<'a> {
    pub(super) point: usize,
    components: Vec<Option<&'a Sensitive<'a>>>,
}

impl<'a> Scatter<'a> {
    /// `None` if no component of the point has sensitivities.
    pub(super) fn new(point: usize, name: &str, sensitive: &'a [Sensitive<'a>]) -> Option<Self> {
        let component = |axis: &&str| {
            let name = format!("{name}.{axis}");
            sensitive.iter().find(|sensitive| sensitive.name == name)
        };
        let components: Vec<_> = COMPONENTS.iter().map(component).collect();
        let is_known = components.iter().any(Option::is_some);
        is_known.then_some(Self { point, components })
    }

    /// Returns the effect of each dimension as a vector.
    pub(super) fn effects(&self, row: usize) -> Vec<[f64; 3]> {
        let mut all: Vec<(&str, [f64; 3])> = Vec::new();
        for (axis, sensitive) in self.components.iter().enumerate() {
            for (name, effect) in sensitive
                .iter()
                .flat_map(|sensitive| sensitive.effects_at(row))
            {
                match all.iter_mut().find(|(known, _)| *known == name) {
                    Some((_, effects)) => effects[axis] = effect,
                    None => {
                        let mut effects = [0.0; 3];
                        effects[axis] = effect;
                        all.push((name, effects));
                    }
                }
            }
        }
        all.into_iter().map(|(_, effects)| effects).collect()
    }
}

/// Half axes of the ellipse of independent errors, the larger first, and the angle of that one on
/// paper.
pub(super) fn ellipse(effects: impl Iterator<Item = [f64; 2]>) -> Option<[f64; 3]> {
    let [xx, xy, yy] = effects.fold([0.0; 3], |[xx, xy, yy], [x, y]| {
        [xx + x * x, xy + x * y, yy + y * y]
    });
    let (mean, half) = (0.5 * (xx + yy), (0.5 * (xx - yy)).hypot(xy));
    let axes = [(mean + half).sqrt(), (mean - half).max(0.0).sqrt()];
    let turn = 0.5 * (2.0 * xy).atan2(xx - yy);
    mean.is_finite().then_some([axes[0], axes[1], turn])
}

#[cfg(test)]
mod tests {
    use super::ellipse;

    #[test]
    fn ellipses_are_those_of_their_errors() {
        // One error alone is a stretch along itself.
        let [long, short, turn] = ellipse([[3.0, 4.0]].into_iter()).unwrap();
        assert!((long - 5.0).abs() < 1e-12 && short < 1e-6);
        assert!((turn - 4f64.atan2(3.0)).abs() < 1e-12);
        // Two across each other are its half axes, however they are turned.
        let (s, c) = 0.7f64.sin_cos();
        let [long, short, turn] =
            ellipse([[2.0 * c, 2.0 * s], [-0.5 * s, 0.5 * c]].into_iter()).unwrap();
        assert!((long - 2.0).abs() < 1e-12 && (short - 0.5).abs() < 1e-12);
        assert!((turn - 0.7).abs() < 1e-12);
    }
}
