"""Yujin Kobuki: numbers of the real base with their sources, its sensors, and the order of its events."""

from __future__ import annotations

from ...world.events import Reading
from ...world.robot import Body, MotorLimits, Robot, ScannerModel
from ...world.time_step import STEPS_PER_SECOND
from . import facts
from .connector import Connector
from .dock_drive import DOCK_ACTION, DockDrive
from .dock_receivers import DockReceivers
from .gyroscope import Gyroscope
from .power import Power
from .sensors import bumper_bits, cliff_bits, edges, hanging_wheels, states

__all__ = ["KOBUKI"]

KOBUKI = Robot(
    name="kobuki",
    body=Body(facts.RADIUS, facts.MASS, facts.INERTIA, facts.WHEELBASE, facts.CONTACT_GAP),
    limits=MotorLimits(
        speed=facts.MAX_SPEED,
        angular_speed=facts.MAX_ANGULAR_SPEED,
        wheel_speed=facts.MAX_WHEEL_SPEED,
        wheelbase=facts.WHEELBASE,
        acceleration=facts.MAX_ACCELERATION,
        angular_acceleration=facts.MAX_ANGULAR_ACCELERATION,
        command_timeout=facts.COMMAND_TIMEOUT,
    ),
    online=Reading("RobotStatus", (1,)),
    bumpers=bumper_bits,
    cliffs=cliff_bits,
    hanging_wheels=hanging_wheels,
    changes=edges,
    states=states,
    outputs={"Led1": (0,), "Led2": (0,), "ExternalPower": (1, 1, 1, 1), "MotorPower": (1,)},
    motor_switch="MotorPower",
    devices=(Gyroscope, Power, DockReceivers, Connector),
    actions={DOCK_ACTION: DockDrive},
    scanner=ScannerModel(
        beams=facts.SCANNER_BEAMS,
        nearest=facts.SCANNER_NEAREST,
        farthest=facts.SCANNER_FARTHEST,
        period=round(facts.SCANNER_PERIOD * STEPS_PER_SECOND),
        ahead=facts.AHEAD_HALF_WIDTH,
    ),
)
