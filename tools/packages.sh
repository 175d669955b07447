# Sourced by tools/parmesan and tools/test: makes sure that Debian packages are there, and builds quietly.

readonly build_packages=(g++ cmake ninja-build libeigen3-dev nlohmann-json3-dev libcli11-dev libcairo2-dev)

say() { echo "${0##*/}: $*" >&2; }
fail() { say "error: $*"; exit 1; }

# Prints those of the packages that are not installed, one per line.
missing_packages() {
  local package
  for package in "$@"; do
    [[ $(dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null) == installed ]] || echo "$package"
  done
}

# ensure_packages PACKAGE...: installs what is missing by apt, with sudo when not root.
ensure_packages() {
  command -v dpkg-query >/dev/null && command -v apt-get >/dev/null ||
    { ensure_tools "$@"; return; }
  local missing apt=(apt-get)
  mapfile -t missing < <(missing_packages "$@")
  ((${#missing[@]})) || return 0
  if ((EUID != 0)); then
    command -v sudo >/dev/null || fail "please have root install these packages: ${missing[*]}"
    apt=(sudo apt-get)
  fi
  say "installing ${missing[*]}"
  export DEBIAN_FRONTEND=noninteractive
  local install=("${apt[@]}" install -y -qq --no-install-recommends "${missing[@]}")
  "${install[@]}" >/dev/null 2>&1 || { "${apt[@]}" update -qq >&2 && "${install[@]}" >&2; } ||
    fail "apt could not install: ${missing[*]}"
}

# Without apt: the tools that can be looked for must be there; CMake looks for the libraries and says which it lacks.
ensure_tools() {
  command -v cmake >/dev/null && command -v ninja >/dev/null && command -v c++ >/dev/null && return
  fail "this is not Debian, please install what these Debian packages hold: $*"
}

# configure_once DIRECTORY ARGUMENT...: configures again only when the arguments have changed.
configure_once() {
  local directory=$1 arguments="${*:2}"
  [[ -f $directory/build.ninja && $(cat "$directory/.arguments" 2>/dev/null) == "$arguments" ]] && return
  mkdir -p "$directory"
  cmake -S "$root" -B "$directory" -G Ninja "${@:2}" >"$directory/configure.log" 2>&1 ||
    { tail -n 40 "$directory/configure.log" >&2; return 1; }
  echo "$arguments" >"$directory/.arguments"
}
