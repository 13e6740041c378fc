//! Vectors that a matrix makes zero.

/// A pivot below this part of the largest entry is zero: entries are differences, exact to some
/// 1e-10.
pub(crate) const ZERO: f64 = 1e-6;

/// The same of the last pivot where a way was followed to a dead point: it ends shortly before it.
pub(crate) const NEARLY_ZERO: f64 = 0.02;

/// Shares of a null vector below this part of the largest one are none.
pub(crate) const LITTLE: f64 = 1e-3;

pub(crate) fn largest(all: &[f64]) -> f64 {
    all.iter().fold(0.0, |most: f64, x| most.max(x.abs()))
}

pub(crate) fn transposed(matrix: &[Vec<f64>]) -> Vec<Vec<f64>> {
    let width = matrix.first().map_or(0, Vec::len);
    let column = |k: usize| matrix.iter().map(|row| row[k]).collect();
    (0..width).map(column).collect()
}

/// The places of a null vector that count.
pub(crate) fn used(vector: &[f64]) -> Vec<usize> {
    let most = largest(vector);
    let used = (0..vector.len()).filter(|&k| vector[k].abs() > LITTLE * most);
    used.collect()
}

/// The null vectors of a matrix with so many columns, one for each column that is free; none if it
/// is regular. The last pivot is zero below `last`, a part of the largest entry.
pub(crate) fn null_vectors(matrix: &[Vec<f64>], width: usize, last: f64) -> Vec<Vec<f64>> {
    let mut rows = matrix.to_vec();
    for row in &mut rows {
        let most = largest(row);
        if most > 0.0 {
            row.iter_mut().for_each(|x| *x /= most);
        }
    }
    let mut free: Vec<usize> = (0..width).collect();
    let mut pivots: Vec<usize> = Vec::new();
    while pivots.len() < rows.len() && !free.is_empty() {
        let done = pivots.len();
        let places =
            (done..rows.len()).flat_map(|row| free.iter().map(move |&column| (row, column)));
        let size = |&(row, column): &(usize, usize)| rows[row][column].abs();
        let Some((row, column)) = places.max_by(|a, b| size(a).total_cmp(&size(b))) else {
            break;
        };
        let pivot = rows[row][column];
        let is_last = free.len() == 1 && done + 1 == width;
        let least = if is_last { last } else { ZERO };
        if pivot.abs() <= least {
            break;
        }
        rows.swap(done, row);
        rows[done].iter_mut().for_each(|x| *x /= pivot);
        let pivot_row = rows[done].clone();
        for (index, other) in rows.iter_mut().enumerate() {
            let factor = other[column];
            if index != done {
                other
                    .iter_mut()
                    .zip(&pivot_row)
                    .for_each(|(x, y)| *x -= factor * y);
            }
        }
        free.retain(|&index| index != column);
        pivots.push(column);
    }
    let vectors = free.iter().map(|&column| {
        let mut vector = vec![0.0; width];
        vector[column] = 1.0;
        for (row, &pivot) in rows.iter().zip(&pivots) {
            vector[pivot] = -row[column];
        }
        vector
    });
    vectors.collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn null_vectors_are_those_of_the_rows() {
        let matrix = [
            vec![1.0, 2.0, 3.0, 4.0],
            vec![2.0, -1.0, 0.5, 1.0],
            vec![3.0, 1.0, 3.5, 5.0],
        ];
        let found = null_vectors(&matrix, 4, ZERO);
        assert_eq!(found.len(), 2);
        for vector in &found {
            for row in &matrix {
                let product: f64 = row.iter().zip(vector).map(|(a, b)| a * b).sum();
                assert!(product.abs() < 1e-14, "{product}");
            }
        }
        let [weights] = &null_vectors(&transposed(&matrix), 3, ZERO)[..] else {
            panic!("the third row is the sum of the others")
        };
        assert!((weights[0] / weights[2] + 1.0).abs() < 1e-14);
        assert!((weights[1] / weights[2] + 1.0).abs() < 1e-14);
        assert!(null_vectors(&[vec![1.0, 2.0], vec![2.0, 1.0]], 2, ZERO).is_empty());
    }
}
