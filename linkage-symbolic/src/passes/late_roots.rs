//! Adds terms that wait for a root last, and turns vectors before: the chain after a root is as
//! short as its formulas allow.
//!
//! A vector that turns with a link is `Z (n D + h D_perp)` with a root `h`. The form `n (Z D) + h
//! (Z D)_perp` has as many operations, and all except the last of them are done by the time the
//! root is. The same holds for a sum, `x + (y + h z) = (x + y) + h z`. Both round as often as
//! before.

use crate::expression::rebuild_shared;
use crate::graph::{Binding, Graph, Node, NodeId, NodeNumbers};
use crate::lookup::Map;
use crate::program::{Binary, Ternary, Unary};

/// The values `outputs` with less behind each root: turned before it, then summed before it, too.
pub fn late_roots(graph: &Graph, outputs: &[NodeId]) -> [Vec<NodeId>; 2] {
    let mut view = View::new(graph, outputs);
    let turned = rewritten(&view, outputs, |view, id, new| view.turned_before(id, new));
    if turned != outputs {
        view = View::new(graph, &turned);
    }
    let added = rewritten(&view, &turned, |view, id, new| view.added_before(id, new));
    [turned, added]
}

type Renewed<'a> = &'a dyn Fn(NodeId) -> NodeId;

/// Rewrites nodes that `rewrite` has another form for, which it makes of renewed operands.
fn rewritten(
    view: &View,
    outputs: &[NodeId],
    rewrite: impl Fn(&View, NodeId, Renewed) -> Option<NodeId>,
) -> Vec<NodeId> {
    let graph = view.graph;
    let mut renewed = NodeNumbers::new(graph.len());
    for &id in &view.nodes {
        let new = |x: NodeId| renewed.node(x);
        let node = match rewrite(view, id, &new) {
            Some(node) => node,
            None => rebuild_shared(graph, id, graph.node(id), new),
        };
        renewed.set(id, node.index());
    }
    outputs.iter().map(|output| renewed.node(*output)).collect()
}

/// A product with a sign.
#[derive(Clone, Copy, Debug)]
struct Product {
    negative: bool,
    factors: [NodeId; 2],
}

/// Facts about the nodes below some outputs.
struct View<'a> {
    graph: &'a Graph,
    /// The nodes, operands first.
    nodes: Vec<NodeId>,
    /// The operations on each node; an output is used once more.
    users: Map<NodeId, Vec<NodeId>>,
    /// The number of roots that each node waits for, one after the other.
    roots: NodeNumbers,
    /// Sums of two products, by their factors in order.
    sums: Map<[[NodeId; 2]; 2], NodeId>,
}

impl<'a> View<'a> {
    fn new(graph: &'a Graph, outputs: &[NodeId]) -> Self {
        let mut view = Self {
            graph,
            nodes: graph.reachable(outputs),
            users: Map::new(),
            roots: NodeNumbers::new(graph.len()),
            sums: Map::new(),
        };
        for index in 0..view.nodes.len() {
            let id = view.nodes[index];
            let node = graph.node(id);
            let is_root = matches!(
                node,
                Node::Ternary(Ternary::GuardedSqrt, ..) | Node::Unary(Unary::Sqrt, _)
            );
            let mut before = 0;
            for operand in node.operands() {
                before = before.max(view.waits_for(operand));
                view.users.entry(operand).or_default().push(id);
            }
            view.roots.set(id, before + usize::from(is_root));
            if let Some(sum) = view.two_products(id) {
                view.sums.insert(key(sum.map(|item| item.factors)), id);
            }
        }
        for &output in outputs {
            view.users.entry(output).or_default().push(output);
        }
        view
    }

    fn waits_for(&self, id: NodeId) -> usize {
        self.roots.get(id).unwrap_or(0)
    }

    fn used_once(&self, id: NodeId) -> bool {
        self.users.get(&id).is_some_and(|users| users.len() == 1)
    }

    fn two_products(&self, id: NodeId) -> Option<[Product; 2]> {
        let Node::Binary(op @ (Binary::Add | Binary::Sub), a, b) = self.graph.node(id) else {
            return None;
        };
        let [a, mut b] = [self.product(a)?, self.product(b)?];
        b.negative ^= op == Binary::Sub;
        Some([a, b])
    }

    /// Returns the factors of a product. Signs of a factor that is known before a call count as
    /// those of the product.
    fn product(&self, id: NodeId) -> Option<Product> {
        let Node::Binary(Binary::Mul, a, b) = self.graph.node(id) else {
            return None;
        };
        Some(match self.graph.node(a) {
            Node::Unary(Unary::Neg, a) => Product {
                negative: true,
                factors: [a, b],
            },
            _ => Product {
                negative: false,
                factors: [a, b],
            },
        })
    }

    /// `Z (n D + h D_perp)` by `Z D`, where the vector in brackets is used for nothing else.
    fn turned_before(&self, id: NodeId, new: Renewed) -> Option<NodeId> {
        let outer = self.two_products(id)?;
        outer
            .iter()
            .all(|item| self.is_early(item.factors[0]))
            .then_some(())?;
        let [[p, u], [q, v]] = outer.map(|product| product.factors);
        let inner = self.inner(u, v)?;
        // The other component.
        let partner = *self.sums.get(&key([[q, u], [p, v]]))?;
        let only = |x: NodeId| {
            let users = &self.users[&x];
            users.len() == 2
                && users.iter().all(|&product| {
                    self.used_once(product)
                        && self.users[&product]
                            .iter()
                            .all(|&sum| sum == id || sum == partner)
                })
        };
        if !(only(u) && only(v)) {
            return None;
        }
        let other = self.two_products(partner)?;
        let other = if other[0].factors[1] == u {
            other
        } else {
            [other[1], other[0]]
        };
        let signs = |pair: [Product; 2]| pair.map(|entry| entry.negative);
        let ([s1, s2], [o1, o2]) = (signs(outer), signs(other));
        // A rotation has one sign that differs from the other three, or three.
        if !(s1 ^ s2 ^ o1 ^ o2) {
            return None;
        }
        let Inner {
            a,
            b,
            d1,
            d2,
            u: [u1, u2],
            v: [v1, v2],
        } = inner;
        let [p, q, a, b, d1, d2] = [p, q, a, b, d1, d2].map(new);
        // a (+-p d1 +- q d2) + b (+-p d2 +- q d1)
        let first = self.signed_sum([(s1 ^ u1, p, d1), (s2 ^ v1, q, d2)]);
        let second = self.signed_sum([(s1 ^ u2, p, d2), (s2 ^ v2, q, d1)]);
        Some(
            self.graph
                .add(self.graph.mul(a, first), self.graph.mul(b, second)),
        )
    }

    fn signed_sum(&self, terms: [(bool, NodeId, NodeId); 2]) -> NodeId {
        let [first, second] = terms.map(|(negative, p, x)| {
            let product = self.graph.mul(p, x);
            if negative {
                self.graph.neg(product)
            } else {
                product
            }
        });
        self.graph.add(first, second)
    }

    /// `u = +-a d1 +- b d2` and `v = +-a d2 +- b d1`, a rotation, where `b` waits for one root more
    /// than all else.
    fn inner(&self, u: NodeId, v: NodeId) -> Option<Inner> {
        let [of_u, of_v] = [self.two_products(u)?, self.two_products(v)?];
        let orders = [[0, 1], [1, 0]];
        let flips = [[0, 0], [0, 1], [1, 0], [1, 1]];
        for order in orders {
            for flip in flips {
                let [f, g] = order.map(|k| of_u[k]);
                let [a, d1] = flipped(f.factors, flip[0]);
                let [b, d2] = flipped(g.factors, flip[1]);
                if self.waits_for(b) <= [a, d1, d2].map(|x| self.waits_for(x)).into_iter().max()? {
                    continue;
                }
                let find = |x: NodeId, y: NodeId| {
                    of_v.iter()
                        .find(|entry| key([entry.factors; 2])[0] == key([[x, y]; 2])[0])
                };
                if let (Some(first), Some(second)) = (find(a, d2), find(b, d1))
                    && f.negative ^ g.negative ^ first.negative ^ second.negative
                {
                    return Some(Inner {
                        a,
                        b,
                        d1,
                        d2,
                        u: [f.negative, g.negative],
                        v: [first.negative, second.negative],
                    });
                }
            }
        }
        None
    }

    fn is_early(&self, id: NodeId) -> bool {
        self.graph.binding(id) < Binding::Call
    }

    /// `x + (y + h z)` as `(x + y) + h z`, where only `h` waits for a root.
    fn added_before(&self, id: NodeId, new: Renewed) -> Option<NodeId> {
        let Node::Binary(op @ (Binary::Add | Binary::Sub), a, b) = self.graph.node(id) else {
            return None;
        };
        let subtracted = op == Binary::Sub;
        let cases = [(a, b, false, subtracted), (b, a, subtracted, false)];
        cases
            .into_iter()
            .find_map(|(x, sum, x_negative, sum_negative)| {
                let (y, late, negative) = self.late_term(sum)?;
                (self.waits_for(x) < self.waits_for(late)).then_some(())?;
                let [x, y, late] = [x, y.0, late].map(new);
                let signed =
                    |x: NodeId, negative: bool| if negative { self.graph.neg(x) } else { x };
                let rest = self.graph.add(
                    signed(x, x_negative),
                    signed(y, sum_negative ^ self.late_term(sum)?.0.1),
                );
                Some(self.graph.add(rest, signed(late, sum_negative ^ negative)))
            })
    }

    /// The product that waits for a root in a sum that is used once, and the rest, each with its
    /// sign.
    fn late_term(&self, sum: NodeId) -> Option<((NodeId, bool), NodeId, bool)> {
        let Node::Binary(op @ (Binary::Add | Binary::Sub), a, b) = self.graph.node(sum) else {
            return None;
        };
        let subtracted = op == Binary::Sub;
        let cases = [((a, false), b, subtracted), ((b, subtracted), a, false)];
        let is_late = |(rest, late): (NodeId, NodeId)| {
            matches!(self.graph.node(late), Node::Binary(Binary::Mul, ..))
                && self.waits_for(late) > self.waits_for(rest)
        };
        let found = cases
            .into_iter()
            .find(|&((rest, _), late, _)| is_late((rest, late)));
        found.filter(|_| self.used_once(sum))
    }
}

/// See [`View::inner`]; the signs are those of the products with `a` and with `b`.
struct Inner {
    a: NodeId,
    b: NodeId,
    d1: NodeId,
    d2: NodeId,
    u: [bool; 2],
    v: [bool; 2],
}

fn flipped([x, y]: [NodeId; 2], flip: usize) -> [NodeId; 2] {
    if flip == 0 { [x, y] } else { [y, x] }
}

/// Products in an order that does not depend on how they were written.
fn key(products: [[NodeId; 2]; 2]) -> [[NodeId; 2]; 2] {
    let mut products = products.map(|[x, y]| [x.min(y), x.max(y)]);
    products.sort_unstable();
    products
}
