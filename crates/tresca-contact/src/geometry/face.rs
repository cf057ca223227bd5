//! A face of a surface with its shape functions.

use tresca_fem::mesh::CellKind;
use tresca_fem::vector3::{cross, norm};

use crate::error::ContactError;

/// Most nodes that a face can have (quad9).
pub(crate) const MAX_NODES: usize = 9;

/// A face with the places of its nodes. Seen from outside of its body its corners go round
/// counter-clockwise; in the plane the outward normal is the tangent turned clockwise.
#[derive(Debug, Clone, Copy)]
pub(crate) struct FaceShape {
    /// The face element.
    pub kind: CellKind,
    nodes: [usize; MAX_NODES],
    points: [[f64; 3]; MAX_NODES],
    count: usize,
    /// How far the map from ξ is from a linear one, for which polynomials in ξ are polynomials on the
    /// face: the largest change of its tangents in relation to themselves.
    pub distortion: f64,
}

impl FaceShape {
    /// A face of `kind` with the given nodes among `points`.
    pub fn new(
        kind: CellKind,
        nodes: &[usize],
        points: &[[f64; 3]],
    ) -> Result<FaceShape, ContactError> {
        let count = kind.node_count();
        if kind.facets().is_empty() || nodes.len() != count {
            return Err(ContactError::FaceKind {
                kind,
                nodes: nodes.len(),
            });
        }
        let mut shape = FaceShape {
            kind,
            nodes: [0; MAX_NODES],
            points: [[0.0; 3]; MAX_NODES],
            count,
            distortion: 0.0,
        };
        for (a, &node) in nodes.iter().enumerate() {
            shape.nodes[a] = node;
            shape.points[a] = *points
                .get(node)
                .filter(|point| point.iter().all(|x| x.is_finite()))
                .ok_or(ContactError::FaceNode { node })?;
        }
        shape.distortion = shape.change_of_tangents();
        Ok(shape)
    }

    /// Node numbers.
    pub fn nodes(&self) -> &[usize] {
        &self.nodes[..self.count]
    }

    /// Places of the nodes.
    pub fn points(&self) -> &[[f64; 3]] {
        &self.points[..self.count]
    }

    /// φ_a(ξ), zero beyond the face's nodes.
    pub fn values(&self, xi: [f64; 3]) -> [f64; MAX_NODES] {
        let mut values = [0.0; MAX_NODES];
        let element = self.kind.element();
        element.shape(xi, &mut values[..self.count]);
        values
    }

    /// Σ_a φ_a x_a.
    pub fn position(&self, values: &[f64; MAX_NODES]) -> [f64; 3] {
        combine(&values[..self.count], self.points())
    }

    /// ∂x/∂ξ₁ and ∂x/∂ξ₂; the second is zero for a line.
    pub fn tangents(&self, xi: [f64; 3]) -> [[f64; 3]; 2] {
        let mut gradients = [[0.0; 3]; MAX_NODES];
        let element = self.kind.element();
        element.gradients(xi, &mut gradients[..self.count]);
        std::array::from_fn(|j| {
            let mut tangent = [0.0; 3];
            for (gradient, point) in gradients.iter().zip(self.points()) {
                for k in 0..3 {
                    tangent[k] += gradient[j] * point[k];
                }
            }
            tangent
        })
    }

    /// The outward normal whose length is the area (in the plane: the length) per unit of ξ.
    pub fn area_vector(&self, xi: [f64; 3]) -> [f64; 3] {
        let [t1, t2] = self.tangents(xi);
        if self.kind.dimension() == 1 {
            [t1[1], -t1[0], 0.0]
        } else {
            cross(t1, t2)
        }
    }

    /// Half of the largest distance between two nodes: a size of the face.
    pub fn radius(&self) -> f64 {
        let points = self.points();
        let pairs = points.iter().enumerate().flat_map(|(i, a)| {
            let others = points[..i].iter();
            others.map(move |b| norm(std::array::from_fn(|k| a[k] - b[k])))
        });
        0.5 * pairs.fold(0.0, f64::max)
    }

    /// Flat or straight, with nodes where a linear map puts them?
    pub fn affine(&self) -> bool {
        self.distortion <= 1e-9
    }

    fn change_of_tangents(&self) -> f64 {
        let at = |xi: &[f64; 3]| self.tangents(*xi);
        let mut nodes = self.kind.element().nodes().iter();
        let first = nodes.next().map_or([[0.0; 3]; 2], at);
        let scale = norm(first[0]) + norm(first[1]);
        let changes = nodes.map(at).map(|tangents| {
            let change = |j: usize| norm(std::array::from_fn(|k| tangents[j][k] - first[j][k]));
            (change(0) + change(1)) / scale
        });
        changes.fold(0.0, f64::max)
    }
}

/// Σ_a values_a points_a.
pub(crate) fn combine(values: &[f64], points: &[[f64; 3]]) -> [f64; 3] {
    let mut x = [0.0; 3];
    for (value, point) in values.iter().zip(points) {
        for k in 0..3 {
            x[k] += value * point[k];
        }
    }
    x
}

/// How a face element is divided into facets, and how much its polynomials can do.
pub(crate) trait FaceElement {
    /// Corners of the facets in the element's own coordinates: parallelograms and triangles that
    /// fill the reference element, the quadratic ones divided at their mid nodes (Puso, Laursen,
    /// Solberg 2008). Empty for what is no face.
    fn facets(self) -> &'static [&'static [[f64; 2]]];

    /// Total degree of the shape functions as polynomials in ξ.
    fn degree(self) -> usize;
}

impl FaceElement for CellKind {
    fn facets(self) -> &'static [&'static [[f64; 2]]] {
        match self {
            CellKind::Line2 => &[&[[-1.0, 0.0], [1.0, 0.0]]],
            CellKind::Line3 => &[&[[-1.0, 0.0], [0.0, 0.0]], &[[0.0, 0.0], [1.0, 0.0]]],
            CellKind::Tri3 => &[&[[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]]],
            CellKind::Tri6 => &[
                &[[0.0, 0.0], [0.5, 0.0], [0.0, 0.5]],
                &[[0.5, 0.0], [1.0, 0.0], [0.5, 0.5]],
                &[[0.0, 0.5], [0.5, 0.5], [0.0, 1.0]],
                &[[0.5, 0.5], [0.0, 0.5], [0.5, 0.0]],
            ],
            CellKind::Quad4 => &[&[[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]]],
            // The centre of a quad8 is no node, but a point of the face like any other.
            CellKind::Quad8 | CellKind::Quad9 => &[
                &[[-1.0, -1.0], [0.0, -1.0], [0.0, 0.0], [-1.0, 0.0]],
                &[[0.0, -1.0], [1.0, -1.0], [1.0, 0.0], [0.0, 0.0]],
                &[[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]],
                &[[-1.0, 0.0], [0.0, 0.0], [0.0, 1.0], [-1.0, 1.0]],
            ],
            CellKind::Tet4
            | CellKind::Tet10
            | CellKind::Wedge6
            | CellKind::Hex8
            | CellKind::Hex20
            | CellKind::Hex27 => &[],
        }
    }

    fn degree(self) -> usize {
        match self {
            CellKind::Line3 | CellKind::Tri6 | CellKind::Quad4 => 2,
            CellKind::Quad8 => 3,
            CellKind::Quad9 => 4,
            _ => 1,
        }
    }
}
