//! Which parts of two bodies face each other.

use rayon::prelude::*;
use tresca_fem::mesh::{Face, Mesh};

use crate::ContactError;
use crate::geometry::{FacetTree, Patches, Reach};
use crate::mortar::{Rules, Segments};

/// The exterior faces of two bodies that face each other within a distance: (faces of `slave`, faces of
/// `master`), ascending, both empty where the bodies are apart.
///
/// Two faces face each other when their outward normals are more than 107° apart and the first sees the
/// second along its normal, in front or (where the bodies overlap) behind, at most `distance` (a length)
/// away in the middle of what it sees.
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
    let slave = Patches::of_mesh(slave, &boundaries[0])?;
    let master = Patches::of_mesh(master, &boundaries[1])?;
    let tree = FacetTree::new(&master.facets);
    let reach = Reach::new(Some(distance), 0.0);
    let rules = Rules::new();
    let partners = |index: usize| -> Vec<usize> {
        let patch = &slave.patches[index];
        let mut partners = Vec::new();
        let mut points = Vec::new();
        for facet in slave.facets_of(index) {
            let segments = Segments::new(slave.space, &rules, patch, facet);
            for candidate in tree.candidates(facet, reach) {
                let other = &master.facets[candidate];
                let patch = &master.patches[other.patch];
                if segments.distance(patch, other, &mut points) <= distance {
                    partners.push(other.patch);
                }
            }
        }
        partners
    };
    let indices = (0..slave.patches.len()).into_par_iter();
    let partners: Vec<Vec<usize>> = indices.map(partners).collect();

    let mut of_slave = Vec::new();
    let mut of_master = vec![false; master.patches.len()];
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
