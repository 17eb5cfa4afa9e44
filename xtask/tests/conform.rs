//! `cargo xtask conform` on kernels that are right, on kernels that are wrong in one known way, and
//! on programs that do not behave.

use ombrage::Quality;
use ombrage::conformance::{Behaviour, Kernel, known_failures, vectors};
use serde_json::Value;
use std::collections::BTreeSet;
use std::env;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::thread;
use std::time::{Duration, Instant};

const BROKEN: &str = env!("CARGO_BIN_EXE_broken_kernels");
const XTASK: &str = env!("CARGO_BIN_EXE_xtask");

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

fn run(options: &[&str], program: &[&str]) -> Output {
    let mut command = Command::new(XTASK);
    command.arg("conform").args(options).arg("--").args(program);
    command.current_dir(root()).output().expect("it starts")
}

/// The report as JSON, and the exit status.
fn report(options: &[&str], program: &[&str]) -> (Value, i32) {
    let output = run(&[options, &["--json"]].concat(), program);
    let text = String::from_utf8_lossy(&output.stdout);
    let report = serde_json::from_str(&text);
    let error = || format!("{text}{}", String::from_utf8_lossy(&output.stderr));
    let code = output.status.code().expect("an exit status");
    (report.unwrap_or_else(|_| panic!("{}", error())), code)
}

fn behaviours(report: &Value) -> Vec<&str> {
    let codes = report["behaviours"].as_array().expect("an array").iter();
    codes.map(|code| code.as_str().expect("a code")).collect()
}

/// The sum of a column over all kinds.
fn sum(report: &Value, column: &str) -> u64 {
    let kinds = report["kinds"].as_array().expect("an array").iter();
    kinds
        .map(|row| row[column].as_u64().expect("a count"))
        .sum()
}

#[test]
fn right_kernels_conform() {
    let (report, code) = report(&[], &[BROKEN, "none"]);
    assert_eq!((report["verdict"].as_str(), code), (Some("conforms"), 0));
    let keys: Vec<&str> = report
        .as_object()
        .expect("an object")
        .keys()
        .map(String::as_str)
        .collect();
    let keys: BTreeSet<&str> = keys.into_iter().collect();
    assert_eq!(
        keys,
        BTreeSet::from(["behaviours", "findings", "kinds", "verdict"])
    );
    let row = &report["kinds"][0];
    let keys: BTreeSet<&str> = row
        .as_object()
        .expect("an object")
        .keys()
        .map(String::as_str)
        .collect();
    let expected = ["failed", "kind", "passed", "prec", "unsupported", "worst"];
    assert_eq!(keys, BTreeSet::from(expected));
    assert_eq!(
        (&row["kind"], &row["prec"]),
        (&"ray_plane".into(), &"f32".into())
    );
    assert_eq!(sum(&report, "passed"), 4178);
    assert_eq!(report["findings"], Value::Array(vec![]));
}

/// One fault of each group as a program; `behaviours.rs` has all of them.
#[test]
fn a_fault_is_named_and_no_other() {
    for (fault, code) in [
        ("open", "OPEN_INTERVAL"),
        ("unit", "UNIT_DIRECTION_ASSUMED"),
    ] {
        let (report, status) = report(&[], &[BROKEN, fault]);
        assert_eq!(behaviours(&report), [code], "{fault}");
        assert_eq!(
            (report["verdict"].as_str(), status),
            (Some("faults"), 1),
            "{fault}"
        );
        let finding = &report["findings"][0];
        assert_eq!(finding["code"], code, "{fault}");
        assert!(finding["cases"].as_u64() >= Some(3), "{finding}");
    }
}

/// Hits nothing: no way to miss is recognised, and everything is wrong.
#[test]
fn what_is_wrong_everywhere_has_no_name() {
    let (report, code) = report(&[], &[BROKEN, "never-hits"]);
    assert_eq!((behaviours(&report), code), (vec![], 1));
    assert!(sum(&report, "failed") > 700);
}

/// One that does not behave costs the cases at which it does not, and no others.
#[test]
fn programs_that_do_not_behave_are_survived() {
    let unlucky = |kernel| {
        let cases: Vec<_> = vectors(kernel).expect("valid");
        let cases = cases.iter().filter(|case| case.id().ends_with(".0003"));
        cases.count() as u64
    };
    let three = unlucky(Kernel::LightSample);
    let all = vectors(Kernel::LightSample).expect("valid").len() as u64;
    assert!(three > 20 && all > 200);
    let programs = [
        ("crashes", "CRASHED", three),
        ("never-flushes-and-crashes", "CRASHED", three),
        ("crashes-at-once", "CRASHED", all),
        ("ends-early", "CRASHED", 0),
        ("never-reads", "HUNG", all),
        ("hangs", "HUNG", 1),
        ("floods", "GARBLED", three),
        ("floods-lines", "GARBLED", three),
        ("says-hello", "GARBLED", 0),
        ("answers-twice", "GARBLED", 0),
        ("answers-others", "GARBLED", 0),
        ("answers-text", "GARBLED", all),
        ("swaps", "GARBLED", 0),
    ];
    for (fault, code, failed) in programs {
        let options = ["--kind", "light_sample", "--timeout", "1"];
        let (report, status) = report(&options, &[BROKEN, fault]);
        assert_eq!((behaviours(&report), status), (vec![code], 1), "{fault}");
        assert_eq!(sum(&report, "failed"), failed, "{fault}");
        assert_eq!(sum(&report, "passed"), all - failed, "{fault}");
    }
}

#[test]
fn noise_and_haste_are_no_fault() {
    for habit in ["floods-stderr", "never-flushes"] {
        let (report, code) = report(&["--kind", "light_sample"], &[BROKEN, habit]);
        assert_eq!(
            (report["verdict"].as_str(), code),
            (Some("conforms"), 0),
            "{habit}"
        );
    }
}

#[test]
#[cfg(target_os = "linux")]
fn nothing_is_left_running() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("child");
    let program = [BROKEN, "leaves-a-child", file.to_str().expect("a name")];
    let (report, code) = report(&["--kind", "offset"], &program);
    assert_eq!((behaviours(&report), code), (vec![], 0));
    let id = fs::read_to_string(&file).expect("the child's id");
    let runs = || {
        let status = fs::read_to_string(format!("/proc/{id}/stat")).unwrap_or_default();
        !status.is_empty() && !status.contains(") Z ")
    };
    let start = Instant::now();
    while runs() {
        assert!(
            start.elapsed() < Duration::from_secs(5),
            "process {id} runs"
        );
        thread::sleep(Duration::from_millis(10));
    }
}

/// The rows of the first table of docs/precision.md.
fn documented() -> Vec<Vec<String>> {
    let text = fs::read_to_string(root().join("docs/precision.md")).expect("the document");
    let rows = text.lines().filter(|line| line.starts_with("| "));
    let cells = |row: &str| row.split('|').map(|cell| cell.trim().to_owned()).collect();
    let is_error = |row: &Vec<String>| row.len() == 12 && (row[3] == "f32" || row[3] == "f64");
    rows.map(cells).filter(is_error).collect()
}

/// What `conform` measures of the kit's own kernels is what docs/precision.md says of them: how many
/// decisions are wrong, the largest error and which families fail.
#[test]
fn the_kits_own_kernels_are_as_documented() {
    let documented = documented();
    assert_eq!(documented.len(), 30);
    let mut behaved = vec![];
    for quality in Quality::ALL {
        let name = quality.name();
        let program = [XTASK, "kernels", "--quality", name];
        let (report, _) = report(&["--quality", name], &program);
        behaved.push(behaviours(&report).join(" "));
        for row in report["kinds"].as_array().expect("an array") {
            let [kind, prec] = ["kind", "prec"].map(|key| row[key].as_str().expect("text"));
            let kernel = Kernel::named(kind).expect("a kind");
            let quality_column = if kernel.has_qualities() { name } else { "all" };
            let line = documented
                .iter()
                .find(|line| line[1] == kind && line[2] == quality_column && line[3] == prec)
                .unwrap_or_else(|| panic!("{kind} {name} {prec} is not documented"));
            let number = |column: usize| line[column].parse::<u64>().expect("a count");
            let findings = report["findings"].as_array().expect("an array").iter();
            let of_kind = findings.filter(|f| f["kind"] == kind && f["prec"] == prec);
            let failed: BTreeSet<&str> = of_kind
                .filter(|finding| finding["code"] == "FAILED")
                .filter_map(|finding| finding["family"].as_str())
                .collect();
            let known: BTreeSet<&str> = known_failures(kernel, quality, prec)
                .map(|(family, _)| family)
                .collect();
            assert_eq!(failed, known, "{kind} {name} {prec}");
            assert_eq!(failed.len() as u64, number(9), "{kind} {name} {prec}");
            let [passed, failed] = ["passed", "failed"].map(|key| row[key].as_u64());
            assert_eq!(
                passed.zip(failed).map(|(p, f)| p + f),
                Some(number(6)),
                "{kind}"
            );
            if let (Some(ulps), true) = (line[5].strip_suffix(" ulp"), known.is_empty()) {
                let worst = format!("{:.3}", row["worst"]["ulps"].as_f64().expect("an error"));
                assert_eq!(worst, ulps, "{kind} {name} {prec}");
            }
        }
        let text = run(&["--quality", name], &program).stdout;
        let text = String::from_utf8_lossy(&text).into_owned();
        for line in documented.iter().filter(|line| line[2] == name) {
            let mut rows = text
                .lines()
                .map(|row| row.split_whitespace().collect::<Vec<_>>());
            let row = rows.find(|row| row.len() > 6 && row[..2] == [&line[1], &line[3]]);
            let wrong = line[7].parse::<u64>().unwrap() + line[8].parse::<u64>().unwrap();
            assert_eq!(row.expect("a row")[5], wrong.to_string(), "{line:?}");
        }
    }
    assert_eq!(behaved, ["TEXTBOOK_SPHERE OVERFLOW", "OVERFLOW", ""]);
}

#[test]
fn the_options_choose_cases() {
    let count = |options: &[&str]| sum(&report(options, &[BROKEN, "none"]).0, "passed");
    assert_eq!(count(&["--kind", "offset", "--prec", "f64"]), 147);
    assert_eq!(
        count(&["--pattern", "grazing_axis_1e-3", "--kind", "ray_plane"]),
        10
    );
    assert_eq!(count(&["--number", "ray_sphere.generic.f32.0001"]), 1);
}

#[test]
fn bad_input_is_told() {
    let bad: [(&[&str], &[&str], &str); 9] = [
        (&[], &["./no-such-program"], "cannot run ./no-such-program"),
        (&[], &["docs/protocol.md"], "cannot run docs/protocol.md"),
        (&[], &["docs"], "cannot run docs"),
        (&[], &[], "PROGRAM"),
        (&["--kind", "cube"], &[BROKEN], "ray_plane, ray_sphere"),
        (&["--prec", "f16"], &[BROKEN], "f32, f64"),
        (&["--pattern", "zebra"], &[BROKEN], "--pattern zebra"),
        (&["--number", "7"], &[BROKEN], "--number 7"),
        (&["--timeout", "0"], &[BROKEN], "seconds from 0.001"),
    ];
    for (options, program, message) in bad {
        let output = run(options, program);
        let error = String::from_utf8_lossy(&output.stderr);
        assert_eq!(
            output.status.code(),
            Some(2),
            "{options:?} {program:?} {error}"
        );
        assert!(
            error.starts_with("error: ") && error.contains(message),
            "{error}"
        );
        assert_eq!(error.lines().count(), 1, "{error}");
    }
}

/// The documented programs are right, if there is something to run them with.
#[test]
fn the_python_adapter_conforms() {
    if Command::new("python3").arg("--version").output().is_err() {
        eprintln!("skipped: there is no python3");
        return;
    }
    let options = ["--kind", "ray_plane"];
    let (report, _) = report(&options, &["python3", "docs/adapters/ray.py"]);
    let rows = &report["kinds"];
    assert_eq!(
        (&rows[0]["unsupported"], &rows[0]["failed"]),
        (&353.into(), &0.into())
    );
    assert_eq!(
        (&rows[1]["passed"], &rows[1]["failed"]),
        (&338.into(), &15.into())
    );
    assert_eq!(behaviours(&report), [Behaviour::Overflow.code()]);
}

#[test]
fn the_cpp_adapter_conforms() {
    let folder = tempfile::tempdir().expect("a folder");
    let program = folder.path().join("ray");
    let compiler = env::var("CXX").unwrap_or("c++".into());
    let mut compile = Command::new(compiler);
    compile.args(["-std=c++20", "-O2", "-ffp-contract=off"]);
    compile.arg(root().join("docs/adapters/ray.cpp"));
    let Ok(output) = compile.arg("-o").arg(&program).output() else {
        eprintln!("skipped: there is no C++ compiler");
        return;
    };
    assert!(output.status.success(), "{output:?}");
    let program = program.to_str().expect("a name");
    let (report, _) = report(&["--kind", "ray_sphere"], &[program]);
    let rows = &report["kinds"];
    assert_eq!(
        (&rows[0]["passed"], &rows[0]["failed"]),
        (&343.into(), &22.into())
    );
    assert_eq!(
        (&rows[1]["unsupported"], &rows[1]["failed"]),
        (&365.into(), &0.into())
    );
    assert_eq!(behaviours(&report), [Behaviour::Overflow.code()]);
}
