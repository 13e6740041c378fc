//! What refused the starts of a search, in numbers.

use alloc::boxed::Box;
use alloc::string::String;
use alloc::vec::Vec;
use core::fmt;

use super::DesignError;
use super::certificate::Interrupted;
use super::problem::Violation;
use crate::format::rounded;

/// Why no start led to a mechanism that holds what must hold. Each start counts once: as `refused`, `open`, `broken` or `ended`.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Refusals {
    /// Starts that were tried.
    pub starts: usize,
    /// Starts that contradict relations between parameters.
    pub refused: usize,
    /// These relations, in words, with how many starts contradict each: one start may contradict several.
    pub relations: Vec<(String, usize)>,
    /// Starts that do not assemble where something is wanted.
    pub open: usize,
    /// Starts that end where a condition does not hold.
    pub broken: usize,
    /// These conditions, with how many starts end where each does not hold.
    pub conditions: Vec<(String, usize)>,
    /// Of the ends that violate conditions the one that comes nearest: its condition that is missed most, and by how much.
    pub missed: Option<(String, f64)>,
    /// Starts that end at local optima which hold all conditions; they are refused for what follows.
    pub ended: usize,
    /// Distinct optima near which no values of catalogues hold all conditions.
    pub no_values: usize,
    /// Distinct optima that do not assemble over the whole range on one circuit.
    pub not_whole: usize,
    /// That of them with the least sum of squares, and why it does not.
    pub nearest: Option<Interrupted>,
    /// Distinct optima that violate a condition or a relation in the assembly that would be returned.
    pub unverified: usize,
    /// That of them with the least sum of squares: the condition or relation that is missed most, and by how much.
    pub violated: Option<(String, f64)>,
    /// What refused the first start of a search that has one of its own, with its numbers.
    pub first: Option<Box<DesignError>>,
}

/// Refused starts, with relations and conditions by their numbers.
#[derive(Clone, Debug, Default)]
pub(crate) struct Tally {
    pub(crate) refused: usize,
    pub(crate) open: usize,
    pub(crate) broken: usize,
    relations: Vec<usize>,
    conditions: Vec<usize>,
    /// The worst condition of the end that comes nearest.
    nearest: Option<Violation>,
}

/// What became of a start in the modes of all assemblies, the best last.
#[derive(Clone, Debug, Default)]
pub(crate) enum Fate {
    /// It does not assemble.
    #[default]
    Open,
    /// It ended where these conditions do not hold.
    Broken(Vec<usize>),
    /// It ended at a local optimum.
    Ended,
}

impl Tally {
    /// A start contradicts these relations.
    pub(crate) fn refuse(&mut self, relations: &[usize]) {
        self.refused += 1;
        relations
            .iter()
            .for_each(|&k| count(&mut self.relations, k, 1));
    }

    /// A start ends where these conditions do not hold.
    pub(crate) fn missed(&mut self, conditions: &[Violation]) {
        let parts = conditions.iter().copied();
        let worst = parts.max_by(|a, b| a.part.total_cmp(&b.part));
        self.nearer(worst);
    }

    fn nearer(&mut self, other: Option<Violation>) {
        let both = self.nearest.into_iter().chain(other);
        self.nearest = both.min_by(|a, b| a.part.total_cmp(&b.part));
    }

    pub(crate) fn begun(&mut self, fate: &Fate) {
        match fate {
            Fate::Open => self.open += 1,
            Fate::Broken(conditions) => {
                self.broken += 1;
                conditions
                    .iter()
                    .for_each(|&k| count(&mut self.conditions, k, 1));
            }
            Fate::Ended => {}
        }
    }

    pub(crate) fn add(&mut self, other: &Self) {
        self.refused += other.refused;
        self.open += other.open;
        self.broken += other.broken;
        self.nearer(other.nearest);
        let pairs = [
            (&mut self.relations, &other.relations),
            (&mut self.conditions, &other.conditions),
        ];
        for (own, others) in pairs {
            let others = others.iter().enumerate();
            others.for_each(|(k, &more)| count(own, k, more));
        }
    }

    /// With relations and conditions by their names.
    pub(crate) fn refusals(
        &self,
        starts: usize,
        relations: Vec<String>,
        conditions: Vec<String>,
    ) -> Refusals {
        let named = |names: Vec<String>, counts: &[usize]| {
            let pairs = names.into_iter().zip(counts.iter().copied());
            pairs.filter(|(_, count)| *count > 0).collect()
        };
        let missed = self
            .nearest
            .and_then(|own| Some((conditions.get(own.wish)?.clone(), own.by)));
        Refusals {
            missed,
            starts,
            refused: self.refused,
            relations: named(relations, &self.relations),
            open: self.open,
            broken: self.broken,
            conditions: named(conditions, &self.conditions),
            ended: starts - self.refused - self.open - self.broken,
            ..Refusals::default()
        }
    }
}

fn count(counts: &mut Vec<usize>, number: usize, more: usize) {
    if counts.len() <= number {
        counts.resize(number + 1, 0);
    }
    counts[number] += more;
}

/// One sentence, without what refused none.
impl fmt::Display for Refusals {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "none of {} starts led to a mechanism that assembles over its whole range on one circuit and holds what must hold",
            self.starts
        )?;
        let mut between = ": ";
        let mut tell =
            |f: &mut fmt::Formatter<'_>, count: usize, what: &str, by: &[(String, usize)]| {
                if count == 0 {
                    return Ok(());
                }
                write!(f, "{between}{count} {what}")?;
                between = ", ";
                for (k, (name, count)) in by.iter().enumerate() {
                    write!(f, "{}{count} `{name}`", if k == 0 { " (" } else { ", " })?;
                }
                f.write_str(if by.is_empty() { "" } else { ")" })
            };
        tell(f, self.refused, "contradict relations", &self.relations)?;
        tell(
            f,
            self.open,
            "do not assemble where something is wanted",
            &[],
        )?;
        tell(
            f,
            self.broken,
            "end where a condition does not hold",
            &self.conditions,
        )?;
        tell(f, self.ended, "end at local optima", &[])?;
        tell(
            f,
            self.no_values,
            "of these optima have no values of the catalogues near them that hold all conditions",
            &[],
        )?;
        tell(
            f,
            self.not_whole,
            "of these optima do not run through the range",
            &[],
        )?;
        tell(
            f,
            self.unverified,
            "of these optima violate what must hold once they are assembled",
            &[],
        )?;
        for (name, by) in self.violated.iter().chain(&self.missed) {
            write!(f, "; the nearest misses `{name}` by {}", rounded(*by))?;
        }
        if let Some(nearest) = &self.nearest {
            write!(f, "; {nearest}")?;
        }
        if let Some(first) = &self.first {
            write!(f, "; the first start: {first}")?;
        }
        Ok(())
    }
}
