//! Lines of a stranger's text, read with bounded memory.

use std::io::{self, BufRead, ErrorKind};

/// Reads to the end of the line, without it, and returns its length in bytes; `None` at the end of
/// the input. Of a line longer than `longest` only the start is kept; one that is longer than
/// `endless` is not read on, and its length so far is returned.
///
/// # Errors
/// If the input cannot be read.
pub fn read_line(
    input: &mut impl BufRead,
    line: &mut Vec<u8>,
    longest: usize,
    endless: usize,
) -> io::Result<Option<usize>> {
    line.clear();
    let mut length = 0;
    loop {
        let buffer = match input.fill_buf() {
            Err(error) if error.kind() == ErrorKind::Interrupted => continue,
            buffer => buffer?,
        };
        if buffer.is_empty() {
            return Ok((length > 0).then_some(length));
        }
        let end = buffer.iter().position(|&byte| byte == b'\n');
        let part = &buffer[..end.unwrap_or(buffer.len())];
        length += part.len();
        if length <= longest {
            line.extend_from_slice(part);
        }
        let read = part.len() + usize::from(end.is_some());
        input.consume(read);
        if end.is_some() || length > endless {
            return Ok(Some(length));
        }
    }
}

/// The first characters of a stranger's text, as a message may show them: what controls a terminal is
/// written as an escape.
pub fn printable(text: &str, most: usize) -> String {
    let shown = |c: char| match c.is_control() {
        true => c.escape_default().to_string(),
        false => c.to_string(),
    };
    text.chars().take(most).map(shown).collect()
}

#[cfg(test)]
mod tests {
    use super::{printable, read_line};
    use std::io::BufReader;

    /// Lines and their lengths, read through a buffer of three bytes.
    fn lines(text: &str, longest: usize, endless: usize) -> Vec<(String, usize)> {
        let mut input = BufReader::with_capacity(3, text.as_bytes());
        let (mut lines, mut line) = (vec![], vec![]);
        while let Some(length) = read_line(&mut input, &mut line, longest, endless).expect("bytes")
        {
            lines.push((String::from_utf8_lossy(&line).into_owned(), length));
        }
        lines
    }

    #[test]
    fn nothing_controls_the_terminal() {
        let text = "a\u{1b}[2J\u{7f}\u{9b}é\n";
        assert_eq!(printable(text, 100), "a\\u{1b}[2J\\u{7f}\\u{9b}é\\n");
        assert_eq!(printable(text, 2), "a\\u{1b}");
    }

    #[test]
    fn lines_are_those_of_the_text() {
        for text in ["", "\n", "a", "a\n", "abcdefgh\n\nij\nk", "\n\nabc"] {
            let found = lines(text, 100, 100);
            let expected: Vec<_> = text
                .lines()
                .map(|line| (line.to_owned(), line.len()))
                .collect();
            assert_eq!(found, expected, "{text:?}");
        }
    }

    #[test]
    fn long_lines_are_counted_but_not_kept() {
        let text = format!("ab\n{}\ncd\n", "x".repeat(50));
        let found = lines(&text, 10, 100);
        assert_eq!((found[0].0.as_str(), found[2].0.as_str()), ("ab", "cd"));
        assert_eq!(found[1].1, 50);
        assert!(found[1].0.len() <= 10);
    }

    #[test]
    fn a_line_without_end_is_given_up() {
        let found = lines(&"x".repeat(1000), 10, 100);
        assert!(found[0].1 > 100 && found[0].1 <= 103, "{}", found[0].1);
    }
}
