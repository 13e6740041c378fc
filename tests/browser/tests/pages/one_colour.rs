//! One colour for one quantity: plots, legends, the path of its point. What is plotted first.

use linkage_browser::Page;
use linkage_browser::samples::{FourBar, four_bar, written};

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
