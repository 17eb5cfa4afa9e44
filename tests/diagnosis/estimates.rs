//! What was drawn comes out again as a number.

use crate::faults::faults;
use crate::naive::Naive;
use crate::{WIDE, judge};
use ombrage::conformance::diagnosis::{Diagnosis, Estimate, Finding};

fn figure(name: &str) -> Naive {
    Naive::figure(name, WIDE.0, WIDE.1)
}

/// The one finding of a picture that has this fault.
fn finding(naive: &Naive, figure: &str, code: &str) -> Finding {
    let Diagnosis { findings, .. } = judge(naive, figure);
    let [finding] = &findings[..] else {
        panic!("{code}: {findings:?}");
    };
    assert_eq!(finding.code.name(), code);
    finding.clone()
}

fn estimate<'a>(finding: &'a Finding, name: &str) -> &'a Estimate {
    let mut named = finding.estimates.iter().filter(|(known, _)| *known == name);
    let (_, estimate) = named
        .next()
        .unwrap_or_else(|| panic!("no {name}: {finding:?}"));
    estimate
}

fn is_near(estimate: &Estimate, drawn: &[f32], tolerance: f64) {
    let numbers = match estimate {
        Estimate::Number(number) => vec![*number],
        Estimate::Numbers(numbers) => numbers.clone(),
        Estimate::Name(name) => panic!("{name} is no number"),
    };
    assert_eq!(numbers.len(), drawn.len());
    for (found, drawn) in numbers.iter().zip(drawn) {
        let off = (found - f64::from(*drawn)).abs();
        assert!(off <= tolerance, "{numbers:?}, but {drawn} was drawn");
    }
}

#[test]
fn offsets() {
    for offset in [0.1, 0.3, 0.5] {
        let naive = Naive {
            offset,
            ..figure("3c")
        };
        let found = finding(&naive, "3c", "OFFSET_TOO_LARGE");
        let tolerance = 0.1 * f64::from(offset);
        is_near(estimate(&found, "offset"), &[offset], tolerance);
    }
}

#[test]
fn shifts() {
    let shifted = Naive {
        shift: [0.3, 0.0, 0.2],
        ..figure("3c")
    };
    let found = finding(&shifted, "3c", "SHADOW_SHIFTED");
    is_near(estimate(&found, "shift"), &[0.3, 0.2], 0.05);
    let light = Naive {
        shadow_light: Some([-1.0, 10.0, 1.0]),
        ..figure("3c")
    };
    let found = finding(&light, "3c", "SHADOW_SHIFTED");
    is_near(estimate(&found, "light_shift"), &[-2.0, 0.0], 0.2);
}

#[test]
fn powers() {
    for (name, power) in [("2b", 50.0), ("3c", 10.0), ("3c", 400.0)] {
        let naive = Naive {
            power,
            ..figure(name)
        };
        let found = finding(&naive, name, "WRONG_POWER");
        let tolerance = 0.02 * f64::from(power);
        is_near(estimate(&found, "power"), &[power], tolerance);
    }
}

#[test]
fn colours() {
    let color = [0.2, 0.6, 0.9];
    let sphere = Naive {
        sphere_color: color,
        ..figure("3c")
    };
    let found = finding(&sphere, "3c", "WRONG_COLOUR");
    is_near(estimate(&found, "sphere"), &color, 0.02);
    assert_eq!(estimate(&found, "object"), &Estimate::Name("sphere"));
    let plane = Naive {
        plane_color: color,
        ..figure("3c")
    };
    let found = finding(&plane, "3c", "WRONG_COLOUR");
    is_near(estimate(&found, "plane"), &color, 0.02);
    assert_eq!(estimate(&found, "object"), &Estimate::Name("plane"));
    let background = Naive {
        background: color,
        ..figure("1")
    };
    let found = finding(&background, "1", "WRONG_BACKGROUND");
    is_near(estimate(&found, "background"), &color, 0.005);
}

#[test]
fn fields_of_view() {
    for fov in [45.0, 70.0] {
        let naive = Naive {
            fov,
            ..figure("3c")
        };
        let found = finding(&naive, "3c", "WRONG_FOV");
        is_near(estimate(&found, "fov"), &[fov], 0.3);
    }
}

#[test]
fn curves() {
    for (gamma, name) in [(1, "srgb"), (2, "2.2")] {
        let naive = Naive {
            gamma,
            ..figure("3c")
        };
        let found = finding(&naive, "3c", "GAMMA");
        assert_eq!(estimate(&found, "gamma"), &Estimate::Name(name));
    }
    let unclamped = Naive {
        clamp_cosine: false,
        ..figure("2a")
    };
    let found = finding(&unclamped, "2a", "COSINE_UNCLAMPED");
    assert_eq!(estimate(&found, "cosine"), &Estimate::Name("signed"));
}

/// Acne is named on the objects that have it, and the rate is the part of the lit pixels that it
/// blackens, or of their light.
#[test]
fn acne() {
    for side in [0, 4] {
        let right = Naive {
            side,
            ..figure("3c")
        };
        for (acne, which) in [
            ([true; 2], "sphere and plane"),
            ([true, false], "sphere"),
            ([false, true], "plane"),
        ] {
            let speckled = Naive { acne, ..right };
            let found = finding(&speckled, "3c", "ACNE");
            assert_eq!(estimate(&found, "object"), &Estimate::Name(which));
            for (index, object) in ["sphere", "plane"].into_iter().enumerate() {
                if acne[index] {
                    let lost = lost(&right, &speckled, [2, 0][index]);
                    is_near(estimate(&found, object), &[lost], 0.06);
                }
            }
            let averages = found.estimates.iter();
            let averages = averages.filter(|(name, _)| *name == "averaged").count();
            let objects = acne.into_iter().filter(|&is| is).count();
            assert_eq!(averages, if side > 0 { objects } else { 0 });
        }
    }
}

/// The part of a channel's light that a picture lacks: blue is the sphere's, red the plane's.
fn lost(right: &Naive, other: &Naive, channel: usize) -> f32 {
    let (right, other) = (right.draw(), other.draw());
    let (mut whole, mut left) = (0.0, 0.0);
    for (right, other) in right.chunks_exact(3).zip(other.chunks_exact(3)) {
        let others = (0..3).filter(|&c| c != channel);
        if right[channel] > 24 && others.clone().all(|c| right[c] == 0) {
            whole += 1.0;
            left += f32::from(other[channel]) / f32::from(right[channel]);
        }
    }
    1.0 - left / whole
}

/// The pixels of a fault are those that it changes, and the region is the rectangle around them.
#[test]
fn places() {
    for (code, name, naive) in faults(WIDE.0, WIDE.1) {
        if ["ACNE", "OTHER_SCENE"].contains(&code) {
            continue;
        }
        let found = judge(&naive, name).findings;
        let [found] = &found[..] else {
            panic!("{code} {name}: {found:?}");
        };
        let (faulty, right) = (naive.draw(), figure(name).draw());
        let pairs = faulty.chunks_exact(3).zip(right.chunks_exact(3));
        let differ = |(a, b): (&[u8], &[u8])| a.iter().zip(b).any(|(a, b)| a.abs_diff(*b) > 2);
        let differing: Vec<usize> = pairs
            .enumerate()
            .filter(|(_, pair)| differ(*pair))
            .map(|(at, _)| at)
            .collect();
        assert_eq!(found.places.len(), found.pixels);
        let few = 20 + differing.len() / 20;
        assert!(
            found.pixels.abs_diff(differing.len()) <= few,
            "{code} {name}: {} pixels, but {} differ",
            found.pixels,
            differing.len()
        );
        let width = WIDE.0 as usize;
        let columns = found.places.iter().map(|at| (at % width) as u32);
        let rows = found.places.iter().map(|at| (at / width) as u32);
        let region = found.region.expect("some pixels");
        assert_eq!(Some(region.left), columns.clone().min(), "{code} {name}");
        assert_eq!(Some(region.top), rows.clone().min(), "{code} {name}");
        assert_eq!(columns.max(), Some(region.left + region.width - 1));
        assert_eq!(rows.max(), Some(region.top + region.height - 1));
    }
}
