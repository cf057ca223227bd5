//! Which parts of two bodies face each other.

use rayon::prelude::*;
use tresca_fem::mesh::{Face, Mesh};

use crate::coupling::mortar::rules::Rules;
use crate::coupling::mortar::segment::{SegmentPoint, Segments};
use crate::error::ContactError;
use crate::geometry::faces::FaceShapes;
use crate::geometry::facet::Facet;
use crate::geometry::search::{FacetTree, Reach};

/// The exterior faces of two bodies that face each other within a distance: (faces of `slave`, faces of
/// `master`), ascending, both empty where the bodies are apart.
///
/// Two faces face each other when their outward normals are more than 107° apart and the first sees the
/// second along its normal at most `distance` (a length) away in the middle of what it sees: in front, or
/// behind where the bodies overlap. What lies behind the slave body is not seen through it, however thin the
/// body is.
///
/// # Errors
/// [`ContactError::Search`] for a distance that is none, [`ContactError::DegenerateFace`].
pub fn facing_surfaces(
    slave: &Mesh,
    master: &Mesh,
    distance: f64,
) -> Result<(Vec<Face>, Vec<Face>), ContactError> {
    if distance.is_nan() || distance <= 0.0 {
        return Err(ContactError::Search { search: distance });
    }
    let boundaries = [slave, master].map(Mesh::boundary_faces);
    let slave = FaceShapes::of_mesh(slave, &boundaries[0])?;
    let master = FaceShapes::of_mesh(master, &boundaries[1])?;
    let view = View {
        trees: [&slave, &master].map(|surface| FacetTree::new(&surface.facets)),
        slave: &slave,
        master: &master,
        distance,
        rules: Rules::new(),
    };
    let indices = (0..slave.shapes.len()).into_par_iter();
    let partners: Vec<Vec<usize>> = indices.map(|index| view.partners(index)).collect();

    let mut of_slave = Vec::new();
    let mut of_master = vec![false; master.shapes.len()];
    for (&face, partners) in boundaries[0].iter().zip(&partners) {
        if !partners.is_empty() {
            of_slave.push(face);
        }
        for &partner in partners {
            of_master[partner] = true;
        }
    }
    let of_master = boundaries[1].iter().zip(of_master);
    let of_master = of_master.filter(|&(_, seen)| seen).map(|(&face, _)| face);
    Ok((of_slave, of_master.collect()))
}

/// What the faces of one surface see.
struct View<'a> {
    slave: &'a FaceShapes,
    master: &'a FaceShapes,
    /// Of the slave, of the master.
    trees: [FacetTree; 2],
    distance: f64,
    rules: Rules,
}

impl View<'_> {
    /// The master faces that a slave face sees.
    fn partners(&self, index: usize) -> Vec<usize> {
        let shape = &self.slave.shapes[index];
        let mut partners = Vec::new();
        let mut work = Vec::new();
        for facet in self.slave.facets_of(index) {
            let segments = Segments::new(self.slave.space, &self.rules, shape, facet);
            let seen = self.seen(&segments, facet, self.master, 1, &mut work);
            // The body is as thick as it is to its own far side, which faces away like what lies behind.
            let thickness = if seen.iter().any(|&(_, distance)| distance < 0.0) {
                let own = self.seen(&segments, facet, self.slave, 0, &mut work);
                let behind = own.into_iter().filter(|&(_, distance)| distance < 0.0);
                behind
                    .map(|(_, distance)| -distance)
                    .fold(f64::INFINITY, f64::min)
            } else {
                f64::INFINITY
            };
            let near = seen
                .into_iter()
                .filter(|&(_, distance)| -distance < thickness);
            partners.extend(near.map(|(face, _)| face));
        }
        partners
    }

    /// Faces of a surface that a facet sees, with their distances along its normal.
    fn seen(
        &self,
        segments: &Segments<'_>,
        facet: &Facet,
        surface: &FaceShapes,
        tree: usize,
        work: &mut Vec<SegmentPoint>,
    ) -> Vec<(usize, f64)> {
        let reach = Reach::new(Some(self.distance), 0.0);
        let candidates = self.trees[tree].candidates(facet, reach).into_iter();
        candidates
            .filter_map(|candidate| {
                let other = &surface.facets[candidate];
                let distance = segments.distance(&surface.shapes[other.face], other, work)?;
                (distance.abs() <= self.distance).then_some((other.face, distance))
            })
            .collect()
    }
}
