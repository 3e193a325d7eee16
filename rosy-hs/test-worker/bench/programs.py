"""
Programs whose checks and runs are measured, and the same as Haskell files for the peers.

In: nothing. Out: their texts, and the lines that a robot link sends up to the first step.
"""

from __future__ import annotations

import json

SMALL = """main = simulate (accelerate, play)

accelerate :: Velocity -> Velocity
accelerate (Velocity v w) = Velocity (v + 0.5) w

play :: Bumper -> Maybe Sound
play (Bumper _ Pressed) = Just ErrorSound
play _ = Nothing
"""


FIRST_STEP = b"".join(
    json.dumps(line).encode() + b"\n"
    for line in (
        {"op": "start", "protocol": 1, "seed": 1, "trace": False},
        {
            "op": "publish",
            "topic": "/odom",
            "msg": {
                "pose": {
                    "pose": {
                        "position": {"x": 0, "y": 0},
                        "orientation": {"z": 0, "w": 1},
                    }
                },
                "twist": {"twist": {"linear": {"x": 0}, "angular": {"z": 0}}},
            },
        },
        {"op": "step", "step": 0, "time": 0},
    )
)


OWN_TYPES = ("data Mode = Go | Stop | Turn Double Seconds", "data ChgDir = ChgDir")


def large_program(functions: int = 12) -> str:
    """A program with types, memory and arithmetic, as a pupil's larger program has them: eight lines for each function, and five."""
    parts = [line for own in OWN_TYPES for line in (own, "")]
    for i in range(functions):
        parts += [
            f"step{i} :: Bumper -> Memory Mode -> Seconds -> Either ChgDir (Memory Mode)",
            f"step{i} (Bumper _ Pressed) _ _ = Left ChgDir",
            f"step{i} _ (Memory m) now = Right (Memory (after{i} m))",
            "  where",
            f"    after{i} (Turn a t) | now > t + {i} = Go",
            f"                        | otherwise = Turn (a * {i + 1} / 2) t",
            f"    after{i} other = other",
            "",
        ]
    # The first function fires at the first step.
    parts = [line.replace("step0 :: Bumper", "step0 :: Velocity").replace("step0 (Bumper _ Pressed)", "step0 (Velocity 9 9)") for line in parts]
    parts.append("main = simulate (" + ", ".join(f"step{i}" for i in range(9)) + ")")
    return "\n".join(parts) + "\n"


def as_haskell(source: str) -> str:
    """The same with what the worker adds to the parsed tree."""
    for own in OWN_TYPES:
        name = own.split()[1]
        classes = ("Added.Value", "Default", "Sensor", "Command")
        source = source.replace(
            own,
            "\n".join(
                [
                    f"{own} deriving (Generic)",
                    *(f"instance {c} {name}" for c in classes),
                ]
            ),
        )
    return "{-# LANGUAGE DeriveGeneric, DeriveAnyClass #-}\nmodule Main (main) where\nimport GHC.Generics (Generic)\nimport Rosy\nimport qualified Rosy.Program as Added\n" + source
