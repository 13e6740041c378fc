//! C for processors with fused multiply-adds: sines by the table of generated Rust.

use std::fs;

use linkage_c::{Real, sources};
use linkage_core::Scalar;
use linkage_corpus::given::{Given, golden};
use linkage_corpus::reference::Assembled;
use linkage_random::Random;

use crate::machine::{self, Compiler, WARNINGS};
use crate::mechanisms::machine_has_fma;

/// A sine and a cosine of one angle.
const PAIR: &str = "
    pub struct Pair { unit mm; input phi = 1rad; }
    impl Pair { pub fn both(phi) -> Both { sine: sin(phi), cosine: cos(phi) } }";

/// Arguments for a compiler of this machine.
fn flags() -> Vec<&'static str> {
    let mut flags = vec!["-std=c99", "-O2", "-fno-math-errno", "-ffp-contract=fast"];
    if cfg!(target_arch = "x86_64") {
        flags.push("-mfma");
    }
    flags
}

/// Compiles a mechanism with a program that calls a function of one angle for each number at its input; what it writes.
fn results(name: &str, given: &Given, call: &str, angles: &[f64]) -> Option<Vec<f64>> {
    let compiler = Compiler::find()?;
    if !machine_has_fma() {
        println!("skipped: this machine has no fused multiply-add");
        return None;
    }
    let folder = machine::folder(name);
    let sources = sources(&given.name, &given.unit, Real::Fused).expect("it can be exported");
    machine::write(&folder, &sources);
    let (own, defaults) = (&sources.name, sources.name.to_uppercase() + "_DEFAULTS");
    let main = format!(
        "#include \"{own}.h\"\n#include <stdio.h>\nint main(void)\n{{\n    const {own}_dimensions d = {defaults};\n    {own} m;\n    double x;\n    \
         if ({own}_assemble(&m, &d) != 0) return 1;\n    while (fread(&x, sizeof x, 1, stdin) == 1) {{\n        \
         const {own}_{call}_result r = {own}_{call}(&m, x);\n        fwrite(&r, sizeof r, 1, stdout);\n    }}\n    return 0;\n}}\n"
    );
    fs::write(folder.join("main.c"), main).expect("a file");
    let file = format!("{own}.c");
    let files = ["main.c", &file, "-o", "main", "-lm"];
    compiler.run(&folder, &[&flags()[..], &files, &WARNINGS].concat());
    let input: Vec<u8> = angles.iter().flat_map(|x| x.to_ne_bytes()).collect();
    let output = machine::run(None, &folder.join("main"), &input);
    let (numbers, rest) = output.as_chunks();
    assert!(rest.is_empty(), "whole numbers");
    Some(numbers.iter().map(|x| f64::from_ne_bytes(*x)).collect())
}

#[test]
fn sines_are_those_of_single_calls() {
    let mut random = Random::new(52);
    let mut angles = vec![
        0.0,
        -0.0,
        f64::NAN,
        f64::INFINITY,
        f64::NEG_INFINITY,
        5e-324,
        -1e-300,
    ];
    let limit = 2.0_f64.powi(30);
    angles.extend([limit, -limit, limit.next_down(), -limit.next_down(), 1e300]);
    angles.extend((-300..300).map(|n| f64::from(n) * std::f64::consts::PI / 128.0));
    for size in [1e-8, 1.0, 10.0, 1e3, 1e5, 1e9] {
        angles.extend((0..2000).map(|_| random.between(-size, size)));
    }
    let Some(numbers) = results("fused_sines", &Given::text(PAIR), "both", &angles) else {
        return;
    };
    assert_eq!(numbers.len(), 2 * angles.len());
    for (x, c) in angles.iter().zip(numbers.chunks(2)) {
        let (sine, cosine) = x.sin_cos_shortest::<true, false>();
        for (c, rust) in c.iter().zip([sine, cosine]) {
            let same = c.to_bits() == rust.to_bits() || (c.is_nan() && rust.is_nan());
            assert!(same, "{x:e}: {c:e} in C, {rust:e} in Rust");
        }
    }
}

/// Roundings are others than those without fused multiply-adds, and results are near.
#[test]
fn results_are_near_those_of_other_files() {
    let text = include_str!("../../../linkage-compiler/tests/golden/crank_rocker.mech");
    let given = Given::text(text);
    let angles: Vec<f64> = (0..400).map(|n| 0.05 * f64::from(n)).collect();
    let Some(numbers) = results("fused_crank_rocker", &given, "path", &angles) else {
        return;
    };
    let dimensions: Vec<f64> = given.unit.scalars().map(|own| own.nominal).collect();
    let rust = Assembled::<f64>::new(&given.unit, &dimensions).expect("it is assembled");
    let path = given.unit.functions.iter().find(|own| own.name == "path");
    let path = path.expect("it has a path");
    let mut different = 0;
    for (x, c) in angles.iter().zip(numbers.chunks(2)) {
        for (c, rust) in c.iter().zip(rust.call(path, &[*x])) {
            assert!(
                (c - rust).abs() < 1e-12,
                "{x}: {c:e} in C, {rust:e} in Rust"
            );
            different += usize::from(*c != rust);
        }
    }
    assert!(different > 0, "multiply-adds are fused");
}

/// Nothing else differs: the mechanisms have the same names and comments. No compiler warns of the sources.
#[test]
fn headers_are_those_of_doubles() {
    let compiler = Compiler::find().filter(|_| machine_has_fma());
    let folder = machine::folder("fused_golden");
    for given in golden() {
        let of = |real| sources(&given.name, &given.unit, real).expect("it can be exported");
        let [double, fused] = [Real::Double, Real::Fused].map(of);
        assert_eq!(double.header, fused.header);
        assert_ne!(double.source, fused.source);
        if let Some(compiler) = &compiler {
            machine::write(&folder, &fused);
            let file = format!("{}.c", fused.name);
            compiler.run(&folder, &[&flags()[..], &["-c", &file], &WARNINGS].concat());
        }
    }
}

/// A processor without the instruction would call a function for each of them.
#[test]
fn other_processors_are_refused() {
    let Some(compiler) = Compiler::find() else {
        return;
    };
    if !cfg!(target_arch = "x86_64") {
        println!("skipped: this processor has fused multiply-adds");
        return;
    }
    let folder = machine::folder("fused_refused");
    let given = Given::text(PAIR);
    let sources = sources(&given.name, &given.unit, Real::Fused).expect("it can be exported");
    machine::write(&folder, &sources);
    let message = compiler.attempt(&folder, &["-std=c99", "-c", "pair.c"]);
    let message = message.expect_err("there is no such instruction");
    assert!(message.contains("export with --scalar double"), "{message}");
}
