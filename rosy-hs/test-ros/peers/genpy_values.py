"""
Pseudo-random values of ROS messages, and what genpy makes of them.

In: a seed, a folder with genpy's modules, and folders of message definitions as arguments; on standard input a line for each
message, its name; with the name of its service behind it for a request or response; and `NAME service` for a service.
Out: for each name one line of fields between tabs: name, MD5 sum, the zero value as hexadecimal bytes and as Haskell shows it, the
constants as Haskell shows them, the full definition in hexadecimal, and for each of three values its bytes and what genpy reads from them as Haskell shows it. For a service its name and sum.
"""

import importlib.util
import io
import keyword
import random
import struct
import sys
from pathlib import Path

from genmsg import MsgContext
from genmsg.msg_loader import load_depends, load_msg_by_type, load_srv_by_type
from genpy import Duration, Message, Time
from genpy.rostime import TVal

CONTROL = ["NUL", "SOH", "STX", "ETX", "EOT", "ENQ", "ACK", "a", "b", "t", "n", "v", "f", "r", "SO", "SI", "DLE", "DC1", "DC2", "DC3", "DC4", "NAK", "SYN", "ETB", "CAN", "EM", "SUB", "ESC", "FS", "GS", "RS", "US"]
VALUES = 3
RANGES = {"int8": 8, "byte": 8, "int16": 16, "int32": 32, "int64": 64}
UNSIGNED = {"uint8": 8, "char": 8, "uint16": 16, "uint32": 32, "uint64": 64}
HASKELL_WORDS = set(
    "case class data default deriving do else forall foreign if import in infix infixl infixr instance let module newtype of then type where".split()
)
LETTERS = "abc XYZ019\"\\'#=\t\n\x00\x0e\x7fH\u00e9\u00df\u20ac\U0001f916"


def main():
    seed, modules, *folders = sys.argv[1:]
    sys.path.insert(0, modules)
    context = MsgContext.create_default()
    search = {}
    for folder in folders:
        path = Path(folder)
        search.setdefault(path.parent.name if path.name in ("msg", "srv") else path.name, []).append(folder)
    for line in sys.stdin:
        name, *service = line.split()
        if service == ["service"]:
            print("\t".join([name, class_of(name)._md5sum]))
        elif service:
            spec = load_srv_by_type(context, service[0], search)
            half = next(half for half in (spec.request, spec.response) if half.full_name == name)
            load_depends(context, half, search)
            print("\t".join(facts(seed, name, half)))
        else:
            print("\t".join(facts(seed, name, load_msg_by_type(context, name, search))))


def facts(seed, name, spec):
    kind = class_of(name)
    constants = [show(getattr(kind, c.name), c.type) for c in spec.constants]
    random_source = random.Random(f"{seed} {name}")
    found = [name, kind._md5sum, written(kind()).hex(), show(kind(), name), " ".join(constants) or "-", kind._full_text.encode().hex() or "-"]
    for _ in range(VALUES):
        data = written(filled(kind, random_source))
        found += [data.hex() or "-", show(kind().deserialize(data), name)]
    found[2] = found[2] or "-"
    return found


def class_of(name):
    package, base = name.split("/")
    for part in (".msg", ".srv"):
        if importlib.util.find_spec(package) and importlib.util.find_spec(package + part):
            found = getattr(importlib.import_module(package + part), base, None)
            if found:
                return found
    raise LookupError(name)


def written(message):
    buffer = io.BytesIO()
    message.serialize(buffer)
    return buffer.getvalue()


def filled(kind, source):
    return kind(*(value(t, source) for t in kind._slot_types)) if kind.__slots__ else kind()


def value(ros_type, source):
    if ros_type.endswith("]"):
        element, size = ros_type[:-1].split("[")
        count = int(size) if size else source.randrange(4)
        many = [value(element, source) for _ in range(count)]
        return bytes(many) if element in ("uint8", "char") else many
    if ros_type == "bool":
        return source.random() < 0.5
    if ros_type in RANGES:
        half = 1 << (RANGES[ros_type] - 1)
        return source.choice([-half, half - 1, -1, 0, source.randrange(-half, half)])
    if ros_type in UNSIGNED:
        end = 1 << UNSIGNED[ros_type]
        return source.choice([0, end - 1, source.randrange(end)])
    if ros_type in ("float32", "float64"):
        # Numbers whose digits are few, so that all of them are printed: Haskell and Python round differently where they may choose.
        largest = 6 if ros_type == "float32" else 30
        return source.choice([0.0, source.randrange(-80000, 80000) / 8, source.randrange(1 << 16) * 2.0 ** source.randrange(-3, largest)])
    if ros_type == "string":
        return "".join(source.choice(LETTERS) for _ in range(source.randrange(8)))
    if ros_type == "time":
        return Time(source.randrange(1 << 32), source.randrange(10**9))
    if ros_type == "duration":
        return Duration(source.randrange(-(1 << 31), 1 << 31), source.randrange(10**9))
    return filled(class_of("std_msgs/Header" if ros_type == "Header" else ros_type), source)


def show(it, ros_type):
    """The value as the derived Show of the generated Haskell type prints it."""
    if isinstance(it, Message):
        base = type(it)._type.split("/")[1]
        name = base[0].upper() + base[1:]
        slots = ", ".join(f"_{field(slot)} = {show(getattr(it, slot), t)}" for slot, t in zip(it.__slots__, it._slot_types))
        return f"{name} {{{slots}}}" if slots else name
    if ros_type.endswith("]"):
        element = ros_type.split("[")[0]
        return "[" + ",".join(show(x, element) for x in it) + "]"
    if isinstance(it, TVal):
        return f"({it.secs},{it.nsecs})"
    if isinstance(it, str):
        return quoted(it)
    if ros_type == "bool":
        return str(bool(it))
    if ros_type in ("float32", "float64"):
        return shown_float(it, ros_type)
    return str(it)


def field(slot):
    """genpy puts an underscore behind what is a word of Python's; the generator puts one before what is a word of Haskell's."""
    name = slot[:-1] if slot.endswith("_") and keyword.iskeyword(slot[:-1]) else slot
    return f"_{name}" if name in HASKELL_WORDS else name


def shown_float(number, ros_type):
    if number in (float("inf"), float("-inf")):
        return "Infinity" if number > 0 else "-Infinity"
    if number == 0:
        return "0.0"
    sign = "-" if number < 0 else ""
    digits, exponent = shortest(abs(number), ros_type)
    if 0.1 <= abs(number) < 10**7:
        whole = digits[:exponent].ljust(exponent, "0") if exponent > 0 else ""
        rest = digits[exponent:] if exponent > 0 else "0" * -exponent + digits
        return f"{sign}{whole or '0'}.{rest or '0'}"
    return f"{sign}{digits[0]}.{digits[1:] or '0'}e{exponent - 1}"


def shortest(number, ros_type):
    """The fewest digits that mean this number, and the place of the point behind the first of them."""
    for places in range(17):
        text = f"{number:.{places}e}"
        again = float(text) if ros_type == "float64" else struct.unpack("<f", struct.pack("<f", float(text)))[0]
        if again == (number if ros_type == "float64" else struct.unpack("<f", struct.pack("<f", number))[0]):
            break
    mantissa, exponent = text.split("e")
    return mantissa.replace(".", "").rstrip("0") or "0", int(exponent) + 1


def quoted(text):
    out = []
    for c in text:
        code = ord(c)
        if out and ((out[-1][:1] == "\\" and out[-1][1:].isdigit() and c in "0123456789") or (out[-1] == "\\SO" and c == "H")):
            out.append("\\&")
        if c in "\"\\":
            out.append("\\" + c)
        elif code < 32:
            out.append("\\" + CONTROL[code])
        elif code == 127:
            out.append("\\DEL")
        elif code > 127:
            out.append(f"\\{code}")
        else:
            out.append(c)
    return '"' + "".join(out) + '"'


main()
