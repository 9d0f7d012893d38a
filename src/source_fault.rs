//! Faults in the source, to test which command sees them. They are compiled only with `--cfg beamgap_faults`, as
//! `.ci/source_faults.py` does. The environment variable `BEAMGAP_FAULT` then chooses one by its name.

/// `$right`, or `$wrong` in a build with faults if the fault of this name is chosen.
macro_rules! source_fault {
    ($name:literal: $wrong:expr, $right:expr) => {{
        #[cfg(beamgap_faults)]
        let value = if crate::source_fault::is_chosen($name) { $wrong } else { $right };
        #[cfg(not(beamgap_faults))]
        let value = $right;
        value
    }};
}
pub(crate) use source_fault;

/// Whether the fault of this name is chosen.
#[cfg(beamgap_faults)]
pub(crate) fn is_chosen(name: &str) -> bool {
    static CHOSEN: std::sync::LazyLock<Option<String>> =
        std::sync::LazyLock::new(|| std::env::var("BEAMGAP_FAULT").ok());
    CHOSEN.as_deref() == Some(name)
}
