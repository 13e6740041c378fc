//! The figures as tables.

use crate::{Outcome, Panel};
use std::fmt::Write;

/// For the terminal.
pub(crate) fn text(panels: &[Panel], about: &str) -> String {
    let mut text = format!("{about}\n");
    for panel in panels {
        let _ = writeln!(text, "\n{}\n", panel.title);
        let rows = rows(panel);
        let width = |column: usize| rows.iter().map(|row| row[column].chars().count()).max();
        let widths: Vec<usize> = (0..rows[0].len()).filter_map(width).collect();
        for row in &rows {
            for (index, (cell, &width)) in row.iter().zip(&widths).enumerate() {
                let _ = match index {
                    0 => write!(text, "{cell:<width$}"),
                    _ => write!(text, "  {cell:>width$}"),
                };
            }
            text.push('\n');
        }
    }
    let _ = writeln!(text, "\n{EXPLANATION}");
    text
}

/// For `docs/pareto.md`.
pub(crate) fn markdown(panels: &[Panel], about: &str) -> String {
    let mut text = format!("# Run time against error\n\n{about}\n\n{EXPLANATION}\n");
    let _ = writeln!(text, "\n![Run time against error](pareto.svg)");
    let _ = writeln!(
        text,
        "\n![Run time against error where methods differ](pareto-hard.svg)"
    );
    for panel in panels {
        let _ = writeln!(text, "\n## {}\n", panel.title);
        let _ = writeln!(text, "Errors in 2^-53 times {}.\n", panel.unit);
        for (index, row) in rows(panel).iter().enumerate() {
            let _ = writeln!(text, "| {} |", row.join(" | "));
            if index == 0 {
                let _ = writeln!(text, "|---{}", "|--:".repeat(row.len() - 1) + "|");
            }
        }
    }
    text
}

const EXPLANATION: &str = "\
Kernel K1, a crank-rocker with a coupler point. Time per position: median over interleaved rounds, with quartiles;
the ratio is that of times in one round, to the generated function in f64. Errors are against 154 digits: the
largest of each part over all positions, and the median over the positions of the largest of all parts. Newton's
method goes on from the position before.

Methods hardly differ on a crank-rocker whose links are alike. The last table has a rocker of 10 um (needle), the
last 0.1 to 3e-7 radians before a dead point, and a parallelogram as near to its change point, in units of what a
roundoff in each dimension, the angle and the point itself does; the times are those of the point alone. NaN: a
position that can be assembled has no result.";

fn rows(panel: &Panel) -> Vec<Vec<String>> {
    let mut head = vec![
        "method".to_owned(),
        "ns".into(),
        "quartiles".into(),
        "ratio".into(),
    ];
    head.extend(panel.parts.iter().map(|&part| part.to_owned()));
    head.push("median".into());
    let ours = &panel.outcomes[0].times;
    let row = |outcome: &Outcome| {
        let time = outcome.times.spread();
        let mut row = vec![
            outcome.name.to_owned(),
            format!("{:.1}", time.median),
            format!("{:.1}-{:.1}", time.low, time.high),
            format!("{:.2}", outcome.times.ratio(ours).median),
        ];
        row.extend(outcome.errors.largest.iter().map(|&error| figure(error)));
        row.push(figure(outcome.errors.median));
        row
    };
    [head]
        .into_iter()
        .chain(panel.outcomes.iter().map(row))
        .collect()
}

/// Two digits, without an exponent where it reads well.
fn figure(x: f64) -> String {
    if (0.01..1e4).contains(&x) {
        let digits = (1 - x.log10().floor() as i32).max(0) as usize;
        format!("{x:.digits$}")
    } else {
        format!("{x:.1e}")
    }
}
