//! The forms of groups that have a solution.

use linkage_symbolic::{NodeId, SymbolId};

use crate::algebra::Scalar;

use super::{Coupled, Private};

/// A vector that turns with an unknown angle: `z (cos + i sense sin)` in complex numbers.
#[derive(Clone, Debug)]
pub(crate) struct Rotor {
    pub(crate) angle: usize,
    /// -1 if the vector turns against the angle.
    pub(crate) sense: f64,
    pub(crate) z: [NodeId; 2],
}

/// `|known + factor * point| = radius`
#[derive(Clone, Debug)]
pub(crate) struct Sphere {
    pub(crate) known: [NodeId; 3],
    pub(crate) factor: NodeId,
    pub(crate) radius: NodeId,
}

/// `normal . point + offset = 0`
#[derive(Clone, Debug)]
pub(crate) struct Plane {
    pub(crate) normal: [NodeId; 3],
    pub(crate) offset: NodeId,
}

/// A group in the form in which it is solved. Each equation is `sum = 0`.
#[derive(Clone, Debug)]
pub(crate) enum Form {
    /// `first + second + known = 0`: RRR
    TwoRotors {
        first: Rotor,
        second: Rotor,
        known: [NodeId; 2],
    },
    /// `rotor + slide * guide + known = 0`: RRP, PRR
    RotorAndSlide {
        rotor: Rotor,
        slide: SymbolId,
        guide: [NodeId; 2],
        known: [NodeId; 2],
    },
    /// `(rotor + slide * guide) turning with one angle + known = 0`: RPR. The rotor's vector is the offset.
    SlideOnRotor {
        rotor: Rotor,
        slide: SymbolId,
        guide: [NodeId; 2],
        known: [NodeId; 2],
    },
    /// `slide 1 * guide 1 + slide 2 * guide 2 + known = 0`: PRP, RPP
    TwoSlides {
        slides: [SymbolId; 2],
        guides: [[NodeId; 2]; 2],
        known: [NodeId; 2],
    },
    /// `a cos + b sin + c = 0`
    Trigonometric {
        angle: usize,
        a: NodeId,
        b: NodeId,
        c: NodeId,
    },
    /// `a x^2 + b x + c = 0`
    Quadratic {
        symbol: SymbolId,
        a: NodeId,
        b: NodeId,
        c: NodeId,
    },
    /// `a x + b = 0`
    Linear {
        symbol: SymbolId,
        a: NodeId,
        b: NodeId,
    },
    /// `|cosine cos + sine sin + known| = length` in space, the two perpendicular and equally long: RSSR
    LinkToRotor {
        angle: usize,
        cosine: [NodeId; 3],
        sine: [NodeId; 3],
        known: [NodeId; 3],
        length: NodeId,
    },
    /// `|slide * guide + known| = length` in space: RSSP
    LinkToSlide {
        slide: SymbolId,
        guide: [NodeId; 3],
        known: [NodeId; 3],
        length: NodeId,
    },
    /// A point on spheres and planes, three in all; a component that is no coordinate is 0, which counts as a plane.
    Point {
        /// With the components that they are.
        coordinates: Vec<(SymbolId, usize)>,
        spheres: Vec<Sphere>,
        planes: Vec<Plane>,
    },
    /// `slide 1 * guide 1 + slide 2 * guide 2 + slide 3 * guide 3 + known = 0` in space
    ThreeSlides {
        slides: [SymbolId; 3],
        guides: [[NodeId; 3]; 3],
        known: [NodeId; 3],
    },
    /// An angle given by others.
    Relation { angle: usize, value: Scalar },
    /// Several loops together: class III and higher
    Coupled(Box<Coupled>),
}

impl Form {
    /// The vectors that turn with its angles, and the lengths of its links in space.
    pub(crate) fn links(&self) -> Vec<Vec<NodeId>> {
        match self {
            Self::LinkToRotor { cosine, length, .. } => vec![cosine.to_vec(), vec![*length]],
            Self::LinkToSlide { length, .. } => vec![vec![*length]],
            Self::Point { spheres, .. } => spheres.iter().map(|s| vec![s.radius]).collect(),
            _ => self.rotors().iter().map(|rotor| rotor.z.to_vec()).collect(),
        }
    }

    fn rotors(&self) -> Vec<&Rotor> {
        match self {
            Self::TwoRotors { first, second, .. } => vec![first, second],
            Self::RotorAndSlide { rotor, .. } | Self::SlideOnRotor { rotor, .. } => vec![rotor],
            Self::Coupled(coupled) => {
                let privates = coupled.blocks.iter().filter_map(|b| b.private.as_ref());
                let rotors = privates.filter_map(|private| match private {
                    Private::Rotor(rotor) => Some(rotor),
                    Private::Slide { .. } => None,
                });
                rotors.collect()
            }
            _ => Vec::new(),
        }
    }

    /// For dumps.
    pub(crate) fn name(&self) -> &'static str {
        match self {
            Self::TwoRotors { .. } => "two rotors",
            Self::RotorAndSlide { .. } => "rotor and slide",
            Self::SlideOnRotor { .. } => "slide on rotor",
            Self::TwoSlides { .. } => "two slides",
            Self::Trigonometric { .. } => "trigonometric",
            Self::Quadratic { .. } => "quadratic",
            Self::Linear { .. } => "linear",
            Self::LinkToRotor { .. } => "link to rotor",
            Self::LinkToSlide { .. } => "link to slide",
            Self::Point { .. } => "point",
            Self::ThreeSlides { .. } => "three slides",
            Self::Relation { .. } => "relation",
            Self::Coupled(_) => "coupled",
        }
    }
}
