//! Geometries that are hard on purpose.

use crate::{Big, Kind, System};

/// The geometry with every length multiplied by `factor`.
pub fn rescaled(system: &System, geometry: &[f64], factor: f64) -> Vec<f64> {
    let one = |(datum, &x): (&crate::Datum, &f64)| {
        if datum.kind == Kind::Length {
            x * factor
        } else {
            x
        }
    };
    system.data.iter().zip(geometry).map(one).collect()
}

/// The geometry with one number changed so that its gap at the given input is as near to `gap` as
/// `f64` allows.
///
/// The number is searched between its value and `factor` times its value; `None` if the gap is not
/// reached there.
pub fn approach(
    system: &System,
    geometry: &[f64],
    input: f64,
    changed: usize,
    factor: f64,
    gap: f64,
) -> Option<Vec<f64>> {
    let at = |x: f64| {
        let mut data: Vec<Big> = geometry
            .iter()
            .chain([&input])
            .map(|&x| Big::from(x))
            .collect();
        data[changed] = Big::from(x);
        (system.gap_at(&data) - gap).is_negative()
    };
    let (mut above, mut below) = (geometry[changed], geometry[changed] * factor);
    if at(above) || !at(below) {
        return None;
    }
    for _ in 0..70 {
        let middle = above + (below - above) * 0.5;
        if at(middle) {
            below = middle
        } else {
            above = middle
        }
    }
    let mut result = geometry.to_vec();
    result[changed] = above;
    Some(result)
}
