//! Other builds of the kit, each asked whether it computes the same.

use super::{Builds, failed, unknown};
use crate::error::Result;
use crate::output;
use crate::table::Table;
use std::path::Path;
use std::process::{Command, ExitCode};
use std::time::Instant;

/// A way to build the kit.
pub struct Build {
    /// Its name.
    pub name: &'static str,
    /// What it is.
    pub what: &'static str,
    /// Cargo's options for it.
    options: &'static [&'static str],
}

/// The builds, those that cargo has made anyway first.
pub const BUILDS: [Build; 7] = [
    Build {
        name: "dev",
        what: "the dev profile: opt-level 1, overflow checks, debug assertions",
        options: &[],
    },
    Build {
        name: "release",
        what: "the release profile: opt-level 3",
        options: &["--release"],
    },
    Build {
        name: "dev-0",
        what: "the dev profile at opt-level 0",
        options: &["--config", "profile.dev.opt-level=0"],
    },
    Build {
        name: "release-1",
        what: "the release profile at opt-level 1",
        options: &["--release", "--config", "profile.release.opt-level=1"],
    },
    Build {
        name: "release-2",
        what: "the release profile at opt-level 2",
        options: &["--release", "--config", "profile.release.opt-level=2"],
    },
    Build {
        name: "release-v3",
        what: "release for x86-64-v3: AVX2 and FMA",
        options: &[
            "--release",
            "--config",
            "build.rustflags=[\"-Ctarget-cpu=x86-64-v3\"]",
        ],
    },
    Build {
        name: "release-native",
        what: "release for the processor it is built on",
        options: &[
            "--release",
            "--config",
            "build.rustflags=[\"-Ctarget-cpu=native\"]",
        ],
    },
];

/// Reads `all`, or names.
pub fn parse(text: &str) -> std::result::Result<Builds, String> {
    if text == "all" {
        return Ok(Builds(BUILDS.iter().collect()));
    }
    let named = |name: &str| {
        let build = BUILDS.iter().find(|build| build.name == name.trim());
        build.ok_or_else(|| unknown(name.trim()))
    };
    let builds: std::result::Result<Vec<_>, _> = text.split(',').map(named).collect();
    builds.map(Builds)
}

/// Builds in every way and has each build check the digests; prints what they say and a table.
pub fn compare(root: &Path, builds: &[&Build]) -> Result<ExitCode> {
    let mut table = Table::new(&["build", "digests", "seconds"]);
    let mut all_same = true;
    for build in builds {
        let begin = Instant::now();
        let mut cargo = Command::new("cargo");
        cargo.args(["run", "--quiet", "--locked", "--package", "xtask"]);
        cargo.args(build.options).args(["--", "digests", "--check"]);
        // Flags of the caller's would come before those of the build.
        cargo
            .env_remove("RUSTFLAGS")
            .env_remove("CARGO_ENCODED_RUSTFLAGS");
        if root.file_name().is_some() {
            cargo.current_dir(root);
        }
        let status = cargo
            .status()
            .map_err(|error| failed("start cargo", &error))?;
        all_same &= status.success();
        let verdict = match status.code() {
            Some(0) => "the same",
            Some(1) => "differ",
            _ => "unknown: the build failed",
        };
        let seconds = format!("{:.0}", begin.elapsed().as_secs_f64());
        table.row(vec![build.name.to_owned(), verdict.to_owned(), seconds]);
    }
    output::print(&table.render())?;
    Ok(if all_same {
        ExitCode::SUCCESS
    } else {
        ExitCode::FAILURE
    })
}
