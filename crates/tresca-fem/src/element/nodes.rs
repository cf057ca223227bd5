//! Nodes of higher elements out of those of the linear ones.

/// The given nodes, then the means of some of them: the middles of edges, the centres of faces and of the cell.
///
/// # Panics
/// When N is not the number of both; at compile time.
pub(super) const fn with_means<const N: usize>(
    nodes: &[[f64; 3]],
    means: &[&[usize]],
) -> [[f64; 3]; N] {
    assert!(nodes.len() + means.len() == N);
    let mut all = [[0.0; 3]; N];
    let mut a = 0;
    while a < N {
        if a < nodes.len() {
            all[a] = nodes[a];
        } else {
            let of = means[a - nodes.len()];
            let mut i = 0;
            while i < 3 {
                let (mut sum, mut k) = (0.0, 0);
                while k < of.len() {
                    sum += nodes[of[k]][i];
                    k += 1;
                }
                all[a][i] = sum / of.len() as f64;
                i += 1;
            }
        }
        a += 1;
    }
    all
}
