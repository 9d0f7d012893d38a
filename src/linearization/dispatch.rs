//! Dispatch to the vector units of the machine at run time, for any build target.

/// Evaluates a kernel with the arithmetic of the machine's vector units and returns, if these units are supported here.
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
pub(crate) use return_with_vectors;

/// Evaluates a kernel with the machine's vector units, if they are supported here, and otherwise without them.
macro_rules! dispatch_simd {
    ($kernel:expr) => {{
        crate::linearization::dispatch::return_with_vectors!(_f: |_| () => $kernel);
        $kernel
    }};
}
pub(crate) use dispatch_simd;
