//! What a program printed that is no answer in its place.

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
            self.first = text.chars().take(60).collect();
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
