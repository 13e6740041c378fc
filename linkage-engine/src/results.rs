//! The results of a function at one position.

use std::ops::Index;

use linkage_compiler::ir::{Function, plain};

/// The results of a function at one position, by the names of its fields.
///
/// ```
/// use linkage_engine::Mechanism;
///
/// let text = "
///     pub struct Crank { unit mm; param r = 30mm; input phi = 0deg; let pin = polar(r, phi); }
///     impl Crank { pub fn motion(phi) -> Motion { pin, height: pin.y } }";
/// let mechanism = Mechanism::compile(text)?;
/// let assembly = mechanism.assemble(&mechanism.dimensions())?;
/// let motion = assembly.results("motion", &[0.0]);
/// assert_eq!(motion["height"], 0.0);
/// assert_eq!(motion.vector("pin"), [30.0, 0.0]);
/// assert_eq!(motion.numbers(), [30.0, 0.0, 0.0]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct Results<'m> {
    pub(crate) function: &'m Function,
    pub(crate) numbers: Vec<f64>,
}

impl Results<'_> {
    /// Returns all numbers, one for each column of the function.
    #[must_use]
    pub fn numbers(&self) -> &[f64] {
        &self.numbers
    }

    /// Returns the numbers of a field: one, the components of a vector, or those of all entries of
    /// an array.
    ///
    /// # Panics
    ///
    /// If no field has that name; the message lists those that there are.
    #[must_use]
    pub fn field(&self, name: &str) -> &[f64] {
        let mut rest = &self.numbers[..];
        for field in &self.function.fields {
            let (numbers, others) = rest.split_at(field.shape.width());
            if plain(&field.name) == name {
                return numbers;
            }
            rest = others;
        }
        let names = self.function.fields.iter().map(|field| plain(&field.name));
        panic!(
            "`{}` has no field `{name}`; it has `{}`",
            plain(&self.function.name),
            names.collect::<Vec<_>>().join("`, `")
        )
    }

    /// Returns the components of a field that is a vector, or the `N` numbers of an array.
    ///
    /// # Panics
    ///
    /// If no field has that name, or it has another number of components.
    #[must_use]
    pub fn vector<const N: usize>(&self, name: &str) -> [f64; N] {
        let numbers = self.field(name);
        let components = numbers.try_into();
        components.unwrap_or_else(|_| panic!("`{name}` has {} numbers", numbers.len()))
    }
}

impl Index<&str> for Results<'_> {
    type Output = f64;

    /// Returns the number of a field that is one.
    ///
    /// # Panics
    ///
    /// If no field has that name, or it has several numbers.
    fn index(&self, name: &str) -> &f64 {
        match self.field(name) {
            [number] => number,
            numbers => panic!("`{name}` has {} numbers", numbers.len()),
        }
    }
}
