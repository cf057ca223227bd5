//! The mechanical model: bodies, supports, loads and contacts, by name, and the load steps.

mod contact;
mod load;

pub use contact::{Contact, ContactSpec, Obstacle, Partner, PartnerRef};
pub use load::{Amount, Load, LoadKind, Step, Support, VectorField};

use tresca_contact::{FrictionLaw, ScalarField};
use tresca_fem::assembly::Formulation;
use tresca_fem::material::Isotropic;
use tresca_fem::mesh::{Face, Mesh, Space};

use crate::ModelError;

/// A body: a mesh and what it is made of.
#[derive(Debug, Clone)]
pub struct Body {
    /// Name, unique in the model.
    pub name: String,
    /// Mesh with named sets of boundary faces.
    pub mesh: Mesh,
    /// Linear elastic, isotropic.
    pub material: Isotropic,
    /// How strains are integrated: in full, or with a remedy against locking.
    pub formulation: Formulation,
    /// Mass per volume, for gravity.
    pub density: Option<f64>,
}

/// A named set of faces of a body, written `body.faces` in case files.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct SurfaceRef<'a> {
    /// Name of the body.
    pub body: &'a str,
    /// Name of the face set in the body's mesh.
    pub faces: &'a str,
}

/// A surface of the model, resolved; of a support also a set of nodes.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Surface {
    /// Index of the body in [`Model::bodies`].
    pub body: usize,
    /// Name of the face set (or node set).
    pub faces: String,
}

/// Bodies with supports, loads, contacts and load steps, every name resolved.
///
/// Built step by step; each step checks what it is given. Units are the user's: any
/// consistent system (mm, N, MPa or m, MN, MPa, …).
#[derive(Debug, Clone, Default)]
pub struct Model {
    title: String,
    bodies: Vec<Body>,
    supports: Vec<Support>,
    loads: Vec<Load>,
    obstacles: Vec<Obstacle>,
    contacts: Vec<Contact>,
    steps: Vec<Step>,
}

impl Model {
    /// An empty model.
    pub fn new(title: impl Into<String>) -> Self {
        Self {
            title: title.into(),
            ..Self::default()
        }
    }

    /// Adds a body.
    ///
    /// # Errors
    /// [`ModelError::DuplicateBody`] when the name is taken, [`ModelError::MixedSpaces`] when the other
    /// bodies live in another space.
    pub fn add_body(
        &mut self,
        name: impl Into<String>,
        mesh: Mesh,
        material: Isotropic,
    ) -> Result<&mut Self, ModelError> {
        let name = name.into();
        self.check_new_name(&name)?;
        if let Some(first) = self.bodies.first()
            && first.mesh.space != mesh.space
        {
            return Err(ModelError::MixedSpaces {
                first: first.name.clone(),
                second: name,
            });
        }
        self.bodies.push(Body {
            name,
            mesh,
            material,
            formulation: Formulation::default(),
            density: None,
        });
        Ok(self)
    }

    fn check_new_name(&self, name: &str) -> Result<(), ModelError> {
        let bodies = self.bodies.iter().map(|body| &body.name);
        let obstacles = self.obstacles.iter().map(|obstacle| &obstacle.name);
        match bodies.chain(obstacles).any(|taken| taken == name) {
            true => Err(ModelError::DuplicateBody {
                name: name.to_owned(),
            }),
            false => Ok(()),
        }
    }

    /// Gives the body added last a formulation.
    ///
    /// # Errors
    /// [`ModelError::NoBodies`] when there is no body; a formulation that the body's elements do not have
    /// is found when it is assembled.
    pub fn formulation(&mut self, formulation: Formulation) -> Result<&mut Self, ModelError> {
        let body = self.bodies.last_mut().ok_or(ModelError::NoBodies)?;
        body.formulation = formulation;
        Ok(self)
    }

    /// Gives the body added last a density (mass per volume, ≥ 0).
    ///
    /// # Errors
    /// [`ModelError::Density`] when it is no number ≥ 0, [`ModelError::NoBodies`] when there is no body.
    pub fn density(&mut self, density: f64) -> Result<&mut Self, ModelError> {
        let body = self.bodies.last_mut().ok_or(ModelError::NoBodies)?;
        if !(density.is_finite() && density >= 0.0) {
            return Err(ModelError::Density {
                body: body.name.clone(),
                density,
            });
        }
        body.density = Some(density);
        Ok(self)
    }

    /// Clamps a surface: all displacement components of its nodes are zero.
    ///
    /// # Errors
    /// When the body or the face set does not exist.
    pub fn clamp(&mut self, on: SurfaceRef<'_>) -> Result<&mut Self, ModelError> {
        let dimension = self.dimension();
        let components = std::array::from_fn(|component| (component < dimension).then_some(0.0));
        self.support(None, &[on], components)
    }

    /// Prescribes displacement components of surfaces or sets of nodes: 0 for a symmetry plane or a roller.
    ///
    /// # Errors
    /// When one of them does not exist, or a displacement is not finite or along z in the plane.
    pub fn support(
        &mut self,
        name: Option<&str>,
        on: &[SurfaceRef<'_>],
        components: [Option<f64>; 3],
    ) -> Result<&mut Self, ModelError> {
        self.check_components(&components.map(|value| value.unwrap_or(0.0)))?;
        if self.dimension() == 2 && components[2].is_some() {
            return Err(ModelError::OutOfPlane);
        }
        let on = on.iter().map(|&place| self.resolve_nodes(place));
        let support = Support {
            name: name.map(str::to_owned),
            on: on.collect::<Result<_, _>>()?,
            components,
        };
        self.supports.push(support);
        Ok(self)
    }

    /// Puts a constant traction (force per area, global components) on surfaces.
    ///
    /// # Errors
    /// As [`Model::add_load`].
    pub fn add_traction(
        &mut self,
        on: &[SurfaceRef<'_>],
        value: [f64; 3],
    ) -> Result<&mut Self, ModelError> {
        let on = self.resolve_all(on)?;
        let value = VectorField::Constant(value);
        self.add_load(None, LoadKind::Traction { on, value })
    }

    /// Adds a load; [`Model::resolve`] gives its surfaces.
    ///
    /// # Errors
    /// When a constant is not finite or has a part out of the plane, or weight acts on a body without
    /// density.
    pub fn add_load(
        &mut self,
        name: Option<&str>,
        kind: LoadKind,
    ) -> Result<&mut Self, ModelError> {
        match &kind {
            LoadKind::Traction { value, .. } => {
                if let VectorField::Constant(value) = value {
                    self.check_components(value)?;
                }
            }
            LoadKind::Pressure { value, .. } => match value {
                ScalarField::Constant(value) => self.check_components(&[*value, 0.0, 0.0])?,
                ScalarField::Function(_) => {}
                ScalarField::Values(_) => return Err(ModelError::PressureByValues),
            },
            LoadKind::BodyForce { value, .. } => self.check_components(value)?,
            LoadKind::Gravity { bodies, value } => {
                self.check_components(value)?;
                let light = bodies
                    .iter()
                    .find(|&&body| self.bodies[body].density.is_none());
                if let Some(&body) = light {
                    return Err(ModelError::NoDensity {
                        body: self.bodies[body].name.clone(),
                    });
                }
            }
        }
        self.loads.push(Load {
            name: name.map(str::to_owned),
            kind,
        });
        Ok(self)
    }

    /// Adds a load step. Without any, the model is solved once as it stands.
    ///
    /// # Errors
    /// [`ModelError::Step`] when the step does not speak of every support, load and contact, prescribes
    /// other components than the support does, gives a value that is not finite, or goes back in time.
    pub fn add_step(&mut self, step: Step) -> Result<&mut Self, ModelError> {
        let number = self.steps.len() + 1;
        let refuse = |reason: String| Err(ModelError::Step { number, reason });
        for (what, found, expected) in [
            ("supports", step.supports.len(), self.supports.len()),
            ("loads", step.loads.len(), self.loads.len()),
            ("obstacles", step.obstacles.len(), self.obstacles.len()),
            ("contacts", step.bounds.len(), self.contacts.len()),
        ] {
            if found != expected {
                return refuse(format!("expected {expected} {what}, found {found}"));
            }
        }
        if self.steps.last().is_some_and(|last| step.time <= last.time) || !step.time.is_finite() {
            return refuse(format!(
                "its time {} is not later than that before",
                step.time
            ));
        }
        for (support, amount) in self.supports.iter().zip(&step.supports) {
            if let Amount::Value(value) = amount
                && (0..3).any(|k| value[k].is_some() != support.components[k].is_some())
            {
                return refuse("a support must prescribe the same components in every step".into());
            }
        }
        let finite = |amount: &Amount<[f64; 3]>| match amount {
            Amount::Factor(factor) => factor.is_finite(),
            Amount::Value(value) => value.iter().all(|x| x.is_finite()),
        };
        let supports = step.supports.iter().map(|amount| match *amount {
            Amount::Factor(factor) => Amount::Factor(factor),
            Amount::Value(value) => Amount::Value(value.map(|x| x.unwrap_or(0.0))),
        });
        let vectors = step.loads.iter().chain(&step.obstacles).copied();
        if !vectors.chain(supports).all(|amount| finite(&amount)) {
            return refuse("a factor or a value is not a finite number".into());
        }
        for (contact, amount) in self.contacts.iter().zip(&step.bounds) {
            let (Amount::Factor(figure) | Amount::Value(figure)) = *amount;
            if !(figure.is_finite() && figure >= 0.0) {
                return refuse(format!("a slip bound must be a number ≥ 0, found {figure}"));
            }
            let replaceable = matches!(
                contact.friction,
                FrictionLaw::Tresca { .. } | FrictionLaw::Bilateral { bound: Some(_) }
            );
            let scalable =
                replaceable || matches!(contact.friction, FrictionLaw::Orthotropic { .. });
            let changes = *amount != Amount::Factor(1.0);
            if matches!(amount, Amount::Value(_)) && !replaceable || changes && !scalable {
                return refuse(format!(
                    "a contact with the law `{}` has no single slip bound to change",
                    contact.friction.name()
                ));
            }
        }
        self.steps.push(step);
        Ok(self)
    }

    /// The step that takes everything as the model gives it.
    pub fn whole_step(&self) -> Step {
        Step {
            time: 1.0,
            name: None,
            supports: vec![Amount::Factor(1.0); self.supports.len()],
            loads: vec![Amount::Factor(1.0); self.loads.len()],
            obstacles: vec![Amount::Factor(1.0); self.obstacles.len()],
            bounds: vec![Amount::Factor(1.0); self.contacts.len()],
        }
    }

    fn check_components(&self, value: &[f64; 3]) -> Result<(), ModelError> {
        if !value.iter().all(|component| component.is_finite()) {
            return Err(ModelError::NonFiniteValue { value: *value });
        }
        if self.dimension() == 2 && value[2] != 0.0 {
            return Err(ModelError::OutOfPlane);
        }
        Ok(())
    }

    fn resolve_all(&self, on: &[SurfaceRef<'_>]) -> Result<Vec<Surface>, ModelError> {
        on.iter().map(|&surface| self.resolve(surface)).collect()
    }

    /// The surface of that name.
    ///
    /// # Errors
    /// When the body or the face set does not exist.
    pub fn resolve(&self, surface: SurfaceRef<'_>) -> Result<Surface, ModelError> {
        self.resolve_among(surface, |mesh| mesh.face_sets.keys().collect())
    }

    /// The surface or the set of nodes of that name.
    ///
    /// # Errors
    /// When the body or the set does not exist.
    pub fn resolve_nodes(&self, place: SurfaceRef<'_>) -> Result<Surface, ModelError> {
        self.resolve_among(place, |mesh| {
            mesh.face_sets.keys().chain(mesh.node_sets.keys()).collect()
        })
    }

    fn resolve_among(
        &self,
        place: SurfaceRef<'_>,
        known: impl Fn(&Mesh) -> Vec<&String>,
    ) -> Result<Surface, ModelError> {
        let body = self.body(place.body)?;
        let known = known(&self.bodies[body].mesh);
        if !known.iter().any(|name| *name == place.faces) {
            return Err(ModelError::UnknownSurface {
                body: place.body.to_owned(),
                faces: place.faces.to_owned(),
                known: known.into_iter().cloned().collect(),
            });
        }
        Ok(Surface {
            body,
            faces: place.faces.to_owned(),
        })
    }

    /// The index of a body.
    ///
    /// # Errors
    /// When it does not exist.
    pub fn body(&self, name: &str) -> Result<usize, ModelError> {
        let index = self.bodies.iter().position(|body| body.name == name);
        index.ok_or_else(|| ModelError::UnknownBody {
            name: name.to_owned(),
            known: self.bodies.iter().map(|body| body.name.clone()).collect(),
        })
    }

    /// The index of an obstacle.
    ///
    /// # Errors
    /// When it does not exist.
    pub fn obstacle(&self, name: &str) -> Result<usize, ModelError> {
        let index = self.obstacles.iter().position(|own| own.name == name);
        index.ok_or_else(|| ModelError::UnknownObstacle {
            name: name.to_owned(),
            known: self.obstacles.iter().map(|own| own.name.clone()).collect(),
        })
    }

    /// The title.
    pub fn title(&self) -> &str {
        &self.title
    }

    /// The bodies, in the order in which they were added.
    pub fn bodies(&self) -> &[Body] {
        &self.bodies
    }

    /// The space that the bodies live in; [`Space::Solid`] as long as there is none.
    pub fn space(&self) -> Space {
        self.bodies
            .first()
            .map_or(Space::Solid, |body| body.mesh.space)
    }

    /// 2 or 3.
    pub fn dimension(&self) -> usize {
        self.bodies.first().map_or(3, |body| body.mesh.dimension())
    }

    /// The supports.
    pub fn supports(&self) -> &[Support] {
        &self.supports
    }

    /// The loads.
    pub fn loads(&self) -> &[Load] {
        &self.loads
    }

    /// The load steps; empty when the model is solved once as it stands.
    pub fn steps(&self) -> &[Step] {
        &self.steps
    }

    /// The obstacles.
    pub fn obstacles(&self) -> &[Obstacle] {
        &self.obstacles
    }

    /// The contacts.
    pub fn contacts(&self) -> &[Contact] {
        &self.contacts
    }

    /// The faces of a surface.
    pub fn faces(&self, surface: &Surface) -> &[Face] {
        &self.bodies[surface.body].mesh.face_sets[&surface.faces]
    }

    /// The nodes of a surface or of a set of nodes, ascending.
    pub fn nodes(&self, place: &Surface) -> Vec<usize> {
        let mesh = &self.bodies[place.body].mesh;
        match mesh.face_sets.get(&place.faces) {
            Some(faces) => mesh.nodes_of_faces(faces),
            None => mesh.node_sets[&place.faces].clone(),
        }
    }

    /// The master surface as `body.faces`, or the obstacle's name.
    pub fn partner_name(&self, partner: &Partner) -> String {
        match partner {
            Partner::Surface(surface) => self.surface_name(surface),
            Partner::Obstacle(obstacle) => self.obstacles[*obstacle].name.clone(),
        }
    }

    /// The surface as `body.faces`.
    pub fn surface_name(&self, surface: &Surface) -> String {
        format!("{}.{}", self.bodies[surface.body].name, surface.faces)
    }
}
