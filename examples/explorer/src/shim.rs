//! What the module exports: a buffer, and a function that replaces the request in it by its answer.
//!
//! The caller asks for room, writes the request, calls `respond` and reads the answer from the buffer. No memory is read
//! or written through a pointer on this side. Only the names of the functions need `unsafe`.

#![expect(unsafe_code, reason = "an exported name may clash with another; the code itself is safe")]

use std::cell::RefCell;

thread_local! {
    static BUFFER: RefCell<Vec<u8>> = const { RefCell::new(Vec::new()) };
}

/// Makes room for a request of `length` bytes, and tells where.
#[unsafe(no_mangle)]
pub extern "C" fn reserve(length: usize) -> *mut u8 {
    BUFFER.with_borrow_mut(|buffer| {
        buffer.clear();
        buffer.resize(length, 0);
        buffer.as_mut_ptr()
    })
}

/// Replaces the request by its answer, and tells how long it is.
#[unsafe(no_mangle)]
pub extern "C" fn respond() -> usize {
    BUFFER.with_borrow_mut(|buffer| {
        *buffer = crate::answer(&String::from_utf8_lossy(buffer)).into_bytes();
        buffer.len()
    })
}

/// Where the answer is.
#[unsafe(no_mangle)]
pub extern "C" fn answer_at() -> *const u8 {
    BUFFER.with_borrow(|buffer| buffer.as_ptr())
}
