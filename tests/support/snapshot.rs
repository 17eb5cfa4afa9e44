//! Accepted pictures: compared pixel by pixel, never by how a PNG was encoded.

use image::{ImageEncoder, RgbImage};
use insta::internals::SnapshotContents;
use insta::{Comparator, Settings, Snapshot};
use std::fs;
use std::path::Path;

/// Where accepted pictures and tables are.
const FOLDER: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/snapshots");

/// Insta's settings for snapshots in the top-level folder, named as they are.
pub fn settings() -> Settings {
    let mut settings = Settings::clone_current();
    settings.set_snapshot_path(FOLDER);
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    settings
}

/// The settings for a picture of this name.
pub fn picture_settings(name: &str) -> Settings {
    let mut settings = settings();
    let name = name.to_owned();
    settings.set_comparator(Box::new(EqualPixels { name }));
    settings
}

/// A picture as a PNG file.
pub fn png(picture: &ombrage::Picture) -> Vec<u8> {
    let (width, height) = (picture.size().width(), picture.size().height());
    let mut file = vec![];
    image::codecs::png::PngEncoder::new(&mut file)
        .write_image(
            picture.bytes(),
            width,
            height,
            image::ExtendedColorType::Rgb8,
        )
        .expect("a picture has three bytes for each pixel");
    file
}

/// Two PNG files are the same where their pixels are. What differs is told, and drawn.
#[derive(Clone)]
struct EqualPixels {
    name: String,
}

impl Comparator for EqualPixels {
    fn matches(&self, reference: &Snapshot, test: &Snapshot) -> bool {
        let (Some(expected), Some(actual)) = (decoded(reference), decoded(test)) else {
            return false;
        };
        match Difference::between(&expected, &actual) {
            None => true,
            Some(difference) => {
                eprintln!("{}: {}", self.name, difference.words());
                let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join(&self.name);
                let saved = fs::create_dir_all(env!("CARGO_TARGET_TMPDIR"))
                    .map_err(image::ImageError::IoError)
                    .and_then(|()| side_by_side(&expected, &actual).save(&path));
                match saved {
                    Ok(()) => eprintln!("expected | difference | actual: {}", path.display()),
                    Err(error) => eprintln!("{} could not be written: {error}", path.display()),
                }
                false
            }
        }
    }

    fn dyn_clone(&self) -> Box<dyn Comparator> {
        Box::new(self.clone())
    }
}

/// The pixels of a snapshot that is a PNG file; `None` where it has no file or another kind of it.
fn decoded(snapshot: &Snapshot) -> Option<RgbImage> {
    let SnapshotContents::Binary(Some(file)) = snapshot.contents() else {
        return None;
    };
    let format = image::ImageFormat::Png;
    Some(
        image::load_from_memory_with_format(file, format)
            .ok()?
            .to_rgb8(),
    )
}

/// In what two pictures differ.
#[derive(Debug, PartialEq)]
pub enum Difference {
    /// Width and height of the one and the other.
    Size([u32; 2], [u32; 2]),
    /// The colours of some pixels.
    Pixels {
        /// How many.
        count: usize,
        /// The largest difference of two bytes.
        largest: u8,
        /// The first and last column and the first and last row with a difference.
        columns: [u32; 2],
        rows: [u32; 2],
    },
}

impl Difference {
    /// What differs; `None`: nothing.
    pub fn between(expected: &RgbImage, actual: &RgbImage) -> Option<Self> {
        if expected.dimensions() != actual.dimensions() {
            return Some(Self::Size(
                expected.dimensions().into(),
                actual.dimensions().into(),
            ));
        }
        let (mut count, mut largest) = (0, 0);
        let (mut columns, mut rows) = ([u32::MAX, 0], [u32::MAX, 0]);
        for (x, y, pixel) in expected.enumerate_pixels() {
            let distances = apart(pixel.0, actual.get_pixel(x, y).0);
            let distance = distances.into_iter().max().unwrap_or(0);
            if distance > 0 {
                count += 1;
                largest = largest.max(distance);
                columns = [columns[0].min(x), columns[1].max(x)];
                rows = [rows[0].min(y), rows[1].max(y)];
            }
        }
        (count > 0).then_some(Self::Pixels {
            count,
            largest,
            columns,
            rows,
        })
    }

    /// The same for a reader.
    fn words(&self) -> String {
        match self {
            Self::Size([width, height], actual) => {
                format!(
                    "{}x{} instead of {width}x{height} pixels",
                    actual[0], actual[1]
                )
            }
            Self::Pixels {
                count,
                largest,
                columns,
                rows,
            } => format!(
                "{count} pixels differ, by at most {largest}, in columns {}..={} and rows {}..={}",
                columns[0], columns[1], rows[0], rows[1]
            ),
        }
    }
}

/// How far two colours are apart.
fn apart(a: [u8; 3], b: [u8; 3]) -> [u8; 3] {
    std::array::from_fn(|i| a[i].abs_diff(b[i]))
}

/// The expected picture, the difference (black where there is none, at least dark grey elsewhere)
/// and the actual picture.
fn side_by_side(expected: &RgbImage, actual: &RgbImage) -> RgbImage {
    let width = expected.width().max(actual.width());
    let height = expected.height().max(actual.height());
    let at = |picture: &RgbImage, x, y| picture.get_pixel_checked(x, y).map_or([0; 3], |p| p.0);
    RgbImage::from_fn(3 * width, height, |x, y| {
        let (part, x) = (x / width, x % width);
        let (expected, actual) = (at(expected, x, y), at(actual, x, y));
        image::Rgb(match part {
            0 => expected,
            1 => match apart(expected, actual) {
                [0, 0, 0] => [0; 3],
                distances => distances.map(|d| d.max(64)),
            },
            _ => actual,
        })
    })
}
