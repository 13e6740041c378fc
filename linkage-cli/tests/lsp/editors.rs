//! The first messages of editors, with all that each of them offers, and the answers that follow
//! from the offer. The offers are those of VS Code 1.96 with vscode-languageclient, of Neovim 0.11,
//! of Helix 25.07 and of Eglot 1.9.

use serde_json::{Value, json};

use crate::client::{Client, URI, error_code};
use crate::template;

/// A text with a mistake that has a further place, after a character of four bytes.
const TWICE: &str = "struct A { /* 𝛗 */ unit mm; param r = 3mm; param r = 4mm; let x = 2 * r; }";

/// An editor, by the parameters of its `initialize`.
struct Offer {
    params: &'static str,
    /// The unit of columns that follows from it.
    encoding: &'static str,
    /// The form of hover.
    hover: &'static str,
    has_related: bool,
    has_tree: bool,
    prepares_rename: bool,
    refreshes_hints: bool,
}

const EDITORS: [Offer; 4] = [
    Offer {
        params: include_str!("editors/vscode.json"),
        encoding: "utf-16",
        hover: "markdown",
        has_related: true,
        has_tree: true,
        prepares_rename: true,
        refreshes_hints: true,
    },
    Offer {
        params: include_str!("editors/neovim.json"),
        encoding: "utf-8",
        hover: "markdown",
        has_related: true,
        has_tree: true,
        prepares_rename: true,
        refreshes_hints: true,
    },
    Offer {
        params: include_str!("editors/helix.json"),
        encoding: "utf-8",
        hover: "markdown",
        has_related: false,
        has_tree: false,
        prepares_rename: true,
        refreshes_hints: false,
    },
    Offer {
        params: include_str!("editors/eglot.json"),
        encoding: "utf-16",
        hover: "plaintext",
        has_related: false,
        has_tree: true,
        prepares_rename: false,
        refreshes_hints: false,
    },
];

/// Runs a test with the server that each editor starts: the offer, the name of the editor, the first
/// answer.
fn with_each_editor(test: impl Fn(&Offer, &Value, &mut Client, &Value)) {
    for offer in &EDITORS {
        let params: Value = serde_json::from_str(offer.params).expect("JSON");
        let name = params["clientInfo"]["name"].clone();
        let (mut client, answer) = Client::start_as(params);
        test(offer, &name, &mut client, &answer);
        client.stop();
    }
}

/// Notifications that editors send without a request of the server; none has an answer.
fn tell_more(client: &mut Client) {
    client.tell("$/setTrace", json!({ "value": "verbose" }));
    client.tell(
        "workspace/didChangeConfiguration",
        json!({ "settings": { "linkage": {} } }),
    );
    client.tell("window/workDoneProgress/cancel", json!({ "token": "1" }));
    client.tell("$/cancelRequest", json!({ "id": 4711 }));
    client.tell(
        "textDocument/willSave",
        json!({ "textDocument": { "uri": URI }, "reason": 1 }),
    );
    client.tell(
        "textDocument/didSave",
        json!({ "textDocument": { "uri": URI } }),
    );
}

#[test]
fn the_answers_fit_what_each_editor_offers() {
    with_each_editor(|offer, name, client, answer| {
        let able = &answer["capabilities"];
        assert_eq!(able["positionEncoding"], offer.encoding, "{name}");
        let prepares = able["renameProvider"]["prepareProvider"] == json!(true);
        assert_eq!(prepares, offer.prepares_rename, "{name}");
        // Changes are sent piece by piece, and messages are sent without a request.
        assert_eq!(able["textDocumentSync"]["change"], 2, "{name}");
        assert_eq!(able["diagnosticProvider"], Value::Null, "{name}");
        assert_eq!(
            able["codeActionProvider"]["codeActionKinds"][0], "quickfix",
            "{name}"
        );
        tell_more(client);

        client.begin_open("linkage", TWICE);
        let messages = client.first_messages();
        let column = TWICE.rfind("r = 4mm").expect("it is there");
        let column = if offer.encoding == "utf-8" {
            column
        } else {
            column - 2
        };
        assert_eq!(
            messages[0]["range"]["start"]["character"], column,
            "{name}: {messages}"
        );
        let related = messages[0]["relatedInformation"].as_array();
        assert_eq!(related.is_some(), offer.has_related, "{name}: {messages}");
        let text = messages[0]["message"].as_str().expect("a text");
        assert_eq!(
            text.contains("\nnote: "),
            !offer.has_related,
            "{name}: {text}"
        );

        let hover = client.ask_at("textDocument/hover", 0, column);
        assert_eq!(hover["contents"]["kind"], offer.hover, "{name}: {hover}");
        let symbols = client.ask_of_text("textDocument/documentSymbol");
        assert_eq!(
            symbols[0]["children"].is_array(),
            offer.has_tree,
            "{name}: {symbols}"
        );
        assert_eq!(
            symbols[0]["location"].is_object(),
            !offer.has_tree,
            "{name}: {symbols}"
        );
        let id = client.begin(
            "textDocument/diagnostic",
            json!({ "textDocument": { "uri": URI } }),
        );
        assert_eq!(error_code(&client.answer(id)), Some(-32601), "{name}");
    });
}

#[test]
fn hints_are_asked_for_again_where_the_editor_can() {
    with_each_editor(|offer, name, client, _| {
        client.begin_open("linkage", &template("slider"));
        assert_eq!(client.first_messages(), json!([]), "{name}");
        if offer.refreshes_hints {
            let (id, method) = client.request_of_server();
            assert_eq!(method, "workspace/inlayHint/refresh", "{name}");
            client.respond(id, Value::Null);
            let range = json!({ "start": { "line": 0, "character": 0 }, "end": { "line": 99, "character": 0 } });
            let hints = client.ask(
                "textDocument/inlayHint",
                json!({ "textDocument": { "uri": URI }, "range": range }),
            );
            assert!(
                hints.as_array().is_some_and(|hints| !hints.is_empty()),
                "{name}"
            );
        }
    });
}

/// Editors send pieces or the whole text, and several changes at once.
#[test]
fn changes_come_in_pieces_or_whole() {
    with_each_editor(|offer, name, client, _| {
        client.begin_open("linkage", TWICE);
        client.first_messages();
        client.change_whole(&TWICE.replace("param r = 4mm", "param s = 4mm"));
        assert_eq!(client.first_messages(), json!([]), "{name}");
        let column = TWICE.find("unit mm").expect("it is there");
        let column = if offer.encoding == "utf-8" {
            column
        } else {
            column - 2
        };
        client.change([[0, column], [0, column + 7]], "unit xx");
        let messages = client.first_messages();
        assert_eq!(
            messages[0]["range"]["start"]["character"],
            column + 5,
            "{name}: {messages}"
        );
    });
}
