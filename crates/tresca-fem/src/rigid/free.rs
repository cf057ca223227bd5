//! Rigid motions that supports leave to the parts of a mesh.

use super::motion::RigidMotion;
use crate::mesh::data::Mesh;
use std::fmt;
use std::sync::Arc;

/// A rigid motion of one connected part of a mesh that its supports leave; or of several parts that
/// equations couple.
#[derive(Clone, Debug, PartialEq)]
pub struct FreeMotion {
    /// Which part moves, counted from zero in the order of [`Mesh::parts`]; of coupled parts the first,
    /// whether it takes part in this motion or not.
    pub part: usize,
    /// How many parts the mesh has.
    pub parts: usize,
    /// How it moves.
    pub motion: RigidMotion,
    /// The part's nodes, ascending; shared by all motions of the part.
    own_nodes: Arc<[usize]>,
    /// The nodes of all coupled parts, ascending.
    nodes: Arc<[usize]>,
    /// The other parts that equations couple to it.
    others: Vec<Piece>,
    /// Values at the full dofs beyond the mesh.
    beyond: Vec<f64>,
}

/// A part that moves along.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Piece {
    pub part: usize,
    pub motion: RigidMotion,
    pub nodes: Arc<[usize]>,
}

impl FreeMotion {
    /// Of a part by itself.
    pub(super) fn of_part(
        part: usize,
        parts: usize,
        motion: RigidMotion,
        nodes: Arc<[usize]>,
    ) -> Self {
        Self {
            part,
            parts,
            motion,
            own_nodes: nodes.clone(),
            nodes,
            others: Vec::new(),
            beyond: Vec::new(),
        }
    }

    /// Of a part with others; `all` are the nodes of all of them.
    pub(super) fn coupled(
        first: Piece,
        others: Vec<Piece>,
        parts: usize,
        all: Arc<[usize]>,
    ) -> Self {
        Self {
            part: first.part,
            parts,
            motion: first.motion,
            own_nodes: first.nodes,
            nodes: all,
            others,
            beyond: Vec::new(),
        }
    }

    /// The nodes that may move: those of the part, and of all that it is coupled to, ascending.
    pub fn nodes(&self) -> &[usize] {
        &self.nodes
    }

    /// Gives the values at the full dofs beyond the mesh.
    pub(super) fn set_beyond(&mut self, values: Vec<f64>) {
        self.beyond = values;
    }

    /// Which of the dofs beyond the mesh move, counted from the mesh's.
    pub(super) fn moving_beyond(&self) -> impl Iterator<Item = usize> + '_ {
        (0..self.beyond.len()).filter(|&k| self.beyond[k] != 0.0)
    }

    /// The motions of the part and of those that are coupled to it.
    pub fn rigid_motions_mut(&mut self) -> impl Iterator<Item = &mut RigidMotion> {
        let others = self.others.iter_mut().map(|piece| &mut piece.motion);
        std::iter::once(&mut self.motion).chain(others)
    }

    /// The motion times a factor.
    #[must_use]
    pub fn scaled(&self, factor: f64) -> Self {
        let mut scaled = self.clone();
        for motion in scaled.rigid_motions_mut() {
            motion.translation = motion.translation.map(|t| factor * t);
            motion.rotation = motion.rotation.map(|t| factor * t);
        }
        scaled.beyond.iter_mut().for_each(|x| *x *= factor);
        scaled
    }

    /// Adds an amount of another motion of the same part, or of the same coupled ones.
    ///
    /// # Panics
    /// When it is one of another part.
    pub fn add(&mut self, amount: f64, other: &FreeMotion) {
        assert_eq!(self.part, other.part, "motions of two parts do not add up");
        self.motion.add(amount, &other.motion);
        for (own, other) in self.others.iter_mut().zip(&other.others) {
            own.motion.add(amount, &other.motion);
        }
        for (own, other) in self.beyond.iter_mut().zip(&other.beyond) {
            *own += amount * other;
        }
    }

    /// Displacement over the full dofs: the motion on the part, zero off it.
    pub fn displacement(&self, mesh: &Mesh) -> Vec<f64> {
        let d = mesh.dimension();
        let mut u = vec![0.0; mesh.dof_count()];
        let others = self
            .others
            .iter()
            .map(|piece| (&piece.motion, &piece.nodes));
        for (motion, nodes) in std::iter::once((&self.motion, &self.own_nodes)).chain(others) {
            for &node in nodes.iter() {
                u[d * node..d * (node + 1)].copy_from_slice(&motion.at(mesh.points[node])[..d]);
            }
        }
        u.extend_from_slice(&self.beyond);
        u
    }
}

/// Names the motion, and the part (counted from one) where there are several.
impl fmt::Display for FreeMotion {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let others = self.others.iter().map(|piece| (piece.part, &piece.motion));
        let moving = std::iter::once((self.part, &self.motion)).chain(others);
        let moving = moving
            .filter(|(_, motion)| motion.translation != [0.0; 3] || motion.rotation != [0.0; 3]);
        let mut first = true;
        for (part, motion) in moving {
            if !std::mem::replace(&mut first, false) {
                write!(f, ", ")?;
            }
            write!(f, "{motion}")?;
            if self.parts > 1 {
                write!(f, " of part {} of {}", part + 1, self.parts)?;
            }
        }
        if first {
            write!(f, "motion of a reference point that strains nothing")?;
        }
        Ok(())
    }
}
