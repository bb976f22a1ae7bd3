// Written by lobe 0.1.0
// ggx smith_correlated schlick: the microfacet BRDF, isotropic and anisotropic.
// v, l: unit, in tangent space, n = (0,0,1), pointing away from the surface; 0 where one is below the horizon.
// u in [0,1)^2. A sample that fails has pdf = 0 and weight = 0.
// alpha in [1e-4,1], F0 in [0,1], linear. Error in float: 20 ULP of f_cos and pdf.

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
    float t1 = alpha * v.x;
    float t2 = alpha * v.y;
    float t3 = t1 * t1 + t2 * t2;
    float t4 = abs(v.z);
    float t5 = sqrt(t3 + t4 * t4);
    float t6 = t5 + abs(t4);
    float t7 = (1.0 - u.x) * t6;
    float t8 = sqrt(u.x * (t6 * t7 + t3));
    float t9 = u.y < 0.125 ? 0.0 : 1.0;
    float t10 = u.y < 0.375 ? 0.0 : 1.0;
    float t11 = u.y < 0.625 ? 0.0 : 1.0;
    float t12 = u.y < 0.875 ? 0.0 : 1.0;
    float t13 = t9 + t10 + t11 + t12;
    bool b1 = t13 == 1.0;
    bool b2 = t13 == 2.0;
    bool b3 = t13 == 3.0;
    bool b4 = b1 || b3;
    float t14 = u.y - t13 * 0.25;
    float t15 = t14 * t14;
    float t16 = -41.341675 + t15 * (81.59394 + t15 * -75.4534);
    float t17 = t14 * 6.2831855 + t14 * (-1.7484555e-07 + t15 * t16);
    float t18 = 64.93932 + t15 * (-85.44374 + t15 * 59.245964);
    float t19 = 1.0 + t15 * (-19.739208 + t15 * t18);
    float t20 = b4 ? t17 : t19;
    float t21 = b1 || b2 ? -t20 : t20;
    float t22 = alpha * (t8 * t21 + t1);
    float t23 = b4 ? t19 : t17;
    float t24 = b2 || b3 ? -t23 : t23;
    float t25 = alpha * (t8 * t24 + t2);
    float t26 = v.x * t22 + v.y * t25 + t4 * t7;
    float t27 = t22 * t22 + t25 * t25;
    float t28 = 2.0 * t26 / max(t27 + t7 * t7, 1.1754944e-38);
    float t29 = t28 * t7 - t4;
    float t30 = abs(t7);
    float t31 = alpha * t30;
    float t32 = t27 + t31 * t31;
    float t33 = t32 > 0.0 ? alpha * (t27 + t30 * t30) / t32 : 0.0;
    float t34 = (t5 + t4) * 0.5;
    float t35 = 0.31830987 * (t33 * t33) / (4.0 * t34);
    bool b5 = v.z > 8.6736174e-19 && t29 > 8.6736174e-19 && t35 > 0.0;
    float t36 = t28 * t22 - v.x;
    float t37 = b5 ? t36 : 0.0;
    float t38 = t28 * t25 - v.y;
    float t39 = b5 ? t38 : 0.0;
    float t40 = b5 ? t29 : 1.0;
    float t41 = b5 ? min(sqrt(t26 * t28 * 0.5), 1.0) : 1.0;
    float t42 = 1.0 - t41;
    float t43 = t42 * t42;
    float t44 = alpha * t36;
    float t45 = alpha * t38;
    float t46 = sqrt(t44 * t44 + t45 * t45 + t29 * t29) + t29;
    float t47 = t29 * t34 / (t34 * t29 + (t46 * 0.5 - t29) * t4);
    float t48 = b5 ? t47 : 0.0;
    return direction_sample3(vec3(t37, t39, t40), (F0 + (1.0 - F0) * (t43 * t43 * t42)) * t48, b5 ? t35 : 0.0);
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
    float t1 = alpha_x * v.x;
    float t2 = alpha_y * v.y;
    float t3 = t1 * t1 + t2 * t2;
    float t4 = abs(v.z);
    float t5 = sqrt(t3 + t4 * t4);
    float t6 = t5 + abs(t4);
    float t7 = (1.0 - u.x) * t6;
    float t8 = sqrt(u.x * (t6 * t7 + t3));
    float t9 = u.y < 0.125 ? 0.0 : 1.0;
    float t10 = u.y < 0.375 ? 0.0 : 1.0;
    float t11 = u.y < 0.625 ? 0.0 : 1.0;
    float t12 = u.y < 0.875 ? 0.0 : 1.0;
    float t13 = t9 + t10 + t11 + t12;
    bool b1 = t13 == 1.0;
    bool b2 = t13 == 2.0;
    bool b3 = t13 == 3.0;
    bool b4 = b1 || b3;
    float t14 = u.y - t13 * 0.25;
    float t15 = t14 * t14;
    float t16 = -41.341675 + t15 * (81.59394 + t15 * -75.4534);
    float t17 = t14 * 6.2831855 + t14 * (-1.7484555e-07 + t15 * t16);
    float t18 = 64.93932 + t15 * (-85.44374 + t15 * 59.245964);
    float t19 = 1.0 + t15 * (-19.739208 + t15 * t18);
    float t20 = b4 ? t17 : t19;
    float t21 = b1 || b2 ? -t20 : t20;
    float t22 = alpha_x * (t8 * t21 + t1);
    float t23 = b4 ? t19 : t17;
    float t24 = b2 || b3 ? -t23 : t23;
    float t25 = alpha_y * (t8 * t24 + t2);
    float t26 = v.x * t22 + v.y * t25 + t4 * t7;
    float t27 = t22 * t22;
    float t28 = t25 * t25;
    float t29 = t27 + t28;
    float t30 = 2.0 * t26 / max(t29 + t7 * t7, 1.1754944e-38);
    float t31 = t30 * t7 - t4;
    float t32 = alpha_y / alpha_x * t27 + alpha_x / alpha_y * t28;
    float t33 = alpha_x * alpha_y;
    float t34 = abs(t7);
    float t35 = t34 * t34;
    float t36 = t32 + t33 * t35;
    float t37 = t36 > 0.0 ? (t29 + t35) / t36 : 0.0;
    float t38 = (t5 + t4) * 0.5;
    float t39 = 0.31830987 * (t37 * t37 * t33) / (4.0 * t38);
    bool b5 = v.z > 8.6736174e-19 && t31 > 8.6736174e-19 && t39 > 0.0;
    float t40 = t30 * t22 - v.x;
    float t41 = b5 ? t40 : 0.0;
    float t42 = t30 * t25 - v.y;
    float t43 = b5 ? t42 : 0.0;
    float t44 = b5 ? t31 : 1.0;
    float t45 = b5 ? min(sqrt(t26 * t30 * 0.5), 1.0) : 1.0;
    float t46 = 1.0 - t45;
    float t47 = t46 * t46;
    float t48 = alpha_x * t40;
    float t49 = alpha_y * t42;
    float t50 = sqrt(t48 * t48 + t49 * t49 + t31 * t31) + t31;
    float t51 = t31 * t38 / (t38 * t31 + (t50 * 0.5 - t31) * t4);
    float t52 = b5 ? t51 : 0.0;
    return direction_sample3(vec3(t41, t43, t44), (F0 + (1.0 - F0) * (t47 * t47 * t46)) * t52, b5 ? t39 : 0.0);
}
