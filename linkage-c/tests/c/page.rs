//! The programs of the page on C, and of the cookbook's recipe: compiled and run.

use std::f64::consts::PI;
use std::fs;
use std::path::Path;
use std::process::Command;

use linkage_c::{Real, column_sweeps, sources};

use crate::machine::{self, Compiler, WARNINGS};
use linkage_corpus::given::Given;

const PAGE: &str = include_str!("../../../docs/c.md");
const COOKBOOK: &str = include_str!("../../../docs/cookbook.md");

/// What calls the block of a PLC.
const CYCLES: &str = r#"
#include <stdio.h>
#include <string.h>
int main(void)
{
    static press_block_variables block;
    const double angles[] = { 0.5, 1.0 }, rods[] = { 150, 150, 160, 20, 5, 160 };
    int cycle;
    for (cycle = 0; cycle < 6; cycle++) {
        block.angle = angles[cycle % 2];
        block.speed = 10;
        block.rod = rods[cycle];
        press_block(&block);
        printf("%d %.12g %.12g %.12g\n", (int)block.error, block.ram, block.velocity, block.acceleration);
    }
    return 0;
}
"#;

/// The blocks of a page in a language, in order.
fn blocks(page: &'static str, language: &str) -> Vec<&'static str> {
    let fence = format!("```{language}\n");
    let parts = page.split(&fence).skip(1);
    let blocks = parts.map(|own| own.split("```").next().expect("a part before the end"));
    blocks.collect()
}

/// The mechanism of the page.
pub(crate) fn press() -> Given {
    Given::text(blocks(PAGE, "text")[0])
}

/// What a program prints that calls a mechanism called `Press`.
fn printed(name: &str, own: &Given, program: &str, real: Real) -> Option<String> {
    let compiler = Compiler::find()?;
    let folder = machine::folder(name);
    machine::write(
        &folder,
        &sources(&own.name, &own.unit, real).expect("it can be exported"),
    );
    Some(run(&compiler, &folder, program, "press.c"))
}

/// What a program prints that is compiled with a source of its folder.
fn run(compiler: &Compiler, folder: &Path, program: &str, source: &str) -> String {
    fs::write(folder.join("main.c"), program).expect("C can be written");
    let mut arguments = vec!["-std=c99", "-O2", "main.c", source, "-o", "main", "-lm"];
    arguments.extend(WARNINGS);
    compiler.run(folder, &arguments);
    let output = Command::new(folder.join("main")).output();
    let output = output.expect("the program runs");
    assert!(output.status.success());
    String::from_utf8(output.stdout).expect("a text")
}

/// Crank and offset of the page's press.
const CRANK: f64 = 40.0;
const OFFSET: f64 = 10.0;

/// Position, first and second derivative of the ram by the crank's angle.
fn ram(rod: f64, phi: f64) -> [f64; 3] {
    let (sin, cos) = phi.sin_cos();
    let height = OFFSET - CRANK * sin;
    let along = (rod * rod - height * height).sqrt();
    // along^2 = rod^2 - height^2, twice differentiated.
    let slope = -height * (-CRANK * cos) / along;
    let bend = (-(CRANK * cos).powi(2) - height * CRANK * sin - slope * slope) / along;
    [
        CRANK * cos + along,
        -CRANK * sin + slope,
        -CRANK * cos + bend,
    ]
}

#[test]
fn the_control_loop_prints_what_the_page_says() {
    let Some(printed) = printed("page_loop", &press(), blocks(PAGE, "c")[0], Real::Single) else {
        return;
    };
    assert_eq!(printed, blocks(PAGE, "text")[1]);
    for (tick, line) in printed.lines().enumerate() {
        let time = 1e-3 * tick as f64;
        let [_, v, a] = ram(150.02, 0.5 + 200.0 * time * time);
        let acceleration = a * (400.0 * time).powi(2) + v * 400.0;
        let torque = 12.0 * acceleration * v * 1e-6;
        let own: f64 = line.parse().expect("a number");
        assert!((own - torque).abs() < 0.0006, "{own} N m, by hand {torque}");
    }
}

#[test]
fn the_check_of_a_range_finds_what_the_page_says() {
    let program = blocks(PAGE, "c")[1];
    let Some(printed) = printed("page_range", &press(), program, Real::Single) else {
        return;
    };
    assert_eq!(printed, blocks(PAGE, "text")[2]);
    // The crank's pin is farther from the guide than the rod is long, by 5 mm at worst.
    let end = PI + f64::asin((45.0 - OFFSET) / CRANK);
    let expected = format!("3: {:.2} to {:.2} rad, 5.0 mm\n", end, 3.0 * PI - end);
    assert_eq!(printed, expected);
}

#[test]
fn columns_have_the_rams_positions() {
    let Some(compiler) = Compiler::find() else {
        return;
    };
    let folder = machine::folder("page_columns");
    let own = press();
    let sweeps = column_sweeps(&own.name, &own.unit, Real::Double).expect("it can be exported");
    machine::write_columns(&folder, &sweeps);
    let printed = run(&compiler, &folder, blocks(PAGE, "c")[3], "press_columns.c");
    let [expected, ..] = ram(150.0, PI / 2.0);
    assert_eq!(printed, format!("{expected:.3} mm at 90 degrees\n"));
}

#[test]
fn the_block_of_a_plc_follows_its_variables() {
    let program = blocks(PAGE, "c")[2].to_owned() + CYCLES;
    let Some(printed) = printed("page_block", &press(), &program, Real::Double) else {
        return;
    };
    let lines: Vec<Vec<f64>> = printed
        .lines()
        .map(|line| {
            line.split(' ')
                .map(|word| word.parse().expect("a number"))
                .collect()
        })
        .collect();
    // The number is that of an error, of which only the sign is known here.
    let expected = [
        (150.0, 0.5, 0.0),
        (150.0, 1.0, 0.0),
        (160.0, 0.5, 0.0),
        (20.0, 1.0, -1.0),
        (5.0, 0.5, 1.0),
        (160.0, 1.0, 0.0),
    ];
    assert_eq!(lines.len(), expected.len());
    for (line, (rod, phi, error)) in lines.iter().zip(expected) {
        assert_eq!(f64::clamp(line[0], -1.0, 1.0), error, "rod {rod}: {line:?}");
        if error != 0.0 {
            continue;
        }
        let [s, v, a] = ram(rod, phi);
        for (own, by_hand) in line[1..].iter().zip([s, 10.0 * v, 100.0 * a]) {
            assert!(
                (own - by_hand).abs() < 1e-9 * by_hand.abs(),
                "{own}, by hand {by_hand}"
            );
        }
    }
}

#[test]
fn the_recipe_of_the_cookbook_prints_a_table() {
    let [declared] = blocks(COOKBOOK, "text")[..] else {
        panic!("the cookbook has one mechanism for C");
    };
    let program = blocks(COOKBOOK, "c")[0];
    let own = Given::text(declared);
    let Some(printed) = printed("cookbook", &own, program, Real::Double) else {
        return;
    };
    // In line, square, folded: 120 + 40, the root of 120^2 - 40^2, 120 - 40; square, the slide is as fast as the crank's pin.
    let expected = [
        [0.0, 160.0, 0.0],
        [90.0, 113.137, -40.0],
        [180.0, 80.0, 0.0],
    ];
    let lines: Vec<&str> = printed.lines().collect();
    assert_eq!(lines.len(), expected.len());
    for (line, expected) in lines.into_iter().zip(expected) {
        let cells = line
            .split(' ')
            .map(|cell| cell.parse::<f64>().expect("a number"));
        assert_eq!(cells.collect::<Vec<_>>(), expected);
    }
}

#[test]
fn the_recipe_of_the_cookbook_runs_from_python() {
    let Some(compiler) = Compiler::find() else {
        return;
    };
    if Compiler::named("python3").is_none() {
        println!("skipped: there is no `python3`");
        return;
    }
    let folder = machine::folder("cookbook_python");
    let press = Given::text(blocks(COOKBOOK, "text")[0]);
    machine::write(
        &folder,
        &sources(&press.name, &press.unit, Real::Double).expect("it can be exported"),
    );
    let program = blocks(COOKBOOK, "python")
        .into_iter()
        .find(|program| program.contains("ctypes"))
        .expect("a program that loads a library");
    fs::write(folder.join("main.py"), program).expect("Python can be written");
    let command = "-std=c99 -O2 -shared -fPIC press.c -o libpress.so -lm";
    assert!(COOKBOOK.contains(command), "the page has another command");
    let mut arguments: Vec<&str> = command.split(' ').collect();
    arguments.extend(WARNINGS);
    compiler.run(&folder, &arguments);
    let output = Command::new("python3")
        .current_dir(&folder)
        .arg("main.py")
        .output()
        .expect("Python runs");
    let errors = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{errors}");
    let printed = String::from_utf8(output.stdout).expect("a text");
    let lines: Vec<&str> = printed.lines().collect();
    let [dead, square, folded, error] = lines[..] else {
        panic!("three rows and an error: {printed}");
    };
    // In line, square, folded: 125 + 40, the root of 125^2 - 40^2, 125 - 40; square, the slide is as fast as the crank's pin.
    let expected = [[165.0, 0.0], [118.427, -40.0], [85.0, 0.0]];
    for (line, expected) in [dead, square, folded].into_iter().zip(expected) {
        let cells = line
            .split(' ')
            .map(|cell| cell.parse::<f64>().expect("a number"));
        assert_eq!(cells.collect::<Vec<_>>(), expected);
    }
    assert!(error.contains("cannot close"), "{error}");
}
