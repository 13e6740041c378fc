//! A pin: its load, its mounting, its material.

/// A pin of a joint, whose diameter is required or checked.
///
/// ```
/// use linkage_analysis::pins::{Criterion, Fit, Limit, Member, Mounting, Pin, Width};
/// use linkage_analysis::pins::standard_diameter;
///
/// // 4 kN on a pin of hardened steel, loose in a bushed rod of 1.2 diameters and in a fork of
/// // 8 mm; in N, mm, MPa.
/// let pin = Pin {
///     load: 4000.0,
///     mounting: Mounting::Clevis {
///         fit: Fit::Loose,
///         rod: Member { width: Width::Ratio(1.2), pressure: Limit::allowable(25.0) },
///         fork: Member { width: Width::Fixed(8.0), pressure: Limit::new(240.0, 2.0) },
///     },
///     bending: Limit::new(500.0, 2.5),
///     shear: Limit::allowable(90.0),
/// };
/// let size = pin.diameter()?;
/// assert_eq!(size.governing.to_string(), "bearing pressure in the rod");
/// assert!((size.diameter - (4000.0_f64 / (1.2 * 25.0)).sqrt()).abs() < 1e-12);
///
/// let diameter = standard_diameter(size.diameter).expect("there are pins up to 100 mm");
/// let check = pin.check(diameter)?;
/// assert!(diameter == 12.0 && check.holds());
/// assert!((check.bending.value - 89.6).abs() < 0.1 && (check.bending.safety - 5.58).abs() < 0.01);
/// # Ok::<(), linkage_analysis::pins::PinError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pin {
    /// The largest force that the joint passes on.
    pub load: f64,
    /// The parts that hold the pin, and that it holds.
    pub mounting: Mounting,
    /// The pin's strength in bending.
    pub bending: Limit,
    /// The pin's strength in shear.
    pub shear: Limit,
}

/// The parts that hold a pin, and that it holds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Mounting {
    /// A rod between the two cheeks of a fork.
    Clevis {
        /// The part that holds the pin.
        fit: Fit,
        /// The rod.
        rod: Member,
        /// One cheek of the fork; the other one is equal.
        fork: Member,
    },
    /// A hub on the free end of a pin that is pressed into a seat.
    Overhung {
        /// The hub.
        hub: Member,
        /// The seat.
        seat: Member,
        /// The distance between them, 0 if they touch.
        gap: f64,
    },
}

/// The part that holds the pin of a clevis. The tighter fit bends the pin less.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Fit {
    /// Nowhere: it has clearance in the rod and in the fork.
    Loose,
    /// In the fork, which it is pressed into.
    PressedInFork,
    /// In the rod, which it is pressed into.
    PressedInRod,
}

/// A part with a hole for the pin.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Member {
    /// The length of its hole.
    pub width: Width,
    /// The pressure that it, or the pin in it, can bear.
    pub pressure: Limit,
}

/// The length of a hole along the pin.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Width {
    /// A length.
    Fixed(f64),
    /// A multiple of the diameter.
    Ratio(f64),
}

impl Width {
    /// The length at a diameter.
    #[must_use]
    pub const fn length(self, diameter: f64) -> f64 {
        match self {
            Self::Fixed(length) => length,
            Self::Ratio(ratio) => ratio * diameter,
        }
    }
}

/// A strength, and by how much stresses must stay below it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Limit {
    /// The stress at which the part fails.
    pub strength: f64,
    /// The safety factor.
    pub safety: f64,
}

impl Limit {
    /// A strength with a safety factor.
    #[must_use]
    pub const fn new(strength: f64, safety: f64) -> Self {
        Self { strength, safety }
    }

    /// An allowable stress, as tables give it: the safety factor is in it and counts as 1.
    #[must_use]
    pub const fn allowable(stress: f64) -> Self {
        Self::new(stress, 1.0)
    }

    /// The allowable stress: strength over safety factor.
    #[must_use]
    pub const fn stress(&self) -> f64 {
        self.strength / self.safety
    }
}
