//! The model, built piece by piece; each piece is checked as it is added.

use tresca_contact::{FrictionLaw, facing_surfaces};
use tresca_fem::mesh::{Face, Space};

use crate::amount::{Amount, Shape};
use crate::body::{Bodies, Body};
use crate::contact::{Contact, ContactWithin, Partner};
use crate::error::ModelError;
use crate::identity::{ContactId, LoadId, ObstacleId, Quantity, SupportId};
use crate::load::Load;
use crate::load::kind::Share;
use crate::obstacle::Obstacle;
use crate::place::{Place, PlaceName, PlaceNames};
use crate::step::Step;
use crate::support::Support;

/// Bodies with supports, loads, contacts and load steps, every name found.
///
/// Units are the user's: any consistent system (mm, N, MPa or m, MN, MPa, …).
#[derive(Debug, Clone, Default)]
pub struct Model {
    title: String,
    bodies: Bodies,
    supports: Vec<Support>,
    loads: Vec<Load>,
    obstacles: Vec<Obstacle>,
    contacts: Vec<Contact>,
    steps: Vec<Step>,
}

/// Building.
impl Model {
    /// An empty model.
    pub fn new(title: impl Into<String>) -> Self {
        Self {
            title: title.into(),
            ..Self::default()
        }
    }

    /// Adds a body and returns its index.
    ///
    /// # Errors
    /// When the name is taken, the other bodies live in another space, or the density is no number ≥ 0.
    pub fn add_body(&mut self, body: Body) -> Result<usize, ModelError> {
        self.check_new_name(&body.name)?;
        if let Some(first) = self.bodies.first()
            && first.mesh.space != body.mesh.space
        {
            return Err(ModelError::MixedSpaces {
                first: first.name.clone(),
                second: body.name,
            });
        }
        if let Some(density) = body.density
            && !(density.is_finite() && density >= 0.0)
        {
            return Err(ModelError::Density {
                body: body.name,
                density,
            });
        }
        self.bodies.0.push(body);
        Ok(self.bodies.len() - 1)
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

    /// Adds a support.
    ///
    /// # Errors
    /// When one of its places does not exist, or a displacement is not finite or along z in the plane.
    pub fn add_support(&mut self, support: Support<PlaceName>) -> Result<SupportId, ModelError> {
        let mut components = support.components;
        if self.dimension() == 2 {
            // A clamp holds what there is.
            components[2] = components[2].filter(|&z| z != 0.0);
        }
        let vector = components.map(|value| value.unwrap_or(0.0));
        self.bodies.check_vector(&vector)?;
        let on = support.on.iter().map(|name| self.bodies.place(name));
        self.supports.push(Support {
            on: on.collect::<Result<_, _>>()?,
            name: support.name,
            components,
        });
        Ok(SupportId(self.supports.len() - 1))
    }

    /// Adds a load.
    ///
    /// # Errors
    /// When one of its places does not exist, a constant is not finite or has a part out of the plane, or weight acts
    /// on a body without density.
    pub fn add_load(&mut self, load: Load<PlaceNames>) -> Result<LoadId, ModelError> {
        self.loads.push(load.found(&self.bodies)?);
        Ok(LoadId(self.loads.len() - 1))
    }

    /// Adds a rigid obstacle that bodies may touch.
    ///
    /// # Errors
    /// When the name is taken, or its motion is not finite or leaves the plane.
    pub fn add_obstacle(&mut self, obstacle: Obstacle) -> Result<ObstacleId, ModelError> {
        self.check_new_name(&obstacle.name)?;
        self.bodies
            .check_vector(&obstacle.motion.unwrap_or_default())?;
        self.obstacles.push(obstacle);
        Ok(ObstacleId(self.obstacles.len() - 1))
    }

    /// Lets a surface touch that of another body, or an obstacle.
    ///
    /// # Errors
    /// When a surface or the obstacle does not exist, both sides lie on one body, or the law has impossible figures.
    pub fn add_contact(
        &mut self,
        contact: Contact<PlaceName, PlaceName>,
    ) -> Result<ContactId, ModelError> {
        contact.friction.validate()?;
        if self.dimension() == 2 && matches!(contact.friction, FrictionLaw::Orthotropic { .. }) {
            return Err(ModelError::OrthotropicInThePlane);
        }
        let slave = self.bodies.surface(&contact.slave)?;
        let master = match contact.master.set {
            Some(_) => Partner::Surface(self.bodies.surface(&contact.master)?),
            None => Partner::Obstacle(self.obstacle(&contact.master.owner)?),
        };
        if master
            .surface()
            .is_some_and(|master| master.body == slave.body)
        {
            return Err(ModelError::SelfContact {
                body: self.bodies[slave.body].name.clone(),
            });
        }
        self.contacts.push(contact.between(slave, master));
        Ok(ContactId(self.contacts.len() - 1))
    }

    /// Lets the exterior surfaces of bodies touch where they face one another within a distance: one contact for each
    /// two bodies that come so close. The faces become face sets of the two bodies, each named `near` and the other
    /// body's name with a colon between; the body added first is the slave.
    ///
    /// # Errors
    /// When a body does not exist, no two bodies come so close, or as [`Model::add_contact`].
    pub fn add_contacts_within(
        &mut self,
        contact: ContactWithin,
    ) -> Result<Vec<ContactId>, ModelError> {
        let distance = contact.slave.distance;
        let named = contact.slave.bodies.0.iter();
        let named = named.map(|name| self.bodies.index(&name.to_string()));
        let mut chosen = named.collect::<Result<Vec<_>, _>>()?;
        if chosen.is_empty() {
            chosen.extend(0..self.bodies.len());
        }
        chosen.sort_unstable();
        chosen.dedup();
        let mut found = Vec::new();
        for (k, &slave) in chosen.iter().enumerate() {
            for &master in &chosen[k + 1..] {
                let meshes = [slave, master].map(|body| &self.bodies[body].mesh);
                let faces = facing_surfaces(meshes[0], meshes[1], distance)?;
                if !faces.0.is_empty() {
                    found.push(([slave, master], faces));
                }
            }
        }
        if found.is_empty() {
            return Err(ModelError::NothingWithin { distance });
        }
        let add = |([slave, master], faces): ([usize; 2], (Vec<Face>, Vec<Face>))| {
            let slave = self.add_near_faces(slave, master, faces.0);
            let master = self.add_near_faces(master, slave.0, faces.1);
            let near = contact.clone().between(slave.1, master.1);
            self.add_contact(near.search(distance))
        };
        found.into_iter().map(add).collect()
    }

    /// Names the faces of a body that are near another one; with the body's index.
    fn add_near_faces(
        &mut self,
        body: usize,
        other: usize,
        faces: Vec<Face>,
    ) -> (usize, PlaceName) {
        let set = format!("near:{}", self.bodies[other].name);
        let body_of_faces = &mut self.bodies.0[body];
        body_of_faces.mesh.face_sets.insert(set.clone(), faces);
        let owner = body_of_faces.name.clone();
        let set = Some(set);
        (body, PlaceName { owner, set })
    }

    /// Adds a load step. Without any, the model is solved once as it stands.
    ///
    /// # Errors
    /// [`ModelError::Step`] when the step speaks of something that does not exist, gives a number for a vector or the
    /// other way round, gives a value that is not finite, changes a slip bound that the law does not have, or goes back
    /// in time.
    pub fn add_step(&mut self, step: Step) -> Result<&mut Self, ModelError> {
        let number = self.steps.len() + 1;
        let refuse = |reason: String| Err(ModelError::Step { number, reason });
        if self.steps.last().is_some_and(|last| step.time <= last.time) || !step.time.is_finite() {
            return refuse(format!(
                "its time {} is not later than that before",
                step.time
            ));
        }
        for (&quantity, &amount) in &step.amounts {
            if let Err(reason) = self.check_amount(quantity, amount) {
                return refuse(reason);
            }
        }
        self.steps.push(step);
        Ok(self)
    }

    fn check_amount(&self, quantity: Quantity, amount: Amount) -> Result<(), String> {
        let exists = match quantity {
            Quantity::Support(id) => id.0 < self.supports.len(),
            Quantity::Load(id) => id.0 < self.loads.len(),
            Quantity::Motion(id) => id.0 < self.obstacles.len(),
            Quantity::SlipBound(id) => id.0 < self.contacts.len(),
        };
        if !exists {
            return Err(format!("the model has no {quantity:?}"));
        }
        if let Quantity::SlipBound(ContactId(contact)) = quantity {
            return check_slip_bound(&self.contacts[contact], amount);
        }
        if !amount.is_finite() {
            return Err("a factor or a value is not a finite number".into());
        }
        if amount.shape().is_some() && amount.shape() != self.shape(quantity) {
            return Err(format!("{quantity:?} does not take {amount:?}"));
        }
        Ok(())
    }
}

fn check_slip_bound(contact: &Contact, amount: Amount) -> Result<(), String> {
    let no_single_bound = || {
        Err(format!(
            "a contact with the law `{}` has no single slip bound to change",
            contact.friction.name()
        ))
    };
    let figure = match amount {
        Amount::Factor(1.0) => return Ok(()),
        Amount::Factor(factor) if contact.has_bounds() => factor,
        Amount::Scalar(bound) if contact.shape().is_some() => bound,
        _ => return no_single_bound(),
    };
    match figure.is_finite() && figure >= 0.0 {
        true => Ok(()),
        false => Err(format!("a slip bound must be a number ≥ 0, found {figure}")),
    }
}

/// Looking at it.
impl Model {
    /// The title.
    pub fn title(&self) -> &str {
        &self.title
    }

    /// The bodies, in the order in which they were added.
    pub fn bodies(&self) -> &Bodies {
        &self.bodies
    }

    /// The supports.
    pub fn supports(&self) -> &[Support] {
        &self.supports
    }

    /// The loads.
    pub fn loads(&self) -> &[Load] {
        &self.loads
    }

    /// The obstacles.
    pub fn obstacles(&self) -> &[Obstacle] {
        &self.obstacles
    }

    /// The contacts.
    pub fn contacts(&self) -> &[Contact] {
        &self.contacts
    }

    /// The load steps; empty when the model is solved once as it stands.
    pub fn steps(&self) -> &[Step] {
        &self.steps
    }

    /// The step that takes everything as the model gives it.
    pub fn whole_step(&self) -> Step {
        Step::new(1.0)
    }

    /// The space that the bodies live in; [`Space::Solid`] as long as there is none.
    pub fn space(&self) -> Space {
        self.bodies.space()
    }

    /// 2 or 3.
    pub fn dimension(&self) -> usize {
        self.bodies.dimension()
    }

    /// The index of a body.
    ///
    /// # Errors
    /// When it does not exist.
    pub fn body(&self, name: &str) -> Result<usize, ModelError> {
        self.bodies.index(name)
    }

    /// An obstacle by its name.
    ///
    /// # Errors
    /// When it does not exist.
    pub fn obstacle(&self, name: &str) -> Result<ObstacleId, ModelError> {
        let index = self.obstacles.iter().position(|own| own.name == name);
        index
            .map(ObstacleId)
            .ok_or_else(|| ModelError::UnknownObstacle {
                name: name.to_owned(),
                known: self.obstacles.iter().map(|own| own.name.clone()).collect(),
            })
    }

    /// Everything that load steps may change: of supports, loads, obstacles and contacts, in this order.
    pub fn quantities(&self) -> impl Iterator<Item = Quantity> {
        let supports = (0..self.supports.len()).map(|i| SupportId(i).into());
        let loads = (0..self.loads.len()).map(|i| LoadId(i).into());
        let motions = (0..self.obstacles.len()).map(|i| ObstacleId(i).into());
        let bounds = (0..self.contacts.len()).map(|i| ContactId(i).into());
        supports.chain(loads).chain(motions).chain(bounds)
    }

    /// What load steps can put in the place of a quantity; `None` where they can only scale it, or not even that.
    pub fn shape(&self, quantity: Quantity) -> Option<Shape> {
        match quantity {
            Quantity::Support(_) | Quantity::Motion(_) => Some(Shape::Vector),
            Quantity::Load(id) => Some(self.loads[id.0].kind.traits().shape),
            Quantity::SlipBound(id) => self.contacts[id.0].shape(),
        }
    }

    /// The model's own value of a quantity, where it is the same everywhere.
    pub fn constant(&self, quantity: Quantity) -> Option<Amount> {
        match quantity {
            Quantity::Support(id) => Some(Amount::Vector(self.supports[id.0].vector())),
            Quantity::Load(id) => self.loads[id.0].kind.constant(),
            Quantity::Motion(id) => Some(Amount::Vector(
                self.obstacles[id.0].motion_by(Amount::WHOLE),
            )),
            Quantity::SlipBound(id) => self.contacts[id.0].constant(),
        }
    }

    /// Adds an amount of a load to the forces at the dofs of a body, held ones too.
    pub fn add_forces(&self, load: LoadId, body: usize, amount: Amount, forces: &mut [f64]) {
        let Load { on, kind, .. } = &self.loads[load.0];
        let bodies = &self.bodies;
        kind.add_forces(&Share { on, bodies, body }, amount, forces);
    }

    /// The faces of a surface.
    pub fn faces(&self, surface: &Place) -> &[Face] {
        self.bodies.faces(surface)
    }

    /// The nodes of a set of faces or nodes, ascending.
    pub fn nodes(&self, place: &Place) -> Vec<usize> {
        self.bodies.nodes(place)
    }

    /// The place as `body.set`.
    pub fn surface_name(&self, place: &Place) -> String {
        format!("{}.{}", self.bodies[place.body].name, place.set)
    }

    /// The master surface as `body.set`, or the obstacle's name.
    pub fn partner_name(&self, partner: &Partner) -> String {
        match partner {
            Partner::Surface(surface) => self.surface_name(surface),
            Partner::Obstacle(obstacle) => self.obstacles[obstacle.0].name.clone(),
        }
    }
}
