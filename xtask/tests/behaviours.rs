//! What wrong kernels are known for, and how a trial of kernels of one's own reads.

#[path = "broken/wrong.rs"]
mod wrong;

use ombrage::Float;
use ombrage::conformance::{
    Answer, Behaviour, Case, Evidence, Kernel, Question, Trial, recognise, vectors,
};
use std::collections::BTreeSet;
use wrong::RIGHT;

/// The faults of `broken/wrong.rs` that a name is known for.
const FAULTS: [(&str, &str); 14] = [
    ("textbook", "TEXTBOOK_SPHERE"),
    ("unit", "UNIT_DIRECTION_ASSUMED"),
    ("distance", "UNIT_DIRECTION_ASSUMED"),
    ("ignores-t-max", "T_MAX_IGNORED"),
    ("ignores-t-min", "T_MIN_IGNORED"),
    ("t-min-of-its-own", "T_MIN_IGNORED"),
    ("half-open", "OPEN_INTERVAL"),
    ("open", "OPEN_INTERVAL"),
    ("culls", "PLANE_CULLED"),
    ("culls-the-front", "PLANE_CULLED"),
    ("misses-from-inside", "INSIDE_MISSED"),
    ("overflows", "OVERFLOW"),
    ("moves-by-a-constant", "OFFSET_CONSTANT"),
    ("moves-by-about-a-constant", "OFFSET_CONSTANT"),
];

fn cases() -> Vec<Case> {
    let of = |kernel| vectors(kernel).expect("valid");
    Kernel::ALL.into_iter().flat_map(of).collect()
}

/// Kernels with a fault, asked everything in one format.
fn trial<'a, F: Float>(cases: &'a [Case], fault: &str) -> Trial<'a> {
    Trial::of::<F>(cases, |question| {
        wrong::answer(fault, question).or_else(|| RIGHT.answer(question).ok())
    })
}

/// What is said of a fault: by what it is known, and of how many cases.
fn evidence<'a>(cases: &'a [Case], fault: &str) -> Vec<Evidence<'a>> {
    let mut judged = trial::<f32>(cases, fault).judged;
    judged.extend(trial::<f64>(cases, fault).judged);
    recognise(&judged)
}

/// Wrong in one way, and that is what is named, in both formats and of enough cases.
#[test]
fn a_fault_is_named_and_no_other() {
    let cases = cases();
    for (fault, code) in FAULTS {
        let evidence = evidence(&cases, fault);
        let codes: BTreeSet<&str> = evidence.iter().map(|of| of.behaviour.code()).collect();
        assert_eq!(codes, BTreeSet::from([code]), "{fault}");
        let floats: BTreeSet<&str> = evidence.iter().map(|of| of.float).collect();
        assert_eq!(floats, BTreeSet::from(["f32", "f64"]), "{fault}");
        for of in evidence {
            let enough = of.matched >= 3 && of.matched <= of.telling;
            assert!(enough, "{fault}: {of:?}");
            assert!(of.first.contains(of.float), "{fault}: {of:?}");
        }
    }
}

#[test]
fn nothing_is_named_of_kernels_that_are_right_or_wrong_in_no_known_way() {
    let cases = cases();
    for fault in ["none", "never-hits", "moves-in-proportion", "stays"] {
        assert!(evidence(&cases, fault).is_empty(), "{fault}");
    }
}

/// Kernels with a fault that shows in a part of what they are asked, the same in every run.
fn codes_of_part(cases: &[Case], fault: &str, part: f64) -> BTreeSet<&'static str> {
    let mut state = 1_u64;
    let trial = Trial::of::<f64>(cases, |question| {
        state = state
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1);
        let is_wrong = ((state >> 40) as f64) < part * f64::from(1 << 24);
        let answer = is_wrong.then(|| wrong::answer(fault, question)).flatten();
        answer.or_else(|| RIGHT.answer(question).ok())
    });
    let evidence = recognise(&trial.judged);
    evidence.iter().map(|of| of.behaviour.code()).collect()
}

/// A behaviour is named where most of the cases that tell it from the truth are answered so, and not
/// where a good part is not.
#[test]
fn what_shows_now_and_then_is_not_named() {
    let cases = cases();
    for (fault, code) in [
        ("ignores-t-max", "T_MAX_IGNORED"),
        ("half-open", "OPEN_INTERVAL"),
        ("culls", "PLANE_CULLED"),
        ("moves-by-a-constant", "OFFSET_CONSTANT"),
        ("overflows", "OVERFLOW"),
    ] {
        let named = codes_of_part(&cases, fault, 0.95);
        assert!(named.contains(code), "{fault}: {named:?}");
        let named = codes_of_part(&cases, fault, 0.4);
        assert!(!named.contains(code), "{fault}: {named:?}");
    }
}

/// What is said of a plane whose hits are these, from the right ones and those of faults.
fn codes_of_plane(
    faults: &[&str],
    hit: impl Fn(Option<f64>, &[Option<f64>]) -> Option<f64>,
) -> Vec<&'static str> {
    let cases = vectors(Kernel::RayPlane).expect("valid");
    let t = |answer: Option<Answer<f64>>| match answer {
        Some(Answer::Hit(t)) => t,
        _ => None,
    };
    let trial = Trial::of::<f64>(&cases, |question| {
        let right = t(RIGHT.answer(question).ok());
        let wrong: Vec<_> = faults
            .iter()
            .map(|fault| t(wrong::answer(fault, question)))
            .collect();
        Some(Answer::Hit(hit(right, &wrong)))
    });
    let named = recognise(&trial.judged);
    named.iter().map(|of| of.behaviour.code()).collect()
}

/// A fault of every hit shows in each kernel that looks for one.
#[test]
fn a_fault_is_named_for_each_kernel() {
    let cases = cases();
    let evidence = evidence(&cases, "ignores-t-max");
    let kernels: BTreeSet<&str> = evidence.iter().map(|of| of.kernel.name()).collect();
    assert_eq!(
        kernels,
        BTreeSet::from(["ray_plane", "ray_sphere", "any_hit"])
    );
}

/// Two faults of one kernel are both named.
#[test]
fn two_faults_are_named() {
    let mut named = codes_of_plane(&["culls", "ignores-t-max"], |right, wrong| {
        let is_culled = right.is_some() && wrong[0].is_none();
        if is_culled { None } else { wrong[1] }
    });
    named.sort_unstable();
    assert_eq!(named, ["PLANE_CULLED", "T_MAX_IGNORED"]);
}

/// Answers need not be exact to be known; but others than a behaviour gives do not speak for it.
#[test]
fn answers_speak_for_what_gives_them() {
    for (factor, named) in [(1.0005, vec!["T_MAX_IGNORED"]), (1.5, vec![])] {
        let of = codes_of_plane(&["ignores-t-max"], |right, wrong| {
            right.or(wrong[0].map(|t| t * factor))
        });
        assert_eq!(of, named, "{factor}");
    }
}

/// A constant that is wrong nowhere is not named.
#[test]
fn a_constant_may_be_right() {
    let cases = vectors(Kernel::Offset).expect("valid");
    let mut judged = trial::<f32>(&cases, "moves-by-a-constant").judged;
    judged.retain(|judged| judged.verdict.wrong.is_none());
    assert!(judged.len() > 9);
    let named = recognise(&judged);
    assert!(named.is_empty(), "{named:?}");
}

/// A sphere that is never hit is wrong in no certain way, however few are to be hit.
#[test]
fn what_is_never_hit_has_no_name() {
    let cases = vectors(Kernel::RaySphere).expect("valid");
    let is_hit = |case: &&Case| case.truth()["hit"]["closed"] == true;
    let (hits, misses): (Vec<_>, Vec<_>) = cases.iter().partition(is_hit);
    let hits = hits.into_iter().step_by(4);
    let few: Vec<Case> = misses.into_iter().chain(hits).cloned().collect();
    for judged in [
        trial::<f32>(&few, "never-hits"),
        trial::<f64>(&few, "never-hits"),
    ] {
        let named = recognise(&judged.judged);
        assert!(named.is_empty(), "{named:?}");
    }
}

/// How far origins move is seen near zero, however many others are so far off that nothing moves them.
#[test]
fn a_constant_is_measured_where_it_shows() {
    let cases = vectors(Kernel::Offset).expect("valid");
    let size = |case: &Case| match case.question::<f32>() {
        Ok(Question::Offset(asked)) => {
            let sizes = asked.point.to_array().map(f32::abs);
            sizes.into_iter().fold(0.0, f32::max)
        }
        _ => f32::NAN,
    };
    let far = cases.iter().filter(|case| size(case) > 1e5);
    let near = cases.iter().filter(|case| size(case) < 100.0).take(5);
    let few: Vec<Case> = far.chain(near).cloned().collect();
    assert!(few.len() > 10, "{}", few.len());
    let judged = trial::<f32>(&few, "moves-by-a-constant").judged;
    let named = recognise(&judged);
    assert_eq!(named.len(), 1, "{named:?}");
    assert_eq!(named[0].behaviour, Behaviour::OffsetConstant);
}

/// Each behaviour says something of its own to look for.
#[test]
fn every_behaviour_has_a_code_and_an_advice() {
    let advice: BTreeSet<&str> = Behaviour::ALL.map(Behaviour::advice).into();
    assert_eq!(advice.len(), Behaviour::ALL.len());
    for behaviour in Behaviour::ALL {
        assert!(behaviour.advice().len() > 20);
        assert_eq!(behaviour.to_string(), behaviour.code());
    }
}

/// A line for each case that fails, with its name and what is wrong; then the sum.
#[test]
fn a_trial_reads_case_by_case() {
    let cases = cases();
    let right = trial::<f32>(&cases, "none");
    let count = right.judged.len();
    assert_eq!(right.failed(), 0, "{right}");
    assert_eq!(
        right.to_string(),
        format!("0 of {count} fail, 0 unsupported")
    );
    let broken = trial::<f32>(&cases, "ignores-t-max");
    let text = broken.to_string();
    let (lines, sum) = text.rsplit_once('\n').expect("lines");
    let failed = broken.failed();
    assert!(failed > 3);
    assert_eq!(sum, format!("{failed} of {count} fail, 0 unsupported"));
    let failing: Vec<_> = broken.judged.iter().filter(|judged| judged.fails).collect();
    assert_eq!(lines.lines().count(), failing.len());
    for (line, judged) in lines.lines().zip(failing) {
        assert!(line.starts_with(judged.case.id()), "{line}");
        assert!(line.len() > judged.case.id().len() + 10, "{line}");
    }
    // What a kernel does not do is no fault.
    let nothing = Trial::of::<f64>(&cases, |_| None);
    assert_eq!((nothing.failed(), nothing.judged.len()), (0, 0));
    assert_eq!(nothing.unsupported.len() + count, cases.len());
}
