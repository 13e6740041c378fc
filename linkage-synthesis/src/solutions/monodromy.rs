//! All solutions of a member with general constants.
//!
//! A random place solves the equations with the constants that it gives: one solution for nothing.
//! Followed around random loops of constants it comes back as others (monodromy), which do so in
//! turn. All pairs of a place and its constants are one piece, the graph of the equations, so that
//! there are loops from each solution to each other one.

use super::super::certificate::Certificate;
use super::super::path::{Pace, Stuck, follow};
use super::family::{Member, ParameterPath};
use super::polynomial_equations::Equations;
use crate::error::Unsolved;
use core::f64::consts::TAU;
use linkage_core::numeric::complex::{Complex, ZERO};
use linkage_design::internals::{in_parallel, quasi_random};
use std::vec::Vec;

/// Loops are made until solutions of which one is missing would have stayed among themselves with a
/// probability below this: a loop exchanges them at random, and takes one of `k + 1` that are left
/// out for itself with probability `1/(k + 1)`.
const MISSED: f64 = 1e-9;
const FEWEST_IDLE: usize = 6;
/// Most solutions that are followed.
pub(super) const MOST: usize = 5000;
/// Random places that are tried for one that solves its equations without doubt.
const PLACES: usize = 4;
const ATTEMPTS: usize = 2;

/// Random numbers, always the same.
pub(super) struct Random(usize);

impl Random {
    const SEED: u64 = 24;

    pub(super) fn new() -> Self {
        Self(0)
    }

    /// Numbers from -1 to 1, their imaginary parts, too.
    pub(super) fn point<const N: usize>(&mut self) -> [Complex; N] {
        let numbers = self.numbers(2 * N);
        core::array::from_fn(|i| {
            Complex::new(2.0 * numbers[2 * i] - 1.0, 2.0 * numbers[2 * i + 1] - 1.0)
        })
    }

    pub(super) fn unit(&mut self) -> Complex {
        Complex::polar(TAU * self.numbers(1)[0])
    }

    fn numbers(&mut self, count: usize) -> Vec<f64> {
        self.0 += 1;
        quasi_random(Self::SEED, self.0, count)
    }
}

/// A member and its known solutions.
pub(super) struct Fibre<'a, E, const N: usize> {
    pub(super) member: Member<'a, E, N>,
    pub(super) found: Vec<Certificate<N>>,
    /// Loops that have brought no further solution, after the last one that did.
    pub(super) idle: usize,
}

impl<'a, E: Equations<N>, const N: usize> Fibre<'a, E, N> {
    /// Starts without known solutions.
    pub(super) fn starting(member: Member<'a, E, N>) -> Self {
        Self {
            member,
            found: Vec::new(),
            idle: 0,
        }
    }

    /// All solutions of the member of a random place.
    pub(super) fn find(kind: &Member<'a, E, N>, random: &mut Random) -> Result<Self, Unsolved> {
        let mut places = (0..PLACES).map(|_| random.point());
        let first = places.find_map(|point| {
            let member = kind.through(&point);
            Some((member, member.shown(&point)?))
        });
        let (member, first) = first.ok_or(Unsolved::Singular)?;
        let mut fibre = Self::starting(member);
        fibre.found.push(first);
        while !fibre.is_settled() {
            fibre.go_round(random)?;
        }
        Ok(fibre)
    }

    /// Returns whether enough loops have brought nothing.
    pub(super) fn is_settled(&self) -> bool {
        let chance = 1.0 / (self.found.len() + 1) as f64;
        self.idle >= FEWEST_IDLE && chance.powf(self.idle as f64) <= MISSED
    }

    /// One more loop.
    pub(super) fn go_round(&mut self, random: &mut Random) -> Result<(), Unsolved> {
        let other = self.member.through(&random.point());
        let there = ParameterPath {
            from: &self.member,
            to: &other,
            arc: random.unit(),
        };
        let back = ParameterPath {
            from: &other,
            to: &self.member,
            arc: random.unit(),
        };
        let ends = in_parallel(&self.found, |known| {
            let turned = end(&there, &middle(known)).ok()?;
            self.member.shown(&end(&back, &turned).ok()?)
        });
        let before = self.found.len();
        ends.into_iter().flatten().for_each(|end| self.add(end));
        self.idle = match self.found.len() == before {
            true => self.idle + 1,
            false => 0,
        };
        if self.found.len() > MOST {
            return Err(Unsolved::TooMany { most: MOST });
        }
        Ok(())
    }

    /// Adds where the solutions of another member lead.
    pub(super) fn follow(
        &mut self,
        from: &Member<'a, E, N>,
        starts: &[[Complex; N]],
        arc: Complex,
    ) {
        let to = &self.member;
        let way = ParameterPath { from, to, arc };
        let ends = in_parallel(starts, |start| to.shown(&end(&way, start).ok()?));
        ends.into_iter().flatten().for_each(|end| self.add(end));
    }

    /// Returns the ends of the solutions of a member in another one; `None` if one leads nowhere.
    pub(super) fn carried(
        from: &Member<'a, E, N>,
        to: &Member<'a, E, N>,
        starts: &[[Complex; N]],
        arc: Complex,
    ) -> Option<Vec<[Complex; N]>> {
        let way = ParameterPath { from, to, arc };
        // The ends are compared by certificates, which have all digits.
        let ends = in_parallel(starts, |start| to.shown(&end(&way, start).ok()?));
        ends.iter().map(|end| end.as_ref().map(middle)).collect()
    }

    /// Adds a solution that is shown to differ from the others.
    pub(super) fn add(&mut self, end: Certificate<N>) {
        if self.found.iter().all(|other| other.is_apart_from(&end)) {
            self.found.push(end);
        }
    }

    pub(super) fn places(&self) -> Vec<[Complex; N]> {
        self.found.iter().map(middle).collect()
    }
}

pub(super) fn middle<const N: usize>(certificate: &Certificate<N>) -> [Complex; N] {
    certificate.discs.map(|disc| disc.middle)
}

/// The end of a path.
pub(super) fn end<E: Equations<N>, const N: usize>(
    way: &ParameterPath<'_, '_, E, N>,
    start: &[Complex; N],
) -> Result<[Complex; N], Stuck<N>> {
    let mut stuck = Stuck {
        t: 1.0,
        point: [ZERO; N],
    };
    for attempt in 0..ATTEMPTS {
        match follow(way, Pace::of_attempt(attempt), 1.0, start) {
            Ok(end) => return Ok(end),
            Err(now) => stuck = now,
        }
    }
    Err(stuck)
}
