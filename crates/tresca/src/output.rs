//! The result files of a run.

use std::path::Path;
use std::time::Instant;

use crate::{Model, Outcome, Summary};
use rayon::prelude::*;
use tresca_fem::stress;
use tresca_io::CellType;
