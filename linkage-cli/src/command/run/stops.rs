//! Ends of a motion that the command line gives: an input, a speed or a result passes a value.

use linkage_compiler::shortened;
use linkage_dynamics::Event;
use linkage_engine::{Assembly, Driven};
use linkage_report::MotionStop;

use super::super::values::{number, parts};
use super::driven::{Moving, moving};
use crate::failure::{Failure, known_names};

/// A number that passes a value.
pub(super) struct Stop {
    watched: Watched,
    value: f64,
}

enum Watched {
    Moving(Moving),
    /// A column of the function.
    Result(usize),
}

impl Stop {
    /// Resolves all options.
    pub(super) fn all(driven: &Driven<'_>, given: &[String]) -> Result<Vec<Self>, Failure> {
        given.iter().map(|given| Self::new(driven, given)).collect()
    }

    fn new(driven: &Driven<'_>, given: &str) -> Result<Self, Failure> {
        let (name, text) = parts("--stop", given)?;
        let mechanism = driven.mechanism();
        let columns = mechanism.headings()[driven.function()].columns;
        let column = columns.iter().position(|column| column.name == name);
        let titles = driven.titles();
        let (watched, unit) = match (moving(driven, name), column) {
            (Some(found), _) => {
                let title = titles.iter().find(|(title, _)| *title == name);
                (Watched::Moving(found), title.map_or("", |(_, unit)| unit))
            }
            (None, Some(column)) => (Watched::Result(column), columns[column].unit),
            (None, None) => {
                let moved = titles.iter().map(|(title, _)| *title);
                let known = moved.chain(columns.iter().map(|column| column.name));
                return Err(Failure::Told(format!(
                    "`{}` has neither input nor result `{}`; it has {}",
                    mechanism.headings()[driven.function()].function,
                    shortened(name),
                    known_names(name, known)
                )));
            }
        };
        let value = number(mechanism, name, text, unit)?;
        Ok(Self { watched, value })
    }

    /// The number and its value for a page.
    pub(super) fn on_page(&self, text: &str) -> MotionStop {
        MotionStop {
            text: text.to_owned(),
            watched: match self.watched {
                Watched::Moving(Moving::Input(input)) => linkage_report::Watched::Input(input),
                Watched::Moving(Moving::Speed(input)) => linkage_report::Watched::Speed(input),
                Watched::Result(column) => linkage_report::Watched::Column(column),
            },
            value: self.value,
        }
    }

    /// The event that ends the motion.
    pub(super) fn event<'a, const N: usize>(
        &self,
        driven: &'a Driven<'_>,
        assembly: &'a Assembly<'_>,
    ) -> Event<'a, N> {
        let value = self.value;
        let event = match self.watched {
            Watched::Moving(Moving::Input(input)) => Event::input(input, value),
            Watched::Moving(Moving::Speed(input)) => Event::speed(input, value),
            Watched::Result(column) => Event::new(move |state| {
                driven.results(assembly, state.inputs, state.speeds)[column] - value
            }),
        };
        event.stop()
    }
}
