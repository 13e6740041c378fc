#!/usr/bin/env bash
# roots 0.0.8, Rust: the assemblies of a trammel whose point on the ellipse is held by a rod, as roots of a quartic.
#
# Behaviour: `find_roots_sturm` finds three of four real roots, and leaves out the largest one, because it searches
# beyond the last turning point of the polynomial only if that point is negative. `find_roots_eigen` returns two
# numbers that are no roots from the same list of coefficients: it reads the list from the constant on, where
# `find_roots_sturm` and `find_roots_quartic` read it from the highest power on. In the other order it finds all four.
# No error is returned. `find_roots_quartic` is right.
#
# A fair guess: all three functions find the four roots of the same polynomial, and the rod is closed for each of them.
#
# Source: the documentation of `find_roots_sturm` has x^n + a[0]*x^(n-1) + ... and promises all roots. The one of
# `find_roots_eigen` has the example x^3 - x, whose list reads the same in both orders. Issue 35 of the crate reports a
# missing root of a quartic, and request 26, which turns the order around, is merged and not in a release.
#
# Seen:
#   quartic: -1.3736 -0.5364 0.4623 1.5602, largest gap of the rod 0.0000
#   sturm: -1.3736 -0.5364 0.4623, largest gap of the rod 0.0000
#   eigen: -0.0469 1.2248, largest gap of the rod 1.5045
#   eigen, constant first: -1.3736 -0.5364 0.4623 1.5602, largest gap of the rod 0.0000
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
cargo init --quiet --vcs none --name check
cargo add --quiet roots@=0.0.8
cat >src/main.rs <<'CHECK'
use roots::{find_roots_eigen, find_roots_quartic, find_roots_sturm};

/// Semi-axes of the ellipse, pin of the rod, and length of the rod.
const WIDTH: f64 = 5.0;
const HEIGHT: f64 = 2.0;
const PIN: [f64; 2] = [0.5, 0.3];
const ROD: f64 = 3.0;

/// Coefficients of the square of a quadratic polynomial, highest power first.
fn square([a, b, c]: [f64; 3]) -> [f64; 5] {
    [a * a, 2.0 * a * b, b * b + 2.0 * a * c, 2.0 * b * c, c * c]
}

/// Error of the length of the rod where the half-angle of the trammel has the tangent `t`.
fn gap(t: f64) -> f64 {
    let [x, y] = [WIDTH * (1.0 - t * t) / (1.0 + t * t), HEIGHT * 2.0 * t / (1.0 + t * t)];
    ((x - PIN[0]).hypot(y - PIN[1]) - ROD).abs()
}

fn report(name: &str, mut roots: Vec<f64>, count: usize, closed: bool) {
    roots.sort_by(f64::total_cmp);
    let list: Vec<String> = roots.iter().map(|root| format!("{root:.4}")).collect();
    let largest = roots.iter().map(|&root| gap(root)).fold(0.0, f64::max);
    println!("{name}: {}, largest gap of the rod {largest:.4}", list.join(" "));
    assert_eq!(roots.len(), count);
    assert_eq!(largest < 1e-6, closed);
}

fn main() {
    let across = square([-WIDTH - PIN[0], 0.0, WIDTH - PIN[0]]);
    let upright = square([-PIN[1], 2.0 * HEIGHT, -PIN[1]]);
    let rod = square([ROD, 0.0, ROD]);
    let all: Vec<f64> = (0..5).map(|index| across[index] + upright[index] - rod[index]).collect();
    let normalized: Vec<f64> = all[1..].iter().map(|value| value / all[0]).collect();
    let reversed: Vec<f64> = normalized.iter().rev().copied().collect();

    let quartic = find_roots_quartic(all[0], all[1], all[2], all[3], all[4]);
    report("quartic", quartic.as_ref().to_vec(), 4, true);
    let sturm = find_roots_sturm(&normalized, &mut 1e-12);
    assert!(sturm.iter().all(Result::is_ok));
    report("sturm", sturm.into_iter().flatten().collect(), 3, true);
    report("eigen", find_roots_eigen(normalized).into(), 2, false);
    report("eigen, constant first", find_roots_eigen(reversed).into(), 4, true);
}
CHECK
CARGO_TARGET_DIR=${CARGO_TARGET_DIR:-$folder/target} cargo run --quiet
