#!/usr/bin/env bash
# Kills or stops (SIGSTOP, every third) random processes of a running community, and looks at what is left: does the launcher bring them
# back, does the mission end in a declared state, can every log be read?
# usage: tests/soak/kill_apps.sh [kills=50] [mission=missions/table1] [bin=build/bin] [warp=10] [seed=1]
set -uo pipefail
cd "$(dirname "$0")/../.."
kills=${1:-50} mission=${2:-missions/table1} bin=${3:-build/bin} warp=${4:-10} seed=${5:-1}
patience=1800  # [s] for the mission to end after the last kill
RANDOM=$seed
run=$(mktemp -d)
port=$((20000 + $$ % 10000))
"$bin/limpet" launch "$mission/mission.moos" --MOOSTimeWarp="$warp" --deploy --until=MISSION_END --run_folder="$run" --seed="$seed" --ServerPort=$port \
  >"$run/launch.out" 2>&1 &
launcher=$!
trap 'kill -TERM $launcher 2>/dev/null' EXIT
sleep 5
killed=0
while ((killed < kills)) && kill -0 $launcher 2>/dev/null; do
  sleep "$((RANDOM % 3)).$((RANDOM % 10))"
  mapfile -t children < <(pgrep -P $launcher)
  ((${#children[@]})) || continue
  victim=${children[RANDOM % ${#children[@]}]}
  name=$(cat "/proc/$victim/comm" 2>/dev/null) || continue
  signal=KILL
  ((killed % 3 == 2)) && signal=STOP
  kill -$signal "$victim" && killed=$((killed + 1)) && echo "$SECONDS s: $name got SIG$signal"
done
until ! kill -0 $launcher 2>/dev/null || ((SECONDS > patience)); do sleep 1; done
if kill -0 $launcher 2>/dev/null; then
  echo "FAILED: the mission did not end within $patience s; $run"
  exit 1
fi
wait $launcher
echo "killed $killed; launcher's exit code $?; its last words:"
tail -n 3 "$run/launch.out"
unreadable=0
while read -r log; do
  "$bin/limpet" log scan "$log" >"$run/scan.out" 2>&1 || { echo "unreadable: $log"; unreadable=1; }
done < <(find "$run" -name '*.alog')
find "$run" -name '*.alog' -exec awk '$2 == "MISSION_END"' {} +
((unreadable == 0)) && echo "every log can be read: $(find "$run" -name '*.alog' | wc -l)" || exit 1
