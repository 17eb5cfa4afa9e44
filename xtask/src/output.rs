//! Standard output.

use crate::error::{Error, Result};
use std::io::{self, ErrorKind, Write};

/// Prints text as it is. A reader who has left, such as `head`, is no error.
///
/// # Errors
/// If standard output cannot be written to.
pub fn print(text: &str) -> Result<()> {
    let mut out = io::stdout().lock();
    match out.write_all(text.as_bytes()).and_then(|()| out.flush()) {
        Err(error) if error.kind() != ErrorKind::BrokenPipe => Err(Error::new(format!(
            "cannot write to standard output: {error}; send it to another file"
        ))),
        _ => Ok(()),
    }
}
