//! The vector units of the machine that a program runs on, whatever it was built for.

/// Evaluates a kernel with the arithmetic of the machine's vector units, if it has any that are known here.
macro_rules! with_the_fastest {
    ($f:ident: $with:expr, $without:expr => $kernel:expr) => {{
        #[cfg(target_arch = "x86_64")]
        if let Some(avx2) = fearless_simd::Level::new().as_avx2() {
            let $f = $with(avx2);
            return fearless_simd::Simd::vectorize(
                avx2,
                #[inline(always)]
                || $kernel,
            );
        }
        let $f = $without;
        $kernel
    }};
}
pub(super) use with_the_fastest;
