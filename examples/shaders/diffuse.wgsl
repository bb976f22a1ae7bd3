// Written by lobe 0.1.0
// Diffuse models. albedo, roughness in [0,1].
// v, l: unit, in tangent space, n = (0,0,1), pointing away from the surface; 0 where one is below the horizon.
// u in [0,1)^2. A sample that fails has pdf = 0 and weight = 0.

struct evaluation3 {
    f_cos: vec3f,
    pdf: f32,
}

struct direction_sample3 {
    l: vec3f,
    weight: vec3f,
    pdf: f32,
}

fn lambert_evaluate(v: vec3f, l: vec3f, albedo: vec3f) -> evaluation3 {
    let t1 = select(0.0, l.z * 0.31830987, v.z > 8.6736174e-19 && l.z > 8.6736174e-19);
    return evaluation3(albedo * t1, t1);
}

fn lambert_sample(v: vec3f, u: vec2f, albedo: vec3f) -> direction_sample3 {
    let t1 = sqrt(1.0 - u.x);
    let b1 = v.z > 8.6736174e-19 && t1 > 8.6736174e-19;
    let t2 = sqrt(u.x);
    let t3 = select(1.0, 0.0, u.y < 0.125) + select(1.0, 0.0, u.y < 0.375);
    let t4 = t3 + select(1.0, 0.0, u.y < 0.625) + select(1.0, 0.0, u.y < 0.875);
    let b2 = t4 == 1.0;
    let b3 = t4 == 2.0;
    let b4 = t4 == 3.0;
    let b5 = b2 || b4;
    let t5 = u.y - t4 * 0.25;
    let t6 = t5 * t5;
    let t7 = t6 * (-41.341675 + t6 * (81.59394 + t6 * -75.4534));
    let t8 = t5 * 6.2831855 + t5 * (-1.7484555e-07 + t7);
    let t9 = t6 * (64.93932 + t6 * (-85.44374 + t6 * 59.245964));
    let t10 = 1.0 + t6 * (-19.739208 + t9);
    let t11 = select(t10, t8, b5);
    let t12 = select(0.0, t2 * select(t11, -t11, b2 || b3), b1);
    let t13 = select(t8, t10, b5);
    let t14 = select(0.0, t2 * select(t13, -t13, b3 || b4), b1);
    return direction_sample3(vec3f(t12, t14, select(1.0, t1, b1)), albedo * select(0.0, 1.0, b1), select(0.0, t1 * 0.31830987, b1));
}

fn eon_evaluate(v: vec3f, l: vec3f, albedo: vec3f, roughness: f32) -> evaluation3 {
    let b1 = v.z > 8.6736174e-19 && l.z > 8.6736174e-19;
    let t1 = 1.0 / (1.0 + 0.2877934 * roughness);
    let t2 = v.x * l.x + v.y * l.y;
    let b2 = t2 > 0.0;
    let t3 = max(max(v.z, l.z), 8.6736174e-19);
    let t4 = max(1.0 + roughness * t2 / select(1.0, t3, b2), 0.0);
    let t5 = l.z * 0.31830987;
    let t6 = roughness * t1;
    let w1 = albedo * albedo * ((t1 + t6 * 0.07248825) * t6 / 0.2153052);
    let t7 = v.x * v.x + v.y * v.y;
    let t8 = sqrt(t7);
    let t9 = 1.0 / (1.0 + t8);
    let t10 = 0.9041297 * v.z * t9 + t8 * (t8 - 0.6666667 * (1.0 + t8 * t8 * t9));
    let t11 = (t8 * atan2(v.z, t8) + v.z * t10) * 0.31830987;
    let t12 = sqrt(l.x * l.x + l.y * l.y);
    let t13 = 1.0 / (1.0 + t12);
    let t14 = t12 * (t12 - 0.6666667 * (1.0 + t12 * t12 * t13));
    let t15 = t12 * atan2(l.z, t12) + l.z * (0.9041297 * l.z * t13 + t14);
    let t16 = select(0.0, t11 * (t15 * 0.31830987) * t5, b1);
    let t17 = roughness * select(0.0, t2 / t12, b2 && t12 > 0.0);
    let t18 = roughness * 0.9 * t2 + t17 * (1.0 / t3 - 1.0);
    let t19 = roughness * t8 * (t7 / (1.0 + abs(v.z))) * 0.31830987;
    return evaluation3(albedo * select(0.0, t1 * t4 * t5, b1) + w1 / (1.0 - albedo * (t6 * 0.2153052)) * t16, select(0.0, t5 * ((1.0 + t18) / (1.0 + t19)), b1));
}

fn eon_sample(v: vec3f, u: vec2f, albedo: vec3f, roughness: f32) -> direction_sample3 {
    let t1 = v.x * v.x + v.y * v.y;
    let t2 = sqrt(t1);
    let t3 = abs(v.z);
    let t4 = t1 / (1.0 + t3);
    let t5 = roughness * t2 * t4 * 0.31830987;
    let t6 = 1.0 + t5;
    let t7 = t5 / t6;
    let b1 = u.x < t7;
    let t8 = select(t7, 0.0, b1);
    let t9 = select(1.0, t7, b1);
    let t10 = t9 - t8;
    let t11 = (u.x - t8) / t10;
    let b2 = t11 < t4;
    let t12 = (t9 - u.x) / t10;
    let t13 = sqrt(select(t3 * t12, t4 * t11, b2));
    let t14 = select(t4 + t3 * t11, t3 + t4 * t12, b2) / (1.0 + t13);
    let t15 = select(t13, t14, b2);
    let t16 = roughness * 0.9;
    let t17 = t16 * t2;
    let t18 = sqrt(t11);
    let t19 = select(1.0, 0.0, u.y < 0.125) + select(1.0, 0.0, u.y < 0.375);
    let t20 = t19 + select(1.0, 0.0, u.y < 0.625) + select(1.0, 0.0, u.y < 0.875);
    let b3 = t20 == 1.0;
    let b4 = t20 == 2.0;
    let b5 = t20 == 3.0;
    let b6 = b3 || b5;
    let t21 = u.y - t20 * 0.25;
    let t22 = t21 * t21;
    let t23 = -41.341675 + t22 * (81.59394 + t22 * -75.4534);
    let t24 = t21 * 6.2831855 + t21 * (-1.7484555e-07 + t22 * t23);
    let t25 = 64.93932 + t22 * (-85.44374 + t22 * 59.245964);
    let t26 = 1.0 + t22 * (-19.739208 + t22 * t25);
    let t27 = select(t26, t24, b6);
    let t28 = t18 * select(t27, -t27, b3 || b4);
    let t29 = 1.0 + t17 * t28;
    let t30 = sqrt(t29 * t29 + t17 * t17 * t12);
    let t31 = select(sqrt(2.0 * t12 / (t29 + t30)), t15, b1);
    let b7 = v.z > 8.6736174e-19 && t31 > 8.6736174e-19;
    let b8 = t1 > 1.1754944e-38;
    let t32 = select(1.0, v.x / t2, b8);
    let t33 = sqrt(select(t14, t13, b2) * (1.0 + t15));
    let t34 = (2.0 * t28 + t17 * (t28 * t28 + t12)) / (1.0 + t30);
    let t35 = select(t34, 2.0 * t33 * sqrt(u.y * (1.0 - u.y)), b1);
    let t36 = select(0.0, v.y / t2, b8);
    let t37 = select(t24, t26, b6);
    let t38 = select(t18 * select(t37, -t37, b4 || b5), t33 * (2.0 * u.y - 1.0), b1);
    let t39 = t32 * t35 - t36 * t38;
    let t40 = t36 * t35 + t32 * t38;
    let t41 = 1.0 / (1.0 + 0.2877934 * roughness);
    let t42 = v.x * t39 + v.y * t40;
    let b9 = t42 > 0.0;
    let t43 = max(max(v.z, t31), 8.6736174e-19);
    let t44 = max(1.0 + roughness * t42 / select(1.0, t43, b9), 0.0);
    let t45 = sqrt(t39 * t39 + t40 * t40);
    let t46 = roughness * select(0.0, t42 / t45, b9 && t45 > 0.0);
    let t47 = (1.0 + (t16 * t42 + t46 * (1.0 / t43 - 1.0))) / t6;
    let t48 = select(0.0, 1.0 / t47, b7);
    let t49 = roughness * t41;
    let w1 = albedo * albedo * ((t41 + t49 * 0.07248825) * t49 / 0.2153052);
    let t50 = 1.0 / (1.0 + t2);
    let t51 = t2 * (t2 - 0.6666667 * (1.0 + t2 * t2 * t50));
    let t52 = t2 * atan2(v.z, t2) + v.z * (0.9041297 * v.z * t50 + t51);
    let t53 = 1.0 / (1.0 + t45);
    let t54 = t45 * (t45 - 0.6666667 * (1.0 + t45 * t45 * t53));
    let t55 = t45 * atan2(t31, t45) + t31 * (0.9041297 * t31 * t53 + t54);
    let t56 = select(0.0, t52 * 0.31830987 * (t55 * 0.31830987) * t48, b7);
    let w2 = w1 / (1.0 - albedo * (t49 * 0.2153052)) * t56;
    return direction_sample3(vec3f(select(0.0, t39, b7), select(0.0, t40, b7), select(1.0, t31, b7)), albedo * select(0.0, t41 * t44 * t48, b7) + w2, select(0.0, t31 * 0.31830987 * t47, b7));
}

fn burley_evaluate(v: vec3f, l: vec3f, albedo: vec3f, roughness: f32) -> evaluation3 {
    let b1 = v.z > 8.6736174e-19 && l.z > 8.6736174e-19;
    let t1 = 0.5 + roughness * (1.0 + dot(v, l)) - 1.0;
    let t2 = 1.0 - l.z;
    let t3 = t2 * t2;
    let t4 = 1.0 - v.z;
    let t5 = t4 * t4;
    let t6 = (1.0 + t1 * (t3 * t3 * t2)) * (1.0 + t1 * (t5 * t5 * t4));
    let t7 = l.z * 0.31830987;
    return evaluation3(albedo * select(0.0, t6 * t7, b1), select(0.0, t7, b1));
}

fn burley_sample(v: vec3f, u: vec2f, albedo: vec3f, roughness: f32) -> direction_sample3 {
    let t1 = sqrt(1.0 - u.x);
    let b1 = v.z > 8.6736174e-19 && t1 > 8.6736174e-19;
    let t2 = sqrt(u.x);
    let t3 = select(1.0, 0.0, u.y < 0.125) + select(1.0, 0.0, u.y < 0.375);
    let t4 = t3 + select(1.0, 0.0, u.y < 0.625) + select(1.0, 0.0, u.y < 0.875);
    let b2 = t4 == 1.0;
    let b3 = t4 == 2.0;
    let b4 = t4 == 3.0;
    let b5 = b2 || b4;
    let t5 = u.y - t4 * 0.25;
    let t6 = t5 * t5;
    let t7 = t6 * (-41.341675 + t6 * (81.59394 + t6 * -75.4534));
    let t8 = t5 * 6.2831855 + t5 * (-1.7484555e-07 + t7);
    let t9 = t6 * (64.93932 + t6 * (-85.44374 + t6 * 59.245964));
    let t10 = 1.0 + t6 * (-19.739208 + t9);
    let t11 = select(t10, t8, b5);
    let t12 = t2 * select(t11, -t11, b2 || b3);
    let t13 = select(t8, t10, b5);
    let t14 = t2 * select(t13, -t13, b3 || b4);
    let t15 = roughness * (1.0 + (v.x * t12 + v.y * t14 + v.z * t1));
    let t16 = 0.5 + t15 - 1.0;
    let t17 = 1.0 - t1;
    let t18 = t17 * t17;
    let t19 = 1.0 - v.z;
    let t20 = t19 * t19;
    let t21 = (1.0 + t16 * (t18 * t18 * t17)) * (1.0 + t16 * (t20 * t20 * t19));
    return direction_sample3(vec3f(select(0.0, t12, b1), select(0.0, t14, b1), select(1.0, t1, b1)), albedo * select(0.0, t21 * select(0.0, 1.0, b1), b1), select(0.0, t1 * 0.31830987, b1));
}

fn burley_frostbite_evaluate(v: vec3f, l: vec3f, albedo: vec3f, roughness: f32) -> evaluation3 {
    let b1 = v.z > 8.6736174e-19 && l.z > 8.6736174e-19;
    let t1 = roughness * (0.5 + (1.0 + dot(v, l))) - 1.0;
    let t2 = 1.0 - l.z;
    let t3 = t2 * t2;
    let t4 = 1.0 - v.z;
    let t5 = t4 * t4;
    let t6 = (1.0 + t1 * (t3 * t3 * t2)) * (1.0 + t1 * (t5 * t5 * t4));
    let t7 = l.z * 0.31830987;
    let t8 = select(0.0, t6 * (1.0 + -0.33774835 * roughness) * t7, b1);
    return evaluation3(albedo * t8, select(0.0, t7, b1));
}

fn burley_frostbite_sample(v: vec3f, u: vec2f, albedo: vec3f, roughness: f32) -> direction_sample3 {
    let t1 = sqrt(1.0 - u.x);
    let b1 = v.z > 8.6736174e-19 && t1 > 8.6736174e-19;
    let t2 = sqrt(u.x);
    let t3 = select(1.0, 0.0, u.y < 0.125) + select(1.0, 0.0, u.y < 0.375);
    let t4 = t3 + select(1.0, 0.0, u.y < 0.625) + select(1.0, 0.0, u.y < 0.875);
    let b2 = t4 == 1.0;
    let b3 = t4 == 2.0;
    let b4 = t4 == 3.0;
    let b5 = b2 || b4;
    let t5 = u.y - t4 * 0.25;
    let t6 = t5 * t5;
    let t7 = t6 * (-41.341675 + t6 * (81.59394 + t6 * -75.4534));
    let t8 = t5 * 6.2831855 + t5 * (-1.7484555e-07 + t7);
    let t9 = t6 * (64.93932 + t6 * (-85.44374 + t6 * 59.245964));
    let t10 = 1.0 + t6 * (-19.739208 + t9);
    let t11 = select(t10, t8, b5);
    let t12 = t2 * select(t11, -t11, b2 || b3);
    let t13 = select(t8, t10, b5);
    let t14 = t2 * select(t13, -t13, b3 || b4);
    let t15 = 0.5 + (1.0 + (v.x * t12 + v.y * t14 + v.z * t1));
    let t16 = roughness * t15 - 1.0;
    let t17 = 1.0 - t1;
    let t18 = t17 * t17;
    let t19 = 1.0 - v.z;
    let t20 = t19 * t19;
    let t21 = (1.0 + t16 * (t18 * t18 * t17)) * (1.0 + t16 * (t20 * t20 * t19));
    let t22 = t21 * (1.0 + -0.33774835 * roughness) * select(0.0, 1.0, b1);
    return direction_sample3(vec3f(select(0.0, t12, b1), select(0.0, t14, b1), select(1.0, t1, b1)), albedo * select(0.0, t22, b1), select(0.0, t1 * 0.31830987, b1));
}
