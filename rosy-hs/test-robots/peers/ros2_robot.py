"""
Stand-ins for two ROS 2 robots behind a rosbridge server: an iRobot Create 3 and a TurtleBot 3.

Written from the message definitions of irobot_create_msgs, turtlebot3_msgs and ROS 2's common packages, from create3_docs and from turtlebot3_node;
it shares nothing with Rosy's own description of these robots.

In: the robot as the first argument, frames from one client at a time, and on standard input `send TOPIC JSON`, `stream TOPIC JSON`, `hazard TYPE FRAME on|off`,
`button NAME on|off`, `appear`, `mark`, `quit`. Further arguments: `stamped`, its velocities have a time; `iron`, they have it on /cmd_vel_stamped; `late`, the robot
is absent until `appear`, and what was subscribed before hears nothing, because its publishers are best effort (rosbridge_library, internal/subscribers.py). Out: on standard output `port N`, `advertised TOPIC TYPE`, `subscribed TOPIC TYPE`, `got TOPIC JSON`,
`called SERVICE JSON`, `rejected WHY`, and `watchdog`, `marked` and `stood SECONDS` as rosbridge.py. Only a Create 3 has a watchdog: turtlebot3_node
keeps the last velocity for as long as it runs itself. What rosbridge_suite refuses is refused: unknown types, topics, services and fields, 1.0 for an
integer, numbers out of range, arrays of another length.
"""

import asyncio
import json
import re
import sys
import time

import websockets

CREATE3 = sys.argv[1] == "create3"

MESSAGES = {
    "builtin_interfaces/Time": "int32 sec, uint32 nanosec",
    "builtin_interfaces/Duration": "int32 sec, uint32 nanosec",
    "std_msgs/Header": "builtin_interfaces/Time stamp, string frame_id",
    "std_msgs/String": "string data",
    "geometry_msgs/Vector3": "float64 x, float64 y, float64 z",
    "geometry_msgs/Point": "float64 x, float64 y, float64 z",
    "geometry_msgs/Quaternion": "float64 x, float64 y, float64 z, float64 w",
    "geometry_msgs/Twist": "geometry_msgs/Vector3 linear, geometry_msgs/Vector3 angular",
    "geometry_msgs/TwistStamped": "std_msgs/Header header, geometry_msgs/Twist twist",
    "geometry_msgs/Pose": "geometry_msgs/Point position, geometry_msgs/Quaternion orientation",
    "geometry_msgs/PoseWithCovariance": "geometry_msgs/Pose pose, float64[36] covariance",
    "geometry_msgs/TwistWithCovariance": "geometry_msgs/Twist twist, float64[36] covariance",
    "nav_msgs/Odometry": "std_msgs/Header header, string child_frame_id, geometry_msgs/PoseWithCovariance pose, geometry_msgs/TwistWithCovariance twist",
    "sensor_msgs/Imu": "std_msgs/Header header, geometry_msgs/Quaternion orientation, float64[9] orientation_covariance, "
    "geometry_msgs/Vector3 angular_velocity, float64[9] angular_velocity_covariance, "
    "geometry_msgs/Vector3 linear_acceleration, float64[9] linear_acceleration_covariance",
    "sensor_msgs/BatteryState": "std_msgs/Header header, float32 voltage, float32 temperature, float32 current, float32 charge, float32 capacity, "
    "float32 design_capacity, float32 percentage, uint8 power_supply_status, uint8 power_supply_health, uint8 power_supply_technology, "
    "bool present, float32[] cell_voltage, float32[] cell_temperature, string location, string serial_number",
    "sensor_msgs/LaserScan": "std_msgs/Header header, float32 angle_min, float32 angle_max, float32 angle_increment, float32 time_increment, "
    "float32 scan_time, float32 range_min, float32 range_max, float32[] ranges, float32[] intensities",
    "irobot_create_msgs/HazardDetection": "std_msgs/Header header, uint8 type",
    "irobot_create_msgs/HazardDetectionVector": "std_msgs/Header header, irobot_create_msgs/HazardDetection[] detections",
    "irobot_create_msgs/Button": "std_msgs/Header header, bool is_pressed, "
    "builtin_interfaces/Time last_start_pressed_time, builtin_interfaces/Duration last_pressed_duration",
    "irobot_create_msgs/InterfaceButtons": "std_msgs/Header header, irobot_create_msgs/Button button_1, "
    "irobot_create_msgs/Button button_power, irobot_create_msgs/Button button_2",
    "irobot_create_msgs/DockStatus": "std_msgs/Header header, bool dock_visible, bool is_docked",
    "irobot_create_msgs/LedColor": "uint8 red, uint8 green, uint8 blue",
    "irobot_create_msgs/LightringLeds": "std_msgs/Header header, irobot_create_msgs/LedColor[6] leds, bool override_system",
    "irobot_create_msgs/AudioNote": "uint16 frequency, builtin_interfaces/Duration max_runtime",
    "irobot_create_msgs/AudioNoteVector": "std_msgs/Header header, irobot_create_msgs/AudioNote[] notes, bool append",
    "turtlebot3_msgs/SensorState": "std_msgs/Header header, uint8 bumper, float32 cliff, float32 sonar, float32 illumination, uint8 led, uint8 button, "
    "bool torque, int32 left_encoder, int32 right_encoder, float32 battery",
}
SENSORS = {
    "/odom": "nav_msgs/Odometry",
    "/imu": "sensor_msgs/Imu",
    "/battery_state": "sensor_msgs/BatteryState",
    **(
        {
            "/hazard_detection": "irobot_create_msgs/HazardDetectionVector",
            "/interface_buttons": "irobot_create_msgs/InterfaceButtons",
            "/dock_status": "irobot_create_msgs/DockStatus",
        }
        if CREATE3
        else {
            "/sensor_state": "turtlebot3_msgs/SensorState",
            "/scan": "sensor_msgs/LaserScan",
        }
    ),
}
STAMPED = "stamped" in sys.argv or "iron" in sys.argv
COMMANDS = {
    "/cmd_vel_stamped"
    if "iron" in sys.argv
    else "/cmd_vel": "geometry_msgs/TwistStamped" if STAMPED else "geometry_msgs/Twist",
    **(
        {
            "/cmd_lightring": "irobot_create_msgs/LightringLeds",
            "/cmd_audio": "irobot_create_msgs/AudioNoteVector",
        }
        if CREATE3
        else {}
    ),
}
SERVICES = (
    {"/e_stop": ("irobot_create_msgs/srv/EStop", "bool e_stop_on")}
    if CREATE3
    else {
        "/motor_power": ("std_srvs/srv/SetBool", "bool data"),
        "/sound": ("turtlebot3_msgs/srv/Sound", "uint8 value"),
    }
)
INTEGERS = {
    "uint8": (0, 255),
    "uint16": (0, 65535),
    "int32": (-(2**31), 2**31 - 1),
    "uint32": (0, 2**32 - 1),
}

client = None
present = ["late" not in sys.argv]
# Topics that the client has subscribed to, and those of them that it hears.
advertised, subscribed, audible = {}, set(), set()
hazards, buttons = {}, {"button_1": False, "button_power": False, "button_2": False}
last_moving, marking, marked = [None], [False], [None]


def say(*words):
    print(*words, flush=True)


def fault(value, kind):
    """Why a value is not of a type; None when it is."""
    if array := re.fullmatch(r"(.*)\[(\d*)\]", kind):
        if not isinstance(value, list):
            return "not a list"
        if array[2] and len(value) != int(array[2]):
            return f"{len(value)} entries for {array[2]}"
        return next((why for entry in value if (why := fault(entry, array[1]))), None)
    if kind == "bool":
        return None if isinstance(value, bool) else "not a bool"
    if kind == "string":
        return None if isinstance(value, str) else "not a string"
    if kind.startswith("float"):
        return (
            None
            if isinstance(value, int | float) and not isinstance(value, bool)
            else "not a number"
        )
    if kind in INTEGERS:
        low, high = INTEGERS[kind]
        return (
            None
            if isinstance(value, int)
            and not isinstance(value, bool)
            and low <= value <= high
            else f"not a {kind}"
        )
    return fields_fault(value, MESSAGES[kind])


def fields_fault(value, definition):
    kinds = {
        name: kind for kind, name in (part.split() for part in definition.split(", "))
    }
    if not isinstance(value, dict):
        return "not an object"
    for key, inner in value.items():
        if key not in kinds:
            return f"unknown field {key}"
        if why := fault(inner, kinds[key]):
            return f"{key}: {why}"
    return None


def named(kind):
    """A type as rosbridge takes it: package/Name or package/msg/Name."""
    parts = str(kind).split("/")
    return f"{parts[0]}/{parts[2]}" if len(parts) == 3 and parts[1] == "msg" else kind


def on_frame(frame):
    message = json.loads(frame)
    op, topic = message["op"], message.get("topic")
    if op == "advertise":
        kind = named(message.get("type"))
        if kind not in MESSAGES or COMMANDS.get(topic, kind) != kind:
            return say("rejected", f"advertise {topic} {message.get('type')}")
        advertised[topic] = kind
        say("advertised", topic, message["type"])
    elif op == "subscribe":
        kind = named(message.get("type"))
        if kind not in MESSAGES or SENSORS.get(topic, kind) != kind:
            return say("rejected", f"subscribe {topic} {message.get('type')}")
        subscribed.add(topic)
        if present[0]:
            audible.add(topic)
        say("subscribed", topic, message["type"])
    elif op == "unsubscribe":
        subscribed.discard(topic)
        audible.discard(topic)
    elif op == "publish":
        why = (
            fault(message["msg"], advertised[topic])
            if topic in advertised
            else "no type"
        )
        if why:
            return say("rejected", f"publish {topic}: {why}")
        if topic.startswith("/cmd_vel"):
            drive(message["msg"].get("twist", message["msg"]))
        say("got", topic, json.dumps(message["msg"]))
    elif op == "call_service" and message["service"] == "/rosapi/topic_type":
        kind = COMMANDS.get(message["args"]["topic"], "") if present[0] else ""
        values = {"type": kind.replace("/", "/msg/")}
        answer = {
            "op": "service_response",
            "service": "/rosapi/topic_type",
            "values": values,
            "result": True,
            "id": message["id"],
        }
        return answer
    elif op == "call_service":
        kind, request = SERVICES.get(message["service"], (None, ""))
        why = (
            "no such service"
            if kind is None
            else "another type"
            if message.get("type", kind) != kind
            else fields_fault(message["args"], request)
        )
        if why:
            return say("rejected", f"call {message['service']}: {why}")
        say("called", message["service"], json.dumps(message["args"]))
    else:
        say("rejected", f"op {op}")


def drive(twist):
    moving = (
        twist.get("linear", {}).get("x", 0) != 0
        or twist.get("angular", {}).get("z", 0) != 0
    )
    last_moving[0] = time.monotonic() if moving else None
    if not moving:
        stand()
    mark()


def mark():
    if marking[0] and last_moving[0] is not None:
        marking[0], marked[0] = False, time.monotonic()
        say("marked")


def stand():
    if marked[0] is not None:
        say("stood", f"{time.monotonic() - marked[0]:.3f}")
        marked[0] = None


async def serve(socket, *_path):
    global client
    client = socket
    advertised.clear()
    subscribed.clear()
    audible.clear()
    try:
        async for frame in socket:
            answer = on_frame(frame)
            if answer:
                await socket.send(json.dumps(answer))
    except websockets.ConnectionClosed:
        pass
    say("left")


async def publish(topic, message):
    if why := fault(message, SENSORS[topic]):
        raise SystemExit(f"this robot cannot say {topic} {message}: {why}")
    if client is not None and present[0] and topic in audible:
        try:
            await client.send(
                json.dumps({"op": "publish", "topic": topic, "msg": message})
            )
        except websockets.ConnectionClosed:
            pass


async def stream(topic, message):
    while True:
        await publish(topic, message)
        await asyncio.sleep(0.02)


async def sense():
    """What hazards and buttons are now, twice: a robot says so 62 times a second, whether something has changed or not."""
    for _ in range(2):
        if CREATE3:
            found = [
                {
                    "header": {"stamp": {"sec": 1, "nanosec": 2}, "frame_id": frame},
                    "type": kind,
                }
                for kind, frame in hazards
            ]
            await publish(
                "/hazard_detection",
                {"header": {"frame_id": "base_link"}, "detections": found},
            )
            await publish(
                "/interface_buttons",
                {name: {"is_pressed": pressed} for name, pressed in buttons.items()},
            )
        else:
            await publish(
                "/sensor_state",
                {
                    "button": buttons["button_1"] + 2 * buttons["button_2"],
                    "torque": True,
                    "battery": 11.9,
                },
            )


async def watch():
    while CREATE3:
        await asyncio.sleep(0.1)
        if last_moving[0] is not None and time.monotonic() - last_moving[0] > 0.6:
            last_moving[0] = None
            say("watchdog")
            stand()


async def main():
    reader = asyncio.StreamReader()
    await asyncio.get_running_loop().connect_read_pipe(
        lambda: asyncio.StreamReaderProtocol(reader), sys.stdin
    )
    tasks = [asyncio.ensure_future(watch())]
    async with websockets.serve(serve, "127.0.0.1", 0, ping_interval=None) as server:
        say("port", server.sockets[0].getsockname()[1])
        while line := (await reader.readline()).decode().strip():
            word, _, rest = line.partition(" ")
            if word in ("send", "stream"):
                topic, _, text = rest.partition(" ")
                act = publish if word == "send" else stream
                tasks.append(asyncio.ensure_future(act(topic, json.loads(text))))
            elif word == "hazard":
                kind, frame, on = rest.split()
                if on == "on":
                    hazards[int(kind), frame] = None
                else:
                    del hazards[int(kind), frame]
                await sense()
            elif word == "button":
                name, on = rest.split()
                buttons[name] = on == "on"
                await sense()
            elif word == "appear":
                present[0] = True
            elif word == "mark":
                marking[0] = True
                mark()
            elif word == "quit":
                break
    for task in tasks:
        task.cancel()


asyncio.run(main())
