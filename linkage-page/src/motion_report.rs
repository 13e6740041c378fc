//! The report of a motion under forces.

use linkage_engine::{Assembly, Driven, Table};
use linkage_report::{DrivenMotion, MotionEnergy, MotionStop, MovingInput, Report};
use linkage_runtime::{Column, Heading, Input, Meaning, Programs};

use crate::mechanism_report::first_paragraph;
use crate::motion_functions::EnergyFunctions;

/// The contents of a page of a motion.
#[derive(Debug)]
pub struct MotionContents<'a> {
    /// The equation of motion, of a mechanism with the functions of the page.
    pub driven: &'a Driven<'a>,
    /// The mechanism with its dimensions.
    pub assembly: &'a Assembly<'a>,
    /// The functions of the energy.
    pub energy: Option<EnergyFunctions>,
    /// The rows of the motion.
    pub rows: MotionRows,
    /// The time that was asked for, s.
    pub until: f64,
    /// The tolerance of a step.
    pub tolerance: f64,
    /// Values that end the motion.
    pub stops: Vec<MotionStop>,
    /// A sentence about an end before the time that was asked for.
    pub end: Option<String>,
    /// Programs with which the page computes the motion.
    pub programs: Programs,
    /// The text of the mechanism.
    pub source: Option<String>,
}

/// Columns of a motion, each with a number for every time.
#[derive(Clone, Debug, Default)]
pub struct MotionRows {
    /// Times, s.
    pub times: Vec<f64>,
    /// Each input.
    pub inputs: Vec<Vec<f64>>,
    /// The speed of each input.
    pub speeds: Vec<Vec<f64>>,
    /// The acceleration of each input.
    pub accelerations: Vec<Vec<f64>>,
    /// The work of loads without a potential since the start, in the unit of energies.
    pub work: Vec<f64>,
}

/// A table of numbers that no function returns.
struct Computed {
    heading: &'static Heading,
    columns: Vec<Vec<f64>>,
}

impl Table for Computed {
    fn heading(&self) -> &'static Heading {
        self.heading
    }

    fn rows(&self) -> usize {
        self.columns[0].len()
    }

    fn column(&self, index: usize) -> &[f64] {
        &self.columns[index]
    }
}

/// Reports a motion: its state, all results of its function, the check of the energy, the drawing.
#[must_use]
pub fn motion_report(contents: &MotionContents<'_>) -> Report {
    let MotionContents {
        driven, assembly, ..
    } = contents;
    let mechanism = driven.mechanism();
    let time = Input {
        name: "time",
        unit: "s",
        reference: 0.0,
        range: None,
    };
    let state = state_table(contents);
    let energy = energy_table(contents);
    let mut report = Report::new(
        format!("Motion of {}", mechanism.name()),
        &time,
        &contents.rows.times,
    )
    .about(first_paragraph(&mechanism.compiled().documentation))
    .structure(mechanism.structure())
    .modes(assembly.modes())
    .dimensions_listed(mechanism.parameters(), assembly.dimensions())
    .programs(contents.programs)
    .table(&state)
    .table(&calls(contents, driven.function()))
    .motion(driven_motion(contents, &state, energy.as_ref()));
    if let Some(energy) = &energy {
        report = report.table(energy);
    }
    let mut headings = mechanism.headings().iter();
    let drawn = headings.position(|heading| heading.picture.is_some());
    if let Some(function) = drawn.filter(|function| *function != driven.function()) {
        report = report.table(&calls(contents, function));
    }
    if let Some(source) = &contents.source {
        report = report.source(source.clone());
    }
    given(report, driven)
}

/// The report with the arguments that a reader may change: starts and loads.
fn given(report: Report, driven: &Driven<'_>) -> Report {
    let names = driven.mechanism().headings()[driven.function()].arguments;
    let is_acceleration = |index: usize| {
        let mut inputs = driven.inputs().iter();
        inputs.any(|input| input.acceleration == Some(index))
    };
    let pairs = names.iter().zip(driven.start_arguments()).enumerate();
    let given = pairs.filter(|(index, _)| !is_acceleration(*index));
    given.fold(report, |report, (_, (name, value))| {
        report.argument(*name, *value)
    })
}

fn driven_motion(
    contents: &MotionContents<'_>,
    state: &Computed,
    energy: Option<&Computed>,
) -> DrivenMotion {
    let driven = contents.driven;
    let heading = driven.mechanism().headings()[driven.function()];
    let inputs = driven.inputs().iter().map(|input| MovingInput {
        name: heading.arguments[input.value].to_owned(),
        speed: heading.arguments[input.speed].to_owned(),
        acceleration: input
            .acceleration
            .map(|index| heading.arguments[index].to_owned()),
        column: input.column,
    });
    let energy = energy
        .zip(contents.energy.as_ref())
        .map(|(table, names)| MotionEnergy {
            table: table.heading.function.to_owned(),
            loads: names.loads.clone(),
            weights: names.weights.clone(),
        });
    DrivenMotion {
        function: heading.function.to_owned(),
        state: state.heading.function.to_owned(),
        inputs: inputs.collect(),
        energy,
        until: contents.until,
        tolerance: contents.tolerance,
        stops: contents.stops.clone(),
        end: contents.end.clone(),
    }
}

/// Inputs and speeds.
fn state_table(contents: &MotionContents<'_>) -> Computed {
    let rows = &contents.rows;
    Computed {
        heading: heading(contents, "state", &contents.driven.titles()),
        columns: rows.inputs.iter().chain(&rows.speeds).cloned().collect(),
    }
}

/// Energies, the work, and by how much the energies differ from the start and the work.
fn energy_table(contents: &MotionContents<'_>) -> Option<Computed> {
    let mechanism = contents.driven.mechanism();
    let names = contents.energy.as_ref()?;
    let function = mechanism.function(&names.loads).ok()?;
    let energies = calls(contents, function);
    let first = 2 * contents.driven.inputs().len();
    let [kinetic, potential] = [first, first + 1].map(|index| energies.column(index).to_vec());
    let unit = mechanism.headings()[function].columns[first].unit;
    let work = contents.rows.work.clone();
    let drift = kinetic.iter().zip(&potential).zip(&work);
    let drift = drift.map(|((k, p), w)| k + p - kinetic[0] - potential[0] - w);
    let drift = drift.collect();
    let titles = ["kinetic", "potential", "work", "drift"].map(|name| (name, unit));
    Some(Computed {
        heading: heading(contents, "energy", &titles),
        columns: vec![kinetic, potential, work, drift],
    })
}

/// An argument that the function of the motion does not take.
const UNKNOWN: &[f64] = &[f64::NAN];

/// A function at all times, with the state of each.
fn calls(contents: &MotionContents<'_>, function: usize) -> linkage_engine::Columns {
    let MotionContents {
        driven,
        assembly,
        rows,
        ..
    } = contents;
    let names = driven.mechanism().headings()[function].arguments;
    let known = driven.mechanism().headings()[driven.function()].arguments;
    let start = driven.start_arguments();
    let moving = |index: usize| -> Option<&[f64]> {
        let mut inputs = driven.inputs().iter().enumerate();
        inputs.find_map(|(k, input)| match index {
            _ if index == input.value => Some(&rows.inputs[k][..]),
            _ if index == input.speed => Some(&rows.speeds[k][..]),
            _ if Some(index) == input.acceleration => Some(&rows.accelerations[k][..]),
            _ => None,
        })
    };
    let slices: Vec<&[f64]> = names
        .iter()
        .map(|name| {
            let index = known.iter().position(|other| other == name);
            let held = |index: usize| moving(index).unwrap_or(&start[index..=index]);
            index.map_or(UNKNOWN, held)
        })
        .collect();
    assembly.calls(function, &slices)
}

/// A heading with a name that no function has. It stays in memory, as those of functions do.
fn heading(contents: &MotionContents<'_>, name: &str, titles: &[(&str, &str)]) -> &'static Heading {
    let mut name = name.to_owned();
    let headings = contents.driven.mechanism().headings();
    while headings.iter().any(|heading| heading.function == name) {
        name.push('_');
    }
    let forever = |text: &str| -> &'static str { Box::leak(text.to_owned().into_boxed_str()) };
    let columns = titles.iter().map(|(name, unit)| Column {
        name: forever(name),
        unit: forever(unit),
        meaning: Meaning::Value,
    });
    let columns: Vec<Column> = columns.collect();
    Box::leak(Box::new(Heading {
        function: forever(&name),
        arguments: &[],
        columns: Box::leak(columns.into_boxed_slice()),
        picture: None,
    }))
}
