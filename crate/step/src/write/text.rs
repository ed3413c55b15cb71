//! The text of a STEP file, entity by entity.

use fit4cad::cloud::{Point, Vector};

use super::Colour;
use super::outline::Loop;
use crate::geometry::shape::Shape;
use crate::placement::Frame;

/// A file in the making.
pub(super) struct Text {
    name: String,
    data: String,
    count: usize,
    faces: Vec<usize>,
    styles: Vec<usize>,
}

impl Text {
    pub fn new(name: &str) -> Self {
        Self {
            name: quoted(name),
            data: String::new(),
            count: 0,
            faces: Vec::new(),
            styles: Vec::new(),
        }
    }

    fn add(&mut self, entity: &str) -> usize {
        self.count += 1;
        self.data.push_str(&format!("#{}={entity};\n", self.count));
        self.count
    }

    fn point(&mut self, at: &Point) -> usize {
        let [x, y, z] = [at.x, at.y, at.z].map(real);
        self.add(&format!("CARTESIAN_POINT('',({x},{y},{z}))"))
    }

    fn direction(&mut self, along: &Vector) -> usize {
        let [x, y, z] = [along.x, along.y, along.z].map(real);
        self.add(&format!("DIRECTION('',({x},{y},{z}))"))
    }

    fn frame(&mut self, frame: &Frame) -> usize {
        let origin = self.point(&frame.origin);
        let (z, x) = (self.direction(&frame.z), self.direction(&frame.x));
        self.add(&format!("AXIS2_PLACEMENT_3D('',#{origin},#{z},#{x})"))
    }

    fn vertex(&mut self, at: &Point) -> usize {
        let point = self.point(at);
        self.add(&format!("VERTEX_POINT('',#{point})"))
    }

    /// Adds a face within loops; the whole surface where there are none.
    pub fn face(&mut self, shape: &Shape, loops: &[Loop], name: &str, colour: Colour) {
        let surface = self.surface(shape);
        let mut bounds = Vec::new();
        for corners in loops {
            let ring = self.ring(shape, corners);
            bounds.push(self.add(&format!("FACE_BOUND('',#{ring},.T.)")));
        }
        if bounds.is_empty() {
            let [_, along] = shape.axes();
            let at = shape.at([0.0, along.range[1]]).0;
            let vertex = self.vertex(&at);
            let ring = self.add(&format!("VERTEX_LOOP('',#{vertex})"));
            bounds.push(self.add(&format!("FACE_BOUND('',#{ring},.T.)")));
        }
        let bounds = list(&bounds);
        let face = self.add(&format!(
            "ADVANCED_FACE('{}',({bounds}),#{surface},.T.)",
            quoted(name)
        ));
        self.faces.push(face);
        self.paint(face, colour);
    }

    fn surface(&mut self, shape: &Shape) -> usize {
        match shape {
            Shape::Cylinder(frame, radius) => {
                let frame = self.frame(frame);
                self.add(&format!(
                    "CYLINDRICAL_SURFACE('',#{frame},{})",
                    real(*radius)
                ))
            }
            Shape::Cone(frame, angle) => {
                let frame = self.frame(frame);
                self.add(&format!("CONICAL_SURFACE('',#{frame},0.,{})", real(*angle)))
            }
            Shape::Sphere(frame, radius) => {
                let frame = self.frame(frame);
                self.add(&format!("SPHERICAL_SURFACE('',#{frame},{})", real(*radius)))
            }
            Shape::Torus(ring) => {
                let frame = self.frame(&ring.frame);
                let radii = format!("{},{}", real(ring.major), real(ring.minor));
                if ring.minor > ring.major {
                    let outer = if ring.inner { ".F." } else { ".T." };
                    return self.add(&format!(
                        "DEGENERATE_TOROIDAL_SURFACE('',#{frame},{radii},{outer})"
                    ));
                }
                self.add(&format!("TOROIDAL_SURFACE('',#{frame},{radii})"))
            }
            Shape::Plane(frame) => {
                let frame = self.frame(frame);
                self.add(&format!("PLANE('',#{frame})"))
            }
            // Only surfaces of the five families are written.
            _ => self.add("SURFACE('')"),
        }
    }

    /// A loop through corners, along one coordinate from each to the next.
    fn ring(&mut self, shape: &Shape, corners: &Loop) -> usize {
        let places: Vec<Point> = corners.iter().map(|at| shape.at(*at).0).collect();
        let vertices: Vec<usize> = places.iter().map(|at| self.vertex(at)).collect();
        let mut uses = Vec::new();
        for k in 0..corners.len() {
            let next = (k + 1) % corners.len();
            let (from, to) = (corners[k], corners[next]);
            // At a pole a way along the first coordinate goes nowhere.
            let size = 1.0 + places[k].coords.norm();
            if (places[k] - places[next]).norm() <= 1e-12 * size {
                continue;
            }
            let curve = self.curve(shape, from, to, &places[k], &places[next]);
            let (a, b) = (vertices[k], vertices[next]);
            let edge = self.add(&format!("EDGE_CURVE('',#{a},#{b},#{curve},.T.)"));
            uses.push(self.add(&format!("ORIENTED_EDGE('',*,*,#{edge},.T.)")));
        }
        let uses = list(&uses);
        self.add(&format!("EDGE_LOOP('',({uses}))"))
    }

    /// The line or circle along one coordinate, in its direction.
    fn curve(
        &mut self,
        shape: &Shape,
        from: [f64; 2],
        to: [f64; 2],
        start: &Point,
        end: &Point,
    ) -> usize {
        let along_first = from[1] == to[1];
        let circle = match shape {
            Shape::Cylinder(frame, radius) if along_first => {
                Some((frame.leave([0.0, 0.0, from[1]]), frame.z, *radius))
            }
            Shape::Cone(frame, angle) if along_first => {
                let radius = from[1] * libm::tan(*angle);
                Some((frame.leave([0.0, 0.0, from[1]]), frame.z, radius))
            }
            Shape::Sphere(frame, radius) => {
                Some(ring_circle(frame, 0.0, *radius, from, along_first))
            }
            Shape::Torus(ring) => Some(ring_circle(
                &ring.frame,
                ring.major,
                ring.minor,
                from,
                along_first,
            )),
            _ => None,
        };
        let Some((centre, axis, radius)) = circle else {
            let way = end - start;
            let (point, direction) = (self.point(start), self.direction(&(way / way.norm())));
            let vector = self.add(&format!("VECTOR('',#{direction},1.)"));
            return self.add(&format!("LINE('',#{point},#{vector})"));
        };
        let k = usize::from(!along_first);
        // A coordinate that first goes on across a border comes back by the shorter way.
        let step = to[k] - from[k];
        let step = if step.abs() > std::f64::consts::PI {
            -step
        } else {
            step
        };
        let axis = if step < 0.0 { -axis } else { axis };
        let origin = self.point(&centre);
        let (z, x) = (
            self.direction(&axis),
            self.direction(&((start - centre) / radius)),
        );
        let frame = self.add(&format!("AXIS2_PLACEMENT_3D('',#{origin},#{z},#{x})"));
        self.add(&format!("CIRCLE('',#{frame},{})", real(radius)))
    }

    /// Gives a face its colour.
    fn paint(&mut self, face: usize, [red, green, blue]: Colour) {
        let (red, green, blue) = (real(red), real(green), real(blue));
        let colour = self.add(&format!("COLOUR_RGB('',{red},{green},{blue})"));
        let fill = self.add(&format!("FILL_AREA_STYLE_COLOUR('',#{colour})"));
        let fill = self.add(&format!("FILL_AREA_STYLE('',(#{fill}))"));
        let fill = self.add(&format!("SURFACE_STYLE_FILL_AREA(#{fill})"));
        let side = self.add(&format!("SURFACE_SIDE_STYLE('',(#{fill}))"));
        let usage = self.add(&format!("SURFACE_STYLE_USAGE(.BOTH.,#{side})"));
        let style = self.add(&format!("PRESENTATION_STYLE_ASSIGNMENT((#{usage}))"));
        let styled = self.add(&format!("STYLED_ITEM('',(#{style}),#{face})"));
        self.styles.push(styled);
    }

    /// The whole file.
    pub fn finish(mut self) -> String {
        let length = self.add("(LENGTH_UNIT() NAMED_UNIT(*) SI_UNIT(.MILLI.,.METRE.))");
        let angle = self.add("(NAMED_UNIT(*) PLANE_ANGLE_UNIT() SI_UNIT($,.RADIAN.))");
        let solid = self.add("(NAMED_UNIT(*) SI_UNIT($,.STERADIAN.) SOLID_ANGLE_UNIT())");
        let exact = self.add(&format!(
            "UNCERTAINTY_MEASURE_WITH_UNIT(LENGTH_MEASURE(1.E-6),#{length},'distance_accuracy_value','')"
        ));
        let context = self.add(&format!(
            "(GEOMETRIC_REPRESENTATION_CONTEXT(3) GLOBAL_UNCERTAINTY_ASSIGNED_CONTEXT((#{exact})) \
             GLOBAL_UNIT_ASSIGNED_CONTEXT((#{length},#{angle},#{solid})) REPRESENTATION_CONTEXT('',''))"
        ));
        let name = self.name.clone();
        let (faces, styles) = (list(&self.faces), list(&self.styles));
        let shell = self.add(&format!("OPEN_SHELL('',({faces}))"));
        let model = self.add(&format!("SHELL_BASED_SURFACE_MODEL('{name}',(#{shell}))"));
        let shape = self.add(&format!(
            "MANIFOLD_SURFACE_SHAPE_REPRESENTATION('{name}',(#{model}),#{context})"
        ));
        self.add(&format!(
            "MECHANICAL_DESIGN_GEOMETRIC_PRESENTATION_REPRESENTATION('',({styles}),#{context})"
        ));
        let application =
            self.add("APPLICATION_CONTEXT('core data for automotive mechanical design processes')");
        self.add(&format!(
            "APPLICATION_PROTOCOL_DEFINITION('international standard','automotive_design',2000,#{application})"
        ));
        let of_product = self.add(&format!("PRODUCT_CONTEXT('',#{application},'mechanical')"));
        let product = self.add(&format!("PRODUCT('{name}','{name}','',(#{of_product}))"));
        let formation = self.add(&format!("PRODUCT_DEFINITION_FORMATION('','',#{product})"));
        let of_definition = self.add(&format!(
            "PRODUCT_DEFINITION_CONTEXT('part definition',#{application},'design')"
        ));
        let definition = self.add(&format!(
            "PRODUCT_DEFINITION('','',#{formation},#{of_definition})"
        ));
        let definition = self.add(&format!("PRODUCT_DEFINITION_SHAPE('','',#{definition})"));
        self.add(&format!(
            "SHAPE_DEFINITION_REPRESENTATION(#{definition},#{shape})"
        ));
        let header = format!(
            "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION(('Primitives of a point cloud'),'2;1');\n\
             FILE_NAME('{name}','',(''),(''),'fit4cad {}','fit4cad','');\n\
             FILE_SCHEMA(('AUTOMOTIVE_DESIGN {{ 1 0 10303 214 1 1 1 1 }}'));\nENDSEC;\nDATA;\n",
            env!("CARGO_PKG_VERSION")
        );
        header + &self.data + "ENDSEC;\nEND-ISO-10303-21;\n"
    }
}

/// The circle along a coordinate of a sphere or torus: centre, axis and radius.
fn ring_circle(
    frame: &Frame,
    major: f64,
    minor: f64,
    [u, v]: [f64; 2],
    along_first: bool,
) -> (Point, Vector, f64) {
    if along_first {
        let (sin, cos) = libm::sincos(v);
        return (
            frame.leave([0.0, 0.0, minor * sin]),
            frame.z,
            major + minor * cos,
        );
    }
    let (sin, cos) = libm::sincos(u);
    let outward = frame.vector([cos, sin, 0.0]);
    // Turning from outward towards the axis' direction.
    (
        frame.origin + outward * major,
        outward.cross(&frame.z),
        minor,
    )
}

/// A number as STEP writes them: with a point.
fn real(value: f64) -> String {
    let text = if value == 0.0 || (1e-5..1e16).contains(&value.abs()) {
        format!("{value:?}")
    } else {
        format!("{value:E}")
    };
    if text.contains('.') {
        return text;
    }
    match text.split_once('E') {
        Some((digits, exponent)) => format!("{digits}.E{exponent}"),
        None => text + ".",
    }
}

fn list(numbers: &[usize]) -> String {
    let numbers: Vec<String> = numbers.iter().map(|number| format!("#{number}")).collect();
    numbers.join(",")
}

/// A text between quotes: beyond ASCII by the numbers of its characters.
fn quoted(text: &str) -> String {
    let mut written = String::new();
    for character in text.chars() {
        match character {
            '\'' => written.push_str("''"),
            '\\' => written.push_str("\\\\"),
            ' '..='~' => written.push(character),
            _ if character.is_control() => {}
            _ => written.push_str(&format!("\\X4\\{:08X}\\X0\\", u32::from(character))),
        }
    }
    written
}
