//! Parts whose body is milled, cast or extruded.

use std::f64::consts::TAU;

use super::super::blocks::{Loop, Outline, Part, Solid};

/// A box with its upright edges rounded.
fn slab(from: [f64; 3], to: [f64; 3], radius: f64) -> Solid {
    let [x, y, z] = from;
    let corners = [[x, y], [to[0], y], [to[0], to[1]], [x, to[1]]];
    let corners = corners.map(|[x, y]| [x, y, radius]);
    Solid::extrude(Outline::new(Loop::rounded(&corners)), to[2] - z).at([0.0, 0.0, z])
}

/// A slot between two points at one ordinate, as a cutter leaves it, cut upwards from a height.
fn slot(from: [f64; 2], length: f64, radius: f64, z: [f64; 2]) -> Solid {
    let [x, y] = from;
    let outline = Loop::path([x, y - radius])
        .line([x + length, y - radius])
        .arc([x + length, y + radius], 1.0)
        .line([x, y + radius])
        .arc([x, y - radius], 1.0);
    Solid::extrude(Outline::new(outline), z[1] - z[0]).at([0.0, 0.0, z[0]])
}

/// A through hole with a conical seat for a screw whose head lies in the plane z = `top`.
fn countersink(at: [f64; 2], hole: f64, head: f64, top: f64, depth: f64) -> Solid {
    let seat = head - hole;
    let profile = [
        [0.0, top - depth],
        [hole, top - depth],
        [hole, top - seat],
        [head + 1.0, top + 1.0],
        [0.0, top + 1.0],
    ];
    Solid::revolve(Outline::new(Loop::polygon(&profile))).at([at[0], at[1], 0.0])
}

pub fn bracket() -> Part {
    // In the plane of x and z, extruded along -y.
    let angle = Loop::rounded(&[
        [0.0, 0.0, 14.0],
        [70.0, 0.0, 0.0],
        [70.0, 8.0, 0.0],
        [8.0, 8.0, 6.0],
        [8.0, 60.0, 0.0],
        [0.0, 60.0, 0.0],
    ]);
    let gusset = Loop::polygon(&[
        [6.0, 6.0],
        [46.0, 6.0],
        [46.0, 10.0],
        [10.0, 46.0],
        [6.0, 46.0],
    ]);
    let upright = |outline: Loop, y: f64, width: f64| {
        Solid::extrude(Outline::new(outline), width)
            .at([0.0, y, 0.0])
            .facing([0.0, -1.0, 0.0], [1.0, 0.0, 0.0])
    };
    let through_wall =
        |y: f64| Solid::rod([-1.0, y, 40.0], 5.0, 12.0).facing([1.0, 0.0, 0.0], [0.0, 1.0, 0.0]);
    Part::new()
        .join(upright(angle, 50.0, 50.0))
        .join(upright(gusset, 28.5, 7.0))
        .cut(through_wall(12.0))
        .cut(through_wall(38.0))
        .cut(countersink([58.0, 12.0], 3.5, 7.0, 8.0, 10.0))
        .cut(countersink([58.0, 38.0], 3.5, 7.0, 8.0, 10.0))
}

pub fn housing() -> Part {
    let arch = Loop::path([-28.0, 5.0])
        .line([28.0, 5.0])
        .line([28.0, 40.0])
        .arc([-28.0, 40.0], 1.0);
    let body = |outline: Loop, y: f64, width: f64| {
        Solid::extrude(Outline::new(outline), width)
            .at([0.0, y, 0.0])
            .facing([0.0, -1.0, 0.0], [1.0, 0.0, 0.0])
    };
    let ring = |radius: f64, y: f64, width: f64| body(Loop::circle([0.0, 40.0], radius), y, width);
    Part::new()
        .join(slab([-60.0, -20.0, 0.0], [60.0, 20.0, 10.0], 8.0))
        .join(body(arch, 15.0, 30.0))
        .join(ring(22.0, 19.0, 38.0))
        .cut(ring(13.0, 20.0, 40.0))
        .cut(ring(17.0, 20.0, 12.0))
        .cut(slot([-49.0, 0.0], 8.0, 4.5, [-1.0, 11.0]))
        .cut(slot([41.0, 0.0], 8.0, 4.5, [-1.0, 11.0]))
        .cut(Solid::rod([0.0, 0.0, 50.0], 3.0, 30.0))
}

pub fn plate() -> Part {
    let corners = [[-40.0, -25.0], [40.0, -25.0], [40.0, 25.0], [-40.0, 25.0]];
    let body = Part::new()
        .join(slab([-50.0, -35.0, 0.0], [50.0, 35.0, 14.0], 10.0))
        .cut(slab([-26.0, -18.0, 6.0], [26.0, 18.0, 20.0], 7.0))
        .join(Solid::rod([0.0, 0.0, 3.0], 9.0, 11.0))
        .cut(Solid::rod([0.0, 0.0, -1.0], 5.0, 20.0));
    corners.into_iter().fold(body, |part, at| {
        part.cut(countersink(at, 3.5, 7.0, 14.0, 16.0))
    })
}

pub fn towers() -> Part {
    Part::new()
        .join(Solid::cuboid([0.0, 0.0, 0.0], [100.0, 60.0, 12.0]))
        .join(Solid::cuboid([10.0, 12.0, 6.0], [38.0, 48.0, 50.0]))
        .join(Solid::cuboid([62.0, 12.0, 6.0], [90.0, 48.0, 50.0]))
        .cut(Solid::rod([50.0, 30.0, -1.0], 6.0, 20.0))
}

pub fn heat_sink() -> Part {
    const FINS: u32 = 16;
    const PITCH: f64 = 6.0;
    const THICKNESS: f64 = 1.6;
    let width = PITCH * f64::from(FINS - 1) + THICKNESS;
    let mut comb = vec![[width, 0.0], [width, 30.0]];
    for fin in (0..FINS).rev() {
        let left = PITCH * f64::from(fin);
        comb.push([left, 30.0]);
        if fin > 0 {
            let valley = left - PITCH + THICKNESS;
            comb.extend([[left, 7.0], [valley, 7.0], [valley, 30.0]]);
        }
    }
    comb.push([0.0, 0.0]);
    let comb = Solid::extrude(Outline::new(Loop::polygon(&comb)), 60.0)
        .facing([0.0, -1.0, 0.0], [1.0, 0.0, 0.0])
        .at([0.0, 60.0, 0.0]);
    let hole = |valley: f64| {
        Solid::rod(
            [PITCH * valley + (PITCH + THICKNESS) / 2.0, 30.0, -1.0],
            2.0,
            10.0,
        )
    };
    Part::new()
        .join(comb)
        .cut(Solid::cuboid([-5.0, 25.0, 7.0], [width + 5.0, 35.0, 40.0]))
        .cut(hole(3.0))
        .cut(hole(11.0))
}

pub fn gear() -> Part {
    const TEETH: u32 = 20;
    let mut rim = Vec::new();
    for tooth in 0..TEETH {
        // Shares of the pitch at which root, flanks and tip begin and end.
        for (share, radius, fillet) in [
            (0.0, 42.0, 1.6),
            (0.24, 42.0, 1.6),
            (0.38, 52.0, 0.0),
            (0.62, 52.0, 0.0),
            (0.76, 42.0, 1.6),
        ] {
            if share > 0.0 {
                let (sin, cos) = libm::sincos(TAU * (f64::from(tooth) + share) / f64::from(TEETH));
                rim.push([radius * cos, radius * sin, fillet]);
            }
        }
    }
    let web = Outline::disc([0.0, 0.0], 34.0).hole(Loop::circle([0.0, 0.0], 15.0));
    Part::new()
        .join(Solid::extrude(Outline::new(Loop::rounded(&rim)), 16.0))
        .cut(Solid::extrude(web.clone(), 5.0).at([0.0, 0.0, 12.0]))
        .cut(Solid::extrude(web, 5.0).at([0.0, 0.0, -1.0]))
        .join(Solid::rod([0.0, 0.0, -4.0], 15.0, 24.0))
        .cut(Solid::rod([0.0, 0.0, -5.0], 9.0, 30.0))
        .cut(Solid::cuboid([4.0, -2.5, -5.0], [11.5, 2.5, 30.0]))
}
