//! Contradictions between the designs of a comparison.

use std::string::{String, ToString};
use std::vec::Vec;

use super::{Compared, Comparison};
use crate::{check, plots};
use linkage_formats::characters::control;
use linkage_formats::{Mistake, ReportError};

impl Comparison<'_> {
    pub(super) fn check(&self) -> Result<(), ReportError> {
        let mut mistakes = Vec::new();
        mistakes.extend(control("the title", &self.title));
        mistakes.extend(control("the text below the title", &self.about));
        if let Some(first) = self.designs.first() {
            for (index, design) in self.designs.iter().enumerate() {
                self.check_design(first, index, design, &mut mistakes)?;
            }
        } else {
            mistakes.push(Mistake::NoDesign);
        }
        self.check_aims(&mut mistakes);
        match mistakes.is_empty() {
            true => Ok(()),
            false => Err(ReportError::Mistakes(mistakes)),
        }
    }

    fn check_design(
        &self,
        first: &Compared<'_>,
        index: usize,
        design: &Compared<'_>,
        mistakes: &mut Vec<Mistake>,
    ) -> Result<(), ReportError> {
        match check::check(design.report) {
            Err(ReportError::Mistakes(found)) => {
                mistakes.extend(found);
                return Ok(());
            }
            other => other?,
        }
        let name = || design.name.clone();
        mistakes.extend(control("the name of a design", &design.name));
        if self.designs[..index]
            .iter()
            .filter(|other| other.name == design.name)
            .count()
            == 1
        {
            mistakes.push(Mistake::SameName { name: name() });
        }
        let input = |of: &Compared<'_>| (of.report.input.name, of.report.input.unit);
        let same = design.report.positions == first.report.positions;
        if !same || input(design) != input(first) {
            let first = first.name.clone();
            mistakes.push(Mistake::OtherPositions {
                name: name(),
                first,
            });
        }
        for column in self.columns() {
            let Some((_, unit, _)) = plots::find_series(design.report, &column) else {
                mistakes.push(Mistake::Unknown {
                    kind: "column",
                    name: column,
                    known: plots::known_columns(design.report),
                });
                continue;
            };
            let firsts = plots::find_series(first.report, &column).map(|(_, unit, _)| unit);
            mistakes.extend(other_unit(column, design, unit, firsts));
        }
        let all = self.figures();
        for (name, _, unit) in design.all_figures() {
            let firsts = all.iter().find(|(other, _)| *other == name);
            mistakes.extend(other_unit(
                name,
                design,
                unit,
                firsts.map(|(_, unit)| unit.clone()),
            ));
        }
        Ok(())
    }

    fn check_aims(&self, mistakes: &mut Vec<Mistake>) {
        if self.aims.len() == 1 || self.aims.len() > 3 {
            mistakes.push(Mistake::Aims {
                count: self.aims.len(),
            });
        }
        let known: Vec<String> = self.figures().into_iter().map(|(name, _)| name).collect();
        let is_there = |figure: &String| known.contains(figure);
        for aim in self.aims.iter().filter(|aim| !is_there(&aim.figure)) {
            mistakes.push(Mistake::Unknown {
                kind: "figure",
                name: aim.figure.to_string(),
                known: known.clone(),
            });
        }
    }
}

fn other_unit(
    name: String,
    design: &Compared<'_>,
    unit: String,
    first: Option<String>,
) -> Option<Mistake> {
    let first = first.filter(|first| *first != unit)?;
    let (design, units) = (design.name.clone(), [unit, first]);
    Some(Mistake::OtherUnit {
        name,
        design,
        units,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Aim, Report};
    use linkage_runtime::Input;

    fn report(positions: usize) -> Report {
        let input = Input {
            name: "phi",
            unit: "rad",
            reference: 0.0,
            range: Some((0.0, 1.0)),
        };
        Report::new("yoke", &input, &input.positions(positions))
    }

    #[test]
    fn all_that_does_not_fit_is_told_at_once() {
        let (a, b) = (report(3), report(4));
        let comparison = Comparison::new("Two")
            .design(Compared::new("a", &a).figure("force", 1.0, "N"))
            .design(Compared::new("a", &b).figure("force", 1.0, "kN"))
            .curves(["psi"])
            .front([Aim::least("dwell")]);
        let message = comparison.html().unwrap_err().to_string();
        let message: Vec<&str> = message.lines().collect();
        assert_eq!(
            message,
            [
                "no column `psi`; there is nothing",
                "two designs are called `a`; give one of them another name",
                "`a` was swept over other positions than `a`; sweep all designs over the same ones",
                "no column `psi`; there is nothing",
                "`force` of `a` is in \"kN\", that of the first design in \"N\"; give all in one unit",
                "a front is of two or three wishes, which is our limit, and not of 1; leave some, or add some",
                "no figure `dwell`; there is `force`",
            ]
        );
        let nothing = Comparison::new("None").html().unwrap_err().to_string();
        assert_eq!(nothing, "a comparison without a design; add some");
    }

    /// Words end neither the page's script nor its title, and a design without a picture is no
    /// obstacle.
    #[test]
    fn words_are_no_markup() {
        let report = report(3);
        let name = "</script><b>";
        let page = Comparison::new(name).design(Compared::new(name, &report));
        let page = page.html().unwrap_or_else(|error| panic!("{error}"));
        assert!(!page.contains("</script><b>"));
        assert!(page.contains("<title>&lt;/script&gt;&lt;b&gt;</title>"));
    }
}
