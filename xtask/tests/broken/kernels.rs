//! Kernels that are wrong in one way, as a program that speaks the kernel protocol: what
//! `tests/conform.rs` judges. `broken_kernels FAULT [FILE]`

mod wrong;

use ombrage::Float;
use ombrage::conformance::{Answer, Question, answer};
use serde_json::{Value, json};
use std::env;
use std::io::{self, BufRead, BufWriter, Write};
use std::process::{self, Command};
use std::thread;
use std::time::Duration;
use wrong::RIGHT;

fn main() -> io::Result<()> {
    let mut arguments = env::args().skip(1);
    let fault = arguments.next().unwrap_or_default();
    match fault.as_str() {
        "never-reads" => sleep(),
        "crashes-at-once" => process::abort(),
        "floods-stderr" => {
            let noise = [b'!'; 1 << 16];
            for _ in 0..1000 {
                io::stderr().write_all(&noise)?;
            }
        }
        "leaves-a-child" => {
            let child = Command::new(env::current_exe()?)
                .arg("never-reads")
                .spawn()?;
            std::fs::write(arguments.next().unwrap_or_default(), child.id().to_string())?;
        }
        _ => {}
    }
    let mut output: Box<dyn Write> = match fault.as_str() {
        "never-flushes" | "never-flushes-and-crashes" => {
            Box::new(BufWriter::with_capacity(1 << 14, io::stdout()))
        }
        _ => Box::new(io::stdout()),
    };
    let mut held = None;
    for (number, line) in io::stdin().lock().lines().enumerate() {
        let request: Value = serde_json::from_str(&line?)?;
        let id = request["id"].as_str().unwrap_or_default();
        let is_unlucky = id.ends_with(".0003");
        let reply = json!({ "id": id, "out": out(&fault, &request) });
        match fault.as_str() {
            "crashes" | "never-flushes-and-crashes" if is_unlucky => process::abort(),
            "hangs" if id.ends_with("generic.f32.0003") => sleep(),
            "ends-early" if number == 100 => return Ok(()),
            "says-hello" if number == 0 => writeln!(output, "ready")?,
            "floods" if is_unlucky => loop {
                output.write_all(&[b'x'; 1 << 16])?;
            },
            "floods-lines" if is_unlucky => loop {
                output.write_all(&b"{}\n".repeat(1 << 12))?;
            },
            "answers-twice" if is_unlucky => writeln!(output, "{reply}")?,
            "swaps" => {
                match held.take() {
                    None => held = Some(reply),
                    Some(first) => writeln!(output, "{reply}\n{first}")?,
                }
                continue;
            }
            "answers-others" if is_unlucky => writeln!(output, r#"{{"id":"me","out":{{}}}}"#)?,
            _ => {}
        }
        writeln!(output, "{reply}")?;
    }
    if let Some(last) = held {
        writeln!(output, "{last}")?;
    }
    output.flush()
}

fn sleep() -> ! {
    loop {
        thread::sleep(Duration::from_secs(60));
    }
}

fn out(fault: &str, request: &Value) -> Value {
    let out = match request["prec"].as_str() {
        Some("f32") => answered::<f32>(fault, request),
        _ => answered::<f64>(fault, request),
    };
    match (fault, out) {
        ("answers-text", _) => json!("hit"),
        (_, Some(out)) => out,
        (_, None) => answer(&RIGHT, request).unwrap_or_default()["out"].clone(),
    }
}

/// The wrong answer's `out`; `None` for the right one.
fn answered<F: Float>(fault: &str, request: &Value) -> Option<Value> {
    let question = Question::<F>::of(request).ok()?;
    wrong::answer(fault, &question).map(|answer: Answer<F>| answer.out())
}
