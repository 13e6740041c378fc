//! The reports about the real mechanisms, as the program `gallery` writes them.

use crate::checks;
use linkage_browser::{DESKTOP, Page, SMALL_PHONE, entries, folder, some};

#[test]
fn reports_of_the_gallery() {
    for entry in some() {
        let Some(mut page) = Page::open(&entry.page) else {
            return;
        };
        checks::all(&mut page, &entry.name);
    }
}

/// It leads to every report.
#[test]
fn index_of_the_gallery() {
    let index = folder().join("index.html");
    let entries = entries();
    if entries.is_empty() {
        return;
    }
    let Some(mut page) = Page::empty() else {
        return;
    };
    page.load(&index);
    page.wait("document.readyState === 'complete' && document.links.length > 0");
    let links =
        page.words("[...document.links].map((link) => link.getAttribute('href')).join(' ')");
    for entry in entries {
        assert!(
            links.contains(&format!("{}/index.html", entry.name)),
            "no link to {} in {links}",
            entry.name
        );
    }
    page.wait("[...document.images].every((image) => image.complete && image.naturalWidth > 0)");
    for screen in [DESKTOP, SMALL_PHONE] {
        page.screen(screen);
        for (dark, colours) in [(false, "light"), (true, "dark")] {
            page.dark(dark);
            page.shoot(&format!("index-{}-{colours}", screen.name));
            // What is left of a picture's box is as light or dark as its drawing.
            let [_, box_of_picture] = page.colours("img");
            assert_eq!(box_of_picture.iter().sum::<f64>() < 384.0, dark);
        }
        let wide = page.number("document.documentElement.scrollWidth");
        assert!(
            wide <= f64::from(screen.width),
            "{wide} pixels on a {}",
            screen.name
        );
    }
    page.assert_quiet();
}
