//! The interface of the module: the script writes a request into [`room`] and reads the answer
//! after [`run`]. All addresses are those of a buffer of the module, which stays until the next call.

// The attributes that give the functions their names in the module count as unsafe: no other
// function of the module has one of these names.
#![allow(unsafe_code)]

use std::cell::RefCell;
use std::panic;

use crate::tasks::answer;

thread_local! {
    /// The request before a run, and its answer after it.
    static TEXT: RefCell<Vec<u8>> = const { RefCell::new(Vec::new()) };
}

/// Makes room for a request of so many bytes, and returns its address.
#[unsafe(no_mangle)]
extern "C" fn room(length: usize) -> *mut u8 {
    panic::set_hook(Box::new(|panic| store(panic.to_string())));
    TEXT.with_borrow_mut(|text| {
        *text = vec![0; length];
        text.as_mut_ptr()
    })
}

/// Answers the request, and returns the length of the answer. After a panic, the answer is the
/// message of the panic.
#[unsafe(no_mangle)]
extern "C" fn run() -> usize {
    let request = TEXT.take();
    let answer = answer(&String::from_utf8_lossy(&request));
    store(answer);
    length()
}

/// Returns the address of the answer.
#[unsafe(no_mangle)]
extern "C" fn address() -> *const u8 {
    TEXT.with_borrow(|text| text.as_ptr())
}

/// Returns the length of the answer.
#[unsafe(no_mangle)]
extern "C" fn length() -> usize {
    TEXT.with_borrow(Vec::len)
}

fn store(answer: String) {
    TEXT.set(answer.into_bytes());
}
