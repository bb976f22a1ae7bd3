// Written by lobe 0.1.0
// ggx smith_correlated schlick: the microfacet BRDF, isotropic and anisotropic.
// v, l: unit, in tangent space, n = (0,0,1), pointing away from the surface; 0 where one is below the horizon.
// u in [0,1)^2. A sample that fails has pdf = 0 and weight = 0.
// alpha in [1e-4,1], F0 in [0,1], linear. Error in float: 20 ULP of f_cos and pdf.

struct evaluation3 {
    f_cos: vec3f,
    pdf: f32,
}

struct direction_sample3 {
    l: vec3f,
    weight: vec3f,
    pdf: f32,
}

struct dfg_terms {
    scale: f32,
    bias: f32,
}

fn ggx_evaluate(v: vec3f, l: vec3f, alpha: f32, F0: vec3f) -> evaluation3 {
    let w1 = v + l;
    let t1 = w1.x * w1.x + w1.y * w1.y;
    let t2 = abs(w1.z);
    let t3 = t1 + t2 * t2;
    let t4 = 1.0 - min(sqrt(t3) * 0.5, 1.0);
    let t5 = t4 * t4;
    let b1 = v.z > 8.6736174e-19 && l.z > 8.6736174e-19;
    let t6 = alpha * t2;
    let t7 = t1 + t6 * t6;
    let t8 = select(0.0, alpha * t3 / t7, t7 > 0.0);
    let t9 = 0.31830987 * (t8 * t8) * 0.25;
    let t10 = alpha * v.x;
    let t11 = alpha * v.y;
    let t12 = sqrt(t10 * t10 + t11 * t11 + v.z * v.z) + v.z;
    let t13 = t12 * 0.5;
    let t14 = alpha * l.x;
    let t15 = alpha * l.y;
    let t16 = sqrt(t14 * t14 + t15 * t15 + l.z * l.z) + l.z;
    let t17 = t9 * l.z / (t13 * l.z + (t16 * 0.5 - l.z) * v.z);
    return evaluation3((F0 + (1.0 - F0) * (t5 * t5 * t4)) * select(0.0, t17, b1), select(0.0, t9 / t13, b1));
}

fn ggx_sample(v: vec3f, u: vec2f, alpha: f32, F0: vec3f) -> direction_sample3 {
    let t1 = alpha * v.x;
    let t2 = alpha * v.y;
    let t3 = t1 * t1 + t2 * t2;
    let t4 = abs(v.z);
    let t5 = sqrt(t3 + t4 * t4);
    let t6 = t5 + abs(t4);
    let t7 = (1.0 - u.x) * t6;
    let t8 = sqrt(u.x * (t6 * t7 + t3));
    let t9 = select(1.0, 0.0, u.y < 0.125) + select(1.0, 0.0, u.y < 0.375);
    let t10 = t9 + select(1.0, 0.0, u.y < 0.625) + select(1.0, 0.0, u.y < 0.875);
    let b1 = t10 == 1.0;
    let b2 = t10 == 2.0;
    let b3 = t10 == 3.0;
    let b4 = b1 || b3;
    let t11 = u.y - t10 * 0.25;
    let t12 = t11 * t11;
    let t13 = -41.341675 + t12 * (81.59394 + t12 * -75.4534);
    let t14 = t11 * 6.2831855 + t11 * (-1.7484555e-07 + t12 * t13);
    let t15 = 64.93932 + t12 * (-85.44374 + t12 * 59.245964);
    let t16 = 1.0 + t12 * (-19.739208 + t12 * t15);
    let t17 = select(t16, t14, b4);
    let t18 = alpha * (t8 * select(t17, -t17, b1 || b2) + t1);
    let t19 = select(t14, t16, b4);
    let t20 = alpha * (t8 * select(t19, -t19, b2 || b3) + t2);
    let t21 = v.x * t18 + v.y * t20 + t4 * t7;
    let t22 = t18 * t18 + t20 * t20;
    let t23 = 2.0 * t21 / max(t22 + t7 * t7, 1.1754944e-38);
    let t24 = t23 * t7 - t4;
    let t25 = abs(t7);
    let t26 = alpha * t25;
    let t27 = t22 + t26 * t26;
    let t28 = select(0.0, alpha * (t22 + t25 * t25) / t27, t27 > 0.0);
    let t29 = (t5 + t4) * 0.5;
    let t30 = 0.31830987 * (t28 * t28) / (4.0 * t29);
    let b5 = v.z > 8.6736174e-19 && t24 > 8.6736174e-19 && t30 > 0.0;
    let t31 = t23 * t18 - v.x;
    let t32 = t23 * t20 - v.y;
    let t33 = select(1.0, min(sqrt(t21 * t23 * 0.5), 1.0), b5);
    let t34 = 1.0 - t33;
    let t35 = t34 * t34;
    let t36 = alpha * t31;
    let t37 = alpha * t32;
    let t38 = sqrt(t36 * t36 + t37 * t37 + t24 * t24) + t24;
    let t39 = t24 * t29 / (t29 * t24 + (t38 * 0.5 - t24) * t4);
    return direction_sample3(vec3f(select(0.0, t31, b5), select(0.0, t32, b5), select(1.0, t24, b5)), (F0 + (1.0 - F0) * (t35 * t35 * t34)) * select(0.0, t39, b5), select(0.0, t30, b5));
}

// Split-sum terms of isotropic GGX with smith_correlated: the albedo is F0 scale + F90 bias.
// Domain: cos_v in [0.001,1], alpha in [0.0009,1]. Error: 1.1e-3, rms 5e-4.
fn ggx_dfg(cos_v: f32, alpha: f32) -> dfg_terms {
    let t1 = alpha * alpha;
    let t2 = (-80.92356 * alpha + 159.31013) * alpha - 68.58001;
    let t3 = (13.252991 * alpha + 47.883152) * alpha + 23.356142;
    let t4 = (t2 * alpha + 23.680496) * alpha * cos_v + (t3 * t1 + 3.272493);
    let t5 = t4 * cos_v + (3.1924329 * alpha - 0.30789798) * alpha;
    let t6 = sqrt(alpha);
    let t7 = ((3.574554 * t6 + 2.947536) * t6 + 1.1579635) * alpha;
    let t8 = (0.71944004 * alpha + 0.6703227) * t6 + 0.06690896;
    let t9 = (cos_v + t7) * cos_v + t8 * (alpha * t6);
    let t10 = (4.6752467 - alpha) * cos_v + 19.079456 * t1 + 0.16968752;
    let t11 = (24.166279 * alpha + 86.77667) * t1 + 11.586927;
    let t12 = (22.483315 * alpha + 10.312562) * alpha + 0.39994174;
    let t13 = ((t10 * cos_v + t11 * t1) * cos_v + t12 * t1) * cos_v;
    let t14 = t13 + 0.4846967 * (t1 * alpha);
    let t15 = 1.0 / (t14 * t9);
    let t16 = 1.0 - cos_v * t1 * (t5 + 0.1134351) * t9 * t15;
    let t17 = (-1.996815 * t6 + 2.612494) * alpha + 1.4740415;
    let t18 = (0.9968305 * cos_v + t17 * alpha) * cos_v + 4.242914 * t1;
    let t19 = t18 * cos_v + (0.2249494 * t6 + 0.43820956) * (t1 * t6);
    let t20 = 1.0 - t19 * t14 * t15;
    let t21 = t20 * t20;
    let t22 = t16 * (t21 * t21 * t20);
    return dfg_terms(t16 - t22, t22);
}

fn ggx_xy_evaluate(v: vec3f, l: vec3f, alpha_x: f32, alpha_y: f32, F0: vec3f) -> evaluation3 {
    let w1 = v + l;
    let t1 = w1.x * w1.x;
    let t2 = w1.y * w1.y;
    let t3 = abs(w1.z);
    let t4 = t3 * t3;
    let t5 = t1 + t2 + t4;
    let t6 = 1.0 - min(sqrt(t5) * 0.5, 1.0);
    let t7 = t6 * t6;
    let b1 = v.z > 8.6736174e-19 && l.z > 8.6736174e-19;
    let t8 = alpha_y / alpha_x * t1 + alpha_x / alpha_y * t2;
    let t9 = alpha_x * alpha_y;
    let t10 = t8 + t9 * t4;
    let t11 = select(0.0, t5 / t10, t10 > 0.0);
    let t12 = 0.31830987 * (t11 * t11 * t9) * 0.25;
    let t13 = alpha_x * v.x;
    let t14 = alpha_y * v.y;
    let t15 = sqrt(t13 * t13 + t14 * t14 + v.z * v.z) + v.z;
    let t16 = t15 * 0.5;
    let t17 = alpha_x * l.x;
    let t18 = alpha_y * l.y;
    let t19 = sqrt(t17 * t17 + t18 * t18 + l.z * l.z) + l.z;
    let t20 = t12 * l.z / (t16 * l.z + (t19 * 0.5 - l.z) * v.z);
    return evaluation3((F0 + (1.0 - F0) * (t7 * t7 * t6)) * select(0.0, t20, b1), select(0.0, t12 / t16, b1));
}

fn ggx_xy_sample(v: vec3f, u: vec2f, alpha_x: f32, alpha_y: f32, F0: vec3f) -> direction_sample3 {
    let t1 = alpha_x * v.x;
    let t2 = alpha_y * v.y;
    let t3 = t1 * t1 + t2 * t2;
    let t4 = abs(v.z);
    let t5 = sqrt(t3 + t4 * t4);
    let t6 = t5 + abs(t4);
    let t7 = (1.0 - u.x) * t6;
    let t8 = sqrt(u.x * (t6 * t7 + t3));
    let t9 = select(1.0, 0.0, u.y < 0.125) + select(1.0, 0.0, u.y < 0.375);
    let t10 = t9 + select(1.0, 0.0, u.y < 0.625) + select(1.0, 0.0, u.y < 0.875);
    let b1 = t10 == 1.0;
    let b2 = t10 == 2.0;
    let b3 = t10 == 3.0;
    let b4 = b1 || b3;
    let t11 = u.y - t10 * 0.25;
    let t12 = t11 * t11;
    let t13 = -41.341675 + t12 * (81.59394 + t12 * -75.4534);
    let t14 = t11 * 6.2831855 + t11 * (-1.7484555e-07 + t12 * t13);
    let t15 = 64.93932 + t12 * (-85.44374 + t12 * 59.245964);
    let t16 = 1.0 + t12 * (-19.739208 + t12 * t15);
    let t17 = select(t16, t14, b4);
    let t18 = alpha_x * (t8 * select(t17, -t17, b1 || b2) + t1);
    let t19 = select(t14, t16, b4);
    let t20 = alpha_y * (t8 * select(t19, -t19, b2 || b3) + t2);
    let t21 = v.x * t18 + v.y * t20 + t4 * t7;
    let t22 = t18 * t18;
    let t23 = t20 * t20;
    let t24 = t22 + t23;
    let t25 = 2.0 * t21 / max(t24 + t7 * t7, 1.1754944e-38);
    let t26 = t25 * t7 - t4;
    let t27 = alpha_y / alpha_x * t22 + alpha_x / alpha_y * t23;
    let t28 = alpha_x * alpha_y;
    let t29 = abs(t7);
    let t30 = t29 * t29;
    let t31 = t27 + t28 * t30;
    let t32 = select(0.0, (t24 + t30) / t31, t31 > 0.0);
    let t33 = (t5 + t4) * 0.5;
    let t34 = 0.31830987 * (t32 * t32 * t28) / (4.0 * t33);
    let b5 = v.z > 8.6736174e-19 && t26 > 8.6736174e-19 && t34 > 0.0;
    let t35 = t25 * t18 - v.x;
    let t36 = t25 * t20 - v.y;
    let t37 = select(1.0, min(sqrt(t21 * t25 * 0.5), 1.0), b5);
    let t38 = 1.0 - t37;
    let t39 = t38 * t38;
    let t40 = alpha_x * t35;
    let t41 = alpha_y * t36;
    let t42 = sqrt(t40 * t40 + t41 * t41 + t26 * t26) + t26;
    let t43 = t26 * t33 / (t33 * t26 + (t42 * 0.5 - t26) * t4);
    return direction_sample3(vec3f(select(0.0, t35, b5), select(0.0, t36, b5), select(1.0, t26, b5)), (F0 + (1.0 - F0) * (t39 * t39 * t38)) * select(0.0, t43, b5), select(0.0, t34, b5));
}
