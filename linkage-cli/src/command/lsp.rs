//! `linkage lsp`: a language server on standard input and output.
//!
//! `linkage-editor` has all answers. Here are the messages of the protocol, and their order. Texts
//! are read in this thread, and solved in that of the worker.

mod answers;
mod capabilities;
mod client;
mod convert;
mod documents;
mod editor;
mod queue;
mod request_place;
mod worker;

use lsp_server::{Connection, ErrorCode, Message, Request, Response};

use crate::failure::Failure;
use capabilities::capabilities;
use client::Client;
use documents::{Change, Documents};
use editor::Editor;
use queue::{Next, Queue};

/// Options of the command.
#[derive(Debug, clap::Args)]
pub(super) struct Options {
    /// Accepted for editors that write it: there is no other way
    #[arg(long)]
    stdio: bool,
}

/// Serves an editor until it sends `exit`.
pub(super) fn run(_: &Options) -> Result<(), Failure> {
    let (connection, threads) = Connection::stdio();
    let result = serve(&connection);
    // The threads end when the connection is gone.
    drop(connection);
    let ended = threads.join();
    result?;
    ended.map_err(|error| Failure::Told(format!("the connection to the editor broke: {error}")))
}

fn serve(connection: &Connection) -> Result<(), Failure> {
    let broken = |error: &dyn std::fmt::Display| {
        Failure::Told(format!(
            "the editor and the server do not understand each other: {error}"
        ))
    };
    let (id, params) = connection
        .initialize_start()
        .map_err(|error| broken(&error))?;
    let client = Client::new(&params);
    let answer = capabilities(client);
    connection
        .initialize_finish(id, answer)
        .map_err(|error| broken(&error))?;
    let (work, done) = worker::start();
    let mut documents = Documents::new(client, work);
    let mut queue = Queue::new(&connection.receiver, done);
    let mut editor = Editor::new(&connection.sender, client);
    loop {
        match queue.next(documents.due()) {
            Next::Message(Message::Request(request)) => {
                if connection
                    .handle_shutdown(&request)
                    .map_err(|error| broken(&error))?
                {
                    return Ok(());
                }
                editor.send(response(&mut documents, &queue, request));
            }
            Next::Message(Message::Notification(notification)) => {
                if let Some(closed) = documents.notified(notification) {
                    editor.publish(closed);
                }
            }
            // To the request that hints are asked for again: nothing.
            Next::Message(Message::Response(_)) => {}
            Next::Cancelled(id) => {
                let code = ErrorCode::RequestCanceled as i32;
                editor.send(Response::new_err(
                    id,
                    code,
                    "the request is cancelled".to_owned(),
                ));
            }
            Next::Idle => {
                let messages = documents.read_changed();
                editor.publish_all(messages);
            }
            Next::Due => editor.publish_all(documents.due_messages()),
            Next::Done(done) => match documents.take(done) {
                Some(Change::Messages(messages)) => editor.publish(messages),
                Some(Change::Values) => editor.refresh_hints(),
                None => {}
            },
            Next::Closed => return Ok(()),
            Next::Stopped => {
                let fact = "the thread that solves mechanisms has stopped";
                return Err(Failure::Told(fact.to_owned()));
            }
        }
        editor.show_status(documents.are_settled());
    }
}

/// Answers a request; one about a text that has changed since is refused.
fn response(documents: &mut Documents, queue: &Queue<'_>, request: Request) -> Response {
    if queue.changes_later(&request) {
        let code = ErrorCode::ContentModified as i32;
        return Response::new_err(request.id, code, "the text has changed".to_owned());
    }
    answers::answer(documents, request)
}
