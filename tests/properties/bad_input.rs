//! What no scene, camera or picture can be made with is refused by name; nothing panics.

use crate::property::{Sample, any_number, any_vector, for_all};
use ombrage::{
    DirectLighting, FIGURES, Figure, Film, Integrator, Invalid, LabChain, PerspectiveCamera, Plane,
    PointLight, Quality, Scene, Shadow, ShadowQuery, Shape, Size, Sphere, Vector, View, lab,
    render,
};
use proptest::prelude::*;

const NOT_FINITE: [f64; 3] = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY];

/// The message names the field and the value and says what it must be, in one line.
pub fn refused<T>(result: Result<T, Invalid>, field: &str, value: &str) {
    let Err(error) = result else {
        panic!("{field} {value} is accepted")
    };
    assert_eq!((error.field, error.value.as_str()), (field, value));
    let words = error.to_string();
    assert_eq!(
        words,
        format!("{field} is {value}, but must be {}", error.must_be)
    );
    assert!(
        !error.must_be.is_empty() && words.lines().count() == 1,
        "{words}"
    );
}

fn vector<F: Sample>(components: [f64; 3]) -> F::Vector {
    F::Vector::constant((), components)
}

/// Every vector with one of these values in one component, as messages show it.
fn spoilt(good: f64, values: &[f64]) -> Vec<([f64; 3], String)> {
    let mut spoilt = vec![];
    for &value in values {
        for axis in 0..3 {
            let v: [f64; 3] = std::array::from_fn(|i| if i == axis { value } else { good });
            spoilt.push((v, format!("({}, {}, {})", v[0], v[1], v[2])));
        }
    }
    spoilt
}

/// Values that no colour has.
fn no_color() -> Vec<([f64; 3], String)> {
    spoilt(0.5, &[f64::NAN, f64::INFINITY, f64::NEG_INFINITY, -0.25])
}

pub fn shapes_are_refused_by_field_and_value<F: Sample>() {
    let (zero, up) = (vector::<F>([0.0; 3]), vector::<F>([0.0, 1.0, 0.0]));
    for (v, text) in spoilt(1.0, &NOT_FINITE) {
        refused(Plane::<F>::new(vector::<F>(v), up), "plane point", &text);
        refused(Plane::<F>::new(zero, vector::<F>(v)), "plane normal", &text);
        refused(
            Sphere::new(vector::<F>(v), F::from_f64(1.0)),
            "sphere center",
            &text,
        );
    }
    refused(Plane::<F>::new(zero, zero), "plane normal", "(0, 0, 0)");
    // A length whose square overflows or underflows is as good as any.
    for exponent in if F::PRECISION == 24 {
        [64, -80]
    } else {
        [512, -600]
    } {
        let length = f64::from(exponent).exp2();
        let plane = Plane::<F>::new(zero, vector::<F>([0.0, length, 0.0]));
        let normal = plane.map(|plane| plane.normal_at::<F>(zero));
        assert_eq!(normal, Ok(vector::<F>([0.0, 1.0, 0.0])), "of {length}");
    }
    for radius in [0.0, -0.0, -1.0, f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let sphere = Sphere::<F>::new(zero, F::from_f64(radius));
        refused(sphere, "sphere radius", &radius.to_string());
    }
}

pub fn lights_are_refused_by_field_and_value<F: Sample>() {
    let (zero, white) = (vector::<F>([0.0; 3]), vector::<F>([1.0; 3]));
    for (v, text) in spoilt(1.0, &NOT_FINITE) {
        let light = PointLight::<F>::new(vector::<F>(v), white, F::from_f64(1.0));
        refused(light, "light position", &text);
    }
    for (v, text) in no_color() {
        let light = PointLight::<F>::new(zero, vector::<F>(v), F::from_f64(1.0));
        refused(light, "light color", &text);
    }
    for power in [-1.0, f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let light = PointLight::<F>::new(zero, white, F::from_f64(power));
        refused(light, "light power", &power.to_string());
    }
}

pub fn scenes_are_refused_by_field_and_value<F: Sample>() {
    let lab = lab::scene::<F>().expect("the lab's scene is valid");
    let (sphere, plane) = (lab.spheres()[0].shape, lab.planes()[0].shape);
    for (v, text) in no_color() {
        let color = vector::<F>(v);
        refused(Scene::<F>::new(color, lab.t_max()), "background", &text);
        refused(
            lab.clone().with_sphere(sphere, color),
            "sphere color",
            &text,
        );
        refused(lab.clone().with_plane(plane, color), "plane color", &text);
    }
    for t_max in [0.0, -1.0, f64::NAN, f64::NEG_INFINITY] {
        let scene = Scene::<F>::new(lab.background(), F::from_f64(t_max));
        refused(scene, "t_max", &t_max.to_string());
    }
    assert!(Scene::<F>::new(lab.background(), F::from_f64(f64::INFINITY)).is_ok());
}

pub fn cameras_are_refused_by_field_and_value<F: Sample>() {
    let good = lab::view::<F>();
    let camera = |view: View<F>| PerspectiveCamera::new(&view, F::from_f64(1.5));
    assert!(camera(good).is_ok());
    for (v, text) in spoilt(1.0, &NOT_FINITE) {
        let v = vector::<F>(v);
        refused(
            camera(View {
                position: v,
                ..good
            }),
            "camera position",
            &text,
        );
        refused(camera(View { look_at: v, ..good }), "camera look_at", &text);
        refused(camera(View { up: v, ..good }), "camera up", &text);
    }
    refused(
        camera(View {
            look_at: good.position,
            ..good
        }),
        "camera look_at",
        "(0, 0, -2)",
    );
    refused(
        camera(View {
            up: vector::<F>([0.0; 3]),
            ..good
        }),
        "camera up",
        "(0, 0, 0)",
    );
    refused(
        camera(View {
            up: vector::<F>([0.0, 0.0, -3.0]),
            ..good
        }),
        "camera up",
        "(0, 0, -3)",
    );
    let far = (if F::PRECISION == 24 { 64f64 } else { 512.0 }).exp2();
    let view = View {
        look_at: vector::<F>([0.0, 0.0, far]),
        ..good
    };
    assert_eq!(
        camera(view),
        camera(good),
        "the distance of look_at matters"
    );
    for fov in [0.0, -60.0, 180.0, 270.0, f64::NAN, f64::INFINITY] {
        let view = View {
            fov: F::from_f64(fov),
            ..good
        };
        refused(camera(view), "camera fov", &fov.to_string());
    }
    for aspect in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let camera = PerspectiveCamera::new(&good, F::from_f64(aspect));
        refused(camera, "aspect", &aspect.to_string());
    }
}

/// Any bits at all in every field: what is accepted is drawn, in each of the integrators and films.
pub fn no_bits_make_the_kit_panic<F: Sample>() {
    let (v, x) = (any_vector::<F>, any_number::<F>);
    let shapes = (v(), x(), v(), v(), v(), v());
    let view = (v(), v(), v(), x(), x());
    for_all(
        (shapes, (v(), v(), x()), (v(), x()), view),
        |(shapes, light, scene, view)| {
            let (center, radius, point, normal, blue, red) = shapes;
            let (position, look_at, up, fov, aspect) = view;
            let lab = |error: Invalid| TestCaseError::fail(error.to_string());
            // A refused part leaves the rest of the scene to be drawn.
            let mut built = Scene::new(scene.0, scene.1)
                .or_else(|_| lab::scene())
                .map_err(lab)?;
            if let Ok(sphere) = Sphere::new(center, radius) {
                built = built.clone().with_sphere(sphere, blue).unwrap_or(built);
            }
            if let Ok(plane) = Plane::new(point, normal) {
                built = built.clone().with_plane(plane, red).unwrap_or(built);
            }
            if let Ok(light) = PointLight::new(light.0, light.1, light.2) {
                built = built.with_light(light);
            }
            let view = View {
                position,
                look_at,
                up,
                fov,
            };
            let camera = PerspectiveCamera::new(&view, aspect)
                .or_else(|_| PerspectiveCamera::new(&lab::view(), F::from_f64(1.5)));
            let (camera, size) = (camera.map_err(lab)?, Size::new(7, 5).map_err(lab)?);
            let (scene, camera) = (&built, &camera);
            for Figure {
                integrator, film, ..
            } in FIGURES
            {
                render(
                    &LabChain {
                        scene,
                        camera,
                        integrator,
                    },
                    size,
                    film,
                );
            }
            let integrator = Integrator::DirectLighting(DirectLighting {
                quality: Quality::Textbook,
                shadow: Some(Shadow::UlpOffset),
                query: ShadowQuery::Nearest,
            });
            let picture = render(
                &LabChain {
                    scene,
                    camera,
                    integrator,
                },
                size,
                Film::Wrap,
            );
            prop_assert_eq!(picture.bytes().len(), 3 * 7 * 5);
            Ok(())
        },
    );
}

/// Every figure in sizes that are not the lab's, one pixel wide or high among them.
pub fn figures_of_any_size_are_drawn<F: Sample>() {
    for_all((1..20u32, 1..20u32), |(width, height)| {
        let size =
            Size::new(width, height).map_err(|error| TestCaseError::fail(error.to_string()))?;
        for figure in FIGURES {
            let picture = figure
                .draw::<F>(size)
                .map_err(|error| TestCaseError::fail(error.to_string()))?;
            prop_assert_eq!(picture.bytes().len(), 3 * size.pixels());
        }
        Ok(())
    });
}
