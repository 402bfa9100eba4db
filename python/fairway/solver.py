# SPDX-License-Identifier: Apache-2.0
"""The optimal control problem, Eq. (15) of the paper, and its solver."""

from ._fairway import Problem, Solution, Solver, read_problems, solve, step

__all__ = ["Problem", "Solution", "Solver", "read_problems", "solve", "step"]
