//! Singles on an emulated Cortex-M0+, which computes them in software.

use linkage_corpus::given::golden;
use linkage_random::is_long;

use crate::controller::{Figure, PAGE, by_rust, measure, version};
use crate::emulated::{COMPILER, build, tools};
use crate::machine;
use crate::page;

/// A Cortex-M0+ has no numbers with a point: its compiler calls functions for them, whose instructions depend on the numbers. Results are the same.
#[test]
fn a_controller_without_numbers_with_a_point_has_the_same_results() {
    let Some(compiler) = tools() else {
        return;
    };
    let mut all = vec![page::press()];
    if is_long() {
        all.extend(golden());
        all.retain(|own| own.unit.coupled.is_empty());
    }
    let folder = machine::folder("controller_soft");
    let flags = [
        "-mcpu=cortex-m0plus",
        "-mthumb",
        "-mfloat-abi=soft",
        "-std=c99",
        "-O2",
        "-fno-math-errno",
        "-ffunction-sections",
    ];
    build(&compiler, &flags, &folder, &all);
    let figures = measure(&folder, &all, 0.0, by_rust);
    for Figure {
        call,
        instructions: [least, most],
        ..
    } in &figures
    {
        println!("{call}: {least} to {most}");
    }
    let press = figures
        .iter()
        .find(|own| own.call == "press_motion")
        .expect("the page's mechanism");
    let [least, most] = press.instructions;
    assert!(least < most, "{least} to {most}");
    // As the page has it: `5,611 to 8,364`.
    let thousands = |x: u32| format!("{},{:03}", x / 1000, x % 1000);
    let told = format!("{} to {}", thousands(least), thousands(most));
    assert!(
        PAGE.contains(&told) || !PAGE.contains(&version(COMPILER)),
        "the page has other figures than {told}"
    );
}
