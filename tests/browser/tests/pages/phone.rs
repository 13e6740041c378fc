//! With a finger on a phone.

use linkage_browser::samples::{FourBar, four_bar, spatial, written};
use linkage_browser::{PHONE, Page};

#[test]
fn fingers_play_and_trace() {
    let file = written(&four_bar("On a phone", FourBar::TURNING), "phone");
    let Some(mut page) = Page::open(&file) else {
        return;
    };
    page.screen(PHONE);
    let place = page.middle("[data-point=b] .mark");
    page.tap(place);
    page.wait("document.querySelector('[data-trace=b]')");

    let before = page.row();
    let place = page.middle("#play");
    page.tap(place);
    page.wait(&format!(
        "Number(document.querySelector('#position').value) !== {before}"
    ));
    page.tap(place);
    page.wait("document.querySelector('#play').getAttribute('aria-label') === 'Play'");

    // Below all plots and tables the controls are still there.
    page.value("window.scrollTo(0, document.body.scrollHeight)");
    page.settle();
    let [_, top, _, height] = page.place("#play");
    assert!(top > 0.0 && top + height <= f64::from(PHONE.height));
    page.shoot("phone-end");

    let place = page.middle(".plot");
    page.tap(place);
    page.settle();
    let last = page.number("Number(document.querySelector('#position').max)");
    assert!(
        (page.row() as f64 / last - 0.45).abs() < 0.15,
        "a tap in the plot leads there"
    );
    page.shoot("phone-plots");
    page.assert_quiet();
}

#[test]
fn two_fingers_make_it_larger() {
    let file = written(&spatial(), "pinch");
    let Some(mut page) = Page::open(&file) else {
        return;
    };
    page.screen(PHONE);
    let scale = "Number(document.querySelector('#drawing').dataset.scale)";
    let fitted = page.number(scale);
    let middle = page.middle("#drawing");
    page.pinch(middle, 80.0, 160.0);
    page.settle();
    let larger = page.number(scale) / fitted;
    assert!((larger - 2.0).abs() < 0.3, "made larger {larger} times");
    page.assert_quiet();
}
