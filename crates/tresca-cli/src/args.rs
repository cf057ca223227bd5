//! The command line. What a solver option means and what its default is comes from
//! [`Settings::options`]: nothing about it is said twice.

use std::num::NonZeroUsize;
use std::path::{Path, PathBuf};

use clap::{Args, Parser, Subcommand, ValueEnum};
use miette::{IntoDiagnostic, WrapErr, miette};
use tresca::{Engine, Method, Settings};

/// Elastic bodies that touch and rub: contact with Tresca friction.
#[derive(Debug, Parser)]
#[command(name = "tresca", version, propagate_version = true)]
pub struct Arguments {
    #[command(subcommand)]
    pub command: Command,
}

#[derive(Debug, Subcommand)]
pub enum Command {
    /// Solve a case file, or a problem given as matrices (our own files, FCLIB, Siconos); write fields, history and summary.
    ///
    /// Exit code 0: converged. 1: not converged or interrupted; the results are written and
    /// marked. 2: wrong input; nothing is written. 130: interrupted before there was a result.
    Solve(SolveArguments),
    /// Read a case with its meshes and say what was understood, without solving it: bodies, surfaces,
    /// supports, loads and their resultants, contacts with their gaps, rigid motions that are left; write grids
    /// of it.
    ///
    /// Exit code 0: understood. 2: wrong input; nothing is written.
    Check(CheckArguments),
    /// Write the assembled matrices of a case: K by bodies, N, T, load, gaps, friction.
    Export(ExportArguments),
    /// Reproduce published experiments.
    Bench(BenchArguments),
    /// List every solver option with its meaning, default and range.
    Options(OptionsArguments),
}

#[derive(Debug, Args)]
pub struct SolveArguments {
    /// The case file (TOML; see docs/case-file.md), or matrices: an .npz archive or a directory of
    /// Matrix Market files (see docs/problem-files.md), a problem of FCLIB (.hdf5, .h5) or Siconos (.dat;
    /// see docs/fclib.md).
    pub case: PathBuf,
    /// Directory for the results (default: `out/` and the case's name).
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
    /// Problems of FCLIB and Siconos: the law of friction (default: coulomb, as they are posed).
    #[arg(long, value_name = "LAW")]
    pub law: Option<FclibLawArg>,
    /// With `--law tresca`: the slip bound of every contact, a force.
    #[arg(long, value_name = "FORCE", allow_negative_numbers = true)]
    pub bound: Option<f64>,
    #[command(flatten)]
    pub solver: SolverArguments,
    /// Number of threads (default: all processors).
    #[arg(long, value_name = "N")]
    pub threads: Option<NonZeroUsize>,
    /// Print nothing but errors.
    #[arg(short, long, conflicts_with = "verbose")]
    pub quiet: bool,
    /// Print the settings, the choice of the engine and the cost of the factorisation, too.
    #[arg(short, long)]
    pub verbose: bool,
}

#[derive(Debug, Args)]
pub struct CheckArguments {
    /// The case file (TOML; see docs/case-file.md).
    pub case: PathBuf,
    /// Directory for the grids and `check.json` (default: `out/` and the case's name with `-check`).
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
    /// Print only, write nothing.
    #[arg(long, conflicts_with = "out")]
    pub dry: bool,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum FclibLawArg {
    /// The bound is the coefficient of friction times the normal force.
    Coulomb,
    /// The bound is given.
    Tresca,
}

#[derive(Debug, Args)]
pub struct ExportArguments {
    /// The case file (TOML; see docs/case-file.md).
    pub case: PathBuf,
    /// Where to: `<name>.npz` for a NumPy archive, `.hdf5` or `.h5` for FCLIB, `.dat` for the text of
    /// Siconos (both of them W, q and μ, for Coulomb friction or none), else a directory for Matrix Market
    /// files.
    #[arg(long, value_name = "PATH")]
    pub to: PathBuf,
    /// Number of the load step, from 1; needed when the case has several. The slip of the steps before is
    /// not known and taken as zero.
    #[arg(long, value_name = "N")]
    pub step: Option<NonZeroUsize>,
}

/// Options that override those of the case file.
#[derive(Debug, Args)]
pub struct SolverArguments {
    #[arg(long, value_name = "NAME", help = option_help("method"))]
    pub method: Option<Method>,
    #[arg(long, value_name = "EPS", help = option_help("tolerance"))]
    pub tolerance: Option<f64>,
    #[arg(long, value_name = "N", help = option_help("max_iterations"))]
    pub max_iterations: Option<usize>,
    #[arg(long, value_name = "NAME", help = option_help("engine"))]
    pub engine: Option<Engine>,
    /// Any solver option, as under `[solver]` in the case file; `tresca options` lists them.
    #[arg(long = "set", value_name = "KEY=VALUE")]
    pub set: Vec<String>,
}

#[derive(Debug, Args)]
pub struct BenchArguments {
    #[command(subcommand)]
    pub experiment: Experiment,
}

#[derive(Debug, Subcommand)]
pub enum Experiment {
    /// Two bricks: iterations and multiplications by A of IMSSN, SSN, APGD and GRSSN beside the
    /// published counts, with times, memory and the ratio to one linear solve.
    Table1(Table1Arguments),
    /// Two bricks with Coulomb's law: updates of the bounds and multiplications by A of both variants,
    /// beside one solve with the final bounds frozen.
    Coulomb(CoulombArguments),
    /// Cases of your own: iterations and multiplications by A, reading, contact search, the whole run with
    /// its files beside one linear solve of the same bodies, peak memory.
    Case(CaseArguments),
    /// Random problems of many kinds, each answer judged by an independent oracle (Clarabel, statics,
    /// Gauss–Seidel).
    ///
    /// Exit code 1 for any wrong answer, more than 0.1 % of undecided ones, or a median n_A that rose.
    Campaign(CampaignArguments),
}

#[derive(Debug, Args)]
pub struct CampaignArguments {
    /// Number of problems.
    #[arg(long, value_name = "N", default_value_t = 10_000)]
    pub problems: usize,
    /// From which they are drawn.
    #[arg(long, value_name = "SEED", default_value_t = 1)]
    pub seed: u64,
    /// Take the seed from the clock; it is printed.
    #[arg(long, conflicts_with = "seed")]
    pub fresh: bool,
    /// These kinds only.
    #[arg(long, value_name = "KIND", value_delimiter = ',')]
    pub kind: Vec<String>,
    /// List the kinds.
    #[arg(long)]
    pub kinds: bool,
    /// The one problem of `--kind` with this seed, which is its own (disagreements print it), with its iterations.
    #[arg(long, value_name = "SEED")]
    pub only: Option<u64>,
    /// Print the table as Markdown.
    #[arg(long)]
    pub markdown: bool,
    /// Print the table only.
    #[arg(short, long)]
    pub quiet: bool,
    /// Number of threads (default: all processors).
    #[arg(long, value_name = "N")]
    pub threads: Option<NonZeroUsize>,
}

#[derive(Debug, Args)]
pub struct CaseArguments {
    /// Case files, for example one case on finer and finer meshes.
    #[arg(required = true)]
    pub cases: Vec<PathBuf>,
    #[command(flatten)]
    pub solver: SolverArguments,
    /// Number of threads (default: all processors).
    #[arg(long, value_name = "N")]
    pub threads: Option<NonZeroUsize>,
}

#[derive(Debug, Args)]
pub struct Table1Arguments {
    /// Nodes per edge of each brick.
    #[arg(long, value_delimiter = ',', default_values_t = [16, 21, 26, 31, 36, 41])]
    pub sizes: Vec<usize>,
    /// Tolerances; GRSSN and APGD run for each of them.
    #[arg(long, value_delimiter = ',', default_values_t = [1e-6, 1e-10])]
    pub tolerance: Vec<f64>,
    /// Tolerance of IMSSN and SSN.
    #[arg(long, default_value_t = 1e-4)]
    pub paper_tolerance: f64,
    #[arg(long, value_name = "NAME", default_value_t = Engine::Condensed, help = option_help("engine"))]
    pub engine: Engine,
    /// Number of threads (default: all processors).
    #[arg(long, value_name = "N")]
    pub threads: Option<NonZeroUsize>,
    /// Leave out IMSSN, SSN and APGD: GRSSN and the ratio to the linear solve alone.
    #[arg(long)]
    pub grssn_only: bool,
}

#[derive(Debug, Args)]
pub struct CoulombArguments {
    /// Nodes per edge of each brick.
    #[arg(long, value_delimiter = ',', default_values_t = [16, 21])]
    pub sizes: Vec<usize>,
    /// Friction coefficients.
    #[arg(long, value_delimiter = ',', default_values_t = [0.1, 0.3, 0.6, 1.0])]
    pub coefficients: Vec<f64>,
    /// Tolerance of all solves.
    #[arg(long, default_value_t = 1e-6)]
    pub tolerance: f64,
    /// Number of threads (default: all processors).
    #[arg(long, value_name = "N")]
    pub threads: Option<NonZeroUsize>,
}

#[derive(Debug, Args)]
pub struct OptionsArguments {
    /// Output format.
    #[arg(long, value_enum, default_value_t = Format::Text)]
    pub format: Format,
}

#[derive(Debug, Clone, Copy, ValueEnum)]
pub enum Format {
    /// For the terminal.
    Text,
    /// The table of docs/options.md.
    Markdown,
}

/// The help text of a solver option.
fn option_help(name: &str) -> String {
    Settings::options()
        .iter()
        .find(|option| option.name == name)
        .map(|option| {
            format!(
                "{} ({}) [default: {}]",
                option.doc, option.allowed, option.default
            )
        })
        .unwrap_or_default()
}

impl SolverArguments {
    /// The settings of the case file with the command line's on top.
    pub fn over(&self, mut settings: Settings) -> miette::Result<Settings> {
        if !self.set.is_empty() {
            settings = with_assignments(&settings, &self.set)?;
        }
        settings.method = self.method.unwrap_or(settings.method);
        settings.tolerance = self.tolerance.unwrap_or(settings.tolerance);
        settings.max_iterations = self.max_iterations.unwrap_or(settings.max_iterations);
        settings.engine = self.engine.unwrap_or(settings.engine);
        settings.validate().into_diagnostic()?;
        Ok(settings)
    }
}

/// The settings with values by name in the place of some.
fn with_assignments(settings: &Settings, assignments: &[String]) -> miette::Result<Settings> {
    let mut table = toml::Table::try_from(settings).into_diagnostic()?;
    for assignment in assignments {
        table.extend(addition(assignment)?);
    }
    table
        .try_into()
        .map_err(|error| miette!("in the options given by --set: {error}"))
}

/// `key=value` with the value as in a case file; shells take quotes away, so names need none.
fn addition(assignment: &str) -> miette::Result<toml::Table> {
    let read = assignment.parse::<toml::Table>().or_else(|error| {
        let is_name = |c: char| c.is_ascii_alphanumeric() || c == '_';
        match assignment.split_once('=') {
            Some((key, value)) if value.trim().chars().all(is_name) => {
                format!("{key} = \"{}\"", value.trim()).parse()
            }
            _ => Err(error),
        }
    });
    read.into_diagnostic()
        .wrap_err_with(|| format!("cannot read `--set {assignment}`: expected key=value"))
}

/// Sets the number of threads for everything that follows.
pub fn use_threads(threads: Option<NonZeroUsize>) -> miette::Result<()> {
    let Some(threads) = threads else {
        return Ok(());
    };
    rayon::ThreadPoolBuilder::new()
        .num_threads(threads.get())
        .build_global()
        .into_diagnostic()
        .wrap_err("cannot start the threads")
}

/// What a run is called: the name of its file without the extension, or of its folder.
pub fn run_name(path: &Path) -> miette::Result<String> {
    // A folder may be called `.`, or end in `..`.
    let full = match path.is_dir() {
        true => path.canonicalize().into_diagnostic()?,
        false => path.to_owned(),
    };
    full.file_stem()
        .and_then(|stem| stem.to_str())
        .map(str::to_owned)
        .ok_or_else(|| miette!("`{}` is not the name of a file", path.display()))
}
