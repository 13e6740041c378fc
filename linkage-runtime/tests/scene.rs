//! Which functions a scene evaluates, and when.
#![cfg(feature = "alloc")]

use linkage_runtime::{Columns, Handle, Scene};
use std::cell::Cell;
use std::hash::{BuildHasher, RandomState};

/// A function that counts its calls.
fn counted<'a>(calls: &'a Cell<u32>, factor: f64) -> impl FnMut(&f64) -> f64 + 'a {
    move |x| {
        calls.set(calls.get() + 1);
        factor * x
    }
}

#[test]
fn a_function_is_evaluated_once_for_each_argument() {
    let calls = Cell::new(0);
    let mut scene = Scene::new();
    let double = scene.add(counted(&calls, 2.0));
    assert_eq!((scene.get(double), scene.argument()), (None, None));

    assert_eq!(scene.update(1.5), 1);
    assert_eq!(
        (scene.get(double), scene.argument()),
        (Some(&3.0), Some(&1.5))
    );
    assert_eq!((scene.update(1.5), calls.get()), (0, 1));
    assert_eq!((scene.update(2.5), calls.get()), (1, 2));
    assert_eq!(scene.get(double), Some(&5.0));
    // Only the last argument is remembered.
    assert_eq!((scene.update(1.5), calls.get()), (1, 3));
}

#[test]
fn what_is_off_is_not_called_and_has_no_result() {
    let [first, second] = [Cell::new(0), Cell::new(0)];
    let mut scene = Scene::new();
    let needle = scene.add(counted(&first, 2.0));
    let press = scene.add(counted(&second, 3.0));
    scene.switch_off(press);
    assert!(scene.is_on(needle) && !scene.is_on(press));

    assert_eq!((scene.update(1.0), scene.update(2.0)), (1, 1));
    assert_eq!((first.get(), second.get()), (2, 0));
    assert_eq!((scene.get(needle), scene.get(press)), (Some(&4.0), None));

    // On again, it has no result before the next update, which evaluates it alone.
    scene.switch_on(press);
    assert_eq!(scene.get(press), None);
    assert_eq!((scene.update(2.0), first.get(), second.get()), (1, 2, 1));
    assert_eq!(scene.get(press), Some(&6.0));

    // Off and on for the same argument: the result is still right.
    scene.switch_off(press);
    assert_eq!((scene.update(2.0), scene.get(press)), (0, None));
    scene.switch_on(press);
    assert_eq!((scene.update(2.0), scene.get(press)), (0, Some(&6.0)));

    // Off while the argument changes: the old result does not come back.
    scene.switch_off(press);
    scene.update(3.0);
    scene.switch_on(press);
    assert_eq!(scene.get(press), None);
    assert_eq!((scene.update(3.0), scene.get(press)), (1, Some(&9.0)));
}

#[test]
fn what_else_has_changed_is_said_by_invalidating() {
    let length = Cell::new(10.0);
    let mut scene = Scene::new();
    let scaled = scene.add(|x: &f64| length.get() * x);
    let plain = scene.add(|x: &f64| *x);
    scene.update(2.0);
    length.set(20.0);
    scene.invalidate(scaled);
    assert_eq!((scene.get(scaled), scene.get(plain)), (None, Some(&2.0)));
    assert_eq!((scene.update(2.0), scene.get(scaled)), (1, Some(&40.0)));
}

#[test]
fn another_function_takes_the_place_of_one() {
    let calls = Cell::new(0);
    let mut scene = Scene::new();
    let handle = scene.add(counted(&calls, 2.0));
    scene.update(1.0);
    scene.set(handle, |x| 5.0 * x);
    assert_eq!(scene.get(handle), None);
    assert_eq!((scene.update(1.0), scene.get(handle)), (1, Some(&5.0)));
    assert_eq!(calls.get(), 1);

    scene.switch_off(handle);
    scene.set_into(handle, 7.0, |x, sum| *sum += x);
    assert!(!scene.is_on(handle));
    scene.switch_on(handle);
    assert_eq!((scene.update(1.0), scene.get(handle)), (1, Some(&8.0)));
    assert_eq!((scene.update(2.0), scene.get(handle)), (1, Some(&10.0)));
}

#[test]
fn a_buffer_is_no_result_before_it_is_filled() {
    let mut scene = Scene::new();
    let sum = scene.add_into(7.0, |x: &f64, sum| *sum += x);
    assert_eq!(scene.get(sum), None);
    scene.switch_off(sum);
    scene.update(1.0);
    assert_eq!(scene.get(sum), None);
}

#[test]
fn sweeps_stay_where_they_are() {
    let mut scene = Scene::<Vec<f64>>::new();
    let table = scene.add_into(Columns::<f64>::new(1, 0), |angles, columns| {
        columns.resize(angles.len());
        columns.column_mut(0).copy_from_slice(angles);
    });
    let first = [0.0, 1.0, 2.0];
    assert_eq!(scene.update_from(&first[..]), 1);
    assert_eq!(scene.update_from(&first[..]), 0);
    let place = |scene: &Scene<'_, Vec<f64>>| {
        let column = scene.get(table).map(|columns| columns.column(0).as_ptr());
        (column, scene.argument().map(|angles| angles.as_ptr()))
    };
    let before = place(&scene);
    assert_eq!(scene.update_from(&[3.0, 4.0, 5.0][..]), 1);
    assert_eq!(place(&scene), before);
    assert_eq!(scene.get(table).map(|c| c.get(2, 0)), Some(5.0));

    // A vector, and one that is given away.
    assert_eq!(scene.update_from(&vec![3.0, 4.0, 5.0]), 0);
    assert_eq!(scene.update(vec![3.0]), 1);
    assert_eq!(scene.get(table).map(Columns::len), Some(1));
}

#[test]
fn the_argument_may_be_that_of_several_shafts() {
    let mut scene = Scene::new();
    let sum = scene.add(|[a, b]: &[f64; 2]| a + b);
    assert_eq!(scene.update([1.0, 2.0]), 1);
    assert_eq!(scene.update([1.0, 2.0]), 0);
    assert_eq!((scene.update([1.0, 3.0]), scene.get(sum)), (1, Some(&4.0)));
}

#[test]
fn not_a_number_is_never_the_same_argument() {
    let calls = Cell::new(0);
    let mut scene = Scene::new();
    let handle = scene.add(counted(&calls, 2.0));
    assert_eq!((scene.update(f64::NAN), scene.update(f64::NAN)), (1, 1));
    assert!(scene.get(handle).is_some_and(|x| x.is_nan()));
    assert_eq!(calls.get(), 2);
}

#[test]
fn functions_are_evaluated_in_the_order_in_which_they_were_added() {
    let order = Cell::new(String::new());
    let mut scene = Scene::new();
    let handles = ["a", "b", "c"].map(|name| {
        scene.add({
            let order = &order;
            move |_: &f64| order.set(order.take() + name)
        })
    });
    scene.set(handles[0], |_| order.set(order.take() + "A"));
    scene.update(1.0);
    assert_eq!(order.take(), "Abc");

    for handle in [handles[1], handles[0], handles[1]] {
        scene.switch_off(handle);
    }
    assert_eq!((scene.update(2.0), order.take()), (1, "c".into()));
    for handle in [handles[1], handles[0], handles[1]] {
        scene.switch_on(handle);
    }
    assert_eq!((scene.update(3.0), order.take()), (3, "Abc".into()));
}

#[test]
#[should_panic(expected = "the handle is of another scene")]
fn a_handle_of_another_scene_is_refused() {
    let mut scene = Scene::new();
    scene.add(|x: &f64| *x);
    let mut other = Scene::new();
    let handle = other.add(|x: &f64| *x);
    scene.update(1.0);
    let _ = scene.get(handle);
}

#[test]
fn handles_are_small_names() {
    /// Without any trait.
    struct Bare;
    let mut scene = Scene::<f64>::default();
    let [a, b]: [Handle<Bare>; 2] = [scene.add(|_| Bare), scene.add(|_| Bare)];
    let copy = a;
    assert!(a == copy && a != b);
    let hasher = RandomState::new();
    assert_eq!(hasher.hash_one(a), hasher.hash_one(copy));
    assert_ne!(hasher.hash_one(a), hasher.hash_one(b));
    assert_eq!(format!("{b:?}"), "Handle(1)");
    assert_eq!(
        format!("{scene:?}"),
        "Scene { argument: None, functions: 2, .. }"
    );
}

/// What several parts are asked for at once is made of what each has computed: none is evaluated for it again.
#[test]
fn results_are_made_of_results() {
    let calls = [const { Cell::new(0) }; 3];
    let mut scene = Scene::new();
    let hook = scene.add(counted(&calls[0], 2.0));
    let eye = scene.add(counted(&calls[1], 3.0));
    let gap = scene.add_of((hook, eye), |(hook, eye)| {
        calls[2].set(calls[2].get() + 1);
        eye - hook
    });
    let far = scene.add_of(gap, |gap| *gap > 1.0);
    let counts = || [&calls[0], &calls[1], &calls[2]].map(Cell::get);
    assert_eq!((scene.update(1.0), counts()), (4, [1, 1, 1]));
    assert_eq!((scene.get(gap), scene.get(far)), (Some(&1.0), Some(&false)));
    assert_eq!((scene.update(1.0), counts()), (0, [1, 1, 1]));
    assert_eq!((scene.update(2.0), counts()), (4, [2, 2, 2]));

    // Without a part there is nothing of it, and the other one costs what it costs alone.
    scene.switch_off(eye);
    assert_eq!((scene.get(gap), scene.get(far)), (None, None));
    assert_eq!((scene.update(3.0), counts()), (1, [3, 2, 2]));
    assert_eq!((scene.get(hook), scene.get(far)), (Some(&6.0), None));
    scene.switch_on(eye);
    assert_eq!((scene.update(3.0), counts()), (3, [3, 3, 3]));
    // On again for the same argument: nothing has changed.
    scene.switch_off(hook);
    assert_eq!((scene.update(3.0), scene.get(gap)), (0, None));
    scene.switch_on(hook);
    assert_eq!((scene.update(3.0), scene.get(gap)), (0, Some(&3.0)));

    // Another function of a part, or one that is out of date: what is made of it follows.
    scene.set(hook, |x| 10.0 * x);
    assert_eq!((scene.get(gap), scene.get(far)), (None, None));
    assert_eq!((scene.update(3.0), counts()), (3, [3, 3, 4]));
    assert_eq!(
        (scene.get(gap), scene.get(far)),
        (Some(&-21.0), Some(&false))
    );
    scene.invalidate(eye);
    assert_eq!((scene.update(3.0), counts()), (3, [3, 4, 5]));

    // A part that changes while what is made of it is off.
    scene.switch_off(gap);
    scene.set(hook, |_| 0.0);
    assert_eq!((scene.update(3.0), scene.get(far)), (1, None));
    scene.switch_on(gap);
    assert_eq!((scene.update(3.0), scene.get(far)), (2, Some(&true)));
    scene.set(gap, |_| 0.5);
    assert_eq!((scene.update(3.0), scene.get(far)), (2, Some(&false)));
}

#[test]
#[should_panic(expected = "the handle is of another scene")]
fn nothing_is_made_of_another_scene() {
    let mut scene = Scene::new();
    let handle = scene.add(|x: &f64| *x);
    let mut other = Scene::<f64>::new();
    other.add_of(handle, |x| *x);
}
