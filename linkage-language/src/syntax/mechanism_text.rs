//! A mechanism in the language.

use super::ast::{Attribute, FunctionDef, Item, MechanismDef, documentation};
use super::dump::Line;
use super::expression_tree::ExprKind;

/// Returns the struct block and the functions of a mechanism as a text that can be compiled again.
/// Comments other than doc comments are not kept.
pub fn mechanism_text(definition: &MechanismDef) -> String {
    let mut text = attributes(&definition.attributes, "");
    let head = |word: &str| {
        let visibility = definition.visibility.to_string();
        let blank = if visibility.is_empty() { "" } else { " " };
        format!("{visibility}{blank}{word}")
    };
    text.push_str(&format!("{} {} {{\n", head("struct"), definition.name));
    for item in &definition.items {
        if let Item::Param(item) = item {
            text.push_str(&attributes(&item.attributes, "    "));
        }
        text.push_str(&format!("    {:#};\n", Line(item)));
    }
    text.push_str("}\n");
    if !definition.functions.is_empty() {
        text.push_str(&format!("impl {} {{\n", definition.name));
        for function in &definition.functions {
            text.push_str(&function_text(function));
        }
        text.push_str("}\n");
    }
    text
}

/// Returns an item without its attributes and its `;`.
pub fn item_text(item: &Item) -> String {
    format!("{:#}", Line(item))
}

fn function_text(function: &FunctionDef) -> String {
    let visibility = function.visibility.to_string();
    let blank = if visibility.is_empty() { "" } else { " " };
    let inputs: Vec<String> = function.inputs.iter().map(ToString::to_string).collect();
    let mut text = attributes(&function.attributes, "    ");
    text.push_str(&format!(
        "    {visibility}{blank}fn {}({}) -> {} {{\n",
        function.name,
        inputs.join(", "),
        function.result
    ));
    for quantity in &function.quantities {
        text.push_str(&attributes(&quantity.attributes, "        "));
        let field = &quantity.field;
        let line = match &quantity.value.kind {
            ExprKind::Name(name) if name == field => format!("        {field},\n"),
            _ => format!("        {field}: {:#},\n", quantity.value),
        };
        text.push_str(&line);
    }
    text + "    }\n"
}

/// Returns a line for each attribute, doc comments as such.
fn attributes(attributes: &[Attribute], indent: &str) -> String {
    let lines = attributes.iter().map(|attribute| {
        if attribute.name == "doc" {
            let doc = documentation(std::slice::from_ref(attribute));
            format!("{indent}/// {doc}\n")
        } else {
            format!("{indent}{}\n", attribute.tokens)
        }
    });
    lines.collect()
}
