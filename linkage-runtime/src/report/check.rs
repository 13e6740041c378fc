//! Whether the parts of a report fit together.

use std::string::{String, ToString};
use std::vec::Vec;

use super::shown::{drawn_names, point_named};
use super::tables::Saved;
use super::{Mistake, Report, ReportError};
use crate::Meaning;

impl Report {
    /// Whether everything fits together; everything that writes asks first.
    ///
    /// # Errors
    ///
    /// [`ReportError::Mistakes`] with all that was found.
    pub fn check(&self) -> Result<(), ReportError> {
        let mut mistakes = Vec::new();
        self.check_words(&mut mistakes);
        self.check_tables(&mut mistakes);
        self.check_picture(&mut mistakes);
        self.check_parameters(&mut mistakes);
        self.check_speed(&mut mistakes);
        self.check_given(&mut mistakes);
        self.check_csv(&mut mistakes);
        self.check_cyclogram(&mut mistakes);
        if mistakes.is_empty() {
            Ok(())
        } else {
            Err(ReportError::Mistakes(mistakes))
        }
    }

    fn check_tables(&self, mistakes: &mut Vec<Mistake>) {
        let positions = self.positions.len();
        if positions < 2 {
            mistakes.push(Mistake::Positions { count: positions });
        }
        self.check_positions(mistakes);
        for (index, table) in self.tables.iter().enumerate() {
            let function = table.heading.function;
            if table.rows != positions {
                mistakes.push(Mistake::Rows {
                    function: function.to_string(),
                    rows: table.rows,
                    positions,
                });
            }
            let same = |other: &&Saved| other.heading.function == function;
            if self.tables[..index].iter().filter(same).count() == 1 {
                mistakes.push(Mistake::Twice {
                    function: function.to_string(),
                });
            }
        }
    }

    fn check_positions(&self, mistakes: &mut Vec<Mistake>) {
        let mut rows = self.positions.iter().enumerate();
        if let Some((row, &value)) = rows.find(|(_, x)| !x.is_finite()) {
            let what = std::format!("position {row} of `{}`", self.input.name);
            mistakes.push(Mistake::NotFinite { what, value });
        }
        let input = self.input.name.to_string();
        match self.positions[..] {
            [first, _, ..] if self.positions.iter().all(|x| *x == first) => {
                mistakes.push(Mistake::Still { input, at: first });
            }
            _ => mistakes.extend(self.turning()),
        }
    }

    /// The first position that does not go on as those before it do: neither an axis nor a player could tell it from an earlier one.
    fn turning(&self) -> Option<Mistake> {
        let mut steps = self.positions.windows(2);
        let rises = steps
            .find(|pair| pair[0] != pair[1])
            .is_some_and(|pair| pair[1] > pair[0]);
        let goes_on = |pair: &[f64]| match rises {
            true => pair[1] > pair[0],
            false => pair[1] < pair[0],
        };
        let mut pairs = self.positions.windows(2).enumerate();
        // What is no number is told by itself.
        let (row, pair) =
            pairs.find(|(_, pair)| pair.iter().all(|x| x.is_finite()) && !goes_on(pair))?;
        Some(Mistake::Turning {
            input: self.input.name.to_string(),
            index: row + 1,
            values: [pair[0], pair[1]],
            rises,
        })
    }

    fn check_picture(&self, mistakes: &mut Vec<Mistake>) {
        let pictures = self.tables.iter().filter(|t| t.heading.picture.is_some());
        let functions: Vec<String> = pictures.map(|t| t.heading.function.to_string()).collect();
        if functions.len() > 1 {
            mistakes.push(Mistake::Pictures { functions });
        }
        let Some(shown) = self.shown() else {
            if let Some(name) = self.traces.first() {
                mistakes.push(Mistake::NoPicture {
                    wanted: std::format!("the path of `{name}`"),
                    functions: self.functions(),
                });
            }
            return;
        };
        for name in &self.traces {
            if point_named(shown.picture, name).is_none() {
                mistakes.push(Mistake::Unknown {
                    kind: "point",
                    name: name.clone(),
                    known: drawn_names(shown.picture),
                });
            }
        }
    }

    fn check_parameters(&self, mistakes: &mut Vec<Mistake>) {
        let dimensions = self.dimensions.len();
        if dimensions == 0 {
            return;
        }
        for column in self.tables.iter().flat_map(|table| table.heading.columns) {
            if let Meaning::Sensitivity { parameter, .. } = column.meaning
                && parameter >= dimensions
            {
                mistakes.push(Mistake::Parameter {
                    column: column.name.to_string(),
                    parameter,
                    dimensions,
                });
            }
        }
    }

    fn check_given(&self, mistakes: &mut Vec<Mistake>) {
        let arguments = self.tables.iter().flat_map(|table| table.heading.arguments);
        let beside: Vec<&str> = arguments
            .copied()
            .filter(|name| *name != self.input.name)
            .collect();
        for (name, value) in &self.given {
            if !beside.contains(&name.as_str()) {
                let mut known: Vec<String> = beside.iter().map(ToString::to_string).collect();
                known.sort();
                known.dedup();
                mistakes.push(Mistake::Unknown {
                    kind: "argument",
                    name: name.clone(),
                    known,
                });
            }
            if !value.is_finite() {
                let what = std::format!("the argument `{name}`");
                mistakes.push(Mistake::NotFinite {
                    what,
                    value: *value,
                });
            }
        }
    }

    fn check_speed(&self, mistakes: &mut Vec<Mistake>) {
        if let Some(speed) = self.speed {
            for (what, value) in [
                ("the speed", speed.omega),
                ("the acceleration", speed.epsilon),
            ] {
                if !value.is_finite() {
                    let what = std::format!("{what} of `{}`", self.input.name);
                    mistakes.push(Mistake::NotFinite { what, value });
                }
            }
        }
        let accelerates = self.speed.is_some_and(|speed| speed.epsilon != 0.0);
        if !accelerates {
            return;
        }
        for table in &self.tables {
            for column in table.heading.columns {
                if let Meaning::Rate { order: 2, .. } = column.meaning
                    && self.velocity(table, column).is_none()
                {
                    mistakes.push(Mistake::Velocity {
                        column: column.name.to_string(),
                        of: table.of(column).map(|name| std::format!("`{name}`")),
                    });
                }
            }
        }
    }
}
