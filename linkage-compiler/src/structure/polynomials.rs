//! Equations as polynomials in the symbols of their coordinates.

use linkage_symbolic::{
    Ex, Graph, Polynomial, SymbolId, V2, V3, Vector, collect, numerically_equal,
    numerically_equal_within,
};

use crate::algebra::names::Names;
use crate::structure::elements::Rotor;
use crate::structure::equations;
use crate::structure::equations::{Coordinate, CoordinateKind};

/// Coefficients below this share of the others are rounding.
const NEGLIGIBLE: f64 = 1e-14;

/// The equations of a group as polynomials in the symbols of its coordinates.
#[derive(Clone, Debug)]
pub(crate) struct Polynomials<'m> {
    pub(crate) rows: Vec<Polynomial<'m>>,
    symbols: Vec<SymbolId>,
}

impl<'m> Polynomials<'m> {
    pub(crate) fn monomial(&self, symbols: &[SymbolId]) -> Vec<u8> {
        let mut exponents = vec![0; self.symbols.len()];
        for symbol in symbols {
            if let Some(index) = self.symbols.iter().position(|s| s == symbol) {
                exponents[index] += 1;
            }
        }
        exponents
    }

    /// Removes and returns the coefficients of a product of symbols, one for each row; 0 where
    /// there is none.
    pub(crate) fn take(&mut self, symbols: &[SymbolId], zero: Ex<'m>) -> Vec<Ex<'m>> {
        let monomial = self.monomial(symbols);
        self.rows
            .iter_mut()
            .map(|row| row.remove(&monomial).unwrap_or(zero))
            .collect()
    }

    pub(crate) fn take_pair(&mut self, symbols: &[SymbolId], zero: Ex<'m>) -> V2<'m> {
        let pair = self.take(symbols, zero);
        Vector([pair[0], pair[1]])
    }

    pub(crate) fn take_space(&mut self, symbols: &[SymbolId], zero: Ex<'m>) -> V3<'m> {
        let taken = self.take(symbols, zero);
        Vector([taken[0], taken[1], taken[2]])
    }

    /// True if a term contains the symbol at `index`.
    pub(crate) fn mention(&self, index: usize) -> bool {
        let mut monomials = self.rows.iter().flat_map(|row| row.keys());
        monomials.any(|monomial| monomial[index] > 0)
    }

    /// A monomial as powers of symbols.
    pub(crate) fn powers(&self, monomial: &[u8]) -> Vec<(SymbolId, u8)> {
        let all = self.symbols.iter().copied().zip(monomial.iter().copied());
        all.filter(|&(_, power)| power > 0).collect()
    }

    /// Returns the factors of a symbol, one for each row, if all rows are linear in it.
    pub(crate) fn slope(&self, graph: &'m Graph, index: usize) -> Option<Vec<Ex<'m>>> {
        let factor = |row: &Polynomial<'m>| {
            let mut sum = graph.number(0.0);
            for (monomial, &coefficient) in row {
                match monomial[index] {
                    0 => continue,
                    1 => {}
                    _ => return None,
                }
                let mut others = monomial.clone();
                others[index] = 0;
                sum += coefficient * self.product(graph, &others);
            }
            Some(sum)
        };
        self.rows.iter().map(factor).collect()
    }

    /// Returns the rows as expressions.
    pub(crate) fn expressions(&self, graph: &'m Graph) -> Vec<Ex<'m>> {
        let sum = |row: &Polynomial<'m>| {
            let terms = row.iter();
            let terms = terms.map(|(monomial, &x)| x * self.product(graph, monomial));
            let sum = terms.reduce(|sum, term| sum + term);
            sum.unwrap_or(graph.number(0.0))
        };
        self.rows.iter().map(sum).collect()
    }

    fn product(&self, graph: &'m Graph, monomial: &[u8]) -> Ex<'m> {
        let mut product = graph.number(1.0);
        for (symbol, power) in self.powers(monomial) {
            for _ in 0..power {
                product = product * graph.ex(graph.symbol_node(symbol));
            }
        }
        product
    }

    /// True if every term has been taken.
    pub(crate) fn is_exhausted(&self) -> bool {
        self.rows.iter().all(Polynomial::is_empty)
    }
}

/// The rows of an equation as polynomials in coordinates; `None` if they are none (a square root,
/// an angle's value).
pub(crate) fn polynomials<'m>(
    names: &Names<'m>,
    rows: &[Ex<'m>],
    coordinates: &[Coordinate],
) -> Option<Polynomials<'m>> {
    let mut symbols = Vec::new();
    let mut unit_pairs = Vec::new();
    for coordinate in coordinates {
        if let CoordinateKind::Angle(_) = coordinate.kind {
            unit_pairs.push((symbols.len(), symbols.len() + 1));
        }
        symbols.extend(equations::symbols(names, coordinate));
    }
    let rows = rows
        .iter()
        .map(|&row| collect(row, &symbols, &unit_pairs))
        .collect::<Option<Vec<Polynomial>>>()?;
    Some(Polynomials { rows, symbols })
}

/// Removes terms in a direction whose coefficients are 0 in a spelling that constructors do not
/// see, or by rounding.
pub(crate) fn drop_cancelled<'m>(graph: &'m Graph, polynomials: &mut Polynomials<'m>) {
    let zero = graph.number(0.0);
    for row in &mut polynomials.rows {
        let squares = row.values().map(|coefficient| coefficient.square());
        let size = squares.fold(zero, |sum, square| sum + square).sqrt();
        row.retain(|_, coefficient| {
            let with = size + *coefficient;
            !numerically_equal(*coefficient, zero)
                && !numerically_equal_within(with, size, NEGLIGIBLE)
        });
    }
}

/// The terms with an angle's unit vector (times `with`), if they are a vector turning with it.
pub(crate) fn take_rotor<'m>(
    names: &Names<'m>,
    polynomials: &mut Polynomials<'m>,
    index: usize,
    with: &[SymbolId],
) -> Option<Rotor<'m>> {
    let angle = &names.angles[index];
    let (cos, sin) = (angle.cos, angle.sin);
    let zero = names.zero();
    let along = polynomials.take_pair(&[&[cos], with].concat(), zero);
    let across = polynomials.take_pair(&[&[sin], with].concat(), zero);
    let perp = along.perp();
    let back = Vector([along[1], -along[0]]);
    let equal = |v: V2<'m>| (0..2).all(|k| numerically_equal(across[k], v[k]));
    let sense = match () {
        () if equal(perp) => 1.0,
        () if equal(back) => -1.0,
        () => return None,
    };
    Some(Rotor {
        angle: index,
        sense,
        z: along,
    })
}

/// The place of a coordinate's first symbol among the symbols of polynomials.
pub(crate) fn first_symbol(names: &Names<'_>, coordinates: &[Coordinate], index: usize) -> usize {
    let before = coordinates[..index].iter();
    before.map(|c| equations::symbols(names, c).len()).sum()
}
