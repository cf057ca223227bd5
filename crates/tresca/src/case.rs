//! From a case file to a model; errors of the model point back into the file.

use std::path::Path;

use tresca_contact::FrictionLaw;
use tresca_fem::material::Isotropic;
use tresca_fem::mesh::{self, BrickSpec};
use tresca_io::case::{self, CaseError, CaseFile, Friction, Mesh, SlipBound, Span, Surface};
use tresca_qcqp::{QcqpError, Settings};

use crate::ModelError;
use crate::model::{Model, SurfaceRef};

/// A case file, read and checked, with the model it describes.
#[derive(Debug)]
pub struct Case {
    file: CaseFile<Settings>,
    /// The model.
    pub model: Model,
}

impl Case {
    /// Reads a case file.
    ///
    /// # Errors
    /// Everything that is wrong with the file, at its line and column.
    pub fn load(path: impl AsRef<Path>) -> Result<Self, CaseError> {
        Self::from_file(case::read(path)?)
    }

    /// Reads a case from its text; `name` is what error messages call it.
    ///
    /// # Errors
    /// As [`Case::load`].
    pub fn parse(name: &str, text: &str) -> Result<Self, CaseError> {
        Self::from_file(case::parse(name, text)?)
    }

    /// The solver settings of the case file.
    pub fn settings(&self) -> &Settings {
        &self.file.solver
    }

    fn from_file(file: CaseFile<Settings>) -> Result<Self, CaseError> {
        if let Err(error) = file.solver.validate() {
            return Err(setting_error(&file, &error));
        }
        let model = build(&file)?;
        Ok(Self { file, model })
    }

    /// Points an error of the model at the place in the case file that it speaks of.
    pub fn locate(&self, error: &ModelError) -> CaseError {
        locate(&self.file, error)
    }
}

fn setting_error(file: &CaseFile<Settings>, error: &QcqpError) -> CaseError {
    let (name, allowed) = match error {
        QcqpError::Setting { name, allowed, .. } => (*name, allowed.as_str()),
        _ => ("", ""),
    };
    let span = file
        .source
        .locate(&format!("solver.{name}"))
        .unwrap_or(0..0);
    CaseError::semantic(
        &file.source,
        span,
        error.to_string(),
        format!("expected {allowed}"),
        "`tresca options` lists every setting with its default and its range",
    )
}

fn build(file: &CaseFile<Settings>) -> Result<Model, CaseError> {
    let mut model = Model::new(&file.title);
    for body in &file.bodies {
        let at_mesh = |error: tresca_fem::FemError| {
            let help =
                "a brick is given by its corners `min` < `max` and by 2 or more `nodes` per axis";
            CaseError::semantic(
                &file.source,
                body.mesh.span(),
                error.to_string(),
                "this mesh",
                help,
            )
        };
        let mesh = match body.mesh.get_ref() {
            Mesh::Brick(brick) => mesh::brick(&BrickSpec {
                min: brick.min.get_ref().values(),
                max: brick.max.get_ref().values(),
                nodes: brick.nodes.get_ref().values(),
            }),
        }
        .map_err(at_mesh)?;
        let constants = body.material.get_ref();
        let material = Isotropic::new(*constants.young.get_ref(), *constants.poisson.get_ref())
            .map_err(|error| {
                let help = "a material needs `young` > 0 and −1 < `poisson` < 0.5";
                let span = body.material.span();
                CaseError::semantic(&file.source, span, error.to_string(), "this material", help)
            })?;
        model
            .add_body(body.name.get_ref(), mesh, material)
            .map_err(|error| locate(file, &error))?;
    }
    let name = |surface: &Surface| file.bodies[surface.body].name.get_ref().clone();
    let added = |error: ModelError, span: &Span| {
        CaseError::semantic(&file.source, span.clone(), error.to_string(), "here", "")
    };
    for surface in file.clamps.iter().flat_map(|clamp| &clamp.on) {
        let body = name(surface);
        model
            .clamp(SurfaceRef {
                body: &body,
                faces: &surface.face,
            })
            .map_err(|error| added(error, &surface.span))?;
    }
    for traction in &file.tractions {
        let value = traction.value.get_ref().values();
        for surface in &traction.on {
            let body = name(surface);
            model
                .add_traction(
                    &[SurfaceRef {
                        body: &body,
                        faces: &surface.face,
                    }],
                    value,
                )
                .map_err(|error| added(error, &surface.span))?;
        }
    }
    for contact in &file.contacts {
        let (slave, master) = (name(&contact.slave), name(&contact.master));
        let friction = match &contact.friction {
            Friction::Tresca { bound } => match bound.get_ref() {
                SlipBound::Constant(bound) => FrictionLaw::Tresca { bound: *bound },
            },
        };
        model
            .add_contact(
                SurfaceRef {
                    body: &slave,
                    faces: &contact.slave.face,
                },
                SurfaceRef {
                    body: &master,
                    faces: &contact.master.face,
                },
                friction,
            )
            .map_err(|error| added(error, &contact.span))?;
    }
    Ok(model)
}

fn locate(file: &CaseFile<Settings>, error: &ModelError) -> CaseError {
    let body_name = |name: &str| {
        file.bodies
            .iter()
            .find(|body| body.name.get_ref() == name)
            .map_or(0..0, |body| body.name.span())
    };
    let (span, label, help) = match error {
        ModelError::Floating { body, .. } => (
            body_name(body),
            "this body can move without resistance".to_owned(),
            format!(
                "clamp a surface of it, for example `on = [\"{body}.x-\"]` in a [[clamp]] table"
            ),
        ),
        ModelError::Coupling { contact, .. } => (
            file.contacts[*contact].span.clone(),
            "the nodes of the two surfaces must lie on one another".to_owned(),
            "give both surfaces the same extent and the same number of nodes; surfaces that are \
             meshed apart are not supported yet"
                .to_owned(),
        ),
        ModelError::NoContact => (
            0..0,
            "no [[contact]] table in this file".to_owned(),
            "add a [[contact]] with `pair` and `friction`".to_owned(),
        ),
        ModelError::Body { body, .. }
        | ModelError::Factorization { body, .. }
        | ModelError::DuplicateBody { name: body } => {
            (body_name(body), "this body".to_owned(), String::new())
        }
        _ => (0..0, "in this file".to_owned(), String::new()),
    };
    CaseError::semantic(&file.source, span, error.to_string(), label, help)
}
