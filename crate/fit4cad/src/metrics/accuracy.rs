//! Approximation accuracy of a predicted primitive (paper, section of that name).

use crate::cloud::{Bounds, Cloud};
use crate::surface::Surface;

/// How well a surface fits the points of its primitive.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FitAccuracy {
    /// Mean fitting error, MFE = (1/|𝒫_S|) Σ d(x, 𝒮) / l.
    pub mfe: f64,
    /// Directed Hausdorff distance, max d(x, 𝒮) / l.
    pub d_haus: f64,
}

/// Mean and largest Euclidean distance of the points to the whole surface 𝒮, over the diagonal l
/// of the points' axis-aligned bounding box. Where l = 0 (one point, or equal points) the diagonal
/// of the cloud takes its place, so that a lone point off its surface still shows.
///
/// `None` without points, where no diagonal is positive and the points are off the surface, or
/// where the numbers overflow. Indices beyond the cloud are left out. O(points), closed form.
pub fn fit_accuracy(cloud: &Cloud, points: &[u32], surface: &Surface) -> Option<FitAccuracy> {
    let (mut bounds, mut sum, mut largest, mut count) = (Bounds::EMPTY, 0.0, 0.0f64, 0u32);
    for &index in points {
        let Some(point) = cloud.points().get(index as usize) else {
            continue;
        };
        bounds.add(point);
        let distance = surface.distance(point);
        sum += distance;
        largest = largest.max(distance);
        count += 1;
    }
    if count == 0 || !f64::is_finite(sum) {
        return None;
    }
    if largest == 0.0 {
        return Some(FitAccuracy {
            mfe: 0.0,
            d_haus: 0.0,
        });
    }
    let diagonal = cloud.length_of(&bounds);
    (diagonal > 0.0 && diagonal.is_finite()).then(|| FitAccuracy {
        mfe: sum / f64::from(count) / diagonal,
        d_haus: largest / diagonal,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cloud::{Point, Vector};
    use crate::surface::{Plane, Sphere};

    fn floor() -> Surface {
        Surface::Plane(Plane::new(Point::origin(), Vector::z()))
    }

    #[test]
    fn mean_and_maximum_are_shares_of_the_diagonal() {
        // Heights 0, 1, 2 and 0 over a box of 2 × 1 × 2: diagonal 3.
        let cloud = Cloud::new(vec![
            Point::new(0.0, 0.0, 0.0),
            Point::new(2.0, 0.0, 1.0),
            Point::new(2.0, 1.0, 2.0),
            Point::new(0.0, 1.0, 0.0),
            Point::new(50.0, 50.0, 50.0),
        ]);
        let accuracy = fit_accuracy(&cloud, &[0, 1, 2, 3], &floor()).unwrap();
        assert_eq!(accuracy.mfe, 0.75 / 3.0);
        assert_eq!(accuracy.d_haus, 2.0 / 3.0);
    }

    #[test]
    fn a_lone_point_is_measured_by_the_cloud() {
        let cloud = Cloud::new(vec![Point::new(0.0, 0.0, 1.0), Point::new(3.0, 4.0, 1.0)]);
        let accuracy = fit_accuracy(&cloud, &[0], &floor()).unwrap();
        assert_eq!((accuracy.mfe, accuracy.d_haus), (0.2, 0.2));
    }

    #[test]
    fn a_cloud_of_one_point_fits_only_a_surface_through_it() {
        let cloud = Cloud::new(vec![Point::new(0.0, 0.0, 1.0)]);
        assert_eq!(fit_accuracy(&cloud, &[0], &floor()), None);
        let sphere = Surface::Sphere(Sphere::new(Point::origin(), 1.0));
        assert_eq!(fit_accuracy(&cloud, &[0], &sphere).unwrap().mfe, 0.0);
    }

    #[test]
    fn no_points_no_measure() {
        let cloud = Cloud::new(vec![Point::origin()]);
        assert_eq!(fit_accuracy(&cloud, &[], &floor()), None);
        assert_eq!(fit_accuracy(&cloud, &[7], &floor()), None);
    }
}
