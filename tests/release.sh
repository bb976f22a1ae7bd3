#!/usr/bin/env bash
# scripts/release.sh on a clone: what it writes can be used, and a mistake ends in one line and leaves nothing.
# tests/release.sh [compiler]
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
compiler=${1:-g++}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
fail() {
    echo "FAILED: $1" >&2
    exit 1
}

# The files as they are now, committed.
mkdir "$work/lobe"
cp -r "$root"/{CMakeLists.txt,CHANGELOG.md,LICENSE,README.md,include,scripts} "$work/lobe"
cd "$work/lobe"
printf '\n## [0.0.1] - 2020-01-01\n\n- An older version.\n' >> CHANGELOG.md
as_test=(git -c user.name=test -c user.email=test@localhost -c commit.gpgsign=false)
git init -q && git add -A && "${as_test[@]}" commit -qm files
version=$(sed -n 's/^#define LOBE_VERSION_\(MAJOR\|MINOR\|PATCH\) //p' include/lobe/version.hpp | paste -sd.)
release() { bash scripts/release.sh "$@" --skip-checks --out "$work/out"; }
refused() {  # what it says, arguments...
    local says=$1 said
    shift
    ! said=$(release "$@" 2>&1) || fail "not refused: $says"
    [[ $said == "release: "*"$says"* && $(wc -l <<< "$said") == 1 ]] || fail "for '$says' it said: $said"
    [[ ! -e $work/out && ! $(find "$work" -maxdepth 1 -name '.release*') ]] || fail "something is left: $says"
}

refused "a version is needed"
refused "version.hpp says $version" 99.0.0
sed -i "s/^## \[$version\].*/## [$version] - unreleased/" CHANGELOG.md
"${as_test[@]}" commit -qam "no date" --allow-empty
refused "no date" "$version"
sed -i "s/^## \[$version\].*/## [$version] - 2030-01-02/" CHANGELOG.md
refused "not committed" "$version"
"${as_test[@]}" commit -qam date
sed -i "s/^## \[$version\].*/## [0.0.0] - 2030-01-02/" CHANGELOG.md
"${as_test[@]}" commit -qam "another section"
refused "no section" "$version"
git reset -q --hard HEAD~1

release "$version" > "$work/log"
refused_again=$(release "$version" 2>&1) && fail "the folder was there already"
[[ $refused_again == *"is there already" ]] || fail "it said: $refused_again"

cd "$work/out"
sha256sum --quiet -c SHA256SUMS
[[ $(ls) == "$(printf '%s\n' SHA256SUMS "lobe-$version.tar.gz" lobe.hpp lobe_testkit.hpp notes.md)" ]] || fail "it wrote $(ls)"
grep -q '^### Added' notes.md && ! grep -q 'An older version' notes.md || fail "notes.md is no section of CHANGELOG.md"
cat > "$work/one.cpp" <<'end'
#include "lobe_testkit.hpp"
#include "lobe.hpp"
int main() {
    const lobe::microfacet gold{lobe::ggx{lobe::alpha{0.3f}}, lobe::smith_correlated{}, lobe::schlick{0.9f}};
    return gold.f_cos({0, 0, 1}, {0, 0, 1}) > 0 ? 0 : 1;
}
end
"$compiler" -std=c++20 -Wall -Wextra -Werror -I. "$work/one.cpp" -o "$work/one" && "$work/one" || fail "the single headers"

tar -xzf "lobe-$version.tar.gz" -C "$work"
cmake -S "$work/lobe-$version" -B "$work/build" -DCMAKE_CXX_COMPILER="$compiler" -DLOBE_BUILD_TESTS=OFF -DLOBE_BUILD_EXAMPLES=OFF \
    -DLOBE_BUILD_BENCHMARKS=OFF > "$work/log" 2>&1 || { cat "$work/log"; fail "the archive does not configure"; }
cmake --install "$work/build" --prefix "$work/prefix" > "$work/log" 2>&1 || { cat "$work/log"; fail "the archive does not install"; }
[[ -s $work/prefix/include/lobe/lobe.hpp ]] || fail "the archive installs no headers"
echo "release: passed"
