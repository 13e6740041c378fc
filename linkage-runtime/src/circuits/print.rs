//! Circuits as a table.

use super::branch::{BranchEnd, Circuits, Estimate, Meeting, Undetermined};
use alloc::format;
use alloc::string::{String, ToString};
use alloc::vec;
use alloc::vec::Vec;
use core::fmt;
use linkage_core::Cycle;
use linkage_core::format::{rounded, settled};
use linkage_core::range_check::listed;

/// One line for each assembly; angles in degrees. Behind its ends and margin: an input, and the
/// unknowns there. Then one for each pair that meets in change points, and for each group that is
/// undetermined.
impl<A> fmt::Display for Circuits<A> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let numbers: Vec<usize> = (1..=self.branches.len()).collect();
        f.write_str(&self.numbered(&numbers))
    }
}

impl<A> Circuits<A> {
    /// The table with other numbers of the assemblies, one for each of `branches`, and in their
    /// order. Circuits are numbered as they come.
    #[doc(hidden)]
    #[must_use]
    pub fn numbered(&self, numbers: &[usize]) -> String {
        let titles = ["assembly", "circuit", "from", "to", "least margin", "at"];
        let mut title = titles.map(String::from).to_vec();
        if let Some(first) = self.branches.first() {
            title.push(self.input.to_string());
            title.extend(
                first
                    .unknowns
                    .iter()
                    .map(|unknown| unknown.name.to_string()),
            );
        }
        let mut rows: Vec<Vec<String>> = vec![title];
        let mut in_order: Vec<_> = numbers.iter().zip(&self.branches).collect();
        in_order.sort_by_key(|(number, _)| **number);
        let mut circuits: Vec<usize> = Vec::new();
        for (_, branch) in &in_order {
            if !circuits.contains(&branch.circuit) {
                circuits.push(branch.circuit);
            }
        }
        let circuit = |number: usize| {
            let known = circuits.iter().position(|other| *other == number);
            known.map_or(0, |known| known + 1)
        };
        for (number, branch) in in_order {
            let end = |end: BranchEnd| self.end(end, branch.closed);
            let mut row = vec![
                number.to_string(),
                circuit(branch.circuit).to_string(),
                end(branch.ends[0]),
                end(branch.ends[1]),
                rounded(branch.margin).to_string(),
                input(&self.cycle, branch.at, FOUND),
                input(&self.cycle, branch.input, ROUNDOFF),
            ];
            row.extend(branch.unknowns.iter().map(Estimate::value));
            rows.push(row);
        }
        let width = |column: usize| {
            let lengths = rows.iter().map(|row| row[column].chars().count());
            lengths.max().unwrap_or(0)
        };
        let widths: Vec<usize> = (0..rows[0].len()).map(width).collect();
        let mut text = String::new();
        for row in &rows {
            let mut line = String::new();
            for (cell, width) in row.iter().zip(&widths) {
                line += &format!("{cell:width$}  ");
            }
            text += line.trim_end();
            text.push('\n');
        }
        for meeting in &self.meetings {
            text += &self.meeting(meeting, numbers, &circuit);
            text.push('\n');
        }
        for found in &self.undetermined {
            text += &self.without_position(found);
            text.push('\n');
        }
        text
    }

    /// ``undetermined from 10 deg to 70 deg, where x = 0mm at phi = 40 deg: joint `f` of `four` ``
    fn without_position(&self, found: &Undetermined) -> String {
        let Undetermined {
            group,
            ends,
            input: known,
            unknowns,
        } = found;
        let [from, to] = ends.map(|x| input(&self.cycle, x, ROUNDOFF));
        let known = input(&self.cycle, *known, ROUNDOFF);
        let unknowns: Vec<String> = unknowns.iter().map(Estimate::to_string).collect();
        let before = match &unknowns[..] {
            [] => String::new(),
            known_before => format!(
                ", where {} at {} = {known}",
                listed(known_before),
                self.input
            ),
        };
        format!(
            "undetermined from {from} to {to}{before}: {}, whose links lie on each other or in one line throughout",
            group.alone()
        )
    }

    /// `circuits 1 and 2 meet at phi = 0 deg and 180 deg (change points): assemblies 1 and 2`
    fn meeting(
        &self,
        meeting: &Meeting,
        numbers: &[usize],
        circuit: &dyn Fn(usize) -> usize,
    ) -> String {
        let inputs = meeting.at.iter().map(|&x| input(&self.cycle, x, FOUND));
        let inputs: Vec<String> = inputs.collect();
        let points = match inputs.len() {
            1 => "change point",
            _ => "change points",
        };
        let at = format!("meet at {} = {} ({points})", self.input, listed(&inputs));
        let mut branches = meeting.branches;
        branches.sort_by_key(|&k| numbers[k]);
        let [one, other] = branches.map(|k| numbers[k]);
        let [first, second] = branches.map(|k| circuit(self.branches[k].circuit));
        if first == second {
            format!("assemblies {one} and {other} of circuit {first} {at}")
        } else {
            format!("circuits {first} and {second} {at}: assemblies {one} and {other}")
        }
    }

    fn end(&self, end: BranchEnd, closed: bool) -> String {
        let x = input(&self.cycle, end.x(), ROUNDOFF);
        match end {
            BranchEnd::Range(_) if closed => format!("{x} (closed)"),
            BranchEnd::Range(_) => x,
            BranchEnd::TurningPoint(_) => format!("{x} (turning point)"),
            BranchEnd::Lost(_) => format!("{x} (lost)"),
        }
    }
}

/// The accuracy of the place of a smallest value, as a share of the range: roundoff there is
/// squared.
const FOUND: f64 = 1e-7;

/// Roundoff of an input, as a share of the range.
const ROUNDOFF: f64 = 1e-13;

/// An input as it is printed; 0 if it differs by less than its accuracy.
fn input(cycle: &Cycle, x: f64, accuracy: f64) -> String {
    let x = settled(x, accuracy, cycle.high - cycle.low);
    if cycle.angle {
        format!("{} deg", rounded(x.to_degrees()))
    } else {
        rounded(x).to_string()
    }
}

impl Estimate {
    /// The value as it is written in a declaration.
    fn value(&self) -> String {
        let number = |x: &f64| {
            if self.angle {
                format!("{}deg", rounded(x.to_degrees()))
            } else {
                format!("{}{}", rounded(*x), self.unit)
            }
        };
        match &self.numbers[..] {
            [one] => number(one),
            several => {
                let several: Vec<String> = several.iter().map(number).collect();
                format!("({})", several.join(", "))
            }
        }
    }
}

/// The text of the declaration after `unknown`.
impl fmt::Display for Estimate {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} = {}", self.name, self.value())
    }
}
