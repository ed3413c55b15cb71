//! How the canvas is divided among the two views. Rectangles are in pixels, y up, as in WebGL.

use tsify::Tsify;

/// One of the two things compared: by custom 0 the truth and 1 the prediction.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Tsify)]
#[tsify(type = "0 | 1")]
pub enum Side {
    /// Truth, by custom.
    #[default]
    First,
    /// Prediction, by custom.
    Second,
}

impl Side {
    /// Both.
    pub const BOTH: [Self; 2] = [Self::First, Self::Second];

    /// 0 or 1.
    pub fn index(self) -> usize {
        self as usize
    }

    /// The side of that number; everything but 0 is the second.
    pub fn from_index(index: usize) -> Self {
        if index == 0 {
            Self::First
        } else {
            Self::Second
        }
    }
}

/// How the views share the canvas.
#[derive(Debug, Clone, Copy, PartialEq, Default, Tsify)]
#[serde(tag = "kind", rename_all = "lowercase")]
pub enum Layout {
    /// One view alone.
    Single {
        /// What it shows.
        side: Side,
    },
    /// Side by side; one above the other where the canvas is taller than wide.
    #[default]
    Split,
    /// Both in the same place: the first to the left of a movable border, the second to its right.
    Wipe {
        /// The border's position, 0 left to 1 right.
        at: f32,
    },
}

/// A rectangle of pixels.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Rect {
    /// Left border.
    pub x: i32,
    /// Lower border.
    pub y: i32,
    /// Width, not negative.
    pub width: i32,
    /// Height, not negative.
    pub height: i32,
}

impl Rect {
    /// A rectangle.
    pub fn new(x: i32, y: i32, width: i32, height: i32) -> Self {
        Self {
            x,
            y,
            width: width.max(0),
            height: height.max(0),
        }
    }

    /// Whether a position lies in it.
    pub fn contains(&self, x: f32, y: f32) -> bool {
        let (x, y) = (x - self.x as f32, y - self.y as f32);
        x >= 0.0 && y >= 0.0 && x < self.width as f32 && y < self.height as f32
    }

    /// What two rectangles share.
    pub fn intersection(&self, other: &Self) -> Self {
        let (x, y) = (self.x.max(other.x), self.y.max(other.y));
        let right = (self.x + self.width).min(other.x + other.width);
        let top = (self.y + self.height).min(other.y + other.height);
        Self::new(x, y, right - x, top - y)
    }

    /// The same rectangle seen from another origin.
    pub fn relative_to(&self, x: i32, y: i32) -> Self {
        Self {
            x: self.x - x,
            y: self.y - y,
            ..*self
        }
    }

    /// Width divided by height.
    pub fn aspect(&self) -> f32 {
        self.width.max(1) as f32 / self.height.max(1) as f32
    }
}

/// A part of the canvas that shows one side.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Pane {
    /// What it shows.
    pub side: Side,
    /// Where the camera's picture lies.
    pub viewport: Rect,
    /// Which part of the picture is visible.
    pub visible: Rect,
}

/// The panes of a canvas, first side first.
#[derive(Debug, Clone, Copy)]
pub struct Panes {
    panes: [Pane; 2],
    count: usize,
}

impl Panes {
    /// Divides a canvas of the given size.
    pub fn new(layout: Layout, width: i32, height: i32) -> Self {
        let whole = Rect::new(0, 0, width, height);
        let pane = |side, viewport, visible| Pane {
            side,
            viewport,
            visible,
        };
        let [first, second] = Side::BOTH;
        match layout {
            Layout::Single { side } => Self {
                panes: [pane(side, whole, whole); 2],
                count: 1,
            },
            Layout::Split => {
                let (one, other) = if width >= height {
                    let half = width / 2;
                    (
                        Rect::new(0, 0, half, height),
                        Rect::new(half, 0, width - half, height),
                    )
                } else {
                    let half = height / 2;
                    (
                        Rect::new(0, half, width, height - half),
                        Rect::new(0, 0, width, half),
                    )
                };
                Self {
                    panes: [pane(first, one, one), pane(second, other, other)],
                    count: 2,
                }
            }
            Layout::Wipe { at } => {
                let border = (at.clamp(0.0, 1.0) * width as f32).round() as i32;
                let left = Rect::new(0, 0, border, height);
                let right = Rect::new(border, 0, width - border, height);
                Self {
                    panes: [pane(first, whole, left), pane(second, whole, right)],
                    count: 2,
                }
            }
        }
    }

    /// The panes.
    pub fn iter(&self) -> impl Iterator<Item = &Pane> {
        self.panes.iter().take(self.count)
    }

    /// The pane at a position, if any.
    pub fn at(&self, x: f32, y: f32) -> Option<&Pane> {
        self.iter().find(|pane| pane.visible.contains(x, y))
    }

    /// The pane that shows a side, if any.
    pub fn of(&self, side: Side) -> Option<&Pane> {
        self.iter().find(|pane| pane.side == side)
    }

    /// The narrowest aspect of the viewports: what a framed box must fit.
    pub fn aspect(&self) -> f32 {
        self.iter()
            .map(|pane| pane.viewport.aspect())
            .fold(f32::INFINITY, f32::min)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_wide_canvas_is_split_left_and_right() {
        let panes = Panes::new(Layout::Split, 101, 60);
        assert_eq!(
            panes.of(Side::First).unwrap().visible,
            Rect::new(0, 0, 50, 60)
        );
        assert_eq!(
            panes.of(Side::Second).unwrap().visible,
            Rect::new(50, 0, 51, 60)
        );
    }

    #[test]
    fn on_a_tall_canvas_the_first_side_is_on_top() {
        let panes = Panes::new(Layout::Split, 60, 100);
        assert_eq!(
            panes.of(Side::First).unwrap().visible,
            Rect::new(0, 50, 60, 50)
        );
        assert_eq!(panes.at(30.0, 10.0).unwrap().side, Side::Second);
    }

    #[test]
    fn a_wipe_shows_both_sides_through_one_viewport() {
        let panes = Panes::new(Layout::Wipe { at: 0.25 }, 200, 100);
        let (first, second) = (
            panes.of(Side::First).unwrap(),
            panes.of(Side::Second).unwrap(),
        );
        assert_eq!(first.viewport, second.viewport);
        assert_eq!(panes.at(49.0, 50.0).unwrap().side, Side::First);
        assert_eq!(panes.at(50.0, 50.0).unwrap().side, Side::Second);
    }

    #[test]
    fn a_wipe_may_lie_beyond_either_end() {
        assert_eq!(
            Panes::new(Layout::Wipe { at: -1.0 }, 10, 10)
                .at(0.0, 0.0)
                .unwrap()
                .side,
            Side::Second
        );
        assert_eq!(
            Panes::new(Layout::Wipe { at: 9.0 }, 10, 10)
                .at(9.5, 0.0)
                .unwrap()
                .side,
            Side::First
        );
        let nowhere = Panes::new(Layout::Wipe { at: f32::NAN }, 10, 10);
        assert_eq!(nowhere.at(0.0, 5.0).unwrap().side, Side::Second);
    }

    #[test]
    fn nothing_is_outside_the_canvas() {
        let panes = Panes::new(Layout::Single { side: Side::Second }, 10, 10);
        assert!(panes.at(-0.5, 5.0).is_none() && panes.at(5.0, 10.0).is_none());
        assert!(panes.of(Side::First).is_none());
    }

    #[test]
    fn rectangles_that_do_not_meet_share_nothing() {
        let shared = Rect::new(0, 0, 5, 5).intersection(&Rect::new(7, 2, 5, 5));
        assert_eq!((shared.width, shared.height), (0, 3));
    }
}
