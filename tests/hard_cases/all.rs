//! The hard cases: every kernel, in every quality and format, over all test vectors and over random
//! coordinates, held to the errors that `conformance::precision` allows.

mod quantise;
mod random;
mod report;

use ombrage::Quality;
use ombrage::conformance::{
    Judged, Kernel, Measured, Trial, failing, known_failures, precision, vectors,
};
use report::describe;
use std::collections::BTreeSet;

/// No case fails but those of the families known to fail; each of these fails; and no stricter error of
/// the same kind would do for the others.
fn hold(kernel: Kernel, quality: Quality, float: &str) {
    let cases = vectors(kernel).unwrap_or_else(|error| panic!("{error}"));
    let Trial {
        judged,
        unsupported,
    } = Trial::of_kit(&cases, quality, float);
    assert!(unsupported.is_empty(), "{unsupported:?}");
    assert!(judged.len() >= 100, "only {} cases", judged.len());
    let findings = findings(kernel, quality, float, &judged);
    let name = format!("{} {} {float}", kernel.name(), quality.name());
    assert!(findings.is_empty(), "{name}:\n{}", findings.join("\n"));
}

fn findings(kernel: Kernel, quality: Quality, float: &str, judged: &[Judged]) -> Vec<String> {
    let allowed = precision(kernel, quality, float).allowed;
    let known: BTreeSet<&str> = known_failures(kernel, quality, float)
        .map(|(family, _)| family)
        .collect();
    let is_known = |judged: &&Judged| known.contains(judged.case.family());
    let mut findings: Vec<String> = judged
        .iter()
        .filter(|judged| judged.fails && !is_known(judged))
        .map(|judged| format!("beyond {allowed}: {}", describe(judged)))
        .collect();
    let passing = known
        .difference(&failing(judged))
        .copied()
        .collect::<Vec<_>>();
    findings.extend(passing.into_iter().map(|family| {
        format!("{family} is known to fail, and passes: take it off the known failures")
    }));
    let measured = Measured::of(judged.iter().filter(|judged| !is_known(judged)));
    if let Some(stricter) = measured.could_be(allowed) {
        findings.push(format!("allowed is {allowed}, and could be {stricter}"));
    }
    findings
}

macro_rules! hold {
    ($($kernel:ident: $($quality:ident)+,)+) => {
        #[allow(non_snake_case, reason = "tests bear the names of the variants they hold")]
        mod vectors_of {
            $(mod $kernel {
                $(mod $quality {
                    #[test]
                    fn f32() {
                        crate::hold(crate::Kernel::$kernel, crate::Quality::$quality, "f32");
                    }

                    #[test]
                    fn f64() {
                        crate::hold(crate::Kernel::$kernel, crate::Quality::$quality, "f64");
                    }
                })+
            })+
        }

        /// The kernels that are held.
        const HELD: &[Kernel] = &[$(Kernel::$kernel),+];
    };
}

hold! {
    RayPlane: Textbook Stable Wide,
    RaySphere: Textbook Stable Wide,
    AnyHit: Textbook Stable Wide,
    LightSample: Textbook Stable Wide,
    Shade: Stable,
    Offset: Stable,
    Quantise: Stable,
}

#[test]
fn every_kernel_is_held() {
    assert_eq!(HELD, Kernel::ALL);
}

/// A family name in the known failures that no vector has would never be noticed otherwise.
#[test]
fn every_known_failure_is_of_a_kernel_that_is_held_in_that_quality() {
    for known in ombrage::conformance::KNOWN_FAILURES {
        assert!(known.kernel.has_qualities(), "{known:?}");
        assert!(!known.qualities.contains(&Quality::Wide), "{known:?}");
    }
}
