//! Coordinates of a vector at several positions.

use linkage_symbolic::Vn;

/// Vectors at several places or of several motions.
pub(super) type Track = Vec<Vec<f64>>;

/// The parts that belong to vectors of lists of all their components.
pub(super) fn divided(tracks: &Track, vectors: &[Vn]) -> Vec<Track> {
    let mut start = 0;
    let part = vectors.iter().map(|vector| {
        let range = start..start + vector.len();
        start = range.end;
        tracks
            .iter()
            .map(|list| list[range.clone()].to_vec())
            .collect()
    });
    part.collect()
}

pub(super) fn difference(a: &[Vec<f64>], b: &[Vec<f64>]) -> Track {
    let rows = a.iter().zip(b);
    rows.map(|(a, b)| a.iter().zip(b).map(|(x, y)| x - y).collect())
        .collect()
}
