"""The rigid body with what is mounted in it: wheels, gyroscopes, moving parts, propellant, control laws."""
