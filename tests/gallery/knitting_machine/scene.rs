//! Parts of the machine in a scene: what is off costs nothing, to the operation.

use super::drives::{
    EyeNeedle, HookNeedle, KnittingMachine, KnittingMachineAssembly, Press, Sinker,
};
use crate::check::Check;
use linkage::{Scene, Structure};
use std::cell::Cell;

/// Operations of a call. There is no branch in it, so that is what every call costs.
pub(crate) fn operations(structure: &Structure, function: &str) -> u32 {
    let mut functions = structure.functions.iter();
    let own = functions.find(|own| own.name == function);
    own.map_or(u32::MAX, |own| own.operations.total())
}

pub(crate) fn parts(machine: &KnittingMachineAssembly, check: &mut Check) {
    let of = |function| operations(KnittingMachine::STRUCTURE, function);
    let [hook, eye, sinker, press] = ["hook", "eye", "sinker", "press"].map(of);
    let alone = [
        operations(HookNeedle::STRUCTURE, "motion"),
        operations(EyeNeedle::STRUCTURE, "motion"),
        operations(Sinker::STRUCTURE, "motion"),
        operations(Press::STRUCTURE, "motion"),
    ];
    let here = [hook, eye, sinker, press];
    println!("       in the machine {here:?}, alone {alone:?}");
    check.holds("every drive takes what it takes alone", here == alone);

    let done = Cell::new(0);
    let spend = |cost: u32| done.set(done.get() + cost);
    let mut scene = Scene::new();
    let hooks = scene.add(|x: &f64| {
        spend(hook);
        machine.hook(*x)
    });
    let eyes = scene.add(|x| {
        spend(eye);
        machine.eye(*x)
    });
    let sinkers = scene.add(|x| {
        spend(sinker);
        machine.sinker(*x)
    });
    let presses = scene.add(|x| {
        spend(press);
        machine.press(*x)
    });
    // Two additions and a norm: what both needles have computed is not computed again.
    let gaps = scene.add_of((hooks, eyes), |(hook, eye)| (eye.tip - hook.tip).norm());
    let cost = |scene: &mut Scene<'_, f64>, x: f64| {
        done.set(0);
        (scene.update(x), done.get())
    };
    let all = hook + eye + sinker + press;
    check.holds(
        "all on: four parts, and what two of them are to each other",
        cost(&mut scene, 0.1) == (5, all),
    );
    scene.switch_off(presses);
    check.holds(
        "without the press: as much less",
        cost(&mut scene, 0.2) == (4, all - press),
    );
    scene.switch_off(sinkers);
    check.holds(
        "without the sinkers, too",
        cost(&mut scene, 0.3) == (3, hook + eye),
    );
    check.holds("the same angle: nothing", cost(&mut scene, 0.3) == (0, 0));
    scene.switch_off(eyes);
    check.holds("the hook needle alone", cost(&mut scene, 0.4) == (1, hook));
    check.holds("and no distance", scene.get(gaps).is_none());
    scene.switch_on(eyes);
    check.holds(
        "the eye needle again: that, and the distance",
        cost(&mut scene, 0.4) == (2, eye),
    );
    let known = (machine.eye(0.4).tip - machine.hook(0.4).tip).norm();
    check.holds("which is the same", scene.get(gaps) == Some(&known));
}
