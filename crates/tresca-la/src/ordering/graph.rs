//! The adjacency graph of a symmetric matrix, compressed to groups of dofs.

use super::{OrderingError, metis};
use crate::SymmetricMatrix;
use metis_sys::idx_t;
use std::ops::Range;

/// Undirected graph whose vertices are runs of consecutive dofs with the same
/// neighbours; trailing dofs are left out.
#[derive(Debug)]
pub(super) struct Graph {
    /// First dof and one past the last dof of each group.
    groups: Vec<Range<usize>>,
    offsets: Vec<usize>,
    neighbours: Vec<usize>,
}

impl Graph {
    /// The graph of `matrix` without the dofs marked in `left_out`.
    pub(super) fn compressed(matrix: &SymmetricMatrix, left_out: &[bool]) -> Self {
        let order = matrix.order();
        let starts_group = group_starts(matrix, left_out);
        const NONE: usize = usize::MAX;
        let mut group_of = vec![NONE; order];
        let mut groups: Vec<Range<usize>> = Vec::new();
        for dof in (0..order).filter(|&dof| !left_out[dof]) {
            match groups.last_mut() {
                Some(last) if last.end == dof && !starts_group[dof] => last.end = dof + 1,
                _ => groups.push(dof..dof + 1),
            }
            group_of[dof] = groups.len() - 1;
        }

        // All dofs of a group have the same neighbours: its first column tells them
        // below, and above they are found from the first columns of the groups there.
        let lower = matrix.lower();
        let edges = || {
            groups.iter().enumerate().flat_map(|(g, dofs)| {
                let group_of = &group_of;
                let mut last = g;
                lower.row_idx_of_col(dofs.start).filter_map(move |row| {
                    let h = group_of[row];
                    let is_new = h != NONE && h != last && h != g;
                    if is_new {
                        last = h;
                    }
                    is_new.then_some((g, h))
                })
            })
        };
        let mut offsets = vec![0; groups.len() + 1];
        for (g, h) in edges() {
            offsets[g + 1] += 1;
            offsets[h + 1] += 1;
        }
        for g in 0..groups.len() {
            offsets[g + 1] += offsets[g];
        }
        let mut neighbours = vec![0; offsets[groups.len()]];
        let mut next = offsets.clone();
        for (g, h) in edges() {
            neighbours[next[g]] = h;
            neighbours[next[h]] = g;
            next[g] += 1;
            next[h] += 1;
        }
        Self {
            groups,
            offsets,
            neighbours,
        }
    }

    /// The dofs of a group, ascending.
    pub(super) fn dofs_of(&self, group: usize) -> Range<usize> {
        self.groups[group].clone()
    }

    fn neighbours_of(&self, group: usize) -> &[usize] {
        &self.neighbours[self.offsets[group]..self.offsets[group + 1]]
    }

    /// The groups in nested dissection order.
    pub(super) fn dissect(&self) -> Result<Vec<usize>, OrderingError> {
        let entries = self.neighbours.len().max(self.offsets.len());
        if idx_t::try_from(entries).is_err() {
            return Err(OrderingError::TooLarge { entries });
        }
        // In range: every value is at most `entries`, or a number of dofs in a group.
        let narrow = |v: &[usize]| v.iter().map(|&v| v as idx_t).collect::<Vec<_>>();
        let weights: Vec<_> = self.groups.iter().map(|g| g.len() as idx_t).collect();
        metis::node_nested_dissection(&narrow(&self.offsets), &narrow(&self.neighbours), &weights)
    }

    /// The same elimination, with every subtree of the elimination tree numbered
    /// contiguously (J. W. H. Liu, *The role of elimination trees in sparse
    /// factorization*, SIAM J. Matrix Anal. Appl. 11, 1990).
    pub(super) fn postordered(&self, order: Vec<usize>) -> Vec<usize> {
        let parent = self.elimination_tree(&order);
        let count = order.len();
        const NONE: usize = usize::MAX;
        // Children as linked lists, built backwards so that they come out ascending.
        let (mut first_child, mut next_sibling) = (vec![NONE; count], vec![NONE; count]);
        for child in (0..count).rev() {
            if parent[child] != NONE {
                next_sibling[child] = first_child[parent[child]];
                first_child[parent[child]] = child;
            }
        }
        let mut postorder = Vec::with_capacity(count);
        let mut path = Vec::new();
        for root in (0..count).filter(|&v| parent[v] == NONE) {
            path.push(root);
            while let Some(&v) = path.last() {
                if first_child[v] == NONE {
                    postorder.push(order[v]);
                    path.pop();
                } else {
                    let child = first_child[v];
                    first_child[v] = next_sibling[child];
                    path.push(child);
                }
            }
        }
        postorder
    }

    /// Parent of each position in the elimination tree; `usize::MAX` at a root.
    fn elimination_tree(&self, order: &[usize]) -> Vec<usize> {
        const NONE: usize = usize::MAX;
        let count = order.len();
        let mut position = vec![0; count];
        for (new, &group) in order.iter().enumerate() {
            position[group] = new;
        }
        let mut parent = vec![NONE; count];
        // Shortcut to a far ancestor seen so far, with path compression.
        let mut ancestor = vec![NONE; count];
        for v in 0..count {
            for &neighbour in self.neighbours_of(order[v]) {
                let mut u = position[neighbour];
                while u < v && ancestor[u] != v {
                    let next = ancestor[u];
                    ancestor[u] = v;
                    if next == NONE {
                        parent[u] = v;
                        break;
                    }
                    u = next;
                }
            }
        }
        parent
    }
}

/// Marks the dofs that cannot join the group of the dof before them, because
/// some third dof couples to only one of the two, or one of the two is left out.
fn group_starts(matrix: &SymmetricMatrix, left_out: &[bool]) -> Vec<bool> {
    let order = matrix.order();
    let lower = matrix.lower();
    // `starts[j]`: j does not continue the group of j − 1.
    let mut starts = vec![false; order + 1];
    for j in 0..order {
        starts[j] |= j == 0 || left_out[j] != left_out[j - 1];
        // Neighbours above both: j − 1 and j must appear in column i together.
        let mut previous = None;
        for row in lower.row_idx_of_col(j).filter(|&row| row > j) {
            if previous != Some(row - 1) && row - 1 != j {
                starts[row] = true;
            }
            if let Some(p) = previous
                && p + 1 != row
            {
                starts[p + 1] = true;
            }
            previous = Some(row);
        }
        if let Some(p) = previous {
            starts[p + 1] = true;
        }
        // Neighbours below both: column j − 1 without j − 1 must equal column j with j.
        if j > 0 {
            let before = lower.row_idx_of_col(j - 1).filter(|&row| row >= j);
            let own = lower.row_idx_of_col(j).filter(|&row| row > j);
            starts[j] |= !before.eq(std::iter::once(j).chain(own));
        }
    }
    starts.truncate(order);
    starts
}
