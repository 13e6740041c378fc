//! The structure of a text by its tokens: mechanisms, their items and functions, declared names.
//!
//! It needs no text that can be compiled. An item that is being written does not hide the others.

use std::ops::Range;

use linkage_language::syntax::{DeclarationWord, ItemWord, LinkedWord, Word};

use crate::cursor::Cursor;
use crate::lexer::{Kind, Token};
use crate::statements::{documentation, statements};

/// The kind of a declared name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NameKind {
    /// A mechanism.
    Mechanism,
    /// A value known at compile time.
    Constant,
    /// A dimension.
    Parameter,
    /// A driving coordinate.
    Input,
    /// A name that the loops determine.
    Unknown,
    /// A quantity derived from other names.
    Derived,
    /// A number that functions take besides inputs.
    Argument,
    /// Another mechanism within this one.
    Part,
    /// A body with mass.
    Body,
    /// A joint of bodies, or of links.
    Joint,
    /// A link.
    Link,
    /// A joint that slides on a link.
    Slider,
    /// A function of the `impl` block.
    Function,
    /// A field of the result of a function.
    Field,
}

impl NameKind {
    /// Returns the kind as text, without an article.
    #[must_use]
    pub fn word(self) -> &'static str {
        match self {
            NameKind::Mechanism => "mechanism",
            NameKind::Constant => "constant",
            NameKind::Parameter => "parameter",
            NameKind::Input => "input",
            NameKind::Unknown => "unknown",
            NameKind::Derived => "derived quantity",
            NameKind::Argument => "argument",
            NameKind::Part => "part",
            NameKind::Body => "body",
            NameKind::Joint => "joint",
            NameKind::Link => "link",
            NameKind::Slider => "slider",
            NameKind::Function => "function",
            NameKind::Field => "field",
        }
    }
}

/// A declared name.
#[derive(Clone, Debug)]
pub(crate) struct Declaration {
    pub(crate) name: String,
    pub(crate) kind: NameKind,
    /// The name in the text.
    pub(crate) range: Range<usize>,
    /// The item that declares it, without its doc comment.
    pub(crate) item: Range<usize>,
    /// The value after `=`.
    pub(crate) value: Option<Range<usize>>,
    /// The mechanism that a part is.
    pub(crate) mechanism: Option<String>,
    /// Its doc comment, or the comment after the item.
    pub(crate) documentation: String,
}

/// A mechanism of the text.
#[derive(Clone, Debug)]
pub(crate) struct Outline {
    pub(crate) mechanism: Declaration,
    /// Between the braces of the struct block.
    pub(crate) body: Range<usize>,
    /// Between the braces of each `impl` block.
    pub(crate) implementations: Vec<Range<usize>>,
    /// The names of the struct block, in order.
    pub(crate) names: Vec<Declaration>,
    pub(crate) functions: Vec<FunctionOutline>,
}

/// A function of an `impl` block.
#[derive(Clone, Debug)]
pub(crate) struct FunctionOutline {
    pub(crate) function: Declaration,
    /// Between the parentheses of its arguments.
    pub(crate) arguments: Range<usize>,
    /// Between the braces of its quantities.
    pub(crate) body: Range<usize>,
    pub(crate) fields: Vec<Declaration>,
}

impl Outline {
    /// Returns true if a byte is in the struct block or in an `impl` block, or between them.
    pub(crate) fn contains(&self, offset: usize) -> bool {
        let touches = |range: &Range<usize>| range.start <= offset && offset <= range.end;
        touches(&self.mechanism.item)
            || touches(&self.body)
            || self.implementations.iter().any(touches)
    }

    /// Returns the name of the struct block with this text.
    pub(crate) fn find(&self, name: &str) -> Option<&Declaration> {
        let plain = |text: &str| text.strip_prefix("r#").unwrap_or(text).to_owned();
        self.names
            .iter()
            .find(|declared| plain(&declared.name) == plain(name))
    }

    /// Returns the function around a byte.
    pub(crate) fn function_at(&self, offset: usize) -> Option<&FunctionOutline> {
        let mut functions = self.functions.iter();
        functions.find(|function| {
            function.function.item.start <= offset && offset <= function.function.item.end
        })
    }
}

/// Returns the mechanisms of a text.
pub(crate) fn outlines(text: &str, tokens: &[Token]) -> Vec<Outline> {
    let mut cursor = Cursor::new(text, tokens);
    let mut found: Vec<Outline> = Vec::new();
    while let Some(token) = cursor.next() {
        match token.text(text) {
            "struct" => found.extend(mechanism(&mut cursor, token.range.start)),
            "impl" => {
                let Some(name) = cursor.next_if(Kind::Word) else {
                    continue;
                };
                let Some(block) = cursor.block() else {
                    continue;
                };
                let name = name.text(text);
                let implemented = found
                    .iter_mut()
                    .rev()
                    .find(|outline| outline.mechanism.name == name);
                if let Some(outline) = implemented {
                    outline.functions.extend(functions(text, tokens, &block));
                    outline.implementations.push(block);
                }
            }
            _ => {}
        }
    }
    found
}

fn mechanism(cursor: &mut Cursor, start: usize) -> Option<Outline> {
    let name = cursor.next_if(Kind::Word)?;
    let body = cursor.block()?;
    let (text, tokens) = (cursor.text, cursor.tokens);
    let names = statements(text, tokens, &body, ';');
    let names = names.iter().flat_map(|item| declared(text, tokens, item));
    Some(Outline {
        mechanism: Declaration {
            name: name.text(text).to_owned(),
            kind: NameKind::Mechanism,
            range: name.range.clone(),
            item: start..body.end + 1,
            value: None,
            mechanism: None,
            documentation: documentation(text, tokens, start..start),
        },
        names: names.collect(),
        body,
        implementations: Vec::new(),
        functions: Vec::new(),
    })
}

/// Returns the names that an item of a struct block declares.
fn declared(text: &str, tokens: &[Token], item: &Range<usize>) -> Vec<Declaration> {
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

/// Returns the functions of an `impl` block.
fn functions(text: &str, tokens: &[Token], block: &Range<usize>) -> Vec<FunctionOutline> {
    let mut cursor = Cursor::within(text, tokens, block);
    let mut found = Vec::new();
    let mut start = block.start;
    while let Some(token) = cursor.next() {
        match token.text(text) {
            "pub" => start = token.range.start,
            "fn" => {
                let is_public = text[..token.range.start].trim_end().ends_with("pub");
                let start = if is_public { start } else { token.range.start };
                found.extend(function(&mut cursor, start));
            }
            _ => {}
        }
    }
    found
}

fn function(cursor: &mut Cursor, start: usize) -> Option<FunctionOutline> {
    let name = cursor.next_if(Kind::Word)?;
    let (text, tokens) = (cursor.text, cursor.tokens);
    let arguments = cursor.block()?;
    let body = cursor.block()?;
    let fields = statements(text, tokens, &body, ',');
    let declaration = |name: &Token, kind, item: Range<usize>, value| Declaration {
        name: name.text(text).to_owned(),
        kind,
        range: name.range.clone(),
        documentation: documentation(text, tokens, item.clone()),
        item,
        value,
        mechanism: None,
    };
    let field = |item: &Range<usize>| {
        let mut cursor = Cursor::within(text, tokens, item);
        let name = cursor.next_if(Kind::Word)?;
        let value = match cursor.next() {
            Some(mark) if mark.text(text) == ":" => Some(mark.range.end..item.end),
            Some(_) => return None,
            None => None,
        };
        Some(declaration(&name, NameKind::Field, item.clone(), value))
    };
    Some(FunctionOutline {
        function: declaration(&name, NameKind::Function, start..body.end + 1, None),
        arguments,
        fields: fields.iter().filter_map(field).collect(),
        body,
    })
}
