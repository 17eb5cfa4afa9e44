//! Which mutants the compiler's errors are about.

use crate::lines::Range;
use crate::rewrite::Switched;
use serde::Deserialize;
use std::collections::{BTreeMap, BTreeSet};

/// Mutants that cannot stay, from one run of the compiler.
#[derive(Debug, Default, PartialEq, Eq)]
pub struct Blame {
    /// Their own code does not compile.
    pub unviable: BTreeSet<usize>,
    /// The code around their switches does not.
    pub unswitchable: BTreeSet<usize>,
    /// Errors that are nobody's.
    pub others: Vec<String>,
}

/// A line that cargo prints as JSON.
#[derive(Deserialize)]
struct Line {
    message: Option<Message>,
}

/// What the compiler says.
#[derive(Deserialize)]
struct Message {
    level: String,
    message: String,
    spans: Vec<Span>,
    #[serde(default)]
    children: Vec<Message>,
}

#[derive(Deserialize)]
struct Span {
    file_name: String,
    byte_start: usize,
    byte_end: usize,
    is_primary: bool,
}

impl Blame {
    /// Reads what cargo prints with `--message-format=json` about these files.
    pub fn of(printed: &str, files: &BTreeMap<String, Switched>) -> Self {
        let mut blame = Self::default();
        let lines = printed.lines();
        let lines = lines.filter_map(|line| serde_json::from_str::<Line>(line).ok());
        for message in lines.filter_map(|line| line.message) {
            if message.level == "error" {
                blame.add(&message, files);
            }
        }
        // An error in the code of a mutant often makes others around its place, which go with it.
        if !blame.unviable.is_empty() {
            blame.unswitchable.clear();
            blame.others.clear();
        }
        blame
    }

    fn add(&mut self, error: &Message, files: &BTreeMap<String, Switched>) {
        let all = error.spans();
        let main: Vec<&Span> = error.spans.iter().filter(|span| span.is_primary).collect();
        for spans in [&main, &all] {
            let own: BTreeSet<usize> = spans
                .iter()
                .filter_map(|span| branch(span, files))
                .collect();
            if !own.is_empty() {
                self.unviable.extend(own);
                return;
            }
        }
        for spans in [&main, &all] {
            let around: BTreeSet<usize> =
                spans.iter().flat_map(|span| place(span, files)).collect();
            if !around.is_empty() {
                self.unswitchable.extend(around);
                return;
            }
        }
        if !error.message.starts_with("aborting due to") {
            self.others.push(error.message.clone());
        }
    }
}

impl Message {
    /// The places that it and its notes name.
    fn spans(&self) -> Vec<&Span> {
        self.spans
            .iter()
            .chain(self.children.iter().flat_map(|note| note.spans()))
            .collect()
    }
}

/// The mutant whose code has all of this; the innermost, if several have.
fn branch(span: &Span, files: &BTreeMap<String, Switched>) -> Option<usize> {
    let branches = &files.get(&span.file_name)?.branches;
    let around = branches.iter().filter(|(range, _)| span.is_in(*range));
    let inner = around.min_by_key(|(range, _)| range.1 - range.0)?;
    Some(inner.1)
}

/// The mutants of the innermost place that has all of this.
fn place(span: &Span, files: &BTreeMap<String, Switched>) -> Vec<usize> {
    let places = files.get(&span.file_name).map(|file| &file.places);
    let around = places.into_iter().flatten();
    let around = around.filter(|(range, _)| span.is_in(*range));
    let inner = around.min_by_key(|(range, _)| range.1 - range.0);
    inner
        .map(|(_, mutants)| mutants.clone())
        .unwrap_or_default()
}

impl Span {
    fn is_in(&self, range: Range) -> bool {
        range.0 <= self.byte_start && self.byte_end <= range.1
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::{Value, json};

    /// A file with a place of two mutants in a place of another one.
    fn files() -> BTreeMap<String, Switched> {
        let file = Switched {
            text: String::new(),
            branches: vec![((10, 20), 0), ((30, 40), 1), ((40, 50), 2)],
            places: vec![((25, 60), vec![1, 2]), ((5, 90), vec![0])],
            without: vec![],
        };
        BTreeMap::from([("src/a.rs".to_owned(), file)])
    }

    fn error(spans: &[(usize, usize, bool)]) -> String {
        let spans = spans.iter().map(|(start, end, main)| {
            json!({"file_name": "src/a.rs", "byte_start": start, "byte_end": end, "is_primary": main})
        });
        let spans: Vec<Value> = spans.collect();
        let message = json!({"level": "error", "message": "wrong", "spans": spans});
        json!({"reason": "compiler-message", "message": message}).to_string()
    }

    fn blamed(errors: &[&[(usize, usize, bool)]]) -> (Vec<usize>, Vec<usize>, usize) {
        let lines: Vec<String> = errors.iter().map(|spans| error(spans)).collect();
        let blame = Blame::of(&lines.join("\n"), &files());
        let all = |set: BTreeSet<usize>| set.into_iter().collect();
        (
            all(blame.unviable),
            all(blame.unswitchable),
            blame.others.len(),
        )
    }

    #[test]
    fn the_mutant_whose_code_is_wrong() {
        assert_eq!(blamed(&[&[(12, 14, true)]]), (vec![0], vec![], 0));
        assert_eq!(
            blamed(&[&[(40, 50, true)], &[(31, 32, true)]]),
            (vec![1, 2], vec![], 0)
        );
    }

    #[test]
    fn the_main_place_counts_before_others() {
        assert_eq!(
            blamed(&[&[(31, 32, false), (41, 42, true)]]),
            (vec![2], vec![], 0)
        );
        assert_eq!(
            blamed(&[&[(31, 32, false), (70, 72, true)]]),
            (vec![1], vec![], 0)
        );
    }

    #[test]
    fn the_innermost_place_if_no_code_of_a_mutant_is_wrong() {
        assert_eq!(blamed(&[&[(52, 55, true)]]), (vec![], vec![1, 2], 0));
        assert_eq!(blamed(&[&[(35, 45, true)]]), (vec![], vec![1, 2], 0));
        assert_eq!(blamed(&[&[(6, 8, true)]]), (vec![], vec![0], 0));
    }

    #[test]
    fn nobody() {
        assert_eq!(blamed(&[&[(95, 96, true)]]), (vec![], vec![], 1));
        assert_eq!(blamed(&[]), (vec![], vec![], 0));
    }

    #[test]
    fn an_error_around_goes_with_one_in_the_code() {
        assert_eq!(
            blamed(&[&[(6, 8, true)], &[(12, 14, true)]]),
            (vec![0], vec![], 0)
        );
    }
}
