//! The slots that a sweep over mechanisms prepares for its rows: those that its function uses.

use std::collections::BTreeSet;

use linkage_symbolic::passes::stages::Stage;
use linkage_symbolic::program::Program;

use super::body::{self, Runs};
use super::compiled;
use super::load::{Places, loader};
use super::outline::Outline;

/// The largest number of slots not used by a function that its sweeps compute and leave to the
/// optimiser. With more of them, as in a machine of many parts, the function has a separate
/// program for the slots that it uses: the length of the code printed for a function does not grow
/// with the machine.
const OTHERS: usize = 64;

/// The slots of one function, in order.
pub(super) struct Slots {
    used: Vec<usize>,
    /// Prepares them alone; `None` where that of all slots does it.
    program: Option<Program>,
}

impl Slots {
    /// Those that stages load; `prepare` is the program of all.
    pub(super) fn for_stages(stages: &[Stage], prepare: &Program) -> Self {
        let used = stages
            .iter()
            .flat_map(|stage| stage.program.prepared_slots());
        let used: Vec<usize> = used.collect::<BTreeSet<usize>>().into_iter().collect();
        let others = prepare.outputs.len() - used.len();
        let program = (others > OTHERS).then(|| prepare.part(used.iter().copied()));
        Self { used, program }
    }

    /// The numbers of the slots.
    pub(super) fn numbers(&self) -> &[usize] {
        &self.used
    }

    /// Statements that put them into `__slots`, for its dimensions `__m`, by `__modes` and
    /// `__turns`; `None` where the program of all slots does it.
    pub(super) fn prepare(&self, outline: &Outline) -> Option<String> {
        let program = self.program.as_ref()?;
        let places = Places::all(outline);
        let statements = body::statements(program, Runs::Once, &loader(outline, &places));
        let puts = compiled::put(program, self.used.iter().copied());
        Some(statements + &puts)
    }
}
