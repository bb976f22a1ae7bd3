#include "scene.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>

#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <stb_image.h>
#include <tiny_obj_loader.h>

namespace {

using problem = std::runtime_error;

vec3 rgb(const float* c) { return {c[0], c[1], c[2]}; }

std::string one_line(std::string text) {
    while (!text.empty() && text.back() == '\n') text.pop_back();
    std::replace_if(
        text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < ' '; }, ' ');
    return text;
}

/// Linear colours of an 8-bit picture, repeated, row by row from the top.
auto texture(const std::filesystem::path& file) {
    int width = 0, height = 0;
    const std::unique_ptr<float, void (*)(void*)> data{stbi_loadf(file.c_str(), &width, &height, nullptr, 3),
                                                       stbi_image_free};
    if (!data) throw problem("its texture " + file.string() + " cannot be read: " + stbi_failure_reason());
    image map{width, height};
    for (std::size_t i = 0; i < map.pixels.size(); ++i) map.pixels[i] = clamp(rgb(data.get() + 3 * i), 0.0f, 1.0f);
    return [map](const glm::vec2& uv) {
        const auto texel = [](float x, int size) {
            return std::clamp(static_cast<int>((x - std::floor(x)) * static_cast<float>(size)), 0, size - 1);
        };
        return map(texel(uv.x, map.width), texel(1 - uv.y, map.height));
    };
}

material made_of(const tinyobj::material_t& m, const std::filesystem::path& folder) {
    const auto within = [&](float x, float lowest, float highest, const char* what) {
        if (!(x >= lowest && x <= highest))
            throw problem("the " + std::string(what) + " of its material " + m.name + " is " + std::to_string(x) +
                          ": it must be from " + std::to_string(lowest) + " to " + std::to_string(highest));
    };
    for (int i = 0; i < 3; ++i) {
        within(m.diffuse[i], 0, 1, "colour Kd");
        within(m.emission[i], 0, 1e6f, "light Ke");
        within(m.transmittance[i], 0, 1, "colour Tf");
    }
    within(m.roughness, 0, 1, "roughness Pr");
    within(m.metallic, 0, 1, "metalness Pm");
    const bool is_glass = m.illum == 4 || m.illum == 6 || m.illum == 7 || m.illum == 9;
    if (is_glass) within(m.ior, 1.0f, 5.0f, "index Ni");

    material made;
    if (is_glass) {
        const vec3 left = rgb(m.transmittance);  // 0, which stands for no Tf, too: clear
        made = glass(m.ior, m.roughness, left == vec3{0} ? vec3{0} : -log(max(left, 1e-6f)));
    } else if (m.diffuse_texname.empty()) {
        made = uniform(metallic_roughness(rgb(m.diffuse), m.metallic, m.roughness));
    } else {
        const auto colour = texture(folder / m.diffuse_texname);
        made.at = [colour, metallic = m.metallic, roughness = m.roughness](const glm::vec2& uv) -> surface {
            return metallic_roughness(colour(uv), metallic, roughness);
        };
    }
    made.emission = rgb(m.emission);
    return made;
}

void read(scene& s, const std::filesystem::path& file, const vec3& foot, float size) {
    if (!std::filesystem::exists(file)) throw problem("does not exist");
    if (!std::filesystem::is_regular_file(file)) throw problem("is not a file");
    tinyobj::ObjReader obj;
    if (!obj.ParseFromFile(file.string()) || !obj.Valid()) throw problem(one_line("cannot be read: " + obj.Error()));
    if (!obj.Warning().empty()) std::cout << file.string() << ": " << one_line(obj.Warning()) << '\n';

    const auto& points = obj.GetAttrib().vertices;
    const auto& normals = obj.GetAttrib().normals;
    const auto& uvs = obj.GetAttrib().texcoords;
    const auto entry = [](const std::vector<float>& list, int index, std::size_t width) -> const float* {
        if (index < 0) return nullptr;
        if ((static_cast<std::size_t>(index) + 1) * width > list.size())
            throw problem("a face names what is not there");
        return &list[static_cast<std::size_t>(index) * width];
    };

    const std::size_t own_materials = s.materials.size(), own_triangles = s.triangles.size();
    for (const auto& m : obj.GetMaterials()) s.add(made_of(m, file.parent_path()));
    const std::size_t plain = s.add(uniform(diffuse(vec3{0.7f}, 0)));
    vec3 low{INFINITY}, high{-INFINITY};
    for (const auto& shape : obj.GetShapes())
        for (std::size_t f = 0; 3 * f < shape.mesh.indices.size(); ++f) {  // ParseFromFile makes triangles of all faces
            triangle face{};
            const int m = shape.mesh.material_ids[f];
            face.material = m < 0 ? plain : own_materials + static_cast<std::size_t>(m);
            bool smooth = true;
            for (std::size_t i = 0; i < 3; ++i) {
                const auto& corner = shape.mesh.indices[3 * f + i];
                const float *p = entry(points, corner.vertex_index, 3), *n = entry(normals, corner.normal_index, 3),
                            *uv = entry(uvs, corner.texcoord_index, 2);
                if (!p) throw problem("a face names what is not there");
                for (int k = 0; k < 3; ++k)
                    if (!(std::abs(p[k]) < 1e15f)) throw problem("a point is not finite");
                face.corners[i] = rgb(p);
                face.uv[i] = uv ? glm::vec2{uv[0], uv[1]} : glm::vec2{0};
                const float length = n ? lobe::length(rgb(n)) : 0;
                smooth = smooth && length > 0 && std::isfinite(length);
                if (smooth) face.normals[i] = rgb(n) / length;
                low = min(low, face.corners[i]);
                high = max(high, face.corners[i]);
            }
            if (!smooth) face.normals = {vec3{0}, vec3{0}, vec3{0}};
            s.triangles.push_back(face);
        }
    const vec3 extent = high - low;
    const float largest = std::max({extent.x, extent.y, extent.z});
    if (!(largest > 0)) throw problem("has no faces with an area");

    const vec3 middle{(low.x + high.x) / 2, low.y, (low.z + high.z) / 2};
    std::vector<triangle> kept(s.triangles.begin(), s.triangles.begin() + static_cast<std::ptrdiff_t>(own_triangles));
    for (std::size_t i = own_triangles; i < s.triangles.size(); ++i) {
        triangle face = s.triangles[i];
        for (vec3& p : face.corners) p = foot + (p - middle) * (size / largest);
        if (!(face.area() > 0)) continue;
        const vec3 flat = lobe::normalize(face.across());
        for (vec3& n : face.normals)
            if (!(lobe::dot(n, flat) > 0)) n = flat;  // none, or one that contradicts the face
        kept.push_back(face);
    }
    if (kept.size() == own_triangles) throw problem("has no faces with an area");
    s.triangles = std::move(kept);
}

}  // namespace

void add_obj(scene& s, const std::filesystem::path& file, const vec3& foot, float size) try {
    read(s, file, foot, size);
} catch (const std::exception& error) {
    throw problem(file.string() + ": " + error.what());
}
