//! Lengths that do not belong together.

use super::{FiveBar, Rocker};

#[test]
#[should_panic(expected = "motion_sweep: `phi` has 3 elements, `phase` has 2")]
fn inputs_of_different_lengths() {
    let linkage = FiveBar::default().assemble().expect("it assembles");
    let _ = linkage.motion_sweep(&[1.0; 3], &[0.1; 2]);
}

#[test]
#[should_panic(expected = "motion_sweep_slices: there are 5 positions, but slice 4 has 4 elements")]
fn a_slice_that_is_too_short() {
    let linkage = Rocker::default().assemble().expect("it assembles");
    let mut buffer = [0.0; 29];
    let mut rest = &mut buffer[..];
    let slices = [5, 5, 5, 5, 4, 5].map(|len| {
        let (slice, behind) = std::mem::take(&mut rest).split_at_mut(len);
        rest = behind;
        slice
    });
    linkage.motion_sweep_slices(&[1.0; 5], slices);
}

#[test]
#[should_panic(
    expected = "motion_sweep_sets: there are 4 mechanisms, but `phase` has 3 elements; give it 4 or 1"
)]
fn neither_one_input_nor_one_for_each_mechanism() {
    let linkage = FiveBar::default().assemble().expect("it assembles");
    let _ = linkage.motion_sweep_sets(&[FiveBar::default(); 4], &[1.0], &[0.1; 3]);
}

#[test]
#[should_panic(
    expected = "motion_sweep_sets: there are 2 mechanisms, but `phi` has 0 elements; give it 2 or 1"
)]
fn no_input_for_mechanisms() {
    let linkage = Rocker::default().assemble().expect("it assembles");
    let _ = linkage.motion_sweep_sets(&[Rocker::default(); 2], &[]);
}

#[test]
#[should_panic(expected = "motion_sweep_into: `phi` has 3 elements, `phase` has 2")]
fn inputs_of_different_lengths_into_columns() {
    let linkage = FiveBar::default().assemble().expect("it assembles");
    linkage.motion_sweep_into(&[1.0; 3], &[0.1; 2], &mut Default::default());
}

#[test]
#[should_panic(
    expected = "motion_sweep_sets_into: there are 4 mechanisms, but `phase` has 3 elements; give it 4 or 1"
)]
fn inputs_for_mechanisms_into_columns() {
    let linkage = FiveBar::default().assemble().expect("it assembles");
    let mechanisms = [FiveBar::default(); 4];
    linkage.motion_sweep_sets_into(&mechanisms, &[1.0], &[0.1; 3], &mut Default::default());
}
