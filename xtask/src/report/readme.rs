//! What the README takes from the report: the three headline figures, and its pictures.

use super::data::Data;
use super::headline;
use super::page::Pictures;
use crate::error::{Error, Result};
use crate::picture_file;
use std::fs;
use std::path::Path;

/// Between these lines stand the headline figures.
const BEGIN: &str = "<!-- report: begin -->\n";
const END: &str = "<!-- report: end -->\n";

/// The README with the headline figures of these data.
///
/// # Errors
/// If it cannot be read, or has no place for them.
pub fn renewed(path: &Path, data: &Data) -> Result<String> {
    let name = path.display();
    let text = fs::read_to_string(path)
        .map_err(|error| Error::new(format!("cannot read {name}: {error}")))?;
    let place = text
        .find(BEGIN)
        .zip(text.find(END))
        .filter(|(begin, end)| begin < end);
    let Some((begin, end)) = place else {
        return Err(Error::new(format!(
            "{name} has no place for the headline figures; put the lines {} and {} where they go",
            BEGIN.trim(),
            END.trim()
        )));
    };
    let (before, after) = (&text[..begin + BEGIN.len()], &text[end..]);
    let items = headline::all(data).into_iter().map(|headline| {
        let text = format!("**{}** {}", headline.figure, headline.sentence);
        wrapped(&text)
    });
    Ok(format!("{before}{}{after}", items.collect::<String>()))
}

/// An item of a list, its lines at most 100 columns wide.
fn wrapped(text: &str) -> String {
    let (mut lines, mut line) = (String::new(), "-".to_owned());
    for word in text.split(' ') {
        if line.chars().count() + 1 + word.chars().count() > 100 {
            lines += &line;
            lines += "\n";
            line = " ".into();
        }
        line += " ";
        line += word;
    }
    lines + &line + "\n"
}

/// The figures that the README shows from docs/figures and that are not those of the report.
///
/// # Errors
/// If the README cannot be read.
pub fn stale_pictures(root: &Path, pictures: &Pictures) -> Result<Vec<String>> {
    let path = root.join("README.md");
    let text = fs::read_to_string(&path)
        .map_err(|error| Error::new(format!("cannot read {}: {error}", path.display())))?;
    let mut stale = vec![];
    for drawn in pictures.drawn() {
        let name = format!("docs/figures/fig{}.png", drawn.figure.name);
        let file = root.join(&name);
        if text.contains(&name) && picture_file::read(&file).ok().as_ref() != Some(&drawn.picture) {
            stale.push(format!(
                "{} is missing or stale; renew it with: cargo xtask figures",
                file.display()
            ));
        }
    }
    Ok(stale)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_are_at_most_a_hundred_columns() {
        let text = wrapped(&"many words ".repeat(40));
        assert!(
            text.lines().all(|line| line.chars().count() <= 100),
            "{text}"
        );
        assert!(
            text.starts_with("- many") && text.contains("\n  many"),
            "{text}"
        );
    }
}
