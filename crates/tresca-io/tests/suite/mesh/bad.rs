//! Files that are broken, cut off, or of another kind.

use miette::Diagnostic;
use tresca_io::located::Position;
use tresca_io::mesh::{MeshFault, MeshFileError, parse, read};

use crate::mesh::support::refused;

const TWO: &str = include_str!("data/hexes-2.2-text.msh");
const FOUR: &str = include_str!("data/hexes-4.1-text.msh");

fn with(text: &str, from: &str, to: &str) -> MeshFileError {
    assert!(text.contains(from), "{from}");
    refused("bad.msh", &text.replacen(from, to, 1))
}

#[test]
fn other_files_and_versions_are_named() {
    let error = refused("bad.msh", "solid ball\nfacet normal 0 0 1\n");
    assert_eq!(
        error.to_string(),
        "`bad.msh` is no mesh file of a known format: it begins with `solid ball\\nfacet normal `"
    );
    assert!(matches!(
        refused("bad.msh", "").fault(),
        MeshFault::Format { .. }
    ));
    for version in ["4.0", "4", "1.0", "3"] {
        let error = with(FOUR, "4.1 0 8", &format!("{version} 0 8"));
        let expected = format!("bad.msh:2: the MSH format of version {version} is not read");
        assert_eq!(error.to_string(), expected);
        assert!(
            error
                .help()
                .unwrap()
                .to_string()
                .contains("save the mesh as version 4.1 or 2.2")
        );
    }
    let error = refused("bad.msh", "$NOD\n1\n1 0 0 0\n$ENDNOD\n");
    assert!(
        matches!(error.fault(), MeshFault::Version { .. }),
        "{error}"
    );
    let error = read("there/is/nothing.msh").unwrap_err();
    assert!(
        error
            .to_string()
            .starts_with("cannot read the mesh file `there/is/nothing.msh`")
    );
}

#[test]
fn faults_of_the_text_have_a_line() {
    for (error, expected) in [
        (
            with(TWO, "$EndMeshFormat", "$EndMesh"),
            "bad.msh:3: expected `$EndMeshFormat`, found `$EndMesh`",
        ),
        (
            with(TWO, "2.2 0 8", "2.2 0 16"),
            "bad.msh:2: expected 8, the width of a number in bytes, found 16",
        ),
        (
            with(TWO, "\n1 0 0 1\n", "\n1 0 zero 1\n"),
            "bad.msh:12: expected a coordinate, found `zero`",
        ),
        (
            with(TWO, "\n1 0 0 1\n", "\n1 0 inf 1\n"),
            "bad.msh:12: node 1 has a coordinate that is no finite number: [0.0, inf, 1.0]",
        ),
        (
            with(TWO, "\n2 0 0 0\n", "\n1 0 0 0\n"),
            "bad.msh:11: there are two nodes with the number 1",
        ),
        (
            with(TWO, "\"block\"", "block"),
            "bad.msh:8: expected the name of a physical group in quotes, found `block`",
        ),
        (
            with(FOUR, "$Nodes", "$Knoten"),
            "bad.msh:44: the file ends where `$EndKnoten` is expected",
        ),
    ] {
        let (found, expected) = (error.to_string(), expected);
        // The last line of the file is wherever it is.
        if let MeshFault::Truncated { .. } = error.fault() {
            assert!(
                found.ends_with("the file ends where `$EndKnoten` is expected"),
                "{found}"
            );
        } else {
            assert_eq!(found, expected);
        }
    }
}

#[test]
fn counts_that_do_not_fit_are_explained() {
    let more = with(TWO, "$Nodes\n27", "$Nodes\n28");
    assert!(
        more.to_string()
            .contains("expected the number of a node, found `$EndNodes`"),
        "{more}"
    );
    assert!(
        more.help()
            .unwrap()
            .to_string()
            .contains("less than the counts")
    );
    let less = with(TWO, "$Nodes\n27", "$Nodes\n26");
    assert!(less.to_string().contains("expected `$EndNodes`"), "{less}");
    assert!(
        less.help()
            .unwrap()
            .to_string()
            .contains("more than the counts")
    );
}

#[test]
fn elements_name_what_is_wrong_with_them() {
    let text = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n5\n1 0 0 0\n2 1 0 0\n3 1 1 0\n4 0 1 0\n5 0 0 1\n$EndNodes\n\
                $Elements\n1\n8 7 2 1 1 1 2 3 4 5\n$EndElements\n";
    for (error, expected) in [
        (
            refused("bad.msh", text),
            "bad.msh:14: element 8 is of the type 7 (pyramid with 5 nodes), which is not supported",
        ),
        (
            with(text, "8 7 2", "8 29 2"),
            "bad.msh:14: element 8 is of the type 29 (element of order 3), which is not supported",
        ),
        (
            with(text, "8 7 2 1 1 1 2 3 4 5", "8 4 2 1 1 1 2 3 6"),
            "bad.msh:14: element 8 refers to node 6, which the file does not have",
        ),
    ] {
        assert_eq!(error.to_string(), expected);
    }
}

/// Every beginning of a good file is refused with a place, and nothing panics.
#[test]
fn files_that_are_cut_off_anywhere_are_refused() {
    for name in [
        "hexes-2.2-text",
        "hexes-2.2-binary",
        "hexes-4.1-text",
        "hexes-4.1-binary",
    ] {
        let path = format!(
            "{}/tests/suite/mesh/data/{name}.msh",
            env!("CARGO_MANIFEST_DIR")
        );
        let bytes = std::fs::read(path).unwrap();
        let whole = parse("cut.msh", &bytes).unwrap();
        let last = bytes.trim_ascii_end().len();
        for end in 1..last {
            match parse("cut.msh", &bytes[..end]) {
                Err(error) => match (error.fault(), &error.place().position) {
                    (MeshFault::Truncated { .. }, Position::Line(line)) => assert!(*line >= 1),
                    (MeshFault::Truncated { .. }, Position::Byte(byte)) => assert_eq!(*byte, end),
                    (MeshFault::Truncated { .. }, other) => panic!("{other:?}"),
                    _ => {}
                },
                // Between two sections a file may seem whole; its elements are not there then.
                Ok(file) => assert_ne!(file, whole, "{name} cut at {end}"),
            }
        }
    }
}

/// Single bytes changed in a binary file: an error or another mesh, but no panic and no exhausted memory.
#[test]
fn corrupt_bytes_do_no_harm() {
    for name in ["hexes-2.2-binary", "hexes-4.1-binary"] {
        let path = format!(
            "{}/tests/suite/mesh/data/{name}.msh",
            env!("CARGO_MANIFEST_DIR")
        );
        let mut bytes = std::fs::read(path).unwrap();
        for at in 0..bytes.len() {
            let old = bytes[at];
            for new in [0, 0xff, old ^ 0x40] {
                bytes[at] = new;
                let _ = parse("corrupt.msh", &bytes);
            }
            bytes[at] = old;
        }
    }
}
