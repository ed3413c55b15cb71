//! The boundary of a part: which points of which faces remain when all solids have had their say.

mod curves;
mod edges;
mod face;
mod solid;

pub use edges::{EdgePoint, edge_points};
use face::{Chart, FaceFoot, Kind};
pub use face::{Domain, Face};
use solid::Placed;

use super::SampleError;
use super::blocks::{Operation, Part};
use crate::cloud::{Bounds, Point, Vector};

/// How near two things must be to be the same, all relative to the size of the part.
mod tolerance {
    /// A point lies on a carrier.
    pub const ON: f64 = 1e-10;
    /// A point that several carriers meet in lies on each, as well as Newton's method finds it.
    pub const MET: f64 = 1e-9;
    /// A step off a face, to see what is on either side of it.
    pub const OFF: f64 = 1e-9;
    /// A step within a face, to see whether it goes on there.
    pub const ASIDE: f64 = 1e-6;
}

/// The faces of all solids of a part, with what decides about their points.
#[derive(Debug, Clone)]
pub struct Boundary {
    /// Those that decide about points: no two are equal.
    pub solids: Vec<Placed>,
    pub faces: Vec<Face>,
    /// Number of different surfaces; each free-form face counts as one.
    pub carriers: usize,
    /// Diagonal of the part's bounding box, to a few thousandths.
    pub diagonal: f64,
}

impl Boundary {
    /// # Errors
    /// [`SampleError::InvalidPart`] if a solid has no sound description or nothing remains.
    pub fn new(part: &Part) -> Result<Self, SampleError> {
        let mut solids = Vec::new();
        for (index, feature) in part.features.iter().enumerate() {
            let placed = Placed::new(feature.operation, &feature.solid);
            let invalid = |reason| SampleError::InvalidPart {
                feature: index + 1,
                reason,
            };
            let placed = placed.map_err(invalid)?;
            // Equal solids hold the same points, about all of which the last has the say. Two faces of n
            // equal ones would meet n² times in one curve.
            let mut later = part.features.iter().skip(index + 1);
            if later.all(|other| other.solid != feature.solid) {
                solids.push(placed);
            }
        }
        let mut faces = Vec::new();
        for (index, placed) in solids.iter().enumerate() {
            let sides = (0..placed.segments.len()).map(Kind::Side);
            let caps = [Kind::Cap(0.0), Kind::Cap(placed.span())];
            let caps = caps.into_iter().filter(|_| !placed.is_closed());
            faces.extend(
                sides
                    .chain(caps)
                    .filter_map(|kind| Face::new(index, placed, kind)),
            );
        }
        let overall = faces.iter().fold(Bounds::EMPTY, |mut all, face| {
            all.add(&face.bounds.min);
            all.add(&face.bounds.max);
            all
        });
        let mut boundary = Self {
            solids,
            faces,
            carriers: 0,
            diagonal: overall.diagonal(),
        };
        boundary.find_neighbours();
        boundary.find_carriers();
        boundary.diagonal = boundary.extent().diagonal();
        if boundary.diagonal > 0.0 {
            Ok(boundary)
        } else {
            Err(SampleError::InvalidPart {
                feature: part.features.len(),
                reason: "nothing is left of the part",
            })
        }
    }

    fn find_neighbours(&mut self) {
        for face in &mut self.faces {
            let reaches = |&other: &usize| {
                other == face.solid || overlap(&self.solids[other].bounds, &face.bounds)
            };
            face.near = (0..self.solids.len()).filter(reaches).collect();
        }
    }

    fn find_carriers(&mut self) {
        let tolerance = tolerance::ON * self.diagonal;
        for index in 0..self.faces.len() {
            let same = |other: &&Face| match (&other.surface, &self.faces[index].surface) {
                (Some(a), Some(b)) => face::coincide(a, b, tolerance),
                _ => false,
            };
            let known = self.faces[..index]
                .iter()
                .find(same)
                .map(|face| face.carrier);
            self.faces[index].carrier = known.unwrap_or(self.carriers);
            self.carriers += usize::from(known.is_none());
        }
    }

    /// Box of what remains, from a grid on every face.
    fn extent(&self) -> Bounds {
        const STEPS: i32 = 64;
        let mut bounds = Bounds::EMPTY;
        for face in &self.faces {
            let Domain { low, high, .. } = face.domain(&self.solids[face.solid]);
            for (i, j) in (0..=STEPS).flat_map(|i| (0..=STEPS).map(move |j| (i, j))) {
                let at = |k: usize, step: i32| {
                    low[k] + (high[k] - low[k]) * f64::from(step) / f64::from(STEPS)
                };
                let chart = [at(0, i), at(1, j)];
                if self.remains(face, chart) {
                    bounds.add(&face.point(&self.solids[face.solid], chart));
                }
            }
        }
        bounds
    }

    /// Whether a point is in the part if it is in the face's own solid, or is not. Later features
    /// prevail over earlier ones.
    fn member(&self, face: &Face, point: &Point, own: bool) -> bool {
        face.near.iter().fold(false, |inside, &index| {
            let solid = &self.solids[index];
            let added = solid.operation == Operation::Add;
            // Only a solid that would change the verdict need be asked.
            if inside == added {
                return inside;
            }
            let contains = if index == face.solid {
                own
            } else {
                solid.contains(point)
            };
            if contains { added } else { inside }
        })
    }

    /// Whether the part's boundary holds the point of a face: it does where one side of the face
    /// is in the part and the other is not.
    pub fn remains(&self, face: &Face, chart: Chart) -> bool {
        let solid = &self.solids[face.solid];
        if !face.holds(solid, chart, tolerance::ON * self.diagonal) {
            return false;
        }
        if face.near.len() == 1 {
            return solid.operation == Operation::Add;
        }
        let point = face.point(solid, chart);
        let step = face.normal(solid, chart) * (tolerance::OFF * self.diagonal);
        self.member(face, &(point - step), true) != self.member(face, &(point + step), false)
    }

    /// The faces whose remaining points come arbitrarily near a point: it lies in the midst of one
    /// face, on the edge of two, or at a corner of more.
    pub fn faces_at(&self, point: &Point) -> Vec<usize> {
        let on = tolerance::ON * self.diagonal;
        let aside = tolerance::ASIDE * self.diagonal;
        let touches = |&index: &usize| {
            let face = &self.faces[index];
            if !face.bounds.contains(point) {
                return false;
            }
            let solid = &self.solids[face.solid];
            let foot = face.foot(solid, point);
            foot.offset.abs() < on && self.remains_near(face, foot.chart, aside)
        };
        (0..self.faces.len()).filter(touches).collect()
    }

    /// Whether a point lies on a carrier.
    fn is_on(&self, carrier: usize, point: &Point) -> bool {
        let mut faces = 0..self.faces.len();
        let face = faces.find(|&face| self.faces[face].carrier == carrier);
        let offset = face.map(|face| self.foot(face, point).offset);
        offset.is_some_and(|offset| offset.abs() <= tolerance::MET * self.diagonal)
    }

    /// Whether steps of some length, in two of many directions next to each other, from a point of
    /// a face's carrier meet what remains of the face. One alone may run along an edge, where the
    /// verdict on a point is worth nothing.
    pub fn remains_near(&self, face: &Face, chart: Chart, step: f64) -> bool {
        const DIRECTIONS: u32 = 32;
        let pace = face.pace(&self.solids[face.solid], chart[0]).max(step);
        let remains = |k: u32| {
            // No step runs along an axis, where edges are likely.
            let angle = (f64::from(k) + 0.31) * std::f64::consts::TAU / f64::from(DIRECTIONS);
            let (sin, cos) = libm::sincos(angle);
            self.remains(face, [chart[0] + step * cos, chart[1] + step * sin / pace])
        };
        let mut before = remains(DIRECTIONS - 1);
        (0..DIRECTIONS).any(|k| {
            let now = remains(k);
            std::mem::replace(&mut before, now) && now
        })
    }

    /// Moves a point near the carriers of up to three faces onto all of them, by Newton's method
    /// in the span of their normals.
    pub fn settle(&self, mut point: Point, faces: &[usize]) -> Point {
        for _ in 0..12 {
            let feet: Vec<FaceFoot> = faces.iter().map(|&f| self.foot(f, &point)).collect();
            let step = match feet.as_slice() {
                [a] => a.gradient * a.offset,
                [a, b] => meet(a, b),
                [a, b, c, ..] => {
                    let across = b.gradient.cross(&c.gradient);
                    let volume = a.gradient.dot(&across);
                    let sum = across * a.offset
                        + c.gradient.cross(&a.gradient) * b.offset
                        + a.gradient.cross(&b.gradient) * c.offset;
                    sum / volume
                }
                [] => Vector::zeros(),
            };
            if !step.norm().is_finite() {
                break;
            }
            point -= step;
            if step.norm() < 1e-16 * self.diagonal {
                break;
            }
        }
        point
    }

    pub fn foot(&self, face: usize, point: &Point) -> FaceFoot {
        let face = &self.faces[face];
        face.foot(&self.solids[face.solid], point)
    }
}

/// The shortest step that takes up both offsets.
fn meet(a: &FaceFoot, b: &FaceFoot) -> Vector {
    let cos = a.gradient.dot(&b.gradient);
    let square = 1.0 - cos * cos;
    if square < 1e-12 {
        return (a.gradient * a.offset + b.gradient * b.offset) / 2.0;
    }
    (a.gradient * (a.offset - b.offset * cos) + b.gradient * (b.offset - a.offset * cos)) / square
}

fn overlap(a: &Bounds, b: &Bounds) -> bool {
    (0..3).all(|k| a.min[k] <= b.max[k] && b.min[k] <= a.max[k])
}
