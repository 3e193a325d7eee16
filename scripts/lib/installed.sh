# shellcheck shell=bash
# Sourced by ./rosy in an installed tree (scripts/installation): everything is built, and nothing is written there.
#
# A folder on a stick also holds Python, GHC's libraries and bubblewrap; a Debian package uses those of the system.

if [ "$(locale charmap 2>/dev/null)" != UTF-8 ]; then
  # A locale that is not installed, or has another encoding, still names the language (sim-service/rosy_sim/sentences/wording.py).
  export ROSY_LOCALE="${LC_ALL:-${LC_MESSAGES:-${LANG:-}}}" LC_ALL=C.UTF-8
fi
export PYTHONPATH="$ROSY_ROOT/sim-service:$ROSY_ROOT/python"
export PYTHONNOUSERSITE=1 PYTHONDONTWRITEBYTECODE=1
ROSY_PYTHON=/usr/bin/python3
if [ -d "$ROSY_ROOT/python-home" ]; then
  ROSY_PYTHON="$ROSY_ROOT/python-home/bin/python3"
  export PYTHONHOME="$ROSY_ROOT/python-home"
  export PATH="$ROSY_ROOT/bin:$PATH"
  # Every library has one folder: a second copy under another path would be loaded a second time.
  ROSY_LIBRARIES="$ROSY_ROOT/lib:$ROSY_ROOT/python-home/lib$(find "$ROSY_ROOT/ghc" -name '*.so' -printf ':%h\n' | sort -u | tr -d '\n')"
  export ROSY_LIBRARIES ROSY_LIBDIR="$ROSY_ROOT/ghc"
  export LD_LIBRARY_PATH="$ROSY_LIBRARIES"
fi
export ROSY_PYTHON

need() {
  case " $* " in
    *" tools "*)
      give_up "this is an installed Rosy. Tests and benchmarks need its source: git clone it, and run ./rosy there."
      ;;
    *" cluster "*)
      give_up "this is an installed Rosy. A cluster needs its source: git clone it, and run ./rosy there."
      ;;
    *" ros2 "*)
      give_up "this is an installed Rosy. A robot on ROS 2 needs its source: git clone it, and run ./rosy there. Or use rosbridge: ws://HOST:9090."
      ;;
    *" builder "*)
      if [ -d "$ROSY_ROOT/python-home" ]; then
        give_up "programs for a robot's computer cannot be built from a stick. Install Rosy on this machine for that."
      fi
      ;;
    *" codegen "*)
      if ! command -v node >/dev/null; then
        give_up "this command needs Node: {command}" command "sudo apt install nodejs"
      fi
      ;;
  esac
}
