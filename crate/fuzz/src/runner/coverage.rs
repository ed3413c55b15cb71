//! Which code an input reaches: a counter of eight bits for every edge of the control flow, put into
//! the code under test by the compiler (`-sanitizer-coverage-inline-8bit-counters`).

use std::sync::Mutex;

/// Where the counters are: first and one past the last, as addresses.
static AREAS: Mutex<Vec<(usize, usize)>> = Mutex::new(Vec::new());

/// Called by the code under test when the program starts, with its counters.
#[allow(
    unsafe_code,
    reason = "the compiler's counters call it by this very name"
)]
#[unsafe(no_mangle)]
extern "C" fn __sanitizer_cov_8bit_counters_init(start: *mut u8, end: *mut u8) {
    let mut areas = AREAS
        .lock()
        .unwrap_or_else(std::sync::PoisonError::into_inner);
    let area = (start.addr(), end.addr());
    if area.0 < area.1 && !areas.contains(&area) {
        start.expose_provenance();
        areas.push(area);
    }
}

/// The counters, and which of them ever counted how far.
pub struct Coverage {
    areas: Vec<(usize, usize)>,
    /// A bit for each order of magnitude of each counter.
    seen: Vec<u8>,
    /// Whether to tell magnitudes apart.
    magnitudes: bool,
}

impl Coverage {
    /// Nothing seen yet. Only whether code is reached counts, or, with `magnitudes`, how often as well.
    pub fn new(magnitudes: bool) -> Self {
        let areas = AREAS
            .lock()
            .unwrap_or_else(std::sync::PoisonError::into_inner)
            .clone();
        let edges = areas.iter().map(|(start, end)| end - start).sum();
        Self {
            areas,
            seen: vec![0; edges],
            magnitudes,
        }
    }

    /// Number of edges; 0 where the program was built without counters.
    pub fn edges(&self) -> usize {
        self.seen.len()
    }

    /// Number of edges reached so far.
    pub fn reached(&self) -> usize {
        self.seen.iter().filter(|&&seen| seen != 0).count()
    }

    /// Sets the counters to 0.
    pub fn reset(&mut self) {
        for &area in &self.areas {
            counters(area).fill(0);
        }
    }

    /// How much is new in what was counted since the reset.
    pub fn collect(&mut self) -> usize {
        let mut new = 0;
        let mut rest = self.seen.as_mut_slice();
        for &area in &self.areas {
            let counters = counters(area);
            let (seen, after) = rest.split_at_mut(counters.len());
            rest = after;
            let (eights, odd) = counters.as_chunks::<8>();
            let (seen_eights, seen_odd) = seen.as_chunks_mut::<8>();
            for (eight, seen) in eights.iter().zip(seen_eights) {
                // Most code is not reached at all.
                if u64::from_ne_bytes(*eight) != 0 {
                    new += see(eight, seen, self.magnitudes);
                }
            }
            new += see(odd, seen_odd, self.magnitudes);
        }
        new
    }
}

fn see(counters: &[u8], seen: &mut [u8], magnitudes: bool) -> usize {
    let mut new = 0;
    for (&counter, seen) in counters.iter().zip(seen) {
        let bit = match counter {
            0 => 0,
            _ if !magnitudes => 1,
            1 => 1,
            2 => 2,
            3 => 4,
            4..=7 => 8,
            8..=15 => 16,
            16..=31 => 32,
            32..=127 => 64,
            128.. => 128,
        };
        new += usize::from(*seen & bit != bit);
        *seen |= bit;
    }
    new
}

/// The counters of an area. Nothing that counts runs while they are held.
#[allow(
    unsafe_code,
    reason = "the counters are the compiler's; there is no other way to them"
)]
fn counters((start, end): (usize, usize)) -> &'static mut [u8] {
    let first = std::ptr::with_exposed_provenance_mut::<u8>(start);
    // SAFETY: the area is a static array of bytes that the compiler made and told of. It is written by
    // the code under test alone, which runs on the thread that calls this, and so not meanwhile; and
    // no two slices of an area are held at once.
    unsafe { std::slice::from_raw_parts_mut(first, end - start) }
}
