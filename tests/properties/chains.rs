//! The two chains compute the same picture by other ways: the kit's own from the camera's place and
//! by sides, the lab's from ray to hit to shadow ray.

use crate::property::for_all;
use glam::DVec3;
use ombrage::{
    Chain, DirectLighting, DoubleDouble, Film, Integrator, Invalid, LabChain, Lighting,
    PerspectiveCamera, Plane, PointLight, Quality, Relative, Scene, Shadow, ShadowQuery, Size,
    Sphere, View, render,
};
use proptest::collection::vec;
use proptest::prelude::*;
use proptest::sample::select;
use std::cell::Cell;

/// Nothing in it is on an edge, but for what chance puts there.
fn point() -> impl Strategy<Value = DVec3> + Clone {
    [-4.0..4.0f64, -4.0..4.0, -4.0..4.0].prop_map(DVec3::from)
}

fn color() -> impl Strategy<Value = DVec3> + Clone {
    [0.1..1.0f64, 0.1..1.0, 0.1..1.0].prop_map(DVec3::from)
}

/// Spheres of all sizes that stand free, around each other, around the camera and around a light, and
/// whose middle a light is much nearer to than the camera; planes on all sides.
fn scenes() -> impl Strategy<Value = (Scene<f64>, View<f64>)> {
    let spheres = vec((point(), 0.2..3.0f64, color()), 0..4);
    let planes = vec((point(), point(), color()), 0..3);
    let lights = vec((point(), color(), 1.0..200.0f64), 1..4);
    let near = vec((point(), prop_oneof![0.01..0.3f64, 4.0..16.0f64]), 0..2);
    let view = (point(), point(), point(), 20.0..120.0f64);
    let t_max = prop_oneof![Just(f64::INFINITY), 2.0..12.0f64];
    let all = (spheres, planes, lights, near, view, t_max);
    all.prop_filter_map("a scene", |(spheres, planes, lights, near, view, t_max)| {
        let (position, look_at, up, fov) = view;
        let build = || -> Result<_, Invalid> {
            let mut scene = Scene::new(DVec3::new(0.2, 0.3, 0.4), t_max)?;
            for (center, radius, color) in spheres {
                scene = scene.with_sphere(Sphere::new(center, radius)?, color)?;
            }
            for (point, normal, color) in planes {
                scene = scene.with_plane(Plane::new(point, normal)?, color)?;
            }
            for (offset, radius) in near {
                let center = lights[0].0 + offset * 0.1;
                scene = scene.with_sphere(Sphere::new(center, radius)?, DVec3::ONE)?;
            }
            for (place, color, power) in lights {
                scene = scene.with_light(PointLight::new(place, color, power)?);
            }
            Ok(scene)
        };
        let view = View {
            position,
            look_at,
            up,
            fov,
        };
        Some((build().ok()?, view))
    })
}

/// The lab's chain in double-double errs by some 10^-28, and its shadow rays start as near to their
/// surface; the kit's in `f64` by some 10^-13. That either turns a byte or an edge is not to be seen
/// in this many pixels.
pub fn both_draw_the_same_pictures() {
    let seen = Cell::new([0; 2]);
    let lightings = select(vec![
        Lighting::Shadowed,
        Lighting::Unshadowed,
        Lighting::Eye,
    ]);
    for_all((scenes(), lightings), |((scene, view), lighting)| {
        let size = Size::new(12, 8).expect("a size");
        let valid = |invalid: Invalid| TestCaseError::reject(invalid.to_string());
        let own = Relative::<f64>::new(&scene, &view, size, lighting).map_err(valid)?;
        let wide = scene.cast::<DoubleDouble>().map_err(valid)?;
        let aspect = DoubleDouble::from_f64(12.0) / DoubleDouble::from_f64(8.0);
        let camera = PerspectiveCamera::new(&view.cast::<DoubleDouble>(), aspect).map_err(valid)?;
        let direct = |shadow| {
            Integrator::DirectLighting(DirectLighting {
                quality: Quality::Textbook,
                shadow,
                query: ShadowQuery::Any,
            })
        };
        let lab = LabChain {
            scene: &wide,
            camera: &camera,
            integrator: match lighting {
                Lighting::Eye => Integrator::RayCast(Quality::Textbook),
                Lighting::Unshadowed => direct(None),
                Lighting::Shadowed => direct(Some(Shadow::TMin(1e-20))),
            },
        };
        let own = render(&own, size, Film::Clamp);
        let lab = render(&lab, size, Film::Clamp);
        let black = own.bytes().chunks(3).filter(|rgb| **rgb == [0; 3]).count();
        seen.set([seen.get()[0] + black, seen.get()[1] + size.pixels() - black]);
        for (place, (own, lab)) in own.bytes().chunks(3).zip(lab.bytes().chunks(3)).enumerate() {
            prop_assert_eq!(own, lab, "column {}, row {}", place % 12, place / 12);
        }
        Ok(())
    });
    let [black, bright] = seen.get();
    assert!(
        black > 1000 && bright > 1000,
        "{black} black, {bright} bright"
    );
}

/// What a survey says of a pixel is what its colour shows: which object, whether a light shines on it,
/// and how brightly.
pub fn surveys_tell_what_pixels_show() {
    let shown = Cell::new([0; 4]);
    for_all(scenes(), |(scene, view)| {
        let size = Size::new(12, 8).expect("a size");
        let valid = |invalid: Invalid| TestCaseError::reject(invalid.to_string());
        let chain = Relative::<f64>::new(&scene, &view, size, Lighting::Shadowed).map_err(valid)?;
        let bare =
            Relative::<f64>::new(&scene, &view, size, Lighting::Unshadowed).map_err(valid)?;
        for (column, row) in (0..8).flat_map(|row| (0..12).map(move |column| (column, row))) {
            let across = Relative::<f64>::coordinate(column, 12);
            let down = Relative::<f64>::coordinate(row, 8);
            let pixel = chain.follow(across, down);
            let radiance = chain.radiance::<f64>(across, down);
            let unblocked = bare.radiance::<f64>(across, down);
            prop_assert_eq!(pixel.level, (255.0 * radiance.max_element()) as u64);
            prop_assert!(!pixel.blocked_by_itself);
            let Some(object) = pixel.object else {
                prop_assert_eq!(radiance, scene.background());
                continue;
            };
            prop_assert_eq!(pixel.on_sphere, object < scene.spheres().len());
            let is_dark = radiance == DVec3::ZERO;
            if scene.lights().len() == 1 {
                prop_assert_eq!(pixel.is_lit(), !is_dark);
            }
            prop_assert!(pixel.faces_light || is_dark);
            // Of several lights one may be blocked and another not.
            prop_assert!(!pixel.blocked_by_another || (pixel.faces_light && radiance != unblocked));
            let [lit, turned, shadowed, all] = shown.get();
            shown.set([
                lit + u32::from(pixel.is_lit()),
                turned + u32::from(!pixel.faces_light),
                shadowed + u32::from(pixel.blocked_by_another),
                all + 1,
            ]);
        }
        Ok(())
    });
    assert!(shown.get().iter().all(|count| *count > 200), "{shown:?}");
}
