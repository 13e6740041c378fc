//! Exported C on other processors, whose compilers and emulators are asked if they are there: results to the last bit.

use std::env;
use std::fmt::Write;
use std::fs;
use std::path::Path;
use std::process::Command;

use linkage_c::{Real, Sources, sources};
use linkage_corpus::given::{Given, golden};
use linkage_corpus::reference::Assembled;
use linkage_random::{Random, is_long};

use crate::batch::{Batch, Number};
use crate::machine::{self, Compiler};
use crate::mechanisms::{arguments, compare};
use crate::page;

/// A processor under Linux.
struct Target {
    compiler: &'static str,
    emulator: &'static str,
    is_swapped: bool,
    flags: &'static [&'static str],
    /// For floats.
    single_flags: &'static [&'static str],
}

const TARGETS: [Target; 3] = [
    Target {
        compiler: "s390x-linux-gnu-gcc",
        emulator: "qemu-s390x-static",
        is_swapped: true,
        flags: &["-static", "-O2"],
        // Otherwise floats are computed as doubles in C99, and the source says so.
        single_flags: &["-fexcess-precision=fast"],
    },
    Target {
        compiler: "aarch64-linux-gnu-gcc",
        emulator: "qemu-aarch64-static",
        is_swapped: false,
        flags: &["-static", "-O2"],
        single_flags: &[],
    },
    Target {
        compiler: "arm-linux-gnueabihf-gcc",
        emulator: "qemu-arm-static",
        is_swapped: false,
        flags: &["-static", "-O2"],
        single_flags: &[],
    },
];

/// A compiler and what runs its programs. Without them tests pass and say so, unless `LINKAGE_FOREIGN=required` is in the environment.
fn tools(compiler: &str, emulator: &str) -> Option<Compiler> {
    if let (Some(found), true) = (Compiler::named(compiler), is_there(emulator)) {
        return Some(found);
    }
    let missing = format!("there is no `{compiler}` or no `{emulator}`");
    let required = env::var("LINKAGE_FOREIGN").is_ok_and(|word| word == "required");
    assert!(!required, "{missing}");
    println!("skipped: {missing}");
    None
}

fn is_there(command: &str) -> bool {
    Command::new(command).arg("--help").output().is_ok()
}

/// The page's mechanism, and in long runs those of the golden files that formulas close.
fn some() -> Vec<Given> {
    let mut all = vec![page::press()];
    if is_long() {
        all.extend(golden());
        all.retain(|own| own.unit.coupled.is_empty());
    }
    all
}

fn same<T: Number>(target: &Target, more: &[&str]) {
    let Some(compiler) = tools(target.compiler, target.emulator) else {
        return;
    };
    let (given, name) = (some(), format!("{}_{}", target.compiler, T::REAL.name()));
    let batch = Batch::new::<T>(&compiler, &name, &given, &[target.flags, more].concat());
    let (_, finite) = compare::<T>(
        &name,
        &given,
        &batch.under(target.emulator, target.is_swapped),
    );
    assert!(finite > 150, "{finite} results");
}

#[test]
fn other_processors_compute_the_same() {
    for target in &TARGETS {
        same::<f64>(target, &[]);
        same::<f32>(target, target.single_flags);
    }
}

/// Prints the bits of all results on an AVR, whose `double` is a float.
const AVR: &str = r#"
#include "NAME.h"
#include <avr/interrupt.h>
#include <avr/io.h>
#include <avr/pgmspace.h>
#include <avr/sleep.h>
#include <string.h>

static const uint32_t arguments[] PROGMEM = { ARGUMENTS };
static float next(void)
{
    static uint16_t place;
    const uint32_t bits = pgm_read_dword(&arguments[place++]);
    float number;
    memcpy(&number, &bits, sizeof number);
    return number;
}
static void put(char c)
{
    while (!(UCSR0A & (1 << UDRE0))) { }
    UDR0 = c;
}
static void word(uint32_t bits)
{
    int8_t k;
    for (k = 28; k >= 0; k -= 4) put("0123456789abcdef"[(bits >> k) & 15]);
    put('\n');
}
static NAME own;
CALLS
int main(void)
{
    const NAME_dimensions d = UPPER_DEFAULTS;
    UCSR0B = 1 << TXEN0;
    word((uint32_t)NAME_assemble(&own, &d));
RUN
    cli();
    sleep_mode();
    return 0;
}
"#;

/// Positions of each function on an AVR.
const POSITIONS: usize = 40;

/// The program for a mechanism, and the results of Rust.
fn for_avr(given: &Given, name: &str) -> (String, Vec<f32>) {
    let unit = &given.unit;
    let defaults: Vec<f32> = unit.scalars().map(|own| own.nominal as f32).collect();
    let assembled = Assembled::new(unit, &defaults).expect("the defaults are assembled");
    let mut random = Random::new(42);
    let (mut words, mut expected) = (Vec::new(), Vec::new());
    let [mut calls, mut run] = [const { String::new() }; 2];
    for (index, function) in unit.functions.iter().enumerate() {
        for position in 0..POSITIONS {
            let at: Vec<f32> = arguments(unit, index, position, &mut random);
            words.extend(at.iter().map(|x| format!("0x{:08x}u", x.to_bits())));
            expected.extend(assembled.call(function, &at));
        }
        let (call, gives) = (&function.name, function.called.program.outputs.len());
        let takes = function.arguments.len();
        let read: String = (0..takes)
            .map(|k| format!("    const float x{k} = next();\n"))
            .collect();
        let at: String = (0..takes).map(|k| format!(", x{k}")).collect();
        let _ = writeln!(
            calls,
            "static void call_{index}(void)\n{{\n{read}    const {name}_{call}_result r = {name}_{call}(&own{at});\n    uint32_t bits[{gives}];\n    \
             uint8_t k;\n    memcpy(bits, &r, sizeof bits);\n    for (k = 0; k < {gives}; k++) word(bits[k]);\n}}"
        );
        let _ = writeln!(
            run,
            "    {{ uint8_t k; for (k = 0; k < {POSITIONS}; k++) call_{index}(); }}"
        );
    }
    words.push("0".to_owned());
    let program = AVR
        .replace("ARGUMENTS", &words.join(", "))
        .replace("CALLS", &calls)
        .replace("RUN", &run);
    let program = program
        .replace("NAME", name)
        .replace("UPPER", &name.to_uppercase());
    (program, expected)
}

/// The words that a program of an AVR writes to its serial line.
fn simulated(folder: &Path) -> Vec<u32> {
    let mut command = Command::new("simavr");
    command.args(["-m", "atmega2560", "-f", "16000000", "program"]);
    let output = command.current_dir(folder).output().expect("it runs");
    let printed = [output.stdout, output.stderr].concat();
    let printed = String::from_utf8_lossy(&printed);
    // The simulator has a colour for what comes from the line, and a point behind it.
    let words = printed
        .split(|c: char| !c.is_ascii_hexdigit())
        .filter(|word| word.len() == 8);
    words
        .filter_map(|word| u32::from_str_radix(word, 16).ok())
        .collect()
}

#[test]
fn an_avr_computes_the_same_in_floats() {
    let Some(compiler) = tools("avr-gcc", "simavr") else {
        return;
    };
    let (mut count, mut finite) = (0, 0);
    for given in some() {
        let folder = machine::folder(&format!("avr_{}", given.name));
        let own: Sources =
            sources(&given.name, &given.unit, Real::Single).expect("it can be exported");
        machine::write(&folder, &own);
        let (program, expected) = for_avr(&given, &own.name);
        fs::write(folder.join("main.c"), program).expect("C can be written");
        let source = format!("{}.c", own.name);
        let flags = [
            "-mmcu=atmega2560",
            "-std=gnu99",
            "-Os",
            "-Wall",
            "-Wextra",
            "-Werror",
            "-ffunction-sections",
            "-Wl,--gc-sections",
        ];
        let tried = compiler.attempt(
            &folder,
            &[&flags[..], &["main.c", &source, "-o", "program", "-lm"]].concat(),
        );
        if let Err(messages) = tried {
            // Its memory is small.
            assert!(
                messages.contains("overflowed") || messages.contains("truncated"),
                "{messages}"
            );
            continue;
        }
        let words = simulated(&folder);
        assert_eq!(words.len(), 1 + expected.len(), "{}", given.name);
        assert_eq!(words[0], 0, "{} is assembled", given.name);
        for (bits, rust) in words[1..].iter().zip(&expected) {
            let c = f32::from_bits(*bits);
            assert!(
                *bits == rust.to_bits() || (c.is_nan() && rust.is_nan()),
                "{}: {c:e}, {rust:e} in Rust",
                given.name
            );
            finite += usize::from(c.is_finite());
            count += 1;
        }
    }
    println!("{count} numbers, {finite} finite");
    assert!(finite > 50, "{finite}");
}

/// In doubles the preprocessor says what helps, and says it first.
#[test]
fn an_avr_is_refused_in_doubles() {
    let Some(compiler) = tools("avr-gcc", "simavr") else {
        return;
    };
    let folder = machine::folder("avr_double");
    let given = page::press();
    machine::write(
        &folder,
        &sources(&given.name, &given.unit, Real::Double).expect("it can be exported"),
    );
    let refused = compiler.attempt(
        &folder,
        &[
            "-mmcu=atmega2560",
            "-std=c99",
            "-c",
            "press.c",
            "-o",
            "press.o",
        ],
    );
    let messages = refused.expect_err("a double has 24 digits");
    assert!(
        messages.contains("write it by linkage c --scalar float"),
        "{messages}"
    );
    assert!(!messages.contains("single_precision"), "{messages}");
}
