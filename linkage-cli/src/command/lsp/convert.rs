//! Results of `linkage-editor` in the types of the protocol.

use std::ops::Range;

use linkage_editor::{
    Colour, CompletionKind, Document, Edit, Encoding, NameKind, Position, Severity, Symbol,
};
use lsp_types::{
    CompletionItemKind, Diagnostic, DiagnosticRelatedInformation, DiagnosticSeverity,
    DocumentSymbol, Documentation, Location, MarkupContent, MarkupKind, SemanticToken,
    SemanticTokenType, SemanticTokensLegend, SymbolInformation, SymbolKind, TextEdit, Uri,
};

use super::client::{Client, Form};

/// Returns a position of the editor.
pub(super) fn position_of_editor(position: lsp_types::Position) -> Position {
    Position {
        line: position.line,
        column: position.character,
    }
}

/// Returns the byte of a position of the editor.
pub(super) fn offset(
    document: &Document,
    position: lsp_types::Position,
    encoding: Encoding,
) -> usize {
    let position = position_of_editor(position);
    document.lines().offset(document.text(), position, encoding)
}

/// Returns the position of a byte.
pub(super) fn position(
    document: &Document,
    offset: usize,
    encoding: Encoding,
) -> lsp_types::Position {
    let position = document.lines().position(document.text(), offset, encoding);
    lsp_types::Position::new(position.line, position.column)
}

/// Returns the positions of some bytes.
pub(super) fn range(
    document: &Document,
    range: &Range<usize>,
    encoding: Encoding,
) -> lsp_types::Range {
    let [start, end] = [range.start, range.end].map(|byte| position(document, byte, encoding));
    lsp_types::Range::new(start, end)
}

/// Returns the messages of a text.
pub(super) fn diagnostics(document: &Document, uri: &Uri, client: Client) -> Vec<Diagnostic> {
    let found = document.diagnostics().iter();
    found
        .map(|found| diagnostic(document, found, uri, client))
        .collect()
}

/// Returns a message, its advice on a second line. Its further places are between them if the editor
/// does not show them.
pub(super) fn diagnostic(
    document: &Document,
    found: &linkage_editor::Diagnostic,
    uri: &Uri,
    client: Client,
) -> Diagnostic {
    let encoding = client.encoding;
    let help = found.help.iter().map(|help| format!("\nhelp: {help}"));
    let notes = found.related.iter().filter(|_| !client.shows_related);
    let notes = notes.map(|related| format!("\nnote: {}", related.message));
    let related = found
        .related
        .iter()
        .map(|related| DiagnosticRelatedInformation {
            location: Location::new(uri.clone(), range(document, &related.range, encoding)),
            message: related.message.clone(),
        });
    let related: Vec<_> = related.filter(|_| client.shows_related).collect();
    Diagnostic {
        range: range(document, &found.range, encoding),
        severity: Some(match found.severity {
            Severity::Error => DiagnosticSeverity::ERROR,
            Severity::Warning => DiagnosticSeverity::WARNING,
        }),
        source: Some("linkage".to_owned()),
        message: found.message.clone() + &notes.chain(help).collect::<String>(),
        related_information: (!related.is_empty()).then_some(related),
        ..Diagnostic::default()
    }
}

/// Returns changes of a text.
pub(super) fn edits(document: &Document, edits: &[Edit], encoding: Encoding) -> Vec<TextEdit> {
    let edits = edits.iter();
    let edits =
        edits.map(|edit| TextEdit::new(range(document, &edit.range, encoding), edit.text.clone()));
    edits.collect()
}

/// Returns Markdown in a form that the editor shows.
pub(super) fn markup(markdown: &str, form: Form) -> MarkupContent {
    match form {
        Form::Markdown => MarkupContent {
            kind: MarkupKind::Markdown,
            value: markdown.to_owned(),
        },
        Form::Plain => MarkupContent {
            kind: MarkupKind::PlainText,
            // Back-ticks are marks of messages, too.
            value: markdown.replace("\n\n---\n\n", "\n\n"),
        },
    }
}

/// Returns a description in Markdown; `None` if it is empty.
pub(super) fn documentation(markdown: &str, form: Form) -> Option<Documentation> {
    (!markdown.is_empty()).then(|| Documentation::MarkupContent(markup(markdown, form)))
}

/// Returns the kind of a word that can be written.
pub(super) fn completion_kind(kind: CompletionKind) -> CompletionItemKind {
    match kind {
        CompletionKind::Name(kind) => match kind {
            NameKind::Mechanism => CompletionItemKind::STRUCT,
            NameKind::Constant => CompletionItemKind::CONSTANT,
            NameKind::Parameter | NameKind::Input | NameKind::Argument => CompletionItemKind::FIELD,
            NameKind::Unknown | NameKind::Derived | NameKind::Slider | NameKind::Slot => {
                CompletionItemKind::VARIABLE
            }
            NameKind::Part => CompletionItemKind::MODULE,
            NameKind::Body | NameKind::Link => CompletionItemKind::CLASS,
            NameKind::Joint => CompletionItemKind::REFERENCE,
            NameKind::Function => CompletionItemKind::METHOD,
            NameKind::Field => CompletionItemKind::PROPERTY,
        },
        CompletionKind::Member => CompletionItemKind::PROPERTY,
        CompletionKind::Function | CompletionKind::Quantity => CompletionItemKind::FUNCTION,
        CompletionKind::Unit => CompletionItemKind::UNIT,
        CompletionKind::Law => CompletionItemKind::ENUM_MEMBER,
        CompletionKind::Keyword => CompletionItemKind::KEYWORD,
    }
}

/// Returns a name with those within it.
pub(super) fn symbol(document: &Document, found: &Symbol, encoding: Encoding) -> DocumentSymbol {
    let inner = found
        .inner
        .iter()
        .map(|inner| symbol(document, inner, encoding));
    let inner: Vec<_> = inner.collect();
    #[allow(deprecated, reason = "the type has no other constructor")]
    DocumentSymbol {
        name: found.name.clone(),
        detail: (!found.detail.is_empty()).then(|| found.detail.clone()),
        kind: symbol_kind(found.kind),
        tags: None,
        deprecated: None,
        range: range(document, &found.item, encoding),
        selection_range: range(document, &found.range, encoding),
        children: (!inner.is_empty()).then_some(inner),
    }
}

/// Returns names and those within them, one after the other, each with the name around it.
pub(super) fn flat(
    tree: &[DocumentSymbol],
    uri: &Uri,
    around: Option<&str>,
) -> Vec<SymbolInformation> {
    let all = tree.iter().flat_map(|symbol| {
        #[allow(deprecated, reason = "the type has no other constructor")]
        let one = SymbolInformation {
            name: symbol.name.clone(),
            kind: symbol.kind,
            tags: None,
            deprecated: None,
            location: Location::new(uri.clone(), symbol.range),
            container_name: around.map(str::to_owned),
        };
        let inner = symbol.children.as_deref().unwrap_or_default();
        std::iter::once(one).chain(flat(inner, uri, Some(&symbol.name)))
    });
    all.collect()
}

fn symbol_kind(kind: NameKind) -> SymbolKind {
    match kind {
        NameKind::Mechanism => SymbolKind::STRUCT,
        NameKind::Constant => SymbolKind::CONSTANT,
        NameKind::Parameter | NameKind::Input | NameKind::Argument => SymbolKind::FIELD,
        NameKind::Unknown | NameKind::Derived | NameKind::Slider | NameKind::Slot => {
            SymbolKind::VARIABLE
        }
        NameKind::Part => SymbolKind::MODULE,
        NameKind::Body | NameKind::Link => SymbolKind::OBJECT,
        NameKind::Joint => SymbolKind::KEY,
        NameKind::Function => SymbolKind::METHOD,
        NameKind::Field => SymbolKind::PROPERTY,
    }
}

/// The meanings of words, in the order of their numbers in the protocol.
const WORDS: [SemanticTokenType; 9] = [
    SemanticTokenType::KEYWORD,
    SemanticTokenType::COMMENT,
    SemanticTokenType::NUMBER,
    SemanticTokenType::TYPE,
    SemanticTokenType::FUNCTION,
    SemanticTokenType::STRUCT,
    SemanticTokenType::PARAMETER,
    SemanticTokenType::VARIABLE,
    SemanticTokenType::PROPERTY,
];

/// Returns the meanings of words that the server knows.
pub(super) fn legend() -> SemanticTokensLegend {
    SemanticTokensLegend {
        token_types: WORDS.to_vec(),
        token_modifiers: Vec::new(),
    }
}

fn word_type(colour: Colour) -> SemanticTokenType {
    match colour {
        Colour::Keyword => SemanticTokenType::KEYWORD,
        Colour::Comment => SemanticTokenType::COMMENT,
        Colour::Number => SemanticTokenType::NUMBER,
        Colour::Unit => SemanticTokenType::TYPE,
        Colour::Function | Colour::Name(NameKind::Function) => SemanticTokenType::FUNCTION,
        Colour::Name(NameKind::Mechanism | NameKind::Part) => SemanticTokenType::STRUCT,
        Colour::Name(
            NameKind::Constant | NameKind::Parameter | NameKind::Input | NameKind::Argument,
        ) => SemanticTokenType::PARAMETER,
        Colour::Name(
            NameKind::Unknown
            | NameKind::Derived
            | NameKind::Body
            | NameKind::Joint
            | NameKind::Link
            | NameKind::Slider
            | NameKind::Slot,
        ) => SemanticTokenType::VARIABLE,
        Colour::Name(NameKind::Field) => SemanticTokenType::PROPERTY,
    }
}

/// Returns the words of a text, each relative to the one before. Comments of several lines are cut
/// into lines.
pub(super) fn words(document: &Document, encoding: Encoding) -> Vec<SemanticToken> {
    let mut last = lsp_types::Position::default();
    let mut found = Vec::new();
    for word in document.words() {
        let wanted = word_type(word.colour);
        let number = WORDS
            .iter()
            .position(|known| *known == wanted)
            .unwrap_or_default();
        for line in lines(document.text(), &word.range) {
            let location = range(document, &line, encoding);
            let is_same_line = location.start.line == last.line;
            found.push(SemanticToken {
                delta_line: location.start.line - last.line,
                delta_start: match is_same_line {
                    true => location.start.character - last.character,
                    false => location.start.character,
                },
                length: location.end.character - location.start.character,
                token_type: number as u32,
                token_modifiers_bitset: 0,
            });
            last = location.start;
        }
    }
    found
}

/// Cuts bytes at the ends of lines.
fn lines(text: &str, range: &Range<usize>) -> Vec<Range<usize>> {
    let mut start = range.start;
    let pieces = text[range.clone()].split_inclusive('\n').map(|piece| {
        let line = start..start + piece.trim_end_matches(['\n', '\r']).len();
        start += piece.len();
        line
    });
    pieces.filter(|line| !line.is_empty()).collect()
}
