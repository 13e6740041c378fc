//! Uses of names: the words of a text that mean a declared name.

use std::ops::Range;

use linkage_language::model::CalledWord;
use linkage_language::syntax::{ItemWord, JointKind, Word, is_clause_word};

use crate::declaration::{Declaration, NameKind};
use crate::lexer::{Kind, Token};
use crate::outline::Outline;

/// A declared name: indices of the mechanism and of the name in it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Symbol {
    Mechanism(usize),
    Name(usize, usize),
    Function(usize, usize),
    /// A field with a value: mechanism, function, field.
    Field(usize, usize, usize),
}

/// A word that means a declared name.
#[derive(Clone, Debug)]
pub(crate) struct Use {
    pub(crate) range: Range<usize>,
    pub(crate) symbol: Symbol,
    /// True for a field whose name is its value: `{ tracer }`.
    pub(crate) is_shorthand: bool,
}

/// Returns the declaration of a symbol.
pub(crate) fn declaration(outlines: &[Outline], symbol: Symbol) -> &Declaration {
    match symbol {
        Symbol::Mechanism(mechanism) => &outlines[mechanism].mechanism,
        Symbol::Name(mechanism, name) => &outlines[mechanism].names[name],
        Symbol::Function(mechanism, function) => &outlines[mechanism].functions[function].function,
        Symbol::Field(mechanism, function, field) => {
            &outlines[mechanism].functions[function].fields[field]
        }
    }
}

/// Returns all uses of names in a text, in order, the declarations among them.
pub(crate) fn uses(text: &str, tokens: &[Token], outlines: &[Outline]) -> Vec<Use> {
    let solid: Vec<&Token> = tokens.iter().filter(|token| !token.is_trivia()).collect();
    let search = UseSearch {
        text,
        solid: &solid,
        outlines,
    };
    let mut found: Vec<Use> = Vec::new();
    for (mechanism, outline) in outlines.iter().enumerate() {
        let blocks = [&outline.mechanism.item]
            .into_iter()
            .chain(&outline.implementations);
        for block in blocks {
            let first = solid.partition_point(|token| token.range.start < block.start);
            let end = solid.partition_point(|token| token.range.end <= block.end);
            found.extend((first..end).filter_map(|index| search.word(mechanism, index)));
        }
    }
    found.extend(search.names_of_blocks());
    found.sort_by_key(|found| found.range.start);
    found.dedup_by_key(|found| found.range.start);
    found
}

struct UseSearch<'t> {
    text: &'t str,
    /// The tokens without blanks and comments.
    solid: &'t [&'t Token],
    outlines: &'t [Outline],
}

impl UseSearch<'_> {
    fn text(&self, index: usize) -> &str {
        self.solid
            .get(index)
            .map_or("", |token| token.text(self.text))
    }

    /// The names after `impl`.
    fn names_of_blocks(&self) -> impl Iterator<Item = Use> {
        let indices = 1..self.solid.len();
        indices
            .filter(|index| self.text(index - 1) == "impl")
            .filter_map(|index| Some(self.found(index, self.mechanism(self.text(index))?)))
    }

    fn found(&self, index: usize, symbol: Symbol) -> Use {
        Use {
            range: self.solid[index].range.clone(),
            symbol,
            is_shorthand: false,
        }
    }

    fn mechanism(&self, name: &str) -> Option<Symbol> {
        let mut names = self.outlines.iter();
        let found = names.position(|outline| outline.mechanism.name == name)?;
        Some(Symbol::Mechanism(found))
    }

    fn name(&self, mechanism: usize, name: &str) -> Option<Symbol> {
        let declared = self.outlines[mechanism].find(name)?;
        let mut names = self.outlines[mechanism].names.iter();
        let index = names.position(|other| other.range == declared.range)?;
        Some(Symbol::Name(mechanism, index))
    }

    /// The use that a word within a mechanism is.
    fn word(&self, mechanism: usize, index: usize) -> Option<Use> {
        let token = self.solid[index];
        let word = token.text(self.text);
        if token.kind != Kind::Word {
            return None;
        }
        let outline = &self.outlines[mechanism];
        if outline.mechanism.range == token.range {
            return Some(self.found(index, Symbol::Mechanism(mechanism)));
        }
        if let Some(declared) = self.declared(mechanism, &token.range) {
            return Some(self.found(index, declared));
        }
        let before = index.checked_sub(1).map_or("", |before| self.text(before));
        if before == "." {
            return Some(self.found(index, self.member(mechanism, index)?));
        }
        if let Some(function) = outline.function_at(token.range.start) {
            return self.word_of_function(mechanism, function, index);
        }
        if before == ":" && index >= 2 {
            // `part NAME: MECHANISM`
            let name = self.name(mechanism, self.text(index - 2));
            let is_part =
                |symbol: &Symbol| declaration(self.outlines, *symbol).kind == NameKind::Part;
            if name.filter(is_part).is_some() {
                return Some(self.found(index, self.mechanism(word)?));
            }
        }
        if let Some(part) = self.given(mechanism, index) {
            return Some(self.found(index, self.name(part, word)?));
        }
        if self.is_called(index) || self.is_of_language(index) {
            return None;
        }
        Some(self.found(index, self.name(mechanism, word)?))
    }

    /// The name that is declared by these bytes.
    fn declared(&self, mechanism: usize, range: &Range<usize>) -> Option<Symbol> {
        let outline = &self.outlines[mechanism];
        let mut names = outline.names.iter();
        if let Some(name) = names.position(|name| name.range == *range) {
            return Some(Symbol::Name(mechanism, name));
        }
        let mut functions = outline.functions.iter();
        let function = functions.position(|function| function.function.range == *range)?;
        Some(Symbol::Function(mechanism, function))
    }

    /// A word of a function: an argument, the name of a field, or a word of its value.
    fn word_of_function(
        &self,
        mechanism: usize,
        function: &crate::outline::FunctionOutline,
        index: usize,
    ) -> Option<Use> {
        let range = &self.solid[index].range;
        let mut fields = function.fields.iter();
        let field = fields.position(|field| field.range == *range);
        if let Some(field) = field.filter(|field| function.fields[*field].value.is_some()) {
            let mut functions = self.outlines[mechanism].functions.iter();
            let number =
                functions.position(|other| other.function.range == function.function.range);
            return Some(self.found(index, Symbol::Field(mechanism, number?, field)));
        }
        let inside = |block: &Range<usize>| block.start <= range.start && range.end <= block.end;
        let is_used = inside(&function.arguments) || inside(&function.body);
        if !is_used || self.is_called(index) {
            return None;
        }
        let symbol = self.name(mechanism, self.text(index))?;
        Some(Use {
            is_shorthand: field.is_some(),
            ..self.found(index, symbol)
        })
    }

    /// The name after a dot: one of a part, or a joint of a link.
    fn member(&self, mechanism: usize, index: usize) -> Option<Symbol> {
        let head = index.checked_sub(2)?;
        let before = head.checked_sub(1).map_or("", |before| self.text(before));
        let symbol = match before {
            "." => self.member(mechanism, head)?,
            _ => self.name(mechanism, self.text(head))?,
        };
        let declared = declaration(self.outlines, symbol);
        match declared.kind {
            NameKind::Part => {
                let Symbol::Mechanism(part) = self.mechanism(declared.mechanism.as_deref()?)?
                else {
                    return None;
                };
                self.name(part, self.text(index))
            }
            NameKind::Link => {
                let joint = self.name(mechanism, self.text(index))?;
                let kind = declaration(self.outlines, joint).kind;
                (kind == NameKind::Joint).then_some(joint)
            }
            _ => None,
        }
    }

    /// The mechanism that a part is, for the name before `=` between its braces.
    fn given(&self, mechanism: usize, index: usize) -> Option<usize> {
        let start = self.solid[index].range.start;
        let mut names = self.outlines[mechanism].names.iter();
        let part = names.find(|name| {
            name.kind == NameKind::Part && name.item.start <= start && start < name.item.end
        })?;
        let before = self.text(index.checked_sub(1)?);
        let is_given = matches!(before, "{" | ",") && self.text(index + 1) == "=";
        let Symbol::Mechanism(number) = self.mechanism(part.mechanism.as_deref()?)? else {
            return None;
        };
        is_given.then_some(number)
    }

    /// True for the word of a function before its parentheses.
    fn is_called(&self, index: usize) -> bool {
        self.text(index + 1) == "(" && CalledWord::from_word(self.text(index)).is_some()
    }

    /// True for a word of the language, where no name can be.
    fn is_of_language(&self, index: usize) -> bool {
        let before = |count| {
            index
                .checked_sub(count)
                .map_or("", |index| self.text(index))
        };
        let is_kind = before(1) == "=" && before(3) == "body";
        is_kind && JointKind::from_word(self.text(index)).is_some()
            || self.begins_item(index)
            || self.is_clause(index)
    }

    /// True for the word that an item begins with.
    fn begins_item(&self, index: usize) -> bool {
        let before = index.checked_sub(1).map_or("", |before| self.text(before));
        matches!(before, ";" | "{" | "]") && ItemWord::from_word(self.text(index)).is_some()
    }

    /// True for the word of a clause: after a value, or after a comma and in front of a value.
    fn is_clause(&self, index: usize) -> bool {
        if index == 0 || !is_clause_word(self.text(index)) {
            return false;
        }
        match self.solid[index - 1].kind {
            Kind::Word => !self.begins_item(index - 1) && !self.is_clause(index - 1),
            Kind::Number | Kind::Close => true,
            _ => self.text(index - 1) == "," && self.begins_clause(index),
        }
    }

    /// True for a word of clauses after a comma that begins one: a value or a name follows.
    fn begins_clause(&self, index: usize) -> bool {
        let is_plain = |index: usize| {
            let token = self.solid.get(index);
            token.is_some_and(|token| match token.kind {
                Kind::Word => !is_clause_word(token.text(self.text)),
                kind => matches!(kind, Kind::Number | Kind::Open),
            })
        };
        // `mass mass at q`, but not the joint in `b, free at phi`.
        let is_named = || is_clause_word(self.text(index + 1)) && !is_plain(index + 2);
        is_plain(index + 1) || is_named()
    }
}
