//! Pages that show what a file has without further options: declared loads, paths that functions
//! return, unknowns of a mechanism without functions.

use crate::pages::Live;

const LOADED: &str = "
    struct Loaded {
        unit mm;
        param crank = 40mm;
        argument load = 2kN;
        input phi = 30deg in 0deg..360deg;
        unknown theta = 30deg;
        unknown psi = 80deg;
        let b = polar(crank, phi);
        let d = (140mm, 0) + polar(100mm, psi);
        loop b + polar(120mm, theta) = d;
    }";

const FUNCTIONS: &str = "
    impl Loaded {
        fn track(phi) -> Track { p: d }
        fn torque(phi, load) -> Torque { t: load * velocity(d.y) }
        fn shape(phi) -> Shape { shape: picture() }
    }";

/// The largest number of a column of a table that the page saves.
fn largest(live: &mut Live, function: &str) -> f64 {
    let text = live.csv(function);
    let cells = text
        .lines()
        .skip(1)
        .filter_map(|line| line.split(',').nth(1));
    let numbers = cells.filter_map(|cell| cell.parse::<f64>().ok());
    numbers.fold(0.0, |largest: f64, x| largest.max(x.abs()))
}

#[test]
fn a_declared_load_has_a_slider_and_forces() {
    let Some(mut live) = Live::text("loaded", &format!("{LOADED}{FUNCTIONS}")) else {
        return;
    };
    assert!(
        live.page
            .holds("document.querySelector('[data-dimension=load]').value === '2000'")
    );
    let before = largest(&mut live, "torque");
    live.page.value("(() => { const field = document.querySelector('[data-dimension=load]'); field.value = '3000'; field.dispatchEvent(new Event('change')); return 0; })()");
    let after = largest(&mut live, "torque");
    assert!(
        before > 0.0 && (after - 1.5 * before).abs() < 1e-9 * after,
        "{before} {after}"
    );
    // The path of the joint that a function returns.
    assert_eq!(
        live.page
            .number("document.querySelectorAll('[data-trace=d]').length"),
        1.0
    );
    live.page.assert_quiet();
}

#[test]
fn functions_without_a_picture_move_and_are_plotted() {
    let functions = "impl Loaded { fn track(phi) -> Track { p: d, psi } }";
    let Some(mut live) = Live::text("pictureless", &format!("{LOADED}{functions}")) else {
        return;
    };
    let links = "document.querySelectorAll('[data-link]').length";
    assert_eq!(live.page.number(links), 3.0);
    let moves = "(() => {
        const slider = document.getElementById('position');
        const shown = (row) => {
            slider.value = row;
            slider.dispatchEvent(new Event('input'));
            return document.querySelector('#drawing .bodies').innerHTML;
        };
        return shown(0) !== shown(90);
    })()";
    assert!(live.page.holds(moves));
    let table = live.csv("track");
    assert!(
        table.starts_with("phi [rad],p.x [mm],p.y [mm],psi [rad]\r\n"),
        "{table}"
    );
    live.page.assert_quiet();
}

#[test]
fn a_mechanism_without_functions_moves_and_is_plotted() {
    let Some(mut live) = Live::text("unknowns", LOADED) else {
        return;
    };
    assert_eq!(
        live.page
            .number("document.querySelectorAll('[data-link]').length"),
        3.0
    );
    // Both unknowns are angles that can be plotted and saved.
    let table = live.csv("motion");
    assert!(
        table.starts_with("phi [rad],theta [rad],psi [rad]\r\n"),
        "{table}"
    );
    assert!(
        live.page
            .holds("document.querySelectorAll('#panels svg').length > 0")
    );
    live.page.assert_quiet();
}

#[test]
fn reactions_are_arrows_at_their_joints() {
    let template = "../linkage-cli/src/templates/toggle-press.mech";
    let Some(mut live) = Live::example_as(template, "reactions") else {
        return;
    };
    live.page.click("[data-vectors=force]");
    let arrows = live
        .page
        .words("[...document.querySelectorAll('.force')].map((own) => own.dataset.arrow).join()");
    assert_eq!(arrows, "rod,head,side");
    // An arrow begins at its joint, and its title has the number of the table.
    let row = live.page.row();
    let begins = "(() => { const [x, y] = document.querySelector('[data-arrow=head] .line').getAttribute('d').match(/-?[\\d.]+/g).map(Number); \
         const { left, top } = document.getElementById('drawing').getBoundingClientRect(); \
         const mark = document.querySelector('.point[data-point=top] .mark').getBoundingClientRect(); \
         return Math.hypot(mark.x + mark.width / 2 - left - x, mark.y + mark.height / 2 - top - y); })()";
    assert!(live.page.number(begins) < 1.0);
    let title = "document.querySelector('[data-arrow=head] title').textContent";
    let told = |title: &str| -> f64 {
        let number = title
            .strip_prefix("force of head: ")
            .and_then(|rest| rest.strip_suffix(" N"));
        number
            .and_then(|number| number.parse().ok())
            .expect("newtons")
    };
    let before = told(&live.page.words(title));
    let table = live.csv("forces");
    let mut lines = table.lines();
    let names: Vec<&str> = lines.next().expect("names").split(',').collect();
    let cells: Vec<&str> = lines.nth(row).expect("a row").split(',').collect();
    let cell = |name: &str| -> f64 {
        let column = names.iter().position(|own| *own == name).expect("a column");
        cells[column].parse().expect("a number")
    };
    let size = cell("head.x [N]").hypot(cell("head.y [N]"));
    assert!((before / size - 1.0).abs() < 1e-3, "{before}, {size}");
    live.page.assert_quiet();
}
