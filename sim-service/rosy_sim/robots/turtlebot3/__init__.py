"""TurtleBot 3 Burger of ROBOTIS: small, with a laser scanner and two buttons, without bumpers and cliff sensors."""

from __future__ import annotations

from ...world.robot import Robot
from ..shared.dimensions import body_of, limits_of, scanner_of
from ..shared.gyroscope import Gyroscope
from ..shared.navigate_drive import NAVIGATE_ACTION, NavigateDrive
from .battery import LithiumBattery
from .sensors import button_edges, hanging_wheels, no_bits, no_contacts, states

__all__ = ["TURTLEBOT3"]

TURTLEBOT3 = Robot(
    name="turtlebot3",
    body=body_of("turtlebot3"),
    limits=limits_of("turtlebot3"),
    online=None,
    bumpers=no_contacts,
    cliffs=no_bits,
    hanging_wheels=hanging_wheels,
    changes=button_edges,
    states=states,
    outputs={"MotorPower": (1,)},
    motor_switch="MotorPower",
    devices=(Gyroscope, LithiumBattery),
    actions={NAVIGATE_ACTION: NavigateDrive},
    scanner=scanner_of("turtlebot3"),
)
