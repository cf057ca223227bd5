//! Sets of files that appear together or not at all.
//!
//! Every file is written under a temporary name in the directory where it belongs, flushed and
//! forced to the disk. Only when all of them are complete, [`OutputSet::commit`] renames them, each
//! atomically. When a rename fails, those already done are taken back, so that the earlier set is
//! whole again. A run that is killed while renaming may leave a mixture of the two sets, but every
//! file is complete, old or new; stage the file that names the others last.

use std::fs::{self, File};
use std::io::{BufWriter, Write};
use std::path::{Path, PathBuf};

use tempfile::{NamedTempFile, TempPath};

use crate::error::WriteError;

const PREFIX: &str = ".tresca-";
const SUFFIX: &str = ".tmp";

/// Files on their way into a directory. Dropped without [`commit`](OutputSet::commit), it removes
/// what it wrote and leaves the directory as it was.
#[derive(Debug)]
pub struct OutputSet {
    directory: PathBuf,
    staged: Vec<Staged>,
}

#[derive(Debug)]
struct Staged {
    name: String,
    /// Closed: a run of many load steps has more files than a process may hold open.
    file: TempPath,
}

impl OutputSet {
    /// A set for the given directory, which is created with its parents where it is missing.
    ///
    /// # Errors
    /// [`WriteError::Io`] when that fails, also when a file stands in the way.
    pub fn new(directory: impl Into<PathBuf>) -> Result<Self, WriteError> {
        let directory = directory.into();
        fs::create_dir_all(&directory)
            .map_err(WriteError::io("create the directory", &directory))?;
        Ok(Self {
            directory,
            staged: Vec::new(),
        })
    }

    /// Writes one file under a temporary name. `write` gets a buffered stream.
    ///
    /// # Errors
    /// What `write` returns; [`WriteError::Name`] when `name` is not a plain file name or was staged
    /// before; [`WriteError::Io`] from the file system. The set stays as it was.
    pub fn stage(
        &mut self,
        name: &str,
        write: impl FnOnce(&mut dyn Write) -> Result<(), WriteError>,
    ) -> Result<(), WriteError> {
        self.check_name(name)?;
        let target = self.directory.join(name);
        let mut file = new_file(&self.directory).map_err(WriteError::io("create", &target))?;
        let mut stream = BufWriter::with_capacity(1 << 16, file.as_file_mut());
        write(&mut stream).map_err(|error| match error {
            // A stream does not know its file; here it is known.
            WriteError::Stream(source) => WriteError::io("write", &target)(source),
            other => other,
        })?;
        stream.flush().map_err(WriteError::io("write", &target))?;
        drop(stream);
        file.as_file()
            .sync_all()
            .map_err(WriteError::io("write", &target))?;
        self.staged.push(Staged {
            name: name.to_owned(),
            file: file.into_temp_path(),
        });
        Ok(())
    }

    /// Gives all files their names, in the order of staging, replacing earlier files. Returns the
    /// paths.
    ///
    /// # Errors
    /// [`WriteError::Io`]; the earlier files are then in place again.
    pub fn commit(self) -> Result<Vec<PathBuf>, WriteError> {
        let mut done: Vec<Renamed> = Vec::with_capacity(self.staged.len());
        for Staged { name, file } in self.staged {
            let target = self.directory.join(name);
            match rename(file, &target) {
                Ok(renamed) => done.push(renamed),
                Err(error) => {
                    for renamed in done.into_iter().rev() {
                        renamed.undo();
                    }
                    return Err(error);
                }
            }
        }
        sync_directory(&self.directory)
            .map_err(WriteError::io("write the directory", &self.directory))?;
        Ok(done.into_iter().map(|renamed| renamed.target).collect())
    }

    fn check_name(&self, name: &str) -> Result<(), WriteError> {
        let refuse = |reason| {
            Err(WriteError::Name {
                name: name.to_owned(),
                reason,
            })
        };
        if Path::new(name).file_name() != Some(name.as_ref()) {
            return refuse("it is not a plain file name");
        }
        if self.staged.iter().any(|staged| staged.name == name) {
            return refuse("it is already in the set");
        }
        Ok(())
    }
}

/// A file that has got its name, and what it replaced.
struct Renamed {
    target: PathBuf,
    /// The earlier file under another name; removed when dropped.
    earlier: Option<NamedTempFile<()>>,
}

impl Renamed {
    /// As far as possible: this runs when something has failed already.
    fn undo(self) {
        match self.earlier {
            Some(earlier) => drop(earlier.persist(&self.target)),
            None => drop(fs::remove_file(&self.target)),
        }
    }
}

fn rename(file: TempPath, target: &Path) -> Result<Renamed, WriteError> {
    let earlier = match fs::symlink_metadata(target) {
        Ok(_) => Some(keep_earlier(target).map_err(WriteError::io("keep the earlier", target))?),
        Err(_) => None,
    };
    file.persist(target)
        .map_err(|error| WriteError::io("replace", target)(error.error))?;
    Ok(Renamed {
        target: target.to_owned(),
        earlier,
    })
}

/// A second name for a file that is about to be replaced: a hard link, which costs nothing, or a
/// copy where the file system has no links.
fn keep_earlier(target: &Path) -> std::io::Result<NamedTempFile<()>> {
    let directory = target.parent().unwrap_or(Path::new("."));
    tempfile::Builder::new()
        .prefix(PREFIX)
        .suffix(SUFFIX)
        .make_in(directory, |path| match fs::hard_link(target, path) {
            Err(error) if error.kind() != std::io::ErrorKind::AlreadyExists => {
                fs::copy(target, path).map(drop)
            }
            linked => linked,
        })
}

fn new_file(directory: &Path) -> std::io::Result<NamedTempFile<File>> {
    let mut builder = tempfile::Builder::new();
    builder.prefix(PREFIX).suffix(SUFFIX);
    #[cfg(unix)]
    {
        // Results are for everyone the user lets in (umask); temporary files usually are not.
        use std::os::unix::fs::PermissionsExt;
        builder.permissions(fs::Permissions::from_mode(0o666));
    }
    builder.tempfile_in(directory)
}

/// Makes the names last through a loss of power, where the system offers that.
fn sync_directory(directory: &Path) -> std::io::Result<()> {
    #[cfg(unix)]
    File::open(directory)?.sync_all()?;
    #[cfg(not(unix))]
    let _ = directory;
    Ok(())
}
