//! What hangs together.

/// Numbers in sets that do not overlap, joined one by one. The root of a set is its lowest number, so that
/// nothing depends on the order of joining.
#[derive(Clone, Debug)]
pub struct DisjointSets {
    parent: Vec<usize>,
}

impl DisjointSets {
    /// The numbers below `count`, each by itself.
    pub fn new(count: usize) -> Self {
        Self {
            parent: (0..count).collect(),
        }
    }

    /// The lowest number of a number's set.
    pub fn root(&mut self, mut number: usize) -> usize {
        // Halves the way for those who come after.
        while self.parent[number] != number {
            self.parent[number] = self.parent[self.parent[number]];
            number = self.parent[number];
        }
        number
    }

    /// Joins the sets of two numbers.
    pub fn join(&mut self, a: usize, b: usize) {
        let (a, b) = (self.root(a), self.root(b));
        self.parent[a.max(b)] = a.min(b);
    }
}
