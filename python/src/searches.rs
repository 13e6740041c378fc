//! Long searches on threads of their own, which a signal ends.

use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::sync::{Mutex, PoisonError};
use std::thread;

use pyo3::exceptions::PyMemoryError;
use pyo3::prelude::*;
use rayon::ThreadPoolBuilder;

use crate::sweep::{SIGNALS, STACK};

/// Done, to do, and the least value up to now.
pub(crate) type Progress = (usize, usize, f64);

/// The two ends of a search: the reader of its progress, and the order to end it.
#[derive(Default)]
pub(crate) struct Watched {
    /// True once the search is to end.
    pub(crate) stopped: AtomicBool,
    progress: Mutex<Option<Progress>>,
}

impl Watched {
    /// Sets the progress.
    pub(crate) fn report(&self, progress: Progress) {
        let mut last = self.progress.lock().unwrap_or_else(PoisonError::into_inner);
        *last = Some(progress);
    }

    /// Calls a function of Python with the progress, if there is news.
    fn show(&self, py: Python<'_>, shown: Option<&Py<PyAny>>) -> PyResult<()> {
        let mut last = self.progress.lock().unwrap_or_else(PoisonError::into_inner);
        let news = last.take();
        drop(last);
        match (shown, news) {
            (Some(shown), Some(progress)) => shown.call1(py, progress).map(drop),
            _ => Ok(()),
        }
    }
}

/// Runs a search in a pool of threads without the lock of the interpreter, while this thread looks
/// for signals and shows the progress.
///
/// # Errors
///
/// The exception of a signal or of `shown`; `MemoryError` if no thread can be started.
pub(crate) fn searched<R: Send>(
    py: Python<'_>,
    threads: usize,
    shown: Option<&Py<PyAny>>,
    search: impl FnOnce(&Watched) -> R + Send,
) -> PyResult<R> {
    let watched = Watched::default();
    py.detach(|| {
        let pool = ThreadPoolBuilder::new().num_threads(threads);
        let pool = pool.stack_size(STACK).build().map_err(no_thread)?;
        let (sender, finished) = channel();
        let work = || {
            let found = pool.install(|| search(&watched));
            // The receiver is gone if an exception ended the wait.
            drop(sender.send(found));
        };
        thread::scope(|scope| {
            let worker = thread::Builder::new().spawn_scoped(scope, work);
            worker.map_err(no_thread)?;
            loop {
                match finished.recv_timeout(SIGNALS) {
                    Ok(found) => {
                        Python::attach(|py| watched.show(py, shown))?;
                        return Ok(found);
                    }
                    Err(RecvTimeoutError::Timeout) => {
                        let seen = Python::attach(|py| {
                            py.check_signals()?;
                            watched.show(py, shown)
                        });
                        seen.inspect_err(|_| watched.stopped.store(true, Ordering::Relaxed))?;
                    }
                    Err(RecvTimeoutError::Disconnected) => {
                        unreachable!("a search that panics ends the scope")
                    }
                }
            }
        })
    })
}

fn no_thread(error: impl std::fmt::Display) -> PyErr {
    PyMemoryError::new_err(format!("a thread of the search cannot be started: {error}"))
}
