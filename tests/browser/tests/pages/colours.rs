//! Colours: light and dark, of the system and of the reader; one colour for one quantity.

use linkage_browser::Page;
use linkage_browser::samples::{FourBar, four_bar, written};

// Light and dark, of the system and of the reader.

/// Relative luminance, as the accessibility guidelines define it.
fn luminance(colour: [f64; 3]) -> f64 {
    let linear = colour.map(|c| {
        let c = c / 255.0;
        if c <= 0.040_45 {
            c / 12.92
        } else {
            ((c + 0.055) / 1.055).powf(2.4)
        }
    });
    0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]
}

fn contrast(page: &mut Page, selector: &str) -> f64 {
    let [ink, paper] = page.colours(selector).map(luminance);
    (ink.max(paper) + 0.05) / (ink.min(paper) + 0.05)
}

fn paper(page: &mut Page) -> f64 {
    luminance(page.colours("body")[1])
}

#[test]
fn words_are_legible_on_light_and_dark_paper() {
    let file = written(&four_bar("Colours", FourBar::TURNING), "colours");
    let Some(mut page) = Page::open(&file) else {
        return;
    };
    for dark in [false, true] {
        page.dark(dark);
        assert_eq!(
            paper(&mut page) < 0.1,
            dark,
            "paper has the luminance {}",
            paper(&mut page)
        );
        for words in [
            "h1",
            "#about",
            "#readout b",
            "#readout small",
            "#hint",
            ".legend caption",
            ".legend th",
            ".plot text",
            "#drawing text",
            "[data-table=dimensions] td",
            "[data-table=dimensions] th",
            ".place",
            "#names",
            "#speed",
        ] {
            let found = contrast(&mut page, words);
            assert!(found >= 4.5, "{words}: contrast {found}, dark: {dark}");
        }
    }
    page.assert_quiet();
}

#[test]
fn paper_is_white_and_has_nothing_to_press() {
    let file = written(&four_bar("On paper", FourBar::TURNING), "printed");
    let Some(mut page) = Page::open(&file) else {
        return;
    };
    page.printed();
    assert!(paper(&mut page) > 0.9);
    for words in ["h1", ".legend th", ".plot text", "#drawing text"] {
        let found = contrast(&mut page, words);
        assert!(found >= 4.5, "{words}: contrast {found}");
    }
    let shown = "[...document.querySelectorAll('header button, #stage button, #stage select, #position, #chooser')].filter((item) => item.getBoundingClientRect().width > 0).map((item) => item.id).join(' ')";
    assert_eq!(page.words(shown), "");
    page.shoot("printed");
    page.assert_quiet();
}

#[test]
fn the_reader_chooses() {
    let file = written(&four_bar("Choice of colours", FourBar::TURNING), "choice");
    let Some(mut page) = Page::open(&file) else {
        return;
    };
    page.dark(false);
    page.click("#theme");
    assert!(paper(&mut page) < 0.1);
    assert_eq!(
        page.words("document.querySelector('#theme').textContent"),
        "Light"
    );
    page.click("#theme");
    page.dark(true);
    assert!(paper(&mut page) > 0.9, "what was chosen stays");
}

// One colour for one quantity: plots, legends, the path of its point. What is plotted first.

#[test]
fn a_quantity_keeps_its_colour() {
    let report = four_bar("One colour", FourBar::TURNING);
    let Some(mut page) = Page::open(&written(&report, "one-colour")) else {
        return;
    };
    let stroke = |page: &mut Page, selector: &str| {
        page.words(&format!(
            "getComputedStyle(document.querySelector({selector:?})).stroke"
        ))
    };
    let curve = ".curve[data-column='motion||tracer.x|mm']";
    let first = stroke(&mut page, curve);
    assert_eq!(
        stroke(
            &mut page,
            "tr[data-column='motion||tracer.x|mm'] .swatch path"
        ),
        first
    );
    assert_eq!(stroke(&mut page, "[data-trace=tracer]"), first);
    // Other curves come and go.
    page.click("#quantities summary");
    page.click("input[data-column='motion||psi|rad']");
    page.click("#apart");
    assert_eq!(stroke(&mut page, curve), first);
    page.click("input[data-column='motion||tracer.y|mm']");
    assert_eq!(stroke(&mut page, curve), first);
    // On paper it is the same one.
    let svg = report
        .plot(["tracer.x"])
        .and_then(|plot| plot.svg())
        .expect("a plot");
    page.dark(false);
    let light = stroke(&mut page, curve);
    let parts: Vec<u8> = light
        .trim_start_matches("rgb(")
        .trim_end_matches(')')
        .split(", ")
        .map(|part| part.parse().expect("a component"))
        .collect();
    let hex = format!("#{:02x}{:02x}{:02x}", parts[0], parts[1], parts[2]);
    assert!(
        svg.contains(&format!("stroke=\"{hex}\" stroke-width=\"1.8\"")),
        "{hex}"
    );
    page.assert_quiet();
}

#[test]
fn what_functions_list_first_is_plotted_first() {
    let report = four_bar("First", FourBar::TURNING).trace("b");
    let Some(mut page) = Page::open(&written(&report, "first-plots")) else {
        return;
    };
    let shown = "[...document.querySelectorAll('.curve')].map((curve) => curve.dataset.column.split('|')[2]).join(' ')";
    let words = page.words(shown);
    assert!(words.starts_with("tracer.x tracer.y psi"), "{words}");
}
