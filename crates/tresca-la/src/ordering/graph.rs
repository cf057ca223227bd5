//! The adjacency graph of a symmetric matrix, compressed to groups of dofs.

use super::error::OrderingError;
use super::metis;
use crate::symmetric::SymmetricMatrix;
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
    touches_left_out: Vec<bool>,
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

        let lower = matrix.lower();
        let mut touches_left_out = vec![false; groups.len()];
        for column in 0..order {
            for row in lower.row_idx_of_col(column) {
                match (group_of[row], group_of[column]) {
                    (NONE, NONE) => {}
                    (NONE, g) | (g, NONE) => touches_left_out[g] = true,
                    _ => {}
                }
            }
        }

        // All dofs of a group have the same neighbours: its first column tells them
        // below, and above they are found from the first columns of the groups there.
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
            touches_left_out,
        }
    }

    /// Number of groups.
    pub(super) fn len(&self) -> usize {
        self.groups.len()
    }

    /// The dofs of a group, ascending.
    pub(super) fn dofs_of(&self, group: usize) -> Range<usize> {
        self.groups[group].clone()
    }

    /// Whether a dof of the group couples to a dof that was left out.
    pub(super) fn touches_left_out(&self, group: usize) -> bool {
        self.touches_left_out[group]
    }

    pub(super) fn neighbours_of(&self, group: usize) -> &[usize] {
        &self.neighbours[self.offsets[group]..self.offsets[group + 1]]
    }

    /// Nested dissection order of the given groups alone.
    pub(super) fn dissect(&self, groups: &[usize]) -> Result<Vec<usize>, OrderingError> {
        // Number of a group among the given ones, or NONE; in range, as there
        // are at most as many as dofs in the matrix, checked below.
        const NONE: idx_t = -1;
        let entries: usize = groups.iter().map(|&g| self.neighbours_of(g).len()).sum();
        let largest = entries.max(self.groups.last().map_or(0, |last| last.end));
        if idx_t::try_from(largest).is_err() {
            return Err(OrderingError::TooLarge { entries: largest });
        }
        let mut number = vec![NONE; self.len()];
        for (new, &g) in groups.iter().enumerate() {
            number[g] = new as idx_t;
        }
        let mut offsets = vec![0];
        let mut adjacency = Vec::with_capacity(entries);
        for &g in groups {
            let neighbours = self.neighbours_of(g).iter().map(|&h| number[h]);
            adjacency.extend(neighbours.filter(|&h| h != NONE));
            offsets.push(adjacency.len() as idx_t);
        }
        let weights: Vec<_> = groups
            .iter()
            .map(|&g| self.groups[g].len() as idx_t)
            .collect();
        let order = metis::node_nested_dissection(&offsets, &adjacency, &weights)?;
        Ok(order.into_iter().map(|v| groups[v]).collect())
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
        for (v, &group) in order.iter().enumerate() {
            for &neighbour in self.neighbours_of(group) {
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
