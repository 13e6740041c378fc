//! Comparisons of an example, and the test that runs the example.

mod comparison;

pub(crate) use comparison::Check;

/// An example compares itself with known answers and fails if one is missed.
#[test]
fn the_known_answers_are_met() -> Result<(), Box<dyn std::error::Error>> {
    super::main()
}
