"""Test runner of the repository: suites, their results, and a scheduler that runs them side by side."""
