//! Files of other programs: their facts, their refusals, and their motion against a solver.

mod facts;
mod files;
mod items;
mod linkage;
mod motion;
mod mutations;
mod newton;
mod page;
mod pmks;
mod readers;
mod refusals;
mod speeds;

#[path = "../shared/memory.rs"]
mod memory;
#[path = "../shared/survival.rs"]
mod survival;
