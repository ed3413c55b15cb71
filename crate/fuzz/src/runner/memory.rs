//! How much memory a run holds at its most, counted by the allocator.

use std::alloc::{GlobalAlloc, Layout, System};
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering::Relaxed};

use crate::watch;

/// Bytes at which a run is ended before the machine is in trouble.
const TOO_MUCH: usize = 2 << 30;

/// The system's allocator with a count of what is held, and of the most that ever was.
struct Counting;

static HELD: AtomicUsize = AtomicUsize::new(0);
static MOST: AtomicUsize = AtomicUsize::new(0);
/// Whether a run is under way.
static WATCHED: AtomicBool = AtomicBool::new(false);

fn take(size: usize) {
    let held = HELD.fetch_add(size, Relaxed).saturating_add(size);
    MOST.fetch_max(held, Relaxed);
    if held > TOO_MUCH && WATCHED.swap(false, Relaxed) {
        // What comes next allocates itself, a little.
        HELD.fetch_sub(size, Relaxed);
        watch::end_for_memory(held);
    }
}

#[allow(unsafe_code, reason = "an allocator is unsafe by its trait")]
// SAFETY: every call is passed on unchanged.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        take(layout.size());
        unsafe { System.alloc(layout) }
    }

    unsafe fn alloc_zeroed(&self, layout: Layout) -> *mut u8 {
        take(layout.size());
        unsafe { System.alloc_zeroed(layout) }
    }

    unsafe fn realloc(&self, pointer: *mut u8, layout: Layout, size: usize) -> *mut u8 {
        take(size);
        HELD.fetch_sub(layout.size(), Relaxed);
        unsafe { System.realloc(pointer, layout, size) }
    }

    unsafe fn dealloc(&self, pointer: *mut u8, layout: Layout) {
        HELD.fetch_sub(layout.size(), Relaxed);
        unsafe { System.dealloc(pointer, layout) }
    }
}

#[global_allocator]
static ALLOCATOR: Counting = Counting;

/// What the work gives, and the most bytes that were held while it was done beyond those before.
pub fn peak<T>(work: impl FnOnce() -> T) -> (T, usize) {
    let before = HELD.load(Relaxed);
    MOST.store(before, Relaxed);
    WATCHED.store(true, Relaxed);
    let value = work();
    WATCHED.store(false, Relaxed);
    (value, MOST.load(Relaxed).saturating_sub(before))
}
