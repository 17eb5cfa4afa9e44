//! The six figures: accepted pictures, accepted counts, and what exact arithmetic says of them.
//!
//! A picture that changes on purpose is accepted with `cargo insta review`.

mod support {
    pub mod snapshot;
}

use ombrage::{
    Counts, Detail, DirectLighting, DoubleDouble, FIGURES, Figure, Float, Integrator, LabChain,
    Picture, Pixel, Quality, Scalar, Shadow, ShadowQuery, Size, Survey, Vector, lab,
    render_radiance,
};
use std::sync::LazyLock;
use support::snapshot;

fn figure(name: &str) -> &'static Figure {
    Figure::named(name).expect("one of the six figures")
}

fn draw<S: Scalar>(name: &str) -> Picture {
    figure(name)
        .draw::<S>(Size::LAB)
        .expect("the lab's scene is valid")
}

fn survey<S: Scalar>(name: &str) -> Survey {
    figure(name)
        .survey::<S>(Size::LAB)
        .expect("the lab's scene is valid")
}

/// Figure 3(c) in exact arithmetic, as near as makes no difference.
static TRUTH: LazyLock<Survey> = LazyLock::new(|| survey::<DoubleDouble>("3c"));

/// The picture is the accepted one, pixel for pixel.
///
/// In Figures 3(a) and 3(b) the black pixels are rounding errors. A change in the order of
/// operations may move them, and then the new picture is accepted after a look at it. How many
/// there are hardly changes: `acne_covers_...` holds their shares to bands, which they may not
/// leave.
fn is_the_accepted_picture<F: Float>(name: &str) {
    let name = format!("figure-{name}-{}.png", F::NAME);
    let figure = figure(name.split('-').nth(1).expect("the name of a figure"));
    let picture = figure
        .draw::<F>(Size::LAB)
        .expect("the lab's scene is valid");
    snapshot::picture_settings(&name).bind(|| {
        insta::assert_binary_snapshot!(&name, snapshot::png(&picture));
    });
}

macro_rules! for_both_floats {
    ($($name:ident)*) => {
        mod f32 {
            $(#[test] fn $name() { super::$name::<core::primitive::f32>() })*
        }
        mod f64 {
            $(#[test] fn $name() { super::$name::<core::primitive::f64>() })*
        }
    };
}

macro_rules! accepted_pictures {
    ($($test:ident: $figure:literal)*) => {
        $(fn $test<F: Float>() { is_the_accepted_picture::<F>($figure) })*
    };
}

accepted_pictures! {
    figure_1_is_the_accepted_picture: "1"
    figure_2a_is_the_accepted_picture: "2a"
    figure_2b_is_the_accepted_picture: "2b"
    figure_3a_is_the_accepted_picture_acne_may_move: "3a"
    figure_3b_is_the_accepted_picture_acne_may_move: "3b"
    figure_3c_is_the_accepted_picture: "3c"
}

for_both_floats! {
    figure_1_is_the_accepted_picture
    figure_2a_is_the_accepted_picture
    figure_2b_is_the_accepted_picture
    figure_3a_is_the_accepted_picture_acne_may_move
    figure_3b_is_the_accepted_picture_acne_may_move
    figure_3c_is_the_accepted_picture
    sphere_shows_on_15644_pixels_and_plane_on_111720
    plane_is_in_the_shadow_on_7587_pixels_of_3c
    lit_pixels_of_3c_are_those_that_are_not_black
    bytes_wrap_on_335_pixels_of_2a
    radiance_passes_1_on_344_sphere_pixels
    largest_level_is_296
    background_is_127_through_row_200_and_plane_starts_at_row_201
    pictures_are_those_of_exact_arithmetic
    acne_covers_84_to_86_percent_of_the_lit_plane
    acne_covers_48_to_62_percent_of_the_lit_sphere
    figure_3c_has_no_acne
    figure_3c_is_the_same_by_any_hit_and_by_nearest_hit
}

#[test]
fn counts_of_all_figures_are_the_accepted_ones() {
    let columns = [
        "sphere",
        "plane",
        "shadowed",
        "wrapped",
        "acne plane",
        "acne sphere",
        "level",
    ];
    let mut table = row("figure", "format", &columns.map(String::from));
    for figure in &FIGURES {
        for (format, survey) in [
            ("f32", survey::<f32>(figure.name)),
            ("f64", survey::<f64>(figure.name)),
        ] {
            let counts = survey.counts();
            let Counts {
                sphere,
                plane,
                shadowed,
                wrapped,
                acne_plane,
                acne_sphere,
                ..
            } = counts;
            let counted = [sphere, plane, shadowed, wrapped, acne_plane, acne_sphere];
            let mut cells: Vec<String> = counted.iter().map(usize::to_string).collect();
            cells.push(counts.largest_level.to_string());
            table.push_str(&row(figure.name, format, &cells));
        }
    }
    snapshot::settings().bind(|| insta::assert_snapshot!("counts", table));
}

/// A line of the table of counts.
fn row(figure: &str, format: &str, cells: &[String]) -> String {
    let cells: String = cells.iter().map(|cell| format!("{cell:>13}")).collect();
    format!("{figure:<7}{format:<6}{cells}\n")
}

fn sphere_shows_on_15644_pixels_and_plane_on_111720<F: Float>() {
    for Figure { name, .. } in &FIGURES {
        let counts = survey::<F>(name).counts();
        assert_eq!(
            (counts.sphere, counts.plane),
            (15_644, 111_720),
            "figure {name}"
        );
    }
}

fn plane_is_in_the_shadow_on_7587_pixels_of_3c<F: Float>() {
    let survey = survey::<F>("3c");
    let shadowed = |pixel: &&Pixel| pixel.on_plane() && pixel.blocked_by_another;
    assert_eq!(survey.pixels().iter().filter(shadowed).count(), 7587);
}

fn bytes_wrap_on_335_pixels_of_2a<F: Float>() {
    let survey = survey::<F>("2a");
    let wraps = |pixel: &&Pixel| pixel.is_too_bright();
    assert_eq!(survey.pixels().iter().filter(wraps).count(), 335);
    let (wrapped, clamped) = (draw::<F>("2a"), draw::<F>("2b"));
    let differ = |(a, b): &(&[u8], &[u8])| a != b;
    let pixels = wrapped.bytes().chunks(3).zip(clamped.bytes().chunks(3));
    assert_eq!(
        pixels.filter(differ).count(),
        335,
        "pixels that differ between 2a and 2b"
    );
}

/// The radiance of every pixel of a figure.
fn radiance<F: Float>(name: &str) -> impl Iterator<Item = [f64; 3]> {
    let scene = lab::scene::<F>().expect("the lab's scene is valid");
    let aspect = F::from_f64(Size::LAB.aspect());
    let camera = ombrage::PerspectiveCamera::new(&lab::view::<F>(), aspect);
    let chain = LabChain {
        scene: &scene,
        camera: &camera.expect("the lab's view is valid"),
        integrator: figure(name).integrator,
    };
    let pixels = render_radiance(&chain, Size::LAB).into_iter();
    pixels.map(|radiance| radiance.to_array().map(Scalar::to_f64))
}

/// Where no shadow ray errs, what is lit is what sends light back.
fn lit_pixels_of_3c_are_those_that_are_not_black<F: Float>() {
    let survey = survey::<F>("3c");
    let mut lit = [0; 2];
    for (pixel, radiance) in survey.pixels().iter().zip(radiance::<F>("3c")) {
        let shines = pixel.object.is_some() && radiance != [0.0; 3];
        lit[usize::from(pixel.on_sphere)] += usize::from(shines);
    }
    let counts = survey.counts();
    assert_eq!([counts.lit_plane, counts.lit_sphere], lit);
}

fn radiance_passes_1_on_344_sphere_pixels<F: Float>() {
    let (mut sphere, mut other) = (0, 0);
    for [red, green, blue] in radiance::<F>("2b") {
        sphere += usize::from(blue > 1.0);
        other += usize::from(red > 1.0 || green > 1.0);
    }
    assert_eq!((sphere, other), (344, 0));
}

fn largest_level_is_296<F: Float>() {
    assert_eq!(survey::<F>("2a").counts().largest_level, 296);
}

/// Row 200 looks just below the horizon, where the plane is beyond t = 1000.
fn background_is_127_through_row_200_and_plane_starts_at_row_201<F: Float>() {
    for name in ["1", "2a", "2b", "3c"] {
        let (picture, survey) = (draw::<F>(name), survey::<F>(name));
        let rows: Vec<_> = survey.pixels().chunks(600).collect();
        let beside_the_sphere = (0..600).filter(|&x| !rows[200][x].on_sphere);
        for (count, x) in beside_the_sphere.enumerate() {
            assert_eq!(
                picture.pixel(x as u32, 200),
                Some([127; 3]),
                "figure {name}, column {x}"
            );
            assert!(
                count > 0 || x == 0,
                "figure {name} starts row 200 with the sphere"
            );
        }
        for x in (0..600).filter(|&x| !rows[201][x].on_sphere) {
            let shows_plane = rows[201][x].on_plane();
            assert!(shows_plane, "figure {name}, column {x}, row 201");
        }
        assert!(
            rows[..200]
                .iter()
                .all(|row| !row.iter().any(Pixel::on_plane))
        );
    }
}

/// In `f64` every byte, in `f32` all but 10.
fn pictures_are_those_of_exact_arithmetic<F: Float>() {
    let allowed = if F::PRECISION == 24 { 10 } else { 0 };
    for name in ["1", "2b", "3c"] {
        let (picture, truth) = (draw::<F>(name), draw::<DoubleDouble>(name));
        let bytes = picture.bytes().iter().zip(truth.bytes());
        let wrong = bytes.filter(|(a, b)| a != b).count();
        assert!(
            wrong <= allowed,
            "figure {name}: {wrong} bytes are wrong, {allowed} may be"
        );
    }
}

/// Of the `count` pixels that exact arithmetic lights and for which `shown` holds, the share that
/// is acne in Figure 3(a), in percent.
fn acne_percent<F: Float>(count: usize, shown: impl Fn(&Pixel) -> bool) -> f64 {
    let lit = |pixel: &Pixel| {
        shown(pixel) && pixel.faces_light && !pixel.blocked_by_another && !pixel.is_acne()
    };
    let survey = survey::<F>("3a");
    let pairs = TRUTH
        .pixels()
        .iter()
        .zip(survey.pixels())
        .filter(|(truth, _)| lit(truth));
    let acne: Vec<bool> = pairs.map(|(_, pixel)| pixel.is_acne()).collect();
    assert_eq!(acne.len(), count, "pixels that exact arithmetic lights");
    100.0 * acne.iter().filter(|&&is| is).count() as f64 / count as f64
}

fn acne_covers_84_to_86_percent_of_the_lit_plane<F: Float>() {
    let percent = acne_percent::<F>(104_133, Pixel::on_plane);
    assert!((84.0..=86.0).contains(&percent), "{percent} %");
}

fn acne_covers_48_to_62_percent_of_the_lit_sphere<F: Float>() {
    let percent = acne_percent::<F>(8633, |pixel| pixel.on_sphere);
    assert!((48.0..=62.0).contains(&percent), "{percent} %");
}

fn figure_3c_has_no_acne<F: Float>() {
    let counts = survey::<F>("3c").counts();
    assert_eq!((counts.acne_plane, counts.acne_sphere), (0, 0));
}

fn figure_3c_is_the_same_by_any_hit_and_by_nearest_hit<F: Float>() {
    let by = |query| {
        let shadow = Some(Shadow::UlpOffset);
        let integrator = Integrator::DirectLighting(DirectLighting {
            quality: Quality::Textbook,
            shadow,
            query,
        });
        let figure = Figure {
            integrator,
            ..*figure("3c")
        };
        figure
            .draw::<F>(Size::LAB)
            .expect("the lab's scene is valid")
    };
    let any = by(ShadowQuery::Any);
    assert!(any == by(ShadowQuery::Nearest), "the two pictures differ");
    assert!(any == draw::<F>("3c"), "Figure 3(c) is another picture");
}

/// A detail that begins at the far edge is moved back into the picture, whatever its size.
#[test]
fn details_stay_in_the_picture() {
    for (width, height) in [(600, 400), (1, 1), (7, 5), (1280, 800)] {
        let size = Size::new(width, height).expect("a size");
        for (left_percent, top_percent) in [(0, 0), (50, 99), (100, 100), (93, 7)] {
            for factor in [1, 3, 8] {
                let detail = Detail {
                    left_percent,
                    top_percent,
                    factor,
                    gain: 1,
                };
                let [left, top, wide, high] = detail.region(size);
                assert!(left + wide <= width && top + high <= height, "{detail:?}");
                assert_eq!(
                    (wide, high),
                    (width.div_ceil(factor), height.div_ceil(factor))
                );
            }
        }
    }
}
