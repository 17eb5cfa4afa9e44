//! An explanation on one screen, and as JSON.

use super::digits::{digits, exact, scientific};
use super::verdict::{Shadows, Verdict};
use crate::error::{Error, Result};
use ombrage::Size;
use ombrage::conformance::{Agreement, Explanation, Loss, Step};
use serde_json::{Value, json};

/// Everything that is told.
pub struct Told<'a> {
    /// What is explained, in a line.
    pub title: String,
    /// The pixel's way.
    pub explanation: &'a Explanation,
    /// Its numbers.
    pub steps: Vec<Step>,
    /// What the strategies say.
    pub shadows: Vec<Shadows>,
    /// The strategy that decides the radiance.
    pub shadow: Option<String>,
    /// The light that is told of, of so many.
    pub light: usize,
    /// How many lights there are.
    pub lights: usize,
    /// The size of the picture.
    pub size: Size,
    /// The pixel.
    pub pixel: [u32; 2],
}

/// Objects whose t is shown: more do not fit the screen.
const MOST_OBJECTS: usize = 4;

/// A loss is worth a mark where a number is further than this from the truth, in ulp.
const MARKED: f64 = 2.0;

impl Told<'_> {
    /// The text: at most 100 columns, and 45 rows where the objects fit.
    pub fn text(&self) -> String {
        let mut text = format!("{}\n\n", self.title);
        text += &columns(
            "",
            ["f32", "f64", "truth"],
            ["ulp32", "ulp64"],
            ["bits", ""],
            ' ',
        );
        let mut notes = Notes::default();
        let (mut shown, mut left_out) = (0, 0);
        let first = self.explanation.truth.first;
        let seen = first.map(|first| format!("t {}", self.explanation.object(first.object)));
        let mut steps = self.steps.as_slice();
        while let Some((step, rest)) = steps.split_first() {
            if step.name.starts_with("t ") && self.is_left_out(step, &mut shown) {
                left_out += 1;
                steps = rest;
            } else if let Some((one, rest)) = in_one_row(steps) {
                text += &one;
                steps = rest;
            } else {
                let used = !step.name.starts_with("t ") || Some(&step.name) == seen.as_ref();
                text += &row(step, &step.name, used, &mut notes);
                steps = rest;
            }
        }
        text += &self.bytes(&mut notes);
        if left_out > 0 {
            notes.add("", format!("{left_out} more objects are not shown"));
        }
        if self.shadows.is_empty() {
            text += "\nNo shadow ray leaves here.\n";
        } else {
            text += &self.strategies();
        }
        text + &notes.text()
    }

    /// Of many objects only those that are hit are shown, and only a few of these.
    fn is_left_out(&self, step: &Step, shown: &mut usize) -> bool {
        let none = step.single.is_none() && step.double.is_none() && step.truth.is_none();
        let many = self.explanation.truth.hits.len() > MOST_OBJECTS;
        if many && (none || *shown == MOST_OBJECTS) {
            return true;
        }
        *shown += 1;
        false
    }

    /// The row of the bytes, marked where they wrap or a shadow ray is wrong.
    fn bytes(&self, notes: &mut Notes) -> String {
        let of = |bytes: [u8; 3]| bytes.map(|byte| byte.to_string()).join(" ");
        let Explanation {
            single,
            double,
            truth,
            ..
        } = self.explanation;
        let mut mark = ' ';
        if single.bytes != truth.bytes || double.bytes != truth.bytes {
            mark = '!';
        }
        for (name, wrap) in ["red", "green", "blue"]
            .into_iter()
            .zip(self.explanation.wraps())
        {
            if let Some(wrap) = wrap {
                mark = notes.add("", format!("byte of {name}: {wrap}"));
            }
        }
        if let Some(shadows) = self.wrong() {
            let [single, double] = shadows.verdicts.map(|verdict| self.word(verdict));
            let truth = self.word(self.shadows[0].verdicts[0]);
            let name = &shadows.name;
            let text = format!("L: by {name}: {single} in f32, {double} in f64; in truth {truth}");
            mark = notes.add("", text);
        }
        let bytes = [single.bytes, double.bytes, truth.bytes].map(of);
        columns(
            "bytes",
            bytes.each_ref().map(String::as_str),
            [""; 2],
            [""; 2],
            mark,
        )
    }

    /// The strategy in use, where it is wrong.
    fn wrong(&self) -> Option<&Shadows> {
        let truth = self.shadows.first()?.verdicts[0];
        let used = self
            .shadows
            .iter()
            .find(|shadows| Some(&shadows.name) == self.shadow.as_ref())?;
        let right = |verdict: &Verdict| *verdict == truth || is_same(*verdict, truth);
        (!used.verdicts.iter().all(right)).then_some(used)
    }

    /// The strategies' verdicts, two a row.
    fn strategies(&self) -> String {
        let truth = self.shadows[0].verdicts[0];
        let mut text = format!(
            "\nLight {}, in truth: {}; by each strategy:",
            self.light,
            self.word(truth)
        );
        if self.lights > 1 {
            text += &format!(" ({} lights, --light N)", self.lights);
        }
        text.push('\n');
        let cell = |shadows: &Shadows| {
            let [single, double] = shadows.verdicts.map(|verdict| {
                let wrong = if verdict == truth || is_same(verdict, truth) {
                    ' '
                } else {
                    '!'
                };
                format!("{wrong}{}", self.word(verdict))
            });
            format!("{:<14}{single:<16}{double:<17}", shadows.name)
        };
        text += &format!(
            "{0:<14}{1:<16}{2:<17}{0:<14}{1:<16}{2}\n",
            "", " f32", " f64"
        );
        let rest: Vec<String> = self.shadows[1..].iter().map(cell).collect();
        let half = rest.len().div_ceil(2);
        for (number, left) in rest[..half].iter().enumerate() {
            let right = rest.get(half + number).map_or("", String::as_str);
            text += format!("{left}{right}").trim_end();
            text.push('\n');
        }
        text
    }

    fn word(&self, verdict: Verdict) -> String {
        match verdict {
            Verdict::Away => "faces away".into(),
            Verdict::Lit => "lit".into(),
            Verdict::Itself => "acne".into(),
            Verdict::By(None) => "by another".into(),
            Verdict::By(Some(number)) => format!("by {}", self.explanation.object(number)),
        }
    }

    /// All of it as JSON.
    ///
    /// # Errors
    /// None that can be foreseen: every part has a form in JSON.
    pub fn json(&self) -> Result<String> {
        let verdicts = |shadows: &Shadows| {
            let [single, double] = shadows.verdicts.map(|verdict| self.word(verdict));
            json!({ "strategy": shadows.name, "f32": single, "f64": double })
        };
        let first = self.explanation.truth.first;
        let told = json!({
            "title": self.title,
            "pixel": self.pixel,
            "size": [self.size.width(), self.size.height()],
            "object": first.map(|first| self.explanation.object(first.object)),
            "light": self.light,
            "steps": self.steps.iter().map(step).collect::<Vec<Value>>(),
            "shadows": self.shadows.iter().map(verdicts).collect::<Vec<Value>>(),
            "wraps": self.explanation.wraps().map(|wrap| wrap.map(|wrap| wrap.to_string())),
            "bytes": {
                "f32": self.explanation.single.bytes,
                "f64": self.explanation.double.bytes,
                "truth": self.explanation.truth.bytes,
            },
        });
        let text = serde_json::to_string_pretty(&told)
            .map_err(|error| Error::new(format!("cannot write the steps as JSON: {error}")))?;
        Ok(text + "\n")
    }
}

/// Whether both say that another object blocks; the chain by sides does not say which.
fn is_same(a: Verdict, b: Verdict) -> bool {
    matches!((a, b), (Verdict::By(_), Verdict::By(_)))
}

/// Lines below the table, each with the letter that marks what it is about.
#[derive(Default)]
struct Notes(Vec<Note>);

struct Note {
    /// The vector whose components share it; empty for none.
    group: String,
    bits: f64,
    text: String,
}

impl Notes {
    /// Adds a line; its letter, which is the last one for all that come after it.
    fn add(&mut self, group: &str, text: String) -> char {
        self.0.push(Note {
            group: group.into(),
            bits: 0.0,
            text,
        });
        self.letter()
    }

    /// Adds a loss, or to the line of another component of the same vector, which tells the worst.
    fn lose(&mut self, name: &str, loss: Loss) -> char {
        let group = name.split_once('.').map_or("", |(group, _)| group);
        let same = self.0.last().is_some_and(|last| last.group == group);
        if group.is_empty() || !same {
            self.add(group, String::new());
        }
        if let Some(last) = self.0.last_mut().filter(|last| loss.bits() > last.bits) {
            last.bits = loss.bits();
            last.text = format!("{name}: {loss}");
        }
        self.letter()
    }

    fn letter(&self) -> char {
        char::from(b'a' + self.0.len().clamp(1, 26) as u8 - 1)
    }

    fn text(&self) -> String {
        let lines = ('a'..='z').zip(&self.0);
        let lines: String = lines
            .map(|(letter, note)| format!("{letter}  {}\n", note.text))
            .collect();
        if lines.is_empty() {
            lines
        } else {
            format!("\n{lines}")
        }
    }
}

/// A line of the table.
fn columns(name: &str, values: [&str; 3], ulps: [&str; 2], bits: [&str; 2], mark: char) -> String {
    let ([single, double, truth], [ulps, ulps64], [bits, bits64]) = (values, ulps, bits);
    let line = format!(
        "{name:<13}{single:<15}{double:<23}{truth:<24}{ulps:>6}{ulps64:>7}{bits:>5}{bits64:>4} {mark}"
    );
    line.trim_end().to_owned() + "\n"
}

/// Three components in one row: as a point, where nothing is to be said of them, or as one, where
/// they are equal.
fn in_one_row(steps: &[Step]) -> Option<(String, &[Step])> {
    let (three, rest) = steps.split_at_checked(3)?;
    let name = three[0]
        .name
        .strip_suffix(".x")
        .or(three[0].name.strip_suffix(".r"))?;
    let same = |step: &Step| {
        let first = &three[0];
        (step.single, step.double, step.truth) == (first.single, first.double, first.truth)
    };
    if name != "o" && three.iter().all(same) {
        return Some((row(&three[0], name, true, &mut Notes::default()), rest));
    }
    let is_exact = |step: &Step| {
        let exactly = |agreement: Option<Agreement>| agreement.is_some_and(|a| a.ulps == 0.0);
        let (single, double) = step.agreement();
        exactly(single) && exactly(double)
    };
    let texts: Option<Vec<String>> = three
        .iter()
        .map(|step| step.truth.map(|x| digits(x, 17)))
        .collect();
    let text = format!("({})", texts?.join(", "));
    if !three.iter().all(is_exact) {
        return None;
    }
    let line = match text.len() {
        ..15 => columns(name, [text.as_str(); 3], ["0"; 2], ["24", "53"], ' '),
        _ => format!("{name:<13}{text} in all three\n"),
    };
    Some((line, rest))
}

/// A line of the table for a number; a new note where digits are lost, unless the number is not
/// used any further and decides as the truth does.
fn row(step: &Step, name: &str, is_used: bool, notes: &mut Notes) -> String {
    let (single, double) = step.agreement();
    let far = |agreement: Option<Agreement>| agreement.is_some_and(|a| a.ulps > MARKED);
    let decision = [step.single.is_some(), step.double.is_some()];
    let decision = decision.into_iter().any(|hit| hit != step.truth.is_some());
    let mark = match step
        .loss
        .filter(|_| decision || is_used && (far(single) || far(double)))
    {
        Some(loss) => notes.lose(name, loss),
        None if decision => '!',
        None => ' ',
    };
    let none = || "-".to_owned();
    let ulps = |agreement: Option<Agreement>| agreement.map_or_else(none, |a| short(a.ulps));
    let bits = |agreement: Option<Agreement>| agreement.map_or_else(none, |a| a.bits.to_string());
    let [single_value, double_value, truth] = [
        step.single
            .map_or_else(none, |x| digits(exact(f64::from(x)), 9)),
        step.double.map_or_else(none, |x| digits(exact(x), 17)),
        step.truth.map_or_else(none, |x| digits(x, 18)),
    ];
    columns(
        name,
        [&single_value, &double_value, &truth],
        [&ulps(single), &ulps(double)],
        [&bits(single), &bits(double)],
        mark,
    )
}

/// Units in the last place in few characters.
fn short(ulps: f64) -> String {
    match ulps {
        0.0 => "0".into(),
        _ if ulps < 100.0 => format!("{ulps:.2}"),
        _ if ulps < 1e5 => format!("{ulps:.0}"),
        _ => format!("{ulps:.0e}"),
    }
}

fn step(step: &Step) -> Value {
    let (single, double) = step.agreement();
    let of =
        |agreement: Option<Agreement>| agreement.map(|a| json!({ "ulps": a.ulps, "bits": a.bits }));
    json!({
        "name": step.name,
        "f32": step.single,
        "f64": step.double,
        "truth": step.truth.map(scientific),
        "agreement": { "f32": of(single), "f64": of(double) },
        "lost": step.loss.map(|loss| loss.to_string()),
    })
}
