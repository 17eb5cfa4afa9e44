//! Progress of long work, on standard error.

use indicatif::{ProgressBar, ProgressStyle};
use std::time::Duration;

/// A bar of so many steps, for work that is long; hidden where standard error is not a terminal.
pub fn bar(steps: u64, long: bool) -> ProgressBar {
    if !long {
        return ProgressBar::hidden();
    }
    let bar = ProgressBar::new(steps);
    if let Ok(style) = ProgressStyle::with_template("{spinner} {wide_bar} {percent:>3} %  {msg}") {
        bar.set_style(style);
    }
    bar.enable_steady_tick(Duration::from_millis(100));
    bar
}

/// Lets a bar say how much time is left, too.
pub fn show_time_left(bar: &ProgressBar) {
    let template = "{spinner} {wide_bar} {percent:>3} %  {msg}  {eta} left";
    if let Ok(style) = ProgressStyle::with_template(template) {
        bar.set_style(style);
    }
}
