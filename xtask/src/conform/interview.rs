//! Asking a program all cases, whatever it does.
//!
//! All requests are sent at once, so a program may read and answer in its own time, flush or not.
//! Where it ends, hangs or floods before it has answered, the requests without an answer are sent
//! to a new process: first one alone, then twice as many each time it goes well. So what is at
//! fault is known for certain, and costs one case.

use super::child::{Printed, Program};
use super::notes::Notes;
use crate::error::Result;
use indicatif::ProgressBar;
use ombrage::conformance::{Behaviour, Case, Kernel};
use serde_json::Value;
use std::collections::{BTreeMap, HashMap, VecDeque};
use std::time::{Duration, Instant};

/// What became of a case.
#[derive(Clone, Debug)]
pub enum Outcome {
    /// The `out` of an answer.
    Out(Value),
    /// The program does not do this.
    Unsupported,
    /// There is no answer: why.
    None(Behaviour, String),
}

/// What a program made of all cases.
#[derive(Debug)]
pub struct Interview {
    /// One outcome a case, in their order.
    pub outcomes: Vec<Outcome>,
    /// What it printed that is no answer in its place.
    pub notes: Notes,
    /// Nanoseconds from one answer to the next.
    pub times: BTreeMap<(Kernel, &'static str), f64>,
}

/// Failures in a row after which the rest of a kind is not asked.
const HANGS: usize = 3;
const CRASHES: usize = 16;

/// Lines that are no answers, after which a program floods.
const RUBBISH: usize = 10_000;

/// How long a program may still print once every request is answered.
const LINGER: Duration = Duration::from_millis(300);

/// How a session ended.
enum End {
    Answered,
    Failed(Behaviour, String),
}

struct Asking<'a, S> {
    start: S,
    timeout: Duration,
    cases: &'a [Case],
    outcomes: Vec<Option<Outcome>>,
    notes: Notes,
    seconds: BTreeMap<(Kernel, &'static str), (f64, u32)>,
    bar: &'a ProgressBar,
}

/// Asks a program all cases; it has `timeout` for each answer. `start` starts it with an input.
///
/// # Errors
/// If it cannot be started.
pub fn ask<P: Program>(
    start: impl FnMut(Vec<u8>) -> Result<P>,
    cases: &[Case],
    timeout: Duration,
    bar: &ProgressBar,
) -> Result<Interview> {
    let mut asking = Asking {
        start,
        timeout,
        cases,
        outcomes: vec![None; cases.len()],
        notes: Notes::default(),
        seconds: BTreeMap::new(),
        bar,
    };
    asking.all()?;
    let never = || Outcome::None(Behaviour::Garbled, "it was not asked".into());
    let outcomes = asking.outcomes.into_iter();
    let mean = |(key, (seconds, answers))| (key, seconds / f64::from(answers) * 1e9);
    Ok(Interview {
        outcomes: outcomes.map(|o| o.unwrap_or_else(never)).collect(),
        notes: asking.notes,
        times: asking.seconds.into_iter().map(mean).collect(),
    })
}

impl<P: Program, S: FnMut(Vec<u8>) -> Result<P>> Asking<'_, S> {
    fn all(&mut self) -> Result<()> {
        let mut pending: VecDeque<usize> = (0..self.cases.len()).collect();
        let mut window = usize::MAX;
        let mut in_a_row = 0;
        while !pending.is_empty() {
            let batch: Vec<usize> = pending.iter().take(window).copied().collect();
            let end = self.session(&batch)?;
            let before = pending.len();
            pending.retain(|&case| self.outcomes[case].is_none());
            if pending.len() < before {
                in_a_row = 0;
            }
            let End::Failed(behaviour, why) = end else {
                window = window.saturating_mul(2);
                continue;
            };
            if batch.len() > 1 {
                self.notes.relapse(behaviour, &why);
                window = 1;
                continue;
            }
            self.fail(batch[0], behaviour, &why);
            pending.retain(|&case| case != batch[0]);
            window = usize::MAX;
            in_a_row += 1;
            let enough = if behaviour == Behaviour::Hung {
                HANGS
            } else {
                CRASHES
            };
            if in_a_row >= enough {
                self.give_up(&mut pending, batch[0], behaviour);
                in_a_row = 0;
            }
        }
        Ok(())
    }

    fn fail(&mut self, case: usize, behaviour: Behaviour, why: &str) {
        self.outcomes[case] = Some(Outcome::None(behaviour, why.into()));
        self.bar.inc(1);
    }

    /// Leaves out the rest of the kind, or of everything where no request was ever answered.
    fn give_up(&mut self, pending: &mut VecDeque<usize>, last: usize, behaviour: Behaviour) {
        let answered = |outcome: &Option<Outcome>| {
            matches!(outcome, Some(Outcome::Out(_) | Outcome::Unsupported))
        };
        let never = !self.outcomes.iter().any(answered);
        let kernel = self.cases[last].kernel();
        let why = "not asked: it had failed too often in a row";
        for case in std::mem::take(pending) {
            if never || self.cases[case].kernel() == kernel {
                self.fail(case, behaviour, why);
            } else {
                pending.push_back(case);
            }
        }
    }

    /// Sends some requests to a new process and takes what it answers.
    fn session(&mut self, batch: &[usize]) -> Result<End> {
        let mut input = String::new();
        let mut places = HashMap::new();
        for &case in batch {
            input += &self.cases[case].request().to_string();
            input.push('\n');
            places.insert(self.cases[case].id(), case);
        }
        let mut program = (self.start)(input.into_bytes())?;
        let mut deadline = Instant::now() + self.timeout;
        let mut last: Option<Instant> = None;
        let mut open: VecDeque<usize> = batch.iter().copied().collect();
        let mut rubbish = 0;
        while let Some(&first) = open.front() {
            if rubbish > RUBBISH {
                let why = "it prints lines without end that are no answers";
                return Ok(End::Failed(Behaviour::Garbled, why.into()));
            }
            let (line, when) = match program.next(deadline) {
                Printed::Line(line, when) => (line, when),
                Printed::LongLine => {
                    rubbish += 1;
                    self.notes.no_answer("a line of more than 64 KiB");
                    continue;
                }
                Printed::Endless => {
                    let why = "it prints a line that does not end";
                    return Ok(End::Failed(Behaviour::Garbled, why.into()));
                }
                Printed::End => return Ok(ended(&mut program, deadline)),
                Printed::Nothing => {
                    let why = format!("no answer in {} s", self.timeout.as_secs_f64());
                    return Ok(End::Failed(Behaviour::Hung, why));
                }
            };
            let Some((id, outcome)) = answer(&line) else {
                rubbish += 1;
                self.notes.no_answer(&String::from_utf8_lossy(&line));
                continue;
            };
            let Some(&case) = places.get(id.as_str()) else {
                rubbish += 1;
                self.notes.unknown(&id);
                continue;
            };
            if self.outcomes[case].is_some() {
                rubbish += 1;
                self.notes.twice(&id);
                continue;
            }
            if case == first {
                open.pop_front();
            } else {
                self.notes.out_of_order(&id);
                open.retain(|&other| other != case);
            }
            self.outcomes[case] = Some(outcome);
            self.bar.inc(1);
            if let Some(last) = last {
                let key = (self.cases[case].kernel(), self.cases[case].float());
                let (seconds, answers) = self.seconds.entry(key).or_default();
                *seconds += when.saturating_duration_since(last).as_secs_f64();
                *answers += 1;
            }
            last = Some(when);
            deadline = Instant::now() + self.timeout;
        }
        self.linger(program, &places);
        Ok(End::Answered)
    }

    /// Hears what a program says that has said everything.
    fn linger(&mut self, mut program: P, places: &HashMap<&str, usize>) {
        let deadline = Instant::now() + LINGER.min(self.timeout);
        for _ in 0..RUBBISH {
            match program.next(deadline) {
                Printed::Line(line, _) => match answer(&line) {
                    Some((id, _)) if places.contains_key(id.as_str()) => self.notes.twice(&id),
                    Some((id, _)) => self.notes.unknown(&id),
                    None => self.notes.no_answer(&String::from_utf8_lossy(&line)),
                },
                Printed::LongLine => self.notes.no_answer("a line of more than 64 KiB"),
                Printed::Endless | Printed::End | Printed::Nothing => return,
            }
        }
    }
}

/// Why a program has left requests without an answer.
fn ended(program: &mut impl Program, deadline: Instant) -> End {
    let (status, error) = program.end(deadline.min(Instant::now() + Duration::from_secs(1)));
    let mut why = match status {
        Some(status) => format!("it ended before it had answered ({status})"),
        None => "it closed standard output before it had answered".to_owned(),
    };
    if !error.is_empty() {
        why += &format!("; it says: {error}");
    }
    End::Failed(Behaviour::Crashed, why)
}

/// The id of an answer and what it says; `None` for a line that is none.
fn answer(line: &[u8]) -> Option<(String, Outcome)> {
    let mut answer: Value = serde_json::from_slice(line).ok()?;
    let id = answer.get("id")?.as_str()?.to_owned();
    let outcome = if let Some(out) = answer.get_mut("out") {
        Outcome::Out(out.take())
    } else if answer.get("unsupported").is_some() {
        Outcome::Unsupported
    } else {
        let why = "an answer has neither \"out\" nor \"unsupported\"";
        Outcome::None(Behaviour::Garbled, why.into())
    };
    Some((id, outcome))
}
