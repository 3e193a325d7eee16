"""
Recorder of the hands on the simulated robot of a page: they are applied between two steps of a run, and kept with it.
"""

from __future__ import annotations

from collections.abc import Callable

from ....errors import BadInput
from ....previews.preview import PreviewTask
from ....run.simulated_run import SimulatedRun
from ....run.steps.hands import HandAction, RecordedHands, write_hands
from ....run.steps.lockstep import Lockstep
from ....run.steps.replay import CommandLog, Replay
from ....run.steps.velocity_guard import SafetySettings
from ....sentences.sentence import tr
from ....wire import page
from ..run_history import RunHistory

__all__ = ["HandsRecorder"]


_MAX_KEPT_STEPS = 60_000
"""Steps of the runs before the last one whose commands are kept, together: 20 minutes."""


class HandsRecorder:
    """``current_run`` returns the simulated run of the page, if there is one."""

    def __init__(self, current_run: Callable[[], SimulatedRun | None]) -> None:
        self._current_run = current_run
        # Of the last run in this room; what a preview and a continued run repeat.
        self._recorded = RecordedHands()
        self._commands = CommandLog()
        # The number of that run; None when there is none that could be repeated.
        self._run: int | None = None
        # The runs before it in this room.
        self._earlier: RunHistory[tuple[RecordedHands, CommandLog]] = RunHistory(_MAX_KEPT_STEPS)
        # Actions deferred to the end of the step in progress.
        self._waiting: list[Callable[[], None]] = []

    def between_steps(self, act: Callable[[], None]) -> None:
        """Act on the robot now, or at the end of the step that is in progress, so that it can be repeated."""
        run = self._current_run()
        if run is not None and run.is_in_step:
            self._waiting.append(act)
        else:
            act()

    def after_step(self) -> None:
        """Run the actions that were deferred to the end of the step, or of the replay."""
        if not self._waiting:
            return
        run = self._current_run()
        if run is not None and run.is_replaying:
            return
        waiting, self._waiting = self._waiting, []
        for act in waiting:
            act()

    def record(self, action: HandAction) -> None:
        """An action was applied."""
        run = self._current_run()
        if run is not None:
            self._recorded.add(run.step, action)

    def record_safety(self, settings: SafetySettings) -> None:
        """The safety rules were switched: for the current run from now on, or for what is repeated of the last one."""
        run = self._current_run()
        if run is None:
            self._recorded.choose_safety(settings)
        else:
            run.switch_safety(settings)
            self._recorded.add(run.step, settings)

    def begin(
        self, seed: int, safety: SafetySettings, run: int | None = None, companions: tuple[page.Companion, ...] = ()
    ) -> None:
        """The run with this number begins; None: there is none any more that a preview repeats."""
        self._replace(RecordedHands(seed, safety, companions=companions), run)

    def forget_room(self) -> None:
        """The room is another one: no earlier run can be continued."""
        self._earlier.clear()

    def _replace(self, recorded: RecordedHands, run: int | None) -> None:
        if self._run is not None and self._commands.steps > 0:
            self._earlier.add(self._run, (self._recorded, self._commands), self._commands.steps)
        self._recorded, self._commands, self._run = recorded, CommandLog(), run

    def record_step(self, lockstep: Lockstep) -> None:
        """A step of the run has been integrated."""
        self._commands.add(lockstep)

    def branch(self, request: page.Run, after: int, safety: SafetySettings) -> tuple[RecordedHands, Replay]:
        """
        Begin a run that repeats an earlier one up to a step.

        Args:
            request: names the earlier run; without a name it is the last one.
            after: how many steps; not more than that run had.
            safety: the settings from then on.

        Returns:
            What is recorded of the new run so far, and what it repeats.

        Raises:
            BadInput: that run cannot be repeated.
        """
        found = (self._recorded, self._commands)
        if request.of is not None and request.of != self._run:
            kept = self._earlier.get(request.of)
            if kept is None:
                raise BadInput(tr("This run is too long ago to go on from there."))
            found = kept
        of, commands = found
        if not of.is_complete:
            raise BadInput(tr("Too much was done by hand in this run to go on from there."))
        steps = max(0, min(after, commands.steps))
        actions = [hand for hand in of.actions if hand[0] <= steps]
        switched = [action for _, action in actions if isinstance(action, SafetySettings)]
        if safety != (switched[-1] if switched else of.safety):
            actions.append((steps, safety))
        self._replace(RecordedHands(of.seed, of.safety, actions, companions=of.companions), request.run)
        return self._recorded, Replay(steps, tuple(actions), commands)

    @property
    def is_complete(self) -> bool:
        """Whether the last run can be repeated: all its actions are recorded."""
        return self._recorded.is_complete

    def preview_task(self, request: page.Preview, world: object) -> PreviewTask:
        """A program in a room, as JSON, with the seed and the hands of the last run there."""
        of = self._recorded
        hands = write_hands(of.actions)
        return PreviewTask(request.id, request.source, world, of.seed, request.seconds, of.safety, hands)
