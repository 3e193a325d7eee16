"""
Programs in the form of the paper and of both generations of the original site: what is typed, and what is observed.

One row per listing of ``rosy-hs/from-the-paper.md``.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass

import pytest

from rosy_sim.config import discover
from rosy_sim.robots.kobuki.facts import MAX_SPEED
from rosy_sim.worker.blocking_worker import BlockingWorker
from rosy_sim.world.arena import Pose
from rosy_sim.world.events import Press, Teleport, UserAction
from rosy_sim.worlds.gallery import named_world

from .real_runs import Ran, ran, worker_started

pytestmark = [pytest.mark.real, pytest.mark.skipif(not discover().worker, reason="the worker is not built")]


@pytest.fixture(scope="module")
def worker() -> Iterator[BlockingWorker]:
    yield from worker_started()


@dataclass(frozen=True)
class Listing:
    """A program as it is typed, and what is seen when it runs."""

    name: str
    typed: str
    observed: Callable[[Ran], bool]
    room: str = "room"
    seconds: float = 10.0
    hands: tuple[tuple[float, UserAction], ...] = ()


def fastest(run: Ran) -> float:
    return max(float(line["v"]) for line in run.lines)


def slowest(run: Ran) -> float:
    return min(float(line["v"]) for line in run.lines)


def commands(run: Ran) -> list[str]:
    return [command for line in run.lines for command in line["commands"]]


def moved(run: Ran) -> float:
    return math.hypot(run.lines[-1]["x"] - run.lines[0]["x"], run.lines[-1]["y"] - run.lines[0]["y"])


def turned(run: Ran) -> float:
    return math.degrees(run.world.theta - float(run.lines[0]["theta"]))


TURNING = {"Velocity 0.0 1.0", "Velocity 0.0 (-1.0)"}
"""The two velocities with which the random walk turns."""

ACCELERATE = """
accelerate :: Velocity -> Velocity
accelerate (Velocity vl va) = Velocity (vl+0.5) va
"""

PLAY = """
play :: Bumper -> Maybe Sound
play (Bumper _ Pressed)  = Just ErrorSound
play (Bumper _ Released) = Nothing
"""

RANDOM_WALK = """
data Mode = Go | Stop | Turn Double Seconds
data ChgDir = ChgDir

bumper :: Bumper -> (Led1,Maybe ChgDir)
bumper (Bumper _ st) = case st of
  Pressed -> (Led1 Orange,Just ChgDir)
  Released -> (Led1 Black,Nothing)

cliff :: Cliff -> (Led2,Maybe ChgDir)
cliff (Cliff _ st) = case st of
  Hole -> (Led2 Orange,Just ChgDir)
  Floor -> (Led2 Black,Nothing)

wheel :: Wheel -> (Led1,Led2,Memory Mode)
wheel (Wheel _ st) = case st of
  Air -> (Led1 Red,Led2 Red,Memory Stop)
  Ground -> (Led1 Black,Led2 Black,Memory Go)

chgdir :: ChgDir -> StdGen -> Seconds -> Memory Mode
chgdir _ r now = Memory (Turn dir time)
  where (b,r') = random r
        (ang,_) = randomR (0,pi) r'
        dir = if b then 1 else -1
        time = now + doubleToSeconds ang
"""

SPIN = """
spin :: Memory Mode -> Seconds -> VEL
spin (Memory Stop) _ = WRAP (Velocity 0 0)
spin (Memory (Turn dir t)) now | t > now = WRAP (Velocity 0 dir)
spin _ _ = WRAP (Velocity 0.3 0)
"""

SAFETY = """
safetyControl :: Either (Either Bumper Cliff) Wheel -> Maybe VEL
safetyControl (Right (Wheel _ Air)) = Just (WRAP (Velocity 0 0))
safetyControl (Left (Left (Bumper CenterBumper Pressed))) = Just (WRAP (Velocity (-0.1) 0))
safetyControl (Left (Right (Cliff CenterCliff Hole))) = Just (WRAP (Velocity (-0.1) 0))
safetyControl (Left (Left (Bumper LeftBumper Pressed))) = Just (WRAP (Velocity (-0.1) (-0.4)))
safetyControl (Left (Right (Cliff LeftCliff Hole))) = Just (WRAP (Velocity (-0.1) (-0.4)))
safetyControl (Left (Left (Bumper RightBumper Pressed))) = Just (WRAP (Velocity (-0.1) 0.4))
safetyControl (Left (Right (Cliff RightCliff Hole))) = Just (WRAP (Velocity (-0.1) 0.4))
safetyControl _ = Nothing
"""

MUX = """
data M = Start | Ignore Seconds
data M1 a = M1 a
data M2 b = M2 b

mux :: Seconds -> Memory M -> Either (M1 a) (M2 a) -> Maybe (a,Memory M)
mux t _ (Left (M1 a)) = Just (a,Memory (Ignore (t+0.5)))
mux t (Memory (Ignore s)) (Right (M2 a)) | s > t = Nothing
mux t _ (Right (M2 a)) = Just (a,Memory Start)

muxVel :: Seconds -> Memory M -> Either (M1 Velocity) (M2 Velocity) -> Maybe (Velocity,Memory M)
muxVel = mux
"""

TURN = """
type Side = Either Degrees Degrees

turn :: Side -> Task ()
turn s = task (startTurn s) runTurn

startTurn :: Side -> Orientation -> Memory Orientation
startTurn (Left a)  o = Memory (o+degreesToOrientation a)
startTurn (Right a) o = Memory (o-degreesToOrientation a)

runTurn :: Memory Orientation -> Orientation -> Either Velocity (Done ())
runTurn (Memory to) from = if abs d <= 0.01 then Right (Done ()) else Left (Velocity 0 (realToFrac d))
  where d = normOrientation (to-from)
"""

MOVE = """
data Direction = Forward Centimeters | Backward Centimeters

move :: Direction -> Task ()
move d = task (startMove d) runMove

startMove :: Direction -> Orientation -> Position -> Memory Position
startMove d (Orientation angle) p =
  Memory $ vecToPosition $ addVec (positionToVec p) $ scalarVec (magnitude d) angle
  where magnitude (Forward cm) = centimetersToMeters cm
        magnitude (Backward cm) = - centimetersToMeters cm

runMove :: Memory Position -> Position -> Either Velocity (Done ())
runMove (Memory to) from = if abs dist <= 0.01 then Right (Done ()) else Left (Velocity dist 0)
  where dist = magnitudeVec (subVec (positionToVec to) (positionToVec from))
"""


def wrapped(text: str, kind: str = "") -> str:
    """The functions of a controller with their velocities as messages of the multiplexer, or plain."""
    return text.replace("VEL", f"({kind} Velocity)" if kind else "Velocity").replace(
        "WRAP ", f"{kind} " if kind else ""
    )


LISTINGS = [
    Listing("move", "move :: Velocity\nmove = Velocity 0.5 0\n\nmain = simulate move", lambda r: fastest(r) == 0.5),
    Listing("accelerate", ACCELERATE + "main = simulate accelerate", lambda r: fastest(r) == MAX_SPEED),
    Listing(
        "accelerateAndPlay",
        ACCELERATE + PLAY + "accelerateAndPlay = (accelerate,play)\n\nmain = simulate accelerateAndPlay",
        lambda r: commands(r).count("ErrorSound") == len(r.heard("Bumper", "Pressed")) > 0,
    ),
    Listing(
        "forwardBackward",
        """
type Hit = Bool

reverseDir :: Bumper -> Memory Hit
reverseDir _ = Memory True

accelerate :: Memory Hit -> Velocity -> Velocity
accelerate (Memory hit) (Velocity vl va) = if hit
    then Velocity (vl-0.5) va
    else Velocity (vl+0.5) va

forwardBackward = (reverseDir,accelerate)

main = simulate forwardBackward
""",
        lambda r: fastest(r) == MAX_SPEED and slowest(r) == -MAX_SPEED,
        seconds=20,
    ),
    Listing(
        "randomWalk",
        RANDOM_WALK + wrapped(SPIN) + "main = simulate (bumper,cliff,wheel,chgdir,spin)",
        lambda r: "Led1 Orange" in commands(r) and not TURNING.isdisjoint(commands(r)),
        seconds=60,
    ),
    Listing(
        "safetyControl",
        wrapped(SAFETY) + "main = simulate safetyControl",
        lambda r: r.velocities() == [],
    ),
    Listing(
        "mux",
        MUX
        + "hit :: Button -> M1 Velocity\nhit _ = M1 (Velocity 0 1)\n\n"
        + "go :: Position -> M2 Velocity\ngo _ = M2 (Velocity 0.2 0)\n\nmain = simulate (hit,go,muxVel)",
        lambda r: r.at(1.4)["w"] == 1.0 and r.at(2.5)["w"] == 0.0 and r.at(2.5)["v"] == pytest.approx(0.2),
        hands=((1.0, Press(0, True)),),
        seconds=3,
    ),
    Listing(
        "safeRandomWalk",
        RANDOM_WALK
        + wrapped(SPIN, "M2")
        + wrapped(SAFETY, "M1")
        + MUX
        + "main = simulate ((bumper,cliff,wheel,chgdir,spin),safetyControl,muxVel)",
        lambda r: "Velocity (-0.1) 0.0" in commands(r) and "Led1 Orange" in commands(r),
        seconds=60,
    ),
    Listing("turn", TURN + "main = simulate (turn $ Left 90)", lambda r: abs(turned(r) - 90) < 1.5, seconds=30),
    Listing(
        "move a distance",
        MOVE + "main = simulate (move $ Forward 32)",
        lambda r: abs(moved(r) - 0.32) < 0.02,
        seconds=30,
    ),
    Listing(
        # As printed, the distance has no sign, so the robot drives ahead and away from its goal.
        "move a distance back",
        MOVE + "main = simulate (move $ Backward 32)",
        lambda r: r.lines[-1]["x"] > r.lines[0]["x"] and r.outcome.ended == "time",
        seconds=3,
    ),
    Listing(
        "drawSquare",
        TURN
        + MOVE
        + "drawSquare :: Task ()\ndrawSquare = replicateM_ 4 $ do\n    move (Forward 32)\n    turn (Left 90)\n\n"
        "main = simulate drawSquare",
        lambda r: r.outcome.ended == "done" and moved(r) < 0.05,
        room="empty",
        seconds=120,
    ),
    Listing(
        "2019: simulateIn",
        ACCELERATE + "main = simulateIn world2 accelerate",
        lambda r: fastest(r) == MAX_SPEED,
    ),
    Listing(
        "2019: simulateTask",
        TURN + "main = simulateTask (turn $ Right 90)",
        lambda r: r.outcome.ended == "done" and abs(turned(r) + 90) < 1.5,
        seconds=30,
    ),
    Listing(
        "2019: a task among controllers",
        PLAY + "main = simulate (play, task' (\\(Button _ _) -> Done ()) >> once (Velocity 0.5 0))",
        lambda r: r.at(0.9)["v"] == 0.0 and fastest(r) == 0.5 and "ErrorSound" in commands(r),
        hands=((1.0, Press(0, True)),),
        seconds=12,
    ),
    Listing(
        "2019: blinking LED",
        """
data Blink = BOff | BOn

blink :: Memory Blink -> (Led1,Memory Blink)
blink (Memory BOff) = (Led1 Black,Memory BOn)
blink (Memory BOn) = (Led1 Red,Memory BOff)

main = simulate blink
""",
        lambda r: commands(r)[:4] == ["Led1 Black", "Led1 Red", "Led1 Black", "Led1 Red"],
        seconds=1,
    ),
    Listing(
        "2019: simple random walker",
        """
data Mode = Ok | Panic Clock

mode :: Memory Mode -> Clock -> Memory Mode
mode (Memory (Panic old)) new = if second new-second old > 1 then Memory Ok else Memory (Panic old)
  where second (Clock _ _ s _) = s
mode (Memory Ok) _ = Memory Ok

emergency :: Either Bumper Cliff -> Clock -> Memory Mode
emergency _ now = Memory (Panic now)

walk :: Orientation -> Memory Mode -> Velocity
walk (Orientation o) (Memory Ok) = Velocity 0.5 0
walk (Orientation o) (Memory (Panic _)) = Velocity 0 (pi/8)

main = simulate (emergency,mode,walk)
""",
        lambda r: fastest(r) == 0.5 and turned(r) > 10,
        seconds=30,
    ),
    Listing(
        "2019: random numbers",
        "main = simulate (Say (show (take 3 (randomRs (1, 6 :: Int) (fst (split (mkStdGen 1)))))))",
        lambda r: len(r.said[0].split(",")) == 3,
        seconds=1,
    ),
    Listing(
        "2021: parallel_ and race_",
        'main = simulate (parallel_ (wait 1) (wait 3) >> race_ (wait 1) (wait 3) >> say "done")',
        lambda r: r.outcome.ended == "done" and len(r.lines) == pytest.approx(200, abs=2),
    ),
]


@pytest.mark.parametrize("listing", LISTINGS, ids=lambda listing: listing.name)
def test_a_listing_runs_as_typed(worker: BlockingWorker, listing: Listing) -> None:
    run = ran(worker, listing.typed, listing.seconds, *listing.hands, world=named_world(listing.room))
    assert run.outcome.ended in {"time", "done"}
    assert listing.observed(run), (run.said, sorted(set(commands(run))))


KOBUKI_TURN = TURN.replace("Task ()", "Task () ()").replace(
    "task (startTurn s) runTurn", "task runTurn taskOpts {init = startTurn s}"
)
"""The turn of the site of 2021: a task with two types and with options."""

LISTINGS_OF_2021 = [
    Listing(
        "move",
        "move :: Velocity\nmove = Velocity 0.5 0\n\nmain = simulate (Kobuki Nothing) move",
        lambda r: fastest(r) == 0.5,
    ),
    Listing(
        "accelerate in a world",
        ACCELERATE + "main = simulate (Kobuki (Just world2)) accelerate",
        lambda r: fastest(r) == MAX_SPEED,
    ),
    Listing(
        "a task with options",
        KOBUKI_TURN + "main = simulate (Kobuki Nothing) (turn (Left 90))",
        lambda r: r.outcome.ended == "done" and abs(turned(r) - 90) < 1.5,
        seconds=30,
    ),
    Listing(
        "a sequence of tasks",
        KOBUKI_TURN + "main = simulate (Kobuki Nothing) (turn (Left 90) >> turn (Right 90))",
        lambda r: r.outcome.ended == "done" and abs(turned(r)) < 3,
        seconds=60,
    ),
    Listing(
        "a task that returns a value",
        """
count :: Bumper -> Memory Int -> Either (Memory Int) (Done Int)
count _ (Memory n) = if n >= 1 then Right (Done (n + 1)) else Left (Memory (n + 1))

bumps :: Task () Int
bumps = task (count, Velocity 0.5 0) taskOpts

main = simulate (Kobuki Nothing) $ do
  n <- bumps
  say (show n)
""",
        lambda r: r.said == ["2"],
        seconds=30,
        hands=((20.0, Teleport(Pose(1.5, 2.0, math.pi))),),
    ),
    Listing(
        "a call with feedback that is cancelled",
        """
count :: Memory Int -> Bumper -> (Memory Int, Feedback Int)
count (Memory n) _ = (Memory (n + 1), Feedback (n + 1))

watch :: Task Int ()
watch = task count taskOpts {cleanup = Led1 Red}

begin :: ButtonZero -> Call
begin _ = call watch callOpts {feedback = \\n -> Say (show (n :: Int)), cancel = \\(ButtonOne _) -> Just Cancel}

drive :: Velocity
drive = Velocity 0.5 0

main = simulate (Kobuki Nothing) (begin, drive)
""",
        lambda r: r.said[:1] == ["1"] and "Led1 Red" in commands(r),
        seconds=20,
        hands=((0.1, Press(0, True)), (15.0, Press(1, True))),
    ),
    Listing(
        "a call whose options are the defaults",
        """start :: Button -> Call
start _ = call (wait 1 >> say "called") callOpts {cancel = noCancel, feedback = noFeedback, response = noResponse}

main = simulate (Kobuki Nothing) start""",
        lambda r: "called" in r.said,
        hands=((1.0, Press(0, True)),),
    ),
    Listing(
        "helpers and the time",
        """report :: Time -> Seconds -> Maybe Say
report t now
  | now < 1 = Nothing
  | otherwise = Just (Say (show (swap (hours t, average [1, 2, 3]), thr4 (1, 2, roundFloating 2.6 / 2, 4))))

main = simulate (Kobuki Nothing) report""",
        lambda r: r.said[0] == "((2.0,0),1.5)",
        seconds=2.0,
    ),
    Listing(
        "division with remainder, pairs of functions, and a circle",
        """report :: Seconds -> Say
report _ = Say (show (quotBy 2 7.5 + 0, remBy 2 (-7.5), both (1, True), length (circleLineIntersection circle line)))

both :: (Int, Bool) -> (Int, Bool)
both = negate >< not

circle :: DCircle
circle = ((0, 0), 1)

line :: DLine
line = ((-2, 0), (2, 0))

main = simulate (Kobuki Nothing) report""",
        lambda r: r.said[0] == "(3,-1.5,(-1,False),2)",
        seconds=2.0,
    ),
    Listing(
        "the loser of a race is cleaned up",
        """
blink :: Task () ()
blink = task led taskOpts {cleanup = Led1 Black}

led :: Memory Bool -> (Led1, Memory Bool)
led (Memory b) = (Led1 (if b then Red else Orange), Memory (not b))

main = simulate (Kobuki Nothing) (race_ (wait 2) blink)
""",
        lambda r: commands(r).count("Led1 Black") == 1 and "Led1 Red" in commands(r),
    ),
]
"""Programs in the forms of 2021; what is observed is of the program that the first fixes of its problems give."""


def fixed(worker: BlockingWorker, source: str) -> str:
    """The program after the fixes of its errors, one by one."""
    for _ in range(10):
        errors = [p for p in worker.check(source).problems if p.severity == "error"]
        if not errors:
            return source
        fix = next(p.fixes[0] for p in errors if p.fixes)
        starts = [0]
        for line in source.splitlines(keepends=True):
            starts.append(starts[-1] + len(line))
        for edit in sorted(fix.edits, key=lambda e: (-e.start.line, -e.start.column)):
            begin = starts[edit.start.line - 1] + edit.start.column - 1
            end = starts[edit.end.line - 1] + edit.end.column - 1
            source = source[:begin] + edit.text + source[end:]
    raise AssertionError(f"still wrong: {source}")


@pytest.mark.parametrize("listing", LISTINGS_OF_2021, ids=lambda listing: listing.name)
def test_a_program_of_2021_runs_after_its_fixes(worker: BlockingWorker, listing: Listing) -> None:
    assert any(p.severity == "error" for p in worker.check(listing.typed).problems)
    run = ran(worker, fixed(worker, listing.typed), listing.seconds, *listing.hands, world=named_world(listing.room))
    assert run.outcome.ended in {"time", "done"}
    assert listing.observed(run), (run.said, sorted(set(commands(run))))
