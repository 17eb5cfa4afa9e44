use ombrage::conformance::Kernels;
use ombrage::{Quality, Shadow};
use serde_json::Value;
use xtask::kernels::serve;

/// Every line of the kernel protocol gets one answer of one sort in its place, from every quality
/// and with a shadow strategy. Returns how many lines are requests that are computed.
pub fn protocol_line(bytes: &[u8]) -> usize {
    let shadow = (Quality::Stable, Some(Shadow::ErrorBound));
    let qualities = Quality::ALL.map(|quality| (quality, None));
    let mut computed = 0;
    for (quality, shadow) in qualities.into_iter().chain([shadow]) {
        let mut output = vec![];
        let all = serve(&Kernels { quality, shadow }, bytes, &mut output).expect("it is served");
        let output = String::from_utf8(output).expect("UTF-8");
        let lines: Vec<&[u8]> = bytes.split_inclusive(|&byte| byte == b'\n').collect();
        assert_eq!(output.lines().count(), lines.len());
        let mut sorts = [0; 3];
        for ((number, line), answer) in (1..).zip(lines).zip(output.lines()) {
            let answer: Value = serde_json::from_str(answer).expect("JSON");
            let keys = ["out", "unsupported", "error"].map(|key| answer.get(key).is_some());
            let shown = || format!("{answer} to {}", String::from_utf8_lossy(line));
            assert_eq!(keys.iter().filter(|&&is| is).count(), 1, "{}", shown());
            assert!(!keys[2] || answer["line"] == number, "{}", shown());
            for (sort, is) in sorts.iter_mut().zip(keys) {
                *sort += usize::from(is);
            }
        }
        assert_eq!(all, sorts[2] == 0, "{output}");
        computed = sorts[0];
    }
    computed
}
