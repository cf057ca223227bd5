//! One contact by itself, friction by Coulomb: exactly.
//!
//! With the other forces held, the contact has to find n ≥ 0 and t with
//!
//! ```text
//! r = W λ + q,   λ = (n, t):      n ≥ 0,  r_n ≥ 0,  n r_n = 0,
//! ‖t‖ ≤ g,  and  r_t = 0  or  t = g d, r_t = −s d with s ≥ 0,      g = min(F n, limit), ‖d‖ = 1.
//! ```
//!
//! Three cases: open, stick, slip. Where it slips, n follows from d, and what is left is one equation for the angle
//! of d, whose roots are enclosed between samples. (The local problem of P. Alart and A. Curnier, Comput. Methods
//! Appl. Mech. Eng. 92 (1991), as a sweep of Gauss and Seidel needs it: F. Jourdan, P. Alart, M. Jean, ibid. 155
//! (1998).)

use std::f64::consts::TAU;

/// Angles at which the equation of slip is looked at before its roots are enclosed.
const SAMPLES: usize = 48;
const BISECTIONS: usize = 60;

/// What the contact sees: its block of A and what the others do to it, components (n, t₁, t₂).
pub(super) struct Local {
    pub w: [[f64; 3]; 3],
    pub q: [f64; 3],
    /// F.
    pub coefficient: f64,
    pub limit: f64,
    /// Tangents: 1 or 2.
    pub tangents: usize,
}

impl Local {
    /// The solution nearest to `before`; `None` where there is none, or W is too singular to say.
    pub fn solve(&self, before: [f64; 3]) -> Option<[f64; 3]> {
        let mut candidates = Vec::new();
        if self.q[0] >= 0.0 {
            candidates.push([0.0; 3]);
        }
        candidates.extend(self.stick());
        if candidates.is_empty() {
            candidates = self.slips(Bound::Follows);
            candidates.retain(|x| self.coefficient * x[0] <= self.limit);
            if candidates.is_empty() && self.limit.is_finite() {
                candidates = self.slips(Bound::Fixed(self.limit));
                candidates.retain(|x| self.coefficient * x[0] >= self.limit);
            }
        }
        let distance = |x: &[f64; 3]| (0..3).map(|i| (x[i] - before[i]).powi(2)).sum::<f64>();
        candidates
            .into_iter()
            .filter(|x| x.iter().all(|x| x.is_finite()))
            .min_by(|x, y| distance(x).total_cmp(&distance(y)))
    }

    fn stick(&self) -> Option<[f64; 3]> {
        let order = 1 + self.tangents;
        let x = eliminate(self.w, self.q.map(|q| -q), order)?;
        let bound = (self.coefficient * x[0]).min(self.limit);
        (x[0] >= 0.0 && x[1].hypot(x[2]) <= bound).then_some(x)
    }

    /// The force that slips along d under a bound, if it presses.
    fn slipping(&self, d: [f64; 2], bound: Bound) -> Option<[f64; 3]> {
        let along = self.w[0][1] * d[0] + self.w[0][2] * d[1];
        let (n, g) = match bound {
            Bound::Follows => {
                let n = -self.q[0] / (self.w[0][0] + self.coefficient * along);
                (n, self.coefficient * n)
            }
            Bound::Fixed(g) => (-(self.q[0] + g * along) / self.w[0][0], g),
        };
        (n >= 0.0 && n.is_finite()).then_some([n, g * d[0], g * d[1]])
    }

    /// r_t under the force x.
    fn pull(&self, x: [f64; 3]) -> [f64; 2] {
        [1, 2].map(|i| (0..3).map(|j| self.w[i][j] * x[j]).sum::<f64>() + self.q[i])
    }

    /// All forces that slip.
    fn slips(&self, bound: Bound) -> Vec<[f64; 3]> {
        let opposes = |d: [f64; 2], x: [f64; 3]| {
            let r = self.pull(x);
            r[0] * d[0] + r[1] * d[1] <= 0.0
        };
        if self.tangents == 1 {
            return [1.0, -1.0]
                .into_iter()
                .filter_map(|sign| {
                    let d = [sign, 0.0];
                    self.slipping(d, bound).filter(|&x| opposes(d, x))
                })
                .collect();
        }
        let direction = |angle: f64| [angle.cos(), angle.sin()];
        // What turns d: the part of r_t across it.
        let across = |angle: f64| {
            let d = direction(angle);
            let x = self.slipping(d, bound)?;
            let r = self.pull(x);
            Some((r[1] * d[0] - r[0] * d[1], x))
        };
        let angle = |k: usize| TAU * k as f64 / SAMPLES as f64;
        let mut found = Vec::new();
        for k in 0..SAMPLES {
            let (mut low, mut high) = (angle(k), angle(k + 1));
            let (Some((mut at_low, _)), Some((at_high, _))) = (across(low), across(high)) else {
                continue;
            };
            if at_low * at_high > 0.0 {
                continue;
            }
            let mut root = None;
            for _ in 0..BISECTIONS {
                let middle = 0.5 * (low + high);
                let Some((value, x)) = across(middle) else {
                    root = None;
                    break;
                };
                root = Some((middle, x));
                if value * at_low > 0.0 {
                    (low, at_low) = (middle, value);
                } else {
                    high = middle;
                }
            }
            found.extend(root.filter(|&(angle, x)| opposes(direction(angle), x)));
        }
        found.into_iter().map(|(_, x)| x).collect()
    }
}

/// The bound under which a contact slips.
#[derive(Clone, Copy)]
enum Bound {
    /// F n.
    Follows,
    Fixed(f64),
}

/// w x = y for the leading block of the given order, by Gaussian elimination with pivoting; `None` when it is singular.
fn eliminate(mut w: [[f64; 3]; 3], mut y: [f64; 3], order: usize) -> Option<[f64; 3]> {
    let size = (0..order).map(|i| w[i][i].abs()).fold(0.0, f64::max);
    for k in 0..order {
        let pivot = (k..order).max_by(|&i, &j| w[i][k].abs().total_cmp(&w[j][k].abs()))?;
        if w[pivot][k].abs() <= 1e-13 * size {
            return None;
        }
        w.swap(k, pivot);
        y.swap(k, pivot);
        for i in k + 1..order {
            let factor = w[i][k] / w[k][k];
            let above = w[k];
            let both = w[i][k..order].iter_mut().zip(&above[k..order]);
            both.for_each(|(x, above)| *x -= factor * above);
            y[i] -= factor * y[k];
        }
    }
    let mut x = [0.0; 3];
    for i in (0..order).rev() {
        let known: f64 = (i + 1..order).map(|j| w[i][j] * x[j]).sum();
        x[i] = (y[i] - known) / w[i][i];
    }
    Some(x)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A plausible W: A Aᵀ + ½ I of pseudo-random numbers.
    fn local(seed: usize, coefficient: f64, tangents: usize) -> Local {
        let number = |i: usize| {
            let phase = 12.9898 * i as f64 + 78.233 * seed as f64;
            2.0 * (43_758.545 * phase.sin()).rem_euclid(1.0) - 1.0
        };
        let a = |i: usize, j: usize| number(3 * i + j);
        let entry = |i: usize, j: usize| {
            let sum: f64 = (0..3).map(|k| a(i, k) * a(j, k)).sum();
            sum + if i == j { 0.5 } else { 0.0 }
        };
        let inside = |i: usize| i <= tangents;
        let w = std::array::from_fn(|i| {
            std::array::from_fn(|j| {
                if inside(i) && inside(j) {
                    entry(i, j)
                } else {
                    0.0
                }
            })
        });
        let mut q = [number(10) - 0.5, number(11), number(12)];
        q[1 + tangents..].fill(0.0);
        Local {
            w,
            q,
            coefficient,
            limit: f64::INFINITY,
            tangents,
        }
    }

    #[test]
    fn solutions_satisfy_the_law() {
        let (mut open, mut stick, mut slip) = (0, 0, 0);
        for seed in 0..3000 {
            for tangents in [1, 2] {
                let mut own = local(seed, 0.1 + (seed % 12) as f64 * 0.1, tangents);
                if seed % 3 == 0 {
                    own.limit = 0.2;
                }
                let x = own.solve([0.0; 3]).unwrap();
                let r_n: f64 = (0..3).map(|j| own.w[0][j] * x[j]).sum::<f64>() + own.q[0];
                let r_t = own.pull(x);
                assert!(x[0] >= 0.0 && r_n >= -1e-12 && (x[0] * r_n).abs() < 1e-12);
                let g = (own.coefficient * x[0]).min(own.limit);
                let t = x[1].hypot(x[2]);
                assert!(t <= g * (1.0 + 1e-12) + 1e-15);
                let speed = r_t[0].hypot(r_t[1]);
                if x[0] == 0.0 {
                    open += 1;
                } else if speed < 1e-10 {
                    stick += 1;
                } else {
                    slip += 1;
                    assert!((t - g).abs() < 1e-12, "{seed}: {t} is not {g}");
                    let work = r_t[0] * x[1] + r_t[1] * x[2];
                    assert!((work + speed * t).abs() < 1e-9, "{seed}: slips aside");
                }
            }
        }
        assert!(
            open > 500 && stick > 500 && slip > 500,
            "{open}, {stick}, {slip}"
        );
    }
}
