//! Elementary functions, from the standard library or from `libm`.

macro_rules! real {
    ($($name:ident, $t:ty, $std:ident;)*) => { $(
        #[inline(always)]
        pub(crate) fn $name(x: $t) -> $t {
            #[cfg(feature = "std")]
            return <$t>::$std(x);
            #[cfg(not(feature = "std"))]
            return libm::$name(x);
        }
    )* };
}

real! {
    cos, f64, cos;
    exp, f64, exp;
    expf, f32, exp;
    sin, f64, sin;
    sqrt, f64, sqrt;
    sqrtf, f32, sqrt;
}

#[cfg(feature = "log")]
real! {
    expm1, f64, exp_m1;
    log, f64, ln;
    log1p, f64, ln_1p;
}
