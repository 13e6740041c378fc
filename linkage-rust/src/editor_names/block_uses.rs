//! The places of the macro's input where names are used, read from its tokens: an item that is half
//! written has its names, too.

use linkage_language::model::clauses_of;
use linkage_language::syntax::{DeclarationWord, ItemWord, LinkedWord, Word};
use proc_macro2::{Delimiter, Ident, TokenStream, TokenTree};

use super::reader::{Declares, Reader, is_punct};
use super::uses::Use;

/// A struct block or an `impl` block.
#[derive(Default)]
pub(super) struct Block {
    /// The mechanism's name.
    pub(super) name: String,
    /// This name after `impl`.
    pub(super) implemented: Option<Ident>,
    pub(super) uses: Vec<Use>,
    /// The results of its functions.
    pub(super) results: Vec<ResultType>,
}

/// The result type of a function.
pub(super) struct ResultType {
    pub(super) name: Ident,
    /// The names that are fields by themselves, as `s` in `{ s, speed: velocity(s) }`.
    pub(super) fields: Vec<String>,
}

/// Returns the blocks in the order of the text.
pub(super) fn blocks(tokens: TokenStream) -> Vec<Block> {
    let mut blocks = Vec::new();
    let mut word = None;
    let mut name: Option<Ident> = None;
    for token in tokens {
        match token {
            TokenTree::Ident(ident) if ident == "struct" || ident == "impl" => {
                word = Some(ident.to_string());
                name = None;
            }
            TokenTree::Ident(ident) => name = Some(ident),
            TokenTree::Group(group) if group.delimiter() == Delimiter::Brace => {
                let mechanism = name.take();
                let mut block = Block {
                    name: mechanism.as_ref().map(Ident::to_string).unwrap_or_default(),
                    ..Block::default()
                };
                match word.take().as_deref() {
                    Some("struct") => items(group.stream(), &mut block),
                    Some(_) => {
                        functions(group.stream(), &mut block);
                        block.implemented = mechanism;
                    }
                    None => continue,
                }
                blocks.push(block);
            }
            TokenTree::Group(_) | TokenTree::Punct(_) | TokenTree::Literal(_) => {}
        }
    }
    blocks
}

/// Items end with `;`.
fn items(tokens: TokenStream, block: &mut Block) {
    let tokens: Vec<TokenTree> = tokens.into_iter().collect();
    for item in tokens.split(|token| is_punct(Some(token), ';')) {
        let is_attribute = |token: &TokenTree| match token {
            TokenTree::Punct(punct) => punct.as_char() == '#',
            TokenTree::Group(group) => group.delimiter() == Delimiter::Bracket,
            TokenTree::Ident(_) | TokenTree::Literal(_) => false,
        };
        let attributes = item.iter().take_while(|token| is_attribute(token)).count();
        let Some((TokenTree::Ident(first), rest)) = item[attributes..].split_first() else {
            continue;
        };
        block.uses.push(Use::Item(first.clone()));
        let word = ItemWord::from_word(&first.to_string());
        let clauses = word.and_then(clauses_of);
        let mut reader = Reader {
            clauses,
            uses: &mut block.uses,
        };
        let declares = word.map_or(Declares::Nothing, declares);
        match (word, rest) {
            (Some(ItemWord::Declaration(DeclarationWord::Unit)), [TokenTree::Ident(unit)]) => {
                reader.uses.push(Use::Unit(unit.clone()));
            }
            (Some(ItemWord::Declaration(DeclarationWord::Body)), [name, equals, rest @ ..])
                if is_punct(Some(equals), '=') =>
            {
                reader.expression(std::slice::from_ref(name), declares);
                reader.joint(rest);
            }
            _ => reader.expression(rest, declares),
        }
        block.uses.push(Use::EndOfItem(clauses));
    }
    block.uses.push(Use::EndOfBlock);
}

fn declares(word: ItemWord) -> Declares {
    match word {
        ItemWord::Declaration(word) => match word {
            DeclarationWord::Unit | DeclarationWord::Loop | DeclarationWord::Gravity => {
                Declares::Nothing
            }
            DeclarationWord::Const
            | DeclarationWord::Param
            | DeclarationWord::Input
            | DeclarationWord::Unknown
            | DeclarationWord::Let
            | DeclarationWord::Argument
            | DeclarationWord::Part
            | DeclarationWord::Body
            | DeclarationWord::Arc => Declares::First,
        },
        ItemWord::Joint(_) => Declares::First,
        ItemWord::Load(_) => Declares::Nothing,
        ItemWord::Linked(word) => match word {
            LinkedWord::Joint => Declares::Several,
            LinkedWord::Link | LinkedWord::Slider => Declares::First,
            LinkedWord::Gears | LinkedWord::Belt | LinkedWord::Weld => Declares::Nothing,
        },
    }
}

/// `pub fn NAME(inputs) -> TYPE { quantities }`
fn functions(tokens: TokenStream, block: &mut Block) {
    let mut last = None;
    for token in tokens {
        match token {
            TokenTree::Ident(ident) => last = Some(ident),
            TokenTree::Group(group) => {
                let inner: Vec<TokenTree> = group.stream().into_iter().collect();
                let mut reader = Reader {
                    clauses: None,
                    uses: &mut block.uses,
                };
                match group.delimiter() {
                    Delimiter::Parenthesis => reader.expression(&inner, Declares::Nothing),
                    Delimiter::Brace => {
                        let fields = reader.quantities(&inner);
                        let name = last.take();
                        block
                            .results
                            .extend(name.map(|name| ResultType { name, fields }));
                    }
                    Delimiter::Bracket | Delimiter::None => continue,
                }
                block.uses.push(Use::EndOfItem(None));
            }
            TokenTree::Punct(_) | TokenTree::Literal(_) => {}
        }
    }
}
