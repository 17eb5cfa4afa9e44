//! A diagnosis as text, as a table and as JSON.

use super::Judged;
use super::read::Submission;
use crate::error::{Error, Result};
use crate::table::{Table, grouped};
use ombrage::conformance::diagnosis::{Code, Diagnosis, Estimate, Finding, Rounding, Verdict};
use serde::Serialize;
use serde_json::{Map, Value, json};
use std::fmt::Write;
use std::path::Path;

/// What `--json` prints of a picture.
#[derive(Serialize)]
pub struct Report {
    file: String,
    verdict: &'static str,
    figure: &'static str,
    conventions: Value,
    findings: Vec<Value>,
    shown: Vec<&'static str>,
    not_shown: Vec<&'static str>,
    not_visible: Vec<&'static str>,
    error: f64,
    margin: f64,
    runner_up: Vec<&'static str>,
    remarks: Vec<&'static str>,
}

impl Report {
    /// The report on a picture.
    pub fn new(path: &Path, submission: &Submission, diagnosis: &Diagnosis) -> Self {
        let thousandths = |x: f64| (x * 1000.0).round() / 1000.0;
        Self {
            file: path.display().to_string(),
            verdict: diagnosis.verdict.name(),
            figure: diagnosis.figure,
            conventions: conventions(submission, diagnosis),
            findings: diagnosis.findings.iter().map(finding).collect(),
            shown: diagnosis.shown.clone(),
            not_shown: diagnosis.not_shown.clone(),
            not_visible: diagnosis.invisible.iter().map(|code| code.name()).collect(),
            error: thousandths(diagnosis.margin.error),
            margin: thousandths(diagnosis.margin.share()),
            runner_up: names(&diagnosis.margin.runner_up),
            remarks: submission.remarks.clone(),
        }
    }
}

fn names(codes: &[Code]) -> Vec<&'static str> {
    codes.iter().map(|code| code.name()).collect()
}

fn rounding(rounding: Rounding) -> &'static str {
    match rounding {
        Rounding::Truncate => "truncated",
        Rounding::Nearest => "rounded",
    }
}

fn conventions(submission: &Submission, diagnosis: &Diagnosis) -> Value {
    let conventions = &diagnosis.conventions;
    let t_max = conventions.t_max.map(|t_max| match t_max.is_finite() {
        true => json!(t_max),
        false => json!("none"),
    });
    let jpeg = submission
        .loss
        .as_ref()
        .map(|loss| json!({ "quality": loss.quality(), "subsampling": loss.subsampling() }));
    json!({
        "sampling": conventions.sampling.name(),
        "rounding": rounding(conventions.rounding),
        "t_max": t_max,
        "format": submission.format,
        "jpeg": jpeg,
    })
}

fn finding(finding: &Finding) -> Value {
    let mut fields = Map::new();
    let bbox = finding
        .region
        .map(|r| json!([r.left, r.top, r.width, r.height]));
    fields.insert("code".into(), json!(finding.code.name()));
    fields.insert("severity".into(), json!(finding.severity().name()));
    fields.insert("pixels".into(), json!(finding.pixels));
    fields.insert("bbox".into(), json!(bbox));
    fields.insert("clause".into(), json!(finding.clause()));
    fields.insert("message".into(), json!(finding.message));
    if let Some(or) = finding.or {
        fields.insert("or".into(), json!(or.name()));
    }
    for (name, estimate) in &finding.estimates {
        let value = match estimate {
            Estimate::Number(x) => json!(x),
            Estimate::Numbers(numbers) => json!(numbers),
            Estimate::Name(name) => json!(name),
        };
        fields.insert((*name).into(), value);
    }
    Value::Object(fields)
}

/// The reports on many pictures.
pub fn all(judged: &[Judged]) -> Vec<Value> {
    let report = |judged: &Judged| match &judged.outcome {
        Ok((submission, diagnosis)) => json!(Report::new(&judged.path, submission, diagnosis)),
        Err(error) => {
            json!({ "file": judged.path.display().to_string(), "error": error.to_string() })
        }
    };
    judged.iter().map(report).collect()
}

/// A value as JSON text.
///
/// # Errors
/// If it has no JSON form.
pub fn json(value: &impl Serialize) -> Result<String> {
    let text = serde_json::to_string_pretty(value)
        .map_err(|error| Error::new(format!("cannot write the report as JSON: {error}")))?;
    Ok(text + "\n")
}

/// A line for each picture.
pub fn table(judged: &[Judged]) -> String {
    let mut table = Table::new(&["picture", "verdict", "findings", "margin"]);
    for judged in judged {
        let name = judged.path.file_name().unwrap_or_default();
        let mut row = vec![name.to_string_lossy().into_owned()];
        match &judged.outcome {
            Err(error) => row.extend(["error".to_owned(), error.to_string(), String::new()]),
            Ok((_, diagnosis)) => {
                let codes: Vec<_> = diagnosis.findings.iter().map(|f| f.code.name()).collect();
                row.extend([
                    diagnosis.verdict.name().to_owned(),
                    codes.join(" "),
                    format!("{:.2}", diagnosis.margin.share()),
                ]);
            }
        }
        table.row(row);
    }
    table.render()
}

/// What a person reads of a picture.
pub fn text(submission: &Submission, diagnosis: &Diagnosis) -> String {
    let mut text = headline(diagnosis);
    text += "\n";
    for remark in &submission.remarks {
        text += &format!("remark: {remark}\n");
    }
    if diagnosis.verdict == Verdict::Unknown {
        return text;
    }
    for finding in &diagnosis.findings {
        let place = finding.region.map_or(String::new(), |r| {
            format!(", {}x{} from ({}, {})", r.width, r.height, r.left, r.top)
        });
        let or = finding
            .or
            .map_or(String::new(), |or| format!(" or {}", or.name()));
        let _ = writeln!(
            text,
            "\n{}{or}  {}, clause {}: {} pixels{place}\n  {}",
            finding.code.name(),
            finding.severity().name(),
            finding.clause(),
            grouped(finding.pixels as u64),
            finding.message,
        );
    }
    let _ = write!(text, "\nconventions  {}\n", in_words(submission, diagnosis));
    if !diagnosis.shown.is_empty() {
        let _ = writeln!(text, "shown        {}", diagnosis.shown.join(" "));
        let _ = writeln!(text, "not shown    {}", diagnosis.not_shown.join(" "));
        let hidden = names(&diagnosis.invisible).join(" ");
        let _ = writeln!(text, "no trace of  {hidden}");
    }
    let margin = &diagnosis.margin;
    let next = match names(&margin.runner_up).join(" + ") {
        none if none.is_empty() => "no fault".to_owned(),
        some => some,
    };
    let _ = writeln!(
        text,
        "error        {:.3} levels a pixel; next best: {next}, {:.3}; margin {:.2}",
        margin.error,
        margin.runner_up_error,
        margin.share()
    );
    text
}

/// The verdict in a sentence.
pub fn headline(diagnosis: &Diagnosis) -> String {
    let figure = diagnosis.figure;
    match diagnosis.verdict {
        Verdict::Conforms => format!("conforms: this is Figure {figure}"),
        Verdict::Faults => {
            let codes: Vec<_> = diagnosis.findings.iter().map(|f| f.code.name()).collect();
            format!("faults: this is not Figure {figure}: {}", codes.join(", "))
        }
        Verdict::Unknown => format!("unknown: no fault known here makes this of Figure {figure}"),
    }
}

/// The conventions in a line.
pub fn in_words(submission: &Submission, diagnosis: &Diagnosis) -> String {
    let conventions = &diagnosis.conventions;
    let t_max = match conventions.t_max {
        None => "any t_max".to_owned(),
        Some(t_max) if t_max.is_finite() => format!("t_max {t_max}"),
        Some(_) => "no t_max".to_owned(),
    };
    let format = match &submission.loss {
        None => submission.format.to_owned(),
        Some(loss) => format!("JPEG {} {}", loss.quality(), loss.subsampling()),
    };
    let sampling = conventions.sampling.name();
    let rounding = rounding(conventions.rounding);
    format!("{sampling}, bytes {rounding}, {t_max}, {format}")
}
