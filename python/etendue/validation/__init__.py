"""What goes wrong without the adjoint corrections, predicted."""
