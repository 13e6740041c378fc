//! The check of the range in C, on random four-bars: what their lengths say. Rates at change points.

use std::f64::consts::PI;
use std::fmt::Write;
use std::fs;
use std::path::{Path, PathBuf};

use linkage_c::{Real, sources};
use linkage_corpus::given::{FOUR_BAR, Given};
use linkage_random::four_bar::{Limit, lengths, limits};
use linkage_random::{Random, one_in};

use crate::machine::{self, Compiler, WARNINGS};

/// Reads four lengths from each line; prints what assembling returns, how many findings there are, and those that fit; then the motion at half a
/// turn.
const MAIN: &str = r#"
#include "four_bar.h"
#include <stdio.h>

int main(void)
{
    double a, b, c, d;
    while (scanf("%lf %lf %lf %lf", &a, &b, &c, &d) == 4) {
        four_bar m;
        four_bar_range_finding found[3];
        four_bar_dimensions own = FOUR_BAR_DEFAULTS;
        four_bar_motion_result at;
        int code, k, count = 0;
        own.crank = (REAL)a;
        own.coupler = (REAL)b;
        own.rocker = (REAL)c;
        own.frame = (REAL)d;
        code = four_bar_assemble(&m, &own);
        if (code == FOUR_BAR_OK) count = four_bar_check_range(&m, found, 3);
        printf("%d %d", code, count);
        for (k = 0; k < count && k < 3; k++) {
            printf(" %d %d %.17g %.17g %.17g", found[k].kind, found[k].group, (double)found[k].from, (double)found[k].to,
                (double)found[k].miss);
        }
        at = four_bar_motion(&m, (REAL)3.141592653589793);
        printf("\n%d %d %d\n", at.psi == at.psi, at.v - at.v == 0 || at.v != at.v, at.v == at.v && at.a == at.a);
    }
    return 0;
}
"#;

/// Kind, begin and end.
type Finding = (Limit, f64, f64);

/// The kind of a finding by its number in C.
fn limit(kind: f64) -> Limit {
    match kind as i32 {
        1 => Limit::ChangePoint,
        2 => Limit::DeadPoint,
        3 => Limit::Gap,
        other => panic!("no kind of finding here has the number {other}"),
    }
}

/// The program that was made of the C.
fn program(compiler: &Compiler, real: Real, test: &str) -> PathBuf {
    let own = Given::text(FOUR_BAR);
    let folder = machine::folder(&format!("ranges_{test}_{}", real.name()));
    let c = sources(&own.name, &own.unit, real).expect("it can be exported");
    machine::write(&folder, &c);
    fs::write(folder.join("main.c"), MAIN.replace("REAL", real.name())).expect("C can be written");
    let options = ["-std=c99", "-O1", "-ffp-contract=off"];
    let warned = ["-c", "four_bar.c", "-o", "four_bar.o"];
    compiler.run(&folder, &[&options[..], &WARNINGS, &warned].concat());
    let linked = ["main.c", "four_bar.o", "-o", "program", "-lm"];
    compiler.run(&folder, &[&options[..], &linked].concat());
    // Who does not need it can leave it out.
    let without = [
        "-DFOUR_BAR_WITHOUT_RANGE_CHECK",
        "-c",
        "four_bar.c",
        "-o",
        "without.o",
    ];
    compiler.run(&folder, &[&options[..], &WARNINGS, &without].concat());
    folder.join("program")
}

/// For each line: what assembling returns, the findings in order, and what is printed of the motion.
fn found(program: &Path, cases: &[[f64; 4]]) -> Vec<(i32, Vec<Finding>, String)> {
    let mut input = String::new();
    for own in cases {
        let _ = writeln!(input, "{:?} {:?} {:?} {:?}", own[0], own[1], own[2], own[3]);
    }
    let output = String::from_utf8(machine::run(None, program, input.as_bytes())).expect("text");
    let lines: Vec<&str> = output.lines().collect();
    assert_eq!(lines.len(), 2 * cases.len());
    let one = |pair: &[&str]| {
        let words: Vec<f64> = pair[0]
            .split(' ')
            .map(|own| own.parse().expect("a number"))
            .collect();
        assert_eq!((words.len() - 2) / 5, words[1] as usize, "{}", pair[0]);
        let mut all: Vec<Finding> = Vec::new();
        for own in words[2..].chunks(5) {
            assert!(
                own[1] == 0.0 && (own[4] > 0.0) == (limit(own[0]) != Limit::ChangePoint),
                "{}",
                pair[0]
            );
            all.push((limit(own[0]), own[2], own[3]));
        }
        all.sort_by(|a, b| a.1.total_cmp(&b.1));
        (words[0] as i32, all, pair[1].to_owned())
    };
    lines.chunks(2).map(one).collect()
}

#[test]
fn random_four_bars_have_what_their_lengths_say() {
    let Some(compiler) = Compiler::find() else {
        return;
    };
    let program = program(&compiler, Real::Double, "lengths");
    let mut random = Random::new(11);
    let cases = (0..20_000).map(|round| lengths(&mut random, round));
    // Of each kind of lengths.
    let cases: Vec<[f64; 4]> = one_in(19, cases).collect();
    let count = cases.len();
    let mut kinds = [0; 4];
    for (own, (code, found, _)) in cases.iter().zip(found(&program, &cases)) {
        let Some(expected) = limits(*own).filter(|_| code == 0 && own.iter().all(|x| *x > 5.0))
        else {
            continue;
        };
        kinds[0] += usize::from(expected.is_empty());
        expected
            .iter()
            .for_each(|own| kinds[1 + own.0 as usize] += 1);
        let near = |(a, b): (&Finding, &Finding)| {
            a.0 == b.0 && (a.1 - b.1).abs() < 2e-7 && (a.2 - b.2).abs() < 2e-7
        };
        let alike = found.len() == expected.len() && found.iter().zip(&expected).all(near);
        assert!(alike, "{own:?}: {found:?}, not {expected:?}");
    }
    assert!(kinds.iter().all(|own| *own > count / 40), "{kinds:?}");
}

#[test]
fn singles_find_change_points_to_their_digits() {
    let Some(compiler) = Compiler::find() else {
        return;
    };
    let program = program(&compiler, Real::Single, "singles");
    let cases = [
        [50.0, 140.0, 50.0, 140.0],
        [60.0, 120.0, 80.0, 140.0],
        [50.0, 120.0, 100.0, 140.0],
        [61.0, 120.0, 80.0, 140.0],
        [59.9, 120.0, 80.0, 140.0],
    ];
    let found = found(&program, &cases);
    let kinds = |k: usize| -> Vec<Limit> { found[k].1.iter().map(|own| own.0).collect() };
    assert_eq!(kinds(0), [Limit::ChangePoint; 3]);
    assert_eq!(kinds(1), [Limit::ChangePoint]);
    assert!((found[1].1[0].1 - PI).abs() < 1e-3);
    assert!(kinds(2).is_empty() && kinds(4).is_empty());
    assert_eq!(kinds(3), [Limit::Gap]);
}

/// Rates are no numbers, and not infinite, where the position is: the limits from both sides are finite.
#[test]
fn rates_are_no_numbers_at_a_change_point() {
    let Some(compiler) = Compiler::find() else {
        return;
    };
    for real in [Real::Double, Real::Single] {
        let program = program(&compiler, real, "rates");
        let cases = [
            [50.0, 140.0, 50.0, 140.0],
            [60.0, 120.0, 80.0, 140.0],
            [50.0, 50.0, 140.0, 140.0],
        ];
        let all = found(&program, &cases);
        // A position, a rate that is finite or none; in double, neither rate is a number.
        for (_, _, motion) in &all {
            assert!(motion.starts_with("1 1 "), "{motion}");
        }
        if real == Real::Double {
            assert!(all.iter().all(|own| own.2 == "1 1 0"), "{all:?}");
        }
    }
}
