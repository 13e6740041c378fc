//! Lengths and scalar products, which the graph remembers.

use super::any_vector::Vn;
use super::ex::Ex;
use super::numeric_equality::{numerically_equal, numerically_equal_within};
use super::vector::{V3, Vector};

/// Rounding of the square of a direction.
const UNIT: f64 = 8.0 * f64::EPSILON;

impl<'g> Vn<'g> {
    /// The scalar product.
    pub fn dot(self, other: Self) -> Ex<'g> {
        if self == other {
            return self.square();
        }
        let zero = Ex::new(self.graph, self.graph.zero());
        let pairs = self.iter().zip(other.iter());
        pairs.fold(zero, |sum, (x, y)| sum + x * y)
    }

    /// The direction: see [`V3::unit`] and [`Vector::length_and_unit`].
    #[must_use]
    pub fn unit(self) -> Self {
        match self.in_space() {
            Some(vector) => vector.unit().into(),
            None => Vector([self.at(0), self.at(1)]).length_and_unit().1.into(),
        }
    }

    /// Returns the length. The graph remembers the vector for it.
    pub fn length(self) -> Ex<'g> {
        let length = match self.len() {
            2 => self.at(0).hypot(self.at(1)),
            _ => self.square().sqrt(),
        };
        let norms = &mut self.graph.store_mut().vectors.norms;
        norms.insert(length.id(), self.ids().to_vec());
        length
    }

    /// Returns the scalar product with itself. The graph remembers the vector for it.
    pub fn square(self) -> Ex<'g> {
        let zero = self.graph.number(0.0);
        let square = self.iter().fold(zero, |sum, x| sum + x.square());
        let squares = &mut self.graph.store_mut().vectors.squares;
        squares.insert(square.id(), self.ids().to_vec());
        square
    }

    /// Remembers that the length is 1: of the vector, its opposite, and in the plane both turned by
    /// a quarter.
    pub fn mark_unit(self) {
        let back = -self;
        let quarters = match (self.ids(), back.ids()) {
            (&[x, y], &[back_x, back_y]) => vec![vec![back_y, x], vec![y, back_x]],
            _ => Vec::new(),
        };
        let units = &mut self.graph.store_mut().vectors.units;
        units.extend(quarters);
        units.extend([self, back].map(|v| v.ids().to_vec()));
    }

    /// True if the length is known to be 1.
    pub fn is_unit(self) -> bool {
        let constants: Option<Vec<f64>> = self.iter().map(Ex::constant_value).collect();
        match constants {
            Some(numbers) => {
                let square: f64 = numbers.iter().map(|x| x * x).sum();
                (square - 1.0).abs() <= 2.0 * f64::EPSILON
            }
            None => self.graph.store().vectors.units.contains(self.ids()),
        }
    }

    /// True if two vectors are perpendicular and of one length. Not by a product that vanishes:
    /// rounded constants leave a rest of it, which is small only beside the squares.
    pub fn is_turned(self, other: Self) -> bool {
        let [first, second] = [self, other].map(Self::square);
        let whole = (self + other).square();
        let parts = first + second;
        numerically_equal(first, second) && numerically_equal(whole, parts)
    }
}

impl<'g, const N: usize> Vector<'g, N> {
    /// The scalar product.
    pub fn dot(self, other: Self) -> Ex<'g> {
        self.either().dot(other.either())
    }

    /// Returns the scalar product with itself. The graph remembers the vector for it.
    pub fn square(self) -> Ex<'g> {
        self.either().square()
    }

    /// Returns the length. The graph remembers the vector for it.
    pub fn length(self) -> Ex<'g> {
        self.either().length()
    }

    /// True if the length is known to be 1.
    pub fn is_unit(self) -> bool {
        self.either().is_unit()
    }

    /// Remembers that the length is 1.
    pub fn mark_unit(self) {
        self.either().mark_unit();
    }

    /// Returns the length, and the vector divided by it. A known unit vector is not divided.
    pub fn length_and_unit(self) -> (Ex<'g>, Self) {
        if self.is_unit() {
            return (self.0[0].number(1.0), self);
        }
        let length = self.length();
        let unit = self / length;
        unit.mark_unit();
        (length, unit)
    }

    fn either(self) -> Vn<'g> {
        Vn::from(self)
    }
}

impl<'g> V3<'g> {
    /// The scalar product; its factors stay known.
    pub fn product(self, other: Self) -> Ex<'g> {
        let product = self.dot(other);
        let factors = self.0.iter().chain(&other.0).map(|x| x.id()).collect();
        let products = &mut product.graph().store_mut().vectors.products;
        products.insert(product.id(), factors);
        product
    }
}

impl V3<'_> {
    /// Returns the direction. A vector of length 1 by its formula, as `(cos t, 0, sin t)`, is not
    /// divided.
    #[must_use]
    pub fn unit(self) -> Self {
        if !self.is_unit() {
            let (square, one) = (self.square(), self.0[0].number(1.0));
            if numerically_equal_within(square, one, UNIT) {
                self.mark_unit();
            }
        }
        self.length_and_unit().1
    }
}
