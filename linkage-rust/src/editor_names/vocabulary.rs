//! Words of the language as items that editors know: their meanings in hovers, and words among the
//! completions.

use linkage_language::model::{CalledWord, WordClass, WordRow, words_of_class};
use linkage_language::syntax::{
    MarkWord, Vocabulary, Word, first_spelling, is_keyword, unit_description, unit_names,
};
use proc_macro2::{Ident, Span, TokenStream};
use quote::{format_ident, quote};

use super::uses::Clauses;

/// The vocabularies of words within items.
const CLAUSES: [Clauses; 5] = [
    None,
    Some(Vocabulary::ClauseWord),
    Some(Vocabulary::LinkClause),
    Some(Vocabulary::SliderWord),
    Some(Vocabulary::WheelsWord),
];

/// The arguments whose fields are the words of the language.
pub(super) fn receivers() -> TokenStream {
    let (words, units) = (items(), units());
    let clauses = CLAUSES.map(|vocabulary| {
        let (argument, holder) = (clauses(vocabulary), clauses_holder(vocabulary));
        quote!(#argument: #holder,)
    });
    let keywords = keywords();
    quote!(#words: __words, #keywords: __keywords, #units: __units, #(#clauses)*)
}

/// The types of these arguments.
pub(super) fn types() -> TokenStream {
    let of_items = fields(item_rows());
    let of_keywords = fields(keyword_rows());
    let of_units = unit_names().filter_map(|unit| Some((unit, unit_description(unit)?)));
    let of_units = fields(of_units);
    let clauses = CLAUSES.map(|vocabulary| {
        let (holder, fields) = (clauses_holder(vocabulary), fields(clause_rows(vocabulary)));
        quote!(struct #holder { #fields })
    });
    quote! {
        struct __words { #of_items }
        struct __keywords { #of_keywords }
        struct __units { #of_units }
        #(#clauses)*
    }
}

/// The fields of words and their meanings.
fn fields(rows: impl IntoIterator<Item = WordRow>) -> TokenStream {
    let fields = rows.into_iter().map(|(word, meaning)| {
        let field = name_of_rust(&Ident::new(word, Span::call_site()));
        quote!(#[doc = #meaning] #field: (),)
    });
    fields.collect()
}

/// The argument whose fields are the words that items begin with.
pub(super) fn items() -> Ident {
    Ident::new("__w", Span::call_site())
}

/// The argument whose fields are the words that are keywords of Rust: completions would write `r#let`.
fn keywords() -> Ident {
    Ident::new("__k", Span::call_site())
}

fn units() -> Ident {
    Ident::new("__u", Span::call_site())
}

/// The argument whose fields are the words within an item.
pub(super) fn clauses(vocabulary: Clauses) -> Ident {
    format_ident!("__c{}", number(vocabulary))
}

fn clauses_holder(vocabulary: Clauses) -> Ident {
    format_ident!("__clauses{}", number(vocabulary))
}

fn number(vocabulary: Clauses) -> usize {
    let mut known = CLAUSES.iter();
    known.position(|known| *known == vocabulary).unwrap_or(0)
}

/// Returns the words of a list that are keywords of Rust, or the others.
fn chosen(rows: Vec<WordRow>, keywords: bool) -> Vec<WordRow> {
    let chosen = |(word, _): &WordRow| is_keyword(word) == keywords;
    rows.into_iter().filter(chosen).collect()
}

/// Returns the words that items begin with, except for keywords of Rust.
fn item_rows() -> Vec<WordRow> {
    chosen(words_of_class(WordClass::Item), false)
}

/// Returns the words that are keywords of Rust.
fn keyword_rows() -> Vec<WordRow> {
    let marks = words_of_class(WordClass::Clause);
    let words = words_of_class(WordClass::Item).into_iter().chain(marks);
    chosen(words.collect(), true)
}

/// Returns the words within an item, except for keywords of Rust: its clauses, marks and courses.
fn clause_rows(vocabulary: Clauses) -> Vec<WordRow> {
    let marks = MarkWord::all().map(|word| (word.word(), word.description()));
    let courses = words_of_class(WordClass::Course);
    let others: Vec<WordRow> = marks.chain(courses).collect();
    let mut rows = vocabulary.map_or_else(Vec::new, Vocabulary::rows);
    for other in others {
        if !rows.iter().any(|(word, _)| *word == other.0) {
            rows.push(other);
        }
    }
    chosen(rows, false)
}

/// The access to the word of an item.
pub(super) fn item(word: &Ident) -> TokenStream {
    access(&items(), word)
}

/// The access to a word within an item.
pub(super) fn clause(word: &Ident, vocabulary: Clauses) -> TokenStream {
    access(&clauses(vocabulary), word)
}

/// The access to a unit, by its first spelling.
pub(super) fn unit(unit: &Ident) -> TokenStream {
    let spelling = first_spelling(&unit.to_string());
    let unit = spelling.map_or_else(|| unit.clone(), |name| Ident::new(name, unit.span()));
    access(&units(), &unit)
}

/// The access to a word, or to one that is being written. A keyword of Rust is after a statement with
/// the receiver of the other words.
fn access(receiver: &Ident, word: &Ident) -> TokenStream {
    if !is_keyword(&word.to_string()) {
        return quote!(#receiver.#word;);
    }
    let is_known = keyword_rows().iter().any(|(known, _)| word == known);
    let keyword = is_known.then(|| {
        let (keywords, name) = (keywords(), name_of_rust(word));
        quote!(#keywords.#name;)
    });
    quote!(#receiver; #keyword)
}

/// A word as a name of Rust, where it is written.
fn name_of_rust(word: &Ident) -> Ident {
    match is_keyword(&word.to_string()) {
        true => Ident::new_raw(&word.to_string(), word.span()),
        false => word.clone(),
    }
}

/// Returns true for a word of a law of motion.
pub(super) fn is_course(word: &Ident) -> bool {
    let courses = words_of_class(WordClass::Course);
    courses.iter().any(|(course, _)| word == course)
}

/// Returns true for a function of expressions or a quantity.
pub(super) fn is_function(word: &str) -> bool {
    CalledWord::from_word(word).is_some()
}

/// The functions as methods of the names of a mechanism: where a name can be written, they can.
pub(super) fn methods(holder: &Ident) -> TokenStream {
    let methods = functions().map(|(word, arguments, meaning)| {
        let name = format_ident!("{word}");
        let arguments = arguments.iter().enumerate().map(|(index, argument)| {
            // Some may be left out, and some come twice.
            let plain = argument.trim_end_matches('?').trim_matches(['[', ']']);
            let is_second = arguments[..index]
                .iter()
                .any(|before| before.starts_with(plain));
            let number = if is_second { "2" } else { "" };
            let argument = Ident::new_raw(&format!("{plain}{number}"), Span::call_site());
            quote!(#argument: f64)
        });
        quote!(#[doc = #meaning] fn #name(&self, #(#arguments),*) {})
    });
    quote!(impl #holder { #(#methods)* })
}

/// Each word with its arguments and its meaning.
fn functions() -> impl Iterator<Item = (&'static str, &'static [&'static str], &'static str)> {
    CalledWord::all().map(|called| {
        let arguments = match called {
            CalledWord::Function(function) => function.parameters(),
            CalledWord::Quantity(quantity) => quantity.parameters(),
            // Their arguments are knots and words.
            CalledWord::Law(_) => &[],
        };
        (called.word(), arguments, called.description())
    })
}
