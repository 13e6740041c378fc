//! Options of both formats: the mechanism, the input, its range, the largest errors.

use std::path::PathBuf;

use clap::Args;
use linkage_compiler::shortened;
use linkage_engine::{Mechanism, Source};
use linkage_runtime::Input;

use super::coupling::Allowed;
use super::driven_joints::RunningName;
use super::skeleton::Skeleton;
use crate::command::choose::Chosen;
use crate::command::values::{Dimensions, number};
use crate::failure::{Failure, listed};
use crate::normal::normal;

/// The default of the largest error of an angle in URDF.
const ERROR: f64 = 1e-4;

/// Options that both formats have.
#[derive(Debug, Args)]
pub(super) struct Common {
    #[command(flatten)]
    pub(super) chosen: Chosen,
    #[command(flatten)]
    pub(super) dimensions: Dimensions,
    /// The input that drives the robot; the first one by default
    #[arg(long, value_name = "INPUT", value_parser = normal)]
    pub(super) over: Option<String>,
    /// Another input, which is held, as `psi=40deg`; by default at its reference
    #[arg(long = "at", value_name = "NAME=VALUE", value_parser = normal)]
    pub(super) at: Vec<String>,
    /// The range of the driving input, as `20deg..80deg`; by default the declared one
    #[arg(long, value_name = "LOW..HIGH", value_parser = normal, allow_hyphen_values = true)]
    pub(super) range: Option<String>,
    /// The joint that the others follow; by default the first that moves as the input does
    #[arg(long, value_name = "JOINT", value_parser = normal)]
    pub(super) drive: Option<String>,
    /// A file instead of the standard output
    #[arg(short, long, value_name = "FILE")]
    pub(super) output: Option<PathBuf>,
}

impl Common {
    /// Returns true if no option chooses an input or a joint that drives alone.
    pub(super) fn moves_all_inputs(&self) -> bool {
        self.over.is_none() && self.at.is_empty() && self.range.is_none() && self.drive.is_none()
    }

    /// The name of the mechanism that is meant.
    pub(super) fn only(&self, source: &Source) -> Result<&'static str, Failure> {
        let all = self.chosen.all_of(source)?;
        match &all[..] {
            [only] => Ok(only.name()),
            several => Err(Failure::Told(format!(
                "there are the mechanisms {} in `{}`: choose one by `--mechanism NAME`",
                listed(several.iter().map(|mechanism| mechanism.name())),
                self.chosen.file().display()
            ))),
        }
    }

    /// The ends of the range of the input, which contains the reference.
    pub(super) fn range(
        &self,
        mechanism: &Mechanism,
        input: &Input,
        reference: f64,
    ) -> Result<[f64; 2], Failure> {
        let [low, high] = match &self.range {
            None => {
                let (low, high) = input.ends();
                [low, high]
            }
            Some(range) => {
                let Some((low, high)) = range.split_once("..") else {
                    return Err(Failure::Told(format!(
                        "`--range {}`: write `--range LOW..HIGH`",
                        shortened(range)
                    )));
                };
                let value = |text: &str| number(mechanism, input.name, text.trim(), input.unit);
                [value(low)?, value(high)?]
            }
        };
        match low <= reference && reference <= high && low < high {
            true => Ok([low, high]),
            false => {
                let named = RunningName {
                    name: input.name,
                    unit: input.unit,
                };
                Err(Failure::Told(format!(
                    "the range from {} to {} does not contain the reference `{} = {}`, at which all joints of the robot are zero",
                    named.written(low),
                    named.written(high),
                    input.name,
                    named.written(reference)
                )))
            }
        }
    }
}

/// The largest errors of angles and lengths.
pub(super) fn allowed(
    mechanism: &Mechanism,
    errors: &[String],
    skeleton: &Skeleton,
) -> Result<Allowed, Failure> {
    let length = mechanism.compiled().length;
    let mut angle = None;
    let mut distance = None;
    for text in errors {
        let value = number(mechanism, "error", text, "rad");
        match value {
            Ok(value) => angle = Some(value),
            Err(_) => distance = Some(number(mechanism, "error", text, length)?),
        }
    }
    let positive = |value: f64| match value > 0.0 {
        true => Ok(value),
        false => Err(Failure::Told(
            "`--error` is positive: the largest error of a joint".to_owned(),
        )),
    };
    let angle_found = positive(angle.unwrap_or(ERROR))?;
    // The arc of the error at the size of the mechanism.
    let length_found = match distance {
        Some(distance) => skeleton.metres().length(positive(distance)?),
        None => angle_found * skeleton.size(),
    };
    Ok(Allowed {
        angle: angle_found,
        length: length_found,
    })
}
