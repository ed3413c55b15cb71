//! The trace of a fit of places, told of the whole cloud.

use super::super::progress::{Cancelled, Observer, Stage};
use super::super::trace::Event;

/// Passes on what an observer is told, with the points of the whole cloud in place of those that stand
/// for them.
pub struct Unfolded<'o> {
    /// The observer.
    pub observer: &'o mut dyn Observer,
    /// The point of the fit that stands for each point of the cloud, `u32::MAX` for none.
    pub standing_for: &'o [u32],
}

impl Unfolded<'_> {
    /// What is known of each point of the fit, for each point of the cloud.
    fn unfold<T: Copy>(&self, of_places: &[T], otherwise: T) -> Vec<T> {
        let places = self.standing_for.iter();
        let of = |&place: &u32| of_places.get(place as usize).copied().unwrap_or(otherwise);
        places.map(of).collect()
    }
}

impl Observer for Unfolded<'_> {
    fn progress(&mut self, stage: Stage, fraction: f64) -> Result<(), Cancelled> {
        self.observer.progress(stage, fraction)
    }

    fn wants_trace(&self) -> bool {
        self.observer.wants_trace()
    }

    fn trace(&mut self, event: Event) {
        let event = match event {
            Event::Accepted { surface, support } => {
                let all = (0u32..).zip(self.standing_for);
                let is_on = |(_, place): &(u32, &u32)| support.binary_search(place).is_ok();
                let support = all.filter(is_on).map(|(index, _)| index).collect();
                Event::Accepted { surface, support }
            }
            Event::SurfaceVariation {
                values,
                quantile,
                threshold,
            } => Event::SurfaceVariation {
                values: self.unfold(&values, 0.0),
                quantile,
                threshold,
            },
            Event::Regions(regions) => Event::Regions(self.unfold(&regions, u32::MAX)),
            other @ (Event::Scale(_)
            | Event::Hough(_)
            | Event::Peak { .. }
            | Event::Slippage { .. }) => other,
        };
        self.observer.trace(event);
    }
}
