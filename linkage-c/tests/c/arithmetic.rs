//! What assembling finds of arithmetic that results are not made for, and what the preprocessor refuses.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use linkage_c::{Real, Sources, sources};
use linkage_corpus::given::Given;

use crate::machine::{self, Compiler, compilers};
use crate::page;

pub(crate) const REALS: [Real; 2] = [Real::Double, Real::Single];

/// Assembles under each rounding mode that the processor has, to nearest first, and prints numbers and texts.
const MAIN: &str = r#"
#include "NAME.h"
#include <fenv.h>
#include <stdio.h>

int main(void)
{
    static const int modes[] = { FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO };
    const NAME_dimensions d = UPPER_DEFAULTS;
    NAME m;
    int k;
    for (k = 0; k < 4; k++) {
        int code;
        fesetround(modes[k]);
        code = NAME_assemble(&m, &d);
        fesetround(FE_TONEAREST);
        printf("%d|%s\n", code, NAME_error(code));
    }
    return 0;
}
"#;

/// A mechanism without a sine, and one with.
pub(crate) fn some() -> [Given; 2] {
    let straight = "
        pub struct Straight {
            unit mm;
            param height = 30mm;
            input s = 20mm in 0mm..100mm;
            unknown t = 40mm;
            loop hypot(s, height) = t;
        }
        impl Straight { pub fn motion(s) -> Motion { t } }";
    [Given::text(straight), page::press()]
}

/// Compilers of C.
pub(crate) fn of_c() -> Vec<(&'static str, Compiler)> {
    let mut all = compilers();
    all.retain(|(command, _)| !command.contains("++"));
    all
}

/// A folder with a mechanism and the program, whose source the function changes.
pub(crate) fn written(
    folder: &str,
    given: &Given,
    real: Real,
    change: impl Fn(String) -> String,
) -> (PathBuf, String) {
    let folder = machine::folder(&format!("{folder}_{}_{}", given.name, real.name()));
    let Sources {
        name,
        header,
        source,
        ..
    } = sources(&given.name, &given.unit, real).expect("it can be exported");
    let main = MAIN
        .replace("NAME", &name)
        .replace("UPPER", &name.to_uppercase());
    for (file, text) in [
        (format!("{name}.h"), change(header)),
        (format!("{name}.c"), change(source)),
        ("main.c".to_owned(), main),
    ] {
        fs::write(folder.join(file), text).expect("C can be written");
    }
    (folder, name)
}

/// Compiles the mechanism with flags and the program without; what the program prints, a line for each mode, or else the compiler's messages.
pub(crate) fn assembled(
    compiler: &Compiler,
    folder: &Path,
    name: &str,
    flags: &[&str],
) -> Result<Vec<String>, String> {
    let source = format!("{name}.c");
    let flags = [&["-std=c99", "-c", &source, "-o", "own.o"], flags].concat();
    compiler.attempt(folder, &flags)?;
    compiler.run(
        folder,
        &["-std=c99", "main.c", "own.o", "-o", "program", "-lm"],
    );
    let output = Command::new(folder.join("program"))
        .output()
        .expect("it runs");
    assert!(output.status.success());
    let printed = String::from_utf8(output.stdout).expect("a text");
    Ok(printed.lines().map(str::to_owned).collect())
}

/// Without what the preprocessor and the type of constants refuse: then assembling has to.
fn unchecked(text: String) -> String {
    let kept = text
        .lines()
        .filter(|line| !line.starts_with("#error") && !line.starts_with("typedef char"));
    kept.collect::<Vec<_>>().join("\n") + "\n"
}

const REORDERED: &str = "the compiler computes sums in another order, which makes positions wrong: compile without -funsafe-math-optimizations, ";
const DIGITS: &str = "numbers are computed with more or fewer digits than their type has: compile without -fsingle-precision-constant, ";
const ROUNDING: &str =
    "numbers are not rounded to nearest here: call fesetround(FE_TONEAREST) before assembling, ";

fn says(line: &str, text: &str) -> bool {
    let (code, told) = line.split_once('|').expect("number and text");
    code != "0"
        && told
            .split_once(": ")
            .is_some_and(|(_, told)| told.starts_with(text))
}

#[test]
fn each_rounding_mode_but_to_nearest_is_refused() {
    let Some(compiler) = Compiler::find() else {
        return;
    };
    for given in some() {
        for real in REALS {
            let (folder, name) = written("modes", &given, real, |text| text);
            let lines = assembled(&compiler, &folder, &name, &["-O1"]).expect("it compiles");
            assert_eq!(lines[0], format!("0|{}: assembled", given.name));
            for line in &lines[1..] {
                assert!(
                    says(line, ROUNDING),
                    "{} in {}: {line}",
                    given.name,
                    real.name()
                );
            }
        }
    }
}

/// Optimisation, fused multiply-adds and wide registers are no reason to refuse.
#[test]
fn what_keeps_the_order_is_assembled() {
    let flags: [&[&str]; 5] = [
        &["-O0"],
        &["-O2"],
        &["-O3", "-ffp-contract=fast", "-march=native"],
        &["-O3", "-ffp-contract=off", "-frounding-math"],
        &[
            "-Os",
            "-fno-math-errno",
            "-fno-trapping-math",
            "-fno-signed-zeros",
        ],
    ];
    let [_, press] = &some();
    for real in REALS {
        let (folder, name) = written("kept", press, real, |text| text);
        for (command, compiler) in of_c() {
            for flags in flags {
                let lines = assembled(&compiler, &folder, &name, flags).expect("it compiles");
                assert_eq!(
                    lines[0],
                    "0|Press: assembled",
                    "{command} {flags:?} in {}",
                    real.name()
                );
            }
        }
    }
}

#[test]
fn sums_in_another_order_are_refused() {
    let all = some();
    for (command, compiler) in of_c() {
        for (number, given) in all.iter().enumerate() {
            for real in REALS {
                let (folder, name) = written("reordered", given, real, |text| text);
                let flags = [
                    "-fassociative-math",
                    "-fno-signed-zeros",
                    "-fno-trapping-math",
                ];
                let flags = if number == 0 {
                    &flags[..]
                } else {
                    &["-funsafe-math-optimizations"]
                };
                for level in ["-O1", "-O3"] {
                    // GCC has a macro for it, clang has none.
                    match assembled(&compiler, &folder, &name, &[&[level], flags].concat()) {
                        Err(messages) => assert!(
                            messages.contains("Sums must be computed in their order"),
                            "{command}: {messages}"
                        ),
                        Ok(lines) => assert!(
                            says(&lines[0], REORDERED),
                            "{command} {level} in {}: {}",
                            real.name(),
                            lines[0]
                        ),
                    }
                }
            }
        }
    }
}

/// As a compiler would be that has no macro for it.
#[test]
fn assembling_refuses_what_the_preprocessor_does_not_see() {
    for (command, compiler) in of_c() {
        for given in some() {
            for real in REALS {
                let (folder, name) = written("unchecked", &given, real, unchecked);
                let lines = assembled(&compiler, &folder, &name, &["-O2", "-ffast-math"])
                    .expect("nothing is checked");
                assert!(
                    says(&lines[0], REORDERED),
                    "{command}, {}: {}",
                    real.name(),
                    lines[0]
                );
                if command == "gcc" && real == Real::Double {
                    let lines = assembled(
                        &compiler,
                        &folder,
                        &name,
                        &["-O2", "-fsingle-precision-constant"],
                    );
                    let lines = lines.expect("nothing is checked");
                    assert!(says(&lines[0], DIGITS), "{}", lines[0]);
                }
            }
        }
    }
}
