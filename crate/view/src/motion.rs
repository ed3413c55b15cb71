//! Level of detail: how many points are drawn while the camera moves.

/// How long after the last movement all the points are drawn again, in milliseconds.
const SETTLE_MS: f64 = 140.0;
/// A frame that comes later than this after it was asked for is too slow for smooth movement.
const SLOW_MS: f64 = 26.0;
/// A frame that comes within this time leaves room for more points.
const QUICK_MS: f64 = 19.0;
/// The fewest points to draw, of all panes together.
const FEWEST: usize = 60_000;
/// What any graphics card of the last ten years draws in a frame.
const FIRST: usize = 2_500_000;

/// Adapts the number of points to what the graphics card can do, by how long frames are waited for.
#[derive(Debug)]
pub struct Motion {
    budget: usize,
    moved: Option<f64>,
    /// Whether the last frame was one of the movement, so that the wait for this one was for it.
    in_motion: bool,
}

impl Default for Motion {
    fn default() -> Self {
        Self {
            budget: FIRST,
            moved: None,
            in_motion: false,
        }
    }
}

impl Motion {
    /// Called once per frame with the time in milliseconds, how long ago the frame was asked for
    /// and whether the camera has moved since the last one. Returns how many of `total` points to
    /// draw (all panes together), and whether the camera is still thought to be moving.
    pub fn frame(&mut self, now: f64, waited: f64, moved: bool, total: usize) -> (usize, bool) {
        if moved {
            self.moved = Some(now);
        }
        let moving = self.moved.is_some_and(|moved| now - moved < SETTLE_MS);
        if moved && self.in_motion {
            if waited > SLOW_MS {
                // Far too slow, far fewer: but one late frame is no proof.
                let factor = (SLOW_MS / waited).max(0.5);
                self.budget = ((self.budget.min(total) as f64 * factor) as usize).max(FEWEST);
            } else if waited < QUICK_MS && self.budget < total {
                self.budget += self.budget / 16;
            }
        }
        // The wait after a full drawing is for that, not for movement.
        self.in_motion = moving && moved;
        let count = if moving {
            self.budget.min(total)
        } else {
            total
        };
        (count, moving)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn run(motion: &mut Motion, wait: f64, frames: usize, total: usize) -> usize {
        let start = motion.moved.unwrap_or(0.0);
        (1..=frames).fold(0, |_, k| {
            motion.frame(start + k as f64 * wait, wait, true, total).0
        })
    }

    #[test]
    fn a_quick_machine_draws_everything() {
        assert_eq!(run(&mut Motion::default(), 16.7, 60, 2_000_000), 2_000_000);
    }

    #[test]
    fn a_slow_machine_draws_fewer_and_recovers() {
        for wait in [80.0, 2000.0] {
            let mut motion = Motion::default();
            let few = run(&mut motion, wait, 20, 2_000_000);
            assert!((FEWEST..200_000).contains(&few), "{few}");
            assert_eq!(run(&mut motion, 12.0, 200, 2_000_000), 2_000_000);
        }
    }

    #[test]
    fn at_rest_everything_is_drawn() {
        let mut motion = Motion::default();
        run(&mut motion, 80.0, 20, 2_000_000);
        let rest = motion.frame(1600.0 + SETTLE_MS, 16.0, false, 2_000_000);
        assert_eq!(rest, (2_000_000, false));
    }

    #[test]
    fn a_pause_between_two_movements_is_no_slow_frame() {
        let mut motion = Motion::default();
        motion.frame(0.0, 16.0, true, 9_000_000);
        let before = motion.frame(16.0, 16.0, true, 9_000_000).0;
        assert!(motion.frame(1100.0, 16.0, true, 9_000_000).0 >= before);
    }

    #[test]
    fn the_wait_after_a_full_drawing_counts_for_nothing() {
        let mut motion = Motion::default();
        let before = motion.frame(0.0, 16.0, true, 9_000_000).0;
        motion.frame(500.0, 16.0, false, 9_000_000);
        assert_eq!(motion.frame(2500.0, 2000.0, true, 9_000_000).0, before);
    }
}
