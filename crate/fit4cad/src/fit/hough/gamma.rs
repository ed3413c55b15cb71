//! Γ_P, the Hough transform of one point: the parameters of all surfaces through it.
//!
//! A point alone lights a hypersurface of cells (paper, section "HT: Simple primitive fitting based
//! on Hough transform", figure "The HT-based paradigm"). This is the transform as it is taught: two
//! parameters of a family are free, the others stay at those of a base surface, and every point
//! votes for each cell its curve passes through. The fitter itself votes with small neighbourhoods
//! (see [`vote`](super::vote)), whose curves have already been intersected.

use super::grid::{Axis, Grid};
use super::persistence::{self, Diagram};
use super::space::Space;
use crate::cloud::{self, Direction, Point, Vector};
use crate::fit::axes::direction_of;
use crate::surface::{Cone, Cylinder, Plane, Sphere, Surface, SurfaceType, Torus, across};

/// A parameter of a family, measured as a departure from a base surface or as its own value.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Coordinate {
    /// Move across the axis (for a sphere along x), in the units of the cloud.
    Across,
    /// Move across the axis and across [`Across`](Self::Across) (for a sphere along y).
    Beside,
    /// Move along the axis; a plane's offset, a cone's apex height (for a sphere along z).
    Along,
    /// Turn of axis and position about the pivot and [`Across`](Self::Across), in radians.
    Turn,
    /// Value of the radius, half-angle or major radius.
    Size,
    /// Value of a torus's minor radius.
    MinorRadius,
}

/// A slice through a family's parameter space: two free parameters, cut into cells.
#[derive(Debug, Clone, PartialEq)]
pub struct Slice {
    base: Surface,
    pivot: Point,
    /// Across, beside and along the base's axis.
    frame: [Direction; 3],
    free: [Coordinate; 2],
    grid: Grid,
}

impl Slice {
    /// The slice through `base` with these two free parameters, each over its axis. Turns are about
    /// `pivot`; the middle of the cloud keeps a plane's curves within a bounded range of offsets.
    pub fn new(base: Surface, pivot: Point, free: [Coordinate; 2], axes: [Axis; 2]) -> Self {
        let frame = match direction_of(&base) {
            Some(along) => {
                let first = across(&along);
                [first, Direction::new_normalize(along.cross(&first)), along]
            }
            None => [Vector::x_axis(), Vector::y_axis(), Vector::z_axis()],
        };
        Self {
            base,
            pivot,
            frame,
            free,
            grid: Grid::new(axes.to_vec()),
        }
    }

    /// The two parameters that say most about a family once the others are known: for a plane the
    /// turn of its normal and its offset, whose curves are the sinusoids of the classical transform
    /// for lines; for a cylinder its centre in the plane across its axis; for a cone apex height and
    /// half-angle; for a sphere its centre in x and y; for a torus both radii.
    pub const fn telling(kind: SurfaceType) -> [Coordinate; 2] {
        match kind {
            SurfaceType::Plane => [Coordinate::Turn, Coordinate::Along],
            SurfaceType::Cylinder | SurfaceType::Sphere => [Coordinate::Across, Coordinate::Beside],
            SurfaceType::Cone => [Coordinate::Along, Coordinate::Size],
            SurfaceType::Torus => [Coordinate::Size, Coordinate::MinorRadius],
        }
    }

    /// The cells.
    pub fn grid(&self) -> &Grid {
        &self.grid
    }

    /// The surface in the middle of a cell.
    pub fn surface(&self, cell: usize) -> Surface {
        let centre = self.grid.parameters(cell);
        match centre.as_slice() {
            &[first, second] => self.surface_at([first, second]),
            _ => self.base,
        }
    }

    /// The surface with these values of the free parameters. Moves are along the turned frame, so a
    /// plane's offset is along its own normal whichever way that points.
    pub fn surface_at(&self, values: [f64; 2]) -> Surface {
        let value_of = |coordinate: Coordinate| {
            let place = self.free.iter().position(|&free| free == coordinate);
            place.map(|place| values[place])
        };
        let move_by = |coordinate| value_of(coordinate).unwrap_or(0.0);
        let turn = cloud::turn(&self.frame[0], move_by(Coordinate::Turn));
        let [across, beside, along] = self.frame.map(Direction::into_inner);
        let shift = across * move_by(Coordinate::Across)
            + beside * move_by(Coordinate::Beside)
            + along * move_by(Coordinate::Along);
        let place = |point: Point| self.pivot + turn * (point - self.pivot + shift);
        let size = |old: f64| value_of(Coordinate::Size).unwrap_or(old);
        match self.base {
            Surface::Plane(Plane { normal, .. }) => {
                let foot = self.base.foot(&self.pivot);
                Surface::Plane(Plane::new(place(foot), turn * normal.into_inner()))
            }
            Surface::Cylinder(Cylinder {
                centre,
                axis,
                radius,
            }) => Surface::Cylinder(Cylinder::new(
                place(centre),
                turn * axis.into_inner(),
                size(radius),
            )),
            Surface::Cone(Cone {
                apex,
                axis,
                half_angle,
            }) => Surface::Cone(Cone::new(
                place(apex),
                turn * axis.into_inner(),
                size(half_angle),
            )),
            Surface::Sphere(Sphere { centre, radius }) => {
                Surface::Sphere(Sphere::new(place(centre), size(radius)))
            }
            Surface::Torus(Torus {
                centre,
                axis,
                major_radius,
                minor_radius,
            }) => {
                let minor = value_of(Coordinate::MinorRadius).unwrap_or(minor_radius);
                let axis = turn * axis.into_inner();
                Surface::Torus(Torus::new(place(centre), axis, size(major_radius), minor))
            }
        }
    }

    /// Calls `visit` for every cell that Γ_P meets: those at whose corners the signed distance of
    /// the point has both signs. A curve that enters and leaves through one side of a cell is
    /// missed, a branch thinner than a cell too. Tori
    /// whose minor radius exceeds the major have no inner side and should be outside the slice.
    /// O(cells).
    pub fn light(&self, point: &Point, mut visit: impl FnMut(usize)) {
        let [rows, columns] = self.size();
        let [first, second] = [self.grid.axes()[0], self.grid.axes()[1]];
        let corner = |axis: &Axis, index: usize| axis.start() + axis.step() * index as f64;
        let row_of = |row: usize| -> Vec<f64> {
            (0..=columns)
                .map(|column| {
                    let values = [corner(&first, row), corner(&second, column)];
                    self.side(values, point)
                })
                .collect()
        };
        let mut above = row_of(0);
        for row in 0..rows {
            let below = row_of(row + 1);
            for column in 0..columns {
                let corners = [
                    above[column],
                    above[column + 1],
                    below[column],
                    below[column + 1],
                ];
                let low = corners.iter().copied().fold(f64::INFINITY, f64::min);
                let high = corners.iter().copied().fold(f64::NEG_INFINITY, f64::max);
                if low <= 0.0 && high >= 0.0 {
                    visit(row * columns + column);
                }
            }
            above = below;
        }
    }

    /// Signed distance of a point to the surface with these values. A plane's sign is that of the
    /// turned normal: its canonical normal jumps to the other side somewhere in every half turn.
    fn side(&self, values: [f64; 2], point: &Point) -> f64 {
        let surface = self.surface_at(values);
        let distance = surface.signed_distance(point);
        let (Surface::Plane(plane), Surface::Plane(base)) = (&surface, &self.base) else {
            return distance;
        };
        let place = self.free.iter().position(|&free| free == Coordinate::Turn);
        let angle = place.map_or(0.0, |place| values[place]);
        let turn = cloud::turn(&self.frame[0], angle);
        distance
            * plane
                .normal
                .dot(&(turn * base.normal.into_inner()))
                .signum()
    }

    /// 𝓗 over the slice: how many of the points' curves meet each cell. O(points · cells).
    pub fn count<'a>(&self, points: impl IntoIterator<Item = &'a Point>) -> Vec<f64> {
        let mut heights = vec![0.0; self.grid.len()];
        for point in points {
            self.light(point, |cell| heights[cell] += 1.0);
        }
        heights
    }

    /// Positions of the points whose curve meets a cell: who voted for it.
    pub fn voters<'a>(&self, cell: usize, points: impl IntoIterator<Item = &'a Point>) -> Vec<u32> {
        (0_u32..)
            .zip(points)
            .filter(|(_, point)| {
                let mut met = false;
                self.light(point, |lit| met |= lit == cell);
                met
            })
            .map(|(position, _)| position)
            .collect()
    }

    /// The persistence diagram of heights over the slice; a peak's position is its cell.
    pub fn diagram(&self, heights: &[f64]) -> Diagram {
        persistence::diagram(heights, |cell, visit| self.grid.neighbours(cell, visit))
    }

    fn size(&self) -> [usize; 2] {
        match self.grid.axes() {
            [first, second] => [first.count(), second.count()],
            _ => [0, 0],
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn axes(range: f64, count: f64) -> [Axis; 2] {
        [Axis::new(-range, range, 2.0 * range / count); 2]
    }

    #[test]
    fn a_points_curve_on_the_centre_of_a_cylinder_is_a_circle_about_the_point() {
        let base = Surface::Cylinder(Cylinder::new(Point::origin(), Vector::z(), 0.5));
        let free = Slice::telling(SurfaceType::Cylinder);
        let slice = Slice::new(base, Point::origin(), free, axes(1.0, 40.0));
        let point = Point::new(0.2, -0.1, 7.0);
        let mut count = 0;
        slice.light(&point, |cell| {
            count += 1;
            assert!(slice.surface(cell).distance(&point) < 0.05);
        });
        // A circle of radius r meets about 8 r / step cells.
        assert!((70..=90).contains(&count), "{count} cells");
    }

    #[test]
    fn a_points_curve_on_turn_and_offset_of_a_plane_is_a_sinusoid() {
        let base = Surface::Plane(Plane::new(Point::origin(), Vector::z()));
        let free = Slice::telling(SurfaceType::Plane);
        let half_turn = Axis::new(0.0, std::f64::consts::PI, 0.05);
        let slice = Slice::new(
            base,
            Point::origin(),
            free,
            [half_turn, Axis::new(-1.0, 1.0, 0.05)],
        );
        let point = Point::new(0.3, 0.5, 0.4);
        let mut rows = vec![false; half_turn.count()];
        slice.light(&point, |cell| {
            rows[slice.grid().place(cell)[0]] = true;
            assert!(slice.surface(cell).distance(&point) < 0.06);
        });
        assert!(
            rows.into_iter().all(|lit| lit),
            "every direction has one plane through a point"
        );
    }

    #[test]
    fn the_curves_of_a_surfaces_points_meet_in_its_own_cell() {
        let truth = Cylinder::new(Point::new(0.31, -0.22, 0.0), Vector::z(), 0.5);
        let points: Vec<Point> = (0..30)
            .map(|i| {
                let angle = f64::from(i) * 0.2;
                Point::new(angle.cos(), angle.sin(), f64::from(i)) * 0.5 + truth.centre.coords
            })
            .collect();
        let base = Surface::Cylinder(Cylinder::new(Point::origin(), Vector::z(), 0.5));
        let free = Slice::telling(SurfaceType::Cylinder);
        let slice = Slice::new(base, Point::origin(), free, axes(1.0, 40.0));
        let heights = slice.count(&points);
        let diagram = slice.diagram(&heights);
        let peak = diagram.peaks[0];
        assert!(peak.birth >= 28.0);
        assert!(diagram.significant(0.5).count() < 4);
        let Surface::Cylinder(found) = slice.surface(peak.position) else {
            unreachable!()
        };
        assert!((found.centre - truth.centre).norm() < 0.08);
        let voters = slice.voters(peak.position, &points);
        assert_eq!(voters.len() as f64, peak.birth);
    }

    #[test]
    fn every_family_has_a_telling_slice_whose_lit_cells_are_surfaces_through_the_point() {
        let point = Point::new(0.4, 0.3, 0.6);
        let o = Point::origin();
        let steps = |start, end| Axis::new(start, end, 0.02);
        let moves = [steps(-1.0, 1.0); 2];
        for (base, range) in [
            (
                Surface::Cone(Cone::new(o, Vector::z(), 0.5)),
                [steps(-1.0, 0.0), steps(0.1, 1.2)],
            ),
            (Surface::Sphere(Sphere::new(o, 0.8)), moves),
            (
                Surface::Torus(Torus::new(o, Vector::z(), 0.8, 0.5)),
                [steps(0.8, 1.2), steps(0.02, 0.78)],
            ),
        ] {
            let slice = Slice::new(base, o, Slice::telling(base.kind()), range);
            let mut count = 0;
            slice.light(&point, |cell| {
                count += 1;
                assert!(slice.surface(cell).distance(&point) < 0.03);
            });
            assert!(count > 10, "{base:?} lights {count}");
        }
    }
}
