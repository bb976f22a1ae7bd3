#!/usr/bin/env bash
# Configures and builds projects that use lobe in every way in which GLM may come with it, and one that exports a library of its own.
# No network: tests/consumers/run.sh [build directory] [compiler]. GLM is the installed one's headers, with a CMakeLists.txt as GLM 1.0.1 has.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
root=$(cd "$here/../.." && pwd)
work=${1:-$root/build/consumers}
compiler=${2:-g++}
headers=$(echo '#include <glm/vec3.hpp>' | "$compiler" -xc++ -E - | sed -n 's|^# 1 "\(.*\)/glm/vec3.hpp".*|\1/glm|p' | head -1)
[[ -d $headers ]] || { echo "No GLM in the compiler's include path" >&2; exit 1; }

rm -rf "$work"
mkdir -p "$work"
cd "$work"

repository() {  # of the files that are there
    git -C "$1" init -q
    git -C "$1" add -A
    git -C "$1" -c user.name=test -c user.email=test@localhost -c commit.gpgsign=false commit -q -m test
}

mkdir -p lobe_repository glm_repository old_names old_paths fetched_headers
cp -r "$root/CMakeLists.txt" "$root/include" lobe_repository
repository lobe_repository
cp -r "$headers" glm_repository
cp -r "$headers" fetched_headers
cat > glm_repository/CMakeLists.txt <<'end'
cmake_minimum_required(VERSION 3.6)
project(glm VERSION 1.0.1 LANGUAGES CXX)
add_library(glm-header-only INTERFACE)
add_library(glm::glm-header-only ALIAS glm-header-only)
target_include_directories(glm-header-only INTERFACE $<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}> $<INSTALL_INTERFACE:include>)
target_compile_definitions(glm-header-only INTERFACE GLM_OF_THE_PROJECT)
add_library(glm INTERFACE)
add_library(glm::glm ALIAS glm)
target_link_libraries(glm INTERFACE glm-header-only)
end
repository glm_repository
git -C glm_repository tag 1.0.1
# what packages before GLM 0.9.9.6 defined: variables, and later a target
echo "set(GLM_INCLUDE_DIRS $work/fetched_headers)" > old_paths/glmConfig.cmake
printf 'add_library(glm INTERFACE IMPORTED)\nset_target_properties(glm PROPERTIES INTERFACE_INCLUDE_DIRECTORIES "%s")\n' \
    "$work/fetched_headers" > old_names/glmConfig.cmake
printf 'set_target_properties(glm PROPERTIES INTERFACE_COMPILE_DEFINITIONS OLD_GLM)\n' >> old_names/glmConfig.cmake

build() {  # name, source, options...
    local name=$1 source=$2
    shift 2
    # lobe's own copy of GLM, which it would download
    if ! { cmake -G Ninja -S "$source" -B "$name" -DCMAKE_CXX_COMPILER="$compiler" -DCMAKE_BUILD_TYPE=Debug \
            -DFETCHCONTENT_SOURCE_DIR_LOBE_GLM="$work/fetched_headers" -DLOBE="$work/lobe_repository" "$@" && cmake --build "$name"; } \
            > "$name.log" 2>&1; then
        cat "$name.log"
        echo "FAILED: $name"
        failed=1
    fi
}
failed=0

none=(-DCMAKE_DISABLE_FIND_PACKAGE_glm=ON)
repositories=(-DGLM="$work/glm_repository")
for way in fetched_after fetched_before declared_after headers_before added_before added_after target_of_old_name imported_target; do
    build "$way" "$here/glm" -DWAY=$way "${repositories[@]}" "${none[@]}"
done
build none_at_all "$here/glm" -DWAY= "${none[@]}"
build given_by_path "$here/glm" -DWAY= "${none[@]}" -DFETCHCONTENT_SOURCE_DIR_GLM="$work/fetched_headers"
build old_paths_used "$here/glm" -DWAY= -Dglm_DIR="$work/old_paths"
build old_names_used "$here/glm" -DWAY= -Dglm_DIR="$work/old_names"
if [[ $headers == /usr/* ]]; then
    build installed "$here/glm" -DWAY=
    build installed_found_before "$here/glm" -DWAY=found_before
    for way in fetched_after added_after; do
        build "installed_and_$way" "$here/glm" -DWAY=$way "${repositories[@]}"
    done
fi

# A library that links lobe from a subdirectory can be exported, whatever GLM; with LOBE_INSTALL lobe is installed with it.
build export_alone "$here/export" "${none[@]}"
build export_added "$here/export" "${repositories[@]}" "${none[@]}"
build export_with_lobe "$here/export" "${none[@]}" -DLOBE_INSTALL=ON
((failed)) && exit 1
cmake --install export_alone --prefix prefix_alone > /dev/null
[[ ! -e prefix_alone/include ]] || { echo "FAILED: lobe's headers were installed without being asked for"; failed=1; }
cmake --install export_alone --prefix prefix_alone --component lobe > /dev/null
cmake --install export_with_lobe --prefix prefix_with_lobe > /dev/null
for prefix in prefix_alone prefix_with_lobe; do
    build "of_$prefix" "$here/of_export" -DCMAKE_PREFIX_PATH="$work/$prefix" -Dglm_DIR="$work/old_paths"
    build "of_${prefix}_old_names" "$here/of_export" -DCMAKE_PREFIX_PATH="$work/$prefix" -Dglm_DIR="$work/old_names"
done
exit $failed
