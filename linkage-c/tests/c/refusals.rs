//! What assembling returns for dimensions that do not go, and how it is told.

use std::fs;
use std::process::Command;

use linkage_c::{Real, sources};

use crate::machine::{self, Compiler};
use linkage_corpus::given::Given;

const CRANK: &str = "
    pub struct CrankRocker {
        unit mm;
        param crank = 40mm;
        param coupler = 120mm;
        param rocker = 80mm;
        param frame = 100mm;
        input phi = 40deg in 0deg..360deg;
        unknown theta = 20deg;
        unknown psi = 60deg;
        loop polar(crank, phi) + polar(coupler, theta) = (frame, 0) + polar(rocker, psi);
    }
    impl CrankRocker {
        pub fn angle(phi) -> Angle { psi }
    }";

const MAIN: &str = r#"
#include "crank_rocker.h"
#include <math.h>
#include <stdio.h>

static void tell(const crank_rocker_dimensions *d)
{
    crank_rocker m;
    const int code = crank_rocker_assemble(&m, d);
    printf("%d|%s|%.9g\n", code, crank_rocker_error(code), (double)m.miss);
}

int main(void)
{
    const crank_rocker_dimensions defaults = CRANK_ROCKER_DEFAULTS;
    crank_rocker_dimensions d = defaults;
    tell(&d);
    d.coupler = 2;
    tell(&d);
    d.coupler = (REAL)NAN;
    tell(&d);
    d = defaults;
    d.frame = (REAL)1e30 * (REAL)LARGE;
    tell(&d);
    d = defaults;
    d.crank = 0;
    d.coupler = 0;
    d.rocker = 0;
    d.frame = 0;
    tell(&d);
    printf("%s\n%s\n", crank_rocker_error(-1), crank_rocker_error(1000));
    return CRANK_ROCKER_OK;
}
"#;

fn told(real: Real) -> Option<String> {
    let compiler = Compiler::find()?;
    let own = Given::text(CRANK);
    let folder = machine::folder(&format!("refusals_{}", real.name()));
    machine::write(
        &folder,
        &sources(&own.name, &own.unit, real).expect("it can be exported"),
    );
    let large = match real {
        Real::Double | Real::Fused => "1e200",
        Real::Single => "1",
    };
    let main = MAIN.replace("REAL", real.name()).replace("LARGE", large);
    fs::write(folder.join("main.c"), main).expect("C can be written");
    compiler.run(
        &folder,
        &[
            "-std=c99",
            "main.c",
            "crank_rocker.c",
            "-o",
            "program",
            "-lm",
        ],
    );
    let output = Command::new(folder.join("program"))
        .output()
        .expect("it runs");
    assert!(output.status.success());
    Some(String::from_utf8(output.stdout).expect("a text"))
}

fn told_as(real: Real, roundoff: f64, of_zeros: &str) {
    let Some(told) = told(real) else {
        return;
    };
    let lines: Vec<&str> = told.lines().collect();
    assert_eq!(lines[0], "0|CrankRocker: assembled|0");
    let parts: Vec<&str> = lines[1].split('|').collect();
    let place = "loop 1 (theta, psi; RRR) cannot close at the reference input: by how much it misses stands in `miss`, in mm";
    assert_eq!(parts[1], format!("CrankRocker: {place}"));
    // The coupler is too short between the rocker and where the pivot is seen from the pin.
    let angle = 40.0_f64.to_radians();
    let distance = f64::hypot(100.0 - 40.0 * angle.cos(), 40.0 * angle.sin());
    let miss: f64 = parts[2].parse().expect("a number");
    assert!((miss - (80.0 - 2.0 - distance)).abs() < roundoff, "{miss}");
    assert!(
        lines[2].ends_with("CrankRocker: the dimension coupler is no finite number|0"),
        "{}",
        lines[2]
    );
    assert!(
        lines[3].contains("CrankRocker: a dimension is too large to be computed with"),
        "{}",
        lines[3]
    );
    assert!(lines[4].contains(of_zeros), "{}", lines[4]);
    assert_eq!(lines[5], "CrankRocker: assembling returns no such number");
    assert_eq!(lines[5], lines[6]);
}

#[test]
fn refusals_of_doubles_say_what_and_by_how_much() {
    told_as(
        Real::Double,
        1e-6,
        "loop 1 (theta, psi; RRR) has no solution",
    );
}

#[test]
fn refusals_of_singles_say_what_and_by_how_much() {
    // What is zero but for the least normal double has no gap, and no angle either.
    told_as(Real::Single, 1e-4, "the turns of psi cannot be counted");
}
