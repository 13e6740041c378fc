//! Mechanisms to start from.

/// A mechanism that a new file may have.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Template {
    /// The name on the command line, which is that of its file.
    pub(crate) name: &'static str,
    /// The mechanism in a few words.
    pub(crate) about: &'static str,
    /// The text of the file.
    pub(crate) text: &'static str,
}

macro_rules! templates {
    ($($name:literal: $about:literal,)*) => {
        /// All templates; the first one is the default.
        pub(crate) const TEMPLATES: &[Template] = &[$(Template {
            name: $name,
            about: $about,
            text: include_str!(concat!("templates/", $name, ".mech")),
        }),*];
    };
}

templates! {
    "slider": "a slider-crank",
    "joints": "a press by its joints and links, with its forces",
    "four-bar": "a four-bar with the path of a coupler point",
    "wiper": "a wiper drive with two arms",
    "clamp": "a toggle clamp with the force at its spindle",
    "scissors": "a scissor lift of two stages with a hydraulic cylinder",
    "leg": "a leg of Jansen's walking mechanism",
    "quick-return": "a crank and slotted lever with the ram of a shaper",
    "toggle-press": "a toggle press with its forces",
    "suspension": "a double wishbone suspension in the plane of its axle",
    "boom": "the boom and the bucket of a loader with two cylinders",
    "pump-jack": "a beam pump with counterweight",
    "steering": "a steering trapezoid, compared with the condition of Ackermann",
    "gripper": "a parallel gripper",
    "cam": "a cam that moves a slide by a law of motion",
    "geneva": "a Geneva drive of four slots",
}
