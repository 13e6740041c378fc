//! All mechanisms of the folder `mechanisms`, of the golden files and of the corpus as the macro compiles them, to be compared with the command `linkage`.

use std::path::Path;

use linkage::{AssemblyMode, Frame, Input, Vector2, Vector3};
use linkage_compiler::check;
use linkage_engine::{Mechanism, Source};
use linkage_random::Random;

/// A mechanism that the macro compiled.
pub struct Subject {
    /// What messages call it.
    pub name: &'static str,
    /// The file that it stands in.
    pub path: &'static str,
    /// Its number in that file.
    pub number: usize,
    /// Assembles it with these dimensions.
    pub assembled: fn(&[f64]) -> Assembled,
    /// Assembles the second dimensions in the assembly of the first.
    pub assembled_from: fn(&[f64], &[f64]) -> Assembled,
    /// Which functions have their sweeps here.
    pub is_swept: &'static [bool],
    /// The rows of a sweep of an assembly with these dimensions; `None` for a function without sweeps, or without them here.
    pub swept: fn(&[f64], usize, &[&[f64]]) -> Rows,
    /// The same for many mechanisms.
    pub swept_sets: SweptSets,
    /// The modes of all assemblies at the reference.
    pub listed: fn() -> Vec<Vec<AssemblyMode>>,
    /// Its circuits, printed.
    pub circuits: fn() -> Option<String>,
    /// Its structure, printed.
    pub structure: fn() -> String,
}

/// The functions of an assembled mechanism, or the message of the error.
pub type Assembled = Result<Box<Call>, String>;

/// The rows of a function for many mechanisms, given dimensions of an assembly, the number of the function, dimensions and arguments.
pub type SweptSets = fn(&[f64], usize, &[Vec<f64>], &[&[f64]]) -> Rows;

/// The results of a function at many positions.
pub type Rows = Option<Vec<Vec<f64>>>;

/// The results of a function, by its number, at some arguments.
pub type Call = dyn Fn(usize, &[f64]) -> Vec<f64>;

/// The same mechanism as the command reads it.
///
/// # Panics
///
/// If the file cannot be read, or has a mistake.
#[must_use]
pub fn read(subject: &Subject) -> Mechanism {
    let source = Source::read(Path::new(subject.path)).expect("it can be read");
    let checked = check(source.calls()[subject.number].tokens.clone());
    Mechanism::new(&checked).expect("a mechanism without a mistake")
}

/// Arguments of a function: inputs in their ranges and a little beyond, others of any size.
#[must_use]
pub fn arguments(mechanism: &Mechanism, function: usize, random: &mut Random) -> Vec<f64> {
    let places = mechanism.compiled().functions[function].arguments.iter();
    places
        .map(|&place| match mechanism.inputs().get(place) {
            Some(input) => {
                let (low, high) = input.ends();
                let beyond = 0.02 * (high - low);
                random.between(low - beyond, high + beyond)
            }
            None => random.between(-20.0, 20.0),
        })
        .collect()
}

/// A result as a list of numbers, components innermost.
trait FlatNumbers {
    fn flat(&self, out: &mut Vec<f64>);
}

impl FlatNumbers for f64 {
    fn flat(&self, out: &mut Vec<f64>) {
        out.push(*self);
    }
}

impl FlatNumbers for Vector2<f64> {
    fn flat(&self, out: &mut Vec<f64>) {
        out.extend(self.iter());
    }
}

impl FlatNumbers for Vector3<f64> {
    fn flat(&self, out: &mut Vec<f64>) {
        out.extend(self.iter());
    }
}

impl FlatNumbers for Frame<f64> {
    fn flat(&self, out: &mut Vec<f64>) {
        [self.origin, self.x, self.y, self.z].flat(out);
    }
}

impl<F: FlatNumbers, const N: usize> FlatNumbers for [F; N] {
    fn flat(&self, out: &mut Vec<f64>) {
        self.iter().for_each(|one| one.flat(out));
    }
}

/// The reference inputs.
struct Reference {
    inputs: Vec<f64>,
}

impl Reference {
    fn of(inputs: &[Input]) -> Self {
        Self {
            inputs: inputs.iter().map(|input| input.reference).collect(),
        }
    }
}

include!(concat!(env!("OUT_DIR"), "/mechanisms.rs"));
