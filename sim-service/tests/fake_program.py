"""
A program's end of the robot link, played from a script: well-behaved, late, garbled, lying or dead.

A script is words; each is one behaviour, with ``@N`` for the step in which it happens, or ``@touch`` for the one in
which the robot is touched:

    drive:0.5   velocity every fifth step          say:hi@3    a Say in step 3
    turn:1.0    the turning part of it             sound:4@3   a sound in step 3
    bump        reverse after a bumper press       led:2@3     LED 1 in step 3
    done@N      ends well in step N                error@N     ends with an error in step N
    hang@N      never settles step N               close@N     closes the link in step N
    garble@N    sends what is no line              lie@N       settles another step
    flood@N     sends commands without end         long@N      sends a line without end
    deaf        ignores `stop`                     mute        never sends `ready`
    drip        sends byte by byte             count       remembers the step, and tells it when asked
    tour        ahead, turning, back, an arc, each for a second, again and again
    fight       `hold` overrides `move`        tell        tells a firing a step when asked
"""

from __future__ import annotations

import contextlib
import json
import os
import socket
import time
from typing import Any

TWIST = "/mobile_base/commands/velocity"

TOUR = [(0.3, 0.0), (0.0, 1.0), (-0.2, 0.0), (0.0, -1.5), (0.3, 0.5)]
"""m/s and rad/s."""

TOUCH = -1
"""The step in which the robot is touched, whenever that is."""


class Script:
    """The words of a script."""

    def __init__(self, text: str) -> None:
        self.touched = False
        self._words: dict[str, tuple[str, int]] = {}
        for word in text.split():
            body, _, step = word.partition("@")
            name, _, value = body.partition(":")
            self._words[name] = (value, TOUCH if step == "touch" else int(step) if step else 0)

    def has(self, name: str) -> bool:
        return name in self._words

    def value(self, name: str, default: str = "") -> str:
        return self._words.get(name, (default, 0))[0]

    def now(self, name: str, step: int) -> bool:
        when = self._words[name][1] if name in self._words else None
        return when == step or (when == TOUCH and self.touched)


def publish(topic: str, msg: dict[str, Any]) -> dict[str, Any]:
    return {"op": "publish", "topic": topic, "msg": msg}


def play(link: socket.socket, text: str) -> None:
    """Play a script until the link ends."""
    with contextlib.suppress(OSError):
        _Player(link, Script(text)).run()
    link.close()


class _Player:
    def __init__(self, link: socket.socket, script: Script) -> None:
        self.link, self.script = link, script
        self.backwards = False
        self.trace = False

    def send(self, *messages: dict[str, Any]) -> None:
        data = b"".join(json.dumps(m).encode() + b"\n" for m in messages)
        if self.script.has("drip"):
            for i in range(len(data)):
                self.link.sendall(data[i : i + 1])
        else:
            self.link.sendall(data)

    def run(self) -> None:
        for line in self.link.makefile("rb"):
            message = json.loads(line)
            match message["op"]:
                case "start":
                    self.trace = message["trace"]
                    if not self.script.has("mute"):
                        self.send(
                            {"op": "advertise", "topic": TWIST, "type": "geometry_msgs/Twist"},
                            {"op": "subscribe", "topic": "/odom", "type": "nav_msgs/Odometry"},
                            {"op": "ready"},
                        )
                case "publish":
                    if message["topic"].endswith("bumper") and message["msg"]["state"] and self.script.has("bump"):
                        self.backwards = True
                    self.script.touched = self.script.touched or "/events/b" in message["topic"]
                case "step":
                    if not self.step(message["step"], message.get("memory", False), message.get("firings", False)):
                        return
                case "stop":
                    if not self.script.has("deaf"):
                        self.send(self.velocity(0.0, 0.0), self.ended(how="stopped"))
                        return

    def velocity(self, linear: float, angular: float) -> dict[str, Any]:
        return publish(TWIST, {"linear": {"x": linear}, "angular": {"z": angular}})

    def ended(self, fired: list[str] | None = None, **how: Any) -> dict[str, Any]:
        told = {"events": [], "commands": ["Velocity 0.0 0.0"]} if self.trace else {}
        return {"op": "ended", "fired": fired or [], **told, **how}

    def step(self, step: int, asked: bool, observed: bool) -> bool:
        script = self.script
        commands: list[dict[str, Any]] = []
        if step % 5 == 0 and (script.has("drive") or script.has("turn")):
            linear = float(script.value("drive", "0"))
            commands.append(self.velocity(-linear if self.backwards else linear, float(script.value("turn", "0"))))
        if step % 5 == 0 and script.has("tour"):
            commands.append(self.velocity(*TOUR[step // 50 % len(TOUR)]))
        if script.now("say", step):
            commands.append(publish("/rosy/say", {"data": script.value("say")}))
        if script.now("sound", step):
            commands.append(publish("/mobile_base/commands/sound", {"value": int(script.value("sound"))}))
        if script.now("led", step):
            commands.append(publish("/mobile_base/commands/led1", {"value": int(script.value("led"))}))
        if script.now("done", step):
            self.send(*commands, self.velocity(0.0, 0.0), self.ended(how="done", fired=["script"]))
            return False
        if script.now("error", step):
            problem = {
                "severity": "error", "kind": "exception", "function": "move", "time": step / 50,
                "message": "`move` divided by zero.", "hint": "", "ghc": "divide by zero",
            }  # fmt: skip
            self.send(self.velocity(0.0, 0.0), self.ended(how="error", problem=problem))
            return False
        if script.now("hang", step):
            time.sleep(3600)
        if script.now("close", step):
            return False
        if script.now("garble", step):
            self.link.sendall(os.urandom(200) + b"\n")
        if script.now("lie", step):
            self.send({"op": "settled", "step": step + 7, "fired": []})
        if script.now("flood", step):
            while True:
                self.send(*[self.velocity(1.0, 0.0)] * 100)
        if script.now("long", step):
            while True:
                self.link.sendall(b"x" * 65536)
        settled: dict[str, Any] = {"op": "settled", "step": step, "fired": ["move"] * len(commands)}
        if script.has("fight") and commands:
            # Both fire in the same step, and what the second one sends stays in force.
            settled |= {"fired": ["move", "hold"], "sent": [len(commands), 1]}
            commands.append(self.velocity(0.0, 0.0))
        if self.trace:
            settled |= {"events": [], "commands": []}
        if asked and script.has("count"):
            settled["memory"] = [{"type": "Memory Int", "value": str(step)}]
        if observed and script.has("tell"):
            cause = {"by": "tick", "instant": step}
            took = [{"from": "time", "value": f"Seconds {step}"}]
            gave = [{"to": "command", "type": "Velocity", "value": "Velocity 0.5 0.0"}]
            if self.trace:
                settled["commands"] = [gave[0]["value"]]
            settled["firings"] = [{"n": step, "function": "f", "task": 0, "cause": cause, "took": took, "gave": gave}]
        self.send(*commands, settled)
        return True
