//! What of a part is seen from viewpoints around it.
//!
//! A place is seen from a viewpoint where no face lies between the two. Faces of the five families are met by
//! rays in closed form, free-form ones as flat pieces; either way what is met is asked whether it lies within
//! the bounds of its face, so holes are looked through. Which faces may be met at all is known by the boxes
//! about them, as the viewpoint sees them.

mod bins;
mod face;
mod ray;
mod roots;

use std::collections::BTreeMap;
use std::f64::consts::{PI, TAU};

use fit4cad::cloud::{Bounds, Point, Vector};
use fit4cad::random::Random;

use crate::face::Trimmed;
use crate::placement::{Frame, Motion};
use crate::sampling::{Patch, Points, Wheel};
use bins::Bins;
use face::Screen;
use ray::Ray;

/// How far viewpoints stand from the middle of the part, over its diagonal: near enough that what is in front
/// hides more than itself, as it does to scanners.
const AWAY: f64 = 2.0;
/// Faces nearer to a place than this, over the diagonal, do not hide it: edges are as exact.
const CLEAR: f64 = 1e-6;
/// Places looked at to tell how much is seen: to within one in a hundred.
const LOOKS: usize = 2000;
/// Places of one face looked at to tell whether it is seen.
const LOOKS_AT_FACE: usize = 64;
/// Places drawn for each point that was found, until it is given up that so many are seen as were asked for.
const MOST_DRAWS: usize = 1000;
/// So many points are hoped for before the first is found.
const HOPED: usize = 200;

/// A part before viewpoints.
pub(crate) struct Sight<'a> {
    patches: &'a [Patch<'a>],
    wheel: Wheel,
    screens: Vec<Screen<'a>>,
    /// For each patch its screen, and the motion back to it.
    own: Vec<(usize, Motion)>,
    views: Vec<View>,
    /// How near a viewpoint may be to any place.
    nearest: f64,
    clear: f64,
}

/// A viewpoint.
struct View {
    eye: Point,
    bins: Bins,
}

impl<'a> Sight<'a> {
    /// Looks at patches from `views` viewpoints that stand evenly about them, turned at random.
    /// O(faces · views).
    pub fn new(patches: &'a [Patch<'a>], views: usize, random: &mut Random) -> Self {
        let mut known: BTreeMap<*const Trimmed, usize> = BTreeMap::new();
        let mut screens = Vec::new();
        let mut own = Vec::with_capacity(patches.len());
        let mut boxes = Vec::with_capacity(patches.len());
        for patch in patches {
            // Instances of a body share its faces.
            let screen = *known
                .entry(std::ptr::from_ref(patch.face))
                .or_insert_with(|| {
                    screens.push(Screen::new(patch.face));
                    screens.len() - 1
                });
            boxes.push(corners(&screens[screen].bounds).map(|it| patch.motion.point(&it)));
            own.push((screen, patch.motion.inverse()));
        }
        let bounds = Bounds::of(boxes.iter().flatten());
        let (middle, diagonal) = (bounds.centre(), bounds.diagonal());
        let views = directions(views, random).into_iter().map(|direction| {
            let eye = middle + direction * (AWAY * diagonal);
            View {
                eye,
                bins: Bins::new(eye, middle, 0.5 * diagonal, &boxes),
            }
        });
        Self {
            patches,
            wheel: Wheel::new(&patches.iter().map(Patch::area).collect::<Vec<_>>()),
            screens,
            own,
            views: views.collect(),
            nearest: (AWAY - 0.5) * diagonal,
            clear: CLEAR * diagonal,
        }
    }

    /// Whether a place of a patch is seen from a viewpoint.
    fn sees(&self, view: &View, patch: usize, place: &Point) -> bool {
        let clear = self.clear / (view.eye - place).norm();
        view.bins.towards(place).iter().all(|&other| {
            let (screen, back) = &self.own[other as usize];
            let from = back.point(place);
            let ray = Ray {
                from,
                way: back.point(&view.eye) - from,
            };
            !self.screens[*screen].hides(&ray, clear, other as usize == patch)
        })
    }

    /// How much of the area is seen from any viewpoint, of 1.
    pub fn share(&self, random: &mut Random) -> f64 {
        let mut seen = 0;
        let mut drawn = 0;
        for _ in 0..LOOKS {
            let patch = self.wheel.draw(random);
            if let Some((_, place)) = self.patches[patch].place(random) {
                drawn += 1;
                let any = self.views.iter().any(|view| self.sees(view, patch, &place));
                seen += usize::from(any);
            }
        }
        seen as f64 / drawn.max(1) as f64
    }

    /// For each patch whether no viewpoint sees any of some places of it, so that what is seen of less than a
    /// few hundredths of it counts as nothing.
    pub fn hidden(&self, random: &mut Random) -> Vec<bool> {
        let patches = self.patches.iter().enumerate();
        let hidden = patches.map(|(index, patch)| {
            let mut places = (0..LOOKS_AT_FACE).filter_map(|_| Some(patch.place(random)?.1));
            !places.any(|place| self.views.iter().any(|view| self.sees(view, index, &place)))
        });
        hidden.collect()
    }

    /// Up to `count` places as a scanner takes them that turns at even steps: of each viewpoint as many, and
    /// from each every direction as likely, so that faces seen aslant or from afar have fewer. `progress` hears
    /// what share of them is there. Expected O(count · faces in the way) for each draw that is not hidden.
    pub fn scan(&self, count: usize, random: &mut Random, progress: &mut dyn FnMut(f64)) -> Points {
        let mut points = Points::with_capacity(count);
        let mut draws = 0;
        while points.len() < count && draws < MOST_DRAWS * (points.len() + HOPED) {
            if draws % 4096 == 0 {
                progress(points.len() as f64 / count as f64);
            }
            draws += 1;
            let patch = self.wheel.draw(random);
            let view = &self.views[random.below(self.views.len())];
            let Some((at, place)) = self.patches[patch].place(random) else {
                continue;
            };
            let way = view.eye - place;
            // Directions that an area takes up: less aslant, and by the square of the distance.
            let aslant = self.patches[patch].normal(at).dot(&way.normalize()).abs();
            let taken = aslant * self.nearest * self.nearest / way.norm_squared();
            if random.unit() < taken && self.sees(view, patch, &place) {
                points.push((patch as u32, place));
            }
        }
        points.sort_by_key(|(patch, _)| *patch);
        points
    }
}

/// Directions that stand evenly about a point, on a spiral from pole to pole whose turns are the golden angle
/// apart (Vogel 1979, on the sphere), turned at random.
fn directions(count: usize, random: &mut Random) -> Vec<Vector> {
    let golden = PI * (3.0 - 5f64.sqrt());
    let draw = |random: &mut Random| Vector::new(random.normal(), random.normal(), random.normal());
    let (axis, across) = (draw(random), draw(random));
    let Some(frame) = Frame::new(Point::origin(), axis, Some(across)) else {
        return vec![Vector::z(); count];
    };
    let turn = TAU * random.unit();
    (0..count)
        .map(|k| {
            let z = 1.0 - (2 * k + 1) as f64 / count as f64;
            let radius = (1.0 - z * z).max(0.0).sqrt();
            let (sin, cos) = libm::sincos(turn + golden * k as f64);
            frame.vector([radius * cos, radius * sin, z])
        })
        .collect()
}

fn corners(bounds: &Bounds) -> [Point; 8] {
    std::array::from_fn(|corner| {
        let of = |axis: usize| {
            let end = [&bounds.min, &bounds.max][(corner >> axis) & 1];
            end[axis]
        };
        Point::new(of(0), of(1), of(2))
    })
}
