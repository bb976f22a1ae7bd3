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
    let t1 = abs(v.z);
    let t2 = alpha * v.x;
    let t3 = alpha * v.y;
    let t4 = sqrt(t2 * t2 + t3 * t3 + t1 * t1);
    let t5 = t1 / t4;
    let t6 = t2 / t4;
    let t7 = t3 / t4;
    let t8 = t6 * t6 + t7 * t7;
    let t9 = 1.0 + abs(t5);
    let t10 = select(t9, t8 / t9, t5 < 0.0);
    let t11 = (1.0 - u.x) * t10;
    let t12 = sqrt(u.x * (t10 * t11 + t8));
    let t13 = select(1.0, 0.0, u.y < 0.125) + select(1.0, 0.0, u.y < 0.375);
    let t14 = t13 + select(1.0, 0.0, u.y < 0.625) + select(1.0, 0.0, u.y < 0.875);
    let b1 = t14 == 1.0;
    let b2 = t14 == 2.0;
    let b3 = t14 == 3.0;
    let b4 = b1 || b3;
    let t15 = u.y - t14 * 0.25;
    let t16 = t15 * t15;
    let t17 = -41.341675 + t16 * (81.59394 + t16 * -75.4534);
    let t18 = t15 * 6.2831855 + t15 * (-1.7484555e-07 + t16 * t17);
    let t19 = 64.93932 + t16 * (-85.44374 + t16 * 59.245964);
    let t20 = 1.0 + t16 * (-19.739208 + t16 * t19);
    let t21 = select(t20, t18, b4);
    let t22 = alpha * (t12 * select(t21, -t21, b1 || b2) + t6);
    let t23 = select(t18, t20, b4);
    let t24 = alpha * (t12 * select(t23, -t23, b2 || b3) + t7);
    let t25 = sqrt(t22 * t22 + t24 * t24 + t11 * t11);
    let t26 = t22 / t25;
    let t27 = t24 / t25;
    let t28 = t11 / t25;
    let t29 = v.x * t26 + v.y * t27 + t1 * t28;
    let t30 = 2.0 * t29;
    let t31 = t30 * t28 - t1;
    let t32 = t26 * t26 + t27 * t27;
    let t33 = abs(t28);
    let t34 = alpha * t33;
    let t35 = t32 + t34 * t34;
    let t36 = select(0.0, alpha * (t32 + t33 * t33) / t35, t35 > 0.0);
    let t37 = (t4 + t1) * 0.5;
    let t38 = 0.31830987 * (t36 * t36) / (4.0 * t37);
    let b5 = v.z > 8.6736174e-19 && t31 > 8.6736174e-19 && t38 > 0.0;
    let t39 = t30 * t26 - v.x;
    let t40 = t30 * t27 - v.y;
    let t41 = 1.0 - select(1.0, min(t29, 1.0), b5);
    let t42 = t41 * t41;
    let t43 = alpha * t39;
    let t44 = alpha * t40;
    let t45 = sqrt(t43 * t43 + t44 * t44 + t31 * t31) + t31;
    let t46 = t31 * t37 / (t37 * t31 + (t45 * 0.5 - t31) * t1);
    return direction_sample3(vec3f(select(0.0, t39, b5), select(0.0, t40, b5), select(1.0, t31, b5)), (F0 + (1.0 - F0) * (t42 * t42 * t41)) * select(0.0, t46, b5), select(0.0, t38, b5));
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
    let t1 = abs(v.z);
    let t2 = alpha_x * v.x;
    let t3 = alpha_y * v.y;
    let t4 = sqrt(t2 * t2 + t3 * t3 + t1 * t1);
    let t5 = t1 / t4;
    let t6 = t2 / t4;
    let t7 = t3 / t4;
    let t8 = t6 * t6 + t7 * t7;
    let t9 = 1.0 + abs(t5);
    let t10 = select(t9, t8 / t9, t5 < 0.0);
    let t11 = (1.0 - u.x) * t10;
    let t12 = sqrt(u.x * (t10 * t11 + t8));
    let t13 = select(1.0, 0.0, u.y < 0.125) + select(1.0, 0.0, u.y < 0.375);
    let t14 = t13 + select(1.0, 0.0, u.y < 0.625) + select(1.0, 0.0, u.y < 0.875);
    let b1 = t14 == 1.0;
    let b2 = t14 == 2.0;
    let b3 = t14 == 3.0;
    let b4 = b1 || b3;
    let t15 = u.y - t14 * 0.25;
    let t16 = t15 * t15;
    let t17 = -41.341675 + t16 * (81.59394 + t16 * -75.4534);
    let t18 = t15 * 6.2831855 + t15 * (-1.7484555e-07 + t16 * t17);
    let t19 = 64.93932 + t16 * (-85.44374 + t16 * 59.245964);
    let t20 = 1.0 + t16 * (-19.739208 + t16 * t19);
    let t21 = select(t20, t18, b4);
    let t22 = alpha_x * (t12 * select(t21, -t21, b1 || b2) + t6);
    let t23 = select(t18, t20, b4);
    let t24 = alpha_y * (t12 * select(t23, -t23, b2 || b3) + t7);
    let t25 = sqrt(t22 * t22 + t24 * t24 + t11 * t11);
    let t26 = t22 / t25;
    let t27 = t24 / t25;
    let t28 = t11 / t25;
    let t29 = v.x * t26 + v.y * t27 + t1 * t28;
    let t30 = 2.0 * t29;
    let t31 = t30 * t28 - t1;
    let t32 = t26 * t26;
    let t33 = t27 * t27;
    let t34 = alpha_y / alpha_x * t32 + alpha_x / alpha_y * t33;
    let t35 = alpha_x * alpha_y;
    let t36 = abs(t28);
    let t37 = t36 * t36;
    let t38 = t34 + t35 * t37;
    let t39 = select(0.0, (t32 + t33 + t37) / t38, t38 > 0.0);
    let t40 = (t4 + t1) * 0.5;
    let t41 = 0.31830987 * (t39 * t39 * t35) / (4.0 * t40);
    let b5 = v.z > 8.6736174e-19 && t31 > 8.6736174e-19 && t41 > 0.0;
    let t42 = t30 * t26 - v.x;
    let t43 = t30 * t27 - v.y;
    let t44 = 1.0 - select(1.0, min(t29, 1.0), b5);
    let t45 = t44 * t44;
    let t46 = alpha_x * t42;
    let t47 = alpha_y * t43;
    let t48 = sqrt(t46 * t46 + t47 * t47 + t31 * t31) + t31;
    let t49 = t31 * t40 / (t40 * t31 + (t48 * 0.5 - t31) * t1);
    return direction_sample3(vec3f(select(0.0, t42, b5), select(0.0, t43, b5), select(1.0, t31, b5)), (F0 + (1.0 - F0) * (t45 * t45 * t44)) * select(0.0, t49, b5), select(0.0, t41, b5));
}
