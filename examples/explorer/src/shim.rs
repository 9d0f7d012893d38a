//! The exports of the module: a buffer, and a function that replaces the request in it by its answer.
//!
//! The caller reserves memory, writes the request, calls `respond` and reads the answer from the buffer. No memory is
//! read or written through a pointer on this side. Only the names of the functions need `unsafe`.

#![expect(unsafe_code, reason = "an exported name may clash with another; the code itself is safe")]

use std::cell::RefCell;

thread_local! {
    static BUFFER: RefCell<Vec<u8>> = const { RefCell::new(Vec::new()) };
}

/// Reserves memory for a request of `length` bytes, and returns its address.
#[unsafe(no_mangle)]
pub extern "C" fn reserve(length: usize) -> *mut u8 {
    BUFFER.with_borrow_mut(|buffer| {
        buffer.clear();
        buffer.resize(length, 0);
        buffer.as_mut_ptr()
    })
}

/// Replaces the request by its answer, and returns the length of the answer.
#[unsafe(no_mangle)]
pub extern "C" fn respond() -> usize {
    BUFFER.with_borrow_mut(|buffer| {
        *buffer = crate::answer(&String::from_utf8_lossy(buffer)).into_bytes();
        buffer.len()
    })
}

/// The same for a request of a scene.
#[unsafe(no_mangle)]
pub extern "C" fn learn() -> usize {
    BUFFER.with_borrow_mut(|buffer| {
        *buffer = crate::learn(&String::from_utf8_lossy(buffer)).into_bytes();
        buffer.len()
    })
}

/// The address of the answer.
#[unsafe(no_mangle)]
pub extern "C" fn answer_at() -> *const u8 {
    BUFFER.with_borrow(|buffer| buffer.as_ptr())
}
