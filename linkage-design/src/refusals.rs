//! Counts of refused starts.

use std::string::String;
use std::vec::Vec;

use super::error::Refusals;
use super::violation::Violation;

/// Refused starts, with relations and conditions by their numbers.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Tally {
    pub(crate) refused: usize,
    pub(crate) open: usize,
    pub(crate) broken: usize,
    pub(crate) relations: Vec<usize>,
    pub(crate) conditions: Vec<usize>,
    /// The worst condition of the end that comes nearest.
    pub(crate) nearest: Option<Violation>,
}

/// The fate of a start in the modes of all assemblies, the best last.
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
        for (counts, others) in pairs {
            let others = others.iter().enumerate();
            others.for_each(|(k, &more)| count(counts, k, more));
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
            .and_then(|nearest| Some((conditions.get(nearest.objective)?.clone(), nearest.by)));
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
