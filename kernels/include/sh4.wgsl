// Spherical harmonics of order 4 in WGSL. Gaunt 0.1.0.
// Made by `gaunt export --lang wgsl --order 4`; do not change it here. MIT or Apache-2.0, at your choice.
//
// Put it before or after your own text: it declares functions, constants and at most one struct, all of which start
// with the prefix. No extension is needed.
//
// A vector has 16 coefficients; that of band l and index m, -l to l, stands at l*l + l + m. The basis is real and
// orthonormal, with the signs usual in graphics (no Condon-Shortley): band 1 is sqrt(3/(4 pi)) (y, z, x), and the
// function 1 is (sqrt(4 pi), 0, ...). A zonal vector has the 4 coefficients of m = 0, one a band, of a function that
// is round about +Z. A symmetric matrix is its lower triangle, row by row. Axes are right-handed, angles radians;
// directions and quaternions (x, y, z, w) have length 1, and rotations are active: (Rf)(s) = f(R^-1 s).
//
// Routines, each with the prefix sh4_: basis, cosine, zonal, product, square, product_cosine, triple, dot,
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
// 27 multiplications, 7 additions.
fn sh4_basis(d: vec3<f32>) -> array<f32, 16> {
    let t5 = d.x + d.y;
    let t6 = d.x - d.y;
    let t7 = t5 * t6;
    let t9 = d.x * 2.0;
    let t10 = d.y * t9;
    let t11 = d.y * t10;
    let t12 = fma(d.x, t7, -t11);
    let t13 = d.x * t10;
    let t14 = fma(d.y, t7, t13);
    let t15 = d.z * d.z;
    let t18 = d.y * 0.48860252;
    let t19 = d.z * 0.48860252;
    let t20 = d.x * 0.48860252;
    let t22 = t10 * 0.54627424;
    let t24 = d.z * 1.0925485;
    let t25 = d.y * t24;
    let t28 = fma(t15, 0.9461747, (-0.31539157));
    let t29 = d.x * t24;
    let t30 = t7 * 0.54627424;
    let t32 = t14 * 0.5900436;
    let t34 = d.z * 1.4453057;
    let t35 = t10 * t34;
    let t38 = fma(t15, 2.285229, (-0.4570458));
    let t39 = d.y * t38;
    let t42 = fma(t15, 1.8658817, (-1.119529));
    let t43 = d.z * t42;
    let t44 = d.x * t38;
    let t45 = t7 * t34;
    let t46 = t12 * 0.5900436;
    return array<f32, 16>(
        0.2820948, t18, t19, t20, t22, t25, t28, t29, t30, t32, t35, t39, t43, t44, t45, t46,
    );
}

// The cosine lobe about the unit normal `d`, over pi: its dot product with radiance is the radiance that a white
// diffuse surface reflects.
// Source: Ren et al. 2006, eq. 9; Ramamoorthi and Hanrahan 2001: A_l/pi = 1, 2/3, 1/4, 0, -1/24, 0.
// 21 multiplications, 3 additions.
fn sh4_cosine(d: vec3<f32>) -> array<f32, 16> {
    let t7 = d.x + d.y;
    let t8 = d.x - d.y;
    let t9 = t7 * t8;
    let t11 = d.x * 2.0;
    let t12 = d.y * t11;
    let t17 = d.z * d.z;
    let t20 = d.y * 0.48860252;
    let t21 = d.z * 0.48860252;
    let t22 = d.x * 0.48860252;
    let t24 = t12 * 0.54627424;
    let t26 = d.z * 1.0925485;
    let t27 = d.y * t26;
    let t30 = fma(t17, 0.9461747, (-0.31539157));
    let t31 = d.x * t26;
    let t32 = t9 * 0.54627424;
    let t49 = 0.6666667 * t20;
    let t50 = 0.6666667 * t21;
    let t51 = 0.6666667 * t22;
    let t52 = 0.25 * t24;
    let t53 = 0.25 * t27;
    let t54 = 0.25 * t30;
    let t55 = 0.25 * t31;
    let t56 = 0.25 * t32;
    return array<f32, 16>(
        0.2820948, t49, t50, t51, t52, t53, t54, t55, t56, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    );
}

// The zonal vector `z` about +Z, turned to the unit vector `d`.
// Source: Sloan et al. 2005; Ren et al. 2006, section 6.1: f_lm = sqrt(4 pi/(2l+1)) z_l y_lm(d).
// 47 multiplications, 7 additions.
fn sh4_zonal(z: array<f32, 4>, d: vec3<f32>) -> array<f32, 16> {
    let t8 = z[0] * 3.5449078;
    let t10 = z[1] * 2.0466535;
    let t12 = z[2] * 1.585331;
    let t14 = z[3] * 1.3398491;
    let t17 = d.x + d.y;
    let t18 = d.x - d.y;
    let t19 = t17 * t18;
    let t21 = d.x * 2.0;
    let t22 = d.y * t21;
    let t23 = d.y * t22;
    let t24 = fma(d.x, t19, -t23);
    let t25 = d.x * t22;
    let t26 = fma(d.y, t19, t25);
    let t27 = d.z * d.z;
    let t30 = d.y * 0.48860252;
    let t31 = d.z * 0.48860252;
    let t32 = d.x * 0.48860252;
    let t34 = t22 * 0.54627424;
    let t36 = d.z * 1.0925485;
    let t37 = d.y * t36;
    let t40 = fma(t27, 0.9461747, (-0.31539157));
    let t41 = d.x * t36;
    let t42 = t19 * 0.54627424;
    let t44 = t26 * 0.5900436;
    let t46 = d.z * 1.4453057;
    let t47 = t22 * t46;
    let t50 = fma(t27, 2.285229, (-0.4570458));
    let t51 = d.y * t50;
    let t54 = fma(t27, 1.8658817, (-1.119529));
    let t55 = d.z * t54;
    let t56 = d.x * t50;
    let t57 = t19 * t46;
    let t58 = t24 * 0.5900436;
    let t59 = t8 * 0.2820948;
    let t60 = t10 * t30;
    let t61 = t10 * t31;
    let t62 = t10 * t32;
    let t63 = t12 * t34;
    let t64 = t12 * t37;
    let t65 = t12 * t40;
    let t66 = t12 * t41;
    let t67 = t12 * t42;
    let t68 = t14 * t44;
    let t69 = t14 * t47;
    let t70 = t14 * t51;
    let t71 = t14 * t55;
    let t72 = t14 * t56;
    let t73 = t14 * t57;
    let t74 = t14 * t58;
    return array<f32, 16>(
        t59, t60, t61, t62, t63, t64, t65, t66, t67, t68, t69, t70, t71, t72, t73, t74,
    );
}

// The product `f * g`, projected back to order n.
//
// Commutative, not associative: what lies above order n is dropped each time.
// Source: Ren et al. 2006, eq. 3.
// 329 multiplications, 258 additions.
fn sh4_product(f: array<f32, 16>, g: array<f32, 16>) -> array<f32, 16> {
    let t33 = f[0] * 0.2820948;
    let t35 = f[6] * 0.12615663;
    let t37 = f[8] * 0.21850969;
    let t39 = t33 - t35;
    let t40 = t39 - t37;
    let t41 = g[0] * 0.2820948;
    let t42 = g[6] * 0.12615663;
    let t43 = g[8] * 0.21850969;
    let t44 = t41 - t42;
    let t45 = t44 - t43;
    let t46 = f[1] * g[1];
    let t47 = 0.2820948 * t46;
    let t48 = 0.12615663 * t46;
    let t50 = g[1] * t40;
    let t52 = fma(f[1], t45, t50);
    let t53 = t37 + t39;
    let t54 = t43 + t44;
    let t55 = f[3] * g[3];
    let t57 = fma(0.2820948, t55, t47);
    let t59 = fma(0.12615663, t55, t48);
    let t60 = 0.21850969 * t55;
    let t61 = fma((-0.21850969), t46, t60);
    let t62 = g[3] * t53;
    let t64 = fma(f[3], t54, t62);
    let t68 = f[8] * 0.15607835;
    let t69 = fma(f[6], 0.090111874, t33);
    let t70 = t69 - t68;
    let t72 = g[8] * 0.15607835;
    let t73 = fma(g[6], 0.090111874, t41);
    let t74 = t73 - t72;
    let t75 = f[5] * g[5];
    let t77 = fma(0.2820948, t75, t57);
    let t79 = fma(0.090111874, t75, -t59);
    let t81 = fma((-0.15607835), t75, t61);
    let t82 = g[5] * t70;
    let t84 = fma(f[5], t74, t82);
    let t85 = t68 + t69;
    let t86 = t72 + t73;
    let t87 = f[7] * g[7];
    let t89 = fma(0.2820948, t87, t77);
    let t91 = fma(0.090111874, t87, t79);
    let t93 = fma(0.15607835, t87, t81);
    let t94 = g[7] * t85;
    let t96 = fma(f[7], t86, t94);
    let t98 = f[8] * 0.14567313;
    let t99 = t33 + t35;
    let t100 = t99 - t98;
    let t101 = g[8] * 0.14567313;
    let t102 = t41 + t42;
    let t103 = t102 - t101;
    let t104 = f[11] * g[11];
    let t106 = fma(0.2820948, t104, t89);
    let t108 = fma(0.12615663, t104, t91);
    let t110 = fma((-0.14567313), t104, t93);
    let t111 = g[11] * t100;
    let t113 = fma(f[11], t103, t111);
    let t114 = t98 + t99;
    let t115 = t101 + t102;
    let t116 = f[13] * g[13];
    let t118 = fma(0.2820948, t116, t106);
    let t120 = fma(0.12615663, t116, t108);
    let t122 = fma(0.14567313, t116, t110);
    let t123 = g[13] * t114;
    let t125 = fma(f[13], t115, t123);
    let t128 = fma(f[6], 0.25231326, t33);
    let t130 = fma(g[6], 0.25231326, t41);
    let t131 = f[2] * g[2];
    let t133 = fma(0.2820948, t131, t118);
    let t135 = fma(0.25231326, t131, t120);
    let t136 = g[2] * t128;
    let t138 = fma(f[2], t130, t136);
    let t141 = fma(-f[6], 0.18022375, t33);
    let t143 = fma(-g[6], 0.18022375, t41);
    let t144 = f[4] * g[4];
    let t146 = fma(0.2820948, t144, t133);
    let t148 = fma((-0.18022375), t144, t135);
    let t149 = g[4] * t141;
    let t151 = fma(f[4], t143, t149);
    let t152 = f[6] * g[6];
    let t154 = fma(0.2820948, t152, t146);
    let t156 = fma(0.18022375, t152, t148);
    let t157 = g[6] * t33;
    let t159 = fma(f[6], t41, t157);
    let t160 = t156 + t159;
    let t161 = f[8] * g[8];
    let t163 = fma(0.2820948, t161, t154);
    let t165 = fma((-0.18022375), t161, t160);
    let t166 = g[8] * t141;
    let t168 = fma(f[8], t143, t166);
    let t169 = t122 + t168;
    let t172 = fma(-f[6], 0.21026105, t33);
    let t174 = fma(-g[6], 0.21026105, t41);
    let t175 = f[9] * g[9];
    let t177 = fma(0.2820948, t175, t163);
    let t179 = fma((-0.21026105), t175, t165);
    let t180 = g[9] * t172;
    let t182 = fma(f[9], t174, t180);
    let t185 = fma(f[6], 0.16820884, t33);
    let t187 = fma(g[6], 0.16820884, t41);
    let t188 = f[12] * g[12];
    let t190 = fma(0.2820948, t188, t177);
    let t192 = fma(0.16820884, t188, t179);
    let t193 = g[12] * t185;
    let t195 = fma(f[12], t187, t193);
    let t196 = f[15] * g[15];
    let t198 = fma(0.2820948, t196, t190);
    let t200 = fma((-0.21026105), t196, t192);
    let t201 = g[15] * t172;
    let t203 = fma(f[15], t174, t201);
    let t204 = f[0] * g[0];
    let t206 = fma(0.2820948, t204, t198);
    let t207 = f[10] * g[10];
    let t209 = fma(0.2820948, t207, t206);
    let t210 = g[10] * t33;
    let t212 = fma(f[10], t41, t210);
    let t213 = f[14] * g[14];
    let t215 = fma(0.2820948, t213, t209);
    let t216 = g[14] * t33;
    let t218 = fma(f[14], t41, t216);
    let t221 = f[13] * 0.05839917;
    let t223 = f[15] * 0.22617902;
    let t224 = fma(f[3], 0.21850969, -t221);
    let t225 = t224 - t223;
    let t227 = g[13] * 0.05839917;
    let t228 = g[15] * 0.22617902;
    let t229 = fma(g[3], 0.21850969, -t227);
    let t230 = t229 - t228;
    let t231 = f[1] * g[4];
    let t233 = fma(f[4], g[1], t231);
    let t235 = fma(0.21850969, t233, t64);
    let t237 = fma((-0.05839917), t233, t125);
    let t239 = fma((-0.22617902), t233, t203);
    let t240 = g[4] * t225;
    let t242 = fma(f[4], t230, t240);
    let t243 = t52 + t242;
    let t244 = g[1] * t225;
    let t246 = fma(f[1], t230, t244);
    let t247 = t151 + t246;
    let t248 = f[2] * 0.21850969;
    let t252 = f[14] * 0.1846744;
    let t253 = fma(-f[12], 0.14304817, t248);
    let t254 = t253 - t252;
    let t255 = g[2] * 0.21850969;
    let t257 = g[14] * 0.1846744;
    let t258 = fma(-g[12], 0.14304817, t255);
    let t259 = t258 - t257;
    let t260 = f[1] * g[5];
    let t262 = fma(f[5], g[1], t260);
    let t264 = fma(0.21850969, t262, t138);
    let t266 = fma((-0.14304817), t262, t195);
    let t268 = fma((-0.1846744), t262, t218);
    let t269 = g[5] * t254;
    let t271 = fma(f[5], t259, t269);
    let t272 = t243 + t271;
    let t273 = g[1] * t254;
    let t275 = fma(f[1], t259, t273);
    let t276 = t84 + t275;
    let t277 = t252 + t253;
    let t278 = t257 + t258;
    let t279 = f[3] * g[7];
    let t281 = fma(f[7], g[3], t279);
    let t283 = fma(0.21850969, t281, t264);
    let t285 = fma((-0.14304817), t281, t266);
    let t287 = fma(0.1846744, t281, t268);
    let t288 = g[7] * t277;
    let t290 = fma(f[7], t278, t288);
    let t291 = t235 + t290;
    let t292 = g[3] * t277;
    let t294 = fma(f[3], t278, t292);
    let t295 = t96 + t294;
    let t297 = f[13] * 0.14567313;
    let t299 = f[15] * 0.094031595;
    let t300 = fma(-f[3], 0.05839917, t297);
    let t301 = t299 + t300;
    let t303 = g[13] * 0.14567313;
    let t304 = g[15] * 0.094031595;
    let t305 = fma(-g[3], 0.05839917, t303);
    let t306 = t304 + t305;
    let t307 = f[4] * g[11];
    let t309 = fma(f[11], g[4], t307);
    let t311 = fma((-0.05839917), t309, t291);
    let t313 = fma(0.14567313, t309, t237);
    let t315 = fma(0.094031595, t309, t239);
    let t316 = g[11] * t301;
    let t318 = fma(f[11], t306, t316);
    let t319 = t247 + t318;
    let t320 = g[4] * t301;
    let t322 = fma(f[4], t306, t320);
    let t323 = t113 + t322;
    let t324 = f[3] * 0.1846744;
    let t328 = f[15] * 0.148677;
    let t329 = fma(f[13], 0.11516472, t324);
    let t330 = t329 - t328;
    let t331 = g[3] * 0.1846744;
    let t333 = g[15] * 0.148677;
    let t334 = fma(g[13], 0.11516472, t331);
    let t335 = t334 - t333;
    let t336 = f[5] * g[10];
    let t338 = fma(f[10], g[5], t336);
    let t340 = fma(0.1846744, t338, t311);
    let t342 = fma(0.11516472, t338, t313);
    let t344 = fma((-0.148677), t338, t315);
    let t345 = g[10] * t330;
    let t347 = fma(f[10], t335, t345);
    let t348 = t276 + t347;
    let t349 = g[5] * t330;
    let t351 = fma(f[5], t335, t349);
    let t352 = t212 + t351;
    let t354 = f[2] * 0.23359668;
    let t357 = f[14] * 0.11516472;
    let t358 = fma(f[12], 0.059470803, t354);
    let t359 = t358 - t357;
    let t360 = g[2] * 0.23359668;
    let t362 = g[14] * 0.11516472;
    let t363 = fma(g[12], 0.059470803, t360);
    let t364 = t363 - t362;
    let t365 = f[5] * g[11];
    let t367 = fma(f[11], g[5], t365);
    let t369 = fma(0.23359668, t367, t283);
    let t371 = fma(0.059470803, t367, t285);
    let t373 = fma((-0.11516472), t367, t287);
    let t374 = g[11] * t359;
    let t376 = fma(f[11], t364, t374);
    let t377 = t348 + t376;
    let t378 = g[5] * t359;
    let t380 = fma(f[5], t364, t378);
    let t381 = t323 + t380;
    let t382 = f[1] * 0.1846744;
    let t385 = fma(f[9], 0.148677, t382);
    let t386 = fma(f[11], 0.11516472, t385);
    let t387 = g[1] * 0.1846744;
    let t390 = fma(g[9], 0.148677, t387);
    let t391 = fma(g[11], 0.11516472, t390);
    let t392 = f[7] * g[10];
    let t394 = fma(f[10], g[7], t392);
    let t396 = fma(0.1846744, t394, t272);
    let t398 = fma(0.148677, t394, t182);
    let t400 = fma(0.11516472, t394, t381);
    let t401 = g[10] * t386;
    let t403 = fma(f[10], t391, t401);
    let t404 = t295 + t403;
    let t405 = g[7] * t386;
    let t407 = fma(f[7], t391, t405);
    let t408 = t352 + t407;
    let t409 = t357 + t358;
    let t410 = t362 + t363;
    let t411 = f[7] * g[13];
    let t413 = fma(f[13], g[7], t411);
    let t415 = fma(0.23359668, t413, t369);
    let t417 = fma(0.059470803, t413, t371);
    let t419 = fma(0.11516472, t413, t373);
    let t420 = g[13] * t409;
    let t422 = fma(f[13], t410, t420);
    let t423 = t404 + t422;
    let t424 = g[7] * t409;
    let t426 = fma(f[7], t410, t424);
    let t427 = t342 + t426;
    let t428 = f[9] * 0.22617902;
    let t430 = fma(f[11], 0.05839917, t428);
    let t431 = g[9] * 0.22617902;
    let t433 = fma(g[11], 0.05839917, t431);
    let t434 = f[1] * g[8];
    let t436 = fma(f[8], g[1], t434);
    let t438 = fma(0.22617902, t436, t398);
    let t440 = fma(0.05839917, t436, t400);
    let t441 = g[8] * t430;
    let t443 = fma(f[8], t433, t441);
    let t444 = t396 + t443;
    let t445 = g[1] * t430;
    let t447 = fma(f[1], t433, t445);
    let t448 = t169 + t447;
    let t449 = t223 - t221;
    let t450 = t228 - t227;
    let t451 = f[3] * g[8];
    let t453 = fma(f[8], g[3], t451);
    let t455 = fma((-0.05839917), t453, t427);
    let t457 = fma(0.22617902, t453, t344);
    let t458 = g[8] * t449;
    let t460 = fma(f[8], t450, t458);
    let t461 = t340 + t460;
    let t462 = g[3] * t449;
    let t464 = fma(f[3], t450, t462);
    let t465 = t448 + t464;
    let t466 = f[3] * 0.22617902;
    let t468 = fma(-f[13], 0.094031595, t466);
    let t469 = g[3] * 0.22617902;
    let t471 = fma(-g[13], 0.094031595, t469);
    let t472 = f[4] * g[9];
    let t474 = fma(f[9], g[4], t472);
    let t476 = fma(0.22617902, t474, t461);
    let t478 = fma((-0.094031595), t474, t455);
    let t479 = g[9] * t468;
    let t481 = fma(f[9], t471, t479);
    let t482 = t319 + t481;
    let t483 = g[4] * t468;
    let t485 = fma(f[4], t471, t483);
    let t486 = t438 + t485;
    let t487 = f[2] * 0.1846744;
    let t490 = fma(-f[12], 0.18806319, t487);
    let t491 = g[2] * 0.1846744;
    let t493 = fma(-g[12], 0.18806319, t491);
    let t494 = f[4] * g[10];
    let t496 = fma(f[10], g[4], t494);
    let t498 = fma(0.1846744, t496, t415);
    let t500 = fma((-0.18806319), t496, t417);
    let t501 = g[10] * t490;
    let t503 = fma(f[10], t493, t501);
    let t504 = t482 + t503;
    let t505 = g[4] * t490;
    let t507 = fma(f[4], t493, t505);
    let t508 = t408 + t507;
    let t509 = f[8] * g[14];
    let t511 = fma(f[14], g[8], t509);
    let t513 = fma(0.1846744, t511, t498);
    let t515 = fma((-0.18806319), t511, t500);
    let t516 = g[14] * t490;
    let t518 = fma(f[14], t493, t516);
    let t519 = t465 + t518;
    let t520 = g[8] * t490;
    let t522 = fma(f[8], t493, t520);
    let t523 = t419 + t522;
    let t525 = f[11] * 0.20230065;
    let t526 = g[11] * 0.20230065;
    let t527 = f[1] * g[6];
    let t529 = fma(f[6], g[1], t527);
    let t531 = fma(0.20230065, t529, t440);
    let t532 = g[6] * t525;
    let t534 = fma(f[6], t526, t532);
    let t535 = t444 + t534;
    let t536 = g[1] * t525;
    let t538 = fma(f[1], t526, t536);
    let t539 = t200 + t538;
    let t541 = f[12] * 0.24776669;
    let t542 = g[12] * 0.24776669;
    let t543 = f[2] * g[6];
    let t545 = fma(f[6], g[2], t543);
    let t547 = fma(0.24776669, t545, t515);
    let t548 = g[6] * t541;
    let t550 = fma(f[6], t542, t548);
    let t551 = t513 + t550;
    let t552 = g[2] * t541;
    let t554 = fma(f[2], t542, t552);
    let t555 = t539 + t554;
    let t556 = f[13] * 0.20230065;
    let t557 = g[13] * 0.20230065;
    let t558 = f[3] * g[6];
    let t560 = fma(f[6], g[3], t558);
    let t562 = fma(0.20230065, t560, t478);
    let t563 = g[6] * t556;
    let t565 = fma(f[6], t557, t563);
    let t566 = t476 + t565;
    let t567 = g[3] * t556;
    let t569 = fma(f[3], t557, t567);
    let t570 = t555 + t569;
    let t571 = f[7] * 0.15607835;
    let t572 = g[7] * 0.15607835;
    let t573 = f[4] * g[5];
    let t575 = fma(f[5], g[4], t573);
    let t577 = fma(0.15607835, t575, t423);
    let t578 = g[5] * t571;
    let t580 = fma(f[5], t572, t578);
    let t581 = t504 + t580;
    let t582 = g[4] * t571;
    let t584 = fma(f[4], t572, t582);
    let t585 = t377 + t584;
    let t586 = f[14] * 0.148677;
    let t587 = g[14] * 0.148677;
    let t588 = f[5] * g[9];
    let t590 = fma(f[9], g[5], t588);
    let t592 = fma(0.148677, t590, t523);
    let t593 = g[9] * t586;
    let t595 = fma(f[9], t587, t593);
    let t596 = t585 + t595;
    let t597 = g[5] * t586;
    let t599 = fma(f[5], t587, t597);
    let t600 = t486 + t599;
    let t601 = f[7] * g[14];
    let t603 = fma(f[14], g[7], t601);
    let t605 = fma(0.148677, t603, t457);
    let t606 = g[14] * t328;
    let t608 = fma(f[14], t333, t606);
    let t609 = t577 + t608;
    let t610 = g[7] * t328;
    let t612 = fma(f[7], t333, t610);
    let t613 = t592 + t612;
    let t614 = f[11] * 0.094031595;
    let t615 = g[11] * 0.094031595;
    let t616 = f[8] * g[9];
    let t618 = fma(f[9], g[8], t616);
    let t620 = fma((-0.094031595), t618, t531);
    let t621 = g[9] * t614;
    let t623 = fma(f[9], t615, t621);
    let t624 = t519 - t623;
    let t625 = g[8] * t614;
    let t627 = fma(f[8], t615, t625);
    let t628 = t600 - t627;
    let t629 = f[8] * g[13];
    let t631 = fma(f[13], g[8], t629);
    let t633 = fma((-0.094031595), t631, t605);
    let t634 = g[13] * t299;
    let t636 = fma(f[13], t304, t634);
    let t637 = t624 - t636;
    let t638 = g[8] * t299;
    let t640 = fma(f[8], t304, t638);
    let t641 = t562 - t640;
    return array<f32, 16>(
        t215, t535, t551, t566, t581, t596, t570, t609, t637, t628, t508, t620, t547, t641, t613,
        t633,
    );
}

// The product of `f` with itself, at about two thirds of a product's cost.
// Source: Ren et al. 2006, eq. 3 with g = f.
// 211 multiplications, 149 additions.
fn sh4_square(f: array<f32, 16>) -> array<f32, 16> {
    let t17 = f[0] * 0.5641896;
    let t19 = f[6] * 0.25231326;
    let t21 = f[8] * 0.43701938;
    let t23 = t17 - t19;
    let t24 = t23 - t21;
    let t25 = f[1] * f[1];
    let t27 = t25 * 0.2820948;
    let t29 = t25 * 0.12615663;
    let t32 = f[1] * t24;
    let t33 = t21 + t23;
    let t34 = f[3] * f[3];
    let t36 = fma(0.2820948, t34, t27);
    let t38 = fma(0.12615663, t34, t29);
    let t39 = 0.21850969 * t34;
    let t40 = fma(-t25, 0.21850969, t39);
    let t41 = f[3] * t33;
    let t45 = f[8] * 0.3121567;
    let t46 = fma(f[6], 0.18022375, t17);
    let t47 = t46 - t45;
    let t48 = f[5] * f[5];
    let t50 = fma(0.2820948, t48, t36);
    let t53 = fma(t48, 0.090111874, -t38);
    let t56 = fma(-t48, 0.15607835, t40);
    let t57 = f[5] * t47;
    let t58 = t45 + t46;
    let t59 = f[7] * f[7];
    let t61 = fma(0.2820948, t59, t50);
    let t63 = fma(0.090111874, t59, t53);
    let t65 = fma(0.15607835, t59, t56);
    let t66 = f[7] * t58;
    let t68 = f[8] * 0.29134625;
    let t69 = t17 + t19;
    let t70 = t69 - t68;
    let t71 = f[11] * f[11];
    let t73 = fma(0.2820948, t71, t61);
    let t75 = fma(0.12615663, t71, t63);
    let t78 = fma(-t71, 0.14567313, t65);
    let t79 = f[11] * t70;
    let t80 = t68 + t69;
    let t81 = f[13] * f[13];
    let t83 = fma(0.2820948, t81, t73);
    let t85 = fma(0.12615663, t81, t75);
    let t87 = fma(0.14567313, t81, t78);
    let t88 = f[13] * t80;
    let t91 = fma(f[6], 0.5046265, t17);
    let t92 = f[2] * f[2];
    let t94 = fma(0.2820948, t92, t83);
    let t96 = fma(0.25231326, t92, t85);
    let t97 = f[2] * t91;
    let t100 = fma(-f[6], 0.3604475, t17);
    let t101 = f[4] * f[4];
    let t103 = fma(0.2820948, t101, t94);
    let t105 = fma((-0.18022375), t101, t96);
    let t106 = f[4] * t100;
    let t107 = f[6] * f[6];
    let t109 = fma(0.2820948, t107, t103);
    let t111 = fma(0.18022375, t107, t105);
    let t113 = fma(f[6], t17, t111);
    let t114 = f[8] * f[8];
    let t116 = fma(0.2820948, t114, t109);
    let t118 = fma((-0.18022375), t114, t113);
    let t120 = fma(f[8], t100, t87);
    let t123 = fma(-f[6], 0.4205221, t17);
    let t124 = f[9] * f[9];
    let t126 = fma(0.2820948, t124, t116);
    let t129 = fma(-t124, 0.21026105, t118);
    let t130 = f[9] * t123;
    let t133 = fma(f[6], 0.33641768, t17);
    let t134 = f[12] * f[12];
    let t136 = fma(0.2820948, t134, t126);
    let t139 = fma(t134, 0.16820884, t129);
    let t140 = f[12] * t133;
    let t141 = f[15] * f[15];
    let t143 = fma(0.2820948, t141, t136);
    let t145 = fma((-0.21026105), t141, t139);
    let t146 = f[15] * t123;
    let t147 = f[0] * f[0];
    let t149 = fma(0.2820948, t147, t143);
    let t150 = f[10] * f[10];
    let t152 = fma(0.2820948, t150, t149);
    let t153 = f[10] * t17;
    let t154 = f[14] * f[14];
    let t156 = fma(0.2820948, t154, t152);
    let t157 = f[14] * t17;
    let t160 = f[13] * 0.11679834;
    let t162 = f[15] * 0.45235804;
    let t163 = fma(f[3], 0.43701938, -t160);
    let t164 = t163 - t162;
    let t165 = f[1] * f[4];
    let t167 = fma(0.43701938, t165, t41);
    let t169 = fma((-0.11679834), t165, t88);
    let t171 = fma((-0.45235804), t165, t146);
    let t173 = fma(f[4], t164, t32);
    let t175 = fma(f[1], t164, t106);
    let t176 = f[2] * 0.43701938;
    let t180 = f[14] * 0.3693488;
    let t181 = fma(-f[12], 0.28609633, t176);
    let t182 = t181 - t180;
    let t183 = f[1] * f[5];
    let t185 = fma(0.43701938, t183, t97);
    let t187 = fma((-0.28609633), t183, t140);
    let t189 = fma((-0.3693488), t183, t157);
    let t191 = fma(f[5], t182, t173);
    let t193 = fma(f[1], t182, t57);
    let t194 = t180 + t181;
    let t195 = f[3] * f[7];
    let t197 = fma(0.43701938, t195, t185);
    let t199 = fma((-0.28609633), t195, t187);
    let t201 = fma(0.3693488, t195, t189);
    let t203 = fma(f[7], t194, t167);
    let t205 = fma(f[3], t194, t66);
    let t207 = f[13] * 0.29134625;
    let t209 = f[15] * 0.18806319;
    let t210 = fma(-f[3], 0.11679834, t207);
    let t211 = t209 + t210;
    let t212 = f[4] * f[11];
    let t214 = fma((-0.11679834), t212, t203);
    let t216 = fma(0.29134625, t212, t169);
    let t218 = fma(0.18806319, t212, t171);
    let t220 = fma(f[11], t211, t175);
    let t222 = fma(f[4], t211, t79);
    let t223 = f[3] * 0.3693488;
    let t227 = f[15] * 0.297354;
    let t228 = fma(f[13], 0.23032944, t223);
    let t229 = t228 - t227;
    let t230 = f[5] * f[10];
    let t232 = fma(0.3693488, t230, t214);
    let t234 = fma(0.23032944, t230, t216);
    let t236 = fma((-0.297354), t230, t218);
    let t238 = fma(f[10], t229, t193);
    let t240 = fma(f[5], t229, t153);
    let t242 = f[2] * 0.46719337;
    let t245 = f[14] * 0.23032944;
    let t246 = fma(f[12], 0.118941605, t242);
    let t247 = t246 - t245;
    let t248 = f[5] * f[11];
    let t250 = fma(0.46719337, t248, t197);
    let t252 = fma(0.118941605, t248, t199);
    let t254 = fma((-0.23032944), t248, t201);
    let t256 = fma(f[11], t247, t238);
    let t258 = fma(f[5], t247, t222);
    let t259 = f[1] * 0.3693488;
    let t262 = fma(f[9], 0.297354, t259);
    let t263 = fma(f[11], 0.23032944, t262);
    let t264 = f[7] * f[10];
    let t266 = fma(0.3693488, t264, t191);
    let t268 = fma(0.297354, t264, t130);
    let t270 = fma(0.23032944, t264, t258);
    let t272 = fma(f[10], t263, t205);
    let t274 = fma(f[7], t263, t240);
    let t275 = t245 + t246;
    let t276 = f[7] * f[13];
    let t278 = fma(0.46719337, t276, t250);
    let t280 = fma(0.118941605, t276, t252);
    let t282 = fma(0.23032944, t276, t254);
    let t284 = fma(f[13], t275, t272);
    let t286 = fma(f[7], t275, t234);
    let t287 = f[9] * 0.45235804;
    let t289 = fma(f[11], 0.11679834, t287);
    let t290 = f[1] * f[8];
    let t292 = fma(0.45235804, t290, t268);
    let t294 = fma(0.11679834, t290, t270);
    let t296 = fma(f[8], t289, t266);
    let t298 = fma(f[1], t289, t120);
    let t299 = t162 - t160;
    let t300 = f[3] * f[8];
    let t302 = fma((-0.11679834), t300, t286);
    let t304 = fma(0.45235804, t300, t236);
    let t306 = fma(f[8], t299, t232);
    let t308 = fma(f[3], t299, t298);
    let t309 = f[3] * 0.45235804;
    let t311 = fma(-f[13], 0.18806319, t309);
    let t312 = f[4] * f[9];
    let t314 = fma(0.45235804, t312, t306);
    let t316 = fma((-0.18806319), t312, t302);
    let t318 = fma(f[9], t311, t220);
    let t320 = fma(f[4], t311, t292);
    let t321 = f[2] * 0.3693488;
    let t324 = fma(-f[12], 0.37612638, t321);
    let t325 = f[4] * f[10];
    let t327 = fma(0.3693488, t325, t278);
    let t329 = fma((-0.37612638), t325, t280);
    let t331 = fma(f[10], t324, t318);
    let t333 = fma(f[4], t324, t274);
    let t334 = f[8] * f[14];
    let t336 = fma(0.3693488, t334, t327);
    let t338 = fma((-0.37612638), t334, t329);
    let t340 = fma(f[14], t324, t308);
    let t342 = fma(f[8], t324, t282);
    let t344 = f[11] * 0.4046013;
    let t345 = f[1] * f[6];
    let t347 = fma(0.4046013, t345, t294);
    let t349 = fma(f[6], t344, t296);
    let t351 = fma(f[1], t344, t145);
    let t353 = f[12] * 0.49553338;
    let t354 = f[2] * f[6];
    let t356 = fma(0.49553338, t354, t338);
    let t358 = fma(f[6], t353, t336);
    let t360 = fma(f[2], t353, t351);
    let t361 = f[13] * 0.4046013;
    let t362 = f[3] * f[6];
    let t364 = fma(0.4046013, t362, t316);
    let t366 = fma(f[6], t361, t314);
    let t368 = fma(f[3], t361, t360);
    let t369 = f[7] * 0.3121567;
    let t370 = f[4] * f[5];
    let t372 = fma(0.3121567, t370, t284);
    let t374 = fma(f[5], t369, t331);
    let t376 = fma(f[4], t369, t256);
    let t377 = f[14] * 0.297354;
    let t378 = f[5] * f[9];
    let t380 = fma(0.297354, t378, t342);
    let t382 = fma(f[9], t377, t376);
    let t384 = fma(f[5], t377, t320);
    let t385 = f[7] * f[14];
    let t387 = fma(0.297354, t385, t304);
    let t389 = fma(f[14], t227, t372);
    let t391 = fma(f[7], t227, t380);
    let t392 = f[11] * 0.18806319;
    let t393 = f[8] * f[9];
    let t395 = fma((-0.18806319), t393, t347);
    let t397 = fma(-f[9], t392, t340);
    let t399 = fma(-f[8], t392, t384);
    let t400 = f[8] * f[13];
    let t402 = fma((-0.18806319), t400, t387);
    let t404 = fma(-f[13], t209, t397);
    let t406 = fma(-f[8], t209, t364);
    return array<f32, 16>(
        t156, t349, t358, t366, t374, t382, t368, t389, t404, t399, t333, t395, t356, t406, t391,
        t402,
    );
}

// The product `f * H(d)` with the cosine lobe about `d`, cheaper than forming and multiplying it: what remains is a dot
// product with each channel of the light.
// Source: Ren et al. 2006, eq. 3 and 9.
// 254 multiplications, 175 additions.
fn sh4_product_cosine(f: array<f32, 16>, d: vec3<f32>) -> array<f32, 16> {
    let t23 = d.x + d.y;
    let t24 = d.x - d.y;
    let t25 = t23 * t24;
    let t27 = d.x * 2.0;
    let t28 = d.y * t27;
    let t33 = d.z * d.z;
    let t36 = d.y * 0.48860252;
    let t37 = d.z * 0.48860252;
    let t38 = d.x * 0.48860252;
    let t40 = t28 * 0.54627424;
    let t42 = d.z * 1.0925485;
    let t43 = d.y * t42;
    let t46 = fma(t33, 0.9461747, (-0.31539157));
    let t47 = d.x * t42;
    let t48 = t25 * 0.54627424;
    let t65 = 0.6666667 * t36;
    let t66 = 0.6666667 * t37;
    let t67 = 0.6666667 * t38;
    let t68 = 0.25 * t40;
    let t69 = 0.25 * t43;
    let t70 = 0.25 * t46;
    let t71 = 0.25 * t47;
    let t72 = 0.25 * t48;
    let t73 = f[0] * 0.2820948;
    let t77 = f[8] * 0.21850969;
    let t78 = fma(-f[6], 0.12615663, t73);
    let t79 = t78 - t77;
    let t81 = t70 * 0.12615663;
    let t82 = t72 * 0.21850969;
    let t83 = 0.07957747 - t81;
    let t84 = t83 - t82;
    let t85 = f[1] * t65;
    let t86 = 0.2820948 * t85;
    let t87 = 0.12615663 * t85;
    let t89 = t65 * t79;
    let t91 = fma(f[1], t84, t89);
    let t92 = t77 + t78;
    let t93 = t82 + t83;
    let t94 = f[3] * t67;
    let t96 = fma(0.2820948, t94, t86);
    let t98 = fma(0.12615663, t94, t87);
    let t99 = 0.21850969 * t94;
    let t100 = fma((-0.21850969), t85, t99);
    let t101 = t67 * t92;
    let t103 = fma(f[3], t93, t101);
    let t107 = f[8] * 0.15607835;
    let t108 = fma(f[6], 0.090111874, t73);
    let t109 = t108 - t107;
    let t111 = t72 * 0.15607835;
    let t112 = fma(t70, 0.090111874, 0.07957747);
    let t113 = t112 - t111;
    let t114 = f[5] * t69;
    let t116 = fma(0.2820948, t114, t96);
    let t118 = fma(0.090111874, t114, -t98);
    let t120 = fma((-0.15607835), t114, t100);
    let t121 = t69 * t109;
    let t123 = fma(f[5], t113, t121);
    let t124 = t107 + t108;
    let t125 = t111 + t112;
    let t126 = f[7] * t71;
    let t128 = fma(0.2820948, t126, t116);
    let t130 = fma(0.090111874, t126, t118);
    let t132 = fma(0.15607835, t126, t120);
    let t133 = t71 * t124;
    let t135 = fma(f[7], t125, t133);
    let t140 = t72 * 0.14567313;
    let t141 = 0.07957747 + t81;
    let t142 = t141 - t140;
    let t145 = t140 + t141;
    let t146 = f[13] * t145;
    let t149 = fma(f[6], 0.25231326, t73);
    let t151 = fma(t70, 0.25231326, 0.07957747);
    let t152 = f[2] * t66;
    let t154 = fma(0.2820948, t152, t128);
    let t156 = fma(0.25231326, t152, t130);
    let t157 = t66 * t149;
    let t159 = fma(f[2], t151, t157);
    let t162 = fma(-f[6], 0.18022375, t73);
    let t164 = fma(-t70, 0.18022375, 0.07957747);
    let t165 = f[4] * t68;
    let t167 = fma(0.2820948, t165, t154);
    let t169 = fma((-0.18022375), t165, t156);
    let t170 = t68 * t162;
    let t172 = fma(f[4], t164, t170);
    let t173 = f[6] * t70;
    let t175 = fma(0.2820948, t173, t167);
    let t177 = fma(0.18022375, t173, t169);
    let t178 = t70 * t73;
    let t180 = fma(f[6], 0.07957747, t178);
    let t181 = t177 + t180;
    let t182 = f[8] * t72;
    let t184 = fma(0.2820948, t182, t175);
    let t186 = fma((-0.18022375), t182, t181);
    let t187 = t72 * t162;
    let t189 = fma(f[8], t164, t187);
    let t190 = t132 + t189;
    let t195 = fma(-t70, 0.21026105, 0.07957747);
    let t196 = f[9] * t195;
    let t201 = fma(t70, 0.16820884, 0.07957747);
    let t202 = f[12] * t201;
    let t203 = f[15] * t195;
    let t205 = fma(0.2820948, t73, t184);
    let t207 = f[14] * 0.07957747;
    let t210 = f[13] * 0.05839917;
    let t212 = f[15] * 0.22617902;
    let t213 = fma(f[3], 0.21850969, -t210);
    let t214 = t213 - t212;
    let t215 = t67 * 0.21850969;
    let t216 = f[1] * t68;
    let t218 = fma(f[4], t65, t216);
    let t220 = fma(0.21850969, t218, t103);
    let t222 = fma((-0.05839917), t218, t146);
    let t224 = fma((-0.22617902), t218, t203);
    let t225 = t68 * t214;
    let t227 = fma(f[4], t215, t225);
    let t228 = t91 + t227;
    let t229 = t65 * t214;
    let t231 = fma(f[1], t215, t229);
    let t232 = t172 + t231;
    let t233 = f[2] * 0.21850969;
    let t237 = f[14] * 0.1846744;
    let t238 = fma(-f[12], 0.14304817, t233);
    let t239 = t238 - t237;
    let t240 = t66 * 0.21850969;
    let t241 = f[1] * t69;
    let t243 = fma(f[5], t65, t241);
    let t245 = fma(0.21850969, t243, t159);
    let t247 = fma((-0.14304817), t243, t202);
    let t249 = fma((-0.1846744), t243, t207);
    let t250 = t69 * t239;
    let t252 = fma(f[5], t240, t250);
    let t253 = t228 + t252;
    let t254 = t65 * t239;
    let t256 = fma(f[1], t240, t254);
    let t257 = t123 + t256;
    let t258 = t237 + t238;
    let t259 = f[3] * t71;
    let t261 = fma(f[7], t67, t259);
    let t263 = fma(0.21850969, t261, t245);
    let t265 = fma((-0.14304817), t261, t247);
    let t267 = fma(0.1846744, t261, t249);
    let t268 = t71 * t258;
    let t270 = fma(f[7], t240, t268);
    let t271 = t220 + t270;
    let t272 = t67 * t258;
    let t274 = fma(f[3], t240, t272);
    let t275 = t135 + t274;
    let t277 = f[13] * 0.14567313;
    let t279 = f[15] * 0.094031595;
    let t280 = fma(-f[3], 0.05839917, t277);
    let t281 = t279 + t280;
    let t282 = t67 * 0.05839917;
    let t283 = f[11] * t68;
    let t285 = fma((-0.05839917), t283, t271);
    let t287 = fma(0.14567313, t283, t222);
    let t289 = fma(0.094031595, t283, t224);
    let t291 = fma(-f[11], t282, t232);
    let t292 = t68 * t281;
    let t294 = fma(-f[4], t282, t292);
    let t295 = fma(f[11], t142, t294);
    let t296 = f[3] * 0.1846744;
    let t300 = f[15] * 0.148677;
    let t301 = fma(f[13], 0.11516472, t296);
    let t302 = t301 - t300;
    let t303 = t67 * 0.1846744;
    let t304 = f[10] * t69;
    let t306 = fma(0.1846744, t304, t285);
    let t308 = fma(0.11516472, t304, t287);
    let t310 = fma((-0.148677), t304, t289);
    let t312 = fma(f[10], t303, t257);
    let t313 = t69 * t302;
    let t315 = fma(f[5], t303, t313);
    let t316 = fma(f[10], 0.07957747, t315);
    let t318 = f[2] * 0.23359668;
    let t321 = f[14] * 0.11516472;
    let t322 = fma(f[12], 0.059470803, t318);
    let t323 = t322 - t321;
    let t324 = t66 * 0.23359668;
    let t325 = f[11] * t69;
    let t327 = fma(0.23359668, t325, t263);
    let t329 = fma(0.059470803, t325, t265);
    let t331 = fma((-0.11516472), t325, t267);
    let t333 = fma(f[11], t324, t312);
    let t334 = t69 * t323;
    let t336 = fma(f[5], t324, t334);
    let t337 = t295 + t336;
    let t338 = f[1] * 0.1846744;
    let t341 = fma(f[9], 0.148677, t338);
    let t342 = fma(f[11], 0.11516472, t341);
    let t343 = t65 * 0.1846744;
    let t344 = f[10] * t71;
    let t346 = fma(0.1846744, t344, t253);
    let t348 = fma(0.148677, t344, t196);
    let t350 = fma(0.11516472, t344, t337);
    let t352 = fma(f[10], t343, t275);
    let t353 = t71 * t342;
    let t355 = fma(f[7], t343, t353);
    let t356 = t316 + t355;
    let t357 = t321 + t322;
    let t358 = f[13] * t71;
    let t360 = fma(0.23359668, t358, t327);
    let t362 = fma(0.059470803, t358, t329);
    let t364 = fma(0.11516472, t358, t331);
    let t366 = fma(f[13], t324, t352);
    let t367 = t71 * t357;
    let t369 = fma(f[7], t324, t367);
    let t370 = t308 + t369;
    let t371 = f[9] * 0.22617902;
    let t373 = fma(f[11], 0.05839917, t371);
    let t374 = f[1] * t72;
    let t376 = fma(f[8], t65, t374);
    let t378 = fma(0.22617902, t376, t348);
    let t380 = fma(0.05839917, t376, t350);
    let t382 = fma(t72, t373, t346);
    let t384 = fma(t65, t373, t190);
    let t385 = t212 - t210;
    let t386 = f[3] * t72;
    let t388 = fma(f[8], t67, t386);
    let t390 = fma((-0.05839917), t388, t370);
    let t392 = fma(0.22617902, t388, t310);
    let t394 = fma(t72, t385, t306);
    let t396 = fma(t67, t385, t384);
    let t397 = f[3] * 0.22617902;
    let t399 = fma(-f[13], 0.094031595, t397);
    let t400 = t67 * 0.22617902;
    let t401 = f[9] * t68;
    let t403 = fma(0.22617902, t401, t394);
    let t405 = fma((-0.094031595), t401, t390);
    let t407 = fma(f[9], t400, t291);
    let t408 = t68 * t399;
    let t410 = fma(f[4], t400, t408);
    let t411 = t378 + t410;
    let t412 = f[2] * 0.1846744;
    let t415 = fma(-f[12], 0.18806319, t412);
    let t416 = t66 * 0.1846744;
    let t417 = f[10] * t68;
    let t419 = fma(0.1846744, t417, t360);
    let t421 = fma((-0.18806319), t417, t362);
    let t423 = fma(f[10], t416, t407);
    let t424 = t68 * t415;
    let t426 = fma(f[4], t416, t424);
    let t427 = t356 + t426;
    let t428 = f[14] * t72;
    let t430 = fma(0.1846744, t428, t419);
    let t432 = fma((-0.18806319), t428, t421);
    let t434 = fma(f[14], t416, t396);
    let t435 = t72 * t415;
    let t437 = fma(f[8], t416, t435);
    let t438 = t364 + t437;
    let t440 = f[11] * 0.20230065;
    let t441 = f[1] * t70;
    let t443 = fma(f[6], t65, t441);
    let t445 = fma(0.20230065, t443, t380);
    let t447 = fma(t70, t440, t382);
    let t449 = fma(t65, t440, t186);
    let t451 = f[12] * 0.24776669;
    let t452 = f[2] * t70;
    let t454 = fma(f[6], t66, t452);
    let t456 = fma(0.24776669, t454, t432);
    let t458 = fma(t70, t451, t430);
    let t460 = fma(t66, t451, t449);
    let t461 = f[13] * 0.20230065;
    let t462 = f[3] * t70;
    let t464 = fma(f[6], t67, t462);
    let t466 = fma(0.20230065, t464, t405);
    let t468 = fma(t70, t461, t403);
    let t470 = fma(t67, t461, t460);
    let t471 = f[7] * 0.15607835;
    let t472 = t71 * 0.15607835;
    let t473 = f[4] * t69;
    let t475 = fma(f[5], t68, t473);
    let t477 = fma(0.15607835, t475, t366);
    let t478 = t69 * t471;
    let t480 = fma(f[5], t472, t478);
    let t481 = t423 + t480;
    let t482 = t68 * t471;
    let t484 = fma(f[4], t472, t482);
    let t485 = t333 + t484;
    let t486 = f[14] * 0.148677;
    let t487 = f[9] * t69;
    let t489 = fma(0.148677, t487, t438);
    let t491 = fma(t69, t486, t411);
    let t492 = f[14] * t71;
    let t494 = fma(0.148677, t492, t392);
    let t496 = fma(t71, t300, t489);
    let t497 = f[11] * 0.094031595;
    let t498 = f[9] * t72;
    let t500 = fma((-0.094031595), t498, t445);
    let t502 = fma(-t72, t497, t491);
    let t503 = f[13] * t72;
    let t505 = fma((-0.094031595), t503, t494);
    let t507 = fma(-t72, t279, t466);
    return array<f32, 16>(
        t205, t447, t458, t468, t481, t485, t470, t477, t434, t502, t427, t500, t456, t507, t496,
        t505,
    );
}

// The integral of the product of three functions over the sphere.
// Source: Ren et al. 2006, section 3: (a, b, c) = (a * b) * c.
// 345 multiplications, 273 additions.
fn sh4_triple(f: array<f32, 16>, g: array<f32, 16>, h: array<f32, 16>) -> f32 {
    let t49 = f[0] * 0.2820948;
    let t51 = f[6] * 0.12615663;
    let t53 = f[8] * 0.21850969;
    let t55 = t49 - t51;
    let t56 = t55 - t53;
    let t57 = g[0] * 0.2820948;
    let t58 = g[6] * 0.12615663;
    let t59 = g[8] * 0.21850969;
    let t60 = t57 - t58;
    let t61 = t60 - t59;
    let t62 = f[1] * g[1];
    let t63 = 0.2820948 * t62;
    let t64 = 0.12615663 * t62;
    let t66 = g[1] * t56;
    let t68 = fma(f[1], t61, t66);
    let t69 = t53 + t55;
    let t70 = t59 + t60;
    let t71 = f[3] * g[3];
    let t73 = fma(0.2820948, t71, t63);
    let t75 = fma(0.12615663, t71, t64);
    let t76 = 0.21850969 * t71;
    let t77 = fma((-0.21850969), t62, t76);
    let t78 = g[3] * t69;
    let t80 = fma(f[3], t70, t78);
    let t84 = f[8] * 0.15607835;
    let t85 = fma(f[6], 0.090111874, t49);
    let t86 = t85 - t84;
    let t88 = g[8] * 0.15607835;
    let t89 = fma(g[6], 0.090111874, t57);
    let t90 = t89 - t88;
    let t91 = f[5] * g[5];
    let t93 = fma(0.2820948, t91, t73);
    let t95 = fma(0.090111874, t91, -t75);
    let t97 = fma((-0.15607835), t91, t77);
    let t98 = g[5] * t86;
    let t100 = fma(f[5], t90, t98);
    let t101 = t84 + t85;
    let t102 = t88 + t89;
    let t103 = f[7] * g[7];
    let t105 = fma(0.2820948, t103, t93);
    let t107 = fma(0.090111874, t103, t95);
    let t109 = fma(0.15607835, t103, t97);
    let t110 = g[7] * t101;
    let t112 = fma(f[7], t102, t110);
    let t114 = f[8] * 0.14567313;
    let t115 = t49 + t51;
    let t116 = t115 - t114;
    let t117 = g[8] * 0.14567313;
    let t118 = t57 + t58;
    let t119 = t118 - t117;
    let t120 = f[11] * g[11];
    let t122 = fma(0.2820948, t120, t105);
    let t124 = fma(0.12615663, t120, t107);
    let t126 = fma((-0.14567313), t120, t109);
    let t127 = g[11] * t116;
    let t129 = fma(f[11], t119, t127);
    let t130 = t114 + t115;
    let t131 = t117 + t118;
    let t132 = f[13] * g[13];
    let t134 = fma(0.2820948, t132, t122);
    let t136 = fma(0.12615663, t132, t124);
    let t138 = fma(0.14567313, t132, t126);
    let t139 = g[13] * t130;
    let t141 = fma(f[13], t131, t139);
    let t144 = fma(f[6], 0.25231326, t49);
    let t146 = fma(g[6], 0.25231326, t57);
    let t147 = f[2] * g[2];
    let t149 = fma(0.2820948, t147, t134);
    let t151 = fma(0.25231326, t147, t136);
    let t152 = g[2] * t144;
    let t154 = fma(f[2], t146, t152);
    let t157 = fma(-f[6], 0.18022375, t49);
    let t159 = fma(-g[6], 0.18022375, t57);
    let t160 = f[4] * g[4];
    let t162 = fma(0.2820948, t160, t149);
    let t164 = fma((-0.18022375), t160, t151);
    let t165 = g[4] * t157;
    let t167 = fma(f[4], t159, t165);
    let t168 = f[6] * g[6];
    let t170 = fma(0.2820948, t168, t162);
    let t172 = fma(0.18022375, t168, t164);
    let t173 = g[6] * t49;
    let t175 = fma(f[6], t57, t173);
    let t176 = t172 + t175;
    let t177 = f[8] * g[8];
    let t179 = fma(0.2820948, t177, t170);
    let t181 = fma((-0.18022375), t177, t176);
    let t182 = g[8] * t157;
    let t184 = fma(f[8], t159, t182);
    let t185 = t138 + t184;
    let t188 = fma(-f[6], 0.21026105, t49);
    let t190 = fma(-g[6], 0.21026105, t57);
    let t191 = f[9] * g[9];
    let t193 = fma(0.2820948, t191, t179);
    let t195 = fma((-0.21026105), t191, t181);
    let t196 = g[9] * t188;
    let t198 = fma(f[9], t190, t196);
    let t201 = fma(f[6], 0.16820884, t49);
    let t203 = fma(g[6], 0.16820884, t57);
    let t204 = f[12] * g[12];
    let t206 = fma(0.2820948, t204, t193);
    let t208 = fma(0.16820884, t204, t195);
    let t209 = g[12] * t201;
    let t211 = fma(f[12], t203, t209);
    let t212 = f[15] * g[15];
    let t214 = fma(0.2820948, t212, t206);
    let t216 = fma((-0.21026105), t212, t208);
    let t217 = g[15] * t188;
    let t219 = fma(f[15], t190, t217);
    let t220 = f[0] * g[0];
    let t222 = fma(0.2820948, t220, t214);
    let t223 = f[10] * g[10];
    let t225 = fma(0.2820948, t223, t222);
    let t226 = g[10] * t49;
    let t228 = fma(f[10], t57, t226);
    let t229 = f[14] * g[14];
    let t231 = fma(0.2820948, t229, t225);
    let t232 = g[14] * t49;
    let t234 = fma(f[14], t57, t232);
    let t237 = f[13] * 0.05839917;
    let t239 = f[15] * 0.22617902;
    let t240 = fma(f[3], 0.21850969, -t237);
    let t241 = t240 - t239;
    let t243 = g[13] * 0.05839917;
    let t244 = g[15] * 0.22617902;
    let t245 = fma(g[3], 0.21850969, -t243);
    let t246 = t245 - t244;
    let t247 = f[1] * g[4];
    let t249 = fma(f[4], g[1], t247);
    let t251 = fma(0.21850969, t249, t80);
    let t253 = fma((-0.05839917), t249, t141);
    let t255 = fma((-0.22617902), t249, t219);
    let t256 = g[4] * t241;
    let t258 = fma(f[4], t246, t256);
    let t259 = t68 + t258;
    let t260 = g[1] * t241;
    let t262 = fma(f[1], t246, t260);
    let t263 = t167 + t262;
    let t264 = f[2] * 0.21850969;
    let t268 = f[14] * 0.1846744;
    let t269 = fma(-f[12], 0.14304817, t264);
    let t270 = t269 - t268;
    let t271 = g[2] * 0.21850969;
    let t273 = g[14] * 0.1846744;
    let t274 = fma(-g[12], 0.14304817, t271);
    let t275 = t274 - t273;
    let t276 = f[1] * g[5];
    let t278 = fma(f[5], g[1], t276);
    let t280 = fma(0.21850969, t278, t154);
    let t282 = fma((-0.14304817), t278, t211);
    let t284 = fma((-0.1846744), t278, t234);
    let t285 = g[5] * t270;
    let t287 = fma(f[5], t275, t285);
    let t288 = t259 + t287;
    let t289 = g[1] * t270;
    let t291 = fma(f[1], t275, t289);
    let t292 = t100 + t291;
    let t293 = t268 + t269;
    let t294 = t273 + t274;
    let t295 = f[3] * g[7];
    let t297 = fma(f[7], g[3], t295);
    let t299 = fma(0.21850969, t297, t280);
    let t301 = fma((-0.14304817), t297, t282);
    let t303 = fma(0.1846744, t297, t284);
    let t304 = g[7] * t293;
    let t306 = fma(f[7], t294, t304);
    let t307 = t251 + t306;
    let t308 = g[3] * t293;
    let t310 = fma(f[3], t294, t308);
    let t311 = t112 + t310;
    let t313 = f[13] * 0.14567313;
    let t315 = f[15] * 0.094031595;
    let t316 = fma(-f[3], 0.05839917, t313);
    let t317 = t315 + t316;
    let t319 = g[13] * 0.14567313;
    let t320 = g[15] * 0.094031595;
    let t321 = fma(-g[3], 0.05839917, t319);
    let t322 = t320 + t321;
    let t323 = f[4] * g[11];
    let t325 = fma(f[11], g[4], t323);
    let t327 = fma((-0.05839917), t325, t307);
    let t329 = fma(0.14567313, t325, t253);
    let t331 = fma(0.094031595, t325, t255);
    let t332 = g[11] * t317;
    let t334 = fma(f[11], t322, t332);
    let t335 = t263 + t334;
    let t336 = g[4] * t317;
    let t338 = fma(f[4], t322, t336);
    let t339 = t129 + t338;
    let t340 = f[3] * 0.1846744;
    let t344 = f[15] * 0.148677;
    let t345 = fma(f[13], 0.11516472, t340);
    let t346 = t345 - t344;
    let t347 = g[3] * 0.1846744;
    let t349 = g[15] * 0.148677;
    let t350 = fma(g[13], 0.11516472, t347);
    let t351 = t350 - t349;
    let t352 = f[5] * g[10];
    let t354 = fma(f[10], g[5], t352);
    let t356 = fma(0.1846744, t354, t327);
    let t358 = fma(0.11516472, t354, t329);
    let t360 = fma((-0.148677), t354, t331);
    let t361 = g[10] * t346;
    let t363 = fma(f[10], t351, t361);
    let t364 = t292 + t363;
    let t365 = g[5] * t346;
    let t367 = fma(f[5], t351, t365);
    let t368 = t228 + t367;
    let t370 = f[2] * 0.23359668;
    let t373 = f[14] * 0.11516472;
    let t374 = fma(f[12], 0.059470803, t370);
    let t375 = t374 - t373;
    let t376 = g[2] * 0.23359668;
    let t378 = g[14] * 0.11516472;
    let t379 = fma(g[12], 0.059470803, t376);
    let t380 = t379 - t378;
    let t381 = f[5] * g[11];
    let t383 = fma(f[11], g[5], t381);
    let t385 = fma(0.23359668, t383, t299);
    let t387 = fma(0.059470803, t383, t301);
    let t389 = fma((-0.11516472), t383, t303);
    let t390 = g[11] * t375;
    let t392 = fma(f[11], t380, t390);
    let t393 = t364 + t392;
    let t394 = g[5] * t375;
    let t396 = fma(f[5], t380, t394);
    let t397 = t339 + t396;
    let t398 = f[1] * 0.1846744;
    let t401 = fma(f[9], 0.148677, t398);
    let t402 = fma(f[11], 0.11516472, t401);
    let t403 = g[1] * 0.1846744;
    let t406 = fma(g[9], 0.148677, t403);
    let t407 = fma(g[11], 0.11516472, t406);
    let t408 = f[7] * g[10];
    let t410 = fma(f[10], g[7], t408);
    let t412 = fma(0.1846744, t410, t288);
    let t414 = fma(0.148677, t410, t198);
    let t416 = fma(0.11516472, t410, t397);
    let t417 = g[10] * t402;
    let t419 = fma(f[10], t407, t417);
    let t420 = t311 + t419;
    let t421 = g[7] * t402;
    let t423 = fma(f[7], t407, t421);
    let t424 = t368 + t423;
    let t425 = t373 + t374;
    let t426 = t378 + t379;
    let t427 = f[7] * g[13];
    let t429 = fma(f[13], g[7], t427);
    let t431 = fma(0.23359668, t429, t385);
    let t433 = fma(0.059470803, t429, t387);
    let t435 = fma(0.11516472, t429, t389);
    let t436 = g[13] * t425;
    let t438 = fma(f[13], t426, t436);
    let t439 = t420 + t438;
    let t440 = g[7] * t425;
    let t442 = fma(f[7], t426, t440);
    let t443 = t358 + t442;
    let t444 = f[9] * 0.22617902;
    let t446 = fma(f[11], 0.05839917, t444);
    let t447 = g[9] * 0.22617902;
    let t449 = fma(g[11], 0.05839917, t447);
    let t450 = f[1] * g[8];
    let t452 = fma(f[8], g[1], t450);
    let t454 = fma(0.22617902, t452, t414);
    let t456 = fma(0.05839917, t452, t416);
    let t457 = g[8] * t446;
    let t459 = fma(f[8], t449, t457);
    let t460 = t412 + t459;
    let t461 = g[1] * t446;
    let t463 = fma(f[1], t449, t461);
    let t464 = t185 + t463;
    let t465 = t239 - t237;
    let t466 = t244 - t243;
    let t467 = f[3] * g[8];
    let t469 = fma(f[8], g[3], t467);
    let t471 = fma((-0.05839917), t469, t443);
    let t473 = fma(0.22617902, t469, t360);
    let t474 = g[8] * t465;
    let t476 = fma(f[8], t466, t474);
    let t477 = t356 + t476;
    let t478 = g[3] * t465;
    let t480 = fma(f[3], t466, t478);
    let t481 = t464 + t480;
    let t482 = f[3] * 0.22617902;
    let t484 = fma(-f[13], 0.094031595, t482);
    let t485 = g[3] * 0.22617902;
    let t487 = fma(-g[13], 0.094031595, t485);
    let t488 = f[4] * g[9];
    let t490 = fma(f[9], g[4], t488);
    let t492 = fma(0.22617902, t490, t477);
    let t494 = fma((-0.094031595), t490, t471);
    let t495 = g[9] * t484;
    let t497 = fma(f[9], t487, t495);
    let t498 = t335 + t497;
    let t499 = g[4] * t484;
    let t501 = fma(f[4], t487, t499);
    let t502 = t454 + t501;
    let t503 = f[2] * 0.1846744;
    let t506 = fma(-f[12], 0.18806319, t503);
    let t507 = g[2] * 0.1846744;
    let t509 = fma(-g[12], 0.18806319, t507);
    let t510 = f[4] * g[10];
    let t512 = fma(f[10], g[4], t510);
    let t514 = fma(0.1846744, t512, t431);
    let t516 = fma((-0.18806319), t512, t433);
    let t517 = g[10] * t506;
    let t519 = fma(f[10], t509, t517);
    let t520 = t498 + t519;
    let t521 = g[4] * t506;
    let t523 = fma(f[4], t509, t521);
    let t524 = t424 + t523;
    let t525 = f[8] * g[14];
    let t527 = fma(f[14], g[8], t525);
    let t529 = fma(0.1846744, t527, t514);
    let t531 = fma((-0.18806319), t527, t516);
    let t532 = g[14] * t506;
    let t534 = fma(f[14], t509, t532);
    let t535 = t481 + t534;
    let t536 = g[8] * t506;
    let t538 = fma(f[8], t509, t536);
    let t539 = t435 + t538;
    let t541 = f[11] * 0.20230065;
    let t542 = g[11] * 0.20230065;
    let t543 = f[1] * g[6];
    let t545 = fma(f[6], g[1], t543);
    let t547 = fma(0.20230065, t545, t456);
    let t548 = g[6] * t541;
    let t550 = fma(f[6], t542, t548);
    let t551 = t460 + t550;
    let t552 = g[1] * t541;
    let t554 = fma(f[1], t542, t552);
    let t555 = t216 + t554;
    let t557 = f[12] * 0.24776669;
    let t558 = g[12] * 0.24776669;
    let t559 = f[2] * g[6];
    let t561 = fma(f[6], g[2], t559);
    let t563 = fma(0.24776669, t561, t531);
    let t564 = g[6] * t557;
    let t566 = fma(f[6], t558, t564);
    let t567 = t529 + t566;
    let t568 = g[2] * t557;
    let t570 = fma(f[2], t558, t568);
    let t571 = t555 + t570;
    let t572 = f[13] * 0.20230065;
    let t573 = g[13] * 0.20230065;
    let t574 = f[3] * g[6];
    let t576 = fma(f[6], g[3], t574);
    let t578 = fma(0.20230065, t576, t494);
    let t579 = g[6] * t572;
    let t581 = fma(f[6], t573, t579);
    let t582 = t492 + t581;
    let t583 = g[3] * t572;
    let t585 = fma(f[3], t573, t583);
    let t586 = t571 + t585;
    let t587 = f[7] * 0.15607835;
    let t588 = g[7] * 0.15607835;
    let t589 = f[4] * g[5];
    let t591 = fma(f[5], g[4], t589);
    let t593 = fma(0.15607835, t591, t439);
    let t594 = g[5] * t587;
    let t596 = fma(f[5], t588, t594);
    let t597 = t520 + t596;
    let t598 = g[4] * t587;
    let t600 = fma(f[4], t588, t598);
    let t601 = t393 + t600;
    let t602 = f[14] * 0.148677;
    let t603 = g[14] * 0.148677;
    let t604 = f[5] * g[9];
    let t606 = fma(f[9], g[5], t604);
    let t608 = fma(0.148677, t606, t539);
    let t609 = g[9] * t602;
    let t611 = fma(f[9], t603, t609);
    let t612 = t601 + t611;
    let t613 = g[5] * t602;
    let t615 = fma(f[5], t603, t613);
    let t616 = t502 + t615;
    let t617 = f[7] * g[14];
    let t619 = fma(f[14], g[7], t617);
    let t621 = fma(0.148677, t619, t473);
    let t622 = g[14] * t344;
    let t624 = fma(f[14], t349, t622);
    let t625 = t593 + t624;
    let t626 = g[7] * t344;
    let t628 = fma(f[7], t349, t626);
    let t629 = t608 + t628;
    let t630 = f[11] * 0.094031595;
    let t631 = g[11] * 0.094031595;
    let t632 = f[8] * g[9];
    let t634 = fma(f[9], g[8], t632);
    let t636 = fma((-0.094031595), t634, t547);
    let t637 = g[9] * t630;
    let t639 = fma(f[9], t631, t637);
    let t640 = t535 - t639;
    let t641 = g[8] * t630;
    let t643 = fma(f[8], t631, t641);
    let t644 = t616 - t643;
    let t645 = f[8] * g[13];
    let t647 = fma(f[13], g[8], t645);
    let t649 = fma((-0.094031595), t647, t621);
    let t650 = g[13] * t315;
    let t652 = fma(f[13], t320, t650);
    let t653 = t640 - t652;
    let t654 = g[8] * t315;
    let t656 = fma(f[8], t320, t654);
    let t657 = t578 - t656;
    let t658 = h[0] * t231;
    let t659 = fma(h[1], t551, t658);
    let t660 = fma(h[2], t567, t659);
    let t661 = fma(h[3], t582, t660);
    let t662 = fma(h[4], t597, t661);
    let t663 = fma(h[5], t612, t662);
    let t664 = fma(h[6], t586, t663);
    let t665 = fma(h[7], t625, t664);
    let t666 = fma(h[8], t653, t665);
    let t667 = fma(h[9], t644, t666);
    let t668 = fma(h[10], t524, t667);
    let t669 = fma(h[11], t636, t668);
    let t670 = fma(h[12], t563, t669);
    let t671 = fma(h[13], t657, t670);
    let t672 = fma(h[14], t629, t671);
    let t673 = fma(h[15], t649, t672);
    return t673;
}

// The integral of the product of two functions over the sphere.
// Source: Orthonormality: integral of f g = sum of f_i g_i.
// 16 multiplications, 15 additions.
fn sh4_dot(f: array<f32, 16>, g: array<f32, 16>) -> f32 {
    let t33 = f[0] * g[0];
    let t34 = fma(f[1], g[1], t33);
    let t35 = fma(f[2], g[2], t34);
    let t36 = fma(f[3], g[3], t35);
    let t37 = fma(f[4], g[4], t36);
    let t38 = fma(f[5], g[5], t37);
    let t39 = fma(f[6], g[6], t38);
    let t40 = fma(f[7], g[7], t39);
    let t41 = fma(f[8], g[8], t40);
    let t42 = fma(f[9], g[9], t41);
    let t43 = fma(f[10], g[10], t42);
    let t44 = fma(f[11], g[11], t43);
    let t45 = fma(f[12], g[12], t44);
    let t46 = fma(f[13], g[13], t45);
    let t47 = fma(f[14], g[14], t46);
    let t48 = fma(f[15], g[15], t47);
    return t48;
}

// The symmetric matrix of multiplication by `f`: its lower triangle, row by row.
// Source: Ren et al. 2006, eq. 5.
// 116 multiplications, 56 additions.
fn sh4_product_matrix(f: array<f32, 16>) -> array<f32, 136> {
    let t17 = f[0] * 0.2820948;
    let t18 = f[1] * 0.2820948;
    let t19 = f[2] * 0.2820948;
    let t20 = f[3] * 0.2820948;
    let t21 = f[4] * 0.2820948;
    let t22 = f[5] * 0.2820948;
    let t23 = f[6] * 0.2820948;
    let t24 = f[7] * 0.2820948;
    let t25 = f[8] * 0.2820948;
    let t26 = f[9] * 0.2820948;
    let t27 = f[10] * 0.2820948;
    let t28 = f[11] * 0.2820948;
    let t29 = f[12] * 0.2820948;
    let t30 = f[13] * 0.2820948;
    let t31 = f[14] * 0.2820948;
    let t32 = f[15] * 0.2820948;
    let t34 = f[6] * 0.12615663;
    let t35 = t17 - t34;
    let t38 = f[8] * 0.21850969;
    let t39 = t35 - t38;
    let t40 = f[1] * 0.21850969;
    let t41 = f[5] * 0.21850969;
    let t42 = f[2] * 0.21850969;
    let t43 = f[4] * 0.21850969;
    let t44 = f[3] * 0.21850969;
    let t47 = fma(-f[13], 0.05839917, t44);
    let t48 = f[4] * 0.05839917;
    let t49 = f[1] * 0.05839917;
    let t51 = f[15] * 0.22617902;
    let t52 = t47 - t51;
    let t53 = f[4] * 0.22617902;
    let t57 = fma(-f[12], 0.14304817, t42);
    let t58 = f[5] * 0.14304817;
    let t61 = f[14] * 0.1846744;
    let t62 = t57 - t61;
    let t63 = f[5] * 0.1846744;
    let t64 = f[1] * 0.1846744;
    let t66 = f[11] * 0.20230065;
    let t67 = fma(-f[1], 0.12615663, t66);
    let t68 = f[6] * 0.20230065;
    let t69 = f[1] * 0.20230065;
    let t70 = f[10] * 0.1846744;
    let t71 = f[7] * 0.1846744;
    let t72 = f[9] * 0.22617902;
    let t73 = t72 - t40;
    let t74 = f[8] * 0.22617902;
    let t75 = f[11] * 0.05839917;
    let t76 = t73 + t75;
    let t77 = f[8] * 0.05839917;
    let t78 = t68 + t77;
    let t81 = fma(f[6], 0.25231326, t17);
    let t82 = f[2] * 0.25231326;
    let t83 = f[7] * 0.21850969;
    let t84 = f[4] * 0.1846744;
    let t85 = f[2] * 0.1846744;
    let t88 = fma(f[11], 0.23359668, t40);
    let t89 = f[5] * 0.23359668;
    let t90 = f[2] * 0.23359668;
    let t93 = fma(f[12], 0.24776669, t82);
    let t94 = f[6] * 0.24776669;
    let t95 = f[2] * 0.24776669;
    let t97 = fma(f[13], 0.23359668, t44);
    let t98 = f[7] * 0.23359668;
    let t99 = f[8] * 0.1846744;
    let t101 = t35 + t38;
    let t102 = t40 + t72;
    let t103 = f[3] * 0.22617902;
    let t104 = t102 - t75;
    let t106 = f[3] * 0.1846744;
    let t107 = f[13] * 0.20230065;
    let t108 = fma(-f[3], 0.12615663, t107);
    let t109 = f[3] * 0.20230065;
    let t110 = f[7] * 0.14304817;
    let t112 = t57 + t61;
    let t113 = t68 - t77;
    let t114 = t47 + t51;
    let t116 = f[6] * 0.18022375;
    let t117 = t17 - t116;
    let t118 = f[4] * 0.18022375;
    let t120 = f[7] * 0.15607835;
    let t121 = f[5] * 0.15607835;
    let t122 = f[4] * 0.15607835;
    let t125 = fma(-f[13], 0.094031595, t103);
    let t126 = f[9] * 0.094031595;
    let t127 = t49 + t126;
    let t128 = f[4] * 0.094031595;
    let t131 = fma(-f[12], 0.18806319, t85);
    let t132 = f[10] * 0.18806319;
    let t133 = f[4] * 0.18806319;
    let t135 = f[13] * 0.14567313;
    let t136 = fma(-f[3], 0.05839917, t135);
    let t137 = f[11] * 0.14567313;
    let t138 = t137 - t127;
    let t139 = f[4] * 0.14567313;
    let t140 = f[15] * 0.094031595;
    let t141 = t136 + t140;
    let t142 = f[11] * 0.094031595;
    let t143 = fma(-f[1], 0.22617902, t142);
    let t146 = fma(f[6], 0.090111874, t17);
    let t147 = f[5] * 0.090111874;
    let t148 = f[8] * 0.15607835;
    let t149 = t146 - t148;
    let t151 = f[14] * 0.148677;
    let t152 = f[9] * 0.148677;
    let t153 = t152 - t64;
    let t154 = f[5] * 0.148677;
    let t157 = fma(f[13], 0.11516472, t106);
    let t158 = f[10] * 0.11516472;
    let t159 = f[5] * 0.11516472;
    let t160 = f[15] * 0.148677;
    let t161 = t157 - t160;
    let t162 = f[10] * 0.148677;
    let t165 = fma(f[12], 0.059470803, t90);
    let t166 = f[11] * 0.059470803;
    let t167 = fma(-f[1], 0.14304817, t166);
    let t168 = f[5] * 0.059470803;
    let t169 = f[14] * 0.11516472;
    let t170 = t165 - t169;
    let t171 = f[11] * 0.11516472;
    let t172 = t153 - t171;
    let t173 = t17 + t116;
    let t174 = f[7] * 0.090111874;
    let t175 = f[8] * 0.18022375;
    let t177 = f[9] * 0.21026105;
    let t179 = fma(-f[6], 0.21026105, t17);
    let t181 = fma(f[11], 0.12615663, t69);
    let t182 = t17 + t34;
    let t185 = fma(f[12], 0.16820884, t95);
    let t187 = fma(f[6], 0.16820884, t17);
    let t189 = fma(f[13], 0.12615663, t109);
    let t190 = f[15] * 0.21026105;
    let t191 = t146 + t148;
    let t192 = t64 + t152;
    let t193 = f[7] * 0.148677;
    let t194 = t171 + t192;
    let t195 = f[7] * 0.11516472;
    let t196 = f[13] * 0.059470803;
    let t197 = fma(-f[3], 0.14304817, t196);
    let t198 = f[7] * 0.059470803;
    let t199 = t165 + t169;
    let t200 = t157 + t160;
    let t201 = t49 - t126;
    let t202 = f[8] * 0.094031595;
    let t203 = t201 - t137;
    let t204 = f[8] * 0.14567313;
    let t205 = t182 - t204;
    let t206 = f[14] * 0.18806319;
    let t207 = f[8] * 0.18806319;
    let t208 = t182 + t204;
    let t209 = t136 - t140;
    return array<f32, 136>(
        t17, t18, t39, t19, t41, t81, t20, t43, t83, t101, t21, t52, t70, t104, t117, t22, t62,
        t88, t70, t120, t149, t23, t67, t93, t108, -t118, t147, t173, t24, t70, t97, t112, t121,
        t122, t174, t191, t25, t76, t61, t114, 0.0, -t121, -t175, t120, t117, t26, t74, 0.0, t53,
        t125, t151, -t177, t162, -t143, t179, t27, t71, t84, t63, t131, t161, 0.0, t194, 0.0, t193,
        t17, t28, t78, t89, -t48, t141, t170, t181, t158, t203, -t202, t195, t205, t29, -t58, t94,
        -t110, -t132, t167, t185, t197, -t206, 0.0, -t133, t168, t187, t30, -t48, t98, t113, t138,
        t158, t189, t199, t209, -t128, t159, t139, t198, t208, t31, -t63, t99, t71, 0.0, t172, 0.0,
        t200, t131, t154, 0.0, -t159, -t207, t195, t17, t32, -t53, 0.0, t74, t143, -t162, -t190,
        t151, t125, 0.0, -t154, t128, 0.0, -t202, t193, t179,
    );
}

// A symmetric matrix, given by its lower triangle, times a vector.
// Source: With the product matrix of f: M_f g = f * g.
// 256 multiplications, 240 additions.
fn sh4_matrix_apply(m: array<f32, 136>, g: array<f32, 16>) -> array<f32, 16> {
    let t153 = m[0] * g[0];
    let t154 = fma(m[1], g[1], t153);
    let t155 = fma(m[3], g[2], t154);
    let t156 = fma(m[6], g[3], t155);
    let t157 = fma(m[10], g[4], t156);
    let t158 = fma(m[15], g[5], t157);
    let t159 = fma(m[21], g[6], t158);
    let t160 = fma(m[28], g[7], t159);
    let t161 = fma(m[36], g[8], t160);
    let t162 = fma(m[45], g[9], t161);
    let t163 = fma(m[55], g[10], t162);
    let t164 = fma(m[66], g[11], t163);
    let t165 = fma(m[78], g[12], t164);
    let t166 = fma(m[91], g[13], t165);
    let t167 = fma(m[105], g[14], t166);
    let t168 = fma(m[120], g[15], t167);
    let t169 = m[1] * g[0];
    let t170 = fma(m[2], g[1], t169);
    let t171 = fma(m[4], g[2], t170);
    let t172 = fma(m[7], g[3], t171);
    let t173 = fma(m[11], g[4], t172);
    let t174 = fma(m[16], g[5], t173);
    let t175 = fma(m[22], g[6], t174);
    let t176 = fma(m[29], g[7], t175);
    let t177 = fma(m[37], g[8], t176);
    let t178 = fma(m[46], g[9], t177);
    let t179 = fma(m[56], g[10], t178);
    let t180 = fma(m[67], g[11], t179);
    let t181 = fma(m[79], g[12], t180);
    let t182 = fma(m[92], g[13], t181);
    let t183 = fma(m[106], g[14], t182);
    let t184 = fma(m[121], g[15], t183);
    let t185 = m[3] * g[0];
    let t186 = fma(m[4], g[1], t185);
    let t187 = fma(m[5], g[2], t186);
    let t188 = fma(m[8], g[3], t187);
    let t189 = fma(m[12], g[4], t188);
    let t190 = fma(m[17], g[5], t189);
    let t191 = fma(m[23], g[6], t190);
    let t192 = fma(m[30], g[7], t191);
    let t193 = fma(m[38], g[8], t192);
    let t194 = fma(m[47], g[9], t193);
    let t195 = fma(m[57], g[10], t194);
    let t196 = fma(m[68], g[11], t195);
    let t197 = fma(m[80], g[12], t196);
    let t198 = fma(m[93], g[13], t197);
    let t199 = fma(m[107], g[14], t198);
    let t200 = fma(m[122], g[15], t199);
    let t201 = m[6] * g[0];
    let t202 = fma(m[7], g[1], t201);
    let t203 = fma(m[8], g[2], t202);
    let t204 = fma(m[9], g[3], t203);
    let t205 = fma(m[13], g[4], t204);
    let t206 = fma(m[18], g[5], t205);
    let t207 = fma(m[24], g[6], t206);
    let t208 = fma(m[31], g[7], t207);
    let t209 = fma(m[39], g[8], t208);
    let t210 = fma(m[48], g[9], t209);
    let t211 = fma(m[58], g[10], t210);
    let t212 = fma(m[69], g[11], t211);
    let t213 = fma(m[81], g[12], t212);
    let t214 = fma(m[94], g[13], t213);
    let t215 = fma(m[108], g[14], t214);
    let t216 = fma(m[123], g[15], t215);
    let t217 = m[10] * g[0];
    let t218 = fma(m[11], g[1], t217);
    let t219 = fma(m[12], g[2], t218);
    let t220 = fma(m[13], g[3], t219);
    let t221 = fma(m[14], g[4], t220);
    let t222 = fma(m[19], g[5], t221);
    let t223 = fma(m[25], g[6], t222);
    let t224 = fma(m[32], g[7], t223);
    let t225 = fma(m[40], g[8], t224);
    let t226 = fma(m[49], g[9], t225);
    let t227 = fma(m[59], g[10], t226);
    let t228 = fma(m[70], g[11], t227);
    let t229 = fma(m[82], g[12], t228);
    let t230 = fma(m[95], g[13], t229);
    let t231 = fma(m[109], g[14], t230);
    let t232 = fma(m[124], g[15], t231);
    let t233 = m[15] * g[0];
    let t234 = fma(m[16], g[1], t233);
    let t235 = fma(m[17], g[2], t234);
    let t236 = fma(m[18], g[3], t235);
    let t237 = fma(m[19], g[4], t236);
    let t238 = fma(m[20], g[5], t237);
    let t239 = fma(m[26], g[6], t238);
    let t240 = fma(m[33], g[7], t239);
    let t241 = fma(m[41], g[8], t240);
    let t242 = fma(m[50], g[9], t241);
    let t243 = fma(m[60], g[10], t242);
    let t244 = fma(m[71], g[11], t243);
    let t245 = fma(m[83], g[12], t244);
    let t246 = fma(m[96], g[13], t245);
    let t247 = fma(m[110], g[14], t246);
    let t248 = fma(m[125], g[15], t247);
    let t249 = m[21] * g[0];
    let t250 = fma(m[22], g[1], t249);
    let t251 = fma(m[23], g[2], t250);
    let t252 = fma(m[24], g[3], t251);
    let t253 = fma(m[25], g[4], t252);
    let t254 = fma(m[26], g[5], t253);
    let t255 = fma(m[27], g[6], t254);
    let t256 = fma(m[34], g[7], t255);
    let t257 = fma(m[42], g[8], t256);
    let t258 = fma(m[51], g[9], t257);
    let t259 = fma(m[61], g[10], t258);
    let t260 = fma(m[72], g[11], t259);
    let t261 = fma(m[84], g[12], t260);
    let t262 = fma(m[97], g[13], t261);
    let t263 = fma(m[111], g[14], t262);
    let t264 = fma(m[126], g[15], t263);
    let t265 = m[28] * g[0];
    let t266 = fma(m[29], g[1], t265);
    let t267 = fma(m[30], g[2], t266);
    let t268 = fma(m[31], g[3], t267);
    let t269 = fma(m[32], g[4], t268);
    let t270 = fma(m[33], g[5], t269);
    let t271 = fma(m[34], g[6], t270);
    let t272 = fma(m[35], g[7], t271);
    let t273 = fma(m[43], g[8], t272);
    let t274 = fma(m[52], g[9], t273);
    let t275 = fma(m[62], g[10], t274);
    let t276 = fma(m[73], g[11], t275);
    let t277 = fma(m[85], g[12], t276);
    let t278 = fma(m[98], g[13], t277);
    let t279 = fma(m[112], g[14], t278);
    let t280 = fma(m[127], g[15], t279);
    let t281 = m[36] * g[0];
    let t282 = fma(m[37], g[1], t281);
    let t283 = fma(m[38], g[2], t282);
    let t284 = fma(m[39], g[3], t283);
    let t285 = fma(m[40], g[4], t284);
    let t286 = fma(m[41], g[5], t285);
    let t287 = fma(m[42], g[6], t286);
    let t288 = fma(m[43], g[7], t287);
    let t289 = fma(m[44], g[8], t288);
    let t290 = fma(m[53], g[9], t289);
    let t291 = fma(m[63], g[10], t290);
    let t292 = fma(m[74], g[11], t291);
    let t293 = fma(m[86], g[12], t292);
    let t294 = fma(m[99], g[13], t293);
    let t295 = fma(m[113], g[14], t294);
    let t296 = fma(m[128], g[15], t295);
    let t297 = m[45] * g[0];
    let t298 = fma(m[46], g[1], t297);
    let t299 = fma(m[47], g[2], t298);
    let t300 = fma(m[48], g[3], t299);
    let t301 = fma(m[49], g[4], t300);
    let t302 = fma(m[50], g[5], t301);
    let t303 = fma(m[51], g[6], t302);
    let t304 = fma(m[52], g[7], t303);
    let t305 = fma(m[53], g[8], t304);
    let t306 = fma(m[54], g[9], t305);
    let t307 = fma(m[64], g[10], t306);
    let t308 = fma(m[75], g[11], t307);
    let t309 = fma(m[87], g[12], t308);
    let t310 = fma(m[100], g[13], t309);
    let t311 = fma(m[114], g[14], t310);
    let t312 = fma(m[129], g[15], t311);
    let t313 = m[55] * g[0];
    let t314 = fma(m[56], g[1], t313);
    let t315 = fma(m[57], g[2], t314);
    let t316 = fma(m[58], g[3], t315);
    let t317 = fma(m[59], g[4], t316);
    let t318 = fma(m[60], g[5], t317);
    let t319 = fma(m[61], g[6], t318);
    let t320 = fma(m[62], g[7], t319);
    let t321 = fma(m[63], g[8], t320);
    let t322 = fma(m[64], g[9], t321);
    let t323 = fma(m[65], g[10], t322);
    let t324 = fma(m[76], g[11], t323);
    let t325 = fma(m[88], g[12], t324);
    let t326 = fma(m[101], g[13], t325);
    let t327 = fma(m[115], g[14], t326);
    let t328 = fma(m[130], g[15], t327);
    let t329 = m[66] * g[0];
    let t330 = fma(m[67], g[1], t329);
    let t331 = fma(m[68], g[2], t330);
    let t332 = fma(m[69], g[3], t331);
    let t333 = fma(m[70], g[4], t332);
    let t334 = fma(m[71], g[5], t333);
    let t335 = fma(m[72], g[6], t334);
    let t336 = fma(m[73], g[7], t335);
    let t337 = fma(m[74], g[8], t336);
    let t338 = fma(m[75], g[9], t337);
    let t339 = fma(m[76], g[10], t338);
    let t340 = fma(m[77], g[11], t339);
    let t341 = fma(m[89], g[12], t340);
    let t342 = fma(m[102], g[13], t341);
    let t343 = fma(m[116], g[14], t342);
    let t344 = fma(m[131], g[15], t343);
    let t345 = m[78] * g[0];
    let t346 = fma(m[79], g[1], t345);
    let t347 = fma(m[80], g[2], t346);
    let t348 = fma(m[81], g[3], t347);
    let t349 = fma(m[82], g[4], t348);
    let t350 = fma(m[83], g[5], t349);
    let t351 = fma(m[84], g[6], t350);
    let t352 = fma(m[85], g[7], t351);
    let t353 = fma(m[86], g[8], t352);
    let t354 = fma(m[87], g[9], t353);
    let t355 = fma(m[88], g[10], t354);
    let t356 = fma(m[89], g[11], t355);
    let t357 = fma(m[90], g[12], t356);
    let t358 = fma(m[103], g[13], t357);
    let t359 = fma(m[117], g[14], t358);
    let t360 = fma(m[132], g[15], t359);
    let t361 = m[91] * g[0];
    let t362 = fma(m[92], g[1], t361);
    let t363 = fma(m[93], g[2], t362);
    let t364 = fma(m[94], g[3], t363);
    let t365 = fma(m[95], g[4], t364);
    let t366 = fma(m[96], g[5], t365);
    let t367 = fma(m[97], g[6], t366);
    let t368 = fma(m[98], g[7], t367);
    let t369 = fma(m[99], g[8], t368);
    let t370 = fma(m[100], g[9], t369);
    let t371 = fma(m[101], g[10], t370);
    let t372 = fma(m[102], g[11], t371);
    let t373 = fma(m[103], g[12], t372);
    let t374 = fma(m[104], g[13], t373);
    let t375 = fma(m[118], g[14], t374);
    let t376 = fma(m[133], g[15], t375);
    let t377 = m[105] * g[0];
    let t378 = fma(m[106], g[1], t377);
    let t379 = fma(m[107], g[2], t378);
    let t380 = fma(m[108], g[3], t379);
    let t381 = fma(m[109], g[4], t380);
    let t382 = fma(m[110], g[5], t381);
    let t383 = fma(m[111], g[6], t382);
    let t384 = fma(m[112], g[7], t383);
    let t385 = fma(m[113], g[8], t384);
    let t386 = fma(m[114], g[9], t385);
    let t387 = fma(m[115], g[10], t386);
    let t388 = fma(m[116], g[11], t387);
    let t389 = fma(m[117], g[12], t388);
    let t390 = fma(m[118], g[13], t389);
    let t391 = fma(m[119], g[14], t390);
    let t392 = fma(m[134], g[15], t391);
    let t393 = m[120] * g[0];
    let t394 = fma(m[121], g[1], t393);
    let t395 = fma(m[122], g[2], t394);
    let t396 = fma(m[123], g[3], t395);
    let t397 = fma(m[124], g[4], t396);
    let t398 = fma(m[125], g[5], t397);
    let t399 = fma(m[126], g[6], t398);
    let t400 = fma(m[127], g[7], t399);
    let t401 = fma(m[128], g[8], t400);
    let t402 = fma(m[129], g[9], t401);
    let t403 = fma(m[130], g[10], t402);
    let t404 = fma(m[131], g[11], t403);
    let t405 = fma(m[132], g[12], t404);
    let t406 = fma(m[133], g[13], t405);
    let t407 = fma(m[134], g[14], t406);
    let t408 = fma(m[135], g[15], t407);
    return array<f32, 16>(
        t168, t184, t200, t216, t232, t248, t264, t280, t296, t312, t328, t344, t360, t376, t392,
        t408,
    );
}

// `f` rotated by the unit quaternion `q` = (x, y, z, w): (Rf)(s) = f(R^-1s).
//
// As accurate for tilts of 1e-7 as for any other rotation.
// Source: R_z(alpha) R_y(beta) R_z(gamma) with the angles' cosines and sines from the quaternion; R_y by quarter turns
// about x.
// 146 multiplications, 72 additions.
fn sh4_rotate(f: array<f32, 16>, q: vec4<f32>) -> array<f32, 16> {
    let t20 = q.z * q.z;
    let t21 = fma(q.w, q.w, t20);
    let t25 = sqrt(t21);
    let t26 = q.w / t25;
    let t27 = q.z / t25;
    let t28 = select(t26, 1.0, t21 < 1e-36);
    let t29 = select(t27, 0.0, t21 < 1e-36);
    let t30 = q.x * q.x;
    let t31 = fma(q.y, q.y, t30);
    let t32 = sqrt(t31);
    let t33 = q.y / t32;
    let t34 = q.x / t32;
    let t35 = select(t33, 1.0, t31 < 1e-36);
    let t36 = select(t34, 0.0, t31 < 1e-36);
    let t37 = t29 * t36;
    let t38 = t29 * t35;
    let t39 = fma(t28, t35, -t37);
    let t40 = fma(t28, t36, t38);
    let t41 = fma(t28, t35, t37);
    let t42 = fma(-t28, t36, t38);
    let t43 = t21 + t31;
    let t44 = t21 - t31;
    let t45 = t44 / t43;
    let t46 = t21 * t31;
    let t47 = sqrt(t46);
    let t49 = t47 * 2.0;
    let t50 = t49 / t43;
    let t51 = t41 + t42;
    let t52 = t41 - t42;
    let t53 = t51 * t52;
    let t54 = t41 * 2.0;
    let t55 = t42 * t54;
    let t56 = t42 * t55;
    let t57 = fma(t41, t53, -t56);
    let t58 = t41 * t55;
    let t59 = fma(t42, t53, t58);
    let t60 = t45 + t50;
    let t61 = t45 - t50;
    let t62 = t60 * t61;
    let t63 = t45 * 2.0;
    let t64 = t50 * t63;
    let t65 = t50 * t64;
    let t66 = fma(t45, t62, -t65);
    let t67 = t45 * t64;
    let t68 = fma(t50, t62, t67);
    let t69 = t39 + t40;
    let t70 = t39 - t40;
    let t71 = t69 * t70;
    let t72 = t39 * 2.0;
    let t73 = t40 * t72;
    let t74 = t40 * t73;
    let t75 = fma(t39, t71, -t74);
    let t76 = t39 * t73;
    let t77 = fma(t40, t71, t76);
    let t78 = f[1] * t40;
    let t79 = f[1] * t39;
    let t80 = fma(f[3], t39, -t78);
    let t81 = fma(f[3], t40, t79);
    let t82 = f[5] * t40;
    let t83 = f[5] * t39;
    let t84 = fma(f[7], t39, -t82);
    let t85 = fma(f[7], t40, t83);
    let t86 = f[4] * t73;
    let t87 = f[4] * t71;
    let t88 = fma(f[8], t71, -t86);
    let t89 = fma(f[8], t73, t87);
    let t90 = f[11] * t40;
    let t91 = f[11] * t39;
    let t92 = fma(f[13], t39, -t90);
    let t93 = fma(f[13], t40, t91);
    let t94 = f[10] * t73;
    let t95 = f[10] * t71;
    let t96 = fma(f[14], t71, -t94);
    let t97 = fma(f[14], t73, t95);
    let t98 = f[9] * t77;
    let t99 = f[9] * t75;
    let t100 = fma(f[15], t75, -t98);
    let t101 = fma(f[15], t77, t99);
    let t103 = f[6] * 0.5;
    let t105 = fma(t88, 0.8660254, t103);
    let t106 = f[6] * 0.8660254;
    let t107 = fma(t88, 0.5, -t106);
    let t109 = f[12] * 0.7905694;
    let t111 = fma(-t96, 0.61237246, t109);
    let t112 = f[12] * 0.61237246;
    let t113 = fma(t96, 0.7905694, t112);
    let t114 = t101 * 0.7905694;
    let t115 = fma(t93, 0.61237246, t114);
    let t117 = t92 * 0.25;
    let t119 = fma(t100, 0.96824586, t117);
    let t120 = t101 * 0.61237246;
    let t121 = fma(-t93, 0.7905694, t120);
    let t122 = t92 * 0.96824586;
    let t123 = fma(t100, 0.25, -t122);
    let t124 = f[2] * t50;
    let t125 = f[2] * t45;
    let t126 = fma(t45, t80, t124);
    let t127 = fma(t50, t80, -t125);
    let t128 = t50 * t85;
    let t129 = t45 * t85;
    let t130 = fma(t45, t89, t128);
    let t131 = fma(t50, t89, -t129);
    let t132 = t64 * t84;
    let t133 = t62 * t84;
    let t134 = fma(t62, t107, t132);
    let t135 = fma(t64, t107, -t133);
    let t136 = t50 * t113;
    let t137 = t45 * t113;
    let t138 = fma(t45, t119, t136);
    let t139 = fma(-t50, t119, t137);
    let t140 = t64 * t97;
    let t141 = t62 * t97;
    let t142 = fma(t62, t121, t140);
    let t143 = fma(t64, t121, -t141);
    let t144 = t68 * t111;
    let t145 = t66 * t111;
    let t146 = fma(t66, t123, -t144);
    let t147 = fma(t68, t123, t145);
    let t148 = 0.5 * t105;
    let t149 = fma((-0.8660254), t134, t148);
    let t150 = 0.8660254 * t105;
    let t151 = fma(0.5, t134, t150);
    let t152 = 0.7905694 * t115;
    let t153 = fma(0.61237246, t142, t152);
    let t154 = 0.61237246 * t115;
    let t155 = fma((-0.7905694), t142, t154);
    let t156 = 0.7905694 * t147;
    let t157 = fma(0.61237246, t139, t156);
    let t158 = 0.25 * t138;
    let t159 = fma((-0.96824586), t146, t158);
    let t160 = 0.61237246 * t147;
    let t161 = fma(0.7905694, t139, -t160);
    let t162 = 0.96824586 * t138;
    let t163 = fma(0.25, t146, t162);
    let t164 = t42 * t81;
    let t165 = t41 * t81;
    let t166 = fma(t41, t126, -t164);
    let t167 = fma(t42, t126, t165);
    let t168 = t42 * t131;
    let t169 = t41 * t131;
    let t170 = fma(-t41, t135, t168);
    let t171 = fma(t42, t135, t169);
    let t172 = t55 * t130;
    let t173 = t53 * t130;
    let t174 = fma(t53, t151, -t172);
    let t175 = fma(t55, t151, t173);
    let t176 = t42 * t155;
    let t177 = t41 * t155;
    let t178 = fma(t41, t159, -t176);
    let t179 = fma(t42, t159, t177);
    let t180 = t55 * t143;
    let t181 = t53 * t143;
    let t182 = fma(t53, t161, t180);
    let t183 = fma(t55, t161, -t181);
    let t184 = t59 * t153;
    let t185 = t57 * t153;
    let t186 = fma(t57, t163, -t184);
    let t187 = fma(t59, t163, t185);
    return array<f32, 16>(
        f[0], t167, -t127, t166, t175, -t171, t149, t170, t174, t187, t183, t179, t157, t178, t182,
        t186,
    );
}

// `f` rotated by the rotation matrix `m`, given row by row: (Rf)(s) = f(R^-1s).
// Source: Shepperd 1978 to a quaternion, then as `rotate`.
// 146 multiplications, 88 additions.
fn sh4_rotate_matrix(f: array<f32, 16>, m: array<f32, 9>) -> array<f32, 16> {
    let t26 = m[0] + 1.0;
    let t27 = t26 - m[4];
    let t28 = t27 - m[8];
    let t29 = 1.0 - m[0];
    let t30 = m[4] + t29;
    let t31 = t30 - m[8];
    let t32 = t29 - m[4];
    let t33 = m[8] + t32;
    let t34 = m[4] + t26;
    let t35 = m[8] + t34;
    let t36 = m[1] + m[3];
    let t37 = m[2] + m[6];
    let t38 = m[5] + m[7];
    let t39 = m[7] - m[5];
    let t40 = m[2] - m[6];
    let t41 = m[3] - m[1];
    let t42 = select(t28, t36, t28 < t31);
    let t43 = select(t36, t31, t28 < t31);
    let t44 = select(t37, t38, t28 < t31);
    let t45 = select(t39, t40, t28 < t31);
    let t46 = select(t28, t31, t28 < t31);
    let t47 = select(t42, t37, t46 < t33);
    let t48 = select(t43, t38, t46 < t33);
    let t49 = select(t44, t33, t46 < t33);
    let t50 = select(t45, t41, t46 < t33);
    let t51 = select(t46, t33, t46 < t33);
    let t52 = select(t47, t39, t51 < t35);
    let t53 = select(t48, t40, t51 < t35);
    let t54 = select(t49, t41, t51 < t35);
    let t55 = select(t50, t35, t51 < t35);
    let t57 = t54 * t54;
    let t58 = fma(t55, t55, t57);
    let t61 = sqrt(t58);
    let t62 = t55 / t61;
    let t63 = t54 / t61;
    let t64 = select(t62, 1.0, t58 < 1e-36);
    let t65 = select(t63, 0.0, t58 < 1e-36);
    let t66 = t52 * t52;
    let t67 = fma(t53, t53, t66);
    let t68 = sqrt(t67);
    let t69 = t53 / t68;
    let t70 = t52 / t68;
    let t71 = select(t69, 1.0, t67 < 1e-36);
    let t72 = select(t70, 0.0, t67 < 1e-36);
    let t73 = t65 * t72;
    let t74 = t65 * t71;
    let t75 = fma(t64, t71, -t73);
    let t76 = fma(t64, t72, t74);
    let t77 = fma(t64, t71, t73);
    let t78 = fma(-t64, t72, t74);
    let t79 = t58 + t67;
    let t80 = t58 - t67;
    let t81 = t80 / t79;
    let t82 = t58 * t67;
    let t83 = sqrt(t82);
    let t85 = t83 * 2.0;
    let t86 = t85 / t79;
    let t87 = t77 + t78;
    let t88 = t77 - t78;
    let t89 = t87 * t88;
    let t90 = t77 * 2.0;
    let t91 = t78 * t90;
    let t92 = t78 * t91;
    let t93 = fma(t77, t89, -t92);
    let t94 = t77 * t91;
    let t95 = fma(t78, t89, t94);
    let t96 = t81 + t86;
    let t97 = t81 - t86;
    let t98 = t96 * t97;
    let t99 = t81 * 2.0;
    let t100 = t86 * t99;
    let t101 = t86 * t100;
    let t102 = fma(t81, t98, -t101);
    let t103 = t81 * t100;
    let t104 = fma(t86, t98, t103);
    let t105 = t75 + t76;
    let t106 = t75 - t76;
    let t107 = t105 * t106;
    let t108 = t75 * 2.0;
    let t109 = t76 * t108;
    let t110 = t76 * t109;
    let t111 = fma(t75, t107, -t110);
    let t112 = t75 * t109;
    let t113 = fma(t76, t107, t112);
    let t114 = f[1] * t76;
    let t115 = f[1] * t75;
    let t116 = fma(f[3], t75, -t114);
    let t117 = fma(f[3], t76, t115);
    let t118 = f[5] * t76;
    let t119 = f[5] * t75;
    let t120 = fma(f[7], t75, -t118);
    let t121 = fma(f[7], t76, t119);
    let t122 = f[4] * t109;
    let t123 = f[4] * t107;
    let t124 = fma(f[8], t107, -t122);
    let t125 = fma(f[8], t109, t123);
    let t126 = f[11] * t76;
    let t127 = f[11] * t75;
    let t128 = fma(f[13], t75, -t126);
    let t129 = fma(f[13], t76, t127);
    let t130 = f[10] * t109;
    let t131 = f[10] * t107;
    let t132 = fma(f[14], t107, -t130);
    let t133 = fma(f[14], t109, t131);
    let t134 = f[9] * t113;
    let t135 = f[9] * t111;
    let t136 = fma(f[15], t111, -t134);
    let t137 = fma(f[15], t113, t135);
    let t139 = f[6] * 0.5;
    let t141 = fma(t124, 0.8660254, t139);
    let t142 = f[6] * 0.8660254;
    let t143 = fma(t124, 0.5, -t142);
    let t145 = f[12] * 0.7905694;
    let t147 = fma(-t132, 0.61237246, t145);
    let t148 = f[12] * 0.61237246;
    let t149 = fma(t132, 0.7905694, t148);
    let t150 = t137 * 0.7905694;
    let t151 = fma(t129, 0.61237246, t150);
    let t153 = t128 * 0.25;
    let t155 = fma(t136, 0.96824586, t153);
    let t156 = t137 * 0.61237246;
    let t157 = fma(-t129, 0.7905694, t156);
    let t158 = t128 * 0.96824586;
    let t159 = fma(t136, 0.25, -t158);
    let t160 = f[2] * t86;
    let t161 = f[2] * t81;
    let t162 = fma(t81, t116, t160);
    let t163 = fma(t86, t116, -t161);
    let t164 = t86 * t121;
    let t165 = t81 * t121;
    let t166 = fma(t81, t125, t164);
    let t167 = fma(t86, t125, -t165);
    let t168 = t100 * t120;
    let t169 = t98 * t120;
    let t170 = fma(t98, t143, t168);
    let t171 = fma(t100, t143, -t169);
    let t172 = t86 * t149;
    let t173 = t81 * t149;
    let t174 = fma(t81, t155, t172);
    let t175 = fma(-t86, t155, t173);
    let t176 = t100 * t133;
    let t177 = t98 * t133;
    let t178 = fma(t98, t157, t176);
    let t179 = fma(t100, t157, -t177);
    let t180 = t104 * t147;
    let t181 = t102 * t147;
    let t182 = fma(t102, t159, -t180);
    let t183 = fma(t104, t159, t181);
    let t184 = 0.5 * t141;
    let t185 = fma((-0.8660254), t170, t184);
    let t186 = 0.8660254 * t141;
    let t187 = fma(0.5, t170, t186);
    let t188 = 0.7905694 * t151;
    let t189 = fma(0.61237246, t178, t188);
    let t190 = 0.61237246 * t151;
    let t191 = fma((-0.7905694), t178, t190);
    let t192 = 0.7905694 * t183;
    let t193 = fma(0.61237246, t175, t192);
    let t194 = 0.25 * t174;
    let t195 = fma((-0.96824586), t182, t194);
    let t196 = 0.61237246 * t183;
    let t197 = fma(0.7905694, t175, -t196);
    let t198 = 0.96824586 * t174;
    let t199 = fma(0.25, t182, t198);
    let t200 = t78 * t117;
    let t201 = t77 * t117;
    let t202 = fma(t77, t162, -t200);
    let t203 = fma(t78, t162, t201);
    let t204 = t78 * t167;
    let t205 = t77 * t167;
    let t206 = fma(-t77, t171, t204);
    let t207 = fma(t78, t171, t205);
    let t208 = t91 * t166;
    let t209 = t89 * t166;
    let t210 = fma(t89, t187, -t208);
    let t211 = fma(t91, t187, t209);
    let t212 = t78 * t191;
    let t213 = t77 * t191;
    let t214 = fma(t77, t195, -t212);
    let t215 = fma(t78, t195, t213);
    let t216 = t91 * t179;
    let t217 = t89 * t179;
    let t218 = fma(t89, t197, t216);
    let t219 = fma(t91, t197, -t217);
    let t220 = t95 * t189;
    let t221 = t93 * t189;
    let t222 = fma(t93, t199, -t220);
    let t223 = fma(t95, t199, t221);
    return array<f32, 16>(
        f[0], t203, -t163, t202, t211, -t207, t185, t206, t210, t223, t219, t215, t193, t214, t218,
        t222,
    );
}

// `f` with band l scaled by cos(pi/2 * l/h), and by 0 for l >= h: against ringing. `h` must be positive; 2n is a mild
// window.
// Source: Ren et al. 2006, section 7.
// 30 multiplications, 12 additions.
fn sh4_window(f: array<f32, 16>, h: f32) -> array<f32, 16> {
    let t18 = 1.5707964 / h;
    let t19 = t18 * t18;
    let t24 = fma(t19, 4.1103176e-19, (-1.5619207e-16));
    let t26 = fma(t19, t24, 4.7794773e-14);
    let t28 = fma(t19, t26, (-1.1470745e-11));
    let t30 = fma(t19, t28, 2.0876756e-9);
    let t32 = fma(t19, t30, (-2.755732e-7));
    let t34 = fma(t19, t32, 2.4801588e-5);
    let t36 = fma(t19, t34, (-0.0013888889));
    let t38 = fma(t19, t36, 0.041666668);
    let t40 = fma(t19, t38, (-0.5));
    let t41 = fma(t19, t40, 1.0);
    let t43 = t41 * 2.0;
    let t44 = fma(t41, t43, (-1.0));
    let t45 = fma(t43, t44, -t41);
    let t46 = select(0.0, t41, 1.0 < h);
    let t47 = select(0.0, t44, 2.0 < h);
    let t49 = select(0.0, t45, 3.0 < h);
    let t50 = f[1] * t46;
    let t51 = f[2] * t46;
    let t52 = f[3] * t46;
    let t53 = f[4] * t47;
    let t54 = f[5] * t47;
    let t55 = f[6] * t47;
    let t56 = f[7] * t47;
    let t57 = f[8] * t47;
    let t58 = f[9] * t49;
    let t59 = f[10] * t49;
    let t60 = f[11] * t49;
    let t61 = f[12] * t49;
    let t62 = f[13] * t49;
    let t63 = f[14] * t49;
    let t64 = f[15] * t49;
    return array<f32, 16>(
        f[0], t50, t51, t52, t53, t54, t55, t56, t57, t58, t59, t60, t61, t62, t63, t64,
    );
}

// Zonal coefficients of the visibility past a circular blocker of angular radius theta about +Z, for any theta in
// 0..pi, from its cosine and sine.
// Source: Ren et al. 2006, eq. 33, integrated in closed form.
// 8 multiplications, 2 additions.
fn sh4_cap_visibility(cosine: f32, sine: f32) -> array<f32, 4> {
    let t2 = sine * sine;
    let t3 = cosine * cosine;
    let t5 = fma(cosine, 1.7724539, 1.7724539);
    let t8 = t2 * 1.5349901;
    let t10 = cosine * 1.9816637;
    let t11 = t2 * t10;
    let t14 = fma(-t3, 2.9309201, 0.586184);
    let t15 = t2 * t14;
    return array<f32, 4>(
        t5, -t8, -t11, t15,
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
// 34 multiplications, 29 additions.
fn sh4_cap_log(sine: f32, cosine: f32) -> array<f32, 4> {
    let t2 = sine * sine;
    let t5 = fma(cosine, 2.0, (-1.0));
    let t9 = fma(t5, 8.714938, 1.4270217);
    let t11 = fma(t5, t9, (-17.657686));
    let t13 = fma(t5, t11, (-4.2739987));
    let t15 = fma(t5, t13, 11.971621);
    let t17 = fma(t5, t15, 2.9923768);
    let t19 = fma(t5, t17, (-0.27626336));
    let t21 = fma(t5, t19, (-3.7308142));
    let t22 = t2 * t21;
    let t25 = fma(t5, 13.132736, 2.2905025);
    let t27 = fma(t5, t25, (-26.742426));
    let t29 = fma(t5, t27, (-6.455682));
    let t31 = fma(t5, t29, 17.383503);
    let t33 = fma(t5, t31, 5.607005);
    let t35 = fma(t5, t33, (-1.3441178));
    let t37 = fma(t5, t35, (-5.323891));
    let t38 = t2 * t37;
    let t41 = fma(t5, 13.413185, 2.018432);
    let t43 = fma(t5, t41, (-27.491596));
    let t45 = fma(t5, t43, (-5.5599904));
    let t47 = fma(t5, t45, 17.261269);
    let t49 = fma(t5, t47, 6.2600274);
    let t51 = fma(t5, t49, (-3.2967982));
    let t53 = fma(t5, t51, (-4.504789));
    let t54 = t2 * t53;
    let t57 = fma(t5, 10.851003, 1.2098075);
    let t59 = fma(t5, t57, (-22.230406));
    let t61 = fma(t5, t59, (-3.7561858));
    let t63 = fma(t5, t61, 13.856788);
    let t65 = fma(t5, t63, 4.6774774);
    let t67 = fma(t5, t65, (-4.275321));
    let t69 = fma(t5, t67, (-2.6153786));
    let t70 = t2 * t69;
    return array<f32, 4>(
        t22, t38, t54, t70,
    );
}

// `f` plus the logarithm of the visibility past a circular blocker about the unit vector `d`: what one blocker costs a
// receiver. The angular radius theta in 0..pi/2 comes as its sine and cosine.
// Source: Ren et al. 2006, eq. 34 and 8, with the fitted logarithm of `cap_log`.
// 77 multiplications, 52 additions.
fn sh4_add_cap_log(f: array<f32, 16>, sine: f32, cosine: f32, d: vec3<f32>) -> array<f32, 16> {
    let t21 = sine * sine;
    let t24 = fma(cosine, 2.0, (-1.0));
    let t28 = fma(t24, 30.893652, 5.05866);
    let t30 = fma(t24, t28, (-62.594868));
    let t32 = fma(t24, t30, (-15.150931));
    let t34 = fma(t24, t32, 42.43829);
    let t36 = fma(t24, t34, 10.607699);
    let t38 = fma(t24, t36, (-0.9793281));
    let t40 = fma(t24, t38, (-13.225391));
    let t41 = t21 * t40;
    let t44 = fma(t24, 26.878159, 4.687865);
    let t46 = fma(t24, t44, (-54.732475));
    let t48 = fma(t24, t46, (-13.2125435));
    let t50 = fma(t24, t48, 35.578007);
    let t52 = fma(t24, t50, 11.475596);
    let t54 = fma(t24, t52, (-2.7509432));
    let t56 = fma(t24, t54, (-10.89616));
    let t57 = t21 * t56;
    let t60 = fma(t24, 21.264338, 3.1998825);
    let t62 = fma(t24, t60, (-43.58328));
    let t64 = fma(t24, t62, (-8.8144245));
    let t66 = fma(t24, t64, 27.364822);
    let t68 = fma(t24, t66, 9.924214);
    let t70 = fma(t24, t68, (-5.2265162));
    let t72 = fma(t24, t70, (-7.141581));
    let t73 = t21 * t72;
    let t76 = fma(t24, 14.538708, 1.6209595);
    let t78 = fma(t24, t76, (-29.78539));
    let t80 = fma(t24, t78, (-5.0327225));
    let t82 = fma(t24, t80, 18.566006);
    let t84 = fma(t24, t82, 6.267114);
    let t86 = fma(t24, t84, (-5.7282853));
    let t88 = fma(t24, t86, (-3.5042129));
    let t89 = t21 * t88;
    let t90 = d.x + d.y;
    let t91 = d.x - d.y;
    let t92 = t90 * t91;
    let t93 = d.x * 2.0;
    let t94 = d.y * t93;
    let t95 = d.y * t94;
    let t96 = fma(d.x, t92, -t95);
    let t97 = d.x * t94;
    let t98 = fma(d.y, t92, t97);
    let t99 = d.z * d.z;
    let t102 = d.y * 0.48860252;
    let t103 = d.z * 0.48860252;
    let t104 = d.x * 0.48860252;
    let t106 = t94 * 0.54627424;
    let t108 = d.z * 1.0925485;
    let t109 = d.y * t108;
    let t112 = fma(t99, 0.9461747, (-0.31539157));
    let t113 = d.x * t108;
    let t114 = t92 * 0.54627424;
    let t116 = t98 * 0.5900436;
    let t118 = d.z * 1.4453057;
    let t119 = t94 * t118;
    let t122 = fma(t99, 2.285229, (-0.4570458));
    let t123 = d.y * t122;
    let t126 = fma(t99, 1.8658817, (-1.119529));
    let t127 = d.z * t126;
    let t128 = d.x * t122;
    let t129 = t92 * t118;
    let t130 = t96 * 0.5900436;
    let t131 = fma(t41, 0.2820948, f[0]);
    let t132 = fma(t57, t102, f[1]);
    let t133 = fma(t57, t103, f[2]);
    let t134 = fma(t57, t104, f[3]);
    let t135 = fma(t73, t106, f[4]);
    let t136 = fma(t73, t109, f[5]);
    let t137 = fma(t73, t112, f[6]);
    let t138 = fma(t73, t113, f[7]);
    let t139 = fma(t73, t114, f[8]);
    let t140 = fma(t89, t116, f[9]);
    let t141 = fma(t89, t119, f[10]);
    let t142 = fma(t89, t123, f[11]);
    let t143 = fma(t89, t127, f[12]);
    let t144 = fma(t89, t128, f[13]);
    let t145 = fma(t89, t129, f[14]);
    let t146 = fma(t89, t130, f[15]);
    return array<f32, 16>(
        t131, t132, t133, t134, t135, t136, t137, t138, t139, t140, t141, t142, t143, t144, t145,
        t146,
    );
}

// As `cap_log`, fitted to `exp_saturating` in the place of the eigen logarithm: sums of it over blockers are what that
// exponential is made for, and no other is. theta in 0..pi/2.
// Source: Ren et al. 2006, eq. 33-34, with the logarithm fitted against true visibilities; `gaunt-lab fit` rewrites the
// coefficients, `gaunt-lab accuracy` states their error.
// 22 multiplications, 17 additions.
fn sh4_cap_log_saturating(sine: f32, cosine: f32) -> array<f32, 4> {
    let t2 = sine * sine;
    let t5 = fma(cosine, 2.0, (-1.0));
    let t9 = fma(t5, 1.4199343, 0.50829476);
    let t11 = fma(t5, t9, (-5.254378));
    let t13 = fma(t5, t11, 5.691467);
    let t15 = fma(t5, t13, (-2.6918445));
    let t16 = t2 * t15;
    let t19 = fma(t5, 2.5226598, (-0.95602775));
    let t21 = fma(t5, t19, (-6.1901937));
    let t23 = fma(t5, t21, 7.5006948);
    let t25 = fma(t5, t23, (-3.8176134));
    let t26 = t2 * t25;
    let t29 = fma(t5, 3.641454, (-3.6814451));
    let t31 = fma(t5, t29, (-3.0555286));
    let t33 = fma(t5, t31, 5.06762);
    let t35 = fma(t5, t33, (-3.104334));
    let t36 = t2 * t35;
    let t39 = fma(t5, 2.6218448, (-3.627524));
    let t41 = fma(t5, t39, (-0.20456287));
    let t43 = fma(t5, t41, 1.2212323);
    let t45 = fma(t5, t43, (-1.5191456));
    let t46 = t2 * t45;
    return array<f32, 4>(
        t16, t26, t36, t46,
    );
}

// `f` plus the logarithm `cap_log_saturating` of the visibility past a circular blocker about the unit vector `d`: what
// one blocker costs a receiver of the shadow pass. The angular radius theta in 0..pi/2 comes as its sine and cosine.
// Source: Ren et al. 2006, eq. 34 and 8, with the fitted logarithm of `cap_log_saturating`.
// 65 multiplications, 40 additions.
fn sh4_add_cap_log_saturating(f: array<f32, 16>, sine: f32, cosine: f32, d: vec3<f32>) -> array<f32, 16> {
    let t21 = sine * sine;
    let t24 = fma(cosine, 2.0, (-1.0));
    let t28 = fma(t24, 5.033536, 1.801858);
    let t30 = fma(t24, t28, (-18.626286));
    let t32 = fma(t24, t30, 20.175726);
    let t34 = fma(t24, t32, (-9.54234));
    let t35 = t21 * t34;
    let t38 = fma(t24, 5.16301, (-1.9566575));
    let t40 = fma(t24, t38, (-12.669181));
    let t42 = fma(t24, t40, 15.351322);
    let t44 = fma(t24, t42, (-7.8133316));
    let t45 = t21 * t44;
    let t48 = fma(t24, 5.7729096, (-5.836309));
    let t50 = fma(t24, t48, (-4.844024));
    let t52 = fma(t24, t50, 8.0338545);
    let t54 = fma(t24, t52, (-4.9213967));
    let t55 = t21 * t54;
    let t58 = fma(t24, 3.5128765, (-4.860335));
    let t60 = fma(t24, t58, (-0.2740834));
    let t62 = fma(t24, t60, 1.6362671);
    let t64 = fma(t24, t62, (-2.035426));
    let t65 = t21 * t64;
    let t66 = d.x + d.y;
    let t67 = d.x - d.y;
    let t68 = t66 * t67;
    let t69 = d.x * 2.0;
    let t70 = d.y * t69;
    let t71 = d.y * t70;
    let t72 = fma(d.x, t68, -t71);
    let t73 = d.x * t70;
    let t74 = fma(d.y, t68, t73);
    let t75 = d.z * d.z;
    let t78 = d.y * 0.48860252;
    let t79 = d.z * 0.48860252;
    let t80 = d.x * 0.48860252;
    let t82 = t70 * 0.54627424;
    let t84 = d.z * 1.0925485;
    let t85 = d.y * t84;
    let t88 = fma(t75, 0.9461747, (-0.31539157));
    let t89 = d.x * t84;
    let t90 = t68 * 0.54627424;
    let t92 = t74 * 0.5900436;
    let t94 = d.z * 1.4453057;
    let t95 = t70 * t94;
    let t98 = fma(t75, 2.285229, (-0.4570458));
    let t99 = d.y * t98;
    let t102 = fma(t75, 1.8658817, (-1.119529));
    let t103 = d.z * t102;
    let t104 = d.x * t98;
    let t105 = t68 * t94;
    let t106 = t72 * 0.5900436;
    let t107 = fma(t35, 0.2820948, f[0]);
    let t108 = fma(t45, t78, f[1]);
    let t109 = fma(t45, t79, f[2]);
    let t110 = fma(t45, t80, f[3]);
    let t111 = fma(t55, t82, f[4]);
    let t112 = fma(t55, t85, f[5]);
    let t113 = fma(t55, t88, f[6]);
    let t114 = fma(t55, t89, f[7]);
    let t115 = fma(t55, t90, f[8]);
    let t116 = fma(t65, t92, f[9]);
    let t117 = fma(t65, t95, f[10]);
    let t118 = fma(t65, t99, f[11]);
    let t119 = fma(t65, t103, f[12]);
    let t120 = fma(t65, t104, f[13]);
    let t121 = fma(t65, t105, f[14]);
    let t122 = fma(t65, t106, f[15]);
    return array<f32, 16>(
        t107, t108, t109, t110, t111, t112, t113, t114, t115, t116, t117, t118, t119, t120, t121,
        t122,
    );
}

// As `cap_log`, fitted to `transfer` in the place of the eigen logarithm. theta in 0..pi/2; of a small one band l is
// that of what the circle hides, so that few small blockers cast the whole of their shadow.
// Source: Ren et al. 2006, eq. 33-34, with the logarithm fitted against true transfers; `gaunt-lab fit` rewrites the
// coefficients.
// 18 multiplications, 13 additions.
fn sh4_cap_log_shading(sine: f32, cosine: f32) -> array<f32, 4> {
    let t2 = sine * sine;
    let t5 = fma(cosine, 2.0, (-1.0));
    let t9 = fma(t5, 1.6844178, 0.77649766);
    let t11 = fma(-t5, t9, 4.54486);
    let t13 = fma(t5, t11, (-2.9701712));
    let t14 = t2 * t13;
    let t17 = fma(-t5, 1.0135978, 2.7615485);
    let t19 = fma(t5, t17, 3.9274805);
    let t21 = fma(t5, t19, (-7.210421));
    let t22 = t2 * t21;
    let t25 = fma(-t5, 6.6317716, 3.0883527);
    let t27 = fma(t5, t25, 4.646804);
    let t29 = fma(t5, t27, (-3.0850484));
    let t30 = t2 * t29;
    let t33 = fma(t5, 2.5485919, 2.4583907);
    let t35 = fma(t5, t33, (-3.954012));
    let t37 = fma(t5, t35, (-3.3977067));
    let t38 = t2 * t37;
    return array<f32, 4>(
        t14, t22, t30, t38,
    );
}

// A sum of blockers plus one more: what one blocker of a cut costs a receiver of the shadow pass. The logarithm
// `cap_log_shading` about the unit vector `d`, band l of it times `w[l]`: a blocker's own weight, times the ratio
// vector of one that stands for several. Coefficients of the sum lack a factor each, which `accumulated_log` puts in at
// the end; it costs as little for many blockers as for one.
// Source: Ren et al. 2006, eq. 38, with the fitted logarithm of `cap_log_shading`.
// 52 multiplications, 36 additions.
fn sh4_accumulate_blocker(f: array<f32, 16>, sine: f32, cosine: f32, d: vec3<f32>, w: array<f32, 4>) -> array<f32, 16> {
    let t25 = sine * sine;
    let t26 = w[0] * t25;
    let t27 = w[1] * t25;
    let t28 = w[2] * t25;
    let t29 = w[3] * t25;
    let t32 = fma(cosine, 2.0, (-1.0));
    let t36 = fma(t32, 1.6844178, 0.77649766);
    let t38 = fma(-t32, t36, 4.54486);
    let t40 = fma(t32, t38, (-2.9701712));
    let t44 = fma(-t32, 1.0135978, 2.7615485);
    let t46 = fma(t32, t44, 3.9274805);
    let t48 = fma(t32, t46, (-7.210421));
    let t49 = t27 * t48;
    let t52 = fma(-t32, 6.6317716, 3.0883527);
    let t54 = fma(t32, t52, 4.646804);
    let t56 = fma(t32, t54, (-3.0850484));
    let t57 = t28 * t56;
    let t60 = fma(t32, 2.5485919, 2.4583907);
    let t62 = fma(t32, t60, (-3.954012));
    let t64 = fma(t32, t62, (-3.3977067));
    let t65 = t29 * t64;
    let t66 = d.x + d.y;
    let t67 = d.x - d.y;
    let t68 = t66 * t67;
    let t69 = d.x * 2.0;
    let t70 = d.y * t69;
    let t71 = d.y * t70;
    let t72 = fma(d.x, t68, -t71);
    let t73 = d.x * t70;
    let t74 = fma(d.y, t68, t73);
    let t75 = d.z * d.z;
    let t76 = d.y * d.z;
    let t78 = t75 - 0.33333334;
    let t79 = d.x * d.z;
    let t80 = d.z * t70;
    let t82 = t75 - 0.2;
    let t83 = d.y * t82;
    let t85 = t75 - 0.6;
    let t86 = d.z * t85;
    let t87 = d.x * t82;
    let t88 = d.z * t68;
    let t89 = fma(t26, t40, f[0]);
    let t90 = fma(d.y, t49, f[1]);
    let t91 = fma(d.z, t49, f[2]);
    let t92 = fma(d.x, t49, f[3]);
    let t93 = fma(t57, t70, f[4]);
    let t94 = fma(t57, t76, f[5]);
    let t95 = fma(t57, t78, f[6]);
    let t96 = fma(t57, t79, f[7]);
    let t97 = fma(t57, t68, f[8]);
    let t98 = fma(t65, t74, f[9]);
    let t99 = fma(t65, t80, f[10]);
    let t100 = fma(t65, t83, f[11]);
    let t101 = fma(t65, t86, f[12]);
    let t102 = fma(t65, t87, f[13]);
    let t103 = fma(t65, t88, f[14]);
    let t104 = fma(t65, t72, f[15]);
    return array<f32, 16>(
        t89, t90, t91, t92, t93, t94, t95, t96, t97, t98, t99, t100, t101, t102, t103, t104,
    );
}

// As `accumulate_blocker`, with the logarithm `cap_log_saturating`: for `exp_saturating`, where the visibility itself
// is asked for.
// Source: Ren et al. 2006, eq. 38, with the fitted logarithm of `cap_log_saturating`.
// 56 multiplications, 40 additions.
fn sh4_accumulate_blocker_saturating(f: array<f32, 16>, sine: f32, cosine: f32, d: vec3<f32>, w: array<f32, 4>) -> array<f32, 16> {
    let t25 = sine * sine;
    let t26 = w[0] * t25;
    let t27 = w[1] * t25;
    let t28 = w[2] * t25;
    let t29 = w[3] * t25;
    let t32 = fma(cosine, 2.0, (-1.0));
    let t36 = fma(t32, 1.4199343, 0.50829476);
    let t38 = fma(t32, t36, (-5.254378));
    let t40 = fma(t32, t38, 5.691467);
    let t42 = fma(t32, t40, (-2.6918445));
    let t46 = fma(t32, 2.5226598, (-0.95602775));
    let t48 = fma(t32, t46, (-6.1901937));
    let t50 = fma(t32, t48, 7.5006948);
    let t52 = fma(t32, t50, (-3.8176134));
    let t53 = t27 * t52;
    let t56 = fma(t32, 3.641454, (-3.6814451));
    let t58 = fma(t32, t56, (-3.0555286));
    let t60 = fma(t32, t58, 5.06762);
    let t62 = fma(t32, t60, (-3.104334));
    let t63 = t28 * t62;
    let t66 = fma(t32, 2.6218448, (-3.627524));
    let t68 = fma(t32, t66, (-0.20456287));
    let t70 = fma(t32, t68, 1.2212323);
    let t72 = fma(t32, t70, (-1.5191456));
    let t73 = t29 * t72;
    let t74 = d.x + d.y;
    let t75 = d.x - d.y;
    let t76 = t74 * t75;
    let t77 = d.x * 2.0;
    let t78 = d.y * t77;
    let t79 = d.y * t78;
    let t80 = fma(d.x, t76, -t79);
    let t81 = d.x * t78;
    let t82 = fma(d.y, t76, t81);
    let t83 = d.z * d.z;
    let t84 = d.y * d.z;
    let t86 = t83 - 0.33333334;
    let t87 = d.x * d.z;
    let t88 = d.z * t78;
    let t90 = t83 - 0.2;
    let t91 = d.y * t90;
    let t93 = t83 - 0.6;
    let t94 = d.z * t93;
    let t95 = d.x * t90;
    let t96 = d.z * t76;
    let t97 = fma(t26, t42, f[0]);
    let t98 = fma(d.y, t53, f[1]);
    let t99 = fma(d.z, t53, f[2]);
    let t100 = fma(d.x, t53, f[3]);
    let t101 = fma(t63, t78, f[4]);
    let t102 = fma(t63, t84, f[5]);
    let t103 = fma(t63, t86, f[6]);
    let t104 = fma(t63, t87, f[7]);
    let t105 = fma(t63, t76, f[8]);
    let t106 = fma(t73, t82, f[9]);
    let t107 = fma(t73, t88, f[10]);
    let t108 = fma(t73, t91, f[11]);
    let t109 = fma(t73, t94, f[12]);
    let t110 = fma(t73, t95, f[13]);
    let t111 = fma(t73, t96, f[14]);
    let t112 = fma(t73, t80, f[15]);
    return array<f32, 16>(
        t97, t98, t99, t100, t101, t102, t103, t104, t105, t106, t107, t108, t109, t110, t111,
        t112,
    );
}

// The logarithm of the visibility past all blockers that `accumulate_blocker` has summed up: each coefficient times its
// factor.
// Source: The leading coefficients of the basis functions, as polynomials in z, and sqrt(4 pi/(2l+1)).
// 12 multiplications, 0 additions.
fn sh4_accumulated_log(f: array<f32, 16>) -> array<f32, 16> {
    let t18 = f[4] * 0.8660254;
    let t20 = f[5] * 1.7320508;
    let t22 = f[6] * 1.5;
    let t23 = f[7] * 1.7320508;
    let t24 = f[8] * 0.8660254;
    let t26 = f[9] * 0.7905694;
    let t28 = f[10] * 1.9364917;
    let t30 = f[11] * 3.0618622;
    let t32 = f[12] * 2.5;
    let t33 = f[13] * 3.0618622;
    let t34 = f[14] * 1.9364917;
    let t35 = f[15] * 0.7905694;
    return array<f32, 16>(
        f[0], f[1], f[2], f[3], t18, t20, t22, t23, t24, t26, t28, t30, t32, t33, t34, t35,
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
// 69 multiplications, 34 additions.
fn sh4_ball_average(sine: f32, cosine: f32, d: vec3<f32>) -> array<f32, 16> {
    let t9 = fma(cosine, 0.10139153, (-0.4891273));
    let t11 = fma(cosine, t9, 0.3260717);
    let t13 = fma(cosine, t11, 1.0740308);
    let t15 = fma(cosine, t13, (-1.3456995));
    let t18 = fma(cosine, 0.052248806, 0.17544451);
    let t20 = fma(cosine, t18, (-1.0734253));
    let t22 = fma(cosine, t20, 1.3456732);
    let t23 = fma(sine, t22, t15);
    let t24 = fma(cosine, t23, 1.0);
    let t27 = fma(cosine, 0.090071715, (-0.27939302));
    let t29 = fma(cosine, t27, (-0.1027927));
    let t31 = fma(cosine, t29, 1.0581062);
    let t33 = fma(cosine, t31, (-1.5159922));
    let t36 = fma(-cosine, 0.022782547, 0.36532167);
    let t38 = fma(cosine, t36, (-1.0585536));
    let t40 = fma(cosine, t38, 1.5160077);
    let t41 = fma(sine, t40, t33);
    let t42 = fma(cosine, t41, 1.0);
    let t45 = fma(cosine, 0.14192861, (-0.27847898));
    let t47 = fma(cosine, t45, (-1.0266498));
    let t49 = fma(cosine, t47, 1.6076074);
    let t51 = fma(cosine, t49, (-1.4444076));
    let t54 = fma(-cosine, 0.09962217, 0.76443815);
    let t56 = fma(cosine, t54, (-1.609256));
    let t58 = fma(cosine, t56, 1.4444689);
    let t59 = fma(sine, t58, t51);
    let t60 = fma(cosine, t59, 1.0);
    let t61 = d.x + d.y;
    let t62 = d.x - d.y;
    let t63 = t61 * t62;
    let t65 = d.x * 2.0;
    let t66 = d.y * t65;
    let t67 = d.y * t66;
    let t68 = fma(d.x, t63, -t67);
    let t69 = d.x * t66;
    let t70 = fma(d.y, t63, t69);
    let t71 = d.z * d.z;
    let t74 = d.y * 0.48860252;
    let t75 = d.z * 0.48860252;
    let t76 = d.x * 0.48860252;
    let t78 = t66 * 0.54627424;
    let t80 = d.z * 1.0925485;
    let t81 = d.y * t80;
    let t84 = fma(t71, 0.9461747, (-0.31539157));
    let t85 = d.x * t80;
    let t86 = t63 * 0.54627424;
    let t88 = t70 * 0.5900436;
    let t90 = d.z * 1.4453057;
    let t91 = t66 * t90;
    let t94 = fma(t71, 2.285229, (-0.4570458));
    let t95 = d.y * t94;
    let t98 = fma(t71, 1.8658817, (-1.119529));
    let t99 = d.z * t98;
    let t100 = d.x * t94;
    let t101 = t63 * t90;
    let t102 = t68 * 0.5900436;
    let t103 = t24 * t74;
    let t104 = t24 * t75;
    let t105 = t24 * t76;
    let t106 = t42 * t78;
    let t107 = t42 * t81;
    let t108 = t42 * t84;
    let t109 = t42 * t85;
    let t110 = t42 * t86;
    let t111 = t60 * t88;
    let t112 = t60 * t91;
    let t113 = t60 * t95;
    let t114 = t60 * t99;
    let t115 = t60 * t100;
    let t116 = t60 * t101;
    let t117 = t60 * t102;
    return array<f32, 16>(
        0.2820948, t103, t104, t105, t106, t107, t108, t109, t110, t111, t112, t113, t114, t115,
        t116, t117,
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
fn sh4_disc_covered(a: f32, b: f32, d: f32) -> f32 {
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
// 367 multiplications, 604 additions.
fn sh4_exp_saturating(f: array<f32, 16>) -> array<f32, 16> {
    let t17 = f[1] * f[1];
    let t18 = fma(f[2], f[2], t17);
    let t19 = fma(f[3], f[3], t18);
    let t20 = fma(f[4], f[4], t19);
    let t21 = fma(f[5], f[5], t20);
    let t22 = fma(f[6], f[6], t21);
    let t23 = fma(f[7], f[7], t22);
    let t24 = fma(f[8], f[8], t23);
    let t25 = fma(f[9], f[9], t24);
    let t26 = fma(f[10], f[10], t25);
    let t27 = fma(f[11], f[11], t26);
    let t28 = fma(f[12], f[12], t27);
    let t29 = fma(f[13], f[13], t28);
    let t30 = fma(f[14], f[14], t29);
    let t31 = fma(f[15], f[15], t30);
    let t33 = min(t31, 1e37);
    let t36 = fma(t33, 0.07017116, 1.0);
    let t37 = sqrt(t36);
    let t38 = 1.0 / t37;
    let t39 = f[0] * t38;
    let t40 = f[1] * t38;
    let t41 = f[2] * t38;
    let t42 = f[3] * t38;
    let t43 = f[4] * t38;
    let t44 = f[5] * t38;
    let t45 = f[6] * t38;
    let t46 = f[7] * t38;
    let t47 = f[8] * t38;
    let t48 = f[9] * t38;
    let t49 = f[10] * t38;
    let t50 = f[11] * t38;
    let t51 = f[12] * t38;
    let t52 = f[13] * t38;
    let t53 = f[14] * t38;
    let t54 = f[15] * t38;
    let t59 = t39 * 0.2820948;
    let t61 = t42 * 0.48860252;
    let t63 = fma(-t45, 0.31539157, t59);
    let t65 = fma(t47, 0.54627424, t63);
    let t67 = fma(-t52, 0.4570458, t61);
    let t69 = fma(t54, 0.5900436, t67);
    let t70 = t65 + t69;
    let t71 = t65 - t69;
    let t72 = max(t70, (-1.0));
    let t73 = min(t72, 0.2);
    let t74 = fma((-0.25), t73, 0.75);
    let t75 = fma(t73, t74, 1.0);
    let t76 = t75 * t75;
    let t77 = max(t71, (-1.0));
    let t78 = min(t77, 0.2);
    let t79 = fma((-0.25), t78, 0.75);
    let t80 = fma(t78, t79, 1.0);
    let t81 = t80 * t80;
    let t82 = t76 + t81;
    let t83 = t76 - t81;
    let t85 = t82 * 0.0450147;
    let t87 = t83 * 0.07109128;
    let t89 = t82 * 0.044318028;
    let t91 = t82 * 0.076761074;
    let t93 = t83 * 0.0563757;
    let t95 = t83 * 0.07278071;
    let t96 = t40 * 0.48860252;
    let t97 = fma(-t47, 0.54627424, t63);
    let t98 = fma(-t48, 0.5900436, t96);
    let t99 = fma(-t50, 0.4570458, t98);
    let t100 = t97 + t99;
    let t101 = t97 - t99;
    let t102 = max(t100, (-1.0));
    let t103 = min(t102, 0.2);
    let t104 = fma((-0.25), t103, 0.75);
    let t105 = fma(t103, t104, 1.0);
    let t106 = t105 * t105;
    let t107 = max(t101, (-1.0));
    let t108 = min(t107, 0.2);
    let t109 = fma((-0.25), t108, 0.75);
    let t110 = fma(t108, t109, 1.0);
    let t111 = t110 * t110;
    let t112 = t106 + t111;
    let t113 = t106 - t111;
    let t114 = fma(0.0450147, t112, t85);
    let t115 = 0.07109128 * t113;
    let t116 = fma(0.044318028, t112, t89);
    let t117 = fma((-0.076761074), t112, t91);
    let t118 = 0.07278071 * t113;
    let t119 = 0.0563757 * t113;
    let t120 = t41 * 0.48860252;
    let t122 = fma(t45, 0.63078314, t59);
    let t124 = fma(t51, 0.7463527, t120);
    let t125 = t122 + t124;
    let t126 = t122 - t124;
    let t127 = max(t125, (-1.0));
    let t128 = min(t127, 0.2);
    let t129 = fma((-0.25), t128, 0.75);
    let t130 = fma(t128, t129, 1.0);
    let t131 = t130 * t130;
    let t132 = max(t126, (-1.0));
    let t133 = min(t132, 0.2);
    let t134 = fma((-0.25), t133, 0.75);
    let t135 = fma(t133, t134, 1.0);
    let t136 = t135 * t135;
    let t137 = t131 + t136;
    let t138 = t131 - t136;
    let t139 = fma(0.0450147, t137, t114);
    let t140 = 0.07109128 * t138;
    let t142 = fma(t137, 0.088636056, -t116);
    let t144 = t138 * 0.09206113;
    let t146 = t40 * 0.34549415;
    let t147 = t41 * 0.34549415;
    let t148 = t44 * 0.54627424;
    let t150 = fma(t45, 0.15769579, t59);
    let t152 = fma(-t47, 0.27313712, t150);
    let t154 = fma(-t48, 0.2086119, t146);
    let t156 = fma(t50, 0.48477027, t154);
    let t158 = fma(-t51, 0.13193776, t147);
    let t160 = fma(-t53, 0.51099277, t158);
    let t161 = t152 + t156;
    let t162 = t152 - t156;
    let t163 = t148 + t160;
    let t164 = t160 - t148;
    let t165 = t161 + t163;
    let t166 = t161 - t163;
    let t167 = t162 + t164;
    let t168 = t162 - t164;
    let t169 = max(t165, (-1.0));
    let t170 = min(t169, 0.2);
    let t171 = fma((-0.25), t170, 0.75);
    let t172 = fma(t170, t171, 1.0);
    let t173 = t172 * t172;
    let t174 = max(t167, (-1.0));
    let t175 = min(t174, 0.2);
    let t176 = fma((-0.25), t175, 0.75);
    let t177 = fma(t175, t176, 1.0);
    let t178 = t177 * t177;
    let t179 = max(t166, (-1.0));
    let t180 = min(t179, 0.2);
    let t181 = fma((-0.25), t180, 0.75);
    let t182 = fma(t180, t181, 1.0);
    let t183 = t182 * t182;
    let t184 = max(t168, (-1.0));
    let t185 = min(t184, 0.2);
    let t186 = fma((-0.25), t185, 0.75);
    let t187 = fma(t185, t186, 1.0);
    let t188 = t187 * t187;
    let t189 = t173 + t178;
    let t190 = t173 - t178;
    let t191 = t183 + t188;
    let t192 = t183 - t188;
    let t193 = t189 + t191;
    let t194 = t189 - t191;
    let t195 = t190 + t192;
    let t196 = t190 - t192;
    let t198 = fma(t193, 0.080026135, t139);
    let t200 = fma(t195, 0.08936733, t115);
    let t201 = fma(t194, 0.08936733, t140);
    let t203 = t196 * 0.13646413;
    let t205 = fma(t193, 0.0393938, t142);
    let t207 = fma(-t193, 0.06823207, t117);
    let t209 = fma(t195, 0.045745544, t118);
    let t211 = fma(t195, 0.10630304, -t119);
    let t213 = fma(-t194, 0.028932024, t144);
    let t215 = t194 * 0.112053245;
    let t216 = t42 * 0.34549415;
    let t217 = t46 * 0.54627424;
    let t218 = fma(t47, 0.27313712, t150);
    let t219 = fma(t52, 0.48477027, t216);
    let t220 = fma(t53, 0.51099277, t158);
    let t221 = fma(t54, 0.2086119, t219);
    let t222 = t218 + t221;
    let t223 = t218 - t221;
    let t224 = t217 + t220;
    let t225 = t220 - t217;
    let t226 = t222 + t224;
    let t227 = t222 - t224;
    let t228 = t223 + t225;
    let t229 = t223 - t225;
    let t230 = max(t226, (-1.0));
    let t231 = min(t230, 0.2);
    let t232 = fma((-0.25), t231, 0.75);
    let t233 = fma(t231, t232, 1.0);
    let t234 = t233 * t233;
    let t235 = max(t228, (-1.0));
    let t236 = min(t235, 0.2);
    let t237 = fma((-0.25), t236, 0.75);
    let t238 = fma(t236, t237, 1.0);
    let t239 = t238 * t238;
    let t240 = max(t227, (-1.0));
    let t241 = min(t240, 0.2);
    let t242 = fma((-0.25), t241, 0.75);
    let t243 = fma(t241, t242, 1.0);
    let t244 = t243 * t243;
    let t245 = max(t229, (-1.0));
    let t246 = min(t245, 0.2);
    let t247 = fma((-0.25), t246, 0.75);
    let t248 = fma(t246, t247, 1.0);
    let t249 = t248 * t248;
    let t250 = t234 + t239;
    let t251 = t234 - t239;
    let t252 = t244 + t249;
    let t253 = t244 - t249;
    let t254 = t250 + t252;
    let t255 = t250 - t252;
    let t256 = t251 + t253;
    let t257 = t251 - t253;
    let t258 = fma(0.080026135, t254, t198);
    let t259 = fma(0.08936733, t255, t201);
    let t260 = fma(0.08936733, t256, t87);
    let t261 = fma(0.0393938, t254, t205);
    let t262 = 0.13646413 * t257;
    let t263 = fma(0.06823207, t254, t207);
    let t264 = fma((-0.028932024), t255, t213);
    let t265 = fma(0.10630304, t256, -t93);
    let t266 = fma(0.112053245, t255, -t215);
    let t267 = fma(0.045745544, t256, t95);
    let t269 = t43 * 0.54627424;
    let t271 = fma(t48, 0.4172238, t146);
    let t273 = fma(-t50, 0.3231802, t271);
    let t274 = fma(-t52, 0.3231802, t216);
    let t275 = fma(-t54, 0.4172238, t274);
    let t276 = t63 + t275;
    let t277 = t63 - t275;
    let t278 = t269 + t273;
    let t279 = t273 - t269;
    let t280 = t276 + t278;
    let t281 = t276 - t278;
    let t282 = t277 + t279;
    let t283 = t277 - t279;
    let t284 = max(t280, (-1.0));
    let t285 = min(t284, 0.2);
    let t286 = fma((-0.25), t285, 0.75);
    let t287 = fma(t285, t286, 1.0);
    let t288 = t287 * t287;
    let t289 = max(t282, (-1.0));
    let t290 = min(t289, 0.2);
    let t291 = fma((-0.25), t290, 0.75);
    let t292 = fma(t290, t291, 1.0);
    let t293 = t292 * t292;
    let t294 = max(t281, (-1.0));
    let t295 = min(t294, 0.2);
    let t296 = fma((-0.25), t295, 0.75);
    let t297 = fma(t295, t296, 1.0);
    let t298 = t297 * t297;
    let t299 = max(t283, (-1.0));
    let t300 = min(t299, 0.2);
    let t301 = fma((-0.25), t300, 0.75);
    let t302 = fma(t300, t301, 1.0);
    let t303 = t302 * t302;
    let t304 = t288 + t293;
    let t305 = t288 - t293;
    let t306 = t298 + t303;
    let t307 = t298 - t303;
    let t308 = t304 + t306;
    let t309 = t304 - t306;
    let t310 = t305 + t307;
    let t311 = t305 - t307;
    let t312 = fma(0.080026135, t308, t258);
    let t313 = fma(0.08936733, t309, t200);
    let t314 = fma(0.08936733, t310, t260);
    let t316 = t311 * 0.13646413;
    let t318 = fma(-t308, 0.0787876, t261);
    let t320 = fma(t309, 0.09149109, -t209);
    let t322 = fma(-t309, 0.07086869, t211);
    let t323 = fma(-t310, 0.07086869, t265);
    let t324 = fma(-t310, 0.09149109, t267);
    let t325 = t40 * 0.2820948;
    let t326 = t41 * 0.2820948;
    let t327 = t42 * 0.2820948;
    let t329 = t43 * 0.3641828;
    let t330 = t44 * 0.3641828;
    let t331 = t46 * 0.3641828;
    let t333 = fma(t48, 0.22710788, t325);
    let t335 = t49 * 0.55629843;
    let t337 = fma(t50, 0.17591701, t333);
    let t339 = fma(-t51, 0.28727126, t326);
    let t340 = fma(t52, 0.17591701, t327);
    let t341 = fma(-t54, 0.22710788, t340);
    let t342 = t59 + t341;
    let t343 = t59 - t341;
    let t344 = t329 + t337;
    let t345 = t337 - t329;
    let t346 = t331 + t339;
    let t347 = t339 - t331;
    let t348 = t330 + t335;
    let t349 = t330 - t335;
    let t350 = t342 + t344;
    let t351 = t342 - t344;
    let t352 = t343 + t345;
    let t353 = t343 - t345;
    let t354 = t346 + t348;
    let t355 = t346 - t348;
    let t356 = t347 + t349;
    let t357 = t347 - t349;
    let t358 = t350 + t354;
    let t359 = t350 - t354;
    let t360 = t352 + t356;
    let t361 = t352 - t356;
    let t362 = t351 + t355;
    let t363 = t351 - t355;
    let t364 = t353 + t357;
    let t365 = t353 - t357;
    let t366 = max(t358, (-1.0));
    let t367 = min(t366, 0.2);
    let t368 = fma((-0.25), t367, 0.75);
    let t369 = fma(t367, t368, 1.0);
    let t370 = t369 * t369;
    let t371 = max(t360, (-1.0));
    let t372 = min(t371, 0.2);
    let t373 = fma((-0.25), t372, 0.75);
    let t374 = fma(t372, t373, 1.0);
    let t375 = t374 * t374;
    let t376 = max(t362, (-1.0));
    let t377 = min(t376, 0.2);
    let t378 = fma((-0.25), t377, 0.75);
    let t379 = fma(t377, t378, 1.0);
    let t380 = t379 * t379;
    let t381 = max(t364, (-1.0));
    let t382 = min(t381, 0.2);
    let t383 = fma((-0.25), t382, 0.75);
    let t384 = fma(t382, t383, 1.0);
    let t385 = t384 * t384;
    let t386 = max(t359, (-1.0));
    let t387 = min(t386, 0.2);
    let t388 = fma((-0.25), t387, 0.75);
    let t389 = fma(t387, t388, 1.0);
    let t390 = t389 * t389;
    let t391 = max(t361, (-1.0));
    let t392 = min(t391, 0.2);
    let t393 = fma((-0.25), t392, 0.75);
    let t394 = fma(t392, t393, 1.0);
    let t395 = t394 * t394;
    let t396 = max(t363, (-1.0));
    let t397 = min(t396, 0.2);
    let t398 = fma((-0.25), t397, 0.75);
    let t399 = fma(t397, t398, 1.0);
    let t400 = t399 * t399;
    let t401 = max(t365, (-1.0));
    let t402 = min(t401, 0.2);
    let t403 = fma((-0.25), t402, 0.75);
    let t404 = fma(t402, t403, 1.0);
    let t405 = t404 * t404;
    let t406 = t370 + t375;
    let t407 = t370 - t375;
    let t408 = t380 + t385;
    let t409 = t380 - t385;
    let t410 = t390 + t395;
    let t411 = t390 - t395;
    let t412 = t400 + t405;
    let t413 = t400 - t405;
    let t414 = t406 + t408;
    let t415 = t406 - t408;
    let t416 = t407 + t409;
    let t417 = t407 - t409;
    let t418 = t410 + t412;
    let t419 = t410 - t412;
    let t420 = t411 + t413;
    let t421 = t411 - t413;
    let t422 = t414 + t418;
    let t423 = t414 - t418;
    let t424 = t416 + t420;
    let t425 = t416 - t420;
    let t426 = t415 + t419;
    let t427 = t415 - t419;
    let t428 = t417 + t421;
    let t429 = t417 - t421;
    let t431 = fma(t422, 0.0747754, t312);
    let t433 = fma(t426, 0.06818048, t313);
    let t434 = fma(t423, 0.06818048, t259);
    let t435 = fma(t424, 0.06818048, t314);
    let t437 = fma(t428, 0.08500689, t316);
    let t438 = fma(t427, 0.08500689, t203);
    let t439 = fma(t425, 0.08500689, t262);
    let t441 = fma(t426, 0.04653383, t320);
    let t443 = t429 * 0.11398414;
    let t445 = fma(t426, 0.03604495, t322);
    let t447 = fma(-t423, 0.058861155, t264);
    let t448 = fma(t424, 0.03604495, t323);
    let t449 = fma(-t424, 0.04653383, t324);
    let t451 = t40 * 0.1473192;
    let t453 = t41 * 0.4419576;
    let t454 = t42 * 0.1473192;
    let t456 = t43 * 0.09932259;
    let t458 = t44 * 0.29796776;
    let t460 = fma(t45, 0.45875138, t59);
    let t461 = t46 * 0.29796776;
    let t463 = fma(t48, 0.032346334, t451);
    let t465 = t49 * 0.23769604;
    let t467 = fma(t50, 0.42594117, t463);
    let t469 = fma(t51, 0.3682371, t453);
    let t470 = fma(t52, 0.42594117, t454);
    let t471 = fma(-t54, 0.032346334, t470);
    let t472 = t460 + t471;
    let t473 = t460 - t471;
    let t474 = t456 + t467;
    let t475 = t467 - t456;
    let t476 = t461 + t469;
    let t477 = t469 - t461;
    let t478 = t458 + t465;
    let t479 = t458 - t465;
    let t480 = t472 + t474;
    let t481 = t472 - t474;
    let t482 = t473 + t475;
    let t483 = t473 - t475;
    let t484 = t476 + t478;
    let t485 = t476 - t478;
    let t486 = t477 + t479;
    let t487 = t477 - t479;
    let t488 = t480 + t484;
    let t489 = t480 - t484;
    let t490 = t482 + t486;
    let t491 = t482 - t486;
    let t492 = t481 + t485;
    let t493 = t481 - t485;
    let t494 = t483 + t487;
    let t495 = t483 - t487;
    let t496 = max(t488, (-1.0));
    let t497 = min(t496, 0.2);
    let t498 = fma((-0.25), t497, 0.75);
    let t499 = fma(t497, t498, 1.0);
    let t500 = t499 * t499;
    let t501 = max(t490, (-1.0));
    let t502 = min(t501, 0.2);
    let t503 = fma((-0.25), t502, 0.75);
    let t504 = fma(t502, t503, 1.0);
    let t505 = t504 * t504;
    let t506 = max(t492, (-1.0));
    let t507 = min(t506, 0.2);
    let t508 = fma((-0.25), t507, 0.75);
    let t509 = fma(t507, t508, 1.0);
    let t510 = t509 * t509;
    let t511 = max(t494, (-1.0));
    let t512 = min(t511, 0.2);
    let t513 = fma((-0.25), t512, 0.75);
    let t514 = fma(t512, t513, 1.0);
    let t515 = t514 * t514;
    let t516 = max(t489, (-1.0));
    let t517 = min(t516, 0.2);
    let t518 = fma((-0.25), t517, 0.75);
    let t519 = fma(t517, t518, 1.0);
    let t520 = t519 * t519;
    let t521 = max(t491, (-1.0));
    let t522 = min(t521, 0.2);
    let t523 = fma((-0.25), t522, 0.75);
    let t524 = fma(t522, t523, 1.0);
    let t525 = t524 * t524;
    let t526 = max(t493, (-1.0));
    let t527 = min(t526, 0.2);
    let t528 = fma((-0.25), t527, 0.75);
    let t529 = fma(t527, t528, 1.0);
    let t530 = t529 * t529;
    let t531 = max(t495, (-1.0));
    let t532 = min(t531, 0.2);
    let t533 = fma((-0.25), t532, 0.75);
    let t534 = fma(t532, t533, 1.0);
    let t535 = t534 * t534;
    let t536 = t500 + t505;
    let t537 = t500 - t505;
    let t538 = t510 + t515;
    let t539 = t510 - t515;
    let t540 = t520 + t525;
    let t541 = t520 - t525;
    let t542 = t530 + t535;
    let t543 = t530 - t535;
    let t544 = t536 + t538;
    let t545 = t536 - t538;
    let t546 = t537 + t539;
    let t547 = t537 - t539;
    let t548 = t540 + t542;
    let t549 = t540 - t542;
    let t550 = t541 + t543;
    let t551 = t541 - t543;
    let t552 = t544 + t548;
    let t553 = t544 - t548;
    let t554 = t546 + t550;
    let t555 = t546 - t550;
    let t556 = t545 + t549;
    let t557 = t545 - t549;
    let t558 = t547 + t551;
    let t559 = t547 - t551;
    let t561 = fma(t552, 0.07151261, t431);
    let t563 = fma(t556, 0.03405244, t433);
    let t565 = fma(t553, 0.102157325, t434);
    let t566 = fma(t554, 0.03405244, t435);
    let t568 = fma(t558, 0.02217209, t437);
    let t570 = fma(t557, 0.06651627, t438);
    let t572 = fma(t552, 0.1024085, t318);
    let t573 = fma(t555, 0.06651627, t439);
    let t575 = fma(t556, 0.0063384864, t441);
    let t577 = fma(t559, 0.046578173, t443);
    let t579 = fma(t556, 0.0834661, t445);
    let t581 = fma(t553, 0.0721586, t447);
    let t582 = fma(t554, 0.0834661, t448);
    let t583 = fma(-t554, 0.0063384864, t449);
    let t584 = t40 * 0.4419576;
    let t585 = t41 * 0.1473192;
    let t586 = t43 * 0.29796776;
    let t588 = fma(-t45, 0.22937569, t59);
    let t589 = t46 * 0.09932259;
    let t591 = fma(-t47, 0.39729035, t588);
    let t593 = fma(-t48, 0.291117, t584);
    let t595 = t49 * 0.23769604;
    let t597 = fma(-t50, 0.22549826, t593);
    let t599 = fma(-t51, 0.28640664, t585);
    let t601 = fma(-t52, 0.075166084, t454);
    let t603 = fma(-t53, 0.31692806, t599);
    let t605 = fma(-t54, 0.42050233, t601);
    let t606 = t591 + t605;
    let t607 = t591 - t605;
    let t608 = t586 + t597;
    let t609 = t597 - t586;
    let t610 = t589 + t603;
    let t611 = t603 - t589;
    let t612 = t458 + t595;
    let t613 = t458 - t595;
    let t614 = t606 + t608;
    let t615 = t606 - t608;
    let t616 = t607 + t609;
    let t617 = t607 - t609;
    let t618 = t610 + t612;
    let t619 = t610 - t612;
    let t620 = t611 + t613;
    let t621 = t611 - t613;
    let t622 = t614 + t618;
    let t623 = t614 - t618;
    let t624 = t616 + t620;
    let t625 = t616 - t620;
    let t626 = t615 + t619;
    let t627 = t615 - t619;
    let t628 = t617 + t621;
    let t629 = t617 - t621;
    let t630 = max(t622, (-1.0));
    let t631 = min(t630, 0.2);
    let t632 = fma((-0.25), t631, 0.75);
    let t633 = fma(t631, t632, 1.0);
    let t634 = t633 * t633;
    let t635 = max(t624, (-1.0));
    let t636 = min(t635, 0.2);
    let t637 = fma((-0.25), t636, 0.75);
    let t638 = fma(t636, t637, 1.0);
    let t639 = t638 * t638;
    let t640 = max(t626, (-1.0));
    let t641 = min(t640, 0.2);
    let t642 = fma((-0.25), t641, 0.75);
    let t643 = fma(t641, t642, 1.0);
    let t644 = t643 * t643;
    let t645 = max(t628, (-1.0));
    let t646 = min(t645, 0.2);
    let t647 = fma((-0.25), t646, 0.75);
    let t648 = fma(t646, t647, 1.0);
    let t649 = t648 * t648;
    let t650 = max(t623, (-1.0));
    let t651 = min(t650, 0.2);
    let t652 = fma((-0.25), t651, 0.75);
    let t653 = fma(t651, t652, 1.0);
    let t654 = t653 * t653;
    let t655 = max(t625, (-1.0));
    let t656 = min(t655, 0.2);
    let t657 = fma((-0.25), t656, 0.75);
    let t658 = fma(t656, t657, 1.0);
    let t659 = t658 * t658;
    let t660 = max(t627, (-1.0));
    let t661 = min(t660, 0.2);
    let t662 = fma((-0.25), t661, 0.75);
    let t663 = fma(t661, t662, 1.0);
    let t664 = t663 * t663;
    let t665 = max(t629, (-1.0));
    let t666 = min(t665, 0.2);
    let t667 = fma((-0.25), t666, 0.75);
    let t668 = fma(t666, t667, 1.0);
    let t669 = t668 * t668;
    let t670 = t634 + t639;
    let t671 = t634 - t639;
    let t672 = t644 + t649;
    let t673 = t644 - t649;
    let t674 = t654 + t659;
    let t675 = t654 - t659;
    let t676 = t664 + t669;
    let t677 = t664 - t669;
    let t678 = t670 + t672;
    let t679 = t670 - t672;
    let t680 = t671 + t673;
    let t681 = t671 - t673;
    let t682 = t674 + t676;
    let t683 = t674 - t676;
    let t684 = t675 + t677;
    let t685 = t675 - t677;
    let t686 = t678 + t682;
    let t687 = t678 - t682;
    let t688 = t680 + t684;
    let t689 = t680 - t684;
    let t690 = t679 + t683;
    let t691 = t679 - t683;
    let t692 = t681 + t685;
    let t693 = t681 - t685;
    let t694 = fma(0.07151261, t686, t561);
    let t695 = fma(0.102157325, t690, t563);
    let t696 = fma(0.03405244, t687, t565);
    let t697 = fma(0.03405244, t688, t566);
    let t698 = fma(0.06651627, t692, t568);
    let t699 = fma(0.06651627, t691, t570);
    let t701 = fma(-t686, 0.05120425, t572);
    let t702 = fma(0.02217209, t689, t573);
    let t704 = fma(-t686, 0.08868836, t263);
    let t706 = fma(-t690, 0.05704638, t575);
    let t708 = fma(t693, 0.046578173, t577);
    let t710 = fma(-t690, 0.044187933, t579);
    let t712 = fma(-t687, 0.056123354, t581);
    let t714 = fma(-t688, 0.014729312, t582);
    let t716 = fma(-t687, 0.062104233, t266);
    let t718 = fma(-t688, 0.08240032, t583);
    let t719 = t42 * 0.4419576;
    let t720 = t44 * 0.09932259;
    let t721 = fma(t47, 0.39729035, t588);
    let t722 = fma(t48, 0.42050233, t451);
    let t723 = fma(-t50, 0.075166084, t722);
    let t724 = fma(-t52, 0.22549826, t719);
    let t725 = fma(t53, 0.31692806, t599);
    let t726 = fma(t54, 0.291117, t724);
    let t727 = t721 + t726;
    let t728 = t721 - t726;
    let t729 = t586 + t723;
    let t730 = t723 - t586;
    let t731 = t461 + t725;
    let t732 = t725 - t461;
    let t733 = t595 + t720;
    let t734 = t720 - t595;
    let t735 = t727 + t729;
    let t736 = t727 - t729;
    let t737 = t728 + t730;
    let t738 = t728 - t730;
    let t739 = t731 + t733;
    let t740 = t731 - t733;
    let t741 = t732 + t734;
    let t742 = t732 - t734;
    let t743 = t735 + t739;
    let t744 = t735 - t739;
    let t745 = t737 + t741;
    let t746 = t737 - t741;
    let t747 = t736 + t740;
    let t748 = t736 - t740;
    let t749 = t738 + t742;
    let t750 = t738 - t742;
    let t751 = max(t743, (-1.0));
    let t752 = min(t751, 0.2);
    let t753 = fma((-0.25), t752, 0.75);
    let t754 = fma(t752, t753, 1.0);
    let t755 = t754 * t754;
    let t756 = max(t745, (-1.0));
    let t757 = min(t756, 0.2);
    let t758 = fma((-0.25), t757, 0.75);
    let t759 = fma(t757, t758, 1.0);
    let t760 = t759 * t759;
    let t761 = max(t747, (-1.0));
    let t762 = min(t761, 0.2);
    let t763 = fma((-0.25), t762, 0.75);
    let t764 = fma(t762, t763, 1.0);
    let t765 = t764 * t764;
    let t766 = max(t749, (-1.0));
    let t767 = min(t766, 0.2);
    let t768 = fma((-0.25), t767, 0.75);
    let t769 = fma(t767, t768, 1.0);
    let t770 = t769 * t769;
    let t771 = max(t744, (-1.0));
    let t772 = min(t771, 0.2);
    let t773 = fma((-0.25), t772, 0.75);
    let t774 = fma(t772, t773, 1.0);
    let t775 = t774 * t774;
    let t776 = max(t746, (-1.0));
    let t777 = min(t776, 0.2);
    let t778 = fma((-0.25), t777, 0.75);
    let t779 = fma(t777, t778, 1.0);
    let t780 = t779 * t779;
    let t781 = max(t748, (-1.0));
    let t782 = min(t781, 0.2);
    let t783 = fma((-0.25), t782, 0.75);
    let t784 = fma(t782, t783, 1.0);
    let t785 = t784 * t784;
    let t786 = max(t750, (-1.0));
    let t787 = min(t786, 0.2);
    let t788 = fma((-0.25), t787, 0.75);
    let t789 = fma(t787, t788, 1.0);
    let t790 = t789 * t789;
    let t791 = t755 + t760;
    let t792 = t755 - t760;
    let t793 = t765 + t770;
    let t794 = t765 - t770;
    let t795 = t775 + t780;
    let t796 = t775 - t780;
    let t797 = t785 + t790;
    let t798 = t785 - t790;
    let t799 = t791 + t793;
    let t800 = t791 - t793;
    let t801 = t792 + t794;
    let t802 = t792 - t794;
    let t803 = t795 + t797;
    let t804 = t795 - t797;
    let t805 = t796 + t798;
    let t806 = t796 - t798;
    let t807 = t799 + t803;
    let t808 = t799 - t803;
    let t809 = t801 + t805;
    let t810 = t801 - t805;
    let t811 = t800 + t804;
    let t812 = t800 - t804;
    let t813 = t802 + t806;
    let t814 = t802 - t806;
    let t815 = fma(0.07151261, t807, t694);
    let t816 = fma(0.03405244, t811, t695);
    let t817 = fma(0.03405244, t808, t696);
    let t818 = fma(0.102157325, t809, t697);
    let t819 = fma(0.06651627, t813, t698);
    let t820 = fma(0.02217209, t812, t699);
    let t821 = fma((-0.05120425), t807, t701);
    let t822 = fma(0.06651627, t810, t702);
    let t823 = fma(0.08868836, t807, t704);
    let t824 = fma(0.08240032, t811, t706);
    let t825 = fma(0.046578173, t814, t708);
    let t826 = fma((-0.014729312), t811, t710);
    let t827 = fma((-0.056123354), t808, t712);
    let t828 = fma((-0.044187933), t809, t714);
    let t829 = fma(0.062104233, t808, t716);
    let t830 = fma(0.05704638, t809, t718);
    return array<f32, 16>(
        t815, t816, t817, t818, t819, t820, t821, t822, t823, t824, t825, t826, t827, t828, t829,
        t830,
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
// 579 multiplications, 709 additions.
fn sh4_transfer(f: array<f32, 16>, d: vec3<f32>) -> array<f32, 16> {
    let t21 = f[1] * f[1];
    let t22 = fma(f[2], f[2], t21);
    let t23 = fma(f[3], f[3], t22);
    let t24 = fma(f[4], f[4], t23);
    let t25 = fma(f[5], f[5], t24);
    let t26 = fma(f[6], f[6], t25);
    let t27 = fma(f[7], f[7], t26);
    let t28 = fma(f[8], f[8], t27);
    let t29 = fma(f[9], f[9], t28);
    let t30 = fma(f[10], f[10], t29);
    let t31 = fma(f[11], f[11], t30);
    let t32 = fma(f[12], f[12], t31);
    let t33 = fma(f[13], f[13], t32);
    let t34 = fma(f[14], f[14], t33);
    let t35 = fma(f[15], f[15], t34);
    let t37 = min(t35, 1e37);
    let t40 = fma(t37, 0.009929332, 1.0);
    let t41 = sqrt(t40);
    let t42 = 1.0 / t41;
    let t43 = f[0] * t42;
    let t44 = f[1] * t42;
    let t45 = f[2] * t42;
    let t46 = f[3] * t42;
    let t47 = f[4] * t42;
    let t48 = f[5] * t42;
    let t49 = f[6] * t42;
    let t50 = f[7] * t42;
    let t51 = f[8] * t42;
    let t52 = f[9] * t42;
    let t53 = f[10] * t42;
    let t54 = f[11] * t42;
    let t55 = f[12] * t42;
    let t56 = f[13] * t42;
    let t57 = f[14] * t42;
    let t58 = f[15] * t42;
    let t62 = t43 * 0.2820948;
    let t64 = t46 * 0.48860252;
    let t66 = fma(-t49, 0.31539157, t62);
    let t68 = fma(t51, 0.54627424, t66);
    let t70 = fma(-t56, 0.4570458, t64);
    let t72 = fma(t58, 0.5900436, t70);
    let t73 = t68 + t72;
    let t74 = t68 - t72;
    let t75 = fma(0.25, t73, 1.0);
    let t76 = max(t75, 0.0);
    let t77 = min(t76, 1.125);
    let t78 = t77 * t77;
    let t79 = t78 * t78;
    let t80 = d.x * d.x;
    let t83 = fma(t80, 0.23337026, (-0.44878897));
    let t85 = fma(t80, t83, 0.36719096);
    let t87 = fma(t80, t85, 0.013599666);
    let t88 = fma(d.x, 0.15915494, t87);
    let t89 = t79 * t88;
    let t90 = fma(0.25, t74, 1.0);
    let t91 = max(t90, 0.0);
    let t92 = min(t91, 1.125);
    let t93 = t92 * t92;
    let t94 = t93 * t93;
    let t95 = fma(-d.x, 0.15915494, t87);
    let t96 = t94 * t95;
    let t97 = t89 + t96;
    let t98 = t89 - t96;
    let t100 = t97 * 0.0450147;
    let t102 = t98 * 0.07796775;
    let t104 = t97 * 0.050327964;
    let t106 = t97 * 0.08717059;
    let t108 = t98 * 0.072932154;
    let t110 = t98 * 0.094155;
    let t111 = t44 * 0.48860252;
    let t112 = fma(-t51, 0.54627424, t66);
    let t113 = fma(-t52, 0.5900436, t111);
    let t114 = fma(-t54, 0.4570458, t113);
    let t115 = t112 + t114;
    let t116 = t112 - t114;
    let t117 = fma(0.25, t115, 1.0);
    let t118 = max(t117, 0.0);
    let t119 = min(t118, 1.125);
    let t120 = t119 * t119;
    let t121 = t120 * t120;
    let t122 = d.y * d.y;
    let t123 = fma(0.23337026, t122, (-0.44878897));
    let t124 = fma(t122, t123, 0.36719096);
    let t125 = fma(t122, t124, 0.013599666);
    let t126 = fma(d.y, 0.15915494, t125);
    let t127 = t121 * t126;
    let t128 = fma(0.25, t116, 1.0);
    let t129 = max(t128, 0.0);
    let t130 = min(t129, 1.125);
    let t131 = t130 * t130;
    let t132 = t131 * t131;
    let t133 = fma(-d.y, 0.15915494, t125);
    let t134 = t132 * t133;
    let t135 = t127 + t134;
    let t136 = t127 - t134;
    let t137 = fma(0.0450147, t135, t100);
    let t138 = 0.07796775 * t136;
    let t139 = fma(0.050327964, t135, t104);
    let t140 = fma((-0.08717059), t135, t106);
    let t141 = 0.094155 * t136;
    let t142 = 0.072932154 * t136;
    let t143 = t45 * 0.48860252;
    let t145 = fma(t49, 0.63078314, t62);
    let t147 = fma(t55, 0.7463527, t143);
    let t148 = t145 + t147;
    let t149 = t145 - t147;
    let t150 = fma(0.25, t148, 1.0);
    let t151 = max(t150, 0.0);
    let t152 = min(t151, 1.125);
    let t153 = t152 * t152;
    let t154 = t153 * t153;
    let t155 = d.z * d.z;
    let t156 = fma(0.23337026, t155, (-0.44878897));
    let t157 = fma(t155, t156, 0.36719096);
    let t158 = fma(t155, t157, 0.013599666);
    let t159 = fma(d.z, 0.15915494, t158);
    let t160 = t154 * t159;
    let t161 = fma(0.25, t149, 1.0);
    let t162 = max(t161, 0.0);
    let t163 = min(t162, 1.125);
    let t164 = t163 * t163;
    let t165 = t164 * t164;
    let t166 = fma(-d.z, 0.15915494, t158);
    let t167 = t165 * t166;
    let t168 = t160 + t167;
    let t169 = t160 - t167;
    let t170 = fma(0.0450147, t168, t137);
    let t171 = 0.07796775 * t169;
    let t173 = fma(t168, 0.10065593, -t139);
    let t175 = t169 * 0.1190977;
    let t177 = t44 * 0.34549415;
    let t178 = t45 * 0.34549415;
    let t179 = t48 * 0.54627424;
    let t181 = fma(t49, 0.15769579, t62);
    let t183 = fma(-t51, 0.27313712, t181);
    let t185 = fma(-t52, 0.2086119, t177);
    let t187 = fma(t54, 0.48477027, t185);
    let t189 = fma(-t55, 0.13193776, t178);
    let t191 = fma(-t57, 0.51099277, t189);
    let t192 = t183 + t187;
    let t193 = t183 - t187;
    let t194 = t179 + t191;
    let t195 = t191 - t179;
    let t196 = t192 + t194;
    let t197 = t192 - t194;
    let t198 = t193 + t195;
    let t199 = t193 - t195;
    let t201 = d.y * 0.70710677;
    let t202 = d.z * 0.70710677;
    let t203 = t201 + t202;
    let t204 = t201 - t202;
    let t205 = fma(0.25, t196, 1.0);
    let t206 = max(t205, 0.0);
    let t207 = min(t206, 1.125);
    let t208 = t207 * t207;
    let t209 = t208 * t208;
    let t210 = t203 * t203;
    let t211 = fma(0.23337026, t210, (-0.44878897));
    let t212 = fma(t210, t211, 0.36719096);
    let t213 = fma(t210, t212, 0.013599666);
    let t214 = fma(0.15915494, t203, t213);
    let t215 = t209 * t214;
    let t216 = fma(0.25, t198, 1.0);
    let t217 = max(t216, 0.0);
    let t218 = min(t217, 1.125);
    let t219 = t218 * t218;
    let t220 = t219 * t219;
    let t221 = t204 * t204;
    let t222 = fma(0.23337026, t221, (-0.44878897));
    let t223 = fma(t221, t222, 0.36719096);
    let t224 = fma(t221, t223, 0.013599666);
    let t225 = fma((-0.15915494), t204, t224);
    let t226 = t220 * t225;
    let t227 = fma(0.25, t197, 1.0);
    let t228 = max(t227, 0.0);
    let t229 = min(t228, 1.125);
    let t230 = t229 * t229;
    let t231 = t230 * t230;
    let t232 = fma(0.15915494, t204, t224);
    let t233 = t231 * t232;
    let t234 = fma(0.25, t199, 1.0);
    let t235 = max(t234, 0.0);
    let t236 = min(t235, 1.125);
    let t237 = t236 * t236;
    let t238 = t237 * t237;
    let t239 = fma((-0.15915494), t203, t213);
    let t240 = t238 * t239;
    let t241 = t215 + t226;
    let t242 = t215 - t226;
    let t243 = t233 + t240;
    let t244 = t233 - t240;
    let t245 = t241 + t243;
    let t246 = t241 - t243;
    let t247 = t242 + t244;
    let t248 = t242 - t244;
    let t250 = fma(t245, 0.080026135, t170);
    let t252 = fma(t247, 0.0980116, t138);
    let t253 = fma(t246, 0.0980116, t171);
    let t255 = t248 * 0.15496995;
    let t257 = fma(t245, 0.044735968, t173);
    let t259 = fma(-t245, 0.07748497, t140);
    let t261 = fma(t247, 0.059180126, t141);
    let t263 = fma(t247, 0.13752218, -t142);
    let t265 = fma(-t246, 0.037428796, t175);
    let t267 = t246 * 0.1449611;
    let t268 = t46 * 0.34549415;
    let t269 = t50 * 0.54627424;
    let t270 = fma(t51, 0.27313712, t181);
    let t271 = fma(t56, 0.48477027, t268);
    let t272 = fma(t57, 0.51099277, t189);
    let t273 = fma(t58, 0.2086119, t271);
    let t274 = t270 + t273;
    let t275 = t270 - t273;
    let t276 = t269 + t272;
    let t277 = t272 - t269;
    let t278 = t274 + t276;
    let t279 = t274 - t276;
    let t280 = t275 + t277;
    let t281 = t275 - t277;
    let t282 = d.x * 0.70710677;
    let t283 = t202 + t282;
    let t284 = t282 - t202;
    let t285 = fma(0.25, t278, 1.0);
    let t286 = max(t285, 0.0);
    let t287 = min(t286, 1.125);
    let t288 = t287 * t287;
    let t289 = t288 * t288;
    let t290 = t283 * t283;
    let t291 = fma(0.23337026, t290, (-0.44878897));
    let t292 = fma(t290, t291, 0.36719096);
    let t293 = fma(t290, t292, 0.013599666);
    let t294 = fma(0.15915494, t283, t293);
    let t295 = t289 * t294;
    let t296 = fma(0.25, t280, 1.0);
    let t297 = max(t296, 0.0);
    let t298 = min(t297, 1.125);
    let t299 = t298 * t298;
    let t300 = t299 * t299;
    let t301 = t284 * t284;
    let t302 = fma(0.23337026, t301, (-0.44878897));
    let t303 = fma(t301, t302, 0.36719096);
    let t304 = fma(t301, t303, 0.013599666);
    let t305 = fma((-0.15915494), t284, t304);
    let t306 = t300 * t305;
    let t307 = fma(0.25, t279, 1.0);
    let t308 = max(t307, 0.0);
    let t309 = min(t308, 1.125);
    let t310 = t309 * t309;
    let t311 = t310 * t310;
    let t312 = fma(0.15915494, t284, t304);
    let t313 = t311 * t312;
    let t314 = fma(0.25, t281, 1.0);
    let t315 = max(t314, 0.0);
    let t316 = min(t315, 1.125);
    let t317 = t316 * t316;
    let t318 = t317 * t317;
    let t319 = fma((-0.15915494), t283, t293);
    let t320 = t318 * t319;
    let t321 = t295 + t306;
    let t322 = t295 - t306;
    let t323 = t313 + t320;
    let t324 = t313 - t320;
    let t325 = t321 + t323;
    let t326 = t321 - t323;
    let t327 = t322 + t324;
    let t328 = t322 - t324;
    let t329 = fma(0.080026135, t325, t250);
    let t330 = fma(0.0980116, t326, t253);
    let t331 = fma(0.0980116, t327, t102);
    let t332 = fma(0.044735968, t325, t257);
    let t333 = 0.15496995 * t328;
    let t334 = fma(0.07748497, t325, t259);
    let t335 = fma((-0.037428796), t326, t265);
    let t336 = fma(0.13752218, t327, -t108);
    let t337 = fma(0.1449611, t326, -t267);
    let t338 = fma(0.059180126, t327, t110);
    let t340 = t47 * 0.54627424;
    let t342 = fma(t52, 0.4172238, t177);
    let t344 = fma(-t54, 0.3231802, t342);
    let t345 = fma(-t56, 0.3231802, t268);
    let t346 = fma(-t58, 0.4172238, t345);
    let t347 = t66 + t346;
    let t348 = t66 - t346;
    let t349 = t340 + t344;
    let t350 = t344 - t340;
    let t351 = t347 + t349;
    let t352 = t347 - t349;
    let t353 = t348 + t350;
    let t354 = t348 - t350;
    let t355 = t201 + t282;
    let t356 = t282 - t201;
    let t357 = fma(0.25, t351, 1.0);
    let t358 = max(t357, 0.0);
    let t359 = min(t358, 1.125);
    let t360 = t359 * t359;
    let t361 = t360 * t360;
    let t362 = t355 * t355;
    let t363 = fma(0.23337026, t362, (-0.44878897));
    let t364 = fma(t362, t363, 0.36719096);
    let t365 = fma(t362, t364, 0.013599666);
    let t366 = fma(0.15915494, t355, t365);
    let t367 = t361 * t366;
    let t368 = fma(0.25, t353, 1.0);
    let t369 = max(t368, 0.0);
    let t370 = min(t369, 1.125);
    let t371 = t370 * t370;
    let t372 = t371 * t371;
    let t373 = t356 * t356;
    let t374 = fma(0.23337026, t373, (-0.44878897));
    let t375 = fma(t373, t374, 0.36719096);
    let t376 = fma(t373, t375, 0.013599666);
    let t377 = fma((-0.15915494), t356, t376);
    let t378 = t372 * t377;
    let t379 = fma(0.25, t352, 1.0);
    let t380 = max(t379, 0.0);
    let t381 = min(t380, 1.125);
    let t382 = t381 * t381;
    let t383 = t382 * t382;
    let t384 = fma(0.15915494, t356, t376);
    let t385 = t383 * t384;
    let t386 = fma(0.25, t354, 1.0);
    let t387 = max(t386, 0.0);
    let t388 = min(t387, 1.125);
    let t389 = t388 * t388;
    let t390 = t389 * t389;
    let t391 = fma((-0.15915494), t355, t365);
    let t392 = t390 * t391;
    let t393 = t367 + t378;
    let t394 = t367 - t378;
    let t395 = t385 + t392;
    let t396 = t385 - t392;
    let t397 = t393 + t395;
    let t398 = t393 - t395;
    let t399 = t394 + t396;
    let t400 = t394 - t396;
    let t401 = fma(0.080026135, t397, t329);
    let t402 = fma(0.0980116, t398, t252);
    let t403 = fma(0.0980116, t399, t331);
    let t405 = t400 * 0.15496995;
    let t407 = fma(-t397, 0.089471936, t332);
    let t409 = fma(t398, 0.11836025, -t261);
    let t411 = fma(-t398, 0.09168146, t263);
    let t412 = fma(-t399, 0.09168146, t336);
    let t413 = fma(-t399, 0.11836025, t338);
    let t414 = t44 * 0.2820948;
    let t415 = t45 * 0.2820948;
    let t416 = t46 * 0.2820948;
    let t418 = t47 * 0.3641828;
    let t419 = t48 * 0.3641828;
    let t420 = t50 * 0.3641828;
    let t422 = fma(t52, 0.22710788, t414);
    let t424 = t53 * 0.55629843;
    let t426 = fma(t54, 0.17591701, t422);
    let t428 = fma(-t55, 0.28727126, t415);
    let t429 = fma(t56, 0.17591701, t416);
    let t430 = fma(-t58, 0.22710788, t429);
    let t431 = t62 + t430;
    let t432 = t62 - t430;
    let t433 = t418 + t426;
    let t434 = t426 - t418;
    let t435 = t420 + t428;
    let t436 = t428 - t420;
    let t437 = t419 + t424;
    let t438 = t419 - t424;
    let t439 = t431 + t433;
    let t440 = t431 - t433;
    let t441 = t432 + t434;
    let t442 = t432 - t434;
    let t443 = t435 + t437;
    let t444 = t435 - t437;
    let t445 = t436 + t438;
    let t446 = t436 - t438;
    let t447 = t439 + t443;
    let t448 = t439 - t443;
    let t449 = t441 + t445;
    let t450 = t441 - t445;
    let t451 = t440 + t444;
    let t452 = t440 - t444;
    let t453 = t442 + t446;
    let t454 = t442 - t446;
    let t456 = d.x * 0.57735026;
    let t457 = d.y * 0.57735026;
    let t458 = d.z * 0.57735026;
    let t459 = t456 + t457;
    let t460 = t456 - t457;
    let t461 = t458 + t459;
    let t462 = t459 - t458;
    let t463 = t458 - t460;
    let t464 = t458 + t460;
    let t465 = fma(0.25, t447, 1.0);
    let t466 = max(t465, 0.0);
    let t467 = min(t466, 1.125);
    let t468 = t467 * t467;
    let t469 = t468 * t468;
    let t470 = t461 * t461;
    let t471 = fma(0.23337026, t470, (-0.44878897));
    let t472 = fma(t470, t471, 0.36719096);
    let t473 = fma(t470, t472, 0.013599666);
    let t474 = fma(0.15915494, t461, t473);
    let t475 = t469 * t474;
    let t476 = fma(0.25, t449, 1.0);
    let t477 = max(t476, 0.0);
    let t478 = min(t477, 1.125);
    let t479 = t478 * t478;
    let t480 = t479 * t479;
    let t481 = t463 * t463;
    let t482 = fma(0.23337026, t481, (-0.44878897));
    let t483 = fma(t481, t482, 0.36719096);
    let t484 = fma(t481, t483, 0.013599666);
    let t485 = fma(0.15915494, t463, t484);
    let t486 = t480 * t485;
    let t487 = fma(0.25, t451, 1.0);
    let t488 = max(t487, 0.0);
    let t489 = min(t488, 1.125);
    let t490 = t489 * t489;
    let t491 = t490 * t490;
    let t492 = t464 * t464;
    let t493 = fma(0.23337026, t492, (-0.44878897));
    let t494 = fma(t492, t493, 0.36719096);
    let t495 = fma(t492, t494, 0.013599666);
    let t496 = fma(0.15915494, t464, t495);
    let t497 = t491 * t496;
    let t498 = fma(0.25, t453, 1.0);
    let t499 = max(t498, 0.0);
    let t500 = min(t499, 1.125);
    let t501 = t500 * t500;
    let t502 = t501 * t501;
    let t503 = t462 * t462;
    let t504 = fma(0.23337026, t503, (-0.44878897));
    let t505 = fma(t503, t504, 0.36719096);
    let t506 = fma(t503, t505, 0.013599666);
    let t507 = fma((-0.15915494), t462, t506);
    let t508 = t502 * t507;
    let t509 = fma(0.25, t448, 1.0);
    let t510 = max(t509, 0.0);
    let t511 = min(t510, 1.125);
    let t512 = t511 * t511;
    let t513 = t512 * t512;
    let t514 = fma(0.15915494, t462, t506);
    let t515 = t513 * t514;
    let t516 = fma(0.25, t450, 1.0);
    let t517 = max(t516, 0.0);
    let t518 = min(t517, 1.125);
    let t519 = t518 * t518;
    let t520 = t519 * t519;
    let t521 = fma((-0.15915494), t464, t495);
    let t522 = t520 * t521;
    let t523 = fma(0.25, t452, 1.0);
    let t524 = max(t523, 0.0);
    let t525 = min(t524, 1.125);
    let t526 = t525 * t525;
    let t527 = t526 * t526;
    let t528 = fma((-0.15915494), t463, t484);
    let t529 = t527 * t528;
    let t530 = fma(0.25, t454, 1.0);
    let t531 = max(t530, 0.0);
    let t532 = min(t531, 1.125);
    let t533 = t532 * t532;
    let t534 = t533 * t533;
    let t535 = fma((-0.15915494), t461, t473);
    let t536 = t534 * t535;
    let t537 = t475 + t486;
    let t538 = t475 - t486;
    let t539 = t497 + t508;
    let t540 = t497 - t508;
    let t541 = t515 + t522;
    let t542 = t515 - t522;
    let t543 = t529 + t536;
    let t544 = t529 - t536;
    let t545 = t537 + t539;
    let t546 = t537 - t539;
    let t547 = t538 + t540;
    let t548 = t538 - t540;
    let t549 = t541 + t543;
    let t550 = t541 - t543;
    let t551 = t542 + t544;
    let t552 = t542 - t544;
    let t553 = t545 + t549;
    let t554 = t545 - t549;
    let t555 = t547 + t551;
    let t556 = t547 - t551;
    let t557 = t546 + t550;
    let t558 = t546 - t550;
    let t559 = t548 + t552;
    let t560 = t548 - t552;
    let t562 = fma(t553, 0.0747754, t401);
    let t563 = fma(t557, 0.0747754, t402);
    let t564 = fma(t554, 0.0747754, t330);
    let t565 = fma(t555, 0.0747754, t403);
    let t567 = fma(t559, 0.096534625, t405);
    let t568 = fma(t558, 0.096534625, t255);
    let t569 = fma(t556, 0.096534625, t333);
    let t571 = fma(t557, 0.060199913, t409);
    let t573 = t560 * 0.14745907;
    let t575 = fma(t557, 0.046630654, t411);
    let t577 = fma(-t554, 0.076147534, t335);
    let t578 = fma(t555, 0.046630654, t412);
    let t579 = fma(-t555, 0.060199913, t413);
    let t581 = t44 * 0.1473192;
    let t583 = t45 * 0.4419576;
    let t584 = t46 * 0.1473192;
    let t586 = t47 * 0.09932259;
    let t588 = t48 * 0.29796776;
    let t590 = fma(t49, 0.45875138, t62);
    let t591 = t50 * 0.29796776;
    let t593 = fma(t52, 0.032346334, t581);
    let t595 = t53 * 0.23769604;
    let t597 = fma(t54, 0.42594117, t593);
    let t599 = fma(t55, 0.3682371, t583);
    let t600 = fma(t56, 0.42594117, t584);
    let t601 = fma(-t58, 0.032346334, t600);
    let t602 = t590 + t601;
    let t603 = t590 - t601;
    let t604 = t586 + t597;
    let t605 = t597 - t586;
    let t606 = t591 + t599;
    let t607 = t599 - t591;
    let t608 = t588 + t595;
    let t609 = t588 - t595;
    let t610 = t602 + t604;
    let t611 = t602 - t604;
    let t612 = t603 + t605;
    let t613 = t603 - t605;
    let t614 = t606 + t608;
    let t615 = t606 - t608;
    let t616 = t607 + t609;
    let t617 = t607 - t609;
    let t618 = t610 + t614;
    let t619 = t610 - t614;
    let t620 = t612 + t616;
    let t621 = t612 - t616;
    let t622 = t611 + t615;
    let t623 = t611 - t615;
    let t624 = t613 + t617;
    let t625 = t613 - t617;
    let t627 = d.x * 0.30151135;
    let t628 = d.y * 0.30151135;
    let t630 = d.z * 0.90453404;
    let t631 = t627 + t628;
    let t632 = t627 - t628;
    let t633 = t630 + t631;
    let t634 = t631 - t630;
    let t635 = t630 - t632;
    let t636 = t630 + t632;
    let t637 = fma(0.25, t618, 1.0);
    let t638 = max(t637, 0.0);
    let t639 = min(t638, 1.125);
    let t640 = t639 * t639;
    let t641 = t640 * t640;
    let t642 = t633 * t633;
    let t643 = fma(0.23337026, t642, (-0.44878897));
    let t644 = fma(t642, t643, 0.36719096);
    let t645 = fma(t642, t644, 0.013599666);
    let t646 = fma(0.15915494, t633, t645);
    let t647 = t641 * t646;
    let t648 = fma(0.25, t620, 1.0);
    let t649 = max(t648, 0.0);
    let t650 = min(t649, 1.125);
    let t651 = t650 * t650;
    let t652 = t651 * t651;
    let t653 = t635 * t635;
    let t654 = fma(0.23337026, t653, (-0.44878897));
    let t655 = fma(t653, t654, 0.36719096);
    let t656 = fma(t653, t655, 0.013599666);
    let t657 = fma(0.15915494, t635, t656);
    let t658 = t652 * t657;
    let t659 = fma(0.25, t622, 1.0);
    let t660 = max(t659, 0.0);
    let t661 = min(t660, 1.125);
    let t662 = t661 * t661;
    let t663 = t662 * t662;
    let t664 = t636 * t636;
    let t665 = fma(0.23337026, t664, (-0.44878897));
    let t666 = fma(t664, t665, 0.36719096);
    let t667 = fma(t664, t666, 0.013599666);
    let t668 = fma(0.15915494, t636, t667);
    let t669 = t663 * t668;
    let t670 = fma(0.25, t624, 1.0);
    let t671 = max(t670, 0.0);
    let t672 = min(t671, 1.125);
    let t673 = t672 * t672;
    let t674 = t673 * t673;
    let t675 = t634 * t634;
    let t676 = fma(0.23337026, t675, (-0.44878897));
    let t677 = fma(t675, t676, 0.36719096);
    let t678 = fma(t675, t677, 0.013599666);
    let t679 = fma((-0.15915494), t634, t678);
    let t680 = t674 * t679;
    let t681 = fma(0.25, t619, 1.0);
    let t682 = max(t681, 0.0);
    let t683 = min(t682, 1.125);
    let t684 = t683 * t683;
    let t685 = t684 * t684;
    let t686 = fma(0.15915494, t634, t678);
    let t687 = t685 * t686;
    let t688 = fma(0.25, t621, 1.0);
    let t689 = max(t688, 0.0);
    let t690 = min(t689, 1.125);
    let t691 = t690 * t690;
    let t692 = t691 * t691;
    let t693 = fma((-0.15915494), t636, t667);
    let t694 = t692 * t693;
    let t695 = fma(0.25, t623, 1.0);
    let t696 = max(t695, 0.0);
    let t697 = min(t696, 1.125);
    let t698 = t697 * t697;
    let t699 = t698 * t698;
    let t700 = fma((-0.15915494), t635, t656);
    let t701 = t699 * t700;
    let t702 = fma(0.25, t625, 1.0);
    let t703 = max(t702, 0.0);
    let t704 = min(t703, 1.125);
    let t705 = t704 * t704;
    let t706 = t705 * t705;
    let t707 = fma((-0.15915494), t633, t645);
    let t708 = t706 * t707;
    let t709 = t647 + t658;
    let t710 = t647 - t658;
    let t711 = t669 + t680;
    let t712 = t669 - t680;
    let t713 = t687 + t694;
    let t714 = t687 - t694;
    let t715 = t701 + t708;
    let t716 = t701 - t708;
    let t717 = t709 + t711;
    let t718 = t709 - t711;
    let t719 = t710 + t712;
    let t720 = t710 - t712;
    let t721 = t713 + t715;
    let t722 = t713 - t715;
    let t723 = t714 + t716;
    let t724 = t714 - t716;
    let t725 = t717 + t721;
    let t726 = t717 - t721;
    let t727 = t719 + t723;
    let t728 = t719 - t723;
    let t729 = t718 + t722;
    let t730 = t718 - t722;
    let t731 = t720 + t724;
    let t732 = t720 - t724;
    let t734 = fma(t725, 0.07151261, t562);
    let t736 = fma(t729, 0.037346244, t563);
    let t738 = fma(t726, 0.11203873, t564);
    let t739 = fma(t727, 0.037346244, t565);
    let t741 = fma(t731, 0.025178833, t567);
    let t743 = fma(t730, 0.0755365, t568);
    let t745 = fma(t725, 0.116296045, t407);
    let t746 = fma(t728, 0.0755365, t569);
    let t748 = fma(t729, 0.008199977, t571);
    let t750 = fma(t732, 0.06025728, t573);
    let t752 = fma(t729, 0.10797848, t575);
    let t754 = fma(t726, 0.09335018, t577);
    let t755 = fma(t727, 0.10797848, t578);
    let t756 = fma(-t727, 0.008199977, t579);
    let t757 = t44 * 0.4419576;
    let t758 = t45 * 0.1473192;
    let t759 = t47 * 0.29796776;
    let t761 = fma(-t49, 0.22937569, t62);
    let t762 = t50 * 0.09932259;
    let t764 = fma(-t51, 0.39729035, t761);
    let t766 = fma(-t52, 0.291117, t757);
    let t768 = t53 * 0.23769604;
    let t770 = fma(-t54, 0.22549826, t766);
    let t772 = fma(-t55, 0.28640664, t758);
    let t774 = fma(-t56, 0.075166084, t584);
    let t776 = fma(-t57, 0.31692806, t772);
    let t778 = fma(-t58, 0.42050233, t774);
    let t779 = t764 + t778;
    let t780 = t764 - t778;
    let t781 = t759 + t770;
    let t782 = t770 - t759;
    let t783 = t762 + t776;
    let t784 = t776 - t762;
    let t785 = t588 + t768;
    let t786 = t588 - t768;
    let t787 = t779 + t781;
    let t788 = t779 - t781;
    let t789 = t780 + t782;
    let t790 = t780 - t782;
    let t791 = t783 + t785;
    let t792 = t783 - t785;
    let t793 = t784 + t786;
    let t794 = t784 - t786;
    let t795 = t787 + t791;
    let t796 = t787 - t791;
    let t797 = t789 + t793;
    let t798 = t789 - t793;
    let t799 = t788 + t792;
    let t800 = t788 - t792;
    let t801 = t790 + t794;
    let t802 = t790 - t794;
    let t803 = d.y * 0.90453404;
    let t804 = d.z * 0.30151135;
    let t805 = t627 + t803;
    let t806 = t627 - t803;
    let t807 = t804 + t805;
    let t808 = t805 - t804;
    let t809 = t804 - t806;
    let t810 = t804 + t806;
    let t811 = fma(0.25, t795, 1.0);
    let t812 = max(t811, 0.0);
    let t813 = min(t812, 1.125);
    let t814 = t813 * t813;
    let t815 = t814 * t814;
    let t816 = t807 * t807;
    let t817 = fma(0.23337026, t816, (-0.44878897));
    let t818 = fma(t816, t817, 0.36719096);
    let t819 = fma(t816, t818, 0.013599666);
    let t820 = fma(0.15915494, t807, t819);
    let t821 = t815 * t820;
    let t822 = fma(0.25, t797, 1.0);
    let t823 = max(t822, 0.0);
    let t824 = min(t823, 1.125);
    let t825 = t824 * t824;
    let t826 = t825 * t825;
    let t827 = t809 * t809;
    let t828 = fma(0.23337026, t827, (-0.44878897));
    let t829 = fma(t827, t828, 0.36719096);
    let t830 = fma(t827, t829, 0.013599666);
    let t831 = fma(0.15915494, t809, t830);
    let t832 = t826 * t831;
    let t833 = fma(0.25, t799, 1.0);
    let t834 = max(t833, 0.0);
    let t835 = min(t834, 1.125);
    let t836 = t835 * t835;
    let t837 = t836 * t836;
    let t838 = t810 * t810;
    let t839 = fma(0.23337026, t838, (-0.44878897));
    let t840 = fma(t838, t839, 0.36719096);
    let t841 = fma(t838, t840, 0.013599666);
    let t842 = fma(0.15915494, t810, t841);
    let t843 = t837 * t842;
    let t844 = fma(0.25, t801, 1.0);
    let t845 = max(t844, 0.0);
    let t846 = min(t845, 1.125);
    let t847 = t846 * t846;
    let t848 = t847 * t847;
    let t849 = t808 * t808;
    let t850 = fma(0.23337026, t849, (-0.44878897));
    let t851 = fma(t849, t850, 0.36719096);
    let t852 = fma(t849, t851, 0.013599666);
    let t853 = fma((-0.15915494), t808, t852);
    let t854 = t848 * t853;
    let t855 = fma(0.25, t796, 1.0);
    let t856 = max(t855, 0.0);
    let t857 = min(t856, 1.125);
    let t858 = t857 * t857;
    let t859 = t858 * t858;
    let t860 = fma(0.15915494, t808, t852);
    let t861 = t859 * t860;
    let t862 = fma(0.25, t798, 1.0);
    let t863 = max(t862, 0.0);
    let t864 = min(t863, 1.125);
    let t865 = t864 * t864;
    let t866 = t865 * t865;
    let t867 = fma((-0.15915494), t810, t841);
    let t868 = t866 * t867;
    let t869 = fma(0.25, t800, 1.0);
    let t870 = max(t869, 0.0);
    let t871 = min(t870, 1.125);
    let t872 = t871 * t871;
    let t873 = t872 * t872;
    let t874 = fma((-0.15915494), t809, t830);
    let t875 = t873 * t874;
    let t876 = fma(0.25, t802, 1.0);
    let t877 = max(t876, 0.0);
    let t878 = min(t877, 1.125);
    let t879 = t878 * t878;
    let t880 = t879 * t879;
    let t881 = fma((-0.15915494), t807, t819);
    let t882 = t880 * t881;
    let t883 = t821 + t832;
    let t884 = t821 - t832;
    let t885 = t843 + t854;
    let t886 = t843 - t854;
    let t887 = t861 + t868;
    let t888 = t861 - t868;
    let t889 = t875 + t882;
    let t890 = t875 - t882;
    let t891 = t883 + t885;
    let t892 = t883 - t885;
    let t893 = t884 + t886;
    let t894 = t884 - t886;
    let t895 = t887 + t889;
    let t896 = t887 - t889;
    let t897 = t888 + t890;
    let t898 = t888 - t890;
    let t899 = t891 + t895;
    let t900 = t891 - t895;
    let t901 = t893 + t897;
    let t902 = t893 - t897;
    let t903 = t892 + t896;
    let t904 = t892 - t896;
    let t905 = t894 + t898;
    let t906 = t894 - t898;
    let t907 = fma(0.07151261, t899, t734);
    let t908 = fma(0.11203873, t903, t736);
    let t909 = fma(0.037346244, t900, t738);
    let t910 = fma(0.037346244, t901, t739);
    let t911 = fma(0.0755365, t905, t741);
    let t912 = fma(0.0755365, t904, t743);
    let t914 = fma(-t899, 0.058148023, t745);
    let t915 = fma(0.025178833, t902, t746);
    let t917 = fma(-t899, 0.10071533, t334);
    let t919 = fma(-t903, 0.0737998, t748);
    let t921 = fma(t906, 0.06025728, t750);
    let t923 = fma(-t903, 0.057165075, t752);
    let t925 = fma(-t900, 0.07260569, t754);
    let t927 = fma(-t901, 0.019055026, t755);
    let t929 = fma(-t900, 0.08034304, t337);
    let t931 = fma(-t901, 0.1065997, t756);
    let t932 = t46 * 0.4419576;
    let t933 = t48 * 0.09932259;
    let t934 = fma(t51, 0.39729035, t761);
    let t935 = fma(t52, 0.42050233, t581);
    let t936 = fma(-t54, 0.075166084, t935);
    let t937 = fma(-t56, 0.22549826, t932);
    let t938 = fma(t57, 0.31692806, t772);
    let t939 = fma(t58, 0.291117, t937);
    let t940 = t934 + t939;
    let t941 = t934 - t939;
    let t942 = t759 + t936;
    let t943 = t936 - t759;
    let t944 = t591 + t938;
    let t945 = t938 - t591;
    let t946 = t768 + t933;
    let t947 = t933 - t768;
    let t948 = t940 + t942;
    let t949 = t940 - t942;
    let t950 = t941 + t943;
    let t951 = t941 - t943;
    let t952 = t944 + t946;
    let t953 = t944 - t946;
    let t954 = t945 + t947;
    let t955 = t945 - t947;
    let t956 = t948 + t952;
    let t957 = t948 - t952;
    let t958 = t950 + t954;
    let t959 = t950 - t954;
    let t960 = t949 + t953;
    let t961 = t949 - t953;
    let t962 = t951 + t955;
    let t963 = t951 - t955;
    let t964 = d.x * 0.90453404;
    let t965 = t628 + t964;
    let t966 = t964 - t628;
    let t967 = t804 + t965;
    let t968 = t965 - t804;
    let t969 = t804 - t966;
    let t970 = t804 + t966;
    let t971 = fma(0.25, t956, 1.0);
    let t972 = max(t971, 0.0);
    let t973 = min(t972, 1.125);
    let t974 = t973 * t973;
    let t975 = t974 * t974;
    let t976 = t967 * t967;
    let t977 = fma(0.23337026, t976, (-0.44878897));
    let t978 = fma(t976, t977, 0.36719096);
    let t979 = fma(t976, t978, 0.013599666);
    let t980 = fma(0.15915494, t967, t979);
    let t981 = t975 * t980;
    let t982 = fma(0.25, t958, 1.0);
    let t983 = max(t982, 0.0);
    let t984 = min(t983, 1.125);
    let t985 = t984 * t984;
    let t986 = t985 * t985;
    let t987 = t969 * t969;
    let t988 = fma(0.23337026, t987, (-0.44878897));
    let t989 = fma(t987, t988, 0.36719096);
    let t990 = fma(t987, t989, 0.013599666);
    let t991 = fma(0.15915494, t969, t990);
    let t992 = t986 * t991;
    let t993 = fma(0.25, t960, 1.0);
    let t994 = max(t993, 0.0);
    let t995 = min(t994, 1.125);
    let t996 = t995 * t995;
    let t997 = t996 * t996;
    let t998 = t970 * t970;
    let t999 = fma(0.23337026, t998, (-0.44878897));
    let t1000 = fma(t998, t999, 0.36719096);
    let t1001 = fma(t998, t1000, 0.013599666);
    let t1002 = fma(0.15915494, t970, t1001);
    let t1003 = t997 * t1002;
    let t1004 = fma(0.25, t962, 1.0);
    let t1005 = max(t1004, 0.0);
    let t1006 = min(t1005, 1.125);
    let t1007 = t1006 * t1006;
    let t1008 = t1007 * t1007;
    let t1009 = t968 * t968;
    let t1010 = fma(0.23337026, t1009, (-0.44878897));
    let t1011 = fma(t1009, t1010, 0.36719096);
    let t1012 = fma(t1009, t1011, 0.013599666);
    let t1013 = fma((-0.15915494), t968, t1012);
    let t1014 = t1008 * t1013;
    let t1015 = fma(0.25, t957, 1.0);
    let t1016 = max(t1015, 0.0);
    let t1017 = min(t1016, 1.125);
    let t1018 = t1017 * t1017;
    let t1019 = t1018 * t1018;
    let t1020 = fma(0.15915494, t968, t1012);
    let t1021 = t1019 * t1020;
    let t1022 = fma(0.25, t959, 1.0);
    let t1023 = max(t1022, 0.0);
    let t1024 = min(t1023, 1.125);
    let t1025 = t1024 * t1024;
    let t1026 = t1025 * t1025;
    let t1027 = fma((-0.15915494), t970, t1001);
    let t1028 = t1026 * t1027;
    let t1029 = fma(0.25, t961, 1.0);
    let t1030 = max(t1029, 0.0);
    let t1031 = min(t1030, 1.125);
    let t1032 = t1031 * t1031;
    let t1033 = t1032 * t1032;
    let t1034 = fma((-0.15915494), t969, t990);
    let t1035 = t1033 * t1034;
    let t1036 = fma(0.25, t963, 1.0);
    let t1037 = max(t1036, 0.0);
    let t1038 = min(t1037, 1.125);
    let t1039 = t1038 * t1038;
    let t1040 = t1039 * t1039;
    let t1041 = fma((-0.15915494), t967, t979);
    let t1042 = t1040 * t1041;
    let t1043 = t981 + t992;
    let t1044 = t981 - t992;
    let t1045 = t1003 + t1014;
    let t1046 = t1003 - t1014;
    let t1047 = t1021 + t1028;
    let t1048 = t1021 - t1028;
    let t1049 = t1035 + t1042;
    let t1050 = t1035 - t1042;
    let t1051 = t1043 + t1045;
    let t1052 = t1043 - t1045;
    let t1053 = t1044 + t1046;
    let t1054 = t1044 - t1046;
    let t1055 = t1047 + t1049;
    let t1056 = t1047 - t1049;
    let t1057 = t1048 + t1050;
    let t1058 = t1048 - t1050;
    let t1059 = t1051 + t1055;
    let t1060 = t1051 - t1055;
    let t1061 = t1053 + t1057;
    let t1062 = t1053 - t1057;
    let t1063 = t1052 + t1056;
    let t1064 = t1052 - t1056;
    let t1065 = t1054 + t1058;
    let t1066 = t1054 - t1058;
    let t1067 = fma(0.07151261, t1059, t907);
    let t1068 = fma(0.037346244, t1063, t908);
    let t1069 = fma(0.037346244, t1060, t909);
    let t1070 = fma(0.11203873, t1061, t910);
    let t1071 = fma(0.0755365, t1065, t911);
    let t1072 = fma(0.025178833, t1064, t912);
    let t1073 = fma((-0.058148023), t1059, t914);
    let t1074 = fma(0.0755365, t1062, t915);
    let t1075 = fma(0.10071533, t1059, t917);
    let t1076 = fma(0.1065997, t1063, t919);
    let t1077 = fma(0.06025728, t1066, t921);
    let t1078 = fma((-0.019055026), t1063, t923);
    let t1079 = fma((-0.07260569), t1060, t925);
    let t1080 = fma((-0.057165075), t1061, t927);
    let t1081 = fma(0.08034304, t1060, t929);
    let t1082 = fma(0.0737998, t1061, t931);
    return array<f32, 16>(
        t1067, t1068, t1069, t1070, t1071, t1072, t1073, t1074, t1075, t1076, t1077, t1078, t1079,
        t1080, t1081, t1082,
    );
}

// As `transfer`, with another lobe about the unit vector `d` in the place of the cosine's: band l of it is `w[l]`, held
// in -1..1, times that of a lobe of no width, so that `w[0]` is the share of an even sky that it gives. Without
// blockers it is y_l(d) times `w[l]`.
//
// Promises for any f: the norm of the result is at most 1.602 times the lobe's at the samples, n^2/sqrt(4 pi).
// Source: As `transfer`; the lobe is of the order of `f`.
// 585 multiplications, 744 additions.
fn sh4_transfer_lobe(f: array<f32, 16>, d: vec3<f32>, w: array<f32, 4>) -> array<f32, 16> {
    let t24 = min(w[0], 1.0);
    let t25 = max(t24, (-1.0));
    let t27 = t25 * 0.07957747;
    let t28 = min(w[1], 1.0);
    let t29 = max(t28, (-1.0));
    let t31 = t29 * 0.23873241;
    let t32 = min(w[2], 1.0);
    let t33 = max(t32, (-1.0));
    let t35 = fma(-t33, 0.19894367, t27);
    let t37 = t33 * 0.596831;
    let t38 = min(w[3], 1.0);
    let t39 = max(t38, (-1.0));
    let t41 = fma(-t39, 0.8355635, t31);
    let t43 = t39 * 1.3926058;
    let t45 = f[1] * f[1];
    let t46 = fma(f[2], f[2], t45);
    let t47 = fma(f[3], f[3], t46);
    let t48 = fma(f[4], f[4], t47);
    let t49 = fma(f[5], f[5], t48);
    let t50 = fma(f[6], f[6], t49);
    let t51 = fma(f[7], f[7], t50);
    let t52 = fma(f[8], f[8], t51);
    let t53 = fma(f[9], f[9], t52);
    let t54 = fma(f[10], f[10], t53);
    let t55 = fma(f[11], f[11], t54);
    let t56 = fma(f[12], f[12], t55);
    let t57 = fma(f[13], f[13], t56);
    let t58 = fma(f[14], f[14], t57);
    let t59 = fma(f[15], f[15], t58);
    let t61 = min(t59, 1e37);
    let t63 = fma(t61, 0.009929332, 1.0);
    let t64 = sqrt(t63);
    let t65 = 1.0 / t64;
    let t66 = f[0] * t65;
    let t67 = f[1] * t65;
    let t68 = f[2] * t65;
    let t69 = f[3] * t65;
    let t70 = f[4] * t65;
    let t71 = f[5] * t65;
    let t72 = f[6] * t65;
    let t73 = f[7] * t65;
    let t74 = f[8] * t65;
    let t75 = f[9] * t65;
    let t76 = f[10] * t65;
    let t77 = f[11] * t65;
    let t78 = f[12] * t65;
    let t79 = f[13] * t65;
    let t80 = f[14] * t65;
    let t81 = f[15] * t65;
    let t85 = t66 * 0.2820948;
    let t87 = t69 * 0.48860252;
    let t89 = fma(-t72, 0.31539157, t85);
    let t91 = fma(t74, 0.54627424, t89);
    let t93 = fma(-t79, 0.4570458, t87);
    let t95 = fma(t81, 0.5900436, t93);
    let t96 = t91 + t95;
    let t97 = t91 - t95;
    let t98 = fma(0.25, t96, 1.0);
    let t99 = max(t98, 0.0);
    let t100 = min(t99, 1.125);
    let t101 = t100 * t100;
    let t102 = t101 * t101;
    let t103 = fma(d.x, t43, t37);
    let t104 = fma(d.x, t103, t41);
    let t105 = fma(d.x, t104, t35);
    let t106 = t102 * t105;
    let t107 = fma(0.25, t97, 1.0);
    let t108 = max(t107, 0.0);
    let t109 = min(t108, 1.125);
    let t110 = t109 * t109;
    let t111 = t110 * t110;
    let t112 = fma(-d.x, t43, t37);
    let t113 = fma(-d.x, t112, t41);
    let t114 = fma(-d.x, t113, t35);
    let t115 = t111 * t114;
    let t116 = t106 + t115;
    let t117 = t106 - t115;
    let t119 = t116 * 0.0450147;
    let t121 = t117 * 0.07796775;
    let t123 = t116 * 0.050327964;
    let t125 = t116 * 0.08717059;
    let t127 = t117 * 0.072932154;
    let t129 = t117 * 0.094155;
    let t130 = t67 * 0.48860252;
    let t131 = fma(-t74, 0.54627424, t89);
    let t132 = fma(-t75, 0.5900436, t130);
    let t133 = fma(-t77, 0.4570458, t132);
    let t134 = t131 + t133;
    let t135 = t131 - t133;
    let t136 = fma(0.25, t134, 1.0);
    let t137 = max(t136, 0.0);
    let t138 = min(t137, 1.125);
    let t139 = t138 * t138;
    let t140 = t139 * t139;
    let t141 = fma(d.y, t43, t37);
    let t142 = fma(d.y, t141, t41);
    let t143 = fma(d.y, t142, t35);
    let t144 = t140 * t143;
    let t145 = fma(0.25, t135, 1.0);
    let t146 = max(t145, 0.0);
    let t147 = min(t146, 1.125);
    let t148 = t147 * t147;
    let t149 = t148 * t148;
    let t150 = fma(-d.y, t43, t37);
    let t151 = fma(-d.y, t150, t41);
    let t152 = fma(-d.y, t151, t35);
    let t153 = t149 * t152;
    let t154 = t144 + t153;
    let t155 = t144 - t153;
    let t156 = fma(0.0450147, t154, t119);
    let t157 = 0.07796775 * t155;
    let t158 = fma(0.050327964, t154, t123);
    let t159 = fma((-0.08717059), t154, t125);
    let t160 = 0.094155 * t155;
    let t161 = 0.072932154 * t155;
    let t162 = t68 * 0.48860252;
    let t164 = fma(t72, 0.63078314, t85);
    let t166 = fma(t78, 0.7463527, t162);
    let t167 = t164 + t166;
    let t168 = t164 - t166;
    let t169 = fma(0.25, t167, 1.0);
    let t170 = max(t169, 0.0);
    let t171 = min(t170, 1.125);
    let t172 = t171 * t171;
    let t173 = t172 * t172;
    let t174 = fma(d.z, t43, t37);
    let t175 = fma(d.z, t174, t41);
    let t176 = fma(d.z, t175, t35);
    let t177 = t173 * t176;
    let t178 = fma(0.25, t168, 1.0);
    let t179 = max(t178, 0.0);
    let t180 = min(t179, 1.125);
    let t181 = t180 * t180;
    let t182 = t181 * t181;
    let t183 = fma(-d.z, t43, t37);
    let t184 = fma(-d.z, t183, t41);
    let t185 = fma(-d.z, t184, t35);
    let t186 = t182 * t185;
    let t187 = t177 + t186;
    let t188 = t177 - t186;
    let t189 = fma(0.0450147, t187, t156);
    let t190 = 0.07796775 * t188;
    let t192 = fma(t187, 0.10065593, -t158);
    let t194 = t188 * 0.1190977;
    let t196 = t67 * 0.34549415;
    let t197 = t68 * 0.34549415;
    let t198 = t71 * 0.54627424;
    let t200 = fma(t72, 0.15769579, t85);
    let t202 = fma(-t74, 0.27313712, t200);
    let t204 = fma(-t75, 0.2086119, t196);
    let t206 = fma(t77, 0.48477027, t204);
    let t208 = fma(-t78, 0.13193776, t197);
    let t210 = fma(-t80, 0.51099277, t208);
    let t211 = t202 + t206;
    let t212 = t202 - t206;
    let t213 = t198 + t210;
    let t214 = t210 - t198;
    let t215 = t211 + t213;
    let t216 = t211 - t213;
    let t217 = t212 + t214;
    let t218 = t212 - t214;
    let t220 = d.y * 0.70710677;
    let t221 = d.z * 0.70710677;
    let t222 = t220 + t221;
    let t223 = t220 - t221;
    let t224 = fma(0.25, t215, 1.0);
    let t225 = max(t224, 0.0);
    let t226 = min(t225, 1.125);
    let t227 = t226 * t226;
    let t228 = t227 * t227;
    let t229 = fma(t43, t222, t37);
    let t230 = fma(t222, t229, t41);
    let t231 = fma(t222, t230, t35);
    let t232 = t228 * t231;
    let t233 = fma(0.25, t217, 1.0);
    let t234 = max(t233, 0.0);
    let t235 = min(t234, 1.125);
    let t236 = t235 * t235;
    let t237 = t236 * t236;
    let t238 = fma(-t43, t223, t37);
    let t239 = fma(-t223, t238, t41);
    let t240 = fma(-t223, t239, t35);
    let t241 = t237 * t240;
    let t242 = fma(0.25, t216, 1.0);
    let t243 = max(t242, 0.0);
    let t244 = min(t243, 1.125);
    let t245 = t244 * t244;
    let t246 = t245 * t245;
    let t247 = fma(t43, t223, t37);
    let t248 = fma(t223, t247, t41);
    let t249 = fma(t223, t248, t35);
    let t250 = t246 * t249;
    let t251 = fma(0.25, t218, 1.0);
    let t252 = max(t251, 0.0);
    let t253 = min(t252, 1.125);
    let t254 = t253 * t253;
    let t255 = t254 * t254;
    let t256 = fma(-t43, t222, t37);
    let t257 = fma(-t222, t256, t41);
    let t258 = fma(-t222, t257, t35);
    let t259 = t255 * t258;
    let t260 = t232 + t241;
    let t261 = t232 - t241;
    let t262 = t250 + t259;
    let t263 = t250 - t259;
    let t264 = t260 + t262;
    let t265 = t260 - t262;
    let t266 = t261 + t263;
    let t267 = t261 - t263;
    let t269 = fma(t264, 0.080026135, t189);
    let t271 = fma(t266, 0.0980116, t157);
    let t272 = fma(t265, 0.0980116, t190);
    let t274 = t267 * 0.15496995;
    let t276 = fma(t264, 0.044735968, t192);
    let t278 = fma(-t264, 0.07748497, t159);
    let t280 = fma(t266, 0.059180126, t160);
    let t282 = fma(t266, 0.13752218, -t161);
    let t284 = fma(-t265, 0.037428796, t194);
    let t286 = t265 * 0.1449611;
    let t287 = t69 * 0.34549415;
    let t288 = t73 * 0.54627424;
    let t289 = fma(t74, 0.27313712, t200);
    let t290 = fma(t79, 0.48477027, t287);
    let t291 = fma(t80, 0.51099277, t208);
    let t292 = fma(t81, 0.2086119, t290);
    let t293 = t289 + t292;
    let t294 = t289 - t292;
    let t295 = t288 + t291;
    let t296 = t291 - t288;
    let t297 = t293 + t295;
    let t298 = t293 - t295;
    let t299 = t294 + t296;
    let t300 = t294 - t296;
    let t301 = d.x * 0.70710677;
    let t302 = t221 + t301;
    let t303 = t301 - t221;
    let t304 = fma(0.25, t297, 1.0);
    let t305 = max(t304, 0.0);
    let t306 = min(t305, 1.125);
    let t307 = t306 * t306;
    let t308 = t307 * t307;
    let t309 = fma(t43, t302, t37);
    let t310 = fma(t302, t309, t41);
    let t311 = fma(t302, t310, t35);
    let t312 = t308 * t311;
    let t313 = fma(0.25, t299, 1.0);
    let t314 = max(t313, 0.0);
    let t315 = min(t314, 1.125);
    let t316 = t315 * t315;
    let t317 = t316 * t316;
    let t318 = fma(-t43, t303, t37);
    let t319 = fma(-t303, t318, t41);
    let t320 = fma(-t303, t319, t35);
    let t321 = t317 * t320;
    let t322 = fma(0.25, t298, 1.0);
    let t323 = max(t322, 0.0);
    let t324 = min(t323, 1.125);
    let t325 = t324 * t324;
    let t326 = t325 * t325;
    let t327 = fma(t43, t303, t37);
    let t328 = fma(t303, t327, t41);
    let t329 = fma(t303, t328, t35);
    let t330 = t326 * t329;
    let t331 = fma(0.25, t300, 1.0);
    let t332 = max(t331, 0.0);
    let t333 = min(t332, 1.125);
    let t334 = t333 * t333;
    let t335 = t334 * t334;
    let t336 = fma(-t43, t302, t37);
    let t337 = fma(-t302, t336, t41);
    let t338 = fma(-t302, t337, t35);
    let t339 = t335 * t338;
    let t340 = t312 + t321;
    let t341 = t312 - t321;
    let t342 = t330 + t339;
    let t343 = t330 - t339;
    let t344 = t340 + t342;
    let t345 = t340 - t342;
    let t346 = t341 + t343;
    let t347 = t341 - t343;
    let t348 = fma(0.080026135, t344, t269);
    let t349 = fma(0.0980116, t345, t272);
    let t350 = fma(0.0980116, t346, t121);
    let t351 = fma(0.044735968, t344, t276);
    let t352 = 0.15496995 * t347;
    let t353 = fma(0.07748497, t344, t278);
    let t354 = fma((-0.037428796), t345, t284);
    let t355 = fma(0.13752218, t346, -t127);
    let t356 = fma(0.1449611, t345, -t286);
    let t357 = fma(0.059180126, t346, t129);
    let t359 = t70 * 0.54627424;
    let t361 = fma(t75, 0.4172238, t196);
    let t363 = fma(-t77, 0.3231802, t361);
    let t364 = fma(-t79, 0.3231802, t287);
    let t365 = fma(-t81, 0.4172238, t364);
    let t366 = t89 + t365;
    let t367 = t89 - t365;
    let t368 = t359 + t363;
    let t369 = t363 - t359;
    let t370 = t366 + t368;
    let t371 = t366 - t368;
    let t372 = t367 + t369;
    let t373 = t367 - t369;
    let t374 = t220 + t301;
    let t375 = t301 - t220;
    let t376 = fma(0.25, t370, 1.0);
    let t377 = max(t376, 0.0);
    let t378 = min(t377, 1.125);
    let t379 = t378 * t378;
    let t380 = t379 * t379;
    let t381 = fma(t43, t374, t37);
    let t382 = fma(t374, t381, t41);
    let t383 = fma(t374, t382, t35);
    let t384 = t380 * t383;
    let t385 = fma(0.25, t372, 1.0);
    let t386 = max(t385, 0.0);
    let t387 = min(t386, 1.125);
    let t388 = t387 * t387;
    let t389 = t388 * t388;
    let t390 = fma(-t43, t375, t37);
    let t391 = fma(-t375, t390, t41);
    let t392 = fma(-t375, t391, t35);
    let t393 = t389 * t392;
    let t394 = fma(0.25, t371, 1.0);
    let t395 = max(t394, 0.0);
    let t396 = min(t395, 1.125);
    let t397 = t396 * t396;
    let t398 = t397 * t397;
    let t399 = fma(t43, t375, t37);
    let t400 = fma(t375, t399, t41);
    let t401 = fma(t375, t400, t35);
    let t402 = t398 * t401;
    let t403 = fma(0.25, t373, 1.0);
    let t404 = max(t403, 0.0);
    let t405 = min(t404, 1.125);
    let t406 = t405 * t405;
    let t407 = t406 * t406;
    let t408 = fma(-t43, t374, t37);
    let t409 = fma(-t374, t408, t41);
    let t410 = fma(-t374, t409, t35);
    let t411 = t407 * t410;
    let t412 = t384 + t393;
    let t413 = t384 - t393;
    let t414 = t402 + t411;
    let t415 = t402 - t411;
    let t416 = t412 + t414;
    let t417 = t412 - t414;
    let t418 = t413 + t415;
    let t419 = t413 - t415;
    let t420 = fma(0.080026135, t416, t348);
    let t421 = fma(0.0980116, t417, t271);
    let t422 = fma(0.0980116, t418, t350);
    let t424 = t419 * 0.15496995;
    let t426 = fma(-t416, 0.089471936, t351);
    let t428 = fma(t417, 0.11836025, -t280);
    let t430 = fma(-t417, 0.09168146, t282);
    let t431 = fma(-t418, 0.09168146, t355);
    let t432 = fma(-t418, 0.11836025, t357);
    let t433 = t67 * 0.2820948;
    let t434 = t68 * 0.2820948;
    let t435 = t69 * 0.2820948;
    let t437 = t70 * 0.3641828;
    let t438 = t71 * 0.3641828;
    let t439 = t73 * 0.3641828;
    let t441 = fma(t75, 0.22710788, t433);
    let t443 = t76 * 0.55629843;
    let t445 = fma(t77, 0.17591701, t441);
    let t447 = fma(-t78, 0.28727126, t434);
    let t448 = fma(t79, 0.17591701, t435);
    let t449 = fma(-t81, 0.22710788, t448);
    let t450 = t85 + t449;
    let t451 = t85 - t449;
    let t452 = t437 + t445;
    let t453 = t445 - t437;
    let t454 = t439 + t447;
    let t455 = t447 - t439;
    let t456 = t438 + t443;
    let t457 = t438 - t443;
    let t458 = t450 + t452;
    let t459 = t450 - t452;
    let t460 = t451 + t453;
    let t461 = t451 - t453;
    let t462 = t454 + t456;
    let t463 = t454 - t456;
    let t464 = t455 + t457;
    let t465 = t455 - t457;
    let t466 = t458 + t462;
    let t467 = t458 - t462;
    let t468 = t460 + t464;
    let t469 = t460 - t464;
    let t470 = t459 + t463;
    let t471 = t459 - t463;
    let t472 = t461 + t465;
    let t473 = t461 - t465;
    let t475 = d.x * 0.57735026;
    let t476 = d.y * 0.57735026;
    let t477 = d.z * 0.57735026;
    let t478 = t475 + t476;
    let t479 = t475 - t476;
    let t480 = t477 + t478;
    let t481 = t478 - t477;
    let t482 = t477 - t479;
    let t483 = t477 + t479;
    let t484 = fma(0.25, t466, 1.0);
    let t485 = max(t484, 0.0);
    let t486 = min(t485, 1.125);
    let t487 = t486 * t486;
    let t488 = t487 * t487;
    let t489 = fma(t43, t480, t37);
    let t490 = fma(t480, t489, t41);
    let t491 = fma(t480, t490, t35);
    let t492 = t488 * t491;
    let t493 = fma(0.25, t468, 1.0);
    let t494 = max(t493, 0.0);
    let t495 = min(t494, 1.125);
    let t496 = t495 * t495;
    let t497 = t496 * t496;
    let t498 = fma(t43, t482, t37);
    let t499 = fma(t482, t498, t41);
    let t500 = fma(t482, t499, t35);
    let t501 = t497 * t500;
    let t502 = fma(0.25, t470, 1.0);
    let t503 = max(t502, 0.0);
    let t504 = min(t503, 1.125);
    let t505 = t504 * t504;
    let t506 = t505 * t505;
    let t507 = fma(t43, t483, t37);
    let t508 = fma(t483, t507, t41);
    let t509 = fma(t483, t508, t35);
    let t510 = t506 * t509;
    let t511 = fma(0.25, t472, 1.0);
    let t512 = max(t511, 0.0);
    let t513 = min(t512, 1.125);
    let t514 = t513 * t513;
    let t515 = t514 * t514;
    let t516 = fma(-t43, t481, t37);
    let t517 = fma(-t481, t516, t41);
    let t518 = fma(-t481, t517, t35);
    let t519 = t515 * t518;
    let t520 = fma(0.25, t467, 1.0);
    let t521 = max(t520, 0.0);
    let t522 = min(t521, 1.125);
    let t523 = t522 * t522;
    let t524 = t523 * t523;
    let t525 = fma(t43, t481, t37);
    let t526 = fma(t481, t525, t41);
    let t527 = fma(t481, t526, t35);
    let t528 = t524 * t527;
    let t529 = fma(0.25, t469, 1.0);
    let t530 = max(t529, 0.0);
    let t531 = min(t530, 1.125);
    let t532 = t531 * t531;
    let t533 = t532 * t532;
    let t534 = fma(-t43, t483, t37);
    let t535 = fma(-t483, t534, t41);
    let t536 = fma(-t483, t535, t35);
    let t537 = t533 * t536;
    let t538 = fma(0.25, t471, 1.0);
    let t539 = max(t538, 0.0);
    let t540 = min(t539, 1.125);
    let t541 = t540 * t540;
    let t542 = t541 * t541;
    let t543 = fma(-t43, t482, t37);
    let t544 = fma(-t482, t543, t41);
    let t545 = fma(-t482, t544, t35);
    let t546 = t542 * t545;
    let t547 = fma(0.25, t473, 1.0);
    let t548 = max(t547, 0.0);
    let t549 = min(t548, 1.125);
    let t550 = t549 * t549;
    let t551 = t550 * t550;
    let t552 = fma(-t43, t480, t37);
    let t553 = fma(-t480, t552, t41);
    let t554 = fma(-t480, t553, t35);
    let t555 = t551 * t554;
    let t556 = t492 + t501;
    let t557 = t492 - t501;
    let t558 = t510 + t519;
    let t559 = t510 - t519;
    let t560 = t528 + t537;
    let t561 = t528 - t537;
    let t562 = t546 + t555;
    let t563 = t546 - t555;
    let t564 = t556 + t558;
    let t565 = t556 - t558;
    let t566 = t557 + t559;
    let t567 = t557 - t559;
    let t568 = t560 + t562;
    let t569 = t560 - t562;
    let t570 = t561 + t563;
    let t571 = t561 - t563;
    let t572 = t564 + t568;
    let t573 = t564 - t568;
    let t574 = t566 + t570;
    let t575 = t566 - t570;
    let t576 = t565 + t569;
    let t577 = t565 - t569;
    let t578 = t567 + t571;
    let t579 = t567 - t571;
    let t581 = fma(t572, 0.0747754, t420);
    let t582 = fma(t576, 0.0747754, t421);
    let t583 = fma(t573, 0.0747754, t349);
    let t584 = fma(t574, 0.0747754, t422);
    let t586 = fma(t578, 0.096534625, t424);
    let t587 = fma(t577, 0.096534625, t274);
    let t588 = fma(t575, 0.096534625, t352);
    let t590 = fma(t576, 0.060199913, t428);
    let t592 = t579 * 0.14745907;
    let t594 = fma(t576, 0.046630654, t430);
    let t596 = fma(-t573, 0.076147534, t354);
    let t597 = fma(t574, 0.046630654, t431);
    let t598 = fma(-t574, 0.060199913, t432);
    let t600 = t67 * 0.1473192;
    let t602 = t68 * 0.4419576;
    let t603 = t69 * 0.1473192;
    let t605 = t70 * 0.09932259;
    let t607 = t71 * 0.29796776;
    let t609 = fma(t72, 0.45875138, t85);
    let t610 = t73 * 0.29796776;
    let t612 = fma(t75, 0.032346334, t600);
    let t614 = t76 * 0.23769604;
    let t616 = fma(t77, 0.42594117, t612);
    let t618 = fma(t78, 0.3682371, t602);
    let t619 = fma(t79, 0.42594117, t603);
    let t620 = fma(-t81, 0.032346334, t619);
    let t621 = t609 + t620;
    let t622 = t609 - t620;
    let t623 = t605 + t616;
    let t624 = t616 - t605;
    let t625 = t610 + t618;
    let t626 = t618 - t610;
    let t627 = t607 + t614;
    let t628 = t607 - t614;
    let t629 = t621 + t623;
    let t630 = t621 - t623;
    let t631 = t622 + t624;
    let t632 = t622 - t624;
    let t633 = t625 + t627;
    let t634 = t625 - t627;
    let t635 = t626 + t628;
    let t636 = t626 - t628;
    let t637 = t629 + t633;
    let t638 = t629 - t633;
    let t639 = t631 + t635;
    let t640 = t631 - t635;
    let t641 = t630 + t634;
    let t642 = t630 - t634;
    let t643 = t632 + t636;
    let t644 = t632 - t636;
    let t646 = d.x * 0.30151135;
    let t647 = d.y * 0.30151135;
    let t649 = d.z * 0.90453404;
    let t650 = t646 + t647;
    let t651 = t646 - t647;
    let t652 = t649 + t650;
    let t653 = t650 - t649;
    let t654 = t649 - t651;
    let t655 = t649 + t651;
    let t656 = fma(0.25, t637, 1.0);
    let t657 = max(t656, 0.0);
    let t658 = min(t657, 1.125);
    let t659 = t658 * t658;
    let t660 = t659 * t659;
    let t661 = fma(t43, t652, t37);
    let t662 = fma(t652, t661, t41);
    let t663 = fma(t652, t662, t35);
    let t664 = t660 * t663;
    let t665 = fma(0.25, t639, 1.0);
    let t666 = max(t665, 0.0);
    let t667 = min(t666, 1.125);
    let t668 = t667 * t667;
    let t669 = t668 * t668;
    let t670 = fma(t43, t654, t37);
    let t671 = fma(t654, t670, t41);
    let t672 = fma(t654, t671, t35);
    let t673 = t669 * t672;
    let t674 = fma(0.25, t641, 1.0);
    let t675 = max(t674, 0.0);
    let t676 = min(t675, 1.125);
    let t677 = t676 * t676;
    let t678 = t677 * t677;
    let t679 = fma(t43, t655, t37);
    let t680 = fma(t655, t679, t41);
    let t681 = fma(t655, t680, t35);
    let t682 = t678 * t681;
    let t683 = fma(0.25, t643, 1.0);
    let t684 = max(t683, 0.0);
    let t685 = min(t684, 1.125);
    let t686 = t685 * t685;
    let t687 = t686 * t686;
    let t688 = fma(-t43, t653, t37);
    let t689 = fma(-t653, t688, t41);
    let t690 = fma(-t653, t689, t35);
    let t691 = t687 * t690;
    let t692 = fma(0.25, t638, 1.0);
    let t693 = max(t692, 0.0);
    let t694 = min(t693, 1.125);
    let t695 = t694 * t694;
    let t696 = t695 * t695;
    let t697 = fma(t43, t653, t37);
    let t698 = fma(t653, t697, t41);
    let t699 = fma(t653, t698, t35);
    let t700 = t696 * t699;
    let t701 = fma(0.25, t640, 1.0);
    let t702 = max(t701, 0.0);
    let t703 = min(t702, 1.125);
    let t704 = t703 * t703;
    let t705 = t704 * t704;
    let t706 = fma(-t43, t655, t37);
    let t707 = fma(-t655, t706, t41);
    let t708 = fma(-t655, t707, t35);
    let t709 = t705 * t708;
    let t710 = fma(0.25, t642, 1.0);
    let t711 = max(t710, 0.0);
    let t712 = min(t711, 1.125);
    let t713 = t712 * t712;
    let t714 = t713 * t713;
    let t715 = fma(-t43, t654, t37);
    let t716 = fma(-t654, t715, t41);
    let t717 = fma(-t654, t716, t35);
    let t718 = t714 * t717;
    let t719 = fma(0.25, t644, 1.0);
    let t720 = max(t719, 0.0);
    let t721 = min(t720, 1.125);
    let t722 = t721 * t721;
    let t723 = t722 * t722;
    let t724 = fma(-t43, t652, t37);
    let t725 = fma(-t652, t724, t41);
    let t726 = fma(-t652, t725, t35);
    let t727 = t723 * t726;
    let t728 = t664 + t673;
    let t729 = t664 - t673;
    let t730 = t682 + t691;
    let t731 = t682 - t691;
    let t732 = t700 + t709;
    let t733 = t700 - t709;
    let t734 = t718 + t727;
    let t735 = t718 - t727;
    let t736 = t728 + t730;
    let t737 = t728 - t730;
    let t738 = t729 + t731;
    let t739 = t729 - t731;
    let t740 = t732 + t734;
    let t741 = t732 - t734;
    let t742 = t733 + t735;
    let t743 = t733 - t735;
    let t744 = t736 + t740;
    let t745 = t736 - t740;
    let t746 = t738 + t742;
    let t747 = t738 - t742;
    let t748 = t737 + t741;
    let t749 = t737 - t741;
    let t750 = t739 + t743;
    let t751 = t739 - t743;
    let t753 = fma(t744, 0.07151261, t581);
    let t755 = fma(t748, 0.037346244, t582);
    let t757 = fma(t745, 0.11203873, t583);
    let t758 = fma(t746, 0.037346244, t584);
    let t760 = fma(t750, 0.025178833, t586);
    let t762 = fma(t749, 0.0755365, t587);
    let t764 = fma(t744, 0.116296045, t426);
    let t765 = fma(t747, 0.0755365, t588);
    let t767 = fma(t748, 0.008199977, t590);
    let t769 = fma(t751, 0.06025728, t592);
    let t771 = fma(t748, 0.10797848, t594);
    let t773 = fma(t745, 0.09335018, t596);
    let t774 = fma(t746, 0.10797848, t597);
    let t775 = fma(-t746, 0.008199977, t598);
    let t776 = t67 * 0.4419576;
    let t777 = t68 * 0.1473192;
    let t778 = t70 * 0.29796776;
    let t780 = fma(-t72, 0.22937569, t85);
    let t781 = t73 * 0.09932259;
    let t783 = fma(-t74, 0.39729035, t780);
    let t785 = fma(-t75, 0.291117, t776);
    let t787 = t76 * 0.23769604;
    let t789 = fma(-t77, 0.22549826, t785);
    let t791 = fma(-t78, 0.28640664, t777);
    let t793 = fma(-t79, 0.075166084, t603);
    let t795 = fma(-t80, 0.31692806, t791);
    let t797 = fma(-t81, 0.42050233, t793);
    let t798 = t783 + t797;
    let t799 = t783 - t797;
    let t800 = t778 + t789;
    let t801 = t789 - t778;
    let t802 = t781 + t795;
    let t803 = t795 - t781;
    let t804 = t607 + t787;
    let t805 = t607 - t787;
    let t806 = t798 + t800;
    let t807 = t798 - t800;
    let t808 = t799 + t801;
    let t809 = t799 - t801;
    let t810 = t802 + t804;
    let t811 = t802 - t804;
    let t812 = t803 + t805;
    let t813 = t803 - t805;
    let t814 = t806 + t810;
    let t815 = t806 - t810;
    let t816 = t808 + t812;
    let t817 = t808 - t812;
    let t818 = t807 + t811;
    let t819 = t807 - t811;
    let t820 = t809 + t813;
    let t821 = t809 - t813;
    let t822 = d.y * 0.90453404;
    let t823 = d.z * 0.30151135;
    let t824 = t646 + t822;
    let t825 = t646 - t822;
    let t826 = t823 + t824;
    let t827 = t824 - t823;
    let t828 = t823 - t825;
    let t829 = t823 + t825;
    let t830 = fma(0.25, t814, 1.0);
    let t831 = max(t830, 0.0);
    let t832 = min(t831, 1.125);
    let t833 = t832 * t832;
    let t834 = t833 * t833;
    let t835 = fma(t43, t826, t37);
    let t836 = fma(t826, t835, t41);
    let t837 = fma(t826, t836, t35);
    let t838 = t834 * t837;
    let t839 = fma(0.25, t816, 1.0);
    let t840 = max(t839, 0.0);
    let t841 = min(t840, 1.125);
    let t842 = t841 * t841;
    let t843 = t842 * t842;
    let t844 = fma(t43, t828, t37);
    let t845 = fma(t828, t844, t41);
    let t846 = fma(t828, t845, t35);
    let t847 = t843 * t846;
    let t848 = fma(0.25, t818, 1.0);
    let t849 = max(t848, 0.0);
    let t850 = min(t849, 1.125);
    let t851 = t850 * t850;
    let t852 = t851 * t851;
    let t853 = fma(t43, t829, t37);
    let t854 = fma(t829, t853, t41);
    let t855 = fma(t829, t854, t35);
    let t856 = t852 * t855;
    let t857 = fma(0.25, t820, 1.0);
    let t858 = max(t857, 0.0);
    let t859 = min(t858, 1.125);
    let t860 = t859 * t859;
    let t861 = t860 * t860;
    let t862 = fma(-t43, t827, t37);
    let t863 = fma(-t827, t862, t41);
    let t864 = fma(-t827, t863, t35);
    let t865 = t861 * t864;
    let t866 = fma(0.25, t815, 1.0);
    let t867 = max(t866, 0.0);
    let t868 = min(t867, 1.125);
    let t869 = t868 * t868;
    let t870 = t869 * t869;
    let t871 = fma(t43, t827, t37);
    let t872 = fma(t827, t871, t41);
    let t873 = fma(t827, t872, t35);
    let t874 = t870 * t873;
    let t875 = fma(0.25, t817, 1.0);
    let t876 = max(t875, 0.0);
    let t877 = min(t876, 1.125);
    let t878 = t877 * t877;
    let t879 = t878 * t878;
    let t880 = fma(-t43, t829, t37);
    let t881 = fma(-t829, t880, t41);
    let t882 = fma(-t829, t881, t35);
    let t883 = t879 * t882;
    let t884 = fma(0.25, t819, 1.0);
    let t885 = max(t884, 0.0);
    let t886 = min(t885, 1.125);
    let t887 = t886 * t886;
    let t888 = t887 * t887;
    let t889 = fma(-t43, t828, t37);
    let t890 = fma(-t828, t889, t41);
    let t891 = fma(-t828, t890, t35);
    let t892 = t888 * t891;
    let t893 = fma(0.25, t821, 1.0);
    let t894 = max(t893, 0.0);
    let t895 = min(t894, 1.125);
    let t896 = t895 * t895;
    let t897 = t896 * t896;
    let t898 = fma(-t43, t826, t37);
    let t899 = fma(-t826, t898, t41);
    let t900 = fma(-t826, t899, t35);
    let t901 = t897 * t900;
    let t902 = t838 + t847;
    let t903 = t838 - t847;
    let t904 = t856 + t865;
    let t905 = t856 - t865;
    let t906 = t874 + t883;
    let t907 = t874 - t883;
    let t908 = t892 + t901;
    let t909 = t892 - t901;
    let t910 = t902 + t904;
    let t911 = t902 - t904;
    let t912 = t903 + t905;
    let t913 = t903 - t905;
    let t914 = t906 + t908;
    let t915 = t906 - t908;
    let t916 = t907 + t909;
    let t917 = t907 - t909;
    let t918 = t910 + t914;
    let t919 = t910 - t914;
    let t920 = t912 + t916;
    let t921 = t912 - t916;
    let t922 = t911 + t915;
    let t923 = t911 - t915;
    let t924 = t913 + t917;
    let t925 = t913 - t917;
    let t926 = fma(0.07151261, t918, t753);
    let t927 = fma(0.11203873, t922, t755);
    let t928 = fma(0.037346244, t919, t757);
    let t929 = fma(0.037346244, t920, t758);
    let t930 = fma(0.0755365, t924, t760);
    let t931 = fma(0.0755365, t923, t762);
    let t933 = fma(-t918, 0.058148023, t764);
    let t934 = fma(0.025178833, t921, t765);
    let t936 = fma(-t918, 0.10071533, t353);
    let t938 = fma(-t922, 0.0737998, t767);
    let t940 = fma(t925, 0.06025728, t769);
    let t942 = fma(-t922, 0.057165075, t771);
    let t944 = fma(-t919, 0.07260569, t773);
    let t946 = fma(-t920, 0.019055026, t774);
    let t948 = fma(-t919, 0.08034304, t356);
    let t950 = fma(-t920, 0.1065997, t775);
    let t951 = t69 * 0.4419576;
    let t952 = t71 * 0.09932259;
    let t953 = fma(t74, 0.39729035, t780);
    let t954 = fma(t75, 0.42050233, t600);
    let t955 = fma(-t77, 0.075166084, t954);
    let t956 = fma(-t79, 0.22549826, t951);
    let t957 = fma(t80, 0.31692806, t791);
    let t958 = fma(t81, 0.291117, t956);
    let t959 = t953 + t958;
    let t960 = t953 - t958;
    let t961 = t778 + t955;
    let t962 = t955 - t778;
    let t963 = t610 + t957;
    let t964 = t957 - t610;
    let t965 = t787 + t952;
    let t966 = t952 - t787;
    let t967 = t959 + t961;
    let t968 = t959 - t961;
    let t969 = t960 + t962;
    let t970 = t960 - t962;
    let t971 = t963 + t965;
    let t972 = t963 - t965;
    let t973 = t964 + t966;
    let t974 = t964 - t966;
    let t975 = t967 + t971;
    let t976 = t967 - t971;
    let t977 = t969 + t973;
    let t978 = t969 - t973;
    let t979 = t968 + t972;
    let t980 = t968 - t972;
    let t981 = t970 + t974;
    let t982 = t970 - t974;
    let t983 = d.x * 0.90453404;
    let t984 = t647 + t983;
    let t985 = t983 - t647;
    let t986 = t823 + t984;
    let t987 = t984 - t823;
    let t988 = t823 - t985;
    let t989 = t823 + t985;
    let t990 = fma(0.25, t975, 1.0);
    let t991 = max(t990, 0.0);
    let t992 = min(t991, 1.125);
    let t993 = t992 * t992;
    let t994 = t993 * t993;
    let t995 = fma(t43, t986, t37);
    let t996 = fma(t986, t995, t41);
    let t997 = fma(t986, t996, t35);
    let t998 = t994 * t997;
    let t999 = fma(0.25, t977, 1.0);
    let t1000 = max(t999, 0.0);
    let t1001 = min(t1000, 1.125);
    let t1002 = t1001 * t1001;
    let t1003 = t1002 * t1002;
    let t1004 = fma(t43, t988, t37);
    let t1005 = fma(t988, t1004, t41);
    let t1006 = fma(t988, t1005, t35);
    let t1007 = t1003 * t1006;
    let t1008 = fma(0.25, t979, 1.0);
    let t1009 = max(t1008, 0.0);
    let t1010 = min(t1009, 1.125);
    let t1011 = t1010 * t1010;
    let t1012 = t1011 * t1011;
    let t1013 = fma(t43, t989, t37);
    let t1014 = fma(t989, t1013, t41);
    let t1015 = fma(t989, t1014, t35);
    let t1016 = t1012 * t1015;
    let t1017 = fma(0.25, t981, 1.0);
    let t1018 = max(t1017, 0.0);
    let t1019 = min(t1018, 1.125);
    let t1020 = t1019 * t1019;
    let t1021 = t1020 * t1020;
    let t1022 = fma(-t43, t987, t37);
    let t1023 = fma(-t987, t1022, t41);
    let t1024 = fma(-t987, t1023, t35);
    let t1025 = t1021 * t1024;
    let t1026 = fma(0.25, t976, 1.0);
    let t1027 = max(t1026, 0.0);
    let t1028 = min(t1027, 1.125);
    let t1029 = t1028 * t1028;
    let t1030 = t1029 * t1029;
    let t1031 = fma(t43, t987, t37);
    let t1032 = fma(t987, t1031, t41);
    let t1033 = fma(t987, t1032, t35);
    let t1034 = t1030 * t1033;
    let t1035 = fma(0.25, t978, 1.0);
    let t1036 = max(t1035, 0.0);
    let t1037 = min(t1036, 1.125);
    let t1038 = t1037 * t1037;
    let t1039 = t1038 * t1038;
    let t1040 = fma(-t43, t989, t37);
    let t1041 = fma(-t989, t1040, t41);
    let t1042 = fma(-t989, t1041, t35);
    let t1043 = t1039 * t1042;
    let t1044 = fma(0.25, t980, 1.0);
    let t1045 = max(t1044, 0.0);
    let t1046 = min(t1045, 1.125);
    let t1047 = t1046 * t1046;
    let t1048 = t1047 * t1047;
    let t1049 = fma(-t43, t988, t37);
    let t1050 = fma(-t988, t1049, t41);
    let t1051 = fma(-t988, t1050, t35);
    let t1052 = t1048 * t1051;
    let t1053 = fma(0.25, t982, 1.0);
    let t1054 = max(t1053, 0.0);
    let t1055 = min(t1054, 1.125);
    let t1056 = t1055 * t1055;
    let t1057 = t1056 * t1056;
    let t1058 = fma(-t43, t986, t37);
    let t1059 = fma(-t986, t1058, t41);
    let t1060 = fma(-t986, t1059, t35);
    let t1061 = t1057 * t1060;
    let t1062 = t998 + t1007;
    let t1063 = t998 - t1007;
    let t1064 = t1016 + t1025;
    let t1065 = t1016 - t1025;
    let t1066 = t1034 + t1043;
    let t1067 = t1034 - t1043;
    let t1068 = t1052 + t1061;
    let t1069 = t1052 - t1061;
    let t1070 = t1062 + t1064;
    let t1071 = t1062 - t1064;
    let t1072 = t1063 + t1065;
    let t1073 = t1063 - t1065;
    let t1074 = t1066 + t1068;
    let t1075 = t1066 - t1068;
    let t1076 = t1067 + t1069;
    let t1077 = t1067 - t1069;
    let t1078 = t1070 + t1074;
    let t1079 = t1070 - t1074;
    let t1080 = t1072 + t1076;
    let t1081 = t1072 - t1076;
    let t1082 = t1071 + t1075;
    let t1083 = t1071 - t1075;
    let t1084 = t1073 + t1077;
    let t1085 = t1073 - t1077;
    let t1086 = fma(0.07151261, t1078, t926);
    let t1087 = fma(0.037346244, t1082, t927);
    let t1088 = fma(0.037346244, t1079, t928);
    let t1089 = fma(0.11203873, t1080, t929);
    let t1090 = fma(0.0755365, t1084, t930);
    let t1091 = fma(0.025178833, t1083, t931);
    let t1092 = fma((-0.058148023), t1078, t933);
    let t1093 = fma(0.0755365, t1081, t934);
    let t1094 = fma(0.10071533, t1078, t936);
    let t1095 = fma(0.1065997, t1082, t938);
    let t1096 = fma(0.06025728, t1085, t940);
    let t1097 = fma((-0.019055026), t1082, t942);
    let t1098 = fma((-0.07260569), t1079, t944);
    let t1099 = fma((-0.057165075), t1080, t946);
    let t1100 = fma(0.08034304, t1079, t948);
    let t1101 = fma(0.0737998, t1080, t950);
    return array<f32, 16>(
        t1086, t1087, t1088, t1089, t1090, t1091, t1092, t1093, t1094, t1095, t1096, t1097, t1098,
        t1099, t1100, t1101,
    );
}

// The lobe in which a surface of this `roughness` (0..1; alpha of GGX is its square) mirrors light, cosine and
// shadowing included and its sum 1: the mean of P_l over it about its axis, for `transfer_lobe`. `cosine` is that
// between the normal and the direction to the viewer. Fitted to 0.01 of the mean of P_1 and to 0.05 of that of P_5,
// most at grazing angles.
// Source: GGX (Walter et al. 2007) with correlated shadowing (Heitz 2014) about the mean of its directions; `gaunt-lab
// fit` rewrites the coefficients.
// 74 multiplications, 81 additions.
fn sh4_gloss_lobe(roughness: f32, cosine: f32) -> array<f32, 4> {
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
    let t63 = fma(t10, 0.12734582, (-0.008853363));
    let t65 = fma(t10, t63, (-0.28333718));
    let t67 = fma(t10, t65, 0.0098530175);
    let t69 = fma(t10, t67, 0.044482708);
    let t72 = fma(-t10, 0.11143656, 0.10735511);
    let t74 = fma(t10, t72, 0.06261152);
    let t76 = fma(t10, t74, (-0.04064477));
    let t78 = fma(t10, t76, 0.28985444);
    let t79 = fma(t7, t69, t78);
    let t82 = fma(t10, 0.092314266, 0.034407303);
    let t84 = fma(-t10, t82, 0.34139365);
    let t86 = fma(t10, t84, 0.03033925);
    let t88 = fma(t10, t86, (-0.13237505));
    let t89 = fma(t7, t79, t88);
    let t92 = fma(t10, 0.071744986, (-0.064104944));
    let t94 = fma(t10, t92, (-0.061694536));
    let t96 = fma(t10, t94, 0.053294037);
    let t98 = fma(t10, t96, (-0.69476503));
    let t99 = fma(t7, t89, t98);
    let t102 = fma(-t10, 0.02808023, 0.052111536);
    let t104 = fma(t10, t102, (-0.09566899));
    let t106 = fma(t10, t104, (-0.012003496));
    let t108 = fma(t10, t106, 0.6626062);
    let t109 = fma(t7, t99, t108);
    let t110 = min(t109, 1.0);
    let t113 = fma(t10, 0.1741316, 0.009690697);
    let t115 = fma(t10, t113, (-0.37583733));
    let t117 = fma(t10, t115, (-0.055546142));
    let t119 = fma(t10, t117, (-0.021325732));
    let t122 = fma(-t10, 0.15402971, 0.14604113);
    let t124 = fma(t10, t122, 0.07003529);
    let t126 = fma(t10, t124, (-0.061919037));
    let t128 = fma(t10, t126, 0.402428);
    let t129 = fma(t7, t119, t128);
    let t132 = fma(t10, 0.11900092, 0.08398227);
    let t134 = fma(-t10, t132, 0.4516698);
    let t136 = fma(t10, t134, 0.12647115);
    let t138 = fma(t10, t136, (-0.02566987));
    let t139 = fma(t7, t129, t138);
    let t142 = fma(t10, 0.12317068, (-0.1104602));
    let t144 = fma(t10, t142, (-0.06709448));
    let t146 = fma(t10, t144, 0.06330181);
    let t148 = fma(t10, t146, (-0.91188085));
    let t149 = fma(t7, t139, t148);
    let t152 = fma(-t10, 0.023308696, 0.06606596);
    let t154 = fma(t10, t152, (-0.12167493));
    let t156 = fma(t10, t154, (-0.05245667));
    let t158 = fma(t10, t156, 0.50623614);
    let t159 = fma(t7, t149, t158);
    let t160 = min(t159, 1.0);
    return array<f32, 4>(
        1.0, t60, t110, t160,
    );
}

// The roughness in whose place light of this order has `roughness`: a smoother lobe, cut off after the order's bands,
// would be below 0 beside its peak by more than 3 % of that, and show dark rings around a sun. At least 1, 0.88, 0.72,
// 0.6 and 0.59 for orders 2 to 6.
// Source: `tests/tests/fitted.rs` holds it to the lobes.
// 0 multiplications, 2 additions.
fn sh4_gloss_told(roughness: f32) -> f32 {
    let t3 = max(roughness, 0.72);
    let t4 = min(t3, 1.0);
    return t4;
}

// How far the lobe of `gloss_lobe` leans: the sine between its axis and the normal, over that of the mirrored
// direction. 1 for a mirror; rough surfaces send light closer to their normal. Fitted to 0.013.
// Source: The mean of the directions of GGX's lobe (Walter et al. 2007); `gaunt-lab fit` rewrites the coefficients.
// 26 multiplications, 32 additions.
fn sh4_gloss_tilt(roughness: f32, cosine: f32) -> f32 {
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
fn sh4_gloss_energy(roughness: f32, cosine: f32) -> vec2<f32> {
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
fn sh4_horizon_radius(height: f32, square: f32) -> f32 {
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
// 183 multiplications, 438 additions.
fn sh4_exp_sampled(f: array<f32, 16>) -> array<f32, 16> {
    let t19 = f[0] * 0.2820948;
    let t21 = f[3] * 0.48860252;
    let t23 = fma(-f[6], 0.31539157, t19);
    let t25 = fma(f[8], 0.54627424, t23);
    let t27 = fma(-f[13], 0.4570458, t21);
    let t29 = fma(f[15], 0.5900436, t27);
    let t30 = t25 + t29;
    let t31 = t25 - t29;
    let t32 = min(t30, 0.15);
    let t33 = exp(t32);
    let t34 = min(t31, 0.15);
    let t35 = exp(t34);
    let t36 = t33 + t35;
    let t37 = t33 - t35;
    let t39 = t36 * 0.0450147;
    let t41 = t37 * 0.07796775;
    let t43 = t36 * 0.050327964;
    let t45 = t36 * 0.08717059;
    let t47 = t37 * 0.072932154;
    let t49 = t37 * 0.094155;
    let t50 = f[1] * 0.48860252;
    let t51 = fma(-f[8], 0.54627424, t23);
    let t52 = fma(-f[9], 0.5900436, t50);
    let t53 = fma(-f[11], 0.4570458, t52);
    let t54 = t51 + t53;
    let t55 = t51 - t53;
    let t56 = min(t54, 0.15);
    let t57 = exp(t56);
    let t58 = min(t55, 0.15);
    let t59 = exp(t58);
    let t60 = t57 + t59;
    let t61 = t57 - t59;
    let t62 = fma(0.0450147, t60, t39);
    let t63 = 0.07796775 * t61;
    let t64 = fma(0.050327964, t60, t43);
    let t65 = fma((-0.08717059), t60, t45);
    let t66 = 0.094155 * t61;
    let t67 = 0.072932154 * t61;
    let t68 = f[2] * 0.48860252;
    let t70 = fma(f[6], 0.63078314, t19);
    let t72 = fma(f[12], 0.7463527, t68);
    let t73 = t70 + t72;
    let t74 = t70 - t72;
    let t75 = min(t73, 0.15);
    let t76 = exp(t75);
    let t77 = min(t74, 0.15);
    let t78 = exp(t77);
    let t79 = t76 + t78;
    let t80 = t76 - t78;
    let t81 = fma(0.0450147, t79, t62);
    let t82 = 0.07796775 * t80;
    let t84 = fma(t79, 0.10065593, -t64);
    let t86 = t80 * 0.1190977;
    let t88 = f[1] * 0.34549415;
    let t89 = f[2] * 0.34549415;
    let t90 = f[5] * 0.54627424;
    let t92 = fma(f[6], 0.15769579, t19);
    let t94 = fma(-f[8], 0.27313712, t92);
    let t96 = fma(-f[9], 0.2086119, t88);
    let t98 = fma(f[11], 0.48477027, t96);
    let t100 = fma(-f[12], 0.13193776, t89);
    let t102 = fma(-f[14], 0.51099277, t100);
    let t103 = t94 + t98;
    let t104 = t94 - t98;
    let t105 = t90 + t102;
    let t106 = t102 - t90;
    let t107 = t103 + t105;
    let t108 = t103 - t105;
    let t109 = t104 + t106;
    let t110 = t104 - t106;
    let t111 = min(t107, 0.15);
    let t112 = exp(t111);
    let t113 = min(t109, 0.15);
    let t114 = exp(t113);
    let t115 = min(t108, 0.15);
    let t116 = exp(t115);
    let t117 = min(t110, 0.15);
    let t118 = exp(t117);
    let t119 = t112 + t114;
    let t120 = t112 - t114;
    let t121 = t116 + t118;
    let t122 = t116 - t118;
    let t123 = t119 + t121;
    let t124 = t119 - t121;
    let t125 = t120 + t122;
    let t126 = t120 - t122;
    let t128 = fma(t123, 0.080026135, t81);
    let t130 = fma(t125, 0.0980116, t63);
    let t131 = fma(t124, 0.0980116, t82);
    let t133 = t126 * 0.15496995;
    let t135 = fma(t123, 0.044735968, t84);
    let t137 = fma(-t123, 0.07748497, t65);
    let t139 = fma(t125, 0.059180126, t66);
    let t141 = fma(t125, 0.13752218, -t67);
    let t143 = fma(-t124, 0.037428796, t86);
    let t145 = t124 * 0.1449611;
    let t146 = f[3] * 0.34549415;
    let t147 = f[7] * 0.54627424;
    let t148 = fma(f[8], 0.27313712, t92);
    let t149 = fma(f[13], 0.48477027, t146);
    let t150 = fma(f[14], 0.51099277, t100);
    let t151 = fma(f[15], 0.2086119, t149);
    let t152 = t148 + t151;
    let t153 = t148 - t151;
    let t154 = t147 + t150;
    let t155 = t150 - t147;
    let t156 = t152 + t154;
    let t157 = t152 - t154;
    let t158 = t153 + t155;
    let t159 = t153 - t155;
    let t160 = min(t156, 0.15);
    let t161 = exp(t160);
    let t162 = min(t158, 0.15);
    let t163 = exp(t162);
    let t164 = min(t157, 0.15);
    let t165 = exp(t164);
    let t166 = min(t159, 0.15);
    let t167 = exp(t166);
    let t168 = t161 + t163;
    let t169 = t161 - t163;
    let t170 = t165 + t167;
    let t171 = t165 - t167;
    let t172 = t168 + t170;
    let t173 = t168 - t170;
    let t174 = t169 + t171;
    let t175 = t169 - t171;
    let t176 = fma(0.080026135, t172, t128);
    let t177 = fma(0.0980116, t173, t131);
    let t178 = fma(0.0980116, t174, t41);
    let t179 = fma(0.044735968, t172, t135);
    let t180 = 0.15496995 * t175;
    let t181 = fma(0.07748497, t172, t137);
    let t182 = fma((-0.037428796), t173, t143);
    let t183 = fma(0.13752218, t174, -t47);
    let t184 = fma(0.1449611, t173, -t145);
    let t185 = fma(0.059180126, t174, t49);
    let t187 = f[4] * 0.54627424;
    let t189 = fma(f[9], 0.4172238, t88);
    let t191 = fma(-f[11], 0.3231802, t189);
    let t192 = fma(-f[13], 0.3231802, t146);
    let t193 = fma(-f[15], 0.4172238, t192);
    let t194 = t23 + t193;
    let t195 = t23 - t193;
    let t196 = t187 + t191;
    let t197 = t191 - t187;
    let t198 = t194 + t196;
    let t199 = t194 - t196;
    let t200 = t195 + t197;
    let t201 = t195 - t197;
    let t202 = min(t198, 0.15);
    let t203 = exp(t202);
    let t204 = min(t200, 0.15);
    let t205 = exp(t204);
    let t206 = min(t199, 0.15);
    let t207 = exp(t206);
    let t208 = min(t201, 0.15);
    let t209 = exp(t208);
    let t210 = t203 + t205;
    let t211 = t203 - t205;
    let t212 = t207 + t209;
    let t213 = t207 - t209;
    let t214 = t210 + t212;
    let t215 = t210 - t212;
    let t216 = t211 + t213;
    let t217 = t211 - t213;
    let t218 = fma(0.080026135, t214, t176);
    let t219 = fma(0.0980116, t215, t130);
    let t220 = fma(0.0980116, t216, t178);
    let t222 = t217 * 0.15496995;
    let t224 = fma(-t214, 0.089471936, t179);
    let t226 = fma(t215, 0.11836025, -t139);
    let t228 = fma(-t215, 0.09168146, t141);
    let t229 = fma(-t216, 0.09168146, t183);
    let t230 = fma(-t216, 0.11836025, t185);
    let t231 = f[1] * 0.2820948;
    let t232 = f[2] * 0.2820948;
    let t233 = f[3] * 0.2820948;
    let t235 = f[4] * 0.3641828;
    let t236 = f[5] * 0.3641828;
    let t237 = f[7] * 0.3641828;
    let t239 = fma(f[9], 0.22710788, t231);
    let t241 = f[10] * 0.55629843;
    let t243 = fma(f[11], 0.17591701, t239);
    let t245 = fma(-f[12], 0.28727126, t232);
    let t246 = fma(f[13], 0.17591701, t233);
    let t247 = fma(-f[15], 0.22710788, t246);
    let t248 = t19 + t247;
    let t249 = t19 - t247;
    let t250 = t235 + t243;
    let t251 = t243 - t235;
    let t252 = t237 + t245;
    let t253 = t245 - t237;
    let t254 = t236 + t241;
    let t255 = t236 - t241;
    let t256 = t248 + t250;
    let t257 = t248 - t250;
    let t258 = t249 + t251;
    let t259 = t249 - t251;
    let t260 = t252 + t254;
    let t261 = t252 - t254;
    let t262 = t253 + t255;
    let t263 = t253 - t255;
    let t264 = t256 + t260;
    let t265 = t256 - t260;
    let t266 = t258 + t262;
    let t267 = t258 - t262;
    let t268 = t257 + t261;
    let t269 = t257 - t261;
    let t270 = t259 + t263;
    let t271 = t259 - t263;
    let t272 = min(t264, 0.15);
    let t273 = exp(t272);
    let t274 = min(t266, 0.15);
    let t275 = exp(t274);
    let t276 = min(t268, 0.15);
    let t277 = exp(t276);
    let t278 = min(t270, 0.15);
    let t279 = exp(t278);
    let t280 = min(t265, 0.15);
    let t281 = exp(t280);
    let t282 = min(t267, 0.15);
    let t283 = exp(t282);
    let t284 = min(t269, 0.15);
    let t285 = exp(t284);
    let t286 = min(t271, 0.15);
    let t287 = exp(t286);
    let t288 = t273 + t275;
    let t289 = t273 - t275;
    let t290 = t277 + t279;
    let t291 = t277 - t279;
    let t292 = t281 + t283;
    let t293 = t281 - t283;
    let t294 = t285 + t287;
    let t295 = t285 - t287;
    let t296 = t288 + t290;
    let t297 = t288 - t290;
    let t298 = t289 + t291;
    let t299 = t289 - t291;
    let t300 = t292 + t294;
    let t301 = t292 - t294;
    let t302 = t293 + t295;
    let t303 = t293 - t295;
    let t304 = t296 + t300;
    let t305 = t296 - t300;
    let t306 = t298 + t302;
    let t307 = t298 - t302;
    let t308 = t297 + t301;
    let t309 = t297 - t301;
    let t310 = t299 + t303;
    let t311 = t299 - t303;
    let t313 = fma(t304, 0.0747754, t218);
    let t314 = fma(t308, 0.0747754, t219);
    let t315 = fma(t305, 0.0747754, t177);
    let t316 = fma(t306, 0.0747754, t220);
    let t318 = fma(t310, 0.096534625, t222);
    let t319 = fma(t309, 0.096534625, t133);
    let t320 = fma(t307, 0.096534625, t180);
    let t322 = fma(t308, 0.060199913, t226);
    let t324 = t311 * 0.14745907;
    let t326 = fma(t308, 0.046630654, t228);
    let t328 = fma(-t305, 0.076147534, t182);
    let t329 = fma(t306, 0.046630654, t229);
    let t330 = fma(-t306, 0.060199913, t230);
    let t332 = f[1] * 0.1473192;
    let t334 = f[2] * 0.4419576;
    let t335 = f[3] * 0.1473192;
    let t337 = f[4] * 0.09932259;
    let t339 = f[5] * 0.29796776;
    let t341 = fma(f[6], 0.45875138, t19);
    let t342 = f[7] * 0.29796776;
    let t344 = fma(f[9], 0.032346334, t332);
    let t346 = f[10] * 0.23769604;
    let t348 = fma(f[11], 0.42594117, t344);
    let t350 = fma(f[12], 0.3682371, t334);
    let t351 = fma(f[13], 0.42594117, t335);
    let t352 = fma(-f[15], 0.032346334, t351);
    let t353 = t341 + t352;
    let t354 = t341 - t352;
    let t355 = t337 + t348;
    let t356 = t348 - t337;
    let t357 = t342 + t350;
    let t358 = t350 - t342;
    let t359 = t339 + t346;
    let t360 = t339 - t346;
    let t361 = t353 + t355;
    let t362 = t353 - t355;
    let t363 = t354 + t356;
    let t364 = t354 - t356;
    let t365 = t357 + t359;
    let t366 = t357 - t359;
    let t367 = t358 + t360;
    let t368 = t358 - t360;
    let t369 = t361 + t365;
    let t370 = t361 - t365;
    let t371 = t363 + t367;
    let t372 = t363 - t367;
    let t373 = t362 + t366;
    let t374 = t362 - t366;
    let t375 = t364 + t368;
    let t376 = t364 - t368;
    let t377 = min(t369, 0.15);
    let t378 = exp(t377);
    let t379 = min(t371, 0.15);
    let t380 = exp(t379);
    let t381 = min(t373, 0.15);
    let t382 = exp(t381);
    let t383 = min(t375, 0.15);
    let t384 = exp(t383);
    let t385 = min(t370, 0.15);
    let t386 = exp(t385);
    let t387 = min(t372, 0.15);
    let t388 = exp(t387);
    let t389 = min(t374, 0.15);
    let t390 = exp(t389);
    let t391 = min(t376, 0.15);
    let t392 = exp(t391);
    let t393 = t378 + t380;
    let t394 = t378 - t380;
    let t395 = t382 + t384;
    let t396 = t382 - t384;
    let t397 = t386 + t388;
    let t398 = t386 - t388;
    let t399 = t390 + t392;
    let t400 = t390 - t392;
    let t401 = t393 + t395;
    let t402 = t393 - t395;
    let t403 = t394 + t396;
    let t404 = t394 - t396;
    let t405 = t397 + t399;
    let t406 = t397 - t399;
    let t407 = t398 + t400;
    let t408 = t398 - t400;
    let t409 = t401 + t405;
    let t410 = t401 - t405;
    let t411 = t403 + t407;
    let t412 = t403 - t407;
    let t413 = t402 + t406;
    let t414 = t402 - t406;
    let t415 = t404 + t408;
    let t416 = t404 - t408;
    let t418 = fma(t409, 0.07151261, t313);
    let t420 = fma(t413, 0.037346244, t314);
    let t422 = fma(t410, 0.11203873, t315);
    let t423 = fma(t411, 0.037346244, t316);
    let t425 = fma(t415, 0.025178833, t318);
    let t427 = fma(t414, 0.0755365, t319);
    let t429 = fma(t409, 0.116296045, t224);
    let t430 = fma(t412, 0.0755365, t320);
    let t432 = fma(t413, 0.008199977, t322);
    let t434 = fma(t416, 0.06025728, t324);
    let t436 = fma(t413, 0.10797848, t326);
    let t438 = fma(t410, 0.09335018, t328);
    let t439 = fma(t411, 0.10797848, t329);
    let t440 = fma(-t411, 0.008199977, t330);
    let t441 = f[1] * 0.4419576;
    let t442 = f[2] * 0.1473192;
    let t443 = f[4] * 0.29796776;
    let t445 = fma(-f[6], 0.22937569, t19);
    let t446 = f[7] * 0.09932259;
    let t448 = fma(-f[8], 0.39729035, t445);
    let t450 = fma(-f[9], 0.291117, t441);
    let t452 = f[10] * 0.23769604;
    let t454 = fma(-f[11], 0.22549826, t450);
    let t456 = fma(-f[12], 0.28640664, t442);
    let t458 = fma(-f[13], 0.075166084, t335);
    let t460 = fma(-f[14], 0.31692806, t456);
    let t462 = fma(-f[15], 0.42050233, t458);
    let t463 = t448 + t462;
    let t464 = t448 - t462;
    let t465 = t443 + t454;
    let t466 = t454 - t443;
    let t467 = t446 + t460;
    let t468 = t460 - t446;
    let t469 = t339 + t452;
    let t470 = t339 - t452;
    let t471 = t463 + t465;
    let t472 = t463 - t465;
    let t473 = t464 + t466;
    let t474 = t464 - t466;
    let t475 = t467 + t469;
    let t476 = t467 - t469;
    let t477 = t468 + t470;
    let t478 = t468 - t470;
    let t479 = t471 + t475;
    let t480 = t471 - t475;
    let t481 = t473 + t477;
    let t482 = t473 - t477;
    let t483 = t472 + t476;
    let t484 = t472 - t476;
    let t485 = t474 + t478;
    let t486 = t474 - t478;
    let t487 = min(t479, 0.15);
    let t488 = exp(t487);
    let t489 = min(t481, 0.15);
    let t490 = exp(t489);
    let t491 = min(t483, 0.15);
    let t492 = exp(t491);
    let t493 = min(t485, 0.15);
    let t494 = exp(t493);
    let t495 = min(t480, 0.15);
    let t496 = exp(t495);
    let t497 = min(t482, 0.15);
    let t498 = exp(t497);
    let t499 = min(t484, 0.15);
    let t500 = exp(t499);
    let t501 = min(t486, 0.15);
    let t502 = exp(t501);
    let t503 = t488 + t490;
    let t504 = t488 - t490;
    let t505 = t492 + t494;
    let t506 = t492 - t494;
    let t507 = t496 + t498;
    let t508 = t496 - t498;
    let t509 = t500 + t502;
    let t510 = t500 - t502;
    let t511 = t503 + t505;
    let t512 = t503 - t505;
    let t513 = t504 + t506;
    let t514 = t504 - t506;
    let t515 = t507 + t509;
    let t516 = t507 - t509;
    let t517 = t508 + t510;
    let t518 = t508 - t510;
    let t519 = t511 + t515;
    let t520 = t511 - t515;
    let t521 = t513 + t517;
    let t522 = t513 - t517;
    let t523 = t512 + t516;
    let t524 = t512 - t516;
    let t525 = t514 + t518;
    let t526 = t514 - t518;
    let t527 = fma(0.07151261, t519, t418);
    let t528 = fma(0.11203873, t523, t420);
    let t529 = fma(0.037346244, t520, t422);
    let t530 = fma(0.037346244, t521, t423);
    let t531 = fma(0.0755365, t525, t425);
    let t532 = fma(0.0755365, t524, t427);
    let t534 = fma(-t519, 0.058148023, t429);
    let t535 = fma(0.025178833, t522, t430);
    let t537 = fma(-t519, 0.10071533, t181);
    let t539 = fma(-t523, 0.0737998, t432);
    let t541 = fma(t526, 0.06025728, t434);
    let t543 = fma(-t523, 0.057165075, t436);
    let t545 = fma(-t520, 0.07260569, t438);
    let t547 = fma(-t521, 0.019055026, t439);
    let t549 = fma(-t520, 0.08034304, t184);
    let t551 = fma(-t521, 0.1065997, t440);
    let t552 = f[3] * 0.4419576;
    let t553 = f[5] * 0.09932259;
    let t554 = fma(f[8], 0.39729035, t445);
    let t555 = fma(f[9], 0.42050233, t332);
    let t556 = fma(-f[11], 0.075166084, t555);
    let t557 = fma(-f[13], 0.22549826, t552);
    let t558 = fma(f[14], 0.31692806, t456);
    let t559 = fma(f[15], 0.291117, t557);
    let t560 = t554 + t559;
    let t561 = t554 - t559;
    let t562 = t443 + t556;
    let t563 = t556 - t443;
    let t564 = t342 + t558;
    let t565 = t558 - t342;
    let t566 = t452 + t553;
    let t567 = t553 - t452;
    let t568 = t560 + t562;
    let t569 = t560 - t562;
    let t570 = t561 + t563;
    let t571 = t561 - t563;
    let t572 = t564 + t566;
    let t573 = t564 - t566;
    let t574 = t565 + t567;
    let t575 = t565 - t567;
    let t576 = t568 + t572;
    let t577 = t568 - t572;
    let t578 = t570 + t574;
    let t579 = t570 - t574;
    let t580 = t569 + t573;
    let t581 = t569 - t573;
    let t582 = t571 + t575;
    let t583 = t571 - t575;
    let t584 = min(t576, 0.15);
    let t585 = exp(t584);
    let t586 = min(t578, 0.15);
    let t587 = exp(t586);
    let t588 = min(t580, 0.15);
    let t589 = exp(t588);
    let t590 = min(t582, 0.15);
    let t591 = exp(t590);
    let t592 = min(t577, 0.15);
    let t593 = exp(t592);
    let t594 = min(t579, 0.15);
    let t595 = exp(t594);
    let t596 = min(t581, 0.15);
    let t597 = exp(t596);
    let t598 = min(t583, 0.15);
    let t599 = exp(t598);
    let t600 = t585 + t587;
    let t601 = t585 - t587;
    let t602 = t589 + t591;
    let t603 = t589 - t591;
    let t604 = t593 + t595;
    let t605 = t593 - t595;
    let t606 = t597 + t599;
    let t607 = t597 - t599;
    let t608 = t600 + t602;
    let t609 = t600 - t602;
    let t610 = t601 + t603;
    let t611 = t601 - t603;
    let t612 = t604 + t606;
    let t613 = t604 - t606;
    let t614 = t605 + t607;
    let t615 = t605 - t607;
    let t616 = t608 + t612;
    let t617 = t608 - t612;
    let t618 = t610 + t614;
    let t619 = t610 - t614;
    let t620 = t609 + t613;
    let t621 = t609 - t613;
    let t622 = t611 + t615;
    let t623 = t611 - t615;
    let t624 = fma(0.07151261, t616, t527);
    let t625 = fma(0.037346244, t620, t528);
    let t626 = fma(0.037346244, t617, t529);
    let t627 = fma(0.11203873, t618, t530);
    let t628 = fma(0.0755365, t622, t531);
    let t629 = fma(0.025178833, t621, t532);
    let t630 = fma((-0.058148023), t616, t534);
    let t631 = fma(0.0755365, t619, t535);
    let t632 = fma(0.10071533, t616, t537);
    let t633 = fma(0.1065997, t620, t539);
    let t634 = fma(0.06025728, t623, t541);
    let t635 = fma((-0.019055026), t620, t543);
    let t636 = fma((-0.07260569), t617, t545);
    let t637 = fma((-0.057165075), t618, t547);
    let t638 = fma(0.08034304, t617, t549);
    let t639 = fma(0.0737998, t618, t551);
    return array<f32, 16>(
        t624, t625, t626, t627, t628, t629, t630, t631, t632, t633, t634, t635, t636, t637, t638,
        t639,
    );
}

// As `exp_sampled`, on 6, 14, 38, 50 and 50 points for orders 2 to 6.
// Source: Ren et al. 2006, eq. 10, by quadrature (Lebedev 1976) and clamped from above.
// 155 multiplications, 311 additions.
fn sh4_exp_sampled_coarse(f: array<f32, 16>) -> array<f32, 16> {
    let t19 = f[0] * 0.2820948;
    let t21 = f[3] * 0.48860252;
    let t23 = fma(-f[6], 0.31539157, t19);
    let t25 = fma(f[8], 0.54627424, t23);
    let t27 = fma(-f[13], 0.4570458, t21);
    let t29 = fma(f[15], 0.5900436, t27);
    let t30 = t25 + t29;
    let t31 = t25 - t29;
    let t32 = min(t30, 0.15);
    let t33 = exp(t32);
    let t34 = min(t31, 0.15);
    let t35 = exp(t34);
    let t36 = t33 + t35;
    let t37 = t33 - t35;
    let t39 = t36 * 0.033761024;
    let t41 = t37 * 0.05847581;
    let t43 = t36 * 0.037745975;
    let t45 = t36 * 0.06537794;
    let t47 = t37 * 0.05469911;
    let t49 = t37 * 0.07061625;
    let t50 = f[1] * 0.48860252;
    let t51 = fma(-f[8], 0.54627424, t23);
    let t52 = fma(-f[9], 0.5900436, t50);
    let t53 = fma(-f[11], 0.4570458, t52);
    let t54 = t51 + t53;
    let t55 = t51 - t53;
    let t56 = min(t54, 0.15);
    let t57 = exp(t56);
    let t58 = min(t55, 0.15);
    let t59 = exp(t58);
    let t60 = t57 + t59;
    let t61 = t57 - t59;
    let t62 = fma(0.033761024, t60, t39);
    let t63 = 0.05847581 * t61;
    let t64 = fma(0.037745975, t60, t43);
    let t65 = fma((-0.06537794), t60, t45);
    let t66 = 0.07061625 * t61;
    let t67 = 0.05469911 * t61;
    let t68 = f[2] * 0.48860252;
    let t70 = fma(f[6], 0.63078314, t19);
    let t72 = fma(f[12], 0.7463527, t68);
    let t73 = t70 + t72;
    let t74 = t70 - t72;
    let t75 = min(t73, 0.15);
    let t76 = exp(t75);
    let t77 = min(t74, 0.15);
    let t78 = exp(t77);
    let t79 = t76 + t78;
    let t80 = t76 - t78;
    let t81 = fma(0.033761024, t79, t62);
    let t82 = 0.05847581 * t80;
    let t84 = fma(t79, 0.07549195, -t64);
    let t86 = t80 * 0.089323275;
    let t87 = f[1] * 0.2820948;
    let t88 = f[2] * 0.2820948;
    let t89 = f[3] * 0.2820948;
    let t91 = f[4] * 0.3641828;
    let t92 = f[5] * 0.3641828;
    let t93 = f[7] * 0.3641828;
    let t95 = fma(f[9], 0.22710788, t87);
    let t97 = f[10] * 0.55629843;
    let t99 = fma(f[11], 0.17591701, t95);
    let t101 = fma(-f[12], 0.28727126, t88);
    let t102 = fma(f[13], 0.17591701, t89);
    let t103 = fma(-f[15], 0.22710788, t102);
    let t104 = t19 + t103;
    let t105 = t19 - t103;
    let t106 = t91 + t99;
    let t107 = t99 - t91;
    let t108 = t93 + t101;
    let t109 = t101 - t93;
    let t110 = t92 + t97;
    let t111 = t92 - t97;
    let t112 = t104 + t106;
    let t113 = t104 - t106;
    let t114 = t105 + t107;
    let t115 = t105 - t107;
    let t116 = t108 + t110;
    let t117 = t108 - t110;
    let t118 = t109 + t111;
    let t119 = t109 - t111;
    let t120 = t112 + t116;
    let t121 = t112 - t116;
    let t122 = t114 + t118;
    let t123 = t114 - t118;
    let t124 = t113 + t117;
    let t125 = t113 - t117;
    let t126 = t115 + t119;
    let t127 = t115 - t119;
    let t128 = min(t120, 0.15);
    let t129 = exp(t128);
    let t130 = min(t122, 0.15);
    let t131 = exp(t130);
    let t132 = min(t124, 0.15);
    let t133 = exp(t132);
    let t134 = min(t126, 0.15);
    let t135 = exp(t134);
    let t136 = min(t121, 0.15);
    let t137 = exp(t136);
    let t138 = min(t123, 0.15);
    let t139 = exp(t138);
    let t140 = min(t125, 0.15);
    let t141 = exp(t140);
    let t142 = min(t127, 0.15);
    let t143 = exp(t142);
    let t144 = t129 + t131;
    let t145 = t129 - t131;
    let t146 = t133 + t135;
    let t147 = t133 - t135;
    let t148 = t137 + t139;
    let t149 = t137 - t139;
    let t150 = t141 + t143;
    let t151 = t141 - t143;
    let t152 = t144 + t146;
    let t153 = t144 - t146;
    let t154 = t145 + t147;
    let t155 = t145 - t147;
    let t156 = t148 + t150;
    let t157 = t148 - t150;
    let t158 = t149 + t151;
    let t159 = t149 - t151;
    let t160 = t152 + t156;
    let t161 = t152 - t156;
    let t162 = t154 + t158;
    let t163 = t154 - t158;
    let t164 = t153 + t157;
    let t165 = t153 - t157;
    let t166 = t155 + t159;
    let t167 = t155 - t159;
    let t169 = fma(t160, 0.113943465, t81);
    let t170 = fma(t164, 0.113943465, t63);
    let t171 = fma(t161, 0.113943465, t82);
    let t172 = fma(t162, 0.113943465, t41);
    let t174 = t166 * 0.14710037;
    let t175 = t165 * 0.14710037;
    let t176 = t163 * 0.14710037;
    let t178 = fma(t164, 0.0917332, -t66);
    let t180 = t167 * 0.22469954;
    let t182 = fma(t164, 0.07105623, -t67);
    let t184 = fma(-t161, 0.116034344, t86);
    let t185 = fma(t162, 0.07105623, -t47);
    let t186 = fma(-t162, 0.0917332, t49);
    let t188 = f[1] * 0.4339151;
    let t190 = f[3] * 0.22461098;
    let t192 = f[4] * 0.44603103;
    let t194 = fma(-f[8], 0.31539157, t23);
    let t196 = fma(-f[9], 0.081063434, t188);
    let t198 = fma(-f[11], 0.4058904, t196);
    let t200 = fma(-f[13], 0.21010435, t190);
    let t202 = fma(-f[15], 0.5844486, t200);
    let t203 = t194 + t202;
    let t204 = t194 - t202;
    let t205 = t192 + t198;
    let t206 = t198 - t192;
    let t207 = t203 + t205;
    let t208 = t203 - t205;
    let t209 = t204 + t206;
    let t210 = t204 - t206;
    let t211 = min(t207, 0.15);
    let t212 = exp(t211);
    let t213 = min(t209, 0.15);
    let t214 = exp(t213);
    let t215 = min(t208, 0.15);
    let t216 = exp(t215);
    let t217 = min(t210, 0.15);
    let t218 = exp(t217);
    let t219 = t212 + t214;
    let t220 = t212 - t214;
    let t221 = t216 + t218;
    let t222 = t216 - t218;
    let t223 = t219 + t221;
    let t224 = t219 - t221;
    let t225 = t220 + t222;
    let t226 = t220 - t222;
    let t228 = fma(t223, 0.10128308, t169);
    let t230 = fma(t224, 0.15579252, t170);
    let t232 = fma(t225, 0.08064414, t172);
    let t234 = fma(t226, 0.1601426, t174);
    let t236 = fma(-t223, 0.113237925, t84);
    let t238 = fma(-t223, 0.113237925, t65);
    let t240 = fma(-t224, 0.029104948, t178);
    let t242 = fma(-t224, 0.14573056, t182);
    let t244 = fma(-t225, 0.07543568, t185);
    let t246 = fma(-t225, 0.20983993, t186);
    let t247 = f[2] * 0.4339151;
    let t249 = fma(f[6], 0.4308329, t19);
    let t250 = f[7] * 0.44603103;
    let t252 = fma(f[8], 0.11544132, t249);
    let t254 = fma(f[12], 0.31264237, t247);
    let t256 = fma(f[13], 0.618416, t190);
    let t258 = fma(f[14], 0.27124354, t254);
    let t260 = fma(f[15], 0.057320505, t256);
    let t261 = t252 + t260;
    let t262 = t252 - t260;
    let t263 = t250 + t258;
    let t264 = t258 - t250;
    let t265 = t261 + t263;
    let t266 = t261 - t263;
    let t267 = t262 + t264;
    let t268 = t262 - t264;
    let t269 = min(t265, 0.15);
    let t270 = exp(t269);
    let t271 = min(t267, 0.15);
    let t272 = exp(t271);
    let t273 = min(t266, 0.15);
    let t274 = exp(t273);
    let t275 = min(t268, 0.15);
    let t276 = exp(t275);
    let t277 = t270 + t272;
    let t278 = t270 - t272;
    let t279 = t274 + t276;
    let t280 = t274 - t276;
    let t281 = t277 + t279;
    let t282 = t277 - t279;
    let t283 = t278 + t280;
    let t284 = t278 - t280;
    let t285 = fma(0.10128308, t281, t228);
    let t286 = fma(0.15579252, t282, t171);
    let t287 = fma(0.08064414, t283, t232);
    let t289 = fma(t281, 0.15468588, t236);
    let t290 = fma(0.1601426, t284, t176);
    let t292 = fma(t281, 0.041447956, t238);
    let t294 = fma(t282, 0.11225086, t184);
    let t296 = fma(t283, 0.22203556, t244);
    let t298 = t282 * 0.09738705;
    let t300 = fma(t283, 0.020580305, t246);
    let t301 = f[1] * 0.22461098;
    let t302 = f[3] * 0.4339151;
    let t303 = fma(f[8], 0.31539157, t23);
    let t304 = fma(f[9], 0.5844486, t301);
    let t305 = fma(-f[11], 0.21010435, t304);
    let t306 = fma(-f[13], 0.4058904, t302);
    let t307 = fma(f[15], 0.081063434, t306);
    let t308 = t303 + t307;
    let t309 = t303 - t307;
    let t310 = t192 + t305;
    let t311 = t305 - t192;
    let t312 = t308 + t310;
    let t313 = t308 - t310;
    let t314 = t309 + t311;
    let t315 = t309 - t311;
    let t316 = min(t312, 0.15);
    let t317 = exp(t316);
    let t318 = min(t314, 0.15);
    let t319 = exp(t318);
    let t320 = min(t313, 0.15);
    let t321 = exp(t320);
    let t322 = min(t315, 0.15);
    let t323 = exp(t322);
    let t324 = t317 + t319;
    let t325 = t317 - t319;
    let t326 = t321 + t323;
    let t327 = t321 - t323;
    let t328 = t324 + t326;
    let t329 = t324 - t326;
    let t330 = t325 + t327;
    let t331 = t325 - t327;
    let t332 = fma(0.10128308, t328, t285);
    let t333 = fma(0.08064414, t329, t230);
    let t334 = fma(0.15579252, t330, t287);
    let t335 = fma(0.1601426, t331, t234);
    let t336 = fma((-0.113237925), t328, t289);
    let t337 = fma(0.113237925, t328, t292);
    let t338 = fma(0.20983993, t329, t240);
    let t339 = fma((-0.07543568), t329, t242);
    let t340 = fma((-0.14573056), t330, t296);
    let t341 = fma(0.029104948, t330, t300);
    let t342 = f[2] * 0.22461098;
    let t344 = fma(-f[6], 0.11544132, t19);
    let t346 = f[7] * 0.44603103;
    let t348 = fma(f[8], 0.4308329, t344);
    let t350 = fma(-f[12], 0.33338508, t342);
    let t352 = fma(f[13], 0.022983272, t302);
    let t354 = fma(f[14], 0.52400225, t350);
    let t356 = fma(f[15], 0.41326755, t352);
    let t357 = t348 + t356;
    let t358 = t348 - t356;
    let t359 = t346 + t354;
    let t360 = t354 - t346;
    let t361 = t357 + t359;
    let t362 = t357 - t359;
    let t363 = t358 + t360;
    let t364 = t358 - t360;
    let t365 = min(t361, 0.15);
    let t366 = exp(t365);
    let t367 = min(t363, 0.15);
    let t368 = exp(t367);
    let t369 = min(t362, 0.15);
    let t370 = exp(t369);
    let t371 = min(t364, 0.15);
    let t372 = exp(t371);
    let t373 = t366 + t368;
    let t374 = t366 - t368;
    let t375 = t370 + t372;
    let t376 = t370 - t372;
    let t377 = t373 + t375;
    let t378 = t373 - t375;
    let t379 = t374 + t376;
    let t380 = t374 - t376;
    let t381 = fma(0.10128308, t377, t332);
    let t382 = fma(0.08064414, t378, t286);
    let t383 = fma(0.15579252, t379, t334);
    let t385 = fma(-t377, 0.041447956, t336);
    let t387 = fma(t380, 0.1601426, t290);
    let t388 = fma(0.15468588, t377, t337);
    let t390 = fma(-t378, 0.1196983, t294);
    let t392 = fma(t379, 0.008251894, t340);
    let t394 = fma(t378, 0.18813734, t298);
    let t396 = fma(t379, 0.14837924, t341);
    let t397 = f[5] * 0.44603103;
    let t398 = fma(-f[8], 0.11544132, t249);
    let t399 = fma(-f[9], 0.057320505, t301);
    let t400 = fma(f[11], 0.618416, t399);
    let t401 = fma(-f[14], 0.27124354, t254);
    let t402 = t398 + t400;
    let t403 = t398 - t400;
    let t404 = t397 + t401;
    let t405 = t401 - t397;
    let t406 = t402 + t404;
    let t407 = t402 - t404;
    let t408 = t403 + t405;
    let t409 = t403 - t405;
    let t410 = min(t406, 0.15);
    let t411 = exp(t410);
    let t412 = min(t408, 0.15);
    let t413 = exp(t412);
    let t414 = min(t407, 0.15);
    let t415 = exp(t414);
    let t416 = min(t409, 0.15);
    let t417 = exp(t416);
    let t418 = t411 + t413;
    let t419 = t411 - t413;
    let t420 = t415 + t417;
    let t421 = t415 - t417;
    let t422 = t418 + t420;
    let t423 = t418 - t420;
    let t424 = t419 + t421;
    let t425 = t419 - t421;
    let t426 = fma(0.10128308, t422, t381);
    let t427 = fma(0.08064414, t424, t333);
    let t428 = fma(0.15579252, t423, t382);
    let t429 = fma(0.1601426, t425, t175);
    let t430 = fma(0.15468588, t422, t385);
    let t431 = fma((-0.041447956), t422, t388);
    let t432 = fma((-0.020580305), t424, t338);
    let t433 = fma(0.22203556, t424, t339);
    let t434 = fma(0.11225086, t423, t390);
    let t435 = fma((-0.09738705), t423, t394);
    let t436 = f[5] * 0.44603103;
    let t437 = fma(-f[8], 0.4308329, t344);
    let t438 = fma(-f[9], 0.41326755, t188);
    let t439 = fma(f[11], 0.022983272, t438);
    let t440 = fma(-f[14], 0.52400225, t350);
    let t441 = t437 + t439;
    let t442 = t437 - t439;
    let t443 = t436 + t440;
    let t444 = t440 - t436;
    let t445 = t441 + t443;
    let t446 = t441 - t443;
    let t447 = t442 + t444;
    let t448 = t442 - t444;
    let t449 = min(t445, 0.15);
    let t450 = exp(t449);
    let t451 = min(t447, 0.15);
    let t452 = exp(t451);
    let t453 = min(t446, 0.15);
    let t454 = exp(t453);
    let t455 = min(t448, 0.15);
    let t456 = exp(t455);
    let t457 = t450 + t452;
    let t458 = t450 - t452;
    let t459 = t454 + t456;
    let t460 = t454 - t456;
    let t461 = t457 + t459;
    let t462 = t457 - t459;
    let t463 = t458 + t460;
    let t464 = t458 - t460;
    let t465 = fma(0.10128308, t461, t426);
    let t466 = fma(0.15579252, t463, t427);
    let t467 = fma(0.08064414, t462, t428);
    let t468 = fma(0.1601426, t464, t429);
    let t469 = fma((-0.041447956), t461, t430);
    let t470 = fma((-0.15468588), t461, t431);
    let t471 = fma((-0.14837924), t463, t432);
    let t472 = fma(0.008251894, t463, t433);
    let t473 = fma((-0.1196983), t462, t434);
    let t474 = fma((-0.18813734), t462, t435);
    return array<f32, 16>(
        t465, t466, t467, t383, t335, t468, t469, t387, t470, t471, t180, t472, t473, t392, t474,
        t396,
    );
}

// As `exp_sampled`, on 26, 38, 86, 110 and 110 points for orders 2 to 6.
// Source: Ren et al. 2006, eq. 10, by quadrature (Lebedev 1976) and clamped from above.
// 314 multiplications, 777 additions.
fn sh4_exp_sampled_fine(f: array<f32, 16>) -> array<f32, 16> {
    let t19 = f[0] * 0.2820948;
    let t21 = f[3] * 0.48860252;
    let t23 = fma(-f[6], 0.31539157, t19);
    let t25 = fma(f[8], 0.54627424, t23);
    let t27 = fma(-f[13], 0.4570458, t21);
    let t29 = fma(f[15], 0.5900436, t27);
    let t30 = t25 + t29;
    let t31 = t25 - t29;
    let t32 = min(t30, 0.15);
    let t33 = exp(t32);
    let t34 = min(t31, 0.15);
    let t35 = exp(t34);
    let t36 = t33 + t35;
    let t37 = t33 - t35;
    let t39 = t36 * 0.040922455;
    let t41 = t37 * 0.07087977;
    let t43 = t36 * 0.045752697;
    let t45 = t36 * 0.07924599;
    let t47 = t37 * 0.06630196;
    let t49 = t37 * 0.08559546;
    let t50 = f[1] * 0.48860252;
    let t51 = fma(-f[8], 0.54627424, t23);
    let t52 = fma(-f[9], 0.5900436, t50);
    let t53 = fma(-f[11], 0.4570458, t52);
    let t54 = t51 + t53;
    let t55 = t51 - t53;
    let t56 = min(t54, 0.15);
    let t57 = exp(t56);
    let t58 = min(t55, 0.15);
    let t59 = exp(t58);
    let t60 = t57 + t59;
    let t61 = t57 - t59;
    let t62 = fma(0.040922455, t60, t39);
    let t63 = 0.07087977 * t61;
    let t64 = fma(0.045752697, t60, t43);
    let t65 = fma((-0.07924599), t60, t45);
    let t66 = 0.08559546 * t61;
    let t67 = 0.06630196 * t61;
    let t68 = f[2] * 0.48860252;
    let t70 = fma(f[6], 0.63078314, t19);
    let t72 = fma(f[12], 0.7463527, t68);
    let t73 = t70 + t72;
    let t74 = t70 - t72;
    let t75 = min(t73, 0.15);
    let t76 = exp(t75);
    let t77 = min(t74, 0.15);
    let t78 = exp(t77);
    let t79 = t76 + t78;
    let t80 = t76 - t78;
    let t81 = fma(0.040922455, t79, t62);
    let t82 = 0.07087977 * t80;
    let t84 = fma(t79, 0.09150539, -t64);
    let t86 = t80 * 0.10827064;
    let t87 = f[1] * 0.2820948;
    let t88 = f[2] * 0.2820948;
    let t89 = f[3] * 0.2820948;
    let t91 = f[4] * 0.3641828;
    let t92 = f[5] * 0.3641828;
    let t93 = f[7] * 0.3641828;
    let t95 = fma(f[9], 0.22710788, t87);
    let t97 = f[10] * 0.55629843;
    let t99 = fma(f[11], 0.17591701, t95);
    let t101 = fma(-f[12], 0.28727126, t88);
    let t102 = fma(f[13], 0.17591701, t89);
    let t103 = fma(-f[15], 0.22710788, t102);
    let t104 = t19 + t103;
    let t105 = t19 - t103;
    let t106 = t91 + t99;
    let t107 = t99 - t91;
    let t108 = t93 + t101;
    let t109 = t101 - t93;
    let t110 = t92 + t97;
    let t111 = t92 - t97;
    let t112 = t104 + t106;
    let t113 = t104 - t106;
    let t114 = t105 + t107;
    let t115 = t105 - t107;
    let t116 = t108 + t110;
    let t117 = t108 - t110;
    let t118 = t109 + t111;
    let t119 = t109 - t111;
    let t120 = t112 + t116;
    let t121 = t112 - t116;
    let t122 = t114 + t118;
    let t123 = t114 - t118;
    let t124 = t113 + t117;
    let t125 = t113 - t117;
    let t126 = t115 + t119;
    let t127 = t115 - t119;
    let t128 = min(t120, 0.15);
    let t129 = exp(t128);
    let t130 = min(t122, 0.15);
    let t131 = exp(t130);
    let t132 = min(t124, 0.15);
    let t133 = exp(t132);
    let t134 = min(t126, 0.15);
    let t135 = exp(t134);
    let t136 = min(t121, 0.15);
    let t137 = exp(t136);
    let t138 = min(t123, 0.15);
    let t139 = exp(t138);
    let t140 = min(t125, 0.15);
    let t141 = exp(t140);
    let t142 = min(t127, 0.15);
    let t143 = exp(t142);
    let t144 = t129 + t131;
    let t145 = t129 - t131;
    let t146 = t133 + t135;
    let t147 = t133 - t135;
    let t148 = t137 + t139;
    let t149 = t137 - t139;
    let t150 = t141 + t143;
    let t151 = t141 - t143;
    let t152 = t144 + t146;
    let t153 = t144 - t146;
    let t154 = t145 + t147;
    let t155 = t145 - t147;
    let t156 = t148 + t150;
    let t157 = t148 - t150;
    let t158 = t149 + t151;
    let t159 = t149 - t151;
    let t160 = t152 + t156;
    let t161 = t152 - t156;
    let t162 = t154 + t158;
    let t163 = t154 - t158;
    let t164 = t153 + t157;
    let t165 = t153 - t157;
    let t166 = t155 + t159;
    let t167 = t155 - t159;
    let t169 = fma(t160, 0.042340055, t81);
    let t170 = fma(t164, 0.042340055, t63);
    let t171 = fma(t161, 0.042340055, t82);
    let t172 = fma(t162, 0.042340055, t41);
    let t174 = t166 * 0.054660775;
    let t175 = t165 * 0.054660775;
    let t176 = t163 * 0.054660775;
    let t178 = fma(t164, 0.034086984, -t66);
    let t180 = t167 * 0.083495714;
    let t182 = fma(t164, 0.026403664, -t67);
    let t184 = fma(-t161, 0.043117, t86);
    let t185 = fma(t162, 0.026403664, -t47);
    let t186 = fma(-t162, 0.034086984, t49);
    let t188 = f[1] * 0.18058889;
    let t190 = f[2] * 0.4165426;
    let t191 = f[3] * 0.18058889;
    let t193 = f[4] * 0.14924896;
    let t195 = f[5] * 0.34425458;
    let t197 = fma(f[6], 0.37227634, t19);
    let t198 = f[7] * 0.34425458;
    let t200 = fma(f[9], 0.059582677, t188);
    let t202 = f[10] * 0.33663872;
    let t204 = fma(f[11], 0.444939, t200);
    let t206 = fma(f[12], 0.20168062, t190);
    let t207 = fma(f[13], 0.444939, t191);
    let t208 = fma(-f[15], 0.059582677, t207);
    let t209 = t197 + t208;
    let t210 = t197 - t208;
    let t211 = t193 + t204;
    let t212 = t204 - t193;
    let t213 = t198 + t206;
    let t214 = t206 - t198;
    let t215 = t195 + t202;
    let t216 = t195 - t202;
    let t217 = t209 + t211;
    let t218 = t209 - t211;
    let t219 = t210 + t212;
    let t220 = t210 - t212;
    let t221 = t213 + t215;
    let t222 = t213 - t215;
    let t223 = t214 + t216;
    let t224 = t214 - t216;
    let t225 = t217 + t221;
    let t226 = t217 - t221;
    let t227 = t219 + t223;
    let t228 = t219 - t223;
    let t229 = t218 + t222;
    let t230 = t218 - t222;
    let t231 = t220 + t224;
    let t232 = t220 - t224;
    let t233 = min(t225, 0.15);
    let t234 = exp(t233);
    let t235 = min(t227, 0.15);
    let t236 = exp(t235);
    let t237 = min(t229, 0.15);
    let t238 = exp(t237);
    let t239 = min(t231, 0.15);
    let t240 = exp(t239);
    let t241 = min(t226, 0.15);
    let t242 = exp(t241);
    let t243 = min(t228, 0.15);
    let t244 = exp(t243);
    let t245 = min(t230, 0.15);
    let t246 = exp(t245);
    let t247 = min(t232, 0.15);
    let t248 = exp(t247);
    let t249 = t234 + t236;
    let t250 = t234 - t236;
    let t251 = t238 + t240;
    let t252 = t238 - t240;
    let t253 = t242 + t244;
    let t254 = t242 - t244;
    let t255 = t246 + t248;
    let t256 = t246 - t248;
    let t257 = t249 + t251;
    let t258 = t249 - t251;
    let t259 = t250 + t252;
    let t260 = t250 - t252;
    let t261 = t253 + t255;
    let t262 = t253 - t255;
    let t263 = t254 + t256;
    let t264 = t254 - t256;
    let t265 = t257 + t261;
    let t266 = t257 - t261;
    let t267 = t259 + t263;
    let t268 = t259 - t263;
    let t269 = t258 + t262;
    let t270 = t258 - t262;
    let t271 = t260 + t264;
    let t272 = t260 - t264;
    let t274 = fma(t265, 0.039385896, t169);
    let t276 = fma(t269, 0.025213704, t170);
    let t278 = fma(t266, 0.05815741, t171);
    let t279 = fma(t267, 0.025213704, t172);
    let t281 = fma(t271, 0.020838045, t174);
    let t283 = fma(t270, 0.048064604, t175);
    let t285 = fma(t265, 0.051976986, t84);
    let t286 = fma(t268, 0.048064604, t176);
    let t288 = fma(t269, 0.0083188955, t178);
    let t290 = fma(t272, 0.04700128, t180);
    let t292 = fma(t269, 0.0621221, t182);
    let t294 = fma(t266, 0.028158518, t184);
    let t295 = fma(t267, 0.0621221, t185);
    let t296 = fma(-t267, 0.0083188955, t186);
    let t297 = f[1] * 0.4165426;
    let t298 = f[2] * 0.18058889;
    let t299 = f[4] * 0.34425458;
    let t301 = fma(-f[6], 0.18613817, t19);
    let t303 = f[7] * 0.14924896;
    let t305 = fma(-f[8], 0.32240078, t301);
    let t307 = fma(-f[9], 0.15944253, t297);
    let t309 = fma(-f[11], 0.12350365, t307);
    let t311 = fma(-f[12], 0.31957263, t298);
    let t313 = fma(-f[13], 0.05354407, t191);
    let t315 = fma(-f[14], 0.31526837, t311);
    let t317 = fma(-f[15], 0.445706, t313);
    let t318 = t305 + t317;
    let t319 = t305 - t317;
    let t320 = t299 + t309;
    let t321 = t309 - t299;
    let t322 = t303 + t315;
    let t323 = t315 - t303;
    let t324 = t318 + t320;
    let t325 = t318 - t320;
    let t326 = t319 + t321;
    let t327 = t319 - t321;
    let t328 = t215 + t322;
    let t329 = t322 - t215;
    let t330 = t216 + t323;
    let t331 = t323 - t216;
    let t332 = t324 + t328;
    let t333 = t324 - t328;
    let t334 = t326 + t330;
    let t335 = t326 - t330;
    let t336 = t325 + t329;
    let t337 = t325 - t329;
    let t338 = t327 + t331;
    let t339 = t327 - t331;
    let t340 = min(t332, 0.15);
    let t341 = exp(t340);
    let t342 = min(t334, 0.15);
    let t343 = exp(t342);
    let t344 = min(t336, 0.15);
    let t345 = exp(t344);
    let t346 = min(t338, 0.15);
    let t347 = exp(t346);
    let t348 = min(t333, 0.15);
    let t349 = exp(t348);
    let t350 = min(t335, 0.15);
    let t351 = exp(t350);
    let t352 = min(t337, 0.15);
    let t353 = exp(t352);
    let t354 = min(t339, 0.15);
    let t355 = exp(t354);
    let t356 = t341 + t343;
    let t357 = t341 - t343;
    let t358 = t345 + t347;
    let t359 = t345 - t347;
    let t360 = t349 + t351;
    let t361 = t349 - t351;
    let t362 = t353 + t355;
    let t363 = t353 - t355;
    let t364 = t356 + t358;
    let t365 = t356 - t358;
    let t366 = t357 + t359;
    let t367 = t357 - t359;
    let t368 = t360 + t362;
    let t369 = t360 - t362;
    let t370 = t361 + t363;
    let t371 = t361 - t363;
    let t372 = t364 + t368;
    let t373 = t364 - t368;
    let t374 = t366 + t370;
    let t375 = t366 - t370;
    let t376 = t365 + t369;
    let t377 = t365 - t369;
    let t378 = t367 + t371;
    let t379 = t367 - t371;
    let t380 = fma(0.039385896, t372, t274);
    let t381 = fma(0.05815741, t376, t276);
    let t382 = fma(0.025213704, t373, t278);
    let t383 = fma(0.025213704, t374, t279);
    let t384 = fma(0.048064604, t378, t281);
    let t385 = fma(0.048064604, t377, t283);
    let t387 = fma(-t372, 0.025988493, t285);
    let t389 = fma(t375, 0.020838045, t286);
    let t391 = fma(-t372, 0.04501339, t65);
    let t393 = fma(-t376, 0.022261264, t288);
    let t394 = fma(0.04700128, t379, t290);
    let t396 = fma(-t376, 0.0172435, t292);
    let t398 = fma(-t373, 0.044618525, t294);
    let t400 = fma(-t374, 0.0074757887, t295);
    let t402 = t373 * 0.04401757;
    let t404 = fma(-t374, 0.062229186, t296);
    let t405 = f[3] * 0.4165426;
    let t406 = f[5] * 0.14924896;
    let t407 = fma(f[8], 0.32240078, t301);
    let t408 = fma(f[9], 0.445706, t188);
    let t409 = fma(-f[11], 0.05354407, t408);
    let t410 = fma(-f[13], 0.12350365, t405);
    let t411 = fma(f[14], 0.31526837, t311);
    let t412 = fma(f[15], 0.15944253, t410);
    let t413 = t407 + t412;
    let t414 = t407 - t412;
    let t415 = t299 + t409;
    let t416 = t409 - t299;
    let t417 = t198 + t411;
    let t418 = t411 - t198;
    let t419 = t202 + t406;
    let t420 = t406 - t202;
    let t421 = t413 + t415;
    let t422 = t413 - t415;
    let t423 = t414 + t416;
    let t424 = t414 - t416;
    let t425 = t417 + t419;
    let t426 = t417 - t419;
    let t427 = t418 + t420;
    let t428 = t418 - t420;
    let t429 = t421 + t425;
    let t430 = t421 - t425;
    let t431 = t423 + t427;
    let t432 = t423 - t427;
    let t433 = t422 + t426;
    let t434 = t422 - t426;
    let t435 = t424 + t428;
    let t436 = t424 - t428;
    let t437 = min(t429, 0.15);
    let t438 = exp(t437);
    let t439 = min(t431, 0.15);
    let t440 = exp(t439);
    let t441 = min(t433, 0.15);
    let t442 = exp(t441);
    let t443 = min(t435, 0.15);
    let t444 = exp(t443);
    let t445 = min(t430, 0.15);
    let t446 = exp(t445);
    let t447 = min(t432, 0.15);
    let t448 = exp(t447);
    let t449 = min(t434, 0.15);
    let t450 = exp(t449);
    let t451 = min(t436, 0.15);
    let t452 = exp(t451);
    let t453 = t438 + t440;
    let t454 = t438 - t440;
    let t455 = t442 + t444;
    let t456 = t442 - t444;
    let t457 = t446 + t448;
    let t458 = t446 - t448;
    let t459 = t450 + t452;
    let t460 = t450 - t452;
    let t461 = t453 + t455;
    let t462 = t453 - t455;
    let t463 = t454 + t456;
    let t464 = t454 - t456;
    let t465 = t457 + t459;
    let t466 = t457 - t459;
    let t467 = t458 + t460;
    let t468 = t458 - t460;
    let t469 = t461 + t465;
    let t470 = t461 - t465;
    let t471 = t463 + t467;
    let t472 = t463 - t467;
    let t473 = t462 + t466;
    let t474 = t462 - t466;
    let t475 = t464 + t468;
    let t476 = t464 - t468;
    let t477 = fma(0.039385896, t469, t380);
    let t478 = fma(0.025213704, t473, t381);
    let t479 = fma(0.025213704, t470, t382);
    let t480 = fma(0.05815741, t471, t383);
    let t481 = fma(0.048064604, t475, t384);
    let t482 = fma(0.020838045, t474, t385);
    let t483 = fma((-0.025988493), t469, t387);
    let t484 = fma(0.048064604, t472, t389);
    let t485 = fma(0.04501339, t469, t391);
    let t486 = fma(0.062229186, t473, t393);
    let t487 = fma(0.04700128, t476, t394);
    let t488 = fma((-0.0074757887), t473, t396);
    let t489 = fma((-0.044618525), t470, t398);
    let t490 = fma((-0.0172435), t471, t400);
    let t491 = fma(0.04401757, t470, -t402);
    let t492 = fma(0.022261264, t471, t404);
    let t494 = f[1] * 0.3392631;
    let t496 = f[2] * 0.092376925;
    let t497 = f[3] * 0.3392631;
    let t499 = f[4] * 0.52674764;
    let t501 = f[5] * 0.14342652;
    let t503 = fma(-f[6], 0.28157052, t19);
    let t504 = f[7] * 0.14342652;
    let t506 = fma(f[9], 0.39505443, t494);
    let t508 = f[10] * 0.26348713;
    let t510 = fma(-f[11], 0.26063287, t506);
    let t512 = fma(-f[12], 0.19905235, t496);
    let t513 = fma(-f[13], 0.26063287, t497);
    let t514 = fma(-f[15], 0.39505443, t513);
    let t515 = t503 + t514;
    let t516 = t503 - t514;
    let t517 = t499 + t510;
    let t518 = t510 - t499;
    let t519 = t504 + t512;
    let t520 = t512 - t504;
    let t521 = t501 + t508;
    let t522 = t501 - t508;
    let t523 = t515 + t517;
    let t524 = t515 - t517;
    let t525 = t516 + t518;
    let t526 = t516 - t518;
    let t527 = t519 + t521;
    let t528 = t519 - t521;
    let t529 = t520 + t522;
    let t530 = t520 - t522;
    let t531 = t523 + t527;
    let t532 = t523 - t527;
    let t533 = t525 + t529;
    let t534 = t525 - t529;
    let t535 = t524 + t528;
    let t536 = t524 - t528;
    let t537 = t526 + t530;
    let t538 = t526 - t530;
    let t539 = min(t531, 0.15);
    let t540 = exp(t539);
    let t541 = min(t533, 0.15);
    let t542 = exp(t541);
    let t543 = min(t535, 0.15);
    let t544 = exp(t543);
    let t545 = min(t537, 0.15);
    let t546 = exp(t545);
    let t547 = min(t532, 0.15);
    let t548 = exp(t547);
    let t549 = min(t534, 0.15);
    let t550 = exp(t549);
    let t551 = min(t536, 0.15);
    let t552 = exp(t551);
    let t553 = min(t538, 0.15);
    let t554 = exp(t553);
    let t555 = t540 + t542;
    let t556 = t540 - t542;
    let t557 = t544 + t546;
    let t558 = t544 - t546;
    let t559 = t548 + t550;
    let t560 = t548 - t550;
    let t561 = t552 + t554;
    let t562 = t552 - t554;
    let t563 = t555 + t557;
    let t564 = t555 - t557;
    let t565 = t556 + t558;
    let t566 = t556 - t558;
    let t567 = t559 + t561;
    let t568 = t559 - t561;
    let t569 = t560 + t562;
    let t570 = t560 - t562;
    let t571 = t563 + t567;
    let t572 = t563 - t567;
    let t573 = t565 + t569;
    let t574 = t565 - t569;
    let t575 = t564 + t568;
    let t576 = t564 - t568;
    let t577 = t566 + t570;
    let t578 = t566 - t570;
    let t580 = fma(t571, 0.0421011, t477);
    let t582 = fma(t575, 0.05063316, t478);
    let t584 = fma(t572, 0.01378675, t479);
    let t585 = fma(t573, 0.05063316, t480);
    let t587 = fma(t577, 0.0786142, t481);
    let t589 = fma(t576, 0.021405622, t482);
    let t591 = fma(-t571, 0.042022858, t483);
    let t592 = fma(t574, 0.021405622, t484);
    let t594 = fma(t575, 0.058959708, t486);
    let t596 = fma(t578, 0.03932401, t487);
    let t598 = fma(-t575, 0.03889803, t488);
    let t600 = fma(-t572, 0.02970747, t489);
    let t601 = fma(-t573, 0.03889803, t490);
    let t602 = fma(-t573, 0.058959708, t492);
    let t603 = f[1] * 0.092376925;
    let t604 = f[2] * 0.3392631;
    let t606 = f[4] * 0.14342652;
    let t607 = f[5] * 0.14342652;
    let t609 = fma(f[6], 0.14078526, t19);
    let t610 = f[7] * 0.52674764;
    let t612 = fma(f[8], 0.24384722, t609);
    let t614 = fma(f[9], 0.1573647, t603);
    let t616 = f[10] * 0.26348713;
    let t618 = fma(f[11], 0.12189417, t614);
    let t620 = fma(-f[12], 0.15271355, t604);
    let t622 = fma(f[13], 0.44766802, t497);
    let t624 = fma(f[14], 0.4479688, t620);
    let t626 = fma(f[15], 0.1535931, t622);
    let t627 = t612 + t626;
    let t628 = t612 - t626;
    let t629 = t606 + t618;
    let t630 = t618 - t606;
    let t631 = t610 + t624;
    let t632 = t624 - t610;
    let t633 = t607 + t616;
    let t634 = t607 - t616;
    let t635 = t627 + t629;
    let t636 = t627 - t629;
    let t637 = t628 + t630;
    let t638 = t628 - t630;
    let t639 = t631 + t633;
    let t640 = t631 - t633;
    let t641 = t632 + t634;
    let t642 = t632 - t634;
    let t643 = t635 + t639;
    let t644 = t635 - t639;
    let t645 = t637 + t641;
    let t646 = t637 - t641;
    let t647 = t636 + t640;
    let t648 = t636 - t640;
    let t649 = t638 + t642;
    let t650 = t638 - t642;
    let t651 = min(t643, 0.15);
    let t652 = exp(t651);
    let t653 = min(t645, 0.15);
    let t654 = exp(t653);
    let t655 = min(t647, 0.15);
    let t656 = exp(t655);
    let t657 = min(t649, 0.15);
    let t658 = exp(t657);
    let t659 = min(t644, 0.15);
    let t660 = exp(t659);
    let t661 = min(t646, 0.15);
    let t662 = exp(t661);
    let t663 = min(t648, 0.15);
    let t664 = exp(t663);
    let t665 = min(t650, 0.15);
    let t666 = exp(t665);
    let t667 = t652 + t654;
    let t668 = t652 - t654;
    let t669 = t656 + t658;
    let t670 = t656 - t658;
    let t671 = t660 + t662;
    let t672 = t660 - t662;
    let t673 = t664 + t666;
    let t674 = t664 - t666;
    let t675 = t667 + t669;
    let t676 = t667 - t669;
    let t677 = t668 + t670;
    let t678 = t668 - t670;
    let t679 = t671 + t673;
    let t680 = t671 - t673;
    let t681 = t672 + t674;
    let t682 = t672 - t674;
    let t683 = t675 + t679;
    let t684 = t675 - t679;
    let t685 = t677 + t681;
    let t686 = t677 - t681;
    let t687 = t676 + t680;
    let t688 = t676 - t680;
    let t689 = t678 + t682;
    let t690 = t678 - t682;
    let t691 = fma(0.0421011, t683, t580);
    let t692 = fma(0.01378675, t687, t582);
    let t693 = fma(0.05063316, t684, t584);
    let t694 = fma(0.05063316, t685, t585);
    let t696 = fma(t689, 0.021405622, t587);
    let t697 = fma(t688, 0.021405622, t589);
    let t699 = fma(t683, 0.021011429, t591);
    let t700 = fma(0.0786142, t686, t592);
    let t702 = fma(t683, 0.03639286, t485);
    let t704 = fma(t687, 0.023485819, t594);
    let t706 = fma(t690, 0.03932401, t596);
    let t708 = fma(t687, 0.018192036, t598);
    let t710 = fma(-t684, 0.022791661, t600);
    let t712 = fma(t685, 0.066812, t601);
    let t714 = fma(t684, 0.06685689, t491);
    let t716 = fma(t685, 0.022922928, t602);
    let t717 = f[3] * 0.092376925;
    let t718 = f[5] * 0.52674764;
    let t719 = f[7] * 0.14342652;
    let t720 = fma(-f[8], 0.24384722, t609);
    let t721 = fma(-f[9], 0.1535931, t494);
    let t722 = fma(f[11], 0.44766802, t721);
    let t723 = fma(f[13], 0.12189417, t717);
    let t724 = fma(-f[14], 0.4479688, t620);
    let t725 = fma(-f[15], 0.1573647, t723);
    let t726 = t720 + t725;
    let t727 = t720 - t725;
    let t728 = t606 + t722;
    let t729 = t722 - t606;
    let t730 = t719 + t724;
    let t731 = t724 - t719;
    let t732 = t616 + t718;
    let t733 = t718 - t616;
    let t734 = t726 + t728;
    let t735 = t726 - t728;
    let t736 = t727 + t729;
    let t737 = t727 - t729;
    let t738 = t730 + t732;
    let t739 = t730 - t732;
    let t740 = t731 + t733;
    let t741 = t731 - t733;
    let t742 = t734 + t738;
    let t743 = t734 - t738;
    let t744 = t736 + t740;
    let t745 = t736 - t740;
    let t746 = t735 + t739;
    let t747 = t735 - t739;
    let t748 = t737 + t741;
    let t749 = t737 - t741;
    let t750 = min(t742, 0.15);
    let t751 = exp(t750);
    let t752 = min(t744, 0.15);
    let t753 = exp(t752);
    let t754 = min(t746, 0.15);
    let t755 = exp(t754);
    let t756 = min(t748, 0.15);
    let t757 = exp(t756);
    let t758 = min(t743, 0.15);
    let t759 = exp(t758);
    let t760 = min(t745, 0.15);
    let t761 = exp(t760);
    let t762 = min(t747, 0.15);
    let t763 = exp(t762);
    let t764 = min(t749, 0.15);
    let t765 = exp(t764);
    let t766 = t751 + t753;
    let t767 = t751 - t753;
    let t768 = t755 + t757;
    let t769 = t755 - t757;
    let t770 = t759 + t761;
    let t771 = t759 - t761;
    let t772 = t763 + t765;
    let t773 = t763 - t765;
    let t774 = t766 + t768;
    let t775 = t766 - t768;
    let t776 = t767 + t769;
    let t777 = t767 - t769;
    let t778 = t770 + t772;
    let t779 = t770 - t772;
    let t780 = t771 + t773;
    let t781 = t771 - t773;
    let t782 = t774 + t778;
    let t783 = t774 - t778;
    let t784 = t776 + t780;
    let t785 = t776 - t780;
    let t786 = t775 + t779;
    let t787 = t775 - t779;
    let t788 = t777 + t781;
    let t789 = t777 - t781;
    let t790 = fma(0.0421011, t782, t691);
    let t791 = fma(0.05063316, t786, t692);
    let t792 = fma(0.05063316, t783, t693);
    let t793 = fma(0.01378675, t784, t694);
    let t794 = fma(0.021405622, t788, t696);
    let t795 = fma(0.0786142, t787, t697);
    let t796 = fma(0.021011429, t782, t699);
    let t797 = fma(0.021405622, t785, t700);
    let t798 = fma((-0.03639286), t782, t702);
    let t799 = fma((-0.022922928), t786, t704);
    let t800 = fma(0.03932401, t789, t706);
    let t801 = fma(0.066812, t786, t708);
    let t802 = fma((-0.022791661), t783, t710);
    let t803 = fma(0.018192036, t784, t712);
    let t804 = fma((-0.06685689), t783, t714);
    let t805 = fma((-0.023485819), t784, t716);
    let t807 = f[1] * 0.4530961;
    let t809 = f[3] * 0.18285608;
    let t811 = f[4] * 0.3791657;
    let t813 = fma(-f[8], 0.39325422, t23);
    let t815 = fma(-f[9], 0.2406262, t807);
    let t817 = fma(-f[11], 0.4238326, t815);
    let t819 = fma(-f[13], 0.17104621, t809);
    let t821 = fma(-f[15], 0.538749, t819);
    let t822 = t813 + t821;
    let t823 = t813 - t821;
    let t824 = t811 + t817;
    let t825 = t817 - t811;
    let t826 = t822 + t824;
    let t827 = t822 - t824;
    let t828 = t823 + t825;
    let t829 = t823 - t825;
    let t830 = min(t826, 0.15);
    let t831 = exp(t830);
    let t832 = min(t828, 0.15);
    let t833 = exp(t832);
    let t834 = min(t827, 0.15);
    let t835 = exp(t834);
    let t836 = min(t829, 0.15);
    let t837 = exp(t836);
    let t838 = t831 + t833;
    let t839 = t831 - t833;
    let t840 = t835 + t837;
    let t841 = t835 - t837;
    let t842 = t838 + t840;
    let t843 = t838 - t840;
    let t844 = t839 + t841;
    let t845 = t839 - t841;
    let t847 = fma(t842, 0.041873526, t790);
    let t849 = fma(t843, 0.06725658, t791);
    let t851 = fma(t844, 0.027142754, t793);
    let t853 = fma(t845, 0.056282517, t794);
    let t855 = fma(-t842, 0.046816025, t796);
    let t857 = fma(-t842, 0.058373787, t798);
    let t859 = fma(-t843, 0.03571802, t799);
    let t861 = fma(-t843, 0.06291277, t801);
    let t863 = fma(-t844, 0.02538972, t803);
    let t865 = fma(-t844, 0.07997071, t805);
    let t866 = f[2] * 0.4530961;
    let t868 = fma(f[6], 0.49826393, t19);
    let t869 = f[7] * 0.3791657;
    let t871 = fma(f[8], 0.07650999, t868);
    let t873 = fma(f[12], 0.4497751, t866);
    let t875 = fma(f[13], 0.564403, t809);
    let t877 = fma(f[14], 0.18771622, t873);
    let t879 = fma(f[15], 0.030927533, t875);
    let t880 = t871 + t879;
    let t881 = t871 - t879;
    let t882 = t869 + t877;
    let t883 = t877 - t869;
    let t884 = t880 + t882;
    let t885 = t880 - t882;
    let t886 = t881 + t883;
    let t887 = t881 - t883;
    let t888 = min(t884, 0.15);
    let t889 = exp(t888);
    let t890 = min(t886, 0.15);
    let t891 = exp(t890);
    let t892 = min(t885, 0.15);
    let t893 = exp(t892);
    let t894 = min(t887, 0.15);
    let t895 = exp(t894);
    let t896 = t889 + t891;
    let t897 = t889 - t891;
    let t898 = t893 + t895;
    let t899 = t893 - t895;
    let t900 = t896 + t898;
    let t901 = t896 - t898;
    let t902 = t897 + t899;
    let t903 = t897 - t899;
    let t904 = fma(0.041873526, t900, t847);
    let t905 = fma(0.06725658, t901, t792);
    let t906 = fma(0.027142754, t902, t851);
    let t908 = fma(t900, 0.0739612, t855);
    let t909 = fma(0.056282517, t903, t797);
    let t911 = fma(t900, 0.011356974, t857);
    let t913 = fma(t901, 0.066763625, t802);
    let t915 = fma(t902, 0.08377873, t863);
    let t917 = fma(t901, 0.02786418, t804);
    let t919 = fma(t902, 0.0045908145, t865);
    let t920 = f[1] * 0.18285608;
    let t921 = f[3] * 0.4530961;
    let t922 = fma(f[8], 0.39325422, t23);
    let t923 = fma(f[9], 0.538749, t920);
    let t924 = fma(-f[11], 0.17104621, t923);
    let t925 = fma(-f[13], 0.4238326, t921);
    let t926 = fma(f[15], 0.2406262, t925);
    let t927 = t922 + t926;
    let t928 = t922 - t926;
    let t929 = t811 + t924;
    let t930 = t924 - t811;
    let t931 = t927 + t929;
    let t932 = t927 - t929;
    let t933 = t928 + t930;
    let t934 = t928 - t930;
    let t935 = min(t931, 0.15);
    let t936 = exp(t935);
    let t937 = min(t933, 0.15);
    let t938 = exp(t937);
    let t939 = min(t932, 0.15);
    let t940 = exp(t939);
    let t941 = min(t934, 0.15);
    let t942 = exp(t941);
    let t943 = t936 + t938;
    let t944 = t936 - t938;
    let t945 = t940 + t942;
    let t946 = t940 - t942;
    let t947 = t943 + t945;
    let t948 = t943 - t945;
    let t949 = t944 + t946;
    let t950 = t944 - t946;
    let t951 = fma(0.041873526, t947, t904);
    let t952 = fma(0.027142754, t948, t849);
    let t953 = fma(0.06725658, t949, t906);
    let t954 = fma(0.056282517, t950, t853);
    let t955 = fma((-0.046816025), t947, t908);
    let t956 = fma(0.058373787, t947, t911);
    let t957 = fma(0.07997071, t948, t859);
    let t958 = fma((-0.02538972), t948, t861);
    let t959 = fma((-0.06291277), t949, t915);
    let t960 = fma(0.03571802, t949, t919);
    let t961 = f[2] * 0.18285608;
    let t963 = fma(-f[6], 0.18287237, t19);
    let t965 = fma(f[8], 0.46976423, t963);
    let t967 = fma(-f[12], 0.32117447, t961);
    let t969 = fma(-f[13], 0.12702717, t921);
    let t971 = fma(f[14], 0.46513894, t967);
    let t973 = fma(f[15], 0.4705307, t969);
    let t974 = t965 + t973;
    let t975 = t965 - t973;
    let t976 = t869 + t971;
    let t977 = t971 - t869;
    let t978 = t974 + t976;
    let t979 = t974 - t976;
    let t980 = t975 + t977;
    let t981 = t975 - t977;
    let t982 = min(t978, 0.15);
    let t983 = exp(t982);
    let t984 = min(t980, 0.15);
    let t985 = exp(t984);
    let t986 = min(t979, 0.15);
    let t987 = exp(t986);
    let t988 = min(t981, 0.15);
    let t989 = exp(t988);
    let t990 = t983 + t985;
    let t991 = t983 - t985;
    let t992 = t987 + t989;
    let t993 = t987 - t989;
    let t994 = t990 + t992;
    let t995 = t990 - t992;
    let t996 = t991 + t993;
    let t997 = t991 - t993;
    let t998 = fma(0.041873526, t994, t951);
    let t999 = fma(0.027142754, t995, t905);
    let t1000 = fma(0.06725658, t996, t953);
    let t1002 = fma(-t994, 0.02714517, t955);
    let t1003 = fma(0.056282517, t997, t909);
    let t1005 = fma(t994, 0.06973076, t956);
    let t1007 = fma(-t995, 0.04767443, t913);
    let t1009 = fma(-t996, 0.018855633, t959);
    let t1011 = fma(t995, 0.069044195, t917);
    let t1013 = fma(t996, 0.06984454, t960);
    let t1014 = f[5] * 0.3791657;
    let t1015 = fma(-f[8], 0.07650999, t868);
    let t1016 = fma(-f[9], 0.030927533, t920);
    let t1017 = fma(f[11], 0.564403, t1016);
    let t1018 = fma(-f[14], 0.18771622, t873);
    let t1019 = t1015 + t1017;
    let t1020 = t1015 - t1017;
    let t1021 = t1014 + t1018;
    let t1022 = t1018 - t1014;
    let t1023 = t1019 + t1021;
    let t1024 = t1019 - t1021;
    let t1025 = t1020 + t1022;
    let t1026 = t1020 - t1022;
    let t1027 = min(t1023, 0.15);
    let t1028 = exp(t1027);
    let t1029 = min(t1025, 0.15);
    let t1030 = exp(t1029);
    let t1031 = min(t1024, 0.15);
    let t1032 = exp(t1031);
    let t1033 = min(t1026, 0.15);
    let t1034 = exp(t1033);
    let t1035 = t1028 + t1030;
    let t1036 = t1028 - t1030;
    let t1037 = t1032 + t1034;
    let t1038 = t1032 - t1034;
    let t1039 = t1035 + t1037;
    let t1040 = t1035 - t1037;
    let t1041 = t1036 + t1038;
    let t1042 = t1036 - t1038;
    let t1043 = fma(0.041873526, t1039, t998);
    let t1044 = fma(0.027142754, t1041, t952);
    let t1045 = fma(0.06725658, t1040, t999);
    let t1046 = fma(0.056282517, t1042, t795);
    let t1047 = fma(0.0739612, t1039, t1002);
    let t1048 = fma((-0.011356974), t1039, t1005);
    let t1049 = fma((-0.0045908145), t1041, t957);
    let t1050 = fma(0.08377873, t1041, t958);
    let t1051 = fma(0.066763625, t1040, t1007);
    let t1052 = fma((-0.02786418), t1040, t1011);
    let t1053 = fma(-f[8], 0.46976423, t963);
    let t1054 = fma(-f[9], 0.4705307, t807);
    let t1055 = fma(-f[11], 0.12702717, t1054);
    let t1056 = fma(-f[14], 0.46513894, t967);
    let t1057 = t1053 + t1055;
    let t1058 = t1053 - t1055;
    let t1059 = t1014 + t1056;
    let t1060 = t1056 - t1014;
    let t1061 = t1057 + t1059;
    let t1062 = t1057 - t1059;
    let t1063 = t1058 + t1060;
    let t1064 = t1058 - t1060;
    let t1065 = min(t1061, 0.15);
    let t1066 = exp(t1065);
    let t1067 = min(t1063, 0.15);
    let t1068 = exp(t1067);
    let t1069 = min(t1062, 0.15);
    let t1070 = exp(t1069);
    let t1071 = min(t1064, 0.15);
    let t1072 = exp(t1071);
    let t1073 = t1066 + t1068;
    let t1074 = t1066 - t1068;
    let t1075 = t1070 + t1072;
    let t1076 = t1070 - t1072;
    let t1077 = t1073 + t1075;
    let t1078 = t1073 - t1075;
    let t1079 = t1074 + t1076;
    let t1080 = t1074 - t1076;
    let t1081 = fma(0.041873526, t1077, t1043);
    let t1082 = fma(0.06725658, t1079, t1044);
    let t1083 = fma(0.027142754, t1078, t1045);
    let t1084 = fma(0.056282517, t1080, t1046);
    let t1085 = fma((-0.02714517), t1077, t1047);
    let t1086 = fma((-0.06973076), t1077, t1048);
    let t1087 = fma((-0.06984454), t1079, t1049);
    let t1088 = fma((-0.018855633), t1079, t1050);
    let t1089 = fma((-0.04767443), t1078, t1051);
    let t1090 = fma((-0.069044195), t1078, t1052);
    return array<f32, 16>(
        t1081, t1082, t1083, t1000, t954, t1084, t1085, t1003, t1086, t1087, t800, t1088, t1089,
        t1009, t1090, t1013,
    );
}

// The factors a and b of the optimal linear exponential a*1 + b*f^ for a vector without DC, of norm |f^| <= 1/4.
// Source: Ren et al. 2006, eq. 23-24, fitted; `gaunt-lab fit` rewrites the coefficients and states their error.
// 6 multiplications, 6 additions.
fn sh4_optimal_linear(norm: f32) -> vec2<f32> {
    let t4 = fma(-norm, 0.006786564, 0.039769206);
    let t6 = fma(norm, t4, 8.197068e-7);
    let t8 = fma(norm, t6, 1.0);
    let t11 = fma(norm, 0.02156885, 0.017322605);
    let t13 = fma(norm, t11, (-0.26014957));
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
fn sh4_optimal_linear_wide(norm: f32) -> vec2<f32> {
    let t2 = min(norm, 6.4693594);
    let t4 = t2 * 0.15457481;
    let t8 = fma(-t4, 785.59753, 2775.465);
    let t10 = fma(t4, t8, (-3888.286));
    let t12 = fma(t4, t10, 2760.571);
    let t14 = fma(t4, t12, (-1050.5603));
    let t16 = fma(t4, t14, 207.15282);
    let t18 = fma(t4, t16, (-17.520998));
    let t20 = fma(t4, t18, 0.58013105);
    let t22 = fma(t4, t20, 1.0);
    let t25 = fma(-t4, 391.21716, 1263.1042);
    let t27 = fma(t4, t25, (-1585.1271));
    let t29 = fma(t4, t27, 985.9454);
    let t31 = fma(t4, t29, (-321.02054));
    let t33 = fma(t4, t31, 52.245518);
    let t35 = fma(t4, t33, (-1.9510844));
    let t37 = fma(t4, t35, (-1.6519163));
    let t38 = fma(t4, t37, 1.0);
    return vec2<f32>(
        t22, t38,
    );
}

// Zonal coefficients of the eigen logarithm of the visibility past a circular blocker about +Z whose angular radius
// is a whole number of degrees, 0..=179; beyond that as at 179. The rows of the table behind `cap_log_table`.
// Source: Ren et al. 2006, eq. 30-32, clipped at 0.02; `gaunt-lab fit` computes it.
fn sh4_cap_log_row(row: u32) -> array<f32, 4> {
    var z = array<f32, 4>();
    if (row < 90u) {
        if (row < 45u) {
            if (row < 22u) {
                if (row < 11u) {
                    if (row < 5u) {
                        if (row < 2u) {
                            if (row < 1u) {
                                z = array<f32, 4>(0.0, 0.0, 0.0, 0.0);
                            } else {
                                z = array<f32, 4>(-0.00027011774, -0.00046775088, -0.00060372805, -0.00071409985);
                            }
                        } else {
                            if (row < 3u) {
                                z = array<f32, 4>(-0.0010823611, -0.001872998, -0.0024158587, -0.002854631);
                            } else {
                                if (row < 4u) {
                                    z = array<f32, 4>(-0.0024423923, -0.0042217267, -0.005439234, -0.0064163087);
                                } else {
                                    z = array<f32, 4>(-0.004359622, -0.0075239195, -0.009678602, -0.011390391);
                                }
                            }
                        }
                    } else {
                        if (row < 8u) {
                            if (row < 6u) {
                                z = array<f32, 4>(-0.0068471725, -0.011793568, -0.015140638, -0.017764777);
                            } else {
                                if (row < 7u) {
                                    z = array<f32, 4>(-0.009921824, -0.017048687, -0.021833966, -0.025524149);
                                } else {
                                    z = array<f32, 4>(-0.013603957, -0.02331134, -0.029769193, -0.03465014);
                                }
                            }
                        } else {
                            if (row < 9u) {
                                z = array<f32, 4>(-0.017917478, -0.030607663, -0.03895896, -0.04512155);
                            } else {
                                if (row < 10u) {
                                    z = array<f32, 4>(-0.022889752, -0.038967915, -0.049418, -0.056914605);
                                } else {
                                    z = array<f32, 4>(-0.028551523, -0.048426513, -0.061163183, -0.07000322);
                                }
                            }
                        }
                    }
                } else {
                    if (row < 16u) {
                        if (row < 13u) {
                            if (row < 12u) {
                                z = array<f32, 4>(-0.03493684, -0.05902209, -0.07421365, -0.08435932);
                            } else {
                                z = array<f32, 4>(-0.042083014, -0.07079761, -0.088590845, -0.0999532);
                            }
                        } else {
                            if (row < 14u) {
                                z = array<f32, 4>(-0.05003054, -0.08380039, -0.10431872, -0.11675389);
                            } else {
                                if (row < 15u) {
                                    z = array<f32, 4>(-0.058823094, -0.098082304, -0.12142381, -0.1347296);
                                } else {
                                    z = array<f32, 4>(-0.06850752, -0.11369987, -0.13993545, -0.15384808);
                                }
                            }
                        }
                    } else {
                        if (row < 19u) {
                            if (row < 17u) {
                                z = array<f32, 4>(-0.07913386, -0.13071445, -0.15988599, -0.17407723);
                            } else {
                                if (row < 18u) {
                                    z = array<f32, 4>(-0.09075542, -0.14919247, -0.18131101, -0.1953855);
                                } else {
                                    z = array<f32, 4>(-0.10342887, -0.16920564, -0.20424967, -0.2177425);
                                }
                            }
                        } else {
                            if (row < 20u) {
                                z = array<f32, 4>(-0.11721444, -0.1908314, -0.22874498, -0.2411196);
                            } else {
                                if (row < 21u) {
                                    z = array<f32, 4>(-0.13217615, -0.21415316, -0.25484437, -0.26549053);
                                } else {
                                    z = array<f32, 4>(-0.14838205, -0.23926093, -0.2826001, -0.2908322);
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
                                z = array<f32, 4>(-0.16590475, -0.26625177, -0.31206986, -0.3171253);
                            } else {
                                z = array<f32, 4>(-0.18482178, -0.29523066, -0.34331757, -0.3443554);
                            }
                        } else {
                            if (row < 25u) {
                                z = array<f32, 4>(-0.20521629, -0.3263112, -0.37641424, -0.37251368);
                            } else {
                                if (row < 26u) {
                                    z = array<f32, 4>(-0.22717781, -0.35961688, -0.41143906, -0.4015983);
                                } else {
                                    z = array<f32, 4>(-0.2508032, -0.3952822, -0.44848078, -0.4316154);
                                }
                            }
                        }
                    } else {
                        if (row < 30u) {
                            if (row < 28u) {
                                z = array<f32, 4>(-0.27619776, -0.43345445, -0.48763913, -0.46258086);
                            } else {
                                if (row < 29u) {
                                    z = array<f32, 4>(-0.30347678, -0.47429562, -0.52902704, -0.49452177);
                                } else {
                                    z = array<f32, 4>(-0.33276713, -0.5179849, -0.5727729, -0.5274787);
                                }
                            }
                        } else {
                            if (row < 31u) {
                                z = array<f32, 4>(-0.36420968, -0.564722, -0.6190238, -0.5615083);
                            } else {
                                if (row < 32u) {
                                    z = array<f32, 4>(-0.39796177, -0.61473066, -0.6679492, -0.59668624);
                                } else {
                                    z = array<f32, 4>(-0.43420094, -0.6682642, -0.719746, -0.6331111);
                                }
                            }
                        }
                    }
                } else {
                    if (row < 39u) {
                        if (row < 36u) {
                            if (row < 34u) {
                                z = array<f32, 4>(-0.47312915, -0.7256117, -0.7746447, -0.6709096);
                            } else {
                                if (row < 35u) {
                                    z = array<f32, 4>(-0.5149785, -0.7871063, -0.8329177, -0.71024257);
                                } else {
                                    z = array<f32, 4>(-0.56001884, -0.8531366, -0.8948902, -0.7513136);
                                }
                            }
                        } else {
                            if (row < 37u) {
                                z = array<f32, 4>(-0.6085675, -0.9241613, -0.9609543, -0.79438);
                            } else {
                                if (row < 38u) {
                                    z = array<f32, 4>(-0.66100293, -1.0007297, -1.0315893, -0.8397678);
                                } else {
                                    z = array<f32, 4>(-0.71778345, -1.0835094, -1.1073889, -0.8878932);
                                }
                            }
                        }
                    } else {
                        if (row < 42u) {
                            if (row < 40u) {
                                z = array<f32, 4>(-0.77947384, -1.1733268, -1.1891004, -0.9392921);
                            } else {
                                if (row < 41u) {
                                    z = array<f32, 4>(-0.84678423, -1.2712256, -1.2776824, -0.99466413);
                                } else {
                                    z = array<f32, 4>(-0.92062896, -1.3785557, -1.3743916, -1.0549397);
                                }
                            }
                        } else {
                            if (row < 43u) {
                                z = array<f32, 4>(-1.0022188, -1.497112, -1.48092, -1.1213844);
                            } else {
                                if (row < 44u) {
                                    z = array<f32, 4>(-1.093213, -1.629364, -1.59962, -1.1957726);
                                } else {
                                    z = array<f32, 4>(-1.1959835, -1.7788551, -1.7338982, -1.2806904);
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
                                z = array<f32, 4>(-1.314112, -1.9509507, -1.8889539, -1.3801045);
                            } else {
                                z = array<f32, 4>(-1.4534141, -2.1543846, -2.0733056, -1.500542);
                            }
                        } else {
                            if (row < 48u) {
                                z = array<f32, 4>(-1.6243582, -2.4049027, -2.302395, -1.653879);
                            } else {
                                if (row < 49u) {
                                    z = array<f32, 4>(-1.8490393, -2.7357717, -2.6089911, -1.8654029);
                                } else {
                                    z = array<f32, 4>(-2.1232529, -3.1410491, -2.9862735, -2.1288435);
                                }
                            }
                        }
                    } else {
                        if (row < 53u) {
                            if (row < 51u) {
                                z = array<f32, 4>(-2.1765656, -3.2145517, -3.0293221, -2.1272352);
                            } else {
                                if (row < 52u) {
                                    z = array<f32, 4>(-2.229572, -3.2864134, -3.0686252, -2.1209583);
                                } else {
                                    z = array<f32, 4>(-2.2821648, -3.3563468, -3.103841, -2.109781);
                                }
                            }
                        } else {
                            if (row < 54u) {
                                z = array<f32, 4>(-2.33425, -3.4240773, -3.1346428, -2.0934927);
                            } else {
                                if (row < 55u) {
                                    z = array<f32, 4>(-2.3858943, -3.4895682, -3.1609395, -2.0720716);
                                } else {
                                    z = array<f32, 4>(-2.437339, -3.553043, -3.1828916, -2.0456922);
                                }
                            }
                        }
                    }
                } else {
                    if (row < 61u) {
                        if (row < 58u) {
                            if (row < 57u) {
                                z = array<f32, 4>(-2.4888692, -3.614789, -3.2007172, -2.0145738);
                            } else {
                                z = array<f32, 4>(-2.540744, -3.6750531, -3.2145872, -1.978898);
                            }
                        } else {
                            if (row < 59u) {
                                z = array<f32, 4>(-2.5931973, -3.73404, -3.2246237, -1.938811);
                            } else {
                                if (row < 60u) {
                                    z = array<f32, 4>(-2.6464512, -3.7919343, -3.2309227, -1.8944378);
                                } else {
                                    z = array<f32, 4>(-2.700727, -3.8489153, -3.233568, -1.8458949);
                                }
                            }
                        }
                    } else {
                        if (row < 64u) {
                            if (row < 62u) {
                                z = array<f32, 4>(-2.7562501, -3.9051669, -3.2326384, -1.7932948);
                            } else {
                                if (row < 63u) {
                                    z = array<f32, 4>(-2.813255, -3.9608808, -3.2282114, -1.7367476);
                                } else {
                                    z = array<f32, 4>(-2.871863, -4.0160728, -3.22019, -1.6762375);
                                }
                            }
                        } else {
                            if (row < 65u) {
                                z = array<f32, 4>(-2.931746, -4.0700707, -3.2078252, -1.611293);
                            } else {
                                if (row < 66u) {
                                    z = array<f32, 4>(-2.9938104, -4.1240764, -3.1921186, -1.5426838);
                                } else {
                                    z = array<f32, 4>(-3.0583305, -4.1783247, -3.1731427, -1.4705085);
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
                                z = array<f32, 4>(-3.1255958, -4.233062, -3.150967, -1.3948582);
                            } else {
                                z = array<f32, 4>(-3.1959095, -4.2885504, -3.1256566, -1.3158159);
                            }
                        } else {
                            if (row < 70u) {
                                z = array<f32, 4>(-3.2695909, -4.345065, -3.0972698, -1.2334518);
                            } else {
                                if (row < 71u) {
                                    z = array<f32, 4>(-3.346977, -4.4028926, -3.0658548, -1.1478211);
                                } else {
                                    z = array<f32, 4>(-3.428422, -4.462333, -3.0314467, -1.05896);
                                }
                            }
                        }
                    } else {
                        if (row < 75u) {
                            if (row < 73u) {
                                z = array<f32, 4>(-3.5142999, -4.5236983, -2.994063, -0.9668817);
                            } else {
                                if (row < 74u) {
                                    z = array<f32, 4>(-3.6050045, -4.587309, -2.9536984, -0.8715715);
                                } else {
                                    z = array<f32, 4>(-3.700951, -4.6534915, -2.9103196, -0.7729813);
                                }
                            }
                        } else {
                            if (row < 76u) {
                                z = array<f32, 4>(-3.8025749, -4.722577, -2.8638556, -0.6710237);
                            } else {
                                if (row < 77u) {
                                    z = array<f32, 4>(-3.9103317, -4.7948933, -2.8141894, -0.5655652);
                                } else {
                                    z = array<f32, 4>(-4.024693, -4.8707557, -2.761146, -0.45641857);
                                }
                            }
                        }
                    }
                } else {
                    if (row < 84u) {
                        if (row < 81u) {
                            if (row < 79u) {
                                z = array<f32, 4>(-4.1461406, -4.950455, -2.7044766, -0.34333557);
                            } else {
                                if (row < 80u) {
                                    z = array<f32, 4>(-4.2751555, -5.03424, -2.643842, -0.22600006);
                                } else {
                                    z = array<f32, 4>(-4.412199, -5.122288, -2.5787919, -0.10402284);
                                }
                            }
                        } else {
                            if (row < 82u) {
                                z = array<f32, 4>(-4.5576835, -5.2146735, -2.5087414, 0.023058632);
                            } else {
                                if (row < 83u) {
                                    z = array<f32, 4>(-4.711933, -5.311314, -2.4329488, 0.15577261);
                                } else {
                                    z = array<f32, 4>(-4.875119, -5.411913, -2.3504982, 0.29469094);
                                }
                            }
                        }
                    } else {
                        if (row < 87u) {
                            if (row < 85u) {
                                z = array<f32, 4>(-5.0471783, -5.5158796, -2.260291, 0.44038466);
                            } else {
                                if (row < 86u) {
                                    z = array<f32, 4>(-5.2277102, -5.622247, -2.1610675, 0.59334755);
                                } else {
                                    z = array<f32, 4>(-5.4158554, -5.7295957, -2.051466, 0.75387883);
                                }
                            }
                        } else {
                            if (row < 88u) {
                                z = array<f32, 4>(-5.6101794, -5.8360066, -1.9301444, 0.92192286);
                            } else {
                                if (row < 89u) {
                                    z = array<f32, 4>(-5.8086, -5.9390836, -1.795971, 1.0968786);
                                } else {
                                    z = array<f32, 4>(-6.0083985, -6.036082, -1.6482792, 1.2774175);
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
                                z = array<f32, 4>(-6.206373, -6.124167, -1.4871376, 1.4613732);
                            } else {
                                z = array<f32, 4>(-6.399146, -6.200774, -1.3135533, 1.645778);
                            }
                        } else {
                            if (row < 93u) {
                                z = array<f32, 4>(-6.583584, -6.2639937, -1.1295184, 1.827091);
                            } else {
                                if (row < 94u) {
                                    z = array<f32, 4>(-6.7572193, -6.3128595, -0.93783915, 2.0015929);
                                } else {
                                    z = array<f32, 4>(-6.91855, -6.3474402, -0.74178004, 2.1658452);
                                }
                            }
                        }
                    } else {
                        if (row < 98u) {
                            if (row < 96u) {
                                z = array<f32, 4>(-7.06298, -6.3645744, -0.5435996, 2.3159733);
                            } else {
                                if (row < 97u) {
                                    z = array<f32, 4>(-7.182767, -6.358124, -0.34519777, 2.4471476);
                                } else {
                                    z = array<f32, 4>(-7.2893176, -6.3405447, -0.15211949, 2.560663);
                                }
                            }
                        } else {
                            if (row < 99u) {
                                z = array<f32, 4>(-7.38438, -6.3139825, 0.033870425, 2.6563835);
                            } else {
                                if (row < 100u) {
                                    z = array<f32, 4>(-7.469838, -6.2803745, 0.21170162, 2.734794);
                                } else {
                                    z = array<f32, 4>(-7.5475254, -6.241349, 0.380867, 2.796774);
                                }
                            }
                        }
                    }
                } else {
                    if (row < 106u) {
                        if (row < 103u) {
                            if (row < 102u) {
                                z = array<f32, 4>(-7.619118, -6.198206, 0.5412727, 2.8434095);
                            } else {
                                z = array<f32, 4>(-7.686092, -6.151941, 0.6931015, 2.875857);
                            }
                        } else {
                            if (row < 104u) {
                                z = array<f32, 4>(-7.749717, -6.1032968, 0.836704, 2.8952541);
                            } else {
                                if (row < 105u) {
                                    z = array<f32, 4>(-7.811079, -6.052815, 0.972519, 2.9026678);
                                } else {
                                    z = array<f32, 4>(-7.871102, -6.000885, 1.1010187, 2.8990686);
                                }
                            }
                        }
                    } else {
                        if (row < 109u) {
                            if (row < 107u) {
                                z = array<f32, 4>(-7.9305816, -5.947785, 1.2226733, 2.8853216);
                            } else {
                                if (row < 108u) {
                                    z = array<f32, 4>(-7.9902096, -5.893716, 1.3379287, 2.862186);
                                } else {
                                    z = array<f32, 4>(-8.050596, -5.838826, 1.447192, 2.8303187);
                                }
                            }
                        } else {
                            if (row < 110u) {
                                z = array<f32, 4>(-8.112292, -5.7832346, 1.5508229, 2.7902808);
                            } else {
                                if (row < 111u) {
                                    z = array<f32, 4>(-8.175802, -5.727045, 1.649126, 2.7425418);
                                } else {
                                    z = array<f32, 4>(-8.241597, -5.6703606, 1.7423427, 2.6874833);
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
                                z = array<f32, 4>(-8.310129, -5.613301, 1.8306406, 2.6253994);
                            } else {
                                z = array<f32, 4>(-8.381837, -5.556016, 1.9140966, 2.5564926);
                            }
                        } else {
                            if (row < 115u) {
                                z = array<f32, 4>(-8.457162, -5.498713, 1.9926724, 2.4808648);
                            } else {
                                if (row < 116u) {
                                    z = array<f32, 4>(-8.53656, -5.441685, 2.0661733, 2.3985002);
                                } else {
                                    z = array<f32, 4>(-8.620522, -5.3853683, 2.1341853, 2.3092365);
                                }
                            }
                        }
                    } else {
                        if (row < 120u) {
                            if (row < 118u) {
                                z = array<f32, 4>(-8.709614, -5.3304296, 2.1959708, 2.2127173);
                            } else {
                                if (row < 119u) {
                                    z = array<f32, 4>(-8.804545, -5.2779155, 2.2503002, 2.108315);
                                } else {
                                    z = array<f32, 4>(-8.906303, -5.229529, 2.2951667, 1.9950064);
                                }
                            }
                        } else {
                            if (row < 121u) {
                                z = array<f32, 4>(-9.016436, -5.1881347, 2.3272953, 1.8711627);
                            } else {
                                if (row < 122u) {
                                    z = array<f32, 4>(-9.137658, -5.158751, 2.3412762, 1.7342035);
                                } else {
                                    z = array<f32, 4>(-9.27526, -5.1505694, 2.328015, 1.5800272);
                                }
                            }
                        }
                    }
                } else {
                    if (row < 129u) {
                        if (row < 126u) {
                            if (row < 124u) {
                                z = array<f32, 4>(-9.44051, -5.1812496, 2.2719996, 1.4021597);
                            } else {
                                if (row < 125u) {
                                    z = array<f32, 4>(-9.580699, -5.1221905, 2.3237672, 1.2722439);
                                } else {
                                    z = array<f32, 4>(-9.728443, -5.059587, 2.3766656, 1.137361);
                                }
                            }
                        } else {
                            if (row < 127u) {
                                z = array<f32, 4>(-9.884743, -4.994742, 2.4289536, 0.996278);
                            } else {
                                if (row < 128u) {
                                    z = array<f32, 4>(-10.049864, -4.927288, 2.4807303, 0.84859335);
                                } else {
                                    z = array<f32, 4>(-10.223981, -4.856771, 2.5320766, 0.6938559);
                                }
                            }
                        }
                    } else {
                        if (row < 132u) {
                            if (row < 130u) {
                                z = array<f32, 4>(-10.407138, -4.782635, 2.583046, 0.53157216);
                            } else {
                                if (row < 131u) {
                                    z = array<f32, 4>(-10.599199, -4.70422, 2.6336498, 0.36122262);
                                } else {
                                    z = array<f32, 4>(-10.79979, -4.620753, 2.6838405, 0.18228969);
                                }
                            }
                        } else {
                            if (row < 133u) {
                                z = array<f32, 4>(-11.008223, -4.531363, 2.7334883, -0.0056961905);
                            } else {
                                if (row < 134u) {
                                    z = array<f32, 4>(-11.223419, -4.4351063, 2.7823577, -0.20308731);
                                } else {
                                    z = array<f32, 4>(-11.443827, -4.3310194, 2.8300805, -0.41002086);
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
                                z = array<f32, 4>(-11.667369, -4.2182093, 2.8761342, -0.6262915);
                            } else {
                                z = array<f32, 4>(-11.891432, -4.0959873, 2.9198337, -0.85120124);
                            }
                        } else {
                            if (row < 138u) {
                                z = array<f32, 4>(-12.112947, -3.9640362, 2.9603446, -1.083409);
                            } else {
                                if (row < 139u) {
                                    z = array<f32, 4>(-12.328581, -3.8225982, 2.9967332, -1.320819);
                                } else {
                                    z = array<f32, 4>(-12.535062, -3.67263, 3.028054, -1.5605625);
                                }
                            }
                        }
                    } else {
                        if (row < 143u) {
                            if (row < 141u) {
                                z = array<f32, 4>(-12.729598, -3.515874, 3.053472, -1.7991242);
                            } else {
                                if (row < 142u) {
                                    z = array<f32, 4>(-12.910304, -3.3547838, 3.072392, -2.0326297);
                                } else {
                                    z = array<f32, 4>(-13.076512, -3.1922946, 3.0845616, -2.2572563);
                                }
                            }
                        } else {
                            if (row < 144u) {
                                z = array<f32, 4>(-13.228869, -3.0314767, 3.0901124, -2.4696655);
                            } else {
                                if (row < 145u) {
                                    z = array<f32, 4>(-13.369191, -2.8751688, 3.08953, -2.6673427);
                                } else {
                                    z = array<f32, 4>(-13.500122, -2.7256868, 3.08356, -2.8487592);
                                }
                            }
                        }
                    }
                } else {
                    if (row < 151u) {
                        if (row < 148u) {
                            if (row < 147u) {
                                z = array<f32, 4>(-13.624734, -2.5846746, 3.0730894, -3.0133452);
                            } else {
                                z = array<f32, 4>(-13.746163, -2.4530916, 3.0590327, -3.1613247);
                            }
                        } else {
                            if (row < 149u) {
                                z = array<f32, 4>(-13.867347, -2.3313074, 3.0422492, -3.2934842);
                            } else {
                                if (row < 150u) {
                                    z = array<f32, 4>(-13.990895, -2.2192411, 3.0234919, -3.4109466);
                                } else {
                                    z = array<f32, 4>(-14.119047, -2.1165087, 3.003389, -3.5149863);
                                }
                            }
                        }
                    } else {
                        if (row < 154u) {
                            if (row < 152u) {
                                z = array<f32, 4>(-14.253704, -2.0225477, 2.9824467, -3.6068983);
                            } else {
                                if (row < 153u) {
                                    z = array<f32, 4>(-14.396483, -1.9367105, 2.961061, -3.6879184);
                                } else {
                                    z = array<f32, 4>(-14.548797, -1.8583298, 2.9395373, -3.7591808);
                                }
                            }
                        } else {
                            if (row < 155u) {
                                z = array<f32, 4>(-14.711919, -1.7867572, 2.9181068, -3.8217037);
                            } else {
                                if (row < 156u) {
                                    z = array<f32, 4>(-14.887052, -1.7213862, 2.896944, -3.8763883);
                                } else {
                                    z = array<f32, 4>(-15.075381, -1.661662, 2.87618, -3.9240286);
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
                                z = array<f32, 4>(-15.278123, -1.6070839, 2.855913, -3.9653244);
                            } else {
                                z = array<f32, 4>(-15.496575, -1.5572044, 2.836217, -4.0008936);
                            }
                        } else {
                            if (row < 160u) {
                                z = array<f32, 4>(-15.73215, -1.5116245, 2.817148, -4.0312867);
                            } else {
                                if (row < 161u) {
                                    z = array<f32, 4>(-15.986427, -1.4699897, 2.7987492, -4.056996);
                                } else {
                                    z = array<f32, 4>(-16.261192, -1.4319841, 2.7810535, -4.078468);
                                }
                            }
                        }
                    } else {
                        if (row < 165u) {
                            if (row < 163u) {
                                z = array<f32, 4>(-16.558498, -1.397327, 2.7640882, -4.09611);
                            } else {
                                if (row < 164u) {
                                    z = array<f32, 4>(-16.880722, -1.365767, 2.747874, -4.110297);
                                } else {
                                    z = array<f32, 4>(-17.23066, -1.3370793, 2.73243, -4.1213794);
                                }
                            }
                        } else {
                            if (row < 166u) {
                                z = array<f32, 4>(-17.611624, -1.3110619, 2.7177713, -4.129684);
                            } else {
                                if (row < 167u) {
                                    z = array<f32, 4>(-18.027592, -1.2875326, 2.7039127, -4.1355195);
                                } else {
                                    z = array<f32, 4>(-18.4834, -1.2663271, 2.6908677, -4.13918);
                                }
                            }
                        }
                    }
                } else {
                    if (row < 174u) {
                        if (row < 171u) {
                            if (row < 169u) {
                                z = array<f32, 4>(-18.98502, -1.2472969, 2.6786497, -4.1409464);
                            } else {
                                if (row < 170u) {
                                    z = array<f32, 4>(-19.539951, -1.2303067, 2.6672719, -4.141088);
                                } else {
                                    z = array<f32, 4>(-20.157797, -1.2152344, 2.6567483, -4.139864);
                                }
                            }
                        } else {
                            if (row < 172u) {
                                z = array<f32, 4>(-20.851162, -1.2019689, 2.6470933, -4.1375265);
                            } else {
                                if (row < 173u) {
                                    z = array<f32, 4>(-21.637054, -1.1904095, 2.6383235, -4.1343193);
                                } else {
                                    z = array<f32, 4>(-22.539257, -1.1804653, 2.630456, -4.1304812);
                                }
                            }
                        }
                    } else {
                        if (row < 177u) {
                            if (row < 175u) {
                                z = array<f32, 4>(-23.592516, -1.1720543, 2.6235101, -4.126246);
                            } else {
                                if (row < 176u) {
                                    z = array<f32, 4>(-24.850597, -1.1651022, 2.6175086, -4.121846);
                                } else {
                                    z = array<f32, 4>(-26.403444, -1.1595434, 2.6124773, -4.1175165);
                                }
                            }
                        } else {
                            if (row < 178u) {
                                z = array<f32, 4>(-28.419476, -1.1553184, 2.6084476, -4.1134996);
                            } else {
                                if (row < 179u) {
                                    z = array<f32, 4>(-31.27651, -1.1523738, 2.6054595, -4.11006);
                                } else {
                                    z = array<f32, 4>(-36.179527, -1.1506591, 2.6035688, -4.107518);
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
const sh4_ROOT_FOUR_PI: f32 = 3.5449078;

// The largest finite number in half precision: (2 - 1/1024) * 32768. What is beyond is brought there.
const sh4_HALF_MAX: f32 = 65504.0;

// f without DC and over 2^p, the norm of that, p, and the root of the DC factor.
struct sh4_Halved {
    rest: array<f32, 16>,
    norm: f32,
    halvings: u32,
    root: f32,
}

fn sh4_halved(f: array<f32, 16>) -> sh4_Halved {
    var result = sh4_Halved(f, 0.0, 0u, 1.0);
    result.rest[0] = 0.0;
    result.norm = sqrt(sh4_dot(result.rest, result.rest));
    var scale = 1.0;
    while (result.norm >= 0.25 && result.halvings < 132u) {
        result.norm *= 0.5;
        scale *= 0.5;
        result.halvings += 1u;
    }
    for (var i = 1u; i < 16u; i += 1u) {
        result.rest[i] *= scale;
    }
    result.root = exp(f[0] * scale / sh4_ROOT_FOUR_PI);
    return result;
}

fn sh4_squared(g: array<f32, 16>, times: u32) -> array<f32, 16> {
    var result = g;
    for (var i = 0u; i < times; i += 1u) {
        result = sh4_square(result);
    }
    return result;
}

// sum + weight * term.
fn sh4_plus(sum: array<f32, 16>, weight: f32, term: array<f32, 16>) -> array<f32, 16> {
    var result = sum;
    for (var i = 0u; i < 16u; i += 1u) {
        result[i] += weight * term[i];
    }
    return result;
}

// PS-p: the plain product series up to `degree` (equation 17).
fn sh4_exp_product_series(f: array<f32, 16>, degree: u32) -> array<f32, 16> {
    var sum = array<f32, 16>();
    sum[0] = sh4_ROOT_FOUR_PI;
    var term = sum;
    var factorial = 1.0;
    for (var k = 1u; k <= degree; k += 1u) {
        term = sh4_product(term, f);
        factorial /= f32(k);
        sum = sh4_plus(sum, factorial, term);
    }
    return sum;
}

// PS*-p: the product series up to `degree`, even and odd powers apart (equation 22), scaled and squared.
fn sh4_exp_ps_star(f: array<f32, 16>, degree: u32) -> array<f32, 16> {
    let parts = sh4_halved(f);
    let square = sh4_square(parts.rest);
    var power = array<f32, 16>();
    power[0] = sh4_ROOT_FOUR_PI;
    var even = power;
    var odd = array<f32, 16>();
    var factorial = 1.0;
    for (var k = 0u; k <= degree; k += 2u) {
        if (k > 0u) {
            power = sh4_product(power, square);
            factorial /= f32(k * (k - 1u));
            even = sh4_plus(even, factorial, power);
        }
        if (k < degree) {
            odd = sh4_plus(odd, factorial / f32(k + 1u), power);
        }
    }
    var sum = sh4_plus(even, 1.0, sh4_product(parts.rest, odd));
    for (var i = 0u; i < 16u; i += 1u) {
        sum[i] *= parts.root;
    }
    return sh4_squared(sum, parts.halvings);
}

// HYB: the optimal linear a 1 + b f, with a and b fitted as functions of the norm (equations 23 and 24), scaled
// and squared.
fn sh4_exp_hyb(f: array<f32, 16>) -> array<f32, 16> {
    let parts = sh4_halved(f);
    let factors = parts.root * sh4_optimal_linear(parts.norm);
    var sum = array<f32, 16>();
    sum[0] = factors.x * sh4_ROOT_FOUR_PI;
    return sh4_squared(sh4_plus(sum, factors.y, parts.rest), parts.halvings);
}

// OL: the optimal linear a 1 + b f for any norm, neither scaled nor squared.
fn sh4_exp_optimal_linear(f: array<f32, 16>) -> array<f32, 16> {
    var rest = f;
    rest[0] = 0.0;
    let factors = exp(f[0] / sh4_ROOT_FOUR_PI) * sh4_optimal_linear_wide(sqrt(sh4_dot(rest, rest)));
    var sum = array<f32, 16>();
    sum[0] = factors.x * sh4_ROOT_FOUR_PI;
    return sh4_plus(sum, factors.y, rest);
}

// Zonal coefficients of the eigen logarithm of the visibility past a circular blocker about +Z whose angular radius is
// `angle`, interpolated between whole degrees; beyond 179 degrees it stays as it is there.
//
// Interpolation errs by at most 0.11 up to 150 degrees and by 0.42 from there on.
// Source: Ren et al. 2006, eq. 30-32, tabulated.
fn sh4_cap_log_table(angle: f32) -> array<f32, 4> {
    let place = clamp(angle * 57.295779513, 0.0, 179.0);
    let row = min(u32(place), 178u);
    let share = place - f32(row);
    var z = array<f32, 4>();
    for (var k = 0u; k < 2u; k += 1u) {
        let weight = select(share, 1.0 - share, k == 0u);
        let numbers = sh4_cap_log_row(row + k);
        for (var l = 0u; l < 4u; l += 1u) {
            z[l] += weight * numbers[l];
        }
    }
    return z;
}

// `f` as half-precision floats, two in each word, the one of lower index in the lower half: in memory they lie as an
// array of 16 f16 does. An odd one at the end is followed by 0. What is beyond 65504 is brought there.
//
// Rounding errs by at most 2^-11 of a coefficient, and by 2^-25 below 2^-14.
fn sh4_pack_half(f: array<f32, 16>) -> array<u32, (16 + 1) / 2> {
    var words = array<u32, (16 + 1) / 2>();
    for (var i = 0u; i < 16u; i += 2u) {
        let second = select(0.0, f[min(i + 1u, 16u - 1u)], i + 1u < 16u);
        words[i >> 1u] = pack2x16float(clamp(vec2<f32>(f[i], second), vec2<f32>(-sh4_HALF_MAX), vec2<f32>(sh4_HALF_MAX)));
    }
    return words;
}

// The vector that `pack_half` has packed.
fn sh4_unpack_half(words: array<u32, (16 + 1) / 2>) -> array<f32, 16> {
    var f = array<f32, 16>();
    for (var i = 0u; i < 16u; i += 1u) {
        let pair = unpack2x16float(words[i >> 1u]);
        f[i] = select(pair.x, pair.y, (i & 1u) == 1u);
    }
    return f;
}
