//! The assembly of the declared dimensions, for languages that do not assemble at run time.

use linkage_compiler::ir::{CompiledMechanism, Generated};
use linkage_core::Scalar;
use linkage_core::numeric::winding::{Centre, follow, uniform};
use linkage_symbolic::interpret::run_by;
use linkage_symbolic::program::{Program, Source};

/// A mechanism without coupled groups, assembled at its reference inputs in the modes that the
/// estimates choose. The arithmetic is that of generated Rust without fused multiply-adds.
#[derive(Clone, Debug, PartialEq)]
pub struct DeclaredAssembly {
    /// The dimensions of the declaration.
    pub dimensions: Vec<f64>,
    /// The assembly modes, 1 or -1.
    pub modes: Vec<f64>,
    /// The guide of each continuous angle at inputs of 0, radians.
    pub centres: Vec<f64>,
    /// For each continuous angle, the turns that it makes for a turn of each input.
    pub windings: Vec<Vec<f64>>,
    /// The prepared slots.
    pub prepared: Vec<f64>,
}

impl DeclaredAssembly {
    /// Assembles a mechanism. The error is the index of the angle, among the continuous ones, whose
    /// revolutions are not found.
    pub fn new(unit: &CompiledMechanism) -> Result<Self, usize> {
        let sign = |plus| if plus { 1.0 } else { -1.0 };
        let mut assembly = Self {
            dimensions: unit.scalars().map(|scalar| scalar.nominal).collect(),
            modes: unit.modes().into_iter().map(sign).collect(),
            centres: unit.angles.iter().map(|angle| angle.estimate).collect(),
            windings: vec![vec![0.0; unit.inputs.len()]; unit.angles.len()],
            prepared: Vec::new(),
        };
        assembly.prepared = assembly.run(&unit.prepare, &[]);
        let vectors = assembly.run(&unit.bearings, &[]);
        let mut vectors = vectors.as_chunks::<2>().0;
        for (index, angle) in unit.angles.iter().enumerate() {
            let (phases, others) = vectors.split_at(angle.phases.len());
            vectors = others;
            let (centre, windings) = assembly.wound(unit, index, phases).ok_or(index)?;
            assembly.centres[index] = centre;
            assembly.windings[index] = windings;
            assembly.prepared = assembly.run(&unit.prepare, &[]);
        }
        Ok(assembly)
    }

    /// Runs a program at these inputs.
    fn run(&self, program: &Program, inputs: &[f64]) -> Vec<f64> {
        run_by::<Generated<f64, false>>(program, |source| match source {
            Source::Parameter(index) => self.dimensions[index],
            Source::Input(index) => inputs[index],
            Source::Mode(index) => self.modes[index],
            Source::Centre(angle) => self.centres[angle],
            Source::Winding(angle, input) => self.windings[angle][input],
            Source::Prepared(slot) => self.prepared[slot],
            Source::State(..) | Source::Limit | Source::Carried(_) => {
                unreachable!("there is no coupled group, and whole programs carry nothing")
            }
        })
    }

    /// Returns the centre and the windings of an angle, from the vectors of its phases where all
    /// inputs are 0.
    fn wound(
        &self,
        unit: &CompiledMechanism,
        index: usize,
        vectors: &[[f64; 2]],
    ) -> Option<(f64, Vec<f64>)> {
        let at: Vec<f64> = unit.inputs.iter().map(|input| input.reference).collect();
        let angle = &unit.angles[index];
        let direction = |inputs: &[f64]| {
            let all = self.run(&unit.directions, inputs);
            [all[2 * index], all[2 * index + 1]]
        };
        let [cosine, sine] = direction(&at);
        let here = f64::angle_near_with::<false>(sine, cosine, angle.estimate);
        if !here.is_finite() {
            return None;
        }
        let turns = angle.phases.iter().map(|phase| phase.turns.clone());
        let turns: Vec<Option<Vec<f64>>> = turns.collect();
        if let Some(found) = uniform(vectors, &turns, &at, here) {
            return Some(found);
        }
        let mut windings = vec![0.0; at.len()];
        let mut centre = Centre::new(here);
        for &input in &angle.inputs {
            let x = at[input];
            let (low, high) = unit.inputs[input].followed;
            let (low, high) = (low.min(x), high.max(x));
            if low == high {
                continue;
            }
            let along = follow(low, high, x, here, &unit.inputs[input].rates, |x| {
                let mut inputs = at.clone();
                inputs[input] = x;
                direction(&inputs)
            })?;
            windings[input] = along.turns;
            centre.add(along, x);
        }
        Some((centre.value(), windings))
    }
}
