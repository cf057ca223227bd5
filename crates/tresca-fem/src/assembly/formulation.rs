//! How strains are made of displacements, and when that locks.

use crate::element::mapping::{measure, physical_gradients};
use crate::element::table::ShapeTable;
use crate::error::FemError;
use crate::material::Isotropic;
use crate::mesh::data::Mesh;
use crate::mesh::kind::CellKind;
use crate::mesh::space::Space;
use std::fmt;
use std::str::FromStr;

/// Poisson's ratio above which linear cells are too stiff in bending and under constraint: the bulk
/// modulus is 25 times the shear modulus there.
const NEARLY_INCOMPRESSIBLE: f64 = 0.48;

/// How strains are made of displacements. A choice per body, the same for the stiffness and for every
/// stress.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Formulation {
    /// ε = sym ∇u at every integration point.
    #[default]
    Full,
    /// Mean dilatation (Hughes: *Generalization of selective integration procedures to anisotropic and
    /// nonlinear media*, IJNME 15, 1980): the volume change of a cell is one number, its mean,
    ///
    /// ε̄ = sym ∇u + ⅓ (θ̄ − div u) I,   θ̄ = (1/|Ω_c|) ∫_c div u dΩ,
    ///
    /// so that nearly incompressible linear cells meet one constraint each instead of one per
    /// integration point. For hex8 and quad4 cells, which then do not lock, and for wedge6 cells beside
    /// them, which still do under constraint (they are too many); in space, plane strain and
    /// axisymmetric.
    BBar,
}

impl Formulation {
    /// Both formulations.
    pub const ALL: [Formulation; 2] = [Formulation::Full, Formulation::BBar];

    /// The name: "full" or "b_bar".
    pub fn name(self) -> &'static str {
        match self {
            Formulation::Full => "full",
            Formulation::BBar => "b_bar",
        }
    }

    /// Refuses B-bar where it is not to be had. Assembly asks this itself.
    ///
    /// # Errors
    /// [`FemError::BBarCells`], [`FemError::BBarPlaneStress`].
    pub fn check(self, mesh: &Mesh, material: &Isotropic) -> Result<(), FemError> {
        if self == Formulation::Full {
            return Ok(());
        }
        if material.is_plane_stress() {
            return Err(FemError::BBarPlaneStress);
        }
        let suits = |kind| matches!(kind, CellKind::Hex8 | CellKind::Wedge6 | CellKind::Quad4);
        let mut kinds = mesh.cells.iter().map(|block| block.kind);
        match kinds.find(|&kind| !suits(kind)) {
            Some(kind) => Err(FemError::BBarCells { kind }),
            None => Ok(()),
        }
    }

    /// The cells of a body that threaten to lock: linear ones of a nearly incompressible material
    /// (ν > 0.48) in the full formulation, wedges in either. `None` where nothing is to be feared. The
    /// remedies are [`Formulation::BBar`] for hexahedra and quadrilaterals, and quadratic cells: tri6
    /// and tet10 do not lock at all; the others are too stiff on coarse meshes, by an error of fourth
    /// order.
    pub fn locking(self, mesh: &Mesh, material: &Isotropic) -> Option<CellKind> {
        if material.poisson() <= NEARLY_INCOMPRESSIBLE || material.is_plane_stress() {
            return None;
        }
        let mut kinds = mesh.cells.iter().map(|block| block.kind);
        kinds.find(|&kind| match self {
            Formulation::Full => kind.order() == 1,
            Formulation::BBar => kind == CellKind::Wedge6,
        })
    }
}

impl fmt::Display for Formulation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.name())
    }
}

/// By [`Formulation::name`].
impl FromStr for Formulation {
    type Err = FemError;

    fn from_str(name: &str) -> Result<Self, FemError> {
        let found = Formulation::ALL.into_iter().find(|one| one.name() == name);
        found.ok_or_else(|| FemError::UnknownFormulation {
            name: name.to_owned(),
        })
    }
}

/// The mean of the physical gradients over a cell, ∫ ∇φ_a dΩ / |Ω|, entries as in
/// [`physical_gradients`]; `scratch` has one entry per node. `None` where det J is not positive.
pub(crate) fn mean_gradients(
    space: Space,
    table: &ShapeTable,
    points: &[[f64; 3]],
    scratch: &mut [[f64; 3]],
    mean: &mut [[f64; 3]],
) -> Option<()> {
    mean.fill([0.0; 3]);
    let mut volume = 0.0;
    for q in 0..table.len() {
        let weight = table.weights[q] * physical_gradients(space, table, q, points, scratch)?;
        volume += weight;
        for (m, g) in mean.iter_mut().zip(scratch.iter()) {
            for i in 0..3 {
                m[i] += weight * g[i];
            }
        }
    }
    for x in mean.as_flattened_mut() {
        *x /= volume;
    }
    Some(())
}

/// The mean volume change over a cell of a strain given at the points of the rule.
pub(crate) fn mean_dilatation(
    space: Space,
    table: &ShapeTable,
    points: &[[f64; 3]],
    strain: impl Fn(usize) -> [f64; 6],
) -> f64 {
    let (mut sum, mut volume) = (0.0, 0.0);
    for q in 0..table.len() {
        let weight = table.weights[q] * measure(space, table, q, points);
        volume += weight;
        sum += weight * strain(q)[..3].iter().sum::<f64>();
    }
    sum / volume
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::brick::{BrickSpec, brick};

    fn cube(kind: CellKind) -> Mesh {
        let spec = BrickSpec {
            min: [0.0; 3],
            max: [1.0; 3],
            nodes: [2; 3],
        };
        brick(&spec).unwrap().with_cells(kind).unwrap()
    }

    #[test]
    fn what_locks_and_what_helps_is_said() {
        let (rubber, steel) = (Isotropic::new(1.0, 0.499), Isotropic::new(1.0, 0.3));
        let (rubber, steel) = (rubber.unwrap(), steel.unwrap());
        for kind in [CellKind::Hex8, CellKind::Wedge6, CellKind::Tet4] {
            let mesh = cube(kind);
            assert_eq!(Formulation::Full.locking(&mesh, &rubber), Some(kind));
            assert_eq!(Formulation::Full.locking(&mesh, &steel), None);
            let with_b_bar = Formulation::BBar.locking(&mesh, &rubber);
            assert_eq!(with_b_bar, (kind == CellKind::Wedge6).then_some(kind));
            let thin = rubber.plane_stress();
            assert_eq!(Formulation::Full.locking(&mesh, &thin), None);
        }
        let quadratic = cube(CellKind::Hex20);
        assert_eq!(Formulation::Full.locking(&quadratic, &rubber), None);
    }

    #[test]
    fn b_bar_is_refused_with_a_remedy() {
        let material = Isotropic::new(1.0, 0.49).unwrap();
        for kind in [CellKind::Hex8, CellKind::Wedge6] {
            assert_eq!(Formulation::BBar.check(&cube(kind), &material), Ok(()));
        }
        for (kind, remedy) in [
            (CellKind::Tet4, "tet10"),
            (CellKind::Hex20, "does not lock"),
        ] {
            let mesh = cube(kind);
            assert_eq!(Formulation::Full.check(&mesh, &material), Ok(()));
            let error = Formulation::BBar.check(&mesh, &material).unwrap_err();
            assert_eq!(error, FemError::BBarCells { kind });
            assert!(error.to_string().contains(remedy), "{error}");
        }
        let sheet = material.plane_stress();
        let error = Formulation::BBar.check(&cube(CellKind::Hex8), &sheet);
        assert_eq!(error, Err(FemError::BBarPlaneStress));
    }

    #[test]
    fn names_are_read_back() {
        for one in Formulation::ALL {
            assert_eq!(one.to_string().parse(), Ok(one));
        }
        assert!("bbar".parse::<Formulation>().is_err());
        assert_eq!(Formulation::default(), Formulation::Full);
    }
}
