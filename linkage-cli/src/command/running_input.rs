//! The input that runs from one position to the next, and the constant ones: options that several
//! commands have.

use clap::Args;
use linkage_engine::Mechanism;
use linkage_runtime::Input;

use super::sweep::{Positions, all_arguments, positions, running, still};
use crate::failure::Failure;
use crate::normal::normal;

/// Options for the arguments of a function.
#[derive(Debug, Args)]
pub(super) struct RunningInput {
    /// First value of the input, with its unit; the lower end of its range by default
    #[arg(long, value_name = "VALUE", allow_hyphen_values = true)]
    from: Option<String>,
    /// Last value of the input
    #[arg(long, value_name = "VALUE", allow_hyphen_values = true)]
    to: Option<String>,
    /// The input that runs from one position to the next; the first one of the function by default
    #[arg(long, value_name = "INPUT", value_parser = normal)]
    over: Option<String>,
    /// Another argument of the function, as `omega=20rad/s`; by default inputs have their reference
    /// and loads the value of their declaration
    #[arg(long = "at", value_name = "NAME=VALUE", value_parser = normal)]
    at: Vec<String>,
}

/// The arguments of a function over a course.
pub(super) struct Along {
    /// All of them, as far as they stand still.
    pub(super) given: Vec<f64>,
    /// The place and the input that runs; `None` for a function without inputs.
    pub(super) running: Option<(usize, &'static Input)>,
    /// The positions that it runs through.
    pub(super) positions: Positions,
}

impl RunningInput {
    /// The arguments of a function over as many positions.
    pub(super) fn resolve(
        &self,
        mechanism: &Mechanism,
        function: usize,
        steps: u32,
    ) -> Result<Along, Failure> {
        let running = running(mechanism, function, self.over.as_deref())?;
        let given = all_arguments(mechanism, function, &self.at)?;
        let positions = match running {
            Some((_, input)) => {
                still(input, &self.at)?;
                let ends = [self.from.as_deref(), self.to.as_deref()];
                positions(mechanism, input, ends, steps)?
            }
            None => Positions::none(),
        };
        Ok(Along {
            given,
            running,
            positions,
        })
    }
}
