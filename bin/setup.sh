# Shared by bin/solitaire and bin/test: installs packages and builds. The caller sets $root, the checkout, and
# $build, the build folder.
# shellcheck shell=bash
: "${root:?}" "${build:?}"

log=$build/setup.log

say() { printf 'solitaire: %s\n' "$*" >&2; }

# The program's own exit statuses are small numbers with a meaning; 125 says that it was not even started.
fail() {
  say "$@"
  exit 125
}

# lock_build: waits until no other script installs or builds for this checkout. The lock ends with the shell that
# took it.
lock_build() {
  mkdir -p "$root/build" "$build" 2>/dev/null || true
  [ -w "$build" ] || fail "cannot write to $build, where the program is built"
  exec 9>"$root/build/.lock"
  if ! flock --nonblock 9; then
    say "waiting for another build"
    flock 9
  fi
  : >"$log"
}

# show_progress: on a terminal, one line that changes; elsewhere nothing, for the log has it all.
show_progress() {
  local line columns
  if [ ! -t 2 ]; then
    cat >/dev/null
    return
  fi
  columns=$(tput cols 2>/dev/null) || columns=80
  while IFS= read -r line; do
    printf '\r\033[K%.*s' "$((columns - 1))" "$line" >&2
  done
  printf '\r\033[K' >&2
}

# logged COMMAND...: runs it with its output in the log, of which a failure shows the end.
logged() {
  # The standard input is the program's: nothing here may read it.
  "$@" </dev/null 2>&1 | tee -a "$log" | show_progress && return
  say "failed: $*"
  tail -n 40 "$log" >&2
  fail "the whole log: $log"
}

as_root() {
  if [ "$(id -u)" = 0 ]; then "$@"; else sudo "$@"; fi
}

# missing_packages SECTION...: those of packages.txt that are not installed.
missing_packages() {
  local section package command
  while read -r section package command; do
    [[ " $* " == *" $section "* ]] || continue
    if [ -n "$command" ] && command -v "$command" >/dev/null; then continue; fi
    [ "$(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null)" = installed ] || echo "$package"
  done <"$root/packages.txt"
}

# install_packages SECTION...: installs those that are missing.
install_packages() {
  command -v apt-get >/dev/null || fail "needs Debian 12: there is no apt-get here"
  local missing
  mapfile -t missing < <(missing_packages "$@")
  [ ${#missing[@]} -gt 0 ] || return 0
  [ "$(id -u)" = 0 ] || command -v sudo >/dev/null ||
    fail "neither root nor sudo; let someone who is root run: apt-get install ${missing[*]}"

  say "installing ${missing[*]}"
  # An installation that was interrupted has to be finished before apt does anything else.
  logged as_root dpkg --configure -a
  logged as_root apt-get update
  logged as_root env DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends \
    -o DPkg::Lock::Timeout=600 "${missing[@]}"
}

# configured: the build folder is laid out, and for this checkout. CMake refuses a folder that was laid out for
# another one, such as this one before it was moved.
configured() {
  [ -e "$build/build.ninja" ] && grep -qxF "CMAKE_HOME_DIRECTORY:INTERNAL=$root" "$build/CMakeCache.txt"
}

# configure CMAKE-OPTION...: lays out the build folder. Several sources are compiled as one, which takes a third of the
# time, unless the options say otherwise.
configure() {
  configured || rm -rf "$build/CMakeCache.txt" "$build/CMakeFiles"
  logged cmake -S "$root" -B "$build" -G Ninja -DCMAKE_UNITY_BUILD=ON -DCMAKE_UNITY_BUILD_BATCH_SIZE=10 "$@"
}

# compile CMAKE-BUILD-OPTION...
compile() {
  say "building in $build (the first time takes minutes)"
  logged cmake --build "$build" "$@"
}
