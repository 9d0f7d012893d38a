//! The vector units of the machine that a program runs on, whatever it was built for.

/// Evaluates a kernel with the arithmetic of the machine's vector units and returns, if it has any that are known here.
macro_rules! return_with_vectors {
    ($f:ident: $with:expr => $kernel:expr) => {
        #[cfg(target_arch = "x86_64")]
        if let Some(avx2) = fearless_simd::Level::new().as_avx2() {
            let $f = $with(avx2);
            return fearless_simd::Simd::vectorize(
                avx2,
                #[inline(always)]
                || $kernel,
            );
        }
    };
}
pub(super) use return_with_vectors;

/// Evaluates the same with the vector units, if the machine has any that are known here, and without them.
macro_rules! dispatch_simd {
    ($kernel:expr) => {{
        crate::linearization::dispatch::return_with_vectors!(_f: |_| () => $kernel);
        $kernel
    }};
}
pub(super) use dispatch_simd;
