"""
A rosbridge server that is as strict as the real ones and knows one robot.

In: frames from one client at a time; on standard input `send TOPIC JSON`, `stream TOPIC JSON`, `still`, `raw TEXT`, `drop`, `refuse`, `accept`, `mark`, `quit`; the
version of ROS as the argument. Out: on standard output `port N`, `advertised TOPIC TYPE`, `subscribed TOPIC TYPE`,
`got TOPIC JSON`, `rejected WHY`, `watchdog` when 0.6 s pass after a velocity that was not zero, after `mark` `marked`, as soon as its wheels turn, and then `stood SECONDS` when they stand, by its own clock. It refuses what rosbridge_suite
refuses: 1.0 for an integer, unknown fields, types it does not know, topics without a type.
"""

import asyncio
import json
import sys
import time

import websockets

ROS2 = sys.argv[1] == "2"
PACKAGE = "kobuki_ros_interfaces" if ROS2 else "kobuki_msgs"
PREFIX = "" if ROS2 else "/mobile_base"

FLOAT = "float"
VECTOR = {"x": FLOAT, "y": FLOAT, "z": FLOAT}
TYPES = {
    "geometry_msgs/Twist": {"linear": VECTOR, "angular": VECTOR},
    f"{PACKAGE}/Led": {"value": "uint8"},
    f"{PACKAGE}/Sound": {"value": "uint8"},
    "std_msgs/String": {"data": "string"},
    "nav_msgs/Odometry": None,
    **{f"{PACKAGE}/{name}": None for name in ("ButtonEvent", "BumperEvent", "CliffEvent", "WheelDropEvent", "RobotStateEvent", "SensorState")},
}
client = None
open_to_all = True
advertised, subscribed = {}, set()
last_moving = [None]
marking, marked = [False], [None]


def say(*words):
    print(*words, flush=True)


def mark():
    """Says that the marked time begins, once the wheels turn: those that stand already would not come to stand."""
    if marking[0] and last_moving[0] is not None:
        marking[0] = False
        marked[0] = time.monotonic()
        say("marked")


def stand():
    if marked[0] is not None:
        say("stood", f"{time.monotonic() - marked[0]:.3f}")
        marked[0] = None


def known(kind):
    if kind is None:
        return None
    parts = kind.split("/")
    # Both servers take two parts; only that of ROS 2 takes three.
    if len(parts) == 3 and parts[1] == "msg" and ROS2:
        parts = [parts[0], parts[2]]
    name = "/".join(parts)
    return name if name in TYPES else None


def fault(value, shape):
    if shape == FLOAT:
        return None if isinstance(value, (int, float)) and not isinstance(value, bool) else "not a number"
    if shape == "uint8":
        return None if isinstance(value, int) and not isinstance(value, bool) and 0 <= value < 256 else "not a uint8"
    if shape == "string":
        return None if isinstance(value, str) else "not a string"
    if not isinstance(value, dict):
        return "not an object"
    for key, inner in value.items():
        if key not in shape:
            return f"unknown field {key}"
        why = fault(inner, shape[key])
        if why:
            return f"{key}: {why}"
    return None


def refuse_constant(name):
    raise ValueError(f"{name} is not JSON")


def on_frame(frame):
    message = json.loads(frame, parse_constant=refuse_constant)
    op, topic = message["op"], message.get("topic")
    if op == "advertise":
        kind = known(message.get("type"))
        if kind is None:
            return say("rejected", f"advertise {topic} {message.get('type')}")
        advertised[topic] = kind
        say("advertised", topic, message["type"])
    elif op == "subscribe":
        if known(message.get("type")) is None:
            return say("rejected", f"subscribe {topic} {message.get('type')}")
        subscribed.add(topic)
        say("subscribed", topic, message["type"])
    elif op == "unsubscribe":
        subscribed.discard(topic)
    elif op == "call_service" and message["service"] == "/rosapi/topic_type":
        kind = "geometry_msgs/msg/Twist" if ROS2 else "geometry_msgs/Twist"
        values = {"type": kind if message["args"]["topic"] == f"{PREFIX}/commands/velocity" else ""}
        return {"op": "service_response", "service": "/rosapi/topic_type", "values": values, "result": True, "id": message["id"]}
    elif op == "publish":
        if topic not in advertised:
            return say("rejected", f"publish {topic} without a type")
        why = fault(message["msg"], TYPES[advertised[topic]])
        if why:
            return say("rejected", f"publish {topic}: {why}")
        if advertised[topic] == "geometry_msgs/Twist":
            twist = message["msg"]
            moving = twist.get("linear", {}).get("x", 0) != 0 or twist.get("angular", {}).get("z", 0) != 0
            last_moving[0] = time.monotonic() if moving else None
            if not moving:
                stand()
            mark()
        say("got", topic, json.dumps(message["msg"]))
    else:
        say("rejected", f"op {op}")


async def serve(socket, *_path):
    global client
    if not open_to_all:
        return
    client = socket
    advertised.clear()
    subscribed.clear()
    try:
        async for frame in socket:
            answer = on_frame(frame)
            if answer:
                await socket.send(json.dumps(answer))
    except websockets.ConnectionClosed:
        pass
    say("left")


async def publish(topic, text):
    if client is not None and topic in subscribed:
        try:
            await client.send(json.dumps({"op": "publish", "topic": topic, "msg": json.loads(text)}))
        except websockets.ConnectionClosed:
            pass


async def stream(topic, text):
    while True:
        await publish(topic, text)
        await asyncio.sleep(0.02)


async def watch():
    while True:
        await asyncio.sleep(0.1)
        if last_moving[0] is not None and time.monotonic() - last_moving[0] > 0.6:
            last_moving[0] = None
            say("watchdog")
            stand()


async def main():
    global open_to_all
    reader = asyncio.StreamReader()
    await asyncio.get_running_loop().connect_read_pipe(lambda: asyncio.StreamReaderProtocol(reader), sys.stdin)
    tasks = [asyncio.ensure_future(watch())]
    async with websockets.serve(serve, "127.0.0.1", 0, ping_interval=None) as server:
        say("port", server.sockets[0].getsockname()[1])
        while line := (await reader.readline()).decode().strip():
            word, _, rest = line.partition(" ")
            if word == "send":
                topic, _, text = rest.partition(" ")
                await publish(topic, text)
            elif word == "stream":
                topic, _, text = rest.partition(" ")
                tasks.append(asyncio.ensure_future(stream(topic, text)))
            elif word == "still":
                tasks.pop().cancel()
            elif word == "raw" and client is not None:
                await client.send(rest)
            elif word == "drop" and client is not None:
                await client.close()
            elif word == "mark":
                marking[0] = True
                mark()
            elif word in ("refuse", "accept"):
                open_to_all = word == "accept"
            elif word == "quit":
                break
    for task in tasks:
        task.cancel()


asyncio.run(main())
