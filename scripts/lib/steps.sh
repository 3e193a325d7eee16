# shellcheck shell=bash
# Sourced by ./rosy: messages, and steps that are done once and remembered.
#
# A step has a stamp under .rosy/stamps with a fingerprint of its inputs. A step whose stamp still fits and whose result is
# still there is skipped. The stamp is written last, so an interrupted step is done again. A lock file keeps two commands
# from doing the same step at once. Logs are in .rosy/log.

# say TEMPLATE [NAME VALUE]...
say() { note "$(sentence "$@")"; }
note() { printf '\033[2m•\033[0m %s\n' "$1" >&2; }

# fingerprint PATH...: names, sizes and times of all files below, as one word. A path that does not exist holds no files.
fingerprint() {
  (cd "$ROSY_ROOT" && { find "$@" \
    \( -name node_modules -o -name dist -o -name dist-newstyle -o -name __pycache__ -o -name .venv -o -name '.*_cache' \) -prune \
    -o -type f -printf '%p %s %T@\n' 2>/dev/null || true; } | LC_ALL=C sort | sha1sum | cut -d' ' -f1)
}
checksum() { cat "$@" | sha1sum | cut -d' ' -f1; }

# step NAME FINGERPRINT SENTENCE COMMAND...: runs the command unless the stamp and the result say that it is done.
step() {
  local name=$1 print=$2 lock
  is_done "$name" "$print" && return 0
  exec {lock}>"$ROSY_STATE/turn"
  if command -v flock >/dev/null && ! flock -n "$lock"; then
    say "Another ./rosy is installing or building here. This one goes on when that one is done."
    flock "$lock"
  fi
  ! is_needed "$name" "$print" || perform "$@"
  exec {lock}>&-
}
is_done() {
  local stamp="$ROSY_STATE/stamps/$1"
  [ -f "$stamp" ] && [ "$(<"$stamp")" = "$2" ] && made "$1"
}
perform() {
  local name=$1 print=$2 sentence=$3 log="$ROSY_STATE/log/$1.log" started=$SECONDS status=0
  shift 3
  rm -f "$ROSY_STATE/stamps/$name"
  if [ -t 2 ]; then
    # In the background, so that the bar can move. The shell's own Ctrl-C handling ends the step with it.
    "$@" >"$log" 2>&1 </dev/null &
    show_progress $! "$name" "$sentence" || status=$?
  else
    note "$sentence"
    "$@" >"$log" 2>&1 </dev/null || status=$?
  fi
  if [ "$status" != 0 ]; then
    tail -n 25 "$log" >&2
    give_up "this step failed: {step} The whole log is in {file}." step "$sentence" file ".rosy/log/$name.log"
  fi
  printf '%s' "$print" >"$ROSY_STATE/stamps/$name"
  seconds_done=$((seconds_done + $(seconds_of "$name")))
  [ $((SECONDS - started)) -lt 3 ] || note "  $(sentence "done in {seconds} s" seconds "$((SECONDS - started))")"
}

# steps_for PART...: the steps behind the parts, in order.
steps_for() {
  local part
  for part in "$@"; do
    case "$part" in
      runtime) echo apt-runtime venv compiled haskell ;;
      robot) echo robot ;;
      builder) echo builder ;;
      codegen) echo node npm codegen ;;
      language-server) echo venv node npm codegen api-docs ;;
      # The names of the language are explained by a page made with Python.
      page) echo venv node npm codegen api-docs page ;;
      cluster) echo venv-cluster ;;
      ros2) echo venv ros2 ;;
      packager) echo venv packager ;;
      tools) echo apt-tools venv venv-tools packager node npm-tools "$(! takes_npm_chromium || echo chromium)" ;;
    esac
  done
}

# What each step takes, for the estimate and the bar: seconds on two cores, megabytes downloaded, megabytes on disk.
# Measured on Debian 12 with empty caches.
cost_of() {
  case "$1" in
    apt-runtime) echo 70 134 1093 ;;
    apt-tools) echo 60 201 780 ;;
    venv) echo 15 15 56 ;;
    venv-tools) echo 20 45 186 ;;
    venv-cluster) echo 40 90 330 ;;
    ros2) echo 11 37 113 ;;
    packager) echo 5 1 7 ;;
    node) echo 10 58 207 ;;
    npm) echo 20 62 147 ;;
    npm-tools) echo 25 100 291 ;;
    chromium) echo 15 69 210 ;;
    compiled) echo 45 20 2 ;;
    haskell) echo 100 0 45 ;;
    robot) echo 60 0 50 ;;
    builder) echo 15 0 5 ;;
    codegen) echo 4 0 5 ;;
    api-docs) echo 3 0 1 ;;
    page) echo 15 0 8 ;;
    *) echo 1 0 0 ;;
  esac
}
seconds_of() { read -r s _ < <(cost_of "$1") && echo "$s"; }

seconds_planned=0
seconds_done=0

# show_progress PID STEP SENTENCE: a bar over all planned steps until the process ends; its exit status.
# The bar follows the estimate and never reaches the end of a step before the step does.
show_progress() {
  local pid=$1 sentence=$3 expected began=$SECONDS part total width=24 filled status=0
  expected=$(seconds_of "$2")
  total=$((seconds_planned > seconds_done + expected ? seconds_planned : seconds_done + expected))
  while kill -0 "$pid" 2>/dev/null; do
    part=$((SECONDS - began < expected ? SECONDS - began : expected))
    filled=$((width * (seconds_done + part) / total))
    printf '\r\033[K[%-*s] %3d %%  %s' "$width" "$(printf '%*s' "$filled" '' | tr ' ' '#')" $((100 * (seconds_done + part) / total)) "$sentence" >&2
    sleep 0.3
  done
  wait "$pid" || status=$?
  printf '\r\033[K' >&2
  return "$status"
}
