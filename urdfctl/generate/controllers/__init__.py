"""From a request to controllers: which ones, for which joints, with which parameters (`recipes.yaml`)."""
