//! Names of points keep clear of each other, of links and of joints.

use linkage_browser::samples::{FourBar, four_bar, sliders, spatial, written};
use linkage_browser::{DESKTOP, PHONE, Page, some};
use serde_json::Value;
use std::path::Path;

/// What is below the words at a position, as the browser itself answers: places two pixels apart within the box of each name are asked of all
/// outlines, blocks, feet and joints; boxes of names of each other. A name apart from its point has a line from the one to the other.
const COVERED: &str = r"
window.goTo = (row) => {
  const slider = document.querySelector('#position');
  slider.value = row;
  slider.dispatchEvent(new Event('input'));
};
window.isShown = (node) => node.closest('[style*=\'display: none\']') === null;
window.shownNames = () => [...document.querySelectorAll('#drawing .name')].filter(isShown);
window.namesOfShownPoints = () => [...document.querySelectorAll('#drawing .name')].filter((node) => isShown(node.closest('.point')));
window.covered = () => {
  const view = document.querySelector('#drawing');
  const found = [];
  const names = shownNames().map((node) => ({ node, box: node.getBoundingClientRect() }));
  const meet = (a, b, edge = 0) => a.left + edge < b.right && b.left + edge < a.right && a.top + edge < b.bottom && b.top + edge < a.bottom;
  const solid = [...view.querySelectorAll('.link .outline, .plate .body, .barrel, .block, .foot, .mark')].filter(isShown)
    .map((node) => ({ node, box: node.getBoundingClientRect(), back: node.getScreenCTM().inverse() }));
  const frame = document.querySelector('#figure').getBoundingClientRect();
  for (const { node, box } of names) {
    const own = node.textContent;
    if (box.left < frame.left || box.right > frame.right || box.top < frame.top || box.bottom > frame.bottom) found.push(`${own} beyond the edge`);
    for (const other of names) if (other.node !== node && meet(box, other.box)) found.push(`${own} on ${other.node.textContent}`);
    for (const tools of document.querySelectorAll('.tools')) if (meet(box, tools.getBoundingClientRect())) found.push(`${own} below buttons`);
    for (const { node: item, box: around, back } of solid) {
      // Boxes of what is drawn leave its stroke out.
      if (!meet(box, { left: around.left - 6, right: around.right + 6, top: around.top - 6, bottom: around.bottom + 6 })) continue;
      let hit = false;
      for (let x = box.left; x <= box.right && !hit; x += 2) for (let y = box.top; y <= box.bottom && !hit; y += 2) {
        const place = new DOMPoint(x, y).matrixTransform(back);
        hit = item.isPointInStroke(place) || (!item.matches('.outline') && item.isPointInFill(place));
      }
      if (hit) found.push(`${own} on ${item.parentNode.textContent} ${item.getAttribute('class')}`);
    }
    const point = node.closest('.point');
    const mark = point.querySelector('.mark').getBoundingClientRect();
    const [x, y] = [mark.left + mark.width / 2, mark.top + mark.height / 2];
    const apart = Math.hypot(Math.max(box.left - x, 0, x - box.right), Math.max(box.top - y, 0, y - box.bottom));
    const line = point.querySelector('.leader').getBoundingClientRect();
    const leads = line.width + line.height > 0 && meet(line, { left: x - 9, right: x + 9, top: y - 9, bottom: y + 9 }) && meet(line, { left: box.left - 1, right: box.right + 1, top: box.top - 1, bottom: box.bottom + 1 });
    if (apart > 18 && !leads) found.push(`${own} is ${apart} pixels from its point, without a line`);
  }
  return found.join(', ');
};
// How often names change their places beside their points, from row to row.
window.jumps = (rows) => {
  let count = 0;
  let before = new Map();
  for (let row = 0; row < rows; row += 1) {
    goTo(row);
    const now = new Map(shownNames().map((node) => {
      const mark = node.closest('.point').querySelector('.mark');
      return [node, ['x', 'y'].map((axis) => node.getAttribute(axis) - mark.getAttribute('c' + axis))];
    }));
    for (const [node, [x, y]] of now) {
      const [u, v] = before.get(node) ?? [x, y];
      if (Math.hypot(x - u, y - v) > 1) count += 1;
    }
    before = now;
  }
  return count;
};
";

/// A page with the names of its points shown; `None` without a browser.
fn named(file: &Path) -> Option<Page> {
    let mut page = Page::open(file)?;
    page.click("#names");
    page.value(COVERED);
    Some(page)
}

fn last(page: &mut Page) -> usize {
    page.number("Number(document.querySelector('#position').max)") as usize
}

/// So many names have room anywhere.
const FEW: f64 = 20.0;

/// The part of the points' names that must have room, on a desktop and on a phone: names of a machine with thirty joints do not all fit on a phone.
const ROOM: [f64; 2] = [0.9, 0.6];

/// At so many positions nothing is below the names, and hardly any is left out: of mechanisms with few points none at all.
fn are_clear(page: &mut Page, name: &str, positions: usize, room: f64) {
    let last = last(page);
    for i in 0..positions {
        let row = i * last / (positions - 1);
        let covered = page.words(&format!("(() => {{ goTo({row}); return covered(); }})()"));
        assert_eq!(covered, "", "{name}, row {row} of {last}");
        let [shown, all] = ["shownNames()", "namesOfShownPoints()"]
            .map(|names| page.number(&format!("{names}.length")));
        let least = if all > FEW { room * all } else { all };
        assert!(
            shown > 0.0 && shown >= least,
            "{name}, row {row} of {last}: {shown} of {all} names"
        );
    }
}

/// Names stay where they are beside their points, but for some times from the first position to the last (a choice without memory: 30 times): what goes round drives a name
/// from one side to the next.
fn are_calm(page: &mut Page, name: &str) {
    let last = last(page);
    let jumps = page.number(&format!("jumps({last} + 1)"));
    let names = page.number("shownNames().length");
    assert!(
        jumps <= 18.0 * names,
        "{name}: {jumps} jumps of {names} names in {last} steps"
    );
}

#[test]
fn names_are_clear_of_everything_in_the_gallery() {
    for entry in some() {
        let Some(mut page) = named(&entry.page) else {
            return;
        };
        let positions = if entry.name == "favorit" { 61 } else { 25 };
        are_clear(&mut page, &entry.name, positions, ROOM[0]);
        are_calm(&mut page, &entry.name);
        page.shoot(&format!("names-{}", entry.name));
        page.screen(PHONE);
        are_clear(&mut page, &entry.name, positions, ROOM[1]);
        page.screen(DESKTOP);
        page.assert_quiet();
    }
}

#[test]
fn names_are_clear_of_everything() {
    let reports = [
        ("four-bar", four_bar("Names", FourBar::TURNING)),
        ("sliders", sliders()),
        ("space", spatial()),
    ];
    for (name, report) in reports {
        let Some(mut page) = named(&written(&report, &format!("clear-{name}"))) else {
            return;
        };
        are_clear(&mut page, name, 25, ROOM[0]);
        are_calm(&mut page, name);
        // Seen larger, and in space from another side.
        let middle = page.middle("#drawing");
        page.drag(
            (middle.0 - 120.0, middle.1 + 90.0),
            (middle.0 - 80.0, middle.1 + 50.0),
        );
        page.click("#nearer");
        let inside = "shownNames().every((name) => { const box = name.getBoundingClientRect(); const frame = document.querySelector('#figure').getBoundingClientRect(); return box.left >= frame.left && box.right <= frame.right && box.top >= frame.top && box.bottom <= frame.bottom; })";
        if page.holds(inside) {
            assert_eq!(page.value("covered()"), Value::from(""), "{name}, larger");
        }
        page.assert_quiet();
    }
}
