//! Byte ranges of a source text, from lines and columns.

use crate::mutant::{Place, Span};
use proc_macro2::{LineColumn, TokenStream};

/// The bytes from the first to before the second.
pub type Range = (usize, usize);

/// A text and where its lines start.
pub struct Lines<'a> {
    text: &'a str,
    starts: Vec<usize>,
}

impl<'a> Lines<'a> {
    /// The lines of a text.
    pub fn new(text: &'a str) -> Self {
        let after = text.match_indices('\n').map(|(place, _)| place + 1);
        Self {
            text,
            starts: std::iter::once(0).chain(after).collect(),
        }
    }

    /// The bytes of a span that syn found.
    pub fn of_token(&self, span: proc_macro2::Span) -> Range {
        let byte = |place: LineColumn| self.byte(place.line, place.column);
        (byte(span.start()), byte(span.end()))
    }

    /// The bytes of a span that cargo-mutants names.
    pub fn of_mutant(&self, span: Span) -> Range {
        let byte = |place: Place| self.byte(place.line, place.column.saturating_sub(1));
        (byte(span.start), byte(span.end))
    }

    /// The byte at a line, from 1, and so many characters after its start.
    fn byte(&self, line: usize, column: usize) -> usize {
        let start = self.starts.get(line.saturating_sub(1)).copied();
        let start = start.unwrap_or(self.text.len());
        let mut places = self.text[start..].char_indices();
        places
            .nth(column)
            .map_or(self.text.len(), |(place, _)| start + place)
    }
}

/// Code in one line, without its comments, so that a second copy of it moves no line; `None` where a
/// literal has a line break.
pub fn in_one_line(code: &str) -> Option<String> {
    if !code.contains('\n') && !code.contains("//") {
        return Some(code.to_owned());
    }
    let tokens: TokenStream = code.parse().ok()?;
    // Tokens are printed with few line breaks, and none that matters outside of literals.
    let text = tokens.to_string();
    let breaks_in_literals = literals(tokens).any(|literal| literal.contains('\n'));
    (!breaks_in_literals).then(|| text.replace('\n', " "))
}

/// The literals of some code, those in its groups too.
fn literals(tokens: TokenStream) -> Box<dyn Iterator<Item = String>> {
    use proc_macro2::TokenTree::{Group, Ident, Literal, Punct};
    Box::new(tokens.into_iter().flat_map(|token| match token {
        Group(group) => literals(group.stream()),
        Literal(literal) => Box::new(std::iter::once(literal.to_string())),
        Ident(_) | Punct(_) => Box::new(std::iter::empty()) as Box<dyn Iterator<Item = String>>,
    }))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn columns_are_characters() {
        let text = "a\né = ø;\n";
        let place = |line, column| Place { line, column };
        let range = Lines::new(text).of_mutant(Span {
            start: place(2, 5),
            end: place(2, 6),
        });
        assert_eq!(&text[range.0..range.1], "ø");
    }

    #[test]
    fn code_keeps_its_tokens_in_one_line() {
        let one = in_one_line("a // more\n  .b(\"//\")").expect("one line");
        assert!(!one.contains('\n') && !one.contains("more"), "{one}");
        assert!(one.contains("\"//\""), "{one}");
        assert_eq!(in_one_line("a + f(\"x\ny\")"), None);
    }
}
