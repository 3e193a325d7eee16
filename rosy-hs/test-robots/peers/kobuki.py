"""
A Kobuki at the end of a pseudo-terminal.

In: command packets on the terminal; on standard input `bump BITS`, `cliff BITS`, `drop BITS`, `press BITS`, `noise`, `cut`, `corrupt`,
`silence`, `speak`, `unplug`, `plug`, `firmware MAJOR`, `mute` (it answers no question), `timeout SECONDS`, `slip TRAVEL TURNING VEER` (it drives and turns this part of what it is told, and VEER rad to the left for each metre), `hush` (no more packets of its own), `replay HEX`, `nudge` (one packet at once), `static` (only noise from now on, in which no packet is whole), `mark`, `quit`; the path of a symbolic link as the argument, to which its process number is added. Out: a packet every 20 ms; on
standard output `plugged PATH`, `first V W` for the first speed it is told behind that, `control V W` when the speed changes, `led1 BITS`, `led2 BITS`, `sound N`, `versions asked`, `versions told` for the first time behind `plugged`, `bad BYTES`, after `mark` `stood SECONDS` when
its wheels stand, by its own clock.
Its wheels turn as told; counters wrap at 16 bits and begin shortly before that. Yujin documents no time after which the firmware stops
a base that hears nothing (protocol specification, firmware change log), so this one drives on; after `timeout SECONDS` it does not.
"""

import math
import os
import select
import struct
import sys
import time
import tty

link = f"{sys.argv[1]}-{os.getpid()}"
BASE, TICKS_PER_METRE = 0.23, 11724.41658
NOTHING = bytes([3, 3, 0, 0, 0])
"""A packet that says nothing of the base itself: no dock is seen."""

master = slave = None
speed = [0.0, 0.0]
bits = {"bump": 0, "cliff": 0, "drop": 0, "press": 0}
left, right = 65000.0, 65000.0
heading, stamp = 17000.0, 65000
faults, firmware, speaking, replaying = [], 1, True, False
outputs, versions_due, versions_told, mute, marked = None, False, False, False, None
static = False
slip = [1.0, 1.0, 0.0]
fresh, patience, told_at = True, None, 0.0
buffer = b""


def say(*words):
    print(*words, flush=True)


def plug():
    global master, slave, fresh, versions_due, versions_told
    fresh, versions_due, versions_told = True, False, False
    master, slave = os.openpty()
    tty.setraw(slave)
    os.set_blocking(master, False)
    if os.path.lexists(link):
        os.unlink(link)
    os.symlink(os.ttyname(slave), link)
    say("plugged", link)


def unplug():
    global master, slave, buffer
    if os.path.lexists(link):
        os.unlink(link)
    os.close(slave)
    os.close(master)
    master = slave = None
    buffer = b""


def framed(payload):
    body = bytes([len(payload)]) + payload
    check = 0
    for byte in body:
        check ^= byte
    return b"\xaa\x55" + body + bytes([check])


def tell(packet):
    try:
        os.write(master, packet)
    except BlockingIOError:
        pass  # no reader


def driven():
    """How fast it drives and turns, for the speed that it was told."""
    v = speed[0] * slip[0]
    return v, speed[1] * slip[1] + v * slip[2]


def move():
    global left, right, heading, stamp
    v, w = driven()
    left += (v - w * BASE / 2) * 0.02 * TICKS_PER_METRE
    right += (v + w * BASE / 2) * 0.02 * TICKS_PER_METRE
    heading = (heading + math.degrees(w) * 100 * 0.02 + 18000) % 36000 - 18000
    stamp = (stamp + 20) % 65536


def versions():
    """The answer to the question for them, if it was asked."""
    global versions_due, versions_told
    if not versions_due:
        return b""
    versions_due = False
    if not versions_told:
        versions_told = True
        say("versions told")
    return bytes([10, 4, 0, 0, 1, 0]) + bytes([11, 4, 0, 2, firmware, 0]) + bytes([19, 12]) + struct.pack("<III", 1, 2, 3)


def feedback():
    core = struct.pack("<HBBBHHbbBBBB", stamp, bits["bump"], bits["drop"], bits["cliff"], int(left) % 65536, int(right) % 65536, 0, 0, bits["press"], 0, 160, 0)
    payload = bytes([1, 15]) + core + bytes([3, 3, 0, 0, 0])
    payload += bytes([4, 7]) + struct.pack("<hhBBB", int(heading), int(math.degrees(driven()[1]) * 100), 0, 0, 0)
    payload += bytes([5, 6]) + bytes(6) + bytes([6, 2, 0, 0]) + bytes([13, 14, 1, 6]) + bytes(12) + bytes([16, 16]) + bytes(16)
    return framed(payload + versions())


def spoil(packet):
    fault = faults.pop() if faults else None
    if fault == "noise":
        return b"\xaa\x55\x03\xaa\xaa\x55" + packet
    if fault == "cut":
        return packet[: len(packet) // 2]
    if fault == "corrupt":
        return corrupted(packet)
    return packet


def corrupted(packet):
    return packet[:6] + bytes([packet[6] ^ 7]) + packet[7:]


def stand():
    global marked
    if marked is not None:
        say("stood", f"{time.monotonic() - marked:.3f}")
        marked = None


def watch():
    """What a firmware with a timeout would do; ours has none until it is told one."""
    if patience is not None and time.monotonic() - told_at > patience:
        if speed != [0.0, 0.0]:
            speed[:] = [0.0, 0.0]
            say("watchdog")
        # Also when they stood before the mark: nothing else would say so.
        stand()


def on_part(ident, data):
    global versions_due, outputs, fresh, told_at
    if ident == 1:
        s, r = struct.unpack("<hh", data)
        if r == 0:
            new = [s / 1000, 0.0]
        elif abs(r) == 1:
            new = [0.0, s / 1000 / (BASE / 2)]
        else:
            w = s / (r + math.copysign(BASE * 500, r))
            new = [w * r / 1000, w]
        told_at = time.monotonic()
        if fresh:
            fresh = False
            say("first", f"{new[0]:.3f}", f"{new[1]:.3f}")
        if new != speed:
            speed[:] = new
            say("control", f"{new[0]:.3f}", f"{new[1]:.3f}", s, r)
        if new == [0.0, 0.0]:
            stand()
    elif ident == 12:
        word = struct.unpack("<H", data)[0]
        if outputs is None or (word ^ outputs) & 0x0300:
            say("led1", word >> 8 & 3)
        if outputs is None or (word ^ outputs) & 0x0C00:
            say("led2", word >> 10 & 3)
        outputs = word
    elif ident == 4:
        say("sound", data[0])
    elif ident == 9:
        say("versions asked")
        versions_due = not mute
    else:
        say("bad", ident, data.hex())


def on_bytes(data):
    global buffer
    buffer += data
    while len(buffer) >= 4:
        if buffer[:2] != b"\xaa\x55":
            say("bad", buffer[:1].hex())
            buffer = buffer[1:]
            continue
        n = buffer[2]
        if len(buffer) < n + 4:
            return
        payload, check = buffer[3 : 3 + n], n
        for byte in buffer[3 : 4 + n]:
            check ^= byte
        if check:
            say("bad", buffer[: n + 4].hex())
        while payload and not check:
            on_part(payload[0], payload[2 : 2 + payload[1]])
            payload = payload[2 + payload[1] :]
        buffer = buffer[n + 4 :]


def on_line(words):
    global firmware, mute, speaking, replaying, static, outputs, marked, patience
    if words[0] in bits:
        bits[words[0]] = int(words[1])
    elif words[0] in ("noise", "cut", "corrupt"):
        faults.append(words[0])
    elif words[0] in ("silence", "speak"):
        speaking = words[0] == "speak"
    elif words[0] == "static":
        static = True
    elif words[0] == "hush":
        replaying = True
        say("hushed")
    elif words[0] == "replay":
        replaying = True
        tell(bytes.fromhex(words[1]))
    elif words[0] == "nudge":
        tell(framed(NOTHING))
    elif words[0] == "unplug":
        unplug()
        outputs = None
    elif words[0] == "mark":
        marked = time.monotonic()
        say("marked")
    elif words[0] == "plug":
        plug()
    elif words[0] == "timeout":
        patience = float(words[1])
    elif words[0] == "slip":
        slip[:] = [float(word) for word in words[1:4]]
    elif words[0] == "mute":
        mute = True
    elif words[0] == "firmware":
        firmware = int(words[1])
    elif words[0] == "quit":
        sys.exit()


plug()
due = time.monotonic()
pending = ""
while True:
    ready = select.select([0] + ([master] if master is not None else []), [], [], max(0, due - time.monotonic()))[0]
    if 0 in ready:
        data = os.read(0, 4096).decode()
        if not data:
            break
        pending += data
        *lines, pending = pending.split("\n")
        for line in lines:
            on_line(line.split())
    if master is not None and master in ready:
        try:
            on_bytes(os.read(master, 4096))
        except OSError:
            pass
    if time.monotonic() >= due:
        due += 0.02
        watch()
        move()
        if master is not None and static:
            tell(corrupted(feedback()))
        elif master is not None and replaying:
            tell(framed(NOTHING + versions()))
        elif master is not None and speaking:
            tell(spoil(feedback()))
