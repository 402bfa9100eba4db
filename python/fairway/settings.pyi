# SPDX-License-Identifier: Apache-2.0
# Written by python/tools/write_settings_stub.py; a test compares the two.
import os
from typing import ClassVar, Literal

import numpy as np
import numpy.typing as npt

class RobotSettings:
    """Settings of the group `robot`."""

    radius: float
    """[m] radius of the disc that covers the robot"""
    length: float
    """[m] length of a rectangular body; 0: the body is the disc"""
    width: float
    """[m] width of a rectangular body; 0: the body is the disc"""
    discs: npt.NDArray[np.float64]
    """[m] discs that form the body, in the robot's frame; none: the body is the rectangle or the disc"""
    linear_min: float
    """[m/s] least linear speed; negative allows reversing"""
    linear_max: float
    """[m/s] greatest linear speed"""
    angular_max: float
    """[rad/s] greatest angular speed"""
    linear_acceleration_max: float
    """[m/s^2] greatest change of linear speed per second"""
    angular_acceleration_max: float
    """[rad/s^2] greatest change of angular speed per second"""
    linear_braking_max: float
    """[m/s^2] greatest loss of linear speed per second; 0: linear_acceleration_max"""
    angular_braking_max: float
    """[rad/s^2] greatest loss of angular speed per second; 0: angular_acceleration_max"""
    linear_delay: float
    """[s] time until a linear command begins to act"""
    angular_delay: float
    """[s] time until an angular command begins to act"""
    linear_lag: float
    """[s] time constant with which the base's linear speed follows its command"""
    angular_lag: float
    """[s] time constant with which the base's angular speed follows its command"""

class MapSettings:
    """Settings of the group `map`."""

    unknown_is_occupied: bool
    """whether unknown cells count as obstacles"""

class PathSettings:
    """Settings of the group `path`."""

    margin: float
    """[m] clearance that every path keeps beyond the robot's radius; a greater value closes narrow gaps"""
    comfort_distance: float
    """[m] clearance beyond the margin below which a metre of path costs more; a greater value keeps paths further from
    obstacles"""
    comfort_weight: float
    """extra cost of a metre of path at the least clearance; a greater value accepts longer detours for more clearance"""
    any_angle: bool
    """whether paths are straightened into lines of sight instead of following the grid"""

class CorridorSettings:
    """Settings of the group `corridor`."""

    method: str
    """how rectangles are built: mdsrc (Algorithms 1 and 2 of the paper) or fewest (as few and as large as possible)"""
    space: str
    """where rectangles are free: workspace (of obstacles, as in the paper) or configuration (for the centre of the
    robot's disc)"""
    num_orientations: int
    """number of orientations that mdsrc tries; more give larger rectangles and take longer"""
    growth_step: float
    """[m] step by which a side advances in mdsrc; a smaller step takes longer"""
    max_growth: float
    """[m] greatest distance of a side from the seed in mdsrc"""
    longest_side: float
    """[m] longest side of a rectangle of fewest; a greater value gives fewer and larger rectangles"""
    inward_offset: float
    """[m] least distance between the robot's centre and the sides, in workspace only"""
    min_overlap_area: float
    """[m^2] least overlap of consecutive rectangles; a greater value eases the change from one to the next"""
    waypoint_spacing: float
    """[m] spacing of the path points that mdsrc grows rectangles from"""

class PlanningSettings:
    """Settings of the group `planning`."""

    background: bool
    """whether plans are made in a thread, so that no control cycle waits; if not, the cycle that needs a plan makes it"""
    rebuild_period: float
    """[s] period of new plans; 0: a new plan only when it is needed"""
    retry_period: float
    """[s] time between attempts while no plan is found or a better one is searched"""

class MpcSettings:
    """Settings of the group `mpc`."""

    horizon: int
    """[steps] number of steps planned ahead; more steps look further ahead and take longer"""
    step_length: float
    """[s] time between the steps of the horizon; a greater value looks further ahead and models motion less exactly"""
    integration: str
    """integration of the model over a step: euler (as in the paper) or midpoint (more exact)"""
    weight_position: float
    """[1/m^2] weight of the distance to the target (Q1); a greater value follows the reference path more closely"""
    weight_heading: float
    """[1/rad^2] weight of the deviation from the target heading (Q1); a greater value aligns the robot with the
    reference path sooner"""
    weight_next_position: float
    """[1/m^2] weight of the distance to the second target (Q2); a greater value draws the robot towards it earlier"""
    weight_next_heading: float
    """[1/rad^2] weight of the deviation from the second target heading (Q2)"""
    weight_linear: float
    """[s^2/m^2] weight of linear speed (R); a greater value drives more slowly"""
    weight_angular: float
    """[s^2/rad^2] weight of angular speed (R); a greater value turns more gently"""
    weight_linear_change: float
    """[s^2/m^2] weight of a change of linear speed (S); a greater value accelerates more gently"""
    weight_angular_change: float
    """[s^2/rad^2] weight of a change of angular speed (S); a greater value steers more smoothly"""
    penalise_first_change: bool
    """whether the change from the command being executed is weighted too"""
    decay_rate: float
    """[1/s] greatest rate at which a barrier may decrease (gamma), at most 1/step_length; a greater value approaches
    moving obstacles faster"""
    violation_weight: float
    """[1/m] penalty weight of leaving the corridor or entering a keep-out disc; too small a value trades violations for
    progress"""
    max_iterations: int
    """iteration budget of one solve; a greater value converges more often and may take longer"""

class TrackingSettings:
    """Settings of the group `tracking`."""

    target_mode: str
    """targets of the controller: reference_path (moving along the shortest path), dual_waypoints (of the paper) or
    overlap_centroid (SMPC)"""
    step_regions: bool
    """whether each step of the horizon is constrained to the rectangle it is expected in; if not, all are to the
    current one"""
    corner_deviation: float
    """[m] distance by which the robot may cut a corner of the reference path; a greater value allows more speed there"""
    corner_clearance: float
    """[m] distance that the reference path keeps from the corners of overlaps, where there is space; a greater value
    takes corners wider"""
    chord_length: float
    """[m] look-ahead on the reference path for the target heading; a greater value turns earlier"""
    space_time_horizon: float
    """[s] time for which a motion among moving obstacles is planned ahead of the controller; 0: the controller follows
    the reference path"""

class PredictionSettings:
    """Settings of the group `prediction`."""

    obstacle_margin: float
    """[m] distance kept from moving obstacles beyond both radii"""
    predict_motion: bool
    """predict that moving obstacles keep their velocity; if not, that they stop"""
    obstacle_growth: float
    """[m/s] growth of that distance per second ahead, since predictions err"""
    obstacle_growth_max: float
    """[m] greatest growth of that distance"""
    comfort_distance: float
    """[m] distance that the robot prefers to keep from moving obstacles, beyond obstacle_margin and its braking
    distance; a greater value takes longer detours"""
    time_headway: float
    """[s] time by which the robot prefers to stay out of the path of a moving obstacle; a greater value passes behind
    rather than in front"""
    deviation_growth: float
    """[m/s] growth of the standard deviation of predictions per second ahead, beyond the controller's horizon"""

class SafetySettings:
    """Settings of the group `safety`."""

    actuation_lag: float
    """[cycles] time until the base follows a command, in control periods; 0.5 is a linear ramp"""
    longest_hold: float
    """[cycles] longest time from one command to the next that the check of the stop covers, in control periods; a later
    cycle brakes"""
    stop_margin: float
    """[m] clearance beyond the body in the check of the stop"""
    moving_margin: float
    """[m] distance from moving obstacles in the check of the stop; at most prediction.obstacle_margin counts"""
    turn_clearance_tolerance: float
    """[m] how far a body that is no disc may go where its covering disc does not fit"""
    pose_timeout: float
    """[s] oldest pose that is used"""
    pose_jump: float
    """[m] distance between a pose and the one predicted from the commands, beyond half of the distance driven since,
    that counts as a jump"""
    map_timeout: float
    """[s] oldest changing map that is used"""
    tracks_timeout: float
    """[s] oldest obstacle tracks that are used"""

class NavigationSettings:
    """Settings of the group `navigation`."""

    control_period: float
    """[s] period of the commands; it must match the rate at which the base receives them"""
    goal_tolerance: float
    """[m] distance at which the goal counts as reached; a greater value arrives sooner and less exactly"""
    heading_tolerance: float
    """[rad] heading error at which the heading of the goal counts as reached; 3.15 ignores the heading"""
    stall_timeout: float
    """[s] standstill away from the goal after which a recovery starts; a greater value waits longer for obstacles to
    move"""
    patience: float
    """[s] time without progress after which the goal is dropped; 0: never"""

class PerceptionSettings:
    """Settings of the group `perception`."""

    window: float
    """[m] side of the square map around the robot; a greater value remembers a wider area and takes longer"""
    resolution: float
    """[m] side of a cell of the map; a smaller value resolves narrower gaps and takes longer"""
    reach: float
    """[m] greatest length at which beams are used; longer ones are cut"""
    hit_depth: float
    """[m] distance added to a beam's end before it is entered into the map, which offsets the part of a cell that
    extends in front of the hit; a greater value keeps narrow gaps open"""
    hit_snap: float
    """[m] distance within which a hit in front of a known obstacle counts for that obstacle; a greater value suppresses
    more range noise"""
    hit_evidence: int
    """evidence added to the cell in which a beam ends; a greater value adds obstacles sooner"""
    miss_evidence: int
    """evidence removed from a cell that a beam crosses; a greater value clears cells sooner"""
    most_evidence: int
    """greatest evidence of an occupied cell; a greater value holds obstacles longer"""
    least_evidence: int
    """evidence of a surely free cell (negative); a lower value needs more scans to add an obstacle there"""
    cluster_gap: float
    """[m] greatest gap between neighbouring points of one moving object; a greater value joins objects that are close
    together"""
    object_size: float
    """[m] greatest diameter of a moving object; larger ones are static"""
    moving_speed: float
    """[m/s] speed below which an object counts as static"""
    moving_distance: float
    """[m] distance that an object must move before it counts as moving; a greater value gives fewer false detections
    and later true ones"""
    acceleration_noise: float
    """[m/s^2] acceleration noise of moving objects; a greater value follows changes of velocity sooner and smooths less"""
    forget_after: float
    """[s] time after which a hidden moving object is forgotten"""
    uncertainty_share: float
    """number of standard deviations of its position added to a moving object's radius; a greater value keeps more
    distance"""
    match_scans: bool
    """whether poses by odometry are corrected by matching each scan with the surfaces seen before; without a map only"""
    max_beams: int
    """number of beams used of a scan, the first ones"""

class Settings:
    """All settings of Fairway, by groups. An assignment checks type and range."""

    __hash__: ClassVar[None]  # type: ignore[assignment]
    def __init__(self, preset: Literal["default", "paper"] = "default") -> None: ...
    @property
    def robot(self) -> RobotSettings: ...
    @property
    def map(self) -> MapSettings: ...
    @property
    def path(self) -> PathSettings: ...
    @property
    def corridor(self) -> CorridorSettings: ...
    @property
    def planning(self) -> PlanningSettings: ...
    @property
    def mpc(self) -> MpcSettings: ...
    @property
    def tracking(self) -> TrackingSettings: ...
    @property
    def prediction(self) -> PredictionSettings: ...
    @property
    def safety(self) -> SafetySettings: ...
    @property
    def navigation(self) -> NavigationSettings: ...
    @property
    def perception(self) -> PerceptionSettings: ...
    @staticmethod
    def read(path: str | os.PathLike[str]) -> Settings: ...
    @staticmethod
    def parse(text: str) -> Settings: ...
    def assign(self, assignment: str) -> None: ...
    def validate(self) -> None: ...
    def yaml(self, essential: bool = False) -> str: ...
    def changed(self) -> dict[str, str]: ...
    def copy(self) -> Settings: ...
    def __copy__(self) -> Settings: ...
    def __deepcopy__(self, memo: dict[int, object]) -> Settings: ...
    def __eq__(self, other: object) -> bool: ...
