//! The program as its user meets it: what it prints, which files it leaves, its exit status.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

use linkage_cli::Source;

/// A folder of its own for each test, empty.
fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).expect("a folder can be made");
    folder
}

fn linkage(folder: &Path, arguments: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_linkage"));
    command.current_dir(folder).args(arguments);
    command.output().expect("it runs")
}

/// What it prints, if it ends with success and says nothing else.
fn printed(folder: &Path, arguments: &[&str]) -> String {
    let output = linkage(folder, arguments);
    let said = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success() && said.is_empty(), "{said}");
    String::from_utf8(output.stdout).expect("text")
}

/// What it says where it ends with this status and prints nothing.
fn refused(folder: &Path, arguments: &[&str], status: i32) -> String {
    let output = linkage(folder, arguments);
    let said = String::from_utf8(output.stderr).expect("text");
    assert_eq!(output.status.code(), Some(status), "{arguments:?}: {said}");
    assert!(output.stdout.is_empty(), "{arguments:?}");
    said
}

fn favorit() -> &'static str {
    concat!(env!("CARGO_MANIFEST_DIR"), "/../examples/favorit.rs")
}

#[test]
fn the_mechanism_to_start_from_has_everything() {
    let folder = folder("start");
    printed(&folder, &["new", "own.mech"]);
    let again = refused(&folder, &["new", "own.mech"], 1);
    assert!(
        again.starts_with("error: cannot write `own.mech`: "),
        "{again}"
    );
    let known = printed(&folder, &["check", "own.mech"]);
    for line in [
        "SliderCrank: mobility 1",
        "1      RRP   2      2      0     1      theta, slide  ",
        "input phi = 30 deg, in 0 deg .. 360 deg",
        "assemblies at the reference: 2",
    ] {
        assert!(known.contains(line), "{line} in {known}");
    }
    let all = printed(&folder, &["assemblies", "own.mech", "--at", "phi=90deg"]);
    assert_eq!(
        all,
        "SliderCrank at phi = 90 deg: 2 assemblies\n\
         1  modes -: theta = -16.9578deg, slide = 114.782mm\n\
         2  modes +: theta = -163.042deg, slide = -114.782mm\n"
    );
    let circuits = printed(&folder, &["circuits", "own.mech"]);
    assert_eq!(
        circuits.matches("360 deg (closed)").count(),
        2,
        "{circuits}"
    );
}

#[test]
fn tables_are_for_spreadsheets_and_programs() {
    let folder = folder("tables");
    printed(&folder, &["new", "own.mech"]);
    let german = [
        "table",
        "own.mech",
        "stroke",
        "--from",
        "-90deg",
        "--to",
        "90deg",
        "--steps",
        "3",
        "--degrees",
        "--digits",
        "6",
        "--separator",
        ";",
        "--decimal",
        ",",
        "--set",
        "offset=0mm",
        "--set",
        "crank = 30mm + 1cm",
    ];
    let table = printed(&folder, &german);
    // At the top and the bottom of the crank the slider stands at sqrt(120^2 - 40^2).
    let lines: Vec<&str> = table.split("\r\n").collect();
    assert_eq!(lines[0], "phi [deg];slide [mm];v [mm/rad];a [mm/rad^2]");
    assert!(
        lines[1].starts_with("-90,0000;113,137;40,0000;14,1421"),
        "{table}"
    );
    assert!(lines[2].starts_with("0,00000;160,000;"), "{table}");
    assert!(lines[3].starts_with("90,0000;113,137;-40,0000;"), "{table}");
    assert_eq!(&lines[4..], [""]);

    // Both forms have every digit.
    let options = ["table", "own.mech", "stroke", "--steps", "25"];
    let lines = printed(&folder, &options);
    let json = printed(&folder, &[&options[..], &["--json"]].concat());
    let json: serde_json::Value = serde_json::from_str(&json).expect("JSON");
    assert_eq!(json["mechanism"], "SliderCrank");
    let columns = json["columns"].as_array().expect("columns");
    for (row, line) in lines.lines().skip(1).enumerate() {
        for (cell, column) in line.split(',').zip(columns) {
            let number = column["values"][row].as_f64().expect("a number");
            assert_eq!(
                cell.parse::<f64>().expect("a number").to_bits(),
                number.to_bits()
            );
        }
    }
    assert_eq!(columns[3]["name"], "a");
    assert_eq!(columns[3]["unit"], "mm/rad^2");
}

#[test]
fn gaps_are_empty_cells_and_are_told() {
    let folder = folder("gaps");
    printed(&folder, &["new", "own.mech"]);
    let short = [
        "table", "own.mech", "stroke", "--steps", "5", "--set", "rod=38mm",
    ];
    let output = linkage(&folder, &short);
    assert!(output.status.success());
    let said = String::from_utf8_lossy(&output.stderr);
    assert!(
        said.starts_with("note: at 1 of 5 positions a number is missing"),
        "{said}"
    );
    let text = String::from_utf8_lossy(&output.stdout);
    assert!(text.contains("\r\n4.71238898038469,,,\r\n"), "{text}");
    let output = linkage(&folder, &[&short[..], &["--json"]].concat());
    let json: serde_json::Value = serde_json::from_slice(&output.stdout).expect("JSON");
    assert!(json["columns"][1]["values"][3].is_null());
}

#[test]
fn bad_input_is_told_in_one_message() {
    let folder = folder("bad");
    printed(&folder, &["new", "own.mech"]);
    let table = |more: &[&str]| {
        let all = [&["table", "own.mech", "stroke"], more].concat();
        refused(&folder, &all, 1)
    };
    for (said, expected) in [
        (
            refused(&folder, &["check", "none.mech"], 1),
            "error: cannot read `none.mech`: ",
        ),
        (
            refused(&folder, &["table", "own.mech", "strike"], 1),
            "error: there is no function `strike` in `own.mech`; there is `stroke`, `accuracy` and `shape`\n",
        ),
        (
            table(&["--set", "crank=300mm"]),
            "error: SliderCrank: loop 1 (theta, slide; RRP) cannot close at the reference input: it misses by 25 mm\n",
        ),
        (
            table(&["--set", "crnak=30mm"]),
            "error: there is no dimension `crnak` in SliderCrank; there is `crank`, `rod` and `offset`\n",
        ),
        (
            table(&["--set", "crank=30"]),
            "error: `crank=30`: this is a number, `crank` is in mm\n",
        ),
        (
            table(&["--set", "crank=30deg"]),
            "error: `crank=30deg`: this is an angle, `30deg`, `crank` is in mm\n",
        ),
        (
            table(&["--set", "crank=(30mm, 2mm)"]),
            "error: `crank=(30mm, 2mm)`: this is a vector of 2 numbers, `crank` is one number\n",
        ),
        (
            table(&["--set", "crank=30mn"]),
            "error: `crank=30mn`: unknown unit `mn`",
        ),
        (
            table(&["--from", "5mm"]),
            "error: `phi=5mm`: this is in mm, `phi` is an angle, `30deg`\n",
        ),
        (
            table(&["--at", "omega=3"]),
            "error: `stroke` does not take `omega`; it takes `phi`\n",
        ),
        (
            table(&["--over", "psi"]),
            "error: `stroke` has no input `psi`; it has `phi`\n",
        ),
        (
            table(&["--mechanism", "Crank"]),
            "error: there is no mechanism `Crank` in `own.mech`; there is `SliderCrank`\n",
        ),
        (
            table(&["-o", "none/own.csv"]),
            "error: cannot write `none/own.csv`: ",
        ),
        (
            refused(&folder, &["tolerance", "own.mech", "stroke"], 1),
            "error: `stroke` has no sensitivities: ",
        ),
        (
            refused(&folder, &["page", "own.mech", "-o", "own.mech/page"], 1),
            "error: cannot write own.mech/page: ",
        ),
    ] {
        assert!(said.starts_with(expected), "{said}");
        let messages = said.lines().filter(|line| line.starts_with("error"));
        assert_eq!(messages.count(), 1, "{said}");
    }
    // Nothing was written, whole or half.
    let left = fs::read_dir(&folder).expect("the folder is there").count();
    assert_eq!(left, 1);
}

#[test]
fn wrong_usage_has_a_status_of_its_own() {
    let folder = folder("usage");
    printed(&folder, &["new", "own.mech"]);
    for arguments in [
        &["tabel", "own.mech"][..],
        &["table"],
        &["table", "own.mech", "stroke", "--steps", "many"],
        &["table", "own.mech", "stroke", "--steps", "0"],
        &["table", "own.mech", "stroke", "--decimal", ","],
        &["table", "own.mech", "stroke", "--digits", "0"],
        &["check"],
    ] {
        let said = refused(&folder, arguments, 2);
        assert!(said.starts_with("error: "), "{said}");
    }
}

#[test]
fn a_file_is_replaced_as_a_whole() {
    let folder = folder("whole");
    printed(&folder, &["new", "own.mech"]);
    let into = |steps| {
        printed(
            &folder,
            &[
                "table", "own.mech", "stroke", "--steps", steps, "-o", "t.csv",
            ],
        )
    };
    assert_eq!(into("3") + &into("2"), "");
    let text = fs::read_to_string(folder.join("t.csv")).expect("a file");
    assert_eq!(text.lines().count(), 3);
    assert_eq!(
        fs::read_dir(&folder).expect("the folder is there").count(),
        2
    );
}

#[test]
fn tolerances_add_up() {
    let folder = folder("tolerances");
    printed(&folder, &["new", "own.mech"]);
    // In line with the guide crank and rod count fully, and the offset not at all.
    let line = [
        "--set",
        "offset=0mm",
        "--from",
        "0deg",
        "--to",
        "180deg",
        "--steps",
        "3",
    ];
    let all = [&["tolerance", "own.mech", "accuracy"], &line[..]].concat();
    let text = printed(&folder, &all);
    assert!(text.starts_with("e [mm]\nphi [deg]  worst case"), "{text}");
    let row: Vec<f64> = text
        .lines()
        .nth(2)
        .into_iter()
        .flat_map(|line| line.split_whitespace())
        .map(|cell| cell.parse().expect("a number"))
        .collect();
    assert_eq!(row, [0.0, 0.03, 0.022_360_7, 0.01, 0.02, 0.0]);
    let (_, worst) = text
        .split_once("worst at phi = ")
        .expect("the worst position");
    for name in ["worst case", "root sum square", "crank", "rod", "offset"] {
        assert!(worst.contains(&format!("\n{name} ")), "{text}");
    }
    assert_eq!(worst.matches(" %").count(), 6, "{text}");
}

#[test]
fn a_page_has_all_functions() {
    let folder = folder("page");
    // The hook-needle drive as a text file.
    let source = Source::read(Path::new(favorit())).expect("the example");
    let tokens: Vec<_> = source.mechanisms()[0].tokens.clone().into_iter().collect();
    let [first, last] = [&tokens[0], &tokens[tokens.len() - 1]].map(|own| own.span().byte_range());
    let text = &source.text()[first.start..last.end];
    fs::write(folder.join("favorit.mech"), text).expect("it can be written");
    printed(&folder, &["page", "favorit.mech"]);
    let page = folder.join("favorit_page");
    let data = fs::read_to_string(page.join("data.json")).expect("data");
    let data: serde_json::Value = serde_json::from_str(&data).expect("JSON");
    assert_eq!(data["title"], "Favorit");
    for name in ["needle", "height", "transmission", "picture", "motion"] {
        let lines = fs::read_to_string(page.join(name).with_extension("csv")).expect("a table");
        assert_eq!(lines.lines().count(), 362, "{name}");
    }
    let html = fs::read_to_string(page.join("index.html")).expect("a page");
    assert!(html.contains("<title>Favorit</title>") && !html.contains("follow("));
    assert!(page.join("drawing.svg").is_file() && !page.join("version.js").exists());
}

/// The best of some tries: others use the machine, too.
fn shortest(folder: &Path, arguments: &[&str]) -> Duration {
    let once = || {
        let start = Instant::now();
        printed(folder, arguments);
        start.elapsed()
    };
    (0..5).map(|_| once()).min().expect("some tries")
}

#[test]
fn nobody_waits_for_a_table_or_a_page() {
    let folder = folder("time");
    let table = shortest(&folder, &["table", favorit(), "motion", "-o", "motion.csv"]);
    let page = shortest(&folder, &["page", favorit(), "-o", "page"]);
    println!("table {table:?}, page {page:?}");
    let text = fs::read_to_string(folder.join("motion.csv")).expect("a table");
    assert_eq!(text.lines().count(), 362);
    // Without optimisation, too.
    assert!(table < Duration::from_millis(300) && page < Duration::from_secs(1));
}

#[test]
fn several_mechanisms_have_a_page_that_leads_to_them() {
    let folder = folder("several");
    let machine = concat!(env!("CARGO_MANIFEST_DIR"), "/../examples/machine.rs");
    let output = linkage(&folder, &["page", machine, "-o", "all"]);
    assert!(output.status.success(), "{output:?}");
    let html = fs::read_to_string(folder.join("all/index.html")).expect("a page");
    let links: Vec<&str> = html.split("<a href=\"").skip(1).collect();
    assert_eq!(links.len(), 3);
    for link in links {
        let (target, _) = link.split_once('"').expect("an address");
        assert!(folder.join("all").join(target).is_file(), "{target}");
    }
}

#[test]
fn what_does_not_move_is_left_out_of_pages_and_circuits() {
    let folder = folder("still");
    let gears = concat!(env!("CARGO_MANIFEST_DIR"), "/../examples/gears.rs");
    let output = linkage(&folder, &["page", gears, "-o", "gears"]);
    let said = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{said}");
    assert_eq!(said, "note: Bracket has no input: nothing of it moves\n");
    assert!(folder.join("gears/index.html").is_file());
    let bracket = ["--mechanism", "Bracket"];
    for (command, expected) in [
        ("page", "error: Bracket has no input: nothing of it moves\n"),
        (
            "circuits",
            "error: Bracket has no circuits: they are for mechanisms with loops and one input\n",
        ),
    ] {
        let said = refused(&folder, &[&[command, gears], &bracket[..]].concat(), 1);
        assert_eq!(said, expected);
    }
}

#[test]
fn one_of_several_mechanisms_is_chosen_by_its_name() {
    let folder = folder("chosen");
    printed(&folder, &["new", "own.mech"]);
    let text = fs::read_to_string(folder.join("own.mech")).expect("the mechanism");
    let other = text.replace("SliderCrank", "Other").replace("40mm", "45mm");
    fs::write(folder.join("two.mech"), text + &other).expect("it can be written");
    let table = ["table", "two.mech", "stroke", "--steps", "1"];
    assert_eq!(
        refused(&folder, &table, 1),
        "error: the function `stroke` is in `SliderCrank` and `Other` in `two.mech`: choose one by `--mechanism NAME`\n"
    );
    let by_name = |name| printed(&folder, &[&table[..], &["--mechanism", name]].concat());
    assert!(by_name("SliderCrank").contains("\r\n0,159.8957"));
    assert!(by_name("Other").contains("\r\n0,164.8957"));
}

#[test]
fn a_watched_page_follows_its_file() {
    let folder = folder("watch");
    printed(&folder, &["new", "own.mech"]);
    let mut command = Command::new(env!("CARGO_BIN_EXE_linkage"));
    command
        .current_dir(&folder)
        .args(["page", "own.mech", "--watch"]);
    let mut running = command
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn()
        .expect("it runs");
    let read = |name: &str| fs::read_to_string(folder.join("own_page").join(name));
    let until = |what: &dyn Fn() -> bool| {
        let start = Instant::now();
        while !what() && start.elapsed() < Duration::from_secs(60) {
            sleep(Duration::from_millis(20));
        }
        what()
    };
    let first = until(&|| read("version.js").is_ok());
    let version = read("version.js").unwrap_or_default();
    // The page knows which version it is, and asks for others.
    let number = version
        .trim()
        .trim_start_matches("linkageVersion")
        .to_owned();
    let own = read("index.html").is_ok_and(|html| html.contains(&format!("follow{number}")));
    let file = folder.join("own.mech");
    let text = fs::read_to_string(&file).expect("the mechanism");
    fs::write(&file, text.replace("crank  = 40mm", "crank  = 41.5mm")).expect("it can be changed");
    let again = until(&|| read("version.js").is_ok_and(|now| now != version));
    let data = read("data.json").unwrap_or_default();
    running.kill().expect("it runs until it is ended");
    running.wait().expect("it has ended");
    assert!(first && own && again, "{first} {own} {again}");
    assert!(data.contains("41.5"), "the new dimension");
}
