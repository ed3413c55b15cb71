//! Directions without a sign, discretised: the first axis of every parameter space but the sphere's.
//!
//! A plane's normal and an axis of revolution are points of the Gauss sphere with antipodes
//! identified. The space is the cubed sphere (Ronchi, Iacono and Paolucci, 1996) cut in half: three
//! faces x, y, z of a cube, each an equiangular grid with an odd number of cells along an edge, so
//! that the directions CAD objects use most, ±x, ±y and ±z, are cell centres and not cell corners.

use super::space::Space;
use crate::cloud::{Direction, Vector};

/// The half Gauss sphere cut into cells of nearly equal size.
///
/// Cell `(face·edge + row)·edge + column` belongs to the face of the dominant component; rows and
/// columns count the equiangular coordinates atan(v/w)·4/π of the two other components, cyclic in
/// x → y → z. Takes 750 bytes per cell along an edge: inside a face the neighbours follow from the
/// numbers of the cells, and a list of them all would outweigh a small cloud and its neighbours.
#[derive(Debug, Clone, PartialEq)]
pub struct DirectionSpace {
    edge: usize,
    /// Each cell on the rim of a face with each of its neighbours, ascending.
    rim: Vec<(u32, u32)>,
}

impl DirectionSpace {
    /// Cells of about `step` radians. The step is kept between 0.2° and 30°, so that there are
    /// never more than 610,000 cells. O(r log r) for r cells on the rims.
    pub fn new(step: f64) -> Self {
        let step = if step.is_finite() { step } else { 0.0 };
        let step = step.clamp(0.2_f64.to_radians(), 30_f64.to_radians());
        let edge = (std::f64::consts::FRAC_PI_2 / step).round() as usize | 1;
        let mut space = Self {
            edge,
            rim: Vec::new(),
        };
        space.rim = space.linked_rim();
        space
    }

    /// Mean angle between the centres of adjacent cells along the middle of a face, in radians.
    pub fn step(&self) -> f64 {
        std::f64::consts::FRAC_PI_2 / self.edge as f64
    }

    /// The cell of a direction of any length and sign; `None` for a vector that has no direction.
    pub fn cell(&self, direction: &Vector) -> Option<usize> {
        let face = direction.iamax();
        let dominant = direction[face];
        if !dominant.is_finite() || dominant == 0.0 {
            return None;
        }
        let index = |component: f64| {
            let angular = libm::atan(component / dominant) * std::f64::consts::FRAC_2_PI * 2.0;
            let place = (angular + 1.0) * 0.5 * self.edge as f64;
            (place.max(0.0) as usize).min(self.edge - 1)
        };
        let row = index(direction[(face + 1) % 3]);
        let column = index(direction[(face + 2) % 3]);
        Some((face * self.edge + row) * self.edge + column)
    }

    /// The direction in the middle of a cell, its dominant component positive.
    pub fn direction_of(&self, cell: usize) -> Direction {
        let (face, row, column) = self.place(cell);
        self.direction(face, row as f64 + 0.5, column as f64 + 0.5)
    }

    /// Calls `visit` for every cell that the great circle across `normal` meets, in ascending
    /// order and each once: the axes of the cylinders with that normal. O(cells).
    pub fn great_circle(&self, normal: &Direction, visit: impl FnMut(usize)) {
        self.small_circle(normal, std::f64::consts::FRAC_PI_2, visit);
    }

    /// Calls `visit` for every cell whose centre is within half a cell of the small circle at
    /// `angle` radians from ±`pole`, ascending and each once. O(cells).
    pub fn small_circle(&self, pole: &Direction, angle: f64, mut visit: impl FnMut(usize)) {
        let angle = angle.min(std::f64::consts::PI - angle);
        for cell in 0..self.len() {
            let cosine = self.direction_of(cell).dot(pole).abs().min(1.0);
            if (libm::acos(cosine) - angle).abs() <= 0.5 * self.step() {
                visit(cell);
            }
        }
    }

    fn place(&self, cell: usize) -> (usize, usize, usize) {
        let (rest, column) = (cell / self.edge, cell % self.edge);
        ((rest / self.edge).min(2), rest % self.edge, column)
    }

    /// The direction at fractional row and column of a face; beyond the face's edge it lies on
    /// another face.
    fn direction(&self, face: usize, row: f64, column: f64) -> Direction {
        let slope = |place: f64| {
            libm::tan((2.0 * place / self.edge as f64 - 1.0) * std::f64::consts::FRAC_PI_4)
        };
        let mut vector = Vector::zeros();
        vector[face] = 1.0;
        vector[(face + 1) % 3] = slope(row);
        vector[(face + 2) % 3] = slope(column);
        Direction::new_normalize(vector)
    }

    /// Whether a cell has all eight neighbours on its own face.
    fn is_inside(&self, cell: usize) -> bool {
        let (_, row, column) = self.place(cell);
        let inside = 1..self.edge - 1;
        inside.contains(&row) && inside.contains(&column)
    }

    /// The cells on the rims of the faces with their neighbours: the eight around a cell, and across
    /// an edge of the face those that hold the places where the eight would be. Made symmetric, which
    /// concerns rims alone: half a cell beyond an edge of one face is the rim of another.
    fn linked_rim(&self) -> Vec<(u32, u32)> {
        let rim = || (0..self.len()).filter(|&cell| !self.is_inside(cell));
        let mut pairs = Vec::with_capacity(2 * AROUND.len() * rim().count());
        for cell in rim() {
            let (face, row, column) = self.place(cell);
            for (down, right) in AROUND {
                let (r, c) = (row as f64 + 0.5 + down, column as f64 + 0.5 + right);
                let Some(other) = self.cell(&self.direction(face, r, c)) else {
                    continue;
                };
                if other == cell {
                    continue;
                }
                pairs.push((cell as u32, other as u32));
                if !self.is_inside(other) {
                    pairs.push((other as u32, cell as u32));
                }
            }
        }
        pairs.sort_unstable();
        pairs.dedup();
        pairs.shrink_to_fit();
        pairs
    }
}

/// Steps to the eight cells around a cell.
const AROUND: [(f64, f64); 8] = [
    (-1.0, -1.0),
    (-1.0, 0.0),
    (-1.0, 1.0),
    (0.0, -1.0),
    (0.0, 1.0),
    (1.0, -1.0),
    (1.0, 0.0),
    (1.0, 1.0),
];

impl Space for DirectionSpace {
    fn len(&self) -> usize {
        3 * self.edge * self.edge
    }

    fn centre(&self, cell: usize) -> [f64; 3] {
        self.direction_of(cell).into_inner().into()
    }

    fn neighbours(&self, cell: usize, visit: &mut dyn FnMut(usize)) {
        if self.is_inside(cell) {
            for row in [cell - self.edge, cell, cell + self.edge] {
                for other in row - 1..=row + 1 {
                    if other != cell {
                        visit(other);
                    }
                }
            }
            return;
        }
        let first = self.rim.partition_point(|&(of, _)| (of as usize) < cell);
        for &(of, other) in &self.rim[first..] {
            if of as usize != cell {
                return;
            }
            visit(other as usize);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_cell_holds_its_own_centre() {
        let space = DirectionSpace::new(3_f64.to_radians());
        for cell in 0..space.len() {
            assert_eq!(space.cell(&space.direction_of(cell)), Some(cell));
        }
    }

    #[test]
    fn opposite_directions_share_a_cell() {
        let space = DirectionSpace::new(2_f64.to_radians());
        for vector in [
            Vector::new(1.0, 0.2, -0.4),
            Vector::new(-0.3, 5.0, 2.0),
            Vector::new(0.1, 0.2, -0.9),
        ] {
            assert_eq!(space.cell(&vector), space.cell(&-vector));
        }
    }

    #[test]
    fn coordinate_axes_are_cell_centres() {
        let space = DirectionSpace::new(2.5_f64.to_radians());
        for axis in [Vector::x_axis(), Vector::y_axis(), Vector::z_axis()] {
            let cell = space.cell(&axis).unwrap();
            assert!(space.direction_of(cell).dot(&axis) > 1.0 - 1e-12);
        }
    }

    #[test]
    fn neighbours_are_mutual_near_and_joined_across_face_edges_and_antipodes() {
        let space = DirectionSpace::new(5_f64.to_radians());
        for cell in 0..space.len() {
            let mut count = 0;
            space.neighbours(cell, &mut |other| {
                count += 1;
                let cosine = space
                    .direction_of(cell)
                    .dot(&space.direction_of(other))
                    .abs();
                assert!(cosine.acos() < 3.0 * space.step());
                let mut back = false;
                space.neighbours(other, &mut |again| back |= again == cell);
                assert!(back);
            });
            assert!(count >= 5, "cell {cell} has {count} neighbours");
        }
    }

    #[test]
    fn neighbours_hold_the_places_of_the_eight_around_a_cell_in_either_direction() {
        for degrees in [30.0, 11.0, 2.5, 1.7] {
            let space = DirectionSpace::new(f64::to_radians(degrees));
            let mut expected = vec![std::collections::BTreeSet::new(); space.len()];
            for cell in 0..space.len() {
                let (face, row, column) = space.place(cell);
                for (down, right) in AROUND {
                    let (r, c) = (row as f64 + 0.5 + down, column as f64 + 0.5 + right);
                    let other = space.cell(&space.direction(face, r, c)).unwrap();
                    if other != cell {
                        expected[cell].insert(other);
                        expected[other].insert(cell);
                    }
                }
            }
            for (cell, expected) in expected.into_iter().enumerate() {
                let mut found = Vec::new();
                space.neighbours(cell, &mut |other| found.push(other));
                let expected: Vec<usize> = expected.into_iter().collect();
                assert_eq!(found, expected, "cell {cell} of {degrees}°");
            }
        }
    }

    #[test]
    fn a_great_circle_meets_the_directions_across_its_normal() {
        let space = DirectionSpace::new(2_f64.to_radians());
        let normal = Direction::new_normalize(Vector::new(1.0, 2.0, 3.0));
        let mut cells = Vec::new();
        space.great_circle(&normal, |cell| cells.push(cell));
        // Half a turn of cells of nearly equal size, about one and a half cells wide.
        let along = std::f64::consts::PI / space.step();
        assert!(cells.len() as f64 > 0.8 * along && (cells.len() as f64) < 2.5 * along);
        for cell in cells {
            assert!(space.direction_of(cell).dot(&normal).abs() < space.step());
        }
    }

    #[test]
    fn a_vector_without_direction_has_no_cell() {
        let space = DirectionSpace::new(0.1);
        assert_eq!(space.cell(&Vector::zeros()), None);
        assert_eq!(space.cell(&Vector::new(f64::NAN, f64::NAN, f64::NAN)), None);
    }
}
