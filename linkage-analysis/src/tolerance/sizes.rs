//! The lengths by which a rule measures parameters.

use core::array;

use super::given::exactly;
use super::{Grade, ToleranceError, tolerance_factor};
use linkage_runtime::Parameter;

/// A size in mm for each parameter, and how a tolerance in mm becomes one of the parameter.
///
/// The size of a length is its nominal value. An angle or a number has none by itself: a
/// [`lever`](Self::lever) sets the length at which it acts. ISO 286 is about lengths; this is the
/// rule that extends it: the angle may move a point at the end of its lever by the tolerance of a
/// length of that size.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sizes<const N: usize> {
    names: [&'static str; N],
    /// In mm; NaN where there is none.
    sizes: [f64; N],
    /// Units of the parameter for one mm of tolerance.
    units: [f64; N],
}

impl<const N: usize> Sizes<N> {
    /// The sizes of lengths; angles and numbers have none yet. A mechanism with other dimensions
    /// than those of the declaration has them in
    /// [`Dimensions::parameters`](linkage_runtime::Dimensions::parameters).
    ///
    /// # Errors
    ///
    /// `Count` if there are not `N` parameters.
    pub fn new(parameters: &[Parameter]) -> Result<Self, ToleranceError> {
        let parameters: [Parameter; N] = exactly("parameters", parameters)?;
        let units = parameters.map(|parameter| 1.0 / millimetres(parameter.unit));
        Ok(Self {
            names: parameters.map(|parameter| parameter.name),
            sizes: array::from_fn(|i| parameters[i].nominal.abs() / units[i]),
            units,
        })
    }

    /// The parameter with this index acts at this length, in mm: for an angle, and for a number
    /// that multiplies the length.
    ///
    /// # Errors
    ///
    /// `NoSuchParameter` for an index that is not below `N`, `SizeOutOfRange` for a lever that is
    /// not positive and finite.
    pub fn lever(mut self, index: usize, lever: f64) -> Result<Self, ToleranceError> {
        self.checked(index, lever)?;
        (self.sizes[index], self.units[index]) = (lever, 1.0 / lever);
        Ok(self)
    }

    /// Another size, in mm, for the length with this index: for a coordinate, whose nominal value
    /// does not determine the process.
    ///
    /// # Errors
    ///
    /// Works as [`lever`](Self::lever), and fails with `NoSize` for a parameter that is no length.
    pub fn size(mut self, index: usize, size: f64) -> Result<Self, ToleranceError> {
        self.checked(index, size)?;
        if self.units[index].is_nan() {
            return Err(ToleranceError::NoSize {
                name: self.names[index],
            });
        }
        self.sizes[index] = size;
        Ok(self)
    }

    /// The tolerances of one mm.
    pub(super) fn equal(&self) -> Result<[f64; N], ToleranceError> {
        self.each(|_| Ok(1.0))
    }

    /// Tolerances in mm that are a thousandth of the standard tolerance factor.
    pub(super) fn factors(&self) -> Result<[f64; N], ToleranceError> {
        self.each(|i| {
            let factor = tolerance_factor(self.sizes[i]).ok_or_else(|| self.out_of_range(i))?;
            Ok(factor / 1000.0)
        })
    }

    /// Half the width of the zone of a grade.
    pub(super) fn grade(&self, grade: Grade) -> Result<[f64; N], ToleranceError> {
        self.each(|i| {
            let width = grade
                .width(self.sizes[i])
                .ok_or_else(|| self.out_of_range(i))?;
            Ok(width / 2.0)
        })
    }

    /// The finest grade that all sizes have.
    pub(super) fn finest(&self) -> Grade {
        let has = |grade: &Grade| self.sizes.iter().all(|&size| grade.width(size).is_some());
        Grade::all().find(has).unwrap_or(Grade::IT01)
    }

    fn each(
        &self,
        millimetres: impl Fn(usize) -> Result<f64, ToleranceError>,
    ) -> Result<[f64; N], ToleranceError> {
        let mut tolerances = [0.0; N];
        for (i, tolerance) in tolerances.iter_mut().enumerate() {
            if self.units[i].is_nan() {
                return Err(ToleranceError::NoSize {
                    name: self.names[i],
                });
            }
            *tolerance = millimetres(i)? * self.units[i];
        }
        Ok(tolerances)
    }

    fn checked(&self, index: usize, size: f64) -> Result<(), ToleranceError> {
        let name = self.names.get(index);
        let &name = name.ok_or(ToleranceError::NoSuchParameter { index, count: N })?;
        if size > 0.0 && size.is_finite() {
            Ok(())
        } else {
            Err(ToleranceError::SizeOutOfRange { name, size })
        }
    }

    fn out_of_range(&self, index: usize) -> ToleranceError {
        ToleranceError::SizeOutOfRange {
            name: self.names[index],
            size: self.sizes[index],
        }
    }
}

/// The unit of a parameter in mm; NaN unless it is a length.
fn millimetres(unit: &str) -> f64 {
    match unit {
        "m" => 1000.0,
        "cm" => 10.0,
        "mm" => 1.0,
        "um" => 0.001,
        "inch" => 25.4,
        _ => f64::NAN,
    }
}
