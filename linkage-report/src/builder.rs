//! Contents of a report.

use std::string::String;
use std::vec::Vec;

use super::SummaryRow;
use super::driven_motion::DrivenMotion;
use super::figures::Figures;
use super::tables::Saved;
use linkage_analysis::cyclogram::Cyclogram;
use linkage_formats::CsvStyle;
use linkage_runtime::{AssemblyMode, Dimensions, Input, Parameter, Programs, Structure, Table};

/// A report about a mechanism over its range.
///
/// Methods that add something never fail. [`check`](Self::check) finds all contradictions, and
/// every output calls it first.
///
/// Angles are in radians here and in data files, as in results; plots and pages show degrees. A
/// number that is not finite, because the mechanism cannot be assembled or stands at a dead point,
/// is a gap: an empty cell, `null`, a break of the curve.
#[derive(Clone, Debug)]
pub struct Report {
    pub(super) title: String,
    pub(super) about: String,
    pub(super) notes: Vec<String>,
    pub(super) input: Input,
    pub(super) positions: Vec<f64>,
    pub(super) tables: Vec<Saved>,
    pub(super) structure: Option<Structure>,
    pub(super) modes: Vec<AssemblyMode>,
    pub(super) dimensions: Vec<Dimension>,
    pub(super) speed: Option<Speed>,
    pub(super) traces: Vec<String>,
    /// Points, and the vectors that are forces at them.
    pub(super) forces: Vec<(String, String)>,
    /// Azimuth and elevation.
    pub(super) view: Option<[f64; 2]>,
    pub(super) summary: Vec<SummaryRow>,
    pub(super) figures: Vec<Figures>,
    pub(super) facts: Vec<Fact>,
    pub(super) version: Option<u64>,
    /// The title of the page that leads to this report.
    pub(super) index: Option<String>,
    pub(super) programs: Vec<Programs>,
    pub(super) given: Vec<(String, f64)>,
    pub(super) source: Option<String>,
    pub(super) csv_style: CsvStyle,
    pub(super) cyclogram: Option<Cyclogram>,
    pub(super) motion: Option<DrivenMotion>,
}

/// A parameter and its value in this mechanism.
#[derive(Clone, Copy, Debug)]
pub(super) struct Dimension {
    pub(super) parameter: Parameter,
    pub(super) value: f64,
}

/// Speed and acceleration of the input.
#[derive(Clone, Copy, Debug)]
pub(super) struct Speed {
    pub(super) omega: f64,
    pub(super) epsilon: f64,
}

/// A word about the mechanism.
#[derive(Clone, Debug)]
pub(super) struct Fact {
    pub(super) name: String,
    pub(super) text: String,
}

impl Report {
    /// A report with this title, about positions of this input, in its unit.
    #[must_use]
    pub fn new(title: impl Into<String>, input: &Input, positions: &[f64]) -> Self {
        Self {
            title: title.into(),
            about: String::new(),
            notes: Vec::new(),
            input: *input,
            positions: positions.to_vec(),
            tables: Vec::new(),
            structure: None,
            modes: Vec::new(),
            dimensions: Vec::new(),
            speed: None,
            traces: Vec::new(),
            forces: Vec::new(),
            view: None,
            summary: Vec::new(),
            figures: Vec::new(),
            facts: Vec::new(),
            version: None,
            index: None,
            programs: Vec::new(),
            given: Vec::new(),
            source: None,
            csv_style: CsvStyle::default(),
            cyclogram: None,
            motion: None,
        }
    }

    /// One or two sentences below the title.
    #[must_use]
    pub fn about(mut self, text: impl Into<String>) -> Self {
        self.about = text.into();
        self
    }

    /// A remark, such as where the dimensions come from. There may be several.
    #[must_use]
    pub fn note(mut self, text: impl Into<String>) -> Self {
        self.notes.push(text.into());
        self
    }

    /// A sweep over the positions of the report. There may be several, of different functions; one
    /// of them may have the columns of a picture, which the drawing and the page show.
    #[must_use]
    pub fn table(mut self, table: &impl Table) -> Self {
        self.tables.push(Saved::new(table));
        self
    }

    /// The structure that the compiler found: the constant `STRUCTURE`.
    #[must_use]
    pub fn structure(mut self, structure: &Structure) -> Self {
        self.structure = Some(*structure);
        self
    }

    /// The assembly's modes, as its method `modes` gives them, which are shown with the structure.
    #[must_use]
    pub fn modes(mut self, modes: &[AssemblyMode]) -> Self {
        self.modes = modes.to_vec();
        self
    }

    /// The mechanism's dimensions with nominal values and tolerances. With them, sensitivities
    /// become bands about their quantities and a table of accuracy.
    #[must_use]
    pub fn dimensions<M: Dimensions<N>, const N: usize>(self, mechanism: &M) -> Self {
        self.dimensions_listed(M::PARAMETERS, &mechanism.values())
    }

    /// Adds dimensions as [`dimensions`](Self::dimensions) does, from the parameters of the
    /// declaration and their values, for mechanisms that are read at run time.
    #[must_use]
    pub fn dimensions_listed(mut self, parameters: &[Parameter], values: &[f64]) -> Self {
        let pairs = parameters.iter().zip(values);
        self.dimensions = pairs
            .map(|(&parameter, &value)| Dimension { parameter, value })
            .collect();
        self
    }

    /// The input's speed (rad/s for an angle) and acceleration (rad/s^2). With them, first and
    /// second derivatives by the input are also shown as true velocities and accelerations.
    #[must_use]
    pub fn speed(mut self, omega: f64, epsilon: f64) -> Self {
        self.speed = Some(Speed { omega, epsilon });
        self
    }

    /// A point of the picture whose path is drawn. Without any, the tips of links are traced, and the
    /// joints whose positions are results of a table.
    #[must_use]
    pub fn trace(mut self, point: impl Into<String>) -> Self {
        self.traces.push(point.into());
        self
    }

    /// A force that the page shows as an arrow at a point of the picture: a vector of the tables,
    /// whose components are `b.x` and `b.y` for the quantity `b`.
    #[must_use]
    pub fn force(mut self, point: impl Into<String>, quantity: impl Into<String>) -> Self {
        self.forces.push((point.into(), quantity.into()));
        self
    }

    /// Sets the initial viewing direction of a mechanism in space, on the page and in
    /// [drawings](Self::drawing): the angle about z, from x, and the angle above the plane of x and
    /// y, in radians. From -90 and 90 degrees x is to the right and y upwards. It has no effect in
    /// the plane, nor has a number that is not finite.
    #[must_use]
    pub fn view(mut self, azimuth: f64, elevation: f64) -> Self {
        self.view = Some([azimuth, elevation]).filter(|view| view.iter().all(|x| x.is_finite()));
        self
    }

    /// Sets the version of a report that is written repeatedly: the open page of another version
    /// reloads when this one is [written](Self::write).
    #[must_use]
    pub fn version(mut self, version: u64) -> Self {
        self.version = Some(version);
        self
    }

    /// Adds a link to an [`Index`](crate::Index) with this title, in the folder above.
    #[must_use]
    pub fn index(mut self, title: impl Into<String>) -> Self {
        self.index = Some(title.into());
        self
    }

    /// Adds the programs behind tables, the constant `PROGRAMS` of a mechanism that is drawn: with
    /// them, the page computes the tables for other dimensions when the reader changes them. It
    /// needs [`dimensions`](Self::dimensions). There may be several, if tables come from several
    /// mechanisms. Dimensions of one name are then the same.
    #[must_use]
    pub fn programs(mut self, programs: Programs) -> Self {
        self.programs.push(programs);
        self
    }

    /// An argument beside the input that functions of tables were called with, the same at all
    /// positions: without it, the page cannot compute these.
    #[must_use]
    pub fn argument(mut self, argument: impl Into<String>, value: f64) -> Self {
        self.given.push((argument.into(), value));
        self
    }

    /// Sets the text of the mechanism, as a file of the command or the braces of `mechanism!` have
    /// it. A page with [`programs`](Self::programs) saves it with its dimensions as defaults.
    #[must_use]
    pub fn source(mut self, text: impl Into<String>) -> Self {
        self.source = Some(text.into());
        self
    }

    /// A word about the mechanism: `fact("Grashof", "crank-rocker")`.
    #[must_use]
    pub fn fact(mut self, name: impl Into<String>, text: impl Into<String>) -> Self {
        self.facts.push(Fact {
            name: name.into(),
            text: text.into(),
        });
        self
    }

    /// Sets the style of [`csv`](Self::csv) and of the files of [`write`](Self::write): angles in
    /// degrees, digits, separator, decimal mark.
    #[must_use]
    pub fn csv_style(mut self, style: CsvStyle) -> Self {
        self.csv_style = style;
        self
    }

    /// Adds the motions of the machine's organs over the angle of its shaft, which is the input: as
    /// a diagram of bars below the drawing of the page, with a line at the current position, as a
    /// table, and as files.
    #[must_use]
    pub fn cyclogram(mut self, cyclogram: &Cyclogram) -> Self {
        self.cyclogram = Some(cyclogram.clone());
        self
    }

    /// Makes this the report of a motion under forces, whose input is the time. Its page computes
    /// the motion for other dimensions, loads and starts by the [`programs`](Self::programs).
    #[doc(hidden)]
    #[must_use]
    pub fn motion(mut self, motion: DrivenMotion) -> Self {
        self.motion = Some(motion);
        self
    }
}
