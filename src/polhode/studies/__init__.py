"""What polhode finds out about something that is no motion of a spec: one file each, from measurements to a report."""
