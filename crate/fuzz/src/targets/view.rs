//! What the renderer computes before WebGL: scene, panes, cameras, lassos, pictures.

use fit4cad_view::camera::{Camera, CameraState, Projection, Standpoint};
use fit4cad_view::cloud::Bounds;
use fit4cad_view::colouring::ColourBy;
use fit4cad_view::controls::{Flight, trackball};
use fit4cad_view::lasso::Lasso;
use fit4cad_view::layout::{Layout, Side};
use fit4cad_view::motion::Motion;
use fit4cad_view::patch::SurfacePatch;
use fit4cad_view::picture::Picture;
use fit4cad_view::scene::{Frame, PointSize, Scene};
use fit4cad_view::select::Region;
use glam::{Vec2, Vec3};

use super::MIB;
use crate::{Bytes, Target};

pub const SCENE: Target = Target {
    name: "view-scene",
    run: |input| {
        let mut bytes = Bytes::new(input);
        let mut scene = Scene::default();
        scene.set_cloud(bytes.list(120, Bytes::single));
        scene.set_normals(bytes.list(120, Bytes::single));
        scene.layout = layout(&mut bytes);
        for side in Side::BOTH {
            let colouring = scene.colouring_mut(side);
            colouring.set_labels(bytes.list(60, Bytes::whole));
            colouring.set_scalars(bytes.list(60, Bytes::single));
            colouring.set_colours(&bytes.list(60, Bytes::byte));
            colouring.set_states(&bytes.list(20, Bytes::byte));
            colouring.set_map(&bytes.list(20, Bytes::byte));
            if bytes.flag() {
                colouring.by = ColourBy::Scalar {
                    low: bytes.single(),
                    high: bytes.single(),
                };
            }
        }
        // In slices, as frames do, and not always to the end.
        for _ in 0..bytes.list(4, Bytes::byte).len() {
            scene.proceed(1 + usize::from(bytes.byte()));
        }
        scene.display.point_size = match bytes.flag() {
            true => PointSize::Spacing(bytes.single().clamp(0.1, 20.0)),
            false => PointSize::Pixels(bytes.single().clamp(0.5, 40.0)),
        };
        let frame = Frame {
            width: side_of(&mut bytes),
            height: side_of(&mut bytes),
            pixel_ratio: bytes.single(),
        };
        if bytes.flag()
            && let Some(camera) = Camera::from_state(&state(&mut bytes))
        {
            scene.camera = camera;
        } else {
            scene.camera = scene.fitting(&frame);
        }
        let curve = bytes.list(60, place);
        let circle = Region::Circle {
            centre: place(&mut bytes),
            radius: bytes.single(),
        };
        let count = scene.cloud.get().len();
        for pane in scene.panes(&frame).iter() {
            let sight = scene.sight(pane, &frame, count);
            let size = Vec2::new(pane.viewport.width as f32, pane.viewport.height as f32);
            for region in [Region::Polygon(curve.clone()), circle.clone()] {
                let matrix = &sight.lens.view_projection;
                let found = region.select(scene.cloud.get().positions(), matrix, size);
                assert!(found.iter().all(|&place| (place as usize) < count));
            }
            if let Some(lasso) =
                Lasso::drawn(&curve, &pane.viewport, &scene.camera, frame.pixel_ratio)
            {
                assert!((3..=1000).contains(&lasso.corners.len()));
                lasso.down_to(
                    scene.cloud.get().positions().iter().copied(),
                    &scene.camera,
                    0.1,
                );
            }
            scene.bounds_of(pane.side, &bytes.list(6, Bytes::whole));
        }
        let (positions, normals) = (bytes.list(60, Bytes::single), bytes.list(60, Bytes::single));
        let patch = SurfacePatch::new(
            Side::First,
            [0; 3],
            &positions,
            &normals,
            &bytes.list(60, Bytes::whole),
        );
        let patch = patch.with_lines(&bytes.list(60, Bytes::single), &bytes.list(60, Bytes::byte));
        let exists = |corner: &u32| (*corner as usize) < patch.vertices.len();
        assert!(patch.triangles.iter().all(exists));
    },
    seeds: super::none,
    words: &[],
    longest: 2048,
    floor: MIB / 2,
    quick: 70_000,
};

pub const CAMERA: Target = Target {
    name: "view-camera",
    run: |input| {
        let mut bytes = Bytes::new(input);
        let bounds = Bounds::of(bytes.list(6, vector));
        let mut camera = Camera::from_state(&state(&mut bytes)).unwrap_or_default();
        let mut motion = Motion::default();
        let mut steps = 0;
        while !bytes.is_empty() && steps < 60 {
            steps += 1;
            match bytes.below(9) {
                0 => camera.drag(place(&mut bytes), place(&mut bytes), bytes.single()),
                1 => camera.turn(bytes.single(), bytes.single(), bytes.single()),
                2 => camera.pan(place(&mut bytes), bytes.single()),
                3 => camera.zoom(bytes.single(), place(&mut bytes), bytes.single()),
                4 => camera = camera.framing(&bounds, bytes.single()),
                5 => camera = camera.from_standpoint(bytes.one(Standpoint::ALL)),
                6 => {
                    let mut flight =
                        Flight::new(camera, camera.from_standpoint(bytes.one(Standpoint::ALL)));
                    flight.at(bytes.number());
                    camera = flight.at(bytes.number()).0;
                }
                7 => {
                    let total = bytes.whole() as usize;
                    let (count, _) =
                        motion.frame(bytes.number(), bytes.number(), bytes.flag(), total);
                    assert!(count <= total);
                }
                _ => {
                    camera.lens(bytes.single(), bytes.single(), &bounds);
                    trackball(place(&mut bytes), place(&mut bytes), bytes.single());
                }
            }
            let usable =
                camera.target.is_finite() && camera.rotation.is_finite() && camera.height > 0.0;
            assert!(usable && camera.height.is_finite(), "{camera:?}");
        }
    },
    seeds: super::none,
    words: &[],
    longest: 512,
    floor: MIB / 4,
    quick: 120_000,
};

pub const PICTURE: Target = Target {
    name: "view-picture",
    run: |input| {
        let mut bytes = Bytes::new(input);
        let side = |bytes: &mut Bytes<'_>| i32::from(bytes.byte());
        let (width, height, factor) = (side(&mut bytes), side(&mut bytes), side(&mut bytes));
        let mut picture = Picture::new(width, height, factor);
        let (x, y) = (side_of(&mut bytes), side_of(&mut bytes));
        let (tile_width, margin) = (side_of(&mut bytes), side_of(&mut bytes));
        picture.add(x, y, bytes.rest(), tile_width, margin);
        let pixels = picture.into_straight_alpha();
        assert_eq!(pixels.len(), (width * height) as usize * 4);
    },
    seeds: super::none,
    words: &[],
    longest: 1024,
    floor: MIB,
    quick: 5_000,
};

/// Width or height of a canvas as JavaScript can give it.
fn side_of(bytes: &mut Bytes<'_>) -> i32 {
    bytes.whole() as i32
}

fn place(bytes: &mut Bytes<'_>) -> Vec2 {
    Vec2::new(bytes.single(), bytes.single())
}

fn vector(bytes: &mut Bytes<'_>) -> Vec3 {
    Vec3::new(bytes.single(), bytes.single(), bytes.single())
}

fn layout(bytes: &mut Bytes<'_>) -> Layout {
    match bytes.below(3) {
        0 => Layout::Split,
        1 => Layout::Single {
            side: bytes.one(Side::BOTH),
        },
        // The boundary turns what is no number into the middle.
        _ => Layout::Wipe {
            at: Some(bytes.single())
                .filter(|at| !at.is_nan())
                .unwrap_or(0.5),
        },
    }
}

fn state(bytes: &mut Bytes<'_>) -> CameraState {
    CameraState {
        target: bytes.numbers::<3>().map(|it| it as f32),
        rotation: bytes.numbers::<4>().map(|it| it as f32),
        height: bytes.single(),
        projection: bytes.one([Projection::Perspective, Projection::Orthographic]),
    }
}
