//! Several organs on one shaft: cyclograms, clearances and phases against references of 40 digits; parts that turn with a body.

mod clearance;
mod cyclogram;
mod mechanisms;
mod phases;
mod references;
mod turning;
mod waves;

type Outcome = Result<(), Box<dyn std::error::Error>>;
