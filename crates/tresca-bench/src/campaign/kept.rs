//! The counts of before, kept in `campaign.toml`: n_A of every problem that was answered rightly.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};

use super::median::median;
use super::verdict::Verdict;
use super::{Judged, Ticket};

/// Counts of a campaign.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Kept {
    /// The seed of the campaign.
    pub seed: u64,
    /// Median and maximum of n_A of each kind, for reading.
    pub summary: BTreeMap<String, Summary>,
    /// Kind by kind n_A of its problems in their order, −1 where the answer was not right.
    pub n_a: BTreeMap<String, Vec<i64>>,
}

/// Of the right answers of a kind.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Summary {
    /// How many.
    pub right: usize,
    /// Of n_A.
    pub median: f64,
    /// Of n_A.
    pub maximum: usize,
}

fn count(judged: &Judged) -> i64 {
    let right = matches!(judged.judgement.verdict, Verdict::Right | Verdict::Alarm);
    if right && judged.judgement.difference.is_some() {
        judged.multiplications as i64
    } else {
        -1
    }
}

impl Kept {
    /// Those of the repository.
    ///
    /// # Errors
    /// When the file is none.
    pub fn stored() -> Result<Self, toml::de::Error> {
        toml::from_str(include_str!("../../campaign.toml"))
    }

    /// Of this campaign.
    pub fn of(seed: u64, judged: &[Judged]) -> Self {
        let mut n_a: BTreeMap<String, Vec<i64>> = BTreeMap::new();
        for one in judged {
            let own = n_a.entry(one.ticket.kind.name.to_owned()).or_default();
            own.push(count(one));
        }
        let summary = n_a.iter().map(|(name, counts)| {
            let mut right: Vec<usize> = counts
                .iter()
                .filter_map(|n| usize::try_from(*n).ok())
                .collect();
            right.sort_unstable();
            let summary = Summary {
                right: right.len(),
                median: median(&right),
                maximum: right.last().copied().unwrap_or(0),
            };
            (name.clone(), summary)
        });
        Self {
            seed,
            summary: summary.collect(),
            n_a,
        }
    }

    /// n_A of a problem that was answered rightly.
    fn count(&self, ticket: &Ticket) -> Option<usize> {
        let own = self.n_a.get(ticket.kind.name)?;
        usize::try_from(*own.get(ticket.number)?).ok()
    }

    /// The medians of n_A, kept and found, over the problems of a kind (or of `all`) right both times.
    pub fn medians(&self, judged: &[Judged], name: &str) -> Option<[f64; 2]> {
        let (mut kept, mut found) = (Vec::new(), Vec::new());
        for one in judged {
            let own = name == "all" || one.ticket.kind.name == name;
            if let (true, Some(before), Ok(now)) =
                (own, self.count(&one.ticket), usize::try_from(count(one)))
            {
                kept.push(before);
                found.push(now);
            }
        }
        kept.sort_unstable();
        found.sort_unstable();
        (!kept.is_empty()).then(|| [median(&kept), median(&found)])
    }
}
