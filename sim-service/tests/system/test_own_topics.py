"""A program with a sensor and commands of its own (rule R23) in the simulator: by input, roslibpy, and in error."""

from __future__ import annotations

import asyncio
import threading
from collections.abc import Iterator
from typing import Any

import pytest
import roslibpy

from rosy_sim.config import discover
from rosy_sim.explain.recorded_run import RecordedRun
from rosy_sim.wire.topics import TopicMessage
from rosy_sim.worker.blocking_worker import BlockingWorker
from rosy_sim.world.events import Press

from ..conftest import PATIENCE
from ..web.page_client import opened, serving
from .real_runs import LIMITS, ran, worker_started

pytestmark = [pytest.mark.real, pytest.mark.skipif(not discover().worker, reason="the worker is not built")]

CORE = "/dock/core"

SOURCE = """newtype Battery = Battery Int

instance Sensor Battery where
  sensor = topic "dock/core" "kobuki_msgs/SensorState" (Battery <$> field "battery")

data Buzz = Buzz

instance Command Buzz where
  command = publish "/mobile_base/commands/sound" "kobuki_msgs/Sound" (\\Buzz -> [("value", whole 3)])

data Report = Report Double Int

instance Command Report where
  command = publish "/report" "geometry_msgs/Twist" twist
    where
      twist (Report x n) = [("linear", record [("x", decimal x), ("y", whole n)])]

warn :: Battery -> Memory Int -> (Memory Int, Maybe Buzz, Report)
warn (Battery level) (Memory n) = (Memory (n + 1), buzz, Report (fromIntegral level + 0.5) n)
  where
    buzz = if level < 130 then Just Buzz else Nothing

main = simulate warn
"""


@pytest.fixture(scope="module")
def worker() -> Iterator[BlockingWorker]:
    yield from worker_started()


def battery(level: int) -> TopicMessage:
    return TopicMessage(CORE, {"battery": level})


def test_messages_of_the_input_file_reach_the_program(worker: BlockingWorker) -> None:
    run = ran(worker, SOURCE, 1.0, (0.2, battery(160)), (0.4, battery(120)))
    assert [(line["t"], line["commands"]) for line in run.lines if line["fired"]] == [
        (0.2, ['/report {"linear":{"x":160.5,"y":0}}']),
        (0.4, ['/mobile_base/commands/sound {"value":3}', '/report {"linear":{"x":120.5,"y":1}}']),
    ]
    assert run.heard(CORE, '"battery":160') == [0.2]


def test_a_firing_tells_the_type_of_each_command_whatever_its_constructor_is_called(worker: BlockingWorker) -> None:
    source = """data Alarm = Loud | Quiet deriving Eq
instance Command Alarm where
  command = publish "/alarm" "std_msgs/Bool" (\\a -> [("data", truth (a == Loud))])
newtype Tagged a = Tagged Int
instance Command (Tagged a) where
  command = publish "/tagged" "std_msgs/UInt8" (\\(Tagged n) -> [("data", whole n)])
newtype Speed = Speed Velocity deriving newtype (Sensor, Command)
press :: Button -> (Alarm, Tagged Alarm, Sound, Speed)
press _ = (Loud, Tagged 3, CleaningEndSound, Speed (Velocity 0.1 0))
main = simulate press
"""
    record = RecordedRun()
    run = ran(worker, source, 1.0, (0.2, Press(0, True)), record=record)
    assert not run.outcome.problems
    assert [(one.type, one.value) for one in record.commands()] == [
        ("Alarm", '/alarm {"data":true}'),
        ("Tagged", '/tagged {"data":3}'),
        ("Sound", "CleaningEndSound"),
        ("Velocity", "Velocity 0.1 0.0"),
    ]
    sent = record.latest_command("Alarm", 1.0)
    assert sent is not None
    assert sent.firing is not None
    assert sent.firing.function == "press"
    assert record.latest_command("Tagged Alarm", 1.0) == record.commands()[1]
    assert record.latest_command("Loud", 1.0) is None


def test_a_message_without_the_field_is_blamed_on_the_function_that_takes_it(worker: BlockingWorker) -> None:
    run = ran(worker, SOURCE, 1.0, (0.2, TopicMessage(CORE, {"batery": 160})))
    problem = run.outcome.problems[0]
    assert (problem.kind, problem.function) == ("unreadable-message", "warn")
    assert "battery" in problem.message


def test_a_topic_of_the_robot_can_be_taken_beside_its_own_type(worker: BlockingWorker) -> None:
    source = """newtype Speed = Speed Double
instance Sensor Speed where sensor = topic "/odom" "nav_msgs/Odometry" (Speed <$> field "twist.twist.linear.x")
data Go = Go
instance Command Go where
  command = publish "/mobile_base/commands/velocity" "geometry_msgs/Twist" twist
    where
      twist Go = [("linear", record [("x", decimal 0.2)])]
own :: Speed -> Maybe Led1
own (Speed v) = if v > 0.1 then Just (Led1 Red) else Nothing
theirs :: Velocity -> Maybe Led2
theirs (Velocity v _) = if v > 0.1 then Just (Led2 Red) else Nothing
main = simulate (Go, own, theirs)
"""
    run = ran(worker, source, 1.0)
    commands = {command for line in run.lines for command in line["commands"]}
    assert {"Led1 Red", "Led2 Red"} <= commands
    assert run.world.x > 1.5


def test_a_topic_that_several_types_of_the_robot_share_comes_with_all_its_fields(worker: BlockingWorker) -> None:
    source = """data Core = Core Int Int [Int]
instance Sensor Core where
  sensor = topic "/mobile_base/sensors/core" "kobuki_msgs/SensorState" core
    where
      core = Core <$> field "battery" <*> field "charger" <*> field "analog_input"
newtype Dock = Dock [Int]
instance Sensor Dock where
  sensor = topic "/mobile_base/sensors/dock_ir" "kobuki_msgs/DockInfraRed" (Dock <$> field "data")
own :: Core -> Say
own (Core level charger inputs) = Say (show (level, charger, length inputs))
dock :: Dock -> Say
dock (Dock receivers) = Say (show receivers)
theirs :: Battery -> Memory Bool -> (Memory Bool, Maybe Say)
theirs (Battery volts) (Memory told) = (Memory True, if told then Nothing else Just (Say (show volts)))
main = simulate (own, dock, theirs)
"""
    run = ran(worker, source, 1.0)
    assert not run.outcome.problems
    said = [command for line in run.lines for command in line["commands"]]
    assert sorted(said) == ['Say "(165,0,4)"', 'Say "16.5"', 'Say "[0,0,0]"']


def test_roslibpy_at_the_other_end_sends_and_gets_them() -> None:
    """The same program; its sensor is published by a ROS client, and its command arrives there."""
    config = discover().with_limits(LIMITS)

    async def tell() -> None:
        async with serving(config) as (address, _), opened(address) as page:
            hello = await page.op("hello")
            host, _, port = address.partition(":")
            got: list[Any] = []
            running = threading.Event()
            client = threading.Thread(target=_other_end, args=(host, int(port), hello["session"], running, got))
            client.start()
            await page.send("run", run=1, source=SOURCE, speed=1)
            await page.until(lambda m: m["op"] == "state" and m["state"] == "running")
            running.set()
            await page.until(lambda m: m["op"] == "sound" and m["sound"] == 3)
            await asyncio.to_thread(client.join, PATIENCE)
            assert not client.is_alive()
            # The first one may have been sent more than once.
            *repeated, last = [(msg["linear"]["x"], msg["linear"]["y"]) for msg in got]
            assert repeated == [(160.5, count) for count in range(max(1, len(repeated)))]
            assert last == (120.5, len(repeated))

    asyncio.run(tell())


def _other_end(host: str, port: int, session: str, running: threading.Event, got: list[Any]) -> None:
    ros = roslibpy.Ros(f"ws://{host}:{port}/rosbridge/{session}")
    ros.run(timeout=PATIENCE)
    core = roslibpy.Topic(ros, CORE, "kobuki_msgs/SensorState")
    core.advertise()
    heard = threading.Semaphore(0)

    def take(msg: Any) -> None:
        got.append(dict(msg))
        heard.release()

    roslibpy.Topic(ros, "/report", "geometry_msgs/Twist").subscribe(take)
    running.wait(PATIENCE)
    # The program takes the topic from a moment after it has been started.
    core.publish(roslibpy.Message({"battery": 160}))
    while not got and not heard.acquire(timeout=0.2):
        core.publish(roslibpy.Message({"battery": 160}))
    core.publish(roslibpy.Message({"battery": 120}))
    while got[-1]["linear"]["x"] != 120.5 and heard.acquire(timeout=PATIENCE):
        pass
    # Not terminate(): it ends the reactor, which all clients of a process share and which cannot be started again.
    ros.close()
