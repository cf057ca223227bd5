//! One brick of the two, clamped on x = 0.

use tresca_fem::FemError;
use tresca_fem::assembly::{self, Formulation};
use tresca_fem::dofs::DofMap;
use tresca_fem::material::Isotropic;
use tresca_fem::mesh::{BrickSpec, CellKind, Mesh, brick};
use tresca_fem::supports::Supports;
use tresca_la::SymmetricMatrix;

pub struct Brick {
    pub mesh: Mesh,
    pub material: Isotropic,
    pub dofs: DofMap,
}

impl Brick {
    /// Of `nodes` corner nodes per edge.
    pub fn new(nodes: usize, kind: CellKind) -> Result<Self, FemError> {
        let spec = BrickSpec {
            min: [0.0; 3],
            max: [2.0, 1.0, 1.0],
            nodes: [nodes; 3],
        };
        let mesh = brick(&spec)?.with_cells(kind)?;
        let mut supports = Supports::new(mesh.node_count(), 3);
        supports.clamp(&mesh.nodes_of_set("x-")?)?;
        Ok(Self {
            material: Isotropic::new(5e4, 0.35)?,
            dofs: DofMap::new(&supports),
            mesh,
        })
    }

    pub fn stiffness(&self) -> Result<SymmetricMatrix, FemError> {
        assembly::stiffness(&self.mesh, &self.material, Formulation::Full, &self.dofs)
    }
}
