//! The structure of a text by its tokens: mechanisms, their items and functions, declared names.
//!
//! It needs no text that can be compiled. An item that is being written does not hide the others.

use std::ops::Range;

use crate::cursor::Cursor;
use crate::declaration::{Declaration, NameKind};
use crate::declared_names::declared;
use crate::lexer::{Kind, Token};
use crate::statements::{documentation, statements};

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
