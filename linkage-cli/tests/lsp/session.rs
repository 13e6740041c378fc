//! Sessions: the messages of an editor from its start to its end.

use serde_json::{Value, json};

use crate::client::{Client, URI, error_code};
use crate::template;

/// Line and column of the end of a piece of a text.
fn place(text: &str, piece: &str) -> [usize; 2] {
    let end = text.find(piece).unwrap_or_else(|| panic!("`{piece}`")) + piece.len();
    let line = text[..end].matches('\n').count();
    let start = text[..end].rfind('\n').map_or(0, |start| start + 1);
    [line, text[start..end].encode_utf16().count()]
}

#[test]
fn an_edited_text_from_start_to_end() {
    let text = template("slider");
    let (mut client, answer) = Client::start(&["utf-16"]);
    assert_eq!(answer["serverInfo"]["name"], "linkage");
    assert_eq!(answer["capabilities"]["positionEncoding"], "utf-16");
    assert_eq!(client.open("linkage", &text), json!([]));

    // A key that breaks the text: its messages, and answers all the same.
    let [line, column] = place(&text, "loop pin + polar(rod");
    client.change([[line, column - 3], [line, column]], "rd");
    let messages = client.messages();
    assert_eq!(messages[0]["severity"], 1);
    assert_eq!(
        messages[0]["message"],
        "unknown name `rd`\nhelp: did you mean `rod`?"
    );
    let start = json!({ "line": line, "character": column - 3 });
    assert_eq!(messages[0]["range"]["start"], start);
    let found = client.ask_at("textDocument/completion", line, column - 1);
    let labels: Vec<&Value> = found
        .as_array()
        .expect("a list")
        .iter()
        .map(|word| &word["label"])
        .collect();
    assert!(labels.contains(&&json!("rod")), "{labels:?}");

    // The change that the message proposes.
    let range = json!({ "start": start, "end": start });
    let params =
        json!({ "textDocument": { "uri": URI }, "range": range, "context": { "diagnostics": [] } });
    let actions = client.ask("textDocument/codeAction", params);
    assert_eq!(actions[0]["title"], "write `rod`");
    assert_eq!(actions[0]["kind"], "quickfix");
    assert_eq!(actions[0]["edit"]["changes"][URI][0]["newText"], "rod");
    client.change([[line, column - 3], [line, column - 1]], "rod");
    assert_eq!(client.messages(), json!([]));

    let [line, column] = place(&text, "unknown slide");
    let hover = client.ask_at("textDocument/hover", line, column);
    let described = hover["contents"]["value"].as_str().expect("Markdown");
    assert!(
        described.contains("unknown `slide`: a length"),
        "{described}"
    );
    let uses = client.ask(
        "textDocument/references",
        json!({
            "textDocument": { "uri": URI }, "position": { "line": line, "character": column },
            "context": { "includeDeclaration": true },
        }),
    );
    assert_eq!(uses.as_array().map(Vec::len), Some(7));
    let [use_line, use_column] = place(&text, "let slider = (slide");
    let definition = client.ask_at("textDocument/definition", use_line, use_column);
    assert_eq!(
        definition["range"]["end"],
        json!({ "line": line, "character": column })
    );
    client.stop();
}

#[test]
fn everything_about_a_whole_text() {
    let text = template("slider");
    let (mut client, _) = Client::start(&["utf-8", "utf-16"]);
    client.open("linkage", &text);
    let symbols = client.ask_of_text("textDocument/documentSymbol");
    // An editor that does not offer a tree has a list.
    assert_eq!(symbols[0]["name"], "SliderCrank");
    let inner = symbols.as_array().expect("a list").iter();
    let inner = inner.filter(|symbol| symbol["containerName"] == "SliderCrank");
    assert_eq!(inner.count(), 11);
    let tokens = client.ask_of_text("textDocument/semanticTokens/full");
    assert!(
        tokens["data"]
            .as_array()
            .is_some_and(|data| data.len() > 500)
    );
    let hints = client.ask(
        "textDocument/inlayHint",
        json!({
            "textDocument": { "uri": URI },
            "range": { "start": { "line": 0, "character": 0 }, "end": { "line": 99, "character": 0 } },
        }),
    );
    let labels: Vec<&str> = hints
        .as_array()
        .expect("a list")
        .iter()
        .filter_map(|hint| hint["label"].as_str())
        .collect();
    assert!(labels.contains(&" = (34.641mm, 20mm)"), "{labels:?}");
    let formatting = json!({ "textDocument": { "uri": URI }, "options": { "tabSize": 4, "insertSpaces": true } });
    assert_eq!(
        client.ask("textDocument/formatting", formatting.clone()),
        json!([])
    );
    let [line, column] = place(&text, "unit mm");
    client.change([[line, column], [line, column]], "  ");
    let edits = client.ask("textDocument/formatting", formatting);
    assert_eq!(edits[0]["newText"], text);
    let [line, column] = place(&text, "let pin = polar(crank");
    let signature = client.ask_at("textDocument/signatureHelp", line, column);
    assert_eq!(signature["signatures"][0]["label"], "polar(length, angle)");
    assert_eq!(signature["activeParameter"], 0);
    client.stop();
}

#[test]
fn columns_are_those_of_the_encoding() {
    let text = "struct A { /* 𝛗 */ unit mm; param r = 3parsec; }";
    let start = text.find("3parsec").expect("it is there");
    for (encodings, column) in [
        (&["utf-16"][..], start - 2),
        (&["utf-8"], start),
        (&[], start - 2),
    ] {
        let (mut client, _) = Client::start(encodings);
        let messages = client.open("linkage", text);
        assert_eq!(
            messages[0]["range"]["start"]["character"], column,
            "{encodings:?}"
        );
        client.stop();
    }
}

#[test]
fn names_are_changed_everywhere() {
    let text = template("slider");
    let (mut client, _) = Client::start(&[]);
    client.open("linkage", &text);
    let [line, character] = place(&text, "param crank");
    let position = json!({ "line": line, "character": character });
    let range = client.ask_at("textDocument/prepareRename", line, character);
    assert_eq!(range["end"], position);
    let rename = |name: &str| json!({ "textDocument": { "uri": URI }, "position": position, "newName": name });
    let edit = client.ask("textDocument/rename", rename("radius"));
    assert_eq!(edit["changes"][URI].as_array().map(Vec::len), Some(2));
    let id = client.begin("textDocument/rename", rename("rod"));
    let refused = client.answer(id);
    assert_eq!(error_code(&refused), Some(-32803));
    client.stop();
}

#[test]
fn unknown_requests_and_texts_are_refused() {
    let (mut client, _) = Client::start(&[]);
    let id = client.begin("textDocument/nothing", json!({}));
    assert_eq!(error_code(&client.answer(id)), Some(-32601));
    let place =
        json!({ "textDocument": { "uri": URI }, "position": { "line": 0, "character": 0 } });
    let id = client.begin("textDocument/hover", place.clone());
    assert_eq!(error_code(&client.answer(id)), Some(-32602));
    client.open("linkage", "struct A { }");
    client.tell(
        "textDocument/didClose",
        json!({ "textDocument": { "uri": URI } }),
    );
    let id = client.begin("textDocument/hover", place);
    assert_eq!(error_code(&client.answer(id)), Some(-32602));
    client.stop();
}

#[test]
fn mechanisms_in_rust_have_messages() {
    let text = "fn main() { let x = \"é\"; }\nlinkage::mechanism! { struct A { unit mm; param r = 3parsec; } }";
    let (mut client, _) = Client::start(&[]);
    let messages = client.open("rust", text);
    assert_eq!(messages.as_array().map(Vec::len), Some(1), "{messages}");
    assert_eq!(messages[0]["range"]["start"]["line"], 1);
    let [line, column] = place(text, "r = 3parsec");
    client.change([[line, column - 6], [line, column]], "mm");
    assert_eq!(client.messages(), json!([]));
    // The rest of the file is a matter of the compiler of Rust.
    client.change([[0, 0], [2, 0]], "fn main( {");
    assert_eq!(client.messages(), json!([]));
    client.stop();
}

#[test]
fn the_server_ends_with_its_editor() {
    let (mut client, _) = Client::start(&[]);
    client.open("linkage", "struct A { }");
    assert!(client.vanish());
}
