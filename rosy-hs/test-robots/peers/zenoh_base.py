"""
Stand-in for a base on ROS 2 with rmw_zenoh: its router, and a session of its own.

Written from rmw_zenoh's design document and its default configurations (keys, liveliness tokens, attachments since 0.6),
from the message definitions of common_interfaces, kobuki_ros_interfaces and turtlebot3_msgs, and from CDR (OMG
DDSI-RTPS 2.5, 10); it shares nothing with Rosy. The type hashes are those that rosbags 0.11 computes from the
definitions; that of the service is what ROS 2 Humble has for all.

In: port of the router, and then what ``fast_dds_base.cpp`` takes, on the command line and on standard input; also the
word ``no_router`` for one that uses another's router, and ``router off``, ``router on``, and ``garble``, for odometry
that breaks off. Out: what that says.

A Kobuki's action follows design.ros2.org, "Actions", the definitions of action_msgs, and AutoDocking.action.
"""

import json
import math
import struct
import sys
import threading
import time

import zenoh

HASHES = {
    "geometry_msgs::msg::dds_::Twist_": "9c45bf16fe0983d80e3cfe750d6835843d265a9a6c46bd2e609fcddde6fb8d2a",
    "geometry_msgs::msg::dds_::TwistStamped_": "5f0fcd4f81d5d06ad9b4c4c63e3ea51b82d6ae4d0558f1d475229b1121db6f64",
    "nav_msgs::msg::dds_::Odometry_": "3cc97dc7fb7502f8714462c526d369e35b603cfc34d946e3f2eda2766dfec6e0",
    "sensor_msgs::msg::dds_::LaserScan_": "64c191398013af96509d518dac71d5164f9382553fce5c1f8cca5be7924bd828",
    "sensor_msgs::msg::dds_::BatteryState_": "4bee5dfce981c98faa6828b868307a0a73f992ed0789f374ee96c8f840e69741",
    "turtlebot3_msgs::msg::dds_::SensorState_": "e35bc7db55e7a7aeb24990b6d7f189a2002ae442e0d9925077e29895f838ccea",
    "kobuki_ros_interfaces::msg::dds_::BumperEvent_": "ca5b8abfc41495a14a9fc1d094633575daf97b4272de107ed5fa58cb46224b72",
}

PORT, DOMAIN, SPACE, KIND, *WORDS = sys.argv[1:]
STAMPED, KOBUKI, WATCHDOG = (
    "stamped" in WORDS,
    KIND == "kobuki",
    "no_watchdog" not in WORDS,
)

SAYING = threading.Lock()


def say(text):
    with SAYING:
        print(text, flush=True)


class Cdr:
    """Little-endian; each number at a multiple of its size behind the header."""

    def __init__(self):
        self.data = bytearray()

    def put(self, format, *values):
        for value in values:
            size = struct.calcsize(format)
            self.data += b"\0" * (-len(self.data) % size) + struct.pack(
                f"<{format}", value
            )
        return self

    def text(self, value):
        self.put("I", len(value) + 1)
        self.data += value.encode() + b"\0"
        return self

    def header(self, n, frame):
        return self.put("i", n // 50 + 1).put("I", 0).text(frame)

    def bytes(self):
        return b"\0\1\0\0" + bytes(self.data)


def session(mode, **settings):
    configuration = zenoh.Config()
    for key, value in {
        "mode": mode,
        "scouting/multicast/enabled": False,
        **settings,
    }.items():
        configuration.insert_json5(key, json.dumps(value))
    return zenoh.open(configuration)


def start_router():
    return session("router", **{"listen/endpoints": [f"tcp/127.0.0.1:{PORT}"]})


def key_of(topic, kind):
    return f"{DOMAIN}{topic}/{kind}/{'RIHS01_' + HASHES[kind] if kind in HASHES else 'TypeHashNotSupported'}"


TOKENS = []


def announce(letters, topic, kind, quality):
    _, _, end = key_of(topic, kind).rpartition(f"/{kind}/")
    here = f"@ros2_lv/{DOMAIN}/{OWN.zid()}/0/{len(TOKENS) + 1}/{letters}/%/%/base"
    TOKENS.append(
        OWN.liveliness().declare_token(
            f"{here}/{topic.replace('/', '%')}/{kind}/{end}/{quality}"
        )
    )


class Publisher:
    def __init__(self, name, kind):
        topic = f"{SPACE}/{name}"
        self.publisher = OWN.declare_publisher(key_of(topic, kind))
        self.number = 0
        announce(
            "MP",
            topic,
            kind,
            "2::,5:,:,:,," if "best_effort" in WORDS else "::,5:,:,:,,",
        )

    def put(self, cdr):
        self.number += 1
        attachment = struct.pack(
            "<qqB16s", self.number, time.time_ns(), 16, b"a writer of base"
        )
        self.publisher.put(cdr.bytes(), attachment=attachment)


class Drive:
    """What it was told, and how it stands."""

    def __init__(self):
        self.lock = threading.RLock()
        self.speed = self.turn = self.told = self.marked = 0.0
        self.moving = self.marking = self.counting = False

    def set(self, speed, turn):
        self.speed, self.turn, self.told = speed, turn, time.monotonic()
        self.moving = speed != 0 or turn != 0
        if self.moving and self.marking:
            self.marking, self.counting, self.marked = False, True, self.told
            say("marked")
        if not self.moving and self.counting:
            self.counting = False
            say(f"stood {self.told - self.marked:.3f}")


def is_numbered(attachment):
    """Whether a sample has the attachment without which rmw_zenoh discards it (rmw_subscription_data.cpp)."""
    raw = b"" if attachment is None else attachment.to_bytes()
    return len(raw) == 33 and raw[16] == 16 and struct.unpack_from("<q", raw)[0] > 0


def on_velocity(sample):
    if not is_numbered(sample.attachment):
        return say("dropped a velocity without an attachment")
    payload = sample.payload.to_bytes()
    assert payload[:2] == b"\0\1", payload
    at, age = 4, -1.0
    if STAMPED:
        seconds, nanoseconds, length = struct.unpack_from("<iII", payload, at)
        age = time.time() - seconds - nanoseconds * 1e-9
        at += -(-(12 + length) // 8) * 8
    x, _, _, _, _, turn = struct.unpack_from("<6d", payload, at)
    with DRIVE.lock:
        say(f"got {x:g} {turn:g} {age:.3f}")
        # As the controllers of ros2_control do. A base without a watchdog takes every one.
        if not STAMPED or not WATCHDOG or abs(age) < 0.5:
            DRIVE.set(x, turn)
    return None


def on_power(query):
    if is_numbered(query.attachment):
        say(f"called motor_power {query.payload.to_bytes()[4]}")
    answer = Cdr().put("B", 1).text("on")
    query.reply(query.key_expr, answer.bytes(), attachment=query.attachment)


class Docking:
    """The action of a Kobuki: one goal at a time."""

    name = "/auto_docking_action/_action"
    kind = "kobuki_ros_interfaces::action::dds_::AutoDocking_"

    def __init__(self):
        self.goal, self.asked, self.ending, self.rejects = b"", None, None, False
        self.feedback = Publisher(f"{self.name[1:]}/feedback", f"{self.kind}FeedbackMessage_")
        self.serve("send_goal", f"{self.kind}SendGoal_", self.send)
        self.serve("get_result", f"{self.kind}GetResult_", self.result)
        self.serve("cancel_goal", "action_msgs::srv::dds_::CancelGoal_", self.cancel)

    def serve(self, part, kind, answer):
        topic = f"{SPACE}{self.name}/{part}"
        OWN.declare_queryable(key_of(topic, kind), answer, complete=True)
        announce("SS", topic, kind, "::,10:,:,:,,")

    def reply(self, query, cdr):
        assert is_numbered(query.attachment)
        query.reply(query.key_expr, cdr.bytes(), attachment=query.attachment)

    def send(self, query):
        accepts = not self.rejects
        if accepts:
            self.goal, self.ending, self.asked = query.payload.to_bytes()[4:20], None, None
        self.reply(query, Cdr().put("B", accepts).put("i", 0).put("I", 0))
        say(f"goal {'accepted' if accepts else 'rejected'}")

    def result(self, query):
        assert query.payload.to_bytes()[4:20] == self.goal
        self.asked = query
        self.answer()

    def cancel(self, query):
        ident = query.payload.to_bytes()[4:20]
        self.reply(query, Cdr().put("b", 0).put("I", 1).put("B", *ident).put("i", 0).put("I", 0))
        if ident == self.goal:
            say("cancel asked")
            self.end(5, "given up")

    def approach(self, state):
        self.feedback.put(Cdr().put("B", *self.goal).text(state).text("on its way"))

    def end(self, status, text):
        self.ending = (status, text)
        self.answer()

    def answer(self):
        query, ending = self.asked, self.ending
        if query is not None and ending is not None:
            self.asked = None
            self.reply(query, Cdr().put("b", ending[0]).text(ending[1]))


WRITERS = set()


def on_token(sample):
    parts = str(sample.key_expr).split("/")
    if (
        parts[5] == "MP"
        and parts[9] == VELOCITY.replace("/", "%")
        and parts[10] == VELOCITY_TYPE
    ):
        (WRITERS.discard if sample.kind == zenoh.SampleKind.DELETE else WRITERS.add)(
            str(sample.key_expr)
        )
        say(f"seen {len(WRITERS)}")


def move():
    x = y = heading = 0.0
    step, n, following = 0.02, 0, time.monotonic()
    while True:
        following += step
        time.sleep(max(0.0, following - time.monotonic()))
        with DRIVE.lock:
            if DRIVE.moving and WATCHDOG and time.monotonic() - DRIVE.told > 0.6:
                say("watchdog")
                DRIVE.set(0.0, 0.0)
            v, w = DRIVE.speed, DRIVE.turn
        heading += w * step
        x, y = x + v * step * math.cos(heading), y + v * step * math.sin(heading)
        pose = Cdr().header(n, "odom").text("base_footprint")
        pose.put("d", x, y, 0, 0, 0, math.sin(heading / 2), math.cos(heading / 2)).put(
            "d", *[math.nan] * 36
        )
        ODOMETRY.put(pose.put("d", v, 0, 0, 0, 0, w).put("d", *[0] * 36))
        if not KOBUKI and n % 10 == 0:
            scan = (
                Cdr()
                .header(n, "base_scan")
                .put("f", 0, 6.28, 0.0175, 0, 0.2, 0.12, 3.5)
            )
            SCAN.put(scan.put("I", 360).put("f", *[math.inf] * 360).put("I", 0))
            sensors = (
                Cdr()
                .header(n, "")
                .put("B", 0)
                .put("f", 0, 0, 0)
                .put("B", 0, 0, 1)
                .put("i", 0, 0)
            )
            SENSORS.put(sensors.put("f", 11.9))
            charge = (
                Cdr()
                .header(n, "")
                .put("f", 11.94, *[math.nan] * 4, 1.8, 0.87)
                .put("B", 0, 0, 0, 1)
            )
            BATTERY.put(charge.put("I", 0, 0).text("").text(""))
        n += 1


DRIVE = Drive()
router = None if "no_router" in WORDS else start_router()
# As a node's session is by default: a peer that knows the others from the router of its computer.
OWN = session(
    "peer",
    **{
        "connect/endpoints": [f"tcp/127.0.0.1:{PORT}"],
        "listen/endpoints": ["tcp/127.0.0.1:0"],
    },
)
VELOCITY = SPACE + ("/commands/velocity" if KOBUKI else "/cmd_vel")
VELOCITY_TYPE = (
    "geometry_msgs::msg::dds_::TwistStamped_"
    if STAMPED
    else "geometry_msgs::msg::dds_::Twist_"
)
OWN.declare_subscriber(key_of(VELOCITY, VELOCITY_TYPE), on_velocity)
announce("MS", VELOCITY, VELOCITY_TYPE, "::,10:,:,:,,")
tokens = OWN.liveliness().declare_subscriber(
    f"@ros2_lv/{DOMAIN}/**", on_token, history=True
)
ODOMETRY = Publisher("odom", "nav_msgs::msg::dds_::Odometry_")
if KOBUKI:
    BUMPER = Publisher(
        "events/bumper", "kobuki_ros_interfaces::msg::dds_::BumperEvent_"
    )
    DOCKING = Docking()
else:
    SCAN = Publisher("scan", "sensor_msgs::msg::dds_::LaserScan_")
    BATTERY = Publisher("battery_state", "sensor_msgs::msg::dds_::BatteryState_")
    SENSORS = Publisher("sensor_state", "turtlebot3_msgs::msg::dds_::SensorState_")
    OWN.declare_queryable(
        key_of(f"{SPACE}/motor_power", "std_srvs::srv::dds_::SetBool_"),
        on_power,
        complete=True,
    )
    announce(
        "SS", f"{SPACE}/motor_power", "std_srvs::srv::dds_::SetBool_", "::,10:,:,:,,"
    )
threading.Thread(target=move, daemon=True).start()
say("ready")
for line in sys.stdin:
    match line.split():
        case ["mark"]:
            with DRIVE.lock:
                DRIVE.marking = True
                if DRIVE.moving:
                    DRIVE.set(DRIVE.speed, DRIVE.turn)
        case ["bump", state] if KOBUKI:
            BUMPER.put(Cdr().put("B", 0, int(state)))
        case ["rejects"]:
            DOCKING.rejects = True
        case ["approach", state]:
            DOCKING.approach(state)
        case ["end", status, text]:
            DOCKING.end(int(status), text)
        case ["garble"]:
            ODOMETRY.publisher.put(b"\0\1\0\0ab", attachment=b"")
        case ["router", "off"]:
            router.close()
        case ["router", "on"]:
            router = start_router()
        case ["quit"]:
            break
OWN.close()
if router is not None:
    router.close()
