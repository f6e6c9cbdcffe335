#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Tries what README promises on a Debian 12 with nothing in it: debootstrap, chroot, clone, two
# commands. Takes some minutes and the network; not part of CI.
#
# usage: tests/newcomer/run.sh [--base DIR] [--mirror URL] [--keep]
#   --base DIR    copy this debootstrap --variant=minbase tree instead of fetching one
#   --mirror URL  default http://deb.debian.org/debian
#   --keep        leave the tree and say where it is
#
# Needs root, debootstrap and unshare. What is committed is tried, not the working tree.
set -euo pipefail

root=$(cd -- "$(dirname -- "$(readlink -f -- "$0")")/../.." && pwd)
base='' mirror=http://deb.debian.org/debian keep=no
while (($# > 0)); do
  case $1 in
    --base) base=$2; shift ;;
    --mirror) mirror=$2; shift ;;
    --keep) keep=yes ;;
    *) echo "unknown option $1" >&2; exit 2 ;;
  esac
  shift
done
((EUID == 0)) || { echo "needs root" >&2; exit 1; }

tree=$(mktemp -d /var/tmp/newcomer.XXXXXX)
chmod 755 "$tree"  # it becomes the root of another user, too
finish() {
  if [[ $keep == yes ]]; then
    echo "the tree is left in $tree"
  else
    rm -rf --one-file-system -- "$tree"
  fi
}
trap finish EXIT

if [[ -n $base ]]; then
  cp -a -- "$base/." "$tree"
else
  debootstrap --variant=minbase bookworm "$tree" "$mirror" > /dev/null
fi
# Package lists as an image of Debian has them: none. And the proxy of this machine, if any.
find "$tree/var/lib/apt/lists" -type f -delete
cp -L /etc/resolv.conf /etc/hosts "$tree/etc/"
grep -l -s -r -i 'proxy\|Check-Valid-Until' /etc/apt/apt.conf.d |
  xargs -r cp -t "$tree/etc/apt/apt.conf.d" || true

# A path with a blank in it, as people have.
home="/home/new comer"
mkdir -p "$tree$home"
git clone --quiet "file://$root" "$tree$home/vides"
cp -a "$tree$home/vides" "$tree$home/theirs"
chroot "$tree" chown -R 65534:65534 "$home/theirs"

# Runs on the new machine, in a clean environment and as USER; the mounts end with the namespace.
inside() {
  local user=$1
  shift
  unshare --mount --propagation private sh -c '
    tree=$1 user=$2 home=$3
    shift 3
    mount -t proc proc "$tree/proc"
    mount --rbind /dev "$tree/dev"
    exec env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME="$home" CI=true \
      ${http_proxy:+http_proxy="$http_proxy"} ${https_proxy:+https_proxy="$https_proxy"} \
      chroot --userspec="$user" "$tree" "$@" < /dev/null
  ' sh "$tree" "$user" "$home" "$@"
}

failures=0
check() {
  local what=$1
  shift
  if "$@"; then echo "ok    $what"; else echo "FAILS $what"; failures=$((failures + 1)); fi
}
out="$tree/out.txt" err="$tree/err.txt"

refused_without_root() {
  local code=0
  inside 65534:65534 "$home/theirs/dev" run --version > "$out" 2> "$err" || code=$?
  ((code == 1)) && [[ ! -s $out ]] && grep -q 'missing.*cmake' "$err"
}
first_run() {
  time inside 0:0 "$home/vides/dev" run --version > "$out" 2> "$err" && cat "$err" "$out" &&
    grep -q '^vides [0-9]' "$out" && (($(wc -l < "$out") == 1))
}
first_test() {
  time inside 0:0 "$home/vides/dev" test > "$out" 2> "$err" || { cat "$err" "$out"; return 1; }
  tail -n 3 "$out"
}
second_run() {
  local start=${EPOCHREALTIME/./} took
  inside 0:0 "$home/vides/dev" run --version > "$out" 2> "$err" || return 1
  took=$(((${EPOCHREALTIME/./} - start) / 1000))
  echo "      $took ms"
  ((took < 1000)) && [[ ! -s $err ]]
}
offline_as_user() {
  local program
  program=$(tree=$tree home=$home/theirs unshare --net -- bash -c "$(declare -f inside); inside \"\$@\"" \
    bash 65534:65534 "$home/theirs/dev" build 2> "$err" | tail -n 1) || { cat "$err"; return 1; }
  [[ $program == /* && -x $tree$program ]]
}

check "without root: refused, and the missing packages named" refused_without_root
check "./dev run on the bare system" first_run || true
((failures == 0)) || cat "$err"
check "./dev test on the bare system" first_test
check "the second start within a second" second_run
check "another user, without a network" offline_as_user
check "libFuzzer is there" inside 0:0 sh -c 'echo "extern \"C\" int LLVMFuzzerTestOneInput(const char*, unsigned long) { return 0; }" > /tmp/f.cpp &&
  clang++ -fsanitize=fuzzer,address,undefined /tmp/f.cpp -o /tmp/f && /tmp/f -runs=10 2> /dev/null'
echo "$failures failed"
((failures == 0))
