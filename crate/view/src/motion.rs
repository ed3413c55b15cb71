//! Level of detail: how many points are drawn while the camera moves.

/// How long after the last movement all the points are drawn again, in milliseconds.
const SETTLE_MS: f64 = 140.0;
/// Frames that come later than this are too slow for smooth movement.
const SLOW_MS: f64 = 26.0;
/// Frames that come faster than this leave room for more points.
const QUICK_MS: f64 = 19.0;
/// A pause longer than this says nothing about drawing.
const PAUSE_MS: f64 = 400.0;
/// The fewest points to draw, of all panes together.
const FEWEST: usize = 60_000;
/// What any graphics card of the last ten years draws in a frame.
const FIRST: usize = 2_500_000;

/// Adapts the number of points to what the graphics card can do, by the time between frames.
#[derive(Debug)]
pub struct Motion {
    budget: usize,
    moved: Option<f64>,
    frame: Option<f64>,
}

impl Default for Motion {
    fn default() -> Self {
        Self {
            budget: FIRST,
            moved: None,
            frame: None,
        }
    }
}

impl Motion {
    /// Called once per frame with the time in milliseconds and whether the camera has moved since
    /// the last one. Returns how many of `total` points to draw (all panes together), and whether
    /// the camera is still thought to be moving.
    pub fn frame(&mut self, now: f64, moved: bool, total: usize) -> (usize, bool) {
        if moved {
            self.moved = Some(now);
        }
        let moving = self.moved.is_some_and(|moved| now - moved < SETTLE_MS);
        if moving
            && moved
            && let Some(last) = self.frame
        {
            let elapsed = now - last;
            if (SLOW_MS..PAUSE_MS).contains(&elapsed) {
                // Far too slow, far fewer: but one late frame is no proof.
                let factor = (SLOW_MS / elapsed).max(0.6);
                self.budget = ((self.budget.min(total) as f64 * factor) as usize).max(FEWEST);
            } else if elapsed < QUICK_MS && self.budget < total {
                self.budget += self.budget / 16;
            }
        }
        // The frame after a full drawing tells how long that took, not how long movement takes.
        self.frame = (moving && moved).then_some(now);
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

    fn run(motion: &mut Motion, step: f64, frames: usize, total: usize) -> usize {
        let start = motion.frame.unwrap_or(0.0);
        (1..=frames).fold(0, |_, k| {
            motion.frame(start + k as f64 * step, true, total).0
        })
    }

    #[test]
    fn a_quick_machine_draws_everything() {
        assert_eq!(run(&mut Motion::default(), 16.7, 60, 2_000_000), 2_000_000);
    }

    #[test]
    fn a_slow_machine_draws_fewer_and_recovers() {
        let mut motion = Motion::default();
        let few = run(&mut motion, 80.0, 20, 2_000_000);
        assert!((FEWEST..200_000).contains(&few), "{few}");
        assert_eq!(run(&mut motion, 12.0, 200, 2_000_000), 2_000_000);
    }

    #[test]
    fn at_rest_everything_is_drawn() {
        let mut motion = Motion::default();
        run(&mut motion, 80.0, 20, 2_000_000);
        let rest = motion.frame(1600.0 + SETTLE_MS, false, 2_000_000);
        assert_eq!(rest, (2_000_000, false));
    }

    #[test]
    fn a_pause_between_two_movements_is_no_slow_frame() {
        let mut motion = Motion::default();
        motion.frame(0.0, true, 9_000_000);
        let before = motion.frame(16.0, true, 9_000_000).0;
        motion.frame(1000.0, false, 9_000_000);
        assert!(motion.frame(1100.0, true, 9_000_000).0 >= before);
    }
}
