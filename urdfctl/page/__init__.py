"""The page of a run of lint or smoke: what is started together, the robots, findings, verdicts and curves."""
