// Spherical harmonics of order 2 in WGSL. Gaunt 0.1.0.
// Made by `gaunt export --lang wgsl --order 2`; do not change it here. MIT or Apache-2.0, at your choice.
//
// Put it before or after your own text: it declares functions, constants and at most one struct, all of which start
// with the prefix. No extension is needed.
//
// A vector has 4 coefficients; that of band l and index m, -l to l, stands at l*l + l + m. The basis is real and
// orthonormal, with the signs usual in graphics (no Condon-Shortley): band 1 is sqrt(3/(4 pi)) (y, z, x), and the
// function 1 is (sqrt(4 pi), 0, ...). A zonal vector has the 2 coefficients of m = 0, one a band, of a function that
// is round about +Z. A symmetric matrix is its lower triangle, row by row. Axes are right-handed, angles radians;
// directions and quaternions (x, y, z, w) have length 1, and rotations are active: (Rf)(s) = f(R^-1 s).
//
// Routines, each with the prefix sh2_: basis, cosine, zonal, product, square, product_cosine, triple, dot,
// product_matrix, matrix_apply, rotate, rotate_matrix, window, cap_visibility, cap_log, add_cap_log,
// cap_log_saturating, add_cap_log_saturating, cap_log_shading, accumulate_blocker, accumulate_blocker_saturating,
// accumulated_log, ball_average, disc_covered, exp_saturating, transfer, transfer_lobe, gloss_lobe, gloss_told,
// gloss_tilt, gloss_energy, horizon_radius, exp_sampled, exp_sampled_coarse, exp_sampled_fine, optimal_linear,
// optimal_linear_wide, cap_log_row, exp_product_series, exp_ps_star, exp_hyb, exp_optimal_linear, cap_log_table,
// pack_half, unpack_half.

// The n^2 basis functions at the unit vector `d`.
//
// `f(d) = basis(d) * f` evaluates a vector.
// Source: Ren et al. 2006, eq. 1; real, orthonormal, without Condon-Shortley sign.
// 3 multiplications, 0 additions.
fn sh2_basis(d: vec3<f32>) -> array<f32, 4> {
    let t8 = d.y * 0.48860252;
    let t9 = d.z * 0.48860252;
    let t10 = d.x * 0.48860252;
    return array<f32, 4>(
        0.2820948, t8, t9, t10,
    );
}

// The cosine lobe about the unit normal `d`, over pi: its dot product with radiance is the radiance that a white
// diffuse surface reflects.
// Source: Ren et al. 2006, eq. 9; Ramamoorthi and Hanrahan 2001: A_l/pi = 1, 2/3, 1/4, 0, -1/24, 0.
// 6 multiplications, 0 additions.
fn sh2_cosine(d: vec3<f32>) -> array<f32, 4> {
    let t9 = d.y * 0.48860252;
    let t10 = d.z * 0.48860252;
    let t11 = d.x * 0.48860252;
    let t12 = 0.6666667 * t9;
    let t13 = 0.6666667 * t10;
    let t14 = 0.6666667 * t11;
    return array<f32, 4>(
        0.2820948, t12, t13, t14,
    );
}

// The zonal vector `z` about +Z, turned to the unit vector `d`.
// Source: Sloan et al. 2005; Ren et al. 2006, section 6.1: f_lm = sqrt(4 pi/(2l+1)) z_l y_lm(d).
// 9 multiplications, 0 additions.
fn sh2_zonal(z: array<f32, 2>, d: vec3<f32>) -> array<f32, 4> {
    let t6 = z[0] * 3.5449078;
    let t8 = z[1] * 2.0466535;
    let t14 = d.y * 0.48860252;
    let t15 = d.z * 0.48860252;
    let t16 = d.x * 0.48860252;
    let t17 = t6 * 0.2820948;
    let t18 = t8 * t14;
    let t19 = t8 * t15;
    let t20 = t8 * t16;
    return array<f32, 4>(
        t17, t18, t19, t20,
    );
}

// The product `f * g`, projected back to order n.
//
// Commutative, not associative: what lies above order n is dropped each time.
// Source: Ren et al. 2006, eq. 3.
// 16 multiplications, 6 additions.
fn sh2_product(f: array<f32, 4>, g: array<f32, 4>) -> array<f32, 4> {
    let t9 = f[0] * g[0];
    let t11 = t9 * 0.2820948;
    let t12 = f[0] * 0.2820948;
    let t13 = g[0] * 0.2820948;
    let t14 = f[1] * g[1];
    let t16 = fma(0.2820948, t14, t11);
    let t17 = g[1] * t12;
    let t19 = fma(f[1], t13, t17);
    let t20 = f[2] * g[2];
    let t22 = fma(0.2820948, t20, t16);
    let t23 = g[2] * t12;
    let t25 = fma(f[2], t13, t23);
    let t26 = f[3] * g[3];
    let t28 = fma(0.2820948, t26, t22);
    let t29 = g[3] * t12;
    let t31 = fma(f[3], t13, t29);
    return array<f32, 4>(
        t28, t19, t25, t31,
    );
}

// The product of `f` with itself, at about two thirds of a product's cost.
// Source: Ren et al. 2006, eq. 3 with g = f.
// 12 multiplications, 3 additions.
fn sh2_square(f: array<f32, 4>) -> array<f32, 4> {
    let t5 = f[0] * f[0];
    let t7 = t5 * 0.2820948;
    let t9 = f[0] * 0.5641896;
    let t10 = f[1] * f[1];
    let t12 = fma(0.2820948, t10, t7);
    let t13 = f[1] * t9;
    let t14 = f[2] * f[2];
    let t16 = fma(0.2820948, t14, t12);
    let t17 = f[2] * t9;
    let t18 = f[3] * f[3];
    let t20 = fma(0.2820948, t18, t16);
    let t21 = f[3] * t9;
    return array<f32, 4>(
        t20, t13, t17, t21,
    );
}

// The product `f * H(d)` with the cosine lobe about `d`, cheaper than forming and multiplying it: what remains is a dot
// product with each channel of the light.
// Source: Ren et al. 2006, eq. 3 and 9.
// 20 multiplications, 6 additions.
fn sh2_product_cosine(f: array<f32, 4>, d: vec3<f32>) -> array<f32, 4> {
    let t13 = d.y * 0.48860252;
    let t14 = d.z * 0.48860252;
    let t15 = d.x * 0.48860252;
    let t16 = 0.6666667 * t13;
    let t17 = 0.6666667 * t14;
    let t18 = 0.6666667 * t15;
    let t19 = f[0] * 0.2820948;
    let t20 = 0.2820948 * t19;
    let t22 = f[1] * t16;
    let t24 = fma(0.2820948, t22, t20);
    let t25 = t16 * t19;
    let t27 = fma(f[1], 0.07957747, t25);
    let t28 = f[2] * t17;
    let t30 = fma(0.2820948, t28, t24);
    let t31 = t17 * t19;
    let t33 = fma(f[2], 0.07957747, t31);
    let t34 = f[3] * t18;
    let t36 = fma(0.2820948, t34, t30);
    let t37 = t18 * t19;
    let t39 = fma(f[3], 0.07957747, t37);
    return array<f32, 4>(
        t36, t27, t33, t39,
    );
}

// The integral of the product of three functions over the sphere.
// Source: Ren et al. 2006, section 3: (a, b, c) = (a * b) * c.
// 20 multiplications, 9 additions.
fn sh2_triple(f: array<f32, 4>, g: array<f32, 4>, h: array<f32, 4>) -> f32 {
    let t13 = f[0] * g[0];
    let t15 = t13 * 0.2820948;
    let t16 = f[0] * 0.2820948;
    let t17 = g[0] * 0.2820948;
    let t18 = f[1] * g[1];
    let t20 = fma(0.2820948, t18, t15);
    let t21 = g[1] * t16;
    let t23 = fma(f[1], t17, t21);
    let t24 = f[2] * g[2];
    let t26 = fma(0.2820948, t24, t20);
    let t27 = g[2] * t16;
    let t29 = fma(f[2], t17, t27);
    let t30 = f[3] * g[3];
    let t32 = fma(0.2820948, t30, t26);
    let t33 = g[3] * t16;
    let t35 = fma(f[3], t17, t33);
    let t36 = h[0] * t32;
    let t37 = fma(h[1], t23, t36);
    let t38 = fma(h[2], t29, t37);
    let t39 = fma(h[3], t35, t38);
    return t39;
}

// The integral of the product of two functions over the sphere.
// Source: Orthonormality: integral of f g = sum of f_i g_i.
// 4 multiplications, 3 additions.
fn sh2_dot(f: array<f32, 4>, g: array<f32, 4>) -> f32 {
    let t9 = f[0] * g[0];
    let t10 = fma(f[1], g[1], t9);
    let t11 = fma(f[2], g[2], t10);
    let t12 = fma(f[3], g[3], t11);
    return t12;
}

// The symmetric matrix of multiplication by `f`: its lower triangle, row by row.
// Source: Ren et al. 2006, eq. 5.
// 4 multiplications, 0 additions.
fn sh2_product_matrix(f: array<f32, 4>) -> array<f32, 10> {
    let t5 = f[0] * 0.2820948;
    let t6 = f[1] * 0.2820948;
    let t7 = f[2] * 0.2820948;
    let t8 = f[3] * 0.2820948;
    return array<f32, 10>(
        t5, t6, t5, t7, 0.0, t5, t8, 0.0, 0.0, t5,
    );
}

// A symmetric matrix, given by its lower triangle, times a vector.
// Source: With the product matrix of f: M_f g = f * g.
// 16 multiplications, 12 additions.
fn sh2_matrix_apply(m: array<f32, 10>, g: array<f32, 4>) -> array<f32, 4> {
    let t15 = m[0] * g[0];
    let t16 = fma(m[1], g[1], t15);
    let t17 = fma(m[3], g[2], t16);
    let t18 = fma(m[6], g[3], t17);
    let t19 = m[1] * g[0];
    let t20 = fma(m[2], g[1], t19);
    let t21 = fma(m[4], g[2], t20);
    let t22 = fma(m[7], g[3], t21);
    let t23 = m[3] * g[0];
    let t24 = fma(m[4], g[1], t23);
    let t25 = fma(m[5], g[2], t24);
    let t26 = fma(m[8], g[3], t25);
    let t27 = m[6] * g[0];
    let t28 = fma(m[7], g[1], t27);
    let t29 = fma(m[8], g[2], t28);
    let t30 = fma(m[9], g[3], t29);
    return array<f32, 4>(
        t18, t22, t26, t30,
    );
}

// `f` rotated by the unit quaternion `q` = (x, y, z, w): (Rf)(s) = f(R^-1s).
//
// As accurate for tilts of 1e-7 as for any other rotation.
// Source: R_z(alpha) R_y(beta) R_z(gamma) with the angles' cosines and sines from the quaternion; R_y by quarter turns
// about x.
// 33 multiplications, 14 additions.
fn sh2_rotate(f: array<f32, 4>, q: vec4<f32>) -> array<f32, 4> {
    let t8 = q.z * q.z;
    let t9 = fma(q.w, q.w, t8);
    let t13 = sqrt(t9);
    let t14 = q.w / t13;
    let t15 = q.z / t13;
    let t16 = select(t14, 1.0, t9 < 1e-36);
    let t17 = select(t15, 0.0, t9 < 1e-36);
    let t18 = q.x * q.x;
    let t19 = fma(q.y, q.y, t18);
    let t20 = sqrt(t19);
    let t21 = q.y / t20;
    let t22 = q.x / t20;
    let t23 = select(t21, 1.0, t19 < 1e-36);
    let t24 = select(t22, 0.0, t19 < 1e-36);
    let t25 = t17 * t24;
    let t26 = t17 * t23;
    let t27 = fma(t16, t23, -t25);
    let t28 = fma(t16, t24, t26);
    let t29 = fma(t16, t23, t25);
    let t30 = fma(-t16, t24, t26);
    let t31 = t9 + t19;
    let t32 = t9 - t19;
    let t33 = t32 / t31;
    let t34 = t9 * t19;
    let t35 = sqrt(t34);
    let t37 = t35 * 2.0;
    let t38 = t37 / t31;
    let t39 = f[1] * t28;
    let t40 = f[1] * t27;
    let t41 = fma(f[3], t27, -t39);
    let t42 = fma(f[3], t28, t40);
    let t43 = f[2] * t38;
    let t44 = f[2] * t33;
    let t45 = fma(t33, t41, t43);
    let t46 = fma(t38, t41, -t44);
    let t47 = t30 * t42;
    let t48 = t29 * t42;
    let t49 = fma(t29, t45, -t47);
    let t50 = fma(t30, t45, t48);
    return array<f32, 4>(
        f[0], t50, -t46, t49,
    );
}

// `f` rotated by the rotation matrix `m`, given row by row: (Rf)(s) = f(R^-1s).
// Source: Shepperd 1978 to a quaternion, then as `rotate`.
// 33 multiplications, 30 additions.
fn sh2_rotate_matrix(f: array<f32, 4>, m: array<f32, 9>) -> array<f32, 4> {
    let t14 = m[0] + 1.0;
    let t15 = t14 - m[4];
    let t16 = t15 - m[8];
    let t17 = 1.0 - m[0];
    let t18 = m[4] + t17;
    let t19 = t18 - m[8];
    let t20 = t17 - m[4];
    let t21 = m[8] + t20;
    let t22 = m[4] + t14;
    let t23 = m[8] + t22;
    let t24 = m[1] + m[3];
    let t25 = m[2] + m[6];
    let t26 = m[5] + m[7];
    let t27 = m[7] - m[5];
    let t28 = m[2] - m[6];
    let t29 = m[3] - m[1];
    let t30 = select(t16, t24, t16 < t19);
    let t31 = select(t24, t19, t16 < t19);
    let t32 = select(t25, t26, t16 < t19);
    let t33 = select(t27, t28, t16 < t19);
    let t34 = select(t16, t19, t16 < t19);
    let t35 = select(t30, t25, t34 < t21);
    let t36 = select(t31, t26, t34 < t21);
    let t37 = select(t32, t21, t34 < t21);
    let t38 = select(t33, t29, t34 < t21);
    let t39 = select(t34, t21, t34 < t21);
    let t40 = select(t35, t27, t39 < t23);
    let t41 = select(t36, t28, t39 < t23);
    let t42 = select(t37, t29, t39 < t23);
    let t43 = select(t38, t23, t39 < t23);
    let t45 = t42 * t42;
    let t46 = fma(t43, t43, t45);
    let t49 = sqrt(t46);
    let t50 = t43 / t49;
    let t51 = t42 / t49;
    let t52 = select(t50, 1.0, t46 < 1e-36);
    let t53 = select(t51, 0.0, t46 < 1e-36);
    let t54 = t40 * t40;
    let t55 = fma(t41, t41, t54);
    let t56 = sqrt(t55);
    let t57 = t41 / t56;
    let t58 = t40 / t56;
    let t59 = select(t57, 1.0, t55 < 1e-36);
    let t60 = select(t58, 0.0, t55 < 1e-36);
    let t61 = t53 * t60;
    let t62 = t53 * t59;
    let t63 = fma(t52, t59, -t61);
    let t64 = fma(t52, t60, t62);
    let t65 = fma(t52, t59, t61);
    let t66 = fma(-t52, t60, t62);
    let t67 = t46 + t55;
    let t68 = t46 - t55;
    let t69 = t68 / t67;
    let t70 = t46 * t55;
    let t71 = sqrt(t70);
    let t73 = t71 * 2.0;
    let t74 = t73 / t67;
    let t75 = f[1] * t64;
    let t76 = f[1] * t63;
    let t77 = fma(f[3], t63, -t75);
    let t78 = fma(f[3], t64, t76);
    let t79 = f[2] * t74;
    let t80 = f[2] * t69;
    let t81 = fma(t69, t77, t79);
    let t82 = fma(t74, t77, -t80);
    let t83 = t66 * t78;
    let t84 = t65 * t78;
    let t85 = fma(t65, t81, -t83);
    let t86 = fma(t66, t81, t84);
    return array<f32, 4>(
        f[0], t86, -t82, t85,
    );
}

// `f` with band l scaled by cos(pi/2 * l/h), and by 0 for l >= h: against ringing. `h` must be positive; 2n is a mild
// window.
// Source: Ren et al. 2006, section 7.
// 15 multiplications, 10 additions.
fn sh2_window(f: array<f32, 4>, h: f32) -> array<f32, 4> {
    let t6 = 1.5707964 / h;
    let t7 = t6 * t6;
    let t12 = fma(t7, 4.1103176e-19, (-1.5619207e-16));
    let t14 = fma(t7, t12, 4.7794773e-14);
    let t16 = fma(t7, t14, (-1.1470745e-11));
    let t18 = fma(t7, t16, 2.0876756e-9);
    let t20 = fma(t7, t18, (-2.755732e-7));
    let t22 = fma(t7, t20, 2.4801588e-5);
    let t24 = fma(t7, t22, (-0.0013888889));
    let t26 = fma(t7, t24, 0.041666668);
    let t28 = fma(t7, t26, (-0.5));
    let t29 = fma(t7, t28, 1.0);
    let t32 = select(0.0, t29, 1.0 < h);
    let t33 = f[1] * t32;
    let t34 = f[2] * t32;
    let t35 = f[3] * t32;
    return array<f32, 4>(
        f[0], t33, t34, t35,
    );
}

// Zonal coefficients of the visibility past a circular blocker of angular radius theta about +Z, for any theta in
// 0..pi, from its cosine and sine.
// Source: Ren et al. 2006, eq. 33, integrated in closed form.
// 3 multiplications, 1 additions.
fn sh2_cap_visibility(cosine: f32, sine: f32) -> array<f32, 2> {
    let t2 = sine * sine;
    let t5 = fma(cosine, 1.7724539, 1.7724539);
    let t8 = t2 * 1.5349901;
    return array<f32, 2>(
        t5, -t8,
    );
}

// Zonal coefficients of the eigen logarithm of the visibility past a circular blocker of angular radius theta about +Z,
// for theta in 0..pi/2, from its sine and cosine; no table look-up.
//
// Against the eigen logarithm, whose values reach 6.5, it errs by at most 0.004, 0.46, 0.41, 0.37 and 0.43 at orders 2
// to 6, near the kinks where an eigenvalue is clipped; in the visibility that the exponential makes of it by at most
// 0.001, 0.060, 0.047, 0.042 and 0.036 of full visibility, as much as the eigen logarithm itself. Beyond pi/2 the
// polynomials mean nothing: hand in pi/2.
// Source: Ren et al. 2006, eq. 30-32, fitted; `gaunt-lab fit` rewrites the coefficients and states their error.
// 18 multiplications, 15 additions.
fn sh2_cap_log(sine: f32, cosine: f32) -> array<f32, 2> {
    let t2 = sine * sine;
    let t5 = fma(cosine, 2.0, (-1.0));
    let t9 = fma(t5, 0.13522413, (-0.20001054));
    let t11 = fma(t5, t9, 0.043783836);
    let t13 = fma(t5, t11, (-0.10583181));
    let t15 = fma(t5, t13, 0.40180758);
    let t17 = fma(t5, t15, (-0.7426351));
    let t19 = fma(t5, t17, 1.4316994);
    let t21 = fma(t5, t19, (-1.8497804));
    let t22 = t2 * t21;
    let t25 = fma(t5, 0.13386823, (-0.19626692));
    let t27 = fma(t5, t25, 0.03531555);
    let t29 = fma(t5, t27, (-0.0855273));
    let t31 = fma(t5, t29, 0.33883712);
    let t33 = fma(t5, t31, (-0.6274035));
    let t35 = fma(t5, t33, 1.057221);
    let t37 = fma(t5, t35, (-2.1905527));
    let t38 = t2 * t37;
    return array<f32, 2>(
        t22, t38,
    );
}

// `f` plus the logarithm of the visibility past a circular blocker about the unit vector `d`: what one blocker costs a
// receiver. The angular radius theta in 0..pi/2 comes as its sine and cosine.
// Source: Ren et al. 2006, eq. 34 and 8, with the fitted logarithm of `cap_log`.
// 25 multiplications, 19 additions.
fn sh2_add_cap_log(f: array<f32, 4>, sine: f32, cosine: f32, d: vec3<f32>) -> array<f32, 4> {
    let t9 = sine * sine;
    let t12 = fma(cosine, 2.0, (-1.0));
    let t16 = fma(t12, 0.47935706, (-0.7090189));
    let t18 = fma(t12, t16, 0.15520966);
    let t20 = fma(t12, t18, (-0.375164));
    let t22 = fma(t12, t20, 1.4243708);
    let t24 = fma(t12, t22, (-2.6325727));
    let t26 = fma(t12, t24, 5.075242);
    let t28 = fma(t12, t26, (-6.5573006));
    let t29 = t9 * t28;
    let t32 = fma(t12, 0.27398187, (-0.40169036));
    let t34 = fma(t12, t32, 0.07227869);
    let t36 = fma(t12, t34, (-0.17504475));
    let t38 = fma(t12, t36, 0.6934821);
    let t40 = fma(t12, t38, (-1.2840774));
    let t42 = fma(t12, t40, 2.1637652);
    let t44 = fma(t12, t42, (-4.4833026));
    let t45 = t9 * t44;
    let t49 = d.y * 0.48860252;
    let t50 = d.z * 0.48860252;
    let t51 = d.x * 0.48860252;
    let t52 = fma(t29, 0.2820948, f[0]);
    let t53 = fma(t45, t49, f[1]);
    let t54 = fma(t45, t50, f[2]);
    let t55 = fma(t45, t51, f[3]);
    return array<f32, 4>(
        t52, t53, t54, t55,
    );
}

// As `cap_log`, fitted to `exp_saturating` in the place of the eigen logarithm: sums of it over blockers are what that
// exponential is made for, and no other is. theta in 0..pi/2.
// Source: Ren et al. 2006, eq. 33-34, with the logarithm fitted against true visibilities; `gaunt-lab fit` rewrites the
// coefficients, `gaunt-lab accuracy` states their error.
// 12 multiplications, 9 additions.
fn sh2_cap_log_saturating(sine: f32, cosine: f32) -> array<f32, 2> {
    let t2 = sine * sine;
    let t5 = fma(cosine, 2.0, (-1.0));
    let t9 = fma(t5, 0.6854817, 1.740299);
    let t11 = fma(t5, t9, (-3.1793683));
    let t13 = fma(t5, t11, 2.1157002);
    let t15 = fma(t5, t13, (-1.4158641));
    let t16 = t2 * t15;
    let t19 = fma(t5, 1.8174903, 0.1310522);
    let t21 = fma(t5, t19, (-3.8702803));
    let t23 = fma(t5, t21, 3.0674944);
    let t25 = fma(t5, t23, (-2.001539));
    let t26 = t2 * t25;
    return array<f32, 2>(
        t16, t26,
    );
}

// `f` plus the logarithm `cap_log_saturating` of the visibility past a circular blocker about the unit vector `d`: what
// one blocker costs a receiver of the shadow pass. The angular radius theta in 0..pi/2 comes as its sine and cosine.
// Source: Ren et al. 2006, eq. 34 and 8, with the fitted logarithm of `cap_log_saturating`.
// 19 multiplications, 13 additions.
fn sh2_add_cap_log_saturating(f: array<f32, 4>, sine: f32, cosine: f32, d: vec3<f32>) -> array<f32, 4> {
    let t9 = sine * sine;
    let t12 = fma(cosine, 2.0, (-1.0));
    let t16 = fma(t12, 2.4299695, 6.1691995);
    let t18 = fma(t12, t16, (-11.270567));
    let t20 = fma(t12, t18, 7.499962);
    let t22 = fma(t12, t20, (-5.0191073));
    let t23 = t9 * t22;
    let t26 = fma(t12, 3.7197728, 0.2682184);
    let t28 = fma(t12, t26, (-7.9211226));
    let t30 = fma(t12, t28, 6.278098);
    let t32 = fma(t12, t30, (-4.0964565));
    let t33 = t9 * t32;
    let t37 = d.y * 0.48860252;
    let t38 = d.z * 0.48860252;
    let t39 = d.x * 0.48860252;
    let t40 = fma(t23, 0.2820948, f[0]);
    let t41 = fma(t33, t37, f[1]);
    let t42 = fma(t33, t38, f[2]);
    let t43 = fma(t33, t39, f[3]);
    return array<f32, 4>(
        t40, t41, t42, t43,
    );
}

// As `cap_log`, fitted to `transfer` in the place of the eigen logarithm. theta in 0..pi/2; of a small one band l is
// that of what the circle hides, so that few small blockers cast the whole of their shadow.
// Source: Ren et al. 2006, eq. 33-34, with the logarithm fitted against true transfers; `gaunt-lab fit` rewrites the
// coefficients.
// 10 multiplications, 7 additions.
fn sh2_cap_log_shading(sine: f32, cosine: f32) -> array<f32, 2> {
    let t2 = sine * sine;
    let t5 = fma(cosine, 2.0, (-1.0));
    let t9 = fma(-t5, 4.804484, 0.31604287);
    let t11 = fma(t5, t9, 8.363991);
    let t13 = fma(t5, t11, (-4.7617764));
    let t14 = t2 * t13;
    let t17 = fma(-t5, 1.187361, 4.5963564);
    let t19 = fma(t5, t17, 0.30570382);
    let t21 = fma(t5, t19, (-5.249689));
    let t22 = t2 * t21;
    return array<f32, 2>(
        t14, t22,
    );
}

// A sum of blockers plus one more: what one blocker of a cut costs a receiver of the shadow pass. The logarithm
// `cap_log_shading` about the unit vector `d`, band l of it times `w[l]`: a blocker's own weight, times the ratio
// vector of one that stands for several. Coefficients of the sum lack a factor each, which `accumulated_log` puts in at
// the end; it costs as little for many blockers as for one.
// Source: Ren et al. 2006, eq. 38, with the fitted logarithm of `cap_log_shading`.
// 15 multiplications, 11 additions.
fn sh2_accumulate_blocker(f: array<f32, 4>, sine: f32, cosine: f32, d: vec3<f32>, w: array<f32, 2>) -> array<f32, 4> {
    let t11 = sine * sine;
    let t12 = w[0] * t11;
    let t13 = w[1] * t11;
    let t16 = fma(cosine, 2.0, (-1.0));
    let t20 = fma(-t16, 4.804484, 0.31604287);
    let t22 = fma(t16, t20, 8.363991);
    let t24 = fma(t16, t22, (-4.7617764));
    let t28 = fma(-t16, 1.187361, 4.5963564);
    let t30 = fma(t16, t28, 0.30570382);
    let t32 = fma(t16, t30, (-5.249689));
    let t33 = t13 * t32;
    let t35 = fma(t12, t24, f[0]);
    let t36 = fma(d.y, t33, f[1]);
    let t37 = fma(d.z, t33, f[2]);
    let t38 = fma(d.x, t33, f[3]);
    return array<f32, 4>(
        t35, t36, t37, t38,
    );
}

// As `accumulate_blocker`, with the logarithm `cap_log_saturating`: for `exp_saturating`, where the visibility itself
// is asked for.
// Source: Ren et al. 2006, eq. 38, with the fitted logarithm of `cap_log_saturating`.
// 17 multiplications, 13 additions.
fn sh2_accumulate_blocker_saturating(f: array<f32, 4>, sine: f32, cosine: f32, d: vec3<f32>, w: array<f32, 2>) -> array<f32, 4> {
    let t11 = sine * sine;
    let t12 = w[0] * t11;
    let t13 = w[1] * t11;
    let t16 = fma(cosine, 2.0, (-1.0));
    let t20 = fma(t16, 0.6854817, 1.740299);
    let t22 = fma(t16, t20, (-3.1793683));
    let t24 = fma(t16, t22, 2.1157002);
    let t26 = fma(t16, t24, (-1.4158641));
    let t30 = fma(t16, 1.8174903, 0.1310522);
    let t32 = fma(t16, t30, (-3.8702803));
    let t34 = fma(t16, t32, 3.0674944);
    let t36 = fma(t16, t34, (-2.001539));
    let t37 = t13 * t36;
    let t39 = fma(t12, t26, f[0]);
    let t40 = fma(d.y, t37, f[1]);
    let t41 = fma(d.z, t37, f[2]);
    let t42 = fma(d.x, t37, f[3]);
    return array<f32, 4>(
        t39, t40, t41, t42,
    );
}

// The logarithm of the visibility past all blockers that `accumulate_blocker` has summed up: each coefficient times its
// factor.
// Source: The leading coefficients of the basis functions, as polynomials in z, and sqrt(4 pi/(2l+1)).
// 0 multiplications, 0 additions.
fn sh2_accumulated_log(f: array<f32, 4>) -> array<f32, 4> {
    return array<f32, 4>(
        f[0], f[1], f[2], f[3],
    );
}

// The vector whose dot product with what a ball's surface emits, a function of the direction from its centre, is the
// mean radiance that is seen of it: of all that is in sight, by solid angle. `d` points from the ball to where it is
// seen from, the angular radius theta in 0..pi/2 comes as its sine and cosine.
//
// Band l is y_l(d) times the mean of P_l(cos alpha) over what is in sight, alpha the angle from `d`: from far away,
// weights are the cosines of the surface's slope, near by those of a small cap. That mean is fitted to 3e-6.
// Source: Guerrero et al. 2008, eq. 16-18, with weights by solid angle, (cos alpha - s)/(1 - 2 s cos alpha +
// s^2)^(3/2), s = sin theta, where eq. 17 has the root alone; `gaunt-lab fit` rewrites the coefficients.
// 15 multiplications, 9 additions.
fn sh2_ball_average(sine: f32, cosine: f32, d: vec3<f32>) -> array<f32, 4> {
    let t9 = fma(cosine, 0.10139153, (-0.4891273));
    let t11 = fma(cosine, t9, 0.3260717);
    let t13 = fma(cosine, t11, 1.0740308);
    let t15 = fma(cosine, t13, (-1.3456995));
    let t18 = fma(cosine, 0.052248806, 0.17544451);
    let t20 = fma(cosine, t18, (-1.0734253));
    let t22 = fma(cosine, t20, 1.3456732);
    let t23 = fma(sine, t22, t15);
    let t24 = fma(cosine, t23, 1.0);
    let t28 = d.y * 0.48860252;
    let t29 = d.z * 0.48860252;
    let t30 = d.x * 0.48860252;
    let t31 = t24 * t28;
    let t32 = t24 * t29;
    let t33 = t24 * t30;
    return array<f32, 4>(
        0.2820948, t31, t32, t33,
    );
}

// Which part of a disc in the sky of angular radius `a` another of radius `b` covers whose middle is at the distance
// `d`; radians, radii up to pi/2.
//
// The share of flat discs, fitted to 0.016, with angles for lengths; of those on a sphere it errs by 0.0165 for radii
// up to 20 degrees, 0.0205 up to 40 degrees, 0.045 up to 60 degrees, 0.087 up to 80 degrees and 0.12 up to 90 degrees,
// most where two of one size overlap by half. 0 for discs that do not touch, 1 for one that is covered, and nothing
// between is below or above.
// Source: The lens of two circles, fitted in place of its inverse cosines; `gaunt-lab fit` rewrites the coefficients.
// 16 multiplications, 15 additions.
fn sh2_disc_covered(a: f32, b: f32, d: f32) -> f32 {
    let t7 = a * b;
    let t8 = max(t7, 1e-12);
    let t9 = 1.0 / t8;
    let t10 = min(a, b);
    let t11 = max(a, b);
    let t12 = t10 * t10;
    let t13 = t9 * t12;
    let t14 = a + b;
    let t15 = t14 - d;
    let t16 = t11 * t15;
    let t17 = t9 * t16;
    let t18 = 0.5 * t17;
    let t19 = max(t18, 0.0);
    let t20 = min(t19, 1.0);
    let t23 = fma(-t13, 0.089969344, 0.34108743);
    let t26 = fma(-t13, 0.60770965, 2.0002413);
    let t27 = 1.0 - t23;
    let t28 = t27 - t26;
    let t29 = fma(t20, t28, t26);
    let t30 = fma(t20, t29, t23);
    let t31 = t20 * t30;
    let t32 = max(t31, 0.0);
    let t33 = b * b;
    let t34 = t9 * t33;
    let t35 = t34 * t34;
    let t36 = min(t35, 1.0);
    let t37 = t32 * t36;
    return t37;
}

// The visibility behind all blockers from `f`, the sum of their `cap_log_saturating`: samples of f, held in bounds by a
// fitted function in the place of e^x, projected back. The exponential of the shadow pass.
//
// With x = f/sqrt(1 + beta|f^|^2/4 pi), f^ being f without its mean, and t = x(s) held in -1..0.2, a sample becomes
// h(t) = ((1 + t)(1 - t/4))^2: 1 for f = 0, at most 1.2996, and 0 where f says dark. Ripples of many overlapping
// blockers, which grow with their number, are compressed to the size of one blocker's; no |f| makes it diverge.
//
// Promises for any finite f: every sample lies in 0..=1.2996 before projection; the norm of the result is at most
// 1.2996 sqrt(4 pi) (2 % more at order 6, where a band's gain is 1.02). A number that is not finite makes the result
// NaN or finite, never infinite. f is told apart up to |f^| = 3e18.
// Source: Sampling rules: Lebedev 1976; beta, the gains of the projection's bands and the logarithm fitted against true
// visibilities by `gaunt-lab fit`.
// 69 multiplications, 110 additions.
fn sh2_exp_saturating(f: array<f32, 4>) -> array<f32, 4> {
    let t5 = f[1] * f[1];
    let t6 = fma(f[2], f[2], t5);
    let t7 = fma(f[3], f[3], t6);
    let t9 = min(t7, 1e37);
    let t12 = fma(t9, 0.5608034, 1.0);
    let t13 = sqrt(t12);
    let t14 = 1.0 / t13;
    let t15 = f[0] * t14;
    let t16 = f[1] * t14;
    let t17 = f[2] * t14;
    let t18 = f[3] * t14;
    let t23 = t15 * 0.2820948;
    let t25 = t18 * 0.48860252;
    let t26 = t23 + t25;
    let t27 = t23 - t25;
    let t28 = max(t26, (-1.0));
    let t29 = min(t28, 0.2);
    let t30 = fma((-0.25), t29, 0.75);
    let t31 = fma(t29, t30, 1.0);
    let t32 = t31 * t31;
    let t33 = max(t27, (-1.0));
    let t34 = min(t33, 0.2);
    let t35 = fma((-0.25), t34, 0.75);
    let t36 = fma(t34, t35, 1.0);
    let t37 = t36 * t36;
    let t38 = t32 + t37;
    let t39 = t32 - t37;
    let t41 = t38 * 0.23632719;
    let t43 = t39 * 0.34255838;
    let t44 = t16 * 0.48860252;
    let t45 = t23 + t44;
    let t46 = t23 - t44;
    let t47 = max(t45, (-1.0));
    let t48 = min(t47, 0.2);
    let t49 = fma((-0.25), t48, 0.75);
    let t50 = fma(t48, t49, 1.0);
    let t51 = t50 * t50;
    let t52 = max(t46, (-1.0));
    let t53 = min(t52, 0.2);
    let t54 = fma((-0.25), t53, 0.75);
    let t55 = fma(t53, t54, 1.0);
    let t56 = t55 * t55;
    let t57 = t51 + t56;
    let t58 = t51 - t56;
    let t59 = fma(0.23632719, t57, t41);
    let t60 = 0.34255838 * t58;
    let t61 = t17 * 0.48860252;
    let t62 = t23 + t61;
    let t63 = t23 - t61;
    let t64 = max(t62, (-1.0));
    let t65 = min(t64, 0.2);
    let t66 = fma((-0.25), t65, 0.75);
    let t67 = fma(t65, t66, 1.0);
    let t68 = t67 * t67;
    let t69 = max(t63, (-1.0));
    let t70 = min(t69, 0.2);
    let t71 = fma((-0.25), t70, 0.75);
    let t72 = fma(t70, t71, 1.0);
    let t73 = t72 * t72;
    let t74 = t68 + t73;
    let t75 = t68 - t73;
    let t76 = fma(0.23632719, t74, t59);
    let t77 = 0.34255838 * t75;
    let t78 = t16 * 0.2820948;
    let t79 = t17 * 0.2820948;
    let t80 = t18 * 0.2820948;
    let t81 = t23 + t80;
    let t82 = t23 - t80;
    let t83 = t78 + t81;
    let t84 = t81 - t78;
    let t85 = t78 + t82;
    let t86 = t82 - t78;
    let t87 = t79 + t83;
    let t88 = t83 - t79;
    let t89 = t79 + t85;
    let t90 = t85 - t79;
    let t91 = t79 + t84;
    let t92 = t84 - t79;
    let t93 = t79 + t86;
    let t94 = t86 - t79;
    let t95 = max(t87, (-1.0));
    let t96 = min(t95, 0.2);
    let t97 = fma((-0.25), t96, 0.75);
    let t98 = fma(t96, t97, 1.0);
    let t99 = t98 * t98;
    let t100 = max(t89, (-1.0));
    let t101 = min(t100, 0.2);
    let t102 = fma((-0.25), t101, 0.75);
    let t103 = fma(t101, t102, 1.0);
    let t104 = t103 * t103;
    let t105 = max(t91, (-1.0));
    let t106 = min(t105, 0.2);
    let t107 = fma((-0.25), t106, 0.75);
    let t108 = fma(t106, t107, 1.0);
    let t109 = t108 * t108;
    let t110 = max(t93, (-1.0));
    let t111 = min(t110, 0.2);
    let t112 = fma((-0.25), t111, 0.75);
    let t113 = fma(t111, t112, 1.0);
    let t114 = t113 * t113;
    let t115 = max(t88, (-1.0));
    let t116 = min(t115, 0.2);
    let t117 = fma((-0.25), t116, 0.75);
    let t118 = fma(t116, t117, 1.0);
    let t119 = t118 * t118;
    let t120 = max(t90, (-1.0));
    let t121 = min(t120, 0.2);
    let t122 = fma((-0.25), t121, 0.75);
    let t123 = fma(t121, t122, 1.0);
    let t124 = t123 * t123;
    let t125 = max(t92, (-1.0));
    let t126 = min(t125, 0.2);
    let t127 = fma((-0.25), t126, 0.75);
    let t128 = fma(t126, t127, 1.0);
    let t129 = t128 * t128;
    let t130 = max(t94, (-1.0));
    let t131 = min(t130, 0.2);
    let t132 = fma((-0.25), t131, 0.75);
    let t133 = fma(t131, t132, 1.0);
    let t134 = t133 * t133;
    let t135 = t99 + t104;
    let t136 = t99 - t104;
    let t137 = t109 + t114;
    let t138 = t109 - t114;
    let t139 = t119 + t124;
    let t140 = t119 - t124;
    let t141 = t129 + t134;
    let t142 = t129 - t134;
    let t143 = t135 + t137;
    let t144 = t135 - t137;
    let t145 = t136 + t138;
    let t147 = t139 + t141;
    let t148 = t139 - t141;
    let t149 = t140 + t142;
    let t151 = t143 + t147;
    let t152 = t143 - t147;
    let t153 = t145 + t149;
    let t155 = t144 + t148;
    let t160 = fma(t151, 0.26586807, t76);
    let t162 = fma(t155, 0.22249821, t60);
    let t163 = fma(t152, 0.22249821, t77);
    let t164 = fma(t153, 0.22249821, t43);
    return array<f32, 4>(
        t160, t162, t163, t164,
    );
}

// The transfer from light to what a surface of unit normal `d` reflects behind blockers, from `f`, the sum of their
// `cap_log_shading`: exp(f) times the cosine lobe over pi, projected. Its dot product with a channel of the light is
// reflected radiance. What the shadow pass takes.
//
// At samples x = f(s)/sqrt(1 + beta|f^|^2/4 pi), f^ being f without its mean, held in -4..1/2, visibility is (1 +
// x/4)^4: 1 for f = 0, 0 where f says dark, at most 1.602. It is multiplied with the lobe there, of which all bands up
// to 2n - 2 are taken: those that couple light of order n with visibility of order n. Light of a lower order takes the
// first coefficients; that way all bands of the visibility are used.
//
// Promises for any finite f: the norm of the result is at most 1.602 times the lobe's at the samples, 0.82. Without
// blockers it is `cosine`. f is told apart up to |f^| = 3e18.
// Source: (L, H(N), g) = L * (g * H(N)), Ren et al. 2006, eq. 10, by quadrature (Lebedev 1976); beta and the logarithm
// fitted against true transfers by `gaunt-lab fit`.
// 114 multiplications, 123 additions.
fn sh2_transfer(f: array<f32, 4>, d: vec3<f32>) -> array<f32, 4> {
    let t9 = f[1] * f[1];
    let t10 = fma(f[2], f[2], t9);
    let t11 = fma(f[3], f[3], t10);
    let t13 = min(t11, 1e37);
    let t16 = fma(t13, 0.13740845, 1.0);
    let t17 = sqrt(t16);
    let t18 = 1.0 / t17;
    let t19 = f[0] * t18;
    let t20 = f[1] * t18;
    let t21 = f[2] * t18;
    let t22 = f[3] * t18;
    let t26 = t19 * 0.2820948;
    let t28 = t22 * 0.48860252;
    let t29 = t26 + t28;
    let t30 = t26 - t28;
    let t31 = fma(0.25, t29, 1.0);
    let t32 = max(t31, 0.0);
    let t33 = min(t32, 1.125);
    let t34 = t33 * t33;
    let t35 = t34 * t34;
    let t36 = d.x * d.x;
    let t39 = fma(t36, 0.14920776, 0.029841552);
    let t40 = fma(d.x, 0.15915494, t39);
    let t41 = t35 * t40;
    let t42 = fma(0.25, t30, 1.0);
    let t43 = max(t42, 0.0);
    let t44 = min(t43, 1.125);
    let t45 = t44 * t44;
    let t46 = t45 * t45;
    let t47 = fma(-d.x, 0.15915494, t39);
    let t48 = t46 * t47;
    let t49 = t41 + t48;
    let t50 = t41 - t48;
    let t52 = t49 * 0.23632719;
    let t54 = t50 * 0.4093307;
    let t55 = t20 * 0.48860252;
    let t56 = t26 + t55;
    let t57 = t26 - t55;
    let t58 = fma(0.25, t56, 1.0);
    let t59 = max(t58, 0.0);
    let t60 = min(t59, 1.125);
    let t61 = t60 * t60;
    let t62 = t61 * t61;
    let t63 = d.y * d.y;
    let t64 = fma(0.14920776, t63, 0.029841552);
    let t65 = fma(d.y, 0.15915494, t64);
    let t66 = t62 * t65;
    let t67 = fma(0.25, t57, 1.0);
    let t68 = max(t67, 0.0);
    let t69 = min(t68, 1.125);
    let t70 = t69 * t69;
    let t71 = t70 * t70;
    let t72 = fma(-d.y, 0.15915494, t64);
    let t73 = t71 * t72;
    let t74 = t66 + t73;
    let t75 = t66 - t73;
    let t76 = fma(0.23632719, t74, t52);
    let t77 = 0.4093307 * t75;
    let t78 = t21 * 0.48860252;
    let t79 = t26 + t78;
    let t80 = t26 - t78;
    let t81 = fma(0.25, t79, 1.0);
    let t82 = max(t81, 0.0);
    let t83 = min(t82, 1.125);
    let t84 = t83 * t83;
    let t85 = t84 * t84;
    let t86 = d.z * d.z;
    let t87 = fma(0.14920776, t86, 0.029841552);
    let t88 = fma(d.z, 0.15915494, t87);
    let t89 = t85 * t88;
    let t90 = fma(0.25, t80, 1.0);
    let t91 = max(t90, 0.0);
    let t92 = min(t91, 1.125);
    let t93 = t92 * t92;
    let t94 = t93 * t93;
    let t95 = fma(-d.z, 0.15915494, t87);
    let t96 = t94 * t95;
    let t97 = t89 + t96;
    let t98 = t89 - t96;
    let t99 = fma(0.23632719, t97, t76);
    let t100 = 0.4093307 * t98;
    let t101 = t20 * 0.2820948;
    let t102 = t21 * 0.2820948;
    let t103 = t22 * 0.2820948;
    let t104 = t26 + t103;
    let t105 = t26 - t103;
    let t106 = t101 + t104;
    let t107 = t104 - t101;
    let t108 = t101 + t105;
    let t109 = t105 - t101;
    let t110 = t102 + t106;
    let t111 = t106 - t102;
    let t112 = t102 + t108;
    let t113 = t108 - t102;
    let t114 = t102 + t107;
    let t115 = t107 - t102;
    let t116 = t102 + t109;
    let t117 = t109 - t102;
    let t119 = d.x * 0.57735026;
    let t120 = d.y * 0.57735026;
    let t121 = d.z * 0.57735026;
    let t122 = t119 + t120;
    let t123 = t119 - t120;
    let t124 = t121 + t122;
    let t125 = t122 - t121;
    let t126 = t121 - t123;
    let t127 = t121 + t123;
    let t128 = fma(0.25, t110, 1.0);
    let t129 = max(t128, 0.0);
    let t130 = min(t129, 1.125);
    let t131 = t130 * t130;
    let t132 = t131 * t131;
    let t133 = t124 * t124;
    let t134 = fma(0.14920776, t133, 0.029841552);
    let t135 = fma(0.15915494, t124, t134);
    let t136 = t132 * t135;
    let t137 = fma(0.25, t112, 1.0);
    let t138 = max(t137, 0.0);
    let t139 = min(t138, 1.125);
    let t140 = t139 * t139;
    let t141 = t140 * t140;
    let t142 = t126 * t126;
    let t143 = fma(0.14920776, t142, 0.029841552);
    let t144 = fma(0.15915494, t126, t143);
    let t145 = t141 * t144;
    let t146 = fma(0.25, t114, 1.0);
    let t147 = max(t146, 0.0);
    let t148 = min(t147, 1.125);
    let t149 = t148 * t148;
    let t150 = t149 * t149;
    let t151 = t127 * t127;
    let t152 = fma(0.14920776, t151, 0.029841552);
    let t153 = fma(0.15915494, t127, t152);
    let t154 = t150 * t153;
    let t155 = fma(0.25, t116, 1.0);
    let t156 = max(t155, 0.0);
    let t157 = min(t156, 1.125);
    let t158 = t157 * t157;
    let t159 = t158 * t158;
    let t160 = t125 * t125;
    let t161 = fma(0.14920776, t160, 0.029841552);
    let t162 = fma((-0.15915494), t125, t161);
    let t163 = t159 * t162;
    let t164 = fma(0.25, t111, 1.0);
    let t165 = max(t164, 0.0);
    let t166 = min(t165, 1.125);
    let t167 = t166 * t166;
    let t168 = t167 * t167;
    let t169 = fma(0.15915494, t125, t161);
    let t170 = t168 * t169;
    let t171 = fma(0.25, t113, 1.0);
    let t172 = max(t171, 0.0);
    let t173 = min(t172, 1.125);
    let t174 = t173 * t173;
    let t175 = t174 * t174;
    let t176 = fma((-0.15915494), t127, t152);
    let t177 = t175 * t176;
    let t178 = fma(0.25, t115, 1.0);
    let t179 = max(t178, 0.0);
    let t180 = min(t179, 1.125);
    let t181 = t180 * t180;
    let t182 = t181 * t181;
    let t183 = fma((-0.15915494), t126, t143);
    let t184 = t182 * t183;
    let t185 = fma(0.25, t117, 1.0);
    let t186 = max(t185, 0.0);
    let t187 = min(t186, 1.125);
    let t188 = t187 * t187;
    let t189 = t188 * t188;
    let t190 = fma((-0.15915494), t124, t134);
    let t191 = t189 * t190;
    let t192 = t136 + t145;
    let t193 = t136 - t145;
    let t194 = t154 + t163;
    let t195 = t154 - t163;
    let t196 = t170 + t177;
    let t197 = t170 - t177;
    let t198 = t184 + t191;
    let t199 = t184 - t191;
    let t200 = t192 + t194;
    let t201 = t192 - t194;
    let t202 = t193 + t195;
    let t204 = t196 + t198;
    let t205 = t196 - t198;
    let t206 = t197 + t199;
    let t208 = t200 + t204;
    let t209 = t200 - t204;
    let t210 = t202 + t206;
    let t212 = t201 + t205;
    let t217 = fma(t208, 0.26586807, t99);
    let t218 = fma(t212, 0.26586807, t77);
    let t219 = fma(t209, 0.26586807, t100);
    let t220 = fma(t210, 0.26586807, t54);
    return array<f32, 4>(
        t217, t218, t219, t220,
    );
}

// As `transfer`, with another lobe about the unit vector `d` in the place of the cosine's: band l of it is `w[l]`, held
// in -1..1, times that of a lobe of no width, so that `w[0]` is the share of an even sky that it gives. Without
// blockers it is y_l(d) times `w[l]`.
//
// Promises for any f: the norm of the result is at most 1.602 times the lobe's at the samples, n^2/sqrt(4 pi).
// Source: As `transfer`; the lobe is of the order of `f`.
// 102 multiplications, 120 additions.
fn sh2_transfer_lobe(f: array<f32, 4>, d: vec3<f32>, w: array<f32, 2>) -> array<f32, 4> {
    let t10 = min(w[0], 1.0);
    let t11 = max(t10, (-1.0));
    let t13 = t11 * 0.07957747;
    let t14 = min(w[1], 1.0);
    let t15 = max(t14, (-1.0));
    let t17 = t15 * 0.23873241;
    let t19 = f[1] * f[1];
    let t20 = fma(f[2], f[2], t19);
    let t21 = fma(f[3], f[3], t20);
    let t23 = min(t21, 1e37);
    let t25 = fma(t23, 0.13740845, 1.0);
    let t26 = sqrt(t25);
    let t27 = 1.0 / t26;
    let t28 = f[0] * t27;
    let t29 = f[1] * t27;
    let t30 = f[2] * t27;
    let t31 = f[3] * t27;
    let t35 = t28 * 0.2820948;
    let t37 = t31 * 0.48860252;
    let t38 = t35 + t37;
    let t39 = t35 - t37;
    let t40 = fma(0.25, t38, 1.0);
    let t41 = max(t40, 0.0);
    let t42 = min(t41, 1.125);
    let t43 = t42 * t42;
    let t44 = t43 * t43;
    let t45 = fma(d.x, t17, t13);
    let t46 = t44 * t45;
    let t47 = fma(0.25, t39, 1.0);
    let t48 = max(t47, 0.0);
    let t49 = min(t48, 1.125);
    let t50 = t49 * t49;
    let t51 = t50 * t50;
    let t52 = fma(-d.x, t17, t13);
    let t53 = t51 * t52;
    let t54 = t46 + t53;
    let t55 = t46 - t53;
    let t57 = t54 * 0.23632719;
    let t59 = t55 * 0.4093307;
    let t60 = t29 * 0.48860252;
    let t61 = t35 + t60;
    let t62 = t35 - t60;
    let t63 = fma(0.25, t61, 1.0);
    let t64 = max(t63, 0.0);
    let t65 = min(t64, 1.125);
    let t66 = t65 * t65;
    let t67 = t66 * t66;
    let t68 = fma(d.y, t17, t13);
    let t69 = t67 * t68;
    let t70 = fma(0.25, t62, 1.0);
    let t71 = max(t70, 0.0);
    let t72 = min(t71, 1.125);
    let t73 = t72 * t72;
    let t74 = t73 * t73;
    let t75 = fma(-d.y, t17, t13);
    let t76 = t74 * t75;
    let t77 = t69 + t76;
    let t78 = t69 - t76;
    let t79 = fma(0.23632719, t77, t57);
    let t80 = 0.4093307 * t78;
    let t81 = t30 * 0.48860252;
    let t82 = t35 + t81;
    let t83 = t35 - t81;
    let t84 = fma(0.25, t82, 1.0);
    let t85 = max(t84, 0.0);
    let t86 = min(t85, 1.125);
    let t87 = t86 * t86;
    let t88 = t87 * t87;
    let t89 = fma(d.z, t17, t13);
    let t90 = t88 * t89;
    let t91 = fma(0.25, t83, 1.0);
    let t92 = max(t91, 0.0);
    let t93 = min(t92, 1.125);
    let t94 = t93 * t93;
    let t95 = t94 * t94;
    let t96 = fma(-d.z, t17, t13);
    let t97 = t95 * t96;
    let t98 = t90 + t97;
    let t99 = t90 - t97;
    let t100 = fma(0.23632719, t98, t79);
    let t101 = 0.4093307 * t99;
    let t102 = t29 * 0.2820948;
    let t103 = t30 * 0.2820948;
    let t104 = t31 * 0.2820948;
    let t105 = t35 + t104;
    let t106 = t35 - t104;
    let t107 = t102 + t105;
    let t108 = t105 - t102;
    let t109 = t102 + t106;
    let t110 = t106 - t102;
    let t111 = t103 + t107;
    let t112 = t107 - t103;
    let t113 = t103 + t109;
    let t114 = t109 - t103;
    let t115 = t103 + t108;
    let t116 = t108 - t103;
    let t117 = t103 + t110;
    let t118 = t110 - t103;
    let t120 = d.x * 0.57735026;
    let t121 = d.y * 0.57735026;
    let t122 = d.z * 0.57735026;
    let t123 = t120 + t121;
    let t124 = t120 - t121;
    let t125 = t122 + t123;
    let t126 = t123 - t122;
    let t127 = t122 - t124;
    let t128 = t122 + t124;
    let t129 = fma(0.25, t111, 1.0);
    let t130 = max(t129, 0.0);
    let t131 = min(t130, 1.125);
    let t132 = t131 * t131;
    let t133 = t132 * t132;
    let t134 = fma(t17, t125, t13);
    let t135 = t133 * t134;
    let t136 = fma(0.25, t113, 1.0);
    let t137 = max(t136, 0.0);
    let t138 = min(t137, 1.125);
    let t139 = t138 * t138;
    let t140 = t139 * t139;
    let t141 = fma(t17, t127, t13);
    let t142 = t140 * t141;
    let t143 = fma(0.25, t115, 1.0);
    let t144 = max(t143, 0.0);
    let t145 = min(t144, 1.125);
    let t146 = t145 * t145;
    let t147 = t146 * t146;
    let t148 = fma(t17, t128, t13);
    let t149 = t147 * t148;
    let t150 = fma(0.25, t117, 1.0);
    let t151 = max(t150, 0.0);
    let t152 = min(t151, 1.125);
    let t153 = t152 * t152;
    let t154 = t153 * t153;
    let t155 = fma(-t17, t126, t13);
    let t156 = t154 * t155;
    let t157 = fma(0.25, t112, 1.0);
    let t158 = max(t157, 0.0);
    let t159 = min(t158, 1.125);
    let t160 = t159 * t159;
    let t161 = t160 * t160;
    let t162 = fma(t17, t126, t13);
    let t163 = t161 * t162;
    let t164 = fma(0.25, t114, 1.0);
    let t165 = max(t164, 0.0);
    let t166 = min(t165, 1.125);
    let t167 = t166 * t166;
    let t168 = t167 * t167;
    let t169 = fma(-t17, t128, t13);
    let t170 = t168 * t169;
    let t171 = fma(0.25, t116, 1.0);
    let t172 = max(t171, 0.0);
    let t173 = min(t172, 1.125);
    let t174 = t173 * t173;
    let t175 = t174 * t174;
    let t176 = fma(-t17, t127, t13);
    let t177 = t175 * t176;
    let t178 = fma(0.25, t118, 1.0);
    let t179 = max(t178, 0.0);
    let t180 = min(t179, 1.125);
    let t181 = t180 * t180;
    let t182 = t181 * t181;
    let t183 = fma(-t17, t125, t13);
    let t184 = t182 * t183;
    let t185 = t135 + t142;
    let t186 = t135 - t142;
    let t187 = t149 + t156;
    let t188 = t149 - t156;
    let t189 = t163 + t170;
    let t190 = t163 - t170;
    let t191 = t177 + t184;
    let t192 = t177 - t184;
    let t193 = t185 + t187;
    let t194 = t185 - t187;
    let t195 = t186 + t188;
    let t197 = t189 + t191;
    let t198 = t189 - t191;
    let t199 = t190 + t192;
    let t201 = t193 + t197;
    let t202 = t193 - t197;
    let t203 = t195 + t199;
    let t205 = t194 + t198;
    let t210 = fma(t201, 0.26586807, t100);
    let t211 = fma(t205, 0.26586807, t80);
    let t212 = fma(t202, 0.26586807, t101);
    let t213 = fma(t203, 0.26586807, t59);
    return array<f32, 4>(
        t210, t211, t212, t213,
    );
}

// The lobe in which a surface of this `roughness` (0..1; alpha of GGX is its square) mirrors light, cosine and
// shadowing included and its sum 1: the mean of P_l over it about its axis, for `transfer_lobe`. `cosine` is that
// between the normal and the direction to the viewer. Fitted to 0.01 of the mean of P_1 and to 0.05 of that of P_5,
// most at grazing angles.
// Source: GGX (Walter et al. 2007) with correlated shadowing (Heitz 2014) about the mean of its directions; `gaunt-lab
// fit` rewrites the coefficients.
// 26 multiplications, 31 additions.
fn sh2_gloss_lobe(roughness: f32, cosine: f32) -> array<f32, 2> {
    let t5 = max(roughness, 0.0);
    let t6 = min(t5, 1.0);
    let t7 = fma(2.0, t6, (-1.0));
    let t8 = max(cosine, 0.0);
    let t9 = min(t8, 1.0);
    let t10 = fma(2.0, t9, (-1.0));
    let t13 = fma(t10, 0.07529733, (-0.0172802));
    let t15 = fma(t10, t13, (-0.14698859));
    let t17 = fma(t10, t15, 0.047411796);
    let t19 = fma(t10, t17, 0.017664796);
    let t22 = fma(-t10, 0.06041673, 0.06076902);
    let t24 = fma(t10, t22, 0.025664076);
    let t26 = fma(t10, t24, (-0.024190182));
    let t28 = fma(t10, t26, 0.13384832);
    let t29 = fma(t7, t19, t28);
    let t32 = fma(t10, 0.05630272, 0.0040978314);
    let t34 = fma(-t10, t32, 0.17357925);
    let t36 = fma(t10, t34, (-0.040853865));
    let t38 = fma(t10, t36, (-0.062440276));
    let t39 = fma(t7, t29, t38);
    let t42 = fma(t10, 0.03409668, (-0.03234042));
    let t44 = fma(t10, t42, (-0.027009565));
    let t46 = fma(t10, t44, 0.031917743);
    let t48 = fma(t10, t46, (-0.3192116));
    let t49 = fma(t7, t39, t48);
    let t52 = fma(-t10, 0.018934075, 0.028766828);
    let t54 = fma(t10, t52, (-0.046554122));
    let t56 = fma(t10, t54, 0.013011632);
    let t58 = fma(t10, t56, 0.8483111);
    let t59 = fma(t7, t49, t58);
    let t60 = min(t59, 1.0);
    return array<f32, 2>(
        1.0, t60,
    );
}

// The roughness in whose place light of this order has `roughness`: a smoother lobe, cut off after the order's bands,
// would be below 0 beside its peak by more than 3 % of that, and show dark rings around a sun. At least 1, 0.88, 0.72,
// 0.6 and 0.59 for orders 2 to 6.
// Source: `tests/tests/fitted.rs` holds it to the lobes.
// 0 multiplications, 2 additions.
fn sh2_gloss_told(roughness: f32) -> f32 {
    let t2 = max(roughness, 1.0);
    let t3 = min(t2, 1.0);
    return t3;
}

// How far the lobe of `gloss_lobe` leans: the sine between its axis and the normal, over that of the mirrored
// direction. 1 for a mirror; rough surfaces send light closer to their normal. Fitted to 0.013.
// Source: The mean of the directions of GGX's lobe (Walter et al. 2007); `gaunt-lab fit` rewrites the coefficients.
// 26 multiplications, 32 additions.
fn sh2_gloss_tilt(roughness: f32, cosine: f32) -> f32 {
    let t5 = max(roughness, 0.0);
    let t6 = min(t5, 1.0);
    let t7 = fma(2.0, t6, (-1.0));
    let t8 = max(cosine, 0.0);
    let t9 = min(t8, 1.0);
    let t10 = fma(2.0, t9, (-1.0));
    let t13 = fma(-t10, 0.010231336, 0.06091407);
    let t15 = fma(t10, t13, (-0.034225594));
    let t17 = fma(t10, t15, 0.0648993);
    let t19 = fma(t10, t17, 0.17395891);
    let t22 = fma(-t10, 0.03806068, 0.01759831);
    let t24 = fma(t10, t22, 0.041156348);
    let t26 = fma(t10, t24, (-0.10885227));
    let t28 = fma(t10, t26, 0.0499536);
    let t29 = fma(t7, t19, t28);
    let t32 = fma(t10, 0.031043382, (-0.08948684));
    let t34 = fma(t10, t32, 0.038185593);
    let t36 = fma(t10, t34, (-0.12392491));
    let t38 = fma(t10, t36, (-0.49964976));
    let t39 = fma(t7, t29, t38);
    let t42 = fma(t10, 0.028306859, (-0.012098665));
    let t44 = fma(t10, t42, (-0.033644266));
    let t46 = fma(t10, t44, 0.09154488);
    let t48 = fma(t10, t46, (-0.5500053));
    let t49 = fma(t7, t39, t48);
    let t52 = fma(-t10, 0.018425288, 0.032557525);
    let t54 = fma(t10, t52, (-0.00980618));
    let t56 = fma(t10, t54, 0.06279413);
    let t58 = fma(t10, t56, 0.83131874);
    let t59 = fma(t7, t49, t58);
    let t60 = max(t59, 0.0);
    let t61 = min(t60, 1.0);
    return t61;
}

// What the lobe of a surface of this `roughness` mirrors of an even sky if it absorbs nothing, light that meets the
// surface once, E; and the part B of it that Fresnel's reflectance has at grazing angles: of a reflectance F from the
// front it mirrors F (E - B) + B. Fitted to 0.01 in the mean, and to 0.06 at grazing angles.
// Source: GGX (Walter et al. 2007) with correlated shadowing (Heitz 2014) and Schlick's Fresnel term (1994), summed as
// by Karis 2013; `gaunt-lab fit` rewrites the coefficients.
// 60 multiplications, 68 additions.
fn sh2_gloss_energy(roughness: f32, cosine: f32) -> vec2<f32> {
    let t6 = max(roughness, 0.0);
    let t7 = min(t6, 1.0);
    let t8 = fma(2.0, t7, (-1.0));
    let t9 = max(cosine, 0.0);
    let t10 = min(t9, 1.0);
    let t11 = fma(2.0, t10, (-1.0));
    let t14 = fma(t11, 0.07624876, 0.21920744);
    let t16 = fma(t11, t14, (-0.41884765));
    let t18 = fma(t11, t16, (-0.0018720112));
    let t20 = fma(t11, t18, 0.3331292);
    let t22 = fma(t11, t20, 0.0017937542);
    let t25 = fma(-t11, 0.31856415, 0.16086918);
    let t27 = fma(t11, t25, 0.3592125);
    let t29 = fma(t11, t27, (-0.27699733));
    let t31 = fma(t11, t29, (-0.0074084555));
    let t33 = fma(t11, t31, 0.08549477);
    let t34 = fma(t8, t22, t33);
    let t37 = fma(t11, 0.040937956, (-0.28784367));
    let t39 = fma(t11, t37, 0.3140905);
    let t41 = fma(t11, t39, 0.089051545);
    let t43 = fma(t11, t41, (-0.46724957));
    let t45 = fma(t11, t43, (-0.14373554));
    let t46 = fma(t8, t34, t45);
    let t49 = fma(t11, 0.15770118, (-0.04405338));
    let t51 = fma(t11, t49, (-0.25872597));
    let t53 = fma(t11, t51, 0.2419688);
    let t55 = fma(t11, t53, (-0.11207622));
    let t57 = fma(t11, t55, (-0.3483105));
    let t58 = fma(t8, t46, t57);
    let t61 = fma(-t11, 0.09272094, 0.11212787);
    let t63 = fma(t11, t61, (-0.010671541));
    let t65 = fma(t11, t63, (-0.017949043));
    let t67 = fma(t11, t65, 0.057467304);
    let t69 = fma(t11, t67, 0.86154354);
    let t70 = fma(t8, t58, t69);
    let t71 = min(t70, 1.0);
    let t72 = max(t71, 0.25);
    let t75 = fma(-t11, 0.56441945, 0.3535342);
    let t77 = fma(t11, t75, 0.57415926);
    let t79 = fma(t11, t77, (-0.42139116));
    let t81 = fma(t11, t79, 0.016136969);
    let t83 = fma(t11, t81, 0.015010444);
    let t86 = fma(t11, 0.1949373, (-0.25991198));
    let t88 = fma(t11, t86, (-0.03956526));
    let t90 = fma(t11, t88, 0.18039474);
    let t92 = fma(t11, t90, (-0.08619435));
    let t94 = fma(t11, t92, 0.014382142);
    let t95 = fma(t8, t83, t94);
    let t98 = fma(t11, 0.5225284, (-0.21345617));
    let t100 = fma(t11, t98, (-0.72230417));
    let t102 = fma(t11, t100, 0.47281408);
    let t104 = fma(t11, t102, (-0.010404754));
    let t106 = fma(t11, t104, (-0.021084508));
    let t107 = fma(t8, t95, t106);
    let t110 = fma(-t11, 0.21217918, 0.1643051);
    let t112 = fma(t11, t110, 0.26270685);
    let t114 = fma(t11, t112, (-0.33933893));
    let t116 = fma(t11, t114, 0.14203957);
    let t118 = fma(t11, t116, (-0.025130296));
    let t119 = fma(t8, t107, t118);
    let t122 = fma(t11, 0.018166976, 0.0057008006);
    let t124 = fma(-t11, t122, 0.002442944);
    let t126 = fma(t11, t124, 0.07538209);
    let t128 = fma(t11, t126, (-0.079305924));
    let t130 = fma(t11, t128, 0.02344341);
    let t131 = fma(t8, t119, t130);
    let t132 = max(t131, 0.0);
    let t133 = min(t132, t72);
    return vec2<f32>(
        t72, t133,
    );
}

// Of a sphere that the horizon cuts: the radius of the one that stands for the part above it, over the sphere's own. It
// touches the horizon from above, below the sphere's centre, and hides the same share of an even sky, weighted by the
// cosine: a sphere of sine s that touches hides s^3. `height` is that of the sphere's centre over its radius, -1
// (wholly below: 0) to 1 (wholly above: 1), `square` the square of the sine of the sphere's angular radius. Fitted: the
// share to 0.0133 of the sky, and that of a small sphere to 0.125 of what it hides when wholly above.
// Source: The form factor of a sphere that a horizon cuts (Snyder 1996, "Area light sources for real-time graphics"),
// to the power 1/3; `gaunt-lab fit` rewrites the coefficients.
// 16 multiplications, 19 additions.
fn sh2_horizon_radius(height: f32, square: f32) -> f32 {
    let t5 = fma(height, 0.5, 0.5);
    let t6 = max(t5, 0.0);
    let t8 = min(t6, 0.9999999);
    let t9 = min(square, 1.0);
    let t12 = fma(-t8, 0.8192233, 1.0812956);
    let t14 = fma(t8, t12, (-0.34824675));
    let t17 = fma(t8, 0.4381442, (-1.4903629));
    let t19 = fma(t8, t17, 1.5754806);
    let t22 = fma(t8, 0.38694167, 0.4362123);
    let t24 = fma(t8, t22, (-1.1836709));
    let t25 = fma(t9, t24, t19);
    let t26 = fma(t9, t25, t14);
    let t27 = 1.0 - t8;
    let t28 = 1.0 - t9;
    let t30 = fma(-t8, 0.9262614, 1.0);
    let t33 = fma(t8, 0.03509759, 0.02);
    let t34 = t27 * t33;
    let t35 = fma(t28, t30, t34);
    let t36 = t26 * t27;
    let t37 = t36 / t35;
    let t38 = fma(t8, t37, t8);
    let t39 = max(t38, 0.0);
    return t39;
}

// The exponential of `f` at samples, exp(min(f(s), 0.15)), projected back; on 14, 26, 50, 86 and 86 points for orders 2
// to 6. Every sample lies in 0..=1.162.
// Source: Ren et al. 2006, eq. 10, by quadrature (Lebedev 1976) and clamped from above.
// 17 multiplications, 64 additions.
fn sh2_exp_sampled(f: array<f32, 4>) -> array<f32, 4> {
    let t7 = f[0] * 0.2820948;
    let t9 = f[3] * 0.48860252;
    let t10 = t7 + t9;
    let t11 = t7 - t9;
    let t12 = min(t10, 0.15);
    let t13 = exp(t12);
    let t14 = min(t11, 0.15);
    let t15 = exp(t14);
    let t16 = t13 + t15;
    let t17 = t13 - t15;
    let t19 = t16 * 0.23632719;
    let t21 = t17 * 0.4093307;
    let t22 = f[1] * 0.48860252;
    let t23 = t7 + t22;
    let t24 = t7 - t22;
    let t25 = min(t23, 0.15);
    let t26 = exp(t25);
    let t27 = min(t24, 0.15);
    let t28 = exp(t27);
    let t29 = t26 + t28;
    let t30 = t26 - t28;
    let t31 = fma(0.23632719, t29, t19);
    let t32 = 0.4093307 * t30;
    let t33 = f[2] * 0.48860252;
    let t34 = t7 + t33;
    let t35 = t7 - t33;
    let t36 = min(t34, 0.15);
    let t37 = exp(t36);
    let t38 = min(t35, 0.15);
    let t39 = exp(t38);
    let t40 = t37 + t39;
    let t41 = t37 - t39;
    let t42 = fma(0.23632719, t40, t31);
    let t43 = 0.4093307 * t41;
    let t44 = f[1] * 0.2820948;
    let t45 = f[2] * 0.2820948;
    let t46 = f[3] * 0.2820948;
    let t47 = t7 + t46;
    let t48 = t7 - t46;
    let t49 = t44 + t47;
    let t50 = t47 - t44;
    let t51 = t44 + t48;
    let t52 = t48 - t44;
    let t53 = t45 + t49;
    let t54 = t49 - t45;
    let t55 = t45 + t51;
    let t56 = t51 - t45;
    let t57 = t45 + t50;
    let t58 = t50 - t45;
    let t59 = t45 + t52;
    let t60 = t52 - t45;
    let t61 = min(t53, 0.15);
    let t62 = exp(t61);
    let t63 = min(t55, 0.15);
    let t64 = exp(t63);
    let t65 = min(t57, 0.15);
    let t66 = exp(t65);
    let t67 = min(t59, 0.15);
    let t68 = exp(t67);
    let t69 = min(t54, 0.15);
    let t70 = exp(t69);
    let t71 = min(t56, 0.15);
    let t72 = exp(t71);
    let t73 = min(t58, 0.15);
    let t74 = exp(t73);
    let t75 = min(t60, 0.15);
    let t76 = exp(t75);
    let t77 = t62 + t64;
    let t78 = t62 - t64;
    let t79 = t66 + t68;
    let t80 = t66 - t68;
    let t81 = t70 + t72;
    let t82 = t70 - t72;
    let t83 = t74 + t76;
    let t84 = t74 - t76;
    let t85 = t77 + t79;
    let t86 = t77 - t79;
    let t87 = t78 + t80;
    let t89 = t81 + t83;
    let t90 = t81 - t83;
    let t91 = t82 + t84;
    let t93 = t85 + t89;
    let t94 = t85 - t89;
    let t95 = t87 + t91;
    let t97 = t86 + t90;
    let t102 = fma(t93, 0.26586807, t42);
    let t103 = fma(t97, 0.26586807, t32);
    let t104 = fma(t94, 0.26586807, t43);
    let t105 = fma(t95, 0.26586807, t21);
    return array<f32, 4>(
        t102, t103, t104, t105,
    );
}

// As `exp_sampled`, on 6, 14, 38, 50 and 50 points for orders 2 to 6.
// Source: Ren et al. 2006, eq. 10, by quadrature (Lebedev 1976) and clamped from above.
// 10 multiplications, 20 additions.
fn sh2_exp_sampled_coarse(f: array<f32, 4>) -> array<f32, 4> {
    let t7 = f[0] * 0.2820948;
    let t9 = f[3] * 0.48860252;
    let t10 = t7 + t9;
    let t11 = t7 - t9;
    let t12 = min(t10, 0.15);
    let t13 = exp(t12);
    let t14 = min(t11, 0.15);
    let t15 = exp(t14);
    let t16 = t13 + t15;
    let t17 = t13 - t15;
    let t19 = t16 * 0.5908179;
    let t21 = t17 * 1.0233268;
    let t22 = f[1] * 0.48860252;
    let t23 = t7 + t22;
    let t24 = t7 - t22;
    let t25 = min(t23, 0.15);
    let t26 = exp(t25);
    let t27 = min(t24, 0.15);
    let t28 = exp(t27);
    let t29 = t26 + t28;
    let t30 = t26 - t28;
    let t31 = fma(0.5908179, t29, t19);
    let t32 = 1.0233268 * t30;
    let t33 = f[2] * 0.48860252;
    let t34 = t7 + t33;
    let t35 = t7 - t33;
    let t36 = min(t34, 0.15);
    let t37 = exp(t36);
    let t38 = min(t35, 0.15);
    let t39 = exp(t38);
    let t40 = t37 + t39;
    let t41 = t37 - t39;
    let t42 = fma(0.5908179, t40, t31);
    let t43 = 1.0233268 * t41;
    return array<f32, 4>(
        t42, t32, t43, t21,
    );
}

// As `exp_sampled`, on 26, 38, 86, 110 and 110 points for orders 2 to 6.
// Source: Ren et al. 2006, eq. 10, by quadrature (Lebedev 1976) and clamped from above.
// 29 multiplications, 122 additions.
fn sh2_exp_sampled_fine(f: array<f32, 4>) -> array<f32, 4> {
    let t7 = f[0] * 0.2820948;
    let t9 = f[3] * 0.48860252;
    let t10 = t7 + t9;
    let t11 = t7 - t9;
    let t12 = min(t10, 0.15);
    let t13 = exp(t12);
    let t14 = min(t11, 0.15);
    let t15 = exp(t14);
    let t16 = t13 + t15;
    let t17 = t13 - t15;
    let t19 = t16 * 0.16880512;
    let t21 = t17 * 0.29237905;
    let t22 = f[1] * 0.48860252;
    let t23 = t7 + t22;
    let t24 = t7 - t22;
    let t25 = min(t23, 0.15);
    let t26 = exp(t25);
    let t27 = min(t24, 0.15);
    let t28 = exp(t27);
    let t29 = t26 + t28;
    let t30 = t26 - t28;
    let t31 = fma(0.16880512, t29, t19);
    let t32 = 0.29237905 * t30;
    let t33 = f[2] * 0.48860252;
    let t34 = t7 + t33;
    let t35 = t7 - t33;
    let t36 = min(t34, 0.15);
    let t37 = exp(t36);
    let t38 = min(t35, 0.15);
    let t39 = exp(t38);
    let t40 = t37 + t39;
    let t41 = t37 - t39;
    let t42 = fma(0.16880512, t40, t31);
    let t43 = 0.29237905 * t41;
    let t45 = f[1] * 0.34549415;
    let t46 = f[2] * 0.34549415;
    let t47 = t7 + t45;
    let t48 = t7 - t45;
    let t49 = t46 + t47;
    let t50 = t47 - t46;
    let t51 = t46 + t48;
    let t52 = t48 - t46;
    let t53 = min(t49, 0.15);
    let t54 = exp(t53);
    let t55 = min(t51, 0.15);
    let t56 = exp(t55);
    let t57 = min(t50, 0.15);
    let t58 = exp(t57);
    let t59 = min(t52, 0.15);
    let t60 = exp(t59);
    let t61 = t54 + t56;
    let t62 = t54 - t56;
    let t63 = t58 + t60;
    let t64 = t58 - t60;
    let t65 = t61 + t63;
    let t66 = t61 - t63;
    let t67 = t62 + t64;
    let t70 = fma(t65, 0.1350441, t42);
    let t72 = fma(t67, 0.16539457, t32);
    let t73 = fma(t66, 0.16539457, t43);
    let t74 = f[3] * 0.34549415;
    let t75 = t7 + t74;
    let t76 = t7 - t74;
    let t77 = t46 + t75;
    let t78 = t75 - t46;
    let t79 = t46 + t76;
    let t80 = t76 - t46;
    let t81 = min(t77, 0.15);
    let t82 = exp(t81);
    let t83 = min(t79, 0.15);
    let t84 = exp(t83);
    let t85 = min(t78, 0.15);
    let t86 = exp(t85);
    let t87 = min(t80, 0.15);
    let t88 = exp(t87);
    let t89 = t82 + t84;
    let t90 = t82 - t84;
    let t91 = t86 + t88;
    let t92 = t86 - t88;
    let t93 = t89 + t91;
    let t94 = t89 - t91;
    let t95 = t90 + t92;
    let t97 = fma(0.1350441, t93, t70);
    let t98 = fma(0.16539457, t94, t73);
    let t99 = fma(0.16539457, t95, t21);
    let t100 = t45 + t75;
    let t101 = t75 - t45;
    let t102 = t45 + t76;
    let t103 = t76 - t45;
    let t104 = min(t100, 0.15);
    let t105 = exp(t104);
    let t106 = min(t102, 0.15);
    let t107 = exp(t106);
    let t108 = min(t101, 0.15);
    let t109 = exp(t108);
    let t110 = min(t103, 0.15);
    let t111 = exp(t110);
    let t112 = t105 + t107;
    let t113 = t105 - t107;
    let t114 = t109 + t111;
    let t115 = t109 - t111;
    let t116 = t112 + t114;
    let t117 = t112 - t114;
    let t118 = t113 + t115;
    let t120 = fma(0.1350441, t116, t97);
    let t121 = fma(0.16539457, t117, t72);
    let t122 = fma(0.16539457, t118, t99);
    let t123 = f[1] * 0.2820948;
    let t124 = f[2] * 0.2820948;
    let t125 = f[3] * 0.2820948;
    let t126 = t7 + t125;
    let t127 = t7 - t125;
    let t128 = t123 + t126;
    let t129 = t126 - t123;
    let t130 = t123 + t127;
    let t131 = t127 - t123;
    let t132 = t124 + t128;
    let t133 = t128 - t124;
    let t134 = t124 + t130;
    let t135 = t130 - t124;
    let t136 = t124 + t129;
    let t137 = t129 - t124;
    let t138 = t124 + t131;
    let t139 = t131 - t124;
    let t140 = min(t132, 0.15);
    let t141 = exp(t140);
    let t142 = min(t134, 0.15);
    let t143 = exp(t142);
    let t144 = min(t136, 0.15);
    let t145 = exp(t144);
    let t146 = min(t138, 0.15);
    let t147 = exp(t146);
    let t148 = min(t133, 0.15);
    let t149 = exp(t148);
    let t150 = min(t135, 0.15);
    let t151 = exp(t150);
    let t152 = min(t137, 0.15);
    let t153 = exp(t152);
    let t154 = min(t139, 0.15);
    let t155 = exp(t154);
    let t156 = t141 + t143;
    let t157 = t141 - t143;
    let t158 = t145 + t147;
    let t159 = t145 - t147;
    let t160 = t149 + t151;
    let t161 = t149 - t151;
    let t162 = t153 + t155;
    let t163 = t153 - t155;
    let t164 = t156 + t158;
    let t165 = t156 - t158;
    let t166 = t157 + t159;
    let t168 = t160 + t162;
    let t169 = t160 - t162;
    let t170 = t161 + t163;
    let t172 = t164 + t168;
    let t173 = t164 - t168;
    let t174 = t166 + t170;
    let t176 = t165 + t169;
    let t181 = fma(t172, 0.113943465, t120);
    let t182 = fma(t176, 0.113943465, t121);
    let t183 = fma(t173, 0.113943465, t98);
    let t184 = fma(t174, 0.113943465, t122);
    return array<f32, 4>(
        t181, t182, t183, t184,
    );
}

// The factors a and b of the optimal linear exponential a*1 + b*f^ for a vector without DC, of norm |f^| <= 1/4.
// Source: Ren et al. 2006, eq. 23-24, fitted; `gaunt-lab fit` rewrites the coefficients and states their error.
// 6 multiplications, 6 additions.
fn sh2_optimal_linear(norm: f32) -> vec2<f32> {
    let t4 = fma(norm, 0.00011931345, 0.039772596);
    let t6 = fma(norm, t4, 6.1459934e-7);
    let t8 = fma(norm, t6, 1.0);
    let t11 = fma(norm, 2.3861006e-5, 0.013259684);
    let t13 = fma(norm, t11, 1.2290425e-7);
    let t14 = fma(norm, t13, 1.0);
    return vec2<f32>(
        t8, t14,
    );
}

// The factors a and b of the optimal linear exponential a*1 + b*f^ for a vector without DC of any norm |f^|, as a
// circle of that norm has them. Beyond the norm of the largest circle they stay as they are there.
// Source: Ren et al. 2006, eq. 23-24 and Figure 3, fitted; `gaunt-lab fit` rewrites the coefficients and states their
// error.
// 17 multiplications, 17 additions.
fn sh2_optimal_linear_wide(norm: f32) -> vec2<f32> {
    let t2 = min(norm, 4.668494);
    let t4 = t2 * 0.21420182;
    let t8 = fma(t4, 0.0002735588, (-0.000117862));
    let t10 = fma(t4, t8, 0.007373523);
    let t12 = fma(t4, t10, (-7.5530465e-5));
    let t14 = fma(t4, t12, 0.1253615);
    let t16 = fma(t4, t14, (-4.6354157e-6));
    let t18 = fma(t4, t16, 0.86718947);
    let t20 = fma(t4, t18, (-1.2104336e-8));
    let t22 = fma(t4, t20, 1.0);
    let t25 = fma(t4, 2.9373576e-5, (-1.063156e-5));
    let t27 = fma(t4, t25, 0.0010466367);
    let t29 = fma(t4, t27, (-6.803373e-6));
    let t31 = fma(t4, t29, 0.025069512);
    let t33 = fma(t4, t31, (-4.1720438e-7));
    let t35 = fma(t4, t33, 0.28906304);
    let t37 = fma(t4, t35, (-1.0889007e-9));
    let t38 = fma(t4, t37, 1.0);
    return vec2<f32>(
        t22, t38,
    );
}

// Zonal coefficients of the eigen logarithm of the visibility past a circular blocker about +Z whose angular radius
// is a whole number of degrees, 0..=179; beyond that as at 179. The rows of the table behind `cap_log_table`.
// Source: Ren et al. 2006, eq. 30-32, clipped at 0.02; `gaunt-lab fit` computes it.
fn sh2_cap_log_row(row: u32) -> array<f32, 2> {
    var z = array<f32, 2>();
    if (row < 90u) {
        if (row < 45u) {
            if (row < 22u) {
                if (row < 11u) {
                    if (row < 5u) {
                        if (row < 2u) {
                            if (row < 1u) {
                                z = array<f32, 2>(0.0, 0.0);
                            } else {
                                z = array<f32, 2>(-0.00026999443, -0.00046757286);
                            }
                        } else {
                            if (row < 3u) {
                                z = array<f32, 2>(-0.0010803888, -0.001870149);
                            } else {
                                if (row < 4u) {
                                    z = array<f32, 2>(-0.0024324157, -0.004207303);
                                } else {
                                    z = array<f32, 2>(-0.004328128, -0.0074783284);
                                }
                            }
                        }
                    } else {
                        if (row < 8u) {
                            if (row < 6u) {
                                z = array<f32, 2>(-0.006770396, -0.011682244);
                            } else {
                                if (row < 7u) {
                                    z = array<f32, 2>(-0.009762903, -0.016817799);
                                } else {
                                    z = array<f32, 2>(-0.013310142, -0.022883484);
                                }
                            }
                        } else {
                            if (row < 9u) {
                                z = array<f32, 2>(-0.01741741, -0.029877543);
                            } else {
                                if (row < 10u) {
                                    z = array<f32, 2>(-0.0220908, -0.037797984);
                                } else {
                                    z = array<f32, 2>(-0.027337193, -0.046642587);
                                }
                            }
                        }
                    }
                } else {
                    if (row < 16u) {
                        if (row < 13u) {
                            if (row < 12u) {
                                z = array<f32, 2>(-0.03316426, -0.05640894);
                            } else {
                                z = array<f32, 2>(-0.03958043, -0.067094445);
                            }
                        } else {
                            if (row < 14u) {
                                z = array<f32, 2>(-0.046594918, -0.07869632);
                            } else {
                                if (row < 15u) {
                                    z = array<f32, 2>(-0.05421767, -0.091211654);
                                } else {
                                    z = array<f32, 2>(-0.062459398, -0.10463742);
                                }
                            }
                        }
                    } else {
                        if (row < 19u) {
                            if (row < 17u) {
                                z = array<f32, 2>(-0.07133154, -0.11897047);
                            } else {
                                if (row < 18u) {
                                    z = array<f32, 2>(-0.08084625, -0.1342076);
                                } else {
                                    z = array<f32, 2>(-0.09101642, -0.1503456);
                                }
                            }
                        } else {
                            if (row < 20u) {
                                z = array<f32, 2>(-0.10185564, -0.16738117);
                            } else {
                                if (row < 21u) {
                                    z = array<f32, 2>(-0.11337818, -0.18531106);
                                } else {
                                    z = array<f32, 2>(-0.12559903, -0.2041321);
                                }
                            }
                        }
                    }
                }
            } else {
                if (row < 33u) {
                    if (row < 27u) {
                        if (row < 24u) {
                            if (row < 23u) {
                                z = array<f32, 2>(-0.13853383, -0.22384115);
                            } else {
                                z = array<f32, 2>(-0.15219893, -0.24443518);
                            }
                        } else {
                            if (row < 25u) {
                                z = array<f32, 2>(-0.1666113, -0.26591134);
                            } else {
                                if (row < 26u) {
                                    z = array<f32, 2>(-0.18178862, -0.28826696);
                                } else {
                                    z = array<f32, 2>(-0.19774924, -0.31149954);
                                }
                            }
                        }
                    } else {
                        if (row < 30u) {
                            if (row < 28u) {
                                z = array<f32, 2>(-0.2145121, -0.3356069);
                            } else {
                                if (row < 29u) {
                                    z = array<f32, 2>(-0.23209687, -0.3605871);
                                } else {
                                    z = array<f32, 2>(-0.25052384, -0.38643855);
                                }
                            }
                        } else {
                            if (row < 31u) {
                                z = array<f32, 2>(-0.269814, -0.41316003);
                            } else {
                                if (row < 32u) {
                                    z = array<f32, 2>(-0.289989, -0.44075075);
                                } else {
                                    z = array<f32, 2>(-0.31107113, -0.4692104);
                                }
                            }
                        }
                    }
                } else {
                    if (row < 39u) {
                        if (row < 36u) {
                            if (row < 34u) {
                                z = array<f32, 2>(-0.33308342, -0.4985391);
                            } else {
                                if (row < 35u) {
                                    z = array<f32, 2>(-0.35604963, -0.5287376);
                                } else {
                                    z = array<f32, 2>(-0.37999415, -0.55980724);
                                }
                            }
                        } else {
                            if (row < 37u) {
                                z = array<f32, 2>(-0.4049422, -0.5917499);
                            } else {
                                if (row < 38u) {
                                    z = array<f32, 2>(-0.43091977, -0.62456834);
                                } else {
                                    z = array<f32, 2>(-0.4579536, -0.65826595);
                                }
                            }
                        }
                    } else {
                        if (row < 42u) {
                            if (row < 40u) {
                                z = array<f32, 2>(-0.4860713, -0.692847);
                            } else {
                                if (row < 41u) {
                                    z = array<f32, 2>(-0.5153013, -0.72831655);
                                } else {
                                    z = array<f32, 2>(-0.545673, -0.7646807);
                                }
                            }
                        } else {
                            if (row < 43u) {
                                z = array<f32, 2>(-0.5772168, -0.8019465);
                            } else {
                                if (row < 44u) {
                                    z = array<f32, 2>(-0.609964, -0.8401221);
                                } else {
                                    z = array<f32, 2>(-0.64394706, -0.8792168);
                                }
                            }
                        }
                    }
                }
            }
        } else {
            if (row < 67u) {
                if (row < 56u) {
                    if (row < 50u) {
                        if (row < 47u) {
                            if (row < 46u) {
                                z = array<f32, 2>(-0.6791995, -0.91924113);
                            } else {
                                z = array<f32, 2>(-0.71575624, -0.9602069);
                            }
                        } else {
                            if (row < 48u) {
                                z = array<f32, 2>(-0.7536533, -1.0021276);
                            } else {
                                if (row < 49u) {
                                    z = array<f32, 2>(-0.7929282, -1.0450178);
                                } else {
                                    z = array<f32, 2>(-0.83362, -1.0888942);
                                }
                            }
                        }
                    } else {
                        if (row < 53u) {
                            if (row < 51u) {
                                z = array<f32, 2>(-0.8757693, -1.1337749);
                            } else {
                                if (row < 52u) {
                                    z = array<f32, 2>(-0.9194185, -1.1796801);
                                } else {
                                    z = array<f32, 2>(-0.96461195, -1.2266319);
                                }
                            }
                        } else {
                            if (row < 54u) {
                                z = array<f32, 2>(-1.0113959, -1.2746549);
                            } else {
                                if (row < 55u) {
                                    z = array<f32, 2>(-1.059819, -1.3237756);
                                } else {
                                    z = array<f32, 2>(-1.1099322, -1.3740238);
                                }
                            }
                        }
                    }
                } else {
                    if (row < 61u) {
                        if (row < 58u) {
                            if (row < 57u) {
                                z = array<f32, 2>(-1.1617893, -1.4254314);
                            } else {
                                z = array<f32, 2>(-1.2154468, -1.4780337);
                            }
                        } else {
                            if (row < 59u) {
                                z = array<f32, 2>(-1.2709645, -1.5318695);
                            } else {
                                if (row < 60u) {
                                    z = array<f32, 2>(-1.3284057, -1.586981);
                                } else {
                                    z = array<f32, 2>(-1.3878376, -1.6434146);
                                }
                            }
                        }
                    } else {
                        if (row < 64u) {
                            if (row < 62u) {
                                z = array<f32, 2>(-1.4493316, -1.7012208);
                            } else {
                                if (row < 63u) {
                                    z = array<f32, 2>(-1.5129638, -1.7604554);
                                } else {
                                    z = array<f32, 2>(-1.5788157, -1.8211792);
                                }
                            }
                        } else {
                            if (row < 65u) {
                                z = array<f32, 2>(-1.6469744, -1.883459);
                            } else {
                                if (row < 66u) {
                                    z = array<f32, 2>(-1.717534, -1.9473684);
                                } else {
                                    z = array<f32, 2>(-1.790595, -2.0129883);
                                }
                            }
                        }
                    }
                }
            } else {
                if (row < 78u) {
                    if (row < 72u) {
                        if (row < 69u) {
                            if (row < 68u) {
                                z = array<f32, 2>(-1.8662668, -2.0804076);
                            } else {
                                z = array<f32, 2>(-1.9446682, -2.1497252);
                            }
                        } else {
                            if (row < 70u) {
                                z = array<f32, 2>(-2.0259278, -2.2210495);
                            } else {
                                if (row < 71u) {
                                    z = array<f32, 2>(-2.1101863, -2.2945018);
                                } else {
                                    z = array<f32, 2>(-2.197598, -2.3702161);
                                }
                            }
                        }
                    } else {
                        if (row < 75u) {
                            if (row < 73u) {
                                z = array<f32, 2>(-2.2883327, -2.4483426);
                            } else {
                                if (row < 74u) {
                                    z = array<f32, 2>(-2.382578, -2.5290484);
                                } else {
                                    z = array<f32, 2>(-2.4805417, -2.6125224);
                                }
                            }
                        } else {
                            if (row < 76u) {
                                z = array<f32, 2>(-2.582456, -2.6989763);
                            } else {
                                if (row < 77u) {
                                    z = array<f32, 2>(-2.6885817, -2.7886503);
                                } else {
                                    z = array<f32, 2>(-2.7992113, -2.8818178);
                                }
                            }
                        }
                    }
                } else {
                    if (row < 84u) {
                        if (row < 81u) {
                            if (row < 79u) {
                                z = array<f32, 2>(-2.9146771, -2.9787903);
                            } else {
                                if (row < 80u) {
                                    z = array<f32, 2>(-3.0353587, -3.0799274);
                                } else {
                                    z = array<f32, 2>(-3.1616912, -3.1856441);
                                }
                            }
                        } else {
                            if (row < 82u) {
                                z = array<f32, 2>(-3.2941797, -3.2964242);
                            } else {
                                if (row < 83u) {
                                    z = array<f32, 2>(-3.4334126, -3.4128356);
                                } else {
                                    z = array<f32, 2>(-3.5800838, -3.5355513);
                                }
                            }
                        }
                    } else {
                        if (row < 87u) {
                            if (row < 85u) {
                                z = array<f32, 2>(-3.7350194, -3.6653764);
                            } else {
                                if (row < 86u) {
                                    z = array<f32, 2>(-3.899215, -3.8032844);
                                } else {
                                    z = array<f32, 2>(-4.073885, -3.9504683);
                                }
                            }
                        } else {
                            if (row < 88u) {
                                z = array<f32, 2>(-4.2605343, -4.1084113);
                            } else {
                                if (row < 89u) {
                                    z = array<f32, 2>(-4.461061, -4.2789884);
                                } else {
                                    z = array<f32, 2>(-4.6779056, -4.464618);
                                }
                            }
                        }
                    }
                }
            }
        }
    } else {
        if (row < 135u) {
            if (row < 112u) {
                if (row < 101u) {
                    if (row < 95u) {
                        if (row < 92u) {
                            if (row < 91u) {
                                z = array<f32, 2>(-4.9142857, -4.668494);
                            } else {
                                z = array<f32, 2>(-5.1745644, -4.8949566);
                            }
                        } else {
                            if (row < 93u) {
                                z = array<f32, 2>(-5.4648767, -5.150116);
                            } else {
                                if (row < 94u) {
                                    z = array<f32, 2>(-5.7942414, -5.442967);
                                } else {
                                    z = array<f32, 2>(-6.1767244, -5.7875495);
                                }
                            }
                        }
                    } else {
                        if (row < 98u) {
                            if (row < 96u) {
                                z = array<f32, 2>(-6.6360965, -6.207609);
                            } else {
                                if (row < 97u) {
                                    z = array<f32, 2>(-7.217537, -6.7482996);
                                } else {
                                    z = array<f32, 2>(-7.4806647, -6.9692116);
                                }
                            }
                        } else {
                            if (row < 99u) {
                                z = array<f32, 2>(-7.572044, -7.0168824);
                            } else {
                                if (row < 100u) {
                                    z = array<f32, 2>(-7.6631694, -7.0627785);
                                } else {
                                    z = array<f32, 2>(-7.7540674, -7.1068964);
                                }
                            }
                        }
                    }
                } else {
                    if (row < 106u) {
                        if (row < 103u) {
                            if (row < 102u) {
                                z = array<f32, 2>(-7.8447666, -7.1492352);
                            } else {
                                z = array<f32, 2>(-7.935299, -7.189795);
                            }
                        } else {
                            if (row < 104u) {
                                z = array<f32, 2>(-8.025698, -7.228578);
                            } else {
                                if (row < 105u) {
                                    z = array<f32, 2>(-8.115998, -7.265587);
                                } else {
                                    z = array<f32, 2>(-8.206241, -7.300827);
                                }
                            }
                        }
                    } else {
                        if (row < 109u) {
                            if (row < 107u) {
                                z = array<f32, 2>(-8.296466, -7.3343034);
                            } else {
                                if (row < 108u) {
                                    z = array<f32, 2>(-8.386718, -7.3660245);
                                } else {
                                    z = array<f32, 2>(-8.477042, -7.3959985);
                                }
                            }
                        } else {
                            if (row < 110u) {
                                z = array<f32, 2>(-8.567491, -7.4242363);
                            } else {
                                if (row < 111u) {
                                    z = array<f32, 2>(-8.6581135, -7.4507494);
                                } else {
                                    z = array<f32, 2>(-8.748967, -7.475551);
                                }
                            }
                        }
                    }
                }
            } else {
                if (row < 123u) {
                    if (row < 117u) {
                        if (row < 114u) {
                            if (row < 113u) {
                                z = array<f32, 2>(-8.84011, -7.498656);
                            } else {
                                z = array<f32, 2>(-8.931603, -7.520079);
                            }
                        } else {
                            if (row < 115u) {
                                z = array<f32, 2>(-9.023512, -7.5398383);
                            } else {
                                if (row < 116u) {
                                    z = array<f32, 2>(-9.115904, -7.5579515);
                                } else {
                                    z = array<f32, 2>(-9.208851, -7.574439);
                                }
                            }
                        }
                    } else {
                        if (row < 120u) {
                            if (row < 118u) {
                                z = array<f32, 2>(-9.302428, -7.589321);
                            } else {
                                if (row < 119u) {
                                    z = array<f32, 2>(-9.396714, -7.6026206);
                                } else {
                                    z = array<f32, 2>(-9.491793, -7.614361);
                                }
                            }
                        } else {
                            if (row < 121u) {
                                z = array<f32, 2>(-9.587749, -7.6245666);
                            } else {
                                if (row < 122u) {
                                    z = array<f32, 2>(-9.684675, -7.6332636);
                                } else {
                                    z = array<f32, 2>(-9.782666, -7.640479);
                                }
                            }
                        }
                    }
                } else {
                    if (row < 129u) {
                        if (row < 126u) {
                            if (row < 124u) {
                                z = array<f32, 2>(-9.881823, -7.646241);
                            } else {
                                if (row < 125u) {
                                    z = array<f32, 2>(-9.982249, -7.65058);
                                } else {
                                    z = array<f32, 2>(-10.084056, -7.653525);
                                }
                            }
                        } else {
                            if (row < 127u) {
                                z = array<f32, 2>(-10.187357, -7.655108);
                            } else {
                                if (row < 128u) {
                                    z = array<f32, 2>(-10.292276, -7.6553626);
                                } else {
                                    z = array<f32, 2>(-10.398938, -7.654322);
                                }
                            }
                        }
                    } else {
                        if (row < 132u) {
                            if (row < 130u) {
                                z = array<f32, 2>(-10.507477, -7.6520214);
                            } else {
                                if (row < 131u) {
                                    z = array<f32, 2>(-10.618034, -7.648496);
                                } else {
                                    z = array<f32, 2>(-10.730755, -7.643783);
                                }
                            }
                        } else {
                            if (row < 133u) {
                                z = array<f32, 2>(-10.845797, -7.637921);
                            } else {
                                if (row < 134u) {
                                    z = array<f32, 2>(-10.963323, -7.630947);
                                } else {
                                    z = array<f32, 2>(-11.083506, -7.6229024);
                                }
                            }
                        }
                    }
                }
            }
        } else {
            if (row < 157u) {
                if (row < 146u) {
                    if (row < 140u) {
                        if (row < 137u) {
                            if (row < 136u) {
                                z = array<f32, 2>(-11.206527, -7.613827);
                            } else {
                                z = array<f32, 2>(-11.33258, -7.603762);
                            }
                        } else {
                            if (row < 138u) {
                                z = array<f32, 2>(-11.461867, -7.592751);
                            } else {
                                if (row < 139u) {
                                    z = array<f32, 2>(-11.594606, -7.580836);
                                } else {
                                    z = array<f32, 2>(-11.731024, -7.568061);
                                }
                            }
                        }
                    } else {
                        if (row < 143u) {
                            if (row < 141u) {
                                z = array<f32, 2>(-11.871366, -7.554471);
                            } else {
                                if (row < 142u) {
                                    z = array<f32, 2>(-12.015891, -7.5401115);
                                } else {
                                    z = array<f32, 2>(-12.164875, -7.5250287);
                                }
                            }
                        } else {
                            if (row < 144u) {
                                z = array<f32, 2>(-12.318616, -7.5092697);
                            } else {
                                if (row < 145u) {
                                    z = array<f32, 2>(-12.477429, -7.492882);
                                } else {
                                    z = array<f32, 2>(-12.641655, -7.475914);
                                }
                            }
                        }
                    }
                } else {
                    if (row < 151u) {
                        if (row < 148u) {
                            if (row < 147u) {
                                z = array<f32, 2>(-12.81166, -7.4584136);
                            } else {
                                z = array<f32, 2>(-12.987839, -7.4404316);
                            }
                        } else {
                            if (row < 149u) {
                                z = array<f32, 2>(-13.170622, -7.4220176);
                            } else {
                                if (row < 150u) {
                                    z = array<f32, 2>(-13.360471, -7.4032216);
                                } else {
                                    z = array<f32, 2>(-13.557893, -7.384095);
                                }
                            }
                        }
                    } else {
                        if (row < 154u) {
                            if (row < 152u) {
                                z = array<f32, 2>(-13.763439, -7.3646903);
                            } else {
                                if (row < 153u) {
                                    z = array<f32, 2>(-13.977716, -7.3450584);
                                } else {
                                    z = array<f32, 2>(-14.201389, -7.3252525);
                                }
                            }
                        } else {
                            if (row < 155u) {
                                z = array<f32, 2>(-14.435196, -7.3053255);
                            } else {
                                if (row < 156u) {
                                    z = array<f32, 2>(-14.679952, -7.285331);
                                } else {
                                    z = array<f32, 2>(-14.936569, -7.2653227);
                                }
                            }
                        }
                    }
                }
            } else {
                if (row < 168u) {
                    if (row < 162u) {
                        if (row < 159u) {
                            if (row < 158u) {
                                z = array<f32, 2>(-15.206068, -7.2453547);
                            } else {
                                z = array<f32, 2>(-15.4896, -7.225482);
                            }
                        } else {
                            if (row < 160u) {
                                z = array<f32, 2>(-15.788468, -7.20576);
                            } else {
                                if (row < 161u) {
                                    z = array<f32, 2>(-16.104158, -7.186244);
                                } else {
                                    z = array<f32, 2>(-16.43838, -7.1669903);
                                }
                            }
                        }
                    } else {
                        if (row < 165u) {
                            if (row < 163u) {
                                z = array<f32, 2>(-16.79311, -7.1480546);
                            } else {
                                if (row < 164u) {
                                    z = array<f32, 2>(-17.170652, -7.129495);
                                } else {
                                    z = array<f32, 2>(-17.573727, -7.1113687);
                                }
                            }
                        } else {
                            if (row < 166u) {
                                z = array<f32, 2>(-18.005562, -7.0937333);
                            } else {
                                if (row < 167u) {
                                    z = array<f32, 2>(-18.470053, -7.076649);
                                } else {
                                    z = array<f32, 2>(-18.97194, -7.0601754);
                                }
                            }
                        }
                    }
                } else {
                    if (row < 174u) {
                        if (row < 171u) {
                            if (row < 169u) {
                                z = array<f32, 2>(-19.517097, -7.0443735);
                            } else {
                                if (row < 170u) {
                                    z = array<f32, 2>(-20.112917, -7.029306);
                                } else {
                                    z = array<f32, 2>(-20.768896, -7.0150366);
                                }
                            }
                        } else {
                            if (row < 172u) {
                                z = array<f32, 2>(-21.497517, -7.001632);
                            } else {
                                if (row < 173u) {
                                    z = array<f32, 2>(-22.315666, -6.9891624);
                                } else {
                                    z = array<f32, 2>(-23.247, -6.9776993);
                                }
                            }
                        }
                    } else {
                        if (row < 177u) {
                            if (row < 175u) {
                                z = array<f32, 2>(-24.326128, -6.9673214);
                            } else {
                                if (row < 176u) {
                                    z = array<f32, 2>(-25.606674, -6.958114);
                                } else {
                                    z = array<f32, 2>(-27.178429, -6.9501715);
                                }
                            }
                        } else {
                            if (row < 178u) {
                                z = array<f32, 2>(-29.209646, -6.943605);
                            } else {
                                if (row < 179u) {
                                    z = array<f32, 2>(-32.077957, -6.9385505);
                                } else {
                                    z = array<f32, 2>(-36.988106, -6.9351954);
                                }
                            }
                        }
                    }
                }
            }
        }
    }
    return z;
}

// sqrt(4 pi): the DC coefficient of the function that is 1 everywhere, because y0 is 1/sqrt(4 pi).
const sh2_ROOT_FOUR_PI: f32 = 3.5449078;

// The largest finite number in half precision: (2 - 1/1024) * 32768. What is beyond is brought there.
const sh2_HALF_MAX: f32 = 65504.0;

// f without DC and over 2^p, the norm of that, p, and the root of the DC factor.
struct sh2_Halved {
    rest: array<f32, 4>,
    norm: f32,
    halvings: u32,
    root: f32,
}

fn sh2_halved(f: array<f32, 4>) -> sh2_Halved {
    var result = sh2_Halved(f, 0.0, 0u, 1.0);
    result.rest[0] = 0.0;
    result.norm = sqrt(sh2_dot(result.rest, result.rest));
    var scale = 1.0;
    while (result.norm >= 0.25 && result.halvings < 132u) {
        result.norm *= 0.5;
        scale *= 0.5;
        result.halvings += 1u;
    }
    for (var i = 1u; i < 4u; i += 1u) {
        result.rest[i] *= scale;
    }
    result.root = exp(f[0] * scale / sh2_ROOT_FOUR_PI);
    return result;
}

fn sh2_squared(g: array<f32, 4>, times: u32) -> array<f32, 4> {
    var result = g;
    for (var i = 0u; i < times; i += 1u) {
        result = sh2_square(result);
    }
    return result;
}

// sum + weight * term.
fn sh2_plus(sum: array<f32, 4>, weight: f32, term: array<f32, 4>) -> array<f32, 4> {
    var result = sum;
    for (var i = 0u; i < 4u; i += 1u) {
        result[i] += weight * term[i];
    }
    return result;
}

// PS-p: the plain product series up to `degree` (equation 17).
fn sh2_exp_product_series(f: array<f32, 4>, degree: u32) -> array<f32, 4> {
    var sum = array<f32, 4>();
    sum[0] = sh2_ROOT_FOUR_PI;
    var term = sum;
    var factorial = 1.0;
    for (var k = 1u; k <= degree; k += 1u) {
        term = sh2_product(term, f);
        factorial /= f32(k);
        sum = sh2_plus(sum, factorial, term);
    }
    return sum;
}

// PS*-p: the product series up to `degree`, even and odd powers apart (equation 22), scaled and squared.
fn sh2_exp_ps_star(f: array<f32, 4>, degree: u32) -> array<f32, 4> {
    let parts = sh2_halved(f);
    let square = sh2_square(parts.rest);
    var power = array<f32, 4>();
    power[0] = sh2_ROOT_FOUR_PI;
    var even = power;
    var odd = array<f32, 4>();
    var factorial = 1.0;
    for (var k = 0u; k <= degree; k += 2u) {
        if (k > 0u) {
            power = sh2_product(power, square);
            factorial /= f32(k * (k - 1u));
            even = sh2_plus(even, factorial, power);
        }
        if (k < degree) {
            odd = sh2_plus(odd, factorial / f32(k + 1u), power);
        }
    }
    var sum = sh2_plus(even, 1.0, sh2_product(parts.rest, odd));
    for (var i = 0u; i < 4u; i += 1u) {
        sum[i] *= parts.root;
    }
    return sh2_squared(sum, parts.halvings);
}

// HYB: the optimal linear a 1 + b f, with a and b fitted as functions of the norm (equations 23 and 24), scaled
// and squared.
fn sh2_exp_hyb(f: array<f32, 4>) -> array<f32, 4> {
    let parts = sh2_halved(f);
    let factors = parts.root * sh2_optimal_linear(parts.norm);
    var sum = array<f32, 4>();
    sum[0] = factors.x * sh2_ROOT_FOUR_PI;
    return sh2_squared(sh2_plus(sum, factors.y, parts.rest), parts.halvings);
}

// OL: the optimal linear a 1 + b f for any norm, neither scaled nor squared.
fn sh2_exp_optimal_linear(f: array<f32, 4>) -> array<f32, 4> {
    var rest = f;
    rest[0] = 0.0;
    let factors = exp(f[0] / sh2_ROOT_FOUR_PI) * sh2_optimal_linear_wide(sqrt(sh2_dot(rest, rest)));
    var sum = array<f32, 4>();
    sum[0] = factors.x * sh2_ROOT_FOUR_PI;
    return sh2_plus(sum, factors.y, rest);
}

// Zonal coefficients of the eigen logarithm of the visibility past a circular blocker about +Z whose angular radius is
// `angle`, interpolated between whole degrees; beyond 179 degrees it stays as it is there.
//
// Interpolation errs by at most 0.11 up to 150 degrees and by 0.42 from there on.
// Source: Ren et al. 2006, eq. 30-32, tabulated.
fn sh2_cap_log_table(angle: f32) -> array<f32, 2> {
    let place = clamp(angle * 57.295779513, 0.0, 179.0);
    let row = min(u32(place), 178u);
    let share = place - f32(row);
    var z = array<f32, 2>();
    for (var k = 0u; k < 2u; k += 1u) {
        let weight = select(share, 1.0 - share, k == 0u);
        let numbers = sh2_cap_log_row(row + k);
        for (var l = 0u; l < 2u; l += 1u) {
            z[l] += weight * numbers[l];
        }
    }
    return z;
}

// `f` as half-precision floats, two in each word, the one of lower index in the lower half: in memory they lie as an
// array of 4 f16 does. An odd one at the end is followed by 0. What is beyond 65504 is brought there.
//
// Rounding errs by at most 2^-11 of a coefficient, and by 2^-25 below 2^-14.
fn sh2_pack_half(f: array<f32, 4>) -> array<u32, (4 + 1) / 2> {
    var words = array<u32, (4 + 1) / 2>();
    for (var i = 0u; i < 4u; i += 2u) {
        let second = select(0.0, f[min(i + 1u, 4u - 1u)], i + 1u < 4u);
        words[i >> 1u] = pack2x16float(clamp(vec2<f32>(f[i], second), vec2<f32>(-sh2_HALF_MAX), vec2<f32>(sh2_HALF_MAX)));
    }
    return words;
}

// The vector that `pack_half` has packed.
fn sh2_unpack_half(words: array<u32, (4 + 1) / 2>) -> array<f32, 4> {
    var f = array<f32, 4>();
    for (var i = 0u; i < 4u; i += 1u) {
        let pair = unpack2x16float(words[i >> 1u]);
        f[i] = select(pair.x, pair.y, (i & 1u) == 1u);
    }
    return f;
}
