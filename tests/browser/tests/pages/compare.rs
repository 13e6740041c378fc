//! Designs side by side.

use linkage_browser::samples::{FourBar, four_bar, page_written, sliders, spatial};
use linkage_browser::{DESKTOP, Key, PHONE, Page, SMALL_PHONE};
use linkage_report::{Aim, Compared, Comparison, Report};

/// A few four-bars, each with two figures: a front of three, and two that are beaten.
const FIGURES: [(&str, f64, [f64; 3]); 5] = [
    ("as drawn", 0.0, [45.0, 9.0, 1.0]),
    ("longer rocker", 4.0, [61.0, 11.0, 2.0]),
    ("longer coupler", 9.0, [52.0, 12.0, 0.5]),
    ("longest dwell", 14.0, [94.0, 14.5, 3.0]),
    ("as <b>large</b> & slow", 20.0, [50.0, 15.0, 4.0]),
];

fn reports() -> Vec<Report> {
    let longer = |(_, more, _): &(&str, f64, [f64; 3])| FourBar {
        rocker: FourBar::TURNING.rocker + more,
        arm: FourBar::TURNING.arm + 2.0 * more,
        ..FourBar::TURNING
    };
    FIGURES
        .iter()
        .map(|own| four_bar(own.0, longer(own)))
        .collect()
}

fn comparison<'a>(reports: &'a [Report], aims: usize) -> Comparison<'a> {
    let all = ["dwell", "force", "size"]
        .into_iter()
        .zip([true, false, false]);
    let aims = all.take(aims).map(|(name, most)| {
        if most {
            Aim::most(name)
        } else {
            Aim::least(name)
        }
    });
    let start = Comparison::new("Longer dwell").about("Four-bars of one frame.");
    let start = start.curves(["tracer.y", "psi"]).front(aims);
    FIGURES
        .iter()
        .zip(reports)
        .fold(start, |all, ((name, _, [dwell, force, size]), report)| {
            let design = Compared::new(*name, report);
            let design = design
                .figure("dwell", dwell.to_radians(), "rad")
                .figure("force", *force, "N");
            let design = design.figure("size", *size, "");
            all.design(if *name == "longest dwell" {
                design.page("longest/index.html")
            } else {
                design
            })
        })
}

fn shown(page: &mut Page) -> String {
    page.words("[...document.querySelectorAll('#designs [aria-pressed=true]')].map((own) => own.dataset.design).join()")
}

fn open(comparison: &Comparison<'_>, name: &str) -> Option<Page> {
    let html = comparison.html().unwrap_or_else(|error| panic!("{error}"));
    Page::open(&page_written(&html, name))
}

#[test]
fn designs_lie_over_each_other() {
    let reports = reports();
    let Some(mut page) = open(&comparison(&reports, 2), "compare") else {
        return;
    };
    assert_eq!(shown(&mut page), "0,1,2");
    let count = |page: &mut Page, selector: &str| {
        page.number(&format!("document.querySelectorAll({selector:?}).length"))
    };
    assert_eq!(count(&mut page, "#drawing g"), 3.0);
    assert_eq!(count(&mut page, "[data-curve=psi] .curve"), 3.0);
    // Where the mechanisms stand is where the reports say: the tracer of the first one, at a quarter turn.
    page.value("(() => { const s = document.querySelector('#position'); s.value = 90; s.dispatchEvent(new Event('input')); })()");
    let csv = reports[0].csv("motion").expect("a table");
    let row: Vec<f64> = csv
        .lines()
        .nth(91)
        .expect("a row")
        .split(',')
        .map(|cell| cell.parse().unwrap_or(f64::NAN))
        .collect();
    let number = page.number(
        "JSON.parse(document.querySelector('#comparison').textContent).designs[0].picture.points.findIndex((p) => p.name === 'tracer')",
    );
    for (k, attribute) in ["cx", "cy"].into_iter().enumerate() {
        let at = page.number(&format!(
            "Number(document.querySelectorAll('#drawing g[data-design=\"0\"] circle')[{number}].getAttribute('{attribute}'))"
        ));
        let known = if k == 0 { row[1] } else { -row[2] };
        assert!((at - known).abs() < 0.02, "{attribute}: {at} {known}");
    }
    // The table at this position says the same.
    let cell = page.words(
        "[...document.querySelectorAll('#tables tr')].find((row) => row.cells[0].textContent === 'tracer.y [mm]').cells[1].textContent",
    );
    assert!(
        (cell.parse::<f64>().expect("a number") - row[2]).abs() < 0.002,
        "{cell} {}",
        row[2]
    );
    // A press in the curves stands there.
    page.click("[data-curve='tracer.y'] svg");
    let middle = page.row();
    assert!((150..220).contains(&middle), "{middle}");
    // Names are words, whatever is in them.
    assert_eq!(
        page.words("document.querySelectorAll('#designs button')[4].textContent"),
        FIGURES[4].0
    );
    page.assert_quiet();
}

#[test]
fn a_click_on_the_front_shows_a_design() {
    let reports = reports();
    let Some(mut page) = open(&comparison(&reports, 2), "compare-front") else {
        return;
    };
    let best = page
        .words("JSON.parse(document.querySelector('#comparison').textContent).front.best.join()");
    assert_eq!(best, "true,true,false,true,false");
    page.click("#fronts .design[data-design='3'] .reach");
    assert_eq!(shown(&mut page), "0,1,2,3");
    let link = page.words("document.querySelector('#tables thead a').getAttribute('href')");
    assert_eq!(link, "longest/index.html");
    page.click("#fronts .design[data-design='1'] .reach");
    assert_eq!(shown(&mut page), "0,2,3");
    // As with keys; the point that was pressed keeps the focus.
    page.value("document.querySelector(\"#fronts .design[data-design='1']\").focus()");
    page.key(Key::Enter);
    assert_eq!(shown(&mut page), "0,1,2,3");
    assert_eq!(page.words("document.activeElement.dataset.design"), "1");
    // Compared with the first that is shown: 94 degrees are 108.9 % more than 45.
    let cell = page.words(
        "[...document.querySelectorAll('#tables tr')].find((row) => row.cells[0].textContent === 'dwell [deg]').cells[4].textContent",
    );
    assert_eq!(cell, "94+109 %");
    // One stays.
    for index in [0, 1, 2, 3] {
        page.click(&format!("#designs [data-design='{index}']"));
    }
    assert_eq!(shown(&mut page), "3");
    page.assert_quiet();
}

/// Three wishes, a phone, dark ground, paper: nothing is wider than the window, and pictures are taken of all.
#[test]
fn comparisons_on_all_screens() {
    let reports = reports();
    let Some(mut page) = open(&comparison(&reports, 3), "compare-three") else {
        return;
    };
    assert_eq!(
        page.number("document.querySelectorAll('#fronts svg').length"),
        3.0
    );
    for screen in [DESKTOP, SMALL_PHONE] {
        page.screen(screen);
        page.value("dispatchEvent(new Event('resize'))");
        for (dark, colours) in [(false, "light"), (true, "dark")] {
            page.dark(dark);
            page.value("scrollTo(0, 0)");
            page.shoot(&format!("compare-{}-{colours}", screen.name));
            let [words, ground] = page.colours("#about");
            let contrast = (words.iter().sum::<f64>() - ground.iter().sum::<f64>()).abs();
            assert!(contrast > 250.0, "{contrast}");
        }
        page.middle("#fronts");
        page.shoot(&format!("compare-{}-front", screen.name));
        page.middle("#tables");
        page.shoot(&format!("compare-{}-tables", screen.name));
        page.middle("#panels");
        page.shoot(&format!("compare-{}-curves", screen.name));
        let wide = page.number("document.documentElement.scrollWidth");
        assert!(
            wide <= f64::from(screen.width),
            "{wide} pixels on a {}",
            screen.name
        );
    }
    page.on_paper();
    page.shoot("compare-paper");
    let wide = page.number("document.documentElement.scrollWidth");
    let paper = page.number("innerWidth");
    assert!(wide <= paper, "{wide} pixels on paper of {paper}");
    assert!(page.holds("getComputedStyle(document.querySelector('#controls')).display === 'none'"));
    page.print("compare");
    page.assert_quiet();
}

/// Mechanisms in space, sliders on guides, and gaps where one cannot be assembled.
#[test]
fn other_mechanisms_are_compared() {
    let [a, b] = [spatial(), spatial()];
    let two = Comparison::new("In space")
        .design(Compared::new("one", &a))
        .design(Compared::new("two", &b));
    let Some(mut page) = open(&two, "compare-space") else {
        return;
    };
    page.shoot("compare-space");
    page.assert_quiet();
    let a = sliders();
    let Some(mut page) = open(
        &Comparison::new("Sliders").design(Compared::new("one", &a)),
        "compare-sliders",
    ) else {
        return;
    };
    assert!(page.number("document.querySelectorAll('#drawing .rail').length") > 0.0);
    page.shoot("compare-sliders");
    page.assert_quiet();
    let [a, b] = [FourBar::TURNING, FourBar::SWINGING].map(|own| four_bar("gaps", own));
    let gaps = Comparison::new("Gaps")
        .curves(["psi"])
        .design(Compared::new("turns", &a))
        .design(Compared::new("swings", &b));
    let Some(mut page) = open(&gaps, "compare-gaps") else {
        return;
    };
    let pens = page
        .number("document.querySelectorAll('.curve')[1].getAttribute('d').split('M').length - 1");
    assert!(pens > 1.0, "{pens}");
    page.assert_quiet();
}

/// The page of a program, as its test has written it; `None` if there is none, or no browser.
fn example(name: &str) -> Option<Page> {
    let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR"))
        .join(format!("../../target/comparisons/{name}/index.html"));
    if !path.is_file() {
        let advice = format!("no page: `cargo test -p linkage-tests --test {name}` writes it");
        assert!(!linkage_browser::required(), "{advice}");
        eprintln!("skipped: {advice}");
        return None;
    }
    Page::open(&path)
}

/// What it says, on all screens, light and dark; nothing is out of sight on a phone.
fn says(page: &mut Page, name: &str, designs: f64, parts: &[&str]) {
    let found = page.number("document.querySelectorAll('#designs [data-design]').length");
    assert_eq!(found, designs);
    let text = page.words("document.body.innerText");
    for part in parts {
        assert!(text.contains(part), "{part}\n{text}");
    }
    for screen in [DESKTOP, PHONE] {
        page.screen(screen);
        for (dark, colours) in [(false, "light"), (true, "dark")] {
            page.dark(dark);
            page.shoot(&format!("{name}-{}-{colours}", screen.name));
        }
        let wide = page.number("document.documentElement.scrollWidth");
        assert!(
            wide <= f64::from(screen.width),
            "{wide} on a {}",
            screen.name
        );
    }
    page.assert_quiet();
}

/// Three drives over each other.
#[test]
fn drives_with_longer_dwells() {
    let Some(mut page) = example("longer_dwell") else {
        return;
    };
    let parts = [
        "A longer dwell",
        "published",
        "longest as drawn",
        "longest in the worst case",
        "band when it is built",
    ];
    says(&mut page, "longer-dwell", 3.0, &parts);
}

/// The press as it was and six compromises, each of which is one of the best but for the first.
#[test]
fn a_quiet_press_and_its_compromises() {
    let Some(mut page) = example("quiet_press") else {
        return;
    };
    let parts = [
        "A quiet press",
        "as it was",
        "guide 40 N",
        "peak of the torque",
        "force on the guide",
    ];
    says(&mut page, "quiet-press", 7.0, &parts);
}
