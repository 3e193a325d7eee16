"""
Programs of the benchmarks, by how often they are asked: at pauses and events only, ten times a second, in each step.
"""

from __future__ import annotations

__all__ = ["BACK_OFF", "EACH_STEP", "MOVE", "PATROL", "SPEED_UP"]

BACK_OFF = """backOff :: Bumper -> Velocity
backOff (Bumper _ Pressed) = Velocity (-0.1) 0.4
backOff _ = Velocity 0.2 0.1

main = simulate (backOff, start)

start :: RobotStatus -> Velocity
start _ = Velocity 0.2 0.1
"""

PATROL = """patrol :: Task ()
patrol = forever (do { once (Velocity 0.3 0); wait 2; once (Velocity 0 0.8); wait 2 })

main = simulate patrol
"""

MOVE = """move :: Velocity
move = Velocity 0.1 0.1

main = simulate move
"""

EACH_STEP = """accelerate :: Velocity -> Velocity
accelerate (Velocity v w) = Velocity (v * 0.5 + 0.05) 0.1

main = simulate accelerate
"""

SPEED_UP = """accelerate :: Velocity -> Velocity
accelerate (Velocity v w) = Velocity (v + 0.3) 0.4

main = simulate accelerate
"""
