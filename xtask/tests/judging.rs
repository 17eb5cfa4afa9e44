//! What a verdict on an answer says, and how verdicts add up.

use ombrage::conformance::{
    Allowed, Answer, Judged, Kernel, Measured, Question, Trial, Verdict, Wrong, precision, vectors,
};
use ombrage::{Float, Quality};
use serde_json::{Value, json};

fn verdict(wrong: Option<Wrong>, ulps: f64, bounds: Option<f64>) -> Verdict {
    Verdict {
        wrong,
        ulps,
        bounds,
    }
}

/// As much as is allowed does not fail; anything more does.
#[test]
fn an_answer_fails_beyond_what_is_allowed() {
    let cases = vectors(Kernel::RayPlane).expect("valid");
    let case = cases
        .iter()
        .find(|case| case.family() == "generic")
        .expect("a case");
    let fails = |allowed, wrong, ulps, bounds| case.fails(&verdict(wrong, ulps, bounds), allowed);
    for (allowed, most, more) in [
        (Allowed::CorrectlyRounded, 0.5, 0.501),
        (Allowed::Ulp(2), 2.0, 2.001),
    ] {
        assert!(!fails(allowed, None, most, None) && fails(allowed, None, more, None));
    }
    let bound = Allowed::Bound(3);
    assert!(!fails(bound, None, 99.0, Some(3.0)) && fails(bound, None, 0.0, Some(3.001)));
    assert!(!fails(bound, None, 99.0, None));
    assert!(!fails(Allowed::Exact, None, 0.0, None));
    let bytes = Allowed::Bytes(1);
    let byte = |off| Some(Wrong::Byte(off));
    assert!(!fails(bytes, byte(1), 0.0, None) && fails(bytes, byte(2), 0.0, None));
    for wrong in [
        Wrong::Decision,
        Wrong::Root,
        Wrong::Side,
        Wrong::Far,
        Wrong::Malformed,
    ] {
        for allowed in [Allowed::Exact, Allowed::Ulp(9), bound] {
            assert!(
                fails(allowed, Some(wrong), 0.0, None),
                "{wrong:?} in {allowed}"
            );
        }
        assert!(wrong.to_string().len() > 10, "{wrong}");
    }
}

/// Where an error of a few bounds may change a decision, it is excused by who allows such errors, for
/// any hit as for the nearest; and by nobody else.
#[test]
fn decisions_at_a_margin_are_excused() {
    let wrong = verdict(Some(Wrong::Decision), 0.0, None);
    for kernel in [Kernel::RayPlane, Kernel::RaySphere, Kernel::AnyHit] {
        let cases = vectors(kernel).expect("valid");
        let (excused, others): (Vec<_>, Vec<_>) = cases
            .iter()
            .partition(|case| !case.fails(&wrong, Allowed::Bound(1)));
        assert!(excused.len() > 9 && others.len() > 9, "{kernel:?}");
        for case in excused {
            assert!(case.fails(&wrong, Allowed::Exact), "{}", case.id());
        }
    }
}

/// Each answer counts once, as what it is; the largest error is kept.
#[test]
fn verdicts_add_up() {
    let cases = vectors(Kernel::RaySphere).expect("valid");
    let verdicts = [
        verdict(None, 1.6, Some(0.5)),
        verdict(None, 0.2, Some(2.2)),
        verdict(Some(Wrong::Decision), 77.0, None),
        verdict(Some(Wrong::Decision), 0.0, None),
        verdict(Some(Wrong::Root), 0.0, Some(99.0)),
        verdict(Some(Wrong::Root), 0.0, None),
        verdict(Some(Wrong::Far), 0.0, None),
        verdict(Some(Wrong::Malformed), 0.0, None),
    ];
    let judged: Vec<Judged> = verdicts
        .into_iter()
        .zip(&cases)
        .map(|(verdict, case)| Judged {
            case,
            out: Value::Null,
            fails: verdict.wrong.is_some(),
            verdict,
        })
        .collect();
    let sum = Measured::of(&judged);
    assert_eq!((sum.cases, sum.failing), (8, 6));
    assert_eq!((sum.decisions, sum.roots, sum.others), (2, 2, 2));
    assert_eq!((sum.ulps, sum.bounds), (1.6, 2.2));
    // Whole units, never none at all, and only where they are fewer than allowed.
    assert_eq!(sum.could_be(Allowed::Ulp(3)), Some(Allowed::Ulp(2)));
    assert_eq!(sum.could_be(Allowed::Ulp(2)), None);
    assert_eq!(sum.could_be(Allowed::Bound(4)), Some(Allowed::Bound(3)));
    assert_eq!(sum.could_be(Allowed::Bound(3)), None);
    assert_eq!(
        Measured::default().could_be(Allowed::Ulp(2)),
        Some(Allowed::Ulp(1))
    );
    for whole in [Allowed::Exact, Allowed::CorrectlyRounded, Allowed::Bytes(9)] {
        assert_eq!(sum.could_be(whole), None);
    }
}

/// Bits are read, null is no hit, and what is malformed is named and cut short.
#[test]
fn answers_are_read_or_refused() {
    let t = |value: Value| Answer::<f64>::of(Kernel::RaySphere, &json!({ "t": value }));
    let hit = |answer| match answer {
        Ok(Answer::Hit(t)) => t,
        other => panic!("{other:?}"),
    };
    assert_eq!(hit(t(Value::Null)), None);
    assert_eq!(hit(t(json!(1.5f64.hex()))), Some(1.5));
    for bad in [
        json!(1.5),
        json!("zebra"),
        json!([1]),
        json!(true),
        json!("x".repeat(500)),
    ] {
        let error = t(bad.clone()).expect_err("malformed");
        assert!(
            error.contains("\"t\" is ") && error.contains("expected"),
            "{error}"
        );
        let told = bad.to_string();
        let is_whole = error.contains(&told);
        assert_eq!(is_whole, told.chars().count() <= 60, "{error}");
        assert_eq!(error.contains('…'), !is_whole, "{error}");
        assert!(error.chars().count() < 200, "{error}");
    }
    let just = "x".repeat(58);
    let error = t(json!(just)).expect_err("malformed");
    assert!(error.contains(&just) && !error.contains('…'), "{error}");
}

/// The lines of docs/precision.md name what is allowed as the library does.
#[test]
fn the_document_says_what_is_allowed() {
    let text = include_str!("../../docs/precision.md");
    for kernel in Kernel::ALL
        .into_iter()
        .filter(|kernel| kernel.has_qualities())
    {
        for quality in Quality::ALL {
            for float in ["f32", "f64"] {
                let allowed = precision(kernel, quality, float).allowed;
                let (kernel, quality) = (kernel.name(), quality.name());
                let line = format!("| {kernel} | {quality} | {float} | {allowed} |");
                assert!(text.contains(&line), "{line}");
            }
        }
    }
}

/// An answer that is dark, or moved too far or to the other side, is told so.
#[test]
fn wrong_answers_are_told_apart() {
    let shade = vectors(Kernel::Shade).expect("valid");
    let right = Trial::of_kit(&shade, Quality::Wide, "f64");
    let (mut turned, mut off) = (0, 0);
    for judged in &right.judged {
        let Ok(Answer::Shade(mut shaded)) = Answer::<f64>::of(Kernel::Shade, &judged.out) else {
            panic!("{judged}");
        };
        let is_dark = shaded.bytes == [0; 3];
        shaded.bytes[1] ^= 4;
        let verdict = judged.case.judge(&Answer::Shade(shaded).out());
        assert_eq!(verdict.wrong, Some(Wrong::Byte(4)), "{judged}");
        off += 1;
        if !is_dark {
            shaded.li *= 0.0;
            let verdict = judged.case.judge(&Answer::Shade(shaded).out());
            assert_eq!(verdict.wrong, Some(Wrong::Decision), "{judged}");
            turned += 1;
        }
    }
    assert!(turned > 50 && off > 100, "{turned} turned, {off} off");

    let offset = vectors(Kernel::Offset).expect("valid");
    let (mut far, mut near) = (0, 0);
    for case in offset.iter().filter(|case| case.float() == "f32") {
        let Ok(Question::Offset(question)) = case.question::<f32>() else {
            continue;
        };
        // Beyond the reach by far, on the right side.
        let size = question.point.length().max(1.0);
        let moved = question.point + question.normal * (0.01 * size);
        let verdict = case.judge(&Answer::<f32>::Offset(moved).out());
        far += u32::from(verdict.wrong == Some(Wrong::Far));
        let moved = question.point + question.normal * (0.0005 * size);
        let verdict = case.judge(&Answer::<f32>::Offset(moved).out());
        near += u32::from(verdict.wrong.is_none());
    }
    assert!(far > 30 && near > 30, "{far} far, {near} near");
}

/// A light sample is a wrong decision where there should be none, and so is none where there should be
/// one; an origin that stays on its surface is on the wrong side.
#[test]
fn what_should_not_be_there_is_wrong() {
    let cases = vectors(Kernel::LightSample).expect("valid");
    let right = Trial::of_kit(&cases, Quality::Wide, "f64");
    let of = |judged: &Judged| {
        let answer = Answer::<f64>::of(Kernel::LightSample, &judged.out).expect("an answer");
        let Answer::LightSample(sample) = answer else {
            panic!("{judged}")
        };
        sample
    };
    let some = right.judged.iter().find_map(of);
    assert!(some.is_some());
    let (mut there, mut none) = (0, 0);
    for judged in &right.judged {
        let decided = |sample| judged.case.judge(&Answer::LightSample(sample).out()).wrong;
        let is_there = of(judged).is_some();
        let (with, without) = (decided(some), decided(None));
        assert_eq!(without, (is_there).then_some(Wrong::Decision), "{judged}");
        assert!(is_there || with == Some(Wrong::Decision), "{judged}");
        (there, none) = (there + u32::from(is_there), none + u32::from(!is_there));
    }
    assert!(
        there > 50 && none > 5,
        "{there} with a sample, {none} without"
    );

    let mut on = 0;
    let cases = vectors(Kernel::Offset).expect("valid");
    for case in cases.iter().filter(|case| case.float() == "f64") {
        let Ok(Question::Offset(question)) = case.question::<f64>() else {
            continue;
        };
        let stays = Answer::<f64>::Offset(question.point).out();
        let height = case.truth()["height_before"].as_str().expect("a height");
        let height: f64 = height.parse().expect("a number");
        if height == 0.0 {
            assert_eq!(case.judge(&stays).wrong, Some(Wrong::Side), "{}", case.id());
            on += 1;
        }
    }
    assert!(on > 5, "{on} on their surface");
}
