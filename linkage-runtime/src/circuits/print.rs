//! Circuits as a table.

use super::{BranchEnd, Circuits, Cycle, Estimate, Meeting};
use crate::words::rounded;
use alloc::format;
use alloc::string::{String, ToString};
use alloc::vec;
use alloc::vec::Vec;
use core::fmt;
use linkage_core::range_check::listed;

/// One line for each assembly; angles in degrees. Behind its ends and margin: an input, and the unknowns there. Then one for each pair that meets
/// in change points.
impl<A> fmt::Display for Circuits<A> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
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
        for (index, branch) in self.branches.iter().enumerate() {
            let end = |end: BranchEnd| self.end(end, branch.closed);
            let mut row = vec![
                (index + 1).to_string(),
                (branch.circuit + 1).to_string(),
                end(branch.ends[0]),
                end(branch.ends[1]),
                rounded(branch.margin).to_string(),
                input(&self.cycle, branch.at),
                input(&self.cycle, branch.input),
            ];
            row.extend(branch.unknowns.iter().map(Estimate::value));
            rows.push(row);
        }
        let width = |column: usize| {
            let lengths = rows.iter().map(|row| row[column].chars().count());
            lengths.max().unwrap_or(0)
        };
        let widths: Vec<usize> = (0..rows[0].len()).map(width).collect();
        for row in &rows {
            let mut line = String::new();
            for (cell, width) in row.iter().zip(&widths) {
                line += &format!("{cell:width$}  ");
            }
            writeln!(f, "{}", line.trim_end())?;
        }
        self.meetings
            .iter()
            .try_for_each(|own| writeln!(f, "{}", self.meeting(own)))
    }
}

impl<A> Circuits<A> {
    /// `circuits 1 and 2 meet at phi = 0 deg and 180 deg (change points): assemblies 1 and 2`
    fn meeting(&self, own: &Meeting) -> String {
        let places: Vec<String> = own.at.iter().map(|&x| input(&self.cycle, x)).collect();
        let points = match places.len() {
            1 => "change point",
            _ => "change points",
        };
        let at = format!("meet at {} = {} ({points})", self.input, listed(&places));
        let [one, other] = own.branches.map(|k| k + 1);
        let [first, second] = own.branches.map(|k| self.branches[k].circuit + 1);
        match first == second {
            true => format!("assemblies {one} and {other} of circuit {first} {at}"),
            false => format!("circuits {first} and {second} {at}: assemblies {one} and {other}"),
        }
    }

    fn end(&self, end: BranchEnd, closed: bool) -> String {
        let x = input(&self.cycle, end.x());
        match end {
            BranchEnd::Range(_) if closed => format!("{x} (closed)"),
            BranchEnd::Range(_) => x,
            BranchEnd::TurningPoint(_) => format!("{x} (turning point)"),
            BranchEnd::Lost(_) => format!("{x} (lost)"),
        }
    }
}

/// An input as it is printed.
fn input(cycle: &Cycle, x: f64) -> String {
    if cycle.angle {
        format!("{} deg", rounded(x.to_degrees()))
    } else {
        rounded(x).to_string()
    }
}

impl Estimate {
    /// The value as it is written in a declaration.
    fn value(&self) -> String {
        let number = |x: &f64| match self.angle {
            true => format!("{}deg", rounded(x.to_degrees())),
            false => format!("{}{}", rounded(*x), self.unit),
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

/// As it is written in a declaration, behind `unknown`.
impl fmt::Display for Estimate {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} = {}", self.name, self.value())
    }
}
