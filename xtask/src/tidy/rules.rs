//! What must hold of the texts.

use super::house::{House, Text};

/// The longest source file, in lines.
const MOST_LINES: usize = 450;

/// How paths on one machine begin. Written in parts, so that this file does not have them.
const MACHINE: [&str; 5] = [
    concat!("/ho", "me/"),
    concat!("/ro", "ot/"),
    concat!("/Us", "ers/"),
    concat!("/tm", "p/"),
    concat!(":\\Us", "ers\\"),
];

/// Words that say something is not done.
const UNDONE: [&str; 4] = [
    concat!("TO", "DO"),
    concat!("FIX", "ME"),
    concat!("todo", "!("),
    concat!("unimpl", "emented!("),
];

/// Everything that does not hold, each with its place.
pub fn findings(house: &House) -> Vec<String> {
    let mut found = vec![];
    for file in house.files() {
        for (number, line) in (1..).zip(file.text.lines()) {
            if let Some(what) = of_line(file, line) {
                found.push(format!("{}:{number}: {what}", file.path));
            }
        }
    }
    for file in house.ending(".rs") {
        let lines = file.text.lines().count();
        if lines > MOST_LINES {
            let path = &file.path;
            found.push(format!(
                "{path}: {lines} lines, more than {MOST_LINES}: give it rooms"
            ));
        }
    }
    let stranger =
        |name| format!("{name}: nothing in the root but rooms and what cargo and git need");
    found.extend(house.strangers().iter().map(stranger));
    found.extend(house.ending(".md").flat_map(|file| dead_links(house, file)));
    found
}

/// What is wrong with a line.
fn of_line(file: &Text, line: &str) -> Option<String> {
    let has = |words: &[&'static str]| words.iter().find(|word| line.contains(**word)).copied();
    if let Some(path) = has(&MACHINE) {
        return Some(format!(
            "{path} is a path on one machine: write it from the workspace"
        ));
    }
    if let Some(word) = has(&UNDONE) {
        return Some(format!("{word}: do it, or say nothing"));
    }
    if !file.path.ends_with(".rs") {
        return None;
    }
    let attribute = line.trim_start();
    let is_allowed = attribute.starts_with("#[allow") || attribute.starts_with("#![allow");
    if is_allowed && !line.contains("reason =") {
        return Some("a lint is allowed without a reason: give reason = \"...\"".to_owned());
    }
    let in_src = file.path.starts_with("src/");
    if in_src && line.contains("xtask::") {
        return Some("the library knows the commands: move what it needs into src".to_owned());
    }
    let in_conformance = file.path.starts_with("src/conformance");
    if in_src && !in_conformance && line.contains("crate::conformance") {
        return Some(
            "a kernel knows what judges it: conformance knows all, none knows it".to_owned(),
        );
    }
    None
}

/// The links of a document to files that are not there.
fn dead_links(house: &House, file: &Text) -> Vec<String> {
    let folder = file.path.rsplit_once('/').map_or("", |(folder, _)| folder);
    let mut dead = vec![];
    for rest in file.text.split("](").skip(1) {
        let target = rest.split([')', '#', ' ', '\n']).next().unwrap_or_default();
        if target.is_empty() || target.contains(':') {
            continue;
        }
        let mut steps: Vec<&str> = folder.split('/').filter(|step| !step.is_empty()).collect();
        for step in target.split('/') {
            match step {
                ".." => drop(steps.pop()),
                "." | "" => {}
                step => steps.push(step),
            }
        }
        if !house.has(&steps.join("/")) {
            dead.push(format!("{}: the link to {target} leads nowhere", file.path));
        }
    }
    dead
}

#[cfg(test)]
mod tests {
    use super::*;

    fn found(path: &str, text: &str) -> Vec<String> {
        findings(&House::of(&[(path, text), ("docs/there.md", "")]))
    }

    #[test]
    fn every_rule_finds_what_breaks_it() {
        let long = "\n".repeat(MOST_LINES + 1);
        let breaks = [
            ("src/a.rs", long.as_str()),
            ("docs/a.md", concat!("in /ho", "me/me/x")),
            ("src/a.rs", concat!("// TO", "DO: more")),
            ("src/a.rs", "    #[allow(dead_code)]"),
            ("src/a.rs", "use xtask::table;"),
            ("src/a.rs", "use crate::conformance::Kernel;"),
            ("docs/a.md", "see [that](here.md)"),
            ("docs/a.md", "see [that](../src/there.md#part)"),
        ];
        for (path, text) in breaks {
            assert_eq!(found(path, text).len(), 1, "{path}: {text}");
        }
    }

    #[test]
    fn no_rule_finds_what_keeps_it() {
        let long = "\n".repeat(MOST_LINES);
        let keeps = [
            ("src/a.rs", long.as_str()),
            ("src/a.rs", "#[allow(dead_code, reason = \"it is shown\")]"),
            ("src/conformance/a.rs", "use crate::conformance::Kernel;"),
            ("xtask/src/a.rs", "use xtask::table;"),
            (
                "docs/a.md",
                "[a](there.md) [b](there.md#part) [c](../docs/there.md) [d](#part)",
            ),
            (
                "README.md",
                "[a](docs/there.md) [b](https://example.org/there)",
            ),
        ];
        for (path, text) in keeps {
            assert_eq!(found(path, text), [""; 0], "{path}: {text}");
        }
    }
}
