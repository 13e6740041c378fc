//! Runs of the scripts in `benches/dynamics_rivals`, from their file.

use crate::comparison::{Method, Run};

const MEASURED: &str = include_str!("../dynamics_rivals/rivals.csv");

/// Returns the methods of a problem.
pub(crate) fn methods(problem: &str) -> Vec<Method> {
    let mut methods: Vec<Method> = Vec::new();
    let rows = MEASURED.lines().filter(|line| !line.starts_with('#'));
    for line in rows.skip(1) {
        let cells: Vec<&str> = line.split(';').collect();
        let [_script, of, name, _setting, error, seconds] = cells[..] else {
            panic!("six cells: {line}");
        };
        if of != problem {
            continue;
        }
        let run = Run {
            error: error.parse().expect("an error"),
            seconds: seconds.parse().expect("a time"),
        };
        match methods.last_mut().filter(|method| method.name == name) {
            Some(method) => method.runs.push(run),
            None => methods.push(Method {
                name: name.to_owned(),
                is_ours: false,
                runs: vec![run],
            }),
        }
    }
    methods
}

/// Returns versions and dates, a line for each script.
pub(crate) fn about() -> Vec<&'static str> {
    let lines = MEASURED.lines();
    lines.filter_map(|line| line.strip_prefix("# ")).collect()
}
