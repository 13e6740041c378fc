//! Contents of a plot.

use std::string::{String, ToString};
use std::vec::Vec;

use super::curve::{Band, Curve, Quantity, shown};
use crate::accuracy::BandKind;
use crate::palette::Style;
use linkage_formats::Mistake;

/// Curves over a common abscissa, as a picture.
///
/// Curves of one unit share a panel; panels stand below each other. Angles are given in radians and
/// shown in degrees. A curve has a gap where its values are not finite; the gaps are shaded and
/// named below the plot. The picture follows the reader's choice of a light or dark ground.
///
/// ```
/// use linkage_report::Plot;
///
/// let phi: Vec<f64> = (0..=360).map(|i| f64::from(i).to_radians()).collect();
/// let lift: Vec<f64> = phi.iter().map(|phi| 5.0 - 5.0 * phi.cos()).collect();
/// let slope: Vec<f64> = phi.iter().map(|phi| 5.0 * phi.sin()).collect();
/// let svg = Plot::new("phi", "rad", &phi)
///     .title("Lift of the cam")
///     .curve("lift", "mm", &lift)
///     .curve("slope", "mm/rad", &slope)
///     .svg()?;
/// assert!(svg.contains("phi [deg]") && svg.contains("lift [mm]"));
/// # Ok::<(), linkage_report::ReportError>(())
/// ```
#[derive(Clone, Debug)]
pub struct Plot {
    pub(super) title: String,
    pub(super) abscissa: Quantity,
    pub(super) curves: Vec<Curve>,
    pub(super) section: usize,
    pub(super) width: f64,
    pub(super) height: f64,
    pub(super) mistakes: Vec<Mistake>,
}

impl Plot {
    /// A plot over these values of the input, `rad` if it is an angle.
    #[must_use]
    pub fn new(name: &str, unit: &str, values: &[f64]) -> Self {
        Self {
            title: String::new(),
            abscissa: Quantity::new(name, unit, values),
            curves: Vec::new(),
            section: 0,
            width: 960.0,
            height: 200.0,
            mistakes: Vec::new(),
        }
    }

    /// A title above the plot.
    #[must_use]
    pub fn title(mut self, title: impl Into<String>) -> Self {
        self.title = title.into();
        self
    }

    /// Width of the plot and height of each panel, in pixels; 960 and 200 if nothing else is asked
    /// for. Not less than 320 and 80, and more where the legend needs it.
    #[must_use]
    pub fn size(mut self, width: f64, height: f64) -> Self {
        (self.width, self.height) = (width.max(320.0), height.max(80.0));
        self
    }

    /// A curve: one value for each value of the abscissa.
    #[must_use]
    pub fn curve(mut self, name: &str, unit: &str, values: &[f64]) -> Self {
        self.check(name, values);
        self.curves.push(Curve {
            section: self.section,
            quantity: Quantity::new(name, unit, values),
            bands: Vec::new(),
            style: None,
            thin: false,
        });
        self
    }

    /// Gives the last curve a style.
    pub(crate) fn styled(mut self, style: Option<Style>) -> Self {
        if let Some(curve) = self.curves.last_mut() {
            curve.style = style;
        }
        self
    }

    /// Draws the last curve thinner than others.
    pub(crate) fn thin(mut self) -> Self {
        if let Some(curve) = self.curves.last_mut() {
            curve.thin = true;
        }
        self
    }

    /// A band about a curve that is there: half its width, in the unit of the curve.
    #[must_use]
    pub fn band(mut self, curve: &str, kind: BandKind, half: &[f64]) -> Self {
        self.check(curve, half);
        let mut curves = self.curves.iter_mut().rev();
        if let Some(to) = curves.find(|to| to.quantity.name == curve) {
            let half = shown(to.quantity.from_radians, half);
            to.bands.push(Band { kind, half });
            return self;
        }
        let known = self.curves.iter().map(|c| c.quantity.name.clone());
        let mistake = Mistake::Unknown {
            kind: "curve",
            name: curve.to_string(),
            known: known.collect(),
        };
        self.mistakes.push(mistake);
        self
    }

    /// Further curves stand in panels of their own, even if there is one of their unit.
    #[must_use]
    pub fn panel(mut self) -> Self {
        self.section += 1;
        self
    }

    /// Returns true if there is a curve of this name and unit.
    pub(crate) fn has_curve(&self, name: &str, unit: &str) -> bool {
        let sought = Quantity::new(name, unit, &[]);
        let mut curves = self.curves.iter().map(|curve| &curve.quantity);
        curves.any(|there| there.name == sought.name && there.unit == sought.unit)
    }

    fn check(&mut self, name: &str, values: &[f64]) {
        let positions = self.abscissa.values.len();
        if values.len() != positions {
            self.mistakes.push(Mistake::Length {
                name: name.to_string(),
                values: values.len(),
                positions,
            });
        }
    }
}
