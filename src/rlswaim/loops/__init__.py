"""The control systems of Sections IV to VII, and what can be said of all their gains."""
