//! The whole file: its tables, in the order of the documentation, and the order in which they are read.

use std::collections::HashMap;
use std::path::Path;

use serde::Deserialize;
use serde::de::DeserializeOwned;
use tresca_io::located::SourceText;
use tresca_model::Model;

use crate::analysis::Analysis;
use crate::body::BodyKeys;
use crate::contact::ContactKeys;
use crate::error::CaseError;
use crate::friction::known_laws;
use crate::load;
use crate::obstacle::ObstacleKeys;
use crate::origins::Origins;
use crate::reader::Reader;
use crate::step::StepKeys;
use crate::support::{ClampKeys, SupportKeys};
use crate::text;
use crate::text::at::At;

macro_rules! file_keys {
    ($($(#[$doc:meta])* $load:ident::$keys:ident,)*) => {
        /// The whole file.
        #[derive(Debug, Deserialize)]
        #[serde(
            deny_unknown_fields,
            bound = "S: DeserializeOwned + Default",
            expecting = "a case file"
        )]
        struct FileKeys<S> {
            /// Headline of reports. Default: the name of the file.
            title: Option<String>,
            /// What the coordinates mean. Default: `solid`.
            analysis: Option<At<Analysis>>,
            /// The elastic bodies; at least one.
            body: Option<At<Vec<BodyKeys>>>,
            /// Surfaces that are held.
            #[serde(default)]
            clamp: Vec<ClampKeys>,
            /// Surfaces of which some displacement components are prescribed.
            #[serde(default)]
            support: Vec<At<SupportKeys>>,
            $($(#[$doc])* #[serde(default)] $load: Vec<At<load::$keys>>,)*
            /// Rigid bodies that the others may touch.
            #[serde(default)]
            obstacle: Vec<At<ObstacleKeys>>,
            /// Pairs of surfaces that may touch.
            #[serde(default)]
            contact: Vec<At<ContactKeys>>,
            /// The history of loading.
            #[serde(default)]
            step: Vec<At<StepKeys>>,
            /// Settings of the solver; the keys are those of the caller's type.
            #[serde(default)]
            solver: S,
        }

        fn fill<S>(keys: FileKeys<S>, reader: &mut Reader<'_>) -> Result<S, CaseError> {
            reader.bodies(keys.body)?;
            reader.supports(keys.clamp, keys.support)?;
            $(reader.loads(&keys.$load)?;)*
            reader.obstacles(keys.obstacle)?;
            reader.contacts(keys.contact)?;
            reader.steps(keys.step)?;
            Ok(keys.solver)
        }
    };
}

load::kinds_of_loads!(file_keys);

/// The model of a text with the places of its parts, and the solver's settings.
pub(crate) fn read<S: DeserializeOwned + Default>(
    source: &SourceText,
) -> Result<(Model, Origins, S), CaseError> {
    let keys: FileKeys<S> = text::read(source, |root| known_laws(source, root))?;
    let title = keys.title.clone().unwrap_or_else(|| {
        Path::new(source.name())
            .file_stem()
            .map_or_else(String::new, |stem| stem.to_string_lossy().into_owned())
    });
    let mut reader = Reader {
        source,
        analysis: keys
            .analysis
            .as_ref()
            .map_or_else(Analysis::default, |a| a.value),
        analysis_span: keys.analysis.as_ref().map(At::span),
        mesh_files: HashMap::new(),
        model: Model::new(title),
        origins: Origins::default(),
    };
    let solver = fill(keys, &mut reader)?;
    Ok((reader.model, reader.origins, solver))
}
