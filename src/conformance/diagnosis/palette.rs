//! Whether a picture that nothing explains at least has the lab's colours.

use super::loss::Loss;
use crate::picture::Picture;

/// Whether nearly all pixels are of one grey, of pure red, of pure blue or black, and enough of
/// them are coloured: a scene like the lab's, but another.
pub(super) fn is_the_labs(picture: &Picture, loss: &dyn Loss) -> bool {
    let tolerance = 2 + loss.tolerance();
    let mut grey = [0_usize; 256];
    let (mut colored, mut other) = (0_usize, 0_usize);
    let pixels = picture.bytes().as_chunks::<3>().0;
    for &[red, green, blue] in pixels {
        let [low, middle, high] = sorted([red, green, blue]);
        if high <= tolerance {
            continue;
        }
        if high - low <= tolerance {
            grey[usize::from(green)] += 1;
        } else if middle <= 2 * tolerance && green < high {
            colored += 1;
        } else {
            other += 1;
        }
    }
    let all_grey: usize = grey.iter().sum();
    let near = usize::from(tolerance);
    let one_grey = (0..256)
        .map(|level: usize| {
            grey[level.saturating_sub(near)..(level + near + 1).min(256)]
                .iter()
                .sum()
        })
        .max()
        .unwrap_or(0);
    let stray = other + (all_grey - one_grey);
    let all = pixels.len();
    stray * 25 <= all && colored * 20 >= all
}

/// Whether a picture is of one colour, but for a few pixels: it says nothing.
pub(super) fn is_blank(picture: &Picture) -> bool {
    let pixels = picture.bytes().as_chunks::<3>().0;
    let Some(middle) = pixels.get(pixels.len() / 2) else {
        return true;
    };
    let other = pixels.iter().filter(|pixel| *pixel != middle).count();
    other * 200 < pixels.len()
}

fn sorted(mut bytes: [u8; 3]) -> [u8; 3] {
    bytes.sort_unstable();
    bytes
}
