use ombrage::conformance::diagnosis::{Loss, MOST_PIXELS, SMALLEST};
use std::path::Path;
use xtask::check::jpeg::Jpeg;
use xtask::check::read;

/// A picture that is read is of a size that is judged, and what JPEG took from it can be taken
/// again; any other file is refused in one line. Whether it was read.
pub fn picture_file(bytes: &[u8]) -> bool {
    match read::decode(Path::new("any"), bytes) {
        Ok(submission) => {
            let size = submission.picture.size();
            assert!(size.width() >= SMALLEST && size.height() >= SMALLEST);
            assert!(size.pixels() <= MOST_PIXELS);
            for loss in submission.loss.iter().flat_map(Jpeg::each) {
                let side = SMALLEST as usize;
                let mut pixels = vec![[128, 0, 255]; side * side];
                loss.degrade(SMALLEST, SMALLEST, &mut pixels);
            }
            true
        }
        Err(error) => {
            assert_eq!(error.to_string().lines().count(), 1, "{error}");
            false
        }
    }
}
