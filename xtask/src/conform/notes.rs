//! What a program printed that is no answer in its place.

use crate::lines::printable;
use ombrage::conformance::Behaviour;
use std::collections::BTreeMap;

/// How many lines of a sort, and the first of them.
#[derive(Debug, Default)]
pub struct Note {
    /// How many.
    pub lines: usize,
    /// The first line, or the id in it.
    pub first: String,
}

impl Note {
    fn add(&mut self, text: &str) {
        if self.lines == 0 {
            self.first = printable(text, 100);
        }
        self.lines += 1;
    }
}

/// Lines by sort.
#[derive(Debug, Default)]
pub struct Notes {
    no_answers: Note,
    unknown: Note,
    twice: Note,
    out_of_order: Note,
    relapses: BTreeMap<Behaviour, Note>,
}

impl Notes {
    /// A line that is no answer at all.
    pub fn no_answer(&mut self, line: &str) {
        self.no_answers.add(line);
    }

    /// An answer to what was not asked.
    pub fn unknown(&mut self, id: &str) {
        self.unknown.add(id);
    }

    /// A second answer, which does not count.
    pub fn twice(&mut self, id: &str) {
        self.twice.add(id);
    }

    /// An answer before its turn, which counts.
    pub fn out_of_order(&mut self, id: &str) {
        self.out_of_order.add(id);
    }

    /// It did not go on, among many requests.
    pub fn relapse(&mut self, behaviour: Behaviour, why: &str) {
        self.relapses.entry(behaviour).or_default().add(why);
    }

    /// A sentence on every behaviour that no case alone brings about, `blamed` being those that one
    /// does; with how many times.
    pub fn without_a_cause(&self, blamed: &[Behaviour]) -> Vec<(Behaviour, usize, String)> {
        let relapses = self.relapses.iter();
        let relapses = relapses.filter(|(behaviour, _)| !blamed.contains(behaviour));
        let sentence = |(behaviour, note): (&Behaviour, &Note)| {
            let (times, why) = (note.lines, &note.first);
            let text = format!("{times} times among many requests, never on one alone: {why}");
            (*behaviour, times, text)
        };
        relapses.map(sentence).collect()
    }

    /// A sentence on every sort there is, with how many lines.
    pub fn sentences(&self) -> Vec<(usize, String)> {
        let sorts = [
            (&self.no_answers, "lines that are no answers, the first"),
            (&self.unknown, "answers to what was not asked, the first"),
            (&self.twice, "second answers, which do not count, the first"),
            (
                &self.out_of_order,
                "answers out of order, which count, the first",
            ),
        ];
        let any = sorts.into_iter().filter(|(note, _)| note.lines > 0);
        any.map(|(note, what)| (note.lines, format!("{what}: {:?}", note.first)))
            .collect()
    }
}
