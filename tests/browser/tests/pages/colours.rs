//! Light and dark, of the system and of the reader.

use linkage_browser::Page;
use linkage_browser::samples::{FourBar, four_bar, written};

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
