#![no_main]
libfuzzer_sys::fuzz_target!(|bytes: &[u8]| {
    ombrage_fuzz::protocol_line(bytes);
});
