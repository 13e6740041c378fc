//! The equations of a coupled group as polynomials in complex unit vectors, whose real solutions are its assemblies.
//!
//! With `u = cos + i sin` and `1/u` its conjugate, a vector loop is one complex polynomial, and so is its conjugate. A private link
//! gives `V conj(V) = r^2`, a private slide `Im(conj(guide) rest) = 0`. Loops in space and scalar loops are real polynomials, row by row.

use linkage_core::numeric::roots::Variable;
use linkage_symbolic::{Ex, SymbolId, V2, Vector};

use crate::algebra::Algebra;
use crate::structure::{Block, Core, Private, Product};

use super::equations::Equations;
use super::laurent::Laurent;

/// A square system: terms by equation, with the powers of the variables.
#[derive(Clone, Debug)]
pub(crate) struct System<'m> {
    pub(crate) variables: Vec<Variable>,
    /// Equation and exponents of each term.
    pub(crate) terms: Vec<(usize, Vec<i8>)>,
    /// Each term's complex coefficient.
    pub(crate) coefficients: Vec<V2<'m>>,
}

impl<'m> System<'m> {
    /// The scaled equations of a coupled group; none of one that is too large for a listing.
    pub(super) fn new(algebra: &Algebra<'m>, equations: &Equations<'_, 'm>) -> Self {
        let form = equations.form;
        let variables: Vec<Variable> = form.core.iter().map(variable).collect();
        if form.is_large() {
            return Self {
                variables,
                terms: Vec::new(),
                coefficients: Vec::new(),
            };
        }
        let builder = Builder {
            algebra,
            equations,
            variables: &variables,
        };
        let blocks = form.blocks.iter();
        let polynomials = blocks.flat_map(|block| builder.polynomials(block));
        let (mut terms, mut coefficients) = (Vec::new(), Vec::new());
        for (equation, polynomial) in polynomials.enumerate() {
            for (exponents, coefficient) in polynomial.0 {
                terms.push((equation, exponents));
                coefficients.push(coefficient);
            }
        }
        Self {
            variables,
            terms,
            coefficients,
        }
    }
}

fn variable(core: &Core) -> Variable {
    match core {
        Core::Angle(_) => Variable::Unit,
        Core::Length {
            component: None,
            number,
            ..
        } => match number {
            true => Variable::Number,
            false => Variable::Length,
        },
        Core::Length {
            component: Some(0), ..
        } => Variable::Point,
        Core::Length {
            component: Some(_), ..
        } => Variable::Conjugate,
    }
}

/// Writes loops in complex variables.
struct Builder<'a, 'm> {
    algebra: &'a Algebra<'m>,
    equations: &'a Equations<'a, 'm>,
    variables: &'a [Variable],
}

impl<'m> Builder<'_, 'm> {
    /// The polynomials of a loop.
    fn polynomials(&self, block: &Block<'m>) -> Vec<Laurent<'m>> {
        let scale = self.equations.scale;
        match &block.private {
            Some(Private::Rotor(rotor)) => {
                let own = &self.algebra.names.angles[rotor.angle];
                let rest = self.without(block, &[own.cos, own.sin]).scaled(scale);
                let square = &rest * &self.conjugate(&rest);
                let length = scale * rotor.z.length();
                vec![(square - self.constant(length.square())).cleaned()]
            }
            Some(Private::Slide { slide, .. }) => {
                let rest = self.without(block, &[*slide]).scaled(scale);
                let guide = self.factor_of(block, *slide);
                let turned = &self.conjugate(&guide) * &rest;
                let conjugate = self.conjugate(&turned);
                vec![(turned - conjugate).cleaned()]
            }
            None if block.rows.len() == 2 => {
                let all = self.without(block, &[]).scaled(scale);
                let conjugate = self.conjugate(&all);
                vec![all.cleaned(), conjugate.cleaned()]
            }
            None => {
                let scale = self.equations.row_scale(block);
                let rows = 0..block.rows.len();
                rows.map(|row| self.row(block, row).scaled(scale).cleaned())
                    .collect()
            }
        }
    }

    /// `row 0 + i row 1` of the terms that mention none of these symbols.
    fn without(&self, block: &Block<'m>, symbols: &[SymbolId]) -> Laurent<'m> {
        let mentions =
            |product: &Product| product.powers.iter().any(|(own, _)| symbols.contains(own));
        let terms = block.terms.iter();
        self.sum(terms.filter(|product| !mentions(product)).cloned())
    }

    /// The factor of a slide.
    fn factor_of(&self, block: &Block<'m>, slide: SymbolId) -> Laurent<'m> {
        let factors = block.terms.iter().filter_map(|product| {
            let mut factor = product.clone();
            factor.powers.retain(|(symbol, _)| *symbol != slide);
            (factor.powers.len() < product.powers.len()).then_some(factor)
        });
        self.sum(factors)
    }

    /// One row, a real polynomial.
    fn row(&self, block: &Block<'m>, row: usize) -> Laurent<'m> {
        self.sum(block.terms.iter().map(|product| Product {
            coefficient: vec![product.coefficient[row]],
            powers: product.powers.clone(),
        }))
    }

    fn sum(&self, products: impl Iterator<Item = Product<'m>>) -> Laurent<'m> {
        products.fold(Laurent::default(), |sum, product| {
            sum + self.product(&product)
        })
    }

    fn product(&self, product: &Product<'m>) -> Laurent<'m> {
        let coefficient = match product.coefficient[..] {
            [re, im] => Vector([re, im]),
            _ => self.real(product.coefficient[0]),
        };
        let start = Laurent::term(self.no_exponents(), coefficient);
        let powers = product.powers.iter();
        powers.fold(start, |product, &(symbol, power)| {
            let factor = self.symbol(symbol);
            (0..power).fold(product, |product, _| &product * &factor)
        })
    }

    /// A symbol of the core in complex variables.
    fn symbol(&self, symbol: SymbolId) -> Laurent<'m> {
        for (place, core) in self.equations.form.core.iter().enumerate() {
            match *core {
                Core::Angle(angle) => {
                    let angle = &self.algebra.names.angles[angle];
                    let [u, inverse] = [1, -1].map(|exponent| self.variable(place, exponent));
                    if angle.cos == symbol {
                        return self.real_part(u, inverse);
                    }
                    if angle.sin == symbol {
                        return self.imaginary_part(u, inverse);
                    }
                }
                Core::Length {
                    symbol: own,
                    component,
                    ..
                } if own == symbol => {
                    let unit = self.equations.unit_of(*core);
                    let variable = |place| self.variable(place, 1);
                    let scaled = match component {
                        None => variable(place),
                        Some(0) => self.real_part(variable(place), variable(place + 1)),
                        Some(_) => self.imaginary_part(variable(place - 1), variable(place)),
                    };
                    return scaled.scaled(unit);
                }
                Core::Length { .. } => {}
            }
        }
        unreachable!("loops mention unknowns of the core and their own private one")
    }

    /// `(z + conj z)/2`
    fn real_part(&self, z: Laurent<'m>, conjugate: Laurent<'m>) -> Laurent<'m> {
        let half = self.algebra.graph.number(0.5);
        (z + conjugate).scaled(half)
    }

    /// `(z - conj z)/2i`
    fn imaginary_part(&self, z: Laurent<'m>, conjugate: Laurent<'m>) -> Laurent<'m> {
        let half_turned_back = Vector([0.0, -0.5].map(|x| self.algebra.graph.number(x)));
        (z - conjugate).turned(half_turned_back)
    }

    fn conjugate(&self, polynomial: &Laurent<'m>) -> Laurent<'m> {
        polynomial.conjugate(self.variables)
    }

    fn variable(&self, place: usize, exponent: i8) -> Laurent<'m> {
        let mut exponents = self.no_exponents();
        exponents[place] = exponent;
        Laurent::term(exponents, self.real(self.algebra.one()))
    }

    fn constant(&self, x: Ex<'m>) -> Laurent<'m> {
        Laurent::term(self.no_exponents(), self.real(x))
    }

    fn no_exponents(&self) -> Vec<i8> {
        vec![0; self.variables.len()]
    }

    fn real(&self, x: Ex<'m>) -> V2<'m> {
        Vector([x, self.algebra.zero()])
    }
}
