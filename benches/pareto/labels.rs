//! Places labels beside points so that they overlap neither each other nor points.

/// Height of a line of text.
pub(crate) const HEIGHT: f64 = 15.0;
/// Half of a marker's size, with some air.
const MARKER: f64 = 8.0;

/// A rectangle, or the frame.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Area {
    pub(crate) left: f64,
    pub(crate) top: f64,
    pub(crate) right: f64,
    pub(crate) bottom: f64,
}

impl Area {
    /// Area that two rectangles share.
    fn overlap(&self, other: &Self) -> f64 {
        let width = self.right.min(other.right) - self.left.max(other.left);
        let height = self.bottom.min(other.bottom) - self.top.max(other.top);
        width.max(0.0) * height.max(0.0)
    }

    fn around([x, y]: [f64; 2], size: f64) -> Self {
        Self {
            left: x - size,
            top: y - size,
            right: x + size,
            bottom: y + size,
        }
    }

    fn grown(&self, by: f64) -> Self {
        Self {
            left: self.left - by,
            top: self.top - by,
            right: self.right + by,
            bottom: self.bottom + by,
        }
    }

    fn size(&self) -> f64 {
        (self.right - self.left) * (self.bottom - self.top)
    }

    /// The point of the rectangle that is nearest to another point.
    pub(crate) fn nearest(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        [
            x.clamp(self.left, self.right),
            y.clamp(self.top, self.bottom),
        ]
    }

    /// How much of a line lies in the rectangle, as a number of samples.
    fn crossed(&self, from: [f64; 2], to: [f64; 2]) -> f64 {
        let at = |part: f64| [0, 1].map(|axis| from[axis] + (to[axis] - from[axis]) * part);
        let inside = |[x, y]: [f64; 2]| {
            (self.left..self.right).contains(&x) && (self.top..self.bottom).contains(&y)
        };
        (0..=20)
            .filter(|&i| inside(at(f64::from(i) / 20.0)))
            .count() as f64
    }
}

/// Rectangles for the labels of the points, each a width of text, inside the frame and apart from the
/// obstacles.
pub(crate) fn place(points: &[([f64; 2], f64)], obstacles: &[Area], frame: &Area) -> Vec<Area> {
    let mut placed: Vec<Option<Area>> = vec![None; points.len()];
    // The first pass sees only the labels before it; later ones improve on it.
    for _ in 0..6 {
        for index in 0..points.len() {
            placed[index] = None;
            let cost = |area: &Area| {
                let covered: f64 = obstacles
                    .iter()
                    .map(|other| area.grown(2.0).overlap(other))
                    .sum();
                // The obstacles are lines: almost nothing of a label's area.
                cost(area, index, points, &placed, frame) + 100.0 * covered
            };
            let (point, width) = points[index];
            placed[index] = candidates(point, width).min_by(|a, b| cost(a).total_cmp(&cost(b)));
        }
    }
    placed.into_iter().flatten().collect()
}

/// Places around a point, near ones first.
fn candidates([x, y]: [f64; 2], width: f64) -> impl Iterator<Item = Area> {
    [4.0, 14.0, 26.0, 40.0, 56.0, 74.0, 94.0, 116.0]
        .into_iter()
        .flat_map(move |distance: f64| {
            (0..24).map(move |step| {
                let (sin, cos) = (f64::from(step) * std::f64::consts::TAU / 24.0).sin_cos();
                let reach = MARKER + distance;
                let centre_x = x + cos * (reach + width / 2.0);
                let centre_y = y + sin * (reach + HEIGHT / 2.0);
                Area {
                    left: centre_x - width / 2.0,
                    right: centre_x + width / 2.0,
                    top: centre_y - HEIGHT / 2.0,
                    bottom: centre_y + HEIGHT / 2.0,
                }
            })
        })
}

fn cost(
    area: &Area,
    index: usize,
    points: &[([f64; 2], f64)],
    placed: &[Option<Area>],
    frame: &Area,
) -> f64 {
    let (point, _) = points[index];
    let outside = area.size() - area.overlap(frame);
    let markers: f64 = points
        .iter()
        .map(|(p, _)| area.overlap(&Area::around(*p, MARKER)))
        .sum();
    let labels: f64 = placed
        .iter()
        .flatten()
        .map(|other| area.overlap(other))
        .sum();
    let end = area.nearest(point);
    let length = f64::hypot(end[0] - point[0], end[1] - point[1]);
    // A leader should not run over labels or points, nor labels lie on leaders.
    let others = points
        .iter()
        .enumerate()
        .filter(|(other, _)| *other != index);
    let mut crossings = 0.0;
    for (other, (p, _)) in others {
        crossings += Area::around(*p, MARKER).crossed(point, end);
        if let Some(label) = &placed[other] {
            crossings += label.crossed(point, end) + area.crossed(*p, label.nearest(*p));
        }
    }
    20.0 * outside + 10.0 * markers + 10.0 * labels + 30.0 * crossings + length
}
