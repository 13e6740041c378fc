//! Masses as simulators accept them: positive, with positive moments about every axis.

use super::mass::Mass;
use super::skeleton::Skeleton;
use super::space_vectors::{AXES, Rotation};

/// A mass that is missing, as a part of the largest mass; a moment that is missing, as a part of mass
/// times the square of the size.
const SMALL: f64 = 1e-6;

/// The mass of all bodies if none has one, in kilograms, and their moment as a part of mass times
/// the square of the size.
const EACH: f64 = 1.0;
const EACH_MOMENT: f64 = 0.1;

/// The mass of a block between two joints as a part of the largest one. MuJoCo holds a constraint on
/// a lighter body worse: of a ten thousandth, a crank of 20 mm was 3 mm off its slot.
const BLOCK: f64 = 1e-2;

/// The least moment of inertia, far above the 1e-15 that MuJoCo accepts.
const LEAST: f64 = 1e-12;

/// The masses of all bodies, and remarks on those that are completed.
pub(super) struct Inertials {
    pub(super) masses: Vec<Mass>,
    pub(super) remarks: Vec<String>,
}

impl Inertials {
    /// Names the bodies whose moments about two axes are those about the third.
    pub(super) fn completed(&self, skeleton: &Skeleton) -> Option<String> {
        let links = skeleton.links.iter();
        let names = links.filter(|link| link.mass.is_completed);
        let names: Vec<&str> = names.map(|link| link.name.as_str()).collect();
        let all = names.join(", ");
        (!names.is_empty()).then(|| {
            format!(
                "moments of inertia about one axis are declared for {all}: the others are equal"
            )
        })
    }
}

/// Completes the masses of bodies.
pub(super) fn inertials(skeleton: &Skeleton) -> Inertials {
    let links = &skeleton.links;
    let most = links
        .iter()
        .fold(0.0, |most: f64, link| most.max(link.mass.mass));
    let size = skeleton.size();
    if most <= 0.0 {
        return equal(links.len(), size);
    }
    let small = SMALL * most;
    let mut masses = Vec::new();
    let mut remarks = Vec::new();
    for link in links {
        let mut mass = link.mass;
        let mut missing: Vec<String> = Vec::new();
        if mass.mass <= 0.0 {
            mass.mass = small;
            missing.push(format!("no mass: {small:.3e} kg are written"));
        }
        if !is_positive(&mass.inertia) {
            let moment = (SMALL * mass.mass * size * size).max(LEAST);
            for (index, row) in mass.inertia.iter_mut().enumerate() {
                row[index] += moment;
            }
            missing.push(format!(
                "no moment of inertia about every axis: {moment:.3e} kg m^2 are added"
            ));
        }
        let all = missing.into_iter();
        remarks.extend(all.map(|missing| format!("`{}` has {missing}", link.name)));
        masses.push(mass);
    }
    Inertials { masses, remarks }
}

/// Equal masses for bodies that have none.
fn equal(count: usize, size: f64) -> Inertials {
    let moment = (EACH_MOMENT * EACH * size * size).max(LEAST);
    let mass = Mass {
        mass: EACH,
        inertia: AXES.map(|axis| axis.map(|component| moment * component)),
        ..Mass::default()
    };
    let remark =
        format!("no body has a mass: {EACH} kg and {moment:.3e} kg m^2 are written for each");
    Inertials {
        masses: vec![mass; count],
        remarks: vec![remark],
    }
}

/// The small mass of a block that only joins two joints.
pub(super) fn block_mass(inertials: &Inertials, size: f64) -> (f64, f64) {
    let masses = inertials.masses.iter();
    let most = masses.fold(0.0, |most: f64, mass| most.max(mass.mass));
    let mass = BLOCK * most;
    (mass, (BLOCK * mass * size * size).max(LEAST))
}

/// True if the matrix is positive definite, by its leading minors.
fn is_positive(m: &Rotation) -> bool {
    let second = m[0][0] * m[1][1] - m[0][1] * m[1][0];
    let cofactor = |k: usize| {
        let [i, j] = [(k + 1) % 3, (k + 2) % 3];
        m[0][k] * (m[1][i] * m[2][j] - m[1][j] * m[2][i])
    };
    let third: f64 = (0..AXES.len()).map(cofactor).sum();
    let scale = m[0][0].abs().max(m[1][1].abs()).max(m[2][2].abs());
    let rounding = 1e-9 * scale;
    m[0][0] > rounding && second > rounding * scale && third > rounding * scale * scale
}
