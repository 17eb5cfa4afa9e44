//! temp
use ombrage::Quality;
use ombrage::conformance::Kernel;
use std::path::Path;
use xtask::survey::*;
#[test]
fn explore() {
    let dir = Path::new(env!("CARGO_MANIFEST_DIR")).join("../tests/vectors");
    for kernel in Kernel::ALL {
        let cases = vectors(&dir, kernel).unwrap();
        for quality in Quality::ALL {
            if !kernel.has_qualities() && quality != Quality::Stable {
                continue;
            }
            for float in ["f32", "f64"] {
                let judged = survey(kernel, quality, float, &cases);
                let f = failing(&judged);
                let ok = Measured::of(
                    judged
                        .iter()
                        .filter(|j| !f.contains(j.case["family"].as_str().unwrap())),
                );
                println!(
                    "FAM {} {} {float}: {:?} {ok:?}",
                    kernel.name(),
                    quality.name(),
                    failing(&judged)
                );
                for j in judged
                    .iter()
                    .filter(|j| j.fails && (quality != Quality::Textbook))
                {
                    println!("      {} {} {:?}", j.case["id"], j.out, j.verdict);
                }
            }
        }
    }
}
