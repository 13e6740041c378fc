//! The polynomial of a degree with the least largest error at given places.
//!
//! The exchange of Remez on a finite set (Remez 1934; Powell: Approximation Theory and Methods,
//! 1981, chapter 8): an error of equal size and changing sign at degree + 2 places is least there;
//! the places move to the extremes of the error until they stay.

/// Exchanges before the best polynomial so far is taken.
const MOST_EXCHANGES: usize = 60;

/// An error that exceeds the levelled one by less than this part is the least one.
const LEVEL: f64 = 1e-9;

/// Returns the coefficients of the polynomial in `x`, that of the lowest power first, and its
/// largest error at the places. `x` increases, and has more entries than the polynomial.
pub(super) fn polynomial(x: &[f64], y: &[f64], degree: usize) -> (Vec<f64>, f64) {
    let (low, high) = (x[0], x[x.len() - 1]);
    let middle = 0.5 * (low + high);
    let half = 0.5 * (high - low);
    let places: Vec<f64> = x.iter().map(|x| (x - middle) / half).collect();
    let mut chosen = chebyshev_places(x.len(), degree + 2);
    let mut best = (Vec::new(), f64::INFINITY);
    for _ in 0..MOST_EXCHANGES {
        let Some((terms, level)) = levelled(&places, y, &chosen) else {
            break;
        };
        let coefficients = powers(&terms, middle, half);
        let pairs = x.iter().zip(y);
        let errors: Vec<f64> = pairs.map(|(x, y)| y - value(&coefficients, *x)).collect();
        let largest = largest(&errors);
        if largest < best.1 {
            best = (coefficients, largest);
        }
        let exchanged = extremes(&errors, degree + 2);
        if largest <= level.abs() * (1.0 + LEVEL) || exchanged == chosen {
            break;
        }
        chosen = exchanged;
    }
    best
}

/// The value of a polynomial.
pub(super) fn value(coefficients: &[f64], x: f64) -> f64 {
    let powers = coefficients.iter().rev();
    powers.fold(0.0, |sum, coefficient| sum * x + coefficient)
}

fn largest(errors: &[f64]) -> f64 {
    errors
        .iter()
        .fold(0.0, |most: f64, error| most.max(error.abs()))
}

/// The extremes of the Chebyshev polynomial, as indices.
fn chebyshev_places(count: usize, chosen: usize) -> Vec<usize> {
    let last = (count - 1) as f64;
    let index = |k: usize| {
        let angle = core::f64::consts::PI * k as f64 / (chosen - 1) as f64;
        (0.5 * (1.0 - angle.cos()) * last).round() as usize
    };
    let mut places: Vec<usize> = (0..chosen).map(index).collect();
    for index in 1..chosen {
        places[index] = places[index].max(places[index - 1] + 1);
    }
    places
}

/// Coefficients of Chebyshev polynomials whose error is equal at the chosen places, with changing
/// signs, and that error.
fn levelled(places: &[f64], y: &[f64], chosen: &[usize]) -> Option<(Vec<f64>, f64)> {
    let size = chosen.len();
    let mut rows: Vec<Vec<f64>> = Vec::with_capacity(size);
    for (number, &index) in chosen.iter().enumerate() {
        let mut row = chebyshev(places[index], size - 1);
        row.push(if number % 2 == 0 { 1.0 } else { -1.0 });
        row.push(y[index]);
        rows.push(row);
    }
    let mut solution = solved(rows)?;
    let level = solution.pop()?;
    Some((solution, level))
}

/// The values of as many Chebyshev polynomials.
fn chebyshev(t: f64, count: usize) -> Vec<f64> {
    let mut values = vec![1.0, t];
    for number in 2..count {
        values.push(2.0 * t * values[number - 1] - values[number - 2]);
    }
    values.truncate(count);
    values
}

/// Solves linear equations with the right side in the last column; `None` if they are singular.
fn solved(mut rows: Vec<Vec<f64>>) -> Option<Vec<f64>> {
    let size = rows.len();
    for column in 0..size {
        let pivot = (column..size).max_by(|i, j| {
            let [a, b] = [*i, *j].map(|row| rows[row][column].abs());
            a.total_cmp(&b)
        })?;
        rows.swap(column, pivot);
        let pivot = rows[column].clone();
        if pivot[column] == 0.0 {
            return None;
        }
        for row in &mut rows[column + 1..] {
            let factor = row[column] / pivot[column];
            for (number, pivot) in row.iter_mut().zip(&pivot) {
                *number -= factor * pivot;
            }
        }
    }
    let mut solution = vec![0.0; size];
    for index in (0..size).rev() {
        let row = &rows[index];
        let known: f64 = (index + 1..size)
            .map(|other| row[other] * solution[other])
            .sum();
        solution[index] = (row[size] - known) / row[index];
    }
    Some(solution)
}

/// Powers of `x` for Chebyshev polynomials of `(x - middle) / half`.
fn powers(terms: &[f64], middle: f64, half: f64) -> Vec<f64> {
    let shifted = |polynomial: &[f64]| {
        let mut product = vec![0.0; polynomial.len() + 1];
        for (power, coefficient) in polynomial.iter().enumerate() {
            product[power + 1] += coefficient / half;
            product[power] -= coefficient * middle / half;
        }
        product
    };
    let mut before = vec![1.0];
    let mut current = shifted(&before);
    let mut sum = vec![0.0; terms.len()];
    for term in terms {
        for (sum, coefficient) in sum.iter_mut().zip(&before) {
            *sum += term * coefficient;
        }
        let mut next: Vec<f64> = shifted(&current).iter().map(|c| 2.0 * c).collect();
        for (next, before) in next.iter_mut().zip(&before) {
            *next -= before;
        }
        before = std::mem::replace(&mut current, next);
    }
    sum
}

/// As many places of extreme errors with changing signs, the largest error among them.
fn extremes(errors: &[f64], count: usize) -> Vec<usize> {
    let mut found: Vec<usize> = Vec::new();
    for (index, error) in errors.iter().enumerate() {
        match found.last().copied() {
            Some(last) if (errors[last] < 0.0) == (*error < 0.0) => {
                if error.abs() > errors[last].abs()
                    && let Some(last) = found.last_mut()
                {
                    *last = index;
                }
            }
            _ => found.push(index),
        }
    }
    while found.len() > count {
        // The smaller end goes; one inside goes together with its smaller neighbour.
        let ends = [found[0], found[found.len() - 1]].map(|index| errors[index].abs());
        if found.len() == count + 1 || found.len() == count + 2 && ends[0] != ends[1] {
            match ends[0] < ends[1] {
                true => drop(found.remove(0)),
                false => drop(found.pop()),
            }
            continue;
        }
        let pair = (0..found.len() - 1).min_by(|i, j| {
            let size = |k: usize| errors[found[k]].abs().max(errors[found[k + 1]].abs());
            size(*i).total_cmp(&size(*j))
        });
        let first = pair.unwrap_or_default();
        found.drain(first..first + 2);
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    fn nodes(low: f64, high: f64) -> Vec<f64> {
        (0..=4096)
            .map(|k| low + (high - low) * f64::from(k) / 4096.0)
            .collect()
    }

    /// The least error for a power by lower ones is that of a Chebyshev polynomial.
    #[test]
    fn a_power_has_the_error_of_chebyshev() {
        for (degree, error) in [(1, 0.5), (2, 0.25), (3, 0.125), (4, 0.0625)] {
            let x = nodes(-1.0, 1.0);
            let y: Vec<f64> = x.iter().map(|x| x.powi(degree as i32 + 1)).collect();
            let (coefficients, found) = polynomial(&x, &y, degree);
            assert!((found - error).abs() < 1e-6, "{degree}: {found}");
            assert_eq!(coefficients.len(), degree + 1);
        }
    }

    /// The error of the best straight line for `exp` on 0..1 (from its formula).
    #[test]
    fn a_line_for_the_exponential() {
        let x = nodes(0.0, 1.0);
        let y: Vec<f64> = x.iter().map(|x| x.exp()).collect();
        let slope = 1.0_f64.exp() - 1.0;
        let error = 0.5 * (slope * slope.ln() - slope + 1.0);
        let (coefficients, found) = polynomial(&x, &y, 1);
        assert!((found - error).abs() < 1e-6 && (coefficients[1] - slope).abs() < 1e-6);
    }

    #[test]
    fn a_polynomial_is_found_again() {
        let x = nodes(-0.3, 2.0);
        let wanted = [0.25, -1.0, 0.5, 2.0, -0.125];
        let y: Vec<f64> = x.iter().map(|x| value(&wanted, *x)).collect();
        let (found, error) = polynomial(&x, &y, 4);
        assert!(error < 1e-14);
        assert!(found.iter().zip(wanted).all(|(a, b)| (a - b).abs() < 1e-12));
    }
}
