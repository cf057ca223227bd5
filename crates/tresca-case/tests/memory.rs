//! The mesh of a case is in memory once. One test in its own binary: the counter is of the whole process.

use std::alloc::{GlobalAlloc, Layout, System};
use std::fmt::Write;
use std::sync::atomic::{AtomicUsize, Ordering};

use tresca_case::Case;

/// Knows how many bytes are in use.
struct Counting;

static USED: AtomicUsize = AtomicUsize::new(0);

// SAFETY: hands everything on to the system allocator unchanged.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        USED.fetch_add(layout.size(), Ordering::Relaxed);
        // SAFETY: the caller's promise is the one that `System` asks for.
        unsafe { System.alloc(layout) }
    }

    unsafe fn dealloc(&self, pointer: *mut u8, layout: Layout) {
        USED.fetch_sub(layout.size(), Ordering::Relaxed);
        // SAFETY: as above.
        unsafe { System.dealloc(pointer, layout) }
    }
}

#[global_allocator]
static ALLOCATOR: Counting = Counting;

fn bytes_of<T>(make: impl FnOnce() -> T) -> (T, usize) {
    let before = USED.load(Ordering::Relaxed);
    let made = make();
    (made, USED.load(Ordering::Relaxed) - before)
}

/// A deck of n × n × n bricks.
fn deck(n: usize) -> String {
    let node = |[i, j, k]: [usize; 3]| 1 + i + (n + 1) * (j + (n + 1) * k);
    let all = |count: usize| {
        (0..count.pow(3)).map(move |m| [m % count, m / count % count, m / count.pow(2)])
    };
    let mut text = "*NODE\n".to_owned();
    for p in all(n + 1) {
        writeln!(text, "{}, {}, {}, {}", node(p), p[0], p[1], p[2]).unwrap();
    }
    text.push_str("*ELEMENT, TYPE=C3D8\n");
    for (number, [i, j, k]) in all(n).enumerate() {
        write!(text, "{}", number + 1).unwrap();
        for k in [k, k + 1] {
            for [i, j] in [[i, j], [i + 1, j], [i + 1, j + 1], [i, j + 1]] {
                write!(text, ", {}", node([i, j, k])).unwrap();
            }
        }
        text.push('\n');
    }
    text
}

#[test]
fn a_mesh_is_in_memory_once() {
    let directory = tempfile::tempdir().unwrap();
    std::fs::write(directory.path().join("block.inp"), deck(16)).unwrap();
    let name = directory.path().join("case.toml").display().to_string();
    let text = "[[body]]\nname = \"block\"\nmesh = { file = \"block.inp\" }\n\
                material = { young = 1, poisson = 0.3 }\n";
    let (case, whole) = bytes_of(|| Case::parse(&name, text).unwrap());
    let (_model, model) = bytes_of(|| case.model.clone());
    assert!(
        model > 300_000 && 10 * whole < 15 * model,
        "the case takes {whole} bytes, its model {model}"
    );
}
