//! Nodes coupled to the motion of one point.

use super::equation::{Dof, Equation};
use crate::error::FemError;
use crate::matrix3::{determinant, inverse_rows};
use crate::mesh::data::Mesh;
use crate::mesh::space::Space;
use crate::supports::Supports;
use crate::vector3::{cross, sub};

/// A point that moves like a rigid body: a displacement and a (small) rotation, on two nodes beyond the mesh.
///
/// A load on the first is a force at the point, one on the second a moment about it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ReferencePoint {
    /// Where it is.
    pub position: [f64; 3],
    /// The node whose components are the displacement of the point.
    pub displacement: usize,
    /// The node whose components are the rotation vector; in the plane component 0 is the rotation about z.
    pub rotation: usize,
}

impl ReferencePoint {
    /// Nodes that a point takes beyond the mesh.
    pub const NODES: usize = 2;

    /// A point on the nodes `first` and `first + 1`, not below the mesh's node count.
    pub fn new(position: [f64; 3], first: usize) -> Self {
        Self {
            position,
            displacement: first,
            rotation: first + 1,
        }
    }

    /// Holds what a point cannot do in the space: in the plane the second component of its rotation node, in
    /// an axisymmetric space everything but the displacement along the axis.
    ///
    /// # Errors
    /// As [`Supports::prescribe`].
    pub fn hold_unused(&self, supports: &mut Supports, space: Space) -> Result<(), FemError> {
        match space {
            Space::Solid => Ok(()),
            Space::Plane => supports.prescribe(self.rotation, 1, 0.0),
            Space::Axisymmetric => {
                supports.prescribe(self.displacement, 0, 0.0)?;
                supports.clamp(&[self.rotation])
            }
        }
    }

    /// Component `i` of the displacement that the point's motion gives a place, as coefficients.
    fn moves(&self, space: Space, place: [f64; 3], i: usize) -> Vec<(Dof, f64)> {
        let r = sub(place, self.position);
        let turn = |k, c| (Dof::new(self.rotation, k), c);
        let shift = (Dof::new(self.displacement, i), 1.0);
        match (space, i) {
            // (Θ × r)_i = Θ_j r_k − Θ_k r_j for i, j, k in turn.
            (Space::Solid, _) => {
                let (j, k) = ((i + 1) % 3, (i + 2) % 3);
                vec![shift, turn(j, r[k]), turn(k, -r[j])]
            }
            (Space::Plane, 0) => vec![shift, turn(0, -r[1])],
            (Space::Plane, _) => vec![shift, turn(0, r[0])],
            (Space::Axisymmetric, 0) => Vec::new(),
            (Space::Axisymmetric, _) => vec![shift],
        }
    }
}

/// Nodes that move with a point like one rigid body, u = U + Θ × (x − X); their dofs are the dependent
/// ones. In an axisymmetric space they do not move radially, and axially as one.
///
/// # Errors
/// [`FemError::Coupling`] without nodes, or for nodes that are not in the mesh.
pub fn rigid(
    mesh: &Mesh,
    nodes: &[usize],
    point: &ReferencePoint,
) -> Result<Vec<Equation>, FemError> {
    check(mesh, nodes)?;
    let of_node = |&node: &usize| {
        let moves = move |i| point.moves(mesh.space, mesh.points[node], i);
        (0..mesh.dimension()).map(move |i| Equation::dependent(Dof::new(node, i), moves(i)))
    };
    Ok(nodes.iter().flat_map(of_node).collect())
}

/// A point that follows nodes in the mean, by weighted least squares, without stiffening them: the dependent
/// dofs are those of the point. With the weights w and the centre c = Σ w x / Σ w of the nodes
///
/// Θ = J⁻¹ Σ w (x − c) × u,   J = Σ w (|x − c|² I − (x − c)(x − c)ᵀ),   U = Σ w u / Σ w + Θ × (X − c).
///
/// A force and a moment at the point go to the nodes as statics asks for, in proportion to their weights.
///
/// # Errors
/// [`FemError::Coupling`] without nodes, for weights that are not positive, or where the nodes lie on a line (in
/// the plane: in a point) and see no rotation about it.
pub fn distributing(
    mesh: &Mesh,
    nodes: &[(usize, f64)],
    point: &ReferencePoint,
) -> Result<Vec<Equation>, FemError> {
    let wrong = |what| FemError::Coupling {
        nodes: nodes.len(),
        what,
    };
    let numbers: Vec<usize> = nodes.iter().map(|&(node, _)| node).collect();
    check(mesh, &numbers)?;
    if !nodes.iter().all(|&(_, w)| w.is_finite() && w > 0.0) {
        return Err(wrong("needs positive weights"));
    }
    let total: f64 = nodes.iter().map(|&(_, w)| w).sum();
    let mut center = [0.0; 3];
    for &(node, w) in nodes {
        for i in 0..3 {
            center[i] += w / total * mesh.points[node][i];
        }
    }
    let mut equations = Vec::new();
    if mesh.space != Space::Axisymmetric {
        let turn = inverse_inertia(mesh, nodes, center)
            .ok_or_else(|| wrong("lie on a line, or in a point, and see no rotation about it"))?;
        let axes = if mesh.space == Space::Solid {
            0..3
        } else {
            2..3
        };
        for (component, axis) in axes.enumerate() {
            // J⁻¹_axis · ((x − c) × u) = u · (J⁻¹_axis × (x − c)).
            let on = nodes.iter().flat_map(|&(node, w)| {
                let arm = cross(turn[axis], sub(mesh.points[node], center));
                (0..mesh.dimension()).map(move |i| (Dof::new(node, i), w * arm[i]))
            });
            equations.push(Equation::dependent(Dof::new(point.rotation, component), on));
        }
    }
    let first = if mesh.space == Space::Axisymmetric {
        1
    } else {
        0
    };
    for i in first..mesh.dimension() {
        let mean = nodes
            .iter()
            .map(|&(node, w)| (Dof::new(node, i), w / total));
        // U = mean + Θ × (X − c): the motion of the point seen from the centre, turned round.
        let back = point.moves(mesh.space, center, i).into_iter().skip(1);
        let back = back.map(|(dof, c)| (dof, -c));
        equations.push(Equation::dependent(
            Dof::new(point.displacement, i),
            mean.chain(back),
        ));
    }
    Ok(equations)
}

/// Rows of J⁻¹; in the plane only that of z. `None` where a rotation is not seen.
fn inverse_inertia(mesh: &Mesh, nodes: &[(usize, f64)], center: [f64; 3]) -> Option<[[f64; 3]; 3]> {
    const FLAT: f64 = 1e-12;
    let mut inertia = [[0.0; 3]; 3];
    for &(node, w) in nodes {
        let d = sub(mesh.points[node], center);
        let square: f64 = d.iter().map(|x| x * x).sum();
        for i in 0..3 {
            inertia[i][i] += w * square;
            for j in 0..3 {
                inertia[i][j] -= w * d[i] * d[j];
            }
        }
    }
    let trace = inertia[0][0] + inertia[1][1] + inertia[2][2];
    if mesh.space == Space::Plane {
        let rows = [[0.0; 3], [0.0; 3], [0.0, 0.0, 1.0 / inertia[2][2]]];
        return (inertia[2][2] > 0.0).then_some(rows);
    }
    let det = determinant(&inertia);
    // J is symmetric: rows and columns are the same.
    (det > FLAT * trace.powi(3)).then(|| inverse_rows(&inertia, det))
}

/// Are there nodes, and are they in the mesh?
fn check(mesh: &Mesh, nodes: &[usize]) -> Result<(), FemError> {
    let wrong = |what| {
        Err(FemError::Coupling {
            nodes: nodes.len(),
            what,
        })
    };
    if nodes.is_empty() {
        return wrong("needs at least one node");
    }
    if nodes.iter().any(|&node| node >= mesh.node_count()) {
        return wrong("names nodes that are not in the mesh");
    }
    Ok(())
}
