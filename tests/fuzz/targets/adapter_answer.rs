#![no_main]
libfuzzer_sys::fuzz_target!(|bytes: &[u8]| {
    ombrage_fuzz::adapter_answer(bytes);
});
