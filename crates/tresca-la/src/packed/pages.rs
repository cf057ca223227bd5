//! Room for tiles on large pages.
//!
//! A triangle of order 5000 is 100 MB: 25 000 pages of 4 KiB, each of which costs a fault when it is written
//! first and an address translation in every sweep. Where the system has pages of 2 MiB for those who ask
//! (Linux with transparent huge pages set to `madvise` or `always`), this asks; elsewhere nothing changes.

use crate::kernels::Tile;

/// Bytes from which asking is worth a system call.
#[cfg(target_os = "linux")]
const LARGE: usize = 4 << 20;

/// An empty vector with room for `count` tiles, none of them touched yet.
pub(super) fn room_for(count: usize) -> Vec<Tile> {
    let mut tiles: Vec<Tile> = Vec::with_capacity(count);
    #[cfg(target_os = "linux")]
    if count * size_of::<Tile>() >= LARGE {
        ask_for_large_pages(tiles.spare_capacity_mut());
    }
    tiles
}

/// Advice only: what the system answers changes no result, so the answer is not looked at.
#[cfg(target_os = "linux")]
fn ask_for_large_pages(memory: &mut [std::mem::MaybeUninit<Tile>]) {
    // SAFETY: no argument can make this call fail in a way that matters.
    let page = unsafe { libc::sysconf(libc::_SC_PAGESIZE) };
    let Ok(page) = usize::try_from(page) else {
        return;
    };
    let range = memory.as_mut_ptr_range();
    let begin = range.start.addr().next_multiple_of(page);
    let end = range.end.addr() / page * page;
    if begin < end {
        // SAFETY: whole pages within memory that is ours; the advice does not change what they hold.
        unsafe {
            let first = range.start.byte_add(begin - range.start.addr());
            libc::madvise(first.cast(), end - begin, libc::MADV_HUGEPAGE);
        }
    }
}
