"""
A rospy node that does what its standard input says, one command a line, and says on its standard output what it sees.

In: `sub TOPIC TYPE`, `pub TOPIC TYPE [latch]`, `send TOPIC JSON`, `stream TOPIC JSON`, `flood TOPIC COUNT`, `echo FROM TO`, `time COUNT TOPIC BACK [TOPIC BACK]`,
`serve NAME`, `add NAME`, `call NAME TYPE JSON...` (one connection for all), `connected TOPIC COUNT`, `listening TOPIC`, `heard TOPIC COUNT`, `watchdog TOPIC`, `mark`, `param get|set NAME JSON`, `rosout`, `quit`.
Out: `ready`, `got TOPIC JSON` for every message, an answer per command; that to `mark` comes as soon as a
watched velocity is not zero, and behind it `stood SECONDS` when it is zero or the watchdog has spoken, by its own clock. It never decides whether a test passes.
"""

import importlib
import json
import sys
import threading
import time

import genpy.message
import rospy


def kind(name):
    package, base = name.split("/")
    return getattr(importlib.import_module(package + ".msg"), base)


def plain(value):
    """A message as JSON would have it."""
    if isinstance(value, genpy.Message):
        return {slot: plain(getattr(value, slot)) for slot in value.__slots__}
    if isinstance(value, genpy.rostime.TVal):
        return value.to_sec()
    if isinstance(value, bytes):
        return list(value)
    if isinstance(value, (list, tuple)):
        return [plain(v) for v in value]
    return value


def say(*words):
    with lock:
        sys.stdout.write(" ".join(words) + "\n")
        sys.stdout.flush()


lock = threading.Lock()
publishers, subscribers, counts, quiet = {}, {}, {}, set()
counted = threading.Condition()


def heard(topic):
    def on_message(message):
        with counted:
            counts[topic].append(getattr(message, "data", None))
            counted.notify_all()
        if topic not in quiet:
            say("got", topic, json.dumps(plain(message)))

    return on_message


def make(name, text):
    message = kind(name)()
    genpy.message.fill_message_args(message, [json.loads(text)])
    return message


def subscribe(topic, type_name, *options):
    counts[topic] = []
    if "quiet" in options:
        quiet.add(topic)
    subscribers[topic] = rospy.Subscriber(topic, kind(type_name), heard(topic), tcp_nodelay=True)
    say("subscribed", topic)


def publish(topic, type_name, *options):
    publishers[topic] = (rospy.Publisher(topic, kind(type_name), queue_size=5000, latch="latch" in options, tcp_nodelay=True), type_name)
    say("publishing", topic)


def send(topic, *text):
    publisher, type_name = publishers[topic]
    publisher.publish(make(type_name, " ".join(text)))


def stream(topic, *text):
    """The same message 50 times a second, as a base's odometry."""
    publisher, type_name = publishers[topic]
    message = make(type_name, " ".join(text))
    rospy.Timer(rospy.Duration(0.02), lambda _event: publisher.publish(message))
    say("streaming", topic)


def connected(topic, count):
    while publishers[topic][0].get_num_connections() < int(count):
        time.sleep(0.005)
    say("connected", topic)


def listening(topic):
    """Says so when a publisher of this has answered. rospy counts a connection before it has begun to connect."""
    while not any(connection.header for connection in subscribers[topic].impl.connections):
        time.sleep(0.005)
    say("listening", topic)


def flood(topic, count):
    publisher, type_name = publishers[topic]
    for i in range(int(count)):
        publisher.publish(kind(type_name)(data=i))
    say("flooded", topic)


def wait_heard(topic, count):
    """Says how many came in order, once there are so many."""
    with counted:
        counted.wait_for(lambda: len(counts[topic]) >= int(count))
        say("heard", topic, str(counts[topic] == list(range(int(count)))))


def echo(source, target):
    publisher = rospy.Publisher(target, kind("kobuki_msgs/Led"), queue_size=100, tcp_nodelay=True)
    rospy.Subscriber(source, kind("kobuki_msgs/BumperEvent"), lambda m: publisher.publish(kind("kobuki_msgs/Led")(m.state)), tcp_nodelay=True)
    say("echoing", source)


def measure(count, *topics):
    """
    Round trips over pairs of topics in turn, so that whatever else the machine does meets all of them alike. Says the median and the
    95th percentile of each pair, in milliseconds.
    """
    message = kind("kobuki_msgs/BumperEvent")(1, 1)
    ways = []
    for topic, back in zip(topics[::2], topics[1::2]):
        came = threading.Event()
        rospy.Subscriber(back, kind("kobuki_msgs/Led"), lambda _m, came=came: came.set(), tcp_nodelay=True)
        publisher = rospy.Publisher(topic, kind("kobuki_msgs/BumperEvent"), queue_size=100, tcp_nodelay=True)
        ways.append((publisher, came, []))
    for publisher, came, _took in ways:  # until both ways are connected
        while True:
            publisher.publish(message)
            if came.wait(0.02):
                break
    for _ in range(int(count)):
        for publisher, came, took in ways:
            time.sleep(0.001)
            came.clear()
            began = time.perf_counter()
            publisher.publish(message)
            if not came.wait(5):
                say("lost")
                return
            took.append((time.perf_counter() - began) * 1000)
    for _publisher, _came, took in ways:
        took.sort()
    say("took", *(f"{took[len(took) * n // 100]:.3f}" for _publisher, _came, took in ways for n in (50, 95)))


def serve(name):
    """A std_srvs/SetBool that agrees to true, fails for false, and answers nothing when it is called "stuck"."""
    from std_srvs.srv import SetBool, SetBoolResponse

    def answer(request):
        say("asked", name, str(request.data))
        if name.endswith("stuck"):
            threading.Event().wait()
        if not request.data:
            raise rospy.ServiceException("false is not for me")
        return SetBoolResponse(True, "grün")

    rospy.Service(name, SetBool, answer)
    say("serving", name)


def add(name):
    """A rospy_tutorials/AddTwoInts."""
    from rospy_tutorials.srv import AddTwoInts, AddTwoIntsResponse

    def answer(request):
        say("asked", name, str(request.a), str(request.b))
        return AddTwoIntsResponse(request.a + request.b)

    rospy.Service(name, AddTwoInts, answer)
    say("serving", name)


def call_service(name, type_name, *texts):
    package, base = type_name.split("/")
    kind = getattr(importlib.import_module(package + ".srv"), base)
    proxy = rospy.ServiceProxy(name, kind, persistent=len(texts) > 1)
    for text in texts:
        request = kind._request_class()
        genpy.message.fill_message_args(request, [json.loads(text)])
        try:
            say("answer", json.dumps(plain(proxy(request))))
        except rospy.ServiceException as error:
            say("failed", str(error))


wheels = threading.Condition()
turning, marked = [False], [None]


def mark():
    """Wheels that stand already would not come to stand, so the marked time begins when they turn."""
    with wheels:
        wheels.wait_for(lambda: turning[0])
        marked[0] = time.monotonic()
        say("marked")


def turn():
    with wheels:
        turning[0] = True
        wheels.notify_all()


def stand():
    with wheels:
        turning[0] = False
        if marked[0] is not None:
            say("stood", f"{time.monotonic() - marked[0]:.3f}")
            marked[0] = None


def watchdog(topic):
    """What kobuki_node does: says so when 0.6 s pass without a command that moves it (cmd_vel_timeout), once per silence."""
    last = [None]

    def on_message(message):
        moving = message.linear.x != 0 or message.angular.z != 0
        last[0] = (time.monotonic(), message) if moving else None
        say("got", topic, json.dumps(plain(message)))
        if moving:
            turn()
        else:
            stand()

    def look(_event):
        moved = last[0]  # messages come on another thread
        if moved is not None and time.monotonic() - moved[0] > 0.6:
            last[0] = None
            say("watchdog")
            stand()

    subscribers[topic] = rospy.Subscriber(topic, kind("geometry_msgs/Twist"), on_message, tcp_nodelay=True)
    rospy.Timer(rospy.Duration(0.1), look)
    say("watching", topic)


def param(verb, name, *text):
    if verb == "set":
        rospy.set_param(name, json.loads(" ".join(text)))
        say("done")
    else:
        say("param", json.dumps(rospy.get_param(name)))


def rosout():
    from rosgraph_msgs.msg import Log

    rospy.Subscriber("/rosout", Log, lambda m: say("log", m.name, str(m.level), m.function, m.msg))
    say("listening")


COMMANDS = {
    "sub": subscribe,
    "pub": publish,
    "send": send,
    "stream": stream,
    "connected": connected,
    "listening": listening,
    "flood": flood,
    "heard": wait_heard,
    "echo": echo,
    "time": measure,
    "serve": serve,
    "add": add,
    "call": call_service,
    "watchdog": watchdog,
    "mark": mark,
    "param": param,
    "rosout": rosout,
}


def main():
    rospy.init_node(sys.argv[1], disable_signals=True)
    rospy.on_shutdown(lambda: say("shutdown"))
    say("ready")
    for line in sys.stdin:
        words = line.split()
        if words == ["quit"]:
            break
        COMMANDS[words[0]](*words[1:])
    rospy.signal_shutdown("quit")


main()
