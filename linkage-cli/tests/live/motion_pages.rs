//! Pages of motions under forces, and the rows of the command with the same arguments.

use std::fs;
use std::path::PathBuf;
use std::process::{Command, Output};

use linkage_browser::Page;

use crate::pages::{CATCH, saved_file};

/// A press with weights, a spring and a damper that a motor accelerates.
const PRESS: &str = "
    pub struct Press {
        unit mm;
        param rod = 120mm;
        param heavy = 1.5kg;
        argument motor = 2N*m;
        gravity = (0, -9.81m/s^2);
        input phi = 20deg in 0deg..360deg at omega, epsilon;
        unknown theta = 0deg;
        unknown x = 150mm;
        let p = polar(30mm, phi);
        loop p + polar(rod, theta) = (x, 0);
        body wheel = pin on frame at (0, 0), turns phi, inertia 500kg*mm^2;
        body link = pin on wheel at p, turns theta, mass 200g at (p + (x, 0)) / 2, inertia 240kg*mm^2;
        body piston = slide guide on frame at (x, 0) along (1, 0), mass heavy at (x, 0);
        pin end = link on piston at (x, 0);
        torque motor on wheel;
        spring 0.4N/mm on guide, free 140mm;
        damper 0.01N*s/mm on guide;
    }
    impl Press {
        pub fn motion(phi, omega, epsilon, motor) -> Motion {
            a: driven_acceleration(phi), x, rest: torque(phi)
        }
    }
";

/// Two stones, and a lever whose input is a length with an end.
const OTHERS: &str = include_str!("../others.mech");

/// A piston with a crank that has dead points.
const PISTON: &str = "
    pub struct Piston {
        unit mm;
        param rod = 120mm;
        argument push = 20N;
        input y = 120mm in 100mm..140mm at v;
        unknown phi = 60deg;
        unknown theta = -20deg;
        loop polar(30mm, phi) + polar(rod, theta) = (y, 0);
        body wheel = pin on frame at (0, 0), turns phi, inertia 500kg*mm^2;
        body ram = slide on frame at (y, 0) along (1, 0), mass 1kg at (y, 0);
        force (push, 0) on ram at (y, 0);
    }
    impl Piston { pub fn stroke(y, v, push) -> Stroke { a: driven_acceleration(y), phi } }
";

/// Calls `linkage run` on one of the texts.
fn run(folder: &PathBuf, arguments: &[&str]) -> Output {
    fs::create_dir_all(folder).expect("a folder");
    fs::write(folder.join("press.mech"), PRESS).expect("a file");
    fs::write(folder.join("others.mech"), [OTHERS, PISTON].concat()).expect("a file");
    let mut command = Command::new(env!("CARGO_BIN_EXE_linkage"));
    let command = command.arg("run").args(arguments).current_dir(folder);
    command.output().expect("it runs")
}

/// The numbers below the first line that has no remark.
fn rows(text: &str) -> Vec<Vec<f64>> {
    let lines = text.lines().filter(|line| !line.contains("# changed"));
    let cells = |line: &str| {
        line.split(',')
            .map(|x| x.parse().unwrap_or(f64::NAN))
            .collect()
    };
    lines.skip(1).map(cells).collect()
}

/// A page and the command with the same arguments.
pub(crate) struct Motion {
    pub(crate) page: Page,
    folder: PathBuf,
    given: Vec<&'static str>,
}

impl Motion {
    /// `None` without a browser.
    pub(crate) fn new(name: &str, given: &[&'static str]) -> Option<Self> {
        let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(format!("motion_{name}"));
        run(&folder, &[given, &["-o", "motion.html"]].concat());
        let mut page = Page::open(&folder.join("motion.html"))?;
        page.value(CATCH);
        Some(Self {
            page,
            folder,
            given: given.to_vec(),
        })
    }

    /// The rows of the command with further options, and what it prints on the standard error.
    pub(crate) fn command(&self, further: &[&str]) -> (Vec<Vec<f64>>, String) {
        let out = run(&self.folder, &[&self.given[..], further].concat());
        let text = String::from_utf8_lossy(&out.stdout).into_owned();
        (
            rows(&text),
            String::from_utf8_lossy(&out.stderr).into_owned(),
        )
    }

    /// The same columns on the page: the state, then the function.
    pub(crate) fn shown(&mut self, function: &str) -> Vec<Vec<f64>> {
        let [state, results] = ["state", function]
            .map(|name| rows(&saved_file(&mut self.page, &format!("{name}.csv"))));
        let pairs = state.into_iter().zip(results);
        pairs
            .map(|(state, results)| [&state[..], &results[1..]].concat())
            .collect()
    }

    /// Types a number into a field.
    pub(crate) fn set(&mut self, name: &str, value: &str) {
        self.page.value(&format!(
            "(() => {{ const field = document.querySelector('input[data-dimension=\"{name}\"]'); \
             field.value = '{value}'; field.dispatchEvent(new Event('change')); }})()"
        ));
    }

    /// The remark above the page.
    pub(crate) fn remark(&mut self) -> String {
        self.page
            .words("document.getElementById('gaps').textContent")
    }

    /// The largest difference of the energy as a share of the largest energy that moves.
    pub(crate) fn drift(&mut self) -> f64 {
        let words = self
            .page
            .words("document.getElementById('drift').textContent");
        let share = words
            .split(", ")
            .last()
            .and_then(|words| words.split(' ').next());
        share
            .expect("a share")
            .parse()
            .unwrap_or_else(|_| panic!("{words}"))
    }
}

/// Compares rows up to a part of the largest number of each column.
pub(crate) fn assert_near(page: &[Vec<f64>], command: &[Vec<f64>], part: f64, what: &str) {
    assert_eq!(page.len(), command.len(), "{what}");
    for column in 0..command[0].len() {
        let largest = command
            .iter()
            .map(|row| row[column].abs())
            .fold(1e-3, f64::max);
        for (page, command) in page.iter().zip(command) {
            let (page, command) = (page[column], command[column]);
            assert!(
                (page - command).abs() <= part * largest,
                "{what}, column {column}: {page} and {command}"
            );
        }
    }
}
