//! The simple system with known solutions at which the paths start: each equation is a product of
//! polynomials in one variable each, with the degrees of the given equation.

use super::polynomial::Polynomial;
use super::system::{HIGHEST_DEGREE, MOST_PATHS, MOST_VARIABLES, Unlisted};
use crate::numeric::complex::{Complex, ONE, ZERO};
use crate::numeric::complex_matrix::Vector;
use alloc::vec::Vec;

/// A polynomial in one variable, given by its roots.
#[derive(Clone, Copy)]
pub(super) struct Univariate {
    pub(super) degree: u8,
    pub(super) roots: [Complex; HIGHEST_DEGREE],
    /// The coefficients from the constant up; the highest is 1.
    pub(super) coefficients: [Complex; HIGHEST_DEGREE + 1],
}

/// Number of paths: the permanent of the matrix of degrees, which is the number of ways of taking
/// one factor of each equation such that every variable occurs once.
pub(super) fn count(target: &[Polynomial]) -> Result<usize, Unlisted> {
    let most = MOST_PATHS as u64;
    let variables = target.len();
    // ways[set]: for the first equations, as many as the set has variables.
    let mut ways = [0_u64; 1 << MOST_VARIABLES];
    ways[0] = 1;
    for set in 1_usize..1 << variables {
        let degrees = &target[set.count_ones() as usize - 1].degrees;
        for (j, &degree) in degrees.iter().enumerate() {
            if set & (1 << j) != 0 {
                let others = ways[set & !(1 << j)];
                ways[set] = ways[set].saturating_add(others.saturating_mul(degree.into()));
            }
        }
    }
    match ways[(1 << variables) - 1] {
        0 => Err(Unlisted::Degenerate),
        paths if paths <= most => Ok(paths as usize),
        paths => Err(Unlisted::TooManyPaths { paths, most }),
    }
}

/// Unit numbers spread over the circle: the multiples of an angle that is no fraction of a turn.
struct Phases {
    next: Complex,
    step: Complex,
}

impl Phases {
    /// Half the golden angle: numbers and their negatives together are spread well too.
    const STEP: Complex = Complex::new(-0.362_374_890_080_480_1, 0.932_032_423_813_227_6);

    fn new(seed: usize) -> Self {
        // One radian.
        const SEED: Complex = Complex::new(0.540_302_305_868_139_8, 0.841_470_984_807_896_5);
        Self {
            next: (0..=seed).fold(ONE, |product, _| product * SEED),
            step: Self::STEP,
        }
    }

    fn take(&mut self) -> Complex {
        let phase = self.next;
        self.next = phase * self.step;
        phase
    }
}

/// One factor for every equation and variable; other ones at every attempt.
pub(super) fn factors<const N: usize>(
    target: &[Polynomial],
    attempt: usize,
) -> [[Univariate; N]; N] {
    let mut factors = [[Univariate::ONE; N]; N];
    for j in 0..N {
        let mut phases = Phases::new(attempt * N + j);
        for (row, polynomial) in factors.iter_mut().zip(target) {
            row[j] = Univariate::new(polynomial.degrees[j], &mut phases);
        }
    }
    factors
}

/// The constant factor of every equation of the start system.
pub(super) fn constants<const N: usize>(attempt: usize) -> Vector<N> {
    let mut phases = Phases::new(13 + 3 * attempt);
    core::array::from_fn(|_| phases.take().scaled(0.35))
}

impl Univariate {
    const ONE: Self = {
        let mut coefficients = [ZERO; HIGHEST_DEGREE + 1];
        coefficients[0] = ONE;
        Self {
            degree: 0,
            roots: [ZERO; HIGHEST_DEGREE],
            coefficients,
        }
    };

    /// With pairs of opposite roots on the unit circle.
    fn new(degree: u8, phases: &mut Phases) -> Self {
        let mut polynomial = Self::ONE;
        while polynomial.degree < degree {
            let root = phases.take();
            polynomial.multiply(root);
            if polynomial.degree < degree {
                polynomial.multiply(-root);
            }
        }
        polynomial
    }

    fn multiply(&mut self, root: Complex) {
        let degree = self.degree as usize;
        for k in (0..=degree).rev() {
            self.coefficients[k + 1] += self.coefficients[k];
            self.coefficients[k] = -(root * self.coefficients[k]);
        }
        self.roots[degree] = root;
        self.degree += 1;
    }
}

/// All solutions of the start system.
pub(super) fn solutions<const N: usize>(factors: &[[Univariate; N]; N]) -> Vec<Vector<N>> {
    let mut found = Vec::new();
    choose(factors, 0, &mut [None; N], &mut found);
    found
}

fn choose<const N: usize>(
    factors: &[[Univariate; N]; N],
    equation: usize,
    chosen: &mut [Option<Complex>; N],
    found: &mut Vec<Vector<N>>,
) {
    if equation == N {
        found.push(chosen.map(|root| root.unwrap_or(ONE)));
        return;
    }
    for j in 0..N {
        if chosen[j].is_some() {
            continue;
        }
        let factor = &factors[equation][j];
        for &root in &factor.roots[..factor.degree as usize] {
            chosen[j] = Some(root);
            choose(factors, equation + 1, chosen, found);
        }
        chosen[j] = None;
    }
}
