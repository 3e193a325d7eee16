"""Yujin Kobuki: numbers of the real base with their sources, its sensors, and the order of its events."""

from __future__ import annotations

from ...world.events import Reading
from ...world.robot import Robot
from ..shared.dimensions import body_of, limits_of, scanner_of
from ..shared.gyroscope import Gyroscope
from ..shared.navigate_drive import NAVIGATE_ACTION, NavigateDrive
from .connector import Connector
from .dock_drive import DOCK_ACTION, DockDrive
from .dock_receivers import DockReceivers
from .line_sensor import LineSensor
from .power import Power
from .sensors import bumper_bits, cliff_bits, edges, hanging_wheels, states

__all__ = ["KOBUKI"]

KOBUKI = Robot(
    name="kobuki",
    body=body_of("kobuki"),
    limits=limits_of("kobuki"),
    online=Reading("RobotStatus", (1,)),
    bumpers=bumper_bits,
    cliffs=cliff_bits,
    hanging_wheels=hanging_wheels,
    changes=edges,
    states=states,
    outputs={
        "Led1": (0,),
        "Led2": (0,),
        "ExternalPower": (1, 1, 1, 1),
        "MotorPower": (1,),
        "Pen": (0,),
        "PenColor": (0,),
        "PenWidth": (0.03,),
    },
    motor_switch="MotorPower",
    devices=(Gyroscope, Power, DockReceivers, Connector, LineSensor),
    actions={DOCK_ACTION: DockDrive, NAVIGATE_ACTION: NavigateDrive},
    scanner=scanner_of("kobuki"),
)
