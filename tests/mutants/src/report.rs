//! What is printed at the end: a table, file by file, and the survivors.

use crate::mutant::Mutant;
use crate::outcomes::{Outcomes, Verdict};
use std::collections::{BTreeMap, BTreeSet};

/// Numbers of mutants.
#[derive(Debug, Default, Clone, Copy, PartialEq, Eq)]
struct Counts {
    noticed: usize,
    not_noticed: usize,
    untried: usize,
}

impl Counts {
    fn viable(self) -> usize {
        self.noticed + self.not_noticed + self.untried
    }

    fn add(&mut self, other: Self) {
        self.noticed += other.noticed;
        self.not_noticed += other.not_noticed;
        self.untried += other.untried;
    }
}

/// What became of the mutants of a run.
pub struct Report<'a> {
    mutants: &'a [Mutant],
    outcomes: &'a Outcomes,
}

impl<'a> Report<'a> {
    /// Of these mutants.
    pub fn new(mutants: &'a [Mutant], outcomes: &'a Outcomes) -> Self {
        Self { mutants, outcomes }
    }

    /// Whether a test notices every mutant that is viable.
    pub fn is_clean(&self) -> bool {
        let mut numbers = 0..self.mutants.len();
        numbers.all(|number| self.outcomes.is_final(number))
    }

    /// All of it.
    pub fn text(&self) -> String {
        [self.table(), self.survivors(), self.unswitched()].concat()
    }

    fn table(&self) -> String {
        let mut files: BTreeMap<&str, Counts> = BTreeMap::new();
        let mut unviable = 0;
        for (number, mutant) in self.mutants.iter().enumerate() {
            let counts = files.entry(&mutant.file).or_default();
            match self.outcomes.of(number) {
                None => counts.untried += 1,
                Some(Verdict::Noticed { .. }) => counts.noticed += 1,
                Some(Verdict::NotNoticed { .. }) => counts.not_noticed += 1,
                Some(Verdict::Unviable) => unviable += 1,
                Some(Verdict::NotSwitched) => {}
            }
        }
        let mut total = Counts::default();
        let mut rows =
            vec![["file", "viable", "noticed", "not noticed", "untried"].map(str::to_owned)];
        for (file, counts) in &files {
            total.add(*counts);
            rows.push(row(file, *counts));
        }
        rows.push(row("total", total));
        let tried = total.noticed + total.not_noticed;
        let share = match tried {
            0 => "nothing was tried".to_owned(),
            _ => format!(
                "{:.2} % of those tried are noticed",
                100.0 * total.noticed as f64 / tried as f64
            ),
        };
        format!(
            "{}{share}; {unviable} more are unviable: they do not compile\n",
            aligned(&rows)
        )
    }

    fn survivors(&self) -> String {
        let mut text = String::new();
        for (number, mutant) in self.mutants.iter().enumerate() {
            if let Some(Verdict::NotNoticed { tried, untried }) = self.outcomes.of(number) {
                let tests = match (tried.len(), untried) {
                    (0, 0) => "no test reaches it".to_owned(),
                    (tried, slower) => {
                        format!("tests that reach it: {tried} tried, {slower} slower ones not")
                    }
                };
                text += &format!("{} ({tests})\n", mutant.name);
            }
        }
        match text.as_str() {
            "" => text,
            _ => format!("\nNot noticed:\n{text}"),
        }
    }

    fn unswitched(&self) -> String {
        let mut text = String::new();
        let mut files = BTreeSet::new();
        for (number, mutant) in self.mutants.iter().enumerate() {
            if self.outcomes.of(number) == Some(&Verdict::NotSwitched) {
                text += &format!("{}\n", mutant.name);
                files.insert((&mutant.package, &mutant.file));
            }
        }
        if text.is_empty() {
            return text;
        }
        let commands = files.into_iter().map(|(package, file)| {
            format!("  cargo mutants --config .cargo/mutants.toml -p {package} --file {file}\n")
        });
        let commands: String = commands.collect();
        format!("\nNot switched: try with cargo mutants:\n{text}{commands}")
    }
}

fn row(name: &str, counts: Counts) -> [String; 5] {
    let numbers = [
        counts.viable(),
        counts.noticed,
        counts.not_noticed,
        counts.untried,
    ];
    let [viable, noticed, not_noticed, untried] = numbers.map(|number| number.to_string());
    [name.to_owned(), viable, noticed, not_noticed, untried]
}

/// Rows in columns two spaces apart: the first aligned left, the others right, a rule under the heads.
fn aligned(rows: &[[String; 5]]) -> String {
    let width = |column: usize| rows.iter().map(|row| row[column].len()).max().unwrap_or(0);
    let widths: [usize; 5] = std::array::from_fn(width);
    let mut text = String::new();
    for (number, row) in rows.iter().enumerate() {
        let [a, b, c, d, e] = row;
        let [wa, wb, wc, wd, we] = widths;
        text += &format!("{a:<wa$}  {b:>wb$}  {c:>wc$}  {d:>wd$}  {e:>we$}\n");
        if number == 0 {
            text += &"─".repeat(widths.iter().sum::<usize>() + 2 * (widths.len() - 1));
            text += "\n";
        }
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn columns_are_aligned() {
        let counts = |noticed, not_noticed| Counts {
            noticed,
            not_noticed,
            untried: 0,
        };
        let heads = ["file", "viable", "noticed", "not noticed", "untried"].map(str::to_owned);
        let rows = [
            heads,
            row("src/a.rs", counts(10, 2)),
            row("total", counts(10, 2)),
        ];
        let text = aligned(&rows);
        let lines: Vec<&str> = text.lines().collect();
        assert_eq!(lines[0], "file      viable  noticed  not noticed  untried");
        assert_eq!(lines[1].chars().count(), lines[0].len());
        assert_eq!(lines[2], "src/a.rs      12       10            2        0");
        assert_eq!(lines[3].len(), lines[2].len());
    }
}
