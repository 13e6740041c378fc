//! What must be found is found: branches, calls, scalar arithmetic in loops.
#![cfg(all(target_arch = "x86_64", target_os = "linux"))]

use std::hint::black_box;

use linkage_machine_code::{inspect, loops};

#[inline(never)]
fn branching(x: f64, steps: u32) -> f64 {
    (0..steps).fold(x, |x, _| if x > 1.0 { x.exp() } else { 2.0 * x })
}

#[inline(never)]
fn calls_a_branching_function(x: f64, steps: u32) -> f64 {
    1.0 + branching(x, steps)
}

#[inline(never)]
fn elementary(x: f64, y: f64) -> f64 {
    let (sin, cos) = x.sin_cos();
    sin * cos + y.atan2(sin)
}

#[inline(never)]
fn divides(x: f64, y: f64) -> f64 {
    x / y + y.sqrt()
}

#[inline(never)]
fn multiply_add(x: f64, y: f64, z: f64) -> f64 {
    x.mul_add(y, z)
}

#[inline(never)]
fn packed(values: &mut [f64; 4096]) {
    for x in values {
        *x = (*x * 2.0 + 1.0) / 3.0;
    }
}

#[inline(never)]
fn with_a_call(values: &mut [f64; 4096]) {
    for x in values {
        *x = x.sin() * 2.0;
    }
}

#[inline(never)]
fn one_after_the_other(values: &mut [f64; 4096]) {
    let mut last = 1.0;
    for x in values {
        last = *x * last + 0.5;
        *x = last;
    }
}

#[test]
fn a_branch_is_found_also_behind_a_call() {
    assert!(black_box(branching(0.3, 4)).is_finite());
    assert!(black_box(calls_a_branching_function(0.3, 4)).is_finite());
    assert!(!inspect(branching as *const ()).branches.is_empty());
    let found = inspect(calls_a_branching_function as *const ());
    assert!(!found.branches.is_empty(), "{found:?}");
}

#[test]
fn elementary_functions_are_known() {
    assert!(black_box(elementary(0.3, 4.0)).is_finite());
    let found = inspect(elementary as *const ());
    assert!((2..=3).contains(&found.library.len()), "{found:?}");
    assert!(found.library.contains(&"atan2"), "{found:?}");
    assert!(
        found.branches.is_empty() && found.strange.is_empty(),
        "{found:?}"
    );
}

#[test]
fn divisions_and_roots_are_counted() {
    assert!(black_box(divides(0.3, 4.0)).is_finite());
    let found = inspect(divides as *const ());
    assert_eq!((found.divisions, found.roots), (1, 1), "{found:?}");
}

#[test]
fn a_multiply_add_is_found() {
    assert!(black_box(multiply_add(0.3, 4.0, 2.0)).is_finite());
    let found = inspect(multiply_add as *const ());
    assert!(found.fused == 1 || found.library == ["fma"], "{found:?}");
}

#[test]
fn packed_loops_are_told_from_others() {
    let mut values = black_box([0.5; 4096]);
    packed(&mut values);
    with_a_call(&mut values);
    one_after_the_other(&mut values);
    assert!(black_box(values)[0].is_finite());

    let good = loops(packed as *const ());
    assert!(good.scalar.is_empty() && good.calls.is_empty(), "{good:?}");
    assert!(!good.packed.is_empty() && good.divisions > 0, "{good:?}");
    let calling = loops(with_a_call as *const ());
    assert!(!calling.calls.is_empty(), "{calling:?}");
    assert!(calling.library.contains(&"sin"), "{calling:?}");
    let chained = loops(one_after_the_other as *const ());
    assert!(!chained.scalar.is_empty(), "{chained:?}");
}
