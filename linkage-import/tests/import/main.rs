//! Files of other programs: their facts, their refusals, and their motion against a solver.

mod facts;
mod files;
mod motion;
mod mutations;
mod newton;
mod page;
mod readers;
mod refusals;
