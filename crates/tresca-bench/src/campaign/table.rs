//! A campaign in one table.

use std::collections::BTreeMap;

use super::Judged;
use super::kept::Kept;
use super::kinds::KINDS;
use super::median::median;
use super::verdict::Verdict;

/// A line of the table: a kind, or all.
#[derive(Debug, Clone, Default)]
pub struct Line {
    /// The kind.
    pub name: String,
    /// Number of problems.
    pub problems: usize,
    /// How many of each verdict.
    pub verdicts: BTreeMap<&'static str, usize>,
    /// How many of each end.
    pub ends: BTreeMap<String, usize>,
    /// The largest difference of a right answer, of energies.
    pub difference: f64,
    /// n_A of right answers that converged, ascending.
    pub multiplications: Vec<usize>,
    /// The medians of n_A over the problems that were right then and are now: kept, found.
    pub medians: Option<[f64; 2]>,
}

/// All of them.
#[derive(Debug, Clone)]
pub struct Table {
    /// Kind by kind, those without a problem left out.
    pub lines: Vec<Line>,
    /// Of all.
    pub all: Line,
}

/// Share of undecided answers that is too much.
const UNDECIDED: f64 = 1e-3;

impl Line {
    fn new(name: &str) -> Self {
        Self {
            name: name.to_owned(),
            ..Self::default()
        }
    }

    fn add(&mut self, judged: &Judged) {
        let verdict = judged.judgement.verdict;
        self.problems += 1;
        *self.verdicts.entry(verdict.name()).or_default() += 1;
        *self.ends.entry(judged.end.name().to_owned()).or_default() += 1;
        if matches!(verdict, Verdict::Right | Verdict::Alarm)
            && let Some(difference) = judged.judgement.difference
        {
            self.difference = self.difference.max(difference);
            self.multiplications.push(judged.multiplications);
        }
    }

    /// How many of a verdict.
    pub fn count(&self, verdict: Verdict) -> usize {
        self.verdicts.get(verdict.name()).copied().unwrap_or(0)
    }

    /// How many wrong answers.
    pub fn wrong(&self) -> usize {
        self.count(Verdict::Wrong) + self.count(Verdict::WrongUnseen)
    }

    fn cells(&self) -> [String; 14] {
        let many = |verdict| match self.count(verdict) {
            0 => "–".to_owned(),
            count => count.to_string(),
        };
        let ends: Vec<String> = self
            .ends
            .iter()
            .map(|(end, count)| format!("{end} {count}"))
            .collect();
        [
            self.name.clone(),
            self.problems.to_string(),
            many(Verdict::Right),
            many(Verdict::Alarm),
            many(Verdict::Wrong),
            many(Verdict::WrongUnseen),
            many(Verdict::Undecided),
            many(Verdict::GaveUp),
            many(Verdict::Neither),
            many(Verdict::Unjudged),
            format!("{:.0e}", self.difference),
            format!(
                "{} / {}",
                median(&self.multiplications),
                self.multiplications.last().unwrap_or(&0)
            ),
            self.medians.map_or("–".to_owned(), |[kept, found]| {
                format!("{kept} → {found}")
            }),
            ends.join(", "),
        ]
    }
}

const HEAD: [&str; 14] = [
    "kind",
    "number",
    "right",
    "alarm",
    "WRONG",
    "unseen",
    "undecided",
    "gave up",
    "neither",
    "unjudged",
    "worst",
    "n_A median / max",
    "kept → now",
    "statuses",
];

impl Table {
    /// Of what was judged, beside the counts that were kept.
    pub fn new(judged: &[Judged], kept: Option<&Kept>) -> Self {
        let mut all = Line::new("all");
        let mut lines: Vec<Line> = KINDS.iter().map(|kind| Line::new(kind.name)).collect();
        for one in judged {
            all.add(one);
            for line in lines
                .iter_mut()
                .filter(|line| line.name == one.ticket.kind.name)
            {
                line.add(one);
            }
        }
        for line in lines.iter_mut().chain([&mut all]) {
            line.multiplications.sort_unstable();
            line.medians = kept.and_then(|kept| kept.medians(judged, &line.name));
        }
        lines.retain(|line| line.problems > 0);
        Self { lines, all }
    }

    /// What must not be, in words; empty if all is well.
    pub fn faults(&self) -> Vec<String> {
        let mut faults = Vec::new();
        let wrong = self.all.wrong();
        if wrong > 0 {
            faults.push(format!("{wrong} wrong answers"));
        }
        let undecided = self.all.count(Verdict::Undecided);
        // Of few problems one may be too many a share.
        if undecided as f64 > (UNDECIDED * self.all.problems as f64).max(1.0) {
            faults.push(format!("{undecided} undecided, more than 0.1 %"));
        }
        for line in &self.lines {
            if let Some([kept, found]) = line.medians
                && found > (1.05 * kept).max(kept + 1.0)
            {
                faults.push(format!(
                    "{}: median n_A rose from {kept} to {found}",
                    line.name
                ));
            }
        }
        faults
    }

    /// For the terminal.
    pub fn text(&self) -> String {
        let rows = self.rows();
        let width = |column: usize| {
            rows.iter()
                .map(|row| row[column].chars().count())
                .max()
                .unwrap_or(0)
        };
        let widths: Vec<usize> = (0..HEAD.len()).map(width).collect();
        let line = |row: &[String; 14]| {
            let cells = row.iter().enumerate().map(|(column, cell)| match column {
                0 | 13 => format!("{cell:<0$}", widths[column]),
                _ => format!("{cell:>0$}", widths[column]),
            });
            cells.collect::<Vec<_>>().join("  ").trim_end().to_owned()
        };
        rows.iter().map(|row| line(row) + "\n").collect()
    }

    /// For the documentation.
    pub fn markdown(&self) -> String {
        let mut text = String::new();
        for (number, row) in self.rows().iter().enumerate() {
            text += &format!("| {} |\n", row.join(" | "));
            if number == 0 {
                text += &format!("|{}\n", "---|".repeat(row.len()));
            }
        }
        text
    }

    fn rows(&self) -> Vec<[String; 14]> {
        let lines = self.lines.iter().chain([&self.all]);
        std::iter::once(HEAD.map(str::to_owned))
            .chain(lines.map(Line::cells))
            .collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::campaign::answer::End;
    use crate::campaign::tickets;
    use crate::campaign::verdict::Judgement;
    use tresca::Status;

    fn judged(number: usize, verdict: Verdict, multiplications: usize) -> Judged {
        Judged {
            ticket: tickets(number + 1, 1, &[&KINDS[0]])[number],
            end: End::Status(Status::Converged),
            multiplications,
            certificate: 0.0,
            judgement: Judgement {
                verdict,
                difference: Some(1e-9),
                oracle: String::new(),
            },
        }
    }

    #[test]
    fn what_must_not_be_is_a_fault() {
        let fine: Vec<_> = (0..9).map(|i| judged(i, Verdict::Right, 10 + i)).collect();
        let table = Table::new(&fine, None);
        assert!(table.faults().is_empty());
        assert_eq!(median(&table.all.multiplications), 14.0);
        let kept = Kept::of(1, &fine);
        assert!(Table::new(&fine, Some(&kept)).faults().is_empty());
        let more: Vec<_> = (0..9).map(|i| judged(i, Verdict::Right, 20 + i)).collect();
        assert_eq!(Table::new(&more, Some(&kept)).faults().len(), 1);
        let mut wrong = fine.clone();
        wrong.push(judged(9, Verdict::WrongUnseen, 1));
        assert_eq!(Table::new(&wrong, None).faults().len(), 1);
        let mut undecided = fine;
        undecided.push(judged(9, Verdict::Undecided, 1));
        assert!(Table::new(&undecided, None).faults().is_empty());
        undecided.push(judged(10, Verdict::Undecided, 1));
        assert_eq!(Table::new(&undecided, None).faults().len(), 1);
    }
}
