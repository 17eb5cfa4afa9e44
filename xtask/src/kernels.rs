//! `cargo xtask kernels`: the kit's kernels as a program that speaks the kernel protocol.

use crate::error::{Error, Result};
use crate::lines::read_line;
use ombrage::conformance::{Kernels, answer};
use ombrage::{Quality, Shadow};
use serde_json::{Value, json};
use std::io::{self, BufRead, ErrorKind, Write};
use std::process::ExitCode;

/// Answer requests of the kernel protocol: one JSON object a line, from standard input to standard
/// output
///
/// A line that is no request gets {"line": N, "error": "..."} in its place, and the program goes
/// on. docs/protocol.md describes requests and answers.
#[derive(clap::Args)]
#[command(after_help = "\
Examples:
  cargo xtask kernels < tests/vectors/ray_sphere.jsonl
  cargo xtask kernels --quality textbook < tests/vectors/light_sample.jsonl
  cargo xtask kernels --shadow ulp-offset < tests/vectors/shade.jsonl

Exit status: 0 every line is answered; 2 a line was no request, or bad usage.")]
pub struct Args {
    /// How well to compute rays and light samples: textbook, stable or wide
    #[arg(long, value_name = "NAME", default_value = Quality::default().name(), value_parser = quality)]
    quality: Quality,

    /// Shade by the lab's shadow rays, which leave their surface in this way; without it, by sides
    #[arg(long, value_name = "NAME", value_parser = shadow)]
    shadow: Option<Shadow>,
}

fn quality(name: &str) -> std::result::Result<Quality, String> {
    let names = Quality::ALL.map(Quality::name).join(", ");
    Quality::named(name).ok_or_else(|| format!("choose one of {names}"))
}

fn shadow(name: &str) -> std::result::Result<Shadow, String> {
    let names = Shadow::ALL.map(Shadow::name).join(", ");
    Shadow::named(name).ok_or_else(|| format!("choose one of {names}"))
}

/// Bytes of the longest line that is read as a request: 16 MiB.
const LONGEST: usize = 1 << 24;

/// Runs the command.
///
/// # Errors
/// If standard input cannot be read or standard output not be written to.
pub fn run(args: &Args) -> Result<ExitCode> {
    let kernels = Kernels {
        quality: args.quality,
        shadow: args.shadow,
    };
    match serve(&kernels, io::stdin().lock(), io::stdout().lock()) {
        Ok(true) => Ok(ExitCode::SUCCESS),
        Ok(false) => Ok(ExitCode::from(2)),
        // A reader who has left, such as `head`, is no error.
        Err(error) if error.kind() == ErrorKind::BrokenPipe => Ok(ExitCode::SUCCESS),
        Err(error) => Err(Error::new(format!(
            "cannot go on reading requests and writing answers: {error}; send them through other files"
        ))),
    }
}

/// Answers every line in its place; whether each was a request.
///
/// # Errors
/// If a line cannot be read or an answer not be written.
pub fn serve(
    kernels: &Kernels,
    mut input: impl BufRead,
    mut output: impl Write,
) -> io::Result<bool> {
    let mut all = true;
    let mut line = vec![];
    for number in 1u64.. {
        let Some(length) = read_line(&mut input, &mut line, LONGEST, usize::MAX)? else {
            break;
        };
        let answer = reply(kernels, &line, length).unwrap_or_else(|error| {
            all = false;
            json!({ "line": number, "error": error })
        });
        writeln!(output, "{answer}")?;
        output.flush()?;
    }
    Ok(all)
}

fn reply(kernels: &Kernels, line: &[u8], length: usize) -> std::result::Result<Value, String> {
    if length > LONGEST {
        return Err(format!("the line has {length} bytes, more than {LONGEST}"));
    }
    let text = str::from_utf8(line).map_err(|error| format!("the line is not UTF-8: {error}"))?;
    let request: Value =
        serde_json::from_str(text).map_err(|error| format!("the line is not JSON: {error}"))?;
    answer(kernels, &request)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn answers(input: &[u8]) -> (bool, Vec<Value>) {
        let mut output = vec![];
        let all = serve(&Kernels::default(), input, &mut output).unwrap();
        let text = String::from_utf8(output).unwrap();
        let parse = |line| serde_json::from_str(line).unwrap();
        (all, text.lines().map(parse).collect())
    }

    const GOOD: &str =
        r#"{"id":"a","kind":"quantise","prec":"f32","in":{"x":"3f800000"},"more":1}"#;

    #[test]
    fn a_bad_line_is_answered_in_its_place() {
        let deep = "[".repeat(100_000);
        let bad = [
            "",
            "zebra",
            "[]",
            "{}",
            &deep,
            r#"{"id":1,"kind":"quantise","prec":"f32","in":{"x":"3f800000"}}"#,
            r#"{"id":"a","kind":"zebra","prec":"f32","in":{}}"#,
            r#"{"id":"a","kind":"quantise","prec":"f16","in":{}}"#,
            r#"{"id":"a","kind":"quantise","prec":"f32","in":[]}"#,
            r#"{"id":"a","kind":"quantise","prec":"f32","in":{}}"#,
            r#"{"id":"a","kind":"quantise","prec":"f32","in":{"x":"3f80000"}}"#,
            r#"{"id":"a","kind":"quantise","prec":"f64","in":{"x":"3f800000"}}"#,
            r#"{"id":"a","kind":"quantise","prec":"f32","in":{"x":"+f800000"}}"#,
            r#"{"id":"a","kind":"any_hit","prec":"f32","in":{"objs":3}}"#,
        ];
        for line in bad {
            let (all, answers) = answers(format!("{GOOD}\n{line}\n{GOOD}").as_bytes());
            assert!(!all && answers.len() == 3, "{line}");
            assert_eq!(answers[1]["line"], 2, "{line}");
            assert!(answers[1]["error"].is_string(), "{line}");
            assert_eq!(answers[2], json!({ "id": "a", "out": { "byte": 255 } }));
        }
    }

    #[test]
    fn neither_bytes_nor_length_break_it() {
        let mut input = b"\xff\xfe\n".to_vec();
        input.extend(vec![b'7'; LONGEST + 1]);
        input.extend(format!("\n{GOOD}\n").bytes());
        let (all, answers) = answers(&input);
        assert!(!all);
        assert_eq!(
            answers[0]["error"].as_str().unwrap().split(':').next(),
            Some("the line is not UTF-8")
        );
        assert_eq!(
            answers[1]["error"],
            "the line has 16777217 bytes, more than 16777216"
        );
        assert_eq!(answers[2]["out"]["byte"], 255);
    }

    #[test]
    fn every_good_line_is_answered() {
        assert!(answers(GOOD.as_bytes()).0);
        assert_eq!(answers(b""), (true, vec![]));
    }
}
