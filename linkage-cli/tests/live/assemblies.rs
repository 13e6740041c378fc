//! Other assemblies of groups without a closed form, chosen in pages.

use linkage_engine::Assembly;

use crate::pages::{self, Live};

/// Values of a table for these rows, every so many of them.
fn rows(live: &mut Live, function: &str) -> Vec<Vec<Option<f64>>> {
    let text = live.csv(function);
    let rows = text.lines().skip(1).step_by(20);
    rows.map(|line| line.split(',').map(|word| word.parse().ok()).collect())
        .collect()
}

/// Whether an assembly of Rust has these numbers, and none where there are none.
fn fits(assembly: &Assembly, function: usize, rows: &[Vec<Option<f64>>]) -> bool {
    rows.iter().all(|row| {
        let rust = assembly.call(function, &[row[0].expect("an input")]);
        rust.iter().zip(&row[1..]).all(|(rust, js)| match js {
            Some(js) => (js - rust).abs() <= 1e-9 * (1.0 + rust.abs()),
            None => !rust.is_finite(),
        })
    })
}

/// Chooses each assembly that the page offers, with other dimensions, too: each is one of Rust's, and all of them are offered.
#[test]
fn coupled_groups_are_chosen() {
    for (example, function, address) in [
        ("eye_needle.rs", "rocker", ""),
        ("eye_needle.rs", "rocker", "l12=48&l34=83"),
        ("two_crank_triad.rs", "motion", ""),
    ] {
        let Some(mut live) = Live::example_as(example, "assemblies") else {
            return;
        };
        live.page.value(&format!("location.hash = '{address}'"));
        live.page
            .wait(&format!("location.hash.slice(1) === '{address}'"));
        let mut dimensions = live.mechanism.dimensions();
        for part in address.split('&').filter(|part| !part.is_empty()) {
            let (name, value) = part.split_once('=').expect("a value");
            let mut all = live.mechanism.parameters().iter();
            let place = all.position(|own| own.name == name).expect("a dimension");
            dimensions[place] = value.parse().expect("a number");
        }
        let unit = &live.mechanism.compiled();
        let at: Vec<f64> = unit.inputs.iter().map(|own| own.reference).collect();
        let number = unit.functions.iter().position(|own| own.name == function);
        let number = number.expect("a function");
        let all = live
            .mechanism
            .assemblies(&dimensions, &at)
            .expect("it closes");
        live.page
            .value("document.getElementById('assembly').dispatchEvent(new Event('focus'))");
        let offered = live
            .page
            .number("document.getElementById('assembly').options.length");
        assert_eq!(offered as usize, all.len(), "{example}, {address}");
        let mut found = Vec::new();
        for choice in 0..all.len() {
            live.page.value(&format!(
                "(() => {{ const select = document.getElementById('assembly'); select.dispatchEvent(new Event('focus')); select.value = {choice}; \
                 select.dispatchEvent(new Event('change')); }})()"
            ));
            let shown = rows(&mut live, function);
            let own = all.iter().position(|own| fits(own, number, &shown));
            found.push(own.unwrap_or_else(|| panic!("{example}, {address}: {choice}")));
            // The link leads to it from the report.
            live.page
                .value("new Promise((done) => setTimeout(done, 300))");
            live.page.value(
                "new Promise((done) => { const once = (what) => addEventListener('hashchange', () => setTimeout(what), { once: true }); \
                 const own = location.hash; if (own === '') return done(); once(() => { once(done); location.hash = own; }); location.hash = ''; })",
            );
            let again = rows(&mut live, function);
            let own = all.iter().position(|own| fits(own, number, &again));
            assert_eq!(own, found.last().copied(), "{example}, {address}: the link");
        }
        found.sort_unstable();
        found.dedup();
        assert_eq!(found.len(), all.len(), "{example}, {address}");
        live.page.assert_quiet();
    }
}

/// Whether two tables have the same numbers but for roundoffs: solutions settle again.
fn same(a: &str, b: &str) -> bool {
    let near = |(a, b): (&str, &str)| match (a.parse::<f64>(), b.parse::<f64>()) {
        (Ok(a), Ok(b)) => (a - b).abs() <= 1e-9 * (1.0 + a.abs()),
        _ => a == b,
    };
    let words = |own| str::split(own, [',', '\r', '\n']);
    words(a).count() == words(b).count() && words(a).zip(words(b)).all(near)
}

/// A choice is a step that is undone; "Reset" leads to the report's assembly.
#[test]
fn a_choice_is_undone() {
    let Some(mut live) = Live::example_as("two_crank_triad.rs", "undone") else {
        return;
    };
    let before = live.csv("motion");
    let choose = |live: &mut Live, choice: usize| {
        live.page.value(&format!(
            "(() => {{ const select = document.getElementById('assembly'); select.dispatchEvent(new Event('focus')); select.value = {choice}; \
             select.dispatchEvent(new Event('change')); }})()"
        ));
        live.csv("motion")
    };
    let first = choose(&mut live, 0);
    let second = choose(&mut live, 1);
    assert!(!same(&before, &first) && !same(&first, &second) && !same(&before, &second));
    let click = |live: &mut Live, id: &str| {
        live.page
            .value(&format!("document.getElementById('{id}').click()"));
        live.csv("motion")
    };
    let options = "document.getElementById('assembly').options.length";
    let listed = live.page.number(options);
    assert!(listed > 2.0, "{listed}");
    assert!(same(&click(&mut live, "undo"), &first));
    // The list stays open, with the assembly that is shown.
    assert_eq!(live.page.number(options), listed);
    assert_eq!(
        live.page
            .number("Number(document.getElementById('assembly').value)"),
        0.0
    );
    assert!(click(&mut live, "undo") == before);
    assert!(same(&click(&mut live, "redo"), &first));
    assert!(click(&mut live, "reset") == before);
    assert!(live.page.holds("document.getElementById('reset').disabled"));
    live.page.assert_quiet();
}

/// The second dyad reaches the rocker's end in one of the two assemblies of the four-bar only.
const ABOVE: &str = "
    pub struct Above {
        unit mm;
        param crank   = 50mm;
        param coupler = 120mm;
        param rocker  = 100mm;
        param lower   = 60mm;
        param upper   = 70mm;
        const frame = (140mm, 0mm);
        const pivot = (160mm, 190mm);
        input phi = 30deg in 20deg..40deg;
        unknown theta = 40deg;
        unknown psi   = 80deg;
        unknown sigma = 30deg;
        unknown tau   = 120deg;
        let b = frame + polar(rocker, psi);
        loop polar(crank, phi) + polar(coupler, theta) = b;
        loop b + polar(lower, sigma) = pivot - polar(upper, tau);
    }
    impl Above {
        pub fn motion(phi) -> Motion { psi, sigma, tau }
    }";

/// The page after another address, whose assembly does not close: it says which part that is, and everything else is computed.
fn follows_but(live: &mut Live, dimension: (&str, f64), wrong: &str) {
    let (name, x) = dimension;
    live.page
        .value(&format!("location.hash = '{name}={x}&{wrong}'"));
    live.page.wait(&format!(
        "document.querySelector('input[data-dimension={name}]').value === '{x}'"
    ));
    assert_eq!(
        live.says(),
        format!("The address says what this mechanism does not have: {wrong}")
    );
    compares(live, dimension);
}

/// All tables are those of Rust with one other dimension.
fn compares(live: &mut Live, (name, x): (&str, f64)) {
    let mut dimensions = live.mechanism.dimensions();
    let mut all = live.mechanism.parameters().iter();
    let place = all.position(|own| own.name == name).expect("a dimension");
    dimensions[place] = x;
    let assembly = live.mechanism.assemble(&dimensions).expect("it closes");
    let gaps = pages::compare(live, &assembly, &[]);
    assert_eq!(gaps, 0, "{name} = {x}");
}

#[test]
fn links_to_modes_that_do_not_close_are_told() {
    let Some(mut live) = Live::text("above", ABOVE) else {
        return;
    };
    let signs = live
        .page
        .words("document.getElementById('assembly').options[0].textContent");
    let turned = if signs.starts_with('+') {
        "-1,1"
    } else {
        "1,1"
    };
    follows_but(
        &mut live,
        ("lower", 61.5),
        &format!("assembly%20modes={turned}"),
    );
    // Further changes are not refused.
    live.page.value("location.hash = 'lower=62.5'");
    live.page
        .wait("document.querySelector('input[data-dimension=lower]').value === '62.5'");
    assert_eq!(live.says(), "");
    compares(&mut live, ("lower", 62.5));
    live.page.assert_quiet();
}

#[test]
fn links_to_starts_without_a_solution_are_told() {
    let Some(mut live) = Live::example_as("eye_needle.rs", "starts") else {
        return;
    };
    live.page.value(
        "(() => { const select = document.getElementById('assembly'); select.dispatchEvent(new Event('focus')); \
         select.value = 1 - Number(select.value); select.dispatchEvent(new Event('change')); })()",
    );
    live.page.wait("location.hash.includes('start')");
    let numbers = live.page.words("location.hash.split('=').pop()");
    let nowhere = vec!["9"; numbers.split(',').count()].join(",");
    follows_but(
        &mut live,
        ("l12", 48.0),
        &format!("assembly%20start={nowhere}"),
    );
    live.page.value("location.hash = 'l12=49'");
    live.page
        .wait("document.querySelector('input[data-dimension=l12]').value === '49'");
    assert_eq!(live.says(), "");
    compares(&mut live, ("l12", 49.0));
    live.page.assert_quiet();
}
