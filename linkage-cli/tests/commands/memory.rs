//! Tables of any length in the same memory, and what does not fit into it.

use crate::{refused, slider};

#[test]
fn json_computed_in_several_passes_has_the_numbers_of_the_lines() {
    let folder = slider("passes");
    // Four columns, of which three are written in a first pass.
    let table = [
        "table", "own.mech", "stroke", "--steps", "100000", "--set", "rod=38mm",
    ];
    let output = |more: &[&str]| {
        let output = crate::linkage(&folder, &[&table[..], more].concat());
        let said = String::from_utf8_lossy(&output.stderr).into_owned();
        (String::from_utf8(output.stdout).expect("text"), said)
    };
    let (lines, said) = output(&[]);
    let (json, said_of_json) = output(&["--json"]);
    assert!(
        said.contains("note: at 1") && said.contains(" of 100000 positions"),
        "{said}"
    );
    assert_eq!(said, said_of_json);
    let json: serde_json::Value = serde_json::from_str(&json).expect("JSON");
    let columns = json["columns"].as_array().expect("columns");
    let columns: Vec<_> = columns
        .iter()
        .map(|own| own["values"].as_array().expect("values"))
        .collect();
    assert!(columns.len() == 4 && columns.iter().all(|own| own.len() == 100_000));
    for (row, line) in lines.lines().skip(1).enumerate() {
        for (cell, column) in line.split(',').zip(&columns) {
            let bits = |x: Option<f64>| x.map(f64::to_bits);
            assert_eq!(
                bits(cell.parse().ok()),
                bits(column[row].as_f64()),
                "{line}"
            );
        }
    }
}

/// With memory for the rows as they are computed, and not for 300,000 of them at once; in long runs ten million.
#[test]
#[cfg(target_os = "linux")]
fn a_long_table_takes_no_more_memory_than_a_short_one() {
    use std::io::{BufRead, BufReader};
    let folder = slider("long");
    let rows = match linkage_random::is_long() {
        true => 10_000_000,
        false => 300_000,
    };
    let script =
        format!("ulimit -v 45000; exec \"$0\" table own.mech stroke --steps {rows} -o t.csv");
    let mut shell = std::process::Command::new("sh");
    shell
        .current_dir(&folder)
        .args(["-c", &script, env!("CARGO_BIN_EXE_linkage")]);
    let output = shell.output().expect("it runs");
    let said = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{said}");
    let table = std::fs::File::open(folder.join("t.csv")).expect("the table");
    let lines = BufReader::new(table).lines();
    assert_eq!(lines.count(), rows + 1);
    std::fs::remove_file(folder.join("t.csv")).expect("it is large");
}

#[test]
fn rows_that_do_not_fit_are_refused() {
    let folder = slider("rows");
    for (command, columns, gigabytes) in [
        (&["page", "own.mech"][..], 19, "7600.0 GB"),
        (&["tolerance", "own.mech", "accuracy"], 6, "2880.0 GB"),
    ] {
        let all = [command, &["--steps", "4000000000"]].concat();
        let said = refused(&folder, &all, 1);
        let expected = format!(
            "error: 4000000000 rows of {columns} columns take about {gigabytes} of memory here"
        );
        assert!(said.starts_with(&expected), "{said}");
        assert!(
            said.contains("help: choose fewer `--steps`, or `linkage table`"),
            "{said}"
        );
    }
    assert!(!folder.join("own_page").exists());
}
