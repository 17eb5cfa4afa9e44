//! Every level, packet width and number of threads computes the bits of the scalar path.

use fearless_simd::{Simd, dispatch};
use ombrage::*;
use proptest::prelude::*;
use std::fmt::Write;
use std::mem::discriminant;
use std::num::NonZero;

/// Runs `$run::<L, f32>(token, level, ...)` and the same for `f64`, at every SIMD level there is.
macro_rules! at_every_level {
    ($run:ident($($argument:expr),*)) => {
        for level in Level::available() {
            let Some(simd) = level.simd() else { continue };
            dispatch!(simd, token => {
                $run::<_, f32>(token, level, $($argument),*);
                $run::<_, f64>(token, level, $($argument),*);
            });
        }
    };
}

mod levels {
    mod words;
}

/// The bits, with one answer for all NaN: IEEE 754 leaves their sign and payload open.
fn bits<F: Float>(x: F) -> Option<u64> {
    (!x.to_f64().is_nan()).then(|| x.bits())
}

fn size(width: u32, height: u32) -> Size {
    Size::new(width, height).unwrap()
}

fn engine(level: Level, threads: usize) -> Engine {
    Engine::new(level, NonZero::new(threads)).unwrap()
}

/// A picture to be rendered in every way.
#[derive(Clone, Debug)]
struct Shot {
    scene: Scene<f64>,
    view: View<f64>,
    size: Size,
    integrator: Integrator,
    film: Film,
}

impl Shot {
    /// The first place where radiance differs, bit by bit.
    fn difference<F: Float>(&self, found: &[F::Vector], expected: &[F::Vector]) -> Option<String> {
        assert_eq!(found.len(), self.size.pixels());
        let width = self.size.width() as usize;
        let mut pairs = found.iter().zip(expected).enumerate();
        let (i, (&found, &expected)) = pairs.find(|(_, (found, expected))| {
            found.to_array().map(bits) != expected.to_array().map(bits)
        })?;
        let mut report = format!("column {}, row {}:", i % width, i / width);
        for (found, expected) in found.to_array().into_iter().zip(expected.to_array()) {
            let _ = write!(report, " {found:e} for {expected:e}");
        }
        Some(report)
    }

    /// Compares what one packet, and the engine's two in flight, compute with the scalar path.
    fn check<L: Simd, F: Lane>(&self, token: L, level: Level) {
        // A scene may be valid in `f64` and not in `f32`.
        let Ok(scene) = self.scene.cast::<F>() else {
            return;
        };
        let aspect = F::from_f64(self.size.aspect());
        let Ok(camera) = PerspectiveCamera::new(&self.view.cast(), aspect) else {
            return;
        };
        let integrator = self.integrator;
        let chain = LabChain {
            scene: &scene,
            camera: &camera,
            integrator,
        };
        self.check_chain(token, level, &chain);
        for lighting in [Lighting::Eye, Lighting::Unshadowed, Lighting::Shadowed] {
            let relative = Relative::<F>::new(&self.scene, &self.view, self.size, lighting);
            self.check_chain(token, level, &relative.unwrap());
        }
    }

    fn check_chain<L: Simd, F: Lane>(&self, token: L, level: Level, chain: &impl Chain<F>) {
        let Self { size, film, .. } = *self;
        let (scalar, packets) = (engine(Level::Scalar, 1), engine(level, 1));
        let expected = scalar.render_radiance(chain, size);
        let found = packets.render_radiance(chain, size);
        let name = std::any::type_name_of_val(chain);
        assert_eq!(
            self.difference::<F>(&found, &expected),
            None,
            "two packets of {name} at {level}"
        );

        let mut found = vec![F::Vector::constant((), [0.0; 3]); size.pixels()];
        let frame = Frame::new(chain, size);
        frame.rows::<Packet<L, F>, _>(token, &Linear, 0..size.height(), &mut found);
        assert_eq!(
            self.difference::<F>(&found, &expected),
            None,
            "one packet of {name} at {level}"
        );

        let expected = scalar.render(chain, size, film);
        let found = packets.render(chain, size, film);
        assert!(
            found == expected,
            "bytes of two packets of {name} at {level}"
        );
    }
}

fn check_shot<L: Simd, F: Lane>(token: L, level: Level, shot: &Shot) {
    shot.check::<L, F>(token, level);
}

fn lab_shot(figure: &Figure, size: Size) -> Shot {
    Shot {
        scene: lab::scene().unwrap(),
        view: lab::view(),
        size,
        integrator: figure.integrator,
        film: figure.film,
    }
}

#[test]
fn every_figure_has_the_scalars_bits_in_every_size() {
    for figure in FIGURES {
        for size in [size(1, 1), size(7, 5), size(33, 17), size(65, 3), Size::LAB] {
            at_every_level!(check_shot(&lab_shot(&figure, size)));
        }
    }
}

/// Engines of every level agree, and so do bytes and radiance of the default one.
#[test]
fn every_engine_draws_the_same_figure() {
    fn check<F: Float>() {
        let scene = lab::scene::<F>().unwrap();
        let camera = PerspectiveCamera::new(&lab::view(), F::from_f64(1.5)).unwrap();
        let figure = Figure::named("3a").unwrap();
        let Figure {
            integrator, film, ..
        } = *figure;
        let reference = engine(Level::Scalar, 1);
        let chain = LabChain {
            scene: &scene,
            camera: &camera,
            integrator,
        };
        let bytes = reference.render(&chain, Size::LAB, film);
        let radiance = reference.render_radiance(&chain, Size::LAB);
        assert_eq!(render(&chain, Size::LAB, film), bytes);
        assert!(render_radiance(&chain, Size::LAB) == radiance);
        for level in Level::available() {
            for threads in [1, 2, 3, 64] {
                let engine = engine(level, threads);
                let found = engine.render(&chain, Size::LAB, film);
                assert!(found == bytes, "bytes at {level} with {threads} threads");
                let found = engine.render_radiance(&chain, Size::LAB);
                assert!(
                    found == radiance,
                    "radiance at {level} with {threads} threads"
                );
            }
        }
    }
    check::<f32>();
    check::<f64>();
}

#[test]
fn threads_do_not_change_small_pictures() {
    let camera = PerspectiveCamera::new(&lab::view::<f32>(), 1.0).unwrap();
    let scene = lab::scene::<f32>().unwrap();
    let Figure {
        integrator, film, ..
    } = *Figure::named("3c").unwrap();
    let chain = LabChain {
        scene: &scene,
        camera: &camera,
        integrator,
    };
    for size in [size(1, 1), size(1, 40), size(40, 1), size(9, 17)] {
        let one = engine(Level::best(), 1).render(&chain, size, film);
        for threads in 1..9 {
            let many = engine(Level::best(), threads);
            assert_eq!(many.threads(size), threads);
            assert_eq!(many.render(&chain, size, film), one);
            let mut other = Picture::from_fn(size, |x, y| [x as u8, y as u8, 77]);
            many.render_into(&chain, film, &mut other);
            assert_eq!(other, one, "over another picture");
            let rows = size.height() / 3..size.height().div_ceil(2);
            let [start, end] = [rows.start, rows.end].map(|row| (3 * row * size.width()) as usize);
            let some = many.render_rows(&chain, size, film, rows);
            assert_eq!(some.as_flattened(), &one.bytes()[start..end], "some rows");
        }
    }
}

#[test]
fn a_level_that_the_processor_lacks_is_an_error_that_lists_what_there_is() {
    let absent = Level::ALL.into_iter().find(|level| !level.is_available());
    let absent = absent.expect("no processor is both x86 and ARM");
    let error = Engine::new(absent, None).unwrap_err();
    assert_eq!(error, NoSuchLevel(absent.name().to_owned()));
    let names: Vec<_> = Level::available().map(Level::name).collect();
    let expected = format!(
        "level is {absent:?}, but must be auto, {}: this processor has no other",
        names.join(", "),
        absent = absent.name()
    );
    assert_eq!(error.to_string(), expected);
    assert!("avx3".parse::<Level>().is_err());
}

/// The standard library knows the processor too. A level asks for more than its name says: for what
/// came with it.
#[test]
#[cfg(target_arch = "x86_64")]
fn levels_are_those_of_the_processor() {
    use std::arch::is_x86_feature_detected as has;
    let avx2 = has!("avx2") && has!("fma") && has!("bmi2") && has!("f16c") && has!("lzcnt");
    let ice_lake = avx2 && has!("avx512vbmi2") && has!("avx512vpopcntdq") && has!("avx512vl");
    for (level, there) in [
        (Level::Scalar, true),
        (Level::Fallback, true),
        (Level::Sse2, true),
        (Level::Sse4_2, has!("sse4.2") && has!("popcnt")),
        (Level::Avx2, avx2),
        (Level::Avx512, ice_lake),
        (Level::Neon, false),
    ] {
        assert_eq!(level.is_available(), there, "{level}");
        assert_eq!(
            level.simd().is_some(),
            there && level != Level::Scalar,
            "{level}"
        );
    }
    assert_eq!(Some(Level::best()), Level::available().next_back());
    let best = Level::best().simd().as_ref().map(discriminant);
    let processors = fearless_simd::Level::new();
    assert_eq!(best, Some(discriminant(&processors)), "{processors:?}");
}

#[test]
fn a_level_is_read_from_its_name() {
    for level in Level::ALL {
        assert_eq!(level.to_string().parse(), Ok(level));
    }
    assert_eq!("auto".parse(), Ok(Level::best()));
    assert_eq!(Engine::default().level(), Level::best());
}

/// Coordinates near the camera, at times on a grid that makes hits exact, at times far or tiny.
fn coordinate() -> impl Strategy<Value = f64> {
    prop_oneof![
        6 => -4.0..4.0,
        2 => (-4i8..=4).prop_map(f64::from),
        1 => (-1.0..1.0, -46i32..20).prop_map(|(x, e)| x * 10f64.powi(e)),
    ]
}

fn vector() -> impl Strategy<Value = glam::DVec3> {
    [coordinate(), coordinate(), coordinate()].prop_map(glam::DVec3::from_array)
}

fn length() -> impl Strategy<Value = f64> {
    prop_oneof![6 => 0.1..6.0, 1 => (0.1..1.0, -44i32..12).prop_map(|(x, e)| x * 10f64.powi(e))]
}

fn color() -> impl Strategy<Value = glam::DVec3> {
    [0.0..1.5, 0.0..1.5, 0.0..1.5].prop_map(glam::DVec3::from_array)
}

fn integrator() -> impl Strategy<Value = Integrator> {
    let shadow = prop_oneof![
        1 => Just(None),
        7 => prop::sample::select(Shadow::ALL.as_slice()).prop_map(Some),
    ];
    let query = prop_oneof![Just(ShadowQuery::Nearest), Just(ShadowQuery::Any)];
    let quality = prop::sample::select(Quality::ALL.as_slice());
    (quality, shadow, query, 0..8).prop_map(|(quality, shadow, query, lights)| match lights {
        0 => Integrator::RayCast(quality),
        _ => Integrator::DirectLighting(DirectLighting {
            quality,
            shadow,
            query,
        }),
    })
}

prop_compose! {
    /// Up to five spheres, three planes and three lights; the camera may be inside a sphere.
    fn scene()(
        background in color(),
        t_max in prop_oneof![Just(f64::INFINITY), 1.0..1e4],
        spheres in prop::collection::vec((vector(), length(), color()), 0..6),
        planes in prop::collection::vec((vector(), vector(), color()), 0..4),
        lights in prop::collection::vec((vector(), color(), 0.0..200.0), 0..4),
    ) -> Scene<f64> {
        let mut scene = Scene::new(background, t_max).unwrap();
        for (center, radius, color) in spheres {
            scene = scene.with_sphere(Sphere::new(center, radius).unwrap(), color).unwrap();
        }
        for (point, normal, color) in planes {
            if let Ok(plane) = Plane::new(point, normal) {
                scene = scene.with_plane(plane, color).unwrap();
            }
        }
        for (position, color, power) in lights {
            scene = scene.with_light(PointLight::new(position, color, power).unwrap());
        }
        scene
    }
}

prop_compose! {
    fn shot()(
        scene in scene(),
        position in vector(),
        look_at in vector(),
        fov in 20.0..150.0,
        size in prop_oneof![Just(size(7, 5)), Just(size(33, 17)), Just(size(65, 3)), Just(size(40, 30))],
        integrator in integrator(),
        film in prop_oneof![Just(Film::Clamp), Just(Film::Wrap)],
    ) -> Shot {
        let view = View { position, look_at, up: glam::dvec3(0.1, 1.0, 0.05), fov };
        Shot { scene, view, size, integrator, film }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]

    #[test]
    fn any_scene_has_the_scalars_bits(shot in shot()) {
        at_every_level!(check_shot(&shot));
    }
}
