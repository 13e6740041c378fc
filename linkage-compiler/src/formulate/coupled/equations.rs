//! The equations of a core: one across each private unknown, and the rows of loops without one.

use linkage_symbolic::program::Unary;
use linkage_symbolic::{NodeId, SymbolId};

use crate::algebra::CoreRow;
use crate::formulate::Solver;
use crate::formulate::vector::Vector;
use crate::structure::{Core, Coupled, Private};

/// The equations of the core, in the symbols of the core alone, and all that is made of them.
pub(super) struct Equations {
    pub(super) reach: NodeId,
    pub(super) scale: NodeId,
    /// 1 over the scale.
    pub(super) unit: NodeId,
    pub(super) residuals: Vec<NodeId>,
    pub(super) rows: Vec<CoreRow>,
    pub(super) matrix: Vec<Vec<NodeId>>,
}

impl Solver<'_, '_> {
    pub(super) fn core_equations(&mut self, form: &Coupled, variables: &[SymbolId]) -> Equations {
        let reach = self.reach(form);
        let graph = &mut self.algebra.graph;
        let scale = graph.unary(Unary::InverseScale, reach);
        let one = graph.one();
        let unit = graph.div(one, scale);
        let column_scales: Vec<NodeId> = form
            .core
            .iter()
            .map(|core| match core {
                Core::Angle(_) => scale,
                Core::Length { .. } => one,
            })
            .collect();
        let units: Vec<NodeId> = form
            .core
            .iter()
            .map(|core| match core {
                Core::Angle(_) => one,
                Core::Length { .. } => unit,
            })
            .collect();
        let mut equations = Equations {
            reach,
            scale,
            unit,
            residuals: Vec::new(),
            rows: Vec::new(),
            matrix: Vec::new(),
        };
        let mut first = 0;
        for block in &form.blocks {
            match (&block.private, &block.rest[..]) {
                (Some(private), &[x, y]) => {
                    self.across_private(
                        &mut equations,
                        private,
                        [x, y],
                        first,
                        (variables, &column_scales),
                    );
                }
                _ => {
                    for (row, &node) in block.rows.iter().enumerate() {
                        // Vector loops and distances are lengths; what a scalar loop is, nobody knows.
                        let (factor, scales): (NodeId, Vec<NodeId>) = match block.is_length() {
                            true => (scale, column_scales.clone()),
                            false => (one, units.clone()),
                        };
                        let residual = self.algebra.graph.mul(factor, node);
                        let entries = variables.iter().zip(&scales).map(|(&variable, &scale)| {
                            let slope = self.algebra.partial(node, variable);
                            self.algebra.graph.mul(scale, slope)
                        });
                        let entries = entries.collect();
                        equations.residuals.push(residual);
                        equations.matrix.push(entries);
                        equations.rows.push(CoreRow {
                            first: first + row,
                            factors: vec![factor],
                        });
                    }
                }
            }
            first += block.rows.len();
        }
        equations
    }

    /// The equation of a loop across its private unknown.
    fn across_private(
        &mut self,
        equations: &mut Equations,
        private: &Private,
        rest: Vector,
        first: usize,
        (variables, column_scales): (&[SymbolId], &[NodeId]),
    ) {
        let scale = equations.scale;
        let slopes: Vec<Vector> = variables
            .iter()
            .map(|&variable| rest.map(|x| self.algebra.partial(x, variable)))
            .collect();
        let (multiplier, residual, entries): (Vector, NodeId, Vec<NodeId>) = match private {
            Private::Rotor(rotor) => {
                let link = self.negative(rest);
                let link = link.map(|x| self.algebra.graph.mul(scale, x));
                let length = self.algebra.length(&rotor.z);
                let graph = &mut self.algebra.graph;
                let length = graph.mul(scale, length);
                let wanted = graph.square(length);
                let square = self.square(link);
                let miss = self.algebra.graph.sub(wanted, square);
                let residual = self.half(miss);
                let entries = slopes.iter().zip(column_scales).map(|(slope, &scale)| {
                    let slope = slope.map(|x| self.algebra.graph.mul(scale, x));
                    self.algebra.dot(&link, &slope)
                });
                let entries = entries.collect();
                (link, residual, entries)
            }
            Private::Slide { guide, .. } => {
                let scaled = rest.map(|x| self.algebra.graph.mul(scale, x));
                let residual = self.algebra.cross(*guide, scaled);
                let entries = variables.iter().zip(&slopes).zip(column_scales);
                let entries = entries.map(|((&variable, slope), &scale)| {
                    let slope = slope.map(|x| self.algebra.graph.mul(scale, x));
                    let turning = guide.map(|x| self.algebra.partial(x, variable));
                    let moved = self.algebra.cross(*guide, slope);
                    let rest = rest.map(|x| self.algebra.graph.mul(scale, x));
                    let turned = self.algebra.cross(turning, rest);
                    self.algebra.graph.add(moved, turned)
                });
                let entries = entries.collect();
                (self.perp(*guide), residual, entries)
            }
        };
        let factors = multiplier.map(|x| self.algebra.graph.mul(scale, x));
        equations.residuals.push(residual);
        equations.matrix.push(entries);
        equations.rows.push(CoreRow {
            first,
            factors: factors.to_vec(),
        });
    }

    /// The sum of the lengths of the links that do not depend on inputs. A power of two near its inverse scales the equations.
    fn reach(&mut self, form: &Coupled) -> NodeId {
        let mut vectors: Vec<Vec<NodeId>> = Vec::new();
        for block in form.blocks.iter().filter(|block| block.rows.len() > 1) {
            for product in &block.terms {
                let turns = |symbol| self.algebra.angles.iter().any(|a| a.cos == symbol);
                let fixed = |x: &NodeId| self.algebra.is_fixed(*x);
                if let [(symbol, 1)] = product.powers[..]
                    && turns(symbol)
                    && product.coefficient.iter().all(fixed)
                {
                    vectors.push(product.coefficient.clone());
                }
            }
        }
        let distances = form.blocks.iter().filter_map(|block| block.distance);
        let distances = distances.filter(|length| self.algebra.is_fixed(*length));
        vectors.extend(distances.map(|length| vec![length]));
        let zero = self.algebra.graph.zero();
        vectors.iter().fold(zero, |sum, vector| {
            let length = self.algebra.length(vector);
            self.algebra.graph.add(sum, length)
        })
    }
}
