# SPDX-License-Identifier: GPL-3.0-or-later
# Sourced by what looks at Blender's window: starts it on a display of its own, talks to it in Python, points and types.
# Wants $home (a folder of its own), BLENDER_USER_SCRIPTS and the add-on in place.
# shellcheck shell=bash

window_pids=()

# window_open WIDTH HEIGHT: a display and a Blender that fills it.
window_open() {
  local number
  Xvfb -displayfd 3 -screen 0 "$1x$2x24" -nolisten tcp 3>"$home/display" >/dev/null 2>&1 &
  window_pids+=($!)
  for _ in $(seq 100); do
    number=$(cat "$home/display" 2>/dev/null || true)
    [ -n "$number" ] && break
    sleep 0.1
  done
  export DISPLAY=:$number
  cat >"$home/listen.py" <<'END'
import os, sys, traceback
import bpy
bpy.context.preferences.view.show_splash = False
bpy.context.preferences.system.viewport_aa = "OFF"
home = os.environ["DUCTUS_WINDOW"]
place = {"bpy": bpy}
def listen():
    path = os.path.join(home, "command")
    if os.path.exists(path):
        text = open(path).read()
        os.remove(path)
        try:
            exec(text, place)
            answer = str(place.pop("answer", ""))
        except BaseException:
            answer = "failed\n" + traceback.format_exc()
        with open(path + ".new", "w") as file:
            file.write(answer)
        os.rename(path + ".new", os.path.join(home, "answer"))
    return 0.05
bpy.app.timers.register(listen, persistent=True)
END
  DUCTUS_WINDOW=$home blender --factory-startup -p 0 0 "$1" "$2" --addons ductus_addon --python "$home/listen.py" \
    >"$home/blender.log" 2>&1 </dev/null &
  window_pids+=($!)
  tell "pass" || { cat "$home/blender.log"; return 1; }
}

# tell CODE: runs Python in Blender; prints what it leaves in `answer`. Fails where the code does.
tell() {
  rm -f "$home/answer"
  printf '%s\n' "$1" >"$home/command.new"
  mv "$home/command.new" "$home/command"
  for _ in $(seq 600); do
    if [ -e "$home/answer" ]; then
      cat "$home/answer"
      ! head -n 1 "$home/answer" | grep -qx failed
      return
    fi
    sleep 0.1
  done
  echo "Blender does not answer"
  cat "$home/blender.log"
  return 1
}

# wait_for EXPRESSION: until it is true in Blender, at most a minute.
wait_for() {
  for _ in $(seq 120); do
    [ "$(tell "answer = bool($1)")" = True ] && return
    sleep 0.5
  done
  echo "never true: $1"
  return 1
}

# settle: until Blender has seen what was pointed and typed, and has drawn what follows from it: between two answers lies
# a whole turn of its main loop. Without a graphics card it is slow.
settle() {
  sleep 0.1
  for _ in 1 2 3; do
    tell "pass" >/dev/null
  done
}

# click X Y, type_keys KEY...: as a user would.
click() {
  # Blender looks where the pointer is when it moves: a step beside the place, then onto it.
  xdotool mousemove "$(($1 - 4))" "$(($2 + 4))"
  settle
  xdotool mousemove "$1" "$2"
  settle
  xdotool mousedown 1
  settle
  xdotool mouseup 1
  settle
}
type_keys() {
  xdotool key "$@"
  settle
}

# photograph FILE: what is on the display.
photograph() {
  settle
  import -window root -silent "$1"
}

window_close() {
  local pid
  for pid in "${window_pids[@]}"; do
    kill "$pid" 2>/dev/null || true
  done
  for pid in "${window_pids[@]}"; do
    wait "$pid" 2>/dev/null || true
  done
  window_pids=()
}
