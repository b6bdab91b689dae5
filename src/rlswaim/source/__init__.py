"""What is given: the report's data and printed numbers, and the checks of what callers pass in."""
