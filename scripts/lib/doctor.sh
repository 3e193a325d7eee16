# shellcheck shell=bash
# Sourced by ./rosy: what works here, also where nothing is installed yet. Nothing is changed on the machine.

ask_doctor() {
  local step needed=0 megabytes
  [ $# = 0 ] || give_up "{command} takes nothing." command doctor
  # shellcheck source=scripts/lib/preflight.sh
  source "$ROSY_ROOT/scripts/lib/preflight.sh"
  # shellcheck source=scripts/lib/steps.sh
  source "$ROSY_ROOT/scripts/lib/steps.sh"
  if [ -e "$ROSY_ROOT/.installed" ]; then
    # shellcheck source=scripts/lib/installed.sh
    source "$ROSY_ROOT/scripts/lib/installed.sh"
  else
    ROSY_PYTHON="$ROSY_ROOT/.rosy/venv/bin/python"
    [ -x "$ROSY_PYTHON" ] || ROSY_PYTHON=$(find_python)
    export ROSY_PYTHON PYTHONPATH="$ROSY_ROOT/sim-service"
  fi
  [ -n "$ROSY_PYTHON" ] || give_up "Python 3.11 or newer is needed; there is none."
  for step in $(steps_for runtime page); do
    read -r _ _ megabytes < <(cost_of "$step")
    needed=$((needed + megabytes))
  done
  # shellcheck disable=SC2086
  exec "$ROSY_PYTHON" -m rosy_sim.doctor "$needed" $GHC_SUPPORTED
}
