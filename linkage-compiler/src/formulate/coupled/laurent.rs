//! The equations of a coupled group as polynomials in complex unit vectors, whose real solutions are its assemblies.
//!
//! With `u = cos + i sin` and `1/u` its conjugate, a vector loop is one complex polynomial, and so is its conjugate. A private link
//! gives `V conj(V) = r^2`, a private slide `Im(conj(guide) rest) = 0`. Loops in space and scalar loops are real polynomials, row by row.

use std::collections::BTreeMap;

use linkage_runtime::numeric::roots::Variable;
use linkage_symbolic::{NodeId, SymbolId, agree};

use crate::algebra::Algebra;
use crate::structure::{Block, Core, Coupled, Private};

/// A square system: terms by equation, with the powers of the variables.
#[derive(Clone, Debug, Default)]
pub(crate) struct System {
    pub(crate) variables: Vec<Variable>,
    /// Equation and exponents of each term.
    pub(crate) terms: Vec<(usize, Vec<i8>)>,
    /// Real and imaginary part of each term's coefficient.
    pub(crate) coefficients: Vec<[NodeId; 2]>,
}

/// Complex coefficients by exponents.
type Laurent = BTreeMap<Vec<i8>, [NodeId; 2]>;

impl System {
    /// Lengths are multiplied by `scale`; `unit` is its inverse.
    pub(super) fn new(algebra: &mut Algebra, form: &Coupled, scale: NodeId, unit: NodeId) -> Self {
        let mut builder = Builder {
            variables: form.core.iter().map(variable).collect(),
            core: &form.core,
            algebra,
            unit,
        };
        let mut system = Self::default();
        let mut count = 0;
        for block in &form.blocks {
            for equation in builder.equations(block, scale) {
                for (exponents, coefficient) in equation {
                    system.terms.push((count, exponents));
                    system.coefficients.push(coefficient);
                }
                count += 1;
            }
        }
        system.variables = builder.variables;
        system
    }
}

fn variable(core: &Core) -> Variable {
    match core {
        Core::Angle(_) => Variable::Unit,
        Core::Length {
            component: None, ..
        } => Variable::Length,
        Core::Length {
            component: Some(0), ..
        } => Variable::Point,
        Core::Length { .. } => Variable::Conjugate,
    }
}

struct Builder<'a, 'm> {
    algebra: &'a mut Algebra<'m>,
    core: &'a [Core],
    variables: Vec<Variable>,
    unit: NodeId,
}

impl Builder<'_, '_> {
    fn equations(&mut self, block: &Block, scale: NodeId) -> Vec<Laurent> {
        match &block.private {
            Some(Private::Rotor(rotor)) => {
                let own = {
                    let angle = &self.algebra.angles[rotor.angle];
                    [angle.cos, angle.sin]
                };
                let rest = self.loop_polynomial(block, |powers| {
                    powers.iter().all(|(symbol, _)| !own.contains(symbol))
                });
                let rest = self.scaled(rest, scale);
                let conjugate = self.conjugate(&rest);
                let mut equation = self.product(&rest, &conjugate);
                let length = self.algebra.length(&rotor.z);
                let graph = &mut self.algebra.graph;
                let length = graph.mul(scale, length);
                let square = graph.square(length);
                let minus = graph.neg(square);
                let zero = graph.zero();
                self.add(&mut equation, vec![0; self.core.len()], [minus, zero]);
                vec![self.cleaned(equation)]
            }
            Some(Private::Slide { slide, .. }) => {
                let rest = self.loop_polynomial(block, |powers| {
                    powers.iter().all(|(symbol, _)| symbol != slide)
                });
                let rest = self.scaled(rest, scale);
                let guide = self.guide_polynomial(block, *slide);
                let turned = self.conjugate(&guide);
                let left = self.product(&turned, &rest);
                let right = self.conjugate(&left);
                let mut equation = left;
                for (exponents, [re, im]) in right {
                    let minus = [self.algebra.graph.neg(re), self.algebra.graph.neg(im)];
                    self.add(&mut equation, exponents, minus);
                }
                vec![self.cleaned(equation)]
            }
            None if block.rows.len() == 2 => {
                let all = self.loop_polynomial(block, |_| true);
                let all = self.scaled(all, scale);
                let conjugate = self.conjugate(&all);
                vec![self.cleaned(all), self.cleaned(conjugate)]
            }
            None => (0..block.rows.len())
                .map(|row| {
                    let all = self.row_polynomial(block, row);
                    let all = match block.is_length() {
                        true => self.scaled(all, scale),
                        false => all,
                    };
                    self.cleaned(all)
                })
                .collect(),
        }
    }

    /// `row 0 + i row 1` of the terms that are wanted.
    fn loop_polynomial(
        &mut self,
        block: &Block,
        wanted: impl Fn(&[(SymbolId, u8)]) -> bool,
    ) -> Laurent {
        let mut sum = Laurent::new();
        for product in block.terms.iter().filter(|p| wanted(&p.powers)) {
            self.add_product(&mut sum, &product.coefficient, &product.powers);
        }
        sum
    }

    /// One row, a real polynomial.
    fn row_polynomial(&mut self, block: &Block, row: usize) -> Laurent {
        let mut sum = Laurent::new();
        for product in &block.terms {
            self.add_product(&mut sum, &product.coefficient[row..=row], &product.powers);
        }
        sum
    }

    /// The factor of a slide.
    fn guide_polynomial(&mut self, block: &Block, slide: SymbolId) -> Laurent {
        let mut sum = Laurent::new();
        for product in &block.terms {
            let others: Vec<_> = product
                .powers
                .iter()
                .copied()
                .filter(|(symbol, _)| *symbol != slide)
                .collect();
            if others.len() < product.powers.len() {
                self.add_product(&mut sum, &product.coefficient, &others);
            }
        }
        sum
    }

    fn add_product(
        &mut self,
        sum: &mut Laurent,
        coefficient: &[NodeId],
        powers: &[(SymbolId, u8)],
    ) {
        let zero = self.algebra.graph.zero();
        let imaginary = coefficient.get(1).copied().unwrap_or(zero);
        let start = (vec![0; self.core.len()], [coefficient[0], imaginary]);
        let mut product = Laurent::from([start]);
        for &(symbol, power) in powers {
            let factor = self.symbol(symbol);
            for _ in 0..power {
                product = self.product(&product, &factor);
            }
        }
        for (exponents, coefficient) in product {
            self.add(sum, exponents, coefficient);
        }
    }

    /// A symbol of the core in complex variables.
    fn symbol(&mut self, symbol: SymbolId) -> Laurent {
        let count = self.core.len();
        let power = |place: usize, exponent: i8| {
            let mut exponents = vec![0; count];
            exponents[place] = exponent;
            exponents
        };
        let graph = &mut self.algebra.graph;
        let (zero, half) = (graph.zero(), graph.constant(0.5));
        let minus_half = graph.constant(-0.5);
        for (place, core) in self.core.iter().enumerate() {
            match *core {
                Core::Angle(angle) => {
                    let angle = &self.algebra.angles[angle];
                    // (u + 1/u)/2 and (u - 1/u)/2i
                    if angle.cos == symbol {
                        return Laurent::from([
                            (power(place, 1), [half, zero]),
                            (power(place, -1), [half, zero]),
                        ]);
                    }
                    if angle.sin == symbol {
                        return Laurent::from([
                            (power(place, 1), [zero, minus_half]),
                            (power(place, -1), [zero, half]),
                        ]);
                    }
                }
                Core::Length {
                    symbol: own,
                    component,
                } if own == symbol => {
                    let graph = &mut self.algebra.graph;
                    let positive = graph.mul(half, self.unit);
                    let negative = graph.neg(positive);
                    // (z + conj z)/2 and (z - conj z)/2i
                    return match component {
                        None => Laurent::from([(power(place, 1), [self.unit, zero])]),
                        Some(0) => Laurent::from([
                            (power(place, 1), [positive, zero]),
                            (power(place + 1, 1), [positive, zero]),
                        ]),
                        Some(_) => Laurent::from([
                            (power(place - 1, 1), [zero, negative]),
                            (power(place, 1), [zero, positive]),
                        ]),
                    };
                }
                Core::Length { .. } => {}
            }
        }
        unreachable!("loops mention unknowns of the core and their own private one")
    }

    fn add(&mut self, sum: &mut Laurent, exponents: Vec<i8>, [re, im]: [NodeId; 2]) {
        let graph = &mut self.algebra.graph;
        let zero = graph.zero();
        let old = sum.entry(exponents).or_insert([zero; 2]);
        *old = [graph.add(old[0], re), graph.add(old[1], im)];
    }

    fn product(&mut self, a: &Laurent, b: &Laurent) -> Laurent {
        let mut sum = Laurent::new();
        for (m, &x) in a {
            for (n, &y) in b {
                let exponents = m.iter().zip(n).map(|(i, j)| i + j).collect();
                let coefficient = self.algebra.complex_product(x, y);
                self.add(&mut sum, exponents, coefficient);
            }
        }
        sum
    }

    fn scaled(&mut self, a: Laurent, factor: NodeId) -> Laurent {
        let graph = &mut self.algebra.graph;
        a.into_iter()
            .map(|(exponents, coefficient)| (exponents, coefficient.map(|x| graph.mul(factor, x))))
            .collect()
    }

    fn conjugate(&mut self, a: &Laurent) -> Laurent {
        let mut result = Laurent::new();
        for (exponents, &[re, im]) in a {
            let mut reflected = exponents.clone();
            for (place, variable) in self.variables.iter().enumerate() {
                match variable {
                    Variable::Unit => reflected[place] = -exponents[place],
                    Variable::Length => {}
                    Variable::Point => reflected[place + 1] = exponents[place],
                    Variable::Conjugate => reflected[place - 1] = exponents[place],
                }
            }
            let minus = self.algebra.graph.neg(im);
            result.insert(reflected, [re, minus]);
        }
        result
    }

    /// Without terms that cancel.
    fn cleaned(&mut self, equation: Laurent) -> Laurent {
        let graph = &mut self.algebra.graph;
        let zero = graph.zero();
        let cleaned = equation.into_iter().map(|(exponents, parts)| {
            let parts = parts.map(|x| if agree(graph, x, zero) { zero } else { x });
            (exponents, parts)
        });
        cleaned
            .filter(|(_, parts)| parts.iter().any(|&x| !graph.is_zero(x)))
            .collect()
    }
}
