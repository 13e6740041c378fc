//! Several drawings of the same things as one that moves.

use std::format;
use std::string::{String, ToString};
use std::vec::Vec;

use super::{Element, Mark, Svg};
use crate::characters::escaped;

/// Numbers that move are rounded to so many parts of a unit, a hundredth of a millimetre on paper:
/// every position is written out, and finer steps are not seen.
const PARTS: f64 = 100.0;

impl Svg {
    /// The first of these drawings, in which all that differs runs through the others, back to the
    /// first, and again, in so many seconds. `None` if they do not consist of the same things, or
    /// differ in more than numbers.
    pub fn film(frames: Vec<Self>, seconds: f64) -> Option<String> {
        let first = frames.first()?;
        if frames
            .iter()
            .any(|frame| frame.marks.len() != first.marks.len())
        {
            return None;
        }
        let mut text = first.head();
        for (index, mark) in first.marks.iter().enumerate() {
            let run = frames.iter().map(|frame| frame.marks[index].element(mark));
            let run: Vec<Option<&Element>> = run.collect::<Option<_>>()?;
            let moves = match run.into_iter().collect::<Option<Vec<_>>>() {
                Some(run) => moves(&run, seconds)?,
                None => String::new(),
            };
            text.push_str(&mark.moved(&moves));
        }
        text.push_str("</svg>\n");
        Some(text)
    }
}

impl Mark {
    /// The element of a mark that is of the same kind as another, `Some(None)` if this kind has
    /// none.
    fn element(&self, like: &Self) -> Option<Option<&Element>> {
        match (self, like) {
            (Self::Alone(element), Self::Alone(_)) | (Self::Begin(element), Self::Begin(_)) => {
                Some(Some(element))
            }
            (Self::Words(element, words), Self::Words(_, other)) if words == other => {
                Some(Some(element))
            }
            (Self::End(tag), Self::End(other)) if tag == other => Some(None),
            _ => None,
        }
    }

    /// Writes the piece with the elements that animate it.
    fn moved(&self, moves: &str) -> String {
        match self {
            Self::Alone(element) if moves.is_empty() => format!("{}/>\n", element.start()),
            Self::Alone(element) => format!("{}>{moves}</{}>\n", element.start(), element.tag),
            Self::Begin(element) => format!("{}>{moves}\n", element.start()),
            Self::End(tag) => format!("</{tag}>\n"),
            Self::Words(element, words) => {
                let words = escaped(words);
                format!("{}>{words}{moves}</{}>\n", element.start(), element.tag)
            }
        }
    }
}

/// Returns the animations of an element, none for attributes that stay. `None` if the elements are
/// not alike.
fn moves(run: &[&Element], seconds: f64) -> Option<String> {
    let first = run.first()?;
    let alike = |element: &&Element| {
        let names = element.attributes.iter().map(|(name, _)| name);
        element.tag == first.tag
            && element.classes == first.classes
            && names.eq(first.attributes.iter().map(|(name, _)| name))
    };
    if !run.iter().all(alike) {
        return None;
    }
    let mut moves = String::new();
    for (index, (name, value)) in first.attributes.iter().enumerate() {
        let run = run.iter().map(|run| run.attributes[index].1.as_str());
        if run.clone().all(|run| run == value) {
            continue;
        }
        let values: Vec<String> = run
            .chain([value.as_str()])
            .map(coarse)
            .collect::<Option<_>>()?;
        // Between lists of different lengths there is no way.
        let count = |values: &String| values.split([' ', ',']).count();
        if values.iter().any(|value| count(value) != count(&values[0])) {
            return None;
        }
        moves.push_str(&format!(
            "<animate attributeName=\"{name}\" dur=\"{seconds}s\" repeatCount=\"indefinite\" values=\"{}\"/>",
            values.join(";")
        ));
    }
    Some(moves)
}

/// Numbers, or pairs of them, without digits that are not seen. `None` for anything else.
fn coarse(value: &str) -> Option<String> {
    let pairs = value.split(' ').map(|pair| {
        let numbers = pair.split(',').map(|number| {
            let number: f64 = number.parse().ok()?;
            // The sum makes a zero positive.
            Some(((number * PARTS).round() / PARTS + 0.0).to_string())
        });
        Some(numbers.collect::<Option<Vec<_>>>()?.join(","))
    });
    Some(pairs.collect::<Option<Vec<_>>>()?.join(" "))
}
