//! Curves over the input.

mod axes;
mod gaps;
mod legend;
mod mistakes;
mod panel;
pub(super) mod ticks;

use std::path::{Path, PathBuf};
use std::string::{String, ToString};
use std::vec::Vec;

use super::hues::Style;
use super::svg::{Element, Svg};
use super::{BandKind, Mistake, ReportError};
use crate::report::colour::Colour;
use axes::Axis;
use legend::Entry;
use panel::{Frame, Panel};

/// Curves over a common abscissa, as a picture.
///
/// Curves of one unit share a panel; panels stand below each other. Angles are given in radians and shown in degrees. A
/// curve has a gap where its values are not finite; the gaps are shaded and named below the plot. The picture follows the
/// reader's choice of a light or dark ground.
///
/// ```
/// use linkage_runtime::report::Plot;
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
/// # Ok::<(), linkage_runtime::report::ReportError>(())
/// ```
#[derive(Clone, Debug)]
pub struct Plot {
    title: String,
    abscissa: Quantity,
    curves: Vec<Curve>,
    section: usize,
    width: f64,
    height: f64,
    mistakes: Vec<Mistake>,
}

/// Of a panel.
const NARROWEST: f64 = 160.0;

/// Numbers as they are shown.
#[derive(Clone, Debug)]
struct Quantity {
    name: String,
    unit: String,
    /// Whether they were given in radians.
    from_radians: bool,
    values: Vec<f64>,
}

#[derive(Clone, Debug)]
struct Curve {
    section: usize,
    quantity: Quantity,
    bands: Vec<Band>,
    /// As the report has it; otherwise it follows from the order.
    style: Option<Style>,
    thin: bool,
}

#[derive(Clone, Debug)]
struct Band {
    kind: BandKind,
    half: Vec<f64>,
}

impl Quantity {
    /// Angles become degrees.
    fn new(name: &str, unit: &str, values: &[f64]) -> Self {
        Self {
            name: name.to_string(),
            unit: String::from(if unit == "rad" { "deg" } else { unit }),
            from_radians: unit == "rad",
            values: shown(unit == "rad", values),
        }
    }
}

fn shown(radians: bool, values: &[f64]) -> Vec<f64> {
    let show = |x: &f64| if radians { x.to_degrees() } else { *x };
    values.iter().map(show).collect()
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

    /// Width of the plot and height of each panel, in pixels; 960 and 200 if nothing else is asked for. Not less than 320 and 80, and
    /// more where the legend needs it.
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
    pub(super) fn styled(mut self, style: Option<Style>) -> Self {
        if let Some(curve) = self.curves.last_mut() {
            curve.style = style;
        }
        self
    }

    /// Draws the last curve thinner than others.
    pub(super) fn thin(mut self) -> Self {
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

    /// The plot as SVG.
    ///
    /// # Errors
    ///
    /// [`ReportError::Mistakes`] if there is no curve or no value, if a value of the abscissa is not finite, if a curve or band has not as
    /// many values as the abscissa, if a band's curve is not there, or if words have control characters.
    pub fn svg(&self) -> Result<String, ReportError> {
        let mistakes = self.all_mistakes();
        match mistakes.is_empty() {
            true => Ok(self.drawn()),
            false => Err(ReportError::Mistakes(mistakes)),
        }
    }

    /// Writes the plot, by the ending of the file's name, as SVG or (with feature `png`) as PNG.
    ///
    /// # Errors
    ///
    /// As [`svg`](Self::svg), if the file cannot be written, and for any other ending.
    pub fn write(&self, path: impl AsRef<Path>) -> Result<PathBuf, ReportError> {
        super::write::picture(path.as_ref(), &self.svg()?)
    }

    /// Whether there is a curve of this name and unit.
    pub(super) fn has_curve(&self, name: &str, unit: &str) -> bool {
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

    fn drawn(&self) -> String {
        let panels = self.panels();
        let legends: Vec<Vec<Entry<'_>>> = panels.iter().map(Panel::legend).collect();
        let beside = legends.iter().map(|l| legend::width(l)).fold(0.0, f64::max);
        let notes = self.gap_notes();
        // As wide and as high as the legend needs it.
        let total = self.width.max(panel::LEFT + NARROWEST + beside + 24.0);
        let lines = legends.iter().map(Vec::len).max().unwrap_or(0);
        let tall = self.height.max(legend::height(lines));

        let top = if self.title.is_empty() { 14.0 } else { 44.0 };
        let below = top + panels.len() as f64 * (tall + panel::SPACE) - panel::SPACE;
        let height = below + 54.0 + 18.0 * notes.len() as f64;
        let mut svg = Svg::new(total, height, "", &self.described());
        if !self.title.is_empty() {
            let title = Element::text([panel::LEFT, 26.0], 16.0).set("font-weight", 600);
            svg.words(title.fill(Colour::Ink), &self.title);
        }
        let axis = Axis::abscissa(&self.abscissa);
        for (index, (panel, legend)) in panels.iter().zip(&legends).enumerate() {
            let above = top + index as f64 * (tall + panel::SPACE);
            let frame = Frame {
                left: panel::LEFT,
                right: total - beside - 24.0,
                top: above,
                bottom: above + tall,
            };
            panel.draw(&mut svg, frame, &axis, index + 1 == panels.len());
            legend::draw(&mut svg, [frame.right + 14.0, above + 12.0], legend);
        }
        for (line, note) in notes.iter().enumerate() {
            let at = [panel::LEFT, below + 64.0 + 18.0 * line as f64];
            let words = Element::text(at, 12.0).class("note").fill(Colour::Muted);
            svg.words(words, note);
        }
        svg.finish()
    }

    /// Curves by section and unit, in the order of their first one.
    fn panels(&self) -> Vec<Panel<'_>> {
        let mut panels: Vec<Panel<'_>> = Vec::new();
        for curve in &self.curves {
            match panels.iter_mut().find(|panel| panel.takes(curve)) {
                Some(panel) => panel.curves.push(curve),
                None => panels.push(Panel {
                    abscissa: &self.abscissa.values,
                    curves: Vec::from([curve]),
                    gaps: self.gaps(),
                }),
            }
        }
        panels
    }

    /// What the picture is, for those who do not see it.
    fn described(&self) -> String {
        let names = self.curves.iter().map(|c| c.quantity.name.as_str());
        let names = names.collect::<Vec<_>>().join(", ");
        let over = &self.abscissa.name;
        match self.title.as_str() {
            "" => std::format!("{names} over {over}"),
            title => std::format!("{title}: {names} over {over}"),
        }
    }
}
