//! What colours the points of one side: labels with a table, scalars with a range, or normals.

use wasm_bindgen::prelude::wasm_bindgen;

use crate::cloud::{Arranged, Cloud};

/// What a label's points look like. A faded, hidden or locked point is not found by the cursor.
#[wasm_bindgen]
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[repr(u8)]
pub enum LabelState {
    /// Not drawn and not picked.
    Hidden = 0,
    /// Drawn almost in the colour of the background, so that others stand out; not picked.
    Faded = 1,
    /// Drawn in its colour.
    Shown = 2,
    /// Drawn in its colour, with an outline.
    Highlighted = 3,
    /// Drawn in its colour; not picked.
    Locked = 4,
}

impl LabelState {
    /// The state of that number; unknown numbers are shown.
    pub fn from_number(number: u8) -> Self {
        match number {
            0 => Self::Hidden,
            1 => Self::Faded,
            3 => Self::Highlighted,
            4 => Self::Locked,
            _ => Self::Shown,
        }
    }

    /// Whether the cursor finds its points: what is faded or locked lets it through to what is not.
    pub fn can_be_picked(self) -> bool {
        matches!(self, Self::Shown | Self::Highlighted)
    }
}

/// Which of a side's values give the colour.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum ColourBy {
    /// The colour of the point's label.
    #[default]
    Label,
    /// The point's scalar, from the low to the high end of the colour map.
    Scalar {
        /// Value at the start of the map.
        low: f32,
        /// Value at its end.
        high: f32,
    },
    /// The absolute components of the unit normal as red, green and blue. Normals estimated from
    /// points have no sign, so the sign is left out (as in Pajevic and Pierpaoli 1999).
    Normal,
}

/// Everything that colours the points of one side. Values are on their way into the
/// cloud's shuffled order; the counters tell the graphics side what has changed since it last looked.
#[derive(Debug)]
pub struct Colouring {
    /// What gives the colour.
    pub by: ColourBy,
    labels: Revised<Arranged<u32, u32>>,
    largest: u32,
    scalars: Revised<Arranged<f32, f32>>,
    table: Revised<Vec<[u8; 4]>>,
    map: Revised<Vec<[u8; 4]>>,
}

/// A value and how often it has been set.
#[derive(Debug, Default)]
pub struct Revised<T> {
    value: T,
    revision: u64,
}

impl<T> Revised<T> {
    /// A value that has not been set yet.
    pub fn new(value: T) -> Self {
        Self { value, revision: 0 }
    }

    /// The value.
    pub fn get(&self) -> &T {
        &self.value
    }

    /// How often it has been set.
    pub fn revision(&self) -> u64 {
        self.revision
    }

    /// Sets it.
    pub fn set(&mut self, value: T) {
        self.change(|held| *held = value);
    }

    /// Brings it nearer to what it was set to; it stays the same value.
    pub fn proceed(&mut self, act: impl FnOnce(&mut T)) {
        act(&mut self.value);
    }

    /// Changes it in place.
    pub fn change(&mut self, act: impl FnOnce(&mut T)) {
        act(&mut self.value);
        self.revision += 1;
    }
}

impl Default for Colouring {
    fn default() -> Self {
        Self {
            by: ColourBy::default(),
            labels: Revised::new(labels_of(Vec::new())),
            largest: 0,
            scalars: Revised::new(Arranged::none(scalar)),
            table: Revised::default(),
            map: Revised::default(),
        }
    }
}

/// A point that is given no label has label 0.
fn labels_of(labels: Vec<u32>) -> Arranged<u32, u32> {
    Arranged::of(labels, 1, |label| label.first().copied().unwrap_or(0))
}

fn scalar(given: &[f32]) -> f32 {
    given.first().copied().unwrap_or(f32::NAN)
}

impl Colouring {
    /// Colour of labels that the table does not know.
    const UNKNOWN: [u8; 3] = [128, 128, 128];

    /// Forgets the values of the points that were there before; the table stays.
    pub fn clear(&mut self) {
        self.by = ColourBy::Label;
        self.set_labels(Vec::new());
        self.scalars.set(Arranged::none(scalar));
    }

    /// Sets the label of each point, in the order the points were given.
    pub fn set_labels(&mut self, labels: Vec<u32>) {
        self.largest = labels.iter().copied().max().unwrap_or(0);
        self.labels.set(labels_of(labels));
    }

    /// Sets the scalar of each point, in the order the points were given. Points without a number
    /// (NaN) take the colour of label 0.
    pub fn set_scalars(&mut self, scalars: Vec<f32>) {
        self.scalars.set(Arranged::of(scalars, 1, scalar));
    }

    /// Brings labels and scalars of as many more points into the cloud's order.
    pub fn proceed(&mut self, cloud: &Cloud, points: usize) {
        self.labels.proceed(|labels| labels.proceed(cloud, points));
        self.scalars
            .proceed(|scalars| scalars.proceed(cloud, points));
    }

    /// How many points have all that they are drawn by.
    pub fn ready(&self) -> usize {
        let labels = self.labels.get().values().len();
        let scalars = self.scalars.get();
        match self.by {
            ColourBy::Scalar { .. } if scalars.is_wanted() => labels.min(scalars.values().len()),
            _ => labels,
        }
    }

    /// Whether all values are in order.
    pub fn is_ready(&self, cloud: &Cloud) -> bool {
        self.labels.get().is_ready(cloud) && self.scalars.get().is_ready(cloud)
    }

    /// Sets the colours (r g b per label) and keeps the states of the labels there were.
    pub fn set_colours(&mut self, colours: &[u8]) {
        let (colours, _) = colours.as_chunks::<3>();
        let states = self.table.get();
        let table = colours
            .iter()
            .enumerate()
            .map(|(label, &[r, g, b])| {
                let shown = LabelState::Shown as u8;
                [r, g, b, states.get(label).map_or(shown, |entry| entry[3])]
            })
            .collect();
        self.table.set(table);
    }

    /// Sets the states, one per label; labels beyond the last are shown.
    pub fn set_states(&mut self, states: &[u8]) {
        let mut table = std::mem::take(&mut self.table.value);
        let [r, g, b] = Self::UNKNOWN;
        let missing = states.len().saturating_sub(table.len());
        table.extend(std::iter::repeat_n(
            [r, g, b, LabelState::Shown as u8],
            missing,
        ));
        for (label, entry) in table.iter_mut().enumerate() {
            let state = states
                .get(label)
                .copied()
                .map_or(LabelState::Shown, LabelState::from_number);
            entry[3] = state as u8;
        }
        self.table.set(table);
    }

    /// Sets the colour map of the scalars (r g b per step, from low to high).
    pub fn set_map(&mut self, colours: &[u8]) {
        let (colours, _) = colours.as_chunks::<3>();
        self.map
            .set(colours.iter().map(|&[r, g, b]| [r, g, b, 255]).collect());
    }

    /// Labels.
    pub fn labels(&self) -> &Revised<Arranged<u32, u32>> {
        &self.labels
    }

    /// The largest label.
    pub fn largest(&self) -> u32 {
        self.largest
    }

    /// Scalars.
    pub fn scalars(&self) -> &Revised<Arranged<f32, f32>> {
        &self.scalars
    }

    /// Colour and state of each label.
    pub fn table(&self) -> &Revised<Vec<[u8; 4]>> {
        &self.table
    }

    /// Steps of the colour map.
    pub fn map(&self) -> &Revised<Vec<[u8; 4]>> {
        &self.map
    }

    /// State of a label.
    pub fn state(&self, label: u32) -> LabelState {
        let entry = self.table.get().get(label as usize);
        entry.map_or(LabelState::Shown, |entry| LabelState::from_number(entry[3]))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn new_colours_keep_what_is_hidden() {
        let mut colouring = Colouring::default();
        colouring.set_colours(&[1, 2, 3, 4, 5, 6]);
        colouring.set_states(&[2, 0]);
        colouring.set_colours(&[9, 9, 9, 8, 8, 8, 7, 7, 7]);
        assert_eq!(
            colouring.table().get(),
            &[[9, 9, 9, 2], [8, 8, 8, 0], [7, 7, 7, 2]]
        );
        assert_eq!(colouring.state(1), LabelState::Hidden);
    }

    #[test]
    fn states_may_come_before_colours() {
        let mut colouring = Colouring::default();
        colouring.set_states(&[0, 3]);
        assert_eq!(colouring.state(0), LabelState::Hidden);
        assert_eq!(colouring.state(1), LabelState::Highlighted);
        assert_eq!(colouring.state(2), LabelState::Shown);
    }

    #[test]
    fn what_is_locked_is_drawn_and_lets_the_cursor_through() {
        let mut colouring = Colouring::default();
        colouring.set_states(&[2, 4]);
        assert_eq!(colouring.state(1), LabelState::Locked);
        assert!(!colouring.state(1).can_be_picked());
        assert!(colouring.state(0).can_be_picked());
    }

    #[test]
    fn points_are_drawn_once_they_have_what_gives_their_colour() {
        let mut cloud = Cloud::new(vec![0.0; 300]);
        let mut colouring = Colouring::default();
        colouring.set_scalars(vec![1.0; 100]);
        cloud.proceed(usize::MAX);
        colouring.proceed(&cloud, 60);
        colouring.set_labels(vec![1; 100]);
        colouring.proceed(&cloud, 40);
        assert_eq!(colouring.ready(), 40);
        assert!(!colouring.is_ready(&cloud));
        colouring.by = ColourBy::Scalar {
            low: 0.0,
            high: 1.0,
        };
        colouring.set_scalars(vec![1.0; 100]);
        assert_eq!(colouring.ready(), 0);
        colouring.proceed(&cloud, usize::MAX);
        assert_eq!((colouring.ready(), colouring.is_ready(&cloud)), (100, true));
    }

    #[test]
    fn every_change_is_counted() {
        let mut colouring = Colouring::default();
        let before = colouring.labels().revision();
        colouring.set_labels(vec![1, 2]);
        assert_eq!(colouring.labels().revision(), before + 1);
    }
}
