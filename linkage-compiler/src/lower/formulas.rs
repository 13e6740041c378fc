//! The results of a function in a plain graph, and the passes that rewrite them before they are
//! scheduled.

use linkage_symbolic::count::{chain, time};
use linkage_symbolic::inline::Inliner;
use linkage_symbolic::passes::polished;
use linkage_symbolic::schedule::{draft, schedule_whole};
use linkage_symbolic::{Ex, Graph, NodeId, by_half_angles, late_roots, share_common_factors};

use crate::observer::PhaseObserver;

use super::plain::plain;

/// The values of a function in a plain graph, after each pass of formulas.
#[derive(Clone, Debug, Default)]
pub(crate) struct Formulas {
    inlined: Vec<NodeId>,
    shared: Vec<NodeId>,
    halved: Vec<NodeId>,
    /// The nodes that are scheduled.
    pub(crate) last: Vec<NodeId>,
}

impl Formulas {
    /// `inline`, then `share multiples`, in the inliner's plain graph.
    pub(crate) fn new(inliner: &mut Inliner, scalars: &[Ex]) -> Self {
        let inlined = plain(inliner, scalars);
        let shared = share_common_factors(&inliner.target, &inlined);
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
        for last in late_roots(graph, &self.halved) {
            if shorter(&self.last, &last) {
                self.last = last;
            }
        }
        self
    }

    /// Returns the estimated time of a call. Work of `assemble()` is free.
    pub(crate) fn time(&self, graph: &Graph) -> u32 {
        time(&polished(draft(graph, &self.last)))
    }

    /// Shows them as programs.
    pub(super) fn show(&self, graph: &Graph, function: usize, watch: &mut dyn PhaseObserver) {
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
