#!/bin/bash
# Runs the README's two commands, or those given, on a bare machine: a debootstrap minbase chroot of Debian 12 with the
# committed tree in it and nothing else. Needs root and the package debootstrap.
#
#   tools/check_bare_machine.sh [--mirror URL] [--keep] [COMMAND]...
#
# Packages come from where this machine's apt gets its own, unless a mirror is given. --keep leaves the chroot there.
set -euo pipefail

mirror=
keep=
while [ $# -gt 0 ]; do
  case $1 in
    --mirror)
      mirror=$2
      shift
      ;;
    --keep) keep=1 ;;
    *) break ;;
  esac
  shift
done
cd "$(dirname "$(readlink -f "$0")")/.."

# readme_command PROGRAM: the first line of the README that is a call of it and nothing else.
readme_command() {
  grep -m1 -E "^ *$1( |\$)" README.md || { echo "README.md has no line with a call of $1" >&2; exit 2; }
}
commands=("$@")
[ $# -gt 0 ] || commands=("$(readme_command bin/solitaire)" "$(readme_command bin/test)")

machine=$(mktemp -d "${TMPDIR:-/tmp}/bare-machine.XXXXXX")
clean_up() {
  if [ -n "$keep" ]; then echo "kept: $machine"; else rm -rf --one-file-system "$machine"; fi
}
trap clean_up EXIT

# This machine's way to packages: its mirror, apt's configuration, name service and certificates.
lend_network() {
  cp -L /etc/resolv.conf /etc/hosts "$machine/etc/"
  cp -L /etc/apt/apt.conf.d/* "$machine/etc/apt/apt.conf.d/"
  cp -L /etc/ssl/certs/ca-certificates.crt "$machine/certificates.crt"
  if [ -n "$1" ]; then return; fi
  rm "$machine/etc/apt/sources.list"
  cp -rL /etc/apt/sources.list* "$machine/etc/apt/"
}

lay_out() {
  local apt_mirror
  # shellcheck disable=SC2016 # for apt to fill in, not for the shell
  apt_mirror=$(apt-get indextargets --format '$(REPO_URI)' 'Created-By: Packages' 'Codename: bookworm' | sed -n 1p)
  debootstrap --variant=minbase bookworm "$machine" "${mirror:-$apt_mirror}"
  chmod 755 "$machine"
  lend_network "$mirror"
  mkdir "$machine/solitaire"
  git archive HEAD | tar -x -C "$machine/solitaire"
}

# run_there COMMAND: with a /proc of its own, and of this machine's variables only those that lead to packages.
run_there() {
  local variables=(HOME=/root TERM=dumb PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin
    npm_config_cafile=/certificates.crt "npm_config_registry=$(npm config get registry 2>/dev/null || true)")
  local name
  for name in http_proxy https_proxy no_proxy HTTP_PROXY HTTPS_PROXY NO_PROXY; do
    [ -z "${!name-}" ] || variables+=("$name=${!name}")
  done
  unshare --mount --pid --fork --mount-proc="$machine/proc" \
    chroot "$machine" env -i "${variables[@]}" bash -c "cd /solitaire && $1" </dev/null
}

echo "== laying out a bare machine"
lay_out >"$machine.log" 2>&1 || { tail -n 20 "$machine.log"; exit 1; }
rm "$machine.log"
for command in "${commands[@]}"; do
  started=$SECONDS
  echo "== $command"
  status=0
  run_there "$command" || status=$?
  echo "== exit status $status after $((SECONDS - started)) s"
  [ "$status" = 0 ] || exit "$status"
done
