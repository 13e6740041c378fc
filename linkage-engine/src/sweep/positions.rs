//! The number of positions of a sweep.

/// The number of positions that the slices are for.
pub(super) fn positions(function: &str, names: &[&str], slices: &[&[f64]]) -> usize {
    assert_eq!(
        slices.len(),
        names.len(),
        "`{function}` takes {} slices: `{}`",
        names.len(),
        names.join("`, `")
    );
    let mut lengths = slices.iter().map(|slice| slice.len()).enumerate();
    let longest = lengths.find(|(_, length)| *length != 1);
    let (first, positions) = longest.unwrap_or((0, usize::from(!names.is_empty())));
    for (name, slice) in names.iter().zip(slices) {
        assert!(
            slice.len() == positions || slice.len() == 1,
            "`{function}`: `{}` has {positions} elements, `{name}` has {}",
            names[first],
            slice.len()
        );
    }
    positions
}
