"""What a Kobuki is: every number the physics uses, with its unit and the place it comes from."""

from __future__ import annotations

import math

__all__ = [
    "BUMPER_BEARINGS",
    "BUMPER_HALF_WIDTH",
    "CLIFF_POINTS",
    "COMMAND_TIMEOUT",
    "CONTACT_GAP",
    "INERTIA",
    "MASS",
    "MAX_ACCELERATION",
    "MAX_ANGULAR_ACCELERATION",
    "MAX_ANGULAR_SPEED",
    "MAX_SPEED",
    "RADIUS",
    "STEP",
    "WHEELBASE",
    "WHEEL_POINTS",
]

STEP = 0.02
"""Time between two sensor packets, s. kobuki_core, doc: the base streams at 50 Hz."""

RADIUS = 0.17575
"""Half the diameter of 351.5 mm, m. Kobuki factory drawing, 2012-11-30."""

MASS = 2.4
"""With the small battery, kg. kobuki_description, urdf/kobuki.urdf.xacro (base_link inertial)."""

INERTIA = 0.03675
"""About the vertical axis, kg m². kobuki_description, urdf/kobuki.urdf.xacro (izz)."""

WHEELBASE = 0.230
"""Distance between the wheels, m. kobuki_core, src/driver/diff_drive.cpp (``bias``)."""

MAX_SPEED = 0.70
"""Top translational speed, m/s. kobuki_documentation, doc/specifications.rst: 70 cm/s."""

MAX_ANGULAR_SPEED = math.pi
"""Top rotational speed, rad/s. kobuki_documentation, doc/specifications.rst: 180 deg/s."""

MAX_ACCELERATION = 2.0
"""Change of speed in either direction, m/s². The firmware has no limit of its own; turtlebot_bringup,
param/defaults/smoother.yaml remarks that the real maximum is about 2 m/s²."""

MAX_ANGULAR_ACCELERATION = 7.0
"""Change of angular speed in either direction, rad/s². kobuki_keyop, param/keyop_smoother.yaml."""

COMMAND_TIMEOUT = 0.6
"""A velocity command older than this stops the robot, s. kobuki_node, param/base.yaml
(``cmd_vel_timeout``). The node looks ten times a second; here the limit is exact."""

BUMPER_BEARINGS = (math.radians(60), 0.0, math.radians(-60))
"""Middle of the left, centre and right bumper zone, rad. kobuki_gazebo_plugins,
src/gazebo_ros_kobuki_updates.cpp: +90..+30, +30..-30, -30..-90 degrees."""

BUMPER_HALF_WIDTH = math.radians(30)
"""Half a bumper zone, rad. Same place. A contact on a border presses both sides of it."""

CONTACT_GAP = 0.001
"""A thing nearer to the body than this presses the bumper, m. Our choice: the ring's travel
is a few millimetres, and the physics keeps bodies apart to a tenth of one."""

CLIFF_POINTS = ((0.08734, 0.13601), (0.156, 0.0), (0.085, -0.13601))
"""Left, centre and right cliff sensor in the robot frame, m. kobuki_description,
urdf/kobuki_gazebo.urdf.xacro (cliff_sensor_*_joint)."""

WHEEL_POINTS = ((0.0, WHEELBASE / 2), (0.0, -WHEELBASE / 2))
"""Where the left and right wheel touch the floor, m. kobuki_description, urdf/kobuki.urdf.xacro."""
