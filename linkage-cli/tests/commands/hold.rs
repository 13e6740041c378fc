//! `linkage hold` against statics of a lever.

use std::f64::consts::PI;
use std::fs;
use std::path::{Path, PathBuf};

use crate::{folder, linkage, printed, refused};

const LEVER: &str = "
    pub struct Lever {
        unit mm;
        param arm = 200mm;
        param rate = 3000N*mm;
        param free = 90deg;
        param mass = 2kg;
        argument load = 50N;
        input phi = 30deg in 0deg..80deg at omega;
        let end = polar(arm, phi);
        gravity = (0, -10m/s^2);
        body lever = pin p on frame at (0, 0), turns phi, mass mass at end / 2;
        spring rate on p, free free;
        force (0, -load) on lever at end;
    }
    impl Lever {
        pub fn statics(phi, load) -> Statics { t: torque(phi), p: reaction(p), end }
        pub fn motion(phi, omega, load) -> Motion { p: reaction(p), e: kinetic_energy() }
    }
    /// A link between a slide and a lever.
    pub struct Toggle {
        unit mm;
        param rod = 50mm;
        argument push = 10N;
        input x = 70mm in 60mm..80mm;
        unknown psi = 45deg;
        loop distance((x, 0), polar(40mm, psi)) = rod;
    }
    impl Toggle {
        pub fn reach() -> Reach { r: 2 * rod }
        pub fn stroke(x, push) -> Stroke { f: push * velocity(psi) * rod }
    }
";

/// A folder with the lever.
fn lever(name: &str) -> PathBuf {
    let folder = folder(name);
    fs::write(folder.join("lever.mech"), LEVER).expect("it can be written");
    folder
}

/// The number in `NAME = NUMBER UNIT`.
#[track_caller]
fn expect(folder: &Path, arguments: &[&str], name: &str, value: f64, unit: &str) {
    let text = printed(folder, &[&["hold", "lever.mech"], arguments].concat());
    let words: Vec<&str> = text.split_whitespace().collect();
    let [found_name, "=", number, found_unit] = words[..] else {
        panic!("{text}");
    };
    assert_eq!([found_name, found_unit], [name, unit], "{text}");
    let number: f64 = number.parse().expect("a number");
    assert!(
        (number - value).abs() < 2e-12 * value.abs().max(1.0),
        "{text}: {value}"
    );
}

#[test]
fn loads_rates_and_masses_that_hold() {
    let folder = lever("hold");
    let cos = |degrees: f64| (degrees * PI / 180.0).cos();
    // Moments about the pin: 20 N at half of the arm, the load at its end, the spring upwards.
    let turn = |degrees: f64| (90.0 - degrees) * PI / 180.0;
    let load = 3000.0 * turn(30.0) / (200.0 * cos(30.0)) - 10.0;
    expect(
        &folder,
        &["statics", "t=0N*mm", "--by", "load"],
        "load",
        load,
        "N",
    );
    let rate = 200.0 * cos(20.0) * (10.0 + 50.0) / turn(20.0);
    let at = ["statics", "t = 0N*m", "--by", "rate", "--at", "phi=20deg"];
    expect(&folder, &at, "rate", rate, "N*mm");
    let rate = (200.0 * cos(30.0) * (10.0 + 40.0) - 1500.0) / turn(30.0);
    let at = ["statics", "t=1.5N*m", "--by", "rate", "--at", "load=40N"];
    expect(&folder, &at, "rate", rate, "N*mm");
    let mass = (3000.0 * turn(30.0) / (300.0 * cos(30.0)) - 50.0) / 5.0;
    let at = ["statics", "t=0N*mm", "--by", "mass", "--set", "arm=300mm"];
    expect(&folder, &at, "mass", mass, "kg");
    // The pin carries load and weight.
    expect(
        &folder,
        &["statics", "p.y=120N", "--by", "load"],
        "load",
        100.0,
        "N",
    );
    expect(
        &folder,
        &["statics", "p.y=120N", "--by", "mass"],
        "mass",
        7.0,
        "kg",
    );
}

#[test]
fn what_cannot_be_solved_is_refused() {
    let folder = lever("hold_refused");
    for (arguments, expected) in [
        (
            &["statics", "p.x=1N", "--by", "load"][..],
            "error: `load` does not change `p.x`\n",
        ),
        (
            &["stroke", "f=100N", "--by", "rod"],
            "error: `f` is not linear in `rod`\nhelp: name a load, a spring rate or a mass after `--by`; `linkage table` shows `f` for others\n",
        ),
        (
            &["stroke", "f=100N", "--by", "push", "--at", "x=91mm"],
            "note: `x = 91 mm` is outside of its range 60 mm .. 80 mm\n\
             error: `f` is no number at `x = 91 mm`: loop 1 (`psi`) misses by 1 mm\n",
        ),
        (
            &["reach", "r=400mm", "--by", "rod"],
            "error: `rod = 200 mm` is needed, but with it Toggle: loop 1 (psi; RRR) cannot close at the reference input: it misses by 90 mm\n",
        ),
        (
            &["statics", "t=0N*mm", "--by", "phi"],
            "error: `t` is not linear in `phi`\nhelp: name a load, a spring rate or a mass after `--by`; `linkage table` shows `t` for others\n",
        ),
        (
            &["motion", "e=1J", "--by", "omega"],
            "error: `e` is not linear in `omega`\nhelp: name a load, a spring rate or a mass after `--by`; `linkage table` shows `e` for others\n",
        ),
        (
            &["motion", "p.x=1N", "--by", "load"],
            "error: `motion` cannot be evaluated: it takes `omega`, too, which is given by `--at omega=VALUE`\n",
        ),
        (
            &["statics", "p=1N", "--by", "load"],
            "error: `statics` has no result `p`; it has `t`, `p.x`, `p.y`, `end.x` and `end.y`\n",
        ),
        (
            &["statics", "t=1N", "--by", "load"],
            "error: `t=1N`: this is in N, `t` is in N*mm\n",
        ),
        (
            &["statics", "t=0N*mm", "--by", "weight"],
            "error: `weight` is no argument of `statics` and no dimension of Lever; there is `phi`, `load`, `arm`, `rate`, `free` and `mass`\n",
        ),
        (
            &["statics", "t=0N*mm", "--by", "omega"],
            "error: `statics` does not depend on `omega`, which it does not take\nhelp: `omega` is an argument of `motion`\n",
        ),
        (
            &["statics", "t=0mm", "--by", "load"],
            "error: `t=0mm`: this is in mm, `t` is in N*mm\n",
        ),
        (
            &["statics", "t=0N*mm", "--by", "load", "--at", "load=1N"],
            "error: `load` is sought and cannot be given by `--at`, too\n",
        ),
        (
            &["statics", "t", "--by", "load"],
            "error: `statics t`: write `statics NAME=VALUE`\n",
        ),
    ] {
        let arguments = [&["hold", "lever.mech"], arguments].concat();
        assert_eq!(refused(&folder, &arguments, 1), expected, "{arguments:?}");
    }
}

#[test]
fn positions_outside_of_the_range_are_named() {
    let folder = lever("hold_outside");
    let said = |phi: &str| {
        let given = format!("phi={phi}");
        let arguments = ["statics", "t=0", "--by", "load", "--at", &given];
        let output = linkage(&folder, &[&["hold", "lever.mech"], &arguments[..]].concat());
        assert!(output.status.success());
        String::from_utf8(output.stderr).expect("a text")
    };
    assert_eq!(
        said("85deg"),
        "note: `phi = 85 deg` is outside of its range 0 deg .. 80 deg\n"
    );
    assert_eq!(said("80deg"), "");
}
