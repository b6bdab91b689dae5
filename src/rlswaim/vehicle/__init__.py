"""The vehicle of Sections I to III: modes, booster, ascent, equations of motion and their coupling."""
