//! Where the shadow lies.

use super::{changed, is_near, mixed, picture, right, size, turned, whole};
use crate::conformance::diagnosis::Code;
use crate::conformance::diagnosis::evidence::distance;
use crate::conformance::diagnosis::loss::Lossless;
use crate::conformance::diagnosis::recipe::{Recipe, ShadowRay};
use crate::conformance::diagnosis::shadow::{
    displaced, is_worth_a_walk, least_gain, shadow_rays, shadow_region,
};
use crate::conformance::diagnosis::surface::{Object, Region};
use crate::picture::{Picture, Size};

const SIZE: (u32, u32) = (96, 64);

const EXACT: ShadowRay = ShadowRay {
    offset: 0.0,
    shift: [0.0; 2],
    light: [0.0; 2],
};

fn offset(offset: f64) -> ShadowRay {
    ShadowRay { offset, ..EXACT }
}

fn shift(x: f64, z: f64) -> ShadowRay {
    ShadowRay {
        shift: [x, z],
        ..EXACT
    }
}

fn light(x: f64, z: f64) -> ShadowRay {
    ShadowRay {
        light: [x, z],
        ..EXACT
    }
}

/// Figure 3(c) with such shadow rays.
fn with(ray: ShadowRay) -> Recipe {
    turned(&right("3c"), |r| r.viewpoint.shadow = Some(ray))
}

/// The recipe that is found in a picture, from the right one.
fn found(picture: &Picture) -> Recipe {
    let (right, evidence) = (right("3c"), whole(picture, &Lossless));
    let drawn = evidence.drawn(&right).expect("a viewpoint");
    displaced(picture, &evidence, &right, &drawn).expect("viewpoints")
}

/// What may have moved a shadow is found, each by its own kind of ray, and explains it best.
#[test]
fn displacements_are_found() {
    let right = right("3c");
    for (kind, ray) in [
        (0, offset(0.1)),
        (0, offset(0.3)),
        (1, shift(0.4, -0.3)),
        (1, shift(-0.2, 0.0)),
        (1, shift(0.08, 0.08)),
        (2, light(-2.0, 1.5)),
    ] {
        let picture = picture(&with(ray), size(SIZE.0, SIZE.1));
        let evidence = whole(&picture, &Lossless);
        let rays = shadow_rays(&evidence, right).expect("viewpoints");
        let best = &rays[kind];
        assert_eq!(evidence.error(&best.recipe), Ok(best.error));
        assert!(rays.iter().all(|other| other.error >= best.error));
        let found = found(&picture);
        let code = [Code::OffsetTooLarge, Code::ShadowShifted][kind.min(1)];
        assert_eq!(found.faults(&right), [code]);
        for recipe in [best.recipe, found] {
            let found = recipe.viewpoint.shadow.expect("a shadow");
            is_near(found.offset, ray.offset, 0.03);
            for i in 0..2 {
                is_near(found.shift[i], ray.shift[i], 0.06);
                is_near(found.light[i], ray.light[i], 0.3);
            }
        }
    }
}

/// A picture without a displacement has none; nor has one without shadows, or with acne on the plane.
#[test]
fn exact_shadows_are_not_displaced() {
    let right = right("3c");
    for (drawn, start) in [
        (right, right),
        (with(offset(0.001)), right),
        (right, turned(&right, |r| r.viewpoint.shadow = None)),
        (with(shift(0.4, 0.0)), turned(&right, |r| r.acne[1] = true)),
        // What is guessed too large is taken back.
        (right, with(offset(0.1))),
    ] {
        let picture = picture(&drawn, size(SIZE.0, SIZE.1));
        let evidence = whole(&picture, &Lossless);
        let pixels = evidence.drawn(&start).expect("a viewpoint");
        let displaced = displaced(&picture, &evidence, &start, &pixels).expect("viewpoints");
        let mut expected = start;
        expected.viewpoint.shadow = start.viewpoint.shadow.map(|_| EXACT);
        assert_eq!(displaced, expected);
    }
}

/// Five in nine of the pixels that a displacement changes are enough to believe it; half of them are not:
/// then it explains no more than it spoils.
#[test]
fn a_displacement_explains_more_than_it_spoils() {
    let right = right("3c");
    let size = size(SIZE.0, SIZE.1);
    for ray in [offset(0.4), shift(0.4, -0.3), light(-2.0, 1.5)] {
        let [exact, moved] = [right, with(ray)].map(|recipe| picture(&recipe, size));
        for (part, is_believed) in [(0.53, false), (0.6, true)] {
            let found = found(&mixed(&exact, &moved, part, 5));
            assert_eq!(found != right, is_believed, "{ray:?} {part}");
        }
    }
}

/// It must change a dozen pixels of a picture as wide as the lab's, and fewer of a smaller one.
#[test]
fn a_displacement_must_show() {
    let gain = |width| least_gain(size(width, 40));
    let lab = gain(Size::LAB.width());
    assert!(12.0 * 40.0 < lab && lab < 12.0 * 64.0);
    assert_eq!(gain(10 * Size::LAB.width()), lab);
    assert_eq!(gain(Size::LAB.width() / 2), lab / 2.0);
    assert_eq!(gain(Size::LAB.width() / 4), lab / 4.0);
    assert_eq!(gain(32), lab / 4.0);
    let mut times = [0; 2];
    for step in 1..24 {
        let ray = offset(0.004 * f64::from(step));
        let [exact, moved] = [EXACT, ray].map(|ray| picture(&with(ray), size(SIZE.0, SIZE.1)));
        let pairs = exact.bytes().as_chunks::<3>().0.iter();
        let pairs = pairs.zip(moved.bytes().as_chunks::<3>().0);
        let gain: f64 = pairs
            .map(|(a, b)| f64::from(distance(*a, *b).min(64)))
            .sum();
        let is_found = found(&moved) != right("3c");
        let bar = least_gain(moved.size());
        // What is found explains nearly all of it.
        if gain < bar || gain > 1.5 * bar {
            assert_eq!(is_found, gain > bar, "{ray:?}: {gain}");
            times[usize::from(is_found)] += 1;
        }
    }
    assert!(times[0] > 2 && times[1] > 2, "{times:?}");
}

/// What a displacement does not explain is no gain, however much of it there is.
#[test]
fn other_errors_are_no_gain() {
    let right = right("3c");
    let mut times = 0;
    for width in 36..60 {
        let size = size(width, 64);
        let drawn = picture(&right, size);
        let drawn = whole(&drawn, &Lossless).drawn(&right).expect("a viewpoint");
        // Three pixels beside the shadow are of no colour that there is.
        let of_plane = drawn
            .iter()
            .enumerate()
            .filter(|(_, pixel)| pixel.object == Object::Plane);
        let plane: Vec<usize> = of_plane.map(|(at, _)| at).collect();
        let ends = plane
            .windows(2)
            .filter(|pair| drawn[pair[0]].is_lit && !drawn[pair[1]].is_lit);
        let beside: Vec<usize> = ends.map(|pair| pair[0]).take(3).collect();
        let ray = offset(0.02);
        let moved = changed(&picture(&with(ray), size), |at, rgb| {
            if beside.contains(&at) {
                [rgb[0], 60, 0]
            } else {
                rgb
            }
        });
        let evidence = whole(&moved, &Lossless);
        let error =
            |recipe: &Recipe| evidence.error(recipe).expect("a viewpoint") * size.pixels() as f64;
        let rest = error(&with(ray));
        let gain = error(&right) - rest;
        let is_worth = is_worth_a_walk(&evidence, right).expect("viewpoints");
        if is_worth && gain > 0.3 * rest && gain < 0.9 * least_gain(size) {
            assert_eq!(found(&moved), right, "{width}");
            times += 1;
        }
    }
    assert!(times > 4, "{times}");
}

/// A displacement must explain a fifth of what is wrong around the shadow.
#[test]
fn a_displacement_explains_a_fifth() {
    let (right, size) = (right("3c"), size(SIZE.0, SIZE.1));
    let exact = picture(&right, size);
    let drawn = whole(&exact, &Lossless).drawn(&right).expect("a viewpoint");
    let in_shadow = |at: usize| drawn[at].object == Object::Plane && !drawn[at].is_lit;
    let shadow: Vec<usize> = (0..drawn.len()).filter(|&at| in_shadow(at)).collect();
    for ray in [offset(0.15), offset(0.2)] {
        let moved = picture(&with(ray), size);
        let mut believed = [0; 2];
        for count in (0..90).step_by(6) {
            // Some pixels of the shadow are green.
            let green = &shadow[shadow.len() - count..];
            let seen = changed(
                &moved,
                |at, rgb| if green.contains(&at) { [0, 60, 0] } else { rgb },
            );
            let evidence = whole(&seen, &Lossless);
            let error = |recipe: &Recipe| evidence.error(recipe).expect("a viewpoint");
            let explained = 1.0 - error(&with(ray)) / error(&right);
            if (explained - 0.2).abs() > 0.02 {
                assert_eq!(found(&seen) != right, explained > 0.2, "{explained}");
                believed[usize::from(explained > 0.2)] += 1;
            }
        }
        assert!(believed.iter().all(|&times| times > 1), "{believed:?}");
    }
}

/// Offsets of less than a hundredth are what they are for: nobody sees them.
#[test]
fn small_offsets_are_right() {
    let large = size(900, 600);
    for (length, is_fault) in [(0.009, false), (0.015, true)] {
        let picture = picture(&with(offset(length)), large);
        let evidence = whole(&picture, &Lossless);
        // They change more than enough pixels.
        let gain = evidence.error(&right("3c")).expect("a viewpoint") * large.pixels() as f64;
        assert!(gain > least_gain(large), "{length}: {gain}");
        let faults = found(&picture).faults(&right("3c"));
        let expected = if is_fault {
            vec![Code::OffsetTooLarge]
        } else {
            vec![]
        };
        assert_eq!(faults, expected, "{length}");
    }
}

/// Wherever a shadow is displaced to, a small step toward there brings it nearer; an exact one is where
/// it should be.
#[test]
fn every_displacement_is_worth_a_walk() {
    let is_worth = |ray| {
        let picture = picture(&with(ray), size(SIZE.0, SIZE.1));
        let evidence = whole(&picture, &Lossless);
        is_worth_a_walk(&evidence, right("3c")).expect("viewpoints")
    };
    assert!(!is_worth(EXACT));
    for by in [0.1, 0.3, 0.6, 1.0] {
        for ray in [
            offset(by),
            shift(by, 0.0),
            shift(-by, 0.0),
            shift(0.0, by),
            shift(0.0, -by),
            light(20.0 * by, 0.0),
            light(-20.0 * by, 0.0),
            light(0.0, 20.0 * by),
            light(0.0, -20.0 * by),
        ] {
            assert!(is_worth(ray), "{ray:?}");
        }
    }
}

/// The region is the smallest around the plane's pixels that are in shadow, in the recipe or in the
/// picture.
#[test]
fn the_region_of_a_shadow() {
    let recipe = right("3c");
    let size = size(SIZE.0, SIZE.1);
    let right = picture(&recipe, size);
    let evidence = whole(&right, &Lossless);
    let drawn = evidence.drawn(&recipe).expect("a viewpoint");
    let region = shadow_region(&evidence, &recipe, &drawn).expect("a shadow");
    let has = |region: Region, (x, y): (u32, u32)| {
        let pixel = |(a, b)| (a, b) == (x, y);
        region.pixels().any(pixel)
    };
    let place = |at: usize| (at as u32 % SIZE.0, at as u32 / SIZE.0);
    let of_plane = |at: usize| drawn[at].object == Object::Plane;
    let dark: Vec<usize> = (0..drawn.len())
        .filter(|&at| of_plane(at) && !drawn[at].is_lit)
        .collect();
    assert!(dark.iter().all(|&at| has(region, place(at))));
    let edges = [
        |r: Region, (x, _): (u32, u32)| x == r.left,
        |r: Region, (_, y): (u32, u32)| y == r.top,
        |r: Region, (x, _): (u32, u32)| x + 1 == r.left + r.width,
        |r: Region, (_, y): (u32, u32)| y + 1 == r.top + r.height,
    ];
    for is_at_edge in edges {
        assert!(dark.iter().any(|&at| is_at_edge(region, place(at))));
    }
    // One more pixel, far from it: it counts where it is dark, and bright in the recipe.
    let outside = (0..drawn.len()).filter(|&at| !has(region, place(at)));
    for at in outside {
        let red = drawn[at].rgb[0];
        if at % 11 > 0 && red.abs_diff(40) > 1 {
            continue;
        }
        for (level, is_dark) in [(0, true), (11, true), (12, false), (60, false)] {
            let other = changed(
                &right,
                |place, rgb| if place == at { [level; 3] } else { rgb },
            );
            let other = whole(&other, &Lossless);
            let found = shadow_region(&other, &recipe, &drawn).expect("a shadow");
            let counts = is_dark && of_plane(at) && red > 40;
            assert_eq!(found != region, counts, "{:?} {red} {level}", place(at));
            assert!(!counts || has(found, place(at)));
        }
    }
    // Without a shadow there is none.
    let lit = turned(&recipe, |r| r.viewpoint.has_plane = false);
    let evidence = whole(&right, &Lossless);
    let drawn = evidence.drawn(&lit).expect("a viewpoint");
    assert_eq!(shadow_region(&evidence, &lit, &drawn), None);
}

/// Rectangles meet where one, made a pixel wider all around, shares one with the other.
#[test]
fn rectangles_meet() {
    let region = |left, top, width, height| Region {
        left,
        top,
        width,
        height,
    };
    let one = region(4, 5, 3, 2);
    let wider = region(3, 4, 5, 4);
    for left in 0..10 {
        for top in 0..10 {
            for (width, height) in [(1, 1), (2, 3), (9, 1), (1, 9)] {
                let other = region(left, top, width, height);
                let of_wider: Vec<_> = wider.pixels().collect();
                let shares = other.pixels().any(|pixel| of_wider.contains(&pixel));
                assert_eq!(one.meets(other), shares, "{other:?}");
                assert_eq!(other.meets(one), shares, "{other:?}");
            }
        }
    }
}
