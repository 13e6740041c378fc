//! With a finger on a phone.

use linkage_browser::samples::{FourBar, four_bar, spatial, written};
use linkage_browser::{PHONE, Page, SMALL_PHONE};

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

/// The slider and the words of the position have a row each, and the words are whole.
#[test]
fn the_readout_is_whole() {
    let Some(mut page) = Page::open(&written(
        &four_bar("Words", FourBar::TURNING),
        "phone-words",
    )) else {
        return;
    };
    for screen in [PHONE, SMALL_PHONE] {
        page.screen(screen);
        // The longest numbers.
        page.value("(() => { const slider = document.getElementById('position'); slider.value = 287; slider.dispatchEvent(new Event('input')); })()");
        page.settle();
        let cut = page.words(
            "[document.getElementById('readout'), ...document.getElementById('readout').children].filter((own) => own.scrollWidth > own.clientWidth + 1 && own.clientWidth > 0 \
             || own.getBoundingClientRect().right > innerWidth).map((own) => own.textContent).join('; ')",
        );
        assert_eq!(cut, "", "on a {}", screen.name);
        let words = page.words("document.getElementById('readout').innerText");
        assert!(
            words.contains("phi = 287 deg")
                && words.contains("rad")
                && words.contains("row 288 of 361, t = "),
            "{words}"
        );
        let [_, top, width, height] = page.place("#position");
        assert!(width > f64::from(screen.width) - 40.0, "{width}");
        for other in ["#play", "#readout", "#direction", "#speed"] {
            let [_, own, _, tall] = page.place(other);
            assert!(
                own >= top + height - 1.0 || own + tall <= top + 1.0,
                "{other} is beside the slider"
            );
        }
        page.shoot(&format!("readout-{}", screen.name));
    }
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
