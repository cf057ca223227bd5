//! FCLIB: HDF5 with the datasets
//!
//! ```text
//! fclib_local    spacedim  W  vectors/{q, mu}     info/{title, description, math_info}
//! fclib_global   spacedim  M  H  vectors/{f, w, mu}  info/…
//! solution       u  r  [v]
//! guesses        number_of_guesses   1/{u, r, [v]}  2/…
//! ```
//!
//! and for every matrix m, n, nz, nzmax, p, i, x as CSparse has them: nz = −1 compressed columns,
//! −2 compressed rows, ≥ 0 triplets.

mod read;
mod write;

pub(super) use read::read;
