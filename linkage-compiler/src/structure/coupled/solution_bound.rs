//! Bounds on the number of complex solutions of a coupled group whose assemblies are not listed.

use std::fmt;

use linkage_symbolic::SymbolId;

use crate::algebra::Names;
use crate::model::{Expr, ExprKind, Function, Mechanism, Name, unknown_frames};
use crate::structure::coupled::group::{Block, Core, Coupled};
use crate::structure::form::Form;
use crate::structure::group::Group;

/// Places of a body in space by six distances of its points from known ones: F. Ronga, T. Vust,
/// "Stewart platforms without computer?", 1992; D. Lazard, "Stewart platforms and Groebner basis",
/// 1992; and M. Raghavan, "The Stewart platform of general geometry has 40 configurations", 1993.
/// Known coordinates of a point are distances from centres infinitely far off, which leaves no more
/// isolated solutions.
const OF_A_BODY: u64 = 40;

/// A bound on the number of complex solutions.
pub(crate) enum SolutionBound {
    /// One body on six distances.
    BodyOnDistances,
    /// Bezout's number for directions and lengths apart.
    ByDegrees(u64),
}

impl fmt::Display for SolutionBound {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::BodyOnDistances => write!(
                f,
                "up to {OF_A_BODY} complex solutions (a body on six distances)"
            ),
            // Too many to count, or none that is isolated.
            Self::ByDegrees(0 | u64::MAX) => f.write_str("complex solutions"),
            Self::ByDegrees(number) => write!(f, "up to {number} complex solutions (by degrees)"),
        }
    }
}

impl SolutionBound {
    /// Returns a bound on the number of isolated complex solutions of a coupled group.
    pub(crate) fn of_group(names: &Names, group: &Group) -> Self {
        let by_degrees = match &group.form {
            Form::Coupled(coupled) => coupled.bezout(names),
            _ => u64::MAX,
        };
        if is_body_on_distances(names.mechanism, group) && OF_A_BODY < by_degrees {
            Self::BodyOnDistances
        } else {
            Self::ByDegrees(by_degrees)
        }
    }
}

/// True if a group finds the position of one body of space, by distances of its points from known
/// ones. Coordinates of its origin may be known.
fn is_body_on_distances(mechanism: &Mechanism, group: &Group) -> bool {
    let bodies = unknown_frames::bodies_of_space(mechanism);
    let mut bodies = bodies.iter().map(|(_, parts)| parts);
    let Some(parts) =
        bodies.find(|parts| group.unknowns.iter().all(|unknown| parts.contains(unknown)))
    else {
        return false;
    };
    let all = (0..mechanism.loops.len())
        .filter(|&index| !unknown_frames::is_loop_of_frame(mechanism, index));
    let mut about = all.filter(|&index| {
        let equation = &mechanism.loops[index];
        mechanism.mentions(&equation.left, parts) || mechanism.mentions(&equation.right, parts)
    });
    about.all(|index| {
        let equation = &mechanism.loops[index];
        let [left, right] = [&equation.left, &equation.right];
        let known = |side| !mechanism.mentions(side, parts);
        let holds = |side| {
            if group.loops.contains(&index) {
                is_distance(mechanism, side, parts)
            } else {
                is_coordinate_of_origin(mechanism, side, parts)
            }
        };
        (holds(left) && known(right)) || (holds(right) && known(left))
    })
}

/// `distance(point_in(body, v), q)` of a body that consists of these unknowns.
fn is_distance(mechanism: &Mechanism, side: &Expr, parts: &[usize]) -> bool {
    let ExprKind::Call(Function::Distance, points) = &definition_of(mechanism, side).kind else {
        return false;
    };
    let [a, b] = &points[..] else { return false };
    let on_body = |point: &Expr| match &definition_of(mechanism, point).kind {
        ExprKind::Call(Function::PointIn, arguments) => {
            is_body(mechanism, &arguments[0], parts) && !mechanism.mentions(&arguments[1], parts)
        }
        ExprKind::Index(frame, 0) => is_body(mechanism, frame, parts),
        _ => false,
    };
    let known = |point: &Expr| !mechanism.mentions(point, parts);
    (on_body(a) && known(b)) || (on_body(b) && known(a))
}

/// `body.origin.z`
fn is_coordinate_of_origin(mechanism: &Mechanism, side: &Expr, parts: &[usize]) -> bool {
    let ExprKind::Component(point, _) = &definition_of(mechanism, side).kind else {
        return false;
    };
    matches!(&definition_of(mechanism, point).kind, ExprKind::Index(frame, 0) if is_body(mechanism, frame, parts))
}

/// True if this is the frame that consists of these unknowns.
fn is_body(mechanism: &Mechanism, frame: &Expr, parts: &[usize]) -> bool {
    let ExprKind::Call(Function::Frame, axes) = &definition_of(mechanism, frame).kind else {
        return false;
    };
    let axes = axes.iter().filter_map(Expr::as_name);
    let unknowns =
        axes.filter(|name| matches!(name, Name::Unknown(index) if parts.contains(index)));
    unknowns.count() == parts.len()
}

/// Returns the definition of a name.
fn definition_of<'e>(mechanism: &'e Mechanism, expr: &'e Expr) -> &'e Expr {
    match expr.kind {
        ExprKind::Name(Name::Let(index)) => definition_of(mechanism, &mechanism.lets[index].value),
        _ => expr,
    }
}

impl Coupled<'_> {
    /// Bezout's number where all lengths are of one kind and every angle is of its own: the
    /// coefficient, in the product of all equations' degrees as sums, of the product of all
    /// unknowns (A. Morgan, A. Sommese, "A homotopy for solving general polynomial systems that
    /// respects m-homogeneous structures", 1987). An angle counts twice: a polynomial in its cosine
    /// and sine is one of twice the degree in the unit vector.
    fn bezout(&self, names: &Names) -> u64 {
        let angles: Vec<usize> = (0..self.core.len())
            .filter(|&k| matches!(self.core[k], Core::Angle(_)))
            .collect();
        let lengths = self.core.len() - angles.len();
        let degrees = self.degrees(names, &angles);
        if degrees.len() != self.core.len() {
            return u64::MAX;
        }
        // Ways of taking one factor of each equation so far such that the angles of a set occur;
        // all others are lengths.
        let sets = 1_usize << angles.len();
        let mut ways = vec![0_u64; sets];
        ways[0] = 1;
        for (done, (of_lengths, of_angles)) in degrees.iter().enumerate() {
            let mut next = vec![0_u64; sets];
            for (set, &number) in ways.iter().enumerate().filter(|(_, way)| **way > 0) {
                let mut add = |set: usize, degree: u64| {
                    next[set] = next[set].saturating_add(number.saturating_mul(degree));
                };
                if done - (set.count_ones() as usize) < lengths {
                    add(set, *of_lengths);
                }
                for (k, degree) in of_angles.iter().enumerate() {
                    if set & (1 << k) == 0 {
                        add(set | (1 << k), *degree);
                    }
                }
            }
            ways = next;
        }
        ways[sets - 1]
    }

    /// The degree of each equation in all lengths, and in each angle's unit vector.
    fn degrees(&self, names: &Names, angles: &[usize]) -> Vec<(u64, Vec<u64>)> {
        let lengths = self.core.iter().filter_map(|unknown| match unknown {
            Core::Length { symbol, .. } => Some(*symbol),
            Core::Angle(_) => None,
        });
        let lengths: Vec<SymbolId> = lengths.collect();
        let units = angles.iter().map(|&k| match self.core[k] {
            Core::Angle(angle) => names.angles[angle].symbols().to_vec(),
            Core::Length { .. } => Vec::new(),
        });
        let units: Vec<Vec<SymbolId>> = units.collect();
        let all = self.blocks.iter().flat_map(|block| {
            let (count, factor) = match block.private {
                // The square of a vector, or its product with the guide.
                Some(_) => (1, 2),
                None => (block.rows.len(), 1),
            };
            let of_lengths = factor * degree(block, &lengths);
            let of_units = units.iter().map(|unit| 2 * factor * degree(block, unit));
            std::iter::repeat_n((of_lengths, of_units.collect()), count)
        });
        all.collect()
    }
}

/// The degree of a loop's polynomials in some symbols.
fn degree(block: &Block, symbols: &[SymbolId]) -> u64 {
    let all = block.terms.iter().map(|term| {
        let powers = term
            .powers
            .iter()
            .filter(|(symbol, _)| symbols.contains(symbol));
        powers.map(|(_, power)| u64::from(*power)).sum()
    });
    all.max().unwrap_or(0)
}
