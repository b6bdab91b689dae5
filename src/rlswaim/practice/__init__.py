"""Beyond the report: another vehicle, limits of performance, criteria in time, loads, truer models."""
