//! A quantity with its derivatives, over a range that may close upon itself.

/// A place and the quantity with its derivatives there.
#[derive(Clone, Copy, Debug)]
pub(super) struct Node<const N: usize> {
    /// The input, beyond the range if the curve was followed over the seam.
    pub(super) u: f64,
    pub(super) jet: [f64; N],
}

impl<const N: usize> Node<N> {
    pub(super) fn is_finite(&self) -> bool {
        self.jet.iter().all(|value| value.is_finite())
    }
}

/// Roundoffs of the range's ends: a nearer place is at the seam.
const SEAM: f64 = 8.0;

/// The quantity as a function of the input.
#[derive(Clone, Copy, Debug)]
pub(super) struct Source<const N: usize, F> {
    pub(super) function: F,
    pub(super) low: f64,
    pub(super) high: f64,
    /// The advance of the quantity over the range, if the range is a cycle that repeats itself.
    pub(super) advance: Option<f64>,
}

impl<const N: usize, F: Fn(f64) -> [f64; N]> Source<N, F> {
    pub(super) fn width(&self) -> f64 {
        self.high - self.low
    }

    /// The quantity at an input, which may be a few cycles beyond the range.
    pub(super) fn node(&self, u: f64) -> Node<N> {
        let (mut x, mut shift) = (u, 0.0);
        if let Some(advance) = self.advance {
            while x > self.high {
                x -= self.width();
                shift += advance;
            }
            while x < self.low {
                x += self.width();
                shift -= advance;
            }
        }
        let mut jet = (self.function)(x);
        jet[0] += shift;
        Node { u, jet }
    }

    /// The node a number of cycles later.
    pub(super) fn shifted(&self, node: Node<N>, cycles: f64) -> Node<N> {
        let mut shifted = node;
        shifted.u += cycles * self.width();
        shifted.jet[0] += cycles * self.advance.unwrap_or(0.0);
        shifted
    }

    /// The node within the range. A node at the seam is at the lower end.
    pub(super) fn in_range(&self, node: Node<N>) -> Node<N> {
        if self.advance.is_none() {
            return node;
        }
        let seam = SEAM * f64::EPSILON * self.low.abs().max(self.high.abs());
        let mut node = node;
        while node.u >= self.high - seam {
            node = self.shifted(node, -1.0);
        }
        while node.u < self.low - seam {
            node = self.shifted(node, 1.0);
        }
        node.u = node.u.max(self.low);
        node
    }
}
