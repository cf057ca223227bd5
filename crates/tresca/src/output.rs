//! The result files of a run.

use std::path::Path;
use std::time::Instant;

use rayon::prelude::*;
use tresca_fem::stress;
use tresca_io::{CellType};
use crate::{Model, Outcome, Summary};
