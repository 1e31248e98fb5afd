"""`urdfctl graph`: what is wired to what, from planning groups and topics to joints and back."""
