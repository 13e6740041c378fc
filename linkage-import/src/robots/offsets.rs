//! Parameters that lead from the pivots of bodies to other points of the bodies.

use super::wording::{Sections, Wording};

/// The parameters so far: body, offset as drawn, name. Coordinates are in the plane or in space.
#[derive(Default)]
pub(super) struct Offsets<const N: usize>(Vec<(usize, [f64; N], String)>);

impl<const N: usize> Offsets<N> {
    /// Returns the name of the parameter of an offset. A new one is declared unless the body has
    /// it; `what` is the end of its name.
    pub(super) fn parameter(
        &mut self,
        wording: &mut Wording<'_>,
        sections: &mut Sections,
        (body, offset): (usize, [f64; N]),
        what: &str,
    ) -> String {
        let mut known = self.0.iter();
        if let Some((_, _, name)) = known.find(|known| known.0 == body && known.1 == offset) {
            return name.clone();
        }
        let wanted = format!("{}_{what}", wording.bodies[body]);
        let name = wording.names.unique(&wanted, "of_");
        let value = wording.point(&offset);
        sections.parameters.push(format!("param {name} = {value};"));
        self.0.push((body, offset, name.clone()));
        name
    }
}
