#![no_main]
libfuzzer_sys::fuzz_target!(|bytes: &[u8]| {
    ombrage_fuzz::picture_file(bytes);
});
