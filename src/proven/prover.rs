//! One rung of the ladder: pixels proven in one precision.

use super::byte::byte;
use crate::camera::View;
use crate::error::Invalid;
use crate::film::Film;
use crate::picture::Size;
use crate::real::{Bounded, DoubleDouble, Proof, Real, Rigorous, Rounded};
use crate::relative::{Lighting, Relative, coordinate};
use crate::scene::Scene;
use crate::vector::{Triple, Vector};
use glam::DVec3;

/// A scene as its camera sees it, of which the rungs' own are rounded.
pub(super) type Precisely<P> = Relative<Bounded<DoubleDouble, P>>;

/// Proves pixels in the format `S`, one by one.
///
/// [`render_proven`](crate::render_proven) does it for whole pictures, in packets and in as many
/// formats as it takes. This is for those who ask about one pixel, or about one format.
#[derive(Clone, Debug)]
pub struct Prover<S: Rounded, P: Proof = Rigorous> {
    pub(super) chain: Relative<Bounded<S, P>>,
    size: Size,
    pub(super) film: Film,
    pub(super) background: [u8; 3],
}

impl<S: Rounded, P: Proof> Prover<S, P> {
    /// A prover of the picture that a camera with this view takes of the scene.
    ///
    /// # Errors
    /// As [`Relative::new`].
    pub fn new(
        scene: &Scene<f64>,
        view: &View<f64>,
        size: Size,
        lighting: Lighting,
        film: Film,
    ) -> Result<Self, Invalid> {
        let precisely = Precisely::<P>::of(scene, view, size, lighting)?;
        Ok(Self::of(&precisely, scene.background(), size, film))
    }

    pub(super) fn of(precisely: &Precisely<P>, background: DVec3, size: Size, film: Film) -> Self {
        Self {
            chain: precisely.map(Bounded::from_wide, Bounded::from_wide),
            size,
            film,
            background: background.to_array().map(|x| film.byte(x) as u8),
        }
    }

    /// The bytes of the pixel in a column and a row, if this format can prove them.
    pub fn pixel(&self, column: u32, row: u32) -> Option<[u8; 3]> {
        let across = coordinate::<Bounded<S, P>>(column, self.size.width());
        let down = coordinate::<Bounded<S, P>>(row, self.size.height());
        let direction = self.chain.across::<Bounded<S, P>>(across) + self.chain.down(down);
        let (levels, proven) = match self.chain.reflected::<Bounded<S, P>>(direction) {
            None => return Some(self.background),
            Some((hit, reflected)) => develop(self.film, hit.certain, reflected),
        };
        proven.then(|| levels.map(|level| level.to_f64() as u8))
    }
}

/// The bytes of a colour, and where all three are certain; only where the mask holds.
#[inline(always)]
pub(super) fn develop<B: Real<Scalar: Rounded>, P: Proof>(
    film: Film,
    mask: B::Mask,
    color: Triple<Bounded<B, P>>,
) -> ([B; 3], B::Mask) {
    let [red, green, blue] = color.to_array();
    let (red, certain_red) = byte(film, red);
    let (green, certain_green) = byte(film, green);
    let (blue, certain_blue) = byte(film, blue);
    let certain = mask & certain_red & certain_green & certain_blue;
    ([red, green, blue], certain)
}
