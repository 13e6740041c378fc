//! The forms of groups that have a solution.

use linkage_symbolic::{Ex, SymbolId, V2, V3};

use crate::algebra::{Names, Scalar};
use crate::structure::coupled::group::{Coupled, Private};
use crate::structure::elements::{Plane, Rotor, Sphere};

/// A group in the form in which it is solved. Each equation is `sum = 0`.
#[derive(Clone, Debug)]
pub(crate) enum Form<'m> {
    /// `first + second + known = 0`: RRR
    TwoRotors {
        first: Rotor<'m>,
        second: Rotor<'m>,
        known: V2<'m>,
    },
    /// `rotor + slide * guide + known = 0`: RRP, PRR
    RotorAndSlide {
        rotor: Rotor<'m>,
        slide: SymbolId,
        guide: V2<'m>,
        known: V2<'m>,
    },
    /// `(rotor + slide * guide) turning with one angle + known = 0`: RPR. The rotor's vector is the
    /// offset.
    SlideOnRotor {
        rotor: Rotor<'m>,
        slide: SymbolId,
        guide: V2<'m>,
        known: V2<'m>,
    },
    /// `slide 1 * guide 1 + slide 2 * guide 2 + known = 0`: PRP, RPP
    TwoSlides {
        slides: [SymbolId; 2],
        guides: [V2<'m>; 2],
        known: V2<'m>,
    },
    /// `a cos + b sin + c = 0`
    Trigonometric {
        angle: usize,
        a: Ex<'m>,
        b: Ex<'m>,
        c: Ex<'m>,
    },
    /// An angle equal to that of a known direction, or half a turn from it; the direction is open
    /// where `arm` is 0.
    Parallel {
        angle: usize,
        value: Scalar<'m>,
        arm: Ex<'m>,
    },
    /// `a x^2 + b x + c = 0`
    Quadratic {
        symbol: SymbolId,
        a: Ex<'m>,
        b: Ex<'m>,
        c: Ex<'m>,
    },
    /// `a x + b = 0`
    Linear {
        symbol: SymbolId,
        a: Ex<'m>,
        b: Ex<'m>,
    },
    /// `|cosine cos + sine sin + known| = length` in space, the two perpendicular and equally long:
    /// RSSR
    LinkToRotor {
        angle: usize,
        cosine: V3<'m>,
        sine: V3<'m>,
        known: V3<'m>,
        length: Ex<'m>,
    },
    /// `|slide * guide + known| = length` in space: RSSP
    LinkToSlide {
        slide: SymbolId,
        guide: V3<'m>,
        known: V3<'m>,
        length: Ex<'m>,
    },
    /// A point on spheres and planes, three in all; a component that is no coordinate is 0, which
    /// counts as a plane.
    Point {
        /// With the components that they are.
        coordinates: Vec<(SymbolId, usize)>,
        spheres: Vec<Sphere<'m>>,
        planes: Vec<Plane<'m>>,
    },
    /// `slide 1 * guide 1 + slide 2 * guide 2 + slide 3 * guide 3 + known = 0` in space
    ThreeSlides {
        slides: [SymbolId; 3],
        guides: [V3<'m>; 3],
        known: V3<'m>,
    },
    /// An angle given by others.
    Relation { angle: usize, value: Scalar<'m> },
    /// Several loops together: class III and higher
    Coupled(Box<Coupled<'m>>),
}

impl<'m> Form<'m> {
    /// The vectors that turn with its angles, and the lengths of its links in space.
    pub(crate) fn links(&self) -> Vec<Vec<Ex<'m>>> {
        match self {
            Self::LinkToRotor { cosine, length, .. } => vec![cosine.0.to_vec(), vec![*length]],
            Self::LinkToSlide { length, .. } => vec![vec![*length]],
            Self::Point { spheres, .. } => spheres.iter().map(|s| vec![s.radius]).collect(),
            Self::TwoRotors { .. }
            | Self::RotorAndSlide { .. }
            | Self::SlideOnRotor { .. }
            | Self::TwoSlides { .. }
            | Self::Trigonometric { .. }
            | Self::Quadratic { .. }
            | Self::Linear { .. }
            | Self::ThreeSlides { .. }
            | Self::Relation { .. }
            | Self::Parallel { .. }
            | Self::Coupled(_) => self.rotors().iter().map(|r| r.z.0.to_vec()).collect(),
        }
    }

    /// The angles of its links that are no unknowns of the mechanism.
    pub(crate) fn introduced_angles(&self, names: &Names) -> Vec<usize> {
        let introduced = |angle: &usize| {
            let angle = &names.angles[*angle];
            angle.unknown.is_none() && angle.stands_for.is_none()
        };
        let angles: Vec<usize> = match self {
            Self::Trigonometric { angle, .. } | Self::Parallel { angle, .. } => vec![*angle],
            _ => self.rotors().iter().map(|rotor| rotor.angle).collect(),
        };
        angles.into_iter().filter(introduced).collect()
    }

    fn rotors(&self) -> Vec<&Rotor<'m>> {
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
            Self::TwoSlides { .. }
            | Self::Trigonometric { .. }
            | Self::Quadratic { .. }
            | Self::Linear { .. }
            | Self::LinkToRotor { .. }
            | Self::LinkToSlide { .. }
            | Self::Point { .. }
            | Self::ThreeSlides { .. }
            | Self::Relation { .. }
            | Self::Parallel { .. } => Vec::new(),
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
            Self::Relation { .. } | Self::Parallel { .. } => "relation",
            Self::Coupled(_) => "coupled",
        }
    }
}
