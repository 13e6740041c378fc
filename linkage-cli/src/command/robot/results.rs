//! The results of a function at one position, by the names of its fields.

use linkage_compiler::ir::plain;
use linkage_engine::{Assembly, Mechanism};

use super::space_vectors::Vector;

/// The numbers of all fields, and the unit of each.
pub(super) struct Values {
    fields: Vec<(String, Vec<f64>, String)>,
}

impl Values {
    /// Calls a function.
    pub(super) fn of_call(
        mechanism: &Mechanism,
        assembly: &Assembly,
        function: usize,
        arguments: &[f64],
    ) -> Self {
        let numbers = assembly.call(function, arguments);
        let function = &mechanism.compiled().functions[function];
        let mut fields = Vec::new();
        let mut first = 0;
        for field in &function.fields {
            let range = first..first + field.shape.width();
            first = range.end;
            let unit = function.columns[range.start].unit.clone();
            fields.push((plain(&field.name).to_owned(), numbers[range].to_vec(), unit));
        }
        Self { fields }
    }

    /// The numbers of a field; none if it does not exist.
    pub(super) fn numbers(&self, name: &str) -> &[f64] {
        let mut fields = self.fields.iter();
        let found = fields.find(|(field, ..)| field == name);
        found.map_or(&[], |(_, numbers, _)| numbers)
    }

    /// The unit of a field.
    pub(super) fn unit(&self, name: &str) -> &str {
        let mut fields = self.fields.iter();
        let found = fields.find(|(field, ..)| field == name);
        found.map_or("", |(.., unit)| unit)
    }

    /// The first number of a field.
    pub(super) fn number(&self, name: &str) -> f64 {
        self.numbers(name).first().copied().unwrap_or(f64::NAN)
    }

    /// A field that is a vector; one of the plane has no third component.
    pub(super) fn vector(&self, name: &str) -> Vector {
        match *self.numbers(name) {
            [x, y] => [x, y, 0.0],
            [x, y, z] => [x, y, z],
            _ => [f64::NAN; 3],
        }
    }
}
