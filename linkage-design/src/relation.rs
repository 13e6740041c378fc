//! Relations between parameters that must hold.

use std::format;
use std::string::{String, ToString};
use std::vec;
use std::vec::Vec;

use linkage_core::format::rounded;

/// A linear relation between parameters that must hold: in their units, angles in radians.
#[derive(Clone, Debug, PartialEq)]
pub struct Relation {
    pub(crate) terms: Vec<(String, f64)>,
    pub(crate) most: f64,
    pub(crate) equality: bool,
}

impl Relation {
    /// The sum of these parameters, each times its factor, is at most so much.
    #[must_use]
    pub fn at_most<'a>(terms: impl IntoIterator<Item = (&'a str, f64)>, most: f64) -> Self {
        let terms = terms
            .into_iter()
            .map(|(name, factor)| (name.to_string(), factor));
        Self {
            terms: terms.collect(),
            most,
            equality: false,
        }
    }

    /// The sum is at least so much.
    #[must_use]
    pub fn at_least<'a>(terms: impl IntoIterator<Item = (&'a str, f64)>, least: f64) -> Self {
        Self::at_most(
            terms.into_iter().map(|(name, factor)| (name, -factor)),
            -least,
        )
    }

    /// The sum is exactly so much: `exactly([("rocker", 1.0), ("coupler", -1.0)], 0.0)` makes both
    /// equal.
    #[must_use]
    pub fn exactly<'a>(terms: impl IntoIterator<Item = (&'a str, f64)>, sum: f64) -> Self {
        Self {
            equality: true,
            ..Self::at_most(terms, sum)
        }
    }

    /// The crank of a four-bar turns fully against the frame: it is the shortest link, and together
    /// with any other one not longer than the two that are left by at least `spare` (Grashof's
    /// condition; with a spare of 0 the links may come in line).
    #[must_use]
    pub fn crank_turns([frame, crank, coupler, rocker]: [&str; 4], spare: f64) -> Vec<Self> {
        let pairs = [
            [frame, coupler, rocker],
            [coupler, frame, rocker],
            [rocker, frame, coupler],
        ];
        let sums = pairs.map(|[other, first, second]| {
            Self::at_most(
                [(crank, 1.0), (other, 1.0), (first, -1.0), (second, -1.0)],
                -spare,
            )
        });
        sums.to_vec()
    }

    /// The relation as text.
    pub(crate) fn described(&self) -> String {
        let mut text = String::new();
        for (index, (name, factor)) in self.terms.iter().enumerate() {
            let sign = match (*factor < 0.0, index) {
                (true, 0) => "-",
                (true, _) => " - ",
                (false, 0) => "",
                (false, _) => " + ",
            };
            let size = factor.abs();
            let term = if size == 1.0 {
                name.clone()
            } else {
                format!("{} {name}", rounded(size))
            };
            text += &format!("{sign}{term}");
        }
        let sign = if self.equality { "=" } else { "<=" };
        format!("{text} {sign} {}", rounded(self.most))
    }
}

/// A relation as a list, so that one and several are added alike.
impl From<Relation> for Vec<Relation> {
    fn from(relation: Relation) -> Self {
        vec![relation]
    }
}
