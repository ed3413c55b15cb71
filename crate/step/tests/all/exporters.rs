//! What exporters write: every kind of surface, curve and bound, with areas in closed form.

use std::f64::consts::PI;

use crate::made::{Made, import, near};
use fit4cad::surface::{Surface, SurfaceType};
use fit4cad_step::{Document, Import, Options};

const X: [f64; 3] = [1.0, 0.0, 0.0];
const Y: [f64; 3] = [0.0, 1.0, 0.0];
const Z: [f64; 3] = [0.0, 0.0, 1.0];
const O: [f64; 3] = [0.0; 3];

fn kinds(import: &Import) -> Vec<Option<SurfaceType>> {
    import.report.faces.iter().map(|face| face.kind).collect()
}

/// Every point on its surface, and no remark on any face.
fn check(import: &Import, area: f64) {
    let remarks: Vec<&str> = import
        .report
        .faces
        .iter()
        .map(|face| &face.remark[..])
        .collect();
    assert!(remarks.iter().all(|it| it.is_empty()), "{remarks:?}");
    assert!(
        near(import.report.area, area, 1e-4),
        "area {} not {area}",
        import.report.area
    );
    let points = import.model.cloud.points();
    for primitive in &import.model.truth.as_ref().unwrap().primitives {
        let surface = primitive.surface.unwrap();
        for &index in &primitive.points {
            assert!(surface.distance(&points[index as usize]) < 1e-9);
        }
    }
}

#[test]
fn a_plate_with_a_hole_whichever_way_face_and_bounds_are_turned() {
    for same in [true, false] {
        let mut made = Made::new();
        let frame = made.frame([0.0, 0.0, 2.0], Z, Some(X));
        let plane = made.add(&format!("PLANE('',#{frame})"));
        let outer = [
            [0.0, 0.0, 2.0],
            [10.0, 0.0, 2.0],
            [10.0, 8.0, 2.0],
            [0.0, 8.0, 2.0],
        ];
        let inner = [
            [2.0, 2.0, 2.0],
            [2.0, 4.0, 2.0],
            [4.0, 4.0, 2.0],
            [4.0, 2.0, 2.0],
        ];
        let face = made.polygon(plane, &[&outer, &inner], same);
        made.shell(&[face]);
        let found = made.import();
        check(&found, 76.0);
        let hole =
            |p: &fit4cad::cloud::Point| (2.0..4.0).contains(&p.x) && (2.0..4.0).contains(&p.y);
        assert!(!found.model.cloud.points().iter().any(hole));
    }
}

#[test]
fn spheres_without_bounds_of_one_vertex_or_two_circles() {
    let mut made = Made::new();
    let frame = made.frame([1.0, 0.0, 0.0], [0.0, 1.0, 1.0], None);
    let surface = made.add(&format!("SPHERICAL_SURFACE('',#{frame},3.)"));
    let whole = made.face(&[], surface, true);
    made.shell(&[whole]);
    check(&made.import(), 36.0 * PI);

    let mut made = Made::new();
    let frame = made.frame(O, Z, Some(X));
    let surface = made.add(&format!("SPHERICAL_SURFACE('',#{frame},5.)"));
    // The zone between latitudes at heights -3 and 4, material to the left of both circles.
    let low = made.round([0.0, 0.0, -3.0], Z, X, 4.0, true);
    let high = made.round([0.0, 0.0, 4.0], Z, X, 3.0, false);
    let zone = made.face(&[low, high], surface, true);
    made.shell(&[zone]);
    check(&made.import(), 2.0 * PI * 5.0 * 7.0);

    // The cap above, and all but the cap: the same circle in the other direction.
    for (forward, height) in [(true, 1.0), (false, 9.0)] {
        let mut made = Made::new();
        let frame = made.frame(O, Z, Some(X));
        let surface = made.add(&format!("SPHERICAL_SURFACE('',#{frame},5.)"));
        let bound = made.round([0.0, 0.0, 4.0], Z, X, 3.0, forward);
        let cap = made.face(&[bound], surface, true);
        made.shell(&[cap]);
        check(&made.import(), 2.0 * PI * 5.0 * height);
    }
}

#[test]
fn a_great_circle_through_both_poles_cuts_a_sphere_in_halves() {
    let mut made = Made::new();
    let frame = made.frame(O, Z, Some(X));
    let surface = made.add(&format!("SPHERICAL_SURFACE('',#{frame},5.)"));
    let bound = made.round(O, X, Y, 5.0, true);
    let half = made.face(&[bound], surface, true);
    made.shell(&[half]);
    let found = made.import();
    check(&found, 50.0 * PI);
    // The left of a circle about x, seen from outside, is where x is greater.
    assert!(
        found
            .model
            .cloud
            .points()
            .iter()
            .all(|point| point.x > -1e-3)
    );
}

#[test]
fn a_cone_to_its_apex_on_either_nappe() {
    for down in [false, true] {
        let mut made = Made::new();
        let frame = made.frame(O, Z, Some(X));
        let angle = 0.5_f64.atan();
        // Apex at -4; of the nappe behind it the file says nothing but where the edges are.
        let surface = made.add(&format!("CONICAL_SURFACE('',#{frame},2.,{angle:?})"));
        let height = if down { -12.0 } else { 4.0 };
        let round = made.round([0.0, 0.0, height], Z, X, 4.0, down);
        let apex = made.vertex([0.0, 0.0, -4.0]);
        let tip = made.add(&format!("VERTEX_LOOP('',#{apex})"));
        let tip = made.bound(tip, true);
        let face = made.face(&[round, tip], surface, true);
        made.shell(&[face]);
        check(&made.import(), PI * 4.0 * 80.0_f64.sqrt());
    }
}

#[test]
fn whole_tori_and_both_halves_of_one_that_meets_itself() {
    let mut made = Made::new();
    let frame = made.frame(O, Z, Some(X));
    let surface = made.add(&format!("TOROIDAL_SURFACE('',#{frame},10.,3.)"));
    let face = made.face(&[], surface, true);
    made.shell(&[face]);
    check(&made.import(), 4.0 * PI * PI * 30.0);

    let pole = (-3.0_f64 / 5.0).acos();
    let apple = 4.0 * PI * 5.0 * (3.0 * pole + 5.0 * pole.sin());
    let lemon = 4.0 * PI * 5.0 * (5.0 * pole.sin() - 3.0 * (PI - pole));
    for (outer, area) in [(true, apple), (false, lemon)] {
        let mut made = Made::new();
        let frame = made.frame(O, Z, Some(X));
        let surface = made.add(&format!(
            "DEGENERATE_TOROIDAL_SURFACE('',#{frame},3.,5.,{})",
            crate::made::flag(outer)
        ));
        let face = made.face(&[], surface, true);
        made.shell(&[face]);
        check(&made.import(), area);
    }
}

/// A seam is used in both directions; where it lies tells what is inside, even of a fillet whose bound
/// is turned the wrong way, as Open Cascade writes them.
#[test]
fn a_seam_lies_within_its_face_whatever_the_bound_says() {
    for orientation in [true, false] {
        let mut made = Made::new();
        let frame = made.frame(O, Z, Some(X));
        let surface = made.add(&format!("TOROIDAL_SURFACE('',#{frame},6.5,1.5)"));
        let (a, b) = (made.vertex([8.0, 0.0, 0.0]), made.vertex([6.5, 0.0, 1.5]));
        let low = made.circle(O, Z, X, 8.0);
        let high = made.circle([0.0, 0.0, 1.5], Z, X, 6.5);
        let seam = made.circle([6.5, 0.0, 0.0], [0.0, -1.0, 0.0], X, 1.5);
        let (low, high) = (made.edge(a, a, low, true), made.edge(b, b, high, true));
        let seam = made.edge(a, b, seam, true);
        let ring = made.ring(&[(low, true), (seam, true), (high, false), (seam, false)]);
        let bound = made.bound(ring, orientation);
        let face = made.face(&[bound], surface, true);
        made.shell(&[face]);
        check(&made.import(), 2.0 * PI * 1.5 * (6.5 * PI / 2.0 + 1.5));
    }
}

/// A strip that winds about a cylinder four times, its edges splines along the way.
#[test]
fn a_strip_that_winds_about_a_cylinder() {
    let mut made = Made::new();
    let frame = made.frame(O, Z, Some(X));
    let surface = made.add(&format!("CYLINDRICAL_SURFACE('',#{frame},5.)"));
    let at = |turns: f64, lift: f64| {
        let angle = 2.0 * PI * turns;
        [5.0 * angle.cos(), 5.0 * angle.sin(), 2.0 * turns + lift]
    };
    let mut edges = Vec::new();
    let corners = [(0.0, 0.0), (4.0, 0.0), (4.0, 0.7), (0.0, 0.7)];
    let vertices = corners.map(|(turns, lift)| made.vertex(at(turns, lift)));
    for k in 0..4 {
        let ((t0, l0), (t1, l1)) = (corners[k], corners[(k + 1) % 4]);
        let curve = if t0 == t1 {
            made.line(at(t0, l0), at(t1, l1))
        } else {
            let places: Vec<usize> = (0..=4000)
                .map(|i| t0 + (t1 - t0) * f64::from(i) / 4000.0)
                .map(|turns| made.point(at(turns, l0)))
                .collect();
            made.add(&format!("POLYLINE('',({}))", crate::made::list(&places)))
        };
        edges.push((
            made.edge(vertices[k], vertices[(k + 1) % 4], curve, true),
            true,
        ));
    }
    let ring = made.ring(&edges);
    let bound = made.bound(ring, true);
    let face = made.face(&[bound], surface, true);
    made.shell(&[face]);
    check(&made.import(), 2.0 * PI * 4.0 * 5.0 * 0.7);
}

#[test]
fn lines_and_circles_that_are_swept_are_of_the_five_families() {
    let mut made = Made::new();
    let axis_at = made.point(O);
    let up = made.direction(Z);
    let axis = made.add(&format!("AXIS1_PLACEMENT('',#{axis_at},#{up})"));
    let bounds = |made: &mut Made, low: (f64, f64), high: (f64, f64)| {
        [low, high].map(|(z, radius)| made.round([0.0, 0.0, z], Z, X, radius, true))
    };
    let upright = made.line([3.0, 0.0, 0.0], [3.0, 0.0, 1.0]);
    let askew = made.line([2.0, 0.0, 0.0], [3.0, 0.0, 2.0]);
    let arc = made.circle([6.0, 0.0, 0.0], [0.0, -1.0, 0.0], X, 2.0);
    let flat = made.circle(O, Z, X, 4.0);
    let vector = made.add(&format!("VECTOR('',#{up},7.)"));
    let mut faces = Vec::new();
    let cylinder = made.add(&format!("SURFACE_OF_REVOLUTION('',#{upright},#{axis})"));
    let ends = bounds(&mut made, (0.0, 3.0), (5.0, 3.0));
    faces.push(made.face(&ends, cylinder, true));
    let cone = made.add(&format!("SURFACE_OF_REVOLUTION('',#{askew},#{axis})"));
    let ends = bounds(&mut made, (0.0, 2.0), (2.0, 3.0));
    faces.push(made.face(&ends, cone, true));
    let torus = made.add(&format!("SURFACE_OF_REVOLUTION('',#{arc},#{axis})"));
    faces.push(made.face(&[], torus, true));
    let extruded = made.add(&format!(
        "SURFACE_OF_LINEAR_EXTRUSION('',#{flat},#{vector})"
    ));
    let ends = bounds(&mut made, (1.0, 4.0), (2.0, 4.0));
    faces.push(made.face(&ends, extruded, true));
    made.shell(&faces);
    let found = made.import();
    let expected = 30.0 * PI + PI * 5.0 * 5.0_f64.sqrt() + 4.0 * PI * PI * 12.0 + 8.0 * PI;
    check(&found, expected);
    use SurfaceType::{Cone, Cylinder, Torus};
    assert_eq!(
        kinds(&found),
        [Some(Cylinder), Some(Cone), Some(Torus), Some(Cylinder)]
    );
    assert!(found.report.faces.iter().all(|face| face.recognised));
    // Who does not want them recognised has them unsegmented.
    let options = Options {
        recognise: false,
        ..Options::default()
    };
    let plain = import(made.text().as_bytes(), &options);
    assert!(kinds(&plain).iter().all(Option::is_none));
    assert!(plain.model.truth.unwrap().primitives.is_empty());
}

/// An eighth of a sphere: a circle turned about an axis through its centre, whose half about zero runs up
/// or down the sphere. Turned over, its normal points inwards, and the bounds say so.
#[test]
fn a_sphere_swept_by_a_circle_keeps_the_side_of_its_normal() {
    for (side, same) in [(1.0, true), (-1.0, false)] {
        let mut made = Made::new();
        let (origin, up) = (made.point(O), made.direction(Z));
        let axis = made.add(&format!("AXIS1_PLACEMENT('',#{origin},#{up})"));
        let circle = made.circle(O, [0.0, -1.0, 0.0], [side, 0.0, 0.0], 2.0);
        let surface = made.add(&format!("SURFACE_OF_REVOLUTION('',#{circle},#{axis})"));
        let corners = [[2.0, 0.0, 0.0], [0.0, 2.0, 0.0], [0.0, 0.0, 2.0]];
        let vertices = corners.map(|at| made.vertex(at));
        let mut edges = Vec::new();
        for (k, (normal, first)) in [(Z, X), (X, Y), (Y, Z)].into_iter().enumerate() {
            let arc = made.circle(O, normal, first, 2.0);
            edges.push((
                made.edge(vertices[k], vertices[(k + 1) % 3], arc, true),
                true,
            ));
        }
        let ring = made.ring(&edges);
        let bound = made.bound(ring, true);
        let face = made.face(&[bound], surface, same);
        made.shell(&[face]);
        check(&made.import(), 2.0 * PI);
    }
}

/// A circle that cuts the axis it is turned about, its zero within: the lemon, tip to tip.
#[test]
fn a_circle_that_cuts_its_axis_sweeps_the_part_about_its_zero() {
    let mut made = Made::new();
    let (origin, up) = (made.point(O), made.direction(Z));
    let axis = made.add(&format!("AXIS1_PLACEMENT('',#{origin},#{up})"));
    let circle = made.circle([-3.0, 0.0, 0.0], [0.0, -1.0, 0.0], X, 5.0);
    let surface = made.add(&format!("SURFACE_OF_REVOLUTION('',#{circle},#{axis})"));
    let tip = made.vertex([0.0, 0.0, 4.0]);
    let ring = made.add(&format!("VERTEX_LOOP('',#{tip})"));
    let bound = made.bound(ring, true);
    let face = made.face(&[bound], surface, true);
    made.shell(&[face]);
    let half = 0.8_f64.asin();
    check(&made.import(), 20.0 * PI * (4.0 - 3.0 * half));
}

/// Half a torus, cut across its tube: both bounds run along the columns, and no column crosses one.
#[test]
fn a_torus_cut_across_its_tube_is_the_half_to_the_left() {
    for first in [X, [0.6, 0.8, 0.0]] {
        for forward in [true, false] {
            let mut made = Made::new();
            let frame = made.frame(O, Z, Some(first));
            let surface = made.add(&format!("TOROIDAL_SURFACE('',#{frame},10.,3.)"));
            // Seen from outside, both run with smaller y on their left.
            let near = made.round([10.0, 0.0, 0.0], [0.0, -1.0, 0.0], X, 3.0, !forward);
            let far = made.round([-10.0, 0.0, 0.0], [0.0, -1.0, 0.0], X, 3.0, !forward);
            let face = made.face(&[near, far], surface, true);
            made.shell(&[face]);
            let found = made.import();
            check(&found, 2.0 * PI * PI * 30.0);
            let side = if forward { 1.0 } else { -1.0 };
            let points = found.model.cloud.points();
            assert!(points.iter().all(|point| side * point.y > -1e-3));
        }
    }
}

/// A curve with a kink a hundredth of the way along it: areas are summed up piece by piece.
#[test]
fn areas_of_swept_curves_are_exact_however_uneven_their_knots_are() {
    let mut made = Made::new();
    let (origin, up) = (made.point(O), made.direction(Z));
    let axis = made.add(&format!("AXIS1_PLACEMENT('',#{origin},#{up})"));
    let points = [[5.0, 0.0, 0.0], [9.0, 0.0, 0.0], [8.0, 0.0, 10.0]].map(|at| made.point(at));
    let curve = made.add(&format!(
        "B_SPLINE_CURVE_WITH_KNOTS('',1,({}),.UNSPECIFIED.,.F.,.F.,(2,1,2),(0.,0.01,1.),.UNSPECIFIED.)",
        crate::made::list(&points)
    ));
    let surface = made.add(&format!("SURFACE_OF_REVOLUTION('',#{curve},#{axis})"));
    let low = made.round(O, Z, X, 5.0, false);
    let high = made.round([0.0, 0.0, 10.0], Z, X, 8.0, true);
    let face = made.face(&[low, high], surface, true);
    made.shell(&[face]);
    check(&made.import(), PI * (56.0 + 17.0 * 101.0_f64.sqrt()));
}

/// A quarter of a cylinder as a rational surface, written part by part; its edges are trimmed and
/// composite curves.
#[test]
fn a_rational_spline_is_recognised_as_a_cylinder() {
    let mut made = Made::new();
    let rows = [[4.0, 0.0], [4.0, 4.0], [0.0, 4.0]].map(|[x, y]| {
        let points = [0.0, 6.0].map(|z| made.point([x, y, z]));
        format!("({})", crate::made::list(&points))
    });
    let w = 0.5_f64.sqrt();
    let surface = made.add(&format!(
        "(BOUNDED_SURFACE() B_SPLINE_SURFACE(2,1,({}),.UNSPECIFIED.,.F.,.F.,.F.) \
         B_SPLINE_SURFACE_WITH_KNOTS((3,3),(2,2),(0.,1.),(0.,1.),.UNSPECIFIED.) \
         GEOMETRIC_REPRESENTATION_ITEM() RATIONAL_B_SPLINE_SURFACE(((1.,1.),({w:?},{w:?}),(1.,1.))) \
         REPRESENTATION_ITEM('') SURFACE())",
        rows.join(",")
    ));
    let corners = [
        [4.0, 0.0, 0.0],
        [0.0, 4.0, 0.0],
        [0.0, 4.0, 6.0],
        [4.0, 0.0, 6.0],
    ];
    let vertices = corners.map(|at| made.vertex(at));
    let circles = [0.0, 6.0].map(|z| made.circle([0.0, 0.0, z], Z, X, 4.0));
    let ends = [made.point(corners[0]), made.point(corners[1])];
    let trimmed = made.add(&format!(
        "TRIMMED_CURVE('',#{},(#{},PARAMETER_VALUE(0.)),(#{},PARAMETER_VALUE(1.5707963267948966)),.T.,.CARTESIAN.)",
        circles[0], ends[0], ends[1]
    ));
    let segment = made.add(&format!(
        "COMPOSITE_CURVE_SEGMENT(.DISCONTINUOUS.,.T.,#{trimmed})"
    ));
    let low = made.add(&format!("COMPOSITE_CURVE('',(#{segment}),.F.)"));
    let right = made.line(corners[1], corners[2]);
    let left = made.line(corners[3], corners[0]);
    let high = made.add(&format!("SURFACE_CURVE('',#{},(),.CURVE_3D.)", circles[1]));
    let edges = [
        (made.edge(vertices[0], vertices[1], low, true), true),
        (made.edge(vertices[1], vertices[2], right, true), true),
        // Against its curve: the circle runs the other way.
        (made.edge(vertices[2], vertices[3], high, false), true),
        (made.edge(vertices[3], vertices[0], left, true), true),
    ];
    let ring = made.ring(&edges);
    let bound = made.bound(ring, true);
    let face = made.face(&[bound], surface, true);
    made.shell(&[face]);
    let found = made.import();
    check(&found, 2.0 * PI * 6.0);
    assert_eq!(kinds(&found), [Some(SurfaceType::Cylinder)]);
    let Some(Surface::Cylinder(cylinder)) = found.model.truth.unwrap().primitives[0].surface else {
        panic!("no cylinder");
    };
    assert!((cylinder.radius - 4.0).abs() < 1e-9, "{}", cylinder.radius);
}

/// Bézier surfaces write no knots; this one bends, and stays unsegmented.
#[test]
fn a_free_form_face_has_points_and_no_primitive() {
    let mut made = Made::new();
    let rows: Vec<String> = (0..4)
        .map(|i| {
            let points: Vec<usize> = (0..4)
                .map(|j| made.point([f64::from(i), f64::from(j), f64::from((i * j) % 3)]))
                .collect();
            format!("({})", crate::made::list(&points))
        })
        .collect();
    let surface = made.add(&format!(
        "BEZIER_SURFACE('',3,3,({}),.UNSPECIFIED.,.F.,.F.,.F.)",
        rows.join(",")
    ));
    let face = made.face(&[], surface, true);
    made.shell(&[face]);
    let found = made.import();
    assert_eq!(kinds(&found), [None]);
    assert_eq!(found.report.faces[0].points, found.model.cloud.len());
    assert!(
        found.report.area > 9.0 && found.report.area < 20.0,
        "{}",
        found.report.area
    );
}

#[test]
fn a_surface_at_a_distance_from_another_is_there() {
    let mut made = Made::new();
    let frame = made.frame(O, Z, Some(X));
    let basis = made.add(&format!("CYLINDRICAL_SURFACE('',#{frame},5.)"));
    let surface = made.add(&format!("OFFSET_SURFACE('',#{basis},-1.,.F.)"));
    let ends = [0.0, 3.0].map(|z| made.round([0.0, 0.0, z], Z, X, 4.0, true));
    let face = made.face(&ends, surface, true);
    made.shell(&[face]);
    check(&made.import(), 24.0 * PI);
}

/// A cube of polygons without edges.
#[test]
fn a_faceted_solid_has_plane_faces() {
    let mut made = Made::new();
    let corner = |k: usize| [0, 1, 2].map(|axis| if k >> axis & 1 == 1 { 2.0 } else { 0.0 });
    let points: Vec<usize> = (0..8).map(|k| made.point(corner(k))).collect();
    let sides = [
        [0, 2, 3, 1],
        [4, 5, 7, 6],
        [0, 1, 5, 4],
        [2, 6, 7, 3],
        [0, 4, 6, 2],
        [1, 3, 7, 5],
    ];
    let normals = [
        [0.0, 0.0, -1.0],
        Z,
        [0.0, -1.0, 0.0],
        Y,
        [-1.0, 0.0, 0.0],
        X,
    ];
    let mut faces = Vec::new();
    for (side, normal) in sides.iter().zip(normals) {
        let ring: Vec<usize> = side.iter().map(|&k| points[k]).collect();
        let ring = made.add(&format!("POLY_LOOP('',({}))", crate::made::list(&ring)));
        let bound = made.add(&format!("FACE_OUTER_BOUND('',#{ring},.T.)"));
        let frame = made.frame(corner(side[0]), normal, None);
        let plane = made.add(&format!("PLANE('',#{frame})"));
        faces.push(made.add(&format!("FACE_SURFACE('',(#{bound}),#{plane},.T.)")));
    }
    let shell = made.add(&format!("CLOSED_SHELL('',({}))", crate::made::list(&faces)));
    let solid = made.add(&format!("FACETED_BREP('',#{shell})"));
    let context = made.context;
    made.representation("FACETED_BREP_SHAPE_REPRESENTATION", &[solid], context);
    check(&made.import(), 24.0);
}

#[test]
fn the_text_may_be_written_in_many_ways() {
    let mut made = Made::new();
    let frame = made.frame(O, Z, Some(X));
    let surface = made.add(&format!(
        "SPHERICAL_SURFACE('\\X2\\00C400DF\\X0\\ it''s',#{frame},1.E0)"
    ));
    let face = made.face(&[], surface, true);
    made.shell(&[face]);
    let text = made.text();
    let windows = text.replace('\n', "\r\n");
    let commented = text.replace(";\n", "; /* a word; or #2=two */\n");
    let tight = text.replace('\n', "");
    let marked = format!("\u{feff}{text}\n\n\0\0");
    let bare = text.replace("FILE_DESCRIPTION((''),'2;1');\n", "").replace(
        "FILE_NAME('made','',(''),(''),'','tests','');\n",
        "FILE_NAME($,$,$,$,$,$,$);\n",
    );
    let small = text
        .replace("1.E0)", "1e+00)")
        .replace("(0.0,0.0,1.0)", "(0,0e0,1e-00)");
    assert_ne!(small, text);
    let named = bare.replace("DATA;", "DATA('',('AUTOMOTIVE_DESIGN'));");
    for text in [
        &text, &windows, &commented, &tight, &marked, &bare, &small, &named,
    ] {
        let document = Document::read(text.as_bytes(), &mut |_| {});
        assert!(document.is_ok(), "{:?}", document.err());
    }
}
