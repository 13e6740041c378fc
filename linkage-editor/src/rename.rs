//! Renaming.

use std::ops::Range;

use crate::declaration::NameKind;
use crate::diagnostics::Edit;
use crate::document::Document;
use crate::lexer::{Kind, tokens};
use crate::uses::{Symbol, declaration};
use linkage_language::syntax::{MarkWord, Word, is_keyword};

/// Returns the bytes of the name at a byte that can be renamed.
pub(crate) fn renamable(document: &Document, offset: usize) -> Option<Range<usize>> {
    let found = document.use_at(offset)?;
    (!is_frame(document, found.symbol)).then(|| found.range.clone())
}

/// Returns the changes that give the name at a byte another text. Fields of results keep their
/// names: `{ tracer }` becomes `{ tracer: pen }`.
///
/// # Errors
///
/// The reason, if there is no name at the byte, the new text is no name, or another name has it.
pub(crate) fn renamed(document: &Document, offset: usize, name: &str) -> Result<Vec<Edit>, String> {
    let found = document.use_at(offset).ok_or("there is no name here")?;
    if is_frame(document, found.symbol) {
        return Err("`frame` is the link that does not move, and keeps its name".to_owned());
    }
    let is_name = matches!(&tokens(name)[..], [only] if only.kind == Kind::Word);
    if !is_name || name.starts_with("__") || is_keyword(name) {
        return Err(format!("`{name}` is no name"));
    }
    let is_taken = match found.symbol {
        Symbol::Mechanism(_) => {
            let mut outlines = document.outlines.iter();
            outlines.any(|outline| outline.mechanism.name == name)
        }
        Symbol::Name(mechanism, _) => document.outlines[mechanism].find(name).is_some(),
        Symbol::Function(mechanism, _) => {
            let mut functions = document.outlines[mechanism].functions.iter();
            functions.any(|function| function.function.name == name)
        }
        Symbol::Field(mechanism, function, _) => {
            let mut fields = document.outlines[mechanism].functions[function]
                .fields
                .iter();
            fields.any(|field| field.name == name)
        }
    };
    if is_taken && document.text.get(found.range.clone()) != Some(name) {
        return Err(format!("there is another `{name}`"));
    }
    let uses = document
        .uses
        .iter()
        .filter(|other| other.symbol == found.symbol);
    let edit = |range: &Range<usize>, is_shorthand| Edit {
        range: range.clone(),
        text: match is_shorthand {
            true => format!("{}: {name}", &document.text[range.clone()]),
            false => name.to_owned(),
        },
    };
    Ok(uses
        .map(|other| edit(&other.range, other.is_shorthand))
        .collect())
}

/// Returns true for the link that does not move: another name is another link.
fn is_frame(document: &Document, symbol: Symbol) -> bool {
    let declared = declaration(&document.outlines, symbol);
    declared.kind == NameKind::Link && declared.name == MarkWord::Frame.word()
}
