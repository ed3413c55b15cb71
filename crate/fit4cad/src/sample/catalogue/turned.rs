//! Parts whose body comes off a lathe.

use std::f64::consts::{FRAC_PI_3, SQRT_2};

use super::super::blocks::{Loop, Outline, Part, QUARTER, Solid};

pub fn flange() -> Part {
    let profile = Loop::rounded(&[
        [12.0, 0.0, 0.0],
        [48.0, 0.0, 0.0],
        [50.0, 2.0, 0.0],
        [50.0, 11.0, 0.0],
        [22.0, 11.0, 5.0],
        [22.0, 36.0, 3.0],
        [12.0, 36.0, 0.0],
    ]);
    let body = Part::new().join(Solid::revolve(Outline::new(profile)));
    (0..6).fold(body, |part, k| {
        let (sin, cos) = libm::sincos(f64::from(k) * FRAC_PI_3);
        part.cut(Solid::rod([37.0 * cos, 37.0 * sin, -1.0], 4.5, 13.0))
    })
}

pub fn shaft() -> Part {
    let profile = Loop::polygon(&[
        [0.0, 0.0],
        [9.0, 0.0],
        [11.0, 2.0],
        [11.0, 30.0],
        [9.5, 30.0],
        [9.5, 34.0],
        [18.0, 34.0],
        [18.0, 70.0],
        [14.0, 70.0],
        [14.0, 110.0],
        [12.0, 113.0],
        [0.0, 113.0],
    ]);
    let keyway = Loop::path([-4.0, 80.0])
        .arc([4.0, 80.0], 1.0)
        .line([4.0, 100.0])
        .arc([-4.0, 100.0], 1.0);
    let keyway = Solid::extrude(Outline::new(keyway), 20.0)
        .at([10.0, 0.0, 0.0])
        .facing([1.0, 0.0, 0.0], [0.0, 1.0, 0.0]);
    Part::new()
        .join(Solid::revolve(Outline::new(profile)))
        .cut(keyway)
}

/// The neck, of radius 12, meets the ball, of radius 20, 16 below its centre.
pub fn ball_joint() -> Part {
    let ball = Loop::path([0.0, 0.0])
        .line([9.0, 0.0])
        .line([10.0, 1.0])
        .line([10.0, 28.0])
        .line([22.0, 28.0])
        .line([22.0, 31.0])
        .arc([19.0, 34.0], QUARTER)
        .line([17.0, 34.0])
        .arc([12.0, 39.0], -QUARTER)
        .line([12.0, 48.0])
        .arc_about([0.0, 64.0], [0.0, 84.0]);
    let flats = |y: [f64; 2]| Solid::cuboid([-30.0, y[0], 27.0], [30.0, y[1], 35.0]);
    Part::new()
        .join(Solid::revolve(Outline::new(ball)))
        .cut(flats([-30.0, -18.0]))
        .cut(flats([18.0, 30.0]))
        .cut(Solid::rod([0.0, 0.0, 68.0], 4.0, 20.0))
}

pub fn nozzle() -> Part {
    let profile = Loop::path([16.0, 0.0])
        .line([28.0, 0.0])
        .line([28.0, 14.0])
        .line([26.0, 16.0])
        .line([22.0, 16.0])
        .line([22.0, 30.0])
        .line([10.0, 74.0])
        .line([8.0, 76.0])
        .line([6.0, 76.0])
        .line([6.0, 66.0])
        .line([16.0, 30.0]);
    let hexagon: Vec<[f64; 2]> = (0..6)
        .map(|k| {
            let (sin, cos) = libm::sincos(f64::from(k) * FRAC_PI_3);
            [31.0 * cos, 31.0 * sin]
        })
        .collect();
    let hexagon = Outline::new(Loop::polygon(&hexagon)).hole(Loop::circle([0.0, 0.0], 20.0));
    Part::new()
        .join(Solid::revolve(Outline::new(profile)))
        .join(Solid::extrude(hexagon, 14.0).at([0.0, 0.0, 12.0]))
}

pub fn spool() -> Part {
    let profile = Loop::rounded(&[
        [10.0, 0.0, 0.0],
        [30.0, 0.0, 0.0],
        [30.0, 6.0, 0.0],
        [18.0, 6.0, 2.0],
        [18.0, 24.0, 2.0],
        [30.0, 24.0, 0.0],
        [30.0, 29.0, 0.0],
        [28.0, 29.0, 0.0],
        [28.0, 31.0, 0.0],
        [30.0, 31.0, 0.0],
        [30.0, 36.0, 0.0],
        [10.0, 36.0, 0.0],
    ]);
    Part::new().join(Solid::revolve(Outline::new(profile)))
}

pub fn knob() -> Part {
    let profile = Loop::path([0.0, 0.0])
        .line([20.0, 0.0])
        .line([20.0, 6.0])
        .curve([[20.0, 16.0], [9.0, 14.0]], [10.0, 26.0])
        .curve([[10.7, 34.4], [24.0, 34.0]], [24.0, 46.0])
        .line([24.0, 50.0])
        .arc([20.0, 54.0], QUARTER)
        .line([0.0, 54.0]);
    let half = 4.0 * SQRT_2;
    let bore = Loop::path([-half, 2.0]).arc_about([0.0, 0.0], [half, 2.0]);
    Part::new()
        .join(Solid::revolve(Outline::new(profile)))
        .cut(Solid::extrude(Outline::new(bore), 20.0).at([0.0, 0.0, -2.0]))
        .cut(Solid::rod([0.0, 0.0, 52.5], 12.0, 10.0))
}
