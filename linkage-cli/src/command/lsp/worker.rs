//! The work that takes longer than a key: a thread that solves texts, the newest of each.

use std::thread;

use crossbeam_channel::{Receiver, Sender, unbounded};
use linkage_editor::{Evaluated, Evaluation, Solved, Solving};

/// Work about an open text.
pub(super) enum Work {
    /// To find its messages.
    Solve(Solving),
    /// To compute the values of its names, which can wait.
    Evaluate(Evaluation),
}

/// The result of [`Work`].
pub(super) enum Done {
    Solved(Solved),
    Evaluated(Evaluated),
}

/// A thing and the address of the text that it is about.
pub(super) type About<T> = (String, T);

/// Starts the thread. It ends when one of the channels is gone.
pub(super) fn start() -> (Sender<About<Work>>, Receiver<About<Done>>) {
    let (work, waiting) = unbounded();
    let (results, done) = unbounded();
    thread::spawn(move || run(&waiting, &results));
    (work, done)
}

fn run(arriving: &Receiver<About<Work>>, results: &Sender<About<Done>>) {
    let mut waiting = Vec::new();
    loop {
        if waiting.is_empty() {
            match arriving.recv() {
                Ok(work) => add(&mut waiting, work),
                Err(_) => return,
            }
        }
        arriving.try_iter().for_each(|work| add(&mut waiting, work));
        let (uri, work) = waiting.remove(next(&waiting));
        let done = match work {
            Work::Solve(solving) => Done::Solved(solving.run()),
            Work::Evaluate(evaluation) => Done::Evaluated(evaluation.run()),
        };
        if results.send((uri, done)).is_err() {
            return;
        }
    }
}

/// Adds work, instead of that about earlier versions of the text.
fn add(waiting: &mut Vec<About<Work>>, work: About<Work>) {
    waiting.retain(|(uri, _)| *uri != work.0);
    waiting.push(work);
}

/// Returns the index of the work to do first: messages before values.
fn next(waiting: &[About<Work>]) -> usize {
    let mut works = waiting.iter();
    let solving = works.position(|(_, work)| matches!(work, Work::Solve(_)));
    solving.unwrap_or(0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use linkage_editor::Document;

    /// A text that is solved in no time.
    const TEXT: &str = "struct A { unit mm; param r = 1mm; input x = 0mm; let y = r + x; }";

    fn solving(document: &mut Document, text: &str) -> Work {
        Work::Solve(document.read(text).expect("it is new"))
    }

    #[test]
    fn earlier_versions_are_left_out_and_messages_come_first() {
        let mut document = Document::new("a.mech", "");
        let Work::Solve(first) = solving(&mut document, TEXT) else {
            panic!("it is to be solved");
        };
        let evaluation = document.finish(first.run()).expect("it has values");
        let about = |uri: &str, work| (uri.to_owned(), work);
        let mut waiting = Vec::new();
        add(&mut waiting, about("a", Work::Evaluate(evaluation)));
        let second = solving(&mut document, &TEXT.replace("1mm", "2mm"));
        add(&mut waiting, about("b", second));
        assert_eq!(next(&waiting), 1);
        let third = solving(&mut document, &TEXT.replace("1mm", "3mm"));
        add(&mut waiting, about("a", third));
        let uris: Vec<&str> = waiting.iter().map(|(uri, _)| uri.as_str()).collect();
        assert_eq!((uris, next(&waiting)), (vec!["b", "a"], 0));
    }

    #[test]
    fn the_thread_solves_and_ends() {
        let (work, done) = start();
        let mut document = Document::new("a.mech", "");
        let solving = solving(&mut document, TEXT);
        work.send(("a".to_owned(), solving)).expect("it runs");
        let Ok((uri, Done::Solved(solved))) = done.recv() else {
            panic!("a solution");
        };
        assert_eq!(uri, "a");
        assert!(document.finish(solved).is_some());
        drop(work);
        assert!(done.recv().is_err());
    }
}
