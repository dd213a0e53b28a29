"""The kind ``vlasov-poisson``: a plasma of electrons in its own field, its waves and their growth."""
