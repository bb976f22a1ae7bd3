#!/usr/bin/env bash
# Writes a release: scripts/release.sh VERSION [--out FOLDER] [--skip-checks]. Into FOLDER, build/release-VERSION if none is named, go the
# archive, the two single headers, notes.md from CHANGELOG.md, and SHA256SUMS. First .ci/run runs, unless it is skipped.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
stop() {
    echo "release: $1" >&2
    exit 1
}

version= out= checks=1
while (($#)); do
    case $1 in
        --out) [[ ${2:-} ]] || stop "--out needs a folder"; out=$2; shift ;;
        --skip-checks) checks= ;;
        -*) stop "unknown option $1 (known: --out, --skip-checks)" ;;
        *) [[ ! $version ]] || stop "one version, not $version and $1"; version=$1 ;;
    esac
    shift
done
[[ $version =~ ^[0-9]+\.[0-9]+\.[0-9]+$ ]] || stop "a version is needed, as in: scripts/release.sh 0.1.0"
out=$(realpath -m "${out:-$root/build/release-$version}")

own=$(sed -n 's/^#define LOBE_VERSION_\(MAJOR\|MINOR\|PATCH\) //p' "$root/include/lobe/version.hpp" | paste -sd.)
[[ $own == "$version" ]] || stop "include/lobe/version.hpp says $own, not $version"
git -C "$root" rev-parse --verify -q HEAD >/dev/null || stop "$root is no git repository"
[[ ! $(git -C "$root" status --porcelain) ]] || stop "the tree has changes that are not committed"
heading=$(grep -m 1 -F "## [$version]" "$root/CHANGELOG.md") || stop "CHANGELOG.md has no section [$version]"
[[ $heading =~ \ -\ [0-9]{4}-[0-9]{2}-[0-9]{2}$ ]] || stop "CHANGELOG.md gives [$version] no date: $heading"
[[ ! -e $out ]] || stop "$out is there already"

[[ ! $checks ]] || "$root/.ci/run"

# Complete or not at all.
mkdir -p "$(dirname "$out")"
work=$(mktemp -d "$(dirname "$out")/.release.XXXXXX")
trap 'rm -rf "$work"' EXIT
git -C "$root" archive --prefix="lobe-$version/" HEAD | gzip -9n > "$work/lobe-$version.tar.gz"
python3 "$root/scripts/single_header.py" "$work"
awk -v heading="$heading" '$0 == heading { inside = 1; next } /^## / { inside = 0 } inside' "$root/CHANGELOG.md" |
    sed '/./,$!d' > "$work/notes.md"
[[ -s $work/notes.md ]] || stop "CHANGELOG.md says nothing of [$version]"
(cd "$work" && sha256sum -- *.tar.gz *.hpp *.md > SHA256SUMS)
chmod 755 "$work"
mv "$work" "$out"
ls -l "$out"
