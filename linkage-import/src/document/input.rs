//! Inputs of a drawing: motors, cylinders and driven slots.

/// A motor or a cylinder.
#[derive(Clone, Debug)]
pub(crate) struct Input {
    pub(crate) kind: InputKind,
    /// The travel from the drawn position that the file allows: degrees for motors, lengths for
    /// cylinders and slots.
    pub(crate) travel: Option<[f64; 2]>,
    /// The speed in the file, as text.
    pub(crate) speed: Option<String>,
    /// The speed of a motor in degrees per second, counterclockwise.
    pub(crate) rate: Option<f64>,
}

/// The coordinate that an input sets.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum InputKind {
    /// The angle of a link about a pivot, against the link `base`.
    Crank {
        link: usize,
        pivot: usize,
        base: usize,
    },
    /// The distance of the two joints of a link.
    Length { link: usize },
    /// The position of a pin in a slot.
    Position { slot: usize },
}
