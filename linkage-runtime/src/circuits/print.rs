//! Circuits as a table.

use super::{BranchEnd, Circuits, Cycle};
use crate::words::rounded;
use alloc::format;
use alloc::string::{String, ToString};
use alloc::vec;
use alloc::vec::Vec;
use core::fmt;

/// One line for each assembly; angles in degrees.
impl<A> fmt::Display for Circuits<A> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let titles = ["assembly", "circuit", "from", "to", "least margin", "at"];
        let mut rows: Vec<Vec<String>> = vec![titles.map(String::from).to_vec()];
        for (index, branch) in self.branches.iter().enumerate() {
            let end = |end: BranchEnd| self.end(end, branch.closed);
            rows.push(vec![
                (index + 1).to_string(),
                (branch.circuit + 1).to_string(),
                end(branch.ends[0]),
                end(branch.ends[1]),
                rounded(branch.margin).to_string(),
                self.cycle.input(branch.at),
            ]);
        }
        let width = |column: usize| {
            let lengths = rows.iter().map(|row| row[column].chars().count());
            lengths.max().unwrap_or(0)
        };
        let widths: Vec<usize> = (0..titles.len()).map(width).collect();
        for row in &rows {
            let mut line = String::new();
            for (cell, width) in row.iter().zip(&widths) {
                line += &format!("{cell:width$}  ");
            }
            writeln!(f, "{}", line.trim_end())?;
        }
        Ok(())
    }
}

impl<A> Circuits<A> {
    fn end(&self, end: BranchEnd, closed: bool) -> String {
        let x = self.cycle.input(end.x());
        match end {
            BranchEnd::Range(_) if closed => format!("{x} (closed)"),
            BranchEnd::Range(_) => x,
            BranchEnd::TurningPoint(_) => format!("{x} (turning point)"),
            BranchEnd::Lost(_) => format!("{x} (lost)"),
        }
    }
}

impl Cycle {
    /// An input as it is printed.
    fn input(&self, x: f64) -> String {
        if self.angle {
            format!("{} deg", rounded(x.to_degrees()))
        } else {
            rounded(x).to_string()
        }
    }
}
