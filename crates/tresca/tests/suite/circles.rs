//! No files of a crate import each other in a circle. Read from the tree itself: `use` lines and paths in the code,
//! where tests and documentation are left out.
//!
//! An import counts for the file whose module it names. A façade (`mod.rs`, `lib.rs`) that hands on the names of its
//! children imports them; whoever inside of the crate imports a name from the façade closes a circle, and should name
//! the module that defines it.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

/// The modules of a crate, by their path (`a::b`, the root is empty), with the source of their files.
type Modules = BTreeMap<Vec<String>, String>;

fn read_crate(src: &Path) -> Modules {
    let mut modules = Modules::new();
    let mut folders = vec![src.to_owned()];
    while let Some(folder) = folders.pop() {
        for entry in std::fs::read_dir(&folder).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|extension| extension == "rs") {
                let source = std::fs::read_to_string(&path).unwrap();
                modules.insert(module_of(src, &path), code(&source));
            }
        }
    }
    modules
}

fn module_of(src: &Path, file: &Path) -> Vec<String> {
    let relative = file.strip_prefix(src).unwrap().with_extension("");
    let mut path: Vec<String> = relative
        .iter()
        .map(|part| part.to_str().unwrap().to_owned())
        .collect();
    if path
        .last()
        .is_some_and(|last| ["lib", "main", "mod"].contains(&last.as_str()))
    {
        path.pop();
    }
    path
}

/// The code without comments, documentation and the module of unit tests, which stands last in a file.
fn code(source: &str) -> String {
    let tests = [
        "
#[cfg(test)]
mod ",
        "
#[cfg(all(test",
    ];
    let ends = tests.iter().filter_map(|begin| source.find(begin));
    let end = ends.min().unwrap_or(source.len());
    let lines = source[..end]
        .lines()
        .filter(|line| !line.trim_start().starts_with("//"));
    lines.collect::<Vec<_>>().join("\n")
}

/// Paths that begin with `crate` or `super`, nested lists of `use` taken apart. Relative to the module `own`.
fn paths(own: &[String], source: &str, modules: &Modules) -> Vec<Vec<String>> {
    let mut found = Vec::new();
    let words = words(source);
    let mut at = 0;
    while at < words.len() {
        let begins = at == 0 || words[at - 1] != "::";
        let word = words[at].as_str();
        let child = begins && at > 0 && ["use", "{"].contains(&words[at - 1].as_str());
        let is_child = child && {
            let mut path = own.to_vec();
            path.push(word.to_owned());
            modules.contains_key(&path)
        };
        let next = words.get(at + 1).map(String::as_str);
        if begins && next == Some("::") && (["crate", "super", "self"].contains(&word) || is_child)
        {
            let base = match word {
                "crate" => Vec::new(),
                "super" => own[..own.len().saturating_sub(1)].to_vec(),
                "self" => own.to_vec(),
                child => [own, &[child.to_owned()]].concat(),
            };
            at = tree(&words, at + 2, base, &mut found);
        } else {
            at += 1;
        }
    }
    found
}

/// Reads what follows `base::`; returns where it ends.
fn tree(words: &[String], mut at: usize, base: Vec<String>, found: &mut Vec<Vec<String>>) -> usize {
    match words.get(at).map(String::as_str) {
        Some("{") => {
            at += 1;
            while at < words.len() && words[at] != "}" {
                at = match words[at].as_str() {
                    "," => at + 1,
                    _ => tree(words, at, base.clone(), found),
                };
            }
            at + 1
        }
        Some("super") if words.get(at + 1).is_some_and(|next| next == "::") => {
            let parent = base[..base.len().saturating_sub(1)].to_vec();
            tree(words, at + 2, parent, found)
        }
        Some("self") => {
            found.push(base);
            at + 1
        }
        Some(name) => {
            let mut path = base;
            path.push(name.to_owned());
            if words.get(at + 1).is_some_and(|next| next == "::") {
                return tree(words, at + 2, path, found);
            }
            found.push(path);
            // `name as other`
            match words.get(at + 1).is_some_and(|next| next == "as") {
                true => at + 3,
                false => at + 1,
            }
        }
        None => at,
    }
}

/// Identifiers, `::` and single signs; texts in quotation marks are left out.
fn words(source: &str) -> Vec<String> {
    let mut words = Vec::new();
    let mut rest = source.chars().peekable();
    while let Some(c) = rest.next() {
        if c.is_alphanumeric() || c == '_' {
            let mut word = String::from(c);
            while let Some(&c) = rest.peek()
                && (c.is_alphanumeric() || c == '_')
            {
                word.push(c);
                rest.next();
            }
            words.push(word);
        } else if c == ':' && rest.peek() == Some(&':') {
            rest.next();
            words.push("::".to_owned());
        } else if c == '"' {
            while let Some(c) = rest.next() {
                match c {
                    '\\' => drop(rest.next()),
                    '"' => break,
                    _ => {}
                }
            }
        } else if !c.is_whitespace() {
            words.push(c.to_string());
        }
    }
    words
}

/// The module that a path names something of: the longest one that exists.
fn resolve(modules: &Modules, path: &[String]) -> Vec<String> {
    let lengths = (0..=path.len()).rev();
    lengths
        .map(|length| path[..length].to_vec())
        .find(|module| modules.contains_key(module))
        .unwrap_or_default()
}

/// Groups of modules that reach each other, as `a, b, c`.
fn circles(modules: &Modules) -> Vec<String> {
    let imports: BTreeMap<&Vec<String>, BTreeSet<Vec<String>>> = modules
        .iter()
        .map(|(own, source)| {
            let paths = paths(own, source, modules);
            let named = paths.iter().map(|path| resolve(modules, path));
            (own, named.filter(|module| module != own).collect())
        })
        .collect();
    let reach = |from: &Vec<String>| {
        let mut seen = BTreeSet::new();
        let mut left: Vec<&Vec<String>> = imports[from].iter().collect();
        while let Some(module) = left.pop() {
            if seen.insert(module.clone()) {
                left.extend(&imports[module]);
            }
        }
        seen
    };
    let reached: BTreeMap<&Vec<String>, BTreeSet<Vec<String>>> = modules
        .keys()
        .map(|module| (module, reach(module)))
        .collect();
    let mut found = BTreeSet::new();
    for (module, all) in &reached {
        if all.contains(*module) {
            let circle = all.iter().filter(|other| reached[other].contains(*module));
            let names: Vec<String> = circle.map(|other| name(other)).collect();
            found.insert(names.join(", "));
        }
    }
    found.into_iter().collect()
}

fn name(module: &[String]) -> String {
    match module {
        [] => "lib.rs".to_owned(),
        path => path.join("::"),
    }
}

#[test]
fn no_files_import_each_other_in_a_circle() {
    let crates = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("..");
    let mut found = Vec::new();
    for entry in std::fs::read_dir(crates).unwrap() {
        let src = entry.unwrap().path().join("src");
        if src.is_dir() {
            let crate_name = src.parent().unwrap().file_name().unwrap().to_owned();
            let own = circles(&read_crate(&src));
            found.extend(
                own.into_iter()
                    .map(|circle| format!("{crate_name:?}: {circle}")),
            );
        }
    }
    assert!(found.is_empty(), "circles of files:\n{}", found.join("\n"));
}

#[test]
fn a_circle_is_seen() {
    let module = |path: &str, source: &str| {
        let path = path.split("::").filter(|part| !part.is_empty());
        (path.map(str::to_owned).collect(), code(source))
    };
    let modules: Modules = [
        module("", "mod a;\nmod b;\npub use a::A;\n"),
        module("a", "use crate::b::{B, c::C as D};\n"),
        module("b", "mod c;\n// use crate::a::A;\n"),
        module("b::c", "fn f() { super::super::a::g(\"crate::b\"); }\n"),
    ]
    .into();
    assert_eq!(circles(&modules), ["a, b::c"]);
    let modules: Modules = [
        module("", "mod a;\npub use a::A;\n"),
        module("a", "use crate::A;\n"),
    ]
    .into();
    assert_eq!(circles(&modules), ["lib.rs, a"], "through a façade");
}
