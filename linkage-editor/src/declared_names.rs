//! The names that an item of a struct block declares.

use std::ops::Range;

use linkage_language::syntax::{DeclarationWord, ItemWord, LinkedWord, Word};

use crate::cursor::Cursor;
use crate::declaration::{Declaration, NameKind};
use crate::lexer::{Kind, Token};
use crate::statements::documentation;

/// Returns the names that an item of a struct block declares.
pub(crate) fn declared(text: &str, tokens: &[Token], item: &Range<usize>) -> Vec<Declaration> {
    let mut cursor = Cursor::within(text, tokens, item);
    let Some(word) = cursor
        .next()
        .and_then(|token| ItemWord::from_word(token.text(text)))
    else {
        return Vec::new();
    };
    let documentation = documentation(text, tokens, item.clone());
    let declaration = |name: &Token, kind, value| Declaration {
        name: name.text(text).to_owned(),
        kind,
        range: name.range.clone(),
        item: item.clone(),
        value,
        mechanism: None,
        documentation: documentation.clone(),
    };
    let mut found = Vec::new();
    let Some(name) = cursor.next_if(Kind::Word) else {
        return found;
    };
    let value = cursor.clone().value();
    match (word, name_kind(word)) {
        (ItemWord::Linked(LinkedWord::Joint), Some(kind)) => {
            found.push(declaration(&name, kind, value));
            while cursor.skip_past(',') {
                let Some(name) = cursor.next_if(Kind::Word) else {
                    break;
                };
                found.push(declaration(&name, kind, cursor.clone().value()));
            }
        }
        (ItemWord::Declaration(DeclarationWord::Part), Some(kind)) => {
            let mechanism = cursor
                .skip_past(':')
                .then(|| cursor.next_if(Kind::Word))
                .flatten();
            let mechanism = mechanism.map(|name| name.text(text).to_owned());
            found.push(Declaration {
                mechanism,
                ..declaration(&name, kind, None)
            });
        }
        (ItemWord::Declaration(DeclarationWord::Input), Some(kind)) => {
            found.push(declaration(&name, kind, value));
            if cursor.skip_past_word("at") {
                let rates = std::iter::from_fn(|| {
                    let name = cursor.next_if(Kind::Word)?;
                    cursor.skip_past(',');
                    Some(name)
                });
                let rates: Vec<Token> = rates.take(2).collect();
                found.extend(
                    rates
                        .iter()
                        .map(|name| declaration(name, NameKind::Argument, None)),
                );
            }
        }
        (ItemWord::Declaration(DeclarationWord::Body), Some(kind)) => {
            found.push(declaration(&name, kind, None));
            // `body rod = pin a on crank at ...`: the joint may have a name.
            if cursor.skip_past('=')
                && cursor.next().is_some()
                && let Some(joint) = cursor.next_if(Kind::Word)
                && joint.text(text) != "on"
            {
                found.push(declaration(&joint, NameKind::Joint, None));
            }
        }
        (ItemWord::Linked(LinkedWord::Link), Some(kind)) => {
            found.push(declaration(&name, kind, None));
        }
        (_, Some(kind)) => found.push(declaration(&name, kind, value)),
        (_, None) => {}
    }
    found
}

/// Returns the kind of the name after a word; `None` if none is declared there.
fn name_kind(word: ItemWord) -> Option<NameKind> {
    match word {
        ItemWord::Declaration(word) => match word {
            DeclarationWord::Const => Some(NameKind::Constant),
            DeclarationWord::Param => Some(NameKind::Parameter),
            DeclarationWord::Input => Some(NameKind::Input),
            DeclarationWord::Unknown => Some(NameKind::Unknown),
            DeclarationWord::Let => Some(NameKind::Derived),
            DeclarationWord::Argument => Some(NameKind::Argument),
            DeclarationWord::Part => Some(NameKind::Part),
            DeclarationWord::Body => Some(NameKind::Body),
            DeclarationWord::Arc => Some(NameKind::Slot),
            DeclarationWord::Unit | DeclarationWord::Loop | DeclarationWord::Gravity => None,
        },
        ItemWord::Joint(_) => Some(NameKind::Joint),
        ItemWord::Load(_) => None,
        ItemWord::Linked(word) => match word {
            LinkedWord::Joint => Some(NameKind::Joint),
            LinkedWord::Link => Some(NameKind::Link),
            LinkedWord::Slider => Some(NameKind::Slider),
            LinkedWord::Gears | LinkedWord::Belt | LinkedWord::Weld => None,
        },
    }
}
