//! Snippets with switches: they are still Rust, have each switch once, and no line more.

use super::*;
use crate::mutant::{Function, Genre, Place, Span};

/// A mutant of `text` whose replaced part is the `nth` occurrence of `part`, from 0.
fn mutant(text: &str, genre: Genre, part: &str, nth: usize, replacement: &str) -> Mutant {
    let (start, _) = text.match_indices(part).nth(nth).expect("the part");
    let place = |byte: usize| {
        let before = &text[..byte];
        let line = before.matches('\n').count() + 1;
        let column = before.chars().rev().take_while(|c| *c != '\n').count() + 1;
        Place { line, column }
    };
    Mutant {
        file: "src/a.rs".into(),
        package: "ombrage".into(),
        name: format!("{part} {nth} {replacement}"),
        genre,
        span: Span {
            start: place(start),
            end: place(start + part.len()),
        },
        replacement: replacement.into(),
        function: Some(Function {
            return_type: String::new(),
        }),
    }
}

/// The text with switches, after checking what holds of every one.
fn switched(text: &str, mutants: &[Mutant]) -> Switched {
    let numbers: Vec<usize> = (0..mutants.len()).collect();
    let switched = rewrite(text, mutants, &numbers).expect("Rust");
    let new = &switched.text;
    assert!(syn::parse_file(new).is_ok(), "{new}");
    assert_eq!(new.lines().count(), text.lines().count(), "{new}");
    for number in numbers {
        let once = usize::from(!switched.without.contains(&number));
        let asked = new.matches(&format!("{IS_ON}({number})")).count();
        assert_eq!(asked, once, "{number}: {new}");
        let branches = switched.branches.iter().filter(|branch| branch.1 == number);
        assert_eq!(branches.count(), once, "{number}: {new}");
        let places = switched.places.iter();
        let places = places.filter(|place| place.1.contains(&number));
        assert_eq!(places.count(), once, "{number}: {new}");
    }
    for ((start, end), number) in &switched.branches {
        assert!(new[*start..*end].contains(&format!("({number})")), "{new}");
    }
    switched
}

#[test]
fn operators_in_operators() {
    let text =
        "fn f(a: i32, b: i32) -> bool {\n    a * b + 2 // sum\n        * a < 3 && -b > 1\n}\n";
    let binary = Genre::BinaryOperator;
    let made = switched(
        text,
        &[
            mutant(text, binary, "*", 0, "/"),
            mutant(text, binary, "*", 0, "+"),
            mutant(text, binary, "+", 0, "-"),
            mutant(text, binary, "*", 1, "+"),
            mutant(text, binary, "<", 0, "<="),
            mutant(text, binary, "&&", 0, "||"),
            mutant(text, Genre::UnaryOperator, "-", 1, ""),
        ],
    );
    assert!(made.without.is_empty());
    assert!(made.text.contains("{ a / b } else if"), "{}", made.text);
}

#[test]
fn assignments_are_statements() {
    let text = "fn f(a: &mut i32) {\n    *a += 1;\n    if *a == 2 { *a -= 3 }\n}\n";
    let made = switched(
        text,
        &[
            mutant(text, Genre::BinaryOperator, "+=", 0, "-="),
            mutant(text, Genre::BinaryOperator, "==", 0, "!="),
            mutant(text, Genre::BinaryOperator, "-=", 0, "/="),
        ],
    );
    assert!(
        made.text.contains("{ *a -= 1 } else { *a += 1 } };"),
        "{}",
        made.text
    );
}

#[test]
fn arms_and_guards() {
    let text = [
        "fn f(a: i32) -> i32 {",
        "    match a {",
        "        1 => 2,",
        "        b",
        "            if b > 3 =>",
        "        {",
        "            4",
        "        }",
        "        _ => 5,",
        "    }",
        "}",
    ]
    .join("\n");
    let text = text.as_str();
    let guarded = "b\n            if b > 3 =>\n        {\n            4\n        }";
    let made = switched(
        text,
        &[
            mutant(text, Genre::MatchArm, "1 => 2,", 0, ""),
            mutant(text, Genre::MatchArm, guarded, 0, ""),
            mutant(text, Genre::MatchArmGuard, "b > 3", 0, "true"),
            mutant(text, Genre::MatchArmGuard, "b > 3", 0, "false"),
            mutant(text, Genre::BinaryOperator, ">", 1, "<"),
        ],
    );
    assert!(
        made.text.contains(&format!("1 if !{IS_ON}(0) =>")),
        "{}",
        made.text
    );
}

#[test]
fn fields_with_a_base() {
    let text = "fn f(x: i32, s: S) -> S {\n    let y = 1;\n    S { x: x + 1, y, ..s }\n}\n";
    let made = switched(
        text,
        &[
            mutant(text, Genre::StructField, "x: x + 1", 0, ""),
            mutant(text, Genre::StructField, "y", 1, ""),
            mutant(text, Genre::BinaryOperator, "+", 0, "*"),
        ],
    );
    assert!(made.text.contains("{ (s).y } else { y }"), "{}", made.text);
}

#[test]
fn bodies_and_what_is_in_them() {
    let text = "fn f(a: i32) -> i32 {\n    let b = !a;\n    b - 1\n}\n";
    let body = "let b = !a;\n    b - 1";
    let made = switched(
        text,
        &[
            mutant(text, Genre::FnValue, body, 0, "0"),
            mutant(text, Genre::FnValue, body, 0, "-1"),
            mutant(text, Genre::UnaryOperator, "!", 0, ""),
            mutant(text, Genre::BinaryOperator, "-", 1, "+"),
        ],
    );
    let start = format!("if {IS_ON}(0) {{ return 0; }}");
    assert!(made.text.contains(&start), "{}", made.text);
}

#[test]
fn functions_with_switches_are_compiled_once() {
    let text = "#[inline(always)]\nfn f(a: i32) -> i32 { a + 1 }\n";
    let plus = mutant(text, Genre::BinaryOperator, "+", 0, "-");
    let made = switched(text, &[plus]);
    assert!(!made.text.contains("always"), "{}", made.text);
}

#[test]
fn what_can_have_no_switch() {
    let text = [
        "const A: i32 = 1 + 2;",
        "const fn f(a: i32) -> i32 { a - 1 }",
        "fn g(a: Option<i32>) -> i32 {",
        "    if let Some(b) = a && b > 1 { b / 2 } else { [0; 4 * 2][0] }",
        "}",
    ]
    .join("\n");
    let text = text.as_str();
    let mut opaque = mutant(text, Genre::FnValue, "if let", 0, "::std::iter::empty()");
    opaque.function = Some(Function {
        return_type: "-> impl Iterator<Item = i32>".into(),
    });
    let made = switched(
        text,
        &[
            mutant(text, Genre::BinaryOperator, "+", 0, "-"),
            mutant(text, Genre::BinaryOperator, "-", 2, "+"),
            mutant(text, Genre::BinaryOperator, "&&", 0, "||"),
            mutant(text, Genre::BinaryOperator, "*", 0, "+"),
            mutant(text, Genre::BinaryOperator, "/", 0, "*"),
            opaque,
        ],
    );
    assert_eq!(made.without, [0, 1, 2, 3, 5]);
}
