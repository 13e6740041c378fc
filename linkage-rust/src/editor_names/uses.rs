//! The places of the macro's input where names are used, read from its tokens: an item that is half
//! written has its names, too.

use crate::spanned::aside;
use linkage_language::syntax::{ItemWord, LinkedWord, Word, is_clause_word, is_unit};
use proc_macro2::{Delimiter, Ident, TokenStream, TokenTree};

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

/// A word where it is written.
pub(super) enum Use {
    /// A name, and the names after its dots.
    Name { path: Vec<Ident>, declares: bool },
    /// The word in front of a parenthesis.
    Call(Ident),
    /// The word that an item or a clause begins with.
    Item(Ident),
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
        let declares = ItemWord::from_word(&first.to_string()).map_or(Declares::Nothing, declares);
        expression(rest, declares, &mut block.uses);
    }
}

/// The declared names of an item.
#[derive(Clone, Copy, PartialEq)]
enum Declares {
    Nothing,
    /// The first name.
    First,
    /// Each name in front of `=`.
    Several,
}

fn declares(word: ItemWord) -> Declares {
    use linkage_language::syntax::DeclarationWord as Word;
    match word {
        ItemWord::Declaration(word) => match word {
            Word::Unit | Word::Loop | Word::Gravity => Declares::Nothing,
            Word::Const | Word::Param | Word::Input | Word::Unknown => Declares::First,
            Word::Let | Word::Argument | Word::Part | Word::Body | Word::Arc => Declares::First,
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
                match group.delimiter() {
                    Delimiter::Parenthesis => {
                        expression(&inner, Declares::Nothing, &mut block.uses);
                    }
                    Delimiter::Brace => {
                        let fields = quantities(&inner, &mut block.uses);
                        let name = last.take();
                        block
                            .results
                            .extend(name.map(|name| ResultType { name, fields }));
                    }
                    Delimiter::Bracket | Delimiter::None => {}
                }
            }
            TokenTree::Punct(_) | TokenTree::Literal(_) => {}
        }
    }
}

/// Returns the names that are fields by themselves.
fn quantities(tokens: &[TokenTree], uses: &mut Vec<Use>) -> Vec<String> {
    let mut fields = Vec::new();
    for quantity in tokens.split(|token| is_punct(Some(token), ',')) {
        let named = quantity
            .iter()
            .rposition(|token| is_punct(Some(token), '#'))
            .map_or(quantity, |doc| &quantity[(doc + 2).min(quantity.len())..]);
        match named {
            [TokenTree::Ident(_), colon, value @ ..] if is_punct(Some(colon), ':') => {
                expression(value, Declares::Nothing, uses);
            }
            _ => {
                expression(named, Declares::Nothing, uses);
                if let [TokenTree::Ident(field)] = named {
                    fields.push(field.to_string());
                }
            }
        }
    }
    fields
}

fn expression(tokens: &[TokenTree], declares: Declares, uses: &mut Vec<Use>) {
    let mut index = 0;
    // After a value, the word of a clause is no name.
    let mut is_after_value = false;
    while let Some(token) = tokens.get(index) {
        let is_word = is_after_value
            || is_punct(
                index.checked_sub(1).and_then(|before| tokens.get(before)),
                ',',
            ) && begins_clause(&tokens[index + 1..]);
        is_after_value = !matches!(token, TokenTree::Punct(_));
        index += 1;
        match token {
            TokenTree::Group(group) => {
                let inner: Vec<TokenTree> = group.stream().into_iter().collect();
                match (group.delimiter(), tokens.first()) {
                    (Delimiter::Brace, Some(TokenTree::Ident(part))) => given(part, &inner, uses),
                    _ => expression(&inner, Declares::Nothing, uses),
                }
            }
            TokenTree::Ident(name) if is_word && is_clause_word(&name.to_string()) => {
                is_after_value = false;
                uses.push(Use::Item(name.clone()));
            }
            TokenTree::Ident(name) => {
                let declares = match declares {
                    Declares::Nothing => false,
                    Declares::First => index == 1,
                    Declares::Several => is_punct(tokens.get(index), '='),
                };
                let mut path = vec![name.clone()];
                while let (true, Some(TokenTree::Ident(member))) =
                    (is_punct(tokens.get(index), '.'), tokens.get(index + 1))
                {
                    path.push(member.clone());
                    index += 2;
                }
                let is_call = matches!(tokens.get(index), Some(TokenTree::Group(group))
                    if group.delimiter() == Delimiter::Parenthesis);
                uses.push(match is_call && !declares {
                    true => Use::Call(name.clone()),
                    false => Use::Name { path, declares },
                });
            }
            TokenTree::Punct(_) | TokenTree::Literal(_) => {}
        }
    }
}

/// Returns true for tokens that can follow the word of a clause.
fn begins_clause(tokens: &[TokenTree]) -> bool {
    let is_plain = |index| match tokens.get(index) {
        Some(TokenTree::Ident(name)) => !is_clause_word(&name.to_string()),
        Some(TokenTree::Group(_) | TokenTree::Literal(_)) => true,
        Some(TokenTree::Punct(_)) | None => false,
    };
    let is_named = matches!(tokens.first(), Some(TokenTree::Ident(_))) && !is_plain(1);
    is_plain(0) || is_named
}

/// `NAME = expression, ...` of a part: the names are those of its mechanism.
fn given(part: &Ident, tokens: &[TokenTree], uses: &mut Vec<Use>) {
    for one in tokens.split(|token| is_punct(Some(token), ',')) {
        let (name, value) = match one {
            [TokenTree::Ident(name), equals, value @ ..] if is_punct(Some(equals), '=') => {
                (Some(name), value)
            }
            _ => (None, one),
        };
        uses.extend(name.map(|name| Use::Name {
            path: vec![aside(part), name.clone()],
            declares: false,
        }));
        expression(value, Declares::Nothing, uses);
    }
}

fn is_punct(token: Option<&TokenTree>, wanted: char) -> bool {
    matches!(token, Some(TokenTree::Punct(punct)) if punct.as_char() == wanted)
}

/// Returns true for a word of clauses or of units that has no meaning alone: it may be a name, but
/// not one that is missing.
pub(super) fn is_word(word: &str) -> bool {
    const OTHERS: [&str; 10] = [
        "around",
        "block",
        "by",
        "in",
        "length",
        "radii",
        "radius",
        "redundant",
        "teeth",
        "through",
    ];
    is_unit(word) || OTHERS.contains(&word)
}
