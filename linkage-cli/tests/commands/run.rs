//! `linkage run` against laws of energy and closed forms.

use std::fs;
use std::path::{Path, PathBuf};

use crate::{folder, linkage, printed, refused};

const PRESS: &str = "
    pub struct Press {
        unit mm;
        argument motor = 2N*m;
        input phi = 0deg in 0deg..360deg at omega, epsilon;
        unknown theta = 0deg;
        unknown x = 150mm;
        let p = polar(30mm, phi);
        loop p + polar(120mm, theta) = (x, 0);
        body wheel = pin on frame at (0, 0), turns phi, inertia 500kg*mm^2;
        body link = pin on wheel at p, turns theta, mass 200g at (p + (x, 0)) / 2, inertia 240kg*mm^2;
        body piston = slide on frame at (x, 0) along (1, 0), mass 1.5kg at (x, 0);
        pin end = link on piston at (x, 0);
        torque motor on wheel;
    }
    impl Press {
        pub fn motion(phi, omega, epsilon, motor) -> Motion {
            a: driven_acceleration(phi), e: kinetic_energy(), rest: torque(phi)
        }
        pub fn path(phi) -> Path { x }
    }
";

/// Two stones, and a lever whose input is a length with an end.
const OTHERS: &str = include_str!("../others.mech");

/// A folder with both files.
fn files(name: &str) -> PathBuf {
    let folder = folder(name);
    fs::write(folder.join("press.mech"), PRESS).expect("it can be written");
    fs::write(folder.join("others.mech"), OTHERS).expect("it can be written");
    folder
}

/// The rows below the titles.
fn rows(text: &str) -> Vec<Vec<f64>> {
    let cells = |line: &str| {
        line.split(',')
            .map(|x| x.parse().expect("a number"))
            .collect()
    };
    text.lines().skip(1).map(cells).collect()
}

fn table(folder: &Path, arguments: &[&str]) -> (String, Vec<Vec<f64>>) {
    let text = printed(folder, &[&["run"], arguments].concat());
    let title = text.lines().next().expect("a title").to_owned();
    let rows = rows(&text);
    (title, rows)
}

#[test]
fn the_work_of_a_motor_becomes_energy() {
    let folder = files("run_energy");
    let (title, rows) = table(&folder, &["press.mech", "--for", "300ms", "--steps", "31"]);
    assert_eq!(
        title,
        "time [s],phi [rad],omega [rad/s],a [rad/s^2],e [N*mm],rest [N*mm]"
    );
    assert_eq!(rows.len(), 31);
    assert_eq!(rows[0][..3], [0.0; 3]);
    for row in &rows[1..] {
        let [time, phi, _, _, energy, rest] = row[..] else {
            panic!("six columns")
        };
        assert!((energy - 2000.0 * phi).abs() < 1e-8 * energy, "{time} s");
        // With the acceleration of the motion no drive is needed.
        assert!(rest.abs() < 1e-6, "{rest} at {time} s");
    }
    assert!((rows[30][0] - 0.3).abs() < 1e-15);
}

#[test]
fn a_motion_ends_where_it_is_asked_to() {
    let folder = files("run_stops");
    let given = [
        "press.mech",
        "motion",
        "--for",
        "9s",
        "--at",
        "motor=3N*m",
        "--steps",
        "2",
    ];
    for (stop, column, value) in [("phi=2turn", 1, 720.0), ("e=5J", 4, 5000.0)] {
        let out = linkage(
            &folder,
            &[&["run"], &given[..], &["--degrees", "--stop", stop]].concat(),
        );
        let text = String::from_utf8_lossy(&out.stdout).into_owned();
        let last = rows(&text).pop().expect("a row");
        assert!(
            (last[column] - value).abs() < 1e-6 * value,
            "{stop}: {last:?}"
        );
        let note = String::from_utf8_lossy(&out.stderr).into_owned();
        assert!(
            note.starts_with(&format!("note: `{stop}` after 0.")),
            "{note}"
        );
    }
}

#[test]
fn several_inputs_move_together() {
    let folder = files("run_inputs");
    let given = [
        "others.mech",
        "--mechanism",
        "Stones",
        "--for",
        "2s",
        "--at",
        "w=1m/s",
        "--steps",
        "3",
    ];
    let (title, rows) = table(&folder, &given);
    assert_eq!(
        title,
        "time [s],y [m],z [m],v [m/s],w [m/s],a [m/s^2],b [m/s^2]"
    );
    for (row, t) in rows.iter().zip([0.0, 1.0, 2.0]) {
        let expected = [t, -5.0 * t * t, t, -10.0 * t, 1.0, -10.0, 0.0];
        let equal = |(a, b): (&f64, f64)| (a - b).abs() < 1e-9;
        assert!(row.iter().zip(expected).all(equal), "{row:?}");
    }
}

/// The motion up to the end of the range of positions is kept, and the message has time and place.
#[test]
fn a_motion_into_a_gap_is_kept() {
    let folder = files("run_gap");
    let given = [
        "run",
        "others.mech",
        "--mechanism",
        "Jack",
        "--for",
        "60s",
        "--at",
        "s=75mm",
    ];
    let out = linkage(&folder, &given);
    assert_eq!(out.status.code(), Some(1));
    let text = String::from_utf8_lossy(&out.stdout).into_owned();
    let rows = rows(&text);
    let last = rows.last().expect("rows");
    // s = 75 + t^2 / 2 * 1000 mm/s^2 reaches 90 mm.
    let end = (2.0 * 15.0 / 1000.0_f64).sqrt();
    assert!((last[0] - end).abs() < 1e-3, "{last:?}");
    let message = String::from_utf8_lossy(&out.stderr).into_owned();
    assert!(message.contains("the motion ends after 0.17"), "{message}");
}

#[test]
fn mistakes_name_what_is_missing() {
    let folder = files("run_mistakes");
    let told = |arguments: &[&str]| refused(&folder, &[&["run"], arguments].concat(), 1);
    let message = told(&["press.mech", "path", "--for", "1s"]);
    assert!(
        message.contains("`path` does not take the speed of `phi`"),
        "{message}"
    );
    assert!(message.contains("driven_acceleration(phi)"), "{message}");
    let message = told(&["others.mech", "--for", "1s"]);
    assert!(message.contains("`Stones` and `Jack`"), "{message}");
    let message = told(&["press.mech", "--for", "1s", "--stop", "phy=1deg"]);
    assert!(
        message.contains("neither input nor result `phy`"),
        "{message}"
    );
    let message = told(&["press.mech", "--for=-1s"]);
    assert!(
        message.contains("the end -1 s is not after the start 0 s"),
        "{message}"
    );
}
