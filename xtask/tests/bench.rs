//! `cargo xtask bench`: what it measures, run in the small, and run as a program.

use indicatif::ProgressBar;
use ombrage::{Level, Size};
use std::process::{Command, Output};
use std::sync::LazyLock;
use xtask::bench::{Bench, Plan, measure};

/// Everything, measured on small pictures, a few rounds each.
static BENCH: LazyLock<Bench> = LazyLock::new(|| {
    let size = |width, height| Size::new(width, height).expect("valid");
    let plan = Plan {
        sizes: vec![size(90, 60), size(61, 41)],
        growing_sizes: vec![size(30, 20), size(60, 40)],
        spheres: vec![1, 40],
        seconds: 0.0,
    };
    measure(&plan, &ProgressBar::hidden()).expect("every scene is valid")
});

#[test]
fn every_picture_is_what_it_must_be() {
    assert_eq!(BENCH.wrong_pictures, Vec::<String>::new());
}

#[test]
fn every_chain_runs_at_every_level_and_on_two_threads() {
    for float in ["f32", "f64"] {
        for chain in ["lab", "relative"] {
            let rows = BENCH.rows.iter().filter(|row| {
                let of_chain = (&*row.float, &*row.chain) == (float, chain);
                of_chain && row.width == 61
            });
            let levels: Vec<(&str, usize)> = rows.map(|row| (&*row.level, row.threads)).collect();
            let mut expected: Vec<_> = Level::available().map(|level| (level.name(), 1)).collect();
            expected.push((Level::best().name(), 2));
            assert_eq!(levels, expected, "{chain} in {float}");
        }
    }
}

#[test]
fn every_size_is_measured_against_the_labs_way() {
    let all = [
        &BENCH.rows,
        &BENCH.growth_with_pixels,
        &BENCH.growth_with_spheres,
    ];
    let rows: Vec<_> = all.into_iter().flatten().collect();
    let baselines = rows.iter().filter(|row| row.chain == "lab-way");
    assert_eq!(baselines.clone().count(), 2 * (2 + 2 + 2));
    for row in baselines {
        assert_eq!(
            (row.ratio_to_lab_way, &*row.level, row.threads),
            (1.0, "scalar", 1)
        );
    }
    for row in rows {
        assert!(
            row.ns_per_pixel > 0.0 && row.ratio_to_lab_way > 0.0,
            "{row:?}"
        );
    }
}

/// A proof takes all the formats it needs, so it runs once, and its picture is the truth.
#[test]
fn a_proof_is_measured_against_the_plain_picture() {
    let proofs = |width| {
        let rows = BENCH.rows.iter().filter(move |row| row.width == width);
        rows.filter(|row| row.chain == "proven")
    };
    for width in [90, 61] {
        let levels = proofs(width).map(|row| (&*row.level, row.threads));
        let mut expected: Vec<_> = Level::available().map(|level| (level.name(), 1)).collect();
        expected.push((Level::best().name(), 2));
        assert_eq!(levels.collect::<Vec<_>>(), expected);
        for row in proofs(width) {
            assert_eq!((&*row.float, row.wrong_bytes), ("f32", 0), "{row:?}");
            assert!(row.ratio_to_plain > Some(0.0), "{row:?}");
        }
    }
    let others = BENCH.rows.iter().filter(|row| row.chain != "proven");
    assert!(others.into_iter().all(|row| row.ratio_to_plain.is_none()));
}

/// The strategies differ in what they get wrong, and the times in the table know it.
#[test]
fn wrong_bytes_stand_beside_every_time() {
    let wrong = |shadow: &str| {
        let of = |row: &&xtask::bench::result::Row| row.shadow == shadow && row.float == "f32";
        BENCH.rows.iter().find(of).expect("a row").wrong_bytes
    };
    assert!(wrong("self-hitting") > 1000);
    assert!(wrong("sidedness") < 5);
    assert!(wrong("ulp-offset") < 20);
}

#[test]
fn limits_shares_and_operations_are_those_of_packets() {
    let packets = Level::available().filter(|level| level.simd().is_some());
    assert_eq!(BENCH.limits.len(), 2 * packets.count());
    for limit in &BENCH.limits {
        let times = [limit.add_mul_ns, limit.divide_ns, limit.sqrt_ns];
        assert!(times.into_iter().all(|ns| ns > 0.0), "{limit:?}");
    }
    for row in BENCH.rows.iter().filter(|row| row.chain == "relative") {
        let expected = row.threads == 1 && row.level != "scalar";
        assert_eq!(row.share_of_limit.is_some(), expected, "{row:?}");
    }
    for counted in &BENCH.operations {
        assert!(
            counted.add_mul > 20.0 && counted.divide > 0.5,
            "{counted:?}"
        );
    }
}

fn bench(args: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_xtask"));
    let output = command.arg("bench").args(args).output();
    output.expect("the program runs")
}

#[test]
fn json_is_the_same_data() {
    let output = bench(&["--quick", "--json"]);
    let errors = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{errors}");
    let bench: Bench = serde_json::from_slice(&output.stdout).expect("a bench");
    assert_eq!(bench.machine.cores, BENCH.machine.cores);
    let sizes = bench.rows.iter().map(|row| (row.width, row.height));
    assert!(sizes.into_iter().all(|size| size == (600, 400)));
    let wrong = |chain: &str| {
        bench
            .rows
            .iter()
            .find(|row| row.chain == chain)
            .map(|row| row.wrong_bytes)
    };
    assert!(wrong("relative") <= Some(5), "{:?}", wrong("relative"));
    assert!(wrong("lab-way") <= Some(10), "{:?}", wrong("lab-way"));
    assert_eq!(
        bench
            .growth_with_spheres
            .iter()
            .map(|row| row.spheres)
            .max(),
        Some(64)
    );
}

#[test]
fn frames_are_drawn_at_levels_that_exist() {
    let output = bench(&["--frames", "1", "--chain", "lab", "--level", "scalar"]);
    assert!(output.status.success());
    assert!(output.stdout.is_empty() && output.stderr.is_empty());
    let output = bench(&["--frames", "1", "--level", "avx1024"]);
    assert_eq!(output.status.code(), Some(2));
    let errors = String::from_utf8_lossy(&output.stderr);
    assert!(
        errors.contains("avx1024") && errors.contains("scalar"),
        "{errors}"
    );
}

#[test]
fn instructions_are_not_counted_without_optimisations_or_valgrind() {
    let mut command = Command::new(env!("CARGO_BIN_EXE_xtask"));
    let output = command
        .args(["bench", "--instructions"])
        .env("PATH", "")
        .output();
    let output = output.expect("the program runs");
    assert!(output.status.success());
    let errors = String::from_utf8_lossy(&output.stderr);
    assert!(errors.starts_with("no instructions counted: "), "{errors}");
}
