//! The picture that is judged, or a part of it, and how far a recipe is from it.

use super::loss::Loss;
use super::recipe::{Recipe, Viewpoint};
use super::shade::Drawn;
use super::surface::{Region, Surfels, surfels};
use crate::error::Invalid;
use crate::picture::{Picture, Size};
use std::cell::RefCell;
use std::rc::Rc;

/// The side of a tile: that of a JPEG block of all channels with halved chroma.
pub(super) const TILE: u32 = 16;

/// Parts of a picture, and what has been computed about them.
pub(super) struct Evidence<'a> {
    pub size: Size,
    pub regions: Vec<Region>,
    /// The picture's pixels, region by region, row-major.
    pub observed: Vec<[u8; 3]>,
    pub loss: &'a dyn Loss,
    /// How many viewpoints are remembered.
    kept: usize,
    seen: RefCell<Vec<(Viewpoint, Rc<Surfels>)>>,
}

/// Surfels that are remembered, of all viewpoints together.
const KEPT: usize = 8 << 20;

/// The largest error of a pixel that counts: more is no worse, be it a silhouette or a wrapped byte.
const LARGEST: f64 = 64.0;

/// What a falsely black pixel costs, in levels: more than the noise of a darker surface, less than
/// a pixel that nothing explains.
const ACNE: f64 = 3.0;

/// What it costs where nothing blurs it, and it is all black.
const BLACK: f64 = 0.5;

impl<'a> Evidence<'a> {
    /// These parts of a picture.
    pub fn new(picture: &Picture, regions: Vec<Region>, loss: &'a dyn Loss) -> Self {
        let pixels = regions.iter().flat_map(|region| region.pixels());
        let observed: Vec<[u8; 3]> = pixels
            .map(|(x, y)| picture.pixel(x, y).unwrap_or_default())
            .collect();
        let kept = (KEPT / observed.len().max(1)).max(2);
        Self {
            size: picture.size(),
            regions,
            observed,
            loss,
            kept,
            seen: RefCell::default(),
        }
    }

    /// About so many pixels of a picture, in tiles that are spread over it.
    pub fn sample(picture: &Picture, pixels: usize, loss: &'a dyn Loss) -> Self {
        let size = picture.size();
        let tiles = (size.pixels() / (TILE * TILE) as usize).max(1);
        let every = (tiles * (TILE * TILE) as usize).div_ceil(pixels).max(1) as u32;
        let bright = |x: u32, y: u32| {
            let at = |n: u32, whole: u32| f64::from(n * TILE + TILE / 2) / f64::from(whole);
            let (across, down) = (at(x, size.width()), at(y, size.height()));
            (across - 0.5).abs() < 0.09 && (down - 0.5).abs() > 0.13 && (down - 0.5).abs() < 0.2
        };
        // Rows are shifted by an odd step, so that no column of tiles is left out.
        let regions = tiles_of(size)
            .filter(|&(x, y, _)| (x + (every / 2 + 1) * y).is_multiple_of(every) || bright(x, y))
            .map(|(.., region)| region)
            .collect();
        Self::new(picture, regions, loss)
    }

    /// The surfels of a viewpoint, computed once.
    pub fn surfels(&self, viewpoint: &Viewpoint) -> Result<Rc<Surfels>, Invalid> {
        let mut seen = self.seen.borrow_mut();
        if let Some((_, surfels)) = seen.iter().find(|(known, _)| known == viewpoint) {
            return Ok(Rc::clone(surfels));
        }
        if seen.len() >= self.kept {
            seen.remove(0);
        }
        let new = Rc::new(surfels(viewpoint, self.size, &self.regions)?);
        seen.push((*viewpoint, Rc::clone(&new)));
        Ok(new)
    }

    /// The pixels as a recipe draws them, without the loss.
    pub fn drawn(&self, recipe: &Recipe) -> Result<Vec<Drawn>, Invalid> {
        let surfels = self.surfels(&recipe.viewpoint)?;
        Ok(surfels.pixels().map(|pixel| recipe.draw(pixel)).collect())
    }

    /// The same, with the loss.
    pub fn predicted(&self, recipe: &Recipe) -> Result<Vec<Drawn>, Invalid> {
        let mut drawn = self.drawn(recipe)?;
        if self.loss.tolerance() > 0 {
            let mut start = 0;
            for region in &self.regions {
                let pixels = &mut drawn[start..][..(region.width * region.height) as usize];
                let mut rgb: Vec<_> = pixels.iter().map(|pixel| pixel.rgb).collect();
                self.loss.degrade(region.width, region.height, &mut rgb);
                for (pixel, rgb) in pixels.iter_mut().zip(rgb) {
                    pixel.rgb = rgb;
                }
                start += pixels.len();
            }
        }
        Ok(drawn)
    }

    /// How far a recipe is from the picture: the mean error of a pixel, in levels.
    pub fn error(&self, recipe: &Recipe) -> Result<f64, Invalid> {
        Ok(self.error_of(recipe, &self.predicted(recipe)?))
    }

    fn error_of(&self, recipe: &Recipe, drawn: &[Drawn]) -> f64 {
        let pairs = drawn.iter().zip(&self.observed);
        let total: f64 = pairs
            .map(|(drawn, &observed)| self.pixel_error(recipe, drawn, observed))
            .sum();
        total / self.observed.len().max(1) as f64
    }

    /// How far a pixel is off, in levels.
    pub fn pixel_error(&self, recipe: &Recipe, drawn: &Drawn, observed: [u8; 3]) -> f64 {
        let off = distance(drawn.rgb, observed);
        let may_be_black = drawn.object.index().is_some_and(|i| recipe.acne[i]) && drawn.is_lit;
        let tolerance = 2 + self.loss.tolerance();
        if may_be_black && off > tolerance && is_darker(drawn.rgb, observed, self.loss) {
            let is_black = self.loss.tolerance() == 0 && observed.iter().all(|&byte| byte <= 1);
            return if is_black {
                BLACK
            } else {
                ACNE + f64::from(self.loss.tolerance()) / 2.0
            };
        }
        f64::from(off).min(LARGEST)
    }
}

/// The largest difference of two pixels' components.
pub(super) fn distance(a: [u8; 3], b: [u8; 3]) -> u8 {
    let off = [0, 1, 2].map(|c| a[c].abs_diff(b[c]));
    off[0].max(off[1]).max(off[2])
}

/// Whether a pixel may be a falsely black one, or an average over some: it has the right hue and
/// less of it. Where there is loss, neighbours bleed into each other, and only the brightest
/// component tells.
fn is_darker(right: [u8; 3], observed: [u8; 3], loss: &dyn Loss) -> bool {
    let tolerance = loss.tolerance();
    if tolerance == 0 {
        return (0..3).all(|c| observed[c] <= right[c].saturating_add(1));
    }
    let brightest = |rgb: [u8; 3]| rgb.into_iter().max().unwrap_or(0);
    brightest(observed) <= brightest(right).saturating_add(2 * tolerance)
}

/// The tiles of a picture: column and row of the tile, and its pixels.
pub(super) fn tiles_of(size: Size) -> impl Iterator<Item = (u32, u32, Region)> {
    let (width, height) = (size.width(), size.height());
    (0..height.div_ceil(TILE)).flat_map(move |y| {
        (0..width.div_ceil(TILE)).map(move |x| {
            let region = Region {
                left: x * TILE,
                top: y * TILE,
                width: TILE.min(width - x * TILE),
                height: TILE.min(height - y * TILE),
            };
            (x, y, region)
        })
    })
}
