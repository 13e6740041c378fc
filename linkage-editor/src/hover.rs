//! The description of the word at a place.

use std::ops::Range;

use linkage_language::model::{Function, MotionLawWord, QuantityWord, plain_word};
use linkage_language::syntax::{ItemWord, LinkQuantity, Word, first_spelling, unit_description};

use crate::computed::Age;
use crate::context::{Region, next_solid, path_at, region};
use crate::declaration::NameKind;
use crate::document::Document;
use crate::facts::Facts;
use crate::lexer::Kind;
use crate::shown;
use crate::signature::{call_of_function, call_of_quantity};
use crate::uses::{Symbol, Use, declaration};

/// A description.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Hover {
    /// The words that it describes.
    pub range: Range<usize>,
    /// Its text, in Markdown.
    pub markdown: String,
}

/// Describes the word at a byte: kind, unit and value of a name, its range, its cost in
/// operations and its comment; the meaning of a word of the language or a unit.
pub(crate) fn hover(document: &Document, offset: usize) -> Option<Hover> {
    let described = match document.use_at(offset) {
        Some(found) => Hover {
            range: found.range.clone(),
            markdown: name_described(document, found),
        },
        None => word_described(document, offset)?,
    };
    Some(described)
}

/// Describes a word that is no declared name.
fn word_described(document: &Document, offset: usize) -> Option<Hover> {
    let index = document.token_at(offset)?;
    let token = &document.tokens[index];
    let text = token.text(&document.text);
    let (range, markdown) = match token.kind {
        Kind::Word => match quantity_of_link(document, index) {
            Some((range, markdown)) => (range, markdown),
            None => {
                let item = item_around(document, token.range.start);
                // `force (fx, fy)` at the beginning of an item is no call.
                let begins_item = item.as_deref() == Some("");
                let is_called = !begins_item && next_solid(document, index) == "(";
                let item = item.and_then(|word| ItemWord::from_word(&word));
                (token.range.clone(), word(text, is_called, item)?)
            }
        },
        Kind::Number => {
            let digits = text.trim_end_matches(|c: char| c.is_alphabetic()).len();
            let unit = unit(&text[digits..])?;
            (token.range.start + digits..token.range.end, unit)
        }
        _ => return None,
    };
    Some(Hover { range, markdown })
}

/// Returns the first word of the item of the struct block that contains a byte, an empty one at its
/// beginning.
fn item_around(document: &Document, offset: usize) -> Option<String> {
    match region(document, offset) {
        Region::Item => Some(String::new()),
        Region::Inside(_, word) => Some(word),
        Region::Outside | Region::Implementation | Region::Arguments(_) | Region::Quantities(_) => {
            None
        }
    }
}

/// Describes `coupler.length` at the word `length`.
fn quantity_of_link(document: &Document, index: usize) -> Option<(Range<usize>, String)> {
    let path = path_at(document, index)?;
    let outline = document.outline_at(path.range.start)?;
    let mechanism = &outline.mechanism.name;
    let fact = document.facts(mechanism)?.names.get(&path.name)?;
    let markdown = value_described(document, mechanism, &path.name, &format!("`{}`", path.name));
    Some((path.range, format!("{markdown}\n\n{}", fact.ty)))
}

/// Describes a declared name.
fn name_described(document: &Document, found: &Use) -> String {
    let declared = declaration(&document.outlines, found.symbol);
    let (outline, name, kind) = document.named(found.symbol);
    let mechanism = &outline.mechanism.name;
    let mut lines = match found.symbol {
        Symbol::Name(..) => {
            let fact = document
                .facts(mechanism)
                .and_then(|facts| facts.names.get(name));
            let ty = fact.map_or_else(String::new, |fact| format!(": {}", fact.ty));
            let head = format!("{} `{name}`{ty}", kind.word());
            let mut lines = value_described(document, mechanism, name, &head);
            lines += &effort(document, mechanism, name, kind);
            if let (NameKind::Link | NameKind::Slider, Some(facts)) =
                (kind, document.facts(mechanism))
            {
                lines += &link_described(document, facts, name);
            }
            lines
        }
        Symbol::Function(..) => {
            let compiled = document.function(mechanism, name);
            let operations = compiled.map_or_else(String::new, |compiled| {
                format!("\n\noperations: {}", compiled.operations)
            });
            format!("{} `{name}`{operations}", kind.word())
        }
        Symbol::Field(_, function, _) => {
            let function = &outline.functions[function].function.name;
            let compiled = document.function(mechanism, function);
            let quantity = compiled.and_then(|compiled| compiled.fields.get(name));
            let quantity = quantity.filter(|quantity| !quantity.is_empty());
            let quantity = quantity.map_or_else(String::new, |quantity| format!(": {quantity}"));
            format!("{} `{name}`{quantity}", kind.word())
        }
        Symbol::Mechanism(_) => format!("{} `{name}`", kind.word()),
    };
    if !declared.documentation.is_empty() {
        lines += &format!("\n\n---\n\n{}", declared.documentation);
    }
    lines
}

/// Returns the heading, the value at the reference and the extremes over the range.
fn value_described(document: &Document, mechanism: &str, name: &str, head: &str) -> String {
    let mut lines = head.to_owned();
    let Some(values) = document.values(mechanism) else {
        return lines;
    };
    let Some(value) = values.names.get(name) else {
        return lines;
    };
    let present = match document.age_of_values() {
        Age::Present => "",
        Age::Pending => " (before the last change)",
        Age::BeforeMistakes => " (before the last mistakes)",
    };
    lines += &format!(
        "\n\n`{}` at the reference{present}",
        shown::reference(value)
    );
    if let (Some(extremes), Some((input, unit, low, high))) =
        (shown::extremes(value), &values.range)
    {
        let [low, high] = [low, high].map(|end| shown::number(*end, unit));
        lines += &format!("\n\n{extremes} while `{input}` is {low} to {high}");
    }
    lines
}

/// Returns lines about a link: its joints, and its quantities at the reference.
fn link_described(document: &Document, facts: &Facts, name: &str) -> String {
    let mut lines = String::new();
    if let Some(joints) = facts.joints_of.get(name) {
        let noun = if joints.len() == 1 { "joint" } else { "joints" };
        lines += &format!("\n\n{} {noun}: `{}`", joints.len(), joints.join("`, `"));
    }
    let Some(values) = document.values(&facts.mechanism) else {
        return lines;
    };
    for quantity in LinkQuantity::all() {
        let quantity = format!("{name}.{}", quantity.word());
        if let Some(value) = values.names.get(&quantity) {
            let reference = shown::short(value);
            lines += &format!("\n\n`{quantity}` is `{reference}` at the reference");
        }
    }
    lines
}

/// Returns a line about the operations that a name costs.
fn effort(document: &Document, mechanism: &str, name: &str, kind: NameKind) -> String {
    let cost = match kind.has_cost() {
        true => document.cost(mechanism, name),
        false => None,
    };
    cost.map_or_else(String::new, |cost| format!("\n\noperations: {cost}"))
}

/// Describes a word of the language in an item that begins with another word.
fn word(text: &str, is_called: bool, item: Option<ItemWord>) -> Option<String> {
    if is_called {
        let called = Function::from_word(text)
            .map(|word| (call_of_function(word), word.description()))
            .or_else(|| {
                let word = QuantityWord::from_word(text)?;
                Some((call_of_quantity(word), word.description()))
            })
            .or_else(|| {
                let word = MotionLawWord::from_word(text)?;
                Some((word.form().to_owned(), word.description()))
            });
        if let Some((call, description)) = called {
            return Some(format!("`{call}`\n\n{description}"));
        }
    }
    match plain_word(text, item) {
        Some((_, description)) => Some(format!("`{text}`\n\n{description}")),
        None if text == "PI" => Some("`PI`\n\nHalf a turn, 3.14159...".to_owned()),
        None => unit(text),
    }
}

fn unit(text: &str) -> Option<String> {
    let (first, description) = (first_spelling(text)?, unit_description(text)?);
    Some(format!("unit `{first}`: {description}"))
}
