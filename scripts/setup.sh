# Sourced by the run.sh scripts. `need package...` installs the Debian packages that are missing.

need() {
    if ! command -v apt-get >/dev/null; then
        echo "Not a Debian machine: the packages below are Debian's names for what is needed; CMake looks for them." >&2
        echo "    $*" >&2
        return
    fi
    local package missing=() as_root=()
    for package in "$@"; do
        [[ $(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null) == installed ]] || missing+=("$package")
    done
    ((${#missing[@]})) || return 0
    if ((EUID)); then
        as_root=(sudo -n)
        if ! sudo -n true 2>/dev/null; then
            echo "Missing packages, and no right to install them. Run: sudo apt-get install ${missing[*]}" >&2
            exit 1
        fi
    fi
    echo "Installing ${missing[*]}"
    if ! { "${as_root[@]}" apt-get update -qq &&
        "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends \
            -o DPkg::Lock::Timeout=120 "${missing[@]}" >/dev/null; }; then
        echo "Could not install ${missing[*]}" >&2
        exit 1
    fi
}
