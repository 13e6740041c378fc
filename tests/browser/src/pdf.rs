//! The page as a printer and as a screen reader have it.

use crate::Page;
use miniz_oxide::inflate::decompress_to_vec_zlib;
use serde_json::{Value, json};
use std::collections::BTreeMap;

// The words of a printed page, read back from its PDF.
//
// Only what Chromium writes is read: compressed streams, and fonts whose glyphs have their letters in a table.

/// The texts of all pages, one a line, in the order in which they are printed.
///
/// # Panics
/// If it is no PDF of Chromium.
#[must_use]
pub fn printed_words(pdf: &[u8]) -> String {
    assert!(pdf.starts_with(b"%PDF"), "no PDF");
    let objects = objects(pdf);
    let fonts: BTreeMap<u32, Letters> = objects
        .iter()
        .filter_map(|(&number, object)| Some((number, letters(&objects, object)?)))
        .collect();
    let streams = objects.values().filter_map(|object| stream(object));
    let pages = streams.filter(|text| text.contains(" Tf\n"));
    let lines: Vec<String> = pages.map(|page| page_words(&page, &fonts)).collect();
    assert!(!lines.is_empty(), "no page with words");
    lines.join("\n")
}

/// Letters by glyph.
type Letters = BTreeMap<u32, String>;

/// The objects by number.
fn objects(pdf: &[u8]) -> BTreeMap<u32, &[u8]> {
    let mut found = BTreeMap::new();
    let mut rest = pdf;
    while let Some(begin) = position(rest, b" 0 obj") {
        let before = &rest[..begin];
        let digits = before.iter().rev().take_while(|c| c.is_ascii_digit());
        let number = &before[begin - digits.count()..];
        let end = position(&rest[begin..], b"endobj").map_or(rest.len(), |end| begin + end);
        let number = String::from_utf8_lossy(number);
        if let Ok(number) = number.parse() {
            found.insert(number, &rest[begin..end]);
        }
        rest = &rest[end..];
    }
    found
}

fn position(bytes: &[u8], wanted: &[u8]) -> Option<usize> {
    bytes
        .windows(wanted.len())
        .position(|window| window == wanted)
}

/// The text of an object's stream; `None` for pictures and fonts, which are no texts.
fn stream(object: &[u8]) -> Option<String> {
    let begin = position(object, b"stream")?;
    let dictionary = String::from_utf8_lossy(&object[..begin]);
    if !dictionary.contains("/FlateDecode") || dictionary.contains("/Image") {
        return None;
    }
    let data = &object[begin + b"stream".len()..];
    let data = data.strip_prefix(b"\r\n").or(data.strip_prefix(b"\n"))?;
    let text = decompress_to_vec_zlib(data).ok()?;
    String::from_utf8(text).ok()
}

/// The letters of a font; `None` for other objects.
fn letters(objects: &BTreeMap<u32, &[u8]>, object: &[u8]) -> Option<Letters> {
    let text = String::from_utf8_lossy(object);
    let (_, reference) = text.split_once("/ToUnicode ")?;
    let number = reference.split(' ').next()?.parse().ok()?;
    let table = stream(objects.get(&number)?)?;
    let mut found = Letters::new();
    for line in table.lines() {
        let codes: Vec<Vec<u16>> = line.split_whitespace().filter_map(code).collect();
        match &codes[..] {
            [glyph, letter] if glyph.len() == 1 => {
                found.insert(glyph[0].into(), String::from_utf16_lossy(letter));
            }
            [first, last, letter] if letter.len() == 1 => {
                for glyph in first[0]..=last[0] {
                    let letter = letter[0] + (glyph - first[0]);
                    found.insert(glyph.into(), String::from_utf16_lossy(&[letter]));
                }
            }
            _ => {}
        }
    }
    Some(found)
}

/// `<00240025>`
fn code(word: &str) -> Option<Vec<u16>> {
    let digits = word.strip_prefix('<')?.strip_suffix('>')?;
    let fours = digits.as_bytes().chunks(4);
    fours
        .map(|four| u16::from_str_radix(std::str::from_utf8(four).ok()?, 16).ok())
        .collect()
}

fn page_words(page: &str, fonts: &BTreeMap<u32, Letters>) -> String {
    let mut lines = Vec::new();
    let mut font = None;
    for block in page.split("BT\n").skip(1) {
        let (block, _) = block.split_once("ET").unwrap_or((block, ""));
        let mut line = String::new();
        for word in block.split_inclusive([' ', '\n', '>']).map(str::trim) {
            if let Some(name) = word.strip_prefix("/F") {
                font = name.parse().ok().and_then(|number: u32| fonts.get(&number));
            } else if let (Some(glyphs), Some(font)) =
                (word.find('<').and_then(|at| code(&word[at..])), font)
            {
                let shown = glyphs
                    .iter()
                    .filter_map(|&glyph| font.get(&u32::from(glyph)));
                line.extend(shown.map(String::as_str));
            }
        }
        lines.push(line);
    }
    lines.join("\n")
}

// The page as a screen reader has it.

/// The roles of elements that a reader can use, or that show something.
const ROLES: [&str; 14] = [
    "button",
    "checkbox",
    "combobox",
    "dialog",
    "Iframe",
    "image",
    "link",
    "radio",
    "region",
    "separator",
    "slider",
    "spinbutton",
    "tab",
    "textbox",
];

/// Returns the elements of the page and of its frames that a screen reader can use, or finds as
/// pictures: role and name.
pub fn accessible(page: &mut Page) -> Vec<(String, String)> {
    let frames = page.tools.call("Page.getFrameTree", json!({}));
    let tree = &frames["frameTree"];
    let inner = tree["childFrames"].as_array().into_iter().flatten();
    let frames = [tree].into_iter().chain(inner);
    let ids: Vec<Value> = frames.map(|frame| frame["frame"]["id"].clone()).collect();
    let mut found = Vec::new();
    for id in ids {
        let tree = (page.tools).call("Accessibility.getFullAXTree", json!({ "frameId": id }));
        let nodes = tree["nodes"].as_array().into_iter().flatten();
        found.extend(nodes.filter_map(used));
    }
    found
}

/// Role and name of a node, unless it is ignored or has none of the roles.
fn used(node: &Value) -> Option<(String, String)> {
    let role = node["role"]["value"].as_str()?;
    let name = node["name"]["value"].as_str().unwrap_or_default();
    let is_used = node["ignored"] != true && ROLES.contains(&role);
    is_used.then(|| (role.to_owned(), name.trim().to_owned()))
}
