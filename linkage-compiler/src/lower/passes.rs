//! The passes on programs by name, in order: on all programs, then on those of functions.

use linkage_symbolic::count::Count;
use linkage_symbolic::passes::{PASSES, stages};

use crate::ir::CompiledMechanism;
use crate::observer::PhaseObserver;

/// A step from unit to unit.
struct Pass {
    name: &'static str,
    run: fn(&mut CompiledMechanism),
}

/// The passes of function bodies alone, which run after the passes of programs.
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
                body.count = Count::of_program(&body.program);
                body.compares_sines = body.program.compares_sines();
            }
        },
    },
];

/// Runs all passes on all programs.
pub(crate) fn polish(unit: &mut CompiledMechanism, watch: &mut dyn PhaseObserver) {
    show_programs(unit, "schedule", watch);
    for pass in PASSES {
        for program in unit.programs_mut() {
            *program = (pass.run)(std::mem::take(program));
        }
        show_programs(unit, pass.name, watch);
    }
    for pass in OF_FUNCTIONS {
        (pass.run)(unit);
        show_programs(unit, pass.name, watch);
    }
}

/// Shows the functions, and in debug builds checks all programs.
fn show_programs(unit: &mut CompiledMechanism, name: &'static str, watch: &mut dyn PhaseObserver) {
    if cfg!(debug_assertions) {
        let mistake = unit.programs_mut().find_map(|program| program.mistake());
        assert!(mistake.is_none(), "after {name}: {mistake:?}");
    }
    for (index, function) in unit.functions.iter().enumerate() {
        watch.pass(name, index, &|| function.called.program.clone());
    }
}
