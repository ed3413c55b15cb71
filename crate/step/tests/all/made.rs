//! STEP files for the tests, entity by entity.

use fit4cad_step::{Amount, Document, Import, Options};

/// A file in the making.
pub struct Made {
    lines: Vec<String>,
    /// The context of millimetres and radians.
    pub context: usize,
}

/// x, y, z.
pub type Place = [f64; 3];

impl Default for Made {
    fn default() -> Self {
        Self::new()
    }
}

impl Made {
    pub fn new() -> Self {
        let mut made = Self {
            lines: Vec::new(),
            context: 0,
        };
        let length = made.add("(LENGTH_UNIT() NAMED_UNIT(*) SI_UNIT(.MILLI.,.METRE.))");
        let angle = made.add("(NAMED_UNIT(*) PLANE_ANGLE_UNIT() SI_UNIT($,.RADIAN.))");
        made.context = made.units(length, angle);
        made
    }

    /// Adds an entity; gives its number.
    pub fn add(&mut self, text: &str) -> usize {
        self.lines.push(text.to_owned());
        self.lines.len()
    }

    /// A context of two units.
    pub fn units(&mut self, length: usize, angle: usize) -> usize {
        self.add(&format!(
            "(GEOMETRIC_REPRESENTATION_CONTEXT(3) GLOBAL_UNIT_ASSIGNED_CONTEXT((#{length},#{angle})) REPRESENTATION_CONTEXT('',''))"
        ))
    }

    /// A unit made of another.
    pub fn converted(&mut self, kind: &str, name: &str, value: f64, of: usize) -> usize {
        let measure = self.add(&format!(
            "MEASURE_WITH_UNIT({kind}_MEASURE({value:?}),#{of})"
        ));
        self.add(&format!(
            "(CONVERSION_BASED_UNIT('{name}',#{measure}) {kind}_UNIT() NAMED_UNIT($))"
        ))
    }

    pub fn point(&mut self, [x, y, z]: Place) -> usize {
        self.add(&format!("CARTESIAN_POINT('',({x:?},{y:?},{z:?}))"))
    }

    pub fn direction(&mut self, [x, y, z]: Place) -> usize {
        self.add(&format!("DIRECTION('',({x:?},{y:?},{z:?}))"))
    }

    pub fn frame(&mut self, origin: Place, z: Place, x: Option<Place>) -> usize {
        let (origin, z) = (self.point(origin), self.direction(z));
        let x = x.map_or("$".to_owned(), |x| format!("#{}", self.direction(x)));
        self.add(&format!("AXIS2_PLACEMENT_3D('',#{origin},#{z},{x})"))
    }

    pub fn vertex(&mut self, at: Place) -> usize {
        let point = self.point(at);
        self.add(&format!("VERTEX_POINT('',#{point})"))
    }

    pub fn line(&mut self, from: Place, to: Place) -> usize {
        let way = [to[0] - from[0], to[1] - from[1], to[2] - from[2]];
        let (point, direction) = (self.point(from), self.direction(way));
        let vector = self.add(&format!("VECTOR('',#{direction},1.)"));
        self.add(&format!("LINE('',#{point},#{vector})"))
    }

    pub fn circle(&mut self, centre: Place, z: Place, x: Place, radius: f64) -> usize {
        let frame = self.frame(centre, z, Some(x));
        self.add(&format!("CIRCLE('',#{frame},{radius:?})"))
    }

    pub fn edge(&mut self, from: usize, to: usize, curve: usize, same: bool) -> usize {
        self.add(&format!(
            "EDGE_CURVE('',#{from},#{to},#{curve},{})",
            flag(same)
        ))
    }

    /// A loop of edges, each along its direction or against it.
    pub fn ring(&mut self, edges: &[(usize, bool)]) -> usize {
        let uses: Vec<String> = edges
            .iter()
            .map(|(edge, forward)| {
                format!(
                    "#{}",
                    self.add(&format!("ORIENTED_EDGE('',*,*,#{edge},{})", flag(*forward)))
                )
            })
            .collect();
        self.add(&format!("EDGE_LOOP('',({}))", uses.join(",")))
    }

    pub fn bound(&mut self, ring: usize, orientation: bool) -> usize {
        self.add(&format!("FACE_BOUND('',#{ring},{})", flag(orientation)))
    }

    pub fn face(&mut self, bounds: &[usize], surface: usize, same: bool) -> usize {
        self.add(&format!(
            "ADVANCED_FACE('',({}),#{surface},{})",
            list(bounds),
            flag(same)
        ))
    }

    /// A face within polygons of straight edges: the first around it, the others around holes.
    pub fn polygon(&mut self, surface: usize, rings: &[&[Place]], same: bool) -> usize {
        let mut bounds = Vec::new();
        for ring in rings {
            let corners: Vec<usize> = ring.iter().map(|at| self.vertex(*at)).collect();
            let mut edges = Vec::new();
            for k in 0..ring.len() {
                let next = (k + 1) % ring.len();
                let line = self.line(ring[k], ring[next]);
                edges.push((self.edge(corners[k], corners[next], line, true), true));
            }
            let ring = self.ring(&edges);
            bounds.push(self.bound(ring, true));
        }
        self.face(&bounds, surface, same)
    }

    /// A full circle as a bound.
    pub fn round(
        &mut self,
        centre: Place,
        z: Place,
        x: Place,
        radius: f64,
        forward: bool,
    ) -> usize {
        let start = [0, 1, 2].map(|k| centre[k] + radius * x[k]);
        let (vertex, circle) = (self.vertex(start), self.circle(centre, z, x, radius));
        let edge = self.edge(vertex, vertex, circle, true);
        let ring = self.ring(&[(edge, forward)]);
        self.bound(ring, true)
    }

    /// A representation of items in a context.
    pub fn representation(&mut self, kind: &str, items: &[usize], context: usize) -> usize {
        self.add(&format!("{kind}('',({}),#{context})", list(items)))
    }

    /// An open shell of faces as the only body.
    pub fn shell(&mut self, faces: &[usize]) -> usize {
        let shell = self.add(&format!("OPEN_SHELL('',({}))", list(faces)));
        let model = self.add(&format!("SHELL_BASED_SURFACE_MODEL('',(#{shell}))"));
        let context = self.context;
        self.representation("MANIFOLD_SURFACE_SHAPE_REPRESENTATION", &[model], context)
    }

    /// A product with a shape; gives its definition.
    pub fn product(&mut self, name: &str, representation: usize) -> usize {
        let product = self.add(&format!("PRODUCT('{name}','{name}','',())"));
        let formation = self.add(&format!("PRODUCT_DEFINITION_FORMATION('','',#{product})"));
        let definition = self.add(&format!("PRODUCT_DEFINITION('','',#{formation},$)"));
        let shape = self.add(&format!("PRODUCT_DEFINITION_SHAPE('','',#{definition})"));
        self.add(&format!(
            "SHAPE_DEFINITION_REPRESENTATION(#{shape},#{representation})"
        ));
        definition
    }

    /// The text, with a header.
    pub fn text(&self) -> String {
        let header = "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION((''),'2;1');\nFILE_NAME('made','',(''),(''),'','tests','');\nFILE_SCHEMA(('AUTOMOTIVE_DESIGN'));\nENDSEC;\nDATA;\n";
        let mut text = header.to_owned();
        for (number, line) in self.lines.iter().enumerate() {
            text.push_str(&format!("#{}={line};\n", number + 1));
        }
        text + "ENDSEC;\nEND-ISO-10303-21;\n"
    }

    /// What becomes of it.
    pub fn import(&self) -> Import {
        import(self.text().as_bytes(), &Options::default())
    }
}

/// Imports bytes that can be.
pub fn import(bytes: &[u8], options: &Options) -> Import {
    let document = Document::read(bytes, &mut |_| {}).unwrap();
    let options = Options {
        amount: match options.amount {
            Amount::Share(_) => Amount::Points(2000),
            other => other,
        },
        ..*options
    };
    document.sample("made", &options, &mut |_| {}).unwrap()
}

pub fn flag(value: bool) -> &'static str {
    if value { ".T." } else { ".F." }
}

pub fn list(numbers: &[usize]) -> String {
    let numbers: Vec<String> = numbers.iter().map(|number| format!("#{number}")).collect();
    numbers.join(",")
}

/// Whether a value is near another, to a share of it.
pub fn near(found: f64, expected: f64, share: f64) -> bool {
    (found - expected).abs() <= share * expected.abs()
}
