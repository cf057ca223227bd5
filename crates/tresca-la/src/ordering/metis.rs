//! The one call into METIS that the project needs.

use super::error::OrderingError;
use metis_sys as ffi;
use std::sync::Mutex;

/// Same seed, same ordering (on one platform: METIS draws from C's `rand`).
const SEED: ffi::idx_t = 7;

/// Separators tried per bisection, of which the smallest is kept. METIS itself
/// takes 2 where it has compressed a graph, which here is done before it is called.
const SEPARATORS: ffi::idx_t = 2;

/// METIS draws from the process-wide generator of C and sets process-wide
/// signal handlers while it runs: one call at a time.
static ONE_AT_A_TIME: Mutex<()> = Mutex::new(());

/// Nested dissection of a graph in compressed adjacency form. Returns the
/// vertices in elimination order.
///
/// `offsets` has one entry more than there are vertices; the neighbours of v
/// stand in `adjacency[offsets[v]..offsets[v + 1]]`, v itself not among them,
/// each edge in both lists. `weights`: positive, one per vertex.
pub(super) fn node_nested_dissection(
    offsets: &[ffi::idx_t],
    adjacency: &[ffi::idx_t],
    weights: &[ffi::idx_t],
) -> Result<Vec<usize>, OrderingError> {
    let vertices = weights.len();
    assert_eq!(offsets.len(), vertices + 1);
    assert_eq!(
        offsets.last().map(|&end| end as usize),
        Some(adjacency.len())
    );
    assert!(offsets.is_sorted() && offsets[0] == 0);
    assert!(adjacency.iter().all(|&v| (v as usize) < vertices));
    if adjacency.is_empty() {
        return Ok((0..vertices).collect());
    }
    // METIS takes pointers to mutable data and, numbering from 0, changes none of it;
    // the copies keep that a matter of its own.
    let mut count = vertices as ffi::idx_t;
    let mut offsets = offsets.to_vec();
    let mut adjacency = adjacency.to_vec();
    let mut weights = weights.to_vec();
    let mut options = [0; ffi::METIS_NOPTIONS as usize];
    let mut order = vec![0; vertices];
    let mut position = vec![0; vertices];

    let guard = ONE_AT_A_TIME
        .lock()
        .unwrap_or_else(std::sync::PoisonError::into_inner);
    // SAFETY: `options` has the length METIS_NOPTIONS that the function fills.
    unsafe { ffi::METIS_SetDefaultOptions(options.as_mut_ptr()) };
    options[ffi::moptions_et_METIS_OPTION_NUMBERING as usize] = 0;
    options[ffi::moptions_et_METIS_OPTION_SEED as usize] = SEED;
    options[ffi::moptions_et_METIS_OPTION_NSEPS as usize] = SEPARATORS;
    options[ffi::moptions_et_METIS_OPTION_COMPRESS as usize] = 0;
    // SAFETY: the arrays have the lengths METIS expects (`offsets`: vertices + 1,
    // `adjacency`: its last entry, the others: vertices) and hold vertex numbers
    // in range, all asserted above; they outlive the call, are not aliased, and
    // the mutex keeps METIS' process-wide state to this call.
    let status = unsafe {
        ffi::METIS_NodeND(
            &mut count,
            offsets.as_mut_ptr(),
            adjacency.as_mut_ptr(),
            weights.as_mut_ptr(),
            options.as_mut_ptr(),
            order.as_mut_ptr(),
            position.as_mut_ptr(),
        )
    };
    drop(guard);
    match status {
        ffi::rstatus_et_METIS_OK => Ok(order.into_iter().map(|v| v as usize).collect()),
        ffi::rstatus_et_METIS_ERROR_MEMORY => Err(OrderingError::OutOfMemory { vertices }),
        status => Err(OrderingError::Metis { status }),
    }
}
