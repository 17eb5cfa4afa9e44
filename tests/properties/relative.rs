//! The kit's own chain, where it decides by the sides of surfaces: a camera or a light on one, and a
//! light much nearer to what it shines on than to the camera.

use crate::property::for_all;
use glam::DVec3;
use ombrage::{
    Chain, Invalid, Lighting, Plane, PointLight, Relative, Scalar, Scene, Size, Sphere, Vector,
    View,
};
use proptest::prelude::*;
use proptest::test_runner::TestCaseError;
use std::cell::Cell;

fn valid<T>(result: Result<T, Invalid>) -> Result<T, TestCaseError> {
    result.map_err(|invalid| TestCaseError::reject(invalid.to_string()))
}

/// A point whose sums with others like it are exact.
fn point() -> impl Strategy<Value = DVec3> + Clone {
    [-256..256i32, -256..256, -256..256].prop_map(|p| DVec3::from(p.map(f64::from)) / 64.0)
}

fn view(position: DVec3, look_at: DVec3, fov: f64) -> View<f64> {
    View {
        position,
        look_at,
        up: DVec3::new(0.3, 1.0, 0.2),
        fov,
    }
}

/// The radiance of every pixel with its direction, row by row.
fn pixels<S: Scalar>(
    scene: &Scene<f64>,
    view: &View<f64>,
    size: Size,
) -> Result<Vec<(DVec3, DVec3)>, TestCaseError> {
    let chain = valid(Relative::<S>::new(scene, view, size, Lighting::Shadowed))?;
    let down = (0..size.height()).map(|row| Relative::<S>::coordinate(row, size.height()));
    let across = (0..size.width()).map(|column| Relative::<S>::coordinate(column, size.width()));
    let places = down.flat_map(|down| across.clone().map(move |across| (across, down)));
    let pixel = |(across, down)| {
        let direction = chain.across::<S>(across) + chain.down::<S>(down);
        let radiance = chain.radiance::<S>(across, down);
        (to_f64::<S>(direction), to_f64::<S>(radiance))
    };
    Ok(places.map(pixel).collect())
}

fn to_f64<S: Scalar>(vector: S::Vector) -> DVec3 {
    DVec3::from(vector.to_array().map(Scalar::to_f64))
}

/// A plane through the camera with this normal, or a sphere of so many times its length.
fn through(camera: DVec3, normal: DVec3, scale: Option<f64>) -> Result<Scene<f64>, Invalid> {
    let scene = Scene::new(DVec3::ZERO, f64::INFINITY)?;
    match scale {
        Some(scale) => scene.with_sphere(
            Sphere::new(camera - normal * scale, normal.length() * scale)?,
            DVec3::ONE,
        ),
        None => scene.with_plane(Plane::new(camera, normal)?, DVec3::ONE),
    }
}

/// A camera on a surface sees to either side what a camera a hair's breadth away on that side does.
pub fn a_surface_through_the_camera_parts_what_it_sees() {
    let size = Size::new(12, 8).expect("a size");
    let scale = prop_oneof![
        Just(None),
        (1..32u8).prop_map(|n| Some(f64::from(n) / 32.0))
    ];
    let parts = ([point(), point(), point(), point()], scale);
    let lit = Cell::new([0; 2]);
    for_all(parts, |([camera, normal, look_at, light], scale)| {
        // 2² + 3² + 6² = 7²: the camera is on the sphere exactly.
        let normal = DVec3::new(2.0, 3.0, 6.0).copysign(normal);
        let scene = valid(through(camera, normal, scale))?;
        // Something to see on every side.
        let around = valid(Sphere::new(DVec3::splat(0.1), 16.0))?;
        let scene = valid(scene.with_sphere(around, DVec3::ONE))?;
        let scene = scene.with_light(valid(PointLight::new(light, DVec3::ONE, 100.0))?);
        let [inner, on, outer] = [-1e-12, 0.0, 1e-12].map(|by| {
            let position = camera + normal.normalize() * by;
            pixels::<f64>(&scene, &view(position, look_at, 90.0), size)
        });
        for ((inner, on), outer) in inner?.iter().zip(on?).zip(outer?) {
            let (direction, radiance) = on;
            let slope = direction.normalize().dot(normal.normalize());
            if slope.abs() < 1e-3 {
                continue;
            }
            let (side, (_, beside)) = if slope > 0.0 { (1, outer) } else { (0, *inner) };
            let off = (radiance - beside).abs().max_element();
            prop_assert!(
                off <= 1e-6 * beside.max_element() + 1e-9,
                "{radiance} along {direction}, beside it {beside}"
            );
            let mut counts = lit.get();
            counts[side] += u32::from(radiance != DVec3::ZERO);
            lit.set(counts);
        }
        Ok(())
    });
    assert!(lit.get().iter().all(|&count| count > 500), "{lit:?}");
}

/// Exactly in it, whatever its directions: nothing of the plane faces the light.
pub fn a_light_in_a_plane_lights_neither_side() {
    let size = Size::new(4, 4).expect("a size");
    let whole = || [-9..10i32, -9..10, -9..10].prop_map(|p| DVec3::from(p.map(f64::from)));
    for_all(
        (point(), whole(), whole(), point()),
        |(on_plane, normal, along, camera)| {
            // Products and sums of few digits: nothing is rounded.
            let light = on_plane + normal.cross(along);
            let scene = valid(Scene::new(DVec3::ZERO, f64::INFINITY))?;
            let plane = valid(Plane::new(on_plane, normal))?;
            let scene = valid(scene.with_plane(plane, DVec3::ONE))?;
            let scene = scene.with_light(valid(PointLight::new(light, DVec3::ONE, 1e9))?);
            let view = view(camera, on_plane, 90.0);
            for (direction, radiance) in pixels::<f64>(&scene, &view, size)? {
                prop_assert_eq!(radiance, DVec3::ZERO, "along {}", direction);
            }
            Ok(())
        },
    );
}

/// At distance D the hit is off by some u D, so the normal of a sphere of radius r by u D / r, and so
/// is the cosine, if the light's height is taken from the center: the way from the camera to the
/// light would turn that into u D² / r over the light's own distance. The radiance has the cosine up to 4
/// times; 36 u D / r and less were seen.
pub fn a_far_sphere_near_its_light_keeps_its_shading() {
    let size = Size::new(4, 4).expect("a size");
    let unit = || {
        let number = || -1.0..1.0f64;
        let vector = [number(), number(), number()].prop_map(DVec3::from);
        vector.prop_filter_map("a direction", DVec3::try_normalize)
    };
    let inputs = (unit(), unit(), -12..8i32, 6..14i32, 1.5..3.0f64);
    for_all(inputs, |(forward, to_light, scale, distance, height)| {
        let radius = f64::from(scale).exp2();
        let ratio = f64::from(distance).exp2();
        let to_light = if to_light.dot(forward) > 0.0 {
            -to_light
        } else {
            to_light
        };
        let center = forward * (ratio * radius);
        let scene = valid(Scene::new(DVec3::ZERO, f64::INFINITY))?;
        let sphere = valid(Sphere::new(center, radius))?;
        let scene = valid(scene.with_sphere(sphere, DVec3::ONE))?;
        let light = PointLight::new(
            center + to_light * (height * radius),
            DVec3::ONE,
            radius * radius,
        );
        let scene = scene.with_light(valid(light)?);
        // As wide as half of the sphere.
        let fov = (0.5 / ratio).atan().to_degrees() * 2.0;
        let view = view(DVec3::ZERO, center, fov);
        let [narrow, wide] = [
            pixels::<f32>(&scene, &view, size)?,
            pixels::<f64>(&scene, &view, size)?,
        ];
        for ((_, narrow), (_, wide)) in narrow.into_iter().zip(wide) {
            let off = (narrow - wide).abs().max_element();
            let allowed = 32.0 * ratio * f64::from(f32::EPSILON);
            prop_assert!(off <= allowed, "{narrow} instead of {wide}");
        }
        Ok(())
    });
}
