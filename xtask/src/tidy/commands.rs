//! The commands that documents and messages show: whether they exist.

use super::house::House;

/// What a command line begins with.
const PROGRAM: &str = "cargo xtask ";

/// Where a command line ends, in prose, tables, code and help. Two spaces begin what it does.
const ENDS: [&str; 11] = ["  ", "`", "\"", "\\", "|", "<", ">", ";", "(", ")", "{"];

/// The commands and options that are shown and do not exist, each with its place.
pub fn findings(house: &House, program: &clap::Command) -> Vec<String> {
    let mut found = vec![];
    for file in house.files() {
        for (number, line) in (1..).zip(file.text.lines()) {
            for rest in line.split(PROGRAM).skip(1) {
                if let Some(what) = unknown(rest, program) {
                    found.push(format!("{}:{number}: {PROGRAM}{what}", file.path));
                }
            }
        }
    }
    found
}

/// What does not exist of a command line, which follows the program's name.
fn unknown(rest: &str, program: &clap::Command) -> Option<String> {
    let ends = ENDS.iter().filter_map(|end| rest.find(end)).min();
    let mut words = rest[..ends.unwrap_or(rest.len())].split_whitespace();
    let name = words.next()?.trim_end_matches([',', '.', ':']);
    if name == "--help" || name.chars().any(char::is_uppercase) {
        return None;
    }
    let Some(command) = program.find_subcommand(name) else {
        return Some(format!("{name}: there is no such command"));
    };
    let option = |word: &str| {
        let long = word.strip_prefix("--")?.trim_end_matches([',', '.', ':']);
        Some(long.split('=').next().unwrap_or(long).to_owned())
    };
    let has = |long: &str| {
        long == "help"
            || command
                .get_arguments()
                .any(|arg| arg.get_long() == Some(long))
    };
    // What follows a bare `--` is another program's.
    let mut options = words.take_while(|word| *word != "--").filter_map(option);
    let long = options.find(|long| !has(long))?;
    Some(format!("{name} --{long}: there is no such option"))
}

#[cfg(test)]
mod tests {
    use super::*;
    use clap::{Arg, Command};

    #[test]
    fn what_does_not_exist_is_found() {
        let draw = Command::new("draw").arg(Arg::new("out").long("out"));
        let program = Command::new("program").subcommand(draw);
        // `$` stands for the program, so that this file shows no command that there is not.
        let lines = [
            ("run `$ draw --out a.png`, then", None),
            ("  $ draw FILE          write --what is drawn", None),
            ("`$ --help` and `$ COMMAND`", None),
            ("$ draw --help", None),
            ("$ draw --out a -- other --over", None),
            ("$ erase", Some("a:1: $ erase: there is no such command")),
            (
                "$ draw --out a --over",
                Some("a:1: $ draw --over: there is no such option"),
            ),
        ];
        for (line, expected) in lines {
            let line = line.replace("$ ", PROGRAM);
            let found = findings(&House::of(&[("a", &line)]), &program);
            let expected = expected.map(|text| text.replace("$ ", PROGRAM));
            assert_eq!(found.first(), expected.as_ref(), "{line}");
        }
    }
}
