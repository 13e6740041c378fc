//! Pages of motions under forces: their rows are those of the command, for the text and for other loads, dimensions and starts.

use std::f64::consts::TAU;

use linkage_browser::{PHONE, Page};

use crate::motion_pages::{Motion, assert_near};

#[test]
fn rows_are_those_of_the_command() {
    let given = ["press.mech", "--for", "400ms", "--steps", "41"];
    let Some(mut motion) = Motion::new("rows", &given) else {
        return;
    };
    let (expected, _) = motion.command(&[]);
    assert_eq!(motion.shown("motion"), expected);
    assert!(motion.drift() < 1e-8, "{}", motion.drift());
    assert_eq!(motion.remark(), "");
    // Curves go through these numbers: one over time, one over the angle.
    let places = |page: &mut Page, chart: &str| {
        let text = page.words(&format!(
            "document.querySelector('{chart} .curves path').getAttribute('d')"
        ));
        text.split(['M', 'L']).count() - 1
    };
    assert_eq!(places(&mut motion.page, "#panels"), 41);
    let portrait = "[data-chart=\"portrait phi\"]";
    assert_eq!(places(&mut motion.page, portrait), 41);
    // Within one turn a line begins with each turn.
    motion
        .page
        .value("document.getElementById('folds').click()");
    let text = motion.page.words(&format!(
        "document.querySelector('{portrait} .curves path').getAttribute('d')"
    ));
    let turns = |row: &Vec<f64>| (row[1] / TAU).floor();
    let begins = expected
        .windows(2)
        .filter(|pair| turns(&pair[0]) != turns(&pair[1]));
    assert_eq!(text.split('M').count() - 1, 1 + begins.count(), "{text}");
    motion.page.assert_quiet();
}

#[test]
fn sliders_change_the_motion() {
    let given = ["press.mech", "--for", "400ms", "--steps", "41"];
    let Some(mut motion) = Motion::new("sliders", &given) else {
        return;
    };
    for (name, value, further) in [
        ("motor", "3000", ["--at", "motor=3N*m"]),
        ("omega", "-5", ["--at", "omega=-5rad/s"]),
        ("phi", "75", ["--at", "phi=75deg"]),
        ("rod", "100", ["--set", "rod=100mm"]),
        ("heavy", "2.5", ["--set", "heavy=2.5kg"]),
    ] {
        motion
            .page
            .value("document.getElementById('reset').click()");
        motion.set(name, value);
        let (expected, _) = motion.command(&further);
        let shown = motion.shown("motion");
        assert_near(&shown, &expected, 1e-6, name);
        assert!(motion.drift() < 1e-7, "{name}: {}", motion.drift());
        // The change is one.
        let (before, _) = motion.command(&[]);
        assert!((shown[40][1] - before[40][1]).abs() > 1e-3, "{name}");
    }
    motion
        .page
        .value("document.getElementById('reset').click()");
    let (expected, _) = motion.command(&[]);
    assert_eq!(motion.shown("motion"), expected);
    motion.page.assert_quiet();
}

#[test]
fn several_inputs_have_portraits() {
    let given = [
        "others.mech",
        "--mechanism",
        "Stones",
        "--for",
        "2s",
        "--steps",
        "5",
    ];
    let Some(mut motion) = Motion::new("stones", &given) else {
        return;
    };
    assert_eq!(
        motion
            .page
            .number("document.querySelectorAll('[data-chart^=portrait]').length"),
        2.0
    );
    motion.set("w", "1");
    let (expected, _) = motion.command(&["--at", "w=1m/s"]);
    assert_near(&motion.shown("fall"), &expected, 1e-9, "w");
    assert!(motion.drift() < 1e-12, "{}", motion.drift());
    motion.page.assert_quiet();
}

#[test]
fn a_motion_ends_where_that_of_the_command_ends() {
    let given = [
        "others.mech",
        "--mechanism",
        "Jack",
        "--for",
        "9s",
        "--steps",
        "11",
    ];
    let Some(mut motion) = Motion::new("ends", &given) else {
        return;
    };
    let (expected, message) = motion.command(&[]);
    assert!(
        message.starts_with("error: the motion ends after "),
        "{message}"
    );
    assert_eq!(motion.shown("lift"), expected);
    assert!(
        motion.remark().starts_with("The motion ends after "),
        "{}",
        motion.remark()
    );
    motion.set("bar", "45");
    let (expected, _) = motion.command(&["--set", "bar=45mm"]);
    let shown = motion.shown("lift");
    let [end, last] = [&shown, &expected].map(|rows| rows[10].clone());
    assert!(
        (end[0] - last[0]).abs() < 1e-6 && (end[1] - last[1]).abs() < 1e-6,
        "{end:?} and {last:?}"
    );
    assert!((end[1] - 85.0).abs() < 1e-6, "{end:?}");
    assert!(
        motion
            .remark()
            .contains("at s = 85 mm: there are no accelerations beyond"),
        "{}",
        motion.remark()
    );
    motion.page.assert_quiet();
}

#[test]
fn dead_points_end_other_motions() {
    let given = [
        "others.mech",
        "--mechanism",
        "Piston",
        "--for",
        "2s",
        "--steps",
        "11",
    ];
    let Some(mut motion) = Motion::new("dead", &given) else {
        return;
    };
    for (name, value, further, at) in [
        ("rod", "110", ["--set", "rod=110mm"], "y = 140 mm"),
        ("push", "-40", ["--at", "push=-40N"], "y = 90 mm"),
        // It turns before it reaches the other one.
        ("v", "-700", ["--at", "v=-700mm/s"], "y = 150 mm"),
    ] {
        motion
            .page
            .value("document.getElementById('reset').click()");
        motion.set(name, value);
        let (expected, message) = motion.command(&further);
        assert!(
            message.contains(&format!("at a dead point, {at}")),
            "{message}"
        );
        let words = format!("at a dead point, {at}.");
        assert!(motion.remark().contains(&words), "{}", motion.remark());
        // Accelerations grow beyond all bounds there.
        let columns = |rows: &[Vec<f64>]| {
            rows[..10]
                .iter()
                .map(|row| vec![row[0], row[1], row[2], row[4]])
                .collect()
        };
        let [shown, expected]: [Vec<Vec<f64>>; 2] =
            [columns(&motion.shown("stroke")), columns(&expected)];
        // The last steps before it end at other times.
        assert_near(&shown, &expected, 1e-4, name);
        assert!(motion.drift() < 1e-6, "{name}: {}", motion.drift());
    }
    motion.page.assert_quiet();
}

#[test]
fn stops_of_the_command_stop_other_motions() {
    let press = ["press.mech", "--for", "9s", "--steps", "5"];
    for (name, stops, value, at, stop) in [
        (
            "turn",
            ["--stop", "phi=1turn", "--stop", "omega=-20rad/s"],
            "4000",
            "motor=4N*m",
            "phi=1turn",
        ),
        (
            "back",
            ["--stop", "phi=1turn", "--stop", "omega=-20rad/s"],
            "-4000",
            "motor=-4N*m",
            "omega=-20rad/s",
        ),
        (
            "way",
            ["--stop", "x=100mm", "--stop", "rest=1J"],
            "4000",
            "motor=4N*m",
            "x=100mm",
        ),
    ] {
        let Some(mut motion) = Motion::new(name, &[&press[..], &stops].concat()) else {
            return;
        };
        motion.set("motor", value);
        let (expected, note) = motion.command(&["--at", at]);
        assert_eq!(note.split('`').nth(1), Some(stop));
        assert_near(&motion.shown("motion"), &expected, 1e-6, at);
        let words = format!("The motion stops at {stop} after ");
        assert!(motion.remark().starts_with(&words), "{}", motion.remark());
    }
}

#[test]
fn time_runs_slowly_and_is_dragged() {
    let given = ["press.mech", "--for", "400ms", "--steps", "41"];
    let Some(mut motion) = Motion::new("time", &given) else {
        return;
    };
    let page = &mut motion.page;
    let words = page.words(
        "Array.from(document.getElementById('speed').options, (own) => own.textContent).join('; ')",
    );
    assert_eq!(
        words,
        "real time; 1/2 of real time; 1/5 of real time; 1/10 of real time; 1/100 of real time"
    );
    // A click at the right end of a portrait goes to the row whose place is there.
    page.value(
        "(() => { const view = document.querySelector('[data-chart=\"portrait phi\"] svg'); \
         const path = view.querySelector('.curves path').getPointAtLength(1e6); \
         const { left, top } = view.getBoundingClientRect(); \
         view.dispatchEvent(new MouseEvent('click', { clientX: left + path.x, clientY: top + path.y })); })()",
    );
    assert_eq!(page.row(), 40);
    assert!(
        page.words("document.getElementById('readout').textContent")
            .contains("0.4 s")
    );
    // A tenth of real time: after a second about a tenth of a second is gone.
    page.value("document.getElementById('position').value = 0; document.getElementById('position').dispatchEvent(new Event('input'))");
    page.value("document.getElementById('speed').value = 10; document.getElementById('speed').dispatchEvent(new Event('change'))");
    let row = page.number(
        "new Promise((done) => { document.getElementById('play').click(); setTimeout(() => { document.getElementById('play').click(); \
         done(Number(document.getElementById('position').value)); }, 1500); })",
    );
    assert!((8.0..=16.0).contains(&row), "{row}");
    page.assert_quiet();
}

#[test]
fn nothing_is_out_of_sight_on_a_phone() {
    let given = ["press.mech", "--for", "400ms", "--steps", "41"];
    let Some(mut motion) = Motion::new("phone", &given) else {
        return;
    };
    motion.page.screen(PHONE);
    // Charts become narrower after the window.
    let ends = "Math.max(document.documentElement.scrollWidth, document.querySelector('#motion svg').getBoundingClientRect().right)";
    motion.page.wait(&format!("{ends} <= {}", PHONE.width));
    motion.page.assert_quiet();
}
