# shellcheck shell=bash
# Sourced by ./rosy: installs and builds what a command needs, once, and says so while it works.
#
#   need runtime   GHC, the Rosy library and its worker, the Python service
#   need robot     what speaks to real robots
#   need builder   what makes native programs
#   need page      what the browser loads
#   need codegen   the block and Haskell conversions for Node
#   need tools     what only the tests use: browser, linters, ROS
#
# Each step has a stamp under .rosy/stamps holding a fingerprint of its inputs; a step whose stamp still fits is skipped,
# so a second call costs a few file listings; one whose result has been taken away is done again. Logs are in .rosy/log.

ROSY_STATE="$ROSY_ROOT/.rosy"
ROSY_PYTHON="$ROSY_STATE/venv/bin/python"
export ROSY_PYTHON
export PYTHONPATH="$ROSY_ROOT/sim-service${PYTHONPATH:+:$PYTHONPATH}"
# A cabal that knows no package server: Debian's packages are all there is, and nothing is asked of the network.
export CABAL_DIR="$ROSY_STATE/cabal"
# Programs, messages and tests are written in UTF-8, also where the system was never told of a language.
[ "$(locale charmap 2>/dev/null)" = UTF-8 ] || export LC_ALL=C.UTF-8
# Where one's own folder cannot be written, as in some containers.
[ -w "${HOME:-/nowhere}" ] || export HOME="$ROSY_STATE/home"
mkdir -p "$HOME" "$ROSY_STATE/stamps" "$ROSY_STATE/log" "$CABAL_DIR"
[ -f "$CABAL_DIR/config" ] || : >"$CABAL_DIR/config"

# Debian packages. Each line has its reason in DECISIONS.md, "What we install".
APT_RUNTIME="ghc cabal-install gcc libc6-dev libgmp-dev pkg-config
  libghc-aeson-dev libghc-websockets-dev libghc-random-dev libghc-network-dev libghc-async-dev
  libseccomp-dev bubblewrap"
APT_TOOLS="chromium hlint ormolu shellcheck
  libghc-quickcheck2-dev libghc-tasty-dev libghc-tasty-hunit-dev libghc-tasty-quickcheck-dev libghc-reactive-banana-dev"

say() { printf '\033[2m•\033[0m %s\n' "$*" >&2; }
give_up() {
  printf 'rosy: %s\n' "$*" >&2
  exit 1
}

# fingerprint PATH...: names, sizes and times of all files below, as one word.
fingerprint() {
  (cd "$ROSY_ROOT" && find "$@" \
    \( -name node_modules -o -name dist -o -name dist-newstyle -o -name __pycache__ -o -name .venv -o -name '.*_cache' \) -prune \
    -o -type f -printf '%p %s %T@\n' 2>/dev/null | LC_ALL=C sort | sha1sum | cut -d' ' -f1)
}

# made STEP: whether what the step made is still there.
made() {
  case "$1" in
    venv) "$ROSY_PYTHON" -c '' 2>/dev/null ;;
    npm) [ -d "$ROSY_ROOT/node_modules/vite" ] ;;
    haskell) built rosy-worker ;;
    robot) built rosy-robot ;;
    builder) built rosy-build ;;
    codegen) [ -f "$ROSY_ROOT/codegen/dist/cli.js" ] ;;
    api-docs) [ -f "$ROSY_STATE/api-docs/Rosy.html" ] ;;
    page) [ -f "$ROSY_ROOT/editor/dist/index.html" ] ;;
  esac
}
built() { compgen -G "$ROSY_ROOT/dist-newstyle/build/*/ghc-*/rosy-*/x/$1/build/$1/$1" >/dev/null; }

# step NAME FINGERPRINT SENTENCE COMMAND...: runs the command unless the stamp says it is done. Two do not do it at once.
step() {
  local name=$1 print=$2 stamp="$ROSY_STATE/stamps/$1" turn
  is_done "$stamp" "$print" "$name" && return 0
  exec {turn}>"$ROSY_STATE/turn"
  if command -v flock >/dev/null; then flock "$turn"; fi
  is_done "$stamp" "$print" "$name" || perform "$@"
  exec {turn}>&-
}
is_done() { [ -f "$1" ] && [ "$(cat "$1")" = "$2" ] && made "$3"; }
perform() {
  local name=$1 print=$2 sentence=$3 stamp="$ROSY_STATE/stamps/$1"
  shift 3
  say "$sentence"
  local log="$ROSY_STATE/log/$name.log" started=$SECONDS
  if ! "$@" >"$log" 2>&1; then
    tail -n 25 "$log" >&2
    give_up "this step failed: $sentence The whole log is in .rosy/log/$name.log."
  fi
  printf '%s' "$print" >"$stamp"
  [ $((SECONDS - started)) -lt 3 ] || say "  done in $((SECONDS - started)) s"
}

missing_packages() {
  local p
  for p in "$@"; do
    # The second test serves machines where Node, Python or a compiler came from elsewhere.
    dpkg-query -W -f='${Status}\n' "$p" 2>/dev/null | grep -q 'ok installed' || printf '%s ' "$p"
  done
}

apt_install() {
  # A machine that has just come up may still be at its own updates.
  local as_root=() patient=(-o Acquire::Retries=5 -o DPkg::Lock::Timeout=600)
  if [ "$(id -u)" != 0 ]; then as_root=(sudo); fi
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get "${patient[@]}" update &&
    "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get "${patient[@]}" install -y --no-install-recommends "$@"
}

need_apt() { # need_apt STAMP PACKAGES
  local stamp=$1 missing
  shift
  [ -f "$ROSY_STATE/stamps/$stamp" ] && [ "$(cat "$ROSY_STATE/stamps/$stamp")" = "$*" ] && return 0
  if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
    give_up "this machine has no apt. Install by your own means what these Debian packages hold, then try again: $*"
  fi
  # shellcheck disable=SC2046
  missing=$(missing_packages "$@")
  if [ -n "$missing" ]; then
    if [ "$(id -u)" != 0 ]; then
      command -v sudo >/dev/null || give_up "these Debian packages are missing, and there is no sudo to install them with. As root, run: apt-get install $missing"
      say "Rosy needs some Debian packages and asks sudo to install them: $missing"
      sudo -v || give_up "without them Rosy cannot go on. As root, run: apt-get install $missing"
    fi
    # shellcheck disable=SC2086
    step "apt-$stamp" "$missing$RANDOM" "Installing from Debian: $missing" apt_install $missing
  fi
  printf '%s' "$*" >"$ROSY_STATE/stamps/$stamp"
}

need_python() {
  command -v python3 >/dev/null || give_up "Python 3.11 or newer is needed. On Debian: apt-get install python3 python3-venv"
  python3 -c 'import sys; sys.exit(sys.version_info < (3, 11))' 2>/dev/null || give_up "Python 3.11 or newer is needed; this is $(python3 --version)."
  python3 -c 'import ensurepip' 2>/dev/null || need_apt python-venv python3-venv
  step venv "$(sha1sum <"$ROSY_ROOT/sim-service/requirements.lock")" "Installing the Python packages of the simulator." make_venv
}
make_venv() {
  rm -rf "$ROSY_STATE/venv"
  python3 -m venv "$ROSY_STATE/venv" &&
    "$ROSY_PYTHON" -m pip install --disable-pip-version-check --retries 10 --no-deps -r "$ROSY_ROOT/sim-service/requirements.lock"
}

need_haskell() {
  # shellcheck disable=SC2086
  need_apt runtime $APT_RUNTIME
  step haskell "$(fingerprint rosy.cabal cabal.project rosy-hs/src rosy-hs/worker rosy-hs/app)" \
    "Building the Rosy language and its worker with GHC (about a minute)." build_haskell
}
build_haskell() {
  (cd "$ROSY_ROOT" && cabal build --offline -j2 --disable-tests lib:rosy exe:rosy-worker)
}

need_robot() {
  step robot "$(fingerprint rosy.cabal cabal.project rosy-hs/src rosy-hs/ros rosy-hs/robots rosy-hs/app)" \
    "Building what speaks to real robots (about a minute)." build_robot
}
build_robot() { (cd "$ROSY_ROOT" && cabal build --offline -j2 --disable-tests exe:rosy-robot); }

need_builder() {
  step builder "$(fingerprint rosy.cabal cabal.project rosy-hs/builder rosy-hs/worker)" \
    "Building what makes native programs." build_builder
}
build_builder() { (cd "$ROSY_ROOT" && cabal build --offline -j2 --disable-tests exe:rosy-build); }

need_node() {
  command -v node >/dev/null || give_up "Node 20 or newer is needed. See https://nodejs.org, or on Debian: apt-get install nodejs npm"
  node -e 'process.exit(Number(process.versions.node.split(".")[0]) < 20 ? 1 : 0)' || give_up "Node 20 or newer is needed; this is $(node --version)."
  step npm "$(sha1sum <"$ROSY_ROOT/package-lock.json")" "Installing the packages of the page." install_node
}
# Not `npm ci`: it wants the lock file to list the builds of esbuild and Biome for every system there is, and a registry
# mirror need not have them all. The versions are the lock file's all the same, and it is left as it is.
install_node() { (cd "$ROSY_ROOT" && npm install --no-save --no-audit --no-fund --fetch-retries=5); }

need_codegen() {
  need_node
  step codegen "$(fingerprint codegen/src codegen/package.json package-lock.json)" "Building the conversions between blocks and Haskell." build_codegen
}
build_codegen() { (cd "$ROSY_ROOT" && npm run -s build -w codegen); }

need_page() {
  need_node
  need_api_docs
  step page "$(fingerprint codegen/src editor examples/teleop package-lock.json)" "Building the page." build_page
}
need_api_docs() {
  step api-docs "$(fingerprint rosy-hs/src scripts/api_docs.py scripts/api_docs.css editor/src/styles/tokens.css package-lock.json)" \
    "Building the page that explains every name of the language." build_api_docs
}
build_api_docs() {
  "$ROSY_PYTHON" "$ROSY_ROOT/scripts/api_docs.py" "$ROSY_STATE/api-docs" && compress "$ROSY_STATE/api-docs"
}
build_page() { (cd "$ROSY_ROOT" && npm run -s build -w editor) && compress "$ROSY_ROOT/editor/dist"; }

# compress FOLDER: a gzip beside every file that gains by it; the service sends that one (rosy_sim/pages.py).
compress() { find "$1" -type f -regex '.*\.\(html\|js\|css\|svg\|wasm\)' -size +1k -exec gzip -9 -k -f {} +; }

need() {
  local what
  for what in "$@"; do
    case "$what" in
      runtime) need_python && need_haskell ;;
      codegen) need_codegen ;;
      page) need_codegen && need_page ;;
      robot) need_robot ;;
      builder) need_builder ;;
      tools)
        # shellcheck disable=SC2086
        need_apt tools $APT_TOOLS
        need_python && need_node
        ;;
    esac
  done
}
