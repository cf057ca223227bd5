//! Peak memory of the process.

/// Peak resident memory since the process began (or since [`reset_peak`]) in bytes; `None`
/// where the operating system does not tell.
pub fn peak_bytes() -> Option<u64> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let line = status
        .lines()
        .find_map(|line| line.strip_prefix("VmHWM:"))?;
    let kibibytes: u64 = line.trim().strip_suffix("kB")?.trim().parse().ok()?;
    Some(kibibytes * 1024)
}

/// Starts counting the peak anew from the present use, so that several solves in one process
/// can be told apart. `false` where the operating system does not allow it: the peak then stays
/// that of the whole process.
pub fn reset_peak() -> bool {
    std::fs::write("/proc/self/clear_refs", "5").is_ok()
}

#[cfg(all(test, target_os = "linux"))]
mod tests {
    use super::*;

    #[test]
    fn the_peak_sees_a_large_allocation() {
        let before = peak_bytes().unwrap();
        let block = vec![1u8; 1 << 28];
        assert!(std::hint::black_box(&block)[12345] == 1);
        assert!(peak_bytes().unwrap() >= before.max(1 << 28));
    }
}
