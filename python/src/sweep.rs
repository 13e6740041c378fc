//! Sweeps on several threads, which a signal ends.

use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::thread;
use std::time::{Duration, Instant};

use linkage_engine::{Assembly, Sweep};
use pyo3::exceptions::PyMemoryError;
use pyo3::prelude::*;

/// Positions that a thread computes before it looks for a signal: less than a second for the
/// slowest mechanisms, and enough for the fastest ones.
const PART: usize = 4096;

/// The time between two looks for signals.
pub(crate) const SIGNALS: Duration = Duration::from_millis(50);

/// Bytes of a thread's stack: sweeps over sets keep blocks of all their numbers there.
pub(crate) const STACK: usize = 1 << 23;

/// A part of a sweep: its first position, and its rows of each column.
type Part<'a> = (usize, Vec<&'a mut [f64]>);

/// Computes a whole sweep without the lock of the interpreter.
///
/// # Errors
///
/// The exception of a signal, as `KeyboardInterrupt`; `MemoryError` if no thread can be started.
pub(crate) fn fill(
    py: Python<'_>,
    sweep: &Sweep<'_>,
    columns: Vec<&mut [f64]>,
    threads: usize,
) -> PyResult<()> {
    if sweep.positions() == 0 {
        return Ok(());
    }
    let parts = parts(columns, sweep.positions());
    let threads = threads.clamp(1, parts.len());
    py.detach(|| match threads {
        1 => fill_here(sweep, parts),
        _ => fill_by_threads(sweep, parts, threads),
    })
}

/// Computes the gaps of all groups at many positions, without the lock of the interpreter.
///
/// # Errors
///
/// The exception of a signal.
pub(crate) fn gaps(
    py: Python<'_>,
    assembly: &Assembly<'_>,
    inputs: &[&[f64]],
    out: &mut [f64],
) -> PyResult<()> {
    let positions = inputs.first().map_or(1, |slice| slice.len());
    py.detach(|| {
        let mut looked = Instant::now();
        for position in 0..positions {
            let at: Vec<f64> = inputs.iter().map(|slice| slice[position]).collect();
            for (group, gap) in assembly.gaps(&at).into_iter().enumerate() {
                out[group * positions + position] = gap;
            }
            look(&mut looked)?;
        }
        Ok(())
    })
}

/// Cuts columns into parts of the same rows.
fn parts(columns: Vec<&mut [f64]>, positions: usize) -> Vec<Part<'_>> {
    let mut parts: Vec<Part<'_>> = (0..positions)
        .step_by(PART)
        .map(|from| (from, Vec::with_capacity(columns.len())))
        .collect();
    for column in columns {
        for (part, rows) in parts.iter_mut().zip(column.chunks_mut(PART)) {
            part.1.push(rows);
        }
    }
    parts
}

/// Computes all parts in this thread.
fn fill_here(sweep: &Sweep<'_>, parts: Vec<Part<'_>>) -> PyResult<()> {
    let mut looked = Instant::now();
    for (from, columns) in parts {
        sweep.fill(from, columns);
        look(&mut looked)?;
    }
    Ok(())
}

/// Computes the parts in threads, while this one looks for signals.
fn fill_by_threads(sweep: &Sweep<'_>, parts: Vec<Part<'_>>, threads: usize) -> PyResult<()> {
    let parts = Mutex::new(parts.into_iter());
    let stopped = AtomicBool::new(false);
    let (finished, all_finished) = channel::<()>();
    let work = |_finished| {
        while !stopped.load(Ordering::Relaxed) {
            let next = parts.lock().expect("no thread panics").next();
            let Some((from, columns)) = next else { return };
            sweep.fill(from, columns);
        }
    };
    let work = &work;
    thread::scope(|scope| {
        for _ in 0..threads {
            let finished = finished.clone();
            let builder = thread::Builder::new().stack_size(STACK);
            if let Err(error) = builder.spawn_scoped(scope, move || work(finished)) {
                stopped.store(true, Ordering::Relaxed);
                let text = format!("a thread of the sweep cannot be started: {error}");
                return Err(PyMemoryError::new_err(text));
            }
        }
        // Each thread drops its end when it has nothing left to do.
        drop(finished);
        while let Err(RecvTimeoutError::Timeout) = all_finished.recv_timeout(SIGNALS) {
            let signal = Python::attach(|py| py.check_signals());
            signal.inspect_err(|_| stopped.store(true, Ordering::Relaxed))?;
        }
        Ok(())
    })
}

/// Looks for signals if the last look is some time ago.
fn look(looked: &mut Instant) -> PyResult<()> {
    if looked.elapsed() < SIGNALS {
        return Ok(());
    }
    *looked = Instant::now();
    Python::attach(|py| py.check_signals())
}
