# shellcheck shell=bash
# Sourced by ./rosy: checks, in about a second and before anything is installed, whether all steps can succeed.
#
# In: the names of the steps that are still to be done (`pending`). Out: nothing when all is well; otherwise one list of
# what is missing, each with the command that fixes it on this system, and exit 1. Then one line that estimates time and
# download. Without network a page that only is to be built again stays as it is (`keeps_page`). Nothing is changed on the machine.

# GHC versions for which the worker is built and tested.
GHC_SUPPORTED="9.0 9.4 9.6 9.10"

missing=()
lacks() { missing+=("$1"$'\n'"      $2"); } # lacks SENTENCE COMMAND

root_prefix() { if [ "$(id -u)" = 0 ]; then :; else printf 'sudo '; fi; }

# The folder itself, before anything is written to it.
check_folder() {
  if [ ! -w "$ROSY_ROOT" ] || { [ -e "$ROSY_STATE" ] && [ ! -w "$ROSY_STATE" ]; }; then
    give_up "the folder {folder} cannot be written by {user}. Copy it to a folder of your own and start there: {command}" \
      folder "$ROSY_ROOT" user "$(id -un)" command "cp -r '$ROSY_ROOT' ~/rosy && ~/rosy/rosy start"
  fi
}

check_system() {
  if [ "$(uname -s)" != Linux ]; then
    lacks "$(sentence "Rosy runs on Debian and Ubuntu; this is {system}." system "$(uname -s)")" "$(sentence "On Windows use WSL2; on macOS use a Debian in a virtual machine.")"
  elif ! command -v apt-get >/dev/null || ! command -v dpkg-query >/dev/null; then
    [ -z "$apt_pending" ] || lacks "$(sentence "This system has no apt to install packages with.")" \
      "$(sentence "Install by its own means what these Debian packages hold: {packages}" packages "$apt_pending")"
  fi
}

# The first Python that is new enough; empty when there is none.
find_python() {
  local candidate
  for candidate in python3 python3.14 python3.13 python3.12 python3.11; do
    if command -v "$candidate" >/dev/null && "$candidate" -c 'import sys; sys.exit(sys.version_info < (3, 11))' 2>/dev/null; then
      echo "$candidate"
      return
    fi
  done
}

check_python() {
  local python
  python=$(find_python)
  if [ -z "$python" ]; then
    local sentence
    sentence=$(sentence "Python 3.11 or newer is needed; there is none.")
    if command -v python3 >/dev/null; then sentence=$(sentence "Python 3.11 or newer is needed; this is {version}." version "$(python3 --version 2>&1 || true)"); fi
    lacks "$sentence" "$(root_prefix)apt-get install python3.11 python3.11-venv"
  elif ! "$python" -c 'import ensurepip' 2>/dev/null && [ -z "$apt_can_install" ]; then
    lacks "$(sentence "Python's venv module is needed.")" "$(root_prefix)apt-get install $("$python" -c 'import sys; print("python3.%d-venv" % sys.version_info[1])')"
  fi
}

check_ghc() {
  local version
  if command -v ghc >/dev/null; then
    version=$(ghc --numeric-version 2>/dev/null || true)
  else
    version=$(LC_ALL=C apt-cache policy ghc 2>/dev/null | sed -n 's/^ *Candidate: *\([0-9]*:\)\?\([0-9.]*\).*/\2/p' || true)
    if [ -z "$version" ]; then
      # A new system may have no lists of packages yet; they are fetched before the first installation.
      [ -z "$apt_pending" ] || ! compgen -G "/var/lib/apt/lists/*_Packages*" >/dev/null || lacks "$(sentence "apt knows no package {name}." name ghc)" "$(root_prefix)apt-get update"
      return
    fi
  fi
  case " $GHC_SUPPORTED " in
    *" ${version%.*} "*) ;;
    *) lacks "$(sentence "This system has GHC {version}; Rosy knows GHC {versions}." version "$version" versions "$GHC_SUPPORTED")" "$(sentence "Use Debian 12 or Ubuntu 24.04, or a newer Rosy.")" ;;
  esac
}

# The name of a system whose own GHC and Python are too old, where no newer GHC was put.
old_system() {
  local release="${ROSY_OS_RELEASE:-/etc/os-release}" id version oldest
  if [ ! -r "$release" ] || command -v ghc >/dev/null; then return; fi
  id=$(sed -n 's/^ID="\?\([a-z]*\)"\?$/\1/p' "$release")
  version=$(sed -n 's/^VERSION_ID="\?\([0-9.]*\)"\?$/\1/p' "$release")
  case "$id" in debian) oldest=12 ;; ubuntu) oldest=24.04 ;; *) return ;; esac
  # Debian testing has no version.
  if [ -n "$version" ] && [ "$(printf '%s\n' "$version" "$oldest" | sort -V | head -n 1)" != "$oldest" ]; then
    sed -n 's/^PRETTY_NAME="\?\([^"]*\)"\?$/\1/p' "$release"
  fi
}

check_rights() {
  apt_can_install=yes
  [ -n "$apt_pending" ] && [ "$(id -u)" != 0 ] || return 0
  if ! command -v sudo >/dev/null; then
    apt_can_install=
    lacks "$(sentence "Debian packages are missing, and there is no sudo to install them with.")" "$(sentence "as root: {command}" command "apt-get install --no-install-recommends $apt_pending")"
  fi
}

# check_disk MEGABYTES
check_disk() {
  local free
  free=$(df -Pm "$ROSY_ROOT" 2>/dev/null | awk 'NR == 2 {print $4}')
  if [ -n "$free" ] && [ "$free" -lt "$1" ]; then
    lacks "$(sentence "About {needed} MB of disk space are needed at {folder}; {free} MB are free." needed "$1" folder "$ROSY_ROOT" free "$free")" \
      "$(sentence "{command}; or use a larger disk" command "$(root_prefix)apt-get clean")"
  fi
}

# check_port PORT: a port in use would end the start after all the work.
check_port() {
  if [ "$1" != 0 ] && (exec 3<>"/dev/tcp/127.0.0.1/$1") 2>/dev/null; then
    give_up "port {port} is in use, perhaps by another Rosy. Use another one: {command}" port "$1" command "./rosy start --port $(($1 + 1))"
  fi
}

# Servers that the pending steps download from, as this machine's own settings name them.
servers() {
  [ -z "$apt_pending" ] || cat /etc/apt/sources.list /etc/apt/sources.list.d/*.list /etc/apt/sources.list.d/*.sources 2>/dev/null |
    sed -nE 's/^(deb|URIs:)[^#]*[[:space:]](https?:\/\/[^[:space:]]+).*/\2/p' | head -n 1
  case " $pending " in *" venv"* | *" node "*) python_index ;; esac
  case " $pending " in *" npm"*) ! command -v npm >/dev/null || npm config get registry 2>/dev/null ;; esac
}

# The package index that pip is set up with, or its default.
python_index() {
  if [ -n "${PIP_INDEX_URL:-}" ]; then
    echo "$PIP_INDEX_URL"
    return
  fi
  local python wheels
  python=$(find_python)
  # Debian's Python has no pip of its own, only the wheel that a new environment gets.
  wheels=$("$python" -c 'import ensurepip, glob, os; print(":".join(glob.glob("/usr/share/python-wheels/pip-*.whl") + glob.glob(os.path.dirname(ensurepip.__file__) + "/_bundled/pip-*.whl")))' 2>/dev/null) || wheels=
  PYTHONPATH="$wheels" "$python" -m pip config get global.index-url 2>/dev/null ||
    PYTHONPATH="$wheels" "$python" -c 'from pip._internal.models.index import PyPI; print(PyPI.url)' 2>/dev/null
}

# Servers that cannot be found or reached, and those whose certificate this machine does not know, with "!" before them.
# Any answer of a server will do. curl(1), EXIT CODES.
check_network() {
  local server status answer=(curl --silent --location --head --output /dev/null --connect-timeout 2 --max-time 4)
  command -v curl >/dev/null || return 0
  while read -r server; do
    status=0
    "${answer[@]}" "$server" || status=$?
    if [ "$status" = 60 ] && [ -n "${NODE_EXTRA_CA_CERTS:-}" ]; then
      status=0
      "${answer[@]}" --cacert "$NODE_EXTRA_CA_CERTS" "$server" || status=$?
    fi
    case "$status" in
      5 | 6 | 7 | 28) echo "$server" ;;
      60) echo "!$server" ;;
    esac
  done
}

# page_can_stay: whether the steps only build anew what is there, and the command has all that it runs on.
page_can_stay() {
  local step
  for step in $pending; do
    case "$step" in node | npm) ;; codegen | api-docs | page) made "$step" || return 1 ;; *) return 1 ;; esac
  done
  [ -z "$runs_node" ] || command -v node >/dev/null
}

# preflight STEPS PORT: `apt_pending` holds the Debian packages that are missing.
preflight() {
  pending=$1
  local port=$2 seconds=0 download=0 disk=0 s d m step network offline unknown old=
  for step in $pending; do
    read -r s d m < <(cost_of "$step")
    seconds=$((seconds + s)) download=$((download + d)) disk=$((disk + m))
  done
  # The slow question runs beside the others.
  exec 4< <(if [ "$download" -gt 0 ]; then servers | sort -u | check_network; fi)
  check_system
  check_rights
  case " $pending " in *" haskell "*) old=$(old_system) ;; esac
  if [ -n "$old" ]; then
    lacks "$(sentence "The GHC of {system} is older than Rosy needs." system "$old")" "$(sentence "Use Debian 12 or Ubuntu 24.04, or a newer one.")"
  else
    check_python
    case " $pending " in *" haskell "*) check_ghc ;; esac
  fi
  check_disk "$disk"
  network=$(cat <&4)
  exec 4<&-
  offline=$(sed '/^!/d' <<<"$network" | tr '\n' ' ' | sed 's/^ *$//')
  unknown=$(sed -n 's/^!//p' <<<"$network" | tr '\n' ' ')
  keeps_page=""
  if [ -n "$offline" ] && page_can_stay; then
    # shellcheck disable=SC2034  # read by setup.sh
    keeps_page=yes
    seconds=0
    say "The page is the one of the last build: to build it again, {megabytes} MB are to be downloaded, and {servers} cannot be reached." megabytes "$download" servers "${offline% }"
    offline=""
  fi
  [ -z "$offline" ] || lacks "$(sentence "There is no way to the network: {servers} cannot be reached, and {megabytes} MB are to be downloaded." servers "${offline% }" megabytes "$download")" \
    "$(sentence "Connect this machine, or set https_proxy, and try again.")"
  [ -z "$unknown" ] || lacks "$(sentence "The certificate of {servers} is not known to this machine; a school's proxy may have put its own in its place." servers "${unknown% }")" \
    "$(sentence "Ask for the proxy's certificate, and name its file: {command}" command "NODE_EXTRA_CA_CERTS=FILE.crt PIP_CERT=FILE.crt ./rosy start")"
  if [ "${#missing[@]}" -gt 0 ]; then
    printf 'rosy: %s\n' "$(sentence "this is missing:")" >&2
    printf '  - %s\n' "${missing[@]}" >&2
    exit 1
  fi
  [ -z "$port" ] || check_port "$port"
  # shellcheck disable=SC2034  # read by steps.sh
  seconds_planned=$seconds
  if [ "$seconds" -ge 20 ]; then
    local minutes=$(((seconds + 59) / 60)) duration
    duration=$(sentence "about {minutes} minutes" minutes "$minutes")
    [ "$minutes" != 1 ] || duration=$(sentence "about a minute")
    if [ "$download" -gt 0 ]; then
      say "First some work: {duration}, {megabytes} MB to download." duration "$duration" megabytes "$download"
    else
      say "First some work: {duration}, nothing to download." duration "$duration"
    fi
  fi
}
