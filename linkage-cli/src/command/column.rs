//! Columns of tables.

/// A column with its name and unit.
pub(super) struct Column<'a> {
    pub(super) name: &'a str,
    pub(super) unit: &'a str,
    /// Radians that are shown in degrees.
    in_degrees: bool,
}

impl<'a> Column<'a> {
    /// A column of numbers in a unit; with `in_degrees` angles are shown in degrees.
    pub(super) fn new(name: &'a str, unit: &'a str, in_degrees: bool) -> Self {
        let in_degrees = in_degrees && unit == "rad";
        Self {
            name,
            unit: if in_degrees { "deg" } else { unit },
            in_degrees,
        }
    }

    pub(super) fn shown(&self, x: f64) -> f64 {
        match self.in_degrees {
            true => x.to_degrees(),
            false => x,
        }
    }

    pub(super) fn title(&self) -> String {
        match self.unit {
            "" => self.name.to_owned(),
            unit => format!("{} [{unit}]", self.name),
        }
    }
}
