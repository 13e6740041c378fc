//! Assemblies that are followed from position to position.

use linkage_compiler::ir::Generated;
use linkage_runtime::NotFollowed;
use linkage_runtime::support::{Corrected, Dispatch, Standing, Stop, follow};
use linkage_symbolic::interpret::run_by;

use crate::compiled::{Assembly, numbers};
use crate::mechanism::Mechanism;
use crate::operations::called;

/// An assembly at some inputs: it is followed from there to others, whatever the ranges of the
/// inputs, and has all functions there.
///
/// The macro has one for mechanisms with a coupled group over several inputs. Here every assembly
/// has one. Without a coupled group it goes anywhere, and functions are NaN where nothing closes.
/// A copy remembers a position.
///
/// ```
/// use linkage_engine::Mechanism;
///
/// let text = "
///     pub struct Crank { unit mm; param r = 30mm; input phi = 0deg; let pin = polar(r, phi); }
///     impl Crank { pub fn motion(phi) -> Motion { pin } }";
/// let mechanism = Mechanism::compile(text)?;
/// let assembly = mechanism.assemble(&mechanism.dimensions())?;
/// let mut follower = assembly.follower(&[0.0])?;
/// follower.follow(&[1.0])?;
/// assert_eq!(follower.inputs(), [1.0]);
/// assert_eq!(follower.call(0, &[1.0]), assembly.call(0, &[1.0]));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct Follower<'a> {
    assembly: &'a Assembly<'a>,
    /// The inputs, then the state of each coupled group with its floor.
    position: Vec<f64>,
}

impl<'a> Follower<'a> {
    /// A follower at these inputs.
    pub(crate) fn new(assembly: &'a Assembly<'a>, inputs: &[f64]) -> Result<Self, NotFollowed> {
        let count = assembly.mechanism().inputs().len();
        assert_eq!(inputs.len(), count, "its inputs");
        let states = assembly.states(inputs).by_build();
        let position = inputs.iter().copied().chain(states.into_iter().flatten());
        let mut follower = Self {
            assembly,
            position: position.collect(),
        };
        follower.follow(inputs)?;
        Ok(follower)
    }

    /// Goes straight to other inputs, in steps that are certain to stay on the assembly: a single one
    /// if the way is short.
    ///
    /// # Errors
    ///
    /// Where no step leads any further, as at a dead point; the follower stays where it was.
    ///
    /// # Panics
    ///
    /// If there is another number of inputs.
    pub fn follow(&mut self, inputs: &[f64]) -> Result<(), NotFollowed> {
        let mechanism = self.assembly.mechanism();
        assert_eq!(inputs.len(), mechanism.inputs().len(), "its inputs");
        let standing = standing(mechanism);
        let path = FollowerPath {
            follower: self,
            to: inputs,
            standing: &standing,
        };
        match mechanism.multiply_adds.by_machine(&path) {
            Ok(position) => {
                self.position = position;
                Ok(())
            }
            Err(stop) => {
                let group = standing[stop.number].group;
                let structure = &mechanism.structure().groups[group];
                let name = mechanism.name();
                Err(NotFollowed::new(
                    name, group, structure, stop.share, stop.why,
                ))
            }
        }
    }

    /// Returns the assembly that is followed.
    #[must_use]
    pub fn assembly(&self) -> &'a Assembly<'a> {
        self.assembly
    }

    /// Returns the inputs of its position.
    #[must_use]
    pub fn inputs(&self) -> &[f64] {
        &self.position[..self.assembly.mechanism().inputs().len()]
    }

    /// Returns the results of a function at the position, by its number. Of the arguments, which are
    /// all those of the function, inputs are ignored.
    ///
    /// # Panics
    ///
    /// If there is no such function or it takes another number of arguments.
    #[must_use]
    pub fn call(&self, function: usize, arguments: &[f64]) -> Vec<f64> {
        let mechanism = self.assembly.mechanism();
        let function = &mechanism.compiled.functions[function];
        assert_eq!(arguments.len(), function.arguments.len(), "its arguments");
        let mut inputs = self.inputs().to_vec();
        let count = inputs.len();
        inputs.resize(count + mechanism.compiled.arguments.len(), f64::NAN);
        for (&index, x) in function.arguments.iter().zip(arguments) {
            if index >= count {
                inputs[index] = *x;
            }
        }
        let states = split(mechanism, &self.position);
        let body = function.settled.as_ref().unwrap_or(&function.called);
        let numbers = numbers(self.assembly.core(), &inputs, &states);
        called(mechanism.multiply_adds, body, |source| numbers.load(source))
    }
}

/// The coupled groups with the places of their states.
fn standing(mechanism: &Mechanism) -> Vec<Standing> {
    let mut first = mechanism.inputs().len();
    let groups = mechanism.compiled.coupled.iter().map(|coupled| {
        let standing = Standing {
            group: coupled.group,
            first,
            size: coupled.size,
        };
        first += coupled.size + 1;
        standing
    });
    groups.collect()
}

/// The state of each coupled group, with its floor.
fn split(mechanism: &Mechanism, position: &[f64]) -> Vec<Vec<f64>> {
    let groups = standing(mechanism).into_iter();
    let states = groups.map(|Standing { first, size, .. }| position[first..=first + size].to_vec());
    states.collect()
}

/// The path from the position of a follower to other inputs.
struct FollowerPath<'w, 'a> {
    follower: &'w Follower<'a>,
    to: &'w [f64],
    standing: &'w [Standing],
}

impl Dispatch<f64, Result<Vec<f64>, Stop>, 0> for FollowerPath<'_, '_> {
    #[inline(always)]
    fn at<const FUSED: bool>(&self, []: [f64; 0]) -> Result<Vec<f64>, Stop> {
        let assembly = self.follower.assembly;
        let mechanism = assembly.mechanism();
        follow(
            &self.follower.position,
            self.to,
            self.standing,
            |number, x: &mut Vec<f64>| {
                let states = split(mechanism, x);
                let inputs = &x[..self.to.len()];
                let numbers = numbers(assembly.core(), inputs, &states);
                let program = &mechanism.compiled.coupled[number].correct;
                let outputs =
                    run_by::<Generated<f64, FUSED>>(program, |source| numbers.load(source));
                let Standing { first, size, .. } = self.standing[number];
                x[first..first + size].copy_from_slice(&outputs[..size]);
                Corrected {
                    size2: outputs[size],
                    determinant: outputs[size + 1],
                }
            },
        )
    }
}
