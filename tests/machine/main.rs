//! Several organs on one shaft: cyclograms, clearances and phases against references of 40 digits.

mod clearance;
mod cyclogram;
mod mechanisms;
mod phases;
mod references;
mod waves;

type Outcome = Result<(), Box<dyn std::error::Error>>;
