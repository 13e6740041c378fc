//! What generated C calls: operations that C's library does not have, or not with these results. Each mechanism has its own copy of
//! those that it needs, and nothing else.

use std::collections::BTreeSet;

use crate::real::Real;
use crate::template::fill;

/// A function or a type beside the programs; each stands behind those that it needs.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Helper {
    Bits,
    Nan,
    Pair,
    Select,
    Min,
    Max,
    Sign,
    Slack,
    Quotient,
    InverseScale,
    Root,
    Hypot,
    SinCos,
    Arc,
    Atan2,
    AngleNear,
    Tan,
    Asin,
    Acos,
    Atan,
    Whole,
    Within,
    Infinite,
}

impl Helper {
    /// In the order in which they are printed.
    const ALL: [Self; 23] = [
        Self::Bits,
        Self::Nan,
        Self::Pair,
        Self::Select,
        Self::Min,
        Self::Max,
        Self::Sign,
        Self::Slack,
        Self::Quotient,
        Self::InverseScale,
        Self::Root,
        Self::Hypot,
        Self::SinCos,
        Self::Arc,
        Self::Atan2,
        Self::AngleNear,
        Self::Tan,
        Self::Asin,
        Self::Acos,
        Self::Atan,
        Self::Whole,
        Self::Within,
        Self::Infinite,
    ];

    fn needs(self) -> &'static [Self] {
        match self {
            Self::Bits | Self::Pair | Self::Arc | Self::Whole | Self::Slack | Self::Quotient => &[],
            Self::Nan
            | Self::Select
            | Self::Min
            | Self::Max
            | Self::InverseScale
            | Self::Root
            | Self::Within
            | Self::Infinite => &[Self::Bits],
            Self::Sign => &[Self::Select],
            Self::Hypot => &[Self::InverseScale, Self::Max],
            Self::SinCos => &[Self::Bits, Self::Pair],
            Self::Atan2 => &[Self::Bits, Self::Arc],
            Self::AngleNear | Self::Asin | Self::Acos | Self::Atan => &[Self::Atan2],
            Self::Tan => &[Self::SinCos],
        }
    }

    fn template(self, real: Real) -> &'static str {
        match (self, real) {
            (Self::Bits, _) => include_str!("../templates/bits.c"),
            (Self::Nan, _) => include_str!("../templates/nan.c"),
            (Self::Pair, _) => include_str!("../templates/pair.c"),
            (Self::Select, _) => include_str!("../templates/select.c"),
            (Self::Min, _) => include_str!("../templates/min.c"),
            (Self::Max, _) => include_str!("../templates/max.c"),
            (Self::Sign, _) => include_str!("../templates/sign.c"),
            (Self::Slack, _) => include_str!("../templates/slack.c"),
            (Self::Quotient, _) => include_str!("../templates/quotient.c"),
            (Self::InverseScale, _) => include_str!("../templates/inverse_scale.c"),
            (Self::Root, _) => include_str!("../templates/root.c"),
            (Self::Hypot, _) => include_str!("../templates/hypot.c"),
            (Self::SinCos, Real::Double) => include_str!("../templates/sin_cos_double.c"),
            (Self::SinCos, Real::Single) => include_str!("../templates/sin_cos_single.c"),
            (Self::Arc, Real::Double) => include_str!("../templates/arc_double.c"),
            (Self::Arc, Real::Single) => include_str!("../templates/arc_single.c"),
            (Self::Atan2, _) => include_str!("../templates/atan2.c"),
            (Self::AngleNear, _) => include_str!("../templates/angle_near.c"),
            (Self::Tan, _) => include_str!("../templates/tan.c"),
            (Self::Asin, _) => include_str!("../templates/asin.c"),
            (Self::Acos, _) => include_str!("../templates/acos.c"),
            (Self::Atan, _) => include_str!("../templates/atan.c"),
            (Self::Whole, _) => include_str!("../templates/whole.c"),
            (Self::Within, _) => include_str!("../templates/within.c"),
            (Self::Infinite, _) => include_str!("../templates/infinite.c"),
        }
    }
}

/// The helpers that something needs.
#[derive(Clone, Debug, Default)]
pub(crate) struct Helpers(BTreeSet<Helper>);

impl Helpers {
    /// Takes note of one, and of what it needs.
    pub(crate) fn need(&mut self, helper: Helper) {
        if self.0.insert(helper) {
            helper.needs().iter().for_each(|&own| self.need(own));
        }
    }

    /// Whether one is needed.
    pub(crate) fn has(&self, helper: Helper) -> bool {
        self.0.contains(&helper)
    }

    /// All of them as C.
    pub(crate) fn text(&self, real: Real, own: &str) -> String {
        let needed = Helper::ALL.iter().filter(|own| self.0.contains(own));
        let texts = needed.map(|helper| fill(helper.template(real), real, own, |_| None));
        texts.collect::<Vec<_>>().join("\n")
    }
}
