// Written by lobe 0.1.0
// ggx smith_correlated schlick: the microfacet BRDF, isotropic and anisotropic.
// v, l: unit, in tangent space, n = (0,0,1), pointing away from the surface; 0 where one is below the horizon.
// u in [0,1)^2. A sample that fails has pdf = 0 and weight = 0.
// alpha in [1e-4,1], F0 in [0,1], linear. Error in float: 20 ULP of f_cos and pdf.
precision highp float;

struct evaluation3 {
    vec3 f_cos;
    float pdf;
};

struct direction_sample3 {
    vec3 l;
    vec3 weight;
    float pdf;
};

struct dfg_terms {
    float scale;
    float bias;
};

evaluation3 ggx_evaluate(vec3 v, vec3 l, float alpha, vec3 F0) {
    vec3 w1 = v + l;
    float t1 = w1.x * w1.x + w1.y * w1.y;
    float t2 = abs(w1.z);
    float t3 = t1 + t2 * t2;
    float t4 = 1.0 - min(sqrt(t3) * 0.5, 1.0);
    float t5 = t4 * t4;
    bool b1 = v.z > 8.6736174e-19 && l.z > 8.6736174e-19;
    float t6 = alpha * t2;
    float t7 = t1 + t6 * t6;
    float t8 = t7 > 0.0 ? alpha * t3 / t7 : 0.0;
    float t9 = 0.31830987 * (t8 * t8) * 0.25;
    float t10 = alpha * v.x;
    float t11 = alpha * v.y;
    float t12 = sqrt(t10 * t10 + t11 * t11 + v.z * v.z) + v.z;
    float t13 = t12 * 0.5;
    float t14 = alpha * l.x;
    float t15 = alpha * l.y;
    float t16 = sqrt(t14 * t14 + t15 * t15 + l.z * l.z) + l.z;
    float t17 = t9 * l.z / (t13 * l.z + (t16 * 0.5 - l.z) * v.z);
    float t18 = b1 ? t17 : 0.0;
    return evaluation3((F0 + (1.0 - F0) * (t5 * t5 * t4)) * t18, b1 ? t9 / t13 : 0.0);
}

direction_sample3 ggx_sample(vec3 v, vec2 u, float alpha, vec3 F0) {
    float t1 = abs(v.z);
    float t2 = alpha * v.x;
    float t3 = alpha * v.y;
    float t4 = sqrt(t2 * t2 + t3 * t3 + t1 * t1);
    float t5 = t1 / t4;
    float t6 = t2 / t4;
    float t7 = t3 / t4;
    float t8 = t6 * t6 + t7 * t7;
    float t9 = 1.0 + abs(t5);
    float t10 = t5 < 0.0 ? t8 / t9 : t9;
    float t11 = (1.0 - u.x) * t10;
    float t12 = sqrt(u.x * (t10 * t11 + t8));
    float t13 = u.y < 0.125 ? 0.0 : 1.0;
    float t14 = u.y < 0.375 ? 0.0 : 1.0;
    float t15 = u.y < 0.625 ? 0.0 : 1.0;
    float t16 = u.y < 0.875 ? 0.0 : 1.0;
    float t17 = t13 + t14 + t15 + t16;
    bool b1 = t17 == 1.0;
    bool b2 = t17 == 2.0;
    bool b3 = t17 == 3.0;
    bool b4 = b1 || b3;
    float t18 = u.y - t17 * 0.25;
    float t19 = t18 * t18;
    float t20 = -41.341675 + t19 * (81.59394 + t19 * -75.4534);
    float t21 = t18 * 6.2831855 + t18 * (-1.7484555e-07 + t19 * t20);
    float t22 = 64.93932 + t19 * (-85.44374 + t19 * 59.245964);
    float t23 = 1.0 + t19 * (-19.739208 + t19 * t22);
    float t24 = b4 ? t21 : t23;
    float t25 = b1 || b2 ? -t24 : t24;
    float t26 = alpha * (t12 * t25 + t6);
    float t27 = b4 ? t23 : t21;
    float t28 = b2 || b3 ? -t27 : t27;
    float t29 = alpha * (t12 * t28 + t7);
    float t30 = sqrt(t26 * t26 + t29 * t29 + t11 * t11);
    float t31 = t26 / t30;
    float t32 = t29 / t30;
    float t33 = t11 / t30;
    float t34 = v.x * t31 + v.y * t32 + t1 * t33;
    float t35 = 2.0 * t34;
    float t36 = t35 * t33 - t1;
    float t37 = t31 * t31 + t32 * t32;
    float t38 = abs(t33);
    float t39 = alpha * t38;
    float t40 = t37 + t39 * t39;
    float t41 = t40 > 0.0 ? alpha * (t37 + t38 * t38) / t40 : 0.0;
    float t42 = (t4 + t1) * 0.5;
    float t43 = 0.31830987 * (t41 * t41) / (4.0 * t42);
    bool b5 = v.z > 8.6736174e-19 && t36 > 8.6736174e-19 && t43 > 0.0;
    float t44 = t35 * t31 - v.x;
    float t45 = b5 ? t44 : 0.0;
    float t46 = t35 * t32 - v.y;
    float t47 = b5 ? t46 : 0.0;
    float t48 = b5 ? t36 : 1.0;
    float t49 = b5 ? min(t34, 1.0) : 1.0;
    float t50 = 1.0 - t49;
    float t51 = t50 * t50;
    float t52 = alpha * t44;
    float t53 = alpha * t46;
    float t54 = sqrt(t52 * t52 + t53 * t53 + t36 * t36) + t36;
    float t55 = t36 * t42 / (t42 * t36 + (t54 * 0.5 - t36) * t1);
    float t56 = b5 ? t55 : 0.0;
    return direction_sample3(vec3(t45, t47, t48), (F0 + (1.0 - F0) * (t51 * t51 * t50)) * t56, b5 ? t43 : 0.0);
}

// Split-sum terms of isotropic GGX with smith_correlated: the albedo is F0 scale + F90 bias.
// Domain: cos_v in [0.001,1], alpha in [0.0009,1]. Error: 1.1e-3, rms 5e-4.
dfg_terms ggx_dfg(float cos_v, float alpha) {
    float t1 = alpha * alpha;
    float t2 = (-80.92356 * alpha + 159.31013) * alpha - 68.58001;
    float t3 = (13.252991 * alpha + 47.883152) * alpha + 23.356142;
    float t4 = (t2 * alpha + 23.680496) * alpha * cos_v + (t3 * t1 + 3.272493);
    float t5 = t4 * cos_v + (3.1924329 * alpha - 0.30789798) * alpha;
    float t6 = sqrt(alpha);
    float t7 = ((3.574554 * t6 + 2.947536) * t6 + 1.1579635) * alpha;
    float t8 = (0.71944004 * alpha + 0.6703227) * t6 + 0.06690896;
    float t9 = (cos_v + t7) * cos_v + t8 * (alpha * t6);
    float t10 = (4.6752467 - alpha) * cos_v + 19.079456 * t1 + 0.16968752;
    float t11 = (24.166279 * alpha + 86.77667) * t1 + 11.586927;
    float t12 = (22.483315 * alpha + 10.312562) * alpha + 0.39994174;
    float t13 = ((t10 * cos_v + t11 * t1) * cos_v + t12 * t1) * cos_v;
    float t14 = t13 + 0.4846967 * (t1 * alpha);
    float t15 = 1.0 / (t14 * t9);
    float t16 = 1.0 - cos_v * t1 * (t5 + 0.1134351) * t9 * t15;
    float t17 = (-1.996815 * t6 + 2.612494) * alpha + 1.4740415;
    float t18 = (0.9968305 * cos_v + t17 * alpha) * cos_v + 4.242914 * t1;
    float t19 = t18 * cos_v + (0.2249494 * t6 + 0.43820956) * (t1 * t6);
    float t20 = 1.0 - t19 * t14 * t15;
    float t21 = t20 * t20;
    float t22 = t16 * (t21 * t21 * t20);
    return dfg_terms(t16 - t22, t22);
}

evaluation3 ggx_xy_evaluate(vec3 v, vec3 l, float alpha_x, float alpha_y, vec3 F0) {
    vec3 w1 = v + l;
    float t1 = w1.x * w1.x;
    float t2 = w1.y * w1.y;
    float t3 = abs(w1.z);
    float t4 = t3 * t3;
    float t5 = t1 + t2 + t4;
    float t6 = 1.0 - min(sqrt(t5) * 0.5, 1.0);
    float t7 = t6 * t6;
    bool b1 = v.z > 8.6736174e-19 && l.z > 8.6736174e-19;
    float t8 = alpha_y / alpha_x * t1 + alpha_x / alpha_y * t2;
    float t9 = alpha_x * alpha_y;
    float t10 = t8 + t9 * t4;
    float t11 = t10 > 0.0 ? t5 / t10 : 0.0;
    float t12 = 0.31830987 * (t11 * t11 * t9) * 0.25;
    float t13 = alpha_x * v.x;
    float t14 = alpha_y * v.y;
    float t15 = sqrt(t13 * t13 + t14 * t14 + v.z * v.z) + v.z;
    float t16 = t15 * 0.5;
    float t17 = alpha_x * l.x;
    float t18 = alpha_y * l.y;
    float t19 = sqrt(t17 * t17 + t18 * t18 + l.z * l.z) + l.z;
    float t20 = t12 * l.z / (t16 * l.z + (t19 * 0.5 - l.z) * v.z);
    float t21 = b1 ? t20 : 0.0;
    return evaluation3((F0 + (1.0 - F0) * (t7 * t7 * t6)) * t21, b1 ? t12 / t16 : 0.0);
}

direction_sample3 ggx_xy_sample(vec3 v, vec2 u, float alpha_x, float alpha_y, vec3 F0) {
    float t1 = abs(v.z);
    float t2 = alpha_x * v.x;
    float t3 = alpha_y * v.y;
    float t4 = sqrt(t2 * t2 + t3 * t3 + t1 * t1);
    float t5 = t1 / t4;
    float t6 = t2 / t4;
    float t7 = t3 / t4;
    float t8 = t6 * t6 + t7 * t7;
    float t9 = 1.0 + abs(t5);
    float t10 = t5 < 0.0 ? t8 / t9 : t9;
    float t11 = (1.0 - u.x) * t10;
    float t12 = sqrt(u.x * (t10 * t11 + t8));
    float t13 = u.y < 0.125 ? 0.0 : 1.0;
    float t14 = u.y < 0.375 ? 0.0 : 1.0;
    float t15 = u.y < 0.625 ? 0.0 : 1.0;
    float t16 = u.y < 0.875 ? 0.0 : 1.0;
    float t17 = t13 + t14 + t15 + t16;
    bool b1 = t17 == 1.0;
    bool b2 = t17 == 2.0;
    bool b3 = t17 == 3.0;
    bool b4 = b1 || b3;
    float t18 = u.y - t17 * 0.25;
    float t19 = t18 * t18;
    float t20 = -41.341675 + t19 * (81.59394 + t19 * -75.4534);
    float t21 = t18 * 6.2831855 + t18 * (-1.7484555e-07 + t19 * t20);
    float t22 = 64.93932 + t19 * (-85.44374 + t19 * 59.245964);
    float t23 = 1.0 + t19 * (-19.739208 + t19 * t22);
    float t24 = b4 ? t21 : t23;
    float t25 = b1 || b2 ? -t24 : t24;
    float t26 = alpha_x * (t12 * t25 + t6);
    float t27 = b4 ? t23 : t21;
    float t28 = b2 || b3 ? -t27 : t27;
    float t29 = alpha_y * (t12 * t28 + t7);
    float t30 = sqrt(t26 * t26 + t29 * t29 + t11 * t11);
    float t31 = t26 / t30;
    float t32 = t29 / t30;
    float t33 = t11 / t30;
    float t34 = v.x * t31 + v.y * t32 + t1 * t33;
    float t35 = 2.0 * t34;
    float t36 = t35 * t33 - t1;
    float t37 = t31 * t31;
    float t38 = t32 * t32;
    float t39 = alpha_y / alpha_x * t37 + alpha_x / alpha_y * t38;
    float t40 = alpha_x * alpha_y;
    float t41 = abs(t33);
    float t42 = t41 * t41;
    float t43 = t39 + t40 * t42;
    float t44 = t43 > 0.0 ? (t37 + t38 + t42) / t43 : 0.0;
    float t45 = (t4 + t1) * 0.5;
    float t46 = 0.31830987 * (t44 * t44 * t40) / (4.0 * t45);
    bool b5 = v.z > 8.6736174e-19 && t36 > 8.6736174e-19 && t46 > 0.0;
    float t47 = t35 * t31 - v.x;
    float t48 = b5 ? t47 : 0.0;
    float t49 = t35 * t32 - v.y;
    float t50 = b5 ? t49 : 0.0;
    float t51 = b5 ? t36 : 1.0;
    float t52 = b5 ? min(t34, 1.0) : 1.0;
    float t53 = 1.0 - t52;
    float t54 = t53 * t53;
    float t55 = alpha_x * t47;
    float t56 = alpha_y * t49;
    float t57 = sqrt(t55 * t55 + t56 * t56 + t36 * t36) + t36;
    float t58 = t36 * t45 / (t45 * t36 + (t57 * 0.5 - t36) * t1);
    float t59 = b5 ? t58 : 0.0;
    return direction_sample3(vec3(t48, t50, t51), (F0 + (1.0 - F0) * (t54 * t54 * t53)) * t59, b5 ? t46 : 0.0);
}
