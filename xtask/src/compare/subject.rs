//! A picture to compare, and the ways to compute it.

use crate::case::{self, Case};
use crate::error::Result;
use crate::shadows::{Hits, by_sidedness};
use crate::truth::{self, TruePixel};
use ombrage::{
    DirectLighting, DoubleDouble, Figure, Film, Integrator, LabChain, Lighting, Picture, Pixel,
    Quality, Relative, Scalar, Shadow, Size, Vector, lab,
};

/// A figure or a scene.
pub struct Subject {
    case: Case,
    figure: Option<&'static Figure>,
}

/// A way to compute a picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Way {
    /// The lab's chain.
    Lab,
    /// The ray-relative chain.
    Relative,
}

impl Way {
    /// The name, as tables give it.
    pub fn name(self) -> &'static str {
        match self {
            Way::Lab => "lab",
            Way::Relative => "relative",
        }
    }
}

/// A computed picture: its radiance in `f64` or wider, its bytes, and what happens at its pixels,
/// once for each light.
pub struct Computed<N, P> {
    /// Three components a pixel, row-major.
    pub radiance: Vec<[N; 3]>,
    /// The bytes.
    pub picture: Picture,
    /// For each light, what happens at every pixel; one without a light where there is none.
    pub lights: Vec<Vec<P>>,
    /// How many spheres the scene has: objects below this number are spheres.
    pub spheres: usize,
    /// Whether anything casts a shadow.
    pub casts_shadows: bool,
}

impl Subject {
    /// A figure of the lab.
    ///
    /// # Errors
    /// None: the lab's scene is valid.
    pub fn figure(figure: &'static Figure) -> Result<Self> {
        Ok(Self {
            case: Case {
                name: format!("figure {}", figure.name),
                scene: lab::scene()?,
                view: lab::view(),
                size: Size::LAB,
            },
            figure: Some(figure),
        })
    }

    /// A scene, drawn with direct light and shadows.
    pub fn scene(case: Case) -> Self {
        Self { case, figure: None }
    }

    /// Its name.
    pub fn name(&self) -> String {
        self.case.name.clone()
    }

    fn integrator(&self) -> Integrator {
        let ulp_offset = case::direct(Quality::Textbook, Some(Shadow::UlpOffset));
        self.figure.map_or(ulp_offset, |figure| figure.integrator)
    }

    fn shadow(&self) -> Option<Shadow> {
        match self.integrator() {
            Integrator::DirectLighting(DirectLighting { shadow, .. }) => shadow,
            Integrator::RayCast(_) => None,
        }
    }

    fn lighting(&self) -> Lighting {
        match (self.integrator(), self.shadow()) {
            (Integrator::RayCast(_), _) => Lighting::Eye,
            (_, None) => Lighting::Unshadowed,
            (_, Some(_)) => Lighting::Shadowed,
        }
    }

    /// The radiance in a way, one pixel at a time.
    fn radiance<S: Scalar>(&self, way: Way) -> Result<Vec<S::Vector>> {
        let case = &self.case;
        Ok(match way {
            Way::Lab => {
                let (scene, camera) = (case.scene.cast::<S>()?, case.camera::<S>()?);
                let chain = LabChain {
                    scene: &scene,
                    camera: &camera,
                    integrator: self.integrator(),
                };
                case::radiance(&chain, case.size)
            }
            Way::Relative => {
                let lighting = self.lighting();
                let chain = Relative::<S>::new(&case.scene, &case.view, case.size, lighting)?;
                case::radiance(&chain, case.size)
            }
        })
    }

    /// A task that computes the radiance, for its time to be taken.
    ///
    /// # Errors
    /// If the case is invalid in this format.
    pub fn draw<S: Scalar>(&self, way: Way) -> Result<Box<dyn FnMut() + '_>> {
        self.radiance::<S>(way)?;
        Ok(Box::new(move || {
            // It succeeded above, and nothing has changed.
            let _ = std::hint::black_box(self.radiance::<S>(way));
        }))
    }

    /// The picture in a format.
    ///
    /// # Errors
    /// If the case is invalid in this format.
    pub fn compute<S: Scalar>(&self, way: Way) -> Result<Computed<f64, Pixel>> {
        let radiance = self.radiance::<S>(way)?;
        let mut lights = vec![];
        for light in self.lights()? {
            lights.push(match (way, self.shadow()) {
                (Way::Lab, shadow) => Hits::<S>::new(&light, self.integrator().quality())?
                    .verdicts(shadow)
                    .collect(),
                (Way::Relative, None) => by_sidedness::<S>(&light, Lighting::Unshadowed)?,
                (Way::Relative, Some(_)) => by_sidedness::<S>(&light, Lighting::Shadowed)?,
            });
        }
        let values = |v: &S::Vector| v.to_array().map(S::to_f64);
        Ok(self.computed(
            radiance.iter().map(values).collect(),
            self.develop::<S>(&radiance),
            lights,
        ))
    }

    /// The true picture: its bytes proven, its radiance in double-double, and the decisions of
    /// [`truth::of`]. Figures 3(a) and 3(b) ought to have shown the shadows of Figure 3(c).
    ///
    /// # Errors
    /// If the case is invalid in double-double.
    pub fn truth(&self) -> Result<Computed<DoubleDouble, TruePixel>> {
        let radiance = self.radiance::<DoubleDouble>(Way::Relative)?;
        let mut lights = vec![];
        for light in self.lights()? {
            lights.push(truth::of(&light.scene, &light.view, light.size)?);
        }
        Ok(self.computed(
            radiance.iter().map(|v| v.to_array()).collect(),
            self.enlarged(case::proven(&self.case, self.lighting(), self.film())?),
            lights,
        ))
    }

    fn computed<N, P>(
        &self,
        radiance: Vec<[N; 3]>,
        picture: Picture,
        lights: Vec<Vec<P>>,
    ) -> Computed<N, P> {
        Computed {
            radiance,
            picture,
            lights,
            spheres: self.case.scene.spheres().len(),
            casts_shadows: self.shadow().is_some(),
        }
    }

    /// The case with each of its lights alone; as it is where there is none.
    fn lights(&self) -> Result<Vec<Case>> {
        let count = self.case.scene.lights().len().max(1);
        (0..count)
            .map(|light| self.case.with_light(light))
            .collect()
    }

    /// From radiance to bytes, and the detail of an enlarged figure.
    fn develop<S: Scalar>(&self, radiance: &[S::Vector]) -> Picture {
        self.enlarged(develop::<S>(radiance, self.case.size, self.film()))
    }

    fn film(&self) -> Film {
        self.figure.map_or(Film::Clamp, |figure| figure.film)
    }

    /// The detail of an enlarged figure; other pictures as they are.
    fn enlarged(&self, picture: Picture) -> Picture {
        match self.figure.and_then(|figure| figure.detail) {
            None => picture,
            Some(detail) => detail.of(&picture),
        }
    }
}

/// From radiance, row-major, to bytes.
pub fn develop<S: Scalar>(radiance: &[S::Vector], size: Size, film: Film) -> Picture {
    Picture::from_fn(size, |x, y| {
        let place = y as usize * size.width() as usize + x as usize;
        radiance[place]
            .to_array()
            .map(|value| film.byte(value).to_f64() as u8)
    })
}
