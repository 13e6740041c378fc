//! Data and unknowns of a mechanism: their names, kinds and values.

/// What a number is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// A length: scales with the mechanism.
    Length,
    /// An angle in radians.
    Angle,
    /// A ratio without dimension.
    Ratio,
}

/// A number that the mechanism is given.
#[derive(Clone, Copy, Debug)]
pub struct Datum {
    /// Its name.
    pub name: &'static str,
    /// What it is.
    pub kind: Kind,
    /// Its value in the mechanism as written.
    pub default: f64,
}

impl Datum {
    /// A length.
    pub const fn length(name: &'static str, default: f64) -> Self {
        Self {
            name,
            kind: Kind::Length,
            default,
        }
    }

    /// An angle, given in degrees (converted as the language does).
    pub const fn degrees(name: &'static str, degrees: f64) -> Self {
        Self {
            name,
            kind: Kind::Angle,
            default: degrees.to_radians(),
        }
    }

    /// A ratio.
    pub const fn ratio(name: &'static str, default: f64) -> Self {
        Self {
            name,
            kind: Kind::Ratio,
            default,
        }
    }
}

/// A number that the loops determine.
#[derive(Clone, Copy, Debug)]
pub struct Unknown {
    /// Its name.
    pub name: &'static str,
    /// `Angle` (then a unit vector is solved for), `Length`, or `Ratio`.
    pub kind: Kind,
    /// The start estimate at the reference input of the mechanism as written.
    pub estimate: f64,
}

impl Unknown {
    /// An unknown angle with its estimate in degrees.
    pub const fn angle(name: &'static str, degrees: f64) -> Self {
        Self {
            name,
            kind: Kind::Angle,
            estimate: degrees.to_radians(),
        }
    }

    /// An unknown slide with its estimate.
    pub const fn slide(name: &'static str, estimate: f64) -> Self {
        Self {
            name,
            kind: Kind::Length,
            estimate,
        }
    }

    /// An unknown number with its estimate, as the component of a unit vector in space.
    pub const fn number(name: &'static str, estimate: f64) -> Self {
        Self {
            name,
            kind: Kind::Ratio,
            estimate,
        }
    }
}

/// A list of data: each constructor of [`Datum`] with names and values.
#[macro_export]
macro_rules! data {
    ($($kind:ident $($name:literal $value:literal),+;)*) => {
        &[$($($crate::Datum::$kind($name, $value),)+)*]
    };
}

/// A list of unknowns: each constructor of [`Unknown`] with names and estimates.
#[macro_export]
macro_rules! unknowns {
    ($($kind:ident $($name:literal $estimate:literal),+;)*) => {
        &[$($($crate::Unknown::$kind($name, $estimate),)+)*]
    };
}
