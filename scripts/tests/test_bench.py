"""Rotation of the benchmarks: each has its turn within ten days."""

from __future__ import annotations

from bench import BENCHES, DAYS, turn


def test_each_benchmark_has_one_turn_in_ten_days() -> None:
    for name, benchmark in BENCHES.items():
        for command in benchmark.commands:
            assert sum(turn(name, command, seed) for seed in range(20779, 20779 + DAYS)) == 1, (name, command)


def test_each_day_has_a_benchmark() -> None:
    for seed in range(DAYS):
        assert any(turn(name, command, seed) for name, benchmark in BENCHES.items() for command in benchmark.commands)
