// Writes a BRDF as a shader: emit_shader --language wgsl --brdf "ggx smith_correlated schlick"
#include "library.hpp"

#include <CLI/CLI.hpp>

#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>

namespace {

using emit::word;

const std::vector<std::pair<std::string, lobe::shader::language>>& languages() {
    static const std::vector<std::pair<std::string, lobe::shader::language>> all{
        {"glsl", lobe::shader::glsl()}, {"glsl_es", lobe::shader::glsl_es()}, {"hlsl", lobe::shader::hlsl()},
        {"wgsl", lobe::shader::wgsl()}, {"msl", lobe::shader::msl()},         {"cpp", lobe::shader::cpp()},
        {"cuda", lobe::shader::cuda()}};
    return all;
}

const lobe::shader::language& language_of(const std::string& name) {
    std::vector<std::string> words;
    for (const auto& [known, language] : languages()) {
        if (known == name) return language;
        words.push_back(known);
    }
    emit::refuse("language", name, words);
}

bool has(const std::vector<word>& words, const std::string& name) {
    return std::any_of(words.begin(), words.end(), [&](const word& w) { return w.name == name; });
}

const std::vector<std::pair<const char*, const std::vector<word>*>> lists{
    {"normals", &emit::normals_words},  {"masking", &emit::masking_words},    {"Fresnel", &emit::fresnel_words},
    {"samplers", &emit::sampler_words}, {"whole models", &emit::model_words}, {"functions", &emit::function_words}};

void list(std::ostream& to) {
    to << "languages:";
    for (const auto& [name, language] : languages()) to << ' ' << name;
    for (const auto& [what, words] : lists) {
        to << '\n' << what << ":\n";
        for (const word& w : *words) to << "  " << w.name << std::string(32 - w.name.size(), ' ') << w.about << '\n';
    }
}

std::string emitted(const std::string& language, const std::string& brdf, const std::vector<std::string>& functions,
                    const std::string& prefix, std::vector<glm::vec2>& texels) {
    const auto& to = language_of(language);
    for (const std::string& f : functions)
        if (!has(emit::function_words, f)) emit::refuse("function", f, emit::names({&emit::function_words}));
    emit::parts parts;
    std::string model, about = brdf;
    std::istringstream written(brdf);
    int count = 0;
    for (std::string w; written >> w; ++count) {
        if (has(emit::normals_words, w))
            parts.normals = w;
        else if (has(emit::masking_words, w))
            parts.masking = w;
        else if (has(emit::fresnel_words, w))
            parts.fresnel = w;
        else if (has(emit::sampler_words, w))
            parts.sampler = w;
        else if (has(emit::model_words, w))
            model = w;
        else
            emit::refuse("part of a BRDF", w,
                         emit::names({&emit::normals_words, &emit::masking_words, &emit::fresnel_words,
                                      &emit::sampler_words, &emit::model_words}));
        for (const auto& [what, words] : lists)
            for (const word& known : *words)
                if (known.name == w) about += "\n  " + w + ": " + known.about;
    }
    if (!count) throw emit::mistake("--brdf names no part: \"ggx smith_correlated schlick\", for instance");
    if (!model.empty() && count > 1) throw emit::mistake("'" + model + "' is a whole model, and takes no parts");
    lobe::shader::file file;
    if (!model.empty()) {
        for (const std::string& f : functions)
            if (f.starts_with("dfg"))
                throw emit::mistake("'" + f + "' is of normals and masking, not of a whole model");
        emit::add_model(file, model, functions, prefix);
    } else {
        emit::add_microfacet(file, parts, functions, prefix, texels);
    }
    return file.print(to, about + "\n" + emit::domain + "\nError in float, on a CPU: docs/accuracy.md of lobe.");
}

void write(const std::filesystem::path& path, const std::string& text) {
    std::ofstream file(path, std::ios::binary);
    if (!(file << text).flush()) throw emit::mistake(path.string() + " cannot be written");
}

}  // namespace

int main(int count, char** arguments) {
    CLI::App app{"Writes a BRDF of lobe's as a shader to include."};
    std::string language = "glsl", brdf = "ggx smith_correlated schlick", prefix, out, ready, texture;
    std::vector<std::string> functions{"evaluate", "sample"};
    bool all = false;
    app.add_option("--language", language, "glsl, glsl_es, hlsl, wgsl, msl, cpp or cuda");
    app.add_option("--brdf", brdf, "parts of a microfacet BRDF, or a whole model");
    app.add_option("--functions", functions, "what of it, with commas between")->delimiter(',');
    app.add_option("--prefix", prefix, "put before the name of each function");
    app.add_option("--out", out, "a file instead of the standard output");
    app.add_option("--texels", texture, "where dfg_texture's numbers go: RG32F, little-endian, row by row");
    app.add_option("--ready-made", ready, "write the files of examples/shaders into this folder");
    app.add_flag("--list", all, "the words of --language, --brdf and --functions");
    try {
        app.parse(count, arguments);
    } catch (const CLI::CallForHelp& help) {
        return app.exit(help);
    } catch (const CLI::ParseError& error) {
        std::cerr << "emit_shader: " << error.what() << '\n';
        return 2;
    }
    try {
        if (all) {
            list(std::cout);
        } else if (!ready.empty()) {
            for (const auto& r : emit::all_ready_made())
                for (const auto& [name, to] : languages())
                    write(std::filesystem::path(ready) / (r.name + "." + to.extension), r.content.print(to, r.about));
        } else {
            std::vector<glm::vec2> texels;
            const std::string text = emitted(language, brdf, functions, prefix, texels);
            if (texels.empty() != texture.empty())
                throw emit::mistake("--functions dfg_texture and --texels FILE go together");
            if (!texels.empty())
                write(texture, {reinterpret_cast<const char*>(texels.data()), texels.size() * sizeof texels[0]});
            if (out.empty())
                std::cout << text;
            else
                write(out, text);
        }
    } catch (const std::exception& error) {
        std::cerr << "emit_shader: " << error.what() << '\n';
        return 2;
    }
}
