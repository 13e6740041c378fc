//! The answer to each request of an editor.

use linkage_editor::formatted;
use lsp_server::{ErrorCode, ExtractError, Request, RequestId, Response};
use lsp_types::request::{
    CodeActionRequest, Completion, DocumentHighlightRequest, DocumentSymbolRequest, Formatting,
    GotoDefinition, HoverRequest, InlayHintRequest, PrepareRenameRequest, References, Rename,
    Request as _, SemanticTokensFullRequest, SignatureHelpRequest,
};
use lsp_types::{
    CodeAction, CodeActionKind, CompletionItem, CompletionTextEdit, DocumentHighlight,
    DocumentSymbol, DocumentSymbolResponse, GotoDefinitionResponse, Hover, HoverContents,
    InlayHint, InlayHintKind, InlayHintLabel, Location, ParameterInformation, ParameterLabel,
    PrepareRenameResponse, SemanticTokens, SignatureHelp, SignatureInformation, TextEdit,
    WorkspaceEdit,
};
use serde::de::DeserializeOwned;
use serde_json::Value;

use super::convert;
use super::documents::Documents;
use super::request_place::{At, location};

/// A request that cannot be answered: the code of the protocol, and the reason.
type Refusal = (ErrorCode, String);

type Answer<T> = Result<T, Refusal>;

/// Answers a request.
pub(super) fn answer(documents: &mut Documents, request: Request) -> Response {
    let id = request.id.clone();
    let result = match request.method.as_str() {
        HoverRequest::METHOD => asked::<HoverRequest>(documents, request, |at, _| hover(at)),
        Completion::METHOD => asked::<Completion>(documents, request, |at, _| completions(at)),
        SignatureHelpRequest::METHOD => {
            asked::<SignatureHelpRequest>(documents, request, |at, _| signature(at))
        }
        GotoDefinition::METHOD => {
            asked::<GotoDefinition>(documents, request, |at, _| definition(at))
        }
        References::METHOD => asked::<References>(documents, request, |at, params| {
            references(at, params.context.include_declaration)
        }),
        DocumentHighlightRequest::METHOD => {
            asked::<DocumentHighlightRequest>(documents, request, |at, _| highlights(at))
        }
        PrepareRenameRequest::METHOD => {
            asked::<PrepareRenameRequest>(documents, request, |at, _| renamable(at))
        }
        Rename::METHOD => asked::<Rename>(documents, request, |at, params| {
            renamed(at, &params.new_name)
        }),
        DocumentSymbolRequest::METHOD => {
            asked::<DocumentSymbolRequest>(documents, request, |at, _| symbols(at))
        }
        Formatting::METHOD => asked::<Formatting>(documents, request, |at, _| formatting(at)),
        InlayHintRequest::METHOD => {
            asked::<InlayHintRequest>(documents, request, |at, params| hints(at, params.range))
        }
        SemanticTokensFullRequest::METHOD => {
            asked::<SemanticTokensFullRequest>(documents, request, |at, _| words(at))
        }
        CodeActionRequest::METHOD => {
            asked::<CodeActionRequest>(documents, request, |at, params| actions(at, params.range))
        }
        other => Err((
            ErrorCode::MethodNotFound,
            format!("`{other}` is not served"),
        )),
    };
    respond(id, result)
}

fn respond(id: RequestId, result: Answer<Value>) -> Response {
    match result {
        Ok(value) => Response::new_ok(id, value),
        Err((code, message)) => Response::new_err(id, code as i32, message),
    }
}

/// Reads a request, and answers it if its text is open.
fn asked<R>(
    documents: &mut Documents,
    request: Request,
    answer: impl FnOnce(At<'_>, &R::Params) -> Answer<R::Result>,
) -> Answer<Value>
where
    R: lsp_types::request::Request,
    R::Params: DeserializeOwned,
{
    let wrong = |error: String| (ErrorCode::InvalidParams, error);
    let location = location(&request.params).map_err(|error| wrong(error.to_string()))?;
    let (_, params) = request
        .extract::<R::Params>(R::METHOD)
        .map_err(|error| match error {
            ExtractError::MethodMismatch(request) => wrong(request.method),
            ExtractError::JsonError { error, .. } => wrong(error.to_string()),
        })?;
    let (uri, position) = location;
    let client = documents.client;
    let unknown = || wrong(format!("`{}` is not open", uri.as_str()));
    let document = documents.find(&uri).ok_or_else(unknown)?;
    let at = At {
        document,
        uri: &uri,
        offset: convert::offset(document, position, client.encoding),
        client,
    };
    let value = serde_json::to_value(answer(at, &params)?);
    value.map_err(|error| (ErrorCode::InternalError, error.to_string()))
}

fn hover(at: At<'_>) -> Answer<Option<Hover>> {
    let found = at.document.hover(at.offset);
    Ok(found.map(|found| Hover {
        contents: HoverContents::Markup(convert::markup(&found.markdown, at.client.hover)),
        range: Some(at.range(&found.range)),
    }))
}

fn completions(at: At<'_>) -> Answer<Option<lsp_types::CompletionResponse>> {
    let words = at.document.completions(at.offset).into_iter();
    let items = words.map(|word| CompletionItem {
        kind: Some(convert::completion_kind(word.kind)),
        detail: (!word.detail.is_empty()).then_some(word.detail),
        documentation: convert::documentation(&word.documentation, at.client.completion),
        text_edit: Some(CompletionTextEdit::Edit(TextEdit::new(
            at.range(&word.range),
            word.text,
        ))),
        label: word.label,
        ..CompletionItem::default()
    });
    Ok(Some(lsp_types::CompletionResponse::Array(items.collect())))
}

fn signature(at: At<'_>) -> Answer<Option<SignatureHelp>> {
    let Some(found) = at.document.signature(at.offset) else {
        return Ok(None);
    };
    let arguments = found.arguments.iter().map(|range| ParameterInformation {
        // All labels are ASCII, so that bytes are units of every encoding.
        label: ParameterLabel::LabelOffsets([range.start as u32, range.end as u32]),
        documentation: None,
    });
    let signature = SignatureInformation {
        documentation: convert::documentation(&found.documentation, at.client.signature),
        parameters: Some(arguments.collect()),
        active_parameter: Some(found.active as u32),
        label: found.label,
    };
    Ok(Some(SignatureHelp {
        signatures: vec![signature],
        active_signature: Some(0),
        active_parameter: Some(found.active as u32),
    }))
}

fn definition(at: At<'_>) -> Answer<Option<GotoDefinitionResponse>> {
    let found = at.document.definition(at.offset);
    Ok(found.map(|range| GotoDefinitionResponse::Scalar(at.location(&range))))
}

fn references(at: At<'_>, with_declaration: bool) -> Answer<Option<Vec<Location>>> {
    let found = at.document.references(at.offset, with_declaration);
    Ok(Some(found.iter().map(|range| at.location(range)).collect()))
}

fn highlights(at: At<'_>) -> Answer<Option<Vec<DocumentHighlight>>> {
    let found = at.document.references(at.offset, true);
    let found = found.iter().map(|range| DocumentHighlight {
        range: at.range(range),
        kind: None,
    });
    Ok(Some(found.collect()))
}

fn renamable(at: At<'_>) -> Answer<Option<PrepareRenameResponse>> {
    let found = at.document.renamable(at.offset);
    Ok(found.map(|range| PrepareRenameResponse::Range(at.range(&range))))
}

fn renamed(at: At<'_>, name: &str) -> Answer<Option<WorkspaceEdit>> {
    let edits = at.document.renamed(at.offset, name);
    let edits = edits.map_err(|reason| (ErrorCode::RequestFailed, reason))?;
    Ok(Some(at.edit(convert::edits(
        at.document,
        &edits,
        at.client.encoding,
    ))))
}

fn symbols(at: At<'_>) -> Answer<Option<DocumentSymbolResponse>> {
    let found = at.document.symbols();
    let found = found
        .iter()
        .map(|found| convert::symbol(at.document, found, at.client.encoding));
    let tree: Vec<DocumentSymbol> = found.collect();
    Ok(Some(match at.client.has_tree_of_symbols {
        true => DocumentSymbolResponse::Nested(tree),
        false => DocumentSymbolResponse::Flat(convert::flat(&tree, at.uri, None)),
    }))
}

/// The whole text is replaced if something changes.
fn formatting(at: At<'_>) -> Answer<Option<Vec<TextEdit>>> {
    let text = at.document.text();
    let Some(new) = at.document.is_text().then(|| formatted(text)).flatten() else {
        return Ok(None);
    };
    let whole = at.range(&(0..text.len()));
    Ok(Some(match new == text {
        true => Vec::new(),
        false => vec![TextEdit::new(whole, new)],
    }))
}

fn hints(at: At<'_>, range: lsp_types::Range) -> Answer<Option<Vec<InlayHint>>> {
    let hints = at.document.hints().into_iter();
    let hints = hints.map(|hint| InlayHint {
        position: convert::position(at.document, hint.offset, at.client.encoding),
        label: InlayHintLabel::String(hint.label),
        kind: Some(InlayHintKind::TYPE),
        text_edits: None,
        tooltip: None,
        padding_left: None,
        padding_right: None,
        data: None,
    });
    let visible = hints.filter(|hint| range.start <= hint.position && hint.position <= range.end);
    Ok(Some(visible.collect()))
}

fn words(at: At<'_>) -> Answer<Option<lsp_types::SemanticTokensResult>> {
    let tokens = SemanticTokens {
        result_id: None,
        data: convert::words(at.document, at.client.encoding),
    };
    Ok(Some(tokens.into()))
}

fn actions(at: At<'_>, range: lsp_types::Range) -> Answer<Option<lsp_types::CodeActionResponse>> {
    let [start, end] =
        [range.start, range.end].map(|end| convert::offset(at.document, end, at.client.encoding));
    let found = at.document.actions(start..end.max(start)).into_iter();
    let actions = found.map(|action| {
        let message = action
            .diagnostic
            .map(|index| &at.document.diagnostics()[index]);
        let message =
            message.map(|message| convert::diagnostic(at.document, message, at.uri, at.client));
        let kind = match message {
            Some(_) => CodeActionKind::QUICKFIX,
            None => CodeActionKind::REFACTOR_REWRITE,
        };
        let action = CodeAction {
            title: action.fix.title,
            kind: Some(kind),
            diagnostics: message.map(|message| vec![message]),
            edit: Some(at.edit(convert::edits(
                at.document,
                &action.fix.edits,
                at.client.encoding,
            ))),
            ..CodeAction::default()
        };
        action.into()
    });
    Ok(Some(actions.collect()))
}
