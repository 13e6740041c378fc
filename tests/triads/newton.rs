//! Newton's method and continuation for equations given as a function.

/// Steps of the differences that make the Jacobian.
const STEP: f64 = 1e-4;

/// Unknowns of size about 1, and the equations' values, of size about 1.
pub(crate) type Equations<'a, const N: usize> = &'a dyn Fn(&[f64; N]) -> [f64; N];

/// One step; gives the largest correction and the determinant.
pub(crate) fn step<const N: usize>(equations: Equations<N>, x: &mut [f64; N]) -> (f64, f64) {
    let value = equations(x);
    let mut rows: Vec<Vec<f64>> = value.iter().map(|v| vec![*v]).collect();
    for column in 0..N {
        let at = |h: f64| {
            let mut moved = *x;
            moved[column] += h;
            equations(&moved)
        };
        let [back, front, far_back, far_front] = [-STEP, STEP, -2.0 * STEP, 2.0 * STEP].map(at);
        for (i, row) in rows.iter_mut().enumerate() {
            let near = 8.0 * (front[i] - back[i]);
            row.push((near - (far_front[i] - far_back[i])) / (12.0 * STEP));
        }
    }
    let (correction, determinant) = solve(rows);
    let mut largest = 0.0;
    for (x, c) in x.iter_mut().zip(&correction) {
        *x -= c;
        largest = crate::largest([largest, *c]);
    }
    (largest, determinant)
}

/// Solves rows of right-hand side and coefficients; gives the determinant as well.
fn solve(mut rows: Vec<Vec<f64>>) -> (Vec<f64>, f64) {
    let n = rows.len();
    let mut determinant = 1.0;
    for column in 1..=n {
        let here = column - 1;
        let by_size =
            |a: &usize, b: &usize| rows[*a][column].abs().total_cmp(&rows[*b][column].abs());
        let pivot = (here..n).max_by(by_size).unwrap_or(here);
        if pivot != here {
            rows.swap(pivot, here);
            determinant = -determinant;
        }
        let top = rows[here].clone();
        determinant *= top[column];
        for row in rows.iter_mut().skip(column) {
            let factor = row[column] / top[column];
            row.iter_mut().zip(&top).for_each(|(x, t)| *x -= factor * t);
        }
    }
    let mut result = vec![0.0; n];
    for row in (0..n).rev() {
        let known: f64 = (row + 1..n).map(|k| rows[row][k + 1] * result[k]).sum();
        result[row] = (rows[row][0] - known) / rows[row][row + 1];
    }
    (result, determinant)
}

/// Follows a solution while an input goes from one value to another, as `follow::follow` does.
pub(crate) fn follow<const N: usize>(
    equations: &dyn Fn(f64, &[f64; N]) -> [f64; N],
    start: [f64; N],
    (from, to): (f64, f64),
) -> Result<[f64; N], f64> {
    let (mut at, mut here, mut length) = (from, start, (to - from) / 64.0);
    let mut last = step(&|x| equations(from, x), &mut start.clone()).1;
    while at != to {
        let longest = (last * last).min(0.02);
        length = length.clamp(-longest, longest);
        let next = if (to - at).abs() <= length.abs() {
            to
        } else {
            at + length
        };
        let mut there = here;
        let (mut moved, mut contracts, mut determinant) = (f64::INFINITY, true, 0.0);
        for _ in 0..8 {
            let (now, d) = step(&|x| equations(next, x), &mut there);
            contracts &= now.is_finite() && (now < 0.3 * moved || now < 1e-10);
            (moved, determinant) = (now, d);
            if !contracts || now < 1e-13 {
                break;
            }
        }
        let apart = crate::largest(here.iter().zip(&there).map(|(a, b)| a - b));
        if contracts && apart < 0.1 && (0.6..1.7).contains(&(determinant / last)) {
            (at, here, last) = (next, there, determinant);
            length *= 1.5;
        } else {
            length *= 0.25;
        }
        if length.abs().min(longest) < 1e-8 {
            return Err(at);
        }
    }
    Ok(here)
}
