//! Ombrage is a conformance kit for cast shadows: a university lab on shadows done right once,
//! generic over `f32` and `f64`, measured against exact truth.
//!
//! # The map: from the lab's clauses to the items
//!
//! | clause | what it asks | item |
//! |---|---|---|
//! | 1.1 | a plane from a point and a normal | [`Plane::new`] |
//! | 1.2 | its intersection, and the hit record | [`Plane::intersect`](Shape::intersect), [`Scene::intersect`] |
//! | 1.3 | Figure 1 | [`Integrator::RayCast`], [`FIGURES`] |
//! | 2.1, 2.2 | point lights with colour and power | [`PointLight`] |
//! | 2.3 | the light sample | [`PointLight::sample`] |
//! | 3.1 | direct lighting | [`DirectLighting`] |
//! | 3.2 | Figure 2(a): bytes wrap | [`Film::Wrap`] |
//! | 3.3 | Figure 2(b): the clamp | [`Film::Clamp`] |
//! | 4.1 | shadow rays | [`DirectLighting::shadow`] |
//! | 4.2 | Figure 3(a): acne | [`Shadow::SelfHitting`] |
//! | 4.3 | Figure 3(c): `Ray::offset` | [`Ray::offset`], [`Shadow::UlpOffset`] |
//! | 5.1 | any hit, on shapes and scene | [`Shape::intersect_any`], [`Scene::intersect_any`] |
//! | 5.2 | shadow rays ask for any hit | [`ShadowQuery::Any`] |
//!
//! Every kernel is written once over [`Real`]; `f32` and `f64` ([`Float`]) use glam's vectors, and
//! [`DoubleDouble`] is the truth for pictures.
//!
//! # Beyond the lab
//!
//! | what | item |
//! |---|---|
//! | how well kernels compute: textbook, stable, one precision up | [`Quality`] |
//! | every known way for a shadow ray to leave its surface | [`Shadow`] |
//! | the default for pictures: relative to the camera, shadows without epsilon | [`Relative`], [`Lighting`] |
//! | SIMD packets and threads, the same bits at every level | [`Engine`], [`Level`] |
//! | what happens at every pixel | [`Survey`], [`Relative::follow`] |
//! | every byte proven, by numbers that carry their error | [`render_proven`], [`Bounded`] |
//! | allowed errors, and kernels to judge others by | [`conformance`] |
//!
//! # Figure 3(c) in ten lines
//!
//! ```
//! use glam::{Vec3, vec3};
//! use ombrage::*;
//!
//! # fn main() -> Result<(), Invalid> {
//! let scene = Scene::<f32>::new(Vec3::splat(0.5), 1000.0)?
//!     .with_sphere(Sphere::new(vec3(0.0, 0.0, 3.0), 1.0)?, Vec3::Z)?
//!     .with_plane(Plane::new(vec3(0.0, -2.0, 0.0), Vec3::Y)?, Vec3::X)?
//!     .with_light(PointLight::new(vec3(1.0, 10.0, 1.0), Vec3::ONE, 100.0)?);
//! let (position, look_at) = (vec3(0.0, 0.0, -2.0), vec3(0.0, 0.0, 79.0));
//! let view = View::<f32> { position, look_at, up: Vec3::Y, fov: 60.0 };
//! let camera = PerspectiveCamera::new(&view, 600.0 / 400.0)?;
//! let (quality, shadow) = (Quality::Textbook, Some(Shadow::UlpOffset));
//! let shadows = DirectLighting { quality, shadow, query: ShadowQuery::Any };
//! let integrator = Integrator::DirectLighting(shadows);
//! let chain = LabChain { scene: &scene, camera: &camera, integrator };
//! let picture = render(&chain, Size::LAB, Film::Clamp);
//! # assert_eq!(picture.pixel(0, 0), Some([127, 127, 127]));
//! # assert_eq!(picture, Figure::named("3c").unwrap().draw::<f32>(Size::LAB)?);
//! # Ok(())
//! # }
//! ```

mod camera;
mod chain;
pub mod conformance;
mod error;
mod figure;
mod film;
mod float;
mod integrator;
pub mod lab;
mod leave;
mod level;
mod light;
mod picture;
mod proven;
mod quality;
mod ray;
mod real;
mod relative;
mod render;
mod scene;
mod shadow;
mod shape;
mod survey;
mod vector;

pub use camera::{PerspectiveCamera, View};
pub use chain::{Chain, ChainKind, LabChain};
pub use error::Invalid;
pub use figure::{Detail, FIGURES, Figure};
pub use film::Film;
pub use float::Float;
pub use integrator::{DirectLighting, Integrator, ShadowQuery};
pub use leave::leave;
pub use level::{Level, NoSuchLevel};
pub use light::{LightSample, PointLight};
pub use picture::{Picture, Size};
pub use proven::{Proven, Prover, Rung, Undecided, render_proven};
pub use quality::Quality;
pub use ray::{Ray, Span};
pub use real::{
    ALLOWANCE, Bounded, Constant, DoubleDouble, Job, Kleene, Lane, Lanes, Mask, Packet, PacketMask,
    Pair, Precise, Proof, Real, Rigorous, Rounded, Scalar,
};
pub use relative::{Lighting, Relative};
pub use render::{Develop, Draw, Engine, Frame, Linear, render, render_radiance};
pub use scene::{HitRecord, Object, Scene};
pub use shadow::{Shadow, ShadowRay};
pub use shape::{Hit, Plane, Projection, Shape, Sphere};
pub use survey::{Counts, Pixel, Survey};
pub use vector::{Triple, Vector};

#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;

#[cfg(all(doctest, feature = "vectors"))]
#[doc = include_str!("../docs/conform.md")]
struct Conform;
