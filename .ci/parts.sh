# Parts of a check with their times; sourced by .ci/run and .ci/nightly.
#   part NAME COMMAND...   runs the command, and continues after a failure
#   part_within MINUTES NAME COMMAND...
#                          the same if MINUTES more keep the whole run below 40; otherwise, or if it
#                          has not ended by then, it says so, and counts as neither
#   finish                 prints the failures and "N passed, N failed"; returns 1 after a failure
passed=0
failed=0
failures=()
mkdir -p build

part() {
  local name=$1 began=$SECONDS log=build/part.log status=0 counts wrong=0
  shift
  echo "== $name: $*"
  "$@" 2>&1 | tee "$log" || status=$?
  if [ "$status" -eq 124 ]; then  # of `timeout`
    echo "== $name: left out, it had not ended after $((SECONDS - began)) s; run by hand: $*"
    return
  fi
  # CTest's tests count one by one, every other part as one.
  counts=$(sed -nE 's/^[0-9]+% tests passed, ([0-9]+) tests? failed out of ([0-9]+)$/\1 \2/p' "$log" | tail -n 1)
  if [ -n "$counts" ]; then
    wrong=${counts% *}
    passed=$((passed + ${counts#* } - wrong))
    failed=$((failed + wrong))
  elif [ "$status" -eq 0 ]; then
    passed=$((passed + 1))
  fi
  if [ "$status" -eq 0 ]; then
    echo "== $name passed in $((SECONDS - began)) s"
  else
    echo "== $name FAILED after $((SECONDS - began)) s"
    failures+=("$name")
    [ "$wrong" -gt 0 ] || failed=$((failed + 1))
  fi
}

part_within() {
  local minutes=$1
  shift
  if [ $((SECONDS + 60 * minutes)) -le $((40 * 60)) ]; then
    part "$1" timeout $((60 * minutes)) "${@:2}"
  else
    echo "== $1: left out, it may take $minutes minutes; run by hand: ${*:2}"
  fi
}

finish() {
  [ ${#failures[@]} -eq 0 ] || printf 'Failed: %s\n' "${failures[@]}"
  echo "$passed passed, $failed failed"
  [ "$failed" -eq 0 ]
}
