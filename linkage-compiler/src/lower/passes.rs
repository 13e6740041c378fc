//! The passes of lowering by name, in order: on formulas, on the programs of the whole unit, on the functions.
//!
//! Formulas become programs between the first and the second list ([`schedule`](linkage_symbolic::schedule)).

use linkage_symbolic::count::{Count, chain, time};
use linkage_symbolic::inline::Inliner;
use linkage_symbolic::passes::{PASSES, polished, stages};
use linkage_symbolic::schedule::{draft, schedule_whole};
use linkage_symbolic::{Ex, Graph, NodeId, by_half_angles, roots_last, share_multiples};

use crate::ir::CompiledMechanism;
use crate::observer::PhaseObserver;

use super::plain;

/// The values of a function in a plain graph, after each pass of formulas.
#[derive(Clone, Debug, Default)]
pub(crate) struct Formulas {
    inlined: Vec<NodeId>,
    shared: Vec<NodeId>,
    halved: Vec<NodeId>,
    /// What is scheduled.
    pub(crate) last: Vec<NodeId>,
}

impl Formulas {
    /// `inline`, then `share multiples`, in the inliner's plain graph.
    pub(crate) fn new(inliner: &mut Inliner, scalars: &[Ex]) -> Self {
        let inlined = plain(inliner, scalars);
        let shared = share_multiples(&inliner.target, &inlined);
        Self {
            inlined,
            halved: shared.clone(),
            last: shared.clone(),
            shared,
        }
    }

    /// Then `half angles` and `roots last`, each where that costs no operation.
    pub(crate) fn settled(mut self, graph: &Graph) -> Self {
        let cost = |outputs: &[NodeId]| {
            let program = polished(draft(graph, outputs));
            (time(&program), chain(&program))
        };
        let mut least = None;
        let mut shorter = |old: &[NodeId], new: &[NodeId]| {
            // Most functions have nothing to be changed: then nothing is measured.
            old != new && {
                let before = *least.get_or_insert_with(|| cost(old));
                let after = cost(new);
                least = Some(before.min(after));
                after < before
            }
        };
        if let Some(halved) = by_half_angles(graph, &self.shared)
            && shorter(&self.shared, &halved)
        {
            self.halved = halved;
        }
        self.last.clone_from(&self.halved);
        for last in roots_last(graph, &self.halved) {
            if shorter(&self.last, &last) {
                self.last = last;
            }
        }
        self
    }

    /// Shows them as programs.
    pub(crate) fn show(&self, graph: &Graph, function: usize, watch: &mut dyn PhaseObserver) {
        for (name, nodes) in [
            ("inline", &self.inlined),
            ("share multiples", &self.shared),
            ("half angles", &self.halved),
            ("roots last", &self.last),
        ] {
            watch.pass(name, function, &|| schedule_whole(graph, nodes));
        }
    }
}

/// A step from unit to unit.
struct Pass {
    name: &'static str,
    run: fn(&mut CompiledMechanism),
}

/// What only the bodies of functions are made to: behind the passes of programs.
const OF_FUNCTIONS: [Pass; 2] = [
    // The loops of sweeps run stages.
    Pass {
        name: "split",
        run: |unit| {
            for body in unit.bodies_mut() {
                body.stages = stages::split(&body.program);
            }
        },
    },
    Pass {
        name: "count",
        run: |unit| {
            for body in unit.bodies_mut() {
                body.count = Count::of(&body.program);
                body.compares_sines = body.program.compares_sines();
            }
        },
    },
];

/// Runs all passes on all programs.
pub(crate) fn polish(unit: &mut CompiledMechanism, watch: &mut dyn PhaseObserver) {
    look(unit, "schedule", watch);
    for pass in PASSES {
        for program in unit.programs_mut() {
            *program = (pass.run)(std::mem::take(program));
        }
        look(unit, pass.name, watch);
    }
    for pass in OF_FUNCTIONS {
        (pass.run)(unit);
        look(unit, pass.name, watch);
    }
}

/// Shows the functions, and in debug builds checks all programs.
fn look(unit: &mut CompiledMechanism, name: &'static str, watch: &mut dyn PhaseObserver) {
    if cfg!(debug_assertions) {
        let mistake = unit.programs_mut().find_map(|program| program.mistake());
        assert!(mistake.is_none(), "after {name}: {mistake:?}");
    }
    for (index, function) in unit.functions.iter().enumerate() {
        watch.pass(name, index, &|| function.called.program.clone());
    }
}
