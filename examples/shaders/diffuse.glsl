// Written by lobe 0.1.0
// Diffuse models. albedo, roughness in [0,1].
// v, l: unit, in tangent space, n = (0,0,1), pointing away from the surface; 0 where one is below the horizon.
// u in [0,1)^2. A sample that fails has pdf = 0 and weight = 0.

struct evaluation3 {
    vec3 f_cos;
    float pdf;
};

struct direction_sample3 {
    vec3 l;
    vec3 weight;
    float pdf;
};

evaluation3 lambert_evaluate(vec3 v, vec3 l, vec3 albedo) {
    float t1 = v.z > 8.6736174e-19 && l.z > 8.6736174e-19 ? l.z * 0.31830987 : 0.0;
    return evaluation3(albedo * t1, t1);
}

direction_sample3 lambert_sample(vec3 v, vec2 u, vec3 albedo) {
    float t1 = sqrt(1.0 - u.x);
    bool b1 = v.z > 8.6736174e-19 && t1 > 8.6736174e-19;
    float t2 = sqrt(u.x);
    float t3 = u.y < 0.125 ? 0.0 : 1.0;
    float t4 = u.y < 0.375 ? 0.0 : 1.0;
    float t5 = u.y < 0.625 ? 0.0 : 1.0;
    float t6 = u.y < 0.875 ? 0.0 : 1.0;
    float t7 = t3 + t4 + t5 + t6;
    bool b2 = t7 == 1.0;
    bool b3 = t7 == 2.0;
    bool b4 = t7 == 3.0;
    bool b5 = b2 || b4;
    float t8 = u.y - t7 * 0.25;
    float t9 = t8 * t8;
    float t10 = t9 * (-41.341675 + t9 * (81.59394 + t9 * -75.4534));
    float t11 = t8 * 6.2831855 + t8 * (-1.7484555e-07 + t10);
    float t12 = t9 * (64.93932 + t9 * (-85.44374 + t9 * 59.245964));
    float t13 = 1.0 + t9 * (-19.739208 + t12);
    float t14 = b5 ? t11 : t13;
    float t15 = b2 || b3 ? -t14 : t14;
    float t16 = b1 ? t2 * t15 : 0.0;
    float t17 = b5 ? t13 : t11;
    float t18 = b3 || b4 ? -t17 : t17;
    float t19 = b1 ? t2 * t18 : 0.0;
    float t20 = b1 ? t1 : 1.0;
    float t21 = b1 ? 1.0 : 0.0;
    return direction_sample3(vec3(t16, t19, t20), albedo * t21, b1 ? t1 * 0.31830987 : 0.0);
}

evaluation3 eon_evaluate(vec3 v, vec3 l, vec3 albedo, float roughness) {
    bool b1 = v.z > 8.6736174e-19 && l.z > 8.6736174e-19;
    float t1 = 1.0 / (1.0 + 0.2877934 * roughness);
    float t2 = v.x * l.x + v.y * l.y;
    bool b2 = t2 > 0.0;
    float t3 = max(max(v.z, l.z), 8.6736174e-19);
    float t4 = b2 ? t3 : 1.0;
    float t5 = l.z * 0.31830987;
    float t6 = t1 * max(1.0 + roughness * t2 / t4, 0.0) * t5;
    float t7 = b1 ? t6 : 0.0;
    float t8 = roughness * t1;
    vec3 w1 = albedo * albedo * ((t1 + t8 * 0.07248825) * t8 / 0.2153052);
    float t9 = v.x * v.x + v.y * v.y;
    float t10 = sqrt(t9);
    float t11 = 1.0 / (1.0 + t10);
    float t12 = t10 * (t10 - 0.6666667 * (1.0 + t10 * t10 * t11));
    float t13 = t10 * atan(v.z, t10) + v.z * (0.9041297 * v.z * t11 + t12);
    float t14 = sqrt(l.x * l.x + l.y * l.y);
    float t15 = 1.0 / (1.0 + t14);
    float t16 = t14 * (t14 - 0.6666667 * (1.0 + t14 * t14 * t15));
    float t17 = t14 * atan(l.z, t14) + l.z * (0.9041297 * l.z * t15 + t16);
    float t18 = b1 ? t13 * 0.31830987 * (t17 * 0.31830987) * t5 : 0.0;
    float t19 = b2 && t14 > 0.0 ? t2 / t14 : 0.0;
    float t20 = roughness * 0.9 * t2 + roughness * t19 * (1.0 / t3 - 1.0);
    float t21 = roughness * t10 * (t9 / (1.0 + abs(v.z))) * 0.31830987;
    return evaluation3(albedo * t7 + w1 / (1.0 - albedo * (t8 * 0.2153052)) * t18, b1 ? t5 * ((1.0 + t20) / (1.0 + t21)) : 0.0);
}

direction_sample3 eon_sample(vec3 v, vec2 u, vec3 albedo, float roughness) {
    float t1 = v.x * v.x + v.y * v.y;
    float t2 = sqrt(t1);
    float t3 = abs(v.z);
    float t4 = t1 / (1.0 + t3);
    float t5 = roughness * t2 * t4 * 0.31830987;
    float t6 = 1.0 + t5;
    float t7 = t5 / t6;
    bool b1 = u.x < t7;
    float t8 = b1 ? 0.0 : t7;
    float t9 = b1 ? t7 : 1.0;
    float t10 = t9 - t8;
    float t11 = (u.x - t8) / t10;
    bool b2 = t11 < t4;
    float t12 = (t9 - u.x) / t10;
    float t13 = b2 ? t3 + t4 * t12 : t4 + t3 * t11;
    float t14 = b2 ? t4 * t11 : t3 * t12;
    float t15 = sqrt(t14);
    float t16 = t13 / (1.0 + t15);
    float t17 = b2 ? t16 : t15;
    float t18 = roughness * 0.9;
    float t19 = t18 * t2;
    float t20 = sqrt(t11);
    float t21 = u.y < 0.125 ? 0.0 : 1.0;
    float t22 = u.y < 0.375 ? 0.0 : 1.0;
    float t23 = u.y < 0.625 ? 0.0 : 1.0;
    float t24 = u.y < 0.875 ? 0.0 : 1.0;
    float t25 = t21 + t22 + t23 + t24;
    bool b3 = t25 == 1.0;
    bool b4 = t25 == 2.0;
    bool b5 = t25 == 3.0;
    bool b6 = b3 || b5;
    float t26 = u.y - t25 * 0.25;
    float t27 = t26 * t26;
    float t28 = -41.341675 + t27 * (81.59394 + t27 * -75.4534);
    float t29 = t26 * 6.2831855 + t26 * (-1.7484555e-07 + t27 * t28);
    float t30 = 64.93932 + t27 * (-85.44374 + t27 * 59.245964);
    float t31 = 1.0 + t27 * (-19.739208 + t27 * t30);
    float t32 = b6 ? t29 : t31;
    float t33 = b3 || b4 ? -t32 : t32;
    float t34 = t20 * t33;
    float t35 = 1.0 + t19 * t34;
    float t36 = sqrt(t35 * t35 + t19 * t19 * t12);
    float t37 = b1 ? t17 : sqrt(2.0 * t12 / (t35 + t36));
    bool b7 = v.z > 8.6736174e-19 && t37 > 8.6736174e-19;
    bool b8 = t1 > 1.1754944e-38;
    float t38 = b8 ? v.x / t2 : 1.0;
    float t39 = b2 ? t15 : t16;
    float t40 = sqrt(t39 * (1.0 + t17));
    float t41 = (2.0 * t34 + t19 * (t34 * t34 + t12)) / (1.0 + t36);
    float t42 = b1 ? 2.0 * t40 * sqrt(u.y * (1.0 - u.y)) : t41;
    float t43 = b8 ? v.y / t2 : 0.0;
    float t44 = b6 ? t31 : t29;
    float t45 = b4 || b5 ? -t44 : t44;
    float t46 = b1 ? t40 * (2.0 * u.y - 1.0) : t20 * t45;
    float t47 = t38 * t42 - t43 * t46;
    float t48 = b7 ? t47 : 0.0;
    float t49 = t43 * t42 + t38 * t46;
    float t50 = b7 ? t49 : 0.0;
    float t51 = b7 ? t37 : 1.0;
    float t52 = 1.0 / (1.0 + 0.2877934 * roughness);
    float t53 = v.x * t47 + v.y * t49;
    bool b9 = t53 > 0.0;
    float t54 = max(max(v.z, t37), 8.6736174e-19);
    float t55 = b9 ? t54 : 1.0;
    float t56 = sqrt(t47 * t47 + t49 * t49);
    float t57 = b9 && t56 > 0.0 ? t53 / t56 : 0.0;
    float t58 = t18 * t53 + roughness * t57 * (1.0 / t54 - 1.0);
    float t59 = (1.0 + t58) / t6;
    float t60 = b7 ? 1.0 / t59 : 0.0;
    float t61 = t52 * max(1.0 + roughness * t53 / t55, 0.0) * t60;
    float t62 = b7 ? t61 : 0.0;
    float t63 = roughness * t52;
    vec3 w1 = albedo * albedo * ((t52 + t63 * 0.07248825) * t63 / 0.2153052);
    float t64 = 1.0 / (1.0 + t2);
    float t65 = t2 * (t2 - 0.6666667 * (1.0 + t2 * t2 * t64));
    float t66 = t2 * atan(v.z, t2) + v.z * (0.9041297 * v.z * t64 + t65);
    float t67 = 1.0 / (1.0 + t56);
    float t68 = t56 * (t56 - 0.6666667 * (1.0 + t56 * t56 * t67));
    float t69 = t56 * atan(t37, t56) + t37 * (0.9041297 * t37 * t67 + t68);
    float t70 = b7 ? t66 * 0.31830987 * (t69 * 0.31830987) * t60 : 0.0;
    vec3 w2 = w1 / (1.0 - albedo * (t63 * 0.2153052)) * t70;
    return direction_sample3(vec3(t48, t50, t51), albedo * t62 + w2, b7 ? t37 * 0.31830987 * t59 : 0.0);
}

evaluation3 burley_evaluate(vec3 v, vec3 l, vec3 albedo, float roughness) {
    bool b1 = v.z > 8.6736174e-19 && l.z > 8.6736174e-19;
    float t1 = 0.5 + roughness * (1.0 + dot(v, l)) - 1.0;
    float t2 = 1.0 - l.z;
    float t3 = t2 * t2;
    float t4 = 1.0 - v.z;
    float t5 = t4 * t4;
    float t6 = (1.0 + t1 * (t3 * t3 * t2)) * (1.0 + t1 * (t5 * t5 * t4));
    float t7 = l.z * 0.31830987;
    float t8 = b1 ? t6 * t7 : 0.0;
    return evaluation3(albedo * t8, b1 ? t7 : 0.0);
}

direction_sample3 burley_sample(vec3 v, vec2 u, vec3 albedo, float roughness) {
    float t1 = sqrt(1.0 - u.x);
    bool b1 = v.z > 8.6736174e-19 && t1 > 8.6736174e-19;
    float t2 = sqrt(u.x);
    float t3 = u.y < 0.125 ? 0.0 : 1.0;
    float t4 = u.y < 0.375 ? 0.0 : 1.0;
    float t5 = u.y < 0.625 ? 0.0 : 1.0;
    float t6 = u.y < 0.875 ? 0.0 : 1.0;
    float t7 = t3 + t4 + t5 + t6;
    bool b2 = t7 == 1.0;
    bool b3 = t7 == 2.0;
    bool b4 = t7 == 3.0;
    bool b5 = b2 || b4;
    float t8 = u.y - t7 * 0.25;
    float t9 = t8 * t8;
    float t10 = t9 * (-41.341675 + t9 * (81.59394 + t9 * -75.4534));
    float t11 = t8 * 6.2831855 + t8 * (-1.7484555e-07 + t10);
    float t12 = t9 * (64.93932 + t9 * (-85.44374 + t9 * 59.245964));
    float t13 = 1.0 + t9 * (-19.739208 + t12);
    float t14 = b5 ? t11 : t13;
    float t15 = b2 || b3 ? -t14 : t14;
    float t16 = t2 * t15;
    float t17 = b1 ? t16 : 0.0;
    float t18 = b5 ? t13 : t11;
    float t19 = b3 || b4 ? -t18 : t18;
    float t20 = t2 * t19;
    float t21 = b1 ? t20 : 0.0;
    float t22 = b1 ? t1 : 1.0;
    float t23 = roughness * (1.0 + (v.x * t16 + v.y * t20 + v.z * t1));
    float t24 = 0.5 + t23 - 1.0;
    float t25 = 1.0 - t1;
    float t26 = t25 * t25;
    float t27 = 1.0 - v.z;
    float t28 = t27 * t27;
    float t29 = (1.0 + t24 * (t26 * t26 * t25)) * (1.0 + t24 * (t28 * t28 * t27));
    float t30 = b1 ? 1.0 : 0.0;
    float t31 = b1 ? t29 * t30 : 0.0;
    return direction_sample3(vec3(t17, t21, t22), albedo * t31, b1 ? t1 * 0.31830987 : 0.0);
}

evaluation3 burley_frostbite_evaluate(vec3 v, vec3 l, vec3 albedo, float roughness) {
    bool b1 = v.z > 8.6736174e-19 && l.z > 8.6736174e-19;
    float t1 = roughness * (0.5 + (1.0 + dot(v, l))) - 1.0;
    float t2 = 1.0 - l.z;
    float t3 = t2 * t2;
    float t4 = 1.0 - v.z;
    float t5 = t4 * t4;
    float t6 = (1.0 + t1 * (t3 * t3 * t2)) * (1.0 + t1 * (t5 * t5 * t4));
    float t7 = l.z * 0.31830987;
    float t8 = b1 ? t6 * (1.0 + -0.33774835 * roughness) * t7 : 0.0;
    return evaluation3(albedo * t8, b1 ? t7 : 0.0);
}

direction_sample3 burley_frostbite_sample(vec3 v, vec2 u, vec3 albedo, float roughness) {
    float t1 = sqrt(1.0 - u.x);
    bool b1 = v.z > 8.6736174e-19 && t1 > 8.6736174e-19;
    float t2 = sqrt(u.x);
    float t3 = u.y < 0.125 ? 0.0 : 1.0;
    float t4 = u.y < 0.375 ? 0.0 : 1.0;
    float t5 = u.y < 0.625 ? 0.0 : 1.0;
    float t6 = u.y < 0.875 ? 0.0 : 1.0;
    float t7 = t3 + t4 + t5 + t6;
    bool b2 = t7 == 1.0;
    bool b3 = t7 == 2.0;
    bool b4 = t7 == 3.0;
    bool b5 = b2 || b4;
    float t8 = u.y - t7 * 0.25;
    float t9 = t8 * t8;
    float t10 = t9 * (-41.341675 + t9 * (81.59394 + t9 * -75.4534));
    float t11 = t8 * 6.2831855 + t8 * (-1.7484555e-07 + t10);
    float t12 = t9 * (64.93932 + t9 * (-85.44374 + t9 * 59.245964));
    float t13 = 1.0 + t9 * (-19.739208 + t12);
    float t14 = b5 ? t11 : t13;
    float t15 = b2 || b3 ? -t14 : t14;
    float t16 = t2 * t15;
    float t17 = b1 ? t16 : 0.0;
    float t18 = b5 ? t13 : t11;
    float t19 = b3 || b4 ? -t18 : t18;
    float t20 = t2 * t19;
    float t21 = b1 ? t20 : 0.0;
    float t22 = b1 ? t1 : 1.0;
    float t23 = 0.5 + (1.0 + (v.x * t16 + v.y * t20 + v.z * t1));
    float t24 = roughness * t23 - 1.0;
    float t25 = 1.0 - t1;
    float t26 = t25 * t25;
    float t27 = 1.0 - v.z;
    float t28 = t27 * t27;
    float t29 = (1.0 + t24 * (t26 * t26 * t25)) * (1.0 + t24 * (t28 * t28 * t27));
    float t30 = b1 ? 1.0 : 0.0;
    float t31 = b1 ? t29 * (1.0 + -0.33774835 * roughness) * t30 : 0.0;
    return direction_sample3(vec3(t17, t21, t22), albedo * t31, b1 ? t1 * 0.31830987 : 0.0);
}
