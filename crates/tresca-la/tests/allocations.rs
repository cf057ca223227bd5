//! The inner loops allocate nothing. One test in its own binary: the counter is
//! of the whole process.

use std::alloc::{GlobalAlloc, Layout, System};
use std::sync::atomic::{AtomicUsize, Ordering};
use tresca_la::krylov::cg::{ConjugateGradient, Proposal};
use tresca_la::krylov::{InverseDiagonal, bicgstab};
use tresca_la::{LinearOperator, PackedLower};

struct Counting;

static ALLOCATIONS: AtomicUsize = AtomicUsize::new(0);

// SAFETY: hands everything on to the system allocator unchanged.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        ALLOCATIONS.fetch_add(1, Ordering::Relaxed);
        // SAFETY: the caller's promise is the one that `System` asks for.
        unsafe { System.alloc(layout) }
    }

    unsafe fn dealloc(&self, pointer: *mut u8, layout: Layout) {
        // SAFETY: as above.
        unsafe { System.dealloc(pointer, layout) }
    }
}

#[global_allocator]
static ALLOCATOR: Counting = Counting;

/// Second differences plus 1: SPD, computed without storage.
struct Chain(usize);

impl LinearOperator for Chain {
    fn dim(&self) -> usize {
        self.0
    }

    fn apply(&mut self, x: &[f64], y: &mut [f64]) {
        for i in 0..x.len() {
            let before = if i > 0 { x[i - 1] } else { 0.0 };
            let after = x.get(i + 1).unwrap_or(&0.0);
            y[i] = 3.0 * x[i] - before - after;
        }
    }
}

fn allocations_in(work: impl FnOnce()) -> usize {
    let before = ALLOCATIONS.load(Ordering::Relaxed);
    work();
    ALLOCATIONS.load(Ordering::Relaxed) - before
}

#[test]
fn loops_do_not_allocate() {
    let n = 100;
    let mut chain = Chain(n);
    let mut preconditioner = InverseDiagonal::new(&vec![3.0; n]);
    let b = vec![1.0; n];
    let mut x = vec![0.0; n];

    let mut cg = ConjugateGradient::with_capacity(n);
    let count = allocations_in(|| {
        // The second, smaller system too.
        for size in [n, n / 2] {
            cg.start(&b[..size]);
            let mut chain = Chain(size);
            for _ in 0..10 {
                let proposal = cg.propose(&mut chain, &mut Cut(&mut preconditioner, size));
                assert!(matches!(proposal, Proposal::Step { .. }));
                cg.accept(&mut x[..size]);
            }
        }
    });
    assert_eq!(count, 0, "CG");

    let mut workspace = bicgstab::Workspace::with_capacity(n);
    x.fill(0.0);
    let count = allocations_in(|| {
        bicgstab::solve(
            &mut chain,
            &mut preconditioner,
            &b,
            &mut x,
            10,
            |_| false,
            &mut workspace,
        );
    });
    assert_eq!(count, 0, "BiCGSTAB");

    let mut packed = PackedLower::zeros(n);
    for i in 0..n {
        packed.set(i, i, 2.0);
    }
    let mut y = vec![0.0; n];
    let count = allocations_in(|| {
        packed.solve_lower_in_place(&mut x);
        packed.solve_upper_in_place(&mut x);
        packed.symmetric_mul(&x, &mut y);
    });
    assert_eq!(count, 0, "packed triangle");
}

/// The leading part of a diagonal preconditioner.
struct Cut<'a>(&'a mut InverseDiagonal, usize);

impl LinearOperator for Cut<'_> {
    fn dim(&self) -> usize {
        self.1
    }

    fn apply(&mut self, x: &[f64], y: &mut [f64]) {
        self.0.apply(x, y);
    }
}
