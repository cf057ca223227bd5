//! A generalised inverse of a singular stiffness matrix by a support that changes nothing.

use super::free::FreeMotion;
use crate::assembly::sum::sum_of_columns;
use crate::dofs::DofMap;
use crate::material::Isotropic;
use crate::matrix3::symmetric_eigen;
use crate::mesh::data::Mesh;
use crate::mesh::space::Space;
use crate::vector3::{dot, sub};
use faer::{Mat, Side};
use tresca_la::SymmetricMatrix;

/// Most of the preferred nodes of a part that carry the support: it couples their dofs with each
/// other, so there should be few.
const MOST_PREFERRED: usize = 24;

/// The sampled nodes see a motion when its smallest root mean square over them has at least this
/// fraction of that over all nodes of the part. The support's stiffness goes with the square: a patch
/// in the middle of a face of four times its width sees the rotations about itself by less than 0.2,
/// and two far nodes more make the condition ten times better.
const SEEN: f64 = 0.3;

/// Stiffness of the support relative to the part's own elastic stiffness. Below 1, because the
/// support is local and the body around it gives way; any positive value is exact.
const STIFFNESS: f64 = 0.1;

/// A support C of the remaining rigid motions of a body, and the generalised inverse that it makes.
///
/// A body with remaining rigid motions R (free dofs × r) has a singular stiffness K with kernel R.
/// Let C (free dofs × r) be such that RᵀC is nonsingular. Then
///
/// K_reg = K + C Cᵀ
///
/// is positive definite, and K_reg⁻¹ *is* a generalised inverse of K: K K_reg⁻¹ K = K. With f in
/// equilibrium, Rᵀf = 0, the support carries nothing, and u = K_reg⁻¹f is the solution of K u = f with
/// Cᵀu = 0: no spring weakens the answer. From K_reg R = C CᵀR follows
///
/// K_reg⁻¹ = K⁺ + R S Rᵀ,   S = (RᵀC CᵀR)⁻¹,   with K⁺ ⪰ 0 and CᵀK⁺ = 0,
///
/// so that S is all that the support adds to the flexibility.
///
/// Few well-placed nodes suffice: these are the *fixing nodes* of Brzobohatý, Dostál,
/// Kozubek, Kovář, Markopoulos: *Cholesky decomposition with fixing nodes to stable computation of a
/// generalized inverse of the stiffness matrix of a floating structure*, IJNME 88, 2011.
///
/// There is one column per motion, in the order the motions were given in; columns of different
/// parts live on different dofs.
#[derive(Clone, Debug, PartialEq)]
pub struct Grounding {
    /// The free dofs where C is not zero, ascending.
    pub dofs: Vec<usize>,
    /// C by columns, `c[k][i]` at `dofs[i]`; the square root of a stiffness.
    pub c: Vec<Vec<f64>>,
    /// S = (RᵀC CᵀR)⁻¹, r × r, symmetric positive definite; the inverse of a stiffness. Zero between
    /// different parts.
    pub s: Vec<Vec<f64>>,
    /// R by columns over all free dofs, the given motions.
    pub r: Vec<Vec<f64>>,
}

impl Grounding {
    /// The grounding of `factor` K.
    pub fn scale(&mut self, factor: f64) {
        let root = factor.sqrt();
        self.c.iter_mut().flatten().for_each(|c| *c *= root);
        self.s.iter_mut().flatten().for_each(|s| *s /= factor);
    }

    /// Grounds the given motions (see [`super::remaining`]), if possible on the `preferred` nodes:
    /// the contact nodes, whose dofs are coupled anyway.
    ///
    /// Per part: at most 24 of the preferred nodes are chosen, each as far as possible from those
    /// before. Where they do not see every motion (a line of contact does not see the rotation about
    /// itself), nodes from all over the part are added the same way until they do. On the dofs of
    /// these nodes C = √κ Q, with Q an orthonormal basis of R restricted to them, so that a motion of
    /// unit length meets the stiffness κ · (number of nodes). It is set to 0.1 E times the diagonal of
    /// the part in space, times 1 in the plane, times the mean circumference in an axisymmetric space.
    ///
    /// # Panics
    /// When motions or preferred nodes belong to another mesh.
    pub fn new(
        mesh: &Mesh,
        material: &Isotropic,
        dofs: &DofMap,
        motions: &[FreeMotion],
        preferred: &[usize],
    ) -> Self {
        let mut sorted = preferred.to_vec();
        sorted.sort_unstable();
        sorted.dedup();
        let mut parts: Vec<usize> = motions.iter().map(|motion| motion.part).collect();
        parts.sort_unstable();
        parts.dedup();
        let supports: Vec<PartSupport> = parts
            .into_iter()
            .map(|part| {
                let of_part = (0..motions.len()).filter(|&k| motions[k].part == part);
                PartSupport::new(mesh, material, dofs, motions, of_part.collect(), &sorted)
            })
            .collect();

        let mut grounded: Vec<usize> = supports.iter().flat_map(|p| p.dofs.clone()).collect();
        grounded.sort_unstable();
        let mut c = vec![vec![0.0; grounded.len()]; motions.len()];
        let mut s = vec![vec![0.0; motions.len()]; motions.len()];
        for support in &supports {
            for (row, dof) in grounded.iter().enumerate() {
                if let Ok(local) = support.dofs.binary_search(dof) {
                    for (&k, column) in support.columns.iter().zip(&support.c) {
                        c[k][row] = column[local];
                    }
                }
            }
            for (&k, of_k) in support.columns.iter().zip(&support.s) {
                for (&l, value) in support.columns.iter().zip(of_k) {
                    s[k][l] = *value;
                }
            }
        }
        let r = motions
            .iter()
            .map(|motion| dofs.free_part(&motion.displacement(mesh)))
            .collect();
        Self {
            dofs: grounded,
            c,
            s,
            r,
        }
    }

    /// K_reg = K + C Cᵀ, with the pattern extended to the coupled dofs.
    ///
    /// # Panics
    /// When K has another order than there are free dofs.
    pub fn add_to(&self, k: &SymmetricMatrix) -> SymmetricMatrix {
        let n = k.order();
        assert!(
            self.r.iter().all(|r| r.len() == n),
            "the stiffness belongs to other dofs"
        );
        let lower = k.lower();
        let coupled = self.dofs.len() * (self.dofs.len() + 1) / 2;
        let column = |j| {
            lower
                .row_idx_of_col(j)
                .zip(lower.val_of_col(j).iter().copied())
        };
        sum_of_columns(n, lower.compute_nnz() + coupled, column, |j| {
            self.column_below_diagonal(j)
        })
    }

    /// out ← out + C Cᵀ v.
    pub fn add_product(&self, v: &[f64], out: &mut [f64]) {
        for c in &self.c {
            let amount: f64 = self.dofs.iter().zip(c).map(|(&dof, c)| c * v[dof]).sum();
            for (&dof, c) in self.dofs.iter().zip(c) {
                out[dof] += amount * c;
            }
        }
    }

    /// Rows and values of column j of C Cᵀ from the diagonal downwards, zeros (of other parts) left
    /// out.
    fn column_below_diagonal(&self, j: usize) -> impl Iterator<Item = (usize, f64)> + '_ {
        let (at, count) = match self.dofs.binary_search(&j) {
            Ok(at) => (at, self.dofs.len()),
            Err(_) => (0, 0),
        };
        (at..count)
            .map(move |i| (self.dofs[i], self.c.iter().map(|c| c[i] * c[at]).sum()))
            .filter(|&(_, value)| value != 0.0)
    }
}

/// The support of one part.
struct PartSupport {
    /// Which of the given motions are this part's.
    columns: Vec<usize>,
    /// Free dofs, ascending.
    dofs: Vec<usize>,
    /// C by columns over `dofs`.
    c: Vec<Vec<f64>>,
    /// The part's block of S.
    s: Vec<Vec<f64>>,
}

impl PartSupport {
    fn new(
        mesh: &Mesh,
        material: &Isotropic,
        dofs: &DofMap,
        motions: &[FreeMotion],
        columns: Vec<usize>,
        preferred: &[usize],
    ) -> Self {
        let of_part = || columns.iter().map(|&k| &motions[k]);
        let mut beyond: Vec<usize> = of_part().flat_map(FreeMotion::moving_beyond).collect();
        beyond.sort_unstable();
        beyond.dedup();
        let part = Sight {
            dofs,
            motions: of_part().map(|motion| motion.displacement(mesh)).collect(),
            beyond: beyond.into_iter().map(|k| mesh.dof_count() + k).collect(),
        };
        let has_free = |node: &usize| (0..dofs.components()).any(|i| dofs.free(*node, i).is_some());
        let of_part = motions[columns[0]].nodes();
        let all: Vec<usize> = of_part.iter().copied().filter(has_free).collect();
        let near: Vec<usize> = preferred
            .iter()
            .copied()
            .filter(|node| of_part.binary_search(node).is_ok() && has_free(node))
            .collect();

        let mut sample = FarthestPoints::new(mesh);
        while sample.nodes.len() < MOST_PREFERRED && sample.add_from(&near) {}
        let enough = SEEN * part.smallest(&all);
        while part.smallest(&sample.nodes) < enough && sample.add_from(&all) {}
        sample.nodes.sort_unstable();

        let (sampled, restricted) = part.restrict(&sample.nodes);
        let stiffness = STIFFNESS * material.young() * length(mesh, of_part);
        let kappa = stiffness * dofs.components() as f64 / sampled.len() as f64;
        let (q, inverse) = orthonormalise(restricted);
        let c = q
            .into_iter()
            .map(|column| column.into_iter().map(|x| kappa.sqrt() * x).collect())
            .collect();
        // R = Q T gives (RᵀC CᵀR)⁻¹ = T⁻¹ T⁻ᵀ / κ.
        let r = columns.len();
        let entry =
            |k: usize, l: usize| (0..r).map(|j| inverse[k][j] * inverse[l][j]).sum::<f64>() / kappa;
        let s = (0..r)
            .map(|k| (0..r).map(|l| entry(k, l)).collect())
            .collect();
        Self {
            columns,
            dofs: sampled,
            c,
            s,
        }
    }
}

/// The length that makes E the stiffness of a part: its diagonal in space, 1 in the plane, where
/// stiffness is per thickness, the mean circumference in an axisymmetric space.
fn length(mesh: &Mesh, nodes: &[usize]) -> f64 {
    let points = nodes.iter().map(|&node| mesh.points[node]);
    match mesh.space {
        Space::Solid => crate::mesh::BoundingBox::around(points).diagonal(),
        Space::Plane => 1.0,
        Space::Axisymmetric => {
            points.map(|p| mesh.space.circumference(p)).sum::<f64>() / nodes.len() as f64
        }
    }
}

/// How well some nodes see the motions of a part.
struct Sight<'a> {
    dofs: &'a DofMap,
    /// Over the full dofs.
    motions: Vec<Vec<f64>>,
    /// Full dofs beyond the mesh that see motions, too; they count whatever the nodes are.
    beyond: Vec<usize>,
}

impl Sight<'_> {
    /// The free dofs of some nodes, and the motions there, by motion.
    fn restrict(&self, nodes: &[usize]) -> (Vec<usize>, Vec<Vec<f64>>) {
        let components = self.dofs.components();
        let of_nodes = nodes
            .iter()
            .flat_map(|&node| (0..components).map(move |i| (node, i)));
        let of_nodes = of_nodes.map(|(node, i)| self.dofs.full(node, i));
        let full = of_nodes.chain(self.beyond.iter().copied());
        let mut free = Vec::new();
        let mut restricted = vec![Vec::new(); self.motions.len()];
        for full in full {
            let Some(dof) = self.dofs.free_of_full(full) else {
                continue;
            };
            free.push(dof);
            for (column, motion) in restricted.iter_mut().zip(&self.motions) {
                column.push(motion[full]);
            }
        }
        (free, restricted)
    }

    /// The smallest root mean square over the nodes' free dofs of any combination of the motions with
    /// unit coefficients; 0 without nodes.
    fn smallest(&self, nodes: &[usize]) -> f64 {
        let (free, restricted) = self.restrict(nodes);
        if free.is_empty() {
            return 0.0;
        }
        let product = |k: usize, l: usize| tresca_la::vector::dot(&restricted[k], &restricted[l]);
        let least = if restricted.len() <= 6 {
            // Unused rows must not be the smallest.
            let mut gram = [[0.0; 6]; 6];
            for (k, row) in gram.iter_mut().enumerate() {
                row[k] = f64::MAX.sqrt();
            }
            for k in 0..restricted.len() {
                for l in 0..restricted.len() {
                    gram[k][l] = product(k, l);
                }
            }
            let (values, _) = symmetric_eigen(gram);
            values.into_iter().fold(f64::INFINITY, f64::min)
        } else {
            // Parts that equations couple can have more motions than one.
            let gram = Mat::from_fn(restricted.len(), restricted.len(), product);
            let values = gram.self_adjoint_eigenvalues(Side::Lower);
            values.map_or(0.0, |values| values[0])
        };
        (least.max(0.0) / free.len() as f64).sqrt()
    }
}

/// Nodes chosen one by one, each as far as possible from those before; the lowest number wins a tie.
struct FarthestPoints<'a> {
    mesh: &'a Mesh,
    nodes: Vec<usize>,
}

impl<'a> FarthestPoints<'a> {
    fn new(mesh: &'a Mesh) -> Self {
        let nodes = Vec::new();
        Self { mesh, nodes }
    }

    /// Adds the candidate that is farthest from the nodes so far (from the candidates' centre when it
    /// is the first); false when every candidate is chosen already.
    fn add_from(&mut self, candidates: &[usize]) -> bool {
        let points = &self.mesh.points;
        let centre: [f64; 3] = std::array::from_fn(|i| {
            candidates.iter().map(|&a| points[a][i]).sum::<f64>() / candidates.len() as f64
        });
        let squared = |a: [f64; 3], b: [f64; 3]| dot(sub(a, b), sub(a, b));
        let mut farthest = None;
        for &node in candidates.iter().filter(|node| !self.nodes.contains(node)) {
            let to_nodes = self.nodes.iter().map(|&other| points[other]);
            let distance = match self.nodes.is_empty() {
                true => squared(points[node], centre),
                false => to_nodes
                    .map(|other| squared(points[node], other))
                    .fold(f64::INFINITY, f64::min),
            };
            if farthest.is_none_or(|(_, most)| distance > most) {
                farthest = Some((node, distance));
            }
        }
        self.nodes.extend(farthest.map(|(node, _)| node));
        farthest.is_some()
    }
}

/// Columns R = Q T with QᵀQ = I and T upper triangular, as Q (by columns) and T⁻¹ (by rows).
///
/// Gram–Schmidt with a second round, which makes Q orthogonal to rounding. T⁻¹ is built along: the
/// operations that turn R into Q turn I into T⁻¹.
fn orthonormalise(mut columns: Vec<Vec<f64>>) -> (Vec<Vec<f64>>, Vec<Vec<f64>>) {
    use tresca_la::vector::{axpy, dot, norm};
    let r = columns.len();
    // By columns: R · inverse[k] is the k-th column of Q.
    let mut inverse = vec![vec![0.0; r]; r];
    for k in 0..r {
        inverse[k][k] = 1.0;
        let (before, rest) = columns.split_at_mut(k);
        let (inverse_before, inverse_rest) = inverse.split_at_mut(k);
        for _ in 0..2 {
            for (q, t) in before.iter().zip(inverse_before.iter()) {
                let along = dot(q, &rest[0]);
                axpy(-along, q, &mut rest[0]);
                axpy(-along, t, &mut inverse_rest[0]);
            }
        }
        let length = norm(&rest[0]);
        for x in rest[0].iter_mut().chain(&mut inverse_rest[0]) {
            *x /= length;
        }
    }
    let by_rows = (0..r)
        .map(|k| inverse.iter().map(|column| column[k]).collect())
        .collect();
    (columns, by_rows)
}
