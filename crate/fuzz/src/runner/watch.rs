//! Looks at the clock beside a run, and ends the program where it is past help.

use std::path::PathBuf;
use std::process;
use std::sync::Mutex;
use std::sync::atomic::{AtomicU64, Ordering::Relaxed};
use std::thread;
use std::time::{Duration, Instant};

use crate::fault::{Fault, Report};

/// How long a run may take.
pub const LONGEST: Duration = Duration::from_secs(2);
/// How often to look.
const PAUSE: Duration = Duration::from_millis(50);

/// Number of the run under way, 0 between runs.
static RUN: AtomicU64 = AtomicU64::new(0);
/// What is run, and where a fault is told.
static CURRENT: Mutex<Option<(Vec<u8>, Report)>> = Mutex::new(None);

/// Starts to look after the thread that calls it.
pub fn start(report: Report) {
    set(|current| *current = Some((Vec::new(), report)));
    let clock = Clock::of_this_thread();
    thread::spawn(move || {
        let mut since: Option<(u64, Duration)> = None;
        loop {
            thread::sleep(PAUSE);
            let (run, now) = (RUN.load(Relaxed), clock.now());
            match since {
                Some((same, start)) if same == run && run != 0 => {
                    if now.saturating_sub(start) > LONGEST {
                        end(&Fault::Hang);
                    }
                }
                _ => since = Some((run, now)),
            }
        }
    });
}

/// Says that a run begins, on which input.
pub fn begin(run: u64, input: &[u8]) {
    set(|current| {
        if let Some((kept, _)) = current {
            kept.clear();
            kept.extend_from_slice(input);
        }
    });
    RUN.store(run, Relaxed);
}

/// Says that it is over.
pub fn over() {
    RUN.store(0, Relaxed);
}

/// Called by the allocator when a run holds more than there should ever be.
pub fn end_for_memory(held: usize) {
    end(&Fault::Memory(held));
}

/// Tells of a fault that the program does not go on after.
fn end(fault: &Fault) {
    set(|current| {
        if let Some((input, report)) = current {
            report.tell(fault, input);
        }
    });
    process::exit(1);
}

fn set(act: impl FnOnce(&mut Option<(Vec<u8>, Report)>)) {
    act(&mut CURRENT
        .lock()
        .unwrap_or_else(std::sync::PoisonError::into_inner));
}

/// Time that a thread has worked, where the system tells; what other programs take does not count.
struct Clock {
    worked: Option<PathBuf>,
    start: Instant,
}

impl Clock {
    fn of_this_thread() -> Self {
        let thread = std::fs::canonicalize("/proc/thread-self").ok();
        Self {
            worked: thread
                .map(|thread| thread.join("schedstat"))
                .filter(|file| file.exists()),
            start: Instant::now(),
        }
    }

    fn now(&self) -> Duration {
        let worked = self.worked.as_ref().and_then(|file| {
            let text = std::fs::read_to_string(file).ok()?;
            Some(Duration::from_nanos(text.split(' ').next()?.parse().ok()?))
        });
        worked.unwrap_or_else(|| self.start.elapsed())
    }
}
