#!/usr/bin/env bash
# Tries the Debian packages of a build in a new root: tools/try_packages.sh [BUILD] [PACKAGE...]
# BUILD may also be a folder of finished packages.
#
# Makes a minimal Debian 12 with debootstrap, installs the packages (all, unless some are named) with
# what they depend on, simulates, builds a program against the library, imports the Python module,
# removes the packages, and looks for files that are left. Needs root, debootstrap and a mirror.
set -euo pipefail
root=$(cd "$(dirname "$0")/.." && pwd)
build=${1:-$root/build/release}
shift || true
[ "$(id -u)" -eq 0 ] || { echo "needs root, for chroot" >&2; exit 1; }
[ -x /usr/sbin/debootstrap ] || { echo "needs debootstrap: apt install debootstrap" >&2; exit 1; }
work=$(mktemp -d)
trap 'rm -rf --one-file-system "$work"' EXIT
debian=$work/debian
mirror=${MIRROR:-$(cat /etc/apt/sources.list /etc/apt/sources.list.d/*.{list,sources} 2>/dev/null |
  sed -nE 's/^(deb( \[[^]]*\])?|URIs:) ([^ ]+).*/\3/p' | head -n 1 || true)}
eval "$(apt-config shell http_proxy Acquire::http::Proxy https_proxy Acquire::https::Proxy)"
export http_proxy="${http_proxy-}" https_proxy="${https_proxy-}"

echo "== packages"
mkdir "$work/packages"
if ls "$build"/*.deb >/dev/null 2>&1; then
  cp "$build"/*.deb "$work/packages"
else
  (cd "$build" && cpack -G DEB -B "$work/packages" >/dev/null)
  rm -rf "$work/packages/_CPack_Packages"
fi
ls -l "$work/packages"
echo "== a new Debian 12"
debootstrap --variant=minbase --include=ca-certificates bookworm "$debian" "$mirror" >"$work/log" || { tail "$work/log" >&2; exit 1; }
cp /etc/resolv.conf "$debian/etc/" 2>/dev/null || true
grep -l '^Acquire' /etc/apt/apt.conf.d/* 2>/dev/null | xargs -r cp -t "$debian/etc/apt/apt.conf.d"  # how the mirror is reached
mkdir "$debian/packages" "$debian/consumer"
cp "$work"/packages/*.deb "$debian/packages"
cp -r "$root/tests/consumer/." "$debian/consumer"
mkdir -p "$debian/examples"
cp "$root/examples/03_drive_to_goal.cpp" "$debian/examples"

inside() { chroot "$debian" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LANG=C.UTF-8 DEBIAN_FRONTEND=noninteractive http_proxy="${http_proxy-}" https_proxy="${https_proxy-}" "$@"; }
files() { (cd "$debian" && find usr etc opt srv var/lib -xdev -path var/lib/apt -prune -o -path var/lib/dpkg -prune -o -print | sort); }
quietly() { inside "$@" >"$work/log" 2>&1 || { tail -n 30 "$work/log" >&2; exit 1; }; }

quietly apt-get update
chosen=("$@")
[ ${#chosen[@]} -gt 0 ] || chosen=($(cd "$debian/packages" && ls ./*.deb | sed 's|^\./||; s|_.*||'))
debs=()
for name in "${chosen[@]}"; do
  deb=$(cd "$debian" && ls packages/"${name}"_*.deb)
  debs+=("/$deb")
done
# Dependencies and a compiler come first, so that what the packages themselves leave can be seen.
echo "== dependencies"
ours='^(lib|python3-)?fairway'
mapfile -t others < <(inside apt-get install -s --no-install-recommends "${debs[@]}" cmake g++ make | sed -nE 's/^Inst ([^ ]+).*/\1/p' | grep -vE "$ours")
[ ${#others[@]} -eq 0 ] || quietly apt-get install -y --no-install-recommends "${others[@]}"
files >"$work/before"
echo "== install: ${chosen[*]}"
quietly apt-get install -y --no-install-recommends "${debs[@]}"

has() { [[ " ${chosen[*]} " == *" $1 "* ]]; }
if has fairway; then
  inside fairway simulate /usr/share/fairway/scenarios/workshop.yaml --json /tmp/run.json --picture /tmp/run.png >/dev/null
  inside test -s /tmp/run.png
  inside fairway --version
fi
if has libfairway-dev; then
  core=ON
  has libfairway-io-dev && core=OFF
  quietly cmake -S /consumer -B /tmp/consumer -DCMAKE_BUILD_TYPE=Release -DFAIRWAY_CORE_ONLY=$core
  quietly cmake --build /tmp/consumer
  inside /tmp/consumer/consumer >/dev/null
  if [ $core = OFF ] && has fairway; then
    printf 'robot: {radius: 0.25}\n' >"$debian/tmp/settings.yaml"
    inside /tmp/consumer/consumer_io /usr/share/fairway/scenarios/maps/workshop.yaml /tmp/settings.yaml
  fi
  echo "a program was built against the library and drove to its goal"
fi
if has python3-fairway; then
  inside python3 -c '
import numpy, fairway
grid = fairway.Map.from_array(numpy.zeros((100, 200), numpy.int8), 0.05, (0, 0))
navigator = fairway.MapNavigator(fairway.Settings(), grid)
navigator.set_goal(9, 1)
robot = (1, 1, 0)
for cycle in range(600):
    step = navigator.update(0.1 * cycle, robot)
    if step.status == fairway.NavigationStatus.GoalReached: break
    robot = fairway.step(robot, (step.linear, step.angular), 0.1)
print("Python:", step.status, "after", cycle, "cycles")
assert "GoalReached" in str(step.status)'
fi
if has fairway-ros; then
  inside ldd /usr/lib/fairway_ros/fairway_ros_node | grep "not found" && exit 1
  echo "the ROS node finds its libraries"
fi
if has fairway-dds; then inside fairway_dds_node --help >/dev/null; echo "the DDS node starts"; fi

echo "== remove"
quietly apt-get purge -y "${chosen[@]}"
files >"$work/after"
left=$(diff "$work/before" "$work/after" | grep '^>' || true)
[ -z "$left" ] || { echo "expected nothing left, found:" >&2; echo "$left" >&2; exit 1; }
echo "nothing is left"
