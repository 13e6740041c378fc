//! A mechanism as the reference sees it: data, unknowns, residuals, outputs.

use crate::{Big, Datum, Kind, Plane, Space, Unknown};

/// A quantity to compare.
#[derive(Clone, Debug)]
pub enum Output {
    /// A length or a coordinate.
    Value(Big),
    /// A number without dimension, as the component of a direction.
    Number(Big),
    /// An angle, given by a vector that points along it.
    Angle(Plane),
}

impl Output {
    /// Lengths or coordinates, one after the other.
    pub fn lengths<const N: usize>(lengths: [Big; N]) -> Vec<Self> {
        lengths.map(Self::Value).to_vec()
    }
}

/// A mechanism as the reference sees it.
///
/// The data are the parameters in declaration order, then constants, then the input. Outputs are the
/// unknowns, in order, then further quantities: the solution of the program is where the reference
/// starts from.
#[derive(Clone, Copy, Debug)]
pub struct System {
    /// The name in reports.
    pub name: &'static str,
    /// Parameters, constants, and last the input.
    pub data: &'static [Datum],
    /// How many of the data are parameters.
    pub parameters: usize,
    /// The unknowns.
    pub unknowns: &'static [Unknown],
    /// The equations, zero at the solution; as many as unknowns. They are lengths, if there is a
    /// length among the data.
    pub residual: fn(&Position) -> Vec<Big>,
    /// The quantities to compare besides the unknowns.
    pub further: fn(&Position) -> Vec<Output>,
    /// Positive where the mechanism can be assembled, zero at a dead point, 1 far from it; from the
    /// data alone.
    pub gap: fn(&Position) -> Big,
    /// The largest angle in radians that a program computes from others (one, if there is none): it
    /// is rounded in proportion, and the roundings turn the mechanism.
    pub turned: fn(&Position) -> Big,
    /// Pairs of data for mixed second derivatives beyond those with the input.
    pub pairs: &'static [(usize, usize)],
    /// Whether the equations are linear: then there is one solution and no assembly mode.
    pub linear: bool,
    /// What the normalised determinant of this system is multiplied by to be `margin()` of the program, from the data alone; none if the
    /// margin is something else.
    pub margin: Option<fn(&Position) -> Big>,
}

impl System {
    /// A system without data, dead points and margin; its outputs are its unknowns.
    pub const PLAIN: Self = Self {
        name: "",
        data: &[],
        parameters: 0,
        unknowns: &[],
        residual: |_| Vec::new(),
        further: |_| Vec::new(),
        gap: |_| Big::one(),
        turned: |_| Big::one(),
        pairs: &[],
        linear: false,
        margin: None,
    };

    /// Index of the input among the data.
    pub fn input(&self) -> usize {
        self.data.len() - 1
    }

    /// The values of the mechanism as written, without the input.
    pub fn default_geometry(&self) -> Vec<f64> {
        self.data[..self.input()]
            .iter()
            .map(|datum| datum.default)
            .collect()
    }

    /// The reference value of the input.
    pub fn reference_input(&self) -> f64 {
        self.data[self.input()].default
    }

    /// The size of the mechanism: its longest given length; 1 without lengths.
    pub fn size(&self, data: &[f64]) -> f64 {
        let data = self.data.iter().zip(data);
        data.filter(|(datum, _)| datum.kind == Kind::Length)
            .map(|(_, x)| x.abs())
            .reduce(f64::max)
            .unwrap_or(1.0)
    }

    /// The data alone, without values of the unknowns.
    fn known<'a>(&'a self, data: &'a [Big]) -> Position<'a> {
        Position {
            system: self,
            data,
            unknowns: &[],
        }
    }

    /// The value of [`System::turned`], at least 1.
    pub(crate) fn turned_at(&self, data: &[Big]) -> f64 {
        let turned = (self.turned)(&self.known(data));
        turned.abs().to_f64().max(1.0)
    }

    /// The value of [`System::margin`] for the given data.
    pub(crate) fn margin_factor(&self, data: &[Big]) -> Option<Big> {
        let factor = self.margin?;
        Some(factor(&self.known(data)))
    }

    /// The value of [`System::gap`] for the given data.
    pub fn gap_at(&self, data: &[Big]) -> Big {
        (self.gap)(&self.known(data))
    }
}

/// The data and a trial value of the unknowns.
pub struct Position<'a> {
    pub(crate) system: &'a System,
    pub(crate) data: &'a [Big],
    /// One entry for each unknown: a unit vector, or a slide or number in its first component.
    pub(crate) unknowns: &'a [Plane],
}

impl Position<'_> {
    /// A datum.
    pub fn value(&self, name: &str) -> &Big {
        let index = self.system.data.iter().position(|datum| datum.name == name);
        &self.data[index.unwrap_or_else(|| panic!("no datum {name}"))]
    }

    /// A point given by two data, `name.x` and `name.y`.
    pub fn point(&self, name: &str) -> Plane {
        let component = |axis: &str| self.value(&format!("{name}.{axis}")).clone();
        Plane {
            x: component("x"),
            y: component("y"),
        }
    }

    /// A vector of space given by three data, or by three unknowns: `name.x`, `name.y`, `name.z`.
    pub fn space(&self, name: &str) -> Space {
        let component = |axis: &str| {
            let name = format!("{name}.{axis}");
            let unknown = self.unknown(&name).map(|unknown| &unknown.x);
            unknown.unwrap_or_else(|| self.value(&name)).clone()
        };
        Space {
            x: component("x"),
            y: component("y"),
            z: component("z"),
        }
    }

    /// The unit vector of an angle, given or unknown.
    pub fn direction(&self, name: &str) -> Plane {
        match self.unknown(name) {
            Some(direction) => direction.clone(),
            None => Plane::direction(self.value(name)),
        }
    }

    /// `length` along the angle `angle`: the names of a datum and of an angle.
    pub fn polar(&self, length: &str, angle: &str) -> Plane {
        self.direction(angle).times(self.value(length))
    }

    /// An unknown slide.
    pub fn slide(&self, name: &str) -> &Big {
        &self
            .unknown(name)
            .unwrap_or_else(|| panic!("no unknown {name}"))
            .x
    }

    /// The quantities to compare: the unknowns, then the further ones.
    pub(crate) fn outputs(&self) -> Vec<Output> {
        let unknowns = self.system.unknowns.iter().zip(self.unknowns);
        let unknowns = unknowns.map(|(unknown, found)| match unknown.kind {
            Kind::Length => Output::Value(found.x.clone()),
            Kind::Angle => Output::Angle(found.clone()),
            Kind::Ratio => Output::Number(found.x.clone()),
        });
        unknowns.chain((self.system.further)(self)).collect()
    }

    fn unknown(&self, name: &str) -> Option<&Plane> {
        let index = self
            .system
            .unknowns
            .iter()
            .position(|unknown| unknown.name == name)?;
        self.unknowns.get(index)
    }
}
