#include "scene.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>

#include <embree3/rtcore.h>

namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

// Embree's own spheres cannot be hit from inside: ours, in double.

struct two_hits {
    double near = infinity, far = infinity;
};

two_hits intersection(const sphere& ball, const RTCRay& ray) {
    const glm::dvec3 d{ray.dir_x, ray.dir_y, ray.dir_z};
    const glm::dvec3 o = glm::dvec3{ray.org_x, ray.org_y, ray.org_z} - glm::dvec3{ball.centre};
    const double d2 = lobe::dot(d, d), along = -lobe::dot(o, d) / d2, r = ball.radius;
    const glm::dvec3 nearest = o + along * d;
    const double half2 = (r * r - lobe::dot(nearest, nearest)) / d2;
    if (half2 < 0) return {};
    return {along - std::sqrt(half2), along + std::sqrt(half2)};
}

float first_of(const two_hits& t, const RTCRay& ray) {
    for (const double x : {t.near, t.far})
        if (x > ray.tnear && x < ray.tfar) return static_cast<float>(x);
    return infinity;
}

const sphere& ball_of(void* spheres, unsigned index) { return static_cast<const sphere*>(spheres)[index]; }

void bound(const RTCBoundsFunctionArguments* a) {
    const auto& [c, r, material] = ball_of(a->geometryUserPtr, a->primID);
    *a->bounds_o = {c.x - r, c.y - r, c.z - r, 0, c.x + r, c.y + r, c.z + r, 0};
}

void intersect(const RTCIntersectFunctionNArguments* a) {  // one ray: only rtcIntersect1 is called
    auto& [ray, found] = *reinterpret_cast<RTCRayHit*>(a->rayhit);
    const float t = a->valid[0] ? first_of(intersection(ball_of(a->geometryUserPtr, a->primID), ray), ray) : infinity;
    if (t == infinity) return;
    ray.tfar = t;
    found.primID = a->primID;
    found.geomID = a->geomID;
    found.instID[0] = a->context->instID[0];
}

void occlude(const RTCOccludedFunctionNArguments* a) {
    auto& ray = *reinterpret_cast<RTCRay*>(a->ray);
    if (a->valid[0] && first_of(intersection(ball_of(a->geometryUserPtr, a->primID), ray), ray) < infinity)
        ray.tfar = -infinity;
}

RTCRay ray_of(const vec3& origin, const vec3& direction, float end) {
    return {origin.x, origin.y, origin.z, 0, direction.x, direction.y, direction.z, 0, end, ~0u, 0, 0};
}

constexpr unsigned sphere_geometry = 0, triangle_geometry = 1;

}  // namespace

struct ray_tracer::embree {
    RTCDevice device = rtcNewDevice(nullptr);
    RTCScene scene = rtcNewScene(device);
    ~embree() {
        rtcReleaseScene(scene);
        rtcReleaseDevice(device);
    }
    void attach(RTCGeometry geometry, unsigned id) const {
        rtcCommitGeometry(geometry);
        rtcAttachGeometryByID(scene, geometry, id);
        rtcReleaseGeometry(geometry);
    }
};

ray_tracer::ray_tracer(const scene& described) : s(described), rays(std::make_unique<embree>()) {
    if (!rays->device) throw std::runtime_error("Embree finds no device");
    if (!s.spheres.empty()) {
        const auto g = rtcNewGeometry(rays->device, RTC_GEOMETRY_TYPE_USER);
        rtcSetGeometryUserPrimitiveCount(g, static_cast<unsigned>(s.spheres.size()));
        rtcSetGeometryUserData(g, const_cast<sphere*>(s.spheres.data()));
        rtcSetGeometryBoundsFunction(g, bound, nullptr);
        rtcSetGeometryIntersectFunction(g, intersect);
        rtcSetGeometryOccludedFunction(g, occlude);
        rays->attach(g, sphere_geometry);
    }
    if (!s.triangles.empty()) {
        const std::size_t count = s.triangles.size();
        const auto g = rtcNewGeometry(rays->device, RTC_GEOMETRY_TYPE_TRIANGLE);
        auto* points = static_cast<vec3*>(
            rtcSetNewGeometryBuffer(g, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(vec3), 3 * count));
        auto* indices = static_cast<unsigned*>(
            rtcSetNewGeometryBuffer(g, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(unsigned), count));
        if (!points || !indices) throw std::runtime_error("Embree has no room for the triangles");
        for (std::size_t i = 0; i < 3 * count; ++i) {
            points[i] = s.triangles[i / 3].corners[i % 3];
            indices[i] = static_cast<unsigned>(i);
        }
        rays->attach(g, triangle_geometry);
    }
    rtcCommitScene(rays->scene);
    if (rtcGetDeviceError(rays->device) != RTC_ERROR_NONE) throw std::runtime_error("Embree cannot build the scene");
}

ray_tracer::~ray_tracer() = default;

std::optional<hit> ray_tracer::first_hit(const vec3& origin, const vec3& direction) const {
    RTCRayHit found{ray_of(origin, direction, infinity), {}};
    found.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcIntersect1(rays->scene, &context, &found);
    const std::size_t i = found.hit.primID;
    const float t = found.ray.tfar;
    if (found.hit.geomID == RTC_INVALID_GEOMETRY_ID) return {};
    if (found.hit.geomID == sphere_geometry) {
        const sphere& ball = s.spheres[i];
        const vec3 n = lobe::normalize(origin + t * direction - ball.centre);
        const vec3 around{n.z, 0, -n.x};
        const bool pole = lobe::dot(around, around) == 0;
        return hit{t,
                   ball.centre + ball.radius * n,
                   n,
                   n,
                   pole ? vec3{1, 0, 0} : around,
                   lobe::latlong_uv(n),
                   ball.material,
                   true,
                   i};
    }
    const triangle& face = s.triangles[i];
    const float b1 = found.hit.u, b2 = found.hit.v, b0 = 1 - b1 - b2;
    const auto between = [&](const auto& x) { return x[0] * b0 + x[1] * b1 + x[2] * b2; };
    const vec3 facing = lobe::normalize(face.across());
    return hit{t,
               between(face.corners),
               lobe::normalize(between(face.normals)),
               facing,
               face.corners[1] - face.corners[0],
               between(face.uv),
               face.material,
               false,
               i};
}

bool ray_tracer::blocked(const vec3& origin, const vec3& direction, float distance) const {
    RTCRay ray = ray_of(origin, direction, distance);
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcOccluded1(rays->scene, &context, &ray);
    return ray.tfar < 0;
}
