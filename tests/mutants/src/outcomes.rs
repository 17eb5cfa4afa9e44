//! What became of mutants, in `target/mutants/outcomes.jsonl`.

use crate::error::{Error, Result};
use crate::mutant::Mutant;
use crate::project::{Project, digest};
use crate::records::{self, Records};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::fs;
use std::path::PathBuf;

/// What became of a mutant.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Verdict {
    /// A test fails, or takes too long.
    Noticed {
        /// The test.
        by: String,
    },
    /// All tests that were tried pass.
    NotNoticed {
        /// The tests.
        tried: Vec<String>,
        /// How many others reach it, which are too slow.
        untried: usize,
    },
    /// It does not compile.
    Unviable,
    /// It may compile, but not behind a switch.
    NotSwitched,
}

/// A line of the file. It holds for the mutant's file as it was.
#[derive(Debug, Clone, Serialize, Deserialize)]
struct Line {
    mutant: String,
    source: String,
    project: String,
    verdict: Verdict,
}

/// What is known of the mutants of a run.
pub struct Outcomes {
    path: PathBuf,
    /// A digest of the whole project.
    project: String,
    /// By the number of the mutant: its name, and a digest of its file.
    names: Vec<(String, String)>,
    lines: BTreeMap<usize, Line>,
}

impl Outcomes {
    /// What earlier runs have found about these mutants.
    ///
    /// # Errors
    /// If a file of the project cannot be read.
    pub fn read(project: &Project, mutants: &[Mutant]) -> Result<Self> {
        let name = |mutant: &Mutant| {
            let source = project.text(&mutant.file)?;
            Ok((mutant.name.clone(), digest(source)))
        };
        let mut outcomes = Self {
            path: project.room().join("outcomes.jsonl"),
            project: digest(project.files()),
            names: mutants.iter().map(name).collect::<Result<_>>()?,
            lines: BTreeMap::new(),
        };
        outcomes.reread();
        Ok(outcomes)
    }

    /// Reads the file once more.
    pub fn reread(&mut self) {
        let names = self.names.iter().enumerate();
        let numbers: BTreeMap<_, _> = names.map(|(number, name)| (name, number)).collect();
        for line in records::read::<Line>(&self.path) {
            let name = (line.mutant.clone(), line.source.clone());
            if let Some(number) = numbers.get(&name) {
                self.lines.insert(*number, line);
            }
        }
    }

    /// Forgets what is known of the mutants of these paths.
    ///
    /// # Errors
    /// If the file cannot be written.
    pub fn forget(&mut self, paths: &[String]) -> Result<()> {
        let is_named = |line: &Line| paths.iter().any(|path| line.mutant.starts_with(path));
        let others = records::read::<Line>(&self.path).into_iter();
        let others: Vec<Line> = others.filter(|line| !is_named(line)).collect();
        let failed = |error| Error::at(&self.path, &error);
        fs::write(&self.path, []).map_err(failed)?;
        let records = Records::open(&self.path)?;
        self.lines.clear();
        others.iter().try_for_each(|line| records.add(line))
    }

    /// What became of a mutant, if it is known.
    pub fn of(&self, mutant: usize) -> Option<&Verdict> {
        self.lines.get(&mutant).map(|line| &line.verdict)
    }

    /// The tests that have noticed mutants, one for each.
    pub fn noticing(&self) -> impl Iterator<Item = &str> {
        self.lines.values().filter_map(|line| match &line.verdict {
            Verdict::Noticed { by } => Some(by.as_str()),
            _ => None,
        })
    }

    /// Whether no test is to be tried any more.
    pub fn is_final(&self, mutant: usize) -> bool {
        !matches!(self.of(mutant), None | Some(Verdict::NotNoticed { .. }))
    }

    /// The tests that did not notice a mutant; none if anything has changed in the project since,
    /// because it may be the tests.
    pub fn tried(&self, mutant: usize) -> &[String] {
        match self.lines.get(&mutant) {
            Some(Line {
                project,
                verdict: Verdict::NotNoticed { tried, .. },
                ..
            }) if *project == self.project => tried,
            _ => &[],
        }
    }

    /// Adds what became of a mutant to the file.
    ///
    /// # Errors
    /// If it cannot be written.
    pub fn add(&self, records: &Records, mutant: usize, verdict: Verdict) -> Result<()> {
        let (name, source) = self.names[mutant].clone();
        records.add(&Line {
            mutant: name,
            source,
            project: self.project.clone(),
            verdict,
        })
    }

    /// The file, to add to.
    ///
    /// # Errors
    /// If it cannot be opened.
    pub fn records(&self) -> Result<Records> {
        Records::open(&self.path)
    }
}
