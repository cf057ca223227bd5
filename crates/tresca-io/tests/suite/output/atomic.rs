//! Sets of files appear together or not at all.

use std::fs;
use std::path::Path;

use tresca_io::WriteError;
use tresca_io::atomic::OutputSet;

fn stage(set: &mut OutputSet, name: &str, text: &str) {
    set.stage(name, |out| Ok(write!(out, "{text}")?)).unwrap();
}

/// Name and text of everything in a directory, hidden files included, in order.
fn contents(directory: &Path) -> Vec<(String, String)> {
    let mut files: Vec<_> = fs::read_dir(directory)
        .unwrap()
        .map(|entry| entry.unwrap())
        .map(|entry| {
            let name = entry.file_name().into_string().unwrap();
            (
                name,
                fs::read_to_string(entry.path()).unwrap_or("directory".into()),
            )
        })
        .collect();
    files.sort();
    files
}

fn listed(files: &[(&str, &str)]) -> Vec<(String, String)> {
    files
        .iter()
        .map(|&(name, text)| (name.to_owned(), text.to_owned()))
        .collect()
}

#[test]
fn a_set_appears_at_once_and_replaces_the_earlier_one() {
    let parent = tempfile::tempdir().unwrap();
    let directory = parent.path().join("out/two-bricks");
    for run in ["one", "two"] {
        let before = directory.exists().then(|| contents(&directory));
        let mut set = OutputSet::new(&directory).unwrap();
        stage(&mut set, "a.vtu", &format!("a of {run}"));
        stage(&mut set, "summary.json", &format!("summary of {run}"));
        if let Some(before) = before {
            let now: Vec<_> = contents(&directory)
                .into_iter()
                .filter(|(name, _)| !name.starts_with('.'))
                .collect();
            assert_eq!(now, before, "staging must not touch earlier results");
        }
        let paths = set.commit().unwrap();
        assert_eq!(
            paths,
            [directory.join("a.vtu"), directory.join("summary.json")]
        );
        let (a, summary) = (format!("a of {run}"), format!("summary of {run}"));
        assert_eq!(
            contents(&directory),
            listed(&[("a.vtu", &a), ("summary.json", &summary)])
        );
    }
}

#[test]
fn a_failing_writer_leaves_the_earlier_set_and_no_rubbish() {
    let directory = tempfile::tempdir().unwrap();
    fs::write(directory.path().join("a.vtu"), "earlier").unwrap();
    let mut set = OutputSet::new(directory.path()).unwrap();
    stage(&mut set, "a.vtu", "new");
    let error = set
        .stage("b.vtu", |out| {
            write!(out, "half")?;
            Err(WriteError::NotFinite {
                field: "stress".into(),
                place: "node 3".into(),
                value: f64::NAN,
            })
        })
        .unwrap_err();
    assert_eq!(
        error.to_string(),
        "`stress` is not a finite number at node 3: NaN"
    );
    drop(set);
    assert_eq!(contents(directory.path()), listed(&[("a.vtu", "earlier")]));
}

#[test]
fn a_panic_leaves_the_earlier_set_and_no_rubbish() {
    let directory = tempfile::tempdir().unwrap();
    fs::write(directory.path().join("a.vtu"), "earlier").unwrap();
    let panicked = std::panic::catch_unwind(|| {
        let mut set = OutputSet::new(directory.path()).unwrap();
        stage(&mut set, "a.vtu", "new");
        panic!("on purpose");
    });
    assert!(panicked.is_err());
    assert_eq!(contents(directory.path()), listed(&[("a.vtu", "earlier")]));
}

#[test]
fn a_failing_rename_takes_the_others_back() {
    let directory = tempfile::tempdir().unwrap();
    fs::write(directory.path().join("a.vtu"), "earlier").unwrap();
    fs::create_dir(directory.path().join("summary.json")).unwrap();
    let mut set = OutputSet::new(directory.path()).unwrap();
    stage(&mut set, "a.vtu", "new");
    stage(&mut set, "b.vtu", "new");
    stage(&mut set, "summary.json", "new");
    let error = set.commit().unwrap_err();
    assert!(matches!(error, WriteError::Io { ref path, .. } if path.ends_with("summary.json")));
    assert_eq!(
        contents(directory.path()),
        listed(&[("a.vtu", "earlier"), ("summary.json", "directory")])
    );
}

#[test]
fn names_are_plain_and_single() {
    let directory = tempfile::tempdir().unwrap();
    let mut set = OutputSet::new(directory.path()).unwrap();
    for bad in ["", "..", "../a.vtu", "a/b.vtu", "/etc/a.vtu", "a.vtu/"] {
        let error = set.stage(bad, |_| Ok(())).unwrap_err();
        assert!(matches!(error, WriteError::Name { .. }), "{bad}: {error}");
    }
    stage(&mut set, "a.vtu", "once");
    let error = set.stage("a.vtu", |_| Ok(())).unwrap_err();
    assert_eq!(
        error.to_string(),
        "the name `a.vtu` cannot be used: it is already in the set"
    );
}

#[test]
fn a_file_in_the_place_of_the_directory_is_named() {
    let directory = tempfile::tempdir().unwrap();
    let path = directory.path().join("out");
    fs::write(&path, "not a directory").unwrap();
    let error = OutputSet::new(&path).unwrap_err();
    assert_eq!(
        error.to_string(),
        format!("cannot create the directory `{}`", path.display())
    );
}

#[cfg(unix)]
#[test]
fn results_are_readable_like_any_other_file() {
    use std::os::unix::fs::PermissionsExt;
    let directory = tempfile::tempdir().unwrap();
    fs::write(directory.path().join("ordinary"), "").unwrap();
    let mut set = OutputSet::new(directory.path()).unwrap();
    stage(&mut set, "result", "");
    set.commit().unwrap();
    let mode = |name| {
        let path = directory.path().join(name);
        fs::metadata(path).unwrap().permissions().mode()
    };
    assert_eq!(mode("result"), mode("ordinary"));
}
