//! Faces, their bounds and edges.

use std::collections::BTreeMap;
use std::rc::Rc;

use fit4cad::cloud::Point;

use super::Reader;
use crate::error::{Got, Trouble};
use crate::geometry::edge::Edge;
use crate::geometry::families::Sided;
use crate::geometry::shape::Shape;

/// A face as the file describes it.
pub(crate) struct Face {
    /// Its surface.
    pub shape: Shape,
    /// Whether its normal is the surface's.
    pub same_sense: bool,
    /// Its bounds, each a loop of edges; one of a single vertex has none.
    pub bounds: Vec<Vec<EdgeUse>>,
}

/// An edge as a bound uses it.
#[derive(Clone)]
pub(crate) struct EdgeUse {
    /// What tells it from others.
    pub key: u64,
    /// The vertices from which and to which the bound runs along it.
    pub vertices: [u64; 2],
    /// Its geometry, from its own start to its own end.
    pub edge: Rc<Edge>,
    /// Whether the bound runs from its start to its end.
    pub forward: bool,
}

impl EdgeUse {
    /// The place at a share of the way of the bound.
    pub fn at(&self, share: f64) -> Point {
        self.edge.at(if self.forward { share } else { 1.0 - share })
    }
}

/// Edges that were read: each is used by two faces.
pub(crate) type Edges = BTreeMap<u64, Got<(Rc<Edge>, [u64; 2])>>;

/// Keys of edges that have no number in the file: sides of polygons.
const NAMELESS: u64 = 1 << 63;

impl Reader<'_> {
    /// The name of the type of a face's surface.
    pub fn surface_name(&self, face: u64) -> String {
        let surface = self
            .file
            .fields(face)
            .and_then(|fields| fields.reference(2));
        let Ok(surface) = surface else {
            return "no surface".to_owned();
        };
        let names: Vec<&str> = self.file.types(surface).collect();
        match &names[..] {
            [one] => (*one).to_owned(),
            many => {
                let named = many
                    .iter()
                    .find(|name| name.starts_with("B_SPLINE_SURFACE"));
                named.map_or_else(|| many.join("+"), |_| "B_SPLINE_SURFACE".to_owned())
            }
        }
    }

    /// Reads a face with its bounds.
    pub fn face(&self, id: u64, edges: &mut Edges) -> Got<Face> {
        let fields = self.file.fields(id)?;
        if self.file.is(id, "ORIENTED_FACE") {
            return self.face(fields.reference(2)?, edges);
        }
        if self.file.is(id, "SUBFACE") {
            return Err(Trouble::new(id, "is a part of a face, which is not read"));
        }
        let Sided { shape, turned } = self.surface(fields.reference(2)?)?;
        let bounds = fields.references(1)?;
        let bounds: Got<Vec<_>> = bounds
            .iter()
            .map(|&bound| self.bound(bound, edges))
            .collect();
        Ok(Face {
            shape,
            same_sense: (fields.flag(3) != Some(false)) != turned,
            bounds: bounds?,
        })
    }

    fn bound(&self, id: u64, edges: &mut Edges) -> Got<Vec<EdgeUse>> {
        let fields = self.file.fields(id)?;
        let ring = fields.reference(1)?;
        let mut uses = self.ring(ring, edges)?;
        if fields.flag(2) == Some(false) {
            uses.reverse();
            for each in &mut uses {
                each.forward = !each.forward;
                each.vertices.reverse();
            }
        }
        Ok(uses)
    }

    fn ring(&self, id: u64, edges: &mut Edges) -> Got<Vec<EdgeUse>> {
        let fields = self.file.fields(id)?;
        if self.file.is(id, "VERTEX_LOOP") {
            return Ok(Vec::new());
        }
        if self.file.is(id, "POLY_LOOP") {
            let corners = fields.references(1)?;
            let places = self.points(&corners)?;
            let sides = (0..corners.len()).map(|k| {
                let next = (k + 1) % corners.len();
                let line = Edge::straight(places[k], places[next]);
                let (from, to) = (corners[k], corners[next]);
                EdgeUse {
                    // Told by its ends: faces of a polyhedron share points, not edges.
                    key: NAMELESS ^ from.min(to).wrapping_mul(0x9e37_79b9_7f4a_7c15) ^ from.max(to),
                    vertices: [from, to],
                    edge: Rc::new(if from <= to {
                        line
                    } else {
                        Edge::straight(places[next], places[k])
                    }),
                    forward: from <= to,
                }
            });
            return Ok(sides.collect());
        }
        if !(self.file.is(id, "EDGE_LOOP") || self.file.is(id, "ORIENTED_PATH")) {
            let name = self.file.name(id);
            return Err(Trouble::new(
                id,
                format!("is {name}, a bound that is not read"),
            ));
        }
        let uses = fields.references(1)?.into_iter();
        uses.map(|id| self.edge_use(id, edges)).collect()
    }

    fn edge_use(&self, id: u64, edges: &mut Edges) -> Got<EdgeUse> {
        let (mut key, mut forward) = (id, true);
        // An oriented edge may be of another.
        for _ in 0..8 {
            if !self.file.is(key, "ORIENTED_EDGE") {
                break;
            }
            let own = self.file.part(key, "ORIENTED_EDGE", 3);
            let own = own.ok_or_else(|| Trouble::new(key, "is no oriented edge"))?;
            // Written part by part, only these two are its own.
            forward ^= own.flag(1) == Some(false);
            key = own.reference(0)?;
        }
        let known = edges.entry(key).or_insert_with(|| self.edge(key));
        let (edge, mut vertices) = known.clone()?;
        if !forward {
            vertices.reverse();
        }
        Ok(EdgeUse {
            key,
            vertices,
            edge,
            forward,
        })
    }

    fn edge(&self, id: u64) -> Got<(Rc<Edge>, [u64; 2])> {
        if !self.file.is(id, "EDGE_CURVE") {
            let name = self.file.name(id);
            return Err(Trouble::new(
                id,
                format!("is {name}, an edge that is not read"),
            ));
        }
        let fields = self.file.fields(id)?;
        let (start, end) = (fields.reference(1)?, fields.reference(2)?);
        let curve = self.curve(fields.reference(3)?)?;
        let places = [self.vertex(start)?, self.vertex(end)?];
        let one = start == end || places[0] == places[1];
        let edge = Edge::new(curve, places, one, fields.flag(4) != Some(false));
        Ok((Rc::new(edge), [start, end]))
    }

    fn vertex(&self, id: u64) -> Got<Point> {
        let fields = self.file.fields(id)?;
        if self.file.is(id, "VERTEX_POINT") {
            self.point(fields.reference(1)?)
        } else {
            let name = self.file.name(id);
            Err(Trouble::new(
                id,
                format!("is {name}, not a vertex with a place"),
            ))
        }
    }
}
