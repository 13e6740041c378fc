//! One counterweight in place of unit masses at several points.

use super::BalanceError;
use crate::components::norm;
use linkage_core::Scalar;

/// A mass at a point of a link, in the axes of the link from its origin.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Counterweight {
    /// Its mass; negative for material to be taken away.
    pub mass: f64,
    /// Its centre along the link's axis of angle 0.
    pub x: f64,
    /// Its centre along the axis 90 degrees ahead.
    pub y: f64,
}

impl Counterweight {
    /// One mass in place of three: one at the link's origin, and two at a radius from it, 90
    /// degrees apart: mass and static moment are the same.
    ///
    /// # Errors
    ///
    /// `Counterweight` if a number is not finite, the radius is not positive, or the masses add up
    /// to 0 and have a static moment, which no single mass has.
    pub fn of_masses([at_origin, m_x, m_y]: [f64; 3], radius: f64) -> Result<Self, BalanceError> {
        positive("the radius of the masses", radius)?;
        let mass = at_origin + m_x + m_y;
        let centre = [m_x, m_y].map(|m| radius * (m / mass));
        if mass != 0.0 && norm(&centre).is_finite() {
            let [x, y] = centre;
            return Ok(Self { mass, x, y });
        }
        Err(BalanceError::Counterweight {
            what: "the sum of the masses",
            value: mass,
            expected: "finite and not 0",
        })
    }

    /// The distance of its centre from the link's origin.
    #[must_use]
    pub fn radius(&self) -> f64 {
        norm(&[self.x, self.y])
    }

    /// The direction of its centre from the link's origin, from -pi to pi.
    #[must_use]
    pub fn angle(&self) -> f64 {
        Scalar::atan2(self.y, self.x)
    }

    /// Mass times place.
    #[must_use]
    pub fn static_moment(&self) -> StaticMoment {
        StaticMoment {
            x: self.mass * self.x,
            y: self.mass * self.y,
        }
    }
}

/// Mass times place on a link, in the axes of the link from its origin: the effect of a
/// counterweight on the shaking force if its link has a fixed pivot, whatever its mass.
///
/// ```
/// use linkage_analysis::balancing::StaticMoment;
///
/// // 0.3 kg at 100 mm in the direction of the link and 0.4 kg at 100 mm across it.
/// let moment = StaticMoment::of_masses([0.3, 0.4], 100.0);
/// assert!((moment.size() - 50.0).abs() < 1e-12);
/// assert!((moment.angle().to_degrees() - 53.130_102).abs() < 1e-6);
/// assert!((moment.of_mass(2.0)?.radius() - 25.0).abs() < 1e-12);
/// assert!((moment.at_radius(40.0)?.mass - 1.25).abs() < 1e-12);
/// # Ok::<(), linkage_analysis::balancing::BalanceError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StaticMoment {
    /// Along the link's axis of angle 0.
    pub x: f64,
    /// Along the axis 90 degrees ahead.
    pub y: f64,
}

impl StaticMoment {
    /// That of two masses at a radius from the link's origin: at angle 0 and at 90 degrees.
    #[must_use]
    pub fn of_masses([m_x, m_y]: [f64; 2], radius: f64) -> Self {
        Self {
            x: radius * m_x,
            y: radius * m_y,
        }
    }

    /// Mass times radius.
    #[must_use]
    pub fn size(&self) -> f64 {
        norm(&[self.x, self.y])
    }

    /// The direction of the counterweight from the link's origin, from -pi to pi.
    #[must_use]
    pub fn angle(&self) -> f64 {
        Scalar::atan2(self.y, self.x)
    }

    /// The counterweight with its centre at a radius.
    ///
    /// # Errors
    ///
    /// `Counterweight` if the radius is not positive and finite, or the static moment is 0, which
    /// has no direction, or not finite.
    pub fn at_radius(&self, radius: f64) -> Result<Counterweight, BalanceError> {
        positive("the radius of the counterweight", radius)?;
        let size = self.size();
        positive("the static moment", size)?;
        Ok(Counterweight {
            mass: size / radius,
            x: radius * (self.x / size),
            y: radius * (self.y / size),
        })
    }

    /// The counterweight with a mass.
    ///
    /// # Errors
    ///
    /// `Counterweight` if the mass is not positive and finite, or the static moment is not finite.
    pub fn of_mass(&self, mass: f64) -> Result<Counterweight, BalanceError> {
        positive("the mass of the counterweight", mass)?;
        let size = self.size();
        if !size.is_finite() {
            return Err(BalanceError::Counterweight {
                what: "the static moment",
                value: size,
                expected: "finite",
            });
        }
        Ok(Counterweight {
            mass,
            x: self.x / mass,
            y: self.y / mass,
        })
    }
}

fn positive(what: &'static str, value: f64) -> Result<(), BalanceError> {
    if value > 0.0 && value.is_finite() {
        return Ok(());
    }
    Err(BalanceError::Counterweight {
        what,
        value,
        expected: "positive and finite",
    })
}
