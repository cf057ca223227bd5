//! From integrals over faces to pairs and the rows of B.

use rayon::prelude::*;

use super::coverage::multipliers;
use super::dual::{DualBasis, dual_basis};
use super::integrals::{FaceIntegrals, Partner};
use super::slave::{SlaveSurface, free};
use crate::data::{ContactData, Discretization};
use crate::error::ContactError;
use crate::geometry::face::MAX_NODES;
use crate::geometry::faces::FaceShapes;
use crate::interface::{Interface, Side};
use crate::pair::rows::{Location, coupling, pair};
use crate::scalar_field::ScalarField;

/// A deformable partner.
#[derive(Clone, Copy)]
pub(crate) struct Master<'a> {
    /// Its body.
    pub side: Side<'a>,
    /// Its faces, in the order of the integrals' partners.
    pub faces: &'a FaceShapes,
}

/// What a multiplier sees: scalar rows, to be multiplied by the directions of a frame.
struct Row {
    /// a_j = ∫ ψ_j.
    area: f64,
    /// (1/a_j) ∫ ψ_j g.
    gap: f64,
    /// D_jk / a_j by node of the slave mesh, ascending.
    slave: Vec<(usize, f64)>,
    /// M_jl / a_j by node of the master mesh, ascending.
    master: Vec<(usize, f64)>,
    /// Is there a face on which this multiplier stands and supports hold every slave node in the direction of
    /// an axis?
    held_faces: [bool; 3],
}

/// The pairs and couplings that belong to the integrals.
///
/// `normal` gives the unit normal ν of a node by its position in the slave surface. Without a master the
/// partner is rigid.
pub(crate) fn assemble(
    slave: &SlaveSurface<'_>,
    normal: impl Fn(usize) -> [f64; 3],
    integrals: &[FaceIntegrals],
    master: Option<Master<'_>>,
    interface: Interface<'_>,
    discretization: Discretization,
) -> Result<ContactData, ContactError> {
    let rows = rows(slave, integrals, master);
    let nodes = &slave.surface.nodes;
    let mesh = slave.side.mesh;
    let mut pairs = Vec::new();
    let mut slave_rows = Vec::new();
    let mut master_rows = Vec::new();
    let mut uncoupled = Vec::new();
    let mut coupled = vec![false; slave.surface.node_count()];
    let mut held_pairs = 0;
    for (index, (node, row)) in nodes.iter().zip(rows).enumerate() {
        let Some(row) = row else {
            if slave.holds_normal(index) {
                held_pairs += 1;
            } else if !slave.taken[index] {
                uncoupled.push((node.ordinal, node.node));
            }
            continue;
        };
        // A direction is lost where the slave node is held, unless the whole face is: then it is the
        // master that moves against it, if anything does.
        let mut movable = slave.free(node.node);
        if let Some(master) = master {
            for &(partner, _) in &row.master {
                let partner = free(master.side, partner);
                for k in 0..3 {
                    movable[k] |= row.held_faces[k] && partner[k];
                }
            }
        }
        if movable == [false; 3] {
            held_pairs += 1;
            continue;
        }
        let location = Location {
            slave_node: node.node,
            patch: node.patch,
            master_node: None,
            point: node.point,
            normal: normal(index),
            area: row.area,
        };
        let value =
            |field: &ScalarField| field.at(node.ordinal, slave.surface.node_count(), node.point);
        coupled[node.ordinal] = true;
        pairs.push(pair(location, movable, interface, value, |_| row.gap)?);
        slave_rows.push(row.slave);
        master_rows.push(row.master);
    }
    if pairs.is_empty() && held_pairs == 0 {
        return Err(ContactError::Apart);
    }
    // On some patch a node may have a pair all the same.
    uncoupled.retain(|&(ordinal, _)| !coupled[ordinal]);
    uncoupled.dedup();
    let uncoupled = uncoupled.into_iter().map(|(_, node)| node).collect();
    let slave_coupling = coupling(&pairs, mesh, 1.0, |i| &slave_rows[i]);
    let master_coupling =
        master.map(|master| coupling(&pairs, master.side.mesh, -1.0, |i| &master_rows[i]));
    Ok(ContactData {
        pairs,
        slave_coupling,
        master_coupling,
        discretization,
        overlap_area: integrals.iter().map(|face| face.area).sum(),
        uncoupled,
        shared: Vec::new(),
        held_pairs,
    })
}

/// The rows by node of the slave surface; `None` for a node without a multiplier.
fn rows(
    slave: &SlaveSurface<'_>,
    integrals: &[FaceIntegrals],
    master: Option<Master<'_>>,
) -> Vec<Option<Row>> {
    let shapes = &slave.faces.shapes;
    let keep = multipliers(slave, integrals, master.is_none());
    let bases: Vec<Option<DualBasis>> = shapes
        .par_iter()
        .zip(integrals)
        .zip(&keep)
        .map(|((shape, integrals), keep)| {
            let any = keep.iter().any(|&k| k);
            any.then(|| dual_basis(shape.kind, &integrals.mass, keep))
        })
        .collect();
    // Where the multipliers of a node stand: faces and rows of their bases, by ascending face.
    let mut places = vec![Vec::new(); slave.surface.nodes.len()];
    for (face, basis) in bases.iter().enumerate() {
        for (row, &local) in basis.iter().flat_map(|basis| &basis.kept).enumerate() {
            places[slave.index_of(face, shapes[face].nodes()[local])].push((face, row));
        }
    }
    let row = |places: &Vec<(usize, usize)>| {
        let mut sum = Sum::default();
        for &(face, row) in places {
            if let Some(basis) = &bases[face] {
                let psi = &basis.coefficients[row];
                sum.add(slave, &integrals[face], face, psi, master);
            }
        }
        sum.finish()
    };
    places.par_iter().map(row).collect()
}

/// A row in the making.
#[derive(Default)]
struct Sum {
    area: f64,
    gap: f64,
    slave: Vec<(usize, f64)>,
    master: Vec<(usize, f64)>,
    held_faces: [bool; 3],
}

impl Sum {
    /// Adds what ψ = Σ_k psi_k φ_k sees on a face.
    fn add(
        &mut self,
        slave: &SlaveSurface<'_>,
        integrals: &FaceIntegrals,
        face: usize,
        psi: &[f64; MAX_NODES],
        master: Option<Master<'_>>,
    ) {
        let nodes = slave.faces.shapes[face].nodes();
        for (l, &node) in nodes.iter().enumerate() {
            let value = (0..nodes.len())
                .map(|k| psi[k] * integrals.mass[k][l])
                .sum();
            self.area += value;
            self.slave.push((node, value));
        }
        self.gap += (0..nodes.len())
            .map(|k| psi[k] * integrals.gap[k])
            .sum::<f64>();
        for axis in 0..slave.side.mesh.dimension() {
            self.held_faces[axis] |= nodes.iter().all(|&node| !slave.free(node)[axis]);
        }
        for Partner { face, moments } in &integrals.partners {
            let Some(master) = master else { continue };
            let partners = master.faces.shapes[*face].nodes();
            for (l, &node) in partners.iter().enumerate() {
                let value = (0..nodes.len())
                    .map(|k| psi[k] * moments[partners.len() * k + l])
                    .sum();
                self.master.push((node, value));
            }
        }
    }

    /// Divided by the area, entries of one node added up.
    fn finish(self) -> Option<Row> {
        if self.area.is_nan() || self.area <= 0.0 {
            return None;
        }
        Some(Row {
            area: self.area,
            gap: self.gap / self.area,
            slave: gathered(self.slave, self.area),
            master: gathered(self.master, self.area),
            held_faces: self.held_faces,
        })
    }
}

/// Coefficients per node, ascending, without those that are rounding of the sum 1.
fn gathered(mut entries: Vec<(usize, f64)>, area: f64) -> Vec<(usize, f64)> {
    const ROUNDING: f64 = 1e-15;
    entries.sort_by_key(|&(node, _)| node);
    entries
        .chunk_by(|a, b| a.0 == b.0)
        .map(|same| {
            let sum: f64 = same.iter().map(|&(_, value)| value).sum();
            (same[0].0, sum / area)
        })
        .filter(|&(_, value)| value.abs() > ROUNDING)
        .collect()
}
