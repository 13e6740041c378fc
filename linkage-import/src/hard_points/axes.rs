//! Axes, unit and side of a table, which the user names.

use crate::error::ImportError;
use crate::names::shown;
use crate::options::Options;
use crate::placement::Vector;

const AXES: &str = "`forward,left,up` (ISO 8855), `forward,right,down` (SAE J670), `rear,right,up`, or the directions of x, y and z in any other order";

/// The meaning of the numbers of a table.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Meaning {
    /// For x, y and z of the file: the component of forward, left, up, and its sign.
    axes: [(usize, f64); 3],
    /// The unit of the language.
    pub(super) unit: &'static str,
    pub(super) is_left: bool,
}

impl Meaning {
    /// Reads the options, all of which are needed.
    pub(super) fn of_options(options: &Options) -> Result<Self, ImportError> {
        let missing: Vec<&str> = [
            options.axes.is_none().then_some("--axes forward,left,up"),
            options.length.is_none().then_some("--length mm"),
            options.side.is_none().then_some("--side left"),
        ]
        .into_iter()
        .flatten()
        .collect();
        if !missing.is_empty() {
            return Err(ImportError::new(format!(
                "a table of points does not say its axes, its unit and its side\nhelp: name them, as by `{}`; axes are {AXES}; units are `mm`, `cm`, `m`, `inch`; sides are `left` and `right`",
                missing.join(" ")
            )));
        }
        let unit = match options.length.as_deref().unwrap_or_default() {
            "mm" => "mm",
            "cm" => "cm",
            "m" => "m",
            "inch" | "in" => "inch",
            other => {
                return Err(ImportError::new(format!(
                    "there is no unit `{}`; there are `mm`, `cm`, `m`, `inch`",
                    shown(other)
                )));
            }
        };
        let is_left = match options.side.as_deref().unwrap_or_default() {
            "left" => true,
            "right" => false,
            other => {
                return Err(ImportError::new(format!(
                    "there is no side `{}`; there are `left` and `right`",
                    shown(other)
                )));
            }
        };
        let axes = axes(options.axes.as_deref().unwrap_or_default())?;
        Ok(Self {
            axes,
            unit,
            is_left,
        })
    }

    /// A point of the file as forward, left and up.
    pub(super) fn point(&self, of_file: Vector) -> Vector {
        let mut point = [0.0; 3];
        for ((component, sign), value) in self.axes.iter().zip(of_file) {
            // No sign of zero.
            point[*component] = sign * value + 0.0;
        }
        point
    }

    /// The sign of the direction to the outside.
    pub(super) fn outside(&self) -> f64 {
        if self.is_left { 1.0 } else { -1.0 }
    }
}

fn axes(text: &str) -> Result<[(usize, f64); 3], ImportError> {
    let wrong = || {
        ImportError::new(format!(
            "`{}` are no three axes: they are {AXES}",
            shown(text)
        ))
    };
    let mut found = Vec::new();
    for word in text.split(',') {
        found.push(match word.trim() {
            "forward" => (0, 1.0),
            "rear" => (0, -1.0),
            "left" => (1, 1.0),
            "right" => (1, -1.0),
            "up" => (2, 1.0),
            "down" => (2, -1.0),
            _ => return Err(wrong()),
        });
    }
    let axes: [(usize, f64); 3] = found.try_into().map_err(|_| wrong())?;
    let has_all = (0..3).all(|component| axes.iter().any(|axis| axis.0 == component));
    match has_all {
        true => Ok(axes),
        false => Err(wrong()),
    }
}
