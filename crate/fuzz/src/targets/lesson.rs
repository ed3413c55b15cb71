//! What the lessons ask for, on clouds and surfaces that no lesson has.

use fit4cad::cloud::{Point, Vector};
use fit4cad::lesson::growing::{Growing, motions, split};
use fit4cad::lesson::hough::{Transform, polish, rivals, typical};
use fit4cad::lesson::{forms, painting};
use fit4cad::metrics::{Protocol, evaluate};
use fit4cad::surface::patch::Patch;
use fit4cad::surface::{Cone, Cylinder, Plane, Sphere, Surface, SurfaceType, Torus};

use super::MIB;
use crate::{Bytes, Target, shapes};

pub const HOUGH: Target = Target {
    name: "lesson-hough",
    run: |input| {
        let mut bytes = Bytes::new(input);
        let surfaces: Vec<Surface> = bytes
            .list(5, shapes::surface)
            .into_iter()
            .flatten()
            .collect();
        let Some(base) = typical(&surfaces, shapes::kind(&mut bytes)) else {
            return;
        };
        let (share, chosen, voters) = (bytes.number(), bytes.whole(), bytes.list(20, Bytes::whole));
        let cloud = shapes::cloud(&mut bytes);
        let transform = Transform::new(&cloud, base);
        transform.gamma(chosen);
        let diagram = transform.diagram();
        assert!(diagram.significant(share).count() <= diagram.peaks.len());
        transform.heights(voters);
        let highest = diagram.peaks.first().map_or(0, |peak| peak.position as u32);
        for cell in [highest, chosen] {
            let Some(surface) = transform.surface(cell) else {
                continue;
            };
            if let Some(candidate) = polish(&cloud, &surface, &transform.voters(cell)) {
                rivals(&cloud, &candidate);
            }
        }
    },
    seeds: super::none,
    words: &[],
    longest: 1024,
    floor: 12 * MIB,
    quick: 80,
};

pub const GROWING: Target = Target {
    name: "lesson-growing",
    run: |input| {
        let mut bytes = Bytes::new(input);
        let (quantile, seed, amount) =
            (bytes.number().clamp(0.0, 1.0), bytes.seed(), bytes.number());
        let chosen = bytes.list(30, Bytes::whole);
        let cloud = shapes::cloud(&mut bytes);
        let growing = Growing::new(&cloud);
        let partition = growing.partition(quantile);
        let regions = partition.regions.iter().take(3);
        for region in regions.chain([&chosen]) {
            if let Some(slippage) = growing.slippage(&cloud, region) {
                let all = cloud.points();
                let points = region.iter().filter_map(|&index| all.get(index as usize));
                let points: Vec<Point> = points.copied().collect();
                for motion in motions(&slippage, &points) {
                    motion.by(amount);
                }
            }
            let found = split(&cloud, region, seed).unwrap_or_default();
            assert!(found.iter().all(|candidate| !candidate.support.is_empty()));
        }
    },
    seeds: super::none,
    words: &[],
    longest: 1024,
    floor: 12 * MIB,
    quick: 1_000,
};

pub const FORMS: Target = Target {
    name: "lesson-forms",
    run: |input| {
        let mut bytes = Bytes::new(input);
        let kind = shapes::kind(&mut bytes);
        let at = shapes::point(&mut bytes);
        let axis = Vector::from(bytes.numbers::<3>());
        let (size, minor) = (bytes.number(), bytes.number());
        let surface = match kind {
            SurfaceType::Plane => Surface::Plane(Plane::new(at, axis)),
            SurfaceType::Cylinder => Surface::Cylinder(Cylinder::new(at, axis, size)),
            SurfaceType::Cone => Surface::Cone(Cone::new(at, axis, size)),
            SurfaceType::Sphere => Surface::Sphere(Sphere::new(at, size)),
            SurfaceType::Torus => Surface::Torus(Torus::new(at, axis, size, minor)),
        };
        let points = forms::shown_points(&surface, 1.5);
        let implicit = surface.to_implicit();
        surface.to_parametric();
        assert_eq!(forms::implicit_terms(implicit.len()).len(), implicit.len());
        Patch::new(&surface, &points);
        let other = bytes.list(40, Bytes::number);
        forms::compare(&implicit, &other);
        forms::compare(&other, &other);
    },
    seeds: super::none,
    words: &[],
    longest: 512,
    floor: 4 * MIB,
    quick: 4_000,
};

pub const PAINTING: Target = Target {
    name: "lesson-painting",
    run: |input| {
        let mut bytes = Bytes::new(input);
        let rest = bytes.whole().min(2_000);
        let model = painting::niche(rest);
        let shift = bytes.number();
        let lists = bytes.list(6, |bytes| bytes.list(60, Bytes::whole));
        let painted = painting::painted(&model, &lists, shift);
        if let Some(truth) = &model.truth {
            let report = evaluate(&model.cloud, truth, &painted, Protocol::Definition);
            assert_eq!(report.predicted, painted.primitives.len());
        }
    },
    seeds: super::none,
    words: &[],
    longest: 1024,
    floor: MIB,
    quick: 7_000,
};
