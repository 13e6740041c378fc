//! What `run_pylinkage.py` has measured: `pylinkage.csv`.

const MEASURED: &str = include_str!("../../pylinkage.csv");

/// The file.
pub(crate) struct Measured {
    /// Versions and the date.
    pub(crate) about: &'static str,
    pub(crate) methods: Vec<Method>,
}

/// A method of the file.
pub(crate) struct Method {
    pub(crate) name: &'static str,
    rows: Vec<Row>,
}

struct Row {
    error: f64,
    /// The median time in seconds, infinite where half of the seeds do not come.
    time: f64,
    reached: usize,
}

pub(crate) fn measured() -> Measured {
    let (about, rows) = MEASURED
        .split_once('\n')
        .expect("versions and the date before the rows");
    let mut methods: Vec<Method> = Vec::new();
    // Behind the names of the columns.
    for line in rows.lines().skip(1) {
        let cells: Vec<&str> = line.split(';').collect();
        let [name, error, time, reached] = cells[..] else {
            panic!("four cells: {line}");
        };
        let row = Row {
            error: error.parse().expect("an error"),
            time: time.parse().expect("a time"),
            reached: reached.parse().expect("a count"),
        };
        match methods.last_mut().filter(|method| method.name == name) {
            Some(method) => method.rows.push(row),
            None => methods.push(Method {
                name,
                rows: vec![row],
            }),
        }
    }
    Measured {
        about: about.trim_start_matches("# "),
        methods,
    }
}

impl Method {
    /// The median time to an error of the file, and how many seeds come there.
    pub(crate) fn time_to(&self, error: f64) -> (f64, usize) {
        // Errors have six digits there.
        let mut rows = self.rows.iter();
        let row = rows.find(|row| (row.error / error - 1.0).abs() < 1e-4);
        let row = row.expect("errors of the table are among those of the picture");
        (row.time, row.reached)
    }

    pub(crate) fn points(&self) -> impl Iterator<Item = (f64, f64)> {
        self.rows.iter().map(|row| (row.time, row.error))
    }
}
