"""The kind ``quantum-rotor``: a molecule, or a body, as a quantum rotor."""
