//! Values that the loops' closed forms have already: arms that are links of a loop, and
//! determinants that are those of a loop, with their reciprocals. Loops may be written in any form,
//! so numbers find the matches, with other dimensions and in other assemblies, too.

use linkage_symbolic::{Ex, Vn};

use crate::algebra::{Algebra, Nominal, cofactors};
use crate::forces::loop_values::{Arms, Determinants};
use crate::forces::multibody::Multibody;
use crate::forces::positions::Positions;
use crate::forces::system::System;
use crate::model::Mechanism;

/// Numbers that differ by a smaller share of the largest are equal: far above rounding, far below
/// the effect of altered dimensions.
pub(super) const EQUAL: f64 = 1e-9;

/// Finds the arms from the joints of bodies to others that are links.
pub(super) fn link_arms<'m>(
    algebra: &Algebra<'m>,
    bodies: &Multibody<'m>,
    positions: &Positions,
    nominal: &Nominal,
) -> Arms<'m> {
    let mut found_arms = Arms::default();
    let groups = algebra.solutions.groups.iter();
    let links = groups.flat_map(|group| group.links.iter().flatten());
    let links: Vec<Vn> = links.map(|link| link.vector.into()).collect();
    let ends: Vec<(usize, Vn)> = ends_of_arms(algebra.mechanism, bodies);
    if links.is_empty() || ends.is_empty() || !bodies.geometry.is_plane() {
        return found_arms;
    }
    let arms = ends.iter().map(|&(body, point)| bodies.arm(body, point));
    let expressions: Vec<Ex> = arms
        .chain(links.iter().copied())
        .flat_map(|v| v.iter())
        .collect();
    let numbers = positions.numbers_anyhow(algebra.mechanism, nominal, &expressions);
    for (index, &(body, point)) in ends.iter().enumerate() {
        let found = links.iter().enumerate().find_map(|(link, &vector)| {
            let other = ends.len() + link;
            let signs = [0, 1].map(|k| sign(&numbers, 2 * index + k, 2 * other + k));
            let [Some(sign), Some(same)] = signs else {
                return None;
            };
            (sign == same).then_some(if sign < 0.0 { -vector } else { vector })
        });
        if let Some(arm) = found {
            let key = (body, point.ids().to_vec());
            found_arms.insert(key, arm);
        }
    }
    found_arms
}

/// The bodies with points that arms from their own joints lead to.
pub(super) fn ends_of_arms<'m>(
    mechanism: &Mechanism,
    bodies: &Multibody<'m>,
) -> Vec<(usize, Vn<'m>)> {
    let (tree, geometry) = (&bodies.tree, &bodies.geometry);
    let cut = tree.closing.iter().flat_map(|&joint| {
        let declared = &mechanism.joints[joint];
        let both = [Some(declared.body), declared.on].into_iter().flatten();
        both.map(move |body| (body, geometry.points[joint]))
    });
    let children = tree
        .children
        .iter()
        .enumerate()
        .flat_map(|(body, children)| {
            children
                .iter()
                .map(move |&child| (body, geometry.origins[child]))
        });
    let ends = cut.chain(children);
    ends.filter(|&(body, point)| !bodies.arm(body, point).is_zero())
        .collect()
}

/// Finds the blocks of equations whose determinants are those of loops.
pub(super) fn loop_determinants<'m>(
    algebra: &Algebra<'m>,
    system: &System<'m>,
    positions: &Positions,
    nominal: &Nominal,
) -> Determinants<'m> {
    let mut found_determinants = Determinants::default();
    let groups = algebra.solutions.groups.iter();
    let known: Vec<Ex> = groups.map(|group| group.determinant).collect();
    let blocks = system.blocks.iter().filter(|block| block.len() == 2);
    let blocks: Vec<&Vec<usize>> = blocks.collect();
    if known.is_empty() || blocks.is_empty() {
        return found_determinants;
    }
    let determinants = blocks
        .iter()
        .map(|block| cofactors::determinant(algebra.graph, &system.matrix_of(block)));
    let expressions: Vec<Ex> = determinants.chain(known.iter().copied()).collect();
    let numbers = positions.numbers_anyhow(algebra.mechanism, nominal, &expressions);
    for (index, block) in blocks.iter().enumerate() {
        let found = known.iter().enumerate().find_map(|(group, &determinant)| {
            let sign = sign(&numbers, index, blocks.len() + group)?;
            Some(if sign < 0.0 {
                -determinant
            } else {
                determinant
            })
        });
        if let Some(determinant) = found {
            found_determinants.insert((*block).clone(), determinant);
        }
    }
    found_determinants
}

/// True if two numbers are equal at all positions, or opposite: 1 or -1.
pub(super) fn sign(numbers: &[Vec<f64>], a: usize, b: usize) -> Option<f64> {
    let largest = numbers
        .iter()
        .map(|values| values[b].abs())
        .fold(0.0, f64::max);
    let is = |sign: f64| {
        let mut positions = numbers.iter();
        positions.all(|values| (values[a] - sign * values[b]).abs() <= EQUAL * largest)
    };
    [1.0, -1.0]
        .into_iter()
        .find(|&sign| numbers.len() > 1 && largest > 0.0 && is(sign))
}

#[cfg(test)]
mod tests {
    use linkage_symbolic::interpret::run;
    use linkage_symbolic::program::{Program, Source};

    use crate::check;
    use crate::ir::CompiledMechanism;

    /// Two dyads side by side on one crank, the second one with a coupler of its own length.
    fn two_dyads(coupler: f64) -> CompiledMechanism {
        let dyad = |k: usize| {
            format!(
                "unknown t{k} = 20deg; unknown p{k} = 70deg; let e{k} = k + polar(b{k}, t{k});
                 loop e{k} = (100mm, 0mm) + polar(c{k}, p{k});
                 body coupler{k} = pin in{k} on wheel at k, turns t{k}, mass 1kg at k + polar(40mm, t{k});
                 body rocker{k} = pin on{k} on frame at (100mm, 0mm), turns p{k}, mass 2kg at (100mm, 0mm) + polar(30mm, p{k});
                 pin end{k} = coupler{k} on rocker{k} at e{k};"
            )
        };
        let text = format!(
            "pub struct M {{
                unit mm; param a = 30mm; param b1 = 80mm; param c1 = 60mm; param b2 = {coupler}mm; param c2 = 60mm;
                gravity = (0m/s^2, -10m/s^2);
                input phi = 60deg in 50deg..70deg at omega;
                let k = polar(a, phi);
                body wheel = pin hub on frame at (0mm, 0mm), turns phi;
                {} {}
            }}
            impl M {{ pub fn f(phi, omega) -> F {{ r: reaction(end1), s: reaction(end2), t: torque(phi) }} }}",
            dyad(1),
            dyad(2),
        );
        let checked = check(text.parse().expect("tokens"));
        let texts: Vec<&String> = checked
            .messages
            .iter()
            .map(|message| &message.text)
            .collect();
        checked.unit.unwrap_or_else(|| panic!("{texts:?}"))
    }

    /// The results with the second coupler of a length.
    fn results(unit: &CompiledMechanism, coupler: f64) -> Vec<f64> {
        let values = |program: &Program, prepared: &[f64]| {
            run(program, |source| match source {
                Source::Parameter(3) => coupler,
                Source::Parameter(k) => unit
                    .scalars()
                    .nth(k)
                    .map_or(f64::NAN, |scalar| scalar.nominal),
                Source::Input(k) => [1.0, 7.0][k],
                Source::Mode(k) => {
                    if unit.modes()[k] {
                        1.0
                    } else {
                        -1.0
                    }
                }
                Source::Prepared(slot) => prepared[slot],
                _ => f64::NAN,
            })
        };
        let prepared = values(&unit.prepare, &[]);
        values(&unit.functions[0].called.program, &prepared)
    }

    #[test]
    fn dyads_that_are_equal_by_chance_have_determinants_of_their_own() {
        let [equal, apart] = [80.0, 85.0].map(two_dyads);
        let pairs = results(&equal, 85.0).into_iter().zip(results(&apart, 85.0));
        for (found, expected) in pairs {
            assert!(
                (found - expected).abs() < 1e-9 * expected.abs(),
                "{found} {expected}"
            );
        }
    }

    #[test]
    fn a_dyad_has_one_division_for_its_determinant() {
        let count = two_dyads(85.0).functions[0].called.count;
        // Of the points, and of the determinants, for each dyad.
        assert_eq!(count.div, 4);
    }
}
