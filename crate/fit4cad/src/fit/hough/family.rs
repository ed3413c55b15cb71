//! The five families as parameter spaces, each factored into a ladder of small spaces.
//!
//! A cone has six parameters; no matrix over all of them fits in memory, nor would its cells see
//! more than one vote. So a family's space is climbed rung by rung (Rabbani and van den Heuvel,
//! 2005, for cylinders): peaks of the first rung split the votes, and each share is counted on the
//! next rung in coordinates that the peak's consensus makes precise.
//!
//! | family | rungs |
//! |---|---|
//! | plane | normal on the Gauss sphere; offset |
//! | cylinder | axis on the Gauss sphere; centre in the plane across; radius |
//! | cone | axis on the Gauss sphere; apex; half-angle |
//! | sphere | centre; radius |
//! | torus | axis on the Gauss sphere; centre; both radii |

use super::grid::{Axis, Grid};
use crate::cloud::{Bounds, Direction, Point};
use crate::fit::axes::direction_of;
use crate::surface::{Cone, Cylinder, Plane, Sphere, Surface, SurfaceType, Torus, across};

/// One rung of a family's ladder.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Rung {
    /// Normal or axis, on the Gauss sphere with antipodes identified.
    Direction,
    /// Signed distance of a plane from the middle of the region, along the chosen normal.
    Offset,
    /// Where the axis pierces the plane across it through the middle of the region.
    Across,
    /// Centre or apex.
    Position,
    /// Radius of a cylinder or sphere.
    Radius,
    /// Half-angle of a cone.
    HalfAngle,
    /// Major and minor radius of a torus.
    Radii,
}

impl Rung {
    /// What the rung's coordinates are, for titles of pictures.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Direction => "direction",
            Self::Offset => "offset",
            Self::Across => "centre across the axis",
            Self::Position => "position",
            Self::Radius => "radius",
            Self::HalfAngle => "half-angle",
            Self::Radii => "radii",
        }
    }
}

/// The ladder of a family.
pub const fn ladder(kind: SurfaceType) -> &'static [Rung] {
    match kind {
        SurfaceType::Plane => &[Rung::Direction, Rung::Offset],
        SurfaceType::Cylinder => &[Rung::Direction, Rung::Across, Rung::Radius],
        SurfaceType::Cone => &[Rung::Direction, Rung::Position, Rung::HalfAngle],
        SurfaceType::Sphere => &[Rung::Position, Rung::Radius],
        SurfaceType::Torus => &[Rung::Direction, Rung::Position, Rung::Radii],
    }
}

/// The region T of parameter space and the size of its cells, taken from the cloud.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Region {
    /// Where the points are.
    pub bounds: Bounds,
    /// Cell size of lengths, in the units of the cloud.
    pub length_step: f64,
    /// Cell size of angles, in radians.
    pub angle_step: f64,
    /// Whether it is the region of surfaces so large, or apexes so far, that the near one does not hold them.
    pub is_far: bool,
}

/// The parameters settled on the rungs climbed so far.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Settled {
    /// Normal or axis.
    pub direction: Option<Direction>,
    /// Centre, apex or point of the axis; for a plane, a point of it.
    pub position: Option<Point>,
    /// Radius, half-angle or both radii.
    pub sizes: [f64; 2],
}

impl Region {
    /// Apexes of slim cones and centres of large spheres lie outside the cloud's box, and radii are looked for,
    /// by up to this many diagonals.
    const NEAR: f64 = 4.0;
    /// And in the far region, whose cells are as much coarser where there are too many: beyond what any search
    /// takes for plausible, 30 diameters of a ball that holds the box.
    const FAR: f64 = 64.0;

    /// Whether a vote is to be counted here. In the near region all are; those it has no cells for drop out.
    pub fn concerns(&self, surface: &Surface) -> bool {
        let size = match surface {
            Surface::Plane(_) => return !self.is_far,
            Surface::Cylinder(it) => it.radius,
            Surface::Sphere(it) => it.radius,
            Surface::Torus(it) => it.major_radius.max(it.minor_radius),
            Surface::Cone(it) => (it.apex - self.bounds.centre()).norm(),
        };
        !self.is_far || size > Self::NEAR * self.bounds.diagonal()
    }

    /// The grid of a rung; the Gauss sphere is no grid and gives one without axes.
    pub fn grid(&self, rung: Rung) -> Grid {
        let diagonal = self.bounds.diagonal();
        let reach = if self.is_far { Self::FAR } else { Self::NEAR };
        let length = |reach: f64| Axis::new(-reach * diagonal, reach * diagonal, self.length_step);
        let radius = || Axis::new(0.0, reach * diagonal, self.length_step);
        let axes = match rung {
            Rung::Direction => Vec::new(),
            Rung::Offset => vec![length(0.5)],
            Rung::Across => vec![length(reach); 2],
            Rung::Position => vec![length(reach); 3],
            Rung::Radius => vec![radius()],
            Rung::HalfAngle => vec![Axis::new(0.0, std::f64::consts::FRAC_PI_2, self.angle_step)],
            Rung::Radii => vec![radius(); 2],
        };
        Grid::new(axes)
    }

    /// Coordinates on a rung of a surface that passes through `foot`, given what is settled.
    /// Coordinates that the settled direction changes are taken at the foot, where the surface is
    /// known best: a plane's offset is that of the foot along the settled normal. `None` where the
    /// surface has no such coordinate.
    pub fn coordinates(
        &self,
        rung: Rung,
        surface: &Surface,
        foot: &Point,
        settled: &Settled,
    ) -> Option<[f64; 3]> {
        let middle = self.bounds.centre();
        let one = |value: f64| Some([value, 0.0, 0.0]);
        match (rung, surface) {
            (Rung::Direction, _) => direction_of(surface).map(|d| [d.x, d.y, d.z]),
            (Rung::Offset, Surface::Plane(_)) => one(settled.direction?.dot(&(foot - middle))),
            (Rung::Across, Surface::Cylinder(cylinder)) => {
                let axis = settled.direction?;
                let u = across(&axis);
                let v = axis.cross(&u);
                let height = cylinder.axis.dot(&(foot - cylinder.centre));
                let level = cylinder.centre + cylinder.axis.into_inner() * height;
                let offset = level - middle;
                Some([offset.dot(&u), offset.dot(&v), 0.0])
            }
            (Rung::Position, Surface::Cone(Cone { apex: p, .. }))
            | (
                Rung::Position,
                Surface::Sphere(Sphere { centre: p, .. }) | Surface::Torus(Torus { centre: p, .. }),
            ) => {
                let offset = p - middle;
                Some([offset.x, offset.y, offset.z])
            }
            (Rung::Radius, Surface::Cylinder(Cylinder { radius, .. }))
            | (Rung::Radius, Surface::Sphere(Sphere { radius, .. })) => one(*radius),
            (Rung::HalfAngle, Surface::Cone(cone)) => one(cone.half_angle),
            (Rung::Radii, Surface::Torus(torus)) => {
                Some([torus.major_radius, torus.minor_radius, 0.0])
            }
            _ => None,
        }
    }

    /// Adds a rung's coordinates to what is settled.
    pub fn settle(&self, rung: Rung, coordinates: [f64; 3], settled: &Settled) -> Settled {
        let middle = self.bounds.centre();
        let [a, b, c] = coordinates;
        let mut settled = *settled;
        match rung {
            Rung::Direction => {
                settled.direction = Direction::try_new(crate::cloud::Vector::new(a, b, c), 0.0);
            }
            Rung::Offset => {
                settled.position = settled.direction.map(|n| middle + n.into_inner() * a);
            }
            Rung::Across => {
                settled.position = settled.direction.map(|axis| {
                    let u = across(&axis);
                    middle + u.into_inner() * a + axis.cross(&u) * b
                });
            }
            Rung::Position => settled.position = Some(middle + crate::cloud::Vector::new(a, b, c)),
            Rung::Radius | Rung::HalfAngle => settled.sizes = [a, 0.0],
            Rung::Radii => settled.sizes = [a, b],
        }
        settled
    }
}

/// The surface of a family whose parameters are all settled; `None` while some are open.
pub fn surface(kind: SurfaceType, settled: &Settled) -> Option<Surface> {
    let position = settled.position?;
    let direction = || settled.direction.map(Direction::into_inner);
    let [size, second] = settled.sizes;
    Some(match kind {
        SurfaceType::Plane => Surface::Plane(Plane::new(position, direction()?)),
        SurfaceType::Cylinder => Surface::Cylinder(Cylinder::new(position, direction()?, size)),
        SurfaceType::Cone => Surface::Cone(Cone::new(position, direction()?, size)),
        SurfaceType::Sphere => Surface::Sphere(Sphere::new(position, size)),
        SurfaceType::Torus => Surface::Torus(Torus::new(position, direction()?, size, second)),
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cloud::Vector;

    fn region() -> Region {
        Region {
            bounds: Bounds {
                min: Point::new(-1.0, 0.0, 1.0),
                max: Point::new(3.0, 4.0, 5.0),
            },
            length_step: 0.05,
            angle_step: 0.03,
            is_far: false,
        }
    }

    fn examples() -> [Surface; 5] {
        let p = Point::new(0.5, 1.5, 3.0);
        let d = Vector::new(1.0, -2.0, 0.5);
        [
            Surface::Plane(Plane::new(p, d)),
            Surface::Cylinder(Cylinder::new(p, d, 0.7)),
            Surface::Cone(Cone::new(p, d, 0.4)),
            Surface::Sphere(Sphere::new(p, 0.7)),
            Surface::Torus(Torus::new(p, d, 0.9, 0.2)),
        ]
    }

    #[test]
    fn climbing_the_ladder_of_a_surface_gives_it_back() {
        let region = region();
        for example in examples() {
            let foot = example.foot(&Point::new(0.9, 0.2, 2.0));
            let mut settled = Settled::default();
            for &rung in ladder(example.kind()) {
                let coordinates = region.coordinates(rung, &example, &foot, &settled).unwrap();
                settled = region.settle(rung, coordinates, &settled);
            }
            let back = surface(example.kind(), &settled).unwrap();
            for probe in [Point::new(1.0, 1.0, 2.0), Point::new(-1.0, 3.0, 4.0)] {
                let difference = back.distance(&probe) - example.distance(&probe);
                assert!(difference.abs() < 1e-9, "{example:?} became {back:?}");
            }
        }
    }

    #[test]
    fn every_coordinate_of_a_surface_in_the_region_has_a_cell() {
        let region = region();
        for example in examples() {
            let foot = example.foot(&region.bounds.centre());
            let mut settled = Settled::default();
            for &rung in ladder(example.kind()) {
                let coordinates = region.coordinates(rung, &example, &foot, &settled).unwrap();
                assert!(region.grid(rung).cell(&coordinates).is_some(), "{rung:?}");
                settled = region.settle(rung, coordinates, &settled);
            }
        }
    }

    #[test]
    fn a_surface_has_no_coordinates_on_another_familys_rung() {
        let [plane, _, _, sphere, _] = examples();
        let settled = Settled::default();
        let foot = Point::origin();
        assert_eq!(
            region().coordinates(Rung::Direction, &sphere, &foot, &settled),
            None
        );
        assert_eq!(
            region().coordinates(Rung::Radius, &plane, &foot, &settled),
            None
        );
    }
}
