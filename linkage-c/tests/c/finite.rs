//! Files of users that are compiled as if there was no NaN: they are refused, unless they test results by the function that looks at bits.

use std::fs;
use std::process::Command;

use linkage_c::{Real, Sources, sources};
use linkage_random::{is_long, one_in};

use crate::machine::{self, compilers};
use crate::page;

const REALS: [Real; 2] = [Real::Double, Real::Single];

/// Compiled with finite mathematics: counts the positions of a turn for which there is a ram, a rod being too short for some.
const USER: &str = r#"
#ifdef WAIVED
#define PRESS_FINITE_MATH
#endif
#include "press.h"
#include <stdio.h>

int main(void)
{
    press_dimensions d = PRESS_DEFAULTS;
    press m;
    int k, there = 0, code;
    d.rod = ROD;
    code = press_assemble(&m, &d);
    for (k = 0; k < 360; k++) {
        const press_motion_result at = press_motion(&m, (REAL)k * (REAL)0.017453292519943295);
        there += press_ok(at.ram) && press_ok(at.v);
    }
    printf("%d %d %d %d\n", code, there, press_ok((REAL)-1e30), press_ok((REAL)1e30 * (REAL)1e30 * LARGE));
    return 0;
}
"#;

/// The number of positions at which the rod reaches, whole degrees.
fn reached(rod: f64) -> usize {
    let height = |k: usize| 10.0 - 40.0 * (k as f64).to_radians().sin();
    (0..360).filter(|k| height(*k).abs() < rod).count()
}

#[test]
fn a_file_without_nan_is_refused_or_asks_for_bits() {
    let rod = 45.3;
    let there = reached(rod);
    assert!(there > 200 && there < 350, "{there}");
    for (command, compiler) in compilers() {
        for real in one_in(2, REALS) {
            let folder = machine::folder(&format!("finite_{}", real.name()));
            let given = page::press();
            let own: Sources = sources(&given.name, &given.unit, real).expect("it can be exported");
            machine::write(&folder, &own);
            let large = match real {
                Real::Double | Real::Fused => "1e300",
                Real::Single => "1.0f",
            };
            let user = USER
                .replace("REAL", real.name())
                .replace("ROD", &format!("(({}){rod})", real.name()));
            fs::write(folder.join("main.c"), user.replace("LARGE", large))
                .expect("C can be written");
            let language = match command.contains("++") {
                true => ["-x", "c++"],
                false => ["-x", "c"],
            };
            let all = |flags: &[&'static str]| [&language, flags].concat();
            for flag in ["-ffinite-math-only", "-ffast-math"] {
                let refused =
                    compiler.attempt(&folder, &all(&[flag, "-c", "main.c", "-o", "main.o"]));
                let messages = refused.expect_err("it is refused");
                assert!(
                    messages.contains("press_ok() alone and define PRESS_FINITE_MATH"),
                    "{command}: {messages}"
                );
                // The source is refused whatever the user defines.
                let refused = compiler.attempt(
                    &folder,
                    &all(&[
                        flag,
                        "-DPRESS_FINITE_MATH",
                        "-c",
                        "press.c",
                        "-o",
                        "press.o",
                    ]),
                );
                let messages = refused.expect_err("it is refused");
                assert!(
                    messages.contains("NaN says that a position does not exist"),
                    "{command}: {messages}"
                );
                // Together in one optimisation, too, where the linker has one.
                let ways = [&[][..], &["-flto"]].into_iter();
                for together in ways.filter(|own| is_long() || command == "gcc" || own.is_empty()) {
                    let first = [&["-O3", "-c", "press.c", "-o", "press.o"], together].concat();
                    let second = [
                        &["-O3", flag, "-DWAIVED", "-c", "main.c", "-o", "main.o"],
                        together,
                    ]
                    .concat();
                    compiler.run(&folder, &all(&first));
                    compiler.run(&folder, &all(&second));
                    let linked =
                        [&["-O3", "main.o", "press.o", "-o", "main", "-lm"], together].concat();
                    if compiler.attempt(&folder, &linked).is_err() && !together.is_empty() {
                        continue;
                    }
                    let output = Command::new(folder.join("main")).output().expect("it runs");
                    let printed = String::from_utf8(output.stdout).expect("a text");
                    assert_eq!(
                        printed,
                        format!("0 {there} 1 0\n"),
                        "{command} {flag} {together:?} in {}",
                        real.name()
                    );
                }
            }
        }
    }
}
