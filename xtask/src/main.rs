//! The commands of the kit: `cargo xtask`.

fn main() {}
