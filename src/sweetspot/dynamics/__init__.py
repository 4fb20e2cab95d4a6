"""An implement as a mechanical system: beam, rigid body, modes of bending and of its face."""
