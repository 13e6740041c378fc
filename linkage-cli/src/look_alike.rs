//! Warnings of names that look alike, as those of rustc for Rust code.

use std::collections::BTreeMap;

use linkage_compiler::{Message, SourceSpan, shortened};
use linkage_engine::{MechanismCall, Source, rendered_warning};
use proc_macro2::{Span, TokenStream, TokenTree};
use unicode_security::confusable_detection::skeleton;

use crate::confusable::{letters, look_alike};

/// A warning for each name that looks like an earlier one, a blank line after each.
pub(crate) fn look_alikes(source: &Source, found: &MechanismCall, coloured: bool) -> String {
    let mut names = BTreeMap::new();
    collect(found.tokens.clone(), &mut names);
    if names.keys().all(|name| name.is_ascii()) {
        return String::new();
    }
    let mut in_order: Vec<(String, Span)> = names.into_iter().collect();
    in_order.sort_by_key(|(_, span)| span.byte_range().start);
    // The first name of each look.
    let mut looks: BTreeMap<String, String> = BTreeMap::new();
    let mut text = String::new();
    for (name, span) in in_order {
        let look: String = skeleton(&name).collect();
        match looks.get(&look) {
            None => {
                looks.insert(look, name);
            }
            Some(first) if !look_alike(&name, first) => {}
            Some(first) => {
                let message = Message::new(SourceSpan::single(span), &warning(&name, first));
                text += &rendered_warning(source, found, &message, coloured);
            }
        }
    }
    text
}

/// All names, with the place where each stands first.
fn collect(tokens: TokenStream, names: &mut BTreeMap<String, Span>) {
    for token in tokens {
        match token {
            TokenTree::Ident(name) => {
                names.entry(name.to_string()).or_insert_with(|| name.span());
            }
            TokenTree::Group(group) => collect(group.stream(), names),
            TokenTree::Punct(_) | TokenTree::Literal(_) => {}
        }
    }
}

fn warning(name: &str, first: &str) -> String {
    format!(
        "`{}` looks like `{}`, and is another name: {}\n\
         help: write both with the same letters if one name is meant, else choose another name",
        shortened(name),
        shortened(first),
        letters(name, first)
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    fn warned(text: &str) -> String {
        let source = Source::new("own.mech", text).expect("tokens");
        look_alikes(&source, &source.calls()[0], false)
    }

    #[test]
    fn letters_of_other_scripts_are_told_by_their_numbers() {
        let text = warned("struct S { param a = 1mm; param \u{430} = 2mm; let b = a - \u{430}; }");
        let expected =
            "warning: `\u{430}` looks like `a`, and is another name: U+0430 instead of U+0061\n";
        assert!(text.starts_with(expected), "{text}");
        assert_eq!(text.matches("warning").count(), 1, "{text}");
        assert!(text.contains("own.mech:1:33"), "{text}");
    }

    #[test]
    fn names_that_differ_or_are_one_are_no_mistake() {
        // Also one name in two spellings, and letters of ASCII.
        for text in [
            "struct S { param \u{3c6} = 1mm; param a = 2mm; }",
            "struct S { param r\u{e9} = 1mm; let b = re\u{301}; }",
            "struct S { param l1 = 1mm; param ll = 2mm; }",
        ] {
            assert_eq!(warned(text), "", "{text}");
        }
    }
}
