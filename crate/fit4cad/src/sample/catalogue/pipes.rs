//! Parts made of pipes.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_3};

use super::super::blocks::{Loop, Outline, Part, Solid};

/// The bend turns about the z axis from the x axis to the y axis, in a circle of radius 40; a
/// flanged pipe leaves each end.
pub fn elbow() -> Part {
    let around = |radius: f64| Outline::disc([40.0, 0.0], radius);
    let bar = |y: f64, radius: f64, height: f64| {
        Solid::rod([40.0, y, 0.0], radius, height).facing([0.0, -1.0, 0.0], [1.0, 0.0, 0.0])
    };
    let other = |x: f64, radius: f64, height: f64| {
        Solid::rod([x, 40.0, 0.0], radius, height).facing([-1.0, 0.0, 0.0], [0.0, 1.0, 0.0])
    };
    let mut part = Part::new()
        .join(Solid::revolve_by(around(15.0), FRAC_PI_2))
        .join(bar(0.0, 15.0, 20.0))
        .join(other(0.0, 15.0, 30.0))
        .join(bar(-20.0, 26.0, 7.0))
        .join(other(-30.0, 26.0, 7.0))
        .cut(Solid::revolve_by(around(11.0), FRAC_PI_2))
        .cut(bar(0.0, 11.0, 30.0))
        .cut(other(0.0, 11.0, 40.0));
    for k in 0..4 {
        let (sin, cos) = libm::sincos(FRAC_PI_2 * (f64::from(k) + 0.5));
        let [across, up] = [20.5 * cos, 20.5 * sin];
        let along_y = Solid::rod([40.0 + across, -19.0, up], 3.0, 10.0);
        let along_x = Solid::rod([-29.0, 40.0 + across, up], 3.0, 10.0);
        part = part
            .cut(along_y.facing([0.0, -1.0, 0.0], [1.0, 0.0, 0.0]))
            .cut(along_x.facing([-1.0, 0.0, 0.0], [0.0, 1.0, 0.0]));
    }
    part
}

/// A run along an oblique axis and a branch at 60 degrees to it.
pub fn branch() -> Part {
    // Orthogonal: the run's axis, and the direction the branch leans away from it.
    let (run, lean) = ([0.6, 0.48, 0.64], [-0.8, 0.36, 0.48]);
    let (sin, cos) = libm::sincos(FRAC_PI_3);
    let way: [f64; 3] = std::array::from_fn(|k| cos * run[k] + sin * lean[k]);
    let along = |axis: [f64; 3], length: f64| axis.map(|x| x * length);
    let pipe = |radius: f64, from: f64, to: f64| {
        Solid::rod(along(run, from), radius, to - from).facing(run, lean)
    };
    let arm = |radius: f64, from: f64, to: f64| {
        Solid::rod(along(way, from), radius, to - from).facing(way, run)
    };
    let collar = |radius: f64, chamfer: f64| {
        let inner = radius - 6.0;
        Loop::polygon(&[
            [inner, 0.0],
            [radius - chamfer, 0.0],
            [radius, chamfer],
            [radius, 8.0 - chamfer],
            [radius - chamfer, 8.0],
            [inner, 8.0],
        ])
    };
    let collar = |radius: f64, at: [f64; 3], axis: [f64; 3], x: [f64; 3]| {
        Solid::revolve(Outline::new(collar(radius, 1.5)))
            .at(at)
            .facing(axis, x)
    };
    Part::new()
        .join(pipe(16.0, -42.0, 58.0))
        .join(arm(11.0, 0.0, 58.0))
        .join(collar(20.0, along(run, -42.0), run, lean))
        .join(collar(20.0, along(run, 50.0), run, lean))
        .join(collar(15.0, along(way, 50.0), way, run))
        .cut(pipe(12.0, -50.0, 70.0))
        .cut(arm(8.0, 0.0, 70.0))
}
