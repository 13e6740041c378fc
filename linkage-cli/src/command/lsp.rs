//! `linkage lsp`: a language server on standard input and output.
//!
//! `linkage-editor` has all answers. Here are the messages of the protocol, and their order.

mod answers;
mod capabilities;
mod convert;
mod documents;
mod queue;

use lsp_server::{Connection, ErrorCode, Message, Request, Response};
use lsp_types::notification::{Notification as _, PublishDiagnostics};

use crate::failure::Failure;
use capabilities::{capabilities, encoding};
use documents::Documents;
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
    let encoding = encoding(&params);
    let answer = capabilities(encoding);
    connection
        .initialize_finish(id, answer)
        .map_err(|error| broken(&error))?;
    let mut documents = Documents::new(encoding);
    let mut queue = Queue::new(&connection.receiver);
    loop {
        match queue.next() {
            Next::Message(Message::Request(request)) => {
                if connection
                    .handle_shutdown(&request)
                    .map_err(|error| broken(&error))?
                {
                    return Ok(());
                }
                let response = response(&mut documents, &queue, request);
                send(connection, response.into());
            }
            Next::Message(Message::Notification(notification)) => {
                if let Some(closed) = documents.notified(notification) {
                    publish(connection, closed);
                }
            }
            // The server sends no requests.
            Next::Message(Message::Response(_)) => {}
            Next::Cancelled(id) => {
                let code = ErrorCode::RequestCanceled as i32;
                let response = Response::new_err(id, code, "the request is cancelled".to_owned());
                send(connection, response.into());
            }
            Next::Idle => {
                for messages in documents.changed_messages() {
                    publish(connection, messages);
                }
            }
            Next::Closed => return Ok(()),
        }
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

fn publish(connection: &Connection, messages: lsp_types::PublishDiagnosticsParams) {
    let method = PublishDiagnostics::METHOD.to_owned();
    send(
        connection,
        lsp_server::Notification::new(method, messages).into(),
    );
}

/// Sends a message. If the editor is gone, the end of its messages follows.
fn send(connection: &Connection, message: Message) {
    let _ = connection.sender.send(message);
}
