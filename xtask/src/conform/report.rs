//! What is said about a program's answers.

use super::interview::{Interview, Outcome};
use crate::error::{Error, Result};
use crate::lines::printable;
use crate::table::Table;
use ombrage::Quality;
use ombrage::conformance::{
    Behaviour, Case, Evidence, Judged, Kernel, Measured, Wrong, precision, promise, recognise,
};
use serde::Serialize;
use std::collections::{BTreeMap, BTreeSet};

/// The largest error where the decision is right.
#[derive(Clone, Debug, Serialize)]
struct Worst {
    id: String,
    ulps: f64,
}

/// A kind in a format.
#[derive(Debug, Serialize)]
struct Row {
    kind: &'static str,
    prec: &'static str,
    passed: usize,
    failed: usize,
    unsupported: usize,
    worst: Option<Worst>,
    #[serde(skip)]
    decisions: usize,
    #[serde(skip)]
    key: (Kernel, &'static str),
}

/// Something that is wrong.
#[derive(Debug, Serialize)]
struct Finding {
    code: &'static str,
    severity: &'static str,
    #[serde(skip_serializing_if = "Option::is_none")]
    kind: Option<&'static str>,
    #[serde(skip_serializing_if = "Option::is_none")]
    prec: Option<&'static str>,
    #[serde(skip_serializing_if = "Option::is_none")]
    family: Option<String>,
    /// Cases, or lines of output, that show it.
    cases: usize,
    /// Of so many that could.
    #[serde(skip_serializing_if = "Option::is_none")]
    of: Option<usize>,
    #[serde(skip_serializing_if = "Option::is_none")]
    first: Option<String>,
    message: String,
}

/// The verdict and all that leads to it.
#[derive(Debug, Serialize)]
pub struct Report {
    verdict: &'static str,
    kinds: Vec<Row>,
    behaviours: Vec<&'static str>,
    findings: Vec<Finding>,
}

/// The code of a family of which a case is more wrong than allowed.
const FAILED: &str = "FAILED";

impl Report {
    /// Judges the answers to all cases, by what is allowed in a quality or to any kernel.
    pub fn new(cases: &[Case], interview: &Interview, quality: Option<Quality>) -> Self {
        let outcomes = &interview.outcomes;
        let judged: Vec<Judged> = cases
            .iter()
            .zip(outcomes)
            .filter_map(|(case, outcome)| match outcome {
                Outcome::Out(out) => {
                    let kernel = case.kernel();
                    let allowed = match quality {
                        Some(quality) => precision(kernel, quality, case.float()),
                        None => promise(kernel),
                    };
                    Some(Judged::new(case, out.clone(), allowed.allowed))
                }
                _ => None,
            })
            .collect();
        let evidence = recognise(&judged);
        let mut findings = named(&evidence);
        findings.extend(unanswered(cases, interview, &judged));
        let mut behaviours: Vec<&'static str> = vec![];
        for behaviour in Behaviour::ALL {
            let code = behaviour.code();
            if findings.iter().any(|finding| finding.code == code) {
                behaviours.push(code);
            }
        }
        findings.extend(failed_families(&judged));
        let kinds = rows(cases, outcomes, &judged);
        let answered = outcomes
            .iter()
            .any(|outcome| !matches!(outcome, Outcome::Unsupported));
        let verdict = match (findings.is_empty(), answered) {
            (false, _) => "faults",
            (true, true) => "conforms",
            (true, false) => "unknown",
        };
        Self {
            verdict,
            kinds,
            behaviours,
            findings,
        }
    }

    /// Whether anything is wrong.
    pub fn has_faults(&self) -> bool {
        !self.findings.is_empty()
    }

    /// As JSON.
    ///
    /// # Errors
    /// None that can be foreseen: every part has a form in JSON.
    pub fn json(&self) -> Result<String> {
        let text = serde_json::to_string_pretty(self)
            .map_err(|error| Error::new(format!("cannot write the report as JSON: {error}")))?;
        Ok(text + "\n")
    }

    /// As text, with the mean times from one answer to the next of the program and of the kit's
    /// own.
    pub fn text(&self, times: &Times, own: &Times) -> String {
        let mut table = Table::new(&[
            "kind", "prec", "passed", "failed", "unsup.", "decis.", "worst", "us", "our us",
        ]);
        for row in &self.kinds {
            let time = |times: &Times| match times.get(&row.key) {
                Some(ns) => format!("{:.1}", ns / 1e3),
                None => "-".into(),
            };
            let worst = row.worst.as_ref();
            table.row(vec![
                row.kind.into(),
                row.prec.into(),
                row.passed.to_string(),
                row.failed.to_string(),
                row.unsupported.to_string(),
                row.decisions.to_string(),
                worst.map_or("-".into(), |worst| ulps(worst.ulps)),
                time(times),
                time(own),
            ]);
        }
        let mut text = table.render();
        text += "decis.: wrong decisions and roots; worst: the largest error elsewhere in ulp; us: \
                 microseconds\nfrom one answer to the next, in a pipe, with JSON\n";
        text += &self.worst();
        text += &self.families();
        text += &self.named();
        text + &match self.verdict {
            "conforms" => "\nIt conforms.\n".to_owned(),
            "unknown" => "\nIt does nothing of this, so nothing is wrong.\n".to_owned(),
            _ => format!("\n{} findings.\n", self.findings.len()),
        }
    }

    /// Where the largest errors are.
    fn worst(&self) -> String {
        let mut text = String::from("\nThe largest errors\n");
        let mut any = false;
        for row in &self.kinds {
            if let Some(Worst { id, ulps: worst }) = &row.worst {
                text += &format!("  {:>8} ulp  {id}\n", ulps(*worst));
                any = true;
            }
        }
        if any { text } else { String::new() }
    }

    /// The families of which cases fail.
    fn families(&self) -> String {
        let mut table = Table::new(&["families that fail", "f32", "f64", "the first"]);
        let mut rows: BTreeMap<String, (BTreeMap<&str, String>, &str)> = BTreeMap::new();
        for finding in self.findings.iter().filter(|f| f.code == FAILED) {
            let (kind, prec) = (finding.kind.unwrap_or_default(), finding.prec);
            let family = finding.family.as_deref().unwrap_or_default();
            let (cells, _) = rows
                .entry(format!("{kind}.{family}"))
                .or_insert_with(|| (BTreeMap::new(), &finding.message));
            let failed = format!("{} of {}", finding.cases, finding.of.unwrap_or_default());
            cells.insert(prec.unwrap_or_default(), failed);
        }
        if rows.is_empty() {
            return String::new();
        }
        for (family, (mut cells, first)) in rows {
            let [single, double] = ["f32", "f64"].map(|prec| cells.remove(prec));
            let cell = |cell: Option<String>| cell.unwrap_or_else(|| "-".into());
            table.row(vec![family, cell(single), cell(double), first.into()]);
        }
        format!("\n{}", table.render())
    }

    /// The behaviours, each with what to look for.
    fn named(&self) -> String {
        let mut text = String::new();
        let mut said = BTreeSet::new();
        for finding in self.findings.iter().filter(|f| f.code != FAILED) {
            if said.insert(finding.code) {
                let behaviour = Behaviour::ALL
                    .into_iter()
                    .find(|behaviour| behaviour.code() == finding.code);
                let advice = behaviour.map_or("", Behaviour::advice);
                text.push('\n');
                text += &wrapped("", &format!("{}: {advice}.", finding.code));
            }
            text += &wrapped("  ", &finding.message);
        }
        text
    }
}

/// Text in lines of at most 100 columns, all but the first indented further.
fn wrapped(indent: &str, text: &str) -> String {
    let mut lines = String::new();
    let mut line = indent.to_owned();
    for word in text.split_whitespace() {
        if line.chars().count() + 1 + word.chars().count() > 100 {
            lines += &line;
            lines.push('\n');
            line = format!("{indent}   ");
        }
        if !line.trim().is_empty() {
            line.push(' ');
        }
        line += word;
    }
    lines + &line + "\n"
}

/// Mean nanoseconds from one answer to the next.
type Times = BTreeMap<(Kernel, &'static str), f64>;

fn ulps(ulps: f64) -> String {
    match ulps {
        _ if ulps.is_infinite() => "inf".into(),
        _ if ulps >= 1e5 => format!("{ulps:.1e}"),
        _ => format!("{ulps:.2}"),
    }
}

/// A finding for every behaviour, kind and format.
fn named(evidence: &[Evidence]) -> Vec<Finding> {
    let mut sorted: Vec<&Evidence> = evidence.iter().collect();
    sorted.sort_by_key(|evidence| evidence.behaviour);
    let finding = |evidence: &Evidence| {
        let (kind, prec) = (evidence.kernel.name(), evidence.float);
        let (matched, telling, first) = (evidence.matched, evidence.telling, evidence.first);
        Finding {
            code: evidence.behaviour.code(),
            severity: "error",
            kind: Some(kind),
            prec: Some(prec),
            family: None,
            cases: matched,
            of: Some(telling),
            first: Some(first.into()),
            message: format!("{kind} {prec}: {matched} of {telling} cases, such as {first}"),
        }
    };
    sorted.into_iter().map(finding).collect()
}

/// Findings about what the program did instead of answering.
fn unanswered(cases: &[Case], interview: &Interview, judged: &[Judged]) -> Vec<Finding> {
    let malformed = judged
        .iter()
        .filter(|judged| judged.verdict.wrong == Some(Wrong::Malformed))
        .map(|judged| {
            let whole = judged.out.to_string();
            let mut out = printable(&whole, 40);
            if whole.chars().count() > 40 {
                out.push('…');
            }
            (
                Behaviour::Garbled,
                judged.case,
                format!("its \"out\" is {out}"),
            )
        });
    let none = cases.iter().zip(&interview.outcomes);
    let none = none.filter_map(|(case, outcome)| match outcome {
        Outcome::None(behaviour, why) => Some((*behaviour, case, why.clone())),
        _ => None,
    });
    let mut findings: BTreeMap<(Behaviour, Kernel, &str), Finding> = BTreeMap::new();
    for (behaviour, case, why) in none.chain(malformed) {
        let (kernel, prec) = (case.kernel(), case.float());
        let kind = kernel.name();
        let finding = findings
            .entry((behaviour, kernel, prec))
            .or_insert_with(|| Finding {
                code: behaviour.code(),
                severity: "error",
                kind: Some(kind),
                prec: Some(prec),
                family: None,
                cases: 0,
                of: None,
                first: Some(case.id().into()),
                message: why,
            });
        finding.cases += 1;
    }
    for finding in findings.values_mut() {
        let (kind, prec) = (
            finding.kind.unwrap_or_default(),
            finding.prec.unwrap_or_default(),
        );
        let first = finding.first.as_deref().unwrap_or_default();
        finding.message = format!(
            "{kind} {prec}: {} cases, the first {first}: {}",
            finding.cases, finding.message
        );
    }
    let blamed: Vec<Behaviour> = findings.keys().map(|(behaviour, ..)| *behaviour).collect();
    let lines = interview.notes.sentences().into_iter();
    let lines = lines.map(|(lines, text)| (Behaviour::Garbled, lines, format!("{lines} {text}")));
    let notes = interview.notes.without_a_cause(&blamed).into_iter();
    let notes = notes
        .chain(lines)
        .map(|(behaviour, cases, message)| Finding {
            code: behaviour.code(),
            severity: "error",
            kind: None,
            prec: None,
            family: None,
            cases,
            of: None,
            first: None,
            message,
        });
    findings.into_values().chain(notes).collect()
}

/// A finding for every family, kind and format of which a case fails.
fn failed_families(judged: &[Judged]) -> Vec<Finding> {
    let mut findings: BTreeMap<(Kernel, &str, &str), Finding> = BTreeMap::new();
    for judged in judged {
        let case = judged.case;
        let (kernel, prec, family) = (case.kernel(), case.float(), case.family());
        let finding = findings
            .entry((kernel, family, prec))
            .or_insert_with(|| Finding {
                code: FAILED,
                severity: "error",
                kind: Some(kernel.name()),
                prec: Some(prec),
                family: Some(family.into()),
                cases: 0,
                of: Some(0),
                first: None,
                message: String::new(),
            });
        finding.of = finding.of.map(|of| of + 1);
        if judged.fails {
            finding.cases += 1;
            if finding.first.is_none() {
                finding.first = Some(case.id().into());
                finding.message = what(judged);
            }
        }
    }
    let all = findings.into_values();
    all.filter(|finding| finding.cases > 0).collect()
}

/// What is wrong with an answer, in short, and with which.
fn what(judged: &Judged) -> String {
    let number = judged.case.id().rsplit('.').next().unwrap_or_default();
    let what = match (judged.verdict.wrong, judged.verdict.bounds) {
        (Some(wrong), _) => wrong.to_string(),
        (None, Some(bounds)) => format!("{} u B", ulps(bounds)),
        (None, None) => format!("{} ulp", ulps(judged.verdict.ulps)),
    };
    format!("{number}: {what}")
}

fn rows(cases: &[Case], outcomes: &[Outcome], judged: &[Judged]) -> Vec<Row> {
    let mut rows = vec![];
    for kernel in Kernel::ALL {
        for prec in ["f32", "f64"] {
            let is_of = |case: &Case| case.kernel() == kernel && case.float() == prec;
            let asked = cases.iter().zip(outcomes).filter(|(case, _)| is_of(case));
            let (asked, unsupported) = asked.fold((0, 0), |(asked, unsupported), (_, outcome)| {
                let not = usize::from(matches!(outcome, Outcome::Unsupported));
                (asked + 1, unsupported + not)
            });
            if asked == 0 {
                continue;
            }
            let mine: Vec<&Judged> = judged.iter().filter(|j| is_of(j.case)).collect();
            let passed = mine.iter().filter(|judged| !judged.fails).count();
            let measured = Measured::of(mine.iter().copied());
            rows.push(Row {
                kind: kernel.name(),
                prec,
                passed,
                failed: asked - unsupported - passed,
                unsupported,
                worst: worst(&mine),
                decisions: measured.decisions + measured.roots,
                key: (kernel, prec),
            });
        }
    }
    rows
}

/// The largest error of a number where nothing else is wrong.
fn worst(judged: &[&Judged]) -> Option<Worst> {
    let right = judged
        .iter()
        .filter(|judged| judged.verdict.wrong.is_none() && judged.verdict.ulps > 0.0);
    let worst = right.max_by(|a, b| a.verdict.ulps.total_cmp(&b.verdict.ulps))?;
    Some(Worst {
        id: worst.case.id().into(),
        ulps: worst.verdict.ulps,
    })
}
