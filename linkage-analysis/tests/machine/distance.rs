//! The distance of points and segments, by another way than the library's: one foot after the other until nothing
//! changes.

pub(crate) fn distance<const K: usize>(first: &[[f64; K]], second: &[[f64; K]]) -> f64 {
    let at = |shape: &[[f64; K]], foot: f64| -> [f64; K] {
        let last = shape.len() - 1;
        std::array::from_fn(|k| shape[0][k] + foot * (shape[last][k] - shape[0][k]))
    };
    // The place of a shape nearest to a point.
    let foot = |shape: &[[f64; K]], to: &[f64; K]| {
        let last = shape.len() - 1;
        let edge: [f64; K] = std::array::from_fn(|k| shape[last][k] - shape[0][k]);
        let along: f64 = (0..K).map(|k| (to[k] - shape[0][k]) * edge[k]).sum();
        let size: f64 = edge.iter().map(|x| x * x).sum();
        if size == 0.0 {
            0.0
        } else {
            (along / size).clamp(0.0, 1.0)
        }
    };
    let mut best = f64::INFINITY;
    // The problem is convex, but slow to converge where edges are nearly parallel: from both ends.
    for start in [0.0, 1.0] {
        let mut s = start;
        let mut length = f64::INFINITY;
        for _ in 0..4000 {
            let p = at(first, s);
            let q = at(second, foot(second, &p));
            s = foot(first, &q);
            let p = at(first, s);
            let next = (0..K)
                .map(|k| (p[k] - q[k]) * (p[k] - q[k]))
                .sum::<f64>()
                .sqrt();
            if next >= length * (1.0 - 1e-12) {
                length = length.min(next);
                break;
            }
            length = next;
        }
        best = best.min(length);
    }
    best
}
