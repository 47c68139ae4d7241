// Spherical harmonics of order 3 in WGSL. Gaunt 0.1.0.
// Made by `gaunt export --lang wgsl --order 3`; do not change it here. MIT or Apache-2.0, at your choice.
//
// Put it before or after your own text: it declares functions, constants and at most one struct, all of which start
// with the prefix. No extension is needed.
//
// A vector has 9 coefficients; that of band l and index m, -l to l, stands at l*l + l + m. The basis is real and
// orthonormal, with the signs usual in graphics (no Condon-Shortley): band 1 is sqrt(3/(4 pi)) (y, z, x), and the
// function 1 is (sqrt(4 pi), 0, ...). A zonal vector has the 3 coefficients of m = 0, one a band, of a function that
// is round about +Z. A symmetric matrix is its lower triangle, row by row. Axes are right-handed, angles radians;
// directions and quaternions (x, y, z, w) have length 1, and rotations are active: (Rf)(s) = f(R^-1 s).
//
// Routines, each with the prefix sh3_: basis, cosine, zonal, product, square, product_cosine, triple, dot,
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
// 13 multiplications, 3 additions.
fn sh3_basis(d: vec3<f32>) -> array<f32, 9> {
    let t5 = d.x + d.y;
    let t6 = d.x - d.y;
    let t7 = t5 * t6;
    let t9 = d.x * 2.0;
    let t10 = d.y * t9;
    let t11 = d.z * d.z;
    let t14 = d.y * 0.48860252;
    let t15 = d.z * 0.48860252;
    let t16 = d.x * 0.48860252;
    let t18 = t10 * 0.54627424;
    let t20 = d.z * 1.0925485;
    let t21 = d.y * t20;
    let t24 = fma(t11, 0.9461747, (-0.31539157));
    let t25 = d.x * t20;
    let t26 = t7 * 0.54627424;
    return array<f32, 9>(
        0.2820948, t14, t15, t16, t18, t21, t24, t25, t26,
    );
}

// The cosine lobe about the unit normal `d`, over pi: its dot product with radiance is the radiance that a white
// diffuse surface reflects.
// Source: Ren et al. 2006, eq. 9; Ramamoorthi and Hanrahan 2001: A_l/pi = 1, 2/3, 1/4, 0, -1/24, 0.
// 21 multiplications, 3 additions.
fn sh3_cosine(d: vec3<f32>) -> array<f32, 9> {
    let t7 = d.x + d.y;
    let t8 = d.x - d.y;
    let t9 = t7 * t8;
    let t11 = d.x * 2.0;
    let t12 = d.y * t11;
    let t13 = d.z * d.z;
    let t16 = d.y * 0.48860252;
    let t17 = d.z * 0.48860252;
    let t18 = d.x * 0.48860252;
    let t20 = t12 * 0.54627424;
    let t22 = d.z * 1.0925485;
    let t23 = d.y * t22;
    let t26 = fma(t13, 0.9461747, (-0.31539157));
    let t27 = d.x * t22;
    let t28 = t9 * 0.54627424;
    let t29 = 0.6666667 * t16;
    let t30 = 0.6666667 * t17;
    let t31 = 0.6666667 * t18;
    let t32 = 0.25 * t20;
    let t33 = 0.25 * t23;
    let t34 = 0.25 * t26;
    let t35 = 0.25 * t27;
    let t36 = 0.25 * t28;
    return array<f32, 9>(
        0.2820948, t29, t30, t31, t32, t33, t34, t35, t36,
    );
}

// The zonal vector `z` about +Z, turned to the unit vector `d`.
// Source: Sloan et al. 2005; Ren et al. 2006, section 6.1: f_lm = sqrt(4 pi/(2l+1)) z_l y_lm(d).
// 25 multiplications, 3 additions.
fn sh3_zonal(z: array<f32, 3>, d: vec3<f32>) -> array<f32, 9> {
    let t7 = z[0] * 3.5449078;
    let t9 = z[1] * 2.0466535;
    let t11 = z[2] * 1.585331;
    let t14 = d.x + d.y;
    let t15 = d.x - d.y;
    let t16 = t14 * t15;
    let t18 = d.x * 2.0;
    let t19 = d.y * t18;
    let t20 = d.z * d.z;
    let t23 = d.y * 0.48860252;
    let t24 = d.z * 0.48860252;
    let t25 = d.x * 0.48860252;
    let t27 = t19 * 0.54627424;
    let t29 = d.z * 1.0925485;
    let t30 = d.y * t29;
    let t33 = fma(t20, 0.9461747, (-0.31539157));
    let t34 = d.x * t29;
    let t35 = t16 * 0.54627424;
    let t36 = t7 * 0.2820948;
    let t37 = t9 * t23;
    let t38 = t9 * t24;
    let t39 = t9 * t25;
    let t40 = t11 * t27;
    let t41 = t11 * t30;
    let t42 = t11 * t33;
    let t43 = t11 * t34;
    let t44 = t11 * t35;
    return array<f32, 9>(
        t36, t37, t38, t39, t40, t41, t42, t43, t44,
    );
}

// The product `f * g`, projected back to order n.
//
// Commutative, not associative: what lies above order n is dropped each time.
// Source: Ren et al. 2006, eq. 3.
// 96 multiplications, 68 additions.
fn sh3_product(f: array<f32, 9>, g: array<f32, 9>) -> array<f32, 9> {
    let t19 = f[0] * 0.2820948;
    let t23 = f[8] * 0.21850969;
    let t25 = fma(-f[6], 0.12615663, t19);
    let t26 = t25 - t23;
    let t27 = g[0] * 0.2820948;
    let t29 = g[8] * 0.21850969;
    let t30 = fma(-g[6], 0.12615663, t27);
    let t31 = t30 - t29;
    let t32 = f[1] * g[1];
    let t33 = 0.2820948 * t32;
    let t34 = 0.12615663 * t32;
    let t36 = g[1] * t26;
    let t38 = fma(f[1], t31, t36);
    let t39 = t23 + t25;
    let t40 = t29 + t30;
    let t41 = f[3] * g[3];
    let t43 = fma(0.2820948, t41, t33);
    let t45 = fma(0.12615663, t41, t34);
    let t46 = 0.21850969 * t41;
    let t47 = fma((-0.21850969), t32, t46);
    let t48 = g[3] * t39;
    let t50 = fma(f[3], t40, t48);
    let t54 = f[8] * 0.15607835;
    let t55 = fma(f[6], 0.090111874, t19);
    let t56 = t55 - t54;
    let t58 = g[8] * 0.15607835;
    let t59 = fma(g[6], 0.090111874, t27);
    let t60 = t59 - t58;
    let t61 = f[5] * g[5];
    let t63 = fma(0.2820948, t61, t43);
    let t65 = fma(0.090111874, t61, -t45);
    let t67 = fma((-0.15607835), t61, t47);
    let t68 = g[5] * t56;
    let t70 = fma(f[5], t60, t68);
    let t71 = t54 + t55;
    let t72 = t58 + t59;
    let t73 = f[7] * g[7];
    let t75 = fma(0.2820948, t73, t63);
    let t77 = fma(0.090111874, t73, t65);
    let t79 = fma(0.15607835, t73, t67);
    let t80 = g[7] * t71;
    let t82 = fma(f[7], t72, t80);
    let t85 = fma(f[6], 0.25231326, t19);
    let t87 = fma(g[6], 0.25231326, t27);
    let t88 = f[2] * g[2];
    let t90 = fma(0.2820948, t88, t75);
    let t92 = fma(0.25231326, t88, t77);
    let t93 = g[2] * t85;
    let t95 = fma(f[2], t87, t93);
    let t98 = fma(-f[6], 0.18022375, t19);
    let t100 = fma(-g[6], 0.18022375, t27);
    let t101 = f[4] * g[4];
    let t103 = fma(0.2820948, t101, t90);
    let t105 = fma((-0.18022375), t101, t92);
    let t106 = g[4] * t98;
    let t108 = fma(f[4], t100, t106);
    let t109 = f[6] * g[6];
    let t111 = fma(0.2820948, t109, t103);
    let t113 = fma(0.18022375, t109, t105);
    let t114 = g[6] * t19;
    let t116 = fma(f[6], t27, t114);
    let t117 = t113 + t116;
    let t118 = f[8] * g[8];
    let t120 = fma(0.2820948, t118, t111);
    let t122 = fma((-0.18022375), t118, t117);
    let t123 = g[8] * t98;
    let t125 = fma(f[8], t100, t123);
    let t126 = t79 + t125;
    let t127 = f[0] * g[0];
    let t129 = fma(0.2820948, t127, t120);
    let t130 = f[5] * 0.21850969;
    let t131 = g[5] * 0.21850969;
    let t132 = f[1] * g[2];
    let t134 = fma(f[2], g[1], t132);
    let t136 = fma(0.21850969, t134, t70);
    let t137 = g[2] * t130;
    let t139 = fma(f[2], t131, t137);
    let t140 = t38 + t139;
    let t141 = g[1] * t130;
    let t143 = fma(f[1], t131, t141);
    let t144 = t95 + t143;
    let t145 = f[4] * 0.21850969;
    let t146 = g[4] * 0.21850969;
    let t147 = f[1] * g[3];
    let t149 = fma(f[3], g[1], t147);
    let t151 = fma(0.21850969, t149, t108);
    let t152 = g[3] * t145;
    let t154 = fma(f[3], t146, t152);
    let t155 = t140 + t154;
    let t156 = g[1] * t145;
    let t158 = fma(f[1], t146, t156);
    let t159 = t50 + t158;
    let t160 = f[7] * 0.21850969;
    let t161 = g[7] * 0.21850969;
    let t162 = f[2] * g[3];
    let t164 = fma(f[3], g[2], t162);
    let t166 = fma(0.21850969, t164, t82);
    let t167 = g[3] * t160;
    let t169 = fma(f[3], t161, t167);
    let t170 = t144 + t169;
    let t171 = g[2] * t160;
    let t173 = fma(f[2], t161, t171);
    let t174 = t159 + t173;
    let t175 = f[7] * 0.15607835;
    let t176 = g[7] * 0.15607835;
    let t177 = f[4] * g[5];
    let t179 = fma(f[5], g[4], t177);
    let t181 = fma(0.15607835, t179, t166);
    let t182 = g[5] * t175;
    let t184 = fma(f[5], t176, t182);
    let t185 = t151 + t184;
    let t186 = g[4] * t175;
    let t188 = fma(f[4], t176, t186);
    let t189 = t136 + t188;
    return array<f32, 9>(
        t129, t155, t170, t174, t185, t189, t122, t181, t126,
    );
}

// The product of `f` with itself, at about two thirds of a product's cost.
// Source: Ren et al. 2006, eq. 3 with g = f.
// 65 multiplications, 40 additions.
fn sh3_square(f: array<f32, 9>) -> array<f32, 9> {
    let t10 = f[0] * 0.5641896;
    let t14 = f[8] * 0.43701938;
    let t16 = fma(-f[6], 0.25231326, t10);
    let t17 = t16 - t14;
    let t18 = f[1] * f[1];
    let t20 = t18 * 0.2820948;
    let t22 = t18 * 0.12615663;
    let t25 = f[1] * t17;
    let t26 = t14 + t16;
    let t27 = f[3] * f[3];
    let t29 = fma(0.2820948, t27, t20);
    let t31 = fma(0.12615663, t27, t22);
    let t32 = 0.21850969 * t27;
    let t33 = fma(-t18, 0.21850969, t32);
    let t34 = f[3] * t26;
    let t38 = f[8] * 0.3121567;
    let t39 = fma(f[6], 0.18022375, t10);
    let t40 = t39 - t38;
    let t41 = f[5] * f[5];
    let t43 = fma(0.2820948, t41, t29);
    let t46 = fma(t41, 0.090111874, -t31);
    let t49 = fma(-t41, 0.15607835, t33);
    let t50 = f[5] * t40;
    let t51 = t38 + t39;
    let t52 = f[7] * f[7];
    let t54 = fma(0.2820948, t52, t43);
    let t56 = fma(0.090111874, t52, t46);
    let t58 = fma(0.15607835, t52, t49);
    let t59 = f[7] * t51;
    let t62 = fma(f[6], 0.5046265, t10);
    let t63 = f[2] * f[2];
    let t65 = fma(0.2820948, t63, t54);
    let t67 = fma(0.25231326, t63, t56);
    let t68 = f[2] * t62;
    let t71 = fma(-f[6], 0.3604475, t10);
    let t72 = f[4] * f[4];
    let t74 = fma(0.2820948, t72, t65);
    let t76 = fma((-0.18022375), t72, t67);
    let t77 = f[4] * t71;
    let t78 = f[6] * f[6];
    let t80 = fma(0.2820948, t78, t74);
    let t82 = fma(0.18022375, t78, t76);
    let t84 = fma(f[6], t10, t82);
    let t85 = f[8] * f[8];
    let t87 = fma(0.2820948, t85, t80);
    let t89 = fma((-0.18022375), t85, t84);
    let t91 = fma(f[8], t71, t58);
    let t92 = f[0] * f[0];
    let t94 = fma(0.2820948, t92, t87);
    let t95 = f[5] * 0.43701938;
    let t96 = f[1] * f[2];
    let t98 = fma(0.43701938, t96, t50);
    let t100 = fma(f[2], t95, t25);
    let t102 = fma(f[1], t95, t68);
    let t103 = f[4] * 0.43701938;
    let t104 = f[1] * f[3];
    let t106 = fma(0.43701938, t104, t77);
    let t108 = fma(f[3], t103, t100);
    let t110 = fma(f[1], t103, t34);
    let t111 = f[7] * 0.43701938;
    let t112 = f[2] * f[3];
    let t114 = fma(0.43701938, t112, t59);
    let t116 = fma(f[3], t111, t102);
    let t118 = fma(f[2], t111, t110);
    let t119 = f[7] * 0.3121567;
    let t120 = f[4] * f[5];
    let t122 = fma(0.3121567, t120, t114);
    let t124 = fma(f[5], t119, t106);
    let t126 = fma(f[4], t119, t98);
    return array<f32, 9>(
        t94, t108, t116, t118, t124, t126, t89, t122, t91,
    );
}

// The product `f * H(d)` with the cosine lobe about `d`, cheaper than forming and multiplying it: what remains is a dot
// product with each channel of the light.
// Source: Ren et al. 2006, eq. 3 and 9.
// 115 multiplications, 71 additions.
fn sh3_product_cosine(f: array<f32, 9>, d: vec3<f32>) -> array<f32, 9> {
    let t16 = d.x + d.y;
    let t17 = d.x - d.y;
    let t18 = t16 * t17;
    let t20 = d.x * 2.0;
    let t21 = d.y * t20;
    let t22 = d.z * d.z;
    let t25 = d.y * 0.48860252;
    let t26 = d.z * 0.48860252;
    let t27 = d.x * 0.48860252;
    let t29 = t21 * 0.54627424;
    let t31 = d.z * 1.0925485;
    let t32 = d.y * t31;
    let t35 = fma(t22, 0.9461747, (-0.31539157));
    let t36 = d.x * t31;
    let t37 = t18 * 0.54627424;
    let t38 = 0.6666667 * t25;
    let t39 = 0.6666667 * t26;
    let t40 = 0.6666667 * t27;
    let t41 = 0.25 * t29;
    let t42 = 0.25 * t32;
    let t43 = 0.25 * t35;
    let t44 = 0.25 * t36;
    let t45 = 0.25 * t37;
    let t46 = f[0] * 0.2820948;
    let t50 = f[8] * 0.21850969;
    let t51 = fma(-f[6], 0.12615663, t46);
    let t52 = t51 - t50;
    let t55 = t45 * 0.21850969;
    let t56 = fma(-t43, 0.12615663, 0.07957747);
    let t57 = t56 - t55;
    let t58 = f[1] * t38;
    let t59 = 0.2820948 * t58;
    let t60 = 0.12615663 * t58;
    let t62 = t38 * t52;
    let t64 = fma(f[1], t57, t62);
    let t65 = t50 + t51;
    let t66 = t55 + t56;
    let t67 = f[3] * t40;
    let t69 = fma(0.2820948, t67, t59);
    let t71 = fma(0.12615663, t67, t60);
    let t72 = 0.21850969 * t67;
    let t73 = fma((-0.21850969), t58, t72);
    let t74 = t40 * t65;
    let t76 = fma(f[3], t66, t74);
    let t80 = f[8] * 0.15607835;
    let t81 = fma(f[6], 0.090111874, t46);
    let t82 = t81 - t80;
    let t84 = t45 * 0.15607835;
    let t85 = fma(t43, 0.090111874, 0.07957747);
    let t86 = t85 - t84;
    let t87 = f[5] * t42;
    let t89 = fma(0.2820948, t87, t69);
    let t91 = fma(0.090111874, t87, -t71);
    let t93 = fma((-0.15607835), t87, t73);
    let t94 = t42 * t82;
    let t96 = fma(f[5], t86, t94);
    let t97 = t80 + t81;
    let t98 = t84 + t85;
    let t99 = f[7] * t44;
    let t101 = fma(0.2820948, t99, t89);
    let t103 = fma(0.090111874, t99, t91);
    let t105 = fma(0.15607835, t99, t93);
    let t106 = t44 * t97;
    let t108 = fma(f[7], t98, t106);
    let t111 = fma(f[6], 0.25231326, t46);
    let t113 = fma(t43, 0.25231326, 0.07957747);
    let t114 = f[2] * t39;
    let t116 = fma(0.2820948, t114, t101);
    let t118 = fma(0.25231326, t114, t103);
    let t119 = t39 * t111;
    let t121 = fma(f[2], t113, t119);
    let t124 = fma(-f[6], 0.18022375, t46);
    let t126 = fma(-t43, 0.18022375, 0.07957747);
    let t127 = f[4] * t41;
    let t129 = fma(0.2820948, t127, t116);
    let t131 = fma((-0.18022375), t127, t118);
    let t132 = t41 * t124;
    let t134 = fma(f[4], t126, t132);
    let t135 = f[6] * t43;
    let t137 = fma(0.2820948, t135, t129);
    let t139 = fma(0.18022375, t135, t131);
    let t140 = t43 * t46;
    let t142 = fma(f[6], 0.07957747, t140);
    let t143 = t139 + t142;
    let t144 = f[8] * t45;
    let t146 = fma(0.2820948, t144, t137);
    let t148 = fma((-0.18022375), t144, t143);
    let t149 = t45 * t124;
    let t151 = fma(f[8], t126, t149);
    let t152 = t105 + t151;
    let t154 = fma(0.2820948, t46, t146);
    let t155 = f[5] * 0.21850969;
    let t156 = t42 * 0.21850969;
    let t157 = f[1] * t39;
    let t159 = fma(f[2], t38, t157);
    let t161 = fma(0.21850969, t159, t96);
    let t162 = t39 * t155;
    let t164 = fma(f[2], t156, t162);
    let t165 = t64 + t164;
    let t166 = t38 * t155;
    let t168 = fma(f[1], t156, t166);
    let t169 = t121 + t168;
    let t170 = f[4] * 0.21850969;
    let t171 = t41 * 0.21850969;
    let t172 = f[1] * t40;
    let t174 = fma(f[3], t38, t172);
    let t176 = fma(0.21850969, t174, t134);
    let t177 = t40 * t170;
    let t179 = fma(f[3], t171, t177);
    let t180 = t165 + t179;
    let t181 = t38 * t170;
    let t183 = fma(f[1], t171, t181);
    let t184 = t76 + t183;
    let t185 = f[7] * 0.21850969;
    let t186 = t44 * 0.21850969;
    let t187 = f[2] * t40;
    let t189 = fma(f[3], t39, t187);
    let t191 = fma(0.21850969, t189, t108);
    let t192 = t40 * t185;
    let t194 = fma(f[3], t186, t192);
    let t195 = t169 + t194;
    let t196 = t39 * t185;
    let t198 = fma(f[2], t186, t196);
    let t199 = t184 + t198;
    let t200 = f[7] * 0.15607835;
    let t201 = t44 * 0.15607835;
    let t202 = f[4] * t42;
    let t204 = fma(f[5], t41, t202);
    let t206 = fma(0.15607835, t204, t191);
    let t207 = t42 * t200;
    let t209 = fma(f[5], t201, t207);
    let t210 = t176 + t209;
    let t211 = t41 * t200;
    let t213 = fma(f[4], t201, t211);
    let t214 = t161 + t213;
    return array<f32, 9>(
        t154, t180, t195, t199, t210, t214, t148, t206, t152,
    );
}

// The integral of the product of three functions over the sphere.
// Source: Ren et al. 2006, section 3: (a, b, c) = (a * b) * c.
// 105 multiplications, 76 additions.
fn sh3_triple(f: array<f32, 9>, g: array<f32, 9>, h: array<f32, 9>) -> f32 {
    let t28 = f[0] * 0.2820948;
    let t32 = f[8] * 0.21850969;
    let t34 = fma(-f[6], 0.12615663, t28);
    let t35 = t34 - t32;
    let t36 = g[0] * 0.2820948;
    let t38 = g[8] * 0.21850969;
    let t39 = fma(-g[6], 0.12615663, t36);
    let t40 = t39 - t38;
    let t41 = f[1] * g[1];
    let t42 = 0.2820948 * t41;
    let t43 = 0.12615663 * t41;
    let t45 = g[1] * t35;
    let t47 = fma(f[1], t40, t45);
    let t48 = t32 + t34;
    let t49 = t38 + t39;
    let t50 = f[3] * g[3];
    let t52 = fma(0.2820948, t50, t42);
    let t54 = fma(0.12615663, t50, t43);
    let t55 = 0.21850969 * t50;
    let t56 = fma((-0.21850969), t41, t55);
    let t57 = g[3] * t48;
    let t59 = fma(f[3], t49, t57);
    let t63 = f[8] * 0.15607835;
    let t64 = fma(f[6], 0.090111874, t28);
    let t65 = t64 - t63;
    let t67 = g[8] * 0.15607835;
    let t68 = fma(g[6], 0.090111874, t36);
    let t69 = t68 - t67;
    let t70 = f[5] * g[5];
    let t72 = fma(0.2820948, t70, t52);
    let t74 = fma(0.090111874, t70, -t54);
    let t76 = fma((-0.15607835), t70, t56);
    let t77 = g[5] * t65;
    let t79 = fma(f[5], t69, t77);
    let t80 = t63 + t64;
    let t81 = t67 + t68;
    let t82 = f[7] * g[7];
    let t84 = fma(0.2820948, t82, t72);
    let t86 = fma(0.090111874, t82, t74);
    let t88 = fma(0.15607835, t82, t76);
    let t89 = g[7] * t80;
    let t91 = fma(f[7], t81, t89);
    let t94 = fma(f[6], 0.25231326, t28);
    let t96 = fma(g[6], 0.25231326, t36);
    let t97 = f[2] * g[2];
    let t99 = fma(0.2820948, t97, t84);
    let t101 = fma(0.25231326, t97, t86);
    let t102 = g[2] * t94;
    let t104 = fma(f[2], t96, t102);
    let t107 = fma(-f[6], 0.18022375, t28);
    let t109 = fma(-g[6], 0.18022375, t36);
    let t110 = f[4] * g[4];
    let t112 = fma(0.2820948, t110, t99);
    let t114 = fma((-0.18022375), t110, t101);
    let t115 = g[4] * t107;
    let t117 = fma(f[4], t109, t115);
    let t118 = f[6] * g[6];
    let t120 = fma(0.2820948, t118, t112);
    let t122 = fma(0.18022375, t118, t114);
    let t123 = g[6] * t28;
    let t125 = fma(f[6], t36, t123);
    let t126 = t122 + t125;
    let t127 = f[8] * g[8];
    let t129 = fma(0.2820948, t127, t120);
    let t131 = fma((-0.18022375), t127, t126);
    let t132 = g[8] * t107;
    let t134 = fma(f[8], t109, t132);
    let t135 = t88 + t134;
    let t136 = f[0] * g[0];
    let t138 = fma(0.2820948, t136, t129);
    let t139 = f[5] * 0.21850969;
    let t140 = g[5] * 0.21850969;
    let t141 = f[1] * g[2];
    let t143 = fma(f[2], g[1], t141);
    let t145 = fma(0.21850969, t143, t79);
    let t146 = g[2] * t139;
    let t148 = fma(f[2], t140, t146);
    let t149 = t47 + t148;
    let t150 = g[1] * t139;
    let t152 = fma(f[1], t140, t150);
    let t153 = t104 + t152;
    let t154 = f[4] * 0.21850969;
    let t155 = g[4] * 0.21850969;
    let t156 = f[1] * g[3];
    let t158 = fma(f[3], g[1], t156);
    let t160 = fma(0.21850969, t158, t117);
    let t161 = g[3] * t154;
    let t163 = fma(f[3], t155, t161);
    let t164 = t149 + t163;
    let t165 = g[1] * t154;
    let t167 = fma(f[1], t155, t165);
    let t168 = t59 + t167;
    let t169 = f[7] * 0.21850969;
    let t170 = g[7] * 0.21850969;
    let t171 = f[2] * g[3];
    let t173 = fma(f[3], g[2], t171);
    let t175 = fma(0.21850969, t173, t91);
    let t176 = g[3] * t169;
    let t178 = fma(f[3], t170, t176);
    let t179 = t153 + t178;
    let t180 = g[2] * t169;
    let t182 = fma(f[2], t170, t180);
    let t183 = t168 + t182;
    let t184 = f[7] * 0.15607835;
    let t185 = g[7] * 0.15607835;
    let t186 = f[4] * g[5];
    let t188 = fma(f[5], g[4], t186);
    let t190 = fma(0.15607835, t188, t175);
    let t191 = g[5] * t184;
    let t193 = fma(f[5], t185, t191);
    let t194 = t160 + t193;
    let t195 = g[4] * t184;
    let t197 = fma(f[4], t185, t195);
    let t198 = t145 + t197;
    let t199 = h[0] * t138;
    let t200 = fma(h[1], t164, t199);
    let t201 = fma(h[2], t179, t200);
    let t202 = fma(h[3], t183, t201);
    let t203 = fma(h[4], t194, t202);
    let t204 = fma(h[5], t198, t203);
    let t205 = fma(h[6], t131, t204);
    let t206 = fma(h[7], t190, t205);
    let t207 = fma(h[8], t135, t206);
    return t207;
}

// The integral of the product of two functions over the sphere.
// Source: Orthonormality: integral of f g = sum of f_i g_i.
// 9 multiplications, 8 additions.
fn sh3_dot(f: array<f32, 9>, g: array<f32, 9>) -> f32 {
    let t19 = f[0] * g[0];
    let t20 = fma(f[1], g[1], t19);
    let t21 = fma(f[2], g[2], t20);
    let t22 = fma(f[3], g[3], t21);
    let t23 = fma(f[4], g[4], t22);
    let t24 = fma(f[5], g[5], t23);
    let t25 = fma(f[6], g[6], t24);
    let t26 = fma(f[7], g[7], t25);
    let t27 = fma(f[8], g[8], t26);
    return t27;
}

// The symmetric matrix of multiplication by `f`: its lower triangle, row by row.
// Source: Ren et al. 2006, eq. 5.
// 31 multiplications, 9 additions.
fn sh3_product_matrix(f: array<f32, 9>) -> array<f32, 45> {
    let t10 = f[0] * 0.2820948;
    let t11 = f[1] * 0.2820948;
    let t12 = f[2] * 0.2820948;
    let t13 = f[3] * 0.2820948;
    let t14 = f[4] * 0.2820948;
    let t15 = f[5] * 0.2820948;
    let t16 = f[6] * 0.2820948;
    let t17 = f[7] * 0.2820948;
    let t18 = f[8] * 0.2820948;
    let t21 = fma(-f[6], 0.12615663, t10);
    let t22 = f[1] * 0.12615663;
    let t24 = f[8] * 0.21850969;
    let t25 = t21 - t24;
    let t26 = f[1] * 0.21850969;
    let t27 = f[5] * 0.21850969;
    let t28 = f[2] * 0.21850969;
    let t29 = f[4] * 0.21850969;
    let t30 = f[3] * 0.21850969;
    let t33 = fma(f[6], 0.25231326, t10);
    let t34 = f[2] * 0.25231326;
    let t35 = f[7] * 0.21850969;
    let t36 = f[3] * 0.12615663;
    let t37 = t21 + t24;
    let t39 = f[6] * 0.18022375;
    let t40 = t10 - t39;
    let t41 = f[4] * 0.18022375;
    let t43 = f[7] * 0.15607835;
    let t44 = f[5] * 0.15607835;
    let t45 = f[4] * 0.15607835;
    let t48 = fma(f[6], 0.090111874, t10);
    let t49 = f[5] * 0.090111874;
    let t50 = f[8] * 0.15607835;
    let t51 = t48 - t50;
    let t52 = t10 + t39;
    let t53 = f[7] * 0.090111874;
    let t54 = f[8] * 0.18022375;
    let t55 = t48 + t50;
    return array<f32, 45>(
        t10, t11, t25, t12, t27, t33, t13, t29, t35, t37, t14, t30, 0.0, t26, t40, t15, t28, t26,
        0.0, t43, t51, t16, -t22, t34, -t36, -t41, t49, t52, t17, 0.0, t30, t28, t44, t45, t53,
        t55, t18, -t26, 0.0, t30, 0.0, -t44, -t54, t43, t40,
    );
}

// A symmetric matrix, given by its lower triangle, times a vector.
// Source: With the product matrix of f: M_f g = f * g.
// 81 multiplications, 72 additions.
fn sh3_matrix_apply(m: array<f32, 45>, g: array<f32, 9>) -> array<f32, 9> {
    let t55 = m[0] * g[0];
    let t56 = fma(m[1], g[1], t55);
    let t57 = fma(m[3], g[2], t56);
    let t58 = fma(m[6], g[3], t57);
    let t59 = fma(m[10], g[4], t58);
    let t60 = fma(m[15], g[5], t59);
    let t61 = fma(m[21], g[6], t60);
    let t62 = fma(m[28], g[7], t61);
    let t63 = fma(m[36], g[8], t62);
    let t64 = m[1] * g[0];
    let t65 = fma(m[2], g[1], t64);
    let t66 = fma(m[4], g[2], t65);
    let t67 = fma(m[7], g[3], t66);
    let t68 = fma(m[11], g[4], t67);
    let t69 = fma(m[16], g[5], t68);
    let t70 = fma(m[22], g[6], t69);
    let t71 = fma(m[29], g[7], t70);
    let t72 = fma(m[37], g[8], t71);
    let t73 = m[3] * g[0];
    let t74 = fma(m[4], g[1], t73);
    let t75 = fma(m[5], g[2], t74);
    let t76 = fma(m[8], g[3], t75);
    let t77 = fma(m[12], g[4], t76);
    let t78 = fma(m[17], g[5], t77);
    let t79 = fma(m[23], g[6], t78);
    let t80 = fma(m[30], g[7], t79);
    let t81 = fma(m[38], g[8], t80);
    let t82 = m[6] * g[0];
    let t83 = fma(m[7], g[1], t82);
    let t84 = fma(m[8], g[2], t83);
    let t85 = fma(m[9], g[3], t84);
    let t86 = fma(m[13], g[4], t85);
    let t87 = fma(m[18], g[5], t86);
    let t88 = fma(m[24], g[6], t87);
    let t89 = fma(m[31], g[7], t88);
    let t90 = fma(m[39], g[8], t89);
    let t91 = m[10] * g[0];
    let t92 = fma(m[11], g[1], t91);
    let t93 = fma(m[12], g[2], t92);
    let t94 = fma(m[13], g[3], t93);
    let t95 = fma(m[14], g[4], t94);
    let t96 = fma(m[19], g[5], t95);
    let t97 = fma(m[25], g[6], t96);
    let t98 = fma(m[32], g[7], t97);
    let t99 = fma(m[40], g[8], t98);
    let t100 = m[15] * g[0];
    let t101 = fma(m[16], g[1], t100);
    let t102 = fma(m[17], g[2], t101);
    let t103 = fma(m[18], g[3], t102);
    let t104 = fma(m[19], g[4], t103);
    let t105 = fma(m[20], g[5], t104);
    let t106 = fma(m[26], g[6], t105);
    let t107 = fma(m[33], g[7], t106);
    let t108 = fma(m[41], g[8], t107);
    let t109 = m[21] * g[0];
    let t110 = fma(m[22], g[1], t109);
    let t111 = fma(m[23], g[2], t110);
    let t112 = fma(m[24], g[3], t111);
    let t113 = fma(m[25], g[4], t112);
    let t114 = fma(m[26], g[5], t113);
    let t115 = fma(m[27], g[6], t114);
    let t116 = fma(m[34], g[7], t115);
    let t117 = fma(m[42], g[8], t116);
    let t118 = m[28] * g[0];
    let t119 = fma(m[29], g[1], t118);
    let t120 = fma(m[30], g[2], t119);
    let t121 = fma(m[31], g[3], t120);
    let t122 = fma(m[32], g[4], t121);
    let t123 = fma(m[33], g[5], t122);
    let t124 = fma(m[34], g[6], t123);
    let t125 = fma(m[35], g[7], t124);
    let t126 = fma(m[43], g[8], t125);
    let t127 = m[36] * g[0];
    let t128 = fma(m[37], g[1], t127);
    let t129 = fma(m[38], g[2], t128);
    let t130 = fma(m[39], g[3], t129);
    let t131 = fma(m[40], g[4], t130);
    let t132 = fma(m[41], g[5], t131);
    let t133 = fma(m[42], g[6], t132);
    let t134 = fma(m[43], g[7], t133);
    let t135 = fma(m[44], g[8], t134);
    return array<f32, 9>(
        t63, t72, t81, t90, t99, t108, t117, t126, t135,
    );
}

// `f` rotated by the unit quaternion `q` = (x, y, z, w): (Rf)(s) = f(R^-1s).
//
// As accurate for tilts of 1e-7 as for any other rotation.
// Source: R_z(alpha) R_y(beta) R_z(gamma) with the angles' cosines and sines from the quaternion; R_y by quarter turns
// about x.
// 74 multiplications, 36 additions.
fn sh3_rotate(f: array<f32, 9>, q: vec4<f32>) -> array<f32, 9> {
    let t13 = q.z * q.z;
    let t14 = fma(q.w, q.w, t13);
    let t18 = sqrt(t14);
    let t19 = q.w / t18;
    let t20 = q.z / t18;
    let t21 = select(t19, 1.0, t14 < 1e-36);
    let t22 = select(t20, 0.0, t14 < 1e-36);
    let t23 = q.x * q.x;
    let t24 = fma(q.y, q.y, t23);
    let t25 = sqrt(t24);
    let t26 = q.y / t25;
    let t27 = q.x / t25;
    let t28 = select(t26, 1.0, t24 < 1e-36);
    let t29 = select(t27, 0.0, t24 < 1e-36);
    let t30 = t22 * t29;
    let t31 = t22 * t28;
    let t32 = fma(t21, t28, -t30);
    let t33 = fma(t21, t29, t31);
    let t34 = fma(t21, t28, t30);
    let t35 = fma(-t21, t29, t31);
    let t36 = t14 + t24;
    let t37 = t14 - t24;
    let t38 = t37 / t36;
    let t39 = t14 * t24;
    let t40 = sqrt(t39);
    let t42 = t40 * 2.0;
    let t43 = t42 / t36;
    let t44 = t34 + t35;
    let t45 = t34 - t35;
    let t46 = t44 * t45;
    let t47 = t34 * 2.0;
    let t48 = t35 * t47;
    let t49 = t38 + t43;
    let t50 = t38 - t43;
    let t51 = t49 * t50;
    let t52 = t38 * 2.0;
    let t53 = t43 * t52;
    let t54 = t32 + t33;
    let t55 = t32 - t33;
    let t56 = t54 * t55;
    let t57 = t32 * 2.0;
    let t58 = t33 * t57;
    let t59 = f[1] * t33;
    let t60 = f[1] * t32;
    let t61 = fma(f[3], t32, -t59);
    let t62 = fma(f[3], t33, t60);
    let t63 = f[5] * t33;
    let t64 = f[5] * t32;
    let t65 = fma(f[7], t32, -t63);
    let t66 = fma(f[7], t33, t64);
    let t67 = f[4] * t58;
    let t68 = f[4] * t56;
    let t69 = fma(f[8], t56, -t67);
    let t70 = fma(f[8], t58, t68);
    let t72 = f[6] * 0.5;
    let t74 = fma(t69, 0.8660254, t72);
    let t75 = f[6] * 0.8660254;
    let t76 = fma(t69, 0.5, -t75);
    let t77 = f[2] * t43;
    let t78 = f[2] * t38;
    let t79 = fma(t38, t61, t77);
    let t80 = fma(t43, t61, -t78);
    let t81 = t43 * t66;
    let t82 = t38 * t66;
    let t83 = fma(t38, t70, t81);
    let t84 = fma(t43, t70, -t82);
    let t85 = t53 * t65;
    let t86 = t51 * t65;
    let t87 = fma(t51, t76, t85);
    let t88 = fma(t53, t76, -t86);
    let t89 = 0.5 * t74;
    let t90 = fma((-0.8660254), t87, t89);
    let t91 = 0.8660254 * t74;
    let t92 = fma(0.5, t87, t91);
    let t93 = t35 * t62;
    let t94 = t34 * t62;
    let t95 = fma(t34, t79, -t93);
    let t96 = fma(t35, t79, t94);
    let t97 = t35 * t84;
    let t98 = t34 * t84;
    let t99 = fma(-t34, t88, t97);
    let t100 = fma(t35, t88, t98);
    let t101 = t48 * t83;
    let t102 = t46 * t83;
    let t103 = fma(t46, t92, -t101);
    let t104 = fma(t48, t92, t102);
    return array<f32, 9>(
        f[0], t96, -t80, t95, t104, -t100, t90, t99, t103,
    );
}

// `f` rotated by the rotation matrix `m`, given row by row: (Rf)(s) = f(R^-1s).
// Source: Shepperd 1978 to a quaternion, then as `rotate`.
// 74 multiplications, 52 additions.
fn sh3_rotate_matrix(f: array<f32, 9>, m: array<f32, 9>) -> array<f32, 9> {
    let t19 = m[0] + 1.0;
    let t20 = t19 - m[4];
    let t21 = t20 - m[8];
    let t22 = 1.0 - m[0];
    let t23 = m[4] + t22;
    let t24 = t23 - m[8];
    let t25 = t22 - m[4];
    let t26 = m[8] + t25;
    let t27 = m[4] + t19;
    let t28 = m[8] + t27;
    let t29 = m[1] + m[3];
    let t30 = m[2] + m[6];
    let t31 = m[5] + m[7];
    let t32 = m[7] - m[5];
    let t33 = m[2] - m[6];
    let t34 = m[3] - m[1];
    let t35 = select(t21, t29, t21 < t24);
    let t36 = select(t29, t24, t21 < t24);
    let t37 = select(t30, t31, t21 < t24);
    let t38 = select(t32, t33, t21 < t24);
    let t39 = select(t21, t24, t21 < t24);
    let t40 = select(t35, t30, t39 < t26);
    let t41 = select(t36, t31, t39 < t26);
    let t42 = select(t37, t26, t39 < t26);
    let t43 = select(t38, t34, t39 < t26);
    let t44 = select(t39, t26, t39 < t26);
    let t45 = select(t40, t32, t44 < t28);
    let t46 = select(t41, t33, t44 < t28);
    let t47 = select(t42, t34, t44 < t28);
    let t48 = select(t43, t28, t44 < t28);
    let t50 = t47 * t47;
    let t51 = fma(t48, t48, t50);
    let t54 = sqrt(t51);
    let t55 = t48 / t54;
    let t56 = t47 / t54;
    let t57 = select(t55, 1.0, t51 < 1e-36);
    let t58 = select(t56, 0.0, t51 < 1e-36);
    let t59 = t45 * t45;
    let t60 = fma(t46, t46, t59);
    let t61 = sqrt(t60);
    let t62 = t46 / t61;
    let t63 = t45 / t61;
    let t64 = select(t62, 1.0, t60 < 1e-36);
    let t65 = select(t63, 0.0, t60 < 1e-36);
    let t66 = t58 * t65;
    let t67 = t58 * t64;
    let t68 = fma(t57, t64, -t66);
    let t69 = fma(t57, t65, t67);
    let t70 = fma(t57, t64, t66);
    let t71 = fma(-t57, t65, t67);
    let t72 = t51 + t60;
    let t73 = t51 - t60;
    let t74 = t73 / t72;
    let t75 = t51 * t60;
    let t76 = sqrt(t75);
    let t78 = t76 * 2.0;
    let t79 = t78 / t72;
    let t80 = t70 + t71;
    let t81 = t70 - t71;
    let t82 = t80 * t81;
    let t83 = t70 * 2.0;
    let t84 = t71 * t83;
    let t85 = t74 + t79;
    let t86 = t74 - t79;
    let t87 = t85 * t86;
    let t88 = t74 * 2.0;
    let t89 = t79 * t88;
    let t90 = t68 + t69;
    let t91 = t68 - t69;
    let t92 = t90 * t91;
    let t93 = t68 * 2.0;
    let t94 = t69 * t93;
    let t95 = f[1] * t69;
    let t96 = f[1] * t68;
    let t97 = fma(f[3], t68, -t95);
    let t98 = fma(f[3], t69, t96);
    let t99 = f[5] * t69;
    let t100 = f[5] * t68;
    let t101 = fma(f[7], t68, -t99);
    let t102 = fma(f[7], t69, t100);
    let t103 = f[4] * t94;
    let t104 = f[4] * t92;
    let t105 = fma(f[8], t92, -t103);
    let t106 = fma(f[8], t94, t104);
    let t108 = f[6] * 0.5;
    let t110 = fma(t105, 0.8660254, t108);
    let t111 = f[6] * 0.8660254;
    let t112 = fma(t105, 0.5, -t111);
    let t113 = f[2] * t79;
    let t114 = f[2] * t74;
    let t115 = fma(t74, t97, t113);
    let t116 = fma(t79, t97, -t114);
    let t117 = t79 * t102;
    let t118 = t74 * t102;
    let t119 = fma(t74, t106, t117);
    let t120 = fma(t79, t106, -t118);
    let t121 = t89 * t101;
    let t122 = t87 * t101;
    let t123 = fma(t87, t112, t121);
    let t124 = fma(t89, t112, -t122);
    let t125 = 0.5 * t110;
    let t126 = fma((-0.8660254), t123, t125);
    let t127 = 0.8660254 * t110;
    let t128 = fma(0.5, t123, t127);
    let t129 = t71 * t98;
    let t130 = t70 * t98;
    let t131 = fma(t70, t115, -t129);
    let t132 = fma(t71, t115, t130);
    let t133 = t71 * t120;
    let t134 = t70 * t120;
    let t135 = fma(-t70, t124, t133);
    let t136 = fma(t71, t124, t134);
    let t137 = t84 * t119;
    let t138 = t82 * t119;
    let t139 = fma(t82, t128, -t137);
    let t140 = fma(t84, t128, t138);
    return array<f32, 9>(
        f[0], t132, -t116, t131, t140, -t136, t126, t135, t139,
    );
}

// `f` with band l scaled by cos(pi/2 * l/h), and by 0 for l >= h: against ringing. `h` must be positive; 2n is a mild
// window.
// Source: Ren et al. 2006, section 7.
// 22 multiplications, 11 additions.
fn sh3_window(f: array<f32, 9>, h: f32) -> array<f32, 9> {
    let t11 = 1.5707964 / h;
    let t12 = t11 * t11;
    let t17 = fma(t12, 4.1103176e-19, (-1.5619207e-16));
    let t19 = fma(t12, t17, 4.7794773e-14);
    let t21 = fma(t12, t19, (-1.1470745e-11));
    let t23 = fma(t12, t21, 2.0876756e-9);
    let t25 = fma(t12, t23, (-2.755732e-7));
    let t27 = fma(t12, t25, 2.4801588e-5);
    let t29 = fma(t12, t27, (-0.0013888889));
    let t31 = fma(t12, t29, 0.041666668);
    let t33 = fma(t12, t31, (-0.5));
    let t34 = fma(t12, t33, 1.0);
    let t36 = t34 * 2.0;
    let t37 = fma(t34, t36, (-1.0));
    let t38 = select(0.0, t34, 1.0 < h);
    let t39 = select(0.0, t37, 2.0 < h);
    let t40 = f[1] * t38;
    let t41 = f[2] * t38;
    let t42 = f[3] * t38;
    let t43 = f[4] * t39;
    let t44 = f[5] * t39;
    let t45 = f[6] * t39;
    let t46 = f[7] * t39;
    let t47 = f[8] * t39;
    return array<f32, 9>(
        f[0], t40, t41, t42, t43, t44, t45, t46, t47,
    );
}

// Zonal coefficients of the visibility past a circular blocker of angular radius theta about +Z, for any theta in
// 0..pi, from its cosine and sine.
// Source: Ren et al. 2006, eq. 33, integrated in closed form.
// 5 multiplications, 1 additions.
fn sh3_cap_visibility(cosine: f32, sine: f32) -> array<f32, 3> {
    let t2 = sine * sine;
    let t5 = fma(cosine, 1.7724539, 1.7724539);
    let t8 = t2 * 1.5349901;
    let t10 = cosine * 1.9816637;
    let t11 = t2 * t10;
    return array<f32, 3>(
        t5, -t8, -t11,
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
// 26 multiplications, 22 additions.
fn sh3_cap_log(sine: f32, cosine: f32) -> array<f32, 3> {
    let t2 = sine * sine;
    let t5 = fma(cosine, 2.0, (-1.0));
    let t9 = fma(-t5, 7.4758644, 0.069827266);
    let t11 = fma(t5, t9, 16.193773);
    let t13 = fma(t5, t11, (-0.7301114));
    let t15 = fma(t5, t13, (-11.700016));
    let t17 = fma(t5, t15, 0.88720566);
    let t19 = fma(t5, t17, 5.081695);
    let t21 = fma(t5, t19, (-3.2671273));
    let t22 = t2 * t21;
    let t25 = fma(-t5, 10.10164, 0.024110338);
    let t27 = fma(t5, t25, 21.872412);
    let t29 = fma(t5, t27, (-0.7568589));
    let t31 = fma(t5, t29, (-16.140879));
    let t33 = fma(t5, t31, 1.4486766);
    let t35 = fma(t5, t33, 6.3847404);
    let t37 = fma(t5, t35, (-4.3396034));
    let t38 = t2 * t37;
    let t41 = fma(-t5, 8.361962, 0.300271);
    let t43 = fma(t5, t41, 17.992922);
    let t45 = fma(t5, t43, (-1.1244124));
    let t47 = fma(t5, t45, (-13.277142));
    let t49 = fma(t5, t47, 1.9010113);
    let t51 = fma(t5, t49, 3.8175852);
    let t53 = fma(t5, t51, (-3.2891376));
    let t54 = t2 * t53;
    return array<f32, 3>(
        t22, t38, t54,
    );
}

// `f` plus the logarithm of the visibility past a circular blocker about the unit vector `d`: what one blocker costs a
// receiver. The angular radius theta in 0..pi/2 comes as its sine and cosine.
// Source: Ren et al. 2006, eq. 34 and 8, with the fitted logarithm of `cap_log`.
// 48 multiplications, 34 additions.
fn sh3_add_cap_log(f: array<f32, 9>, sine: f32, cosine: f32, d: vec3<f32>) -> array<f32, 9> {
    let t14 = sine * sine;
    let t17 = fma(cosine, 2.0, (-1.0));
    let t21 = fma(-t17, 26.50125, 0.24753122);
    let t23 = fma(t17, t21, 57.40543);
    let t25 = fma(t17, t23, (-2.5881774));
    let t27 = fma(t17, t25, (-41.475475));
    let t29 = fma(t17, t27, 3.1450622);
    let t31 = fma(t17, t29, 18.014141);
    let t33 = fma(t17, t31, (-11.581664));
    let t34 = t14 * t33;
    let t37 = fma(-t17, 20.674557, 0.049345504);
    let t39 = fma(t17, t37, 44.765247);
    let t41 = fma(t17, t39, (-1.5490279));
    let t43 = fma(t17, t41, (-33.034782));
    let t45 = fma(t17, t43, 2.9649389);
    let t47 = fma(t17, t45, 13.06735);
    let t49 = fma(t17, t47, (-8.881663));
    let t50 = t14 * t49;
    let t53 = fma(-t17, 13.256477, 0.47602892);
    let t55 = fma(t17, t53, 28.524736);
    let t57 = fma(t17, t55, (-1.7825657));
    let t59 = fma(t17, t57, (-21.048664));
    let t61 = fma(t17, t59, 3.013732);
    let t63 = fma(t17, t61, 6.052136);
    let t65 = fma(t17, t63, (-5.2143717));
    let t66 = t14 * t65;
    let t67 = d.x + d.y;
    let t68 = d.x - d.y;
    let t69 = t67 * t68;
    let t70 = d.x * 2.0;
    let t71 = d.y * t70;
    let t72 = d.z * d.z;
    let t75 = d.y * 0.48860252;
    let t76 = d.z * 0.48860252;
    let t77 = d.x * 0.48860252;
    let t79 = t71 * 0.54627424;
    let t81 = d.z * 1.0925485;
    let t82 = d.y * t81;
    let t85 = fma(t72, 0.9461747, (-0.31539157));
    let t86 = d.x * t81;
    let t87 = t69 * 0.54627424;
    let t88 = fma(t34, 0.2820948, f[0]);
    let t89 = fma(t50, t75, f[1]);
    let t90 = fma(t50, t76, f[2]);
    let t91 = fma(t50, t77, f[3]);
    let t92 = fma(t66, t79, f[4]);
    let t93 = fma(t66, t82, f[5]);
    let t94 = fma(t66, t85, f[6]);
    let t95 = fma(t66, t86, f[7]);
    let t96 = fma(t66, t87, f[8]);
    return array<f32, 9>(
        t88, t89, t90, t91, t92, t93, t94, t95, t96,
    );
}

// As `cap_log`, fitted to `exp_saturating` in the place of the eigen logarithm: sums of it over blockers are what that
// exponential is made for, and no other is. theta in 0..pi/2.
// Source: Ren et al. 2006, eq. 33-34, with the logarithm fitted against true visibilities; `gaunt-lab fit` rewrites the
// coefficients, `gaunt-lab accuracy` states their error.
// 17 multiplications, 13 additions.
fn sh3_cap_log_saturating(sine: f32, cosine: f32) -> array<f32, 3> {
    let t2 = sine * sine;
    let t5 = fma(cosine, 2.0, (-1.0));
    let t9 = fma(t5, 1.3317174, 1.0462912);
    let t11 = fma(t5, t9, (-4.946312));
    let t13 = fma(t5, t11, 4.5262027);
    let t15 = fma(t5, t13, (-2.172371));
    let t16 = t2 * t15;
    let t19 = fma(t5, 2.295521, 0.18202902);
    let t21 = fma(t5, t19, (-5.799306));
    let t23 = fma(t5, t21, 5.4090543);
    let t25 = fma(t5, t23, (-2.7540944));
    let t26 = t2 * t25;
    let t29 = fma(t5, 3.3814132, (-2.705135));
    let t31 = fma(t5, t29, (-3.0313816));
    let t33 = fma(t5, t31, 3.315428);
    let t35 = fma(t5, t33, (-2.419929));
    let t36 = t2 * t35;
    return array<f32, 3>(
        t16, t26, t36,
    );
}

// `f` plus the logarithm `cap_log_saturating` of the visibility past a circular blocker about the unit vector `d`: what
// one blocker costs a receiver of the shadow pass. The angular radius theta in 0..pi/2 comes as its sine and cosine.
// Source: Ren et al. 2006, eq. 34 and 8, with the fitted logarithm of `cap_log_saturating`.
// 39 multiplications, 25 additions.
fn sh3_add_cap_log_saturating(f: array<f32, 9>, sine: f32, cosine: f32, d: vec3<f32>) -> array<f32, 9> {
    let t14 = sine * sine;
    let t17 = fma(cosine, 2.0, (-1.0));
    let t21 = fma(t17, 4.720815, 3.7090058);
    let t23 = fma(t17, t21, (-17.53422));
    let t25 = fma(t17, t23, 16.044971);
    let t27 = fma(t17, t25, (-7.7008543));
    let t28 = t14 * t27;
    let t31 = fma(t17, 4.6981363, 0.3725503);
    let t33 = fma(t17, t31, (-11.869169));
    let t35 = fma(t17, t33, 11.070459);
    let t37 = fma(t17, t35, (-5.636677));
    let t38 = t14 * t37;
    let t41 = fma(t17, 5.360659, (-4.288534));
    let t43 = fma(t17, t41, (-4.8057427));
    let t45 = fma(t17, t43, 5.2560506);
    let t47 = fma(t17, t45, (-3.8363883));
    let t48 = t14 * t47;
    let t49 = d.x + d.y;
    let t50 = d.x - d.y;
    let t51 = t49 * t50;
    let t52 = d.x * 2.0;
    let t53 = d.y * t52;
    let t54 = d.z * d.z;
    let t57 = d.y * 0.48860252;
    let t58 = d.z * 0.48860252;
    let t59 = d.x * 0.48860252;
    let t61 = t53 * 0.54627424;
    let t63 = d.z * 1.0925485;
    let t64 = d.y * t63;
    let t67 = fma(t54, 0.9461747, (-0.31539157));
    let t68 = d.x * t63;
    let t69 = t51 * 0.54627424;
    let t70 = fma(t28, 0.2820948, f[0]);
    let t71 = fma(t38, t57, f[1]);
    let t72 = fma(t38, t58, f[2]);
    let t73 = fma(t38, t59, f[3]);
    let t74 = fma(t48, t61, f[4]);
    let t75 = fma(t48, t64, f[5]);
    let t76 = fma(t48, t67, f[6]);
    let t77 = fma(t48, t68, f[7]);
    let t78 = fma(t48, t69, f[8]);
    return array<f32, 9>(
        t70, t71, t72, t73, t74, t75, t76, t77, t78,
    );
}

// As `cap_log`, fitted to `transfer` in the place of the eigen logarithm. theta in 0..pi/2; of a small one band l is
// that of what the circle hides, so that few small blockers cast the whole of their shadow.
// Source: Ren et al. 2006, eq. 33-34, with the logarithm fitted against true transfers; `gaunt-lab fit` rewrites the
// coefficients.
// 14 multiplications, 10 additions.
fn sh3_cap_log_shading(sine: f32, cosine: f32) -> array<f32, 3> {
    let t2 = sine * sine;
    let t5 = fma(cosine, 2.0, (-1.0));
    let t9 = fma(-t5, 1.8702054, 1.7641344);
    let t11 = fma(t5, t9, 5.9901485);
    let t13 = fma(t5, t11, (-6.7703047));
    let t14 = t2 * t13;
    let t17 = fma(-t5, 5.115826, 2.3442216);
    let t19 = fma(t5, t17, 3.901193);
    let t21 = fma(t5, t19, (-2.6645784));
    let t22 = t2 * t21;
    let t25 = fma(t5, 0.6358743, 4.4560995);
    let t27 = fma(t5, t25, (-1.4047298));
    let t29 = fma(t5, t27, (-5.6689076));
    let t30 = t2 * t29;
    return array<f32, 3>(
        t14, t22, t30,
    );
}

// A sum of blockers plus one more: what one blocker of a cut costs a receiver of the shadow pass. The logarithm
// `cap_log_shading` about the unit vector `d`, band l of it times `w[l]`: a blocker's own weight, times the ratio
// vector of one that stands for several. Coefficients of the sum lack a factor each, which `accumulated_log` puts in at
// the end; it costs as little for many blockers as for one.
// Source: Ren et al. 2006, eq. 38, with the fitted logarithm of `cap_log_shading`.
// 31 multiplications, 22 additions.
fn sh3_accumulate_blocker(f: array<f32, 9>, sine: f32, cosine: f32, d: vec3<f32>, w: array<f32, 3>) -> array<f32, 9> {
    let t17 = sine * sine;
    let t18 = w[0] * t17;
    let t19 = w[1] * t17;
    let t20 = w[2] * t17;
    let t23 = fma(cosine, 2.0, (-1.0));
    let t27 = fma(-t23, 1.8702054, 1.7641344);
    let t29 = fma(t23, t27, 5.9901485);
    let t31 = fma(t23, t29, (-6.7703047));
    let t35 = fma(-t23, 5.115826, 2.3442216);
    let t37 = fma(t23, t35, 3.901193);
    let t39 = fma(t23, t37, (-2.6645784));
    let t40 = t19 * t39;
    let t43 = fma(t23, 0.6358743, 4.4560995);
    let t45 = fma(t23, t43, (-1.4047298));
    let t47 = fma(t23, t45, (-5.6689076));
    let t48 = t20 * t47;
    let t49 = d.x + d.y;
    let t50 = d.x - d.y;
    let t51 = t49 * t50;
    let t52 = d.x * 2.0;
    let t53 = d.y * t52;
    let t55 = d.y * d.z;
    let t57 = fma(d.z, d.z, (-0.33333334));
    let t58 = d.x * d.z;
    let t59 = fma(t18, t31, f[0]);
    let t60 = fma(d.y, t40, f[1]);
    let t61 = fma(d.z, t40, f[2]);
    let t62 = fma(d.x, t40, f[3]);
    let t63 = fma(t48, t53, f[4]);
    let t64 = fma(t48, t55, f[5]);
    let t65 = fma(t48, t57, f[6]);
    let t66 = fma(t48, t58, f[7]);
    let t67 = fma(t48, t51, f[8]);
    return array<f32, 9>(
        t59, t60, t61, t62, t63, t64, t65, t66, t67,
    );
}

// As `accumulate_blocker`, with the logarithm `cap_log_saturating`: for `exp_saturating`, where the visibility itself
// is asked for.
// Source: Ren et al. 2006, eq. 38, with the fitted logarithm of `cap_log_saturating`.
// 34 multiplications, 25 additions.
fn sh3_accumulate_blocker_saturating(f: array<f32, 9>, sine: f32, cosine: f32, d: vec3<f32>, w: array<f32, 3>) -> array<f32, 9> {
    let t17 = sine * sine;
    let t18 = w[0] * t17;
    let t19 = w[1] * t17;
    let t20 = w[2] * t17;
    let t23 = fma(cosine, 2.0, (-1.0));
    let t27 = fma(t23, 1.3317174, 1.0462912);
    let t29 = fma(t23, t27, (-4.946312));
    let t31 = fma(t23, t29, 4.5262027);
    let t33 = fma(t23, t31, (-2.172371));
    let t37 = fma(t23, 2.295521, 0.18202902);
    let t39 = fma(t23, t37, (-5.799306));
    let t41 = fma(t23, t39, 5.4090543);
    let t43 = fma(t23, t41, (-2.7540944));
    let t44 = t19 * t43;
    let t47 = fma(t23, 3.3814132, (-2.705135));
    let t49 = fma(t23, t47, (-3.0313816));
    let t51 = fma(t23, t49, 3.315428);
    let t53 = fma(t23, t51, (-2.419929));
    let t54 = t20 * t53;
    let t55 = d.x + d.y;
    let t56 = d.x - d.y;
    let t57 = t55 * t56;
    let t58 = d.x * 2.0;
    let t59 = d.y * t58;
    let t61 = d.y * d.z;
    let t63 = fma(d.z, d.z, (-0.33333334));
    let t64 = d.x * d.z;
    let t65 = fma(t18, t33, f[0]);
    let t66 = fma(d.y, t44, f[1]);
    let t67 = fma(d.z, t44, f[2]);
    let t68 = fma(d.x, t44, f[3]);
    let t69 = fma(t54, t59, f[4]);
    let t70 = fma(t54, t61, f[5]);
    let t71 = fma(t54, t63, f[6]);
    let t72 = fma(t54, t64, f[7]);
    let t73 = fma(t54, t57, f[8]);
    return array<f32, 9>(
        t65, t66, t67, t68, t69, t70, t71, t72, t73,
    );
}

// The logarithm of the visibility past all blockers that `accumulate_blocker` has summed up: each coefficient times its
// factor.
// Source: The leading coefficients of the basis functions, as polynomials in z, and sqrt(4 pi/(2l+1)).
// 5 multiplications, 0 additions.
fn sh3_accumulated_log(f: array<f32, 9>) -> array<f32, 9> {
    let t11 = f[4] * 0.8660254;
    let t13 = f[5] * 1.7320508;
    let t15 = f[6] * 1.5;
    let t16 = f[7] * 1.7320508;
    let t17 = f[8] * 0.8660254;
    return array<f32, 9>(
        f[0], f[1], f[2], f[3], t11, t13, t15, t16, t17,
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
// 39 multiplications, 21 additions.
fn sh3_ball_average(sine: f32, cosine: f32, d: vec3<f32>) -> array<f32, 9> {
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
    let t43 = d.x + d.y;
    let t44 = d.x - d.y;
    let t45 = t43 * t44;
    let t47 = d.x * 2.0;
    let t48 = d.y * t47;
    let t49 = d.z * d.z;
    let t52 = d.y * 0.48860252;
    let t53 = d.z * 0.48860252;
    let t54 = d.x * 0.48860252;
    let t56 = t48 * 0.54627424;
    let t58 = d.z * 1.0925485;
    let t59 = d.y * t58;
    let t62 = fma(t49, 0.9461747, (-0.31539157));
    let t63 = d.x * t58;
    let t64 = t45 * 0.54627424;
    let t65 = t24 * t52;
    let t66 = t24 * t53;
    let t67 = t24 * t54;
    let t68 = t42 * t56;
    let t69 = t42 * t59;
    let t70 = t42 * t62;
    let t71 = t42 * t63;
    let t72 = t42 * t64;
    return array<f32, 9>(
        0.2820948, t65, t66, t67, t68, t69, t70, t71, t72,
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
fn sh3_disc_covered(a: f32, b: f32, d: f32) -> f32 {
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
// 156 multiplications, 251 additions.
fn sh3_exp_saturating(f: array<f32, 9>) -> array<f32, 9> {
    let t10 = f[1] * f[1];
    let t11 = fma(f[2], f[2], t10);
    let t12 = fma(f[3], f[3], t11);
    let t13 = fma(f[4], f[4], t12);
    let t14 = fma(f[5], f[5], t13);
    let t15 = fma(f[6], f[6], t14);
    let t16 = fma(f[7], f[7], t15);
    let t17 = fma(f[8], f[8], t16);
    let t19 = min(t17, 1e37);
    let t22 = fma(t19, 0.2228105, 1.0);
    let t23 = sqrt(t22);
    let t24 = 1.0 / t23;
    let t25 = f[0] * t24;
    let t26 = f[1] * t24;
    let t27 = f[2] * t24;
    let t28 = f[3] * t24;
    let t29 = f[4] * t24;
    let t30 = f[5] * t24;
    let t31 = f[6] * t24;
    let t32 = f[7] * t24;
    let t33 = f[8] * t24;
    let t38 = t25 * 0.2820948;
    let t40 = t28 * 0.48860252;
    let t42 = fma(-t31, 0.31539157, t38);
    let t44 = fma(t33, 0.54627424, t42);
    let t45 = t40 + t44;
    let t46 = t44 - t40;
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
    let t60 = t57 * 0.16880512;
    let t62 = t58 * 0.28576553;
    let t64 = t57 * 0.11889197;
    let t66 = t57 * 0.20592694;
    let t67 = t26 * 0.48860252;
    let t68 = fma(-t33, 0.54627424, t42);
    let t69 = t67 + t68;
    let t70 = t68 - t67;
    let t71 = max(t69, (-1.0));
    let t72 = min(t71, 0.2);
    let t73 = fma((-0.25), t72, 0.75);
    let t74 = fma(t72, t73, 1.0);
    let t75 = t74 * t74;
    let t76 = max(t70, (-1.0));
    let t77 = min(t76, 0.2);
    let t78 = fma((-0.25), t77, 0.75);
    let t79 = fma(t77, t78, 1.0);
    let t80 = t79 * t79;
    let t81 = t75 + t80;
    let t82 = t75 - t80;
    let t83 = fma(0.16880512, t81, t60);
    let t84 = 0.28576553 * t82;
    let t85 = fma(0.11889197, t81, t64);
    let t86 = fma((-0.20592694), t81, t66);
    let t87 = t27 * 0.48860252;
    let t89 = fma(t31, 0.63078314, t38);
    let t90 = t87 + t89;
    let t91 = t89 - t87;
    let t92 = max(t90, (-1.0));
    let t93 = min(t92, 0.2);
    let t94 = fma((-0.25), t93, 0.75);
    let t95 = fma(t93, t94, 1.0);
    let t96 = t95 * t95;
    let t97 = max(t91, (-1.0));
    let t98 = min(t97, 0.2);
    let t99 = fma((-0.25), t98, 0.75);
    let t100 = fma(t98, t99, 1.0);
    let t101 = t100 * t100;
    let t102 = t96 + t101;
    let t103 = t96 - t101;
    let t104 = fma(0.16880512, t102, t83);
    let t105 = 0.28576553 * t103;
    let t107 = fma(t102, 0.23778394, -t85);
    let t109 = t26 * 0.34549415;
    let t110 = t27 * 0.34549415;
    let t111 = t30 * 0.54627424;
    let t113 = fma(t31, 0.15769579, t38);
    let t115 = fma(-t33, 0.27313712, t113);
    let t116 = t109 + t115;
    let t117 = t115 - t109;
    let t118 = t110 + t111;
    let t119 = t110 - t111;
    let t120 = t116 + t118;
    let t121 = t116 - t118;
    let t122 = t117 + t119;
    let t123 = t117 - t119;
    let t124 = max(t120, (-1.0));
    let t125 = min(t124, 0.2);
    let t126 = fma((-0.25), t125, 0.75);
    let t127 = fma(t125, t126, 1.0);
    let t128 = t127 * t127;
    let t129 = max(t122, (-1.0));
    let t130 = min(t129, 0.2);
    let t131 = fma((-0.25), t130, 0.75);
    let t132 = fma(t130, t131, 1.0);
    let t133 = t132 * t132;
    let t134 = max(t121, (-1.0));
    let t135 = min(t134, 0.2);
    let t136 = fma((-0.25), t135, 0.75);
    let t137 = fma(t135, t136, 1.0);
    let t138 = t137 * t137;
    let t139 = max(t123, (-1.0));
    let t140 = min(t139, 0.2);
    let t141 = fma((-0.25), t140, 0.75);
    let t142 = fma(t140, t141, 1.0);
    let t143 = t142 * t142;
    let t144 = t128 + t133;
    let t145 = t128 - t133;
    let t146 = t138 + t143;
    let t147 = t138 - t143;
    let t148 = t144 + t146;
    let t149 = t144 - t146;
    let t150 = t145 + t147;
    let t151 = t145 - t147;
    let t153 = fma(t148, 0.1350441, t104);
    let t155 = fma(t150, 0.1616534, t84);
    let t156 = fma(t149, 0.1616534, t105);
    let t158 = t151 * 0.16474155;
    let t160 = fma(t148, 0.047556788, t107);
    let t162 = fma(-t148, 0.08237077, t86);
    let t163 = t28 * 0.34549415;
    let t164 = t32 * 0.54627424;
    let t165 = fma(t33, 0.27313712, t113);
    let t166 = t163 + t165;
    let t167 = t165 - t163;
    let t168 = t110 + t164;
    let t169 = t110 - t164;
    let t170 = t166 + t168;
    let t171 = t166 - t168;
    let t172 = t167 + t169;
    let t173 = t167 - t169;
    let t174 = max(t170, (-1.0));
    let t175 = min(t174, 0.2);
    let t176 = fma((-0.25), t175, 0.75);
    let t177 = fma(t175, t176, 1.0);
    let t178 = t177 * t177;
    let t179 = max(t172, (-1.0));
    let t180 = min(t179, 0.2);
    let t181 = fma((-0.25), t180, 0.75);
    let t182 = fma(t180, t181, 1.0);
    let t183 = t182 * t182;
    let t184 = max(t171, (-1.0));
    let t185 = min(t184, 0.2);
    let t186 = fma((-0.25), t185, 0.75);
    let t187 = fma(t185, t186, 1.0);
    let t188 = t187 * t187;
    let t189 = max(t173, (-1.0));
    let t190 = min(t189, 0.2);
    let t191 = fma((-0.25), t190, 0.75);
    let t192 = fma(t190, t191, 1.0);
    let t193 = t192 * t192;
    let t194 = t178 + t183;
    let t195 = t178 - t183;
    let t196 = t188 + t193;
    let t197 = t188 - t193;
    let t198 = t194 + t196;
    let t199 = t194 - t196;
    let t200 = t195 + t197;
    let t201 = t195 - t197;
    let t202 = fma(0.1350441, t198, t153);
    let t203 = fma(0.1616534, t199, t156);
    let t204 = fma(0.1616534, t200, t62);
    let t205 = fma(0.047556788, t198, t160);
    let t206 = 0.16474155 * t201;
    let t207 = fma(0.08237077, t198, t162);
    let t209 = t29 * 0.54627424;
    let t210 = t42 + t163;
    let t211 = t42 - t163;
    let t212 = t109 + t209;
    let t213 = t109 - t209;
    let t214 = t210 + t212;
    let t215 = t210 - t212;
    let t216 = t211 + t213;
    let t217 = t211 - t213;
    let t218 = max(t214, (-1.0));
    let t219 = min(t218, 0.2);
    let t220 = fma((-0.25), t219, 0.75);
    let t221 = fma(t219, t220, 1.0);
    let t222 = t221 * t221;
    let t223 = max(t216, (-1.0));
    let t224 = min(t223, 0.2);
    let t225 = fma((-0.25), t224, 0.75);
    let t226 = fma(t224, t225, 1.0);
    let t227 = t226 * t226;
    let t228 = max(t215, (-1.0));
    let t229 = min(t228, 0.2);
    let t230 = fma((-0.25), t229, 0.75);
    let t231 = fma(t229, t230, 1.0);
    let t232 = t231 * t231;
    let t233 = max(t217, (-1.0));
    let t234 = min(t233, 0.2);
    let t235 = fma((-0.25), t234, 0.75);
    let t236 = fma(t234, t235, 1.0);
    let t237 = t236 * t236;
    let t238 = t222 + t227;
    let t239 = t222 - t227;
    let t240 = t232 + t237;
    let t241 = t232 - t237;
    let t242 = t238 + t240;
    let t243 = t238 - t240;
    let t244 = t239 + t241;
    let t245 = t239 - t241;
    let t246 = fma(0.1350441, t242, t202);
    let t247 = fma(0.1616534, t243, t155);
    let t248 = fma(0.1616534, t244, t204);
    let t250 = t245 * 0.16474155;
    let t252 = fma(-t242, 0.095113575, t205);
    let t253 = t26 * 0.2820948;
    let t254 = t27 * 0.2820948;
    let t255 = t28 * 0.2820948;
    let t257 = t29 * 0.3641828;
    let t258 = t30 * 0.3641828;
    let t259 = t32 * 0.3641828;
    let t260 = t38 + t255;
    let t261 = t38 - t255;
    let t262 = t253 + t257;
    let t263 = t253 - t257;
    let t264 = t254 + t259;
    let t265 = t254 - t259;
    let t266 = t260 + t262;
    let t267 = t260 - t262;
    let t268 = t261 + t263;
    let t269 = t261 - t263;
    let t270 = t258 + t264;
    let t271 = t264 - t258;
    let t272 = t258 + t265;
    let t273 = t265 - t258;
    let t274 = t266 + t270;
    let t275 = t266 - t270;
    let t276 = t268 + t272;
    let t277 = t268 - t272;
    let t278 = t267 + t271;
    let t279 = t267 - t271;
    let t280 = t269 + t273;
    let t281 = t269 - t273;
    let t282 = max(t274, (-1.0));
    let t283 = min(t282, 0.2);
    let t284 = fma((-0.25), t283, 0.75);
    let t285 = fma(t283, t284, 1.0);
    let t286 = t285 * t285;
    let t287 = max(t276, (-1.0));
    let t288 = min(t287, 0.2);
    let t289 = fma((-0.25), t288, 0.75);
    let t290 = fma(t288, t289, 1.0);
    let t291 = t290 * t290;
    let t292 = max(t278, (-1.0));
    let t293 = min(t292, 0.2);
    let t294 = fma((-0.25), t293, 0.75);
    let t295 = fma(t293, t294, 1.0);
    let t296 = t295 * t295;
    let t297 = max(t280, (-1.0));
    let t298 = min(t297, 0.2);
    let t299 = fma((-0.25), t298, 0.75);
    let t300 = fma(t298, t299, 1.0);
    let t301 = t300 * t300;
    let t302 = max(t275, (-1.0));
    let t303 = min(t302, 0.2);
    let t304 = fma((-0.25), t303, 0.75);
    let t305 = fma(t303, t304, 1.0);
    let t306 = t305 * t305;
    let t307 = max(t277, (-1.0));
    let t308 = min(t307, 0.2);
    let t309 = fma((-0.25), t308, 0.75);
    let t310 = fma(t308, t309, 1.0);
    let t311 = t310 * t310;
    let t312 = max(t279, (-1.0));
    let t313 = min(t312, 0.2);
    let t314 = fma((-0.25), t313, 0.75);
    let t315 = fma(t313, t314, 1.0);
    let t316 = t315 * t315;
    let t317 = max(t281, (-1.0));
    let t318 = min(t317, 0.2);
    let t319 = fma((-0.25), t318, 0.75);
    let t320 = fma(t318, t319, 1.0);
    let t321 = t320 * t320;
    let t322 = t286 + t291;
    let t323 = t286 - t291;
    let t324 = t296 + t301;
    let t325 = t296 - t301;
    let t326 = t306 + t311;
    let t327 = t306 - t311;
    let t328 = t316 + t321;
    let t329 = t316 - t321;
    let t330 = t322 + t324;
    let t331 = t322 - t324;
    let t332 = t323 + t325;
    let t333 = t323 - t325;
    let t334 = t326 + t328;
    let t335 = t326 - t328;
    let t336 = t327 + t329;
    let t337 = t327 - t329;
    let t338 = t330 + t334;
    let t339 = t330 - t334;
    let t340 = t332 + t336;
    let t341 = t332 - t336;
    let t342 = t331 + t335;
    let t343 = t331 - t335;
    let t344 = t333 + t337;
    let t347 = fma(t338, 0.113943465, t246);
    let t349 = fma(t342, 0.1113661, t247);
    let t350 = fma(t339, 0.1113661, t203);
    let t351 = fma(t340, 0.1113661, t248);
    let t353 = fma(t344, 0.09266712, t250);
    let t354 = fma(t343, 0.09266712, t158);
    let t355 = fma(t341, 0.09266712, t206);
    return array<f32, 9>(
        t347, t349, t350, t351, t353, t354, t252, t355, t207,
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
// 253 multiplications, 289 additions.
fn sh3_transfer(f: array<f32, 9>, d: vec3<f32>) -> array<f32, 9> {
    let t14 = f[1] * f[1];
    let t15 = fma(f[2], f[2], t14);
    let t16 = fma(f[3], f[3], t15);
    let t17 = fma(f[4], f[4], t16);
    let t18 = fma(f[5], f[5], t17);
    let t19 = fma(f[6], f[6], t18);
    let t20 = fma(f[7], f[7], t19);
    let t21 = fma(f[8], f[8], t20);
    let t23 = min(t21, 1e37);
    let t26 = fma(t23, 0.08251911, 1.0);
    let t27 = sqrt(t26);
    let t28 = 1.0 / t27;
    let t29 = f[0] * t28;
    let t30 = f[1] * t28;
    let t31 = f[2] * t28;
    let t32 = f[3] * t28;
    let t33 = f[4] * t28;
    let t34 = f[5] * t28;
    let t35 = f[6] * t28;
    let t36 = f[7] * t28;
    let t37 = f[8] * t28;
    let t41 = t29 * 0.2820948;
    let t43 = t32 * 0.48860252;
    let t45 = fma(-t35, 0.31539157, t41);
    let t47 = fma(t37, 0.54627424, t45);
    let t48 = t43 + t47;
    let t49 = t47 - t43;
    let t50 = fma(0.25, t48, 1.0);
    let t51 = max(t50, 0.0);
    let t52 = min(t51, 1.125);
    let t53 = t52 * t52;
    let t54 = t53 * t53;
    let t55 = d.x * d.x;
    let t58 = fma(-t55, 0.13055679, 0.26111358);
    let t60 = fma(t55, t58, 0.01865097);
    let t61 = fma(d.x, 0.15915494, t60);
    let t62 = t54 * t61;
    let t63 = fma(0.25, t49, 1.0);
    let t64 = max(t63, 0.0);
    let t65 = min(t64, 1.125);
    let t66 = t65 * t65;
    let t67 = t66 * t66;
    let t68 = fma(-d.x, 0.15915494, t60);
    let t69 = t67 * t68;
    let t70 = t62 + t69;
    let t71 = t62 - t69;
    let t73 = t70 * 0.16880512;
    let t75 = t71 * 0.29237905;
    let t77 = t70 * 0.18872987;
    let t79 = t70 * 0.32688972;
    let t80 = t30 * 0.48860252;
    let t81 = fma(-t37, 0.54627424, t45);
    let t82 = t80 + t81;
    let t83 = t81 - t80;
    let t84 = fma(0.25, t82, 1.0);
    let t85 = max(t84, 0.0);
    let t86 = min(t85, 1.125);
    let t87 = t86 * t86;
    let t88 = t87 * t87;
    let t89 = d.y * d.y;
    let t90 = fma((-0.13055679), t89, 0.26111358);
    let t91 = fma(t89, t90, 0.01865097);
    let t92 = fma(d.y, 0.15915494, t91);
    let t93 = t88 * t92;
    let t94 = fma(0.25, t83, 1.0);
    let t95 = max(t94, 0.0);
    let t96 = min(t95, 1.125);
    let t97 = t96 * t96;
    let t98 = t97 * t97;
    let t99 = fma(-d.y, 0.15915494, t91);
    let t100 = t98 * t99;
    let t101 = t93 + t100;
    let t102 = t93 - t100;
    let t103 = fma(0.16880512, t101, t73);
    let t104 = 0.29237905 * t102;
    let t105 = fma(0.18872987, t101, t77);
    let t106 = fma((-0.32688972), t101, t79);
    let t107 = t31 * 0.48860252;
    let t109 = fma(t35, 0.63078314, t41);
    let t110 = t107 + t109;
    let t111 = t109 - t107;
    let t112 = fma(0.25, t110, 1.0);
    let t113 = max(t112, 0.0);
    let t114 = min(t113, 1.125);
    let t115 = t114 * t114;
    let t116 = t115 * t115;
    let t117 = d.z * d.z;
    let t118 = fma((-0.13055679), t117, 0.26111358);
    let t119 = fma(t117, t118, 0.01865097);
    let t120 = fma(d.z, 0.15915494, t119);
    let t121 = t116 * t120;
    let t122 = fma(0.25, t111, 1.0);
    let t123 = max(t122, 0.0);
    let t124 = min(t123, 1.125);
    let t125 = t124 * t124;
    let t126 = t125 * t125;
    let t127 = fma(-d.z, 0.15915494, t119);
    let t128 = t126 * t127;
    let t129 = t121 + t128;
    let t130 = t121 - t128;
    let t131 = fma(0.16880512, t129, t103);
    let t132 = 0.29237905 * t130;
    let t134 = fma(t129, 0.37745973, -t105);
    let t136 = t30 * 0.34549415;
    let t137 = t31 * 0.34549415;
    let t138 = t34 * 0.54627424;
    let t140 = fma(t35, 0.15769579, t41);
    let t142 = fma(-t37, 0.27313712, t140);
    let t143 = t136 + t142;
    let t144 = t142 - t136;
    let t145 = t137 + t138;
    let t146 = t137 - t138;
    let t147 = t143 + t145;
    let t148 = t143 - t145;
    let t149 = t144 + t146;
    let t150 = t144 - t146;
    let t152 = d.y * 0.70710677;
    let t153 = d.z * 0.70710677;
    let t154 = t152 + t153;
    let t155 = t152 - t153;
    let t156 = fma(0.25, t147, 1.0);
    let t157 = max(t156, 0.0);
    let t158 = min(t157, 1.125);
    let t159 = t158 * t158;
    let t160 = t159 * t159;
    let t161 = t154 * t154;
    let t162 = fma((-0.13055679), t161, 0.26111358);
    let t163 = fma(t161, t162, 0.01865097);
    let t164 = fma(0.15915494, t154, t163);
    let t165 = t160 * t164;
    let t166 = fma(0.25, t149, 1.0);
    let t167 = max(t166, 0.0);
    let t168 = min(t167, 1.125);
    let t169 = t168 * t168;
    let t170 = t169 * t169;
    let t171 = t155 * t155;
    let t172 = fma((-0.13055679), t171, 0.26111358);
    let t173 = fma(t171, t172, 0.01865097);
    let t174 = fma((-0.15915494), t155, t173);
    let t175 = t170 * t174;
    let t176 = fma(0.25, t148, 1.0);
    let t177 = max(t176, 0.0);
    let t178 = min(t177, 1.125);
    let t179 = t178 * t178;
    let t180 = t179 * t179;
    let t181 = fma(0.15915494, t155, t173);
    let t182 = t180 * t181;
    let t183 = fma(0.25, t150, 1.0);
    let t184 = max(t183, 0.0);
    let t185 = min(t184, 1.125);
    let t186 = t185 * t185;
    let t187 = t186 * t186;
    let t188 = fma((-0.15915494), t154, t163);
    let t189 = t187 * t188;
    let t190 = t165 + t175;
    let t191 = t165 - t175;
    let t192 = t182 + t189;
    let t193 = t182 - t189;
    let t194 = t190 + t192;
    let t195 = t190 - t192;
    let t196 = t191 + t193;
    let t197 = t191 - t193;
    let t199 = fma(t194, 0.1350441, t131);
    let t201 = fma(t196, 0.16539457, t104);
    let t202 = fma(t195, 0.16539457, t132);
    let t204 = t197 * 0.26151177;
    let t206 = fma(t194, 0.07549195, t134);
    let t208 = fma(-t194, 0.13075589, t106);
    let t209 = t32 * 0.34549415;
    let t210 = t36 * 0.54627424;
    let t211 = fma(t37, 0.27313712, t140);
    let t212 = t209 + t211;
    let t213 = t211 - t209;
    let t214 = t137 + t210;
    let t215 = t137 - t210;
    let t216 = t212 + t214;
    let t217 = t212 - t214;
    let t218 = t213 + t215;
    let t219 = t213 - t215;
    let t220 = d.x * 0.70710677;
    let t221 = t153 + t220;
    let t222 = t220 - t153;
    let t223 = fma(0.25, t216, 1.0);
    let t224 = max(t223, 0.0);
    let t225 = min(t224, 1.125);
    let t226 = t225 * t225;
    let t227 = t226 * t226;
    let t228 = t221 * t221;
    let t229 = fma((-0.13055679), t228, 0.26111358);
    let t230 = fma(t228, t229, 0.01865097);
    let t231 = fma(0.15915494, t221, t230);
    let t232 = t227 * t231;
    let t233 = fma(0.25, t218, 1.0);
    let t234 = max(t233, 0.0);
    let t235 = min(t234, 1.125);
    let t236 = t235 * t235;
    let t237 = t236 * t236;
    let t238 = t222 * t222;
    let t239 = fma((-0.13055679), t238, 0.26111358);
    let t240 = fma(t238, t239, 0.01865097);
    let t241 = fma((-0.15915494), t222, t240);
    let t242 = t237 * t241;
    let t243 = fma(0.25, t217, 1.0);
    let t244 = max(t243, 0.0);
    let t245 = min(t244, 1.125);
    let t246 = t245 * t245;
    let t247 = t246 * t246;
    let t248 = fma(0.15915494, t222, t240);
    let t249 = t247 * t248;
    let t250 = fma(0.25, t219, 1.0);
    let t251 = max(t250, 0.0);
    let t252 = min(t251, 1.125);
    let t253 = t252 * t252;
    let t254 = t253 * t253;
    let t255 = fma((-0.15915494), t221, t230);
    let t256 = t254 * t255;
    let t257 = t232 + t242;
    let t258 = t232 - t242;
    let t259 = t249 + t256;
    let t260 = t249 - t256;
    let t261 = t257 + t259;
    let t262 = t257 - t259;
    let t263 = t258 + t260;
    let t264 = t258 - t260;
    let t265 = fma(0.1350441, t261, t199);
    let t266 = fma(0.16539457, t262, t202);
    let t267 = fma(0.16539457, t263, t75);
    let t268 = fma(0.07549195, t261, t206);
    let t269 = 0.26151177 * t264;
    let t270 = fma(0.13075589, t261, t208);
    let t272 = t33 * 0.54627424;
    let t273 = t45 + t209;
    let t274 = t45 - t209;
    let t275 = t136 + t272;
    let t276 = t136 - t272;
    let t277 = t273 + t275;
    let t278 = t273 - t275;
    let t279 = t274 + t276;
    let t280 = t274 - t276;
    let t281 = t152 + t220;
    let t282 = t220 - t152;
    let t283 = fma(0.25, t277, 1.0);
    let t284 = max(t283, 0.0);
    let t285 = min(t284, 1.125);
    let t286 = t285 * t285;
    let t287 = t286 * t286;
    let t288 = t281 * t281;
    let t289 = fma((-0.13055679), t288, 0.26111358);
    let t290 = fma(t288, t289, 0.01865097);
    let t291 = fma(0.15915494, t281, t290);
    let t292 = t287 * t291;
    let t293 = fma(0.25, t279, 1.0);
    let t294 = max(t293, 0.0);
    let t295 = min(t294, 1.125);
    let t296 = t295 * t295;
    let t297 = t296 * t296;
    let t298 = t282 * t282;
    let t299 = fma((-0.13055679), t298, 0.26111358);
    let t300 = fma(t298, t299, 0.01865097);
    let t301 = fma((-0.15915494), t282, t300);
    let t302 = t297 * t301;
    let t303 = fma(0.25, t278, 1.0);
    let t304 = max(t303, 0.0);
    let t305 = min(t304, 1.125);
    let t306 = t305 * t305;
    let t307 = t306 * t306;
    let t308 = fma(0.15915494, t282, t300);
    let t309 = t307 * t308;
    let t310 = fma(0.25, t280, 1.0);
    let t311 = max(t310, 0.0);
    let t312 = min(t311, 1.125);
    let t313 = t312 * t312;
    let t314 = t313 * t313;
    let t315 = fma((-0.15915494), t281, t290);
    let t316 = t314 * t315;
    let t317 = t292 + t302;
    let t318 = t292 - t302;
    let t319 = t309 + t316;
    let t320 = t309 - t316;
    let t321 = t317 + t319;
    let t322 = t317 - t319;
    let t323 = t318 + t320;
    let t324 = t318 - t320;
    let t325 = fma(0.1350441, t321, t265);
    let t326 = fma(0.16539457, t322, t201);
    let t327 = fma(0.16539457, t323, t267);
    let t329 = t324 * 0.26151177;
    let t331 = fma(-t321, 0.1509839, t268);
    let t332 = t30 * 0.2820948;
    let t333 = t31 * 0.2820948;
    let t334 = t32 * 0.2820948;
    let t336 = t33 * 0.3641828;
    let t337 = t34 * 0.3641828;
    let t338 = t36 * 0.3641828;
    let t339 = t41 + t334;
    let t340 = t41 - t334;
    let t341 = t332 + t336;
    let t342 = t332 - t336;
    let t343 = t333 + t338;
    let t344 = t333 - t338;
    let t345 = t339 + t341;
    let t346 = t339 - t341;
    let t347 = t340 + t342;
    let t348 = t340 - t342;
    let t349 = t337 + t343;
    let t350 = t343 - t337;
    let t351 = t337 + t344;
    let t352 = t344 - t337;
    let t353 = t345 + t349;
    let t354 = t345 - t349;
    let t355 = t347 + t351;
    let t356 = t347 - t351;
    let t357 = t346 + t350;
    let t358 = t346 - t350;
    let t359 = t348 + t352;
    let t360 = t348 - t352;
    let t362 = d.x * 0.57735026;
    let t363 = d.y * 0.57735026;
    let t364 = d.z * 0.57735026;
    let t365 = t362 + t363;
    let t366 = t362 - t363;
    let t367 = t364 + t365;
    let t368 = t365 - t364;
    let t369 = t364 - t366;
    let t370 = t364 + t366;
    let t371 = fma(0.25, t353, 1.0);
    let t372 = max(t371, 0.0);
    let t373 = min(t372, 1.125);
    let t374 = t373 * t373;
    let t375 = t374 * t374;
    let t376 = t367 * t367;
    let t377 = fma((-0.13055679), t376, 0.26111358);
    let t378 = fma(t376, t377, 0.01865097);
    let t379 = fma(0.15915494, t367, t378);
    let t380 = t375 * t379;
    let t381 = fma(0.25, t355, 1.0);
    let t382 = max(t381, 0.0);
    let t383 = min(t382, 1.125);
    let t384 = t383 * t383;
    let t385 = t384 * t384;
    let t386 = t369 * t369;
    let t387 = fma((-0.13055679), t386, 0.26111358);
    let t388 = fma(t386, t387, 0.01865097);
    let t389 = fma(0.15915494, t369, t388);
    let t390 = t385 * t389;
    let t391 = fma(0.25, t357, 1.0);
    let t392 = max(t391, 0.0);
    let t393 = min(t392, 1.125);
    let t394 = t393 * t393;
    let t395 = t394 * t394;
    let t396 = t370 * t370;
    let t397 = fma((-0.13055679), t396, 0.26111358);
    let t398 = fma(t396, t397, 0.01865097);
    let t399 = fma(0.15915494, t370, t398);
    let t400 = t395 * t399;
    let t401 = fma(0.25, t359, 1.0);
    let t402 = max(t401, 0.0);
    let t403 = min(t402, 1.125);
    let t404 = t403 * t403;
    let t405 = t404 * t404;
    let t406 = t368 * t368;
    let t407 = fma((-0.13055679), t406, 0.26111358);
    let t408 = fma(t406, t407, 0.01865097);
    let t409 = fma((-0.15915494), t368, t408);
    let t410 = t405 * t409;
    let t411 = fma(0.25, t354, 1.0);
    let t412 = max(t411, 0.0);
    let t413 = min(t412, 1.125);
    let t414 = t413 * t413;
    let t415 = t414 * t414;
    let t416 = fma(0.15915494, t368, t408);
    let t417 = t415 * t416;
    let t418 = fma(0.25, t356, 1.0);
    let t419 = max(t418, 0.0);
    let t420 = min(t419, 1.125);
    let t421 = t420 * t420;
    let t422 = t421 * t421;
    let t423 = fma((-0.15915494), t370, t398);
    let t424 = t422 * t423;
    let t425 = fma(0.25, t358, 1.0);
    let t426 = max(t425, 0.0);
    let t427 = min(t426, 1.125);
    let t428 = t427 * t427;
    let t429 = t428 * t428;
    let t430 = fma((-0.15915494), t369, t388);
    let t431 = t429 * t430;
    let t432 = fma(0.25, t360, 1.0);
    let t433 = max(t432, 0.0);
    let t434 = min(t433, 1.125);
    let t435 = t434 * t434;
    let t436 = t435 * t435;
    let t437 = fma((-0.15915494), t367, t378);
    let t438 = t436 * t437;
    let t439 = t380 + t390;
    let t440 = t380 - t390;
    let t441 = t400 + t410;
    let t442 = t400 - t410;
    let t443 = t417 + t424;
    let t444 = t417 - t424;
    let t445 = t431 + t438;
    let t446 = t431 - t438;
    let t447 = t439 + t441;
    let t448 = t439 - t441;
    let t449 = t440 + t442;
    let t450 = t440 - t442;
    let t451 = t443 + t445;
    let t452 = t443 - t445;
    let t453 = t444 + t446;
    let t454 = t444 - t446;
    let t455 = t447 + t451;
    let t456 = t447 - t451;
    let t457 = t449 + t453;
    let t458 = t449 - t453;
    let t459 = t448 + t452;
    let t460 = t448 - t452;
    let t461 = t450 + t454;
    let t464 = fma(t455, 0.113943465, t325);
    let t465 = fma(t459, 0.113943465, t326);
    let t466 = fma(t456, 0.113943465, t266);
    let t467 = fma(t457, 0.113943465, t327);
    let t469 = fma(t461, 0.14710037, t329);
    let t470 = fma(t460, 0.14710037, t204);
    let t471 = fma(t458, 0.14710037, t269);
    return array<f32, 9>(
        t464, t465, t466, t467, t469, t470, t331, t471, t270,
    );
}

// As `transfer`, with another lobe about the unit vector `d` in the place of the cosine's: band l of it is `w[l]`, held
// in -1..1, times that of a lobe of no width, so that `w[0]` is the share of an even sky that it gives. Without
// blockers it is y_l(d) times `w[l]`.
//
// Promises for any f: the norm of the result is at most 1.602 times the lobe's at the samples, n^2/sqrt(4 pi).
// Source: As `transfer`; the lobe is of the order of `f`.
// 244 multiplications, 296 additions.
fn sh3_transfer_lobe(f: array<f32, 9>, d: vec3<f32>, w: array<f32, 3>) -> array<f32, 9> {
    let t16 = min(w[0], 1.0);
    let t17 = max(t16, (-1.0));
    let t19 = t17 * 0.07957747;
    let t20 = min(w[1], 1.0);
    let t21 = max(t20, (-1.0));
    let t23 = t21 * 0.23873241;
    let t24 = min(w[2], 1.0);
    let t25 = max(t24, (-1.0));
    let t27 = fma(-t25, 0.19894367, t19);
    let t29 = t25 * 0.596831;
    let t31 = f[1] * f[1];
    let t32 = fma(f[2], f[2], t31);
    let t33 = fma(f[3], f[3], t32);
    let t34 = fma(f[4], f[4], t33);
    let t35 = fma(f[5], f[5], t34);
    let t36 = fma(f[6], f[6], t35);
    let t37 = fma(f[7], f[7], t36);
    let t38 = fma(f[8], f[8], t37);
    let t40 = min(t38, 1e37);
    let t42 = fma(t40, 0.08251911, 1.0);
    let t43 = sqrt(t42);
    let t44 = 1.0 / t43;
    let t45 = f[0] * t44;
    let t46 = f[1] * t44;
    let t47 = f[2] * t44;
    let t48 = f[3] * t44;
    let t49 = f[4] * t44;
    let t50 = f[5] * t44;
    let t51 = f[6] * t44;
    let t52 = f[7] * t44;
    let t53 = f[8] * t44;
    let t57 = t45 * 0.2820948;
    let t59 = t48 * 0.48860252;
    let t61 = fma(-t51, 0.31539157, t57);
    let t63 = fma(t53, 0.54627424, t61);
    let t64 = t59 + t63;
    let t65 = t63 - t59;
    let t66 = fma(0.25, t64, 1.0);
    let t67 = max(t66, 0.0);
    let t68 = min(t67, 1.125);
    let t69 = t68 * t68;
    let t70 = t69 * t69;
    let t71 = fma(d.x, t29, t23);
    let t72 = fma(d.x, t71, t27);
    let t73 = t70 * t72;
    let t74 = fma(0.25, t65, 1.0);
    let t75 = max(t74, 0.0);
    let t76 = min(t75, 1.125);
    let t77 = t76 * t76;
    let t78 = t77 * t77;
    let t79 = fma(-d.x, t29, t23);
    let t80 = fma(-d.x, t79, t27);
    let t81 = t78 * t80;
    let t82 = t73 + t81;
    let t83 = t73 - t81;
    let t85 = t82 * 0.16880512;
    let t87 = t83 * 0.29237905;
    let t89 = t82 * 0.18872987;
    let t91 = t82 * 0.32688972;
    let t92 = t46 * 0.48860252;
    let t93 = fma(-t53, 0.54627424, t61);
    let t94 = t92 + t93;
    let t95 = t93 - t92;
    let t96 = fma(0.25, t94, 1.0);
    let t97 = max(t96, 0.0);
    let t98 = min(t97, 1.125);
    let t99 = t98 * t98;
    let t100 = t99 * t99;
    let t101 = fma(d.y, t29, t23);
    let t102 = fma(d.y, t101, t27);
    let t103 = t100 * t102;
    let t104 = fma(0.25, t95, 1.0);
    let t105 = max(t104, 0.0);
    let t106 = min(t105, 1.125);
    let t107 = t106 * t106;
    let t108 = t107 * t107;
    let t109 = fma(-d.y, t29, t23);
    let t110 = fma(-d.y, t109, t27);
    let t111 = t108 * t110;
    let t112 = t103 + t111;
    let t113 = t103 - t111;
    let t114 = fma(0.16880512, t112, t85);
    let t115 = 0.29237905 * t113;
    let t116 = fma(0.18872987, t112, t89);
    let t117 = fma((-0.32688972), t112, t91);
    let t118 = t47 * 0.48860252;
    let t120 = fma(t51, 0.63078314, t57);
    let t121 = t118 + t120;
    let t122 = t120 - t118;
    let t123 = fma(0.25, t121, 1.0);
    let t124 = max(t123, 0.0);
    let t125 = min(t124, 1.125);
    let t126 = t125 * t125;
    let t127 = t126 * t126;
    let t128 = fma(d.z, t29, t23);
    let t129 = fma(d.z, t128, t27);
    let t130 = t127 * t129;
    let t131 = fma(0.25, t122, 1.0);
    let t132 = max(t131, 0.0);
    let t133 = min(t132, 1.125);
    let t134 = t133 * t133;
    let t135 = t134 * t134;
    let t136 = fma(-d.z, t29, t23);
    let t137 = fma(-d.z, t136, t27);
    let t138 = t135 * t137;
    let t139 = t130 + t138;
    let t140 = t130 - t138;
    let t141 = fma(0.16880512, t139, t114);
    let t142 = 0.29237905 * t140;
    let t144 = fma(t139, 0.37745973, -t116);
    let t146 = t46 * 0.34549415;
    let t147 = t47 * 0.34549415;
    let t148 = t50 * 0.54627424;
    let t150 = fma(t51, 0.15769579, t57);
    let t152 = fma(-t53, 0.27313712, t150);
    let t153 = t146 + t152;
    let t154 = t152 - t146;
    let t155 = t147 + t148;
    let t156 = t147 - t148;
    let t157 = t153 + t155;
    let t158 = t153 - t155;
    let t159 = t154 + t156;
    let t160 = t154 - t156;
    let t162 = d.y * 0.70710677;
    let t163 = d.z * 0.70710677;
    let t164 = t162 + t163;
    let t165 = t162 - t163;
    let t166 = fma(0.25, t157, 1.0);
    let t167 = max(t166, 0.0);
    let t168 = min(t167, 1.125);
    let t169 = t168 * t168;
    let t170 = t169 * t169;
    let t171 = fma(t29, t164, t23);
    let t172 = fma(t164, t171, t27);
    let t173 = t170 * t172;
    let t174 = fma(0.25, t159, 1.0);
    let t175 = max(t174, 0.0);
    let t176 = min(t175, 1.125);
    let t177 = t176 * t176;
    let t178 = t177 * t177;
    let t179 = fma(-t29, t165, t23);
    let t180 = fma(-t165, t179, t27);
    let t181 = t178 * t180;
    let t182 = fma(0.25, t158, 1.0);
    let t183 = max(t182, 0.0);
    let t184 = min(t183, 1.125);
    let t185 = t184 * t184;
    let t186 = t185 * t185;
    let t187 = fma(t29, t165, t23);
    let t188 = fma(t165, t187, t27);
    let t189 = t186 * t188;
    let t190 = fma(0.25, t160, 1.0);
    let t191 = max(t190, 0.0);
    let t192 = min(t191, 1.125);
    let t193 = t192 * t192;
    let t194 = t193 * t193;
    let t195 = fma(-t29, t164, t23);
    let t196 = fma(-t164, t195, t27);
    let t197 = t194 * t196;
    let t198 = t173 + t181;
    let t199 = t173 - t181;
    let t200 = t189 + t197;
    let t201 = t189 - t197;
    let t202 = t198 + t200;
    let t203 = t198 - t200;
    let t204 = t199 + t201;
    let t205 = t199 - t201;
    let t207 = fma(t202, 0.1350441, t141);
    let t209 = fma(t204, 0.16539457, t115);
    let t210 = fma(t203, 0.16539457, t142);
    let t212 = t205 * 0.26151177;
    let t214 = fma(t202, 0.07549195, t144);
    let t216 = fma(-t202, 0.13075589, t117);
    let t217 = t48 * 0.34549415;
    let t218 = t52 * 0.54627424;
    let t219 = fma(t53, 0.27313712, t150);
    let t220 = t217 + t219;
    let t221 = t219 - t217;
    let t222 = t147 + t218;
    let t223 = t147 - t218;
    let t224 = t220 + t222;
    let t225 = t220 - t222;
    let t226 = t221 + t223;
    let t227 = t221 - t223;
    let t228 = d.x * 0.70710677;
    let t229 = t163 + t228;
    let t230 = t228 - t163;
    let t231 = fma(0.25, t224, 1.0);
    let t232 = max(t231, 0.0);
    let t233 = min(t232, 1.125);
    let t234 = t233 * t233;
    let t235 = t234 * t234;
    let t236 = fma(t29, t229, t23);
    let t237 = fma(t229, t236, t27);
    let t238 = t235 * t237;
    let t239 = fma(0.25, t226, 1.0);
    let t240 = max(t239, 0.0);
    let t241 = min(t240, 1.125);
    let t242 = t241 * t241;
    let t243 = t242 * t242;
    let t244 = fma(-t29, t230, t23);
    let t245 = fma(-t230, t244, t27);
    let t246 = t243 * t245;
    let t247 = fma(0.25, t225, 1.0);
    let t248 = max(t247, 0.0);
    let t249 = min(t248, 1.125);
    let t250 = t249 * t249;
    let t251 = t250 * t250;
    let t252 = fma(t29, t230, t23);
    let t253 = fma(t230, t252, t27);
    let t254 = t251 * t253;
    let t255 = fma(0.25, t227, 1.0);
    let t256 = max(t255, 0.0);
    let t257 = min(t256, 1.125);
    let t258 = t257 * t257;
    let t259 = t258 * t258;
    let t260 = fma(-t29, t229, t23);
    let t261 = fma(-t229, t260, t27);
    let t262 = t259 * t261;
    let t263 = t238 + t246;
    let t264 = t238 - t246;
    let t265 = t254 + t262;
    let t266 = t254 - t262;
    let t267 = t263 + t265;
    let t268 = t263 - t265;
    let t269 = t264 + t266;
    let t270 = t264 - t266;
    let t271 = fma(0.1350441, t267, t207);
    let t272 = fma(0.16539457, t268, t210);
    let t273 = fma(0.16539457, t269, t87);
    let t274 = fma(0.07549195, t267, t214);
    let t275 = 0.26151177 * t270;
    let t276 = fma(0.13075589, t267, t216);
    let t278 = t49 * 0.54627424;
    let t279 = t61 + t217;
    let t280 = t61 - t217;
    let t281 = t146 + t278;
    let t282 = t146 - t278;
    let t283 = t279 + t281;
    let t284 = t279 - t281;
    let t285 = t280 + t282;
    let t286 = t280 - t282;
    let t287 = t162 + t228;
    let t288 = t228 - t162;
    let t289 = fma(0.25, t283, 1.0);
    let t290 = max(t289, 0.0);
    let t291 = min(t290, 1.125);
    let t292 = t291 * t291;
    let t293 = t292 * t292;
    let t294 = fma(t29, t287, t23);
    let t295 = fma(t287, t294, t27);
    let t296 = t293 * t295;
    let t297 = fma(0.25, t285, 1.0);
    let t298 = max(t297, 0.0);
    let t299 = min(t298, 1.125);
    let t300 = t299 * t299;
    let t301 = t300 * t300;
    let t302 = fma(-t29, t288, t23);
    let t303 = fma(-t288, t302, t27);
    let t304 = t301 * t303;
    let t305 = fma(0.25, t284, 1.0);
    let t306 = max(t305, 0.0);
    let t307 = min(t306, 1.125);
    let t308 = t307 * t307;
    let t309 = t308 * t308;
    let t310 = fma(t29, t288, t23);
    let t311 = fma(t288, t310, t27);
    let t312 = t309 * t311;
    let t313 = fma(0.25, t286, 1.0);
    let t314 = max(t313, 0.0);
    let t315 = min(t314, 1.125);
    let t316 = t315 * t315;
    let t317 = t316 * t316;
    let t318 = fma(-t29, t287, t23);
    let t319 = fma(-t287, t318, t27);
    let t320 = t317 * t319;
    let t321 = t296 + t304;
    let t322 = t296 - t304;
    let t323 = t312 + t320;
    let t324 = t312 - t320;
    let t325 = t321 + t323;
    let t326 = t321 - t323;
    let t327 = t322 + t324;
    let t328 = t322 - t324;
    let t329 = fma(0.1350441, t325, t271);
    let t330 = fma(0.16539457, t326, t209);
    let t331 = fma(0.16539457, t327, t273);
    let t333 = t328 * 0.26151177;
    let t335 = fma(-t325, 0.1509839, t274);
    let t336 = t46 * 0.2820948;
    let t337 = t47 * 0.2820948;
    let t338 = t48 * 0.2820948;
    let t340 = t49 * 0.3641828;
    let t341 = t50 * 0.3641828;
    let t342 = t52 * 0.3641828;
    let t343 = t57 + t338;
    let t344 = t57 - t338;
    let t345 = t336 + t340;
    let t346 = t336 - t340;
    let t347 = t337 + t342;
    let t348 = t337 - t342;
    let t349 = t343 + t345;
    let t350 = t343 - t345;
    let t351 = t344 + t346;
    let t352 = t344 - t346;
    let t353 = t341 + t347;
    let t354 = t347 - t341;
    let t355 = t341 + t348;
    let t356 = t348 - t341;
    let t357 = t349 + t353;
    let t358 = t349 - t353;
    let t359 = t351 + t355;
    let t360 = t351 - t355;
    let t361 = t350 + t354;
    let t362 = t350 - t354;
    let t363 = t352 + t356;
    let t364 = t352 - t356;
    let t366 = d.x * 0.57735026;
    let t367 = d.y * 0.57735026;
    let t368 = d.z * 0.57735026;
    let t369 = t366 + t367;
    let t370 = t366 - t367;
    let t371 = t368 + t369;
    let t372 = t369 - t368;
    let t373 = t368 - t370;
    let t374 = t368 + t370;
    let t375 = fma(0.25, t357, 1.0);
    let t376 = max(t375, 0.0);
    let t377 = min(t376, 1.125);
    let t378 = t377 * t377;
    let t379 = t378 * t378;
    let t380 = fma(t29, t371, t23);
    let t381 = fma(t371, t380, t27);
    let t382 = t379 * t381;
    let t383 = fma(0.25, t359, 1.0);
    let t384 = max(t383, 0.0);
    let t385 = min(t384, 1.125);
    let t386 = t385 * t385;
    let t387 = t386 * t386;
    let t388 = fma(t29, t373, t23);
    let t389 = fma(t373, t388, t27);
    let t390 = t387 * t389;
    let t391 = fma(0.25, t361, 1.0);
    let t392 = max(t391, 0.0);
    let t393 = min(t392, 1.125);
    let t394 = t393 * t393;
    let t395 = t394 * t394;
    let t396 = fma(t29, t374, t23);
    let t397 = fma(t374, t396, t27);
    let t398 = t395 * t397;
    let t399 = fma(0.25, t363, 1.0);
    let t400 = max(t399, 0.0);
    let t401 = min(t400, 1.125);
    let t402 = t401 * t401;
    let t403 = t402 * t402;
    let t404 = fma(-t29, t372, t23);
    let t405 = fma(-t372, t404, t27);
    let t406 = t403 * t405;
    let t407 = fma(0.25, t358, 1.0);
    let t408 = max(t407, 0.0);
    let t409 = min(t408, 1.125);
    let t410 = t409 * t409;
    let t411 = t410 * t410;
    let t412 = fma(t29, t372, t23);
    let t413 = fma(t372, t412, t27);
    let t414 = t411 * t413;
    let t415 = fma(0.25, t360, 1.0);
    let t416 = max(t415, 0.0);
    let t417 = min(t416, 1.125);
    let t418 = t417 * t417;
    let t419 = t418 * t418;
    let t420 = fma(-t29, t374, t23);
    let t421 = fma(-t374, t420, t27);
    let t422 = t419 * t421;
    let t423 = fma(0.25, t362, 1.0);
    let t424 = max(t423, 0.0);
    let t425 = min(t424, 1.125);
    let t426 = t425 * t425;
    let t427 = t426 * t426;
    let t428 = fma(-t29, t373, t23);
    let t429 = fma(-t373, t428, t27);
    let t430 = t427 * t429;
    let t431 = fma(0.25, t364, 1.0);
    let t432 = max(t431, 0.0);
    let t433 = min(t432, 1.125);
    let t434 = t433 * t433;
    let t435 = t434 * t434;
    let t436 = fma(-t29, t371, t23);
    let t437 = fma(-t371, t436, t27);
    let t438 = t435 * t437;
    let t439 = t382 + t390;
    let t440 = t382 - t390;
    let t441 = t398 + t406;
    let t442 = t398 - t406;
    let t443 = t414 + t422;
    let t444 = t414 - t422;
    let t445 = t430 + t438;
    let t446 = t430 - t438;
    let t447 = t439 + t441;
    let t448 = t439 - t441;
    let t449 = t440 + t442;
    let t450 = t440 - t442;
    let t451 = t443 + t445;
    let t452 = t443 - t445;
    let t453 = t444 + t446;
    let t454 = t444 - t446;
    let t455 = t447 + t451;
    let t456 = t447 - t451;
    let t457 = t449 + t453;
    let t458 = t449 - t453;
    let t459 = t448 + t452;
    let t460 = t448 - t452;
    let t461 = t450 + t454;
    let t464 = fma(t455, 0.113943465, t329);
    let t465 = fma(t459, 0.113943465, t330);
    let t466 = fma(t456, 0.113943465, t272);
    let t467 = fma(t457, 0.113943465, t331);
    let t469 = fma(t461, 0.14710037, t333);
    let t470 = fma(t460, 0.14710037, t212);
    let t471 = fma(t458, 0.14710037, t275);
    return array<f32, 9>(
        t464, t465, t466, t467, t469, t470, t335, t471, t276,
    );
}

// The lobe in which a surface of this `roughness` (0..1; alpha of GGX is its square) mirrors light, cosine and
// shadowing included and its sum 1: the mean of P_l over it about its axis, for `transfer_lobe`. `cosine` is that
// between the normal and the direction to the viewer. Fitted to 0.01 of the mean of P_1 and to 0.05 of that of P_5,
// most at grazing angles.
// Source: GGX (Walter et al. 2007) with correlated shadowing (Heitz 2014) about the mean of its directions; `gaunt-lab
// fit` rewrites the coefficients.
// 50 multiplications, 56 additions.
fn sh3_gloss_lobe(roughness: f32, cosine: f32) -> array<f32, 3> {
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
    return array<f32, 3>(
        1.0, t60, t110,
    );
}

// The roughness in whose place light of this order has `roughness`: a smoother lobe, cut off after the order's bands,
// would be below 0 beside its peak by more than 3 % of that, and show dark rings around a sun. At least 1, 0.88, 0.72,
// 0.6 and 0.59 for orders 2 to 6.
// Source: `tests/tests/fitted.rs` holds it to the lobes.
// 0 multiplications, 2 additions.
fn sh3_gloss_told(roughness: f32) -> f32 {
    let t3 = max(roughness, 0.88);
    let t4 = min(t3, 1.0);
    return t4;
}

// How far the lobe of `gloss_lobe` leans: the sine between its axis and the normal, over that of the mirrored
// direction. 1 for a mirror; rough surfaces send light closer to their normal. Fitted to 0.013.
// Source: The mean of the directions of GGX's lobe (Walter et al. 2007); `gaunt-lab fit` rewrites the coefficients.
// 26 multiplications, 32 additions.
fn sh3_gloss_tilt(roughness: f32, cosine: f32) -> f32 {
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
fn sh3_gloss_energy(roughness: f32, cosine: f32) -> vec2<f32> {
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
fn sh3_horizon_radius(height: f32, square: f32) -> f32 {
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
// 58 multiplications, 164 additions.
fn sh3_exp_sampled(f: array<f32, 9>) -> array<f32, 9> {
    let t12 = f[0] * 0.2820948;
    let t14 = f[3] * 0.48860252;
    let t16 = fma(-f[6], 0.31539157, t12);
    let t18 = fma(f[8], 0.54627424, t16);
    let t19 = t14 + t18;
    let t20 = t18 - t14;
    let t21 = min(t19, 0.15);
    let t22 = exp(t21);
    let t23 = min(t20, 0.15);
    let t24 = exp(t23);
    let t25 = t22 + t24;
    let t26 = t22 - t24;
    let t28 = t25 * 0.16880512;
    let t30 = t26 * 0.29237905;
    let t32 = t25 * 0.18872987;
    let t34 = t25 * 0.32688972;
    let t35 = f[1] * 0.48860252;
    let t36 = fma(-f[8], 0.54627424, t16);
    let t37 = t35 + t36;
    let t38 = t36 - t35;
    let t39 = min(t37, 0.15);
    let t40 = exp(t39);
    let t41 = min(t38, 0.15);
    let t42 = exp(t41);
    let t43 = t40 + t42;
    let t44 = t40 - t42;
    let t45 = fma(0.16880512, t43, t28);
    let t46 = 0.29237905 * t44;
    let t47 = fma(0.18872987, t43, t32);
    let t48 = fma((-0.32688972), t43, t34);
    let t49 = f[2] * 0.48860252;
    let t51 = fma(f[6], 0.63078314, t12);
    let t52 = t49 + t51;
    let t53 = t51 - t49;
    let t54 = min(t52, 0.15);
    let t55 = exp(t54);
    let t56 = min(t53, 0.15);
    let t57 = exp(t56);
    let t58 = t55 + t57;
    let t59 = t55 - t57;
    let t60 = fma(0.16880512, t58, t45);
    let t61 = 0.29237905 * t59;
    let t63 = fma(t58, 0.37745973, -t47);
    let t65 = f[1] * 0.34549415;
    let t66 = f[2] * 0.34549415;
    let t67 = f[5] * 0.54627424;
    let t69 = fma(f[6], 0.15769579, t12);
    let t71 = fma(-f[8], 0.27313712, t69);
    let t72 = t65 + t71;
    let t73 = t71 - t65;
    let t74 = t66 + t67;
    let t75 = t66 - t67;
    let t76 = t72 + t74;
    let t77 = t72 - t74;
    let t78 = t73 + t75;
    let t79 = t73 - t75;
    let t80 = min(t76, 0.15);
    let t81 = exp(t80);
    let t82 = min(t78, 0.15);
    let t83 = exp(t82);
    let t84 = min(t77, 0.15);
    let t85 = exp(t84);
    let t86 = min(t79, 0.15);
    let t87 = exp(t86);
    let t88 = t81 + t83;
    let t89 = t81 - t83;
    let t90 = t85 + t87;
    let t91 = t85 - t87;
    let t92 = t88 + t90;
    let t93 = t88 - t90;
    let t94 = t89 + t91;
    let t95 = t89 - t91;
    let t97 = fma(t92, 0.1350441, t60);
    let t99 = fma(t94, 0.16539457, t46);
    let t100 = fma(t93, 0.16539457, t61);
    let t102 = t95 * 0.26151177;
    let t104 = fma(t92, 0.07549195, t63);
    let t106 = fma(-t92, 0.13075589, t48);
    let t107 = f[3] * 0.34549415;
    let t108 = f[7] * 0.54627424;
    let t109 = fma(f[8], 0.27313712, t69);
    let t110 = t107 + t109;
    let t111 = t109 - t107;
    let t112 = t66 + t108;
    let t113 = t66 - t108;
    let t114 = t110 + t112;
    let t115 = t110 - t112;
    let t116 = t111 + t113;
    let t117 = t111 - t113;
    let t118 = min(t114, 0.15);
    let t119 = exp(t118);
    let t120 = min(t116, 0.15);
    let t121 = exp(t120);
    let t122 = min(t115, 0.15);
    let t123 = exp(t122);
    let t124 = min(t117, 0.15);
    let t125 = exp(t124);
    let t126 = t119 + t121;
    let t127 = t119 - t121;
    let t128 = t123 + t125;
    let t129 = t123 - t125;
    let t130 = t126 + t128;
    let t131 = t126 - t128;
    let t132 = t127 + t129;
    let t133 = t127 - t129;
    let t134 = fma(0.1350441, t130, t97);
    let t135 = fma(0.16539457, t131, t100);
    let t136 = fma(0.16539457, t132, t30);
    let t137 = fma(0.07549195, t130, t104);
    let t138 = 0.26151177 * t133;
    let t139 = fma(0.13075589, t130, t106);
    let t141 = f[4] * 0.54627424;
    let t142 = t16 + t107;
    let t143 = t16 - t107;
    let t144 = t65 + t141;
    let t145 = t65 - t141;
    let t146 = t142 + t144;
    let t147 = t142 - t144;
    let t148 = t143 + t145;
    let t149 = t143 - t145;
    let t150 = min(t146, 0.15);
    let t151 = exp(t150);
    let t152 = min(t148, 0.15);
    let t153 = exp(t152);
    let t154 = min(t147, 0.15);
    let t155 = exp(t154);
    let t156 = min(t149, 0.15);
    let t157 = exp(t156);
    let t158 = t151 + t153;
    let t159 = t151 - t153;
    let t160 = t155 + t157;
    let t161 = t155 - t157;
    let t162 = t158 + t160;
    let t163 = t158 - t160;
    let t164 = t159 + t161;
    let t165 = t159 - t161;
    let t166 = fma(0.1350441, t162, t134);
    let t167 = fma(0.16539457, t163, t99);
    let t168 = fma(0.16539457, t164, t136);
    let t170 = t165 * 0.26151177;
    let t172 = fma(-t162, 0.1509839, t137);
    let t173 = f[1] * 0.2820948;
    let t174 = f[2] * 0.2820948;
    let t175 = f[3] * 0.2820948;
    let t177 = f[4] * 0.3641828;
    let t178 = f[5] * 0.3641828;
    let t179 = f[7] * 0.3641828;
    let t180 = t12 + t175;
    let t181 = t12 - t175;
    let t182 = t173 + t177;
    let t183 = t173 - t177;
    let t184 = t174 + t179;
    let t185 = t174 - t179;
    let t186 = t180 + t182;
    let t187 = t180 - t182;
    let t188 = t181 + t183;
    let t189 = t181 - t183;
    let t190 = t178 + t184;
    let t191 = t184 - t178;
    let t192 = t178 + t185;
    let t193 = t185 - t178;
    let t194 = t186 + t190;
    let t195 = t186 - t190;
    let t196 = t188 + t192;
    let t197 = t188 - t192;
    let t198 = t187 + t191;
    let t199 = t187 - t191;
    let t200 = t189 + t193;
    let t201 = t189 - t193;
    let t202 = min(t194, 0.15);
    let t203 = exp(t202);
    let t204 = min(t196, 0.15);
    let t205 = exp(t204);
    let t206 = min(t198, 0.15);
    let t207 = exp(t206);
    let t208 = min(t200, 0.15);
    let t209 = exp(t208);
    let t210 = min(t195, 0.15);
    let t211 = exp(t210);
    let t212 = min(t197, 0.15);
    let t213 = exp(t212);
    let t214 = min(t199, 0.15);
    let t215 = exp(t214);
    let t216 = min(t201, 0.15);
    let t217 = exp(t216);
    let t218 = t203 + t205;
    let t219 = t203 - t205;
    let t220 = t207 + t209;
    let t221 = t207 - t209;
    let t222 = t211 + t213;
    let t223 = t211 - t213;
    let t224 = t215 + t217;
    let t225 = t215 - t217;
    let t226 = t218 + t220;
    let t227 = t218 - t220;
    let t228 = t219 + t221;
    let t229 = t219 - t221;
    let t230 = t222 + t224;
    let t231 = t222 - t224;
    let t232 = t223 + t225;
    let t233 = t223 - t225;
    let t234 = t226 + t230;
    let t235 = t226 - t230;
    let t236 = t228 + t232;
    let t237 = t228 - t232;
    let t238 = t227 + t231;
    let t239 = t227 - t231;
    let t240 = t229 + t233;
    let t243 = fma(t234, 0.113943465, t166);
    let t244 = fma(t238, 0.113943465, t167);
    let t245 = fma(t235, 0.113943465, t135);
    let t246 = fma(t236, 0.113943465, t168);
    let t248 = fma(t240, 0.14710037, t170);
    let t249 = fma(t239, 0.14710037, t102);
    let t250 = fma(t237, 0.14710037, t138);
    return array<f32, 9>(
        t243, t244, t245, t246, t248, t249, t172, t250, t139,
    );
}

// As `exp_sampled`, on 6, 14, 38, 50 and 50 points for orders 2 to 6.
// Source: Ren et al. 2006, eq. 10, by quadrature (Lebedev 1976) and clamped from above.
// 32 multiplications, 84 additions.
fn sh3_exp_sampled_coarse(f: array<f32, 9>) -> array<f32, 9> {
    let t12 = f[0] * 0.2820948;
    let t14 = f[3] * 0.48860252;
    let t16 = fma(-f[6], 0.31539157, t12);
    let t18 = fma(f[8], 0.54627424, t16);
    let t19 = t14 + t18;
    let t20 = t18 - t14;
    let t21 = min(t19, 0.15);
    let t22 = exp(t21);
    let t23 = min(t20, 0.15);
    let t24 = exp(t23);
    let t25 = t22 + t24;
    let t26 = t22 - t24;
    let t28 = t25 * 0.23632719;
    let t30 = t26 * 0.4093307;
    let t32 = t25 * 0.26422182;
    let t34 = t25 * 0.45764562;
    let t35 = f[1] * 0.48860252;
    let t36 = fma(-f[8], 0.54627424, t16);
    let t37 = t35 + t36;
    let t38 = t36 - t35;
    let t39 = min(t37, 0.15);
    let t40 = exp(t39);
    let t41 = min(t38, 0.15);
    let t42 = exp(t41);
    let t43 = t40 + t42;
    let t44 = t40 - t42;
    let t45 = fma(0.23632719, t43, t28);
    let t46 = 0.4093307 * t44;
    let t47 = fma(0.26422182, t43, t32);
    let t48 = fma((-0.45764562), t43, t34);
    let t49 = f[2] * 0.48860252;
    let t51 = fma(f[6], 0.63078314, t12);
    let t52 = t49 + t51;
    let t53 = t51 - t49;
    let t54 = min(t52, 0.15);
    let t55 = exp(t54);
    let t56 = min(t53, 0.15);
    let t57 = exp(t56);
    let t58 = t55 + t57;
    let t59 = t55 - t57;
    let t60 = fma(0.23632719, t58, t45);
    let t61 = 0.4093307 * t59;
    let t63 = fma(t58, 0.52844363, -t47);
    let t64 = f[1] * 0.2820948;
    let t65 = f[2] * 0.2820948;
    let t66 = f[3] * 0.2820948;
    let t68 = f[4] * 0.3641828;
    let t69 = f[5] * 0.3641828;
    let t70 = f[7] * 0.3641828;
    let t71 = t12 + t66;
    let t72 = t12 - t66;
    let t73 = t64 + t68;
    let t74 = t64 - t68;
    let t75 = t65 + t70;
    let t76 = t65 - t70;
    let t77 = t71 + t73;
    let t78 = t71 - t73;
    let t79 = t72 + t74;
    let t80 = t72 - t74;
    let t81 = t69 + t75;
    let t82 = t75 - t69;
    let t83 = t69 + t76;
    let t84 = t76 - t69;
    let t85 = t77 + t81;
    let t86 = t77 - t81;
    let t87 = t79 + t83;
    let t88 = t79 - t83;
    let t89 = t78 + t82;
    let t90 = t78 - t82;
    let t91 = t80 + t84;
    let t92 = t80 - t84;
    let t93 = min(t85, 0.15);
    let t94 = exp(t93);
    let t95 = min(t87, 0.15);
    let t96 = exp(t95);
    let t97 = min(t89, 0.15);
    let t98 = exp(t97);
    let t99 = min(t91, 0.15);
    let t100 = exp(t99);
    let t101 = min(t86, 0.15);
    let t102 = exp(t101);
    let t103 = min(t88, 0.15);
    let t104 = exp(t103);
    let t105 = min(t90, 0.15);
    let t106 = exp(t105);
    let t107 = min(t92, 0.15);
    let t108 = exp(t107);
    let t109 = t94 + t96;
    let t110 = t94 - t96;
    let t111 = t98 + t100;
    let t112 = t98 - t100;
    let t113 = t102 + t104;
    let t114 = t102 - t104;
    let t115 = t106 + t108;
    let t116 = t106 - t108;
    let t117 = t109 + t111;
    let t118 = t109 - t111;
    let t119 = t110 + t112;
    let t120 = t110 - t112;
    let t121 = t113 + t115;
    let t122 = t113 - t115;
    let t123 = t114 + t116;
    let t124 = t114 - t116;
    let t125 = t117 + t121;
    let t126 = t117 - t121;
    let t127 = t119 + t123;
    let t128 = t119 - t123;
    let t129 = t118 + t122;
    let t130 = t118 - t122;
    let t131 = t120 + t124;
    let t134 = fma(t125, 0.26586807, t60);
    let t135 = fma(t129, 0.26586807, t46);
    let t136 = fma(t126, 0.26586807, t61);
    let t137 = fma(t127, 0.26586807, t30);
    let t139 = t131 * 0.3432342;
    let t140 = t130 * 0.3432342;
    let t141 = t128 * 0.3432342;
    return array<f32, 9>(
        t134, t135, t136, t137, t139, t140, t63, t141, t48,
    );
}

// As `exp_sampled`, on 26, 38, 86, 110 and 110 points for orders 2 to 6.
// Source: Ren et al. 2006, eq. 10, by quadrature (Lebedev 1976) and clamped from above.
// 87 multiplications, 248 additions.
fn sh3_exp_sampled_fine(f: array<f32, 9>) -> array<f32, 9> {
    let t12 = f[0] * 0.2820948;
    let t14 = f[3] * 0.48860252;
    let t16 = fma(-f[6], 0.31539157, t12);
    let t18 = fma(f[8], 0.54627424, t16);
    let t19 = t14 + t18;
    let t20 = t18 - t14;
    let t21 = min(t19, 0.15);
    let t22 = exp(t21);
    let t23 = min(t20, 0.15);
    let t24 = exp(t23);
    let t25 = t22 + t24;
    let t26 = t22 - t24;
    let t28 = t25 * 0.033761024;
    let t30 = t26 * 0.05847581;
    let t32 = t25 * 0.037745975;
    let t34 = t25 * 0.06537794;
    let t35 = f[1] * 0.48860252;
    let t36 = fma(-f[8], 0.54627424, t16);
    let t37 = t35 + t36;
    let t38 = t36 - t35;
    let t39 = min(t37, 0.15);
    let t40 = exp(t39);
    let t41 = min(t38, 0.15);
    let t42 = exp(t41);
    let t43 = t40 + t42;
    let t44 = t40 - t42;
    let t45 = fma(0.033761024, t43, t28);
    let t46 = 0.05847581 * t44;
    let t47 = fma(0.037745975, t43, t32);
    let t48 = fma((-0.06537794), t43, t34);
    let t49 = f[2] * 0.48860252;
    let t51 = fma(f[6], 0.63078314, t12);
    let t52 = t49 + t51;
    let t53 = t51 - t49;
    let t54 = min(t52, 0.15);
    let t55 = exp(t54);
    let t56 = min(t53, 0.15);
    let t57 = exp(t56);
    let t58 = t55 + t57;
    let t59 = t55 - t57;
    let t60 = fma(0.033761024, t58, t45);
    let t61 = 0.05847581 * t59;
    let t63 = fma(t58, 0.07549195, -t47);
    let t64 = f[1] * 0.2820948;
    let t65 = f[2] * 0.2820948;
    let t66 = f[3] * 0.2820948;
    let t68 = f[4] * 0.3641828;
    let t69 = f[5] * 0.3641828;
    let t70 = f[7] * 0.3641828;
    let t71 = t12 + t66;
    let t72 = t12 - t66;
    let t73 = t64 + t68;
    let t74 = t64 - t68;
    let t75 = t65 + t70;
    let t76 = t65 - t70;
    let t77 = t71 + t73;
    let t78 = t71 - t73;
    let t79 = t72 + t74;
    let t80 = t72 - t74;
    let t81 = t69 + t75;
    let t82 = t75 - t69;
    let t83 = t69 + t76;
    let t84 = t76 - t69;
    let t85 = t77 + t81;
    let t86 = t77 - t81;
    let t87 = t79 + t83;
    let t88 = t79 - t83;
    let t89 = t78 + t82;
    let t90 = t78 - t82;
    let t91 = t80 + t84;
    let t92 = t80 - t84;
    let t93 = min(t85, 0.15);
    let t94 = exp(t93);
    let t95 = min(t87, 0.15);
    let t96 = exp(t95);
    let t97 = min(t89, 0.15);
    let t98 = exp(t97);
    let t99 = min(t91, 0.15);
    let t100 = exp(t99);
    let t101 = min(t86, 0.15);
    let t102 = exp(t101);
    let t103 = min(t88, 0.15);
    let t104 = exp(t103);
    let t105 = min(t90, 0.15);
    let t106 = exp(t105);
    let t107 = min(t92, 0.15);
    let t108 = exp(t107);
    let t109 = t94 + t96;
    let t110 = t94 - t96;
    let t111 = t98 + t100;
    let t112 = t98 - t100;
    let t113 = t102 + t104;
    let t114 = t102 - t104;
    let t115 = t106 + t108;
    let t116 = t106 - t108;
    let t117 = t109 + t111;
    let t118 = t109 - t111;
    let t119 = t110 + t112;
    let t120 = t110 - t112;
    let t121 = t113 + t115;
    let t122 = t113 - t115;
    let t123 = t114 + t116;
    let t124 = t114 - t116;
    let t125 = t117 + t121;
    let t126 = t117 - t121;
    let t127 = t119 + t123;
    let t128 = t119 - t123;
    let t129 = t118 + t122;
    let t130 = t118 - t122;
    let t131 = t120 + t124;
    let t134 = fma(t125, 0.113943465, t60);
    let t135 = fma(t129, 0.113943465, t46);
    let t136 = fma(t126, 0.113943465, t61);
    let t137 = fma(t127, 0.113943465, t30);
    let t139 = t131 * 0.14710037;
    let t140 = t130 * 0.14710037;
    let t141 = t128 * 0.14710037;
    let t143 = f[1] * 0.4339151;
    let t145 = f[3] * 0.22461098;
    let t147 = f[4] * 0.44603103;
    let t149 = fma(-f[8], 0.31539157, t16);
    let t150 = t145 + t149;
    let t151 = t149 - t145;
    let t152 = t143 + t147;
    let t153 = t143 - t147;
    let t154 = t150 + t152;
    let t155 = t150 - t152;
    let t156 = t151 + t153;
    let t157 = t151 - t153;
    let t158 = min(t154, 0.15);
    let t159 = exp(t158);
    let t160 = min(t156, 0.15);
    let t161 = exp(t160);
    let t162 = min(t155, 0.15);
    let t163 = exp(t162);
    let t164 = min(t157, 0.15);
    let t165 = exp(t164);
    let t166 = t159 + t161;
    let t167 = t159 - t161;
    let t168 = t163 + t165;
    let t169 = t163 - t165;
    let t170 = t166 + t168;
    let t171 = t166 - t168;
    let t172 = t167 + t169;
    let t173 = t167 - t169;
    let t175 = fma(t170, 0.10128308, t134);
    let t177 = fma(t171, 0.15579252, t135);
    let t179 = fma(t172, 0.08064414, t137);
    let t181 = fma(t173, 0.1601426, t139);
    let t183 = fma(-t170, 0.113237925, t63);
    let t185 = fma(-t170, 0.113237925, t48);
    let t186 = f[2] * 0.4339151;
    let t188 = fma(f[6], 0.4308329, t12);
    let t189 = f[7] * 0.44603103;
    let t191 = fma(f[8], 0.11544132, t188);
    let t192 = t145 + t191;
    let t193 = t191 - t145;
    let t194 = t186 + t189;
    let t195 = t186 - t189;
    let t196 = t192 + t194;
    let t197 = t192 - t194;
    let t198 = t193 + t195;
    let t199 = t193 - t195;
    let t200 = min(t196, 0.15);
    let t201 = exp(t200);
    let t202 = min(t198, 0.15);
    let t203 = exp(t202);
    let t204 = min(t197, 0.15);
    let t205 = exp(t204);
    let t206 = min(t199, 0.15);
    let t207 = exp(t206);
    let t208 = t201 + t203;
    let t209 = t201 - t203;
    let t210 = t205 + t207;
    let t211 = t205 - t207;
    let t212 = t208 + t210;
    let t213 = t208 - t210;
    let t214 = t209 + t211;
    let t215 = t209 - t211;
    let t216 = fma(0.10128308, t212, t175);
    let t217 = fma(0.15579252, t213, t136);
    let t218 = fma(0.08064414, t214, t179);
    let t220 = fma(t212, 0.15468588, t183);
    let t221 = fma(0.1601426, t215, t141);
    let t223 = fma(t212, 0.041447956, t185);
    let t224 = f[1] * 0.22461098;
    let t225 = f[3] * 0.4339151;
    let t226 = fma(f[8], 0.31539157, t16);
    let t227 = t225 + t226;
    let t228 = t226 - t225;
    let t229 = t147 + t224;
    let t230 = t224 - t147;
    let t231 = t227 + t229;
    let t232 = t227 - t229;
    let t233 = t228 + t230;
    let t234 = t228 - t230;
    let t235 = min(t231, 0.15);
    let t236 = exp(t235);
    let t237 = min(t233, 0.15);
    let t238 = exp(t237);
    let t239 = min(t232, 0.15);
    let t240 = exp(t239);
    let t241 = min(t234, 0.15);
    let t242 = exp(t241);
    let t243 = t236 + t238;
    let t244 = t236 - t238;
    let t245 = t240 + t242;
    let t246 = t240 - t242;
    let t247 = t243 + t245;
    let t248 = t243 - t245;
    let t249 = t244 + t246;
    let t250 = t244 - t246;
    let t251 = fma(0.10128308, t247, t216);
    let t252 = fma(0.08064414, t248, t177);
    let t253 = fma(0.15579252, t249, t218);
    let t254 = fma(0.1601426, t250, t181);
    let t255 = fma((-0.113237925), t247, t220);
    let t256 = fma(0.113237925, t247, t223);
    let t257 = f[2] * 0.22461098;
    let t259 = fma(-f[6], 0.11544132, t12);
    let t261 = f[7] * 0.44603103;
    let t263 = fma(f[8], 0.4308329, t259);
    let t264 = t225 + t263;
    let t265 = t263 - t225;
    let t266 = t257 + t261;
    let t267 = t257 - t261;
    let t268 = t264 + t266;
    let t269 = t264 - t266;
    let t270 = t265 + t267;
    let t271 = t265 - t267;
    let t272 = min(t268, 0.15);
    let t273 = exp(t272);
    let t274 = min(t270, 0.15);
    let t275 = exp(t274);
    let t276 = min(t269, 0.15);
    let t277 = exp(t276);
    let t278 = min(t271, 0.15);
    let t279 = exp(t278);
    let t280 = t273 + t275;
    let t281 = t273 - t275;
    let t282 = t277 + t279;
    let t283 = t277 - t279;
    let t284 = t280 + t282;
    let t285 = t280 - t282;
    let t286 = t281 + t283;
    let t287 = t281 - t283;
    let t288 = fma(0.10128308, t284, t251);
    let t289 = fma(0.08064414, t285, t217);
    let t290 = fma(0.15579252, t286, t253);
    let t292 = fma(-t284, 0.041447956, t255);
    let t294 = fma(t287, 0.1601426, t221);
    let t295 = fma(0.15468588, t284, t256);
    let t296 = f[5] * 0.44603103;
    let t297 = fma(-f[8], 0.11544132, t188);
    let t298 = t224 + t297;
    let t299 = t297 - t224;
    let t300 = t186 + t296;
    let t301 = t186 - t296;
    let t302 = t298 + t300;
    let t303 = t298 - t300;
    let t304 = t299 + t301;
    let t305 = t299 - t301;
    let t306 = min(t302, 0.15);
    let t307 = exp(t306);
    let t308 = min(t304, 0.15);
    let t309 = exp(t308);
    let t310 = min(t303, 0.15);
    let t311 = exp(t310);
    let t312 = min(t305, 0.15);
    let t313 = exp(t312);
    let t314 = t307 + t309;
    let t315 = t307 - t309;
    let t316 = t311 + t313;
    let t317 = t311 - t313;
    let t318 = t314 + t316;
    let t319 = t314 - t316;
    let t320 = t315 + t317;
    let t321 = t315 - t317;
    let t322 = fma(0.10128308, t318, t288);
    let t323 = fma(0.08064414, t320, t252);
    let t324 = fma(0.15579252, t319, t289);
    let t325 = fma(0.1601426, t321, t140);
    let t326 = fma(0.15468588, t318, t292);
    let t327 = fma((-0.041447956), t318, t295);
    let t328 = f[5] * 0.44603103;
    let t329 = fma(-f[8], 0.4308329, t259);
    let t330 = t143 + t329;
    let t331 = t329 - t143;
    let t332 = t257 + t328;
    let t333 = t257 - t328;
    let t334 = t330 + t332;
    let t335 = t330 - t332;
    let t336 = t331 + t333;
    let t337 = t331 - t333;
    let t338 = min(t334, 0.15);
    let t339 = exp(t338);
    let t340 = min(t336, 0.15);
    let t341 = exp(t340);
    let t342 = min(t335, 0.15);
    let t343 = exp(t342);
    let t344 = min(t337, 0.15);
    let t345 = exp(t344);
    let t346 = t339 + t341;
    let t347 = t339 - t341;
    let t348 = t343 + t345;
    let t349 = t343 - t345;
    let t350 = t346 + t348;
    let t351 = t346 - t348;
    let t352 = t347 + t349;
    let t353 = t347 - t349;
    let t354 = fma(0.10128308, t350, t322);
    let t355 = fma(0.15579252, t352, t323);
    let t356 = fma(0.08064414, t351, t324);
    let t357 = fma(0.1601426, t353, t325);
    let t358 = fma((-0.041447956), t350, t326);
    let t359 = fma((-0.15468588), t350, t327);
    return array<f32, 9>(
        t354, t355, t356, t290, t254, t357, t358, t294, t359,
    );
}

// The factors a and b of the optimal linear exponential a*1 + b*f^ for a vector without DC, of norm |f^| <= 1/4.
// Source: Ren et al. 2006, eq. 23-24, fitted; `gaunt-lab fit` rewrites the coefficients and states their error.
// 6 multiplications, 6 additions.
fn sh3_optimal_linear(norm: f32) -> vec2<f32> {
    let t4 = fma(-norm, 0.0040266532, 0.039770607);
    let t6 = fma(norm, t4, 6.9618153e-7);
    let t8 = fma(norm, t6, 1.0);
    let t11 = fma(norm, 0.0023965482, 0.017483618);
    let t13 = fma(norm, t11, (-0.1567272));
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
fn sh3_optimal_linear_wide(norm: f32) -> vec2<f32> {
    let t2 = min(norm, 6.3091846);
    let t4 = t2 * 0.15849909;
    let t8 = fma(t4, 33.377457, (-126.07081));
    let t10 = fma(t4, t8, 190.14436);
    let t12 = fma(t4, t10, (-146.67497));
    let t14 = fma(t4, t12, 61.853867);
    let t16 = fma(t4, t14, (-14.442913));
    let t18 = fma(t4, t16, 2.942907);
    let t20 = fma(t4, t18, (-0.04584649));
    let t22 = fma(t4, t20, 1.0);
    let t25 = fma(t4, 142.37247, (-497.74405));
    let t27 = fma(t4, t25, 697.86316);
    let t29 = fma(t4, t27, (-500.62173));
    let t31 = fma(t4, t29, 193.86366);
    let t33 = fma(t4, t31, (-39.376488));
    let t35 = fma(t4, t33, 4.558848);
    let t37 = fma(t4, t35, (-1.1134727));
    let t38 = fma(t4, t37, 1.0);
    return vec2<f32>(
        t22, t38,
    );
}

// Zonal coefficients of the eigen logarithm of the visibility past a circular blocker about +Z whose angular radius
// is a whole number of degrees, 0..=179; beyond that as at 179. The rows of the table behind `cap_log_table`.
// Source: Ren et al. 2006, eq. 30-32, clipped at 0.02; `gaunt-lab fit` computes it.
fn sh3_cap_log_row(row: u32) -> array<f32, 3> {
    var z = array<f32, 3>();
    if (row < 90u) {
        if (row < 45u) {
            if (row < 22u) {
                if (row < 11u) {
                    if (row < 5u) {
                        if (row < 2u) {
                            if (row < 1u) {
                                z = array<f32, 3>(0.0, 0.0, 0.0);
                            } else {
                                z = array<f32, 3>(-0.0002700458, -0.00046764407, -0.00060360244);
                            }
                        } else {
                            if (row < 3u) {
                                z = array<f32, 3>(-0.0010812108, -0.0018712888, -0.0024138482);
                            } else {
                                if (row < 4u) {
                                    z = array<f32, 3>(-0.0024365752, -0.0042130733, -0.005429057);
                                } else {
                                    z = array<f32, 3>(-0.0043412647, -0.0074965684, -0.009646441);
                                }
                            }
                        }
                    } else {
                        if (row < 8u) {
                            if (row < 6u) {
                                z = array<f32, 3>(-0.006802439, -0.011726786, -0.015062126);
                            } else {
                                if (row < 7u) {
                                    z = array<f32, 3>(-0.009829277, -0.016910192, -0.021671178);
                                } else {
                                    z = array<f32, 3>(-0.013432954, -0.02305472, -0.029467637);
                                }
                            }
                        } else {
                            if (row < 9u) {
                                z = array<f32, 3>(-0.017626623, -0.030169792, -0.038444567);
                            } else {
                                if (row < 10u) {
                                    z = array<f32, 3>(-0.022425381, -0.038266346, -0.0485941);
                                } else {
                                    z = array<f32, 3>(-0.027846254, -0.04735685, -0.059907492);
                                }
                            }
                        }
                    }
                } else {
                    if (row < 16u) {
                        if (row < 13u) {
                            if (row < 12u) {
                                z = array<f32, 3>(-0.033908155, -0.057455357, -0.07237521);
                            } else {
                                z = array<f32, 3>(-0.040631853, -0.06857751, -0.08598697);
                            }
                        } else {
                            if (row < 14u) {
                                z = array<f32, 3>(-0.04803996, -0.08074062, -0.10073186);
                            } else {
                                if (row < 15u) {
                                    z = array<f32, 3>(-0.05615688, -0.09396367, -0.11659838);
                                } else {
                                    z = array<f32, 3>(-0.065008804, -0.10826738, -0.1335746);
                                }
                            }
                        }
                    } else {
                        if (row < 19u) {
                            if (row < 17u) {
                                z = array<f32, 3>(-0.07462367, -0.12367428, -0.1516482);
                            } else {
                                if (row < 18u) {
                                    z = array<f32, 3>(-0.085031144, -0.14020877, -0.17080665);
                                } else {
                                    z = array<f32, 3>(-0.09626265, -0.15789711, -0.19103722);
                                }
                            }
                        } else {
                            if (row < 20u) {
                                z = array<f32, 3>(-0.10835129, -0.17676766, -0.21232729);
                            } else {
                                if (row < 21u) {
                                    z = array<f32, 3>(-0.12133193, -0.19685078, -0.2346643);
                                } else {
                                    z = array<f32, 3>(-0.13524117, -0.21817903, -0.25803602);
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
                                z = array<f32, 3>(-0.15011732, -0.24078725, -0.28243062);
                            } else {
                                z = array<f32, 3>(-0.16600063, -0.26471272, -0.307837);
                            }
                        } else {
                            if (row < 25u) {
                                z = array<f32, 3>(-0.18293308, -0.28999516, -0.3342448);
                            } else {
                                if (row < 26u) {
                                    z = array<f32, 3>(-0.20095867, -0.31667703, -0.3616446);
                                } else {
                                    z = array<f32, 3>(-0.22012343, -0.34480357, -0.3900284);
                                }
                            }
                        }
                    } else {
                        if (row < 30u) {
                            if (row < 28u) {
                                z = array<f32, 3>(-0.24047554, -0.37442312, -0.4193895);
                            } else {
                                if (row < 29u) {
                                    z = array<f32, 3>(-0.26206547, -0.4055872, -0.44972295);
                                } else {
                                    z = array<f32, 3>(-0.28494623, -0.43835083, -0.4810259);
                                }
                            }
                        } else {
                            if (row < 31u) {
                                z = array<f32, 3>(-0.30917343, -0.4727728, -0.5132978);
                            } else {
                                if (row < 32u) {
                                    z = array<f32, 3>(-0.3348057, -0.508916, -0.5465407);
                                } else {
                                    z = array<f32, 3>(-0.36190486, -0.5468477, -0.5807597);
                                }
                            }
                        }
                    }
                } else {
                    if (row < 39u) {
                        if (row < 36u) {
                            if (row < 34u) {
                                z = array<f32, 3>(-0.3905363, -0.58664024, -0.6159635);
                            } else {
                                if (row < 35u) {
                                    z = array<f32, 3>(-0.42076942, -0.6283711, -0.6521649);
                                } else {
                                    z = array<f32, 3>(-0.45267805, -0.672124, -0.6893808);
                                }
                            }
                        } else {
                            if (row < 37u) {
                                z = array<f32, 3>(-0.48634103, -0.7179892, -0.72763383);
                            } else {
                                if (row < 38u) {
                                    z = array<f32, 3>(-0.52184284, -0.7660645, -0.7669521);
                                } else {
                                    z = array<f32, 3>(-0.5592743, -0.8164561, -0.80737066);
                                }
                            }
                        }
                    } else {
                        if (row < 42u) {
                            if (row < 40u) {
                                z = array<f32, 3>(-0.5987338, -0.86927974, -0.8489323);
                            } else {
                                if (row < 41u) {
                                    z = array<f32, 3>(-0.64032775, -0.92466235, -0.8916886);
                                } else {
                                    z = array<f32, 3>(-0.6841725, -0.9827432, -0.9357013);
                                }
                            }
                        } else {
                            if (row < 43u) {
                                z = array<f32, 3>(-0.73039544, -1.0436763, -0.98104405);
                            } else {
                                if (row < 44u) {
                                    z = array<f32, 3>(-0.7791369, -1.1076322, -1.0278043);
                                } else {
                                    z = array<f32, 3>(-0.8305525, -1.174802, -1.0760852);
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
                                z = array<f32, 3>(-0.88481575, -1.2453995, -1.1260093);
                            } else {
                                z = array<f32, 3>(-0.9421213, -1.3196667, -1.1777211);
                            }
                        } else {
                            if (row < 48u) {
                                z = array<f32, 3>(-1.0026892, -1.3978792, -1.2313921);
                            } else {
                                if (row < 49u) {
                                    z = array<f32, 3>(-1.0667702, -1.4803524, -1.2872258);
                                } else {
                                    z = array<f32, 3>(-1.134652, -1.5674514, -1.345465);
                                }
                            }
                        }
                    } else {
                        if (row < 53u) {
                            if (row < 51u) {
                                z = array<f32, 3>(-1.2066681, -1.6596018, -1.4064002);
                            } else {
                                if (row < 52u) {
                                    z = array<f32, 3>(-1.283209, -1.7573053, -1.4703821);
                                } else {
                                    z = array<f32, 3>(-1.3647366, -1.8611593, -1.5378367);
                                }
                            }
                        } else {
                            if (row < 54u) {
                                z = array<f32, 3>(-1.451804, -1.9718841, -1.6092867);
                            } else {
                                if (row < 55u) {
                                    z = array<f32, 3>(-1.5450846, -2.0903604, -1.6853805);
                                } else {
                                    z = array<f32, 3>(-1.6454084, -2.2176814, -1.7669334);
                                }
                            }
                        }
                    }
                } else {
                    if (row < 61u) {
                        if (row < 58u) {
                            if (row < 57u) {
                                z = array<f32, 3>(-1.75382, -2.35523, -1.8549877);
                            } else {
                                z = array<f32, 3>(-1.8716612, -2.5047915, -1.9509021);
                            }
                        } else {
                            if (row < 59u) {
                                z = array<f32, 3>(-2.0007017, -2.6687303, -2.0564897);
                            } else {
                                if (row < 60u) {
                                    z = array<f32, 3>(-2.1433468, -2.850273, -2.1742432);
                                } else {
                                    z = array<f32, 3>(-2.3029933, -3.0539925, -2.3077152);
                                }
                            }
                        }
                    } else {
                        if (row < 64u) {
                            if (row < 62u) {
                                z = array<f32, 3>(-2.4846773, -3.2866855, -2.4622157);
                            } else {
                                if (row < 63u) {
                                    z = array<f32, 3>(-2.6963515, -3.5591106, -2.6461902);
                                } else {
                                    z = array<f32, 3>(-2.9517329, -3.889853, -2.874291);
                                }
                            }
                        } else {
                            if (row < 65u) {
                                z = array<f32, 3>(-3.2777817, -4.315479, -3.1754644);
                            } else {
                                if (row < 66u) {
                                    z = array<f32, 3>(-3.6169963, -4.7584143, -3.4855533);
                                } else {
                                    z = array<f32, 3>(-3.6837327, -4.831534, -3.4925687);
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
                                z = array<f32, 3>(-3.7474785, -4.898952, -3.4930515);
                            } else {
                                z = array<f32, 3>(-3.80764, -4.9597497, -3.4863443);
                            }
                        } else {
                            if (row < 70u) {
                                z = array<f32, 3>(-3.8672, -5.0178647, -3.4756503);
                            } else {
                                if (row < 71u) {
                                    z = array<f32, 3>(-3.926245, -5.07331, -3.4610136);
                                } else {
                                    z = array<f32, 3>(-3.9848692, -5.1261067, -3.4424834);
                                }
                            }
                        }
                    } else {
                        if (row < 75u) {
                            if (row < 73u) {
                                z = array<f32, 3>(-4.043173, -5.1762824, -3.4201157);
                            } else {
                                if (row < 74u) {
                                    z = array<f32, 3>(-4.101263, -5.223872, -3.3939707);
                                } else {
                                    z = array<f32, 3>(-4.159252, -5.268918, -3.3641126);
                                }
                            }
                        } else {
                            if (row < 76u) {
                                z = array<f32, 3>(-4.217258, -5.311467, -3.330609);
                            } else {
                                if (row < 77u) {
                                    z = array<f32, 3>(-4.2754054, -5.3515735, -3.293532);
                                } else {
                                    z = array<f32, 3>(-4.3338237, -5.389297, -3.2529542);
                                }
                            }
                        }
                    }
                } else {
                    if (row < 84u) {
                        if (row < 81u) {
                            if (row < 79u) {
                                z = array<f32, 3>(-4.3926477, -5.424702, -3.2089515);
                            } else {
                                if (row < 80u) {
                                    z = array<f32, 3>(-4.452018, -5.4578605, -3.1616006);
                                } else {
                                    z = array<f32, 3>(-4.5120792, -5.4888477, -3.1109793);
                                }
                            }
                        } else {
                            if (row < 82u) {
                                z = array<f32, 3>(-4.5729837, -5.5177445, -3.0571654);
                            } else {
                                if (row < 83u) {
                                    z = array<f32, 3>(-4.6348867, -5.544636, -3.0002367);
                                } else {
                                    z = array<f32, 3>(-4.6979513, -5.5696125, -2.9402702);
                                }
                            }
                        }
                    } else {
                        if (row < 87u) {
                            if (row < 85u) {
                                z = array<f32, 3>(-4.762344, -5.5927687, -2.8773413);
                            } else {
                                if (row < 86u) {
                                    z = array<f32, 3>(-4.828238, -5.6142025, -2.8115225);
                                } else {
                                    z = array<f32, 3>(-4.895813, -5.634016, -2.7428849);
                                }
                            }
                        } else {
                            if (row < 88u) {
                                z = array<f32, 3>(-4.965254, -5.652315, -2.6714947);
                            } else {
                                if (row < 89u) {
                                    z = array<f32, 3>(-5.036752, -5.669208, -2.597415);
                                } else {
                                    z = array<f32, 3>(-5.1105065, -5.6848073, -2.520703);
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
                                z = array<f32, 3>(-5.1867228, -5.699227, -2.4414105);
                            } else {
                                z = array<f32, 3>(-5.2656145, -5.7125835, -2.3595824);
                            }
                        } else {
                            if (row < 93u) {
                                z = array<f32, 3>(-5.347404, -5.724996, -2.2752554);
                            } else {
                                if (row < 94u) {
                                    z = array<f32, 3>(-5.4323215, -5.736584, -2.1884575);
                                } else {
                                    z = array<f32, 3>(-5.5206075, -5.747469, -2.0992062);
                                }
                            }
                        }
                    } else {
                        if (row < 98u) {
                            if (row < 96u) {
                                z = array<f32, 3>(-5.612513, -5.7577715, -2.0075076);
                            } else {
                                if (row < 97u) {
                                    z = array<f32, 3>(-5.7082996, -5.767612, -1.9133539);
                                } else {
                                    z = array<f32, 3>(-5.808242, -5.77711, -1.8167228);
                                }
                            }
                        } else {
                            if (row < 99u) {
                                z = array<f32, 3>(-5.9126263, -5.7863817, -1.7175741);
                            } else {
                                if (row < 100u) {
                                    z = array<f32, 3>(-6.021753, -5.7955384, -1.615848);
                                } else {
                                    z = array<f32, 3>(-6.135936, -5.8046865, -1.5114619);
                                }
                            }
                        }
                    }
                } else {
                    if (row < 106u) {
                        if (row < 103u) {
                            if (row < 102u) {
                                z = array<f32, 3>(-6.2555046, -5.8139215, -1.4043072);
                            } else {
                                z = array<f32, 3>(-6.3808017, -5.8233275, -1.2942464);
                            }
                        } else {
                            if (row < 104u) {
                                z = array<f32, 3>(-6.5121846, -5.8329725, -1.181107);
                            } else {
                                if (row < 105u) {
                                    z = array<f32, 3>(-6.650022, -5.842901, -1.0646789);
                                } else {
                                    z = array<f32, 3>(-6.7946916, -5.85313, -0.9447074);
                                }
                            }
                        }
                    } else {
                        if (row < 109u) {
                            if (row < 107u) {
                                z = array<f32, 3>(-6.9465747, -5.863636, -0.820889);
                            } else {
                                if (row < 108u) {
                                    z = array<f32, 3>(-7.106048, -5.874348, -0.6928652);
                                } else {
                                    z = array<f32, 3>(-7.273472, -5.8851323, -0.5602179);
                                }
                            }
                        } else {
                            if (row < 110u) {
                                z = array<f32, 3>(-7.4491715, -5.8957725, -0.42246583);
                            } else {
                                if (row < 111u) {
                                    z = array<f32, 3>(-7.6334157, -5.9059553, -0.27906412);
                                } else {
                                    z = array<f32, 3>(-7.8263793, -5.915244, -0.12940902);
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
                                z = array<f32, 3>(-8.028103, -5.923057, 0.027149348);
                            } else {
                                z = array<f32, 3>(-8.238438, -5.9286456, 0.19128156);
                            }
                        } else {
                            if (row < 115u) {
                                z = array<f32, 3>(-8.456977, -5.931078, 0.36363697);
                            } else {
                                if (row < 116u) {
                                    z = array<f32, 3>(-8.682987, -5.929238, 0.5447797);
                                } else {
                                    z = array<f32, 3>(-8.915336, -5.921844, 0.7351004);
                                }
                            }
                        }
                    } else {
                        if (row < 120u) {
                            if (row < 118u) {
                                z = array<f32, 3>(-9.152441, -5.9075036, 0.93470484);
                            } else {
                                if (row < 119u) {
                                    z = array<f32, 3>(-9.392252, -5.8848076, 1.1432897);
                                } else {
                                    z = array<f32, 3>(-9.632299, -5.8524666, 1.3600256);
                                }
                            }
                        } else {
                            if (row < 121u) {
                                z = array<f32, 3>(-9.869817, -5.809478, 1.5834781);
                            } else {
                                if (row < 122u) {
                                    z = array<f32, 3>(-10.101952, -5.7552934, 1.811602);
                                } else {
                                    z = array<f32, 3>(-10.326025, -5.6899514, 2.0418334);
                                }
                            }
                        }
                    }
                } else {
                    if (row < 129u) {
                        if (row < 126u) {
                            if (row < 124u) {
                                z = array<f32, 3>(-10.53981, -5.614129, 2.2712803);
                            } else {
                                if (row < 125u) {
                                    z = array<f32, 3>(-10.741744, -5.529093, 2.4969826);
                                } else {
                                    z = array<f32, 3>(-10.931053, -5.4365573, 2.7161841);
                                }
                            }
                        } else {
                            if (row < 127u) {
                                z = array<f32, 3>(-11.10774, -5.3384867, 2.9265585);
                            } else {
                                if (row < 128u) {
                                    z = array<f32, 3>(-11.272472, -5.236885, 3.1263492);
                                } else {
                                    z = array<f32, 3>(-11.426408, -5.133621, 3.3144073);
                                }
                            }
                        }
                    } else {
                        if (row < 132u) {
                            if (row < 130u) {
                                z = array<f32, 3>(-11.571002, -5.030311, 3.4901516);
                            } else {
                                if (row < 131u) {
                                    z = array<f32, 3>(-11.707837, -4.9282618, 3.6534717);
                                } else {
                                    z = array<f32, 3>(-11.838489, -4.8284664, 3.8046148);
                                }
                            }
                        } else {
                            if (row < 133u) {
                                z = array<f32, 3>(-11.964445, -4.7316294, 3.9440715);
                            } else {
                                if (row < 134u) {
                                    z = array<f32, 3>(-12.087058, -4.6382127, 4.072481);
                                } else {
                                    z = array<f32, 3>(-12.207523, -4.5484834, 4.190557);
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
                                z = array<f32, 3>(-12.32689, -4.462562, 4.2990327);
                            } else {
                                z = array<f32, 3>(-12.446066, -4.380461, 4.3986278);
                            }
                        } else {
                            if (row < 138u) {
                                z = array<f32, 3>(-12.565844, -4.3021193, 4.490027);
                            } else {
                                if (row < 139u) {
                                    z = array<f32, 3>(-12.686916, -4.227426, 4.573867);
                                } else {
                                    z = array<f32, 3>(-12.809897, -4.1562395, 4.6507325);
                                }
                            }
                        }
                    } else {
                        if (row < 143u) {
                            if (row < 141u) {
                                z = array<f32, 3>(-12.935342, -4.0884027, 4.721158);
                            } else {
                                if (row < 142u) {
                                    z = array<f32, 3>(-13.063761, -4.0237503, 4.785627);
                                } else {
                                    z = array<f32, 3>(-13.195635, -3.962118, 4.8445773);
                                }
                            }
                        } else {
                            if (row < 144u) {
                                z = array<f32, 3>(-13.331424, -3.9033442, 4.898407);
                            } else {
                                if (row < 145u) {
                                    z = array<f32, 3>(-13.471581, -3.8472755, 4.947475);
                                } else {
                                    z = array<f32, 3>(-13.616561, -3.7937663, 4.992109);
                                }
                            }
                        }
                    }
                } else {
                    if (row < 151u) {
                        if (row < 148u) {
                            if (row < 147u) {
                                z = array<f32, 3>(-13.766825, -3.7426808, 5.0326076);
                            } else {
                                z = array<f32, 3>(-13.92285, -3.693893, 5.0692453);
                            }
                        } else {
                            if (row < 149u) {
                                z = array<f32, 3>(-14.085135, -3.6472862, 5.102274);
                            } else {
                                if (row < 150u) {
                                    z = array<f32, 3>(-14.254211, -3.6027534, 5.1319275);
                                } else {
                                    z = array<f32, 3>(-14.430641, -3.5601966, 5.1584234);
                                }
                            }
                        }
                    } else {
                        if (row < 154u) {
                            if (row < 152u) {
                                z = array<f32, 3>(-14.615034, -3.5195265, 5.1819644);
                            } else {
                                if (row < 153u) {
                                    z = array<f32, 3>(-14.808047, -3.4806612, 5.202742);
                                } else {
                                    z = array<f32, 3>(-15.010399, -3.4435265, 5.2209363);
                                }
                            }
                        } else {
                            if (row < 155u) {
                                z = array<f32, 3>(-15.222877, -3.4080555, 5.236719);
                            } else {
                                if (row < 156u) {
                                    z = array<f32, 3>(-15.446349, -3.3741872, 5.2502527);
                                } else {
                                    z = array<f32, 3>(-15.681776, -3.3418667, 5.2616935);
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
                                z = array<f32, 3>(-15.930232, -3.3110447, 5.2711916);
                            } else {
                                z = array<f32, 3>(-16.192919, -3.281677, 5.2788906);
                            }
                        } else {
                            if (row < 160u) {
                                z = array<f32, 3>(-16.471191, -3.2537239, 5.28493);
                            } else {
                                if (row < 161u) {
                                    z = array<f32, 3>(-16.766596, -3.2271504, 5.2894454);
                                } else {
                                    z = array<f32, 3>(-17.080893, -3.2019255, 5.2925677);
                                }
                            }
                        }
                    } else {
                        if (row < 165u) {
                            if (row < 163u) {
                                z = array<f32, 3>(-17.416113, -3.1780224, 5.294424);
                            } else {
                                if (row < 164u) {
                                    z = array<f32, 3>(-17.774626, -3.1554174, 5.2951393);
                                } else {
                                    z = array<f32, 3>(-18.1592, -3.1340907, 5.294835);
                                }
                            }
                        } else {
                            if (row < 166u) {
                                z = array<f32, 3>(-18.573133, -3.114025, 5.29363);
                            } else {
                                if (row < 167u) {
                                    z = array<f32, 3>(-19.020374, -3.0952075, 5.2916403);
                                } else {
                                    z = array<f32, 3>(-19.505728, -3.077627, 5.2889805);
                                }
                            }
                        }
                    }
                } else {
                    if (row < 174u) {
                        if (row < 171u) {
                            if (row < 169u) {
                                z = array<f32, 3>(-20.03513, -3.061276, 5.285763);
                            } else {
                                if (row < 170u) {
                                    z = array<f32, 3>(-20.616034, -3.0461497, 5.2820973);
                                } else {
                                    z = array<f32, 3>(-21.257998, -3.0322464, 5.2780933);
                                }
                            }
                        } else {
                            if (row < 172u) {
                                z = array<f32, 3>(-21.973572, -3.019567, 5.2738585);
                            } else {
                                if (row < 173u) {
                                    z = array<f32, 3>(-22.779705, -3.0081158, 5.2695003);
                                } else {
                                    z = array<f32, 3>(-23.700119, -2.9979, 5.2651267);
                                }
                            }
                        }
                    } else {
                        if (row < 177u) {
                            if (row < 175u) {
                                z = array<f32, 3>(-24.76949, -2.9889314, 5.260846);
                            } else {
                                if (row < 176u) {
                                    z = array<f32, 3>(-26.04151, -2.9812248, 5.2567697);
                                } else {
                                    z = array<f32, 3>(-27.60604, -2.9748008, 5.2530146);
                                }
                            }
                        } else {
                            if (row < 178u) {
                                z = array<f32, 3>(-29.631414, -2.969687, 5.249708);
                            } else {
                                if (row < 179u) {
                                    z = array<f32, 3>(-32.495354, -2.9659214, 5.246997);
                                } else {
                                    z = array<f32, 3>(-37.402702, -2.9635596, 5.2450676);
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
const sh3_ROOT_FOUR_PI: f32 = 3.5449078;

// The largest finite number in half precision: (2 - 1/1024) * 32768. What is beyond is brought there.
const sh3_HALF_MAX: f32 = 65504.0;

// f without DC and over 2^p, the norm of that, p, and the root of the DC factor.
struct sh3_Halved {
    rest: array<f32, 9>,
    norm: f32,
    halvings: u32,
    root: f32,
}

fn sh3_halved(f: array<f32, 9>) -> sh3_Halved {
    var result = sh3_Halved(f, 0.0, 0u, 1.0);
    result.rest[0] = 0.0;
    result.norm = sqrt(sh3_dot(result.rest, result.rest));
    var scale = 1.0;
    while (result.norm >= 0.25 && result.halvings < 132u) {
        result.norm *= 0.5;
        scale *= 0.5;
        result.halvings += 1u;
    }
    for (var i = 1u; i < 9u; i += 1u) {
        result.rest[i] *= scale;
    }
    result.root = exp(f[0] * scale / sh3_ROOT_FOUR_PI);
    return result;
}

fn sh3_squared(g: array<f32, 9>, times: u32) -> array<f32, 9> {
    var result = g;
    for (var i = 0u; i < times; i += 1u) {
        result = sh3_square(result);
    }
    return result;
}

// sum + weight * term.
fn sh3_plus(sum: array<f32, 9>, weight: f32, term: array<f32, 9>) -> array<f32, 9> {
    var result = sum;
    for (var i = 0u; i < 9u; i += 1u) {
        result[i] += weight * term[i];
    }
    return result;
}

// PS-p: the plain product series up to `degree` (equation 17).
fn sh3_exp_product_series(f: array<f32, 9>, degree: u32) -> array<f32, 9> {
    var sum = array<f32, 9>();
    sum[0] = sh3_ROOT_FOUR_PI;
    var term = sum;
    var factorial = 1.0;
    for (var k = 1u; k <= degree; k += 1u) {
        term = sh3_product(term, f);
        factorial /= f32(k);
        sum = sh3_plus(sum, factorial, term);
    }
    return sum;
}

// PS*-p: the product series up to `degree`, even and odd powers apart (equation 22), scaled and squared.
fn sh3_exp_ps_star(f: array<f32, 9>, degree: u32) -> array<f32, 9> {
    let parts = sh3_halved(f);
    let square = sh3_square(parts.rest);
    var power = array<f32, 9>();
    power[0] = sh3_ROOT_FOUR_PI;
    var even = power;
    var odd = array<f32, 9>();
    var factorial = 1.0;
    for (var k = 0u; k <= degree; k += 2u) {
        if (k > 0u) {
            power = sh3_product(power, square);
            factorial /= f32(k * (k - 1u));
            even = sh3_plus(even, factorial, power);
        }
        if (k < degree) {
            odd = sh3_plus(odd, factorial / f32(k + 1u), power);
        }
    }
    var sum = sh3_plus(even, 1.0, sh3_product(parts.rest, odd));
    for (var i = 0u; i < 9u; i += 1u) {
        sum[i] *= parts.root;
    }
    return sh3_squared(sum, parts.halvings);
}

// HYB: the optimal linear a 1 + b f, with a and b fitted as functions of the norm (equations 23 and 24), scaled
// and squared.
fn sh3_exp_hyb(f: array<f32, 9>) -> array<f32, 9> {
    let parts = sh3_halved(f);
    let factors = parts.root * sh3_optimal_linear(parts.norm);
    var sum = array<f32, 9>();
    sum[0] = factors.x * sh3_ROOT_FOUR_PI;
    return sh3_squared(sh3_plus(sum, factors.y, parts.rest), parts.halvings);
}

// OL: the optimal linear a 1 + b f for any norm, neither scaled nor squared.
fn sh3_exp_optimal_linear(f: array<f32, 9>) -> array<f32, 9> {
    var rest = f;
    rest[0] = 0.0;
    let factors = exp(f[0] / sh3_ROOT_FOUR_PI) * sh3_optimal_linear_wide(sqrt(sh3_dot(rest, rest)));
    var sum = array<f32, 9>();
    sum[0] = factors.x * sh3_ROOT_FOUR_PI;
    return sh3_plus(sum, factors.y, rest);
}

// Zonal coefficients of the eigen logarithm of the visibility past a circular blocker about +Z whose angular radius is
// `angle`, interpolated between whole degrees; beyond 179 degrees it stays as it is there.
//
// Interpolation errs by at most 0.11 up to 150 degrees and by 0.42 from there on.
// Source: Ren et al. 2006, eq. 30-32, tabulated.
fn sh3_cap_log_table(angle: f32) -> array<f32, 3> {
    let place = clamp(angle * 57.295779513, 0.0, 179.0);
    let row = min(u32(place), 178u);
    let share = place - f32(row);
    var z = array<f32, 3>();
    for (var k = 0u; k < 2u; k += 1u) {
        let weight = select(share, 1.0 - share, k == 0u);
        let numbers = sh3_cap_log_row(row + k);
        for (var l = 0u; l < 3u; l += 1u) {
            z[l] += weight * numbers[l];
        }
    }
    return z;
}

// `f` as half-precision floats, two in each word, the one of lower index in the lower half: in memory they lie as an
// array of 9 f16 does. An odd one at the end is followed by 0. What is beyond 65504 is brought there.
//
// Rounding errs by at most 2^-11 of a coefficient, and by 2^-25 below 2^-14.
fn sh3_pack_half(f: array<f32, 9>) -> array<u32, (9 + 1) / 2> {
    var words = array<u32, (9 + 1) / 2>();
    for (var i = 0u; i < 9u; i += 2u) {
        let second = select(0.0, f[min(i + 1u, 9u - 1u)], i + 1u < 9u);
        words[i >> 1u] = pack2x16float(clamp(vec2<f32>(f[i], second), vec2<f32>(-sh3_HALF_MAX), vec2<f32>(sh3_HALF_MAX)));
    }
    return words;
}

// The vector that `pack_half` has packed.
fn sh3_unpack_half(words: array<u32, (9 + 1) / 2>) -> array<f32, 9> {
    var f = array<f32, 9>();
    for (var i = 0u; i < 9u; i += 1u) {
        let pair = unpack2x16float(words[i >> 1u]);
        f[i] = select(pair.x, pair.y, (i & 1u) == 1u);
    }
    return f;
}
