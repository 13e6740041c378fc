//! Tables.

use crate::{linkage, printed, slider};

#[test]
fn tables_are_for_spreadsheets_and_programs() {
    let folder = slider("tables");
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
    let folder = slider("gaps");
    let short = [
        "table", "own.mech", "stroke", "--steps", "5", "--set", "rod=38mm",
    ];
    let output = linkage(&folder, &short);
    assert!(output.status.success());
    let said = String::from_utf8_lossy(&output.stderr);
    assert!(
        said.starts_with("warning: SliderCrank: the mechanism comes apart in this range"),
        "{said}"
    );
    assert!(
        said.contains(
            "\nnote: at 1 of 5 positions a number is missing, first at `phi = 270 deg`: \
             loop 1 (`theta` and `slide`) misses by 7 mm\n"
        ),
        "{said}"
    );
    let text = String::from_utf8_lossy(&output.stdout);
    assert!(text.contains("\r\n4.71238898038469,,,\r\n"), "{text}");
    let output = linkage(&folder, &[&short[..], &["--json"]].concat());
    let json: serde_json::Value = serde_json::from_slice(&output.stdout).expect("JSON");
    assert!(json["columns"][1]["values"][3].is_null());
}
