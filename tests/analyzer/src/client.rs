//! The client: requests of an editor about words of a text.

use std::io::{BufRead, BufReader, Read, Write};
use std::path::Path;
use std::process::{Child, ChildStdin, ChildStdout, Command, Stdio};
use std::thread;
use std::time::Duration;

use serde_json::{Value, json};

/// A running rust-analyzer with an open file.
pub struct Analyzer {
    process: Child,
    input: ChildStdin,
    output: BufReader<ChildStdout>,
    requests: u64,
    is_ready: bool,
    uri: String,
    version: i64,
    text: String,
}

/// A range of a file.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Location {
    /// The line, counted from 1.
    pub line: u64,
    /// The text of the range.
    pub word: String,
}

/// The server computes anew after a change; a request before it has done so is refused.
const CHANGED: [i64; 2] = [-32801, -32802];

impl Analyzer {
    /// Starts rust-analyzer in a folder and waits until it has read the program.
    ///
    /// # Panics
    ///
    /// If it does not start.
    pub fn new(folder: &Path) -> Self {
        let mut process = Command::new("rust-analyzer")
            .current_dir(folder)
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .stderr(Stdio::null())
            .spawn()
            .expect("rust-analyzer starts");
        let input = process.stdin.take().expect("its input");
        let output = BufReader::new(process.stdout.take().expect("its output"));
        let mut analyzer = Self {
            process,
            input,
            output,
            requests: 0,
            is_ready: false,
            uri: String::new(),
            version: 0,
            text: String::new(),
        };
        analyzer.request(
            "initialize",
            &json!({
                "processId": null,
                "rootUri": format!("file://{}", folder.display()),
                "initializationOptions": {
                    "checkOnSave": false,
                    "cachePriming": { "enable": false },
                    "linkedProjects": [folder.join("rust-project.json")],
                },
                "capabilities": {
                    "experimental": { "serverStatusNotification": true },
                    "textDocument": { "hover": { "contentFormat": ["markdown"] } },
                    "workspace": { "workspaceEdit": { "documentChanges": true } },
                },
            }),
        );
        analyzer.notify("initialized", &json!({}));
        while !analyzer.is_ready {
            analyzer.message();
        }
        analyzer
    }

    /// Opens a file; all requests are about it from then on.
    ///
    /// # Panics
    ///
    /// If the file cannot be read.
    pub fn open(&mut self, path: &Path) {
        let text = std::fs::read_to_string(path).expect("the file of a module");
        if !self.uri.is_empty() {
            let document = json!({ "textDocument": { "uri": self.uri } });
            self.notify("textDocument/didClose", &document);
        }
        self.uri = format!("file://{}", path.display());
        self.version = 1;
        self.text = text;
        let document =
            json!({ "uri": self.uri, "languageId": "rust", "version": 1, "text": self.text });
        self.notify("textDocument/didOpen", &json!({ "textDocument": document }));
    }

    /// Replaces the text of the file.
    pub fn change(&mut self, text: &str) {
        self.version += 1;
        self.text = text.to_owned();
        let parameters = json!({
            "textDocument": { "uri": self.uri, "version": self.version },
            "contentChanges": [{ "text": text }],
        });
        self.notify("textDocument/didChange", &parameters);
    }

    /// Returns the text of the hover at an offset, empty if there is none.
    pub fn hover(&mut self, offset: usize) -> String {
        let answer = self.request("textDocument/hover", &self.at(offset));
        answer["contents"]["value"]
            .as_str()
            .unwrap_or_default()
            .to_owned()
    }

    /// Returns the definitions of the word at an offset that are in the file.
    pub fn definitions(&mut self, offset: usize) -> Vec<Location> {
        let answer = self.request("textDocument/definition", &self.at(offset));
        let all = answer.as_array().cloned().unwrap_or_default();
        let here = all.iter().filter(|one| one["uri"] == *self.uri);
        here.map(|one| self.location(&one["range"])).collect()
    }

    /// Returns the file after the word at an offset is renamed.
    ///
    /// # Errors
    ///
    /// The message of the server.
    ///
    /// # Panics
    ///
    /// If the answer is not one of the protocol.
    pub fn renamed(&mut self, offset: usize, name: &str) -> Result<String, String> {
        let mut parameters = self.at(offset);
        parameters["newName"] = name.into();
        let answer = self.request("textDocument/rename", &parameters);
        let Some(changes) = answer["documentChanges"].as_array() else {
            return Err(answer.to_string());
        };
        let of_file = changes
            .iter()
            .filter(|change| change["textDocument"]["uri"] == *self.uri);
        let edits = of_file.flat_map(|change| change["edits"].as_array().into_iter().flatten());
        let mut edits: Vec<(usize, usize, &str)> = edits
            .map(|edit| {
                let ends = ["start", "end"].map(|end| self.offset(&edit["range"][end]));
                (ends[0], ends[1], edit["newText"].as_str().expect("a text"))
            })
            .collect();
        edits.sort_unstable();
        let mut text = self.text.clone();
        for (start, end, new) in edits.into_iter().rev() {
            text.replace_range(start..end, new);
        }
        Ok(text)
    }

    /// Returns the labels of the completions at an offset.
    pub fn completions(&mut self, offset: usize) -> Vec<String> {
        let answer = self.request("textDocument/completion", &self.at(offset));
        let items = answer["items"].as_array().or_else(|| answer.as_array());
        let labels = items
            .into_iter()
            .flatten()
            .filter_map(|item| item["label"].as_str());
        labels.map(str::to_owned).collect()
    }

    fn at(&self, offset: usize) -> Value {
        let before = &self.text[..offset];
        let start = before.rfind('\n').map_or(0, |end| end + 1);
        json!({
            "textDocument": { "uri": self.uri },
            "position": {
                "line": before.matches('\n').count(),
                "character": self.text[start..offset].encode_utf16().count(),
            },
        })
    }

    fn offset(&self, position: &Value) -> usize {
        let number = |name: &str| position[name].as_u64().expect("a number") as usize;
        let mut lines = self.text.split_inclusive('\n');
        let start: usize = lines.by_ref().take(number("line")).map(str::len).sum();
        let line = lines.next().unwrap_or_default();
        let mut units = 0;
        let character = number("character");
        let passed = line.chars().take_while(|letter| {
            units += letter.len_utf16();
            units <= character
        });
        start + passed.map(char::len_utf8).sum::<usize>()
    }

    fn location(&self, range: &Value) -> Location {
        let [start, end] = ["start", "end"].map(|end| self.offset(&range[end]));
        Location {
            line: range["start"]["line"].as_u64().expect("a number") + 1,
            word: self.text[start..end].to_owned(),
        }
    }

    /// Returns the result of a request, or its error.
    fn request(&mut self, method: &str, parameters: &Value) -> Value {
        loop {
            self.requests += 1;
            let id = self.requests;
            self.send(
                &json!({ "jsonrpc": "2.0", "id": id, "method": method, "params": parameters }),
            );
            let answer = loop {
                let message = self.message();
                if message["id"] == id && message.get("method").is_none() {
                    break message;
                }
            };
            match answer.get("error") {
                Some(error) if CHANGED.iter().any(|code| error["code"] == *code) => {
                    thread::sleep(Duration::from_millis(50));
                }
                Some(error) => return error.clone(),
                None => return answer["result"].clone(),
            }
        }
    }

    fn notify(&mut self, method: &str, parameters: &Value) {
        self.send(&json!({ "jsonrpc": "2.0", "method": method, "params": parameters }));
    }

    fn send(&mut self, message: &Value) {
        let text = message.to_string();
        write!(self.input, "Content-Length: {}\r\n\r\n{text}", text.len()).expect("it reads");
        self.input.flush().expect("it reads");
    }

    /// Reads a message; requests of the server are answered.
    fn message(&mut self) -> Value {
        let mut length = 0;
        loop {
            let mut line = String::new();
            let count = self.output.read_line(&mut line).expect("it answers");
            assert!(count > 0, "rust-analyzer has ended");
            match line.trim().split_once(": ") {
                Some(("Content-Length", value)) => length = value.parse().expect("a number"),
                Some(_) => {}
                None => break,
            }
        }
        let mut content = vec![0; length];
        self.output.read_exact(&mut content).expect("it answers");
        let message: Value = serde_json::from_slice(&content).expect("JSON");
        if message["method"] == "experimental/serverStatus"
            && message["params"]["quiescent"] == true
        {
            self.is_ready = true;
        }
        if let (Some(_), Some(id)) = (message.get("method"), message.get("id")) {
            let result = match message["method"] == "workspace/configuration" {
                true => json!([{}]),
                false => Value::Null,
            };
            self.send(&json!({ "jsonrpc": "2.0", "id": id, "result": result }));
        }
        message
    }
}

impl Drop for Analyzer {
    fn drop(&mut self) {
        // It may have ended.
        let _ = self.process.kill();
        let _ = self.process.wait();
    }
}
