//! The text of docs/digests.md.

use super::builds::BUILDS;
use super::subject::Subject;

const HEAD: &str = "\
# Digests

Written by `cargo xtask digests`: the first 16 digits of the SHA-256 of what the kit computes. Every
machine and every build is to compute the same; `cargo xtask digests --check` says whether this one
does. Pictures and radiance are computed at every level that the processor has, on one thread and on
two, and must agree before they are compared with this file.

This is a claim only where it was run: Rust 1.95, Linux on x86-64, on a processor with all levels from
`scalar` to `avx512`, in the first two of these builds; `cargo xtask digests --builds all` runs them all:

";

const COLUMNS: &str = "
Pictures are the bytes of the rows, three a pixel. Radiance is the bits of every component of every
pixel, little-endian, with one pattern for all NaN, in pictures at most 120 pixels wide; the lab's
chain has the default quality and `ulp-offset`. A scene that a format cannot hold is `invalid` there.
Counts are what the figures' table says. Files are those that the command writes.

| what | f32 | f64 |
|---|---|---|
";

/// The document.
pub fn text(subjects: &[Subject]) -> String {
    let mut text = HEAD.to_owned();
    for build in &BUILDS {
        text += &format!("- `{}`: {}\n", build.name, build.what);
    }
    text += COLUMNS;
    for Subject { name, digests } in subjects {
        text += &format!("| {name} | {} |\n", digests.join(" | "));
    }
    text
}

/// The lines in which a committed document differs from this one.
pub fn differences(committed: &str, text: &str) -> String {
    if committed == text {
        return String::new();
    }
    let missing = |from: &str, sign: &str, other: &str| -> String {
        let lines = other
            .lines()
            .filter(|line| !from.lines().any(|l| l == *line));
        lines.map(|line| format!("{sign} {line}\n")).collect()
    };
    let head = "docs/digests.md is not what this build computes (- committed, + computed)\n";
    head.to_owned() + &missing(text, "-", committed) + &missing(committed, "+", text)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_that_differ_are_named_from_both_sides() {
        let row = |digest: &str| Subject {
            name: "it".to_owned(),
            digests: vec![digest.to_owned(), String::new()],
        };
        let committed = text(&[row("0123")]);
        assert_eq!(differences(&committed, &committed), "");
        let named = differences(&committed, &text(&[row("4567")]));
        let lines: Vec<&str> = named.lines().skip(1).collect();
        assert_eq!(lines, ["- | it | 0123 |  |", "+ | it | 4567 |  |"]);
        assert!(differences("", &committed).lines().count() > 10);
    }
}
