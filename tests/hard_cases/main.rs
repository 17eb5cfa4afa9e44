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
                let m = Measured::of(&judged);
                let ok = Measured::of(judged.iter().filter(|j| !j.fails));
                println!(
                    "{} {} {float}: {m:?}\n   ok ulps {} bounds {}\n   failing {:?}",
                    kernel.name(),
                    quality.name(),
                    ok.ulps,
                    ok.bounds,
                    failing(&judged)
                );
                if quality == Quality::Wide
                    || !kernel.has_qualities()
                    || (kernel == Kernel::LightSample && quality == Quality::Stable)
                {
                    for j in judged.iter().filter(|j| j.fails).take(8) {
                        println!("      {} {} {:?}", j.case["id"], j.out, j.verdict);
                    }
                }
            }
        }
    }
}
